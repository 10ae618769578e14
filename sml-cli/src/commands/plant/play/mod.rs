//! `sml play` of a plant: its closed loop, event by event, and why the feedback inhibits what it inhibits.

mod expect;
mod position;
mod view;

use crate::commands::play::place;
use crate::failure::{Exit, Failure};
use crate::input::Given;
use crate::options::Format;
use crate::session::{ReadPlant, Session};
use crate::{input, output};
use expect::Expectation;
use position::{Position, Verdict};
use std::io::{BufRead, IsTerminal as _};
use std::path::Path;
use synth_core::diagnostic::{Code, Diagnostic};
use synth_core::plant::{EventId, Plant};
use synth_core::syntax::{Sources, Span};

const HELP: &str = "  NUMBER          the event with this number
  EVENT           an event by its name
  back [N]        take the last N events back
  save FILE       write the events as a script; `save! FILE` also over a file
  state           the states of the automata, what can happen, and what is inhibited
  why EVENT       why an event can happen or cannot
  expect ...      check something: `enabled`, `inhibited`, `only` with events between `;`, `state Automaton.State`
  help            this
  quit            the end
";

enum Line<'l> {
    Event(EventId),
    Number(usize),
    Back(usize),
    Save { path: &'l str, replace: bool },
    State,
    Why(EventId),
    Expect(Expectation),
    Help,
    Quit,
}

impl<'l> Line<'l> {
    /// What a line says; a name of an event is one even if a command has it, too.
    fn parse(line: &'l str, plant: &Plant) -> Result<Self, String> {
        if let Some(event) = event(line, plant) {
            return Ok(Line::Event(event));
        }
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim();
        let path = || if rest.is_empty() { Err(format!("`{word}` needs a file")) } else { Ok(rest) };
        Ok(match word {
            "back" if rest.is_empty() => Line::Back(1),
            "back" => Line::Back(rest.parse().map_err(|_| format!("`{rest}` is no number of events"))?),
            "save" => Line::Save { path: path()?, replace: false },
            "save!" => Line::Save { path: path()?, replace: true },
            "why" => Line::Why(known(rest, plant)?),
            "expect" => Line::Expect(Expectation::parse(rest, plant)?),
            "state" if rest.is_empty() => Line::State,
            "help" if rest.is_empty() => Line::Help,
            "quit" if rest.is_empty() => Line::Quit,
            _ => Line::Number(line.parse().map_err(|_| unknown(line))?),
        })
    }
}

/// The event of this name.
fn event(name: &str, plant: &Plant) -> Option<EventId> {
    (0..).zip(&plant.events).find(|(_, event)| event.name == name).map(|(id, _)| id)
}

/// The event of this name, or why there is none.
fn known(name: &str, plant: &Plant) -> Result<EventId, String> {
    event(name, plant).ok_or_else(|| unknown(name))
}

fn unknown(name: &str) -> String {
    format!("`{name}` is no event of the plant")
}

/// Whether a line says anything.
fn is_said(line: &str) -> bool {
    !line.is_empty() && !line.starts_with('#')
}

pub(in crate::commands) fn run(
    given: &Given,
    script: Option<&Path>,
    session: &mut Session,
) -> Result<Exit, Failure> {
    let ReadPlant { sources, plant, .. } = session.plant(given)?;
    let script = match script {
        Some(path) => Some((input::name(path), input::text(path, Code::Encoding)?)),
        None => None,
    };
    let found = session.synthesis(&plant);
    let (synthesis, closed) = found.map_err(|failure| Failure::of(&failure, &sources))?;
    let mut position = Position::new(&plant, &closed, &synthesis);
    let format = session.format();
    match script {
        Some((path, text)) => {
            play(&path, &text, &mut position, format)?;
            if format == Format::Text {
                output::print(&view::state(&position))?;
            }
        }
        None => {
            let interactive = std::io::stdin().is_terminal();
            let color = session.color(&std::io::stderr());
            talk(&mut std::io::stdin().lock(), &mut position, format, interactive.then_some(color))?;
        }
    }
    Ok(Exit::Done)
}

/// Plays a script. An expectation that does not hold is reported at the end; an event that cannot happen ends it.
fn play(path: &str, text: &str, position: &mut Position<'_>, format: Format) -> Result<(), Failure> {
    let mut sources = Sources::new();
    let file = sources.add(path, text);
    let (mut lines, mut wrong) = (Vec::new(), Vec::new());
    for (number, line) in (1..).zip(text.lines()).filter(|(_, line)| is_said(line.trim())) {
        let span = place(file, number, line);
        match Line::parse(line.trim(), position.plant) {
            Ok(line @ (Line::Event(_) | Line::Why(_) | Line::Expect(_))) => lines.push((span, line)),
            Ok(_) => wrong.push(Diagnostic::error(
                Code::MalformedScript,
                span,
                "a script has events, `why` and `expect` only",
            )),
            Err(why) => wrong.push(Diagnostic::error(Code::MalformedScript, span, why)),
        }
    }
    if !wrong.is_empty() {
        return Err(Failure::all(Exit::Wrong, wrong, sources));
    }
    let mut failed = Vec::new();
    for (span, line) in lines {
        match line {
            Line::Expect(expectation) => {
                failed.extend(expectation.check(position).map(|found| not_so(span, found)));
            }
            Line::Why(event) => output::print(&view::why(position, event, format))?,
            Line::Event(event) => match position.step(event) {
                Ok(()) => output::print(&view::event(position, event, format))?,
                Err(verdict) => {
                    failed.push(impossible(span, event, &verdict, position.plant));
                    break;
                }
            },
            _ => {}
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(Failure::all(Exit::No, failed, sources)) }
}

fn not_so(span: Span, found: String) -> Diagnostic {
    Diagnostic::error(Code::FailedExpectation, span, "this does not hold here").note(found)
}

fn impossible(span: Span, event: EventId, verdict: &Verdict, plant: &Plant) -> Diagnostic {
    let name = &plant.events[event as usize].name;
    Diagnostic::error(Code::NotExecutable, span, format!("`{name}` cannot happen now"))
        .note(verdict.text(event, plant))
}

/// Does what lines say until there are no more or one says `quit`. Where nobody types, the first mistake ends it;
/// `typed` says that somebody does, and whether messages for them are colored.
fn talk(
    lines: &mut dyn BufRead,
    position: &mut Position<'_>,
    format: Format,
    typed: Option<bool>,
) -> Result<(), Failure> {
    look(position, format)?;
    let mut bytes = Vec::new();
    loop {
        if typed.is_some() && format == Format::Text {
            output::print("> ")?;
        }
        bytes.clear();
        let read = lines.read_until(b'\n', &mut bytes);
        if read.map_err(|error| Failure::unreadable("<stdin>", &error))? == 0 {
            return if typed.is_some() { output::print("\n") } else { Ok(()) };
        }
        let Ok(line) = std::str::from_utf8(&bytes) else {
            return Err(Failure::malformed(Code::Encoding, "<stdin>", "not UTF-8 text"));
        };
        if !is_said(line.trim()) {
            continue;
        }
        let line = Line::parse(line.trim(), position.plant).map_err(Failure::line);
        let done = line.and_then(|line| match line {
            Line::Quit => Ok(true),
            line => execute(line, position, format).map(|()| false),
        });
        match (done, typed) {
            (Ok(true), _) => return Ok(()),
            (Ok(false), _) => {}
            (Err(failure), Some(color)) if failure.can_be_mended() => {
                failure.report(Format::Text, color);
            }
            (Err(failure), _) => return Err(failure),
        }
    }
}

fn execute(line: Line<'_>, position: &mut Position<'_>, format: Format) -> Result<(), Failure> {
    match line {
        Line::Event(event) => give(event, position, format),
        Line::Number(number) => {
            let enabled: Vec<EventId> = position.enabled().collect();
            match number.checked_sub(1).and_then(|index| enabled.get(index)) {
                Some(&event) => give(event, position, format),
                None => Err(Failure::line(format!("no event has the number {number}"))),
            }
        }
        Line::Back(events) => {
            if !position.back(events) {
                return Err(Failure::line("not so many events have happened"));
            }
            look(position, format)
        }
        Line::Save { path, replace } => save(path, replace, position),
        Line::State if format == Format::Json => output::print(&view::state_json(position)),
        Line::State => output::print(&view::state(position)),
        Line::Why(event) => output::print(&view::why(position, event, format)),
        Line::Expect(expectation) => match expectation.check(position) {
            None => Ok(()),
            Some(found) => Err(Failure::new(Exit::No, not_so(Span::default(), found))),
        },
        Line::Help if format == Format::Json => {
            output::note(HELP.trim_end());
            Ok(())
        }
        Line::Help => output::print(HELP),
        Line::Quit => Ok(()),
    }
}

fn give(event: EventId, position: &mut Position<'_>, format: Format) -> Result<(), Failure> {
    position.step(event).map_err(|verdict| {
        Failure::new(Exit::No, impossible(Span::default(), event, &verdict, position.plant))
    })?;
    output::print(&view::event(position, event, format))?;
    look(position, format)
}

/// Shows the state, unless a program reads: that has it with every event.
fn look(position: &Position<'_>, format: Format) -> Result<(), Failure> {
    match format {
        Format::Json => Ok(()),
        Format::Text => output::print(&view::state(position)),
    }
}

/// Writes the events that have happened, which are a script.
fn save(path: &str, replace: bool, position: &Position<'_>) -> Result<(), Failure> {
    let file = Path::new(path);
    let exists = std::fs::symlink_metadata(file).is_ok();
    if exists && !replace && !input::is_stdin(file) {
        return Err(Failure::line(format!("`{path}` exists; `save! {path}` overwrites it")));
    }
    let mut text = format!("# a play of {}\n", position.plant.name);
    for event in position.past() {
        text.push_str(&position.plant.events[event as usize].name);
        text.push('\n');
    }
    output::product(Some(file), &text)
}
