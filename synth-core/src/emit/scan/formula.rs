//! Expressions as text.

use crate::logic::{Expr, Var};
use crate::plant::Condition;

/// Terms of no more bytes stay on a line.
const TOGETHER: usize = 80;

/// How a language writes expressions; conjunction binds tighter than disjunction in all of them.
pub(crate) struct Notation {
    not: &'static str,
    and: &'static str,
    or: &'static str,
    constants: [&'static str; 2],
}

/// That of plants, and of Rust.
pub(crate) static PLANT: Notation = Notation { not: "!", and: "&&", or: "||", constants: ["false", "true"] };

/// That of Structured Text.
pub(in crate::emit) static STRUCTURED: Notation =
    Notation { not: "NOT ", and: "AND", or: "OR", constants: ["FALSE", "TRUE"] };

impl Notation {
    /// The expression on one line.
    pub(crate) fn text(&self, expr: &Expr, name: &dyn Fn(Var) -> String) -> String {
        self.parts(expr, name).join(" ")
    }

    /// The expression in pieces: a line may end between any two of them, a space joins them.
    pub(in crate::emit) fn parts(&self, expr: &Expr, name: &dyn Fn(Var) -> String) -> Vec<String> {
        let mut parts = Vec::new();
        self.push(expr, name, &mut parts, "");
        parts
    }

    /// A condition on one line.
    pub(in crate::emit) fn condition<A>(&self, of: &Condition<A>, name: &dyn Fn(&A) -> String) -> String {
        let join = |parts: &[Condition<A>], operator: &str, inner: fn(&Condition<A>) -> bool| {
            let part = |part: &Condition<A>| {
                let text = self.condition(part, name);
                if inner(part) { format!("({text})") } else { text }
            };
            parts.iter().map(part).collect::<Vec<_>>().join(&format!(" {operator} "))
        };
        match of {
            Condition::Atom(atom) => name(atom),
            Condition::Not(inner) => {
                let text = self.condition(inner, name);
                let is_compound = matches!(**inner, Condition::And(_) | Condition::Or(_));
                if is_compound { format!("{}({text})", self.not) } else { format!("{}{text}", self.not) }
            }
            Condition::And(all) => join(all, self.and, |part| matches!(part, Condition::Or(_))),
            Condition::Or(any) => join(any, self.or, |_| false),
        }
    }

    /// `before` stands before the first piece: an operator with a space, parentheses.
    fn push(&self, expr: &Expr, name: &dyn Fn(Var) -> String, parts: &mut Vec<String>, before: &str) {
        match expr {
            Expr::Constant(value) => parts.push(format!("{before}{}", self.constants[usize::from(*value)])),
            Expr::Literal(literal) => {
                let not = if literal.negated { self.not } else { "" };
                parts.push(format!("{before}{not}{}", name(literal.variable)));
            }
            Expr::And(all) => self.join(all, self.and, name, parts, before),
            Expr::Or(any) => self.join(any, self.or, name, parts, before),
        }
    }

    fn join(
        &self,
        terms: &[Expr],
        operator: &str,
        name: &dyn Fn(Var) -> String,
        parts: &mut Vec<String>,
        before: &str,
    ) {
        for (index, term) in terms.iter().enumerate() {
            let before = if index == 0 { before.to_owned() } else { format!("{operator} ") };
            let first = parts.len();
            if matches!(term, Expr::Or(_)) {
                self.push(term, name, parts, &format!("{before}("));
                if let Some(last) = parts.last_mut() {
                    last.push(')');
                }
            } else {
                self.push(term, name, parts, &before);
            }
            if parts[first..].iter().map(|part| part.len() + 1).sum::<usize>() <= TOGETHER {
                let term = parts.drain(first..).collect::<Vec<_>>().join(" ");
                parts.push(term);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::logic::Literal;

    fn literal(variable: Var, negated: bool) -> Expr {
        Expr::Literal(Literal { variable, negated })
    }

    #[track_caller]
    fn check(notation: &Notation, expr: &Expr, expect: &[&str]) {
        assert_eq!(notation.parts(expr, &|variable| format!("x{variable}")), expect);
    }

    #[test]
    fn parentheses_stand_where_they_must() {
        let either = Expr::Or(vec![literal(1, true), literal(2, false)]);
        let both = Expr::And(vec![either.clone(), literal(0, false), either.clone()]);
        check(&PLANT, &both, &["(!x1 || x2)", "&& x0", "&& (!x1 || x2)"]);
        check(&STRUCTURED, &both, &["(NOT x1 OR x2)", "AND x0", "AND (NOT x1 OR x2)"]);
        check(
            &PLANT,
            &Expr::Or(vec![both, literal(3, false)]),
            &["(!x1 || x2) && x0 && (!x1 || x2)", "|| x3"],
        );
        check(&PLANT, &either, &["!x1", "|| x2"]);
    }

    #[test]
    fn long_terms_are_broken() {
        let many = |variables: std::ops::Range<Var>| variables.map(|x| literal(x, true)).collect();
        let long = Expr::And(vec![Expr::Or(many(10..30)), literal(0, false)]);
        let parts = STRUCTURED.parts(&long, &|variable| format!("x{variable}"));
        assert_eq!((parts.len(), parts[0].as_str(), parts[20].as_str()), (21, "(NOT x10", "AND x0"));
        assert_eq!(STRUCTURED.text(&long, &|variable| format!("x{variable}")), parts.join(" "));
    }

    #[test]
    fn constants_are_words() {
        check(&PLANT, &Expr::Constant(true), &["true"]);
        check(&STRUCTURED, &Expr::Constant(false), &["FALSE"]);
    }
}
