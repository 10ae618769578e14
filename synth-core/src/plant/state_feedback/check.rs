//! Whether the instructions do what the formulas say.
//!
//! The instruction list of the rungs of one event, or of one automaton's memory, is run on functions instead of values, from
//! variables that can be anything: that is all runs at once. The condition of an event is run on all values one by one, too,
//! up to [`EXHAUSTIVE`] variables. Rungs that follow each other do what they do one by one, so nothing else is to be checked.

use super::Assembly;
use super::memory::Switch;
use crate::logic::{Expr, Function, Instruction, Literal, TooLarge, Var, Words, run};
use crate::plant::{EventId, Rung};

/// So many variables are tried with all their values.
const EXHAUSTIVE: usize = 20;

impl Assembly<'_, '_> {
    /// The variable of the diagrams: relays come after all others.
    fn level(&self, variable: Var) -> Var {
        self.bounds.position.get(variable as usize).copied().unwrap_or(variable)
    }

    /// The variables of the program as they are before some rungs: anything.
    pub(super) fn anything(&mut self) -> Result<Vec<Function>, TooLarge> {
        (0..self.program.variables.len() as Var)
            .map(|variable| {
                let level = self.level(variable);
                self.bounds.bdd.variable(level)
            })
            .collect()
    }

    pub(super) fn function(&mut self, expr: &Expr) -> Result<Function, TooLarge> {
        let renamed = expr.renamed(&|variable| self.level(variable));
        renamed.function(&mut self.bounds.bdd)
    }

    /// Runs rungs on `values`; `false` if the list is malformed.
    fn run(&mut self, rungs: &[Rung], values: &mut [Function]) -> Result<bool, TooLarge> {
        let list: Vec<Instruction> = rungs.iter().flat_map(Rung::instructions).collect();
        Ok(run(&mut self.bounds.bdd, &list, values)?.is_some() || list.is_empty())
    }

    /// The rungs from `first` on are those of an event, which fires where `formula` holds.
    pub(super) fn check_event(
        &mut self,
        event: EventId,
        formula: &Expr,
        first: usize,
    ) -> Result<bool, TooLarge> {
        let formula = self.function(formula)?;
        let before = self.anything()?;
        let already = match self.fired {
            // The first event does not look at the relay.
            Some(fired) if !self.program.rungs[first..].iter().any(|rung| outputs(rung, fired)) => {
                before[fired as usize]
            }
            _ => Function::FALSE,
        };
        let fires = self.bounds.bdd.without(formula, already)?;
        let rungs = self.program.rungs[first..].to_vec();
        let own = rungs.iter().find(|rung| rung.event == Some(event));
        if let Some(rung) = own
            && !self.try_all(rung, fires)
        {
            return Ok(false);
        }
        let mut after = before.clone();
        if !self.run(&rungs, &mut after)? {
            return Ok(false);
        }
        let mut expected = before.clone();
        for command in &self.bounds.plant.events[event as usize].commands {
            let value = &mut expected[command.signal as usize];
            let bdd = &mut self.bounds.bdd;
            *value = if command.set { bdd.or(*value, fires)? } else { bdd.without(*value, fires)? };
        }
        let (on, switches) = self.switches_of(event)?;
        for mut switch in switches {
            switch.set = self.bounds.bdd.and(switch.set, fires)?;
            switch.reset = self.bounds.bdd.and(switch.reset, fires)?;
            expected[switch.variable as usize] = switch.next(self.bounds)?;
        }
        if let Some(fired) = self.fired {
            expected[fired as usize] = self.bounds.bdd.or(already, fires)?;
        }
        // What memory becomes where no entry is, is nobody's concern.
        let matters = self.bounds.bdd.or(on, !fires)?;
        self.agree(&after, &expected, matters, Some(event))
    }

    /// The rungs from `first` on switch bits of memory.
    pub(super) fn check_update(&mut self, switches: &[Switch], first: usize) -> Result<bool, TooLarge> {
        let rungs = self.program.rungs[first..].to_vec();
        let before = self.anything()?;
        let mut after = before.clone();
        if !self.run(&rungs, &mut after)? {
            return Ok(false);
        }
        let mut expected = before;
        for switch in switches {
            expected[switch.variable as usize] = switch.next(self.bounds)?;
        }
        self.agree(&after, &expected, Function::TRUE, None)
    }

    /// All variables but auxiliary relays are as expected; where it is about an event, bits of memory only where it matters.
    fn agree(
        &mut self,
        after: &[Function],
        expected: &[Function],
        matters: Function,
        event: Option<EventId>,
    ) -> Result<bool, TooLarge> {
        let kept = self.bounds.order.len();
        for (variable, (&a, &b)) in after.iter().zip(expected).enumerate() {
            if variable >= kept && self.fired != Some(variable as Var) {
                continue;
            }
            let where_it_matters = match event {
                Some(_) if (self.bounds.plant.signals.len()..kept).contains(&variable) => matters,
                _ => Function::TRUE,
            };
            let differs = self.bounds.bdd.ite(a, !b, b)?;
            if self.bounds.bdd.and(differs, where_it_matters)? != Function::FALSE {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether the condition of a rung, run on all values of the variables, is `expected`; beyond [`EXHAUSTIVE`] variables
    /// nothing is tried.
    fn try_all(&mut self, rung: &Rung, expected: Function) -> bool {
        let list = crate::logic::instructions(&rung.condition);
        let mut variables: Vec<Var> = self.bounds.bdd.support(&[expected]);
        variables.extend(list.iter().filter_map(|instruction| match instruction {
            Instruction::Str(Literal { variable, .. })
            | Instruction::And(Literal { variable, .. })
            | Instruction::Or(Literal { variable, .. }) => Some(self.level(*variable)),
            _ => None,
        }));
        variables.sort_unstable();
        variables.dedup();
        if variables.len() > EXHAUSTIVE {
            return true;
        }
        let table = self.bounds.bdd.truth_table(expected, &variables);
        let places: Vec<Option<usize>> = (0..self.program.variables.len() as Var)
            .map(|variable| variables.binary_search(&self.level(variable)).ok())
            .collect();
        let used = u64::MAX >> (64 - (1usize << variables.len().min(6)));
        let mut values = vec![0; places.len()];
        table.iter().enumerate().all(|(word, &expected)| {
            for (value, place) in values.iter_mut().zip(&places) {
                *value = place.map_or(0, |place| column(place, word));
            }
            matches!(run(&mut Words, &list, &mut values), Ok(Some(found)) if (found ^ expected) & used == 0)
        })
    }
}

/// The values of a variable in 64 neighbouring rows of a truth table, in which it is bit `place` of the row's number.
fn column(place: usize, word: usize) -> u64 {
    const BELOW_SIX: [u64; 6] = [
        0xaaaa_aaaa_aaaa_aaaa,
        0xcccc_cccc_cccc_cccc,
        0xf0f0_f0f0_f0f0_f0f0,
        0xff00_ff00_ff00_ff00,
        0xffff_0000_ffff_0000,
        0xffff_ffff_0000_0000,
    ];
    match place {
        0..6 => BELOW_SIX[place],
        _ if word >> (place - 6) & 1 == 1 => u64::MAX,
        _ => 0,
    }
}

fn outputs(rung: &Rung, variable: Var) -> bool {
    rung.coils.iter().any(|coil| coil.variable == variable && coil.drive == crate::plant::Drive::Out)
}
