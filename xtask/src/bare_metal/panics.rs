//! The linker's proof that no panic can be reached: a program whose panics call a function that is defined nowhere
//! links only without any path to one. With an indexing that can fail it must not link, or the proof proves nothing.

use super::folders::Folders;
use super::toolchain::Toolchain;
use crate::failure::{Failure, Result};
use crate::process;

/// What the panic handler of `board` calls.
const UNDEFINED: &str = "undefined symbol: a_panic_can_be_reached";

/// Links the program without panics, then the one with a panic.
pub(crate) fn prove(folders: &Folders, toolchain: &Toolchain) -> Result<()> {
    if let Some(said) = link(folders, toolchain, &[])? {
        return Err(Failure::new(format!("a step can panic:\n{said}")));
    }
    match link(folders, toolchain, &["--features", "control"])? {
        Some(said) if said.contains(UNDEFINED) => Ok(()),
        Some(said) => Err(Failure::new(format!("the control does not link for another reason:\n{said}"))),
        None => Err(Failure::new("the control links, although an indexing in it can fail")
            .help("the proof proves nothing: look at `firmware/proof`")),
    }
}

/// What the build says if it fails.
fn link(folders: &Folders, toolchain: &Toolchain, features: &[&str]) -> Result<Option<String>> {
    let output =
        process::output(toolchain.cargo(folders, "build").args(["--package", "proof"]).args(features))?;
    Ok((!output.status.success()).then(|| String::from_utf8_lossy(&output.stderr).into_owned()))
}
