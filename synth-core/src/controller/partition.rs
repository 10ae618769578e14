//! Refinable partitions on flat arrays.

/// A partition of `0..n` whose elements can be marked; splitting cuts every set into its marked and unmarked part.
///
/// After Valmari and Lehtinen, "Efficient minimization of DFAs with partial transition functions" (STACS 2008):
/// the elements of a set are contiguous, its marked ones in front, so that marking takes constant time and splitting
/// takes time proportional to what was marked.
#[derive(Debug)]
pub(super) struct Partition {
    /// All elements, set by set.
    elements: Vec<u32>,
    /// Per element: its place in `elements`.
    place: Vec<u32>,
    /// Per element: its set.
    set: Vec<u32>,
    /// Per set: where it begins and ends in `elements`, and how many of it are marked.
    begin: Vec<u32>,
    end: Vec<u32>,
    marked: Vec<u32>,
    /// The sets with a marked element.
    touched: Vec<u32>,
}

impl Partition {
    /// The partition into the `sets` (numbered without gaps) that `set` says for each element.
    pub(super) fn new(set: Vec<u32>, sets: u32) -> Self {
        let (bounds, elements) = bucket(&set, sets);
        let mut place = vec![0; set.len()];
        for (i, &element) in elements.iter().enumerate() {
            place[element as usize] = i as u32;
        }
        let begin = bounds[..sets as usize].to_vec();
        let end = bounds[1..].to_vec();
        Partition { elements, place, set, begin, end, marked: vec![0; sets as usize], touched: Vec::new() }
    }

    /// Number of sets.
    pub(super) fn sets(&self) -> u32 {
        self.begin.len() as u32
    }

    /// The elements of a set.
    pub(super) fn elements(&self, set: u32) -> &[u32] {
        &self.elements[self.begin[set as usize] as usize..self.end[set as usize] as usize]
    }

    /// Per element: its set.
    pub(super) fn into_sets(self) -> Vec<u32> {
        self.set
    }

    /// Marks an element; a second mark changes nothing.
    pub(super) fn mark(&mut self, element: u32) {
        let set = self.set[element as usize];
        let from = self.place[element as usize];
        let to = self.begin[set as usize] + self.marked[set as usize];
        if from < to {
            return;
        }
        if self.marked[set as usize] == 0 {
            self.touched.push(set);
        }
        self.marked[set as usize] += 1;
        let other = self.elements[to as usize];
        self.elements[to as usize] = element;
        self.elements[from as usize] = other;
        self.place[element as usize] = to;
        self.place[other as usize] = from;
    }

    /// Splits every set with marked and unmarked elements, and takes all marks away. The smaller part becomes a new
    /// set, with the next free number: what makes the whole refinement `O(m log n)`.
    pub(super) fn split(&mut self) {
        while let Some(set) = self.touched.pop() {
            let old = set as usize;
            let (begin, end) = (self.begin[old], self.end[old]);
            let cut = begin + self.marked[old];
            self.marked[old] = 0;
            if cut == end {
                continue;
            }
            let new = self.sets();
            let (new_begin, new_end) = if cut - begin <= end - cut {
                self.begin[old] = cut;
                (begin, cut)
            } else {
                self.end[old] = cut;
                (cut, end)
            };
            self.begin.push(new_begin);
            self.end.push(new_end);
            self.marked.push(0);
            for &element in &self.elements[new_begin as usize..new_end as usize] {
                self.set[element as usize] = new;
            }
        }
    }
}

/// Sorts the indices of `keys` by key, equal keys in order of index: the bounds of the `buckets` in the second array
/// (one more than there are), and the indices.
pub(super) fn bucket(keys: &[u32], buckets: u32) -> (Vec<u32>, Vec<u32>) {
    let mut bounds = vec![0; buckets as usize + 1];
    for &key in keys {
        bounds[key as usize + 1] += 1;
    }
    for i in 1..bounds.len() {
        bounds[i] += bounds[i - 1];
    }
    let mut next = bounds.clone();
    let mut indices = vec![0; keys.len()];
    for (i, &key) in keys.iter().enumerate() {
        let place = &mut next[key as usize];
        indices[*place as usize] = i as u32;
        *place += 1;
    }
    (bounds, indices)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bucket_is_stable_and_knows_empty_buckets() {
        assert_eq!(bucket(&[2, 0, 2, 0], 4), (vec![0, 2, 2, 4, 4], vec![1, 3, 0, 2]));
        assert_eq!(bucket(&[], 0), (vec![0], vec![]));
    }

    #[test]
    fn split_makes_the_smaller_part_the_new_set() {
        let mut partition = Partition::new(vec![0, 0, 0, 1, 1], 2);
        for element in [2, 2, 3, 4] {
            partition.mark(element);
        }
        partition.split();
        assert_eq!(partition.sets(), 3);
        assert_eq!(partition.elements(2), [2]);
        partition.mark(0);
        partition.mark(4);
        partition.split();
        assert_eq!(partition.sets(), 5);
        let sets = partition.into_sets();
        assert_eq!(sets.len(), 5);
        assert!((0..5).all(|set| sets.contains(&set)));
    }
}
