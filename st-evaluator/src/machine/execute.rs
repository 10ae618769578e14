//! Statements.

use super::{Fault, Machine, fault};
use crate::code::{Action, CallBlock, Case, For, Step};
use crate::declare::Pou;
use crate::error::Position;

/// Where execution goes on.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Flow {
    Next,
    Exit,
    Continue,
    Return,
}

impl Machine {
    /// Runs a body to its end.
    pub(super) fn execute(&mut self, pous: &[Pou], steps: &[Step]) -> Result<(), Fault> {
        self.block(pous, steps).map(|_| ())
    }

    fn block(&mut self, pous: &[Pou], steps: &[Step]) -> Result<Flow, Fault> {
        for step in steps {
            let flow = self.step(pous, step)?;
            if flow != Flow::Next {
                return Ok(flow);
            }
        }
        Ok(Flow::Next)
    }

    fn step(&mut self, pous: &[Pou], step: &Step) -> Result<Flow, Fault> {
        self.stats.statements += 1;
        self.at = step.at;
        self.burn()?;
        match &step.action {
            Action::Assign(place, value) => {
                let value = self.evaluate(pous, value)?;
                let address = self.address(pous, place)?;
                self.store(address, value)?;
            }
            Action::If { branches, otherwise } => {
                for (condition, body) in branches {
                    if self.evaluate(pous, condition)? != 0 {
                        return self.block(pous, body);
                    }
                }
                return self.block(pous, otherwise);
            }
            Action::Case(case) => return self.case(pous, case),
            Action::For(inner) => return self.for_loop(pous, inner, step.at),
            Action::While(condition, body) => {
                while self.evaluate(pous, condition)? != 0 {
                    match self.iterate(pous, body)? {
                        Flow::Exit => break,
                        Flow::Return => return Ok(Flow::Return),
                        Flow::Next | Flow::Continue => {}
                    }
                }
            }
            Action::Repeat(body, condition) => loop {
                match self.iterate(pous, body)? {
                    Flow::Exit => break,
                    Flow::Return => return Ok(Flow::Return),
                    Flow::Next | Flow::Continue => {}
                }
                if self.evaluate(pous, condition)? != 0 {
                    break;
                }
            },
            Action::Copy { to, from, size } => {
                let from = self.span(pous, from, *size)?;
                self.stats.copied += u64::from(*size);
                self.copy(pous, from, to, *size)?;
            }
            Action::SetText { to, capacity, text } => {
                let address = self.span(pous, to, *capacity + 2)?;
                self.set_text(pous, address, *capacity, text)?;
            }
            Action::CallBlock(call) => self.call_block(pous, call)?,
            Action::Discard(expr) => {
                self.evaluate(pous, expr)?;
            }
            Action::Exit => return Ok(Flow::Exit),
            Action::Continue => return Ok(Flow::Continue),
            Action::Return => return Ok(Flow::Return),
        }
        Ok(Flow::Next)
    }

    fn iterate(&mut self, pous: &[Pou], body: &[Step]) -> Result<Flow, Fault> {
        self.stats.iterations += 1;
        self.burn()?;
        self.block(pous, body)
    }

    fn case(&mut self, pous: &[Pou], case: &Case) -> Result<Flow, Fault> {
        let value = self.evaluate(pous, &case.selector)?;
        let behind = case.labels.partition_point(|(low, ..)| *low <= value);
        let found =
            behind.checked_sub(1).map(|index| case.labels[index]).filter(|(_, high, _)| value <= *high);
        match found {
            Some((_, _, branch)) => self.block(pous, &case.branches[branch as usize]),
            None => self.block(pous, &case.otherwise),
        }
    }

    fn for_loop(&mut self, pous: &[Pou], inner: &For, at: Position) -> Result<Flow, Fault> {
        let start = self.evaluate(pous, &inner.start)?;
        let end = inner.kind.value(self.evaluate(pous, &inner.end)?);
        let step = inner.kind.value(self.evaluate(pous, &inner.step)?);
        if step == 0 {
            return fault(at, "the step is 0");
        }
        let control = self.address(pous, &inner.control)?;
        self.store(control, start)?;
        loop {
            let value = inner.kind.value(self.memory[control]);
            if if step > 0 { value > end } else { value < end } {
                return Ok(Flow::Next);
            }
            match self.iterate(pous, &inner.body)? {
                Flow::Exit => return Ok(Flow::Next),
                Flow::Return => return Ok(Flow::Return),
                Flow::Next | Flow::Continue => {}
            }
            let next = inner.kind.value(self.memory[control]) + step;
            let (low, high) = inner.kind.range();
            if next < low || next > high {
                // It would wrap around, and never reach the end.
                return fault(at, format!("the control variable leaves `{}`", inner.kind.name()));
            }
            self.memory[control] = next as i64;
        }
    }

    fn call_block(&mut self, pous: &[Pou], call: &CallBlock) -> Result<(), Fault> {
        self.stats.calls += 1;
        let instance = self.address(pous, &call.instance)?;
        self.pass(pous, instance, &call.inputs)?;
        self.run_block(pous, call.pou, instance)?;
        self.fetch(pous, instance, &call.outputs)
    }
}
