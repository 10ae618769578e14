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
use super::{FileId, Pos, Span};
use crate::diagnostic::{Code, Diagnostic};
use reader::{Reader, Result};

/// What was read of a file.
pub(super) struct Parsed {
    /// Complete if there are no errors.
    pub(super) tree: Option<File>,
    /// In the order in which they were found.
    pub(super) errors: Vec<Diagnostic>,
    /// Where a brace was due, or the file: if braces do not match, this is where they went wrong.
    pub(super) unbraced: Option<Pos>,
}

/// Reads a whole file.
pub(super) fn parse(tokens: TokenStream, file: FileId, end: Span) -> Parsed {
    let reader = Reader::new(file, end);
    let mut tree = None;
    let consumed = |input: ParseStream<'_>| {
        tree = reader.file(input);
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
        let name = self.header(input).map_err(|error| self.report(*error)).ok();
        if name.is_none() {
            self.skip_until(input, |input| input.peek(syn::token::Brace));
        }
        if input.is_empty() && name.is_none() {
            return None;
        }
        let sections = self
            .braces(input, "`{` and the sections of the specification", |inside| Ok(self.sections(inside)))
            .map_err(|error| self.report(*error))
            .ok();
        if sections.is_some() {
            self.optional_semicolon(input);
            if !input.is_empty() {
                self.unbraced(input);
                let mut error = self.expected(input, "the end of the file");
                if let Some((_, span)) = &sections {
                    let end = Pos { column: span.end.column.saturating_sub(1), ..span.end };
                    let place = Span { start: end, ..*span };
                    error.labels.push((place, "the specification ends here".to_owned()));
                }
                self.report(*error);
            }
        }
        let declares_all = self.declares_all();
        Some(File { imports, name: name?, sections: sections?.0, declares_all })
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

    fn optional_semicolon(&self, input: ParseStream<'_>) {
        self.eat_punct(input, Token![;]);
    }
}
