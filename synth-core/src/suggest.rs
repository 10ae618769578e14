//! "Did you mean …?": the nearest known name.

/// The candidate nearest to `name`, if one is near enough to be a slip of the keyboard; of several the first.
///
/// A third of the letters may be wrong, where a letter too many, one missing, a wrong one, and two that changed places
/// count as one each; case does not count.
pub(crate) fn nearest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let limit = name.chars().count().div_ceil(3);
    candidates
        .map(|candidate| (distance(&name.to_lowercase(), &candidate.to_lowercase()), candidate))
        // A name of one or two letters is not a slip of another one that shares none of them.
        .filter(|&(distance, candidate)| distance <= limit && distance < candidate.chars().count())
        .min()
        .map(|(_, candidate)| candidate)
}

/// Edit distance with adjacent transpositions (optimal string alignment).
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let best = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                let swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
                if swapped { best.min(rows[i - 2][j - 2] + 1) } else { best }
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[track_caller]
    fn check(name: &str, known: &[&str], expect: Option<&str>) {
        assert_eq!(nearest(name, known.iter().copied()), expect);
    }

    #[test]
    fn nearest_name() {
        check("feedAmr", &["feedArm", "feedBelt"], Some("feedArm"));
        check("feedarm", &["feedArm"], Some("feedArm"));
        check("x", &["controller"], None);
        check("a", &["b"], None);
        check("press", &[], None);
        check("ro", &["or", "and"], Some("or"));
    }
}
