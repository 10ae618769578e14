//! From places to addresses.

use super::{Fault, Machine, fault};
use crate::code::{Element, Expr, Place, Target};
use crate::declare::Pou;

/// A pointer is an address, the number of cells that lie there, and the epoch of its call.
const ADDRESS_BITS: u32 = 31;
const SIZE_BITS: u32 = 25;

/// After so many calls an old pointer is mistaken for a new one.
pub(super) const EPOCHS: i64 = 1 << (63 - ADDRESS_BITS - SIZE_BITS);

impl Machine {
    pub(super) fn address(&mut self, pous: &[Pou], place: &Place) -> Result<usize, Fault> {
        Ok(match place {
            Place::This(at) => self.this + *at as usize,
            Place::Frame(at) => self.frame + *at as usize,
            Place::Constant(at) => *at as usize,
            Place::Global(at) => self.globals + *at as usize,
            _ => self.locate(pous, place)?.0,
        })
    }

    /// The address, and the end of what lies there if that was reached through a pointer.
    fn locate(&mut self, pous: &[Pou], place: &Place) -> Result<(usize, usize), Fault> {
        match place {
            Place::This(_) | Place::Frame(_) | Place::Constant(_) | Place::Global(_) => {
                Ok((self.address(pous, place)?, usize::MAX))
            }
            Place::ThroughThis(at) => Ok((self.memory[self.this + *at as usize] as usize, usize::MAX)),
            Place::ThroughFrame(at) => Ok((self.memory[self.frame + *at as usize] as usize, usize::MAX)),
            Place::Field(base, offset) => {
                let (address, end) = self.locate(pous, base)?;
                Ok((address + *offset as usize, end))
            }
            Place::Element(element) => self.element(pous, element),
            Place::Target(target) => self.target(pous, target),
        }
    }

    fn element(&mut self, pous: &[Pou], element: &Element) -> Result<(usize, usize), Fault> {
        let (base, end) = match &element.base {
            Place::Constant(at) => (*at as usize, usize::MAX),
            Place::This(at) => (self.this + *at as usize, usize::MAX),
            base => self.locate(pous, base)?,
        };
        let index = match &element.index {
            Expr::Value(index) => *index,
            index => {
                self.stats.indexed += 1;
                self.evaluate(pous, index)?
            }
        };
        if index < element.low || index > element.high {
            let Element { low, high, .. } = element;
            return fault(element.at, format!("index {index} is outside of [{low}..{high}]"));
        }
        let stride = element.stride as usize;
        let address = base + (index - element.low) as usize * stride;
        if address + stride > end {
            return fault(element.at, format!("index {index} is outside of what the pointer points to"));
        }
        Ok((address, end))
    }

    fn target(&mut self, pous: &[Pou], target: &Target) -> Result<(usize, usize), Fault> {
        let pointer = self.evaluate(pous, &target.pointer)?;
        if pointer == 0 {
            return fault(target.at, "the pointer points to nothing");
        }
        if pointer >> (ADDRESS_BITS + SIZE_BITS) != self.epoch {
            // Between calls an online change may have moved what it points to.
            return fault(target.at, "the pointer was taken in an earlier call");
        }
        let start = pointer as usize & ((1 << ADDRESS_BITS) - 1);
        let end = start + (pointer as usize >> ADDRESS_BITS & ((1 << SIZE_BITS) - 1));
        let address = match &target.index {
            None => start,
            Some(index) => {
                self.stats.indexed += 1;
                let index = self.evaluate(pous, index)?;
                let offset = usize::try_from(index).ok().and_then(|i| i.checked_mul(target.size as usize));
                match offset.and_then(|offset| start.checked_add(offset)) {
                    Some(address) => address,
                    None => {
                        return fault(
                            target.at,
                            format!("index {index} is outside of what the pointer points to"),
                        );
                    }
                }
            }
        };
        if address.saturating_add(target.size as usize) > end {
            return fault(target.at, "less lies behind the pointer than is used");
        }
        Ok((address, end))
    }

    /// The address of so many cells, which must be there.
    pub(super) fn span(&mut self, pous: &[Pou], place: &Place, size: u32) -> Result<usize, Fault> {
        let (address, end) = self.locate(pous, place)?;
        if address.saturating_add(size as usize) > end {
            return fault(self.at, "less lies behind the pointer than is copied");
        }
        Ok(address)
    }

    /// The pointer to a place.
    pub(super) fn pointer(&mut self, pous: &[Pou], place: &Place, size: u32) -> Result<i64, Fault> {
        let address = self.span(pous, place, size)?;
        Ok(address as i64 | i64::from(size) << ADDRESS_BITS | self.epoch << (ADDRESS_BITS + SIZE_BITS))
    }
}
