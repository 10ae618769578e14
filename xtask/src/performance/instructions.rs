//! Instructions of every stage, as callgrind counts them.
//!
//! Stages run in one function, an instance of `Timings::stage` for each: counting is on inside of it only, and a profile
//! is written whenever it ends. So the profiles are those of the stages, in the order in which `--timings` names them.

use super::measure::{Bench, stages};
use super::members::Member;
use super::report::Instructions;
use crate::failure::{At, Failure, Result};
use crate::process;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The function of a stage, however the compiler mangles its name.
const STAGE: &str = "*Timings::stage";

/// Counts; none if it takes too long.
pub(super) fn count(bench: &Bench, member: Member, text: &Path) -> Result<Option<Instructions>> {
    if process::find("valgrind").is_none() {
        return Err(Failure::new("`valgrind` is missing").help("install it, with `apt-get install valgrind`"));
    }
    let folder = bench.file("profiles");
    if folder.exists() {
        fs::remove_dir_all(&folder).doing(format_args!("remove `{}`", folder.display()))?;
    }
    fs::create_dir_all(&folder).doing(format_args!("create `{}`", folder.display()))?;
    let mut command = Command::new("valgrind");
    command
        .args(["--quiet", "--tool=callgrind"])
        .arg(format!("--callgrind-out-file={}", folder.join("profile").display()))
        .arg(format!("--toggle-collect={STAGE}"))
        .arg(format!("--dump-after={STAGE}"))
        .arg(&bench.sml)
        .args(bench.arguments(member, text))
        // Threads that wait for each other count as they please.
        .args(["--threads", "1"]);
    let Some((status, said)) = bench.bounded(&mut command)? else { return Ok(None) };
    if !status.success() {
        return Err(Failure::new(format!("callgrind failed ({status}):\n{}", said.trim_end())));
    }
    let names: Vec<String> = stages(&said)?.into_iter().map(|stage| stage.name).collect();
    let counts = (1..=names.len()).map(|number| total(&folder.join(format!("profile.{number}"))));
    Ok(Some(names.into_iter().zip(counts.collect::<Result<Vec<u64>>>()?).collect()))
}

/// What a profile sums up to.
fn total(profile: &Path) -> Result<u64> {
    let text = fs::read_to_string(profile).doing(format_args!("read `{}`", profile.display()))?;
    summary(&text).ok_or_else(|| Failure::new(format!("`{}` has no total", profile.display())))
}

fn summary(profile: &str) -> Option<u64> {
    let line = |what| profile.lines().rev().find_map(|line: &str| line.strip_prefix(what));
    line("totals: ").or_else(|| line("summary: "))?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_profile_has_a_total() {
        assert_eq!(super::summary("version: 1\nsummary: 12\n\nfn=(1) f\n3 12\n\ntotals: 12\n"), Some(12));
        assert_eq!(super::summary("version: 1\n"), None);
    }
}
