//! A list for each of many places, of which few are distinct: each is kept once.

use crate::intern::hash;
use hashbrown::HashTable;
use std::fmt;
use std::ops::Index;

/// A list of numbers for each place from 0, as a `Vec<Vec<u32>>` that takes four bytes a place.
///
/// Lists are equal to others of the same content, however they came to be.
#[derive(Clone, Default)]
pub struct Lists {
    /// Per place the number of its list.
    of: Vec<u32>,
    distinct: Distinct,
}

impl Lists {
    /// An empty list for each of so many places.
    #[must_use]
    pub fn empty(places: usize) -> Lists {
        let mut lists = Lists::default();
        if places > 0 {
            lists.of = vec![lists.distinct.intern(&[]); places];
        }
        lists
    }

    /// No places, but the distinct lists of these, with their numbers.
    pub(crate) fn cleared(&self) -> Lists {
        Lists { of: Vec::new(), distinct: self.distinct.clone() }
    }

    /// Number of places.
    #[must_use]
    pub fn len(&self) -> usize {
        self.of.len()
    }

    /// Whether there are no places.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.of.is_empty()
    }

    /// The lists, place by place.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.of.iter().map(|&number| self.distinct.get(number))
    }

    /// Adds a place.
    pub fn push(&mut self, list: &[u32]) {
        let number = self.distinct.intern(list);
        self.of.push(number);
    }

    /// Adds a place with a list whose number is known.
    pub(crate) fn push_number(&mut self, number: u32) {
        debug_assert!((number as usize) < self.distinct());
        self.of.push(number);
    }

    /// Adds the places of these lists.
    pub(crate) fn append(&mut self, other: &Lists) {
        let numbers: Vec<u32> =
            (0..other.distinct() as u32).map(|number| self.distinct.intern(other.list(number))).collect();
        self.of.extend(other.of.iter().map(|&number| numbers[number as usize]));
    }

    /// Replaces the list of a place.
    ///
    /// # Panics
    ///
    /// If there is no such place.
    pub fn set(&mut self, place: usize, list: &[u32]) {
        self.of[place] = self.distinct.intern(list);
    }

    /// The number of a place's list, equal for equal lists.
    pub(crate) fn number(&self, place: usize) -> u32 {
        self.of[place]
    }

    /// The numbers of all places' lists.
    pub(crate) fn numbers(&self) -> &[u32] {
        &self.of
    }

    /// All numbers are below this; not each must still be in use.
    pub(crate) fn distinct(&self) -> usize {
        self.distinct.ends.len()
    }

    /// The list with a number.
    pub(crate) fn list(&self, number: u32) -> &[u32] {
        self.distinct.get(number)
    }

    /// The same lists at other places: at each the one that was at `order` of it.
    pub(crate) fn reordered(mut self, order: &[u32]) -> Lists {
        self.of = order.iter().map(|&place| self.of[place as usize]).collect();
        self
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        let Distinct { values, ends, index } = &self.distinct;
        // The index has a byte of its own beside each number.
        (self.of.capacity() + values.capacity() + ends.capacity()) * size_of::<u32>()
            + index.capacity() * (size_of::<u32>() + 1)
    }
}

impl Index<usize> for Lists {
    type Output = [u32];

    fn index(&self, place: usize) -> &[u32] {
        self.distinct.get(self.of[place])
    }
}

impl<L: AsRef<[u32]>> FromIterator<L> for Lists {
    fn from_iter<I: IntoIterator<Item = L>>(lists: I) -> Lists {
        let mut all = Lists::default();
        lists.into_iter().for_each(|list| all.push(list.as_ref()));
        all
    }
}

impl PartialEq for Lists {
    fn eq(&self, other: &Lists) -> bool {
        self.iter().eq(other.iter())
    }
}

impl Eq for Lists {}

impl fmt::Debug for Lists {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

/// Lists, none twice, in order of discovery.
#[derive(Clone, Default)]
struct Distinct {
    /// One list behind the other.
    values: Vec<u32>,
    /// Per list where it ends.
    ends: Vec<u32>,
    index: HashTable<u32>,
}

impl Distinct {
    fn get(&self, number: u32) -> &[u32] {
        nth(&self.values, &self.ends, number)
    }

    /// The number of a list, which need not be known yet.
    fn intern(&mut self, list: &[u32]) -> u32 {
        let Distinct { values, ends, index } = self;
        let code = hash(list);
        if let Some(&found) = index.find(code, |&number| nth(values, ends, number) == list) {
            return found;
        }
        let number = ends.len() as u32;
        values.extend_from_slice(list);
        ends.push(values.len() as u32);
        index.insert_unique(code, number, |&number| hash(nth(values, ends, number)));
        number
    }
}

fn nth<'v>(values: &'v [u32], ends: &[u32], number: u32) -> &'v [u32] {
    let begin = (number as usize).checked_sub(1).map_or(0, |before| ends[before]);
    &values[begin as usize..ends[number as usize] as usize]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_lists_are_one() {
        let mut lists: Lists = [vec![1, 2], vec![], vec![1, 2], vec![1]].iter().collect();
        assert_eq!(lists.numbers(), [0, 1, 0, 2]);
        assert_eq!((&lists[2], lists.distinct(), lists.len()), (&[1, 2][..], 3, 4));
        lists.set(0, &[]);
        assert_eq!(lists.iter().collect::<Vec<_>>(), [&[][..], &[], &[1, 2], &[1]]);
    }

    #[test]
    fn content_makes_them_equal() {
        let lists: Lists = [[1], [2], [1]].iter().collect();
        let mut other: Lists = [[2], [1], [1]].iter().collect();
        assert_ne!(lists, other);
        other = other.reordered(&[1, 0, 2]);
        assert_ne!(lists.numbers(), other.numbers());
        assert_eq!(lists, other);
        other.append(&lists);
        assert_eq!(other, [[1], [2], [1], [1], [2], [1]].iter().collect());
        assert_eq!(other.distinct(), 2);
        assert_eq!(Lists::empty(2), [[], []].iter().collect());
        assert!(Lists::empty(0).is_empty());
    }
}
