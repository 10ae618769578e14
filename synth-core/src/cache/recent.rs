//! A store in memory.

use super::{Key, Store};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// More are forgotten, those first that were not asked for the longest.
const MOST: usize = 16;

/// The results that were last asked for, of all threads.
#[derive(Debug, Default)]
pub struct Recent(Mutex<Vec<(Key, Vec<String>)>>);

impl Recent {
    /// An empty one.
    #[must_use]
    pub const fn new() -> Self {
        Recent(Mutex::new(Vec::new()))
    }

    /// The last one used is last. Nothing that is done with it can panic halfway.
    fn entries(&self) -> MutexGuard<'_, Vec<(Key, Vec<String>)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Store for Recent {
    fn get(&self, key: &Key) -> Option<Vec<String>> {
        let mut entries = self.entries();
        let at = entries.iter().position(|(known, _)| known == key)?;
        entries[at..].rotate_left(1);
        entries.last().map(|(_, texts)| texts.clone())
    }

    fn put(&self, key: &Key, texts: &[String]) {
        let mut entries = self.entries();
        entries.retain(|(known, _)| known != key);
        if entries.len() == MOST {
            entries.remove(0);
        }
        entries.push((key.clone(), texts.to_vec()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_used_stays() {
        let key = |i: usize| Key::new("", &i);
        let text = |i: usize| vec![i.to_string()];
        let recent = Recent::new();
        for i in 0..3 * MOST {
            recent.put(&key(i), &text(i));
            assert_eq!(recent.get(&key(0)), Some(text(0)));
        }
        let known: Vec<usize> = (0..3 * MOST).filter(|&i| recent.get(&key(i)).is_some()).collect();
        let expected: Vec<usize> = [0].into_iter().chain(2 * MOST + 1..3 * MOST).collect();
        assert_eq!(known, expected);
        recent.put(&key(0), &text(1));
        assert_eq!(recent.get(&key(0)), Some(text(1)));
    }
}
