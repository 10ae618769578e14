//! `docs/performance.md` and its plots, made from the figures.

use super::controllers::{LEVELS, SUBJECTS, shown};
use super::growth::{MOST, Point, per_doubling};
use super::members::{self, FAMILIES, Member};
use super::report::{EXPLORING, Outcome, Report, Stage, Version};
use crate::bare_metal::folders::Folders;
use crate::failure::{At, Failure, Result};
use crate::plot::{Series, grouped, plot};
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

const BEGIN: &str = "<!-- figures: `cargo xtask performance` writes them -->\n";
const END: &str = "<!-- end of figures -->\n";

/// A plot: its file, title, the name of its values, and which they are.
struct Plot {
    name: &'static str,
    title: &'static str,
    y: &'static str,
    of: fn(&Report, Member) -> Option<u64>,
}

const PLOTS: [Plot; 4] = [
    Plot { name: "total", title: "Time from the text to the product", y: "microseconds", of: total },
    Plot { name: "explore", title: "Time to find all states", y: "microseconds", of: exploration },
    Plot { name: "memory", title: "Memory of the process at its peak", y: "KiB", of: memory },
    Plot {
        name: "instructions",
        title: "Instructions of all stages for each state",
        y: "instructions",
        of: instructions,
    },
];

fn now(report: &Report, member: Member) -> Option<&Outcome> {
    report.runs.get(&(member, Version::Now))
}

fn total(report: &Report, member: Member) -> Option<u64> {
    now(report, member)?.total()
}

fn exploration(report: &Report, member: Member) -> Option<u64> {
    Some(now(report, member)?.explored()?.micros)
}

fn memory(report: &Report, member: Member) -> Option<u64> {
    now(report, member)?.peak().filter(|peak| *peak > 0).map(|peak| peak / 1024)
}

fn instructions(report: &Report, member: Member) -> Option<u64> {
    Some(point(report, member)?.per_state() as u64)
}

fn point(report: &Report, member: Member) -> Option<Point> {
    Some(Point::of(member.states(), report.instructions.get(&member)?))
}

/// The file of the figures.
pub(super) fn figures(folders: &Folders) -> PathBuf {
    folders.docs().join("performance.txt")
}

/// All files that are made from the figures, with their text.
pub(super) fn files(folders: &Folders, report: &Report) -> Result<Vec<(PathBuf, String)>> {
    let path = folders.docs().join("performance.md");
    let old = fs::read_to_string(&path).doing(format_args!("read `{}`", path.display()))?;
    let parts = old.split_once(BEGIN).and_then(|(before, rest)| Some((before, rest.split_once(END)?.1)));
    let (before, behind) =
        parts.ok_or_else(|| Failure::new("`docs/performance.md` has no place for figures"))?;
    let page = format!("{before}{BEGIN}{}{END}{behind}", text(report));
    let plots = PLOTS.iter().map(|each| {
        let svg = plot(each.title, "states", each.y, &series(report, each));
        (folders.docs().join(format!("performance-{}.svg", each.name)), svg)
    });
    Ok(plots.chain([(path, page)]).collect())
}

fn series(report: &Report, plot: &Plot) -> Vec<Series> {
    let points = |family: usize| {
        let members = members::all().filter(|member| member.family == family);
        members.filter_map(|member| Some((member.states(), (plot.of)(report, member)?))).collect()
    };
    let all = FAMILIES.iter().enumerate();
    all.map(|(number, family)| Series { name: family.title, own: false, points: points(number) })
        .filter(|series| !series.points.is_empty())
        .collect()
}

/// What stands between the marks.
fn text(report: &Report) -> String {
    let mut text = format!("\nMeasured with {}.\n\n", report.with);
    for Plot { name, title, .. } in &PLOTS {
        let _ = writeln!(text, "![{title}](performance-{name}.svg)");
    }
    text.push_str("\n### From the text to the product\n\n");
    totals(&mut text, report);
    text.push_str("\n### Threads\n\n");
    threads(&mut text, report);
    if report.runs.keys().any(|(_, version)| *version == Version::Before) {
        text.push_str("\n### Before and after\n\n");
        before_and_after(&mut text, report);
    }
    text.push_str("\n### Stages\n\n");
    stages(&mut text, report);
    text.push_str("\n### Instructions\n\n");
    growth(&mut text, report);
    text.push_str("\n### Controllers\n\n");
    controllers(&mut text, report);
    text.push('\n');
    text
}

/// Why there are no figures.
pub(super) fn unmeasured(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Measured(_) => String::new(),
        Outcome::Stopped(seconds) => format!("stopped after {seconds} s"),
        Outcome::Ended(3) => "limit reached".to_owned(),
        Outcome::Ended(code) => format!("ended with exit code {code}"),
        Outcome::Untried => "not tried after a smaller one did not end".to_owned(),
    }
}

/// `1,234.5`, of microseconds.
fn milliseconds(micros: u64) -> String {
    format!("{}.{}", grouped((micros + 50) / 1_000), (micros + 50) % 1_000 / 100)
}

/// With one decimal, or `–`.
fn ratio(part: u64, whole: u64) -> String {
    if whole == 0 { "–".to_owned() } else { format!("{:.1}", part as f64 / whole as f64) }
}

fn name(member: Member) -> String {
    format!("{} {}", member.family().title, member.number)
}

fn of_version(report: &Report, version: Version) -> impl Iterator<Item = (Member, &Outcome)> {
    let all = report.runs.iter().filter(move |((_, each), _)| *each == version);
    all.map(|((member, _), outcome)| (*member, outcome))
}

fn totals(text: &mut String, report: &Report) {
    text.push_str(
        "| member | states | transitions | controller | states found, ms | all else, ms | ratio | bytes a state | bytes a transition | peak, MiB |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for member in members::all() {
        let _ = write!(text, "| {} | ", name(member));
        let Some(outcome) = now(report, member) else {
            let _ = writeln!(text, "{} | not measured | | | | | | | |", grouped(member.states()));
            continue;
        };
        let (Some(found), Some(total), Some(peak)) = (outcome.explored(), outcome.total(), outcome.peak())
        else {
            let _ = writeln!(text, "{} | {} | | | | | | | |", grouped(member.states()), unmeasured(outcome));
            continue;
        };
        let Stage { micros, states, transitions, of_states, of_transitions, .. } = found;
        let controller = outcome.stage("minimise").map_or("–".to_owned(), |stage| grouped(stage.states));
        let _ = writeln!(
            text,
            "{} | {} | {controller} | {} | {} | {} | {} | {} | {:.1} |",
            grouped(states),
            grouped(transitions),
            milliseconds(micros),
            milliseconds(total - micros),
            ratio(total - micros, micros),
            ratio(of_states, states),
            ratio(of_transitions, transitions),
            peak as f64 / f64::from(1 << 20)
        );
    }
}

fn per_second(stage: &Stage) -> String {
    grouped((stage.states as f64 * 1e6 / stage.micros.max(1) as f64) as u64)
}

fn threads(text: &mut String, report: &Report) {
    text.push_str("| member | states | states a second, one thread | all threads |\n|---|--:|--:|--:|\n");
    for (member, one) in of_version(report, Version::OneThread) {
        let speed = |outcome: Option<&Outcome>| match outcome.map(|outcome| (outcome, outcome.explored())) {
            Some((_, Some(stage))) => per_second(&stage),
            Some((outcome, None)) => unmeasured(outcome),
            None => "not measured".to_owned(),
        };
        let (one, all) = (speed(Some(one)), speed(now(report, member)));
        let _ = writeln!(text, "| {} | {} | {one} | {all} |", name(member), grouped(member.states()));
    }
}

fn before_and_after(text: &mut String, report: &Report) {
    text.push_str(
        "| member | states | total before, ms | after | times | states found before, ms | after | times | peak before, MiB | after |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for (member, before) in of_version(report, Version::Before) {
        let Some(after) = now(report, member) else { continue };
        let _ = write!(text, "| {} | {} | ", name(member), grouped(member.states()));
        let found = |outcome: &Outcome| outcome.explored().map(|stage| stage.micros);
        for of in [Outcome::total, found] {
            let shown = |outcome| of(outcome).map_or_else(|| unmeasured(outcome), milliseconds);
            let times =
                of(before).zip(of(after)).map_or("–".to_owned(), |(before, after)| ratio(before, after));
            let _ = write!(text, "{} | {} | {times} | ", shown(before), shown(after));
        }
        let peak = |outcome: &Outcome| outcome.peak().map_or("–".to_owned(), |peak| ratio(peak, 1 << 20));
        let _ = writeln!(text, "{} | {} |", peak(before), peak(after));
    }
}

/// The largest measured member of each family.
fn stages(text: &mut String, report: &Report) {
    text.push_str("| member | stage | ms | % | states | transitions |\n|---|---|--:|--:|--:|--:|\n");
    for family in 0..FAMILIES.len() {
        let of_family = of_version(report, Version::Now).filter(|(member, _)| member.family == family);
        let Some((member, outcome)) = of_family.filter(|(_, outcome)| outcome.stages().is_some()).last()
        else {
            continue;
        };
        let total = outcome.total().unwrap_or_default().max(1);
        for stage in outcome.stages().unwrap_or_default() {
            let or_blank = |number| if number == 0 { String::new() } else { grouped(number) };
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {} |",
                name(member),
                stage.name,
                milliseconds(stage.micros),
                (stage.micros * 100 + total / 2) / total,
                or_blank(stage.states),
                or_blank(stage.transitions)
            );
        }
    }
}

fn growth(text: &mut String, report: &Report) {
    let _ = writeln!(
        text,
        "Growth is that of instructions per state from the member before, per doubling of states. \
         `--check` holds it below {MOST} % where members are large enough for what does not depend on their size.\n\n\
         | member | states | instructions a state | states found | all else | growth, % |\n\
         |---|--:|--:|--:|--:|--:|"
    );
    let mut before: Option<(Member, Point)> = None;
    for (&member, counts) in &report.instructions {
        let point = Point::of(member.states(), counts);
        let found = counts.iter().filter(|(name, _)| EXPLORING.contains(&name.as_str()));
        let found: u64 = found.map(|(_, count)| count).sum();
        let growth = before.filter(|(before, _)| before.family == member.family);
        let growth =
            growth.map_or(String::new(), |(_, before)| format!("{:.1}", per_doubling(before, point)));
        let each = |count: u64| grouped(count / point.states.max(1));
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {growth} |",
            name(member),
            grouped(point.states),
            each(point.instructions),
            each(found),
            each(point.instructions - found)
        );
        before = Some((member, point));
    }
    let missing = members::all().filter(|member| !report.instructions.contains_key(member));
    let missing: Vec<String> = missing.map(name).collect();
    if !missing.is_empty() {
        let _ = writeln!(text, "\nNot counted, because that takes long: {}.", missing.join(", "));
    }
}

fn controllers(text: &mut String, report: &Report) {
    let _ = writeln!(text, "| specification | `{}` | others |", LEVELS.join("` | `"));
    let _ = writeln!(text, "|---|{}---|", "--:|".repeat(LEVELS.len()));
    for subject in &SUBJECTS {
        let size = |level: &&str| {
            let size = report.controllers.get(&(subject.name.to_owned(), (*level).to_owned()));
            shown(size.copied())
        };
        let sizes: Vec<String> = LEVELS.iter().map(size).collect();
        let _ = writeln!(text, "| {} | {} | {} |", subject.title, sizes.join(" | "), subject.others);
    }
}

#[cfg(test)]
mod tests {
    use super::{Folders, Report, figures, files, milliseconds, text};

    #[test]
    fn the_page_has_the_figures() {
        let folders = Folders::new();
        let report = Report::read(&figures(&folders)).unwrap();
        for (path, text) in files(&folders, &report).unwrap() {
            if std::env::var_os("SML_BLESS").is_some() {
                std::fs::write(&path, &text).unwrap();
            }
            let old = std::fs::read_to_string(&path).unwrap();
            assert!(old == text, "`SML_BLESS=1 cargo test -p xtask` writes `{}`", path.display());
        }
    }

    #[test]
    fn what_did_not_end_has_its_row() {
        let text = text(
            &Report::parse(
                "stage lift 3 now us 1500 peak 2097152 states 68 of 680 transitions 144 of 1152 explore\n\
                 stage lift 3 now us 500 peak 3145728 states 40 of 0 transitions 0 of 0 minimise\n\
                 stopped lift 15 now 60\n\
                 ended lift 3 before 3\n",
            )
            .unwrap(),
        );
        assert!(text.contains("| lift 3 | 68 | 144 | 40 | 1.5 | 0.5 | 0.3 | 10.0 | 8.0 | 3.0 |\n"), "{text}");
        assert!(text.contains("| lift 15 | 1,654,784 | stopped after 60 s | | | | | | | |\n"), "{text}");
        assert!(
            text.contains("| lift 3 | 68 | limit reached | 2.0 | – | limit reached | 1.5 | – | – | 3.0 |\n"),
            "{text}"
        );
        assert!(text.contains("| arbiter 17 | 1,376,255 | not measured | | | | | | | |\n"), "{text}");
        assert!(text.contains(" philosophers 12, philosophers 14.\n"), "{text}");
        assert!(text.contains("| lift 3 | explore | 1.5 | 75 | 68 | 144 |\n"), "{text}");
    }

    #[test]
    fn times_are_rounded() {
        assert_eq!([0, 49, 50, 1_950, 1_234_567].map(milliseconds), ["0.0", "0.0", "0.1", "2.0", "1,234.6"]);
    }
}
