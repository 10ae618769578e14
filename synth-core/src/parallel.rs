//! Work that several threads share.

use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Cuts a range into consecutive parts of about one size and calls `work` with each, on a thread of its own. Each part has
/// a place for its results; places are made as needed, and keep what they held. Returns the number of parts.
///
/// There are at most `threads` parts, or as many as the machine runs threads at once if that is 0, and none that is
/// smaller than `least`, unless it is the only one.
pub(crate) fn share<T: Default + Send>(
    places: &mut Vec<T>,
    range: Range<u32>,
    least: usize,
    threads: usize,
    work: impl Fn(&mut T, Range<u32>) + Sync,
) -> usize {
    let parts = threads_for(range.len() / least.max(1), threads);
    places.resize_with(places.len().max(parts), T::default);
    let size = range.len().div_ceil(parts) as u32;
    let part = |index: usize| {
        let bound =
            |index: usize| range.start.saturating_add(size.saturating_mul(index as u32)).min(range.end);
        bound(index)..bound(index + 1)
    };
    let (first, others) = places[..parts].split_at_mut(1);
    if others.is_empty() {
        work(&mut first[0], range);
        return 1;
    }
    let work = &work;
    thread::scope(|scope| {
        for (index, place) in others.iter_mut().enumerate() {
            let part = part(index + 1);
            scope.spawn(move || work(place, part));
        }
        work(&mut first[0], part(0));
    });
    parts
}

/// Calls `work` for each of so many items. Each thread takes the next item as soon as it is done with one, and has a place for its
/// results, so which place an item's result is in means nothing. `threads` as for [`share`].
pub(crate) fn take_turns<T: Default + Send>(
    places: &mut Vec<T>,
    items: usize,
    threads: usize,
    work: impl Fn(&mut T, usize) + Sync,
) {
    let next = AtomicUsize::new(0);
    let threads = threads_for(items, threads);
    share(places, 0..threads as u32, 1, threads, |place, _| {
        let turns = std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
        turns.take_while(|&item| item < items).for_each(|item| work(place, item));
    });
}

/// Does two things, at the same time if `most` threads could share the work; the result of the first. `threads` as for [`share`].
pub(crate) fn both<R>(
    most: usize,
    threads: usize,
    one: impl FnOnce() -> R,
    other: impl FnOnce() + Send,
) -> R {
    if threads_for(most, threads) == 1 {
        other();
        return one();
    }
    thread::scope(|scope| {
        scope.spawn(other);
        one()
    })
}

/// Calls `work` with each of so many items, in any order; `threads` as for [`share`].
pub(crate) fn each<I: ExactSizeIterator + Send>(items: I, threads: usize, work: impl Fn(I::Item) + Sync) {
    let count = items.len();
    let items = Mutex::new(items);
    take_turns(&mut Vec::new(), count, threads, |(), _| {
        let item = items.lock().unwrap_or_else(PoisonError::into_inner).next();
        item.into_iter().for_each(&work);
    });
}

/// Fills an array with what `value` says for each index; `least` and `threads` as for [`share`].
pub(crate) fn fill<T: Send>(
    array: &mut [T],
    least: usize,
    threads: usize,
    value: impl Fn(usize) -> T + Sync,
) {
    let parts = threads_for(array.len() / least.max(1), threads);
    let size = array.len().div_ceil(parts).max(1);
    each(array.chunks_mut(size).enumerate(), parts, |(part, places)| {
        (part * size..).zip(places).for_each(|(index, place)| *place = value(index));
    });
}

/// Calls `look` with the numbers below `nodes`, the greatest first, as each thread does with the part of them that is its turn; the sum
/// of the results. `threads` as for [`share`].
pub(crate) fn sum_backwards(nodes: usize, threads: usize, look: impl Fn(usize) -> usize + Sync) -> usize {
    const PART: usize = 1 << 12;
    // A thread is started in the time in which a few thousand nodes are looked at.
    const LEAST: usize = 1 << 14;
    let threads = threads_for(nodes / LEAST, threads);
    let mut places: Vec<usize> = Vec::new();
    take_turns(&mut places, nodes.div_ceil(PART), threads, |sum, part| {
        let end = nodes - part * PART;
        *sum += (end.saturating_sub(PART)..end).rev().map(&look).sum::<usize>();
    });
    places.iter().sum()
}

/// On how many threads to do work for `most`: so many as are asked for, or as the machine runs at once if `threads` is 0, and one at
/// least.
pub(crate) fn threads_for(most: usize, threads: usize) -> usize {
    match most.max(1) {
        // Asking the system takes longer than many a specification.
        1 => 1,
        most if threads == 0 => most.min(thread::available_parallelism().map_or(1, NonZeroUsize::get)),
        most => most.min(threads),
    }
}

/// The first item of which `find` finds something, with its index; whoever finds it, the result is that of asking item by
/// item. `least` and `threads` as for [`share`].
pub(crate) fn find_first<T: Sync, R: Send>(
    items: &[T],
    least: usize,
    threads: usize,
    find: impl Fn(&T) -> Option<R> + Sync,
) -> Option<(usize, R)> {
    let mut places: Vec<Option<(usize, R)>> = Vec::new();
    share(&mut places, 0..items.len() as u32, least, threads, |place, part| {
        let mut indices = part.map(|index| index as usize);
        *place = indices.find_map(|index| Some((index, find(&items[index])?)));
    });
    places.into_iter().flatten().next()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(range: Range<u32>, least: usize, threads: usize, expect: &[(u32, u32)]) {
        let mut places: Vec<Option<(u32, u32)>> = Vec::new();
        let parts = share(&mut places, range, least, threads, |place, part| {
            *place = Some((part.start, part.end));
        });
        let found: Vec<_> = places.into_iter().take(parts).flatten().collect();
        assert_eq!(found, expect);
    }

    #[test]
    fn parts_are_large_enough_and_follow_each_other() {
        check(3..13, 5, 1, &[(3, 13)]);
        check(3..13, 5, 8, &[(3, 8), (8, 13)]);
        check(3..13, 6, 8, &[(3, 13)]);
        check(0..10, 1, 3, &[(0, 4), (4, 8), (8, 10)]);
        check(0..9, 1, 8, &[(0, 2), (2, 4), (4, 6), (6, 8), (8, 9), (9, 9), (9, 9), (9, 9)]);
        check(7..7, 1, 4, &[(7, 7)]);
    }

    #[test]
    fn both_are_done() {
        for (most, threads) in [(1, 8), (8, 1), (8, 8)] {
            let mut done = false;
            assert_eq!((both(most, threads, || 7, || done = true), done), (7, true));
        }
    }

    #[test]
    fn each_item_is_somebodys_turn() {
        for threads in 1..9 {
            let mut places: Vec<Vec<usize>> = Vec::new();
            take_turns(&mut places, 5, threads, Vec::push);
            assert!(places.len() <= threads.min(5));
            let mut all = places.concat();
            all.sort_unstable();
            assert_eq!(all, [0, 1, 2, 3, 4]);
        }
    }

    #[test]
    fn each_place_is_filled() {
        for threads in 1..9 {
            let mut squares = [0; 7];
            fill(&mut squares, 2, threads, |index| index * index);
            assert_eq!(squares, [0, 1, 4, 9, 16, 25, 36]);
        }
        fill(&mut [], 1, 2, |index| index);
    }

    #[test]
    fn the_first_one_is_found_on_any_number_of_threads() {
        for threads in 1..9 {
            let find =
                |wanted| find_first(&[4, 7, 7, 1, 9], 1, threads, |&item| (item == wanted).then_some(item));
            assert_eq!([7, 9, 4, 2].map(find), [Some((1, 7)), Some((4, 9)), Some((0, 4)), None]);
        }
    }
}
