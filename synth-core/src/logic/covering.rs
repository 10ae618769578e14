//! Minimum weight covering: the fewest columns that meet all rows.
//!
//! Essential columns, dominated rows and dominated columns go first (Quine 1955, McCluskey 1956); what is left, the cyclic
//! core, falls into independent parts or is branched on, cut by rows that share no column and so need one each.

/// Chooses among columns, which are numbered; a row is the ascending list of the columns that meet it.
pub(super) struct Covering<'a> {
    /// What a column costs.
    weights: &'a [u64],
    /// How much work is left before the search gives up, in rows looked at.
    budget: u64,
    /// It gave up: what it found need not be the best.
    exhausted: bool,
}

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

/// A choice of columns that meets all `rows` and costs less than `limit`, as cheap as can be found with `budget`.
pub(super) fn cover(rows: Vec<Vec<u32>>, weights: &[u64], limit: u64, budget: u64) -> Covered {
    let mut search = Covering { weights, budget, exhausted: false };
    let columns = search.solve(rows, limit).map(|mut choice| {
        choice.columns.sort_unstable();
        choice.columns
    });
    Covered { columns, proven: !search.exhausted }
}

impl Covering<'_> {
    fn solve(&mut self, mut rows: Vec<Vec<u32>>, limit: u64) -> Option<Choice> {
        let work = 1 + rows.len() as u64;
        if self.budget < work {
            self.exhausted = true;
            return None;
        }
        self.budget -= work;
        let mut columns = Vec::new();
        self.reduce(&mut rows, &mut columns);
        let weight: u64 = columns.iter().map(|&column| self.weights[column as usize]).sum();
        if rows.is_empty() {
            return (weight < limit).then_some(Choice { weight, columns });
        }
        if weight + self.bound(&rows) >= limit {
            return None;
        }
        let rest = match parts(&rows) {
            parts if parts.len() > 1 => self.solve_parts(parts, limit - weight),
            _ => self.branch(&rows, limit - weight),
        }?;
        columns.extend(rest.columns);
        Some(Choice { weight: weight + rest.weight, columns })
    }

    /// Parts that share no column.
    fn solve_parts(&mut self, parts: Vec<Vec<Vec<u32>>>, limit: u64) -> Option<Choice> {
        let mut all = Choice { weight: 0, columns: Vec::new() };
        for part in parts {
            let choice = self.solve(part, limit.checked_sub(all.weight)?)?;
            all.weight += choice.weight;
            all.columns.extend(choice.columns);
        }
        Some(all)
    }

    /// Tries every column of a shortest row, the ones before it left out.
    fn branch(&mut self, rows: &[Vec<u32>], mut limit: u64) -> Option<Choice> {
        let row = rows.iter().min_by_key(|row| row.len())?;
        let met = |column: u32| rows.iter().filter(|row| row.binary_search(&column).is_ok()).count();
        let mut candidates = row.clone();
        candidates.sort_by_cached_key(|&column| (usize::MAX - met(column), self.weights[column as usize]));
        let mut best = None;
        for (position, &column) in candidates.iter().enumerate() {
            let weight = self.weights[column as usize];
            let tried = &candidates[..position];
            let rest = rows
                .iter()
                .filter(|row| row.binary_search(&column).is_err())
                .map(|row| row.iter().copied().filter(|other| !tried.contains(other)).collect())
                .collect();
            if let Some(mut choice) = limit.checked_sub(weight).and_then(|limit| self.solve(rest, limit)) {
                choice.weight += weight;
                choice.columns.push(column);
                limit = choice.weight;
                best = Some(choice);
            }
        }
        best
    }

    /// Rows that share no column need a column each.
    fn bound(&self, rows: &[Vec<u32>]) -> u64 {
        let mut order: Vec<&Vec<u32>> = rows.iter().collect();
        order.sort_by_key(|row| row.len());
        let mut used = vec![false; self.weights.len()];
        let mut bound = 0;
        for row in order {
            if row.iter().all(|&column| !used[column as usize]) {
                row.iter().for_each(|&column| used[column as usize] = true);
                bound +=
                    row.iter().map(|&column| self.weights[column as usize]).min().unwrap_or(u64::MAX / 4);
            }
        }
        bound
    }

    /// Takes what must be taken and removes what cannot matter, until nothing changes. A row without columns stays.
    fn reduce(&self, rows: &mut Vec<Vec<u32>>, chosen: &mut Vec<u32>) {
        loop {
            rows.sort_unstable_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
            rows.dedup();
            let essential: Vec<u32> =
                rows.iter().take_while(|row| row.len() <= 1).filter_map(|row| row.first().copied()).collect();
            if !essential.is_empty() {
                rows.retain(|row| row.iter().all(|column| essential.binary_search(column).is_err()));
                chosen.extend(essential);
            }
            self.keep_hard_rows(rows);
            if !self.keep_good_columns(rows) {
                return;
            }
        }
    }

    /// A row that contains another is met wherever that one is. Rows are in order of length.
    fn keep_hard_rows(&self, rows: &mut Vec<Vec<u32>>) {
        let mut kept: Vec<Vec<u32>> = Vec::with_capacity(rows.len());
        let mut kept_by_column: Vec<Vec<u32>> = vec![Vec::new(); self.weights.len()];
        let mut shared = vec![0; rows.len()];
        for row in rows.drain(..) {
            let mut touched = Vec::new();
            let mut contains_other = false;
            for &other in row.iter().flat_map(|&column| &kept_by_column[column as usize]) {
                shared[other as usize] += 1;
                touched.push(other);
                contains_other |= shared[other as usize] == kept[other as usize].len();
            }
            touched.into_iter().for_each(|other| shared[other as usize] = 0);
            if !contains_other {
                row.iter().for_each(|&column| kept_by_column[column as usize].push(kept.len() as u32));
                kept.push(row);
            }
        }
        *rows = kept;
    }

    /// A column is not needed if another that costs no more meets all of its rows. Says whether any has gone.
    fn keep_good_columns(&self, rows: &mut [Vec<u32>]) -> bool {
        let mut met: Vec<Vec<u32>> = vec![Vec::new(); self.weights.len()];
        for (position, row) in rows.iter().enumerate() {
            row.iter().for_each(|&column| met[column as usize].push(position as u32));
        }
        let mut order: Vec<u32> =
            (0..self.weights.len() as u32).filter(|&column| !met[column as usize].is_empty()).collect();
        order.sort_by_key(|&column| (usize::MAX - met[column as usize].len(), self.weights[column as usize]));
        let mut kept_by_row: Vec<Vec<u32>> = vec![Vec::new(); rows.len()];
        let mut shared = vec![0; self.weights.len()];
        let mut gone = vec![false; self.weights.len()];
        let mut any = false;
        for column in order {
            let own = &met[column as usize];
            let mut touched = Vec::new();
            let mut dominated = false;
            for &other in own.iter().flat_map(|&row| &kept_by_row[row as usize]) {
                shared[other as usize] += 1;
                touched.push(other);
                dominated |= shared[other as usize] == own.len()
                    && self.weights[other as usize] <= self.weights[column as usize];
            }
            touched.into_iter().for_each(|other| shared[other as usize] = 0);
            if dominated {
                gone[column as usize] = true;
                any = true;
            } else {
                own.iter().for_each(|&row| kept_by_row[row as usize].push(column));
            }
        }
        if any {
            rows.iter_mut().for_each(|row| row.retain(|&column| !gone[column as usize]));
        }
        any
    }
}

/// Groups of rows that share no column with rows of another group.
fn parts(rows: &[Vec<u32>]) -> Vec<Vec<Vec<u32>>> {
    let columns = rows.iter().flatten().max().map_or(0, |&column| column as usize + 1);
    // The group that a column was seen in; groups point to the one that they were merged into.
    let mut group_of_column = vec![usize::MAX; columns];
    let mut merged: Vec<usize> = (0..rows.len()).collect();
    let root = |merged: &[usize], mut group: usize| {
        while merged[group] != group {
            group = merged[group];
        }
        group
    };
    for (position, row) in rows.iter().enumerate() {
        for &column in row {
            match &mut group_of_column[column as usize] {
                group if *group == usize::MAX => *group = position,
                group => {
                    let (a, b) = (root(&merged, *group), root(&merged, position));
                    merged[a.max(b)] = a.min(b);
                }
            }
        }
    }
    let mut parts: Vec<Vec<Vec<u32>>> = vec![Vec::new(); rows.len()];
    for (position, row) in rows.iter().enumerate() {
        parts[root(&merged, position)].push(row.clone());
    }
    parts.retain(|part| !part.is_empty());
    parts
}

#[cfg(test)]
mod tests;
