//! What the figures say, in words: where this project is better, and where it is not.

use super::figures::{Figures, Outcome, Report};
use super::machines::Machine;
use crate::plot::grouped;
use std::fmt::Write as _;

/// The size from which on machines of this project are meant to be better.
const LARGE: u32 = 5_000;

/// How many times below `match` the compile time is meant to be.
const AIM: u64 = 20;

/// A figure of which less is better.
struct Measure {
    name: &'static str,
    unit: &'static str,
    of: fn(Figures) -> u64,
}

const MEASURES: [Measure; 2] = [
    Measure { name: "Flash", unit: "bytes", of: |figures| figures.flash },
    Measure { name: "Instructions in the worst case", unit: "instructions", of: |figures| figures.most },
];

/// A list, one item for each measure and large size.
pub(super) fn verdict(report: &Report) -> String {
    let mut text = String::new();
    for size in report.sizes().into_iter().filter(|size| *size >= LARGE) {
        for measure in &MEASURES {
            let _ = writeln!(
                text,
                "- **{}, {} transitions.** {}",
                measure.name,
                grouped(size.into()),
                below(report, size, measure)
            );
        }
        let _ = writeln!(
            text,
            "- **Compile time, {} transitions.** {}",
            grouped(size.into()),
            compiled(report, size)
        );
    }
    text
}

/// Which machines of this project are below every other.
fn below(report: &Report, size: u32, measure: &Measure) -> String {
    let (own, others) = split(report, size, measure.of);
    let Some(least) = others.iter().map(|(_, value)| *value).min() else {
        return "There is nothing to compare with.".to_owned();
    };
    let (better, worse): (Vec<_>, Vec<_>) = own.iter().partition(|(_, value)| *value < least);
    let best: Vec<_> = others.iter().filter(|(_, value)| *value == least).copied().collect();
    let mut text = String::new();
    if !better.is_empty() {
        let _ = write!(
            text,
            "{} below every other machine; the least of those is {}.",
            are(&better),
            list(&best, measure.unit)
        );
    }
    for (machine, value) in worse {
        let before: Vec<_> = others.iter().filter(|(_, other)| other <= value).copied().collect();
        let _ = write!(
            text,
            "{}`{}` ({}) is not: {} take{} no more.",
            if text.is_empty() { "" } else { " " },
            machine.name(),
            grouped(*value),
            list(&before, ""),
            if before.len() == 1 { "s" } else { "" },
        );
    }
    text
}

/// How many times below `match` each machine of this project is.
fn compiled(report: &Report, size: u32) -> String {
    let (own, _) = split(report, size, |figures| figures.compile);
    let (time, at_least) = match report.get(size, Machine::Match) {
        Some(Outcome::Measured(figures)) => (figures.compile, ""),
        Some(Outcome::TooSlow(seconds)) => (seconds * 1_000, "at least "),
        None => return "There is no `match` to compare with.".to_owned(),
    };
    let times = |value: u64| time / value.max(1);
    let said: Vec<String> = own
        .iter()
        .map(|(machine, value)| format!("`{}` {at_least}{} times", machine.name(), grouped(times(*value))))
        .collect();
    let missed: Vec<String> = own
        .iter()
        .filter(|(_, value)| times(*value) < AIM)
        .map(|(machine, _)| format!("`{}`", machine.name()))
        .collect();
    let aim = match missed.is_empty() {
        true => format!("the aim of {AIM} times is reached"),
        false => format!(
            "{} miss{} the aim of {AIM} times",
            and(&missed),
            if missed.len() == 1 { "es" } else { "" }
        ),
    };
    format!("Below that of `match` are {}: {aim}.", and(&said))
}

type Values = Vec<(Machine, u64)>;

/// The machines of this project, and the others, ascending.
fn split(report: &Report, size: u32, of: impl Fn(Figures) -> u64) -> (Values, Values) {
    let mut values: Values = report
        .of_size(size)
        .filter_map(|(machine, outcome)| Some((machine, of(outcome.figures()?))))
        .collect();
    values.sort_by_key(|(_, value)| *value);
    values.into_iter().partition(|(machine, _)| machine.is_own())
}

fn are(machines: &[&(Machine, u64)]) -> String {
    let named: Vec<String> = machines
        .iter()
        .map(|(machine, value)| format!("`{}` ({})", machine.name(), grouped(*value)))
        .collect();
    format!("{} {}", and(&named), if named.len() == 1 { "is" } else { "are" })
}

fn list(machines: &[(Machine, u64)], unit: &str) -> String {
    let space = if unit.is_empty() { "" } else { " " };
    let named: Vec<String> = machines
        .iter()
        .map(|(machine, value)| format!("`{}` ({}{space}{unit})", machine.name(), grouped(*value)))
        .collect();
    and(&named)
}

/// `a, b and c`.
fn and(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [word] => word.clone(),
        [before @ .., last] => format!("{} and {last}", before.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::super::figures::tests::report;
    use super::verdict;

    #[track_caller]
    fn check(lines: &str, words: &str) {
        assert_eq!(verdict(&report(lines)), words);
    }

    #[test]
    fn small_machines_are_not_judged() {
        check("50 comb flash 3 ram 4 min 8 mean 20 max 40 compile 12\n", "");
    }

    #[test]
    fn what_is_better_is_said() {
        check(
            "5000 comb flash 3000 ram 4 min 8 mean 20 max 40 compile 10\n\
             5000 match flash 4000 ram 2 min 8 mean 20 max 50 compile 200\n",
            "- **Flash, 5,000 transitions.** `comb` (3,000) is below every other machine; the least of those is `match` (4,000 bytes).\n\
             - **Instructions in the worst case, 5,000 transitions.** `comb` (40) is below every other machine; the least of those is `match` (50 instructions).\n\
             - **Compile time, 5,000 transitions.** Below that of `match` are `comb` 20 times: the aim of 20 times is reached.\n",
        );
    }

    #[test]
    fn what_is_worse_is_said_too() {
        check(
            "5000 search flash 5000 ram 4 min 8 mean 20 max 60 compile 11\n\
             5000 comb flash 3000 ram 4 min 8 mean 20 max 50 compile 20\n\
             5000 match stopped 120\n\
             5000 statig flash 4000 ram 4 min 8 mean 20 max 55 compile 10\n\
             5000 dense flash 9000 ram 2 min 8 mean 20 max 50 compile 200\n",
            "- **Flash, 5,000 transitions.** `comb` (3,000) is below every other machine; the least of those is `statig` (4,000 bytes). \
             `search` (5,000) is not: `statig` (4,000) takes no more.\n\
             - **Instructions in the worst case, 5,000 transitions.** `comb` (50) is not: `dense` (50) takes no more. \
             `search` (60) is not: `dense` (50) and `statig` (55) take no more.\n\
             - **Compile time, 5,000 transitions.** Below that of `match` are `search` at least 10,909 times and `comb` at least 6,000 times: \
             the aim of 20 times is reached.\n",
        );
        let lines = "5000 comb flash 3 ram 4 min 8 mean 20 max 40 compile 10\n\
                     5000 match flash 4 ram 2 min 8 mean 20 max 50 compile 199\n";
        assert!(verdict(&report(lines)).ends_with("`comb` 19 times: `comb` misses the aim of 20 times.\n"));
    }
}
