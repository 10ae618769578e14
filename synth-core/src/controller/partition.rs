//! Refinable partitions on flat arrays.

/// A partition of `0..n` whose elements can be marked; splitting cuts every set into its marked and unmarked part.
///
/// After Valmari and Lehtinen, "Efficient minimization of DFAs with partial transition functions" (STACS 2008):
/// the elements of a set are contiguous, its marked ones in front, so that marking takes constant time and splitting
/// takes time proportional to what was marked.
///
/// What is looked up together lies together: with random rows nearly all time goes into cache misses.
#[derive(Debug)]
pub(crate) struct Partition {
    /// All elements, set by set.
    order: Vec<u32>,
    /// Per element.
    elements: Vec<Element>,
    /// Per set.
    sets: Vec<Set>,
    /// The sets with a marked element.
    touched: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Element {
    /// Where it is in the order.
    place: u32,
    set: u32,
}

/// `order[begin..end]`, of which `order[begin..unmarked]` is marked.
#[derive(Debug)]
struct Set {
    begin: u32,
    unmarked: u32,
    end: u32,
}

impl Partition {
    /// The partition into the `sets` (numbered without gaps) that `set` says for each element.
    pub(crate) fn new(set: &[u32], sets: u32) -> Self {
        let (bounds, order) = bucket(set, sets);
        let mut elements: Vec<Element> = set.iter().map(|&set| Element { place: 0, set }).collect();
        for (i, &element) in order.iter().enumerate() {
            elements[element as usize].place = i as u32;
        }
        let sets =
            bounds.windows(2).map(|pair| Set { begin: pair[0], unmarked: pair[0], end: pair[1] }).collect();
        Partition { order, elements, sets, touched: Vec::new() }
    }

    /// Number of sets.
    pub(crate) fn sets(&self) -> u32 {
        self.sets.len() as u32
    }

    /// The elements of a set.
    pub(crate) fn elements(&self, set: u32) -> &[u32] {
        let Set { begin, end, .. } = self.sets[set as usize];
        &self.order[begin as usize..end as usize]
    }

    /// Per element: its set.
    pub(crate) fn into_sets(self) -> Vec<u32> {
        self.elements.into_iter().map(|element| element.set).collect()
    }

    /// Marks an element; a second mark changes nothing.
    pub(crate) fn mark(&mut self, element: u32) {
        let Element { place: from, set: id } = self.elements[element as usize];
        let set = &mut self.sets[id as usize];
        let to = set.unmarked;
        // Marked already, or alone: then there is nothing to split off.
        if from < to || set.end - set.begin == 1 {
            return;
        }
        if to == set.begin {
            self.touched.push(id);
        }
        set.unmarked += 1;
        let other = self.order[to as usize];
        self.order[to as usize] = element;
        self.order[from as usize] = other;
        self.elements[other as usize].place = from;
        self.elements[element as usize].place = to;
    }

    /// Splits every set with marked and unmarked elements, and takes all marks away. The smaller part becomes a new
    /// set, with the next free number: what makes the whole refinement `O(m log n)`.
    pub(crate) fn split(&mut self) {
        while let Some(id) = self.touched.pop() {
            let new = self.sets();
            let set = &mut self.sets[id as usize];
            let (begin, cut, end) = (set.begin, set.unmarked, set.end);
            set.unmarked = begin;
            if cut == end {
                continue;
            }
            let part = if cut - begin <= end - cut {
                (set.begin, set.unmarked) = (cut, cut);
                begin..cut
            } else {
                set.end = cut;
                cut..end
            };
            self.sets.push(Set { begin: part.start, unmarked: part.start, end: part.end });
            for &element in &self.order[part.start as usize..part.end as usize] {
                self.elements[element as usize].set = new;
            }
        }
    }
}

/// Sorts the indices of `keys` by key, equal keys in order of index: the bounds of the `buckets` in the second array
/// (one more than there are), and the indices.
pub(crate) fn bucket(keys: &[u32], buckets: u32) -> (Vec<u32>, Vec<u32>) {
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
        let mut partition = Partition::new(&[0, 0, 0, 1, 1], 2);
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
