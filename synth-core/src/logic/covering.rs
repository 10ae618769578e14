//! Minimum weight covering: the fewest columns that meet all rows.
//!
//! Essential columns, dominated rows and dominated columns go first (Quine 1955, McCluskey 1956); what is left, the cyclic
//! core, falls into independent parts or is branched on, cut by rows that share no column and so need one each.

/// A row: the set of columns that meet it; or a column: the set of rows that it meets.
type Bits = Vec<u64>;

/// The result of a search.
pub(super) struct Covered {
    /// The columns that cost least, ascending; `None` if none cost less than the limit.
    pub columns: Option<Vec<u32>>,
    /// No other choice costs less, and if there is none, none costs less than the limit.
    pub proven: bool,
}

/// Columns and what they cost.
struct Choice {
    weight: u64,
    columns: Vec<u32>,
}

/// A choice of columns that meets all `rows` and costs less than `limit`, as cheap as can be found with `budget`, which is in
/// comparisons of rows or columns. A row is the list of the columns that meet it.
pub(super) fn cover(rows: &[Vec<u32>], weights: &[u64], limit: u64, budget: u64) -> Covered {
    let words = weights.len().div_ceil(64);
    let bits = |row: &Vec<u32>| {
        let mut bits = vec![0; words];
        row.iter().for_each(|&column| insert(&mut bits, column));
        bits
    };
    let mut search = Search { weights, budget, exhausted: false };
    let columns =
        search.solve(rows.iter().map(bits).collect(), limit).map(|Choice { mut columns, .. }| {
            columns.sort_unstable();
            // A search that was cut off may have taken a column that later ones make needless.
            if search.exhausted {
                drop_needless(rows, weights, &mut columns);
            }
            columns
        });
    Covered { columns, proven: !search.exhausted }
}

/// Drops columns whose rows others meet, the heaviest first. `columns` are ascending.
fn drop_needless(rows: &[Vec<u32>], weights: &[u64], columns: &mut Vec<u32>) {
    let mut order = columns.clone();
    order.sort_by_key(|&column| std::cmp::Reverse(weights[column as usize]));
    for column in order {
        let meets = |row: &&Vec<u32>| row.binary_search(&column).is_ok();
        let others = |row: &Vec<u32>| row.iter().any(|&c| c != column && columns.binary_search(&c).is_ok());
        if rows.iter().filter(meets).all(others) {
            columns.retain(|&other| other != column);
        }
    }
}

struct Search<'a> {
    /// What a column costs.
    weights: &'a [u64],
    /// How many comparisons are left before the search gives up.
    budget: u64,
    /// It gave up: what it found need not be the best.
    exhausted: bool,
}

impl Search<'_> {
    fn solve(&mut self, mut rows: Vec<Bits>, limit: u64) -> Option<Choice> {
        if self.budget == 0 {
            self.exhausted = true;
            return None;
        }
        let mut columns = Vec::new();
        self.reduce(&mut rows, &mut columns);
        let weight: u64 = columns.iter().map(|&column| self.weights[column as usize]).sum();
        if rows.is_empty() {
            return (weight < limit).then_some(Choice { weight, columns });
        }
        if weight + self.bound(&rows) >= limit {
            return None;
        }
        let mut parts = parts(rows);
        let rest = match parts.len() {
            1 => self.branch(&parts.remove(0), limit - weight),
            _ => self.solve_parts(parts, limit - weight),
        }?;
        columns.extend(rest.columns);
        Some(Choice { weight: weight + rest.weight, columns })
    }

    /// Parts that share no column.
    fn solve_parts(&mut self, parts: Vec<Vec<Bits>>, limit: u64) -> Option<Choice> {
        let mut all = Choice { weight: 0, columns: Vec::new() };
        for part in parts {
            let choice = self.solve(part, limit.checked_sub(all.weight)?)?;
            all.weight += choice.weight;
            all.columns.extend(choice.columns);
        }
        Some(all)
    }

    /// Tries every column of a shortest row, the ones before it left out.
    fn branch(&mut self, rows: &[Bits], mut limit: u64) -> Option<Choice> {
        let row = rows.iter().min_by_key(|row| len(row))?;
        let met = |column: u32| rows.iter().filter(|row| has(row, column)).count();
        let mut candidates: Vec<u32> = members(row).collect();
        candidates.sort_by_cached_key(|&column| (usize::MAX - met(column), self.weights[column as usize]));
        let mut best = None;
        let mut tried = vec![0; row.len()];
        for column in candidates {
            let weight = self.weights[column as usize];
            let mut rest: Vec<Bits> = rows.iter().filter(|row| !has(row, column)).cloned().collect();
            rest.iter_mut().for_each(|row| remove(row, &tried));
            if let Some(mut choice) = limit.checked_sub(weight).and_then(|limit| self.solve(rest, limit)) {
                choice.weight += weight;
                choice.columns.push(column);
                limit = choice.weight;
                best = Some(choice);
            }
            insert(&mut tried, column);
        }
        best
    }

    /// Rows that share no column need a column each.
    fn bound(&self, rows: &[Bits]) -> u64 {
        let mut order: Vec<&Bits> = rows.iter().collect();
        order.sort_by_cached_key(|row| len(row));
        let mut used = vec![0; rows[0].len()];
        let mut bound = 0;
        for row in order {
            if !meet(row, &used) {
                unite(&mut used, row);
                let least = members(row).map(|column| self.weights[column as usize]).min();
                bound += least.unwrap_or(u64::MAX / 4);
            }
        }
        bound
    }

    /// Takes what must be taken and removes what cannot matter, until nothing changes. A row without columns stays.
    fn reduce(&mut self, rows: &mut Vec<Bits>, chosen: &mut Vec<u32>) {
        loop {
            rows.sort_by_cached_key(|row| len(row));
            let essential = rows.iter().find(|row| len(row) == 1).and_then(|row| members(row).next());
            if let Some(column) = essential {
                rows.retain(|row| !has(row, column));
                chosen.push(column);
                continue;
            }
            self.keep_hard_rows(rows);
            if !self.keep_good_columns(rows) {
                return;
            }
        }
    }

    /// A row that contains another is met wherever that one is. Rows are in order of length.
    fn keep_hard_rows(&mut self, rows: &mut Vec<Bits>) {
        let mut kept: Vec<Bits> = Vec::with_capacity(rows.len());
        for row in rows.drain(..) {
            self.budget = self.budget.saturating_sub(kept.len() as u64 + 1);
            if !kept.iter().any(|other| within(other, &row)) {
                kept.push(row);
            }
        }
        *rows = kept;
    }

    /// A column is not needed if another that costs no more meets all of its rows. Says whether any has gone.
    fn keep_good_columns(&mut self, rows: &mut [Bits]) -> bool {
        let mut all = vec![0; self.weights.len().div_ceil(64)];
        rows.iter().for_each(|row| unite(&mut all, row));
        let mut columns: Vec<(usize, u64, u32, Bits)> = members(&all)
            .map(|column| {
                let mut met = vec![0; rows.len().div_ceil(64)];
                (0..rows.len())
                    .filter(|&row| has(&rows[row], column))
                    .for_each(|row| insert(&mut met, row as u32));
                (usize::MAX - len(&met), self.weights[column as usize], column, met)
            })
            .collect();
        columns.sort_unstable();
        let mut kept: Vec<(u64, Bits)> = Vec::with_capacity(columns.len());
        let mut gone = vec![0; all.len()];
        let mut any = false;
        for (_, weight, column, met) in columns {
            self.budget = self.budget.saturating_sub(kept.len() as u64 + 1);
            if kept.iter().any(|(other, more)| *other <= weight && within(&met, more)) {
                insert(&mut gone, column);
                any = true;
            } else {
                kept.push((weight, met));
            }
        }
        if any {
            rows.iter_mut().for_each(|row| remove(row, &gone));
        }
        any
    }
}

/// Groups of rows that share no column with rows of another group.
fn parts(rows: Vec<Bits>) -> Vec<Vec<Bits>> {
    let mut groups: Vec<(Bits, Vec<Bits>)> = Vec::new();
    for row in rows {
        let (mut columns, mut members) = (row.clone(), vec![row]);
        let mut apart = Vec::with_capacity(groups.len() + 1);
        for (others, group) in groups {
            if meet(&others, &columns) {
                unite(&mut columns, &others);
                members.extend(group);
            } else {
                apart.push((others, group));
            }
        }
        apart.push((columns, members));
        groups = apart;
    }
    groups.into_iter().map(|(_, members)| members).collect()
}

fn has(set: &[u64], member: u32) -> bool {
    set[member as usize / 64] >> (member % 64) & 1 == 1
}

fn insert(set: &mut [u64], member: u32) {
    set[member as usize / 64] |= 1 << (member % 64);
}

fn len(set: &[u64]) -> usize {
    set.iter().map(|word| word.count_ones() as usize).sum()
}

fn members(set: &[u64]) -> impl Iterator<Item = u32> {
    (0..set.len() as u32 * 64).filter(|&member| has(set, member))
}

// Loops, since these run millions of times, also in builds without optimisation.

fn within(set: &[u64], other: &[u64]) -> bool {
    for i in 0..set.len() {
        if set[i] & !other[i] != 0 {
            return false;
        }
    }
    true
}

fn meet(set: &[u64], other: &[u64]) -> bool {
    for i in 0..set.len() {
        if set[i] & other[i] != 0 {
            return true;
        }
    }
    false
}

fn unite(set: &mut [u64], other: &[u64]) {
    set.iter_mut().zip(other).for_each(|(word, other)| *word |= other);
}

fn remove(set: &mut [u64], other: &[u64]) {
    set.iter_mut().zip(other).for_each(|(word, other)| *word &= !other);
}

#[cfg(test)]
mod tests;
