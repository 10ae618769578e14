//! Integer types of the standard.

use super::owed::Owed;
use super::{Integers, Unfit};
use crate::controller::tables::{ComponentTable, Tables};

/// An elementary integer type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Integer {
    Usint,
    Uint,
    Udint,
    Int,
    Dint,
}

impl Integer {
    /// The narrowest type of the family that holds `0..=max`; `None` if none does.
    pub(super) fn holding(max: u64, family: Integers) -> Option<Integer> {
        let candidates: &[Integer] = match family {
            Integers::Unsigned => &[Integer::Usint, Integer::Uint, Integer::Udint],
            Integers::Signed => &[Integer::Int, Integer::Dint],
        };
        candidates.iter().copied().find(|integer| max <= integer.max())
    }

    /// The type's keyword.
    pub(super) fn keyword(self) -> &'static str {
        match self {
            Integer::Usint => "USINT",
            Integer::Uint => "UINT",
            Integer::Udint => "UDINT",
            Integer::Int => "INT",
            Integer::Dint => "DINT",
        }
    }

    fn max(self) -> u64 {
        match self {
            Integer::Usint => u64::from(u8::MAX),
            Integer::Uint => u64::from(u16::MAX),
            Integer::Udint => u64::from(u32::MAX),
            Integer::Int => i16::MAX as u64,
            Integer::Dint => i32::MAX as u64,
        }
    }

    /// An expression of this type converted to `target`; the standard has no implicit conversions.
    pub(super) fn converted(self, target: Integer, expression: &str) -> String {
        if self == target {
            expression.to_owned()
        } else {
            format!("{}_TO_{}({expression})", self.keyword(), target.keyword())
        }
    }
}

/// The types that a controller's text uses.
#[derive(Debug)]
pub(super) struct Types {
    /// States in the tables and in the variable `state`.
    pub(super) state: Integer,
    /// `state_no`.
    pub(super) state_no: Integer,
    /// Indices of tables and events, and what is computed with them.
    pub(super) index: Integer,
    /// Per component: the codes in its array.
    pub(super) codes: Vec<Integer>,
    /// The arrays of what the environment owes, where they are wanted.
    pub(super) owed: Integer,
}

impl Types {
    /// Types for a layout whose indices go up to `largest_index`.
    ///
    /// # Errors
    ///
    /// A number that no type of the family holds.
    pub(super) fn of(
        tables: &Tables,
        family: Integers,
        largest_index: u64,
        owed: Option<&Owed>,
    ) -> Result<Types, Unfit> {
        let too_large = || Unfit::TooLarge { states: tables.states };
        let codes = |component: &ComponentTable| {
            let commands = component.commands.len();
            code_type(commands, family)
                .ok_or_else(|| Unfit::TooManyCommands { object: component.object.clone(), commands })
        };
        Ok(Types {
            state: Integer::holding(u64::from(tables.states), family).ok_or_else(too_large)?,
            state_no: match family {
                Integers::Unsigned => Integer::Udint,
                Integers::Signed => Integer::Dint,
            },
            index: Integer::holding(largest_index.max(tables.events.len() as u64), family)
                .ok_or_else(too_large)?,
            owed: Integer::holding(owed.map_or(0, Owed::largest), family).ok_or_else(too_large)?,
            codes: tables.components.iter().map(codes).collect::<Result<_, _>>()?,
        })
    }
}

/// The type of an array of command codes; the outputs are `INT`, so nothing wider is of use.
fn code_type(commands: usize, family: Integers) -> Option<Integer> {
    let narrowest = Integer::holding(commands as u64, family)?;
    match narrowest {
        Integer::Usint | Integer::Int => Some(narrowest),
        _ => (commands as u64 <= Integer::Int.max()).then_some(Integer::Int),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(max: u64, unsigned: Option<Integer>, signed: Option<Integer>) {
        assert_eq!(Integer::holding(max, Integers::Unsigned), unsigned);
        assert_eq!(Integer::holding(max, Integers::Signed), signed);
    }

    #[test]
    fn narrowest() {
        check(0, Some(Integer::Usint), Some(Integer::Int));
        check(255, Some(Integer::Usint), Some(Integer::Int));
        check(256, Some(Integer::Uint), Some(Integer::Int));
        check(32_767, Some(Integer::Uint), Some(Integer::Int));
        check(32_768, Some(Integer::Uint), Some(Integer::Dint));
        check(65_536, Some(Integer::Udint), Some(Integer::Dint));
        check(1 << 31, Some(Integer::Udint), None);
        check(1 << 32, None, None);
    }

    #[test]
    fn codes_fit_the_outputs() {
        assert_eq!(code_type(255, Integers::Unsigned), Some(Integer::Usint));
        assert_eq!(code_type(256, Integers::Unsigned), Some(Integer::Int));
        assert_eq!(code_type(3, Integers::Signed), Some(Integer::Int));
        assert_eq!(code_type(32_768, Integers::Unsigned), None);
        assert_eq!(code_type(32_768, Integers::Signed), None);
    }

    #[test]
    fn conversions_are_explicit() {
        assert_eq!(Integer::Usint.converted(Integer::Udint, "state"), "USINT_TO_UDINT(state)");
        assert_eq!(Integer::Udint.converted(Integer::Udint, "state"), "state");
    }
}
