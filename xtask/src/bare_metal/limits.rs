//! What a look-up may cost.

use super::count::Count;
use super::target::Target;
use crate::failure::{Failure, Result};

/// A look-up by the engine `search` takes less: bytes of code, and instructions at most.
const SEARCH: &[(&str, u64, u64)] =
    &[("thumbv7m", 80, 125), ("thumbv6m", 104, 162), ("riscv32imac", 98, 109)];

/// A look-up by the engine `comb` takes no more instructions.
const COMB: &[(&str, u64)] = &[("thumbv7m", 30)];

/// Judges a look-up of the program `look-up`; its label is `<controller>_<engine>`.
pub(crate) fn judge(target: &Target, label: &str, code: u64, count: &Count) -> Result<()> {
    let is_target = |beginning: &str| target.triple.starts_with(beginning);
    let over = match label.rsplit_once('_') {
        Some((_, "search")) => {
            SEARCH.iter().any(|&(name, bytes, most)| is_target(name) && (code >= bytes || count.most >= most))
        }
        Some((_, "comb")) => COMB.iter().any(|&(name, most)| is_target(name) && count.most > most),
        _ => false,
    };
    if over {
        let most = count.most;
        return Err(Failure::new(format!(
            "`{label}` takes {code} bytes and at most {most} instructions, which is too much"
        )));
    }
    Ok(())
}
