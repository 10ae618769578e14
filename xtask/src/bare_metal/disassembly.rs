//! What the functions of a step execute: no floating point, no atomic access, no division, no call that cannot be
//! followed.

use super::elf::Function;
use super::toolchain::Toolchain;
use crate::failure::{Failure, Result};
use crate::process;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// An instruction: what it does, and the function that it names.
type Instruction<'t> = (&'t str, Option<&'t str>);

/// Beginnings of the names of functions that stand for instructions which a processor does not have.
const SUBSTITUTES: &[(&str, &str)] = &[
    ("__aeabi_f", "floating point"),
    ("__aeabi_d", "floating point"),
    ("__aeabi_cf", "floating point"),
    ("__aeabi_cd", "floating point"),
    ("__aeabi_i2", "floating point"),
    ("__aeabi_ui2", "floating point"),
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

/// Reads the functions and all that they call, and returns how many instructions these are.
pub(crate) fn read(toolchain: &Toolchain, program: &Path, functions: &[&Function]) -> Result<usize> {
    let mut command = toolchain.disassembler();
    command.args(["--disassemble", "--no-show-raw-insn"]).arg(program);
    let text = process::text(&mut command)?;
    let code = parse(&text);
    let roots = code.keys().copied().filter(|symbol| {
        let name = format!("{:#}", rustc_demangle::demangle(symbol));
        functions.iter().any(|function| function.name == name)
    });
    judge(&code, roots.collect()).map_err(|why| Failure::new(format!("`{}`: {why}", program.display())))
}

/// Instructions by function: `00000478 <name>:` and then lines `478: push {r4, lr}`.
fn parse(text: &str) -> BTreeMap<&str, Vec<Instruction<'_>>> {
    let mut code = BTreeMap::new();
    let mut current: Option<&mut Vec<Instruction<'_>>> = None;
    for line in text.lines() {
        if let Some(name) = line.strip_suffix(">:").and_then(|line| Some(line.split_once(" <")?.1)) {
            current = Some(code.entry(name).or_default());
        } else if let (Some(instructions), Some((_, instruction))) = (&mut current, line.split_once(":")) {
            let mut words = instruction.split_whitespace();
            let Some(mnemonic) = words.next() else { continue };
            let names = instruction.rsplit_once('<').and_then(|(_, name)| name.strip_suffix('>'));
            instructions.push((mnemonic, names.map(|name| name.split("+0x").next().unwrap_or(name))));
        }
    }
    code
}

/// Follows calls from the roots.
fn judge(
    code: &BTreeMap<&str, Vec<Instruction<'_>>>,
    roots: Vec<&str>,
) -> std::result::Result<usize, String> {
    if roots.is_empty() {
        return Err("the functions of a step are not there".to_owned());
    }
    let mut seen: BTreeSet<&str> = roots.iter().copied().collect();
    let mut open = roots;
    let mut count = 0;
    while let Some(name) = open.pop() {
        let shown = rustc_demangle::demangle(name);
        if let Some((_, what)) = SUBSTITUTES.iter().find(|(beginning, _)| name.starts_with(beginning)) {
            return Err(format!("a step calls `{shown}`: {what}"));
        }
        let instructions =
            code.get(name).ok_or_else(|| format!("a step calls `{shown}`, which is not there"))?;
        for &(mnemonic, callee) in instructions {
            count += 1;
            if let Some(what) = forbidden(mnemonic, callee) {
                return Err(format!("`{shown}` has `{mnemonic}`: {what}"));
            }
            if let Some(callee) = callee
                && seen.insert(callee)
            {
                open.push(callee);
            }
        }
    }
    Ok(count)
}

/// What an instruction must not do, on Arm or RISC-V.
fn forbidden(mnemonic: &str, callee: Option<&str>) -> Option<&'static str> {
    let begins = |beginnings: &[&str]| beginnings.iter().any(|beginning| mnemonic.starts_with(beginning));
    if begins(&["ldrex", "strex", "dmb", "lr.", "sc.", "amo", "fence"]) {
        Some("an atomic access")
    } else if begins(&["udiv", "sdiv", "div", "rem"]) {
        Some("a division")
    } else if begins(&["v", "f", "c.f"]) {
        Some("floating point")
    } else if begins(&["blx", "jalr", "c.jalr"]) && callee.is_none() {
        Some("a call that cannot be followed")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{judge, parse};

    #[track_caller]
    fn check(text: &str, expect: Result<usize, &str>) {
        assert_eq!(judge(&parse(text), vec!["step"]), expect.map_err(str::to_owned));
    }

    #[test]
    fn calls_are_followed() {
        let helper = "0000a <helper>:\n   a: movs r0, #1\n   c: bx lr\n";
        check(&format!("00000 <step>:\n   0: bl 0xa <helper>\n   4: bx lr\n\n{helper}"), Ok(4));
        check("00000 <step>:\n   0: beq 0x4 <step+0x4>\n   4: bx lr\n", Ok(2));
        check("00000 <step>:\n   0: bl 0xa <helper>\n", Err("a step calls `helper`, which is not there"));
    }

    #[test]
    fn what_a_step_must_not_do_is_found() {
        let step = |instruction: &str| format!("00000 <step>:\n   0: {instruction}\n   4: bx lr\n");
        check(&step("udiv r0, r1, r2"), Err("`step` has `udiv`: a division"));
        check(&step("remu a0, a1, a2"), Err("`step` has `remu`: a division"));
        check(&step("ldrexb r0, [r1]"), Err("`step` has `ldrexb`: an atomic access"));
        check(&step("amoadd.w a0, a1, (a2)"), Err("`step` has `amoadd.w`: an atomic access"));
        check(&step("fence rw, rw"), Err("`step` has `fence`: an atomic access"));
        check(&step("vadd.f32 s0, s1, s2"), Err("`step` has `vadd.f32`: floating point"));
        check(&step("flw fa0, 0(a0)"), Err("`step` has `flw`: floating point"));
        check(&step("blx r3"), Err("`step` has `blx`: a call that cannot be followed"));
        check(&step("bl 0x8 <__aeabi_uidiv>"), Err("a step calls `__aeabi_uidiv`: a division"));
        check(&step("bl 0x8 <__aeabi_fadd>"), Err("a step calls `__aeabi_fadd`: floating point"));
        check("00000 <other>:\n   0: bx lr\n", Err("a step calls `step`, which is not there"));
    }
}
