//! "Did you mean …?": the nearest known name.

/// Help that names the candidate nearest to `name`, if one is near enough to be a slip of the keyboard.
pub(super) fn did_you_mean<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<String> {
    let limit = name.chars().count().div_ceil(3);
    candidates
        .map(|candidate| (distance(&name.to_lowercase(), &candidate.to_lowercase()), candidate))
        .filter(|&(distance, _)| distance <= limit)
        .min()
        .map(|(_, candidate)| format!("write `{candidate}`, which is declared"))
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
    use super::did_you_mean;

    #[track_caller]
    fn check(name: &str, known: &[&str], expect: Option<&str>) {
        let help = did_you_mean(name, known.iter().copied());
        assert_eq!(help.as_deref(), expect.map(|e| format!("write `{e}`, which is declared")).as_deref());
    }

    #[test]
    fn nearest_name() {
        check("feedAmr", &["feedArm", "feedBelt"], Some("feedArm"));
        check("feedarm", &["feedArm"], Some("feedArm"));
        check("x", &["controller"], None);
        check("press", &[], None);
    }
}
