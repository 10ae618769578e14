//! Expressions.

use super::{Fault, Machine, fault};
use crate::arithmetic;
use crate::code::{Argument, Binary, Call, Expr, Operator, Output, Place, Unary};
use crate::declare::Pou;
use crate::error::Position;
use crate::kind::Kind;

impl Machine {
    /// The cell of an expression.
    pub(super) fn evaluate(&mut self, pous: &[Pou], expr: &Expr) -> Result<i64, Fault> {
        match expr {
            Expr::Value(value) => Ok(*value),
            Expr::Load(place) => {
                let address = self.address(pous, place)?;
                Ok(self.memory[address])
            }
            Expr::Binary(binary) => self.binary(pous, binary),
            Expr::Unary(unary, kind, operand) => {
                let value = self.evaluate(pous, operand)?;
                Ok(self.unary(*unary, *kind, value))
            }
            Expr::Shortcut(and, sides) => {
                let left = self.evaluate(pous, &sides.0)? != 0;
                if left == *and { self.evaluate(pous, &sides.1) } else { Ok(i64::from(left)) }
            }
            Expr::Convert { from, to, value } => {
                let value = self.evaluate(pous, value)?;
                let (cell, wrapped) = arithmetic::convert(*from, *to, value);
                self.stats.wrapped += u64::from(wrapped);
                Ok(cell)
            }
            Expr::Within(within) => {
                let value = self.evaluate(pous, &within.value)?;
                if value < within.low || value > within.high {
                    let message = format!("{value} is not within {}..{}", within.low, within.high);
                    return fault(within.at, message);
                }
                Ok(value)
            }
            Expr::Extreme(least, kind, values) => self.extreme(pous, *least, *kind, values),
            Expr::Select(choices, at) => self.select(pous, choices, *at),
            Expr::Call(call) => self.call(pous, call),
            Expr::Address(place, size) => self.pointer(pous, place, *size),
            Expr::Length(text) => {
                let mut buffer = Vec::new();
                self.text(pous, text, &mut buffer)?;
                Ok(buffer.len() as i64)
            }
            Expr::CompareTexts(operator, texts) => self.compare_texts(pous, *operator, texts),
            Expr::Number(text, kind, at) => self.number(pous, text, *kind, *at),
            Expr::Clock => Ok(self.clock),
        }
    }

    fn binary(&mut self, pous: &[Pou], binary: &Binary) -> Result<i64, Fault> {
        let indexed = self.stats.indexed;
        let a = self.evaluate(pous, &binary.left)?;
        let b = self.evaluate(pous, &binary.right)?;
        self.stats.compared += u64::from(binary.operator.is_comparison() && self.stats.indexed > indexed);
        match binary.operator {
            Operator::And => return Ok(a & b),
            Operator::Or => return Ok(a | b),
            Operator::Equal => return Ok(i64::from(a == b)),
            Operator::Unequal => return Ok(i64::from(a != b)),
            _ => {}
        }
        match arithmetic::binary(binary.operator, binary.kind, a, b) {
            Ok((value, wrapped)) => {
                self.stats.wrapped += u64::from(wrapped);
                Ok(value)
            }
            Err(message) => fault(binary.at, message),
        }
    }

    fn unary(&mut self, unary: Unary, kind: Kind, value: i64) -> i64 {
        let exact = match unary {
            Unary::Complement => return kind.wrap(!value),
            Unary::Absolute if value >= 0 || kind.is_wide_unsigned() => return value,
            Unary::Negate | Unary::Absolute => value.wrapping_neg(),
        };
        let wrapped = kind.wrap(exact);
        self.stats.wrapped += u64::from(kind.value(wrapped) != -kind.value(value));
        wrapped
    }

    fn extreme(&mut self, pous: &[Pou], least: bool, kind: Kind, values: &[Expr]) -> Result<i64, Fault> {
        let mut best = None;
        for value in values {
            let value = self.evaluate(pous, value)?;
            let better = best.is_none_or(|best| (kind.value(value) < kind.value(best)) == least);
            if better {
                best = Some(value);
            }
        }
        Ok(best.unwrap_or_default())
    }

    /// All choices are evaluated, as arguments of a function are.
    fn select(&mut self, pous: &[Pou], choices: &[Expr], at: Position) -> Result<i64, Fault> {
        let Some((selector, choices)) = choices.split_first() else { return Ok(0) };
        let selected = self.evaluate(pous, selector)?;
        let mut result = None;
        for (index, choice) in choices.iter().enumerate() {
            let value = self.evaluate(pous, choice)?;
            if index as i64 == selected {
                result = Some(value);
            }
        }
        match result {
            Some(value) => Ok(value),
            None => fault(at, format!("there is no choice {selected}")),
        }
    }

    /// The result of a function.
    fn call(&mut self, pous: &[Pou], call: &Call) -> Result<i64, Fault> {
        self.stats.calls += 1;
        let pou = &pous[call.pou];
        let frame = self.reserve(&pou.frame);
        self.pass(pous, frame, &call.inputs)?;
        self.run_function(pous, call.pou, frame)?;
        self.fetch(pous, frame, &call.outputs)?;
        self.top = frame;
        Ok(pou.result.map_or(0, |(_, at)| self.memory[frame + at as usize]))
    }

    /// Writes arguments into an instance or a frame.
    pub(super) fn pass(
        &mut self,
        pous: &[Pou],
        base: usize,
        inputs: &[(u32, Argument)],
    ) -> Result<(), Fault> {
        for (offset, argument) in inputs {
            let to = base + *offset as usize;
            match argument {
                Argument::Scalar(expr) => self.memory[to] = self.evaluate(pous, expr)?,
                Argument::Copy(place, size) => {
                    let from = self.span(pous, place, *size)?;
                    self.memory.copy_within(from..from + *size as usize, to);
                    self.stats.copied += u64::from(*size);
                }
                Argument::Text(text, capacity) => self.set_text(pous, to, *capacity, text)?,
                Argument::Reference(place) => self.memory[to] = self.address(pous, place)? as i64,
            }
        }
        Ok(())
    }

    /// Reads outputs from an instance or a frame.
    pub(super) fn fetch(&mut self, pous: &[Pou], base: usize, outputs: &[Output]) -> Result<(), Fault> {
        for Output { from, to, size } in outputs {
            let from = base + *from as usize;
            self.stats.copied += if *size > 1 { u64::from(*size) } else { 0 };
            self.copy(pous, from, to, *size)?;
        }
        Ok(())
    }

    /// Copies cells to a place.
    pub(super) fn copy(&mut self, pous: &[Pou], from: usize, to: &Place, size: u32) -> Result<(), Fault> {
        let to = self.span(pous, to, size)?;
        if to < self.globals {
            return fault(self.at, "a constant is written through a pointer");
        }
        self.memory.copy_within(from..from + size as usize, to);
        Ok(())
    }
}
