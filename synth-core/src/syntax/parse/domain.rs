//! Sections that say what there is: classes, objects, effects, ranges, channels.

use syn::Token;
use syn::parse::ParseStream;

use super::reader::{Reader, Result};
use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::Span;
use crate::syntax::ast::{
    Attribute, Channel, Class, DomainItem, Effect, Enum, EventRef, Expr, ExprKind, Name, Object, Operation,
    ParameterRanges, RangeSpan, Type, TypeKind,
};

impl Reader {
    /// `ID? { (enum | class)* }`.
    pub(super) fn domain(&self, input: ParseStream<'_>) -> Result<Vec<DomainItem>> {
        if self.word(input).is_some() {
            self.name(input, "the name of the domain")?;
        }
        let starts = |input: ParseStream<'_>| self.at_any(input, &["enum", "class", "abstract"]);
        let (items, _) = self.braces(input, "`{` and the classes of the domain", |inside| {
            Ok(self.items(inside, starts, |input| {
                let item = self.domain_item(input)?;
                self.optional_separator(input);
                Ok(item)
            }))
        })?;
        Ok(items)
    }

    fn domain_item(&self, input: ParseStream<'_>) -> Result<DomainItem> {
        match self.word(input).as_deref() {
            Some("enum") => self.enumeration(input).map(DomainItem::Enum),
            Some("class" | "abstract") => self.class(input).map(DomainItem::Class),
            _ => {
                let words = ["class", "abstract", "enum"];
                Err(self.expected_word(input, "`class`, `abstract class` or `enum`", &words))
            }
        }
    }

    fn enumeration(&self, input: ParseStream<'_>) -> Result<Enum> {
        self.keyword(input, "enum")?;
        let name = self.name(input, "the name of the enum")?;
        let (literals, _) = self.braces(input, "`{` and the literals of the enum", |inside| {
            if inside.is_empty() {
                return Err(self.expected(inside, "a literal of the enum"));
            }
            self.comma_list(inside, |inside| self.name(inside, "a literal of the enum"))
        })?;
        Ok(Enum { name, literals })
    }

    fn class(&self, input: ParseStream<'_>) -> Result<Class> {
        let is_abstract = self.eat(input, "abstract");
        self.keyword(input, "class")?;
        let name = self.name(input, "the name of the class")?;
        let base = if self.eat_punct(input, Token![:]) {
            Some(self.name(input, "the class to inherit from")?)
        } else {
            if self.at_any(input, &["extends", "inherits"]) {
                let error = self.expected(input, "`{` and the members of the class");
                return Err(Box::new(error.help("write `:` and the class to inherit from")));
            }
            None
        };
        let (mut attributes, mut operations) = (Vec::new(), Vec::new());
        self.braces(input, "`{` and the members of the class", |inside| {
            self.list(inside, |inside| {
                let name = self.member(inside, "an attribute or operation")?;
                if inside.peek(syn::token::Paren) {
                    operations.push(Operation { name, parameters: self.parameters(inside)? });
                    return Ok(());
                }
                self.punct(inside, Token![:], "`:` of an attribute or `(` of an operation")?;
                let ty = self.ty(inside)?;
                let initial =
                    if self.eat_punct(inside, Token![=]) { Some(self.literal(inside)?) } else { None };
                attributes.push(Attribute { name, ty, initial });
                Ok(())
            })
        })?;
        Ok(Class { is_abstract, name, base, attributes, operations })
    }

    /// The name of what has a type.
    fn member(&self, input: ParseStream<'_>, what: &str) -> Result<Name> {
        let name = self.name(input, what);
        let type_first = self.at(input, "bool") || input.peek(syn::LitInt);
        name.map_err(|error| {
            if type_first {
                Box::new(error.help("write the name before the type: `name: type`"))
            } else {
                error
            }
        })
    }

    fn parameters(&self, input: ParseStream<'_>) -> Result<Vec<(Name, Type)>> {
        let (parameters, _) = self.parens(input, "`(` and parameters", |inside| {
            self.comma_list(inside, |inside| {
                let name = self.member(inside, "the name of a parameter")?;
                self.punct(inside, Token![:], "`:` and the type of the parameter")?;
                Ok((name, self.ty(inside)?))
            })
        })?;
        Ok(parameters)
    }

    /// `bool | int ..= int | ID`.
    pub(super) fn ty(&self, input: ParseStream<'_>) -> Result<Type> {
        let start = self.span(input);
        if self.eat(input, "bool") {
            return Ok(Type { kind: TypeKind::Bool, span: start });
        }
        if let Some(low) = self.integer(input)? {
            if input.peek(Token![..]) && !input.peek(Token![..=]) {
                let error = self.expected(input, "`..=` and the largest value");
                return Err(Box::new(error.help("write `..=`: both ends of a type belong to it")));
            }
            self.punct(input, Token![..=], "`..=` and the largest value")?;
            let Some(high) = self.integer(input)? else {
                return Err(self.expected(input, "the largest value"));
            };
            return Ok(Type { kind: TypeKind::Int(low, high), span: self.since(start, input) });
        }
        if let Some(error) = self.word(input).and_then(|word| old_type(&word, start)) {
            return Err(Box::new(error));
        }
        let name = self.name(input, "a type: `bool`, a range such as `0..=9`, an enum or a class")?;
        Ok(Type { kind: TypeKind::Named(name.text), span: name.span })
    }

    /// `object ID : ID ({ (ID : literal ,?)* })?`.
    pub(super) fn object(&self, input: ParseStream<'_>) -> Result<Object> {
        self.keyword(input, "object")?;
        let name = self.name(input, "the name of the object")?;
        self.punct(input, Token![:], "`:` and the class of the object")?;
        let class = self.name(input, "the class of the object")?;
        let mut values = Vec::new();
        if input.peek(syn::token::Brace) {
            (values, _) = self.braces(input, "`{`", |inside| {
                self.list(inside, |inside| {
                    let attribute = self.name(inside, "the name of an attribute")?;
                    self.punct(inside, Token![:], "`:` and the initial value")?;
                    Ok((attribute, self.literal(inside)?))
                })
            })?;
        }
        Ok(Object { name, class, values })
    }

    /// `{ effect* }`.
    pub(super) fn effects(&self, input: ParseStream<'_>) -> Result<Vec<Effect>> {
        let starts = |input: ParseStream<'_>| {
            input.cursor().ident().is_some_and(|(_, rest)| {
                rest.punct().is_some_and(|(dash, rest)| {
                    dash.as_char() == '-' && rest.punct().is_some_and(|(tip, _)| tip.as_char() == '>')
                })
            })
        };
        let (effects, _) = self.braces(input, "`{` and effects", |inside| {
            Ok(self.items(inside, starts, |input| {
                let effect = self.declares_nothing(|| self.effect(input))?;
                self.optional_separator(input);
                Ok(effect)
            }))
        })?;
        Ok(effects)
    }

    fn effect(&self, input: ParseStream<'_>) -> Result<Effect> {
        let sender = self.name(input, "the sender of an effect: an object or a class")?;
        self.punct(input, Token![->], "`->` and the receiver")?;
        let receiver = self.name(input, "the receiver: an object or a class")?;
        self.punct(input, Token![.], "`.` and the operation")?;
        let operation = self.name(input, "the operation")?;
        let (parameters, _) = self.parens(input, "`(` and the names of the parameters", |inside| {
            self.comma_list(inside, |inside| self.name(inside, "the name of a parameter"))
        })?;
        let (assignments, _) = self.braces(input, "`{` and the assignments of the effect", |inside| {
            self.list(inside, |inside| {
                let path = self.path(inside, "the attribute to assign")?;
                self.punct(inside, Token![=], "`=` and the new value")?;
                Ok((path, self.expr(inside)?))
            })
        })?;
        Ok(Effect { sender, receiver, operation, parameters, assignments })
    }

    /// `- spontaneous events { eventRef* }`.
    pub(super) fn non_spontaneous(&self, input: ParseStream<'_>) -> Result<Vec<EventRef>> {
        if !self.eat_punct(input, Token![-]) {
            let error = self.expected(input, "`-` of `non-spontaneous`");
            return Err(Box::new(error.help("write `non-spontaneous events`")));
        }
        self.keyword(input, "spontaneous")?;
        self.keyword(input, "events")?;
        let (events, _) = self.braces(input, "`{` and events", |inside| {
            self.list(inside, |inside| self.listed_event(inside))
        })?;
        Ok(events)
    }

    fn event(&self, input: ParseStream<'_>) -> Result<EventRef> {
        let class = self.name(input, "an event such as `Class.operation`")?;
        self.punct(input, Token![.], "`.` and the operation")?;
        Ok(EventRef { class, operation: self.name(input, "the operation")? })
    }

    /// One of the events of a list, which have no arguments.
    fn listed_event(&self, input: ParseStream<'_>) -> Result<EventRef> {
        let event = self.event(input)?;
        if input.peek(syn::token::Paren) {
            let error = self.expected(input, "an event such as `Class.operation`");
            return Err(Box::new(error.help("remove the parentheses")));
        }
        Ok(event)
    }

    /// `ranges { range* }`.
    pub(super) fn parameter_ranges(&self, input: ParseStream<'_>) -> Result<Vec<ParameterRanges>> {
        self.keyword(input, "ranges")?;
        let (ranges, _) = self.braces(input, "`{` and the ranges of events", |inside| {
            self.list(inside, |inside| {
                let event = self.event(inside)?;
                let (parameters, _) = self.parens(inside, "`(` and the ranges of parameters", |inside| {
                    if inside.is_empty() {
                        return Err(self.expected(inside, "the name of a parameter"));
                    }
                    self.list(inside, |inside| {
                        let name = self.name(inside, "the name of a parameter")?;
                        self.punct(inside, Token![=], "`=` and the range of the parameter")?;
                        if inside.peek(syn::LitInt) {
                            let error = self.expected(inside, "`[` and the range of the parameter");
                            return Err(Box::new(error.help("put the range into brackets: `[ … ]`")));
                        }
                        let spans =
                            self.brackets(inside, "`[` and the range of the parameter", |inside| {
                                if inside.is_empty() {
                                    return Err(self.expected(inside, "a value or a range such as `0..=9`"));
                                }
                                self.list(inside, |inside| self.range_span(inside))
                            })?;
                        Ok((name, spans))
                    })
                })?;
                Ok(ParameterRanges { event, parameters })
            })
        })?;
        Ok(ranges)
    }

    fn range_span(&self, input: ParseStream<'_>) -> Result<RangeSpan> {
        let low = self.literal(input)?;
        if !input.peek(Token![..]) {
            return Ok(RangeSpan { low, high: None });
        }
        if !matches!(low.kind, ExprKind::Int(_)) {
            let error = Diagnostic::error(Code::Syntax, low.span, "only integers have a range between them");
            return Err(Box::new(error.help("list the values one by one")));
        }
        if !self.eat_punct(input, Token![..=]) {
            self.eat_punct(input, Token![..]);
        }
        let start = self.span(input);
        let Some(high) = self.integer(input)? else { return Err(self.expected(input, "the largest value")) };
        let span = self.since(start, input);
        let kind = ExprKind::Int(high);
        Ok(RangeSpan { low, high: Some(Expr { kind, span }) })
    }

    /// `{ channel* }`.
    pub(super) fn channels(&self, input: ParseStream<'_>) -> Result<Vec<Channel>> {
        let (channels, _) = self.braces(input, "`{` and channels", |inside| {
            self.list(inside, |inside| {
                let event = self.event(inside)?;
                self.keyword(inside, "over")?;
                let class = self.name(inside, "the class of the sender")?;
                self.punct(inside, Token![.], "`.` and the reference to the receiver")?;
                let reference = self.name(inside, "the reference to the receiver")?;
                Ok(Channel { event, class, reference })
            })
        })?;
        Ok(channels)
    }
}

fn old_type(word: &str, span: Span) -> Option<Diagnostic> {
    let help = match word {
        "EBoolean" => "write `bool`",
        "EInt" => "write a range of integers such as `0..=9`",
        "EString" => "declare an `enum` with the texts that can occur",
        _ => return None,
    };
    Some(Diagnostic::error(Code::OldType, span, format!("`{word}` is not a type here")).help(help))
}
