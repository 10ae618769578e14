//! Warnings: those of the corpus, and what the naive implementation has to say to their plays.

use sml_tests::naive::explore::{Graph, Owner};
use sml_tests::naive::{self, Event, Semantics};
use sml_tests::random::{self, specification as random_specification};
use sml_tests::{corpus, fast};
use std::collections::BTreeSet;
use synth_core::diagnostic::{Code, Diagnostic};
use synth_core::pipeline::{Timings, warnings};
use synth_core::syntax::ast::ScenarioKind;

/// The warnings of a text; none if it is too large or a play shows a mistake.
fn warnings_of(text: &str, classic: bool, states: usize) -> Option<Vec<Diagnostic>> {
    let loaded = fast::loaded(text);
    let spec = fast::resolved(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let mut solved = fast::solved(&spec, &fast::options(classic, states)).ok()?;
    Some(warnings(&loaded, &mut solved, true, &mut Timings::default()).expect("the solver is right"))
}

#[track_caller]
fn check(name: &str, expect: &[&str]) {
    let entry = corpus::all().into_iter().find(|entry| entry.name == name).expect("an entry of the corpus");
    let warnings = warnings_of(&entry.text, false, 10_000).expect("a small game");
    let lines = warnings.iter().map(|one| {
        let line = entry.text.lines().nth(one.span.start.line as usize - 1).unwrap_or_default();
        let length = (one.span.end.column - one.span.start.column) as usize;
        let marked: String = line.chars().skip(one.span.start.column as usize - 1).take(length).collect();
        format!("{} {marked}: {}", one.code as u16, one.message)
    });
    assert_eq!(lines.collect::<Vec<_>>(), expect);
}

#[test]
fn the_production_cell() {
    let unneeded = "99 NoBlankBeforePreviousIsPickedUp: no guarantee needs assumption \
                    `ProductionCell.NoBlankBeforePreviousIsPickedUp`";
    check("production_cell", &[unneeded]);
    check("pc_set_messages", &[unneeded]);
}

#[test]
fn the_production_cell_without_its_first_assumption() {
    check(
        "pc_no_a1_safe_strict",
        &[
            "90 ArmArrives: an event of the system can violate assumption `ProductionCell.ArmArrives`",
            "96 controller -> arm.moveTo(bind target): `controller -> feedArm.moveTo(press)` violates \
             `ProductionCell.ArmArrives`, although it has another argument",
            "90 ArmReleases: an event of the system can violate assumption `ProductionCell.ArmReleases`",
        ],
    );
}

#[test]
fn the_line() {
    check("line_2", &["99 NoQueue: no guarantee needs assumption `Line.NoQueue`"]);
}

#[test]
fn the_arbiter() {
    check(
        "arbiter_2",
        &[
            "95 client -> arbiter.request(): the order of `client1 -> arbiter.request()` and \
             `client2 -> arbiter.request()` makes a difference",
            "99 RequestOnce: no guarantee needs assumption `Arbiter.RequestOnce`",
        ],
    );
}

#[test]
fn the_elevator() {
    check(
        "elevator_3",
        &[
            "95 floor -> control.call(): the order of `floor2 -> control.call()` and \
             `lift1 -> control.wentUp()` makes a difference",
            "95 floor -> control.call(): the order of `floor1 -> control.call()` and \
             `lift1 -> control.wentDown()` makes a difference",
            "99 CallOnce: no guarantee needs assumption `Elevator.CallOnce`",
        ],
    );
}

#[test]
fn nothing_to_warn_of() {
    for name in ["hot_cold", "memory", "unreal_clash"] {
        check(name, &[]);
    }
}

fn semantics(classic: bool) -> Semantics {
    if classic { Semantics::Classic } else { Semantics::Default }
}

/// One specification as the naive implementation sees it.
struct Naive {
    spec: naive::Spec,
    graph: Graph,
}

impl Naive {
    fn new(text: &str, classic: bool) -> Option<Self> {
        let spec = naive::Spec::new(&corpus::parse(text).expect("a syntax tree")).expect("tables");
        let graph = naive::explore(&spec, semantics(classic), 800).ok()?;
        Some(Naive { spec, graph })
    }

    fn target(&self, node: usize, text: &str) -> Option<usize> {
        let edges = self.graph.edges.iter().filter(|edge| edge.from == node);
        let mut targets = edges.filter(|edge| show(edge.event.as_ref()) == text).map(|edge| edge.to);
        targets.next()
    }

    /// Follows a play; the node it ends in.
    #[track_caller]
    fn follow(&self, play: &[&str]) -> usize {
        play.iter().fold(0, |node, event| {
            self.target(node, event).unwrap_or_else(|| panic!("`{event}` is not executable: {play:?}"))
        })
    }

    /// The kinds of scenario that the event violates in a node.
    fn violated(&self, node: usize, text: &str) -> BTreeSet<ScenarioKind> {
        let state = self.graph.nodes[node].state.as_ref().expect("a state");
        match self.spec.step(state, &self.event(text)) {
            Ok(step) => step.violated,
            Err(error) => error.violated,
        }
    }

    fn event(&self, text: &str) -> Event {
        let (sender, rest) = text.split_once(" -> ").expect("an arrow");
        let (receiver, rest) = rest.split_once('.').expect("a point");
        let (operation, arguments) = rest.split_once('(').expect("a parenthesis");
        let parameters = self.spec.parameters(receiver, operation).expect("an operation");
        let arguments = arguments.trim_end_matches(')').split(", ").zip(parameters);
        let arguments = arguments.map(|(text, (_, ty))| {
            let mut values = self.spec.values_of(&ty).into_iter();
            values.find(|value| value.to_string() == text).unwrap_or(naive::Value::Null)
        });
        Event {
            sender: sender.to_owned(),
            receiver: receiver.to_owned(),
            operation: operation.to_owned(),
            arguments: arguments.collect(),
        }
    }

    /// Whether the warning is right, as far as plays and states show it.
    #[track_caller]
    fn judge(&self, warning: &Diagnostic, classic: bool) {
        let play = play(warning);
        match warning.code {
            Code::SystemBreaksAssumption => {
                let (last, before) = play.split_last().expect("an event");
                let node = self.follow(before);
                assert_eq!(
                    self.violated(node, last),
                    BTreeSet::from([ScenarioKind::Assumption]),
                    "{warning:?}"
                );
                let won = self.target(node, last).map(|target| self.graph.nodes[target].owner);
                assert_eq!(won, classic.then_some(Owner::Won));
            }
            Code::CoveredSiblings => {
                let (last, before) = play.split_last().expect("an event");
                let node = self.follow(before);
                assert!(!self.violated(node, last).is_empty(), "{warning:?}");
            }
            Code::Trapped => {
                let node = self.follow(&play);
                assert!(!self.graph.nodes[node].open.is_empty(), "{warning:?}");
            }
            Code::OrderMatters => {
                let node = self.follow(&play);
                for event in quoted(&warning.message) {
                    assert!(self.target(node, event).is_some(), "`{event}`: {warning:?}");
                }
            }
            Code::NeverStarts => {
                let name = quoted(&warning.message)[0];
                let states = self.graph.nodes.iter().filter_map(|node| node.state.as_ref());
                let mut copies = states.flat_map(|state| &state.copies);
                assert!(!copies.any(|copy| self.spec.scenarios[copy.scenario].name == name), "{warning:?}");
            }
            Code::NeverCaused => {
                let (class, operation) = quoted(&warning.message)[0].split_once('.').expect("a point");
                let mut events = self.graph.edges.iter().filter_map(|edge| edge.event.as_ref());
                let is_it = |e: &Event| {
                    e.operation == operation
                        && self.spec.is_instance(&e.receiver, class)
                        && !self.spec.is_controllable(&e.sender)
                };
                assert!(!events.any(is_it), "{warning:?}");
            }
            Code::NotNeeded => {
                assert_eq!(play, Vec::<&str>::new());
                let name = quoted(&warning.message)[0];
                let mut spec = self.spec.clone();
                let position = spec.scenarios.iter().position(|scenario| scenario.name == name);
                spec.relaxed = BTreeSet::from([position.expect("a scenario")]);
                // Relaxing can lead to more states; without an answer there is nothing to judge.
                if let Ok(graph) = naive::explore(&spec, semantics(classic), 5_000) {
                    assert!(naive::solve(&graph)[0], "{warning:?}");
                }
            }
            _ => assert_eq!(play, Vec::<&str>::new()),
        }
    }
}

fn show(event: Option<&Event>) -> String {
    event.map_or_else(|| "yield".to_owned(), ToString::to_string)
}

/// What stands in backticks.
fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// The play that a warning shows.
fn play(warning: &Diagnostic) -> Vec<&str> {
    let title = "the shortest play that leads there:\n  ";
    let plays: Vec<&str> = warning.notes.iter().filter_map(|note| note.strip_prefix(title)).collect();
    assert!(plays.len() <= 1, "{warning:?}");
    plays.iter().flat_map(|play| play.split("\n  ")).collect()
}

#[track_caller]
fn judge(text: &str, classic: bool, seen: &mut BTreeSet<Code>) {
    let Some(warnings) = warnings_of(text, classic, 700) else { return };
    if let Some(naive) = Naive::new(text, classic) {
        for warning in &warnings {
            naive.judge(warning, classic);
            seen.insert(warning.code);
        }
    }
}

#[test]
fn plays_of_the_corpus_are_legal() {
    let mut seen = BTreeSet::new();
    for entry in corpus::all().iter().filter(|entry| entry.expected["default"]["states"].as_u64() < Some(700))
    {
        judge(&entry.text, false, &mut seen);
        judge(&entry.text, true, &mut seen);
    }
    for code in [Code::SystemBreaksAssumption, Code::OrderMatters, Code::NotNeeded] {
        assert!(seen.contains(&code), "{code} is not in {seen:?}");
    }
}

#[test]
fn warnings_of_random_specifications_are_right() {
    let mut seen = BTreeSet::new();
    for seed in 0..150 {
        let text = random_specification(seed, random::Options::default());
        for classic in [false, true] {
            let judged = std::panic::catch_unwind(|| {
                let mut seen = BTreeSet::new();
                judge(&text, classic, &mut seen);
                seen
            });
            let Ok(judged) = judged else { panic!("seed {seed}, classic {classic}:\n{text}") };
            seen.extend(judged);
        }
    }
    for code in [
        Code::SystemBreaksAssumption,
        Code::Trapped,
        Code::NeverStarts,
        Code::Vacuous,
        Code::OrderMatters,
        Code::Unused,
        Code::NeverCaused,
        Code::NotNeeded,
    ] {
        assert!(seen.contains(&code), "{code} was never seen: {seen:?}");
    }
}
