//! An entry as bytes: what it is, a hash of the rest, then the key and the texts, each behind its length. Numbers are
//! 64 bits, little end first.

use super::{Key, hash};

const MAGIC: &[u8] = b"sml cache entry 1\n";

pub(super) fn encode(key: &Key, texts: &[String]) -> Vec<u8> {
    let mut rest = Vec::new();
    for part in [key.bytes()].into_iter().chain(texts.iter().map(String::as_bytes)) {
        rest.extend((part.len() as u64).to_le_bytes());
        rest.extend(part);
    }
    [MAGIC, &hash(&rest).to_le_bytes(), &rest].concat()
}

/// The texts; `None` if the entry is not whole, or another key's.
pub(super) fn decode(bytes: &[u8], key: &Key) -> Option<Vec<String>> {
    let (sum, mut rest) = number(bytes.strip_prefix(MAGIC)?)?;
    if sum != hash(rest) || part(&mut rest)? != key.bytes() {
        return None;
    }
    let mut texts = Vec::new();
    while !rest.is_empty() {
        texts.push(String::from_utf8(part(&mut rest)?.to_vec()).ok()?);
    }
    Some(texts)
}

fn number(bytes: &[u8]) -> Option<(u64, &[u8])> {
    let (number, rest) = bytes.split_first_chunk()?;
    Some((u64::from_le_bytes(*number), rest))
}

fn part<'b>(bytes: &mut &'b [u8]) -> Option<&'b [u8]> {
    let (length, rest) = number(bytes)?;
    let (part, rest) = rest.split_at_checked(usize::try_from(length).ok()?)?;
    *bytes = rest;
    Some(part)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(text: &str) -> Key {
        Key::new("test", &"").text(text)
    }

    fn texts() -> Vec<String> {
        ["pub mod cell {}", "", "a warning"].map(str::to_owned).into()
    }

    #[test]
    fn what_was_put_comes_back() {
        for texts in [texts(), Vec::new(), vec![String::new()]] {
            assert_eq!(decode(&encode(&key("a"), &texts), &key("a")), Some(texts));
        }
    }

    #[test]
    fn another_key_with_the_same_name_is_no_hit() {
        assert_eq!(decode(&encode(&key("a"), &texts()), &key("b")), None);
    }

    #[test]
    fn what_is_damaged_anywhere_is_no_hit() {
        let entry = encode(&key("a"), &texts());
        for place in 0..entry.len() {
            assert_eq!(decode(&entry[..place], &key("a")), None, "cut at {place}");
            for bit in [1, 0x80] {
                let mut damaged = entry.clone();
                damaged[place] ^= bit;
                assert_eq!(decode(&damaged, &key("a")), None, "bit {bit} at {place}");
            }
        }
        let longer = [entry.as_slice(), &[0]].concat();
        assert_eq!(decode(&longer, &key("a")), None);
    }

    /// Somebody could have written the right hash of nonsense.
    #[test]
    fn lengths_are_not_believed() {
        let with_hash = |rest: &[u8]| [MAGIC, &hash(rest).to_le_bytes(), rest].concat();
        let right = encode(&key("a"), &[])[MAGIC.len() + 8..].to_vec();
        assert_eq!(decode(&with_hash(&right), &key("a")), Some(Vec::new()));
        let behind: [&[u8]; 4] =
            [&[0; 7], &u64::MAX.to_le_bytes(), &1_u64.to_le_bytes(), &[1, 0, 0, 0, 0, 0, 0, 0, 0xFF]];
        for behind in behind {
            assert_eq!(decode(&with_hash(&[&right, behind].concat()), &key("a")), None, "{behind:?}");
        }
    }
}
