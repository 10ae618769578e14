//! Diagnostics for people: the marked source, as compilers show it.

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

use super::{Diagnostic, Severity, readable};
use crate::syntax::{FileId, Pos, Sources, Span};

/// More than this many nobody reads, and each costs a pass over its line, which may be the whole file.
const MOST_SHOWN: usize = 50;

/// The first 50 of `diagnostics` with the lines they are about, an empty line between them, and how many more there are;
/// empty if there are none.
///
/// `color` adds terminal escapes. A place outside its file is moved to the file's end; a diagnostic whose line is 0,
/// or whose file has no text, is shown without a source.
#[must_use]
pub fn render(diagnostics: &[Diagnostic], sources: &Sources, color: bool) -> String {
    let renderer = if color { Renderer::styled() } else { Renderer::plain() };
    let mut out = String::new();
    for diagnostic in diagnostics.iter().take(MOST_SHOWN) {
        if !out.is_empty() {
            out.push('\n');
        }
        let code = diagnostic.code.to_string();
        out.push_str(&renderer.render(&[group(diagnostic, &code, sources)]));
        out.push('\n');
    }
    let more = diagnostics.len().saturating_sub(MOST_SHOWN);
    if more > 0 {
        out.push_str(&format!("\n... and {more} more\n"));
    }
    out
}

fn group<'a>(diagnostic: &'a Diagnostic, code: &'a str, sources: &'a Sources) -> Group<'a> {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let mut group = Group::with_title(level.primary_title(&diagnostic.message).id(code));
    for file in files(diagnostic) {
        if let Some(snippet) = snippet(diagnostic, file, sources) {
            group = group.element(snippet);
        }
    }
    let path = sources.path(diagnostic.span.file);
    if diagnostic.span.start.line > 0 && !path.is_empty() && sources.text(diagnostic.span.file).is_empty() {
        let Pos { line, column } = diagnostic.span.start;
        group = group.element(Origin::path(path).line(line as usize).char_column(column as usize));
    }
    for note in &diagnostic.notes {
        group = group.element(Level::NOTE.message(readable(note)));
    }
    if let Some(help) = &diagnostic.help {
        group = group.element(Level::HELP.message(help));
    }
    group
}

/// The files involved, that of the diagnostic itself first.
fn files(diagnostic: &Diagnostic) -> Vec<FileId> {
    let mut files = vec![diagnostic.span.file];
    for (span, _) in &diagnostic.labels {
        if !files.contains(&span.file) {
            files.push(span.file);
        }
    }
    files
}

fn snippet<'a>(
    diagnostic: &'a Diagnostic,
    file: FileId,
    sources: &'a Sources,
) -> Option<Snippet<'a, annotate_snippets::Annotation<'a>>> {
    let text = sources.text(file);
    let shown = |span: &Span| span.file == file && span.start.line > 0;
    let mut marks = Vec::new();
    if shown(&diagnostic.span) {
        let label = Some(diagnostic.label.as_str()).filter(|label| !label.is_empty());
        marks.push(AnnotationKind::Primary.span(sources.bytes(diagnostic.span)).label(label));
    }
    for (span, label) in diagnostic.labels.iter().filter(|(span, _)| shown(span)) {
        marks.push(AnnotationKind::Context.span(sources.bytes(*span)).label(label.as_str()));
    }
    if text.is_empty() || marks.is_empty() {
        return None;
    }
    Some(Snippet::source(text).path(sources.path(file)).annotations(marks))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Code;
    use crate::syntax::Pos;

    fn span(start: (u32, u32), end: (u32, u32)) -> Span {
        let pos = |(line, column)| Pos { line, column };
        Span { file: FileId(0), start: pos(start), end: pos(end) }
    }

    fn sources(text: &str) -> Sources {
        let mut sources = Sources::new();
        sources.add("cell.sml", text);
        sources
    }

    #[test]
    fn whole_diagnostic() {
        let diagnostic = Diagnostic::error(Code::Syntax, span((2, 3), (2, 6)), "expected `b`, found `abc`")
            .label("here")
            .also(span((1, 1), (1, 2)), "begins here")
            .note("a fact")
            .help("write `b`");
        let shown = render(&[diagnostic], &sources("{\n  abc\n}\n"), false);
        let expect = "\
error[SML0004]: expected `b`, found `abc`
 --> cell.sml:2:3
  |
1 | {
  | - begins here
2 |   abc
  |   ^^^ here
  |
  = note: a fact
  = help: write `b`
";
        assert_eq!(shown, expect);
    }

    #[test]
    fn warning_in_color() {
        let diagnostic = Diagnostic::warning(Code::Syntax, span((1, 1), (1, 2)), "odd");
        let shown = render(&[diagnostic], &sources("x"), true);
        assert!(shown.contains("warning") && shown.contains("\u{1b}["), "{shown}");
    }

    #[test]
    fn any_place_can_be_shown() {
        let places = [(0, 0), (1, 0), (1, 1), (1, 3), (1, 99), (2, 1), (3, 1), (9, 9), (u32::MAX, u32::MAX)];
        for text in ["", "\n", "é€\r\nx", "a\n\n", "{\tb", "\u{feff}a"] {
            let sources = sources(text);
            for start in places {
                for end in places {
                    let diagnostic = Diagnostic::error(Code::Syntax, span(start, end), "m")
                        .also(span(end, start), "other")
                        .also(Span { file: FileId(7), ..span(start, end) }, "no such file");
                    assert!(render(&[diagnostic], &sources, false).starts_with("error[SML0004]: m"));
                }
            }
        }
    }

    #[test]
    fn many_are_cut_off() {
        let one = Diagnostic::error(Code::Syntax, span((1, 1), (1, 2)), "m");
        let shown = |count| render(&vec![one.clone(); count], &sources("x"), false);
        assert_eq!(shown(MOST_SHOWN).matches("error").count(), MOST_SHOWN);
        assert!(!shown(MOST_SHOWN).contains("more"));
        assert_eq!(shown(MOST_SHOWN + 3).matches("error").count(), MOST_SHOWN);
        assert!(shown(MOST_SHOWN + 3).ends_with("\n... and 3 more\n"));
    }

    #[test]
    fn an_empty_file_is_named() {
        let diagnostic = Diagnostic::error(Code::Syntax, span((1, 1), (1, 1)), "m");
        let shown = render(&[diagnostic], &sources(""), false);
        assert!(shown.contains("--> cell.sml"), "{shown}");
    }

    #[test]
    fn no_line_no_source() {
        let diagnostic = Diagnostic::error(Code::Syntax, Span::default(), "m").help("do");
        assert_eq!(render(&[diagnostic], &sources("x"), false), "error[SML0004]: m\n  |\n  = help: do\n");
    }
}
