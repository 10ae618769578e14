//! Plays that the environment forces, replayed by the naive implementation: they are legal, they are lost by the
//! definition of who wins a play, and what is said of their steps is so.

use sml_tests::naive::cut::causing_modality;
use sml_tests::naive::matching::Context;
use sml_tests::naive::state::{Key, State};
use sml_tests::naive::{self, Case, Event, Semantics, Spec, Value};
use sml_tests::random::{Features, Options, specification};
use sml_tests::{corpus, fast};
use std::collections::BTreeSet;
use synth_core::explain::{Explanation, PlayStep, Refusal, SILENCE, explain};
use synth_core::explore::Limits;
use synth_core::game::{CounterStrategy, YIELD};
use synth_core::model::Type;
use synth_core::pipeline::{Failure, Solved};
use synth_core::syntax::ast::{FragmentKind, Modality, ScenarioKind};

/// A play under way.
struct Replay<'a> {
    spec: &'a Spec,
    semantics: Semantics,
    alphabet: BTreeSet<Event>,
    state: State,
}

/// What was seen of one step.
struct Seen {
    case: Case,
    /// Open before it.
    open: BTreeSet<Key>,
    discharged: BTreeSet<Key>,
    violated: BTreeSet<ScenarioKind>,
}

impl<'a> Replay<'a> {
    fn new(spec: &'a Spec, semantics: Semantics) -> Self {
        let state = spec.initial().expect("an initial state");
        Replay { spec, semantics, alphabet: spec.environment_alphabet(), state }
    }

    fn turn(&self) -> naive::turn::Turn {
        self.spec.turn(&self.alphabet, &self.state, self.semantics).expect("a turn")
    }

    /// Plays an event, a yield or silence, which must be possible.
    fn follow(&mut self, text: &str) -> Result<Seen, String> {
        let turn = self.turn();
        let (case, open) = (turn.case, self.spec.open(&self.state));
        let (discharged, violated) = (BTreeSet::new(), BTreeSet::new());
        if text == SILENCE {
            if !Spec::is_silent(&turn, self.semantics) {
                return Err("the environment may not be silent".to_owned());
            }
            return Ok(Seen { case, open, discharged, violated });
        }
        if text == "yield" {
            if case != Case::SystemEventually {
                return Err(format!("a yield in case {case:?}"));
            }
            self.state.yielded = true;
            return Ok(Seen { case, open, discharged, violated });
        }
        let found = turn.events.into_iter().find(|(event, _)| event.to_string() == text);
        let (_, step) = found.ok_or_else(|| format!("`{text}` cannot happen"))?;
        self.state = step.state;
        Ok(Seen { case, open, discharged: step.discharged, violated: step.violated })
    }
}

/// Why the system does not lose this play, or why it is none.
fn judge(spec: &Spec, semantics: Semantics, play: &[String], cycle: &[String]) -> Result<(), String> {
    let mut replay = Replay::new(spec, semantics);
    let mut last = None;
    for event in play {
        last = Some(replay.follow(event)?);
    }
    if cycle.is_empty() {
        let violated = last.map(|seen| seen.violated).unwrap_or_default();
        let lost =
            violated.contains(&ScenarioKind::Guarantee) && !violated.contains(&ScenarioKind::Assumption);
        return if lost { Ok(()) } else { Err(format!("the play ends with {violated:?}")) };
    }
    if last.is_some_and(|seen| !seen.violated.is_empty()) {
        return Err("the play goes on behind a violation".to_owned());
    }
    let begin = replay.state.clone();
    let mut loop_steps = Vec::new();
    for event in cycle {
        let seen = replay.follow(event)?;
        if !seen.violated.is_empty() {
            return Err(format!("`{event}` violates {:?}", seen.violated));
        }
        loop_steps.push(seen);
    }
    if replay.state != begin {
        return Err("the loop does not close".to_owned());
    }
    // What is open in the first state of the loop and not met in it.
    let starved = |kind: ScenarioKind| {
        let met = |key: &Key| {
            loop_steps.iter().any(|seen| !seen.open.contains(key) || seen.discharged.contains(key))
        };
        loop_steps[0].open.iter().any(|key| spec.scenarios[key.scenario].kind == kind && !met(key))
    };
    let endless = loop_steps.iter().all(|seen| seen.case.is_system());
    if starved(ScenarioKind::Assumption) {
        Err("the loop is not fair to the assumptions".to_owned())
    } else if starved(ScenarioKind::Guarantee) || endless {
        Ok(())
    } else {
        Err("every guarantee is met in the loop".to_owned())
    }
}

/// The event of a text that was met in exploration.
fn event(solved: &Solved<'_>, text: &str) -> Event {
    let playout = &solved.explored.playout;
    let domain = &playout.spec().domain;
    let event = playout.event(playout.find_event(text).expect("an event that was met"));
    let parameters = &domain.operations[event.operation].parameters;
    let value = |(&value, (_, ty)): (&i64, &(String, Type))| match ty {
        Type::Bool => Value::Bool(value != 0),
        Type::Int(..) => Value::Int(value),
        Type::Enum(_) => Value::Literal(domain.show(value, *ty)),
        Type::Class(_) if value < 0 => Value::Null,
        Type::Class(_) => Value::Object(domain.show(value, *ty)),
    };
    Event {
        sender: domain.objects[event.sender].name.clone(),
        receiver: domain.objects[event.receiver].name.clone(),
        operation: domain.operations[event.operation].name.clone(),
        arguments: event.arguments.iter().zip(parameters).map(value).collect(),
    }
}

/// Scenario, line and column of every message that causes an event in a state.
fn wanted_by(replay: &Replay<'_>, event: &Event) -> BTreeSet<(String, u32, u32)> {
    let spec = replay.spec;
    let mut wanted = BTreeSet::new();
    for copy in &replay.state.copies {
        let scenario = &spec.scenarios[copy.scenario];
        for (path, fragment) in copy.cut.fragments(&scenario.body) {
            let FragmentKind::Message(modifier, message) = &fragment.kind else { continue };
            let causes: Option<Modality> = match scenario.kind {
                ScenarioKind::Assumption => modifier.modality,
                _ if spec.is_controllable(&event.sender) => causing_modality(fragment),
                _ => None,
            };
            let context = Context::of(spec, &replay.state.attributes, copy);
            let matched = context.matches(&path[..path.len() - 1], message, event);
            if causes.is_some() && matches!(matched, Ok(Some(_))) {
                let start = fragment.span.start;
                wanted.insert((scenario.name.clone(), start.line, start.column));
            }
        }
    }
    wanted
}

/// What is said of a step, compared with the state in which it is made.
fn check_step(replay: &Replay<'_>, solved: &Solved<'_>, step: &PlayStep) -> Result<(), String> {
    let turn = replay.turn();
    if turn.case as u8 != step.turn as u8 {
        return Err(format!("case {:?}, said to be {:?}", turn.case, step.turn));
    }
    let executable: BTreeSet<String> = turn.events.iter().map(|(event, _)| event.to_string()).collect();
    for Refusal { event: text, by } in &step.forbidden {
        let event = event(solved, text);
        let violated = match replay.spec.step(&replay.state, &event) {
            Ok(step) => step.violated,
            Err(error) => error.violated,
        };
        if executable.contains(text) {
            return Err(format!("`{text}` is said to be refused, and can happen"));
        }
        if by.is_empty() == replay.spec.has_channel(&replay.state.attributes, &event) {
            return Err(format!("`{text}` has a channel or not"));
        }
        for mention in by {
            let kind = kind_of(replay.spec, &mention.scenario);
            if !violated.contains(&kind) {
                return Err(format!("`{text}` does not violate {}: {violated:?}", mention.scenario));
            }
        }
        if wanted_by(replay, &event).is_empty() {
            return Err(format!("nobody wants `{text}`"));
        }
    }
    if step.event == SILENCE || step.event == "yield" {
        return Ok(());
    }
    let event = event(solved, &step.event);
    let bare = |name: &str| name.split('[').next().unwrap_or(name).to_owned();
    let said: BTreeSet<(String, u32, u32)> = step
        .wanted_by
        .iter()
        .map(|one| (bare(&one.scenario), one.place.start.line, one.place.start.column))
        .collect();
    let found = wanted_by(replay, &event);
    if said != found {
        return Err(format!("`{event}` is said to be wanted by {said:?}, and is by {found:?}"));
    }
    let said: BTreeSet<ScenarioKind> =
        step.violates.iter().map(|one| kind_of(replay.spec, &one.scenario)).collect();
    let found = replay.spec.step(&replay.state, &event).expect("a step").violated;
    if said != found {
        return Err(format!("`{event}` is said to violate {said:?}, and does {found:?}"));
    }
    Ok(())
}

fn kind_of(spec: &Spec, name: &str) -> ScenarioKind {
    let bare = name.split('[').next().unwrap_or(name);
    spec.scenarios.iter().find(|scenario| scenario.name == bare).expect("a scenario").kind
}

fn check_explanation(
    spec: &Spec,
    semantics: Semantics,
    solved: &Solved<'_>,
    explanation: &Explanation,
) -> Result<(), String> {
    judge(spec, semantics, &explanation.play, &explanation.cycle)?;
    let texts: Vec<&String> = explanation.play.iter().chain(&explanation.cycle).collect();
    if texts != explanation.steps.iter().map(|step| &step.event).collect::<Vec<_>>() {
        return Err("the steps are not the play".to_owned());
    }
    let mut replay = Replay::new(spec, semantics);
    for step in &explanation.steps {
        check_step(&replay, solved, step)?;
        replay.follow(&step.event)?;
    }
    Ok(())
}

/// A generator of numbers; the same seed gives the same ones.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % bound
    }
}

/// A play of a system that chooses at random against the counter-strategy.
fn random_play(solved: &Solved<'_>, numbers: &mut Numbers) -> (Vec<String>, Vec<String>) {
    let game = &solved.explored.game;
    let mut strategy = CounterStrategy::new(game, &solved.solution).expect("a strategy of the environment");
    let mut at = strategy.begin();
    let (mut play, mut visited): (Vec<String>, Vec<(_, usize)>) = (Vec::new(), Vec::new());
    loop {
        if let Some(&(_, first)) = visited.iter().find(|(place, _)| *place == at) {
            let cycle = play.split_off(first);
            return (play, cycle);
        }
        visited.push((at, play.len()));
        let edges = game.edges_of(at.state);
        let edge = if game.turn[at.state as usize].is_system() {
            Some((edges.start + numbers.below(edges.len())) as u32)
        } else {
            strategy.choose(at)
        };
        let Some(edge) = edge else {
            let silent = strategy.starves(at).is_some();
            return (play, if silent { vec![SILENCE.to_owned()] } else { Vec::new() });
        };
        play.push(match game.label(edge as usize) {
            YIELD => "yield".to_owned(),
            event => solved.explored.playout.event(event).text.clone(),
        });
        at = strategy.follow(at, edge);
    }
}

/// Checks everything on one text; whether it is unrealizable.
fn check(text: &str, classic: bool, states: usize) -> Result<bool, String> {
    let spec = fast::resolved(text)?;
    let solved = match fast::solved(&spec, &fast::options(classic, states)) {
        Ok(solved) => solved,
        Err(Failure::Limit(_) | Failure::Wrong(_)) => return Ok(false),
        Err(failure) => return Err(format!("{failure:?}")),
    };
    let Some(explanation) = explain(&solved, &Limits::default()) else { return Ok(false) };
    let naive = Spec::new(&corpus::parse(text)?)?;
    let semantics = if classic { Semantics::Classic } else { Semantics::Default };
    check_explanation(&naive, semantics, &solved, &explanation)
        .map_err(|error| format!("{error}\n{explanation:#?}"))?;
    let mut numbers = Numbers(explanation.play.len() as u64);
    for _ in 0..10 {
        let (play, cycle) = random_play(&solved, &mut numbers);
        judge(&naive, semantics, &play, &cycle)
            .map_err(|error| format!("a random player: {error}\n{play:#?}\n{cycle:#?}"))?;
    }
    Ok(true)
}

#[track_caller]
fn check_all(texts: impl Iterator<Item = (String, String)>, states: usize) -> usize {
    let mut unrealizable = 0;
    for (name, text) in texts {
        for classic in [false, true] {
            match check(&text, classic, states) {
                Ok(found) => unrealizable += usize::from(found),
                Err(error) => panic!("{name}, classic {classic}: {error}\n{text}"),
            }
        }
    }
    unrealizable
}

/// How many seeds; `SML_SEEDS` asks for a longer run.
fn seeds(default: u64) -> std::ops::Range<u64> {
    0..std::env::var("SML_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}

#[test]
fn on_the_corpus() {
    let unrealizable = check_all(corpus::all().into_iter().map(|entry| (entry.name, entry.text)), 20_000);
    assert!(unrealizable > 5, "{unrealizable}");
}

#[test]
fn on_the_core_language() {
    let options = Options { features: Features::CORE, ..Options::default() };
    let texts = seeds(150).map(|seed| (format!("seed {seed}"), specification(seed, options)));
    let unrealizable = check_all(texts, 2000);
    assert!(unrealizable > 50, "{unrealizable}");
}

#[test]
fn on_the_full_language() {
    let texts = seeds(150).map(|seed| (format!("seed {seed}"), specification(seed, Options::default())));
    let unrealizable = check_all(texts, 2000);
    assert!(unrealizable > 50, "{unrealizable}");
}
