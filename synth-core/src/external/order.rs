//! The order of rows on disk: by their fields, the last one first. Since it does not depend on how wide fields are, a file
//! that was sorted when they were narrower still is.

use crate::successors::Layout;
use std::cmp::Ordering;

/// Compares two rows of one layout.
#[inline]
pub(super) fn compare(a: &[u64], b: &[u64]) -> Ordering {
    if let (&[a], &[b]) = (a, b) { a.cmp(&b) } else { a.iter().rev().cmp(b.iter().rev()) }
}

/// Sorts rows of so many words that lie side by side.
pub(super) fn sort(rows: &mut Vec<u64>, words: usize) {
    match words {
        1 => rows.sort_unstable(),
        2 => sort_arrays::<2>(rows),
        3 => sort_arrays::<3>(rows),
        4 => sort_arrays::<4>(rows),
        5 => sort_arrays::<5>(rows),
        6 => sort_arrays::<6>(rows),
        _ => {
            let mut sorted: Vec<&[u64]> = rows.chunks_exact(words).collect();
            sorted.sort_unstable_by(|a, b| compare(a, b));
            *rows = sorted.concat();
        }
    }
}

fn sort_arrays<const WORDS: usize>(rows: &mut [u64]) {
    rows.as_chunks_mut::<WORDS>().0.sort_unstable_by(|a, b| a.iter().rev().cmp(b.iter().rev()));
}

/// The same rows in a wider layout.
pub(super) fn convert(from: &Layout, to: &Layout, rows: &[u64]) -> Vec<u64> {
    let mut converted = vec![0; rows.len() / from.words() * to.words()];
    for (old, row) in rows.chunks_exact(from.words()).zip(converted.chunks_exact_mut(to.words())) {
        to.convert(from, old, row);
    }
    converted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_word_decides() {
        for words in 1..9 {
            let mut random = 1_u64;
            let mut next = || {
                random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                random >> 62
            };
            let mut rows: Vec<u64> = (0..words * 100).map(|_| next()).collect();
            let mut expect: Vec<Vec<u64>> = rows.chunks(words).map(<[u64]>::to_vec).collect();
            expect.sort_by(|a, b| a.iter().rev().cmp(b.iter().rev()));
            sort(&mut rows, words);
            assert_eq!(rows, expect.concat(), "{words} words");
            assert!(rows.chunks(words).is_sorted_by(|a, b| compare(a, b).is_le()));
        }
    }

    #[test]
    fn a_wider_layout_keeps_the_order() {
        let narrow = Layout::of_widths(&[2, 30, 0, 31, 3]);
        let wide = Layout::of_widths(&[5, 31, 9, 32, 3, 7]);
        let (from, to) = (narrow.words(), wide.words());
        let mut rows: Vec<u64> = (0..200_u64).map(|i| i.wrapping_mul(0x9e37_79b9_7f4a_7c15)).collect();
        // Only bits that belong to a field.
        for row in rows.chunks_exact_mut(from) {
            row[0] &= (1 << 63) - 1;
            row[1] &= 7;
        }
        sort(&mut rows, from);
        let converted = convert(&narrow, &wide, &rows);
        assert!(converted.chunks(to).is_sorted_by(|a, b| compare(a, b).is_le()));
        assert!(converted != rows && converted.len() == rows.len() / from * to);
    }
}
