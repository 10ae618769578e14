//! What a controller may do in a node of the product, and what it must not.

use super::machine::Machine;
use super::nodes::Control;
use crate::game::{Turn, YIELD};
use crate::playout::{EventId, Playout};
use crate::successors::PackedMoves;

/// A move that the controller makes or follows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// Index of the edge among the moves.
    pub(super) edge: usize,
    /// Where the controller is then.
    pub(super) control: Control,
}

/// What must not happen.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Fault {
    /// The controller accepts an event while a super step is due.
    Accepts,
    /// It sends a command in the environment's turn.
    OutOfTurn(u32),
    /// It sends a command that is not allowed.
    NotAllowed(u32),
    /// It waits where it must send something.
    Waits,
    /// The environment violates a guarantee with this event.
    Lost(EventId),
    /// The controller does not accept an event.
    Refuses(EventId),
}

impl Fault {
    /// The event that shows it, and what goes wrong.
    pub(super) fn reason(
        self,
        machine: &Machine<'_>,
        control: Control,
        playout: &Playout<'_>,
    ) -> (Option<EventId>, String) {
        match self {
            Fault::Accepts => {
                let event = machine.accepted(control.state).unwrap_or_default();
                (None, format!("the controller accepts `{event}` while its super step is due"))
            }
            Fault::OutOfTurn(command) => {
                let text = machine.command_text(command);
                (None, format!("the controller sends `{text}` in the environment's turn"))
            }
            Fault::NotAllowed(command) => {
                let text = machine.command_text(command);
                (None, format!("the controller sends `{text}`, which is not allowed here"))
            }
            Fault::Waits => {
                let reason = "the controller sends nothing where it must send a committed or urgent message";
                (None, reason.to_owned())
            }
            Fault::Lost(event) => (Some(event), "the environment violates a guarantee".to_owned()),
            Fault::Refuses(event) => {
                (Some(event), format!("the controller does not accept `{}`", playout.event(event).text))
            }
        }
    }
}

/// Finds the steps from a node, given the moves of its state. A move that wins the game at once (classic semantics) leads
/// nowhere and is no step.
pub(super) fn steps(
    machine: &Machine<'_>,
    control: Control,
    moves: &PackedMoves,
    steps: &mut Vec<Step>,
) -> Result<(), Fault> {
    steps.clear();
    match machine.due(control.state) {
        Some(_) => command(machine, control, moves, steps),
        None => wait(machine, control, moves, steps),
    }
}

/// The controller sends the next event of its super step.
fn command(
    machine: &Machine<'_>,
    at: Control,
    moves: &PackedMoves,
    steps: &mut Vec<Step>,
) -> Result<(), Fault> {
    let Some(step) = machine.due(at.state) else { return Ok(()) };
    if at.position == 0 && machine.accepted(at.state).is_some() {
        return Err(Fault::Accepts);
    }
    let command = step.events[at.position as usize];
    if !moves.turn.is_system() {
        return Err(Fault::OutOfTurn(command));
    }
    let sent = moves.edges().iter().position(|edge| machine.is_command(edge.event, command));
    let edge = sent.ok_or(Fault::NotAllowed(command))?;
    let last = at.position as usize + 1 == step.events.len();
    let control = if last {
        Control { state: step.target, position: 0 }
    } else {
        Control { position: at.position + 1, ..at }
    };
    if moves.edges()[edge].end.is_none() {
        steps.push(Step { edge, control });
    }
    Ok(())
}

/// The controller waits for the environment.
fn wait(
    machine: &Machine<'_>,
    control: Control,
    moves: &PackedMoves,
    steps: &mut Vec<Step>,
) -> Result<(), Fault> {
    match moves.turn {
        Turn::SystemEventually => {
            let pass = moves.edges().iter().position(|edge| edge.event == YIELD);
            steps.extend(pass.map(|edge| Step { edge, control }));
        }
        Turn::SystemCommitted | Turn::SystemUrgent => return Err(Fault::Waits),
        _ => {
            let mut accepts = machine.accepts(control.state);
            for (index, edge) in moves.edges().iter().enumerate() {
                if edge.end == Some(Turn::Lost) {
                    return Err(Fault::Lost(edge.event));
                }
                let Some(state) = accepts.target(edge.event) else {
                    return Err(Fault::Refuses(edge.event));
                };
                if edge.end.is_none() {
                    steps.push(Step { edge: index, control: Control { state, position: 0 } });
                }
            }
        }
    }
    Ok(())
}
