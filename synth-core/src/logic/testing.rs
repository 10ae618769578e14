//! Functions from truth tables, for tests.

use super::{Bdd, Cover, Expr, Function, Var};

/// The function of `variables` variables whose value at `i` is the bit `i` of `table`, variable 0 the least bit of `i`.
pub(super) fn function(bdd: &mut Bdd, table: &[u64], variables: u32) -> Function {
    build(bdd, table, variables, 0, 0)
}

fn build(bdd: &mut Bdd, table: &[u64], variables: u32, variable: Var, index: usize) -> Function {
    if variable == variables {
        return Function::from(bit(table, index));
    }
    let low = build(bdd, table, variables, variable + 1, index);
    let high = build(bdd, table, variables, variable + 1, index | 1 << variable);
    let literal = bdd.variable(variable).expect("small");
    bdd.ite(literal, high, low).expect("small")
}

pub(super) fn bit(table: &[u64], index: usize) -> bool {
    table[index / 64] >> (index % 64) & 1 == 1
}

/// Values of an expression, as `function` takes them.
pub(super) fn table(expr: &Expr, variables: u32) -> Vec<u64> {
    let mut table = vec![0; (1usize << variables).div_ceil(64)];
    for index in 0..1usize << variables {
        table[index / 64] |= u64::from(expr.eval(&|variable| index >> variable & 1 == 1)) << (index % 64);
    }
    table
}

/// Text with letters for variables.
pub(super) fn text(cover: &Cover) -> String {
    cover.text(|variable| char::from(b'a' + variable as u8).to_string(), 0)
}

/// Text of an expression with letters for variables.
pub(super) fn written(expr: &Expr) -> String {
    match expr {
        Expr::Constant(value) => value.to_string(),
        Expr::Literal(literal) => {
            let name = char::from(b'a' + literal.variable as u8);
            if literal.negated { format!("!{name}") } else { name.to_string() }
        }
        Expr::And(parts) => parts.iter().map(written).collect::<Vec<_>>().join(" "),
        Expr::Or(parts) => {
            format!("({})", parts.iter().map(written).collect::<Vec<_>>().join(" + "))
        }
    }
}
