use super::super::testing::table;
use super::{Instruction, Words, count, depth, instructions, run, stack_depth};
use crate::logic::{Bdd, Expr, Literal};
use proptest::prelude::*;

fn expr() -> impl Strategy<Value = Expr> {
    let leaf = (0..6u32, any::<bool>()).prop_map(|(variable, value)| Expr::literal(variable, value));
    leaf.prop_recursive(4, 40, 4, |inner| {
        prop_oneof![
            proptest::collection::vec(inner.clone(), 2..4).prop_map(Expr::all),
            proptest::collection::vec(inner, 2..4).prop_map(Expr::any),
        ]
    })
}

/// Six variables with all their values.
const COLUMNS: [u64; 6] = [
    0xaaaa_aaaa_aaaa_aaaa,
    0xcccc_cccc_cccc_cccc,
    0xf0f0_f0f0_f0f0_f0f0,
    0xff00_ff00_ff00_ff00,
    0xffff_0000_ffff_0000,
    0xffff_ffff_0000_0000,
];

/// The least stack in any order of operands.
fn least_depth(expr: &Expr) -> usize {
    let (Expr::And(parts) | Expr::Or(parts)) = expr else { return 1 };
    let depths: Vec<usize> =
        parts.iter().filter(|part| !matches!(part, Expr::Literal(_))).map(least_depth).collect();
    (0..depths.len().max(1))
        .map(|first| {
            let others = depths.iter().enumerate().filter(|(i, _)| *i != first).map(|(_, depth)| depth + 1);
            others.chain(depths.get(first).copied()).max().unwrap_or(1)
        })
        .min()
        .unwrap_or(1)
}

proptest! {
    #[test]
    fn the_list_computes_the_expression(expr in expr()) {
        let list = instructions(&expr);
        let mut variables = COLUMNS.to_vec();
        prop_assert_eq!(run(&mut Words, &list, &mut variables).unwrap(), Some(table(&expr, 6)[0]));
        prop_assert_eq!(list.len(), count(&expr));
        prop_assert_eq!(stack_depth(&list), depth(&expr));
        prop_assert_eq!(depth(&expr), least_depth(&expr));
    }

    #[test]
    fn functions_are_computed_as_well(expr in expr()) {
        let mut bdd = Bdd::new();
        let mut variables: Vec<_> = (0..6).map(|variable| bdd.variable(variable).unwrap()).collect();
        let found = run(&mut bdd, &instructions(&expr), &mut variables).unwrap().unwrap();
        prop_assert_eq!(bdd.truth_table(found, &[0, 1, 2, 3, 4, 5]), table(&expr, 6));
    }
}

fn literal(variable: u32) -> Literal {
    Literal { variable, negated: false }
}

#[test]
fn coils_leave_the_top_and_the_next_rung_starts_anew() {
    use Instruction::{Out, Reset, Set, Str};
    let list = [Str(literal(0)), Set(1), Reset(2), Str(literal(3)), Out(4)];
    let mut variables = [0b1100, 0b1010, 0b1010, 0b0110, 0];
    run(&mut Words, &list, &mut variables).unwrap();
    assert_eq!(variables, [0b1100, 0b1110, 0b0010, 0b0110, 0b0110]);
    assert_eq!(stack_depth(&list), 1);
}

#[test]
fn a_list_that_takes_too_much_has_no_value() {
    let mut variables = [0; 2];
    for list in [
        vec![Instruction::And(literal(0))],
        vec![Instruction::Str(literal(0)), Instruction::AndStr],
        vec![Instruction::Set(0)],
        vec![Instruction::Str(literal(2))],
        vec![],
    ] {
        assert_eq!(run(&mut Words, &list, &mut variables), Ok(None), "{list:?}");
    }
}
