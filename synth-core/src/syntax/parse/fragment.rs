//! Fragments: what stands in the body of a scenario.

use syn::Token;
use syn::parse::ParseStream;

use super::reader::{Reader, Result};
use crate::syntax::ast::{
    Argument, ArgumentKind, Case, Expr, Fragment, FragmentKind, Message, Modality, Modifier,
};

pub(super) const MODIFIERS: [&str; 6] =
    ["strict", "monitored", "eventually", "urgent", "requested", "committed"];

impl Reader {
    pub(super) fn fragment(&self, input: ParseStream<'_>) -> Result<Fragment> {
        let start = self.span(input);
        let kind = self.fragment_kind(input)?;
        Ok(Fragment { kind, span: self.since(start, input) })
    }

    fn fragment_kind(&self, input: ParseStream<'_>) -> Result<FragmentKind> {
        if input.peek(syn::token::Brace) {
            return Ok(FragmentKind::Body(self.body(input)?));
        }
        self.older_message_keyword(input);
        let Some(word) = self.word(input) else { return Err(self.expected(input, "a fragment")) };
        match word.as_str() {
            "alternative" => self.alternative(input),
            "parallel" => self.parallel(input),
            "while" => {
                self.skip(input);
                let condition = self.optional_condition(input)?;
                Ok(FragmentKind::While(condition, self.body(input)?))
            }
            "wait" => self.wait(input),
            "interrupt" | "violation" => {
                self.skip(input);
                self.eat(input, "if");
                let condition = self.condition(input)?;
                Ok(if word == "interrupt" {
                    FragmentKind::Interrupt(condition)
                } else {
                    FragmentKind::Violation(condition)
                })
            }
            "var" => self.variable(input),
            word if MODIFIERS.contains(&word) => {
                let modifier = self.modifier(input)?;
                Ok(FragmentKind::Message(modifier, self.message(input)?))
            }
            _ if input.peek2(Token![:])
                || input.peek2(Token![=]) && !input.peek2(Token![==]) && !input.peek2(Token![=>]) =>
            {
                let name = self.name(input, "the name of a variable")?;
                self.punct(input, Token![=], "`=`")?;
                Ok(FragmentKind::Assignment(name, self.expr(input)?))
            }
            "or" | "and" => {
                let (opening, other) =
                    if word == "or" { ("an `alternative`", "and") } else { ("a `parallel`", "or") };
                let error = self.expected(input, "a fragment");
                let note = format!("`{word}` continues {opening} that ends just before it");
                let help = format!("write `{other}`, or put {opening} in front");
                Err(Box::new(error.note(note).help(help)))
            }
            "scenario" | "assumption" | "guarantee" | "existential" => {
                let error = self.expected(input, "a fragment");
                Err(Box::new(error.help("close the body of the scenario before the next one begins")))
            }
            "forbidden" | "ignore" | "consider" | "constraints" => {
                let error = self.expected(input, "a fragment");
                let constraint = if word == "constraints" { "…" } else { &format!("{word} …") };
                let help = format!("move it behind a body: `{{ … }} constraints [ {constraint} ]`");
                Err(Box::new(error.help(help)))
            }
            _ => {
                if let Some(error) = self.attribute_assignment(input) {
                    return Err(error);
                }
                if let Some(help) = self.misspelt_fragment(input, &word) {
                    return Err(Box::new(self.expected(input, "a fragment").help(help)));
                }
                Ok(FragmentKind::Message(Modifier::default(), self.message(input)?))
            }
        }
    }

    /// `message` before the modifiers of a message says nothing more; before `->` or `=` it is a name.
    pub(super) fn older_message_keyword(&self, input: ParseStream<'_>) {
        if self.at(input, "message") && !input.peek2(Token![->]) && !input.peek2(Token![=]) {
            self.skip(input);
        }
    }

    fn alternative(&self, input: ParseStream<'_>) -> Result<FragmentKind> {
        let mut cases = Vec::new();
        while self.eat(input, if cases.is_empty() { "alternative" } else { "or" }) {
            let condition = self.optional_condition(input)?;
            cases.push(Case { condition, body: self.body(input)? });
        }
        Ok(FragmentKind::Alternative(cases))
    }

    fn parallel(&self, input: ParseStream<'_>) -> Result<FragmentKind> {
        let mut branches = Vec::new();
        while self.eat(input, if branches.is_empty() { "parallel" } else { "and" }) {
            branches.push(self.body(input)?);
        }
        Ok(FragmentKind::Parallel(branches))
    }

    fn wait(&self, input: ParseStream<'_>) -> Result<FragmentKind> {
        self.keyword(input, "wait")?;
        let older = self.eat(input, "until");
        let strict = self.eat(input, "strict");
        let eventually = self.eat(input, "eventually");
        if !older {
            self.eat(input, "until");
        }
        if self.at(input, "strict") {
            let error = self.expected(input, "`[` and a condition");
            return Err(Box::new(error.help("write `wait strict eventually`")));
        }
        if input.peek2(syn::token::Bracket)
            && let Some(help) = self.misspelt(input, &["until", "strict", "eventually"])
        {
            return Err(Box::new(self.expected(input, "`[` and a condition").help(help)));
        }
        Ok(FragmentKind::Wait { strict, eventually, condition: self.condition(input)? })
    }

    fn optional_condition(&self, input: ParseStream<'_>) -> Result<Option<Expr>> {
        if input.peek(syn::token::Brace) { Ok(None) } else { self.condition_or_body(input).map(Some) }
    }

    fn condition_or_body(&self, input: ParseStream<'_>) -> Result<Expr> {
        if input.peek(syn::token::Bracket) || input.peek(syn::token::Paren) {
            return self.condition(input);
        }
        let mut error = self.expected(input, "`{`, or a condition in `[ … ]`");
        if self.at(input, "if") {
            error.help = Some("remove `if`".to_owned());
        }
        Err(error)
    }

    fn condition(&self, input: ParseStream<'_>) -> Result<Expr> {
        if self.word(input).is_some() && input.peek2(Token![->]) {
            let error = self.expected(input, "`[` and a condition");
            return Err(Box::new(error.help(
                "move a constraint behind the body: `{ … } constraints [ interrupt … ]`, or write a condition \
                 in `[ … ]`",
            )));
        }
        if self.word(input).is_some() || input.peek(Token![!]) {
            let error = self.expected(input, "`[` and a condition");
            return Err(Box::new(error.help("put the condition into brackets: `[ … ]`")));
        }
        self.brackets(input, "`[` and a condition", |inside| self.expr(inside))
    }

    fn variable(&self, input: ParseStream<'_>) -> Result<FragmentKind> {
        self.keyword(input, "var")?;
        let ty = self.ty(input)?;
        if input.peek(Token![=]) || input.peek(Token![:]) {
            let error = self.expected(input, "the name of the variable");
            return Err(Box::new(error.help("write the type before the name: `var bool name = …`")));
        }
        let name = self.name(input, "the name of the variable")?;
        let value = if self.eat_punct(input, Token![=]) { Some(self.expr(input)?) } else { None };
        Ok(FragmentKind::Variable(ty, name, value))
    }

    /// `strict? (monitored? modality)?`.
    fn modifier(&self, input: ParseStream<'_>) -> Result<Modifier> {
        let strict = self.eat(input, "strict");
        let monitored = self.eat(input, "monitored");
        let modality_word = MODIFIERS.into_iter().find(|word| self.at(input, word)).unwrap_or_default();
        let modality = match self.word(input).as_deref() {
            Some("eventually") => Some(Modality::Eventually),
            Some("urgent") => Some(Modality::Urgent),
            Some("requested") => Some(Modality::Requested),
            Some("committed") => Some(Modality::Committed),
            _ if monitored => {
                let what = "`eventually`, `urgent`, `requested` or `committed`";
                let mut error = self.expected(input, what);
                let help = if self.at(input, "strict") {
                    self.order_of_modifiers(&["monitored"], input)
                } else {
                    "write one of them behind `monitored`".to_owned()
                };
                error.help.get_or_insert(help);
                return Err(error);
            }
            _ => None,
        };
        if modality.is_some() {
            self.skip(input);
        }
        if self.at(input, "wait") {
            let (words, rest) = match (strict, modality_word) {
                (true, "eventually") => ("wait strict eventually", true),
                (true, "") => ("wait strict", true),
                (false, "eventually") => ("wait eventually", true),
                _ => ("", false),
            };
            if rest && !monitored {
                let error = self.expected(input, "the sender of the message");
                return Err(Box::new(error.help(format!("write `{words} [ … ]`"))));
            }
        }
        if self.at_any(input, &MODIFIERS) {
            let taken = [(strict, "strict"), (monitored, "monitored"), (modality.is_some(), modality_word)];
            let taken: Vec<&str> = taken.into_iter().filter(|one| one.0).map(|one| one.1).collect();
            let error = self.expected(input, "the sender of the message");
            return Err(Box::new(
                error
                    .note("the order is `strict`, then `monitored`, then one of the modalities")
                    .help(self.order_of_modifiers(&taken, input)),
            ));
        }
        if input.cursor().ident().is_some_and(|(_, rest)| rest.ident().is_some())
            && let Some(help) = self.misspelt(input, &MODIFIERS)
        {
            return Err(Box::new(self.expected(input, "the sender of the message").help(help)));
        }
        Ok(Modifier { strict, monitored, modality })
    }

    /// `ID -> ID . ID (( (argument (, argument)*)? ))?`.
    pub(super) fn message(&self, input: ParseStream<'_>) -> Result<Message> {
        let sender = self.name(input, "the sender of a message")?;
        self.punct(input, Token![->], "`->` and the receiver")?;
        let receiver = self.name(input, "the receiver of the message")?;
        self.punct(input, Token![.], "`.` and the operation")?;
        let operation = self.name(input, "the operation")?;
        let mut span = sender.span.to(operation.span);
        let mut arguments = Vec::new();
        if input.peek(syn::token::Paren) {
            let parens;
            (arguments, parens) =
                self.parens(input, "`(`", |inside| self.comma_list(inside, |inside| self.argument(inside)))?;
            span = span.to(parens);
        }
        Ok(Message { sender, receiver, operation, arguments, span })
    }

    /// `* | bind to? ID | expr`.
    fn argument(&self, input: ParseStream<'_>) -> Result<Argument> {
        let start = self.span(input);
        let kind = if self.eat_punct(input, Token![*]) {
            ArgumentKind::Any
        } else if self.eat(input, "bind") {
            if self.at(input, "to") && input.cursor().ident().is_some_and(|(_, rest)| rest.ident().is_some())
            {
                self.skip(input);
            }
            ArgumentKind::Bind(self.name(input, "the variable to bind")?)
        } else if input.cursor().ident().is_some_and(|(_, rest)| rest.ident().is_some())
            && let Some(help) = self.misspelt(input, &["bind"])
        {
            return Err(Box::new(self.expected(input, "an argument").help(help)));
        } else {
            ArgumentKind::Value(self.expr(input)?)
        };
        Ok(Argument { kind, span: self.since(start, input) })
    }
}
