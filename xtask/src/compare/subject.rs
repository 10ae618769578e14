//! The controller that every machine implements: generated, the same in every run, with exactly so many transitions.

use super::line::{Happening, Line, MOST, ORDERS, REPORTS, Shape};
use std::collections::BTreeMap;
use synth_core::controller::{Component, Controller, Event, Lists, SuperStep, SuperSteps, number};

/// Where an event leads from a state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Row {
    pub(super) source: u32,
    pub(super) event: u32,
    /// The state after the super step, if there is one.
    pub(super) target: u32,
    /// Index of the super step; rows with the same commands on the way to the same state share one.
    pub(super) step: Option<u32>,
}

/// Commands on the way to a state.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Step {
    pub(super) target: u32,
    /// Per component a code, 0 for none.
    pub(super) codes: Vec<u8>,
}

/// A machine over states that wait for events, by rows. [`controller`](Self::controller) has the same with states for the
/// super steps.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Subject {
    /// States, breadth first; 0 is the initial one.
    pub(super) states: u32,
    /// Texts of the events in table order.
    pub(super) events: Vec<String>,
    /// Objects that are commanded; code `i + 1` is `ORDERS[i]` for each.
    pub(super) components: Vec<String>,
    /// By source, then event.
    pub(super) rows: Vec<Row>,
    pub(super) steps: Vec<Step>,
}

impl Subject {
    /// With exactly so many rows.
    ///
    /// The line has as many stations as it can have with no more rows when every batch has one item, and as many items
    /// in a batch as are needed then. The states nearest to the initial one are kept; what leads beyond goes to
    /// the state with another number of items delivered, or if there is none to the initial one.
    pub(super) fn new(transitions: u32) -> Subject {
        let mut shape = Shape { stations: 1, batch: 1 };
        let mut all = reached(shape, transitions);
        while shape.stations < MOST {
            let larger = Shape { stations: shape.stations + 1, batch: 1 };
            let more = reached(larger, transitions);
            if more.1.len() as u32 >= transitions {
                break;
            }
            (shape, all) = (larger, more);
        }
        while (all.1.len() as u32) < transitions {
            shape.batch += 1;
            all = reached(shape, transitions);
        }
        let (states, rows) = all;
        Subject::over(shape, &states, rows)
    }

    fn over(shape: Shape, states: &[Line], rows: Vec<(u32, Happening, Line)>) -> Subject {
        let kept = rows.last().map_or(0, |row| row.0) + 1;
        let numbers: BTreeMap<Line, u32> = states.iter().copied().zip(0..kept).collect();
        let number = |line: Line| {
            let twin = |distance| {
                let delivered = (line.delivered() + distance) % shape.batch;
                numbers.get(&line.with_delivered(delivered)).copied()
            };
            (0..shape.batch).find_map(twin).unwrap_or(0)
        };
        let mut steps = Vec::new();
        let mut step_numbers = BTreeMap::new();
        let mut rows: Vec<Row> = rows
            .into_iter()
            .map(|(source, happening, after)| {
                let (target, orders) = after.react(shape);
                let target = number(target);
                let step = (!orders.is_empty()).then(|| {
                    *step_numbers.entry((after, target)).or_insert_with(|| {
                        let mut codes = vec![0; shape.stations];
                        for order in &orders {
                            codes[order.station] = order.order as u8 + 1;
                        }
                        steps.push(Step { target, codes });
                        steps.len() as u32 - 1
                    })
                });
                Row { source, event: event_number(happening), target, step }
            })
            .collect();
        rows.sort_unstable_by_key(|row| (row.source, row.event));
        let stations = (1..=shape.stations).map(|number| format!("station{number}"));
        let components: Vec<String> = stations.collect();
        let reports = components
            .iter()
            .flat_map(|station| REPORTS.map(|report| format!("{station} -> controller.{report}()")));
        let events = std::iter::once("belt -> controller.blankArrived()".to_owned()).chain(reports).collect();
        Subject { states: kept, events, components, rows, steps }
    }

    /// The same for the back ends, numbered as the pipeline numbers what it emits.
    pub(super) fn controller(&self) -> Controller {
        number(self.breadth_first())
    }

    fn breadth_first(&self) -> Controller {
        let (waiting, stepping) = self.numbers();
        let mut environment = vec![Vec::new(); self.events.len()];
        for row in &self.rows {
            let leads_to = match row.step {
                Some(step) => stepping[step as usize],
                None => waiting[row.target as usize],
            };
            environment[row.event as usize].push((waiting[row.source as usize], leads_to));
        }
        environment.iter_mut().for_each(|rows| rows.sort_unstable());
        let mut super_steps = SuperSteps::default();
        for (step, &source) in self.steps.iter().zip(&stepping) {
            let codes = (0..).zip(&step.codes).filter(|(_, code)| **code != 0);
            let events =
                codes.map(|(component, &code)| component * ORDERS.len() as u32 + u32::from(code) - 1);
            let events: Vec<u32> = events.collect();
            super_steps.push(SuperStep { source, target: waiting[step.target as usize], events: &events });
        }
        super_steps.sort();
        let states = self.states + self.steps.len() as u32;
        let orders = |station: &String| ORDERS.map(|order| event("controller", station, order));
        Controller {
            states,
            initial: 0,
            events: self.events.iter().map(|text| report(text)).collect(),
            commands: self.components.iter().flat_map(orders).collect(),
            components: (0..)
                .step_by(ORDERS.len())
                .zip(&self.components)
                .map(|(first, object)| Component {
                    object: object.clone(),
                    commands: (first..first + ORDERS.len() as u32).collect(),
                })
                .collect(),
            environment,
            super_steps,
            owed: Lists::empty(states as usize),
        }
    }

    /// The controller's numbers of the states, and of those in which the super steps are due.
    fn numbers(&self) -> (Vec<u32>, Vec<u32>) {
        let mut waiting = vec![None; self.states as usize];
        let mut stepping = vec![None; self.steps.len()];
        waiting[0] = Some(0);
        let mut next = 1;
        let mut fresh = |place: &mut Option<u32>| {
            if place.is_none() {
                *place = Some(next);
                next += 1;
            }
        };
        // Sources are in order of their discovery.
        for row in &self.rows {
            if let Some(step) = row.step {
                fresh(&mut stepping[step as usize]);
            }
            fresh(&mut waiting[row.target as usize]);
        }
        let all = |places: Vec<Option<u32>>| places.into_iter().map(Option::unwrap_or_default).collect();
        (all(waiting), all(stepping))
    }

    /// The rows of a state.
    pub(super) fn rows_of(&self, state: u32) -> &[Row] {
        let first = self.rows.partition_point(|row| row.source < state);
        let count = self.rows[first..].partition_point(|row| row.source == state);
        &self.rows[first..first + count]
    }

    /// The commands of a row: per component a code, 0 for none.
    pub(super) fn codes(&self, row: &Row) -> Vec<u8> {
        match row.step {
            Some(step) => self.steps[step as usize].codes.clone(),
            None => vec![0; self.components.len()],
        }
    }
}

/// States in order of discovery, and the first rows, each with the state right after the event.
fn reached(shape: Shape, transitions: u32) -> (Vec<Line>, Vec<(u32, Happening, Line)>) {
    let mut states = vec![Line::default()];
    let mut known = std::collections::BTreeSet::from([Line::default()]);
    let mut rows = Vec::new();
    let mut source = 0;
    while let Some(&line) = states.get(source as usize) {
        for (happening, after) in line.happenings(shape) {
            if rows.len() == transitions as usize {
                return (states, rows);
            }
            let (target, _) = after.react(shape);
            if known.insert(target) {
                states.push(target);
            }
            rows.push((source, happening, after));
        }
        source += 1;
    }
    (states, rows)
}

fn event_number(happening: Happening) -> u32 {
    match happening {
        Happening::Arrival => 0,
        Happening::Report { station, report } => (1 + station * REPORTS.len() + report) as u32,
    }
}

fn event(sender: &str, receiver: &str, operation: &str) -> Event {
    Event {
        text: format!("{sender} -> {receiver}.{operation}()"),
        sender: sender.to_owned(),
        receiver: receiver.to_owned(),
        operation: operation.to_owned(),
        arguments: Vec::new(),
    }
}

fn report(text: &str) -> Event {
    let (sender, rest) = text.split_once(" -> ").unwrap_or_default();
    let (receiver, operation) = rest.split_once('.').unwrap_or_default();
    event(sender, receiver, operation.trim_end_matches("()"))
}

#[cfg(test)]
mod tests {
    use super::Subject;

    #[test]
    fn rows_are_as_many_as_wanted() {
        for transitions in [1, 7, 50, 500, 5_000] {
            let subject = Subject::new(transitions);
            assert_eq!(subject.rows.len() as u32, transitions);
            assert!((0..subject.states).all(|state| !subject.rows_of(state).is_empty()));
            assert_eq!(subject, Subject::new(transitions));
        }
    }

    #[test]
    fn events_are_in_table_order() {
        let subject = Subject::new(500);
        assert!(subject.events.is_sorted());
        let controller = subject.controller();
        assert!(controller.commands.iter().map(|command| &command.text).is_sorted());
    }

    #[test]
    fn the_controller_does_the_same() {
        let subject = Subject::new(500);
        let controller = subject.controller();
        let (mut state, mut other) = (0, 0);
        for number in 0..2_000_usize {
            let rows = subject.rows_of(state);
            let row = &rows[number % rows.len()];
            let column = &controller.environment[row.event as usize];
            let found = column.iter().find(|(source, _)| *source == other).expect("a row").1;
            let step = controller.super_steps.due(found);
            assert_eq!(step.is_some(), row.step.is_some());
            other = step.map_or(found, |step| step.target);
            let commands = step.map_or(0, |step| step.events.len());
            assert_eq!(commands, subject.codes(row).iter().filter(|code| **code != 0).count());
            state = row.target;
        }
    }
}
