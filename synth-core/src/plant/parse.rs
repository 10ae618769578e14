//! The grammar of plants: one function a rule, by the same reader as that of specifications.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::Token;
use syn::parse::ParseStream;

use super::ast::{Automaton, Command, Constraint, Edge, Event, File, Item, Range, Rule, Signals, State};
use super::{Condition, SignalKind};
use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::ast::{Name, Path};
use crate::syntax::parse::{Parsed, Reader, Result, parse_all};
use crate::syntax::{FileId, Grammar, Read, Span, read_text, read_tokens};

/// The words that begin an item.
const ITEMS: [&str; 8] =
    ["input", "output", "memory", "range", "controllable", "uncontrollable", "automaton", "constraint"];

/// The words that begin a state.
const STATES: [&str; 3] = ["state", "initial", "marked"];

/// Words that cannot be names, sorted: those that begin an item, and two that are constants everywhere else.
///
/// All others (`state`, `initial`, `set`, `reset`, `never`, …) are told from names by their place.
pub const RESERVED: &[&str] = &[
    "automaton",
    "constraint",
    "controllable",
    "false",
    "input",
    "memory",
    "output",
    "range",
    "true",
    "uncontrollable",
];

const PLANT: Grammar<File> = Grammar {
    keeps: documents,
    parse: |tokens, file, end| parse_all(tokens, Reader::new(file, end, RESERVED), end, Reader::plant),
};

/// Reads the text of a file.
///
/// The tree holds all that could be read; it is complete if there is no diagnostic, and `None` if not even the plant's
/// name could be found. Diagnostics come in the order of their places. A byte order mark is skipped.
#[must_use]
pub fn parse_text(text: &str, file: FileId) -> (Option<File>, Vec<Diagnostic>) {
    let Read { mut tree, errors, hidden } = read_text(text, file, &PLANT);
    if let Some(tree) = &mut tree {
        tree.declares_all &= !hidden;
    }
    (tree, errors)
}

/// Reads the tokens of a macro; places are those of the tokens in the file that invokes it.
///
/// Returns the same as [`parse_text`].
#[must_use]
pub fn parse_tokens(tokens: TokenStream, file: FileId) -> (Option<File>, Vec<Diagnostic>) {
    let Parsed { tree, errors, .. } = read_tokens(tokens, file, None, &PLANT);
    (tree, errors)
}

/// Whether a comment stands above an item, a state, or a name in a list of signals.
fn documents(before: Option<&TokenTree>, trees: &[TokenTree]) -> bool {
    let Some(TokenTree::Ident(word)) = trees.first() else { return false };
    let listed = match before {
        Some(TokenTree::Punct(comma)) => comma.as_char() == ',',
        Some(TokenTree::Ident(kind)) => ITEMS[..3].iter().any(|word| kind == word),
        _ => false,
    };
    // In the middle of an item these words are names, which no name follows.
    let follows = match trees.get(1) {
        Some(TokenTree::Ident(_)) => true,
        Some(TokenTree::Punct(comment)) => comment.as_char() == '#',
        _ => false,
    };
    listed || word == "plant" || follows && ITEMS.iter().chain(&STATES).any(|item| word == item)
}

impl Reader {
    fn plant(&self, input: ParseStream<'_>) -> Option<File> {
        if input.is_empty() {
            let error = Diagnostic::error(Code::Empty, self.span(input), "the file contains no plant");
            self.report(error.help("begin with `plant Name { … }`"));
            return None;
        }
        let doc = self.comment(input);
        let header = |input: ParseStream<'_>| self.plant_header(input);
        let due = "`{` and what the plant consists of";
        let (name, items) = self.framed(input, "plant", due, header, |inside| self.plant_items(inside))?;
        Some(File { doc, name, items, declares_all: self.declares_all() })
    }

    fn plant_header(&self, input: ParseStream<'_>) -> Result<Name> {
        if !self.at(input, "plant") {
            let mut error = self.expected_word(input, "`plant`", &["plant"]);
            error.help.get_or_insert_with(|| "begin with `plant Name { … }`".to_owned());
            return Err(error);
        }
        self.skip(input);
        self.name(input, "the name of the plant")
    }

    fn plant_items(&self, input: ParseStream<'_>) -> Vec<Item> {
        let starts = |input: ParseStream<'_>| self.at_documented(input, &ITEMS);
        self.items(input, starts, |input| {
            let item = self.plant_item(input)?;
            self.optional_separator(input);
            Ok(item)
        })
    }

    /// Whether one of `words` comes next, behind the comment above it.
    fn at_documented(&self, input: ParseStream<'_>, words: &[&str]) -> bool {
        if !input.peek(Token![#]) {
            return self.at_any(input, words);
        }
        let ahead = input.fork();
        self.comment(&ahead);
        self.at_any(&ahead, words)
    }

    fn plant_item(&self, input: ParseStream<'_>) -> Result<Item> {
        let doc = self.comment(input);
        let Some(word) = self.word(input).filter(|word| ITEMS.contains(&word.as_str())) else {
            return Err(self.no_item(input));
        };
        self.skip(input);
        Ok(match word.as_str() {
            "input" => Item::Signals(self.signals(input, doc, SignalKind::Input, "the name of an input")?),
            "output" => {
                Item::Signals(self.signals(input, doc, SignalKind::Output, "the name of an output")?)
            }
            "memory" => {
                Item::Signals(self.signals(input, doc, SignalKind::Memory, "the name of a memory bit")?)
            }
            "range" => Item::Range(self.range_of_analogue(input, doc)?),
            "automaton" => Item::Component(self.automaton(input, doc)?),
            "constraint" if self.eat(input, "automaton") => {
                Item::ConstraintAutomaton(self.automaton(input, doc)?)
            }
            "constraint" => Item::Constraint(self.declares_nothing(|| self.rule(input, doc))?),
            word => Item::Event(self.plant_event(input, doc, word == "controllable")?),
        })
    }

    fn no_item(&self, input: ParseStream<'_>) -> Box<Diagnostic> {
        let what = "an input, an output, an event, an automaton or a constraint";
        let mut error = self.expected_word(input, what, &ITEMS);
        if error.help.is_none() && self.at_any(input, &STATES) {
            error.help = Some("put states into `automaton Name { … }`".to_owned());
        }
        if error.help.is_none() && self.at_any(input, &["event", "events"]) {
            error.help = Some("write `controllable` or `uncontrollable`".to_owned());
        }
        if error.help.is_some() {
            return error;
        }
        Box::new(error.note(
            "items begin with `input`, `output`, `memory`, `range`, `controllable`, `uncontrollable`, `automaton` or \
             `constraint`",
        ))
    }

    /// `ID ("," ID)*`.
    fn signals(
        &self,
        input: ParseStream<'_>,
        doc: Vec<String>,
        kind: SignalKind,
        what: &str,
    ) -> Result<Signals> {
        let mut names = vec![(self.comment(input), self.name(input, what)?)];
        while self.eat_punct(input, Token![,]) && !input.is_empty() && !self.at_documented(input, &ITEMS) {
            names.push((self.comment(input), self.name(input, what)?));
        }
        if self.word(input).is_some_and(|word| !self.is_reserved(&word)) {
            let error = self.expected(input, "`,` or the next declaration");
            return Err(match self.misspelt(input, &ITEMS) {
                Some(help) => Box::new(error.help(help)),
                None => self.missing_comma(input, error),
            });
        }
        Ok(Signals { doc, kind, names })
    }

    /// `ID = ID in INT..=INT`.
    fn range_of_analogue(&self, input: ParseStream<'_>, doc: Vec<String>) -> Result<Range> {
        let name = self.name(input, "the name of the range")?;
        self.punct(input, Token![=], "`=` and an analogue input")?;
        let analogue = self.name(input, "the name of an analogue input")?;
        self.keyword(input, "in")?;
        let start = self.span(input);
        let Some(low) = self.integer(input)? else {
            return Err(self.expected(input, "the least value of the range"));
        };
        if input.peek(Token![..]) && !input.peek(Token![..=]) {
            let error = self.expected(input, "`..=` and the greatest value");
            return Err(Box::new(error.help("write `..=`: both ends of a range belong to it")));
        }
        self.punct(input, Token![..=], "`..=` and the greatest value")?;
        let Some(high) = self.integer(input)? else {
            return Err(self.expected(input, "the greatest value of the range"));
        };
        Ok(Range { doc, name, analogue, low, high, span: self.since(start, input) })
    }

    /// `ID ({ ((set | reset) ID)* })?`.
    fn plant_event(&self, input: ParseStream<'_>, doc: Vec<String>, controllable: bool) -> Result<Event> {
        let name = self.name(input, "the name of the event")?;
        if name.text == "event" && self.word(input).is_some_and(|word| !self.is_reserved(&word)) {
            let error = Diagnostic::error(Code::Syntax, name.span, "`event` is no part of a declaration");
            return Err(Box::new(error.help("remove it")));
        }
        let mut commands = Vec::new();
        if input.peek(syn::token::Brace) {
            let starts = |input: ParseStream<'_>| self.at_any(input, &["set", "reset"]);
            (commands, _) = self.braces(input, "`{`", |inside| {
                Ok(self.items(inside, starts, |input| {
                    let command = self.declares_nothing(|| self.command(input))?;
                    self.optional_separator(input);
                    Ok(command)
                }))
            })?;
        }
        Ok(Event { doc, controllable, name, commands })
    }

    fn command(&self, input: ParseStream<'_>) -> Result<Command> {
        let start = self.span(input);
        let set = self.at(input, "set");
        if !set && !self.at(input, "reset") {
            let mut error = self.expected_word(input, "`set` or `reset`", &["set", "reset"]);
            let word = self.word(input).filter(|word| error.help.is_none() && !self.is_reserved(word));
            if let Some(word) = word {
                error.help = Some(format!("write `set {word}` or `reset {word}`"));
            }
            return Err(error);
        }
        self.skip(input);
        let what = if set { "the output or memory bit to set" } else { "the output or memory bit to reset" };
        let signal = self.name(input, what)?;
        let span = start.to(signal.span);
        Ok(Command { set, signal, span })
    }

    /// `ID { state* }`.
    fn automaton(&self, input: ParseStream<'_>, doc: Vec<String>) -> Result<Automaton> {
        let name = self.name(input, "the name of the automaton")?;
        let starts = |input: ParseStream<'_>| self.at_documented(input, &STATES);
        let (states, _) = self.braces(input, "`{` and the states of the automaton", |inside| {
            Ok(self.items(inside, starts, |input| {
                let state = self.state(input)?;
                self.optional_separator(input);
                Ok(state)
            }))
        })?;
        Ok(Automaton { doc, name, states })
    }

    /// `initial? marked? state ID ([ condition ])? ({ edge* })?`.
    fn state(&self, input: ParseStream<'_>) -> Result<State> {
        let doc = self.comment(input);
        let start = self.span(input);
        let initial = self.eat(input, "initial").then_some(start);
        let marked = self.eat(input, "marked");
        if !self.at(input, "state") {
            let mut error = self.expected_word(input, "`state`", &STATES);
            if marked && self.at(input, "initial") {
                error.help = Some("write `initial marked state`".to_owned());
            }
            return Err(error);
        }
        self.skip(input);
        let name = self.name(input, "the name of the state")?;
        if input.peek(syn::token::Paren) {
            return Err(self.expected(input, "`[` and what inputs and outputs are in the state"));
        }
        let mut formula = None;
        if input.peek(syn::token::Bracket) {
            let condition = self.declares_nothing(|| {
                self.brackets(input, "`[`", |inside| self.disjunction(inside, "an input or output"))
            });
            formula = condition.map_err(|error| self.report(*error)).ok();
        }
        let edges = if input.peek(syn::token::Brace) { self.edges(input)? } else { Vec::new() };
        Ok(State { doc, initial, marked, name, formula, edges })
    }

    /// `{ (ID -> ID)* }`.
    fn edges(&self, input: ParseStream<'_>) -> Result<Vec<Edge>> {
        let starts = |input: ParseStream<'_>| self.word(input).is_some() && input.peek2(Token![->]);
        let (edges, _) = self.braces(input, "`{`", |inside| {
            Ok(self.items(inside, starts, |input| {
                let edge = self.declares_nothing(|| self.edge(input))?;
                self.optional_separator(input);
                Ok(edge)
            }))
        })?;
        Ok(edges)
    }

    fn edge(&self, input: ParseStream<'_>) -> Result<Edge> {
        let event = self.name(input, "an event")?;
        self.punct(input, Token![->], "`->` and the next state").map_err(|error| {
            let dot = input.peek(Token![.]);
            if dot { Box::new(error.help("write `->` instead of `.`")) } else { error }
        })?;
        Ok(Edge { event, target: self.name(input, "the next state")? })
    }

    /// `ID: ID only when condition | ID: ID not when condition | ID: never condition`.
    fn rule(&self, input: ParseStream<'_>, doc: Vec<String>) -> Result<Constraint> {
        const STATE: &str = "a state such as `Boom.Left`";
        let name = self.name(input, "the name of the constraint")?;
        self.punct(input, Token![:], "`:` and what the constraint says")?;
        let ahead = input.fork();
        let never = self.eat(&ahead, "never");
        // An event may have that name.
        if never && !((self.eat(&ahead, "only") || self.eat(&ahead, "not")) && self.at(&ahead, "when")) {
            self.skip(input);
            let condition = self.disjunction(input, STATE)?;
            return Ok(Constraint { doc, name, rule: Rule::Never(condition) });
        }
        let event = self.name(input, "an event or `never`")?;
        let only = self.at(input, "only");
        if !only && !self.at(input, "not") {
            let mut error = self.expected_word(input, "`only when` or `not when`", &["only", "not"]);
            if self.at(input, "when") {
                error.help = Some("write `only when` or `not when`".to_owned());
            }
            return Err(error);
        }
        self.skip(input);
        self.keyword(input, "when")?;
        let condition = self.disjunction(input, STATE)?;
        let rule = if only { Rule::Only(event, condition) } else { Rule::Not(event, condition) };
        Ok(Constraint { doc, name, rule })
    }

    /// `all ("||" all)*`; `what` its atoms are.
    fn disjunction(&self, input: ParseStream<'_>, what: &str) -> Result<Condition<Path>> {
        let mut parts = vec![self.conjunction(input, what)?];
        while self.eat_punct(input, Token![||]) {
            parts.push(self.conjunction(input, what)?);
        }
        if let Some(error) = self.foreign_connective(input) {
            return Err(error);
        }
        Ok(joined(parts, Condition::Or))
    }

    /// `operand ("&&" operand)*`.
    fn conjunction(&self, input: ParseStream<'_>, what: &str) -> Result<Condition<Path>> {
        let mut parts = vec![self.operand(input, what)?];
        while self.eat_punct(input, Token![&&]) {
            parts.push(self.operand(input, what)?);
        }
        Ok(joined(parts, Condition::And))
    }

    /// `"!" operand | "(" condition ")" | ID ("." ID)?`.
    fn operand(&self, input: ParseStream<'_>, what: &str) -> Result<Condition<Path>> {
        if input.peek(Token![!]) && !input.peek(Token![!=]) {
            self.skip(input);
            let inner = self.nested(input, || self.operand(input, what))?;
            return Ok(Condition::Not(Box::new(inner)));
        }
        if input.peek(syn::token::Paren) {
            return Ok(self.parens(input, "`(`", |inside| self.disjunction(inside, what))?.0);
        }
        if let Some(not) = self.word(input).filter(|word| matches!(word.as_str(), "not" | "NOT"))
            && self.before_operand(input)
        {
            return Err(self.no_connective(input, &not, "write `!` instead"));
        }
        if self.at_any(input, &["true", "false"]) {
            let error = self.expected(input, what);
            return Err(Box::new(error.help("leave it out: a condition is about names alone")));
        }
        let first = self.name(input, what)?;
        let mut path = Path { span: first.span, names: vec![first] };
        if self.eat_punct(input, Token![.]) {
            let state = self.name(input, "the name of a state")?;
            path.span = path.span.to(state.span);
            path.names.push(state);
        }
        Ok(Condition::Atom(path))
    }

    /// Whether an operand begins behind the next token, where none could stand if that were a name.
    fn before_operand(&self, input: ParseStream<'_>) -> bool {
        let next = input.cursor().token_tree().and_then(|(_, rest)| rest.token_tree());
        match next {
            Some((TokenTree::Ident(word), _)) => !self.is_reserved(&word.to_string()),
            Some((TokenTree::Group(group), _)) => group.delimiter() == Delimiter::Parenthesis,
            Some((TokenTree::Punct(punct), _)) => punct.as_char() == '!',
            _ => false,
        }
    }

    /// The error that an operand is followed by an operator of another language.
    fn foreign_connective(&self, input: ParseStream<'_>) -> Option<Box<Diagnostic>> {
        if let Some(word) = self.word(input).filter(|_| self.before_operand(input)) {
            let help = match word.as_str() {
                "and" | "AND" => "write `&&` instead",
                "or" | "OR" => "write `||` instead",
                "xor" | "XOR" => "write `a && !b || !a && b` instead",
                _ => return None,
            };
            return Some(self.no_connective(input, &word, help));
        }
        input.cursor().punct()?;
        let found = crate::syntax::parse::operator(input);
        let help = match found.as_str() {
            "&" | "*" => "write `&&` instead",
            "|" | "+" => "write `||` instead",
            "=" | "==" | "!=" | "<>" | "===" => "write the name alone, or `!` before it: it is a Boolean",
            "<" | "<=" | ">" | ">=" => "declare a `range` of the analogue input, and write its name",
            "=>" | "->" => "write `!a || b` instead",
            _ => return None,
        };
        Some(self.no_connective(input, &found, help))
    }

    fn no_connective(&self, input: ParseStream<'_>, found: &str, help: &str) -> Box<Diagnostic> {
        let mut span: Span = self.span(input);
        span.end.column = span.start.column + found.len() as u32;
        let error = Diagnostic::error(Code::Syntax, span, format!("`{found}` is no operator of conditions"));
        Box::new(error.help(help))
    }
}

/// One part alone, or several joined.
fn joined(
    mut parts: Vec<Condition<Path>>,
    join: fn(Vec<Condition<Path>>) -> Condition<Path>,
) -> Condition<Path> {
    match parts.len() {
        1 => parts.remove(0),
        _ => join(parts),
    }
}
