//! What the hook for observers costs a controller that nobody observes: nothing. The code of each step with `()` has no byte more
//! than that of the same loop without any hook. (The two are not always equal: the copy of commands that an observer would
//! get, though it is gone, can turn the choice of a register, to fewer bytes.) With an observer that counts it must be larger
//! than both, or the comparison proves nothing.

use super::disassembly;
use super::elf;
use super::folders::Folders;
use super::target::Target;
use super::toolchain::Toolchain;
use crate::failure::{Failure, Result};
use crate::process;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// The functions of the program `hook`.
const STEPS: [&str; 3] = ["hook::cycle", "hook::drain", "hook::react"];

/// Compares the three builds; returns the sizes in short.
pub(crate) fn compare(folders: &Folders, toolchain: &Toolchain, target: &Target) -> Result<String> {
    let unobserved = code(folders, toolchain, target, &[])?;
    let hookless = code(folders, toolchain, target, &["--features", "hookless"])?;
    let counting = code(folders, toolchain, target, &["--features", "counting"])?;
    let mut said = String::from("nothing;");
    for step in STEPS {
        let [Some(unobserved), Some(hookless), Some(counting)] =
            [&unobserved, &hookless, &counting].map(|code| code.get(step).copied())
        else {
            return Err(Failure::new(format!("`{step}` is not in every build of `hook`")));
        };
        if unobserved > hookless {
            return Err(Failure::new(format!(
                "`{step}` has {unobserved} bytes of code with `()` for an observer, and {hookless} without the hook"
            ))
            .help("look at `Observer` and `Machine` in `controller-template/src/machine.rs`"));
        }
        if counting <= hookless {
            return Err(Failure::new(format!(
                "`{step}` has {counting} bytes with an observer that counts, and {hookless} without the hook"
            ))
            .help("the comparison proves nothing: look at `firmware/hook`"));
        }
        let name = step.trim_start_matches("hook::");
        let _ = write!(
            said,
            " {name} {unobserved} bytes, {hookless} without the hook, {counting} with an observer;"
        );
    }
    Ok(said.trim_end_matches(';').to_owned())
}

/// Bytes of code of each function, with all that it calls.
fn code(
    folders: &Folders,
    toolchain: &Toolchain,
    target: &Target,
    features: &[&str],
) -> Result<BTreeMap<String, u64>> {
    process::text(toolchain.cargo(folders, "build").args(["--package", "hook"]).args(features))?;
    let file = folders.build().join(target.triple).join("release/hook");
    let (_, functions) = elf::read(&file)?;
    let roots: Vec<_> = functions.iter().filter(|function| STEPS.contains(&function.name.as_str())).collect();
    let code = disassembly::read(toolchain, &file, &functions, &roots)?;
    Ok(code.into_iter().map(|(name, bytes)| (name.to_owned(), bytes)).collect())
}
