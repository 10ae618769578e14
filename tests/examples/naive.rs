//! Prints the game of a specification as the naive implementation sees it: `naive FILE [classic]`, or
//! `naive SEED [classic]` for a random one.

use sml_tests::naive::explore::Owner;
use sml_tests::naive::state::Roles;
use sml_tests::naive::{Semantics, Spec, State, explore, solve};
use sml_tests::{corpus, random};

fn main() -> Result<(), String> {
    let mut arguments = std::env::args().skip(1);
    let source = arguments.next().ok_or("a file or a seed is missing")?;
    let semantics = match arguments.next().as_deref() {
        Some("classic") => Semantics::Classic,
        _ => Semantics::Default,
    };
    let text = match source.parse() {
        Ok(seed) => random::specification(seed, random::Options::default()),
        Err(_) => std::fs::read_to_string(&source).map_err(|error| error.to_string())?,
    };
    if source.parse::<u64>().is_ok() {
        print!("{text}");
    }
    let spec = Spec::new(&corpus::parse(&text)?)?;
    let graph = explore(&spec, semantics, 20_000).map_err(|error| format!("{error:?}"))?;
    let winning = solve(&graph);
    for (index, node) in graph.nodes.iter().enumerate() {
        let owner = match node.owner {
            Owner::Turn(case) => format!("turn {}", case as u8),
            Owner::Lost => "lost".into(),
            Owner::Won => "won".into(),
        };
        let verdict = if winning[index] { "winning" } else { "losing" };
        let silent = if node.silent { ", silent" } else { "" };
        println!("{index}: {owner}, {verdict}{silent}, open {:?}", node.open);
        if let Some(state) = &node.state {
            print_state(&spec, state);
        }
        for edge in graph.edges.iter().filter(|edge| edge.from == index) {
            let event = edge.event.as_ref().map_or("yield".to_string(), ToString::to_string);
            println!("    {event} => {}, discharges {:?}", edge.to, edge.discharged);
        }
    }
    for (index, (kind, key)) in graph.keys.iter().enumerate() {
        let name = &spec.scenarios[key.scenario].name;
        println!("key {index}: {kind:?} {name}{} {:?} {:?}", bound(&key.roles), key.fragment, key.values);
    }
    for (figure, value) in graph.figures(&winning).named() {
        println!("{figure}: {value}");
    }
    Ok(())
}

fn print_state(spec: &Spec, state: &State) {
    let attributes: Vec<String> = state
        .attributes
        .iter()
        .map(|((object, attribute), value)| format!("{object}.{attribute} = {value}"))
        .collect();
    if !attributes.is_empty() {
        println!("    {}", attributes.join(", "));
    }
    if state.yielded {
        println!("    yielded");
    }
    for copy in &state.copies {
        let variables: Vec<String> =
            copy.variables.iter().map(|((_, name), value)| format!("{name} = {value}")).collect();
        let cut = copy.cut.fragments(&spec.scenarios[copy.scenario].body);
        let cut: Vec<_> = cut.into_iter().map(|(path, _)| path).collect();
        let name = &spec.scenarios[copy.scenario].name;
        println!("    {name}{} at {cut:?} {}", bound(&copy.roles), variables.join(", "));
    }
}

fn bound(roles: &Roles) -> String {
    let roles: Vec<String> = roles.iter().map(|(role, object)| format!("{role}={object}")).collect();
    if roles.is_empty() { String::new() } else { format!("[{}]", roles.join(",")) }
}
