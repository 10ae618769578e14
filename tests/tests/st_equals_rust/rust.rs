//! Reads a generated Rust module as tokens.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use super::super::{Component, Controller, Event, Mapping};

/// A token, or a documentation comment.
#[derive(Clone, Debug)]
enum Token {
    Word(String),
    Group(Delimiter, Vec<Token>),
    Doc(String),
}

impl Token {
    fn is(&self, word: &str) -> bool {
        matches!(self, Token::Word(text) if text == word)
    }

    fn word(&self) -> &str {
        match self {
            Token::Word(text) => text,
            other => panic!("no word: {other:?}"),
        }
    }

    fn group(&self) -> Option<&[Token]> {
        match self {
            Token::Group(_, inner) => Some(inner),
            _ => None,
        }
    }
}

/// Everything that the module of `text` says of the controller.
pub(crate) fn read(text: &str) -> Controller {
    let tokens = tokens(text.parse().expect("tokens of Rust"));
    let module = tokens.iter().find_map(|token| match token {
        Token::Group(Delimiter::Brace, inner) => Some(inner),
        _ => None,
    });
    let module = items(module.expect("a module"));
    let mut controller = Controller::default();
    let mut doc = "";
    for (at, token) in module.iter().enumerate() {
        let [_, name, ..] = &module[at..] else { break };
        match token {
            Token::Doc(text) => doc = text.trim(),
            Token::Word(word) if word == "impl" => initial(&module[at..], &mut controller),
            Token::Word(word) if word == "enum" => {
                let body = module[at + 2].group().expect("a body");
                if name.is("Event") {
                    controller.events = variants(body).map(|(text, _)| event(text)).collect();
                } else if let Some(object) = doc.strip_prefix("Commands to ") {
                    let commands = variants(body).map(|(text, code)| (text, code.expect("a code"))).collect();
                    let object = plain(object.trim_end_matches('.'));
                    controller.components.push(Component { object, commands, codes: Vec::new() });
                }
            }
            Token::Word(word) if word == "static" => {
                let end = module[at..].iter().position(|token| token.is(";")).expect("an end");
                table(doc, name.word(), &module[at..at + end], &mut controller);
            }
            _ => {}
        }
    }
    controller
}

/// The tokens of a module, and in their place those inside of macros of the runtime, which hand them on.
fn items(module: &[Token]) -> Vec<Token> {
    let mut items = Vec::with_capacity(module.len());
    for token in module {
        match token {
            Token::Group(Delimiter::Brace, inner)
                if items.last().is_some_and(|last: &Token| last.is("!")) =>
            {
                items.extend_from_slice(inner);
            }
            _ => items.push(token.clone()),
        }
    }
    items
}

fn event(text: String) -> Event {
    Event { text, mapping: Mapping::default() }
}

/// `const INITIAL: u8 = 3;`, if this is the `impl` that has it.
fn initial(tokens: &[Token], controller: &mut Controller) {
    let Some(body) = tokens.iter().find_map(Token::group) else { return };
    if let Some(at) = body.iter().position(|token| token.is("INITIAL")) {
        assert!(body[at + 1].is(":") && body[at + 3].is("="));
        controller.initial = number(body[at + 4].word());
    }
}

/// The documentation and the number, if any, of every variant.
fn variants(body: &[Token]) -> impl Iterator<Item = (String, Option<u32>)> {
    body.split(|token| token.is(",")).filter(|variant| !variant.is_empty()).map(|variant| {
        let Token::Doc(doc) = &variant[0] else { panic!("no documentation: {variant:?}") };
        let code = variant.iter().position(|token| token.is("="));
        (plain(doc), code.map(|at| number(variant[at + 1].word())))
    })
}

/// `static name: type = value`.
fn table(doc: &str, name: &str, item: &[Token], controller: &mut Controller) {
    let equals = item.iter().position(|token| token.is("=")).expect("a value");
    let (ty, value) = (&item[..equals], &item[equals + 1..]);
    if name == "ROWS" {
        let mut mappings = mappings(ty, value);
        controller.super_steps = mappings.pop().expect("super steps");
        assert_eq!(mappings.len(), controller.events.len());
        for (event, mapping) in controller.events.iter_mut().zip(mappings) {
            event.mapping = mapping;
        }
    } else if let Some(object) = doc.strip_prefix("Codes that super steps command to ") {
        let object = plain(object.trim_end_matches("; 0 is none."));
        let component = controller.components.iter_mut().find(|component| component.object == object);
        component.expect("the component of the codes").codes = numbers(ty, value);
    }
}

/// `::controller_template::Mappings { first: …, source: …, target: … }`, of columns of the types of `first` and of the others.
fn mappings(ty: &[Token], value: &[Token]) -> Vec<Mapping> {
    let fields = value.iter().find_map(Token::group).expect("fields");
    let fields: Vec<&[Token]> = fields.split(|token| token.is(",")).filter(|c| !c.is_empty()).collect();
    let [first, source, target] = fields[..] else { panic!("no three columns: {fields:?}") };
    let (first_ty, ty) = two_types(ty);
    let [first, source, target] =
        [(first_ty, first), (ty, source), (ty, target)].map(|(ty, field)| numbers(ty, field));
    assert_eq!((source.len(), first.last()), (target.len(), Some(&(source.len() as u32))));
    let rows = |rows: &[u32]| {
        let rows = rows[0] as usize..rows[1] as usize;
        Mapping { source: source[rows.clone()].to_vec(), target: target[rows].to_vec() }
    };
    first.windows(2).map(rows).collect()
}

/// The arguments of `::controller_template::Mappings<[u8; 3], [u16; 40]>`, or of two `Packed<u8, 3>`.
fn two_types(ty: &[Token]) -> (&[Token], &[Token]) {
    let is_array = |token: &Token| matches!(token, Token::Group(Delimiter::Bracket, _));
    let is_column = |token: &Token| is_array(token) || token.is("Packed");
    let second = ty.iter().rposition(is_column).expect("two columns");
    ty.split_at(second)
}

/// `[1, 2]`, or `::controller_template::Packed::new(*b"\x01\x02")` with numbers as wide as the type says.
fn numbers(ty: &[Token], value: &[Token]) -> Vec<u32> {
    let inner = value.iter().find_map(Token::group).expect("numbers");
    let (true, Some(literal)) = (inner.first().is_some_and(|star| star.is("*")), inner.get(1)) else {
        return inner.iter().filter(|token| !token.is(",")).map(|token| number(token.word())).collect();
    };
    let width = ["u8", "u16", "", "u32"].iter().position(|width| ty.iter().any(|token| token.is(width)));
    let hex = |text: &str| u32::from_str_radix(&text[..2], 16).expect("two digits");
    let bytes: Vec<u32> = literal.word().split("\\x").skip(1).map(hex).collect();
    let little_endian = |bytes: &[u32]| bytes.iter().rev().fold(0, |number, byte| number << 8 | byte);
    bytes.chunks(width.expect("a width") + 1).map(little_endian).collect()
}

fn number(text: &str) -> u32 {
    text.replace('_', "").parse().unwrap_or_else(|_| panic!("{text} is no number"))
}

/// A text in backticks.
fn plain(text: &str) -> String {
    text.trim().trim_matches('`').to_owned()
}

fn tokens(stream: TokenStream) -> Vec<Token> {
    let mut out = Vec::new();
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Punct(punct) if punct.as_char() == '#' => {
                let Some(TokenTree::Group(group)) = trees.next() else { continue };
                let attribute: Vec<TokenTree> = group.stream().into_iter().collect();
                if let [TokenTree::Ident(name), _, TokenTree::Literal(text)] = attribute.as_slice()
                    && name == "doc"
                {
                    out.push(Token::Doc(text.to_string().trim_matches('"').to_owned()));
                }
            }
            TokenTree::Group(group) => out.push(Token::Group(group.delimiter(), tokens(group.stream()))),
            other => out.push(Token::Word(other.to_string())),
        }
    }
    out
}
