//! What the back ends are told of the specification: its events, its requirements, where it came from.

use super::Options;
use crate::controller::tables::{Provenance, Requirement, Tables};
use crate::controller::{Alphabet, Controller, Event, Letter};
use crate::model::{Kind, Scenario, Spec};
use crate::playout::Playout;
use crate::syntax::Loaded;

/// The events behind the labels of the game.
#[must_use]
pub fn alphabet(playout: &Playout<'_>) -> Alphabet {
    let domain = &playout.spec().domain;
    let letter = |event: u32| {
        let event = playout.event(event);
        let operation = &domain.operations[event.operation];
        let values = event.arguments.iter().zip(&operation.parameters);
        Letter {
            event: Event {
                text: event.text.clone(),
                sender: domain.objects[event.sender].name.clone(),
                receiver: domain.objects[event.receiver].name.clone(),
                operation: operation.name.clone(),
                arguments: values.map(|(&value, (_, ty))| domain.show(value, *ty)).collect(),
            },
            controllable: event.controllable,
            commands: event.controllable && !playout.spec().controllable[event.receiver],
        }
    };
    Alphabet { letters: (0..playout.event_count() as u32).map(letter).collect() }
}

/// The tables of a controller, or of a monitor, which has a name of its own: both can be parts of one program.
#[must_use]
pub fn tables(loaded: &Loaded, spec: &Spec, options: &Options, controller: &Controller) -> Tables {
    let name = if options.monitor { format!("{}Monitor", spec.name) } else { spec.name.clone() };
    Tables::new(&name, controller, provenance(loaded, spec, options))
}

/// What outputs say of their origin.
#[must_use]
pub fn provenance(loaded: &Loaded, spec: &Spec, options: &Options) -> Provenance {
    let requirement = |scenario: &Scenario| Requirement {
        scenario: scenario.name.clone(),
        kind: match scenario.kind {
            Kind::Assumption => "assumption",
            Kind::Guarantee => "guarantee",
            Kind::Existential => "existential",
        },
        text: scenario.requirement.clone(),
        file: loaded.sources.path(scenario.span.file).to_owned(),
        line: scenario.span.start.line,
    };
    Provenance {
        file: loaded.sources.path(Loaded::MAIN).to_owned(),
        hash: loaded.hash(),
        options: if options.monitor { " --monitor".to_owned() } else { options.level.option() },
        level: options.level,
        monitor: options.monitor,
        requirements: spec.scenarios.iter().map(requirement).collect(),
    }
}
