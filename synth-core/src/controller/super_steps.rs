//! From a strategy to a controller: runs of system choices become super steps.

use super::{Alphabet, Component, Controller, Event, Lists, SuperStep, SuperSteps};
use crate::game::{Game, Strategy, YIELD};
use crate::parallel::share;
use std::{collections::BTreeMap, error::Error, fmt};

/// A super step of the strategy never ends, so no controller can do it.
///
/// Such a strategy can be a winning one: where an assumption has not been met yet, the system can keep the environment
/// from ever meeting it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EndlessSuperStep {
    /// A node of the strategy to which it comes back.
    pub node: u32,
}

impl fmt::Display for EndlessSuperStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the super step that comes back to node {} never ends", self.node)
    }
}

impl Error for EndlessSuperStep {}

/// Merges the system choices of a strategy into super steps (Gritzner and Greenyer 2018, section 4).
///
/// States are the environment's nodes of the strategy, the system's nodes at which a run of choices begins, and
/// those at which a super step is split because the next event commands a component that it commands already. A run
/// of yields alone vanishes. States are numbered breadth first from the initial one, which is 0, successors in table
/// order.
///
/// Events, components and codes come from the whole of `game`, so they do not depend on the strategy. `owed` says for each state of the
/// game which events (ids of `alphabet`) assumptions promise there; what is no environment event of the game is passed over.
///
/// It is done on so many threads, or as many as the machine runs at once if that is 0; the result does not depend on it.
///
/// # Errors
///
/// A run of system choices never ends.
pub fn merge(
    game: &Game,
    strategy: &Strategy,
    alphabet: &Alphabet,
    owed: &Lists,
    threads: usize,
) -> Result<Controller, EndlessSuperStep> {
    if let Some(node) = strategy.endless_run(game) {
        return Err(EndlessSuperStep { node });
    }
    let vocabulary = Vocabulary::new(game, alphabet);
    let mut walk = Walk::new(game, strategy);
    let mut runs = Runs {
        commanded: vec![None; vocabulary.components.len()],
        events: Vec::new(),
        vocabulary: &vocabulary,
    };
    let mut super_steps = SuperSteps::default();
    walk.visit(0);
    let mut source = 0;
    while let Some(&node) = walk.nodes.get(source as usize) {
        if walk.choice(node).is_some() {
            let end = runs.follow(&walk, source, node);
            super_steps.push(SuperStep { source, target: walk.visit(end), events: &runs.events });
        } else {
            for &target in &strategy.target[strategy.edges_of(node)] {
                walk.visit(target);
            }
        }
        source += 1;
    }
    Ok(Controller {
        states: source,
        initial: 0,
        environment: walk.environment(&vocabulary, threads),
        super_steps,
        owed: walk.owed(&vocabulary.promised(alphabet, owed), owed),
        events: vocabulary.events,
        commands: vocabulary.commands,
        components: vocabulary.components,
    })
}

/// The events, commands and components of `game` in a controller that accepts and does nothing: what names are made
/// of, whoever wins.
#[must_use]
pub fn interface(game: &Game, alphabet: &Alphabet) -> Controller {
    let Vocabulary { events, commands, components, .. } = Vocabulary::new(game, alphabet);
    Controller {
        states: 1,
        initial: 0,
        environment: vec![Vec::new(); events.len()],
        super_steps: SuperSteps::default(),
        owed: Lists::empty(1),
        events,
        commands,
        components,
    }
}

const NONE: u32 = u32::MAX;

/// The events on the edges of a game, in table order.
struct Vocabulary {
    events: Vec<Event>,
    commands: Vec<Event>,
    components: Vec<Component>,
    /// Per event id: index into `events` or `commands`; [`NONE`] if no edge has it.
    index: Vec<u32>,
    /// Per command: its component, or [`NONE`] if it goes to a controllable object.
    component: Vec<u32>,
}

impl Vocabulary {
    fn new(game: &Game, alphabet: &Alphabet) -> Self {
        let letters = &alphabet.letters;
        let mut occurs = vec![false; letters.len()];
        for label in game.actions.labels().filter(|&label| label != YIELD) {
            occurs[label as usize] = true;
        }
        let mut ids: Vec<u32> = (0..letters.len() as u32).filter(|&id| occurs[id as usize]).collect();
        ids.sort_unstable_by(|&a, &b| {
            letters[a as usize].event.text.cmp(&letters[b as usize].event.text).then(a.cmp(&b))
        });
        let mut index = vec![NONE; letters.len()];
        let (mut events, mut commands) = (Vec::new(), Vec::new());
        let mut by_object: BTreeMap<&str, Vec<u32>> = BTreeMap::new();
        for id in ids {
            let letter = &letters[id as usize];
            let side = if letter.controllable { &mut commands } else { &mut events };
            index[id as usize] = side.len() as u32;
            if letter.commands {
                by_object.entry(&letter.event.receiver).or_default().push(side.len() as u32);
            }
            side.push(letter.event.clone());
        }
        let mut component = vec![NONE; commands.len()];
        let mut components = Vec::new();
        for (object, commands) in by_object {
            for &command in &commands {
                component[command as usize] = components.len() as u32;
            }
            components.push(Component { object: object.to_owned(), commands });
        }
        Vocabulary { events, commands, components, index, component }
    }

    /// Per distinct list of ids the ascending indices of the environment's events among them.
    fn promised(&self, alphabet: &Alphabet, owed: &Lists) -> Lists {
        let is_event =
            |id: &u32| !alphabet.letters[*id as usize].controllable && self.index[*id as usize] != NONE;
        let lists = (0..owed.distinct() as u32).map(|list| {
            let events = owed.list(list).iter().filter(|id| is_event(id));
            let mut events: Vec<u32> = events.map(|&id| self.index[id as usize]).collect();
            events.sort_unstable();
            events.dedup();
            events
        });
        lists.collect()
    }
}

/// The nodes that are states of the controller, in order of discovery.
struct Walk<'a> {
    game: &'a Game,
    strategy: &'a Strategy,
    /// Per state: its node.
    nodes: Vec<u32>,
    /// Per node: its state, or that behind its yield; [`NONE`] if it was not met.
    state: Vec<u32>,
}

impl<'a> Walk<'a> {
    fn new(game: &'a Game, strategy: &'a Strategy) -> Self {
        Walk { game, strategy, nodes: Vec::new(), state: vec![NONE; strategy.nodes()] }
    }

    /// The system's choice in a node: label and successor. `None` where it has none to make.
    fn choice(&self, node: u32) -> Option<(u32, u32)> {
        if !self.game.turn[self.strategy.state[node as usize] as usize].is_system() {
            return None;
        }
        let edge = self.strategy.edges_of(node).next()?;
        Some((self.game.label(self.strategy.edge[edge] as usize), self.strategy.target[edge]))
    }

    /// The state for a node that is entered; yields are skipped (one yield leads to the environment's turn).
    fn visit(&mut self, entered: u32) -> u32 {
        let known = self.state[entered as usize];
        if known != NONE {
            return known;
        }
        let mut node = entered;
        while let Some((YIELD, next)) = self.choice(node) {
            node = next;
        }
        let mut state = self.state[node as usize];
        if state == NONE {
            state = self.nodes.len() as u32;
            self.nodes.push(node);
            self.state[node as usize] = state;
        }
        self.state[entered as usize] = state;
        state
    }

    /// Per event the rows of all states that were visited, once those are to which they lead.
    fn environment(&self, vocabulary: &Vocabulary, threads: usize) -> Vec<Vec<(u32, u32)>> {
        const LEAST: usize = 1 << 14;
        let mut parts = Vec::new();
        share(&mut parts, 0..self.nodes.len() as u32, LEAST, threads, |rows: &mut Vec<Vec<_>>, states| {
            rows.resize_with(vocabulary.events.len(), Vec::new);
            for (source, &node) in states.clone().zip(&self.nodes[states.start as usize..]) {
                if self.choice(node).is_none() {
                    for edge in self.strategy.edges_of(node) {
                        let label = self.game.label(self.strategy.edge[edge] as usize);
                        let target = self.state[self.strategy.target[edge] as usize];
                        rows[vocabulary.index[label as usize] as usize].push((source, target));
                    }
                }
            }
        });
        let mut parts = parts.into_iter();
        let mut all = parts.next().unwrap_or_default();
        parts.for_each(|part| all.iter_mut().zip(part).for_each(|(rows, more)| rows.extend(more)));
        all
    }

    /// Per state what is promised there, by the lists of states of the game.
    fn owed(&self, promised: &Lists, owed: &Lists) -> Lists {
        let mut of_states = promised.cleared();
        for &node in &self.nodes {
            let list = owed.number(self.strategy.state[node as usize] as usize);
            of_states.push_number(promised.number(list as usize));
        }
        of_states
    }
}

/// Collects super steps.
struct Runs<'a> {
    vocabulary: &'a Vocabulary,
    /// Per component: the last state whose super step commands it.
    commanded: Vec<Option<u32>>,
    /// The events of the last super step that was followed.
    events: Vec<u32>,
}

impl Runs<'_> {
    /// Follows the super step of state `source`, which begins in `node`, to the node in which it ends.
    fn follow(&mut self, walk: &Walk<'_>, source: u32, mut node: u32) -> u32 {
        self.events.clear();
        while let Some((label, next)) = walk.choice(node) {
            if label != YIELD {
                let command = self.vocabulary.index[label as usize];
                let component = self.vocabulary.component[command as usize];
                if component != NONE {
                    let last = self.commanded[component as usize].replace(source);
                    if last == Some(source) {
                        break;
                    }
                }
                self.events.push(command);
            }
            node = next;
        }
        node
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{show, trim};
    use super::super::{Letter, cycle::Machine};
    use super::*;
    use crate::game::{Actions, ActionsBuilder, KeySetsBuilder, Strategy, Turn};
    use proptest::prelude::{any, prop, prop_assert, prop_assert_eq, prop_oneof, proptest};
    use proptest::strategy::Strategy as Generator;
    use std::collections::BTreeSet;

    /// A state of a game: whether it is the system's, and its edges. The first edge of the system's is its choice.
    type Node = (bool, Vec<(String, u32)>);

    /// The notation of the fixtures, but with a target per system event, `yield` among them, and the first one chosen:
    /// `0: a 1, b 2` is the environment's, `1! arm.go 2, yield 3` the system's.
    fn parse(lines: &str) -> Vec<Node> {
        let lines = lines.lines().map(str::trim).filter(|line| !line.is_empty());
        lines
            .map(|line| {
                let (_, edges) = line.split_once([':', '!']).expect("a colon or an exclamation mark");
                let edges = edges.split(',').filter_map(|edge| edge.trim().split_once(' '));
                let edges = edges.map(|(label, target)| (label.to_owned(), target.parse().expect("a state")));
                (line.contains('!'), edges.collect())
            })
            .collect()
    }

    fn letter(controllable: bool, short: &str) -> Letter {
        let text = if controllable { format!("ctl -> {short}()") } else { format!("env -> ctl.{short}()") };
        let event = Event::from_text(&text).expect("an event");
        let commands = controllable && event.receiver != "log";
        Letter { event, controllable, commands }
    }

    fn alphabet(nodes: &[Node]) -> Alphabet {
        // Ids in an order that is not that of the texts, and one event that does not occur.
        let shorts: BTreeSet<(bool, &str)> = nodes
            .iter()
            .flat_map(|(system, edges)| edges.iter().map(|edge| (*system, edge.0.as_str())))
            .collect();
        let mut letters = vec![letter(true, "unused.go")];
        letters.extend(shorts.into_iter().rev().filter(|s| s.1 != "yield").map(|s| letter(s.0, s.1)));
        Alphabet { letters }
    }

    /// The game, and the strategy that takes the first edge of each of the system's states.
    fn game_and_strategy(nodes: &[Node], alphabet: &Alphabet) -> (Game, Strategy) {
        let id = |system: bool, short: &str| match short {
            "yield" => YIELD,
            _ => {
                let text = letter(system, short).event.text;
                alphabet.letters.iter().position(|letter| letter.event.text == text).expect("a letter") as u32
            }
        };
        let mut game = Game {
            initial: 0,
            turn: Vec::new(),
            silent: vec![false; nodes.len()],
            open: vec![0; nodes.len()],
            first: vec![0],
            action: Vec::new(),
            target: Vec::new(),
            actions: Actions::default(),
            key_sets: KeySetsBuilder::default().finish(),
            assumptions: Vec::new(),
            guarantees: Vec::new(),
        };
        let mut actions = ActionsBuilder::default();
        let mut strategy = Strategy {
            state: (0..nodes.len() as u32).collect(),
            first: vec![0],
            edge: Vec::new(),
            target: Vec::new(),
        };
        for (system, edges) in nodes {
            game.turn.push(if *system { Turn::SystemEventually } else { Turn::EnvironmentAny });
            for (i, (short, target)) in edges.iter().enumerate() {
                if !system || i == 0 {
                    strategy.edge.push(game.action.len() as u32);
                    strategy.target.push(*target);
                }
                game.action.push(actions.intern(id(*system, short), 0));
                game.target.push(*target);
            }
            game.first.push(game.action.len() as u32);
            strategy.first.push(strategy.edge.len() as u32);
        }
        game.actions = actions.finish();
        (game, strategy)
    }

    fn merged(nodes: &[Node]) -> Controller {
        let alphabet = alphabet(nodes);
        let (game, strategy) = game_and_strategy(nodes, &alphabet);
        merge(&game, &strategy, &alphabet, &Lists::empty(game.states()), 1).expect("super steps end")
    }

    #[track_caller]
    fn check(input: &str, expected: &str) {
        assert_eq!(show(&merged(&parse(input))), trim(expected));
    }

    #[test]
    fn choices_between_two_environment_events_become_one_super_step() {
        check(
            "0: a 1 \n 1! arm.go 2 \n 2! log.x 3 \n 3! press.go 0",
            "0: a 1
             1! arm.go log.x press.go 0",
        );
    }

    #[test]
    fn a_run_of_a_yield_alone_vanishes() {
        check("0: a 1 \n 1! yield 2 \n 2: b 0", "0: a 1\n1: b 0");
    }

    #[test]
    fn a_yield_at_the_end_of_a_run_is_not_listed() {
        check("0: a 1 \n 1! arm.go 2 \n 2! yield 3 \n 3: b 0", "0: a 1\n1! arm.go 2\n2: b 0");
    }

    #[test]
    fn an_initial_yield_vanishes() {
        check("0! yield 1, arm.go 0 \n 1: a 0", "0: a 0");
    }

    #[test]
    fn the_initial_state_may_have_a_super_step() {
        check("0! arm.go 1 \n 1: a 0", "0! arm.go 1\n1: a 0");
    }

    #[test]
    fn a_super_step_is_split_before_a_component_is_commanded_again() {
        check(
            "0: a 1 \n 1! arm.go 2 \n 2! press.go 3 \n 3! log.x 4 \n 4! arm.stop 5 \n 5! arm.go 6 \n 6! log.x 0",
            "0: a 1
             1! arm.go press.go log.x 2
             2! arm.stop 3
             3! arm.go log.x 0",
        );
    }

    #[test]
    fn events_between_controllable_objects_may_repeat() {
        check("0: a 1 \n 1! log.x 2 \n 2! arm.go 3 \n 3! log.x 0", "0: a 1\n1! log.x arm.go log.x 0");
    }

    #[test]
    fn a_run_that_begins_inside_another_is_a_state_of_its_own() {
        check(
            "0: a 1, b 2 \n 1! arm.go 2 \n 2! press.go 0",
            "0: a 1, b 2
             1! arm.go press.go 0
             2! press.go 0",
        );
    }

    #[test]
    fn a_run_that_begins_where_another_is_split_shares_its_state() {
        check(
            "0: a 1, b 2 \n 1! arm.go 2 \n 2! arm.stop 0",
            "0: a 1, b 2
             1! arm.go 2
             2! arm.stop 0",
        );
    }

    #[test]
    fn states_are_numbered_breadth_first() {
        check(
            "0: a 3, b 1 \n 1: a 2 \n 2: \n 3! arm.go 4 \n 4: b 2",
            "0: a 1, b 2
             1! arm.go 3
             2: a 4
             3: b 4
             4:",
        );
    }

    #[test]
    fn tables_hold_the_events_of_the_whole_game() {
        let controller =
            merged(&parse("0: b 1 \n 1! log.x 0, press.stop 2, arm.go 2, arm.aim 2, log.a 0 \n 2: a 0"));
        let texts = |events: &[Event]| events.iter().map(|event| event.text.clone()).collect::<Vec<_>>();
        assert_eq!(texts(&controller.events), ["env -> ctl.a()", "env -> ctl.b()"]);
        assert_eq!(
            texts(&controller.commands),
            [
                "ctl -> arm.aim()",
                "ctl -> arm.go()",
                "ctl -> log.a()",
                "ctl -> log.x()",
                "ctl -> press.stop()"
            ]
        );
        assert_eq!(
            controller.components,
            [
                Component { object: "arm".to_owned(), commands: vec![0, 1] },
                Component { object: "press".to_owned(), commands: vec![4] },
            ]
        );
        assert_eq!(controller.environment, [vec![], vec![(0, 1)]]);
        assert_eq!(controller.states, 2);
    }

    #[test]
    fn owed_events_are_indices_of_the_environment_s_in_order() {
        let nodes = parse("0: a 1, b 0 \n 1! yield 2 \n 2: c 3 \n 3! arm.go 0");
        let alphabet = alphabet(&nodes);
        let id =
            |text: &str| alphabet.letters.iter().position(|letter| letter.event.text == text).unwrap() as u32;
        let (game, strategy) = game_and_strategy(&nodes, &alphabet);
        let mut owed = Lists::empty(game.states());
        owed.set(0, &[id("env -> ctl.c()"), id("env -> ctl.a()"), id("ctl -> arm.go()"), 0]);
        owed.set(2, &[id("env -> ctl.b()"), id("env -> ctl.b()")]);
        let controller = merge(&game, &strategy, &alphabet, &owed, 1).expect("super steps end");
        assert_eq!(controller.owed, [vec![0, 2], vec![1], vec![]].iter().collect());
    }

    /// The node to which a super step comes back.
    #[track_caller]
    fn check_endless(input: &str, node: u32) {
        let nodes = parse(input);
        let alphabet = alphabet(&nodes);
        let (game, strategy) = game_and_strategy(&nodes, &alphabet);
        let merged = merge(&game, &strategy, &alphabet, &Lists::empty(game.states()), 1);
        assert_eq!(merged, Err(EndlessSuperStep { node }));
    }

    #[test]
    fn a_run_without_end_is_refused() {
        check_endless("0: a 1 \n 1! log.x 2 \n 2! log.y 3 \n 3! log.x 2", 2);
        check_endless("0! log.x 0", 0);
    }

    #[test]
    fn a_circle_of_yields_is_refused() {
        check_endless("0: a 1 \n 1! yield 1", 1);
        check_endless("0: a 1 \n 1! log.x 2 \n 2! yield 2", 2);
    }

    #[test]
    fn a_run_without_end_is_refused_although_it_would_be_split() {
        check_endless("0: a 1 \n 1! arm.go 2 \n 2! press.go 1", 1);
    }

    /// Games in which every run of system choices ends, and the last state is the environment's.
    fn nodes() -> impl Generator<Value = Vec<Node>> {
        let environment = |count: u32| {
            prop::collection::btree_map(prop::sample::select(vec!["a", "b"]), 0..count, 0..=2).prop_map(
                |edges| (false, edges.into_iter().map(|(e, t)| (e.to_owned(), t)).collect::<Vec<_>>()),
            )
        };
        let system = || {
            let labels = vec!["arm.go", "arm.stop", "press.go", "log.x", "yield"];
            (prop::sample::select(labels), 0..1000_u32).prop_map(|(e, t)| (true, vec![(e.to_owned(), t)]))
        };
        (1..16_u32).prop_flat_map(move |count| {
            let mixed = prop_oneof![1 => environment(count), 2 => system()];
            (prop::collection::vec(mixed, count as usize - 1), environment(count)).prop_map(
                |(mut nodes, last)| {
                    nodes.push(last);
                    let count = nodes.len() as u32;
                    for (i, (system, edges)) in (0..).zip(&mut nodes) {
                        for (_, target) in edges.iter_mut().filter(|_| *system) {
                            *target = i + 1 + *target % (count - 1 - i);
                        }
                    }
                    nodes
                },
            )
        })
    }

    /// Follows the system's choices from a node: the events, and the environment's node at their end.
    fn settle(nodes: &[Node], mut node: u32) -> (Vec<String>, u32) {
        let mut events = Vec::new();
        while let (true, edges) = &nodes[node as usize] {
            if edges[0].0 != "yield" {
                events.push(letter(true, &edges[0].0).event.text);
            }
            node = edges[0].1;
        }
        (events, node)
    }

    /// The same for the controller: cycles while a super step is due, at least one.
    fn cycles(controller: &Controller, machine: &mut Machine<'_>) -> Vec<String> {
        let mut events = Vec::new();
        while controller.super_steps.iter().any(|step| step.source == machine.state()) {
            events.extend(machine.cycle().events);
        }
        events.into_iter().map(|event| controller.commands[event as usize].text.clone()).collect()
    }

    proptest! {
        #[test]
        fn the_controller_answers_as_the_strategy(
            nodes in nodes(),
            choices in prop::collection::vec(any::<prop::sample::Index>(), 0..12),
        ) {
            let controller = merged(&nodes);
            let mut machine = Machine::new(&controller);
            let (expected, mut node) = settle(&nodes, 0);
            prop_assert_eq!(cycles(&controller, &mut machine), expected);
            for choice in choices {
                let edges = &nodes[node as usize].1;
                let accepted: Vec<bool> = (0..controller.events.len() as u32).map(|e| machine.accepts(e)).collect();
                prop_assert_eq!(accepted.iter().filter(|accepts| **accepts).count(), edges.len());
                if edges.is_empty() {
                    break;
                }
                let (short, target) = choice.get(edges);
                let text = letter(false, short).event.text;
                let event = controller.events.iter().position(|event| event.text == text).expect("an event");
                let mut answer = Vec::new();
                for event in machine.react(event as u32).expect("the event is accepted").events {
                    answer.push(controller.commands[event as usize].text.clone());
                }
                answer.extend(cycles(&controller, &mut machine));
                let (expected, next) = settle(&nodes, *target);
                prop_assert_eq!(answer, expected);
                node = next;
            }
        }

        #[test]
        fn no_super_step_is_empty_or_commands_a_component_twice(nodes in nodes()) {
            let controller = merged(&nodes);
            for step in &controller.super_steps {
                prop_assert!(!step.events.is_empty());
                let receivers = step.events.iter().map(|&event| &controller.commands[event as usize].receiver);
                let commanded: Vec<&String> = receivers.filter(|receiver| *receiver != "log").collect();
                let distinct: BTreeSet<&String> = commanded.iter().copied().collect();
                prop_assert_eq!(commanded.len(), distinct.len());
            }
        }
    }
}
