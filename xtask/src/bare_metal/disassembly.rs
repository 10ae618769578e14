//! What the functions of a step execute: no floating point, no atomic access, no division, no call that cannot be
//! followed.

use super::elf::Function;
use super::toolchain::Toolchain;
use crate::failure::{Failure, Result};
use crate::process;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Beginnings of the names of functions that stand for instructions which a processor does not have.
const SUBSTITUTES: &[(&str, &str)] = &[
    ("__aeabi_f", "floating point"),
    ("__aeabi_d", "floating point"),
    ("__aeabi_cf", "floating point"),
    ("__aeabi_cd", "floating point"),
    ("__aeabi_i2", "floating point"),
    ("__aeabi_ui2", "floating point"),
    ("__aeabi_l2", "floating point"),
    ("__aeabi_ul2", "floating point"),
    ("__add", "floating point"),
    ("__sub", "floating point"),
    ("__mulsf", "floating point"),
    ("__muldf", "floating point"),
    ("__eq", "floating point"),
    ("__ne", "floating point"),
    ("__lt", "floating point"),
    ("__le", "floating point"),
    ("__gt", "floating point"),
    ("__ge", "floating point"),
    ("__unord", "floating point"),
    ("__fix", "floating point"),
    ("__float", "floating point"),
    ("__extend", "floating point"),
    ("__trunc", "floating point"),
    ("__aeabi_idiv", "a division"),
    ("__aeabi_uidiv", "a division"),
    ("__aeabi_ldiv", "a division"),
    ("__aeabi_uldiv", "a division"),
    ("__udiv", "a division"),
    ("__div", "a division"),
    ("__umod", "a division"),
    ("__mod", "a division"),
    ("__atomic", "an atomic access"),
    ("__sync", "an atomic access"),
];

/// Instructions by address: what is done, and with what.
type Code<'t> = BTreeMap<u64, (&'t str, &'t str)>;

/// Reads each of the `roots` with everything that it calls. Returns the bytes of their code, or fails if something in
/// it must not be.
pub(crate) fn read<'f>(
    toolchain: &Toolchain,
    program: &Path,
    functions: &[Function],
    roots: &[&'f Function],
) -> Result<BTreeMap<&'f str, u64>> {
    let mut command = toolchain.disassembler();
    command.args(["--disassemble", "--no-show-raw-insn"]).arg(program);
    let text = process::text(&mut command)?;
    let code = parse(&text);
    let bytes = roots.iter().map(|root| Ok((root.name.as_str(), judge(&code, functions, root)?)));
    bytes
        .collect::<std::result::Result<_, String>>()
        .map_err(|why| Failure::new(format!("`{}`: {why}", program.display())))
}

/// Lines such as `478: push {r4, lr}`; data between the functions and the names before them are no instructions.
fn parse(text: &str) -> Code<'_> {
    text.lines().filter_map(instruction).collect()
}

fn instruction(line: &str) -> Option<(u64, (&str, &str))> {
    let (address, instruction) = line.split_once(':')?;
    let address = u64::from_str_radix(address.trim(), 16).ok()?;
    let instruction = instruction.trim();
    let is_data = instruction.starts_with('.') || instruction.contains("\t.");
    let parts = instruction.split_once(char::is_whitespace).unwrap_or((instruction, ""));
    (!is_data && !instruction.is_empty()).then_some((address, parts))
}

/// Bytes of a function and of all that it calls.
fn judge(code: &Code<'_>, functions: &[Function], root: &Function) -> std::result::Result<u64, String> {
    let mut seen = BTreeSet::from([root.address]);
    let mut open = vec![root];
    let mut bytes = 0;
    while let Some(function) = open.pop() {
        let Function { name, address, size } = function;
        if let Some((_, what)) = SUBSTITUTES.iter().find(|(beginning, _)| name.starts_with(beginning)) {
            return Err(format!("`{}` calls `{name}`: {what}", root.name));
        }
        bytes += size;
        let mut before = None;
        for (&place, &(mnemonic, operands)) in code.range(*address..address + size) {
            let target = target(before, mnemonic, operands);
            if let Some(what) = forbidden(mnemonic, target) {
                return Err(format!("`{name}` has `{mnemonic} {operands}`: {what}"));
            }
            before = Some((place, mnemonic, operands));
            let Some(target) = target.filter(|target| !(*address..address + size).contains(target)) else {
                continue;
            };
            let around =
                |function: &&Function| (function.address..function.address + function.size).contains(&target);
            let callee = functions
                .iter()
                .find(around)
                .ok_or_else(|| format!("`{name}` calls {target:#x}, where no function is"))?;
            if seen.insert(callee.address) {
                open.push(callee);
            }
        }
    }
    Ok(bytes)
}

/// Where a branch or a call leads: `bl 0x480 <name>`, or `auipc ra, 0` before `jalr -16(ra)`.
fn target(before: Option<(u64, &str, &str)>, mnemonic: &str, operands: &str) -> Option<u64> {
    if ["jalr", "jr"].contains(&mnemonic) {
        let (place, "auipc", upper) = before? else { return None };
        let (register, upper) = upper.split_once(", ")?;
        let (offset, inside) = operands.split_once('(')?;
        let offset = offset.rsplit(' ').next()?;
        if !inside.starts_with(register) {
            return None;
        }
        // Twenty bits, then twelve with a sign.
        let upper = number(upper)?.wrapping_shl(12) as u64;
        let address = place.wrapping_add(upper).wrapping_add(number(offset)? as u64);
        return Some(address & 0xffff_ffff);
    }
    if !mnemonic.starts_with(['b', 'c', 'j']) {
        return None;
    }
    let (address, _) = operands.split_once(" <")?;
    number(address.rsplit(' ').next()?).map(|address| address as u64)
}

/// A decimal or hexadecimal number.
fn number(text: &str) -> Option<i64> {
    let (sign, text) = text.strip_prefix('-').map_or((1, text), |text| (-1, text));
    let value = match text.strip_prefix("0x") {
        Some(digits) => i64::from_str_radix(digits, 16),
        None => text.parse(),
    };
    Some(sign * value.ok()?)
}

/// What an instruction must not do, on Arm or RISC-V.
fn forbidden(mnemonic: &str, target: Option<u64>) -> Option<&'static str> {
    let begins = |beginnings: &[&str]| beginnings.iter().any(|beginning| mnemonic.starts_with(beginning));
    if begins(&["ldrex", "strex", "dmb", "lr.", "sc.", "amo", "fence"]) {
        Some("an atomic access")
    } else if begins(&["udiv", "sdiv", "div", "rem"]) {
        Some("a division")
    } else if begins(&["v", "f", "c.f"]) {
        Some("floating point")
    } else if ["blx", "jalr"].contains(&mnemonic) && target.is_none() {
        // A `jr` alone, or a load of the program counter, is a jump through a table, which stays in its function.
        Some("a call that cannot be followed")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{Function, judge, parse};

    #[track_caller]
    fn check(text: &str, expect: Result<u64, &str>) {
        let function = |name: &str, address, size| Function { name: name.to_owned(), address, size };
        let functions = [
            function("step", 0, 8),
            function("next", 0x10, 4),
            function("__aeabi_uidiv", 0x20, 4),
            function("__aeabi_fadd", 0x30, 4),
        ];
        assert_eq!(judge(&parse(text), &functions, &functions[0]), expect.map_err(str::to_owned));
    }

    #[test]
    fn calls_are_followed() {
        let next = "00000010 <next>:\n      10:\tmovs\tr0, #1\n      12:\tbx\tlr\n";
        check(
            &format!("00000000 <step>:\n   0:\tbl\t0x10 <next>   @ imm = #12\n   4:\tbx\tlr\n\n{next}"),
            Ok(12),
        );
        check("00000000 <step>:\n   0:\tbeq\t0x4 <step+0x4>\n   4:\tbx\tlr\n", Ok(8));
        check("00000000 <step>:\n   0:\tcbz\tr0, 0x4 <$t+0x2>\n", Ok(8));
        check("00000000 <step>:\n   0:\tauipc\tra, 0\n   4:\tjalr\t16(ra)\n", Ok(12));
        check("00000000 <step>:\n   0:\tb\t0x80 <other>\n", Err("`step` calls 0x80, where no function is"));
    }

    #[test]
    fn constants_between_the_functions_are_no_instructions() {
        check("   0:\tldr\tr0, [pc, #4]    @ 0x80 <$d>\n   4:\t00 00 00 20\t.word\t0x20000000\n", Ok(8));
        check("   0:\tbx\tlr\n   4:\tfa 00\t.short\t0x00fa\n", Ok(8));
    }

    #[test]
    fn what_a_step_must_not_do_is_found() {
        let has = |instruction: &str, what: &str| {
            check(
                &format!("   0:\t{instruction}\n   4:\tbx\tlr\n"),
                Err(&format!("`step` has `{instruction}`: {what}")),
            );
        };
        has("udiv r0, r1, r2", "a division");
        has("remu a0, a1, a2", "a division");
        has("ldrexb r0, [r1]", "an atomic access");
        has("amoadd.w a0, a1, (a2)", "an atomic access");
        has("fence rw, rw", "an atomic access");
        has("vadd.f32 s0, s1, s2", "floating point");
        has("flw fa0, 0(a0)", "floating point");
        has("blx r3", "a call that cannot be followed");
        has("jalr 0(a0)", "a call that cannot be followed");
        check("   0:\tjr\ta0\n", Ok(8));
        check("   0:\tbl\t0x20 <__aeabi_uidiv>\n", Err("`step` calls `__aeabi_uidiv`: a division"));
        check("   0:\tbl\t0x30 <__aeabi_fadd>\n", Err("`step` calls `__aeabi_fadd`: floating point"));
    }
}
