//! Elementary types that one cell holds.

/// An elementary type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Bool,
    Sint,
    Int,
    Dint,
    Lint,
    Usint,
    Uint,
    Udint,
    Ulint,
    Byte,
    Word,
    Dword,
    Lword,
    /// In nanoseconds.
    Time,
    /// An element of a string in SCL.
    Char,
}

const NAMES: [(&str, Kind); 15] = [
    ("BOOL", Kind::Bool),
    ("SINT", Kind::Sint),
    ("INT", Kind::Int),
    ("DINT", Kind::Dint),
    ("LINT", Kind::Lint),
    ("USINT", Kind::Usint),
    ("UINT", Kind::Uint),
    ("UDINT", Kind::Udint),
    ("ULINT", Kind::Ulint),
    ("BYTE", Kind::Byte),
    ("WORD", Kind::Word),
    ("DWORD", Kind::Dword),
    ("LWORD", Kind::Lword),
    ("TIME", Kind::Time),
    ("CHAR", Kind::Char),
];

impl Kind {
    /// The type of this name, in capitals.
    pub(crate) fn named(capitals: &str) -> Option<Kind> {
        NAMES.iter().find(|(name, _)| *name == capitals).map(|(_, kind)| *kind)
    }

    pub(crate) fn name(self) -> &'static str {
        NAMES.iter().find(|(_, kind)| *kind == self).map_or("", |(name, _)| name)
    }

    pub(crate) fn bits(self) -> u32 {
        match self {
            Kind::Bool => 1,
            Kind::Sint | Kind::Usint | Kind::Byte | Kind::Char => 8,
            Kind::Int | Kind::Uint | Kind::Word => 16,
            Kind::Dint | Kind::Udint | Kind::Dword => 32,
            Kind::Lint | Kind::Ulint | Kind::Lword | Kind::Time => 64,
        }
    }

    /// What `SIZEOF` says.
    pub(crate) fn bytes(self) -> u32 {
        self.bits().div_ceil(8)
    }

    pub(crate) fn is_signed(self) -> bool {
        matches!(self, Kind::Sint | Kind::Int | Kind::Dint | Kind::Lint | Kind::Time)
    }

    /// `ANY_INT`.
    pub(crate) fn is_integer(self) -> bool {
        !self.is_bit_string() && !matches!(self, Kind::Time | Kind::Char)
    }

    /// `ANY_BIT`, which `BOOL` belongs to.
    pub(crate) fn is_bit_string(self) -> bool {
        matches!(self, Kind::Bool | Kind::Byte | Kind::Word | Kind::Dword | Kind::Lword)
    }

    /// Whether a cell of this type is a `u64` in disguise.
    pub(crate) fn is_wide_unsigned(self) -> bool {
        matches!(self, Kind::Ulint | Kind::Lword)
    }

    /// The smallest and the largest value.
    pub(crate) fn range(self) -> (i128, i128) {
        match (self, self.is_signed(), self.bits()) {
            (_, true, bits) => (-(1 << (bits - 1)), (1 << (bits - 1)) - 1),
            (_, false, bits) => (0, (1 << bits) - 1),
        }
    }

    /// The value that a cell holds.
    pub(crate) fn value(self, cell: i64) -> i128 {
        if self.is_wide_unsigned() { i128::from(cell as u64) } else { i128::from(cell) }
    }

    /// The cell of a value, which loses the bits that there is no room for.
    pub(crate) fn wrap(self, value: i64) -> i64 {
        match self {
            Kind::Bool => value & 1,
            Kind::Sint => i64::from(value as i8),
            Kind::Int => i64::from(value as i16),
            Kind::Dint => i64::from(value as i32),
            Kind::Usint | Kind::Byte | Kind::Char => i64::from(value as u8),
            Kind::Uint | Kind::Word => i64::from(value as u16),
            Kind::Udint | Kind::Dword => i64::from(value as u32),
            Kind::Lint | Kind::Ulint | Kind::Lword | Kind::Time => value,
        }
    }

    /// Whether every value is one of `wider`, of the same sort, or with `mixed` of either sort.
    pub(crate) fn widens_to(self, wider: Kind, mixed: bool) -> bool {
        let is_bits = |kind: Kind| kind.is_bit_string() && kind != Kind::Bool;
        let is_number = |kind: Kind| kind.is_integer() || is_bits(kind);
        let (low, high) = self.range();
        let (wide_low, wide_high) = wider.range();
        let sorts = self.is_integer() && wider.is_integer()
            || is_bits(self) && is_bits(wider)
            || mixed && is_number(self) && is_number(wider);
        sorts && wide_low <= low && high <= wide_high
    }
}
