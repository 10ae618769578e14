//! Boolean functions as reduced, ordered binary decision diagrams.
//!
//! One arena of nodes for all functions of a [`Bdd`], in which equal functions are the same node, so that comparing two is
//! comparing numbers (Bryant, "Graph-based algorithms for Boolean function manipulation", 1986). Edges carry a complement
//! bit, so that a function and its negation share all nodes and negation costs nothing (Brace, Rudell and Bryant,
//! "Efficient implementation of a BDD package", 1990). Variables are tested in the order of their numbers; nothing is ever
//! freed, since a diagram lives as long as one synthesis.

use super::{TooLarge, Var};
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;
use std::ops::Not;

/// A function of some [`Bdd`]: twice the position of a node, and one if it is negated.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Function(u32);

impl Function {
    /// Always true.
    pub const TRUE: Function = Function(0);
    /// Always false.
    pub const FALSE: Function = Function(1);

    fn node(self) -> usize {
        (self.0 >> 1) as usize
    }

    /// `self`, negated if `other` is a negated edge.
    fn negated_like(self, other: Function) -> Function {
        Function(self.0 ^ (other.0 & 1))
    }
}

impl Not for Function {
    type Output = Function;

    fn not(self) -> Function {
        Function(self.0 ^ 1)
    }
}

impl From<bool> for Function {
    fn from(value: bool) -> Function {
        if value { Function::TRUE } else { Function::FALSE }
    }
}

/// Tests `variable`. The edge where it is true is never negated, which makes nodes canonical.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Node {
    variable: Var,
    low: Function,
    high: Function,
}

/// The variable of the constant: after all others.
const LEAF: Var = Var::MAX;

/// How many nodes [`Bdd::new`] allows: some hundred megabytes with the tables.
const NODES: usize = 4_000_000;

/// An arena of functions.
pub struct Bdd {
    nodes: Vec<Node>,
    unique: HashMap<Node, Function, FxBuildHasher>,
    conjunctions: HashMap<(Function, Function), Function, FxBuildHasher>,
    limit: usize,
    /// Nodes visited so far, for budgets that do not depend on the machine.
    work: u64,
}

impl Default for Bdd {
    fn default() -> Self {
        Bdd::new()
    }
}

impl Bdd {
    /// An arena that only knows constants.
    #[must_use]
    pub fn new() -> Self {
        Bdd::with_limit(NODES)
    }

    /// The same, that gives up beyond `limit` nodes.
    #[must_use]
    pub fn with_limit(limit: usize) -> Self {
        Bdd {
            nodes: vec![Node { variable: LEAF, low: Function::TRUE, high: Function::TRUE }],
            unique: HashMap::default(),
            conjunctions: HashMap::default(),
            limit: limit.min(u32::MAX as usize / 2),
            work: 0,
        }
    }

    /// How many nodes there are, those of functions that nobody needs any longer included.
    #[must_use]
    pub fn size(&self) -> usize {
        self.nodes.len()
    }

    /// How many nodes operations have visited so far.
    pub(super) fn work(&self) -> u64 {
        self.work
    }

    fn make(&mut self, variable: Var, low: Function, high: Function) -> Result<Function, TooLarge> {
        if low == high {
            return Ok(low);
        }
        let node = Node { variable, low: low.negated_like(high), high: high.negated_like(high) };
        if let Some(&known) = self.unique.get(&node) {
            return Ok(known.negated_like(high));
        }
        if self.nodes.len() >= self.limit {
            return Err(TooLarge::Nodes(self.limit));
        }
        let made = Function((self.nodes.len() as u32) << 1);
        self.nodes.push(node);
        self.unique.insert(node, made);
        Ok(made.negated_like(high))
    }

    /// The function that is true where `variable` is.
    pub fn variable(&mut self, variable: Var) -> Result<Function, TooLarge> {
        self.make(variable, Function::FALSE, Function::TRUE)
    }

    /// The function that is true where `variable` is `value`.
    pub fn literal(&mut self, variable: Var, value: bool) -> Result<Function, TooLarge> {
        let positive = self.variable(variable)?;
        Ok(if value { positive } else { !positive })
    }

    /// The variable that `f` tests first; `None` for a constant.
    #[must_use]
    pub fn top(&self, f: Function) -> Option<Var> {
        let variable = self.nodes[f.node()].variable;
        (variable != LEAF).then_some(variable)
    }

    /// `f` where `variable` is false, and where it is true, if `f` tests no variable before it.
    #[must_use]
    pub fn branches(&self, f: Function, variable: Var) -> (Function, Function) {
        let node = &self.nodes[f.node()];
        if node.variable == variable { (node.low.negated_like(f), node.high.negated_like(f)) } else { (f, f) }
    }

    /// The variable that is tested first by one of two functions that are not both constant.
    pub(super) fn first(&self, f: Function, g: Function) -> Var {
        self.nodes[f.node()].variable.min(self.nodes[g.node()].variable)
    }

    /// Both.
    pub fn and(&mut self, f: Function, g: Function) -> Result<Function, TooLarge> {
        if f == Function::FALSE || g == Function::FALSE || f == !g {
            return Ok(Function::FALSE);
        }
        if f == Function::TRUE || f == g {
            return Ok(g);
        }
        if g == Function::TRUE {
            return Ok(f);
        }
        let key = if f < g { (f, g) } else { (g, f) };
        if let Some(&known) = self.conjunctions.get(&key) {
            return Ok(known);
        }
        self.work += 1;
        let variable = self.first(f, g);
        let (f0, f1) = self.branches(f, variable);
        let (g0, g1) = self.branches(g, variable);
        let low = self.and(f0, g0)?;
        let high = self.and(f1, g1)?;
        let result = self.make(variable, low, high)?;
        // A cache, so that it may forget.
        if self.conjunctions.len() >= self.limit {
            self.conjunctions.clear();
        }
        self.conjunctions.insert(key, result);
        Ok(result)
    }

    /// One of them at least.
    pub fn or(&mut self, f: Function, g: Function) -> Result<Function, TooLarge> {
        Ok(!self.and(!f, !g)?)
    }

    /// `f` and not `g`.
    pub fn without(&mut self, f: Function, g: Function) -> Result<Function, TooLarge> {
        self.and(f, !g)
    }

    /// `then` where `condition` holds, else `otherwise`.
    pub fn ite(
        &mut self,
        condition: Function,
        then: Function,
        otherwise: Function,
    ) -> Result<Function, TooLarge> {
        let then = self.and(condition, then)?;
        let otherwise = self.and(!condition, otherwise)?;
        self.or(then, otherwise)
    }

    /// `f` holds only where `g` does.
    pub fn implies(&mut self, f: Function, g: Function) -> Result<bool, TooLarge> {
        Ok(self.and(f, !g)? == Function::FALSE)
    }

    /// `f` where `variable` is `value`.
    pub fn cofactor(&mut self, f: Function, variable: Var, value: bool) -> Result<Function, TooLarge> {
        self.cofactor_memo(f, variable, value, &mut HashMap::default())
    }

    fn cofactor_memo(
        &mut self,
        f: Function,
        variable: Var,
        value: bool,
        memo: &mut Memo,
    ) -> Result<Function, TooLarge> {
        let Node { variable: top, low, high } = self.nodes[f.node()];
        if top > variable {
            return Ok(f);
        }
        if top == variable {
            return Ok(if value { high } else { low }.negated_like(f));
        }
        let regular = Function(f.0 & !1);
        if let Some(&known) = memo.get(&regular) {
            return Ok(known.negated_like(f));
        }
        self.work += 1;
        let low = self.cofactor_memo(low, variable, value, memo)?;
        let high = self.cofactor_memo(high, variable, value, memo)?;
        let result = self.make(top, low, high)?;
        memo.insert(regular, result);
        Ok(result.negated_like(f))
    }

    /// Holds where `f` does for some values of `variables`, which ascend.
    pub fn exists(&mut self, f: Function, variables: &[Var]) -> Result<Function, TooLarge> {
        self.exists_memo(f, variables, &mut HashMap::default())
    }

    fn exists_memo(&mut self, f: Function, variables: &[Var], memo: &mut Memo) -> Result<Function, TooLarge> {
        let Some(top) = self.top(f) else { return Ok(f) };
        let passed = variables.partition_point(|&variable| variable < top);
        let variables = &variables[passed..];
        if variables.is_empty() {
            return Ok(f);
        }
        if let Some(&known) = memo.get(&f) {
            return Ok(known);
        }
        self.work += 1;
        let (low, high) = self.branches(f, top);
        let low = self.exists_memo(low, variables, memo)?;
        let high = self.exists_memo(high, variables, memo)?;
        let result = if variables[0] == top { self.or(low, high)? } else { self.make(top, low, high)? };
        memo.insert(f, result);
        Ok(result)
    }

    /// Holds where `f` does for all values of `variables`, which ascend.
    pub fn forall(&mut self, f: Function, variables: &[Var]) -> Result<Function, TooLarge> {
        Ok(!self.exists(!f, variables)?)
    }

    /// The variables that matter to one of `functions`, ascending.
    #[must_use]
    pub fn support(&self, functions: &[Function]) -> Vec<Var> {
        let mut seen = HashMap::<usize, (), FxBuildHasher>::default();
        let mut open: Vec<usize> = functions.iter().map(|f| f.node()).collect();
        let mut variables = Vec::new();
        while let Some(position) = open.pop() {
            let node = &self.nodes[position];
            if node.variable == LEAF || seen.insert(position, ()).is_some() {
                continue;
            }
            variables.push(node.variable);
            open.extend([node.low.node(), node.high.node()]);
        }
        variables.sort_unstable();
        variables.dedup();
        variables
    }

    /// Its value where `holds` says which variables are true.
    #[must_use]
    pub fn eval(&self, mut f: Function, holds: &impl Fn(Var) -> bool) -> bool {
        while let Some(variable) = self.top(f) {
            let (low, high) = self.branches(f, variable);
            f = if holds(variable) { high } else { low };
        }
        f == Function::TRUE
    }

    /// The part of all assignments in which it holds.
    #[must_use]
    pub fn density(&self, f: Function) -> f64 {
        let mut memo = HashMap::<usize, f64, FxBuildHasher>::default();
        self.density_memo(f, &mut memo)
    }

    fn density_memo(&self, f: Function, memo: &mut HashMap<usize, f64, FxBuildHasher>) -> f64 {
        let node = self.nodes[f.node()];
        let regular = if node.variable == LEAF {
            1.0
        } else if let Some(&known) = memo.get(&f.node()) {
            known
        } else {
            let mean = f64::midpoint(self.density_memo(node.low, memo), self.density_memo(node.high, memo));
            memo.insert(f.node(), mean);
            mean
        };
        if f.0 & 1 == 0 { regular } else { 1.0 - regular }
    }

    /// In how many of the assignments to `variables` it holds, if it depends on nothing else and there are at most 64.
    ///
    /// Exact up to 53 variables.
    #[must_use]
    pub fn count(&self, f: Function, variables: usize) -> f64 {
        self.density(f) * 2f64.powi(variables as i32)
    }

    /// Literals that make it true, ascending by variable; `None` if nothing does.
    #[must_use]
    pub fn witness(&self, mut f: Function) -> Option<Vec<(Var, bool)>> {
        if f == Function::FALSE {
            return None;
        }
        let mut literals = Vec::new();
        while let Some(variable) = self.top(f) {
            let (low, high) = self.branches(f, variable);
            let value = low == Function::FALSE;
            literals.push((variable, value));
            f = if value { high } else { low };
        }
        Some(literals)
    }

    /// All values of a function that depends on nothing but `variables`, which ascend: bit `i % 64` of word `i / 64` is the
    /// value where the first of `variables` is the least bit of `i`, and so on.
    ///
    /// # Panics
    /// If there are more than 30 variables: the table would have a gigabit.
    #[must_use]
    pub fn truth_table(&self, f: Function, variables: &[Var]) -> Vec<u64> {
        assert!(variables.len() <= 30, "a truth table of {} variables", variables.len());
        let mut table = vec![0; (1usize << variables.len()).div_ceil(64)];
        self.fill(f, variables, 0, 0, &mut table);
        table
    }

    /// The values where the variables before `position` are the bits of `index`.
    fn fill(&self, f: Function, variables: &[Var], position: usize, index: usize, table: &mut [u64]) {
        if f == Function::FALSE {
            return;
        }
        let Some(&variable) = variables.get(position) else {
            table[index / 64] |= 1 << (index % 64);
            return;
        };
        let (low, high) = self.branches(f, variable);
        self.fill(low, variables, position + 1, index, table);
        self.fill(high, variables, position + 1, index | 1 << position, table);
    }
}

type Memo = HashMap<Function, Function, FxBuildHasher>;

#[cfg(test)]
mod tests;
