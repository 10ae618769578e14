//! What all rules need: looking ahead, taking tokens, saying what was expected, going on after an error.

use std::cell::{Cell, RefCell};

use proc_macro2::TokenTree;
use syn::Token;
use syn::parse::{Parse, ParseBuffer, ParseStream, Peek};
use syn::token::{Brace, Bracket, Paren};

use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::ast::Name;
use crate::syntax::{FileId, MAX_DEPTH, Pos, Span, keywords, lexis, tokens};

/// A rule's tree, or why there is none.
pub(crate) type Result<T> = std::result::Result<T, Box<Diagnostic>>;

/// The state of reading one file; the position is that of the `ParseStream` that each rule takes.
pub(crate) struct Reader {
    file: FileId,
    /// The words that cannot be names, sorted.
    reserved: &'static [&'static str],
    /// The place behind the last token.
    end: Span,
    errors: RefCell<Vec<Diagnostic>>,
    /// The closing delimiters that are still to come, innermost last.
    closing: RefCell<Vec<&'static str>>,
    /// Levels of operators; `closing` counts those of delimiters.
    depth: Cell<usize>,
    /// The first place where a brace was due.
    unbraced: Cell<Option<Pos>>,
    /// Errors that cost no declaration.
    harmless: Cell<usize>,
}

impl Reader {
    pub(crate) fn new(file: FileId, end: Span, reserved: &'static [&'static str]) -> Self {
        let (errors, closing) = (RefCell::default(), RefCell::default());
        Reader {
            file,
            reserved,
            end,
            errors,
            closing,
            depth: Cell::new(0),
            unbraced: Cell::new(None),
            harmless: Cell::new(0),
        }
    }

    pub(crate) fn into_errors(self) -> (Vec<Diagnostic>, Option<Pos>) {
        (self.errors.into_inner(), self.unbraced.get())
    }

    /// Remembers that the braces do not fit here.
    pub(crate) fn unbraced(&self, input: ParseStream<'_>) {
        self.unbraced.set(self.unbraced.get().or_else(|| Some(self.span(input).start)));
    }

    /// Runs a rule for something that declares no name that others use: what is wrong with it costs nobody else.
    pub(crate) fn declares_nothing<T>(&self, rule: impl FnOnce() -> Result<T>) -> Result<T> {
        let before = self.errors.borrow().len();
        let result = rule();
        let errors = self.errors.borrow().len() - before + usize::from(result.is_err());
        self.harmless.set(self.harmless.get() + errors);
        result
    }

    /// Whether everything that declares a name could be read so far.
    pub(crate) fn declares_all(&self) -> bool {
        self.errors.borrow().len() == self.harmless.get()
    }

    pub(crate) fn report(&self, error: Diagnostic) {
        self.errors.borrow_mut().push(error);
    }

    /// The place of the next token, or of the delimiter that closes what is being read.
    pub(crate) fn span(&self, input: ParseStream<'_>) -> Span {
        if !input.is_empty() {
            return tokens::place(input.span(), self.file);
        }
        if self.closing.borrow().is_empty() {
            return self.end;
        }
        // The compiler gives a rebuilt group no place for its closing delimiter but the group's own.
        let mut span = tokens::place(input.span(), self.file);
        span.start = span.end;
        span.start.column = span.end.column.saturating_sub(1).max(1);
        span
    }

    /// From `start` to the end of the token taken last.
    pub(crate) fn since(&self, start: Span, input: ParseStream<'_>) -> Span {
        start.to(tokens::place(input.cursor().prev_span(), self.file))
    }

    /// The next token if it is a word, keyword or not.
    pub(crate) fn word(&self, input: ParseStream<'_>) -> Option<String> {
        input.cursor().ident().map(|(word, _)| word.to_string())
    }

    pub(crate) fn is_reserved(&self, word: &str) -> bool {
        self.reserved.binary_search(&word).is_ok()
    }

    pub(crate) fn at(&self, input: ParseStream<'_>, word: &str) -> bool {
        input.cursor().ident().is_some_and(|(found, _)| found == word)
    }

    pub(crate) fn at_any(&self, input: ParseStream<'_>, words: &[&str]) -> bool {
        self.word(input).is_some_and(|found| words.contains(&found.as_str()))
    }

    /// Whether the token after the next is `word`.
    pub(crate) fn then(&self, input: ParseStream<'_>, word: &str) -> bool {
        let next = input.cursor().token_tree().and_then(|(_, rest)| rest.ident());
        next.is_some_and(|(found, _)| found == word)
    }

    /// Takes `word` if it is next.
    pub(crate) fn eat(&self, input: ParseStream<'_>, word: &str) -> bool {
        self.at(input, word) && self.skip(input)
    }

    /// Takes `token` if it is next.
    pub(crate) fn eat_punct<T: Peek>(&self, input: ParseStream<'_>, token: T) -> bool
    where
        T::Token: Parse,
    {
        input.peek(token) && input.parse::<T::Token>().is_ok()
    }

    /// Takes the keyword `word`.
    pub(crate) fn keyword(&self, input: ParseStream<'_>, word: &str) -> Result<()> {
        if self.eat(input, word) { Ok(()) } else { Err(self.expected(input, &format!("`{word}`"))) }
    }

    /// Takes `token`, described by `text` should it not come.
    pub(crate) fn punct<T: Peek>(&self, input: ParseStream<'_>, token: T, text: &str) -> Result<()>
    where
        T::Token: Parse,
    {
        if self.eat_punct(input, token) { Ok(()) } else { Err(self.expected(input, text)) }
    }

    /// Takes a name that is `what`.
    pub(crate) fn name(&self, input: ParseStream<'_>, what: &str) -> Result<Name> {
        let Some(word) = self.word(input) else { return Err(self.expected(input, what)) };
        let span = self.span(input);
        if self.is_reserved(&word) {
            let message = format!("expected {what}, found the keyword `{word}`");
            let note = format!("`{word}` is reserved and cannot be a name");
            return Err(Box::new(Diagnostic::error(Code::Reserved, span, message).note(note)));
        }
        if let Some(error) = keywords::name_error(&word, span) {
            return Err(Box::new(error));
        }
        self.skip(input);
        Ok(Name { text: word, span })
    }

    /// The error that `what` should come next.
    pub(crate) fn expected(&self, input: ParseStream<'_>, what: &str) -> Box<Diagnostic> {
        let message = format!("expected {what}, found {}", self.found(input));
        let mut span = self.span(input);
        if input.cursor().punct().is_some() {
            span.end.column = span.start.column + operator(input).len() as u32;
        }
        let mut error = Diagnostic::error(Code::Syntax, span, message);
        error.help = self.hint(input, what);
        Box::new(error)
    }

    /// The error that `what` should come next, which begins with one of `words`.
    pub(crate) fn expected_word(
        &self,
        input: ParseStream<'_>,
        what: &str,
        words: &[&str],
    ) -> Box<Diagnostic> {
        let mut error = self.expected(input, what);
        error.help = self.misspelt(input, words).or(error.help);
        error
    }

    fn found(&self, input: ParseStream<'_>) -> String {
        match input.cursor().token_tree() {
            None => match self.closing.borrow().last() {
                Some(closing) => format!("`{closing}`"),
                None => "the end of the file".to_owned(),
            },
            Some((TokenTree::Group(_), _)) if input.peek(Brace) => "`{`".to_owned(),
            Some((TokenTree::Group(_), _)) if input.peek(Bracket) => "`[`".to_owned(),
            Some((TokenTree::Group(_), _)) => "`(`".to_owned(),
            Some((TokenTree::Ident(word), _)) if self.is_reserved(&word.to_string()) => {
                format!("the keyword `{word}`")
            }
            Some((TokenTree::Punct(hash), _)) if hash.as_char() == '#' && input.peek2(Bracket) => {
                "a documentation comment".to_owned()
            }
            Some((TokenTree::Punct(_), _)) => format!("`{}`", operator(input)),
            Some((TokenTree::Literal(literal), _)) if literal.to_string().starts_with('"') => {
                "a string".to_owned()
            }
            Some((token, _)) => format!("`{token}`"),
        }
    }

    /// Takes whatever comes next; says whether there was anything.
    pub(crate) fn skip(&self, input: ParseStream<'_>) -> bool {
        let skipped = input.step(|cursor| match cursor.token_tree() {
            Some((_, rest)) => Ok(((), rest)),
            None => Err(cursor.error("end of input")),
        });
        skipped.is_ok()
    }

    pub(crate) fn skip_until(&self, input: ParseStream<'_>, found: impl Fn(ParseStream<'_>) -> bool) {
        while !input.is_empty() && !found(input) {
            self.skip(input);
        }
    }

    pub(crate) fn skip_to(&self, input: ParseStream<'_>, found: impl Fn(&str) -> bool) {
        self.skip_until(input, |input| self.word(input).is_some_and(|word| found(&word)));
    }

    /// The lines of the comment that stands here, if any.
    pub(crate) fn comment(&self, input: ParseStream<'_>) -> Vec<String> {
        let mut lines = Vec::new();
        while input.peek(Token![#]) && input.peek2(syn::token::Bracket) {
            self.skip(input);
            let attribute = input.cursor().token_tree().map(|(tree, _)| tree);
            let text = attribute.as_ref().and_then(|tree: &TokenTree| tokens::comment_text(tree));
            for line in text.iter().flat_map(|text| text.split('\n')) {
                lines.push(line.strip_prefix(' ').unwrap_or(line).trim_end().to_owned());
            }
            self.skip(input);
        }
        lines
    }

    /// Reads items to the end of `input`. After one that fails, goes on with the next that `starts`.
    pub(crate) fn items<'a, T>(
        &self,
        input: ParseStream<'a>,
        starts: impl Fn(ParseStream<'_>) -> bool,
        item: impl Fn(ParseStream<'_>) -> Result<T>,
    ) -> Vec<T> {
        let mut items = Vec::new();
        while !input.is_empty() {
            let before = input.cursor();
            match item(input) {
                Ok(item) => items.push(item),
                Err(error) => {
                    self.report(*error);
                    if input.cursor() == before {
                        self.skip(input);
                    }
                    self.skip_until(input, &starts);
                }
            }
        }
        items
    }

    /// Reads items to the end of `input`, each with an optional `,` or `;` behind it.
    pub(crate) fn list<T>(
        &self,
        input: ParseStream<'_>,
        mut item: impl FnMut(ParseStream<'_>) -> Result<T>,
    ) -> Result<Vec<T>> {
        let mut items = Vec::new();
        while !input.is_empty() {
            items.push(item(input)?);
            self.optional_separator(input);
        }
        Ok(items)
    }

    pub(crate) fn optional_separator(&self, input: ParseStream<'_>) {
        if !self.eat_punct(input, Token![,]) {
            self.eat_punct(input, Token![;]);
        }
    }

    /// Reads items to the end of `input`, with a `,` between them.
    pub(crate) fn comma_list<T>(
        &self,
        input: ParseStream<'_>,
        mut item: impl FnMut(ParseStream<'_>) -> Result<T>,
    ) -> Result<Vec<T>> {
        let mut items = Vec::new();
        while !input.is_empty() {
            items.push(item(input)?);
            if !input.is_empty() {
                let closing = self.closing.borrow().last().copied().unwrap_or_default();
                if !self.eat_punct(input, Token![,]) {
                    let error = self.expected(input, &format!("`,` or `{closing}`"));
                    return Err(self.missing_comma(input, error));
                }
            }
        }
        Ok(items)
    }

    /// Reads `{ … }`; gives its place, too.
    pub(crate) fn braces<T>(
        &self,
        input: ParseStream<'_>,
        what: &str,
        inside: impl FnOnce(ParseStream<'_>) -> Result<T>,
    ) -> Result<(T, Span)> {
        if !input.peek(Brace) {
            self.unbraced(input);
            return Err(self.expected(input, what));
        }
        self.group(input, open_braces, "}", inside)
    }

    /// Reads `[ … ]`.
    pub(crate) fn brackets<T>(
        &self,
        input: ParseStream<'_>,
        what: &str,
        inside: impl FnOnce(ParseStream<'_>) -> Result<T>,
    ) -> Result<T> {
        if !input.peek(Bracket) {
            return Err(self.expected(input, what));
        }
        Ok(self.group(input, open_brackets, "]", inside)?.0)
    }

    /// Reads `( … )`; gives its place, too.
    pub(crate) fn parens<T>(
        &self,
        input: ParseStream<'_>,
        what: &str,
        inside: impl FnOnce(ParseStream<'_>) -> Result<T>,
    ) -> Result<(T, Span)> {
        if !input.peek(Paren) {
            return Err(self.expected(input, what));
        }
        self.group(input, open_parens, ")", inside)
    }

    fn group<'a, T>(
        &self,
        input: ParseStream<'a>,
        open: fn(ParseStream<'a>) -> syn::Result<ParseBuffer<'a>>,
        closing: &'static str,
        inside: impl FnOnce(ParseStream<'_>) -> Result<T>,
    ) -> Result<(T, Span)> {
        let start = self.span(input);
        let content = open(input).map_err(|_| self.expected(input, "an opening delimiter"))?;
        let span = self.since(start, input);
        self.closing.borrow_mut().push(closing);
        let result = inside(&content).and_then(|result| {
            if content.is_empty() {
                Ok((result, span))
            } else {
                Err(self.expected(&content, &format!("`{closing}`")))
            }
        });
        self.closing.borrow_mut().pop();
        result
    }

    /// Runs `rule` one level deeper.
    ///
    /// # Errors
    ///
    /// [`Code::TooDeep`] at the next token: recursion through operators is as limited as that through delimiters.
    pub(crate) fn nested<T>(&self, input: ParseStream<'_>, rule: impl FnOnce() -> Result<T>) -> Result<T> {
        if self.depth.get() + self.closing.borrow().len() >= MAX_DEPTH {
            return Err(Box::new(lexis::too_deep(self.span(input))));
        }
        self.depth.set(self.depth.get() + 1);
        let result = rule();
        self.depth.set(self.depth.get() - 1);
        result
    }

    /// Takes an unsigned integer, as its digits.
    pub(crate) fn digits(&self, input: ParseStream<'_>) -> Result<Option<String>> {
        let Some((literal, _)) = input.cursor().literal() else { return Ok(None) };
        let text = literal.to_string();
        if !text.starts_with(|c: char| c.is_ascii_digit()) {
            return Ok(None);
        }
        if let Some(error) = keywords::number_error(&text, self.span(input)) {
            return Err(Box::new(error));
        }
        self.skip(input);
        Ok(Some(text))
    }
}

/// The operator at `input`, whole: `=>` rather than `=`.
pub(crate) fn operator(input: ParseStream<'_>) -> String {
    let mut text = String::new();
    let mut cursor = input.cursor();
    while let Some((punct, rest)) = cursor.punct() {
        text.push(punct.as_char());
        if punct.spacing() == proc_macro2::Spacing::Alone || text.len() == 3 {
            break;
        }
        cursor = rest;
    }
    text
}

fn open_braces(input: ParseStream<'_>) -> syn::Result<ParseBuffer<'_>> {
    let content;
    syn::braced!(content in input);
    Ok(content)
}

fn open_brackets(input: ParseStream<'_>) -> syn::Result<ParseBuffer<'_>> {
    let content;
    syn::bracketed!(content in input);
    Ok(content)
}

fn open_parens(input: ParseStream<'_>) -> syn::Result<ParseBuffer<'_>> {
    let content;
    syn::parenthesized!(content in input);
    Ok(content)
}
