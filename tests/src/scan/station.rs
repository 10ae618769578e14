//! The distribution station's program as an engineer would write it: what components must be in, then what constraints ask for.

use super::Plan;
use synth_core::logic::{Expr, Literal, Var};
use synth_core::plant::{self, Coil, Drive, Plant, Program, Rung, SignalKind, Use, Variable};
use synth_core::syntax::FileId;

const TEXT: &str = include_str!("../../plants/distribution_station.plant");

/// Event, and when it may fire: `+` over products of contacts, in parentheses within products.
const CONDITIONS: [(&str, &str); 6] = [
    ("inject", "!Y2 X0 !X1 !X6 !Y0 !X2 X3"),
    ("reset", "Y2 !X0 X1 !Y3 X5 !Y1 X2 !X3"),
    ("right", "!Y1 X2 !X3 ( !Y2 !X0 + !Y2 X0 !X1 !X6 ) ( !Y4 !X5 + !Y3 X5 )"),
    ("left", "!Y0 !X2 X3 !Y4 !X5 ( Y2 !X0 X1 + X6 !Y2 ( X0 !X1 + !X0 ) )"),
    ("grab", "!Y4 !X5 !Y1 X2 !X3 Y2 !X0 X1"),
    ("rls", "!Y3 X5 !Y0 !X2 X3"),
];

/// Its components.
///
/// # Panics
///
/// If the plant is not what it was.
#[must_use]
pub fn plant() -> Plant {
    plant::read(TEXT, FileId::default()).expect("a plant").0
}

/// The station.
///
/// # Panics
///
/// If the plant is not what it was.
#[must_use]
pub fn station() -> Plan {
    let plant = plant();
    let usage = |kind| if kind == SignalKind::Input { Use::Input } else { Use::Output };
    let variable = |signal: &plant::Signal| Variable {
        name: signal.name.clone(),
        usage: usage(signal.kind),
        doc: signal.doc.clone(),
    };
    let rungs = CONDITIONS.iter().map(|&(event, condition)| rung(&plant, event, condition)).collect();
    let program = Program {
        name: plant.name.clone(),
        doc: plant.doc.clone(),
        variables: plant.signals.iter().map(variable).collect(),
        analogues: vec![],
        rungs,
    };
    Plan::new(program, plant.events)
}

fn rung(plant: &Plant, event: &str, condition: &str) -> Rung {
    let number = plant.events.iter().position(|it| it.name == event).expect("an event");
    let coils = plant.events[number].commands.iter().map(|command| Coil {
        variable: command.signal,
        drive: if command.set { Drive::Set } else { Drive::Reset },
    });
    let condition = sum(plant, &mut condition.split_whitespace().peekable());
    Rung { event: Some(number as u32), comment: vec![], condition, coils: coils.collect() }
}

type Words<'a> = std::iter::Peekable<std::str::SplitWhitespace<'a>>;

fn sum(plant: &Plant, words: &mut Words<'_>) -> Expr {
    let mut terms = vec![product(plant, words)];
    while words.next_if_eq(&"+").is_some() {
        terms.push(product(plant, words));
    }
    if terms.len() == 1 { terms.remove(0) } else { Expr::Or(terms) }
}

fn product(plant: &Plant, words: &mut Words<'_>) -> Expr {
    let mut parts = Vec::new();
    while let Some(word) = words.next_if(|&word| !matches!(word, "+" | ")")) {
        match word {
            "(" => {
                parts.push(sum(plant, words));
                words.next();
            }
            name => parts.push(literal(plant, name)),
        }
    }
    if parts.len() == 1 { parts.remove(0) } else { Expr::And(parts) }
}

fn literal(plant: &Plant, name: &str) -> Expr {
    let (negated, name) = name.strip_prefix('!').map_or((false, name), |name| (true, name));
    let variable = plant.signals.iter().position(|signal| signal.name == name).expect("a signal") as Var;
    Expr::Literal(Literal { variable, negated })
}
