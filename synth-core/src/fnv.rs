//! FNV-1a, the hash of everything that outputs say of their origin: the same on every machine, and not meant to resist
//! anybody.

/// A hash in the making.
#[derive(Clone, Debug)]
pub(crate) struct Fnv(u64);

impl Fnv {
    pub(crate) fn new() -> Fnv {
        Fnv(0xcbf2_9ce4_8422_2325)
    }

    /// A text, told apart from the one behind it.
    pub(crate) fn text(&mut self, text: &str) {
        text.bytes().chain([0]).for_each(|byte| self.byte(byte));
    }

    /// A list of numbers, told apart from the one behind it.
    pub(crate) fn numbers(&mut self, numbers: &[u32]) {
        let length = numbers.len() as u64;
        length.to_le_bytes().into_iter().for_each(|byte| self.byte(byte));
        numbers.iter().flat_map(|number| number.to_le_bytes()).for_each(|byte| self.byte(byte));
    }

    pub(crate) fn finish(&self) -> u64 {
        self.0
    }

    /// As 16 hexadecimal digits.
    pub(crate) fn hex(&self) -> String {
        format!("{:016x}", self.0)
    }

    fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
}

#[cfg(test)]
mod tests {
    use super::Fnv;

    #[test]
    fn published_values() {
        assert_eq!(Fnv::new().hex(), "cbf29ce484222325");
        let mut hash = Fnv::new();
        "foobar".bytes().for_each(|byte| hash.byte(byte));
        assert_eq!(hash.hex(), "85944171f73967e8");
    }

    #[test]
    fn borders_count() {
        let hash = |texts: &[&str], lists: &[&[u32]]| {
            let mut hash = Fnv::new();
            texts.iter().for_each(|text| hash.text(text));
            lists.iter().for_each(|numbers| hash.numbers(numbers));
            hash.finish()
        };
        assert_ne!(hash(&["ab", "c"], &[]), hash(&["a", "bc"], &[]));
        assert_ne!(hash(&[], &[&[1], &[2]]), hash(&[], &[&[1, 2], &[]]));
    }
}
