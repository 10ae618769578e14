//! Whatever the input, there is a tree or a diagnostic, and a picture of it.

use proptest::prelude::*;
use proptest::sample::Index;

use super::trees::shape;
use super::{corpus, parse, tree};
use crate::diagnostic::{compile_errors, render};
use crate::syntax::ast::{BinaryOp, Expr, ExprKind, FragmentKind, Name, Path, Section, UnaryOp};
use crate::syntax::{FileId, Loaded, Sources, Span, parse_tokens, print};

/// Text that is neither read nor refused in silence fails; so does a diagnostic out of order.
fn survive(text: &str) {
    let (read, errors) = parse(text);
    assert!(read.is_some() || !errors.is_empty(), "{text}");
    assert!(errors.is_sorted_by_key(|d| d.span.start), "{text}");
    let mut sources = Sources::new();
    sources.add("x.sml", text);
    assert_eq!(render(&errors, &sources, false).is_empty(), errors.is_empty());
    if errors.is_empty() {
        let read = read.expect("a tree without errors");
        assert_eq!(shape(&tree(&print(&read))), shape(&read), "{text}");
    }
    if let Ok(tokens) = text.parse::<proc_macro2::TokenStream>() {
        let (_, errors) = parse_tokens(tokens.clone(), FileId(0));
        let _ = compile_errors(&errors, &tokens, &Loaded::default());
    }
}

/// The text cut into words, numbers, spaces and single characters.
pub(crate) fn pieces(text: &str) -> Vec<String> {
    let mut pieces: Vec<String> = Vec::new();
    let mut last = None;
    for c in text.chars() {
        let kind = if c.is_alphanumeric() {
            'w'
        } else if c.is_whitespace() {
            ' '
        } else {
            c
        };
        if last == Some(kind) {
            pieces.last_mut().expect("a piece").push(c);
        } else {
            pieces.push(c.to_string());
        }
        last = Some(kind);
    }
    pieces
}

const INSERTED: [&str; 40] = [
    "{",
    "}",
    "[",
    "]",
    "(",
    ")",
    "\"",
    "'",
    "€",
    "\\",
    "/*",
    "*/",
    "//",
    "///",
    "#",
    "#[doc = \"x\"]",
    "->",
    "=>",
    "==",
    "=",
    "..=",
    "..",
    "1.",
    "0x",
    "1_0",
    "99999999999999999999",
    "r#",
    "r\"",
    "_",
    "ä",
    "\u{0}",
    "\r",
    "\n",
    "wait",
    "strict",
    "scenario",
    "or",
    "!",
    "-",
    "\u{feff}",
];

#[derive(Clone, Debug)]
pub(crate) enum Change {
    Delete(Index),
    Duplicate(Index),
    Swap(Index, Index),
    Insert(Index, usize),
    Cut(Index),
}

pub(crate) fn change() -> impl Strategy<Value = Change> {
    prop_oneof![
        any::<Index>().prop_map(Change::Delete),
        any::<Index>().prop_map(Change::Duplicate),
        any::<(Index, Index)>().prop_map(|(a, b)| Change::Swap(a, b)),
        (any::<Index>(), 0..INSERTED.len()).prop_map(|(at, what)| Change::Insert(at, what)),
        any::<Index>().prop_map(Change::Cut),
    ]
}

pub(crate) fn apply(pieces: &mut Vec<String>, change: &Change) {
    let length = pieces.len().max(1);
    if pieces.is_empty() {
        pieces.push(String::new());
    }
    match change {
        Change::Delete(at) => drop(pieces.remove(at.index(length))),
        Change::Duplicate(at) => pieces.insert(at.index(length), pieces[at.index(length)].clone()),
        Change::Swap(a, b) => pieces.swap(a.index(length), b.index(length)),
        Change::Insert(at, what) => pieces.insert(at.index(length), INSERTED[*what].to_owned()),
        Change::Cut(at) => pieces.truncate(at.index(length)),
    }
}

fn expr() -> impl Strategy<Value = Expr> {
    let e = |kind| Expr { kind, span: Span::default() };
    let name = |text: &str| Name { text: text.to_owned(), span: Span::default() };
    let leaf = prop_oneof![
        any::<bool>().prop_map(ExprKind::Bool),
        any::<i64>().prop_map(ExprKind::Int),
        Just(ExprKind::Null),
        Just(ExprKind::Literal(name("E"), name("a"))),
        (1..4usize)
            .prop_map(move |n| ExprKind::Path(Path { names: vec![name("a"); n], span: Span::default() })),
    ];
    let operators = proptest::sample::select(vec![
        BinaryOp::Implies,
        BinaryOp::Or,
        BinaryOp::And,
        BinaryOp::Eq,
        BinaryOp::Ne,
        BinaryOp::Lt,
        BinaryOp::Le,
        BinaryOp::Gt,
        BinaryOp::Ge,
        BinaryOp::Add,
        BinaryOp::Sub,
        BinaryOp::Mul,
    ]);
    leaf.prop_map(e).prop_recursive(6, 40, 2, move |inner| {
        prop_oneof![
            (any::<bool>(), inner.clone()).prop_map(move |(not, operand)| {
                e(ExprKind::Unary(if not { UnaryOp::Not } else { UnaryOp::Neg }, Box::new(operand)))
            }),
            (operators.clone(), inner.clone(), inner).prop_map(move |(op, left, right)| e(ExprKind::Binary(
                op,
                Box::new(left),
                Box::new(right)
            ))),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn changed_specifications(which in any::<Index>(), changes in prop::collection::vec(change(), 1..6)) {
        let mut corpus = corpus();
        let (_, text) = corpus.swap_remove(which.index(corpus.len()));
        let mut pieces = pieces(&text);
        for change in &changes {
            apply(&mut pieces, change);
        }
        survive(&pieces.concat());
    }

    #[test]
    fn heaps_of_pieces(pieces in prop::collection::vec(0..INSERTED.len(), 0..30)) {
        survive(&pieces.iter().map(|&piece| INSERTED[piece]).collect::<String>());
    }

    #[test]
    fn any_text(text in any::<String>()) {
        survive(&text);
    }

    #[test]
    fn expressions_round_trip(expr in expr()) {
        let mut file = tree("specification X { collaboration C { guarantee scenario S { wait [a] } } }");
        let Some(Section::Collaboration(c)) = file.sections.last_mut() else { unreachable!() };
        let FragmentKind::Wait { condition, .. } = &mut c.scenarios[0].body.fragments[0].kind else { unreachable!() };
        *condition = expr;
        let printed = print(&file);
        prop_assert_eq!(shape(&tree(&printed)), shape(&file), "{}", printed);
    }
}
