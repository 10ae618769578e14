//! Rungs and coils that keep bits of memory up to date.

use super::{Assembly, not_constant};
use crate::logic::{Expr, Function, TooLarge, Var, factor};
use crate::plant::formulas::{Bounds, bit};
use crate::plant::remember::Change;
use crate::plant::{Coil, Drive, EventId};

/// A coil on a bit of memory.
pub(super) struct Write {
    pub coil: Coil,
    /// When the bit is driven, over the variables of the program.
    pub condition: Expr,
    /// The bit may be driven whenever the event fires.
    pub always: bool,
}

/// A coil that is driven when a relay, written further up, says so.
pub(super) struct Delayed {
    relay: Var,
    coil: Coil,
    /// What it does, for comments.
    what: String,
}

/// When one bit becomes true and when it becomes false, in the variables of the diagrams.
#[derive(Clone, Copy)]
pub(super) struct Switch {
    pub variable: Var,
    pub value: Function,
    pub set: Function,
    pub reset: Function,
}

impl Switch {
    /// Its value afterwards.
    pub(super) fn next(self, bounds: &mut Bounds<'_>) -> Result<Function, TooLarge> {
        let stays = bounds.bdd.without(self.value, self.reset)?;
        bounds.bdd.or(stays, self.set)
    }
}

/// What a list of changes does to every bit of one automaton.
pub(super) fn switches(
    bounds: &mut Bounds<'_>,
    which: usize,
    changes: &[&Change],
) -> Result<Vec<Switch>, TooLarge> {
    let mut switches = Vec::new();
    for number in 0..bounds.memory[which].bits {
        let variable = bit(bounds.plant, bounds.memory, which, number);
        let value = bounds.bdd.variable(bounds.position[variable as usize])?;
        let mut switch = Switch { variable, value, set: Function::FALSE, reset: Function::FALSE };
        for change in changes {
            let (old, new) = (change.old >> number & 1 == 1, change.new >> number & 1 == 1);
            if old == new {
                continue;
            }
            let occasion = occasion(bounds, which, change)?;
            let sum = if new { &mut switch.set } else { &mut switch.reset };
            *sum = bounds.bdd.or(*sum, occasion)?;
        }
        switches.push(switch);
    }
    Ok(switches)
}

/// Where a change takes place: states of components, and the bits before.
fn occasion(bounds: &mut Bounds<'_>, which: usize, change: &Change) -> Result<Function, TooLarge> {
    let remembered = &bounds.memory[which];
    let mut product = Function::TRUE;
    for (&component, &state) in remembered.components.iter().zip(&change.states) {
        let function = bounds.states[component as usize][state as usize];
        product = bounds.bdd.and(product, function)?;
    }
    for number in 0..remembered.bits {
        let variable = bit(bounds.plant, bounds.memory, which, number);
        let literal =
            bounds.bdd.literal(bounds.position[variable as usize], change.old >> number & 1 == 1)?;
        product = bounds.bdd.and(product, literal)?;
    }
    Ok(product)
}

impl Assembly<'_, '_> {
    /// The rungs that conclude from what is seen what one automaton has to remember.
    pub(super) fn update(&mut self, which: usize) -> Result<bool, TooLarge> {
        let memory = self.bounds.memory;
        let seen: Vec<&Change> = memory[which].seen.iter().collect();
        let switches = switches(self.bounds, which, &seen)?;
        let name = memory[which].name(self.bounds.plant);
        let mut writes = Vec::new();
        for switch in &switches {
            writes.extend(self.writes_of(*switch, None)?);
        }
        let first_rung = self.program.rungs.len();
        // Bits change all at once: where one is read after another has been written, conditions are computed beforehand.
        let alone = writes.len() < 2 || writes.len() == 2 && self.stable(&switches)?;
        let mut delayed = Vec::new();
        for write in writes {
            let comment = vec![format!("what `{name}` has to remember, from what is seen")];
            let condition = not_constant(write.condition);
            if alone {
                self.rung(None, comment, condition, vec![write.coil]);
            } else {
                delayed.push(self.delay(None, write.coil, comment, condition));
            }
        }
        self.drive(delayed);
        self.check_update(&switches, first_rung)
    }

    /// A rung that finds out whether a bit is to change, before any bit does; `cause` is the event if it is one's.
    pub(super) fn delay(
        &mut self,
        cause: Option<&str>,
        coil: Coil,
        mut comment: Vec<String>,
        condition: Expr,
    ) -> Delayed {
        let bit = &self.program.variables[coil.variable as usize].name;
        let verb = if coil.drive == Drive::Set { "set" } else { "reset" };
        let (relay, what) = match cause {
            Some(event) => (format!("{event}_{verb}s_{bit}"), format!("`{event}` {verb}s `{bit}`")),
            None => (format!("{verb}_{bit}"), format!("{verb} `{bit}`")),
        };
        let when = if cause.is_some() { "whether" } else { "whether to" };
        comment.push(format!("{when} {what}; found before any bit changes"));
        let relay = self.scratch(&relay);
        self.rung(None, comment, condition, vec![Coil { variable: relay, drive: Drive::Out }]);
        Delayed { relay, coil, what }
    }

    /// The rungs that change bits as was found.
    pub(super) fn drive(&mut self, delayed: Vec<Delayed>) {
        for Delayed { relay, coil, what } in delayed {
            let comment = vec![format!("{what}, as found above")];
            self.rung(None, comment, Expr::literal(relay, true), vec![coil]);
        }
    }

    /// There is one bit, and where it has been set it is not reset at once.
    fn stable(&mut self, switches: &[Switch]) -> Result<bool, TooLarge> {
        let [switch] = switches else { return Ok(false) };
        let variable = self.bounds.position[switch.variable as usize];
        let set = self.bounds.bdd.exists(switch.set, &[variable])?;
        Ok(self.bounds.bdd.and(set, switch.reset)? == Function::FALSE)
    }

    /// What an event does to bits of memory.
    pub(super) fn writes(&mut self, event: EventId) -> Result<Vec<Write>, TooLarge> {
        let (on, switches) = self.switches_of(event)?;
        let mut writes = Vec::new();
        for switch in switches {
            writes.extend(self.writes_of(switch, Some(on))?);
        }
        Ok(writes)
    }

    /// Where an event is enabled, and what it does there to bits of memory.
    pub(super) fn switches_of(&mut self, event: EventId) -> Result<(Function, Vec<Switch>), TooLarge> {
        let memory = self.bounds.memory;
        let (on, _) = self.bounds.on_and_off(event)?;
        let mut all = Vec::new();
        for (which, remembered) in memory.iter().enumerate() {
            let caused = remembered.caused.iter().filter(|(cause, _)| *cause == event);
            let caused: Vec<&Change> = caused.map(|(_, change)| change).collect();
            for mut switch in switches(self.bounds, which, &caused)? {
                switch.set = self.bounds.bdd.and(switch.set, on)?;
                switch.reset = self.bounds.bdd.and(switch.reset, on)?;
                all.push(switch);
            }
        }
        Ok((on, all))
    }

    fn writes_of(&mut self, switch: Switch, on: Option<Function>) -> Result<Vec<Write>, TooLarge> {
        let mut writes = Vec::new();
        for (drive, now, value) in
            [(Drive::Set, switch.set, switch.value), (Drive::Reset, switch.reset, !switch.value)]
        {
            if now == Function::FALSE {
                continue;
            }
            let other = if drive == Drive::Set { switch.reset } else { switch.set };
            let bdd = &mut self.bounds.bdd;
            // Setting what is set does no harm.
            let harmless = bdd.without(value, other)?;
            let upper = bdd.or(now, harmless)?;
            let always = match on {
                Some(on) => bdd.implies(on, upper)?,
                None => false,
            };
            let condition = factor(bdd, now, upper, &[])?;
            let order = &self.bounds.order;
            let condition = condition.renamed(&|level| order[level as usize]).in_order();
            writes.push(Write { coil: Coil { variable: switch.variable, drive }, condition, always });
        }
        Ok(writes)
    }
}
