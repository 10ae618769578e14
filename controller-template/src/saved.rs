//! A controller's state on its way through a power cycle or an update.

use core::fmt;

use crate::{Bits, Machine, Number, Tables};

/// What a controller is to go on from: its state, its pending events, and which tables they are of.
///
/// Plain numbers, for memory that survives a reset, or as [`to_bytes`](Self::to_bytes) for any other. `W` is that of the
/// [`Machine`], `B` the number of bytes, `4 * (W + 3)`; a generated module has a name for the type.
///
/// ```
/// use controller_template::{RestoreError, Saved};
///
/// let bytes = [0x5A; 16];
/// assert_eq!(Saved::<1, 16>::from_bytes(&bytes), Err(RestoreError::Damaged));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Saved<const W: usize, const B: usize> {
    table_version: u32,
    state: u32,
    pending: Bits<W>,
}

/// Why a controller does not go on from what was saved.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RestoreError {
    /// The bytes are not those that were saved, or nothing ever was.
    Damaged,
    /// Other tables saved it: what a state means there, nobody knows here.
    OtherTables,
    /// There is no state of that number.
    NoSuchState,
    /// Something is pending that is no event.
    NoSuchEvent,
}

impl fmt::Display for RestoreError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            RestoreError::Damaged => "the saved bytes are damaged",
            RestoreError::OtherTables => "a controller with other tables saved it",
            RestoreError::NoSuchState => "the saved state does not exist",
            RestoreError::NoSuchEvent => "a saved event does not exist",
        })
    }
}

impl core::error::Error for RestoreError {}

impl<const W: usize, const B: usize> Saved<W, B> {
    /// Bytes that [`to_bytes`](Self::to_bytes) gives.
    pub const BYTES: usize = {
        assert!(B == 4 * (W + 3), "version, state, events and check have four bytes each");
        B
    };

    /// The version of the tables that it is of.
    #[must_use]
    pub const fn table_version(&self) -> u32 {
        self.table_version
    }

    /// The state's number.
    #[must_use]
    pub const fn state(&self) -> u32 {
        self.state
    }

    /// The pending events, by their positions in table order.
    #[must_use]
    pub const fn pending(&self) -> Bits<W> {
        self.pending
    }

    /// Table version, state and pending events, little-endian, and a check of them (CRC-32).
    #[must_use]
    pub fn to_bytes(&self) -> [u8; B] {
        let mut bytes = [0; B];
        if let Some((body, check)) = bytes.get_mut(..Self::BYTES).and_then(<[u8]>::split_last_chunk_mut) {
            let numbers = [self.table_version, self.state].into_iter().chain(self.pending.words());
            for (byte, value) in body.iter_mut().zip(numbers.flat_map(u32::to_le_bytes)) {
                *byte = value;
            }
            *check = crc32(body).to_le_bytes();
        }
        bytes
    }

    /// What [`to_bytes`](Self::to_bytes) made bytes of.
    ///
    /// # Errors
    ///
    /// [`RestoreError::Damaged`] if there are more or fewer bytes, or their check is another.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, RestoreError> {
        let (body, check) = bytes.split_last_chunk().ok_or(RestoreError::Damaged)?;
        if bytes.len() != Self::BYTES || crc32(body).to_le_bytes() != *check {
            return Err(RestoreError::Damaged);
        }
        let number = |index| u32::read(body, index).ok_or(RestoreError::Damaged);
        let mut words = [0; W];
        for (index, word) in words.iter_mut().enumerate() {
            *word = number(index + 2)?;
        }
        Ok(Saved { table_version: number(0)?, state: number(1)?, pending: Bits::new(words) })
    }
}

impl<T: Tables, const W: usize> Machine<T, W> {
    /// What [`restore`](Self::restore) goes on from.
    #[must_use]
    pub fn save<const B: usize>(&self) -> Saved<W, B> {
        Saved { table_version: T::VERSION, state: self.state(), pending: self.pending() }
    }

    /// As it was when it was saved.
    ///
    /// # Errors
    ///
    /// If other tables saved it, or no controller did.
    pub fn restore<const B: usize>(saved: &Saved<W, B>) -> Result<Self, RestoreError> {
        if saved.table_version != T::VERSION {
            return Err(RestoreError::OtherTables);
        }
        let state = T::State::from_u32(saved.state).filter(|_| saved.state < T::STATES);
        if saved.pending.ones().any(|event| T::event(event).is_none()) {
            return Err(RestoreError::NoSuchEvent);
        }
        state.map(|state| Machine::at(state, saved.pending)).ok_or(RestoreError::NoSuchState)
    }
}

/// CRC-32 as in Ethernet (ISO 3309), bit by bit: a table would take more flash than the time is worth.
fn crc32(bytes: &[u8]) -> u32 {
    let bit = |crc: u32, _| (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg());
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), bit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_check_value() {
        assert_eq!(crc32(b"123456789"), 0xCBF4_3926);
    }

    #[track_caller]
    fn check<const W: usize, const B: usize>(words: [u32; W]) {
        let saved = Saved::<W, B> { table_version: 0x0102_0304, state: 70_000, pending: Bits::new(words) };
        let bytes = saved.to_bytes();
        assert_eq!(bytes[..8], [4, 3, 2, 1, 0x70, 0x11, 1, 0]);
        assert_eq!(Saved::from_bytes(&bytes), Ok(saved));
        let damaged = Err(RestoreError::Damaged);
        for bit in 0..8 * B {
            let mut other = bytes;
            other[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(Saved::<W, B>::from_bytes(&other), damaged, "bit {bit}");
        }
        // Memory that was never written, and flash that was erased.
        assert_eq!(Saved::<W, B>::from_bytes(&[0; B]), damaged);
        assert_eq!(Saved::<W, B>::from_bytes(&[0xFF; B]), damaged);
        assert_eq!(Saved::<W, B>::from_bytes(&bytes[..B - 1]), damaged);
        assert_eq!(Saved::<W, B>::from_bytes(&[]), damaged);
        let longer = Saved::<3, 24> { table_version: 1, state: 2, pending: Bits::new([3; 3]) };
        assert_eq!(Saved::<W, B>::from_bytes(&longer.to_bytes()), damaged);
    }

    #[test]
    fn bytes_are_what_was_saved_or_refused() {
        check::<0, 12>([]);
        check::<1, 16>([5]);
        check::<2, 20>([5, u32::MAX]);
    }
}
