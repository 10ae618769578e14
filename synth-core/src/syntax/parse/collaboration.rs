//! Collaborations: roles and scenarios.

use syn::Token;
use syn::parse::ParseStream;

use super::reader::{Reader, Result};
use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::ast::{
    Body, Collaboration, Constraint, ConstraintKind, Expr, Message, Name, Role, Scenario, ScenarioKind,
};

/// The words that begin a role or a scenario, the older ones last.
const ITEMS: [&str; 7] =
    ["static", "dynamic", "assumption", "guarantee", "existential", "specification", "requirement"];

enum Item {
    Role(Role),
    Scenario(Scenario),
}

impl Reader {
    /// `ID { role* scenario* }`.
    pub(super) fn collaboration(&self, input: ParseStream<'_>) -> Result<Collaboration> {
        let name = self.name(input, "the name of the collaboration")?;
        // Also one whose first word is misspelt.
        let starts = |input: ParseStream<'_>| {
            input.peek(Token![#])
                || self.at_any(input, &ITEMS)
                || self.then(input, "scenario")
                || self.then(input, "role")
        };
        let scenario_seen = std::cell::Cell::new(false);
        let (items, _) = self.braces(input, "`{`, roles and scenarios", |inside| {
            Ok(self.items(inside, starts, |input| {
                let item = if self.at_any(input, &ITEMS[..2]) {
                    if scenario_seen.take() {
                        let error =
                            Diagnostic::error(Code::Syntax, self.span(input), "role behind a scenario");
                        self.report(error.help("move all roles before the first scenario"));
                    }
                    Item::Role(self.role(input)?)
                } else {
                    scenario_seen.set(self.at_scenario(input));
                    Item::Scenario(if self.at_scenario(input) || self.then(input, "scenario") {
                        self.declares_nothing(|| self.scenario(input))?
                    } else {
                        self.scenario(input)?
                    })
                };
                self.optional_separator(input);
                Ok(item)
            }))
        })?;
        let (mut roles, mut scenarios) = (Vec::new(), Vec::new());
        for item in items {
            match item {
                Item::Role(role) => roles.push(role),
                Item::Scenario(scenario) => scenarios.push(scenario),
            }
        }
        Ok(Collaboration { name, roles, scenarios })
    }

    fn role(&self, input: ParseStream<'_>) -> Result<Role> {
        let dynamic = self.eat(input, "dynamic");
        if !dynamic {
            self.keyword(input, "static")?;
        }
        self.keyword(input, "role")?;
        let class = self.name(input, "the class of the role")?;
        Ok(Role { dynamic, class, name: self.name(input, "the name of the role")? })
    }

    pub(super) fn at_scenario(&self, input: ParseStream<'_>) -> bool {
        input.peek(Token![#]) || self.at_any(input, &ITEMS[2..]) && self.then(input, "scenario")
    }

    fn scenario(&self, input: ParseStream<'_>) -> Result<Scenario> {
        let requirement = self.comment(input);
        let kind = match self.word(input).as_deref() {
            Some("assumption") => ScenarioKind::Assumption,
            Some("guarantee" | "specification" | "requirement") => ScenarioKind::Guarantee,
            Some("existential") => ScenarioKind::Existential,
            _ => {
                let what = "a role, or an assumption, guarantee or existential scenario";
                let mut error = self.expected_word(input, what, &ITEMS);
                error.help = self.stray_item(input).or(error.help);
                return Err(error);
            }
        };
        let word = self.word(input).unwrap_or_default();
        self.skip(input);
        if !self.eat(input, "scenario") {
            let mut error = self.expected(input, "`scenario`");
            error.help.get_or_insert(format!("write `{word} scenario`"));
            return Err(error);
        }
        let name = self.name(input, "the name of the scenario")?;
        let bindings = self.bindings(input)?;
        if !input.peek(syn::token::Brace) {
            self.unbraced(input);
            return Err(self.expected_word(input, "`{` and the body of the scenario", &["bindings"]));
        }
        Ok(Scenario { requirement, kind, name, bindings, body: self.body(input)? })
    }

    /// `(bindings [(ID = expr)*])?`, older `with dynamic bindings [(bind ID to expr)*]`.
    fn bindings(&self, input: ParseStream<'_>) -> Result<Vec<(Name, Expr)>> {
        if self.eat(input, "with") {
            self.keyword(input, "dynamic")?;
        } else if !self.at(input, "bindings") {
            return Ok(Vec::new());
        }
        self.keyword(input, "bindings")?;
        self.brackets(input, "`[` and bindings", |inside| {
            self.list(inside, |inside| {
                let older = self.eat(inside, "bind");
                let role = self.name(inside, "the role to bind")?;
                if older {
                    self.keyword(inside, "to")?;
                } else {
                    self.punct(inside, Token![=], "`=` and what to bind the role to")?;
                }
                Ok((role, self.expr(inside)?))
            })
        })
    }

    /// `{ fragment* } (constraints [constraint*])?`.
    pub(super) fn body(&self, input: ParseStream<'_>) -> Result<Body> {
        let (fragments, span) = self.braces(input, "`{`", |inside| {
            let mut fragments = Vec::new();
            while !inside.is_empty() {
                fragments.push(self.fragment(inside)?);
                self.eat_punct(inside, Token![;]);
            }
            Ok(fragments)
        })?;
        let constraints = if self.eat(input, "constraints") {
            if input.peek(syn::token::Brace) {
                let error = self.expected(input, "`[` and constraints");
                return Err(Box::new(error.help("write `[ … ]` instead of `{ … }`")));
            }
            self.brackets(input, "`[` and constraints", |inside| {
                self.list(inside, |inside| self.constraint(inside))
            })?
        } else if input.peek2(syn::token::Bracket)
            && let Some(help) = self.misspelt(input, &["constraints"])
        {
            return Err(Box::new(self.expected(input, "`constraints`").help(help)));
        } else {
            Vec::new()
        };
        Ok(Body { fragments, constraints, span })
    }

    fn constraint(&self, input: ParseStream<'_>) -> Result<Constraint> {
        let start = self.span(input);
        let kind = match self.word(input).as_deref() {
            Some("forbidden") => ConstraintKind::Forbidden,
            Some("ignore") => ConstraintKind::Ignore,
            Some("interrupt") => ConstraintKind::Interrupt,
            Some("consider") => ConstraintKind::Consider,
            _ => {
                let mut error = self.expected(input, "`forbidden`, `ignore`, `interrupt` or `consider`");
                if error.help.is_none() && input.peek2(Token![->]) {
                    error.help = Some("write one of them before the message".to_owned());
                }
                return Err(error);
            }
        };
        self.skip(input);
        self.older_message_keyword(input);
        let message: Message = self.message(input)?;
        let span = start.to(message.span);
        Ok(Constraint { kind, message, span })
    }
}
