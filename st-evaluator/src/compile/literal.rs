//! Literals.

use tree_sitter::Node;

use super::{Body, Operand};
use crate::code::{Expr, Text};
use crate::kind::Kind;
use crate::tree::part;

impl<'t> Body<'_, 't> {
    /// A literal of any sort.
    pub(super) fn literal(&mut self, node: Node<'t>) -> Option<Operand> {
        match node.kind() {
            "integer_literal" => self.integer(node).map(Operand::Integer),
            "boolean_literal" => {
                let value = self.unit.source.name(node) == "TRUE";
                Some(self.of_kind(Kind::Bool, i64::from(value)))
            }
            "time_literal" => {
                let text = self.unit.source.text(node);
                match nanoseconds(text).filter(|_| !text.starts_with(['L', 'l'])) {
                    Some(value) => Some(self.of_kind(Kind::Time, value)),
                    None => {
                        self.error(node, "the duration cannot be read");
                        None
                    }
                }
            }
            "string_literal" => self.literal_text(node).map(|text| Operand::Text(Text::Literal(text))),
            "typed_literal" => self.typed(node),
            other => {
                self.error(node, format!("`{other}` is not supported"));
                None
            }
        }
    }

    fn of_kind(&mut self, kind: Kind, value: i64) -> Operand {
        Operand::Scalar { ty: self.elementary(kind), expr: Expr::Value(value), value: Some(value) }
    }

    fn integer(&mut self, node: Node<'t>) -> Option<i128> {
        let value = integer(self.unit.source.text(node));
        if value.is_none() {
            self.error(node, "the number cannot be read");
        }
        value
    }

    /// `INT#5`.
    fn typed(&mut self, node: Node<'t>) -> Option<Operand> {
        let (ty_node, value_node) = (part(node, "type")?, part(node, "value")?);
        let name = self.unit.source.name(ty_node);
        let Some(kind) = Kind::named(&name) else {
            self.error(ty_node, format!("`{name}` is not supported"));
            return None;
        };
        let ty = self.elementary(kind);
        let operand = self.literal(value_node)?;
        let operand = match operand {
            // `BOOL#1`.
            Operand::Integer(value @ 0..=1) if kind == Kind::Bool => {
                Operand::Scalar { ty, expr: Expr::Value(value as i64), value: Some(value as i64) }
            }
            operand => operand,
        };
        let (expr, value) = self.coerce(value_node, operand, ty)?;
        Some(Operand::Scalar { ty, expr, value })
    }

    /// The characters of a string literal; none if it is something else.
    pub(crate) fn literal_text(&mut self, node: Node<'t>) -> Option<Vec<u8>> {
        if node.kind() != "string_literal" {
            return None;
        }
        let text = self.unit.source.text(node);
        if text.starts_with('"') {
            self.error(node, "`WSTRING` is not supported");
            return None;
        }
        if !text.is_ascii() {
            self.error(node, "a string of other than ASCII characters");
            return None;
        }
        Some(characters(&text[1..text.len() - 1]))
    }
}

/// `16#FF`, `-1_000`.
pub(crate) fn integer(text: &str) -> Option<i128> {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    let (negative, digits) = match digits.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, digits.strip_prefix('+').unwrap_or(&digits)),
    };
    let value = match digits.split_once('#') {
        Some((base, digits)) => i128::from_str_radix(digits, base.parse().ok()?).ok()?,
        None => digits.parse().ok()?,
    };
    Some(if negative { -value } else { value })
}

/// `T#1h30m`, `TIME#-1.5s`.
pub(crate) fn nanoseconds(text: &str) -> Option<i64> {
    let (_, duration) = text.split_once('#')?;
    let (sign, mut rest) = match duration.strip_prefix('-') {
        Some(rest) => (-1, rest),
        None => (1, duration.strip_prefix('+').unwrap_or(duration)),
    };
    let mut total: i128 = 0;
    while !rest.is_empty() {
        let number_end = rest.find(|c: char| c.is_ascii_alphabetic())?;
        let (number, tail) = rest.split_at(number_end);
        let unit_end = tail.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(tail.len());
        let (unit, next) = tail.split_at(unit_end);
        let scale: i128 = match unit.to_ascii_lowercase().as_str() {
            "d" => 86_400_000_000_000,
            "h" => 3_600_000_000_000,
            "m" => 60_000_000_000,
            "s" => 1_000_000_000,
            "ms" => 1_000_000,
            "us" => 1_000,
            "ns" => 1,
            _ => return None,
        };
        let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
        total += whole.parse::<i128>().ok()? * scale;
        if !fraction.is_empty() {
            let places = u32::try_from(fraction.len()).ok().filter(|places| *places <= 18)?;
            total += fraction.parse::<i128>().ok()? * scale / 10_i128.pow(places);
        }
        rest = next;
    }
    i64::try_from(sign * total).ok()
}

/// Resolves `$$`, `$'`, `$L`, `$0A` and the like.
fn characters(text: &str) -> Vec<u8> {
    let mut out = Vec::with_capacity(text.len());
    let mut bytes = text.bytes().peekable();
    while let Some(byte) = bytes.next() {
        if byte != b'$' {
            out.push(byte);
            continue;
        }
        let Some(next) = bytes.next() else { break };
        match next.to_ascii_uppercase() {
            b'L' | b'N' => out.push(b'\n'),
            b'P' => out.push(12),
            b'R' => out.push(b'\r'),
            b'T' => out.push(b'\t'),
            digit if digit.is_ascii_hexdigit() => {
                let low = bytes.next().unwrap_or(b'0');
                let value = |c: u8| char::from(c).to_digit(16).unwrap_or(0) as u8;
                out.push(value(digit) * 16 + value(low));
            }
            _ => out.push(next),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers() {
        assert_eq!(integer("1_000"), Some(1000));
        assert_eq!(integer("16#fF_0"), Some(0xFF0));
        assert_eq!(integer("2#101"), Some(5));
        assert_eq!(integer("-3"), Some(-3));
        assert_eq!(integer("8#9"), None);
    }

    #[test]
    fn durations() {
        assert_eq!(nanoseconds("T#10ms"), Some(10_000_000));
        assert_eq!(nanoseconds("TIME#1h30m"), Some(5_400_000_000_000));
        assert_eq!(nanoseconds("t#-1.5s"), Some(-1_500_000_000));
    }

    #[test]
    fn escapes() {
        assert_eq!(characters("a$$b$'$0A$l"), b"a$b'\n\n");
    }
}
