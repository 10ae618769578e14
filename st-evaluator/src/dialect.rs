//! What the systems accept beyond the standard's second edition, and what they refuse of it.

/// Whose Structured Text it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dialect {
    /// IEC 61131-3, second edition (2003), without any extension.
    Edition2,
    /// CODESYS 3.
    Codesys,
    /// TwinCAT 3.
    TwinCat,
    /// Siemens SCL (TIA Portal).
    Siemens,
}

impl Dialect {
    /// Nothing but the standard.
    pub(crate) fn is_strict(self) -> bool {
        self == Dialect::Edition2
    }

    /// CODESYS and what descends from it.
    pub(crate) fn is_codesys(self) -> bool {
        matches!(self, Dialect::Codesys | Dialect::TwinCat)
    }

    /// `END_IF` and its like may stand without a semicolon.
    pub(crate) fn leaves_out_semicolons(self) -> bool {
        self.is_codesys()
    }

    /// `POINTER TO`, `ADR`, `^`, `SIZEOF`, `AND_THEN`, `OR_ELSE`.
    pub(crate) fn has_pointers(self) -> bool {
        self.is_codesys()
    }

    /// `AND`, `OR`, `XOR`, `NOT` and shifts on integers, arithmetic on bit strings, and one for the other where it
    /// fits.
    pub(crate) fn mixes_integers_and_bit_strings(self) -> bool {
        self.is_codesys()
    }

    /// Significant characters of an identifier. The standard leaves the number to the implementer; 63 is what C
    /// promises to tell apart, which compilers to C inherit.
    pub(crate) fn identifier_limit(self) -> usize {
        match self {
            Dialect::Edition2 => 63,
            Dialect::Codesys | Dialect::TwinCat => 255,
            Dialect::Siemens => 128,
        }
    }
}
