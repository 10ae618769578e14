//! Columns of numbers as Rust: the narrowest type, and arrays or byte strings.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Numbers that a module may hold as arrays.
///
/// `rustc` takes about 4 µs for each number of an array (0.8 s for 200,000) and 0.05 s for any byte string, so this
/// many cost less than 0.1 s.
const MAX_LITERALS: usize = 16_384;

/// The narrowest unsigned type that holds some numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Width {
    /// `u8`
    One,
    /// `u16`
    Two,
    /// `u32`
    Four,
}

impl Width {
    /// Of the numbers `0..=greatest`.
    pub(super) fn of(greatest: u32) -> Self {
        match greatest {
            0..=0xFF => Width::One,
            0x100..=0xFFFF => Width::Two,
            _ => Width::Four,
        }
    }

    fn bytes(self) -> usize {
        match self {
            Width::One => 1,
            Width::Two => 2,
            Width::Four => 4,
        }
    }

    /// The type.
    pub(super) fn ty(self) -> TokenStream {
        match self {
            Width::One => quote!(u8),
            Width::Two => quote!(u16),
            Width::Four => quote!(u32),
        }
    }
}

/// How the columns of one module are written; all the same way, so that rows stay types of one kind.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Layout {
    /// `[u8; 3]`
    Arrays,
    /// `Packed<u8, 3>`
    Packed,
}

impl Layout {
    /// For a module of so many numbers.
    pub(super) fn of(numbers: usize) -> Self {
        if numbers <= MAX_LITERALS { Layout::Arrays } else { Layout::Packed }
    }

    /// The type of a column.
    pub(super) fn ty(self, width: Width, length: usize) -> TokenStream {
        let ty = width.ty();
        match self {
            Layout::Arrays => {
                let length = number(length as u32);
                quote!([#ty; #length])
            }
            Layout::Packed => {
                let length = number((length * width.bytes()) as u32);
                quote!(::controller_template::Packed<#ty, #length>)
            }
        }
    }

    /// The value of a column.
    pub(super) fn value(self, width: Width, numbers: &[u32]) -> TokenStream {
        match self {
            Layout::Arrays => {
                let numbers = numbers.iter().map(|&n| number(n));
                quote!([#(#numbers),*])
            }
            Layout::Packed => {
                let bytes = byte_string(width, numbers);
                quote!(::controller_template::Packed::new(*#bytes))
            }
        }
    }
}

/// A column of a module: its numbers, and the type of one.
pub(super) struct Column {
    width: Width,
    numbers: Vec<u32>,
}

impl Column {
    /// Of numbers that `width` holds.
    pub(super) fn new(width: Width, numbers: Vec<u32>) -> Column {
        Column { width, numbers }
    }

    /// Of the narrowest type that holds all numbers.
    pub(super) fn narrow(numbers: Vec<u32>) -> Column {
        Column::new(Width::of(numbers.iter().copied().max().unwrap_or(0)), numbers)
    }

    pub(super) fn numbers(&self) -> &[u32] {
        &self.numbers
    }

    /// Bytes of flash.
    pub(super) fn bytes(&self) -> usize {
        self.width.bytes() * self.numbers.len()
    }

    pub(super) fn ty(&self, layout: Layout) -> TokenStream {
        layout.ty(self.width, self.numbers.len())
    }

    pub(super) fn value(&self, layout: Layout) -> TokenStream {
        layout.value(self.width, &self.numbers)
    }
}

/// A number, digits in groups of three from six digits on.
pub(super) fn number(number: u32) -> Literal {
    let digits = number.to_string();
    if digits.len() < 6 {
        return Literal::u32_unsuffixed(number);
    }
    let mut grouped = String::with_capacity(digits.len() + 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            grouped.push('_');
        }
        grouped.push(digit);
    }
    literal(&grouped)
}

/// Little-endian, every byte as `\xNN`, so that lines can be broken anywhere between bytes.
pub(super) fn byte_string(width: Width, numbers: &[u32]) -> Literal {
    const HEX: &[u8; 16] = b"0123456789abcdef";
    let mut text = String::with_capacity(4 * width.bytes() * numbers.len() + 3);
    text.push_str("b\"");
    for number in numbers {
        for &byte in &number.to_le_bytes()[..width.bytes()] {
            text.push_str("\\x");
            text.push(char::from(HEX[usize::from(byte >> 4)]));
            text.push(char::from(HEX[usize::from(byte & 15)]));
        }
    }
    text.push('"');
    literal(&text)
}

fn literal(text: &str) -> Literal {
    text.parse().expect("digits and hexadecimal escapes are a literal")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths() {
        for (greatest, width) in [
            (0, Width::One),
            (255, Width::One),
            (256, Width::Two),
            (65_535, Width::Two),
            (65_536, Width::Four),
        ] {
            assert_eq!(Width::of(greatest), width, "{greatest}");
        }
    }

    #[track_caller]
    fn check(layout: Layout, width: Width, numbers: &[u32], ty: &str, value: &str) {
        assert_eq!(layout.ty(width, numbers.len()).to_string().replace(' ', ""), ty);
        assert_eq!(layout.value(width, numbers).to_string().replace(' ', ""), value);
    }

    #[test]
    fn arrays() {
        check(Layout::Arrays, Width::One, &[], "[u8;0]", "[]");
        check(Layout::Arrays, Width::Four, &[7, 99_999, 100_000], "[u32;3]", "[7,99999,100_000]");
        assert_eq!(number(u32::MAX).to_string(), "4_294_967_295");
    }

    #[test]
    fn byte_strings() {
        let new = "::controller_template::Packed::new";
        let check = |width, numbers: &[u32], ty: &str, value: &str| {
            let ty = format!("::controller_template::Packed<{ty}>");
            check(Layout::Packed, width, numbers, &ty, &format!("{new}(*b\"{value}\")"));
        };
        check(Width::One, &[255, 0], "u8,2", r"\xff\x00");
        check(Width::Two, &[258], "u16,2", r"\x02\x01");
        check(Width::Four, &[0x0102_0304], "u32,4", r"\x04\x03\x02\x01");
    }
}
