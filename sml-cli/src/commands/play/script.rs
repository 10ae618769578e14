//! Scripts: one event a line, and what is expected in between.

use super::dialog::{show, trouble};
use super::expect::Expectation;
use super::table::Table;
use crate::failure::{Exit, Failure};
use crate::options::Format;
use synth_core::diagnostic::{Code, Diagnostic};
use synth_core::model::Spec;
use synth_core::syntax::{FileId, Pos, Sources, Span};

/// A script that means something.
#[derive(Debug)]
pub(super) struct Script {
    sources: Sources,
    lines: Vec<(Span, Line)>,
}

#[derive(Debug)]
enum Line {
    Event(String),
    Expect(Expectation),
}

/// The word before an expectation, if a line holds one. An object of the name `expect` can send events all the same.
pub(super) fn expectation(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("expect")?;
    let is_word = rest.is_empty() || rest.starts_with(char::is_whitespace);
    (is_word && !rest.trim_start().starts_with("->")).then_some(rest)
}

impl Script {
    /// Reads a script; `path` is the name by which messages speak of it.
    ///
    /// # Errors
    /// All lines that mean nothing.
    pub(super) fn parse(path: &str, text: &str, spec: &Spec) -> Result<Self, Failure> {
        let mut sources = Sources::new();
        let file = sources.add(path, text);
        let (mut lines, mut wrong) = (Vec::new(), Vec::new());
        for (number, line) in (1..).zip(sources.text(file).lines()) {
            let text = line.trim();
            if text.is_empty() || text.starts_with('#') {
                continue;
            }
            let span = place(file, number, line);
            match expectation(text).map(|rest| Expectation::parse(rest, spec)) {
                None => lines.push((span, Line::Event(text.to_owned()))),
                Some(Ok(expectation)) => lines.push((span, Line::Expect(expectation))),
                Some(Err(why)) => wrong.push(Diagnostic::error(Code::MalformedScript, span, why)),
            }
        }
        if wrong.is_empty() {
            Ok(Script { sources, lines })
        } else {
            Err(Failure::all(Exit::Wrong, wrong, sources))
        }
    }

    /// Plays it. An expectation that does not hold is reported at the end; an event that cannot happen ends it.
    pub(super) fn play(&self, table: &mut Table<'_>, format: Format) -> Result<(), Failure> {
        let mut failed = Vec::new();
        for (span, line) in &self.lines {
            match line {
                Line::Expect(expectation) => {
                    if let Some(difference) = expectation.check(table) {
                        let diagnostic =
                            Diagnostic::error(Code::FailedExpectation, *span, "this does not hold here");
                        failed.push(diagnostic.note(difference.show()));
                    }
                }
                Line::Event(text) => {
                    let mut happened = Vec::new();
                    let result = table.give(text, &mut happened);
                    show(&happened, table, format)?;
                    if let Err(wrong) = result {
                        match trouble(wrong, text, table) {
                            (Exit::No, diagnostic) => failed.push(Diagnostic { span: *span, ..diagnostic }),
                            (exit, diagnostic) => {
                                return Err(Failure::at(exit, diagnostic, &table.loaded.sources));
                            }
                        }
                        break;
                    }
                }
            }
        }
        if failed.is_empty() { Ok(()) } else { Err(Failure::all(Exit::No, failed, self.sources.clone())) }
    }
}

/// A line without the blanks around it.
pub(in crate::commands) fn place(file: FileId, number: u32, line: &str) -> Span {
    let before = line.chars().take_while(|c| c.is_whitespace()).count() as u32;
    let length = line.trim().chars().count() as u32;
    let pos = |column| Pos { line: number, column };
    Span { file, start: pos(before + 1), end: pos(before + length + 1) }
}
