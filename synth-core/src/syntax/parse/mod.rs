//! The grammar: recursive descent over tokens, one function a rule.
//!
//! A rule that fails returns its diagnostic; the nearest list of sections, classes, effects or scenarios around it
//! keeps the diagnostic and goes on with its next item.

mod collaboration;
mod domain;
mod expr;
mod fragment;
mod hints;
mod reader;

use proc_macro2::TokenStream;
use syn::Token;
use syn::parse::{ParseStream, Parser as _};

use super::ast::{Controllable, File, Import, Name, Section};
use super::{FileId, Pos, RESERVED, Span};
use crate::diagnostic::{Code, Diagnostic};
pub(crate) use reader::{Reader, Result, operator};

/// What was read of a file.
pub(crate) struct Parsed<T> {
    /// Complete if there are no errors.
    pub(crate) tree: Option<T>,
    /// In the order in which they were found.
    pub(crate) errors: Vec<Diagnostic>,
    /// Where a brace was due, or the file: if braces do not match, this is where they went wrong.
    pub(crate) unbraced: Option<Pos>,
}

/// Reads a whole specification.
pub(super) fn parse(tokens: TokenStream, file: FileId, end: Span) -> Parsed<File> {
    parse_all(tokens, Reader::new(file, end, RESERVED), end, Reader::file)
}

/// Reads all tokens by `rule`; `end` is the place behind them.
pub(crate) fn parse_all<T>(
    tokens: TokenStream,
    reader: Reader,
    end: Span,
    rule: impl FnOnce(&Reader, ParseStream<'_>) -> Option<T>,
) -> Parsed<T> {
    let mut tree = None;
    let consumed = |input: ParseStream<'_>| {
        tree = rule(&reader, input);
        Ok(())
    };
    let leftover = consumed.parse2(tokens).err();
    let (mut errors, unbraced) = reader.into_errors();
    // Every rule reports what it leaves behind; this only keeps a slip in one of them from going unnoticed.
    if let Some(error) = leftover.filter(|_| errors.is_empty()) {
        errors.push(Diagnostic::error(Code::Syntax, end, error.to_string()));
    }
    Parsed { tree, errors, unbraced }
}

/// The words that begin a section.
const SECTIONS: [&str; 8] =
    ["domain", "object", "effects", "controllable", "non", "parameter", "channels", "collaboration"];

impl Reader {
    fn file(&self, input: ParseStream<'_>) -> Option<File> {
        if input.is_empty() {
            let error =
                Diagnostic::error(Code::Empty, self.span(input), "the file contains no specification");
            self.report(error.help("begin with `specification Name { … }`"));
            return None;
        }
        let mut imports = Vec::new();
        while self.at(input, "import") {
            match self.import(input) {
                Ok(import) => imports.push(import),
                Err(error) => {
                    self.report(*error);
                    self.skip_to(input, |word| matches!(word, "import" | "specification" | "system"));
                }
            }
        }
        let due = "`{` and the sections of the specification";
        let (name, sections) = self.framed(
            input,
            "specification",
            due,
            |input| self.header(input),
            |inside| self.sections(inside),
        )?;
        Some(File { imports, name, sections, declares_all: self.declares_all() })
    }

    /// A name, and what stands behind it in the braces `due`, up to the end of the file; `what` is the whole.
    pub(crate) fn framed<N, T>(
        &self,
        input: ParseStream<'_>,
        what: &str,
        due: &str,
        name: impl FnOnce(ParseStream<'_>) -> Result<N>,
        inside: impl FnOnce(ParseStream<'_>) -> T,
    ) -> Option<(N, T)> {
        let name = name(input).map_err(|error| self.report(*error)).ok();
        if name.is_none() {
            self.skip_until(input, |input| input.peek(syn::token::Brace));
        }
        if input.is_empty() && name.is_none() {
            return None;
        }
        let body =
            self.braces(input, due, |content| Ok(inside(content))).map_err(|error| self.report(*error)).ok();
        if let Some((_, span)) = &body {
            self.optional_semicolon(input);
            if !input.is_empty() {
                self.unbraced(input);
                let mut error = self.expected(input, "the end of the file");
                let end = Pos { column: span.end.column.saturating_sub(1), ..span.end };
                error.labels.push((Span { start: end, ..*span }, format!("the {what} ends here")));
                self.report(*error);
            }
        }
        Some((name?, body?.0))
    }

    fn import(&self, input: ParseStream<'_>) -> Result<Import> {
        self.keyword(input, "import")?;
        let span = self.span(input);
        let literal = input.peek(syn::LitStr).then(|| input.parse::<syn::LitStr>());
        let Some(Ok(literal)) = literal else {
            return Err(self.expected(input, "the path of a file in quotes"));
        };
        if !literal.suffix().is_empty() {
            let message = format!("`{}` behind the path belongs to nothing", literal.suffix());
            return Err(Diagnostic::error(Code::Syntax, span, message).into());
        }
        self.optional_semicolon(input);
        Ok(Import { path: literal.value(), span })
    }

    fn header(&self, input: ParseStream<'_>) -> Result<Name> {
        self.eat(input, "system");
        if !self.at(input, "specification") {
            let mut error =
                self.expected_word(input, "`specification`", &["specification", "import", "system"]);
            error.help.get_or_insert_with(|| "begin with `specification Name { … }`".to_owned());
            return Err(error);
        }
        self.keyword(input, "specification")?;
        self.name(input, "the name of the specification")
    }

    fn sections(&self, input: ParseStream<'_>) -> Vec<Section> {
        let starts = |input: ParseStream<'_>| self.at_any(input, &SECTIONS);
        self.items(input, starts, |input| {
            let section = self.section(input)?;
            self.optional_semicolon(input);
            Ok(section)
        })
    }

    fn section(&self, input: ParseStream<'_>) -> Result<Section> {
        let start = self.span(input);
        let Some(word) = self.word(input).filter(|word| SECTIONS.contains(&word.as_str())) else {
            return Err(self.no_section(input));
        };
        if word == "object" {
            return self.object(input).map(Section::Object);
        }
        self.keyword(input, &word)?;
        Ok(match word.as_str() {
            "domain" => Section::Domain(self.domain(input)?),
            "effects" => Section::Effects(self.effects(input)?),
            "controllable" => {
                let (classes, _) = self.braces(input, "`{` and the names of classes", |inside| {
                    self.list(inside, |inside| self.name(inside, "the name of a class"))
                })?;
                Section::Controllable(Controllable { keyword: start, classes })
            }
            "non" => Section::NonSpontaneous(self.declares_nothing(|| self.non_spontaneous(input))?),
            "parameter" => Section::ParameterRanges(self.declares_nothing(|| self.parameter_ranges(input))?),
            "channels" => Section::Channels(self.declares_nothing(|| self.channels(input))?),
            _ => Section::Collaboration(self.collaboration(input)?),
        })
    }

    fn no_section(&self, input: ParseStream<'_>) -> Box<Diagnostic> {
        let error = self.expected(input, "a section");
        if self.at_scenario(input) {
            return Box::new(error.help("put scenarios into `collaboration Name { … }`"));
        }
        if self.at_any(input, &["class", "enum", "abstract"]) {
            return Box::new(error.help("put classes and enums into `domain Name { … }`"));
        }
        if self.at_any(input, &["static", "dynamic"]) {
            return Box::new(error.help("put roles into `collaboration Name { … }`"));
        }
        if let Some(help) = self.stray_item(input).or_else(|| self.misspelt_section(input)) {
            return Box::new(error.help(help));
        }
        Box::new(error.note(
            "sections are `domain`, `object`, `effects`, `controllable`, `non-spontaneous events`, \
             `parameter ranges`, `channels` and `collaboration`",
        ))
    }

    pub(crate) fn optional_semicolon(&self, input: ParseStream<'_>) {
        self.eat_punct(input, Token![;]);
    }
}
