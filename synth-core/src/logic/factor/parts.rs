//! Parts of a function that have no variable in common.
//!
//! Formulas of plants are mostly conjunctions of one part a component, and a disjunction of terms multiplies these out.

use super::super::{Bdd, Function, TooLarge, Var};

/// Functions without a common variable whose conjunction (else disjunction) is `f`, as small as possible.
pub(super) fn parts(bdd: &mut Bdd, f: Function, and: bool) -> Result<Vec<Function>, TooLarge> {
    let f = if and { f } else { !f };
    let groups = groups(bdd, f)?;
    let mut parts = Vec::with_capacity(groups.len());
    let mut product = Function::TRUE;
    for own in &groups {
        let others: Vec<Var> =
            bdd.support(&[f]).into_iter().filter(|variable| !own.contains(variable)).collect();
        let part = bdd.exists(f, &others)?;
        product = bdd.and(product, part)?;
        parts.push(part);
    }
    // Variables are grouped in pairs: that they can be kept apart all at once is not said by that.
    let parts = if product == f { parts } else { vec![f] };
    Ok(if and { parts } else { parts.into_iter().map(|part| !part).collect() })
}

/// The variables of `f` in groups: two are in one if no conjunction has the one only in its first and the other only in its
/// second part, and if a third links them.
fn groups(bdd: &mut Bdd, f: Function) -> Result<Vec<Vec<Var>>, TooLarge> {
    let support = bdd.support(&[f]);
    let possible: Vec<Function> =
        support.iter().map(|&variable| bdd.exists(f, &[variable])).collect::<Result<_, _>>()?;
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (position, &with) in possible.iter().enumerate() {
        let mut own = vec![position];
        let mut apart = Vec::with_capacity(groups.len() + 1);
        for group in groups {
            let mut linked = false;
            for &other in &group {
                let both = bdd.and(with, possible[other])?;
                if both != f {
                    linked = true;
                    break;
                }
            }
            if linked { own.extend(group) } else { apart.push(group) }
        }
        own.sort_unstable();
        apart.push(own);
        groups = apart;
    }
    groups.sort_unstable();
    Ok(groups
        .into_iter()
        .map(|group| group.into_iter().map(|position| support[position]).collect())
        .collect())
}
