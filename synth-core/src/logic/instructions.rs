//! Instruction lists for a machine with a stack of Booleans.
//!
//! `STR` pushes a variable or its negation, `AND` and `OR` combine the top with one, `ANDSTR` and `ORSTR` combine the two
//! topmost. `SET`, `RST` and `OUT` read the top and leave it; the `STR` after them starts anew with an empty stack. A
//! constant has no instructions: the machine has none for it, and programs have no rungs that need one.

use super::{Bdd, Expr, Function, Literal, TooLarge, Var};

/// One instruction. Negated operands are written `STR NOT x` and are one instruction, too.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Instruction {
    /// Pushes.
    Str(Literal),
    /// The top becomes its conjunction with the operand.
    And(Literal),
    /// The top becomes its disjunction with the operand.
    Or(Literal),
    /// Two values become their conjunction.
    AndStr,
    /// Two values become their disjunction.
    OrStr,
    /// Where the top is true, the variable becomes true.
    Set(Var),
    /// Where the top is true, the variable becomes false.
    Reset(Var),
    /// The variable becomes the top.
    Out(Var),
}

/// The fewest instructions that leave the value of `expr` on the stack without changing the expression, in the order that
/// keeps the stack shallow. Empty for a constant.
#[must_use]
pub fn instructions(expr: &Expr) -> Vec<Instruction> {
    let mut list = Vec::new();
    compile(expr, &mut list);
    list
}

fn compile(expr: &Expr, list: &mut Vec<Instruction>) {
    type Join = (fn(Literal) -> Instruction, Instruction);
    let (parts, (with_literal, with_top)): (_, Join) = match expr {
        Expr::Constant(_) => return,
        Expr::Literal(literal) => return list.push(Instruction::Str(*literal)),
        Expr::And(parts) => (parts, (Instruction::And, Instruction::AndStr)),
        Expr::Or(parts) => (parts, (Instruction::Or, Instruction::OrStr)),
    };
    // What is compound comes first, since the first operand needs no instruction to be joined; of that the deepest, since
    // nothing lies below it.
    let mut compound: Vec<&Expr> = parts.iter().filter(|part| !matches!(part, Expr::Literal(_))).collect();
    compound.sort_by_key(|part| usize::MAX - depth(part));
    let mut literals = parts.iter().filter_map(|part| match part {
        Expr::Literal(literal) => Some(*literal),
        _ => None,
    });
    match compound.split_first() {
        Some((first, rest)) => {
            compile(first, list);
            for part in rest {
                compile(part, list);
                list.push(with_top);
            }
        }
        None => list.extend(literals.next().map(Instruction::Str)),
    }
    list.extend(literals.map(with_literal));
}

/// How many [`instructions`] there are.
#[must_use]
pub fn count(expr: &Expr) -> usize {
    match expr {
        Expr::Constant(_) => 0,
        Expr::Literal(_) => 1,
        Expr::And(parts) | Expr::Or(parts) => {
            let compound = parts.iter().filter(|part| !matches!(part, Expr::Literal(_))).count();
            parts.iter().map(count).sum::<usize>() + compound.saturating_sub(1)
        }
    }
}

/// How deep the stack gets in [`instructions`].
#[must_use]
pub fn depth(expr: &Expr) -> usize {
    match expr {
        Expr::Constant(_) => 0,
        Expr::Literal(_) => 1,
        Expr::And(parts) | Expr::Or(parts) => {
            let mut depths: Vec<usize> =
                parts.iter().filter(|part| !matches!(part, Expr::Literal(_))).map(depth).collect();
            depths.sort_unstable();
            let deepest = depths.pop().unwrap_or(1);
            // The others are computed while the result so far lies below them.
            deepest.max(depths.pop().map_or(0, |second| second + 1))
        }
    }
}

/// How deep the stack gets while `list` runs.
#[must_use]
pub fn stack_depth(list: &[Instruction]) -> usize {
    let (mut height, mut deepest, mut after_coil) = (0usize, 0, false);
    for instruction in list {
        match instruction {
            Instruction::Str(_) => {
                height = if after_coil { 1 } else { height + 1 };
                after_coil = false;
            }
            Instruction::AndStr | Instruction::OrStr => height = height.saturating_sub(1),
            Instruction::And(_) | Instruction::Or(_) => {}
            Instruction::Set(_) | Instruction::Reset(_) | Instruction::Out(_) => after_coil = true,
        }
        deepest = deepest.max(height);
    }
    deepest
}

/// Values that the machine can compute with.
pub trait Algebra {
    /// A value.
    type Value: Copy;
    /// Negation.
    fn not(&mut self, a: Self::Value) -> Self::Value;
    /// Conjunction.
    fn and(&mut self, a: Self::Value, b: Self::Value) -> Result<Self::Value, TooLarge>;
    /// Disjunction.
    fn or(&mut self, a: Self::Value, b: Self::Value) -> Result<Self::Value, TooLarge> {
        let (a, b) = (self.not(a), self.not(b));
        let neither = self.and(a, b)?;
        Ok(self.not(neither))
    }
}

/// Sixty-four runs at once, a bit each.
pub struct Words;

impl Algebra for Words {
    type Value = u64;

    fn not(&mut self, a: u64) -> u64 {
        !a
    }

    fn and(&mut self, a: u64, b: u64) -> Result<u64, TooLarge> {
        Ok(a & b)
    }
}

/// All runs at once: values are functions of the variables.
impl Algebra for Bdd {
    type Value = Function;

    fn not(&mut self, a: Function) -> Function {
        !a
    }

    fn and(&mut self, a: Function, b: Function) -> Result<Function, TooLarge> {
        Bdd::and(self, a, b)
    }
}

/// Runs `list` on `variables`, and says what is on top of the stack in the end.
///
/// `None` if an instruction finds fewer values on the stack than it takes, or a variable that there is none of.
///
/// # Errors
/// If the algebra gives up.
pub fn run<A: Algebra>(
    algebra: &mut A,
    list: &[Instruction],
    variables: &mut [A::Value],
) -> Result<Option<A::Value>, TooLarge> {
    let mut machine = Machine { algebra, variables, stack: Vec::new(), after_coil: false };
    for &instruction in list {
        if machine.step(instruction)?.is_none() {
            return Ok(None);
        }
    }
    Ok(machine.stack.pop())
}

struct Machine<'a, A: Algebra> {
    algebra: &'a mut A,
    variables: &'a mut [A::Value],
    stack: Vec<A::Value>,
    /// The next value pushed is the first of a rung.
    after_coil: bool,
}

impl<A: Algebra> Machine<'_, A> {
    fn step(&mut self, instruction: Instruction) -> Result<Option<()>, TooLarge> {
        let (first, second) = match instruction {
            Instruction::Str(literal) => {
                if std::mem::take(&mut self.after_coil) {
                    self.stack.clear();
                }
                let value = self.operand(literal);
                self.stack.extend(value);
                return Ok(value.map(|_| ()));
            }
            Instruction::Set(variable) | Instruction::Reset(variable) | Instruction::Out(variable) => {
                return self.coil(instruction, variable);
            }
            Instruction::And(literal) | Instruction::Or(literal) => (self.stack.pop(), self.operand(literal)),
            Instruction::AndStr | Instruction::OrStr => {
                let second = self.stack.pop();
                (self.stack.pop(), second)
            }
        };
        let (Some(first), Some(second)) = (first, second) else { return Ok(None) };
        self.stack.push(match instruction {
            Instruction::And(_) | Instruction::AndStr => self.algebra.and(first, second)?,
            _ => self.algebra.or(first, second)?,
        });
        Ok(Some(()))
    }

    fn operand(&mut self, literal: Literal) -> Option<A::Value> {
        let value = *self.variables.get(literal.variable as usize)?;
        Some(if literal.negated { self.algebra.not(value) } else { value })
    }

    fn coil(&mut self, instruction: Instruction, variable: Var) -> Result<Option<()>, TooLarge> {
        self.after_coil = true;
        let (Some(&top), Some(value)) = (self.stack.last(), self.variables.get_mut(variable as usize)) else {
            return Ok(None);
        };
        *value = match instruction {
            Instruction::Set(_) => self.algebra.or(*value, top)?,
            Instruction::Reset(_) => {
                let stays = self.algebra.not(top);
                self.algebra.and(*value, stays)?
            }
            _ => top,
        };
        Ok(Some(()))
    }
}

#[cfg(test)]
mod tests;
