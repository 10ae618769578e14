//! Reading and writing by `serde`: sets of events by their words, events and commands by their texts.

use core::fmt;
use core::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use serde::ser::{Serialize, SerializeTuple, Serializer};

use crate::Bits;

/// The words, as many as the type says.
impl<const W: usize> Serialize for Bits<W> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(W)?;
        for word in self.words() {
            tuple.serialize_element(&word)?;
        }
        tuple.end()
    }
}

impl<'de, const W: usize> Deserialize<'de> for Bits<W> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_tuple(W, Words)
    }
}

struct Words<const W: usize>;

impl<'de, const W: usize> Visitor<'de> for Words<W> {
    type Value = Bits<W>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{W} numbers of 32 bits")
    }

    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut numbers: A) -> Result<Bits<W>, A::Error> {
        let mut words = [0; W];
        for (index, word) in words.iter_mut().enumerate() {
            *word = numbers.next_element()?.ok_or_else(|| Error::invalid_length(index, &self))?;
        }
        Ok(Bits::new(words))
    }
}

/// Reads a text and finds what it is the text of; used by generated modules.
///
/// # Errors
///
/// Those of the format, and a text of nothing.
#[doc(hidden)]
pub fn from_text<'de, D: Deserializer<'de>, T>(
    deserializer: D,
    find: impl Fn(&str) -> Option<T>,
) -> Result<T, D::Error> {
    deserializer.deserialize_str(Text(find, PhantomData))
}

struct Text<F, T>(F, PhantomData<T>);

impl<T, F: Fn(&str) -> Option<T>> Visitor<'_> for Text<F, T> {
    type Value = T;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a text of the specification, `sender -> receiver.operation(arguments)`")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        (self.0)(text).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
    }
}
