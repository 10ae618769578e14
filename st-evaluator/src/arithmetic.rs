//! What operators do with cells, at compile time and at run time.

use crate::code::Operator;
use crate::kind::Kind;

/// The cell that an operator gives, and whether bits were lost.
///
/// # Errors
///
/// A division by zero.
pub(crate) fn binary(operator: Operator, kind: Kind, a: i64, b: i64) -> Result<(i64, bool), &'static str> {
    let truth = |value: bool| Ok((i64::from(value), false));
    match operator {
        Operator::And => Ok((a & b, false)),
        Operator::Or => Ok((a | b, false)),
        Operator::Xor => Ok((a ^ b, false)),
        Operator::Equal => truth(a == b),
        Operator::Unequal => truth(a != b),
        Operator::Less => truth(kind.value(a) < kind.value(b)),
        Operator::LessOrEqual => truth(kind.value(a) <= kind.value(b)),
        Operator::Greater => truth(kind.value(a) > kind.value(b)),
        Operator::GreaterOrEqual => truth(kind.value(a) >= kind.value(b)),
        Operator::Divide | Operator::Modulo if b == 0 => Err("division by zero"),
        Operator::Add | Operator::Subtract | Operator::Multiply | Operator::Divide | Operator::Modulo => {
            Ok(if kind.bits() <= 32 { narrow(operator, kind, a, b) } else { wide(operator, kind, a, b) })
        }
        Operator::ShiftLeft | Operator::ShiftRight | Operator::RotateLeft | Operator::RotateRight => {
            Ok((shift(operator, kind, a, b), false))
        }
    }
}

fn narrow(operator: Operator, kind: Kind, a: i64, b: i64) -> (i64, bool) {
    let exact = match operator {
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::Multiply => a * b,
        Operator::Divide => a / b,
        _ => a % b,
    };
    let wrapped = kind.wrap(exact);
    (wrapped, wrapped != exact)
}

fn wide(operator: Operator, kind: Kind, a: i64, b: i64) -> (i64, bool) {
    let (a, b) = (kind.value(a), kind.value(b));
    // The product of two u64 may not fit; its low bits are right nevertheless.
    let exact = match operator {
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::Multiply => match a.checked_mul(b) {
            Some(product) => product,
            None => return (a.wrapping_mul(b) as i64, true),
        },
        Operator::Divide => a / b,
        _ => a % b,
    };
    (exact as i64, kind.value(exact as i64) != exact)
}

/// Shifts fill with zeros and rotations keep the bits, within the width of the type.
fn shift(operator: Operator, kind: Kind, a: i64, b: i64) -> i64 {
    let bits = kind.bits();
    let pattern = if bits == 64 { a as u64 } else { a as u64 & ((1 << bits) - 1) };
    let places = u32::try_from(b).unwrap_or(u32::MAX);
    let (left, right) = match operator {
        Operator::ShiftLeft => (pattern.checked_shl(places).unwrap_or(0), 0),
        Operator::ShiftRight => (0, pattern.checked_shr(places).unwrap_or(0)),
        Operator::RotateLeft => turned(pattern, places % bits, bits),
        _ => turned(pattern, (bits - places % bits) % bits, bits),
    };
    kind.wrap((left | right) as i64)
}

fn turned(pattern: u64, places: u32, bits: u32) -> (u64, u64) {
    (pattern << places, pattern.checked_shr(bits - places).unwrap_or(0))
}

/// The cell of `to` for a cell of `from`, and whether the value is another one.
pub(crate) fn convert(from: Kind, to: Kind, cell: i64) -> (i64, bool) {
    const MILLISECOND: i64 = 1_000_000;
    match (from, to) {
        (_, Kind::Bool) => (i64::from(cell != 0), false),
        // Durations are numbers of milliseconds.
        (Kind::Time, Kind::Time) => (cell, false),
        (Kind::Time, _) => convert(Kind::Lint, to, cell / MILLISECOND),
        (_, Kind::Time) => (cell.wrapping_mul(MILLISECOND), false),
        _ => {
            let converted = to.wrap(cell);
            (converted, to.value(converted) != from.value(cell))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(operator: Operator, kind: Kind, a: i64, b: i64, expected: (i64, bool)) {
        assert_eq!(binary(operator, kind, a, b), Ok(expected));
    }

    #[test]
    fn wraps_around() {
        check(Operator::Add, Kind::Usint, 200, 100, (44, true));
        check(Operator::Add, Kind::Int, 32_767, 1, (-32_768, true));
        check(Operator::Subtract, Kind::Udint, 0, 1, (0xFFFF_FFFF, true));
        check(Operator::Multiply, Kind::Dint, 65_536, 65_536, (0, true));
        check(Operator::Divide, Kind::Sint, -128, -1, (-128, true));
        check(Operator::Add, Kind::Ulint, -1, 1, (0, true));
        check(Operator::Add, Kind::Ulint, i64::MAX, 1, (i64::MIN, false));
        check(Operator::Add, Kind::Lint, i64::MAX, 1, (i64::MIN, true));
        check(Operator::Multiply, Kind::Ulint, -1, -1, (1, true));
        check(Operator::Add, Kind::Uint, 65_534, 1, (65_535, false));
    }

    #[test]
    fn division_truncates() {
        check(Operator::Divide, Kind::Int, -7, 2, (-3, false));
        check(Operator::Modulo, Kind::Int, -7, 2, (-1, false));
        check(Operator::Divide, Kind::Ulint, -1, 2, (i64::MAX, false));
        assert!(binary(Operator::Modulo, Kind::Int, 1, 0).is_err());
    }

    #[test]
    fn unsigned_cells_compare_as_such() {
        check(Operator::Less, Kind::Ulint, 1, -1, (1, false));
        check(Operator::Less, Kind::Lint, 1, -1, (0, false));
    }

    #[test]
    fn bits_move() {
        check(Operator::ShiftLeft, Kind::Byte, 0x81, 1, (0x02, false));
        check(Operator::ShiftRight, Kind::Dword, 0x8000_0000, 31, (1, false));
        check(Operator::ShiftRight, Kind::Dword, 0x8000_0000, 32, (0, false));
        check(Operator::ShiftRight, Kind::Lword, -1, 63, (1, false));
        check(Operator::ShiftLeft, Kind::Lword, 1, 64, (0, false));
        check(Operator::RotateLeft, Kind::Byte, 0x81, 1, (0x03, false));
        check(Operator::RotateRight, Kind::Word, 1, 1, (0x8000, false));
        check(Operator::RotateRight, Kind::Lword, 1, 64, (1, false));
        check(Operator::RotateLeft, Kind::Lword, i64::MIN, 1, (1, false));
    }

    #[test]
    fn conversions() {
        assert_eq!(convert(Kind::Uint, Kind::Usint, 300), (44, true));
        assert_eq!(convert(Kind::Int, Kind::Uint, -1), (65_535, true));
        assert_eq!(convert(Kind::Usint, Kind::Udint, 255), (255, false));
        assert_eq!(convert(Kind::Int, Kind::Bool, -4), (1, false));
        assert_eq!(convert(Kind::Time, Kind::Dint, 1_500_000_000), (1500, false));
        assert_eq!(convert(Kind::Ulint, Kind::Lint, -1), (-1, true));
    }
}
