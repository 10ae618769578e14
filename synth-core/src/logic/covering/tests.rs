use super::cover;
use proptest::prelude::*;

/// The least weight of columns that meet all rows; `None` if a row has none.
fn naive(rows: &[Vec<u32>], weights: &[u64]) -> Option<u64> {
    let weight = |set: u32| (0..weights.len()).filter(|i| set >> i & 1 == 1).map(|i| weights[i]).sum();
    (0..1u32 << weights.len())
        .filter(|set| rows.iter().all(|row| row.iter().any(|column| set >> column & 1 == 1)))
        .map(weight)
        .min()
}

fn rows() -> impl Strategy<Value = (Vec<Vec<u32>>, Vec<u64>)> {
    (3u32..10).prop_flat_map(|columns| {
        let row = proptest::collection::btree_set(0..columns, 1..4).prop_map(|row| row.into_iter().collect());
        (
            proptest::collection::vec(row, 1..14),
            proptest::collection::vec(100u64..104, columns as usize..=columns as usize),
        )
    })
}

proptest! {
    #[test]
    fn no_choice_costs_less((rows, weights) in rows()) {
        let least = naive(&rows, &weights).unwrap();
        let covered = cover(&rows, &weights, u64::MAX / 8, 1_000_000);
        prop_assert!(covered.proven);
        let columns = covered.columns.unwrap();
        prop_assert!(rows.iter().all(|row| row.iter().any(|column| columns.contains(column))));
        prop_assert_eq!(columns.iter().map(|&column| weights[column as usize]).sum::<u64>(), least);
        // Nothing is below the least.
        let below = cover(&rows, &weights, least, 1_000_000);
        prop_assert!(below.proven && below.columns.is_none());
    }
}

#[test]
fn a_cyclic_core_is_branched_on() {
    let ring: Vec<Vec<u32>> = (0..7)
        .map(|i| vec![i, (i + 1) % 7])
        .map(|mut row| {
            row.sort_unstable();
            row
        })
        .collect();
    let covered = cover(&ring, &[1; 7], 100, 1_000);
    assert_eq!((covered.columns.map(|columns| columns.len()), covered.proven), (Some(4), true));
}

#[test]
fn parts_are_solved_each_for_itself() {
    let mut rings: Vec<Vec<u32>> = Vec::new();
    for ring in 0..12 {
        rings.extend([[0, 1], [1, 2], [0, 2]].map(|row| row.map(|column| 3 * ring + column).to_vec()));
    }
    // One after the other, that is 12 small searches instead of 3^12.
    let covered = cover(&rings, &[1; 36], 100, 3_000);
    assert_eq!((covered.columns.map(|columns| columns.len()), covered.proven), (Some(24), true));
}

#[test]
fn what_is_not_finished_is_not_proven() {
    let ring: Vec<Vec<u32>> = (0..7)
        .map(|i| vec![i, (i + 1) % 7])
        .map(|mut row| {
            row.sort_unstable();
            row
        })
        .collect();
    assert!(!cover(&ring, &[1; 7], 100, 20).proven);
}

#[test]
fn a_row_without_columns_cannot_be_met() {
    let covered = cover(&[vec![0], vec![]], &[1], 100, 100);
    assert!(covered.proven && covered.columns.is_none());
}
