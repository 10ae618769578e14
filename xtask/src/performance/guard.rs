//! Whether what is written still holds: sizes, and how instructions grow.

use super::controllers::{self, SUBJECTS};
use super::growth::{MOST, Point, per_doubling};
use super::instructions;
use super::measure::Bench;
use super::members::{self, Member};
use super::report::{Outcome, Report, Version};
use crate::failure::{Failure, Result};

/// Sizes of larger members are not checked.
const STATES: u64 = 10_000;

/// Pairs of members, some thousand instructions a state: small enough for callgrind, large enough that what does not depend on
/// the size does not count.
const GROWING: [(&str, [&str; 2]); 3] =
    [("lift", ["7", "8"]), ("arbiter", ["7", "8"]), ("transfer-line", ["5", "6"])];

/// Compares, and tells all that is wrong.
pub(super) fn check(bench: &Bench, report: &Report) -> Result<()> {
    let mut wrong = Vec::new();
    for member in members::all().filter(|member| member.states() <= STATES) {
        let now = bench.run(&bench.sml, member, &bench.text(member)?, &[])?;
        let written = report.runs.get(&(member, Version::Now));
        if let Some(why) = differs(written, &now) {
            wrong.push(format!("`{member}`: {why}"));
        }
    }
    for subject in &SUBJECTS {
        let now = subject.at(bench, "exact")?;
        let written = report.controllers.get(&(subject.name.to_owned(), "exact".to_owned())).copied();
        if written != Some(now) {
            let (written, now) = (controllers::shown(written), controllers::shown(Some(now)));
            wrong.push(format!("`{}`: the controller has {now} states, written is {written}", subject.name));
        }
    }
    for (family, numbers) in GROWING {
        let [small, large] = numbers.map(|number| point(bench, family, number));
        let growth = per_doubling(small?, large?);
        let line =
            format!("`{family}`: instructions per state grow by {growth:.1} percent when states double");
        println!("{line}");
        if growth > MOST {
            wrong.push(format!("{line}, and may by {MOST}"));
        }
    }
    if wrong.is_empty() {
        return Ok(());
    }
    Err(Failure::new(format!("figures are not what `docs/performance.md` says:\n{}", wrong.join("\n")))
        .help("look at the difference, then run `cargo xtask performance`"))
}

fn point(bench: &Bench, family: &str, number: &str) -> Result<Point> {
    let member = Member::called(family, number);
    let member = member.ok_or_else(|| Failure::new(format!("there is no family `{family}`")))?;
    let counts = instructions::count(bench, member, &bench.text(member)?)?;
    let counts = counts.ok_or_else(|| {
        Failure::new(format!("callgrind takes more than {} s for `{member}`", bench.seconds))
            .help("raise `--seconds`")
    })?;
    Ok(Point::of(member.states(), &counts))
}

/// How sizes differ; time and memory depend on the computer.
fn differs(written: Option<&Outcome>, now: &Outcome) -> Option<String> {
    let Some(written) = written.and_then(Outcome::stages) else {
        return Some("it is not written".to_owned());
    };
    let now = now.stages()?;
    let sizes = |outcome: &[super::report::Stage]| -> Vec<(String, u64, u64)> {
        outcome.iter().map(|stage| (stage.name.clone(), stage.states, stage.transitions)).collect()
    };
    let (written, now) = (sizes(written), sizes(now));
    let pairs = written.iter().zip(&now);
    let different = pairs.into_iter().find(|(written, now)| written != now);
    match different {
        Some(((name, states, transitions), (name_now, states_now, transitions_now))) => Some(format!(
            "stage `{name_now}` gives {states_now} states and {transitions_now} transitions; \
             written is `{name}` with {states} and {transitions}"
        )),
        None if written.len() != now.len() => Some("there are other stages".to_owned()),
        None => None,
    }
}

#[cfg(test)]
mod tests {
    use super::differs;
    use crate::performance::report::{Outcome, Stage};

    #[test]
    fn sizes_must_be_the_same() {
        let run = |states, micros| {
            let stage = Stage { name: "explore".to_owned(), micros, states, ..Stage::default() };
            Outcome::Measured(vec![stage])
        };
        assert_eq!(differs(Some(&run(5, 1)), &run(5, 900)), None);
        let why = "stage `explore` gives 6 states and 0 transitions; written is `explore` with 5 and 0";
        assert_eq!(differs(Some(&run(5, 1)), &run(6, 1)), Some(why.to_owned()));
        assert_eq!(differs(None, &run(5, 1)), Some("it is not written".to_owned()));
        assert_eq!(differs(Some(&Outcome::Untried), &run(5, 1)), Some("it is not written".to_owned()));
        assert_eq!(
            differs(Some(&run(5, 1)), &Outcome::Measured(Vec::new())),
            Some("there are other stages".to_owned())
        );
    }
}
