//! Strings.

use super::{Fault, Machine, fault};
use crate::code::{Expr, Operator, Text};
use crate::declare::Pou;
use crate::error::Position;
use crate::kind::Kind;

impl Machine {
    /// Adds the characters of a string.
    pub(super) fn text(&mut self, pous: &[Pou], text: &Text, out: &mut Vec<u8>) -> Result<(), Fault> {
        match text {
            Text::Literal(bytes) => out.extend_from_slice(bytes),
            Text::Load(place, capacity) => {
                let start = self.span(pous, place, capacity + 2)?;
                let length = self.memory[start] as usize;
                out.extend(self.memory[start + 1..=start + length].iter().map(|&cell| cell as u8));
            }
            Text::Concat(texts) => {
                for text in texts {
                    self.text(pous, text, out)?;
                }
            }
            Text::Middle(parts, at) => {
                let (text, length, start) = &**parts;
                let whole = self.whole(pous, text)?;
                let length = self.evaluate(pous, length)?;
                let start = self.evaluate(pous, start)?;
                slice(&whole, start.saturating_sub(1), length, *at, out)?;
            }
            Text::Left(parts, at) => {
                let (whole, length) = self.text_and_length(pous, parts)?;
                slice(&whole, 0, length, *at, out)?;
            }
            Text::Right(parts, at) => {
                let (whole, length) = self.text_and_length(pous, parts)?;
                slice(&whole, (whole.len() as i64).saturating_sub(length), length, *at, out)?;
            }
        }
        Ok(())
    }

    fn whole(&mut self, pous: &[Pou], text: &Text) -> Result<Vec<u8>, Fault> {
        let mut out = Vec::new();
        self.text(pous, text, &mut out)?;
        Ok(out)
    }

    fn text_and_length(&mut self, pous: &[Pou], parts: &(Text, Expr)) -> Result<(Vec<u8>, i64), Fault> {
        Ok((self.whole(pous, &parts.0)?, self.evaluate(pous, &parts.1)?))
    }

    /// Writes a string to a variable, which may cut it.
    pub(super) fn set_text(
        &mut self,
        pous: &[Pou],
        address: usize,
        capacity: u32,
        text: &Text,
    ) -> Result<(), Fault> {
        let mut bytes = self.whole(pous, text)?;
        bytes.truncate(capacity as usize);
        let cells = &mut self.memory[address..address + capacity as usize + 2];
        cells.fill(0);
        cells[0] = bytes.len() as i64;
        for (cell, byte) in cells[1..].iter_mut().zip(bytes) {
            *cell = i64::from(byte);
        }
        Ok(())
    }

    pub(super) fn compare_texts(
        &mut self,
        pous: &[Pou],
        operator: Operator,
        texts: &(Text, Text),
    ) -> Result<i64, Fault> {
        let order = self.whole(pous, &texts.0)?.cmp(&self.whole(pous, &texts.1)?);
        Ok(i64::from(match operator {
            Operator::Equal => order.is_eq(),
            Operator::Unequal => order.is_ne(),
            Operator::Less => order.is_lt(),
            Operator::LessOrEqual => order.is_le(),
            Operator::Greater => order.is_gt(),
            _ => order.is_ge(),
        }))
    }

    pub(super) fn number(
        &mut self,
        pous: &[Pou],
        text: &Text,
        kind: Kind,
        at: Position,
    ) -> Result<i64, Fault> {
        let bytes = self.whole(pous, text)?;
        let text = String::from_utf8_lossy(&bytes);
        let value = text.trim().parse::<i128>().ok();
        let (low, high) = kind.range();
        match value.filter(|value| (low..=high).contains(value)) {
            Some(value) => Ok(value as i64),
            None => fault(at, format!("`{text}` is no `{}`", kind.name())),
        }
    }
}

/// Characters from a position, from 0.
fn slice(whole: &[u8], start: i64, length: i64, at: Position, out: &mut Vec<u8>) -> Result<(), Fault> {
    let end = start.checked_add(length).and_then(|end| usize::try_from(end).ok());
    let range = usize::try_from(start).ok().zip(end).filter(|(start, end)| start <= end);
    match range.and_then(|(start, end)| whole.get(start..end)) {
        Some(part) => {
            out.extend_from_slice(part);
            Ok(())
        }
        None => fault(at, format!("{length} characters from {} on: there are {}", start + 1, whole.len())),
    }
}
