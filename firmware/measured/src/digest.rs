//! A digest that is the same whatever the width of a pointer.

use core::hash::{Hash, Hasher};

/// FNV-1a of 32 bits over 32-bit words.
pub(crate) struct Digest(u32);

impl Digest {
    pub(crate) fn new() -> Self {
        Digest(0x811c_9dc5)
    }

    pub(crate) fn add(&mut self, value: &impl Hash) {
        value.hash(self);
    }

    pub(crate) fn value(&self) -> u32 {
        self.0
    }
}

impl Hasher for Digest {
    fn finish(&self) -> u64 {
        self.0.into()
    }

    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
    }

    fn write_u32(&mut self, value: u32) {
        self.write(&value.to_le_bytes());
    }

    // The discriminants of enumerations are hashed as `isize`.
    fn write_usize(&mut self, value: usize) {
        self.write_u32(value as u32);
    }

    fn write_isize(&mut self, value: isize) {
        self.write_u32(value as u32);
    }
}
