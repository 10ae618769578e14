//! The instruction list of a machine with a stack of Booleans.
//!
//! | instruction | what it does |
//! |---|---|
//! | `STR x` | pushes `x` |
//! | `AND x`, `OR x` | the top becomes its conjunction or disjunction with `x` |
//! | `STR NOT x`, `AND NOT x`, `OR NOT x` | the same with the negation of `x` |
//! | `ANDSTR`, `ORSTR` | pops two and pushes their conjunction or disjunction |
//! | `SET x`, `RST x` | where the top holds, `x` becomes true or false |
//! | `OUT x` | `x` becomes the top |
//! | `STRGE a n`, `ANDLE a n` | as `STR`, `AND`, with a comparison of an analogue input with a number: ranges, at the top |
//!
//! A rung begins with an empty stack. No instruction jumps: a scan does all of them, so its time is the sum of theirs.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::{NameMap, Source, origin, rung_lines};
use crate::emit::names::Namer;
use crate::logic::{Expr, Instruction, Literal, Var};
use crate::plant::Rung;

/// Words that no name may be.
fn is_word(name: &str) -> bool {
    matches!(
        name.to_ascii_uppercase().as_str(),
        "STR" | "AND" | "OR" | "NOT" | "ANDSTR" | "ORSTR" | "SET" | "RST" | "OUT" | "STRGE" | "ANDLE"
    )
}

/// What a scan costs.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cost {
    /// All instructions, each of which is done once a scan.
    pub instructions: usize,
    /// The most Booleans on the stack.
    pub depth: usize,
    /// How many there are of each instruction, by its word.
    pub words: BTreeMap<String, usize>,
}

/// A part of the list: a range or a rung.
struct Block {
    comment: Vec<String>,
    /// Word and operand.
    lines: Vec<(String, String)>,
}

/// The whole list, ending in a newline, deterministic. Comments are in `(* *)`.
#[must_use]
pub fn text(source: &Source<'_>) -> String {
    let blocks = blocks(source);
    let cost = cost_of(&blocks);
    let mut out = String::new();
    for line in origin(source, "Instruction list of", "il") {
        comment(&mut out, &line);
    }
    comment(
        &mut out,
        &format!(
            "{} instructions, all of them done in every scan, {} rungs; at most {} on the stack.",
            cost.instructions,
            source.program.rungs.len(),
            cost.depth
        ),
    );
    let words: Vec<String> = cost.words.iter().map(|(word, count)| format!("{count} {word}")).collect();
    if !words.is_empty() {
        comment(&mut out, &format!("The time of a scan is that of {}.", words.join(", ")));
    }
    for block in &blocks {
        out.push('\n');
        block.comment.iter().for_each(|line| comment(&mut out, line));
        for (word, operand) in &block.lines {
            // Writing to a string cannot fail.
            let _ = writeln!(out, "{}", format!("{word:<6} {operand}").trim_end());
        }
    }
    out
}

/// What a scan costs.
#[must_use]
pub fn cost(source: &Source<'_>) -> Cost {
    cost_of(&blocks(source))
}

fn comment(out: &mut String, text: &str) {
    let text = text.replace("*)", "* )").replace("(*", "( *");
    let _ = writeln!(out, "(* {} *)", text.trim());
}

/// What the list calls signals; nothing else has a name in it.
#[must_use]
pub fn names(source: &Source<'_>) -> NameMap {
    let program = source.program;
    let mut namer = Namer::new(is_word).fold_case();
    NameMap {
        target: "il",
        function_block: String::new(),
        program: String::new(),
        variables: program.variables.iter().map(|variable| namer.name(&variable.name)).collect(),
        analogues: program.analogues.iter().map(|name| namer.name(name)).collect(),
        events: Vec::new(),
    }
}

fn blocks(source: &Source<'_>) -> Vec<Block> {
    let program = source.program;
    let NameMap { variables: names, analogues, .. } = names(source);
    let ranges = source.ranges().map(|(variable, analogue, low, high)| {
        let (name, analogue) = (&names[variable as usize], &analogues[analogue as usize]);
        let line = |word: &str, operand: String| (word.to_owned(), operand);
        Block {
            comment: vec![format!("Range {name}: {analogue} from {low} to {high}")],
            lines: vec![
                line("STRGE", format!("{analogue} {low}")),
                line("ANDLE", format!("{analogue} {high}")),
                line("OUT", name.clone()),
            ],
        }
    });
    let rungs = (1..).zip(&program.rungs).map(|(number, rung)| {
        let mut comment = rung_lines(source, number, rung);
        let lines = match rung.coils.first() {
            Some(coil) => {
                let rung = Rung { condition: written(&rung.condition, coil.variable), ..rung.clone() };
                rung.instructions().into_iter().map(|one| line(one, &names)).collect()
            }
            None => {
                comment.push("It commands nothing.".to_owned());
                Vec::new()
            }
        };
        Block { comment, lines }
    });
    ranges.chain(rungs).collect()
}

fn cost_of(blocks: &[Block]) -> Cost {
    let mut cost = Cost { instructions: 0, depth: 0, words: BTreeMap::new() };
    for block in blocks {
        let mut depth = 0usize;
        for (word, _) in &block.lines {
            match word.as_str() {
                "STR" | "STRGE" => depth += 1,
                "ANDSTR" | "ORSTR" => depth -= 1,
                _ => {}
            }
            cost.depth = cost.depth.max(depth);
            *cost.words.entry(word.clone()).or_default() += 1;
        }
        cost.instructions += block.lines.len();
    }
    cost
}

/// The condition without constants, which no instruction pushes: a variable and its negation tell both.
fn written(condition: &Expr, any: Var) -> Expr {
    let both = || [false, true].map(|negated| Expr::Literal(Literal { variable: any, negated })).into();
    match condition {
        Expr::Constant(false) => Expr::And(both()),
        Expr::Constant(true) => Expr::Or(both()),
        _ => condition.clone(),
    }
}

/// Word and operand.
fn line(instruction: Instruction, names: &[String]) -> (String, String) {
    let name = |variable: Var| names[variable as usize].clone();
    let (word, operand) = match instruction {
        Instruction::Str(literal) => ("STR", operand(literal, names)),
        Instruction::And(literal) => ("AND", operand(literal, names)),
        Instruction::Or(literal) => ("OR", operand(literal, names)),
        Instruction::AndStr => ("ANDSTR", String::new()),
        Instruction::OrStr => ("ORSTR", String::new()),
        Instruction::Set(variable) => ("SET", name(variable)),
        Instruction::Reset(variable) => ("RST", name(variable)),
        Instruction::Out(variable) => ("OUT", name(variable)),
    };
    (word.to_owned(), operand)
}

fn operand(literal: Literal, names: &[String]) -> String {
    let not = if literal.negated { "NOT " } else { "" };
    format!("{not}{}", names[literal.variable as usize])
}
