//! How small controllers get, beside what others report.

use super::measure::Bench;
use super::members::Member;
use super::report::Report;
use crate::failure::{At, Failure, Result};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Levels of minimisation.
pub(super) const LEVELS: [&str; 4] = ["none", "exact", "assume", "ordered"];

/// A specification, and what others make of it.
pub(super) struct Subject {
    /// In the file of figures.
    pub(super) name: &'static str,
    /// For people.
    pub(super) title: &'static str,
    from: From,
    /// States of others, in words.
    pub(super) others: &'static str,
}

enum From {
    Family(&'static str, &'static str),
    File(&'static str),
}

pub(super) static SUBJECTS: [Subject; 4] = [
    Subject {
        name: "production-cell",
        title: "production cell",
        from: From::File("tests/specs/production_cell/spec.sml"),
        others: "greedy merging with don't-cares: 16 waiting",
    },
    Subject {
        name: "line-2",
        title: "line with 2 presses",
        from: From::Family("line", "2"),
        others: "greedy merging with don't-cares: 174 waiting",
    },
    Subject {
        name: "lift-8",
        title: "lift with 8 floors",
        from: From::Family("lift", "8"),
        others: "explicit GR(1) tools, not minimised: 11,904 and 6,722",
    },
    Subject {
        name: "arbiter-8",
        title: "arbiter with 8 clients",
        from: From::Family("arbiter", "8"),
        others: "explicit GR(1) tool, not minimised: 11,264",
    },
];

/// What came of a level.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Size {
    /// States, and those of them in which no super step is due, so that the controller waits for an event.
    Of { states: u64, waiting: u64 },
    /// The command refuses the level, or takes too long.
    None,
}

impl Subject {
    fn text(&self, bench: &Bench) -> Result<PathBuf> {
        match self.from {
            From::File(path) => Ok(bench.repository(path)),
            From::Family(family, number) => {
                let member = Member::called(family, number);
                bench.text(member.ok_or_else(|| Failure::new(format!("there is no family `{family}`")))?)
            }
        }
    }

    /// Synthesises at a level.
    pub(super) fn at(&self, bench: &Bench, level: &str) -> Result<Size> {
        let (text, product) = (self.text(bench)?, bench.file("controller.json"));
        let mut command = Command::new(&bench.sml);
        command.arg("synth").arg(text).args(["--minimize", level, "-o"]).arg(&product);
        match bench.bounded(&mut command)? {
            Some((status, _)) if status.success() => size(&product),
            _ => Ok(Size::None),
        }
    }
}

fn size(product: &Path) -> Result<Size> {
    let text = fs::read_to_string(product).doing(format_args!("read `{}`", product.display()))?;
    let controller: Value =
        serde_json::from_str(&text).doing(format_args!("read `{}`", product.display()))?;
    counted(&controller).ok_or_else(|| Failure::new(format!("`{}` is no controller", product.display())))
}

fn counted(controller: &Value) -> Option<Size> {
    let states = controller["states"].as_u64()?;
    let due = controller["supersteps"].as_array()?.len() as u64;
    Some(Size::Of { states, waiting: states.checked_sub(due)? })
}

/// Measures all, whatever is written.
pub(super) fn measure(bench: &Bench, report: &mut Report) -> Result<()> {
    report.controllers.clear();
    for subject in &SUBJECTS {
        for level in LEVELS {
            let size = subject.at(bench, level)?;
            println!("{} {level}: {}", subject.name, shown(Some(size)));
            report.controllers.insert((subject.name.to_owned(), level.to_owned()), size);
        }
    }
    Ok(())
}

/// `200 (96 waiting)`.
pub(super) fn shown(size: Option<Size>) -> String {
    use crate::plot::grouped;
    match size {
        Some(Size::Of { states, waiting }) => format!("{} ({})", grouped(states), grouped(waiting)),
        Some(Size::None) => "not given".to_owned(),
        None => "not measured".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::{Size, counted};
    use serde_json::json;

    #[test]
    fn states_with_a_super_step_do_not_wait() {
        let controller = json!({ "states": 3, "supersteps": [{}, {}] });
        assert_eq!(counted(&controller), Some(Size::Of { states: 3, waiting: 1 }));
        assert_eq!(counted(&json!({})), None);
    }
}
