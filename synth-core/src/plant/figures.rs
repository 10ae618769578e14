//! Programs as instruction lists, and their figures.

use super::{Drive, Program, Rung, Use};
use crate::logic::{Instruction, instructions, stack_depth};

/// What a program costs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Figures {
    /// Instructions of the list, those of ranges too, the end of the program not counted.
    pub instructions: usize,
    /// How deep the stack of Booleans gets.
    pub stack_depth: usize,
    /// Rungs.
    pub rungs: usize,
    /// Contacts of all rungs.
    pub literals: usize,
}

impl Rung {
    /// The rung for a machine with a stack of Booleans: the condition, then the coils.
    #[must_use]
    pub fn instructions(&self) -> Vec<Instruction> {
        let mut list = instructions(&self.condition);
        list.extend(self.coils.iter().map(|coil| match coil.drive {
            Drive::Set => Instruction::Set(coil.variable),
            Drive::Reset => Instruction::Reset(coil.variable),
            Drive::Out => Instruction::Out(coil.variable),
        }));
        list
    }
}

impl Program {
    /// What it costs.
    #[must_use]
    pub fn figures(&self) -> Figures {
        let mut figures = Figures { instructions: 0, stack_depth: 0, rungs: self.rungs.len(), literals: 0 };
        // A range is two comparisons and where their result goes.
        let ranges =
            self.variables.iter().filter(|variable| matches!(variable.usage, Use::Range(..))).count();
        if ranges > 0 {
            (figures.instructions, figures.stack_depth) = (3 * ranges, 1);
        }
        for rung in &self.rungs {
            let list = rung.instructions();
            figures.instructions += list.len();
            figures.stack_depth = figures.stack_depth.max(stack_depth(&list));
            figures.literals += rung.condition.literals();
        }
        figures
    }
}
