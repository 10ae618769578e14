//! Playing by commands, one a line, from a terminal or a pipe.

use super::expect::Expectation;
use super::player::{Happened, Side, Trouble, not_executable};
use super::script::{Script, expectation};
use super::table::Table;
use super::view;
use crate::failure::{Exit, Failure, nowhere};
use crate::options::Format;
use crate::{input, output};
use std::io::BufRead;
use std::path::Path;
use synth_core::diagnostic::{Code, Diagnostic};

const HELP: &str = "  NUMBER          the event with this number
  EVENT           an event by its text, or `yield`
  back [N]        take the last N events that you chose back, and the answers to them
  save FILE       write what you chose as a script; `save! FILE` also over a file
  replay FILE     begin anew and play a script
  state           active scenarios with their cuts, attributes, and what can happen
  why EVENT       who wants an event, who waits for it, and what does not let it happen; NUMBER, too
  expect ...      check something, see `sml explain SML0109`
  help            this
  quit            the end
";

/// Who reads and writes.
#[derive(Clone, Copy)]
pub(super) struct Manners {
    pub(super) format: Format,
    /// Escapes on stdout.
    pub(super) color: bool,
    /// Somebody types: a prompt, and mistakes can be mended.
    pub(super) interactive: bool,
}

enum Command<'l> {
    Event(&'l str),
    Number(usize),
    Back(usize),
    Save { path: &'l str, replace: bool },
    Replay(&'l str),
    State,
    Why(&'l str),
    Expect(&'l str),
    Help,
    Quit,
}

impl<'l> Command<'l> {
    fn parse(line: &'l str) -> Result<Self, Failure> {
        if let Some(rest) = expectation(line) {
            return Ok(Command::Expect(rest));
        }
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim();
        // An object can have the name of a command.
        if rest.starts_with("->") || word.contains("->") {
            return Ok(Command::Event(line));
        }
        let with = |what: &str| match rest {
            "" => Err(Failure::line(format!("`{word}` needs {what}"))),
            rest => Ok(rest),
        };
        Ok(match word {
            "back" if rest.is_empty() => Command::Back(1),
            "back" => match rest.parse() {
                Ok(events) => Command::Back(events),
                Err(_) => return Err(Failure::line(format!("`{rest}` is no number of events"))),
            },
            "save" => Command::Save { path: with("a file")?, replace: false },
            "save!" => Command::Save { path: with("a file")?, replace: true },
            "replay" => Command::Replay(with("a file")?),
            "why" => Command::Why(with("an event")?),
            "state" if rest.is_empty() => Command::State,
            "help" if rest.is_empty() => Command::Help,
            "quit" if rest.is_empty() => Command::Quit,
            _ => line.parse().map_or(Command::Event(line), Command::Number),
        })
    }
}

/// Does what the lines say, until there are no more or one says `quit`. Where nobody types, the first mistake ends it.
pub(super) fn run(table: &mut Table<'_>, lines: &mut dyn BufRead, manners: Manners) -> Result<(), Failure> {
    look(table, manners)?;
    let mut line = Vec::new();
    loop {
        if manners.interactive && manners.format == Format::Text {
            output::print("> ")?;
        }
        line.clear();
        let read = lines.read_until(b'\n', &mut line);
        if read.map_err(|error| Failure::unreadable("<stdin>", &error))? == 0 {
            return if manners.interactive { output::print("\n") } else { Ok(()) };
        }
        let Ok(text) = std::str::from_utf8(&line) else {
            return Err(Failure::malformed(Code::Encoding, "<stdin>", "not UTF-8 text"));
        };
        let text = text.trim();
        if text.is_empty() || text.starts_with('#') {
            continue;
        }
        let done = Command::parse(text).and_then(|command| match command {
            Command::Quit => Ok(true),
            command => execute(&command, table, manners).map(|()| false),
        });
        match done {
            Ok(true) => return Ok(()),
            Ok(false) => {}
            Err(failure) if manners.interactive && failure.can_be_mended() => {
                failure.report(Format::Text, manners.color);
            }
            Err(failure) => return Err(failure),
        }
    }
}

fn execute(command: &Command<'_>, table: &mut Table<'_>, manners: Manners) -> Result<(), Failure> {
    let text = manners.format == Format::Text;
    match *command {
        Command::Event(event) => give(event, table, manners),
        Command::Number(number) => give(&numbered(number, table), table, manners),
        Command::Back(events) => {
            table.back(events).map_err(|wrong| failure(wrong, "", table))?;
            look(table, manners)
        }
        Command::Save { path, replace } => save(path, replace, table),
        Command::Replay(path) => replay(path, table, manners),
        Command::State if text => output::print(&view::state(table, manners.color)),
        Command::State => output::print(&view::state_json(table)),
        Command::Why(event) => {
            let event = &event.parse().map_or_else(|_| event.to_owned(), |number| numbered(number, table));
            let Some(choice) = table.player.find(event) else {
                let diagnostic =
                    nowhere(Code::NotExecutable, format!("`{event}` is no event of any scenario here"));
                return Err(Failure::new(Exit::No, diagnostic));
            };
            let sources = &table.loaded.sources;
            output::print(&if text {
                view::why(&choice, &table.player, sources)
            } else {
                view::why_json(&choice, sources)
            })
        }
        Command::Expect(rest) => expect(rest, table),
        Command::Help if text => output::print(HELP),
        Command::Help => {
            output::note(HELP.trim_end());
            Ok(())
        }
        Command::Quit => Ok(()),
    }
}

/// The event with this number in the list, or else the number.
fn numbered(number: usize, table: &mut Table<'_>) -> String {
    let enabled = table.player.enabled();
    let event = number.checked_sub(1).and_then(|index| enabled.get(index));
    event.map_or_else(|| number.to_string(), |event| (*event).to_owned())
}

fn give(event: &str, table: &mut Table<'_>, manners: Manners) -> Result<(), Failure> {
    let mut happened = Vec::new();
    let result = table.give(event, &mut happened);
    show(&happened, table, manners.format)?;
    result.map_err(|wrong| failure(wrong, event, table))?;
    look(table, manners)
}

fn replay(path: &str, table: &mut Table<'_>, manners: Manners) -> Result<(), Failure> {
    if input::is_stdin(Path::new(path)) {
        return Err(Failure::line("the commands come from stdin, so no script can"));
    }
    let text = input::text(Path::new(path), Code::Encoding)?;
    let script = Script::parse(path, &text, table.player.spec())?;
    let mut happened = Vec::new();
    let result = table.restart(&mut happened);
    show(&happened, table, manners.format)?;
    result.map_err(|wrong| failure(wrong, "", table))?;
    script.play(table, manners.format)?;
    look(table, manners)
}

/// Writes the events that were chosen, which are a script for the same kind of play.
fn save(path: &str, replace: bool, table: &Table<'_>) -> Result<(), Failure> {
    let file = Path::new(path);
    let exists = std::fs::symlink_metadata(file).is_ok();
    if exists && !replace && !input::is_stdin(file) {
        return Err(Failure::line(format!("`{path}` exists; `save! {path}` overwrites it")));
    }
    let how = match table.side() {
        None => "",
        Some(Side::System) => ", with --strategy: the events of the system",
        Some(Side::Environment) => ", with --strategy: the events of the environment",
    };
    let mut text = format!("# a play of {}{how}\n", table.player.spec().name);
    for event in table.given() {
        text.push_str(event);
        text.push('\n');
    }
    output::product(Some(file), &text)
}

fn expect(rest: &str, table: &Table<'_>) -> Result<(), Failure> {
    let malformed = |why| Failure::new(Exit::Wrong, nowhere(Code::MalformedScript, why));
    let expectation = Expectation::parse(rest, table.player.spec()).map_err(malformed)?;
    match expectation.check(table) {
        None => Ok(()),
        Some(difference) => {
            let message = format!("`expect {}` does not hold here", rest.trim());
            let diagnostic = nowhere(Code::FailedExpectation, message).note(difference.show());
            Err(Failure::new(Exit::No, diagnostic))
        }
    }
}

/// Shows the state, unless a program reads: that has it with every event.
fn look(table: &mut Table<'_>, manners: Manners) -> Result<(), Failure> {
    match manners.format {
        Format::Json => Ok(()),
        Format::Text => output::print(&view::state(table, manners.color)),
    }
}

/// Shows what happened.
pub(super) fn show(happened: &[Happened], table: &Table<'_>, format: Format) -> Result<(), Failure> {
    happened.iter().try_for_each(|one| {
        output::print(&match format {
            Format::Json => view::event_json(one),
            Format::Text => view::event_text(one, &table.loaded.sources),
        })
    })
}

pub(super) fn failure(wrong: Trouble, event: &str, table: &mut Table<'_>) -> Failure {
    let (exit, diagnostic) = trouble(wrong, event, table);
    Failure::at(exit, diagnostic, &table.loaded.sources)
}

/// Why an event does not happen, as a diagnostic.
pub(super) fn trouble(wrong: Trouble, event: &str, table: &mut Table<'_>) -> (Exit, Diagnostic) {
    match wrong {
        Trouble::Mistake(mistake) => (Exit::Wrong, *mistake),
        Trouble::NotExecutable(notes) => {
            let (code, message) = not_executable(event);
            let diagnostic = notes.into_iter().fold(nowhere(code, message), Diagnostic::note);
            let choice = table.player.find(event).filter(|_| table.player.over().is_none());
            let sources = &table.loaded.sources;
            let violated = choice.iter().flat_map(|choice| &choice.refused_by);
            let violated = violated.map(|mention| {
                format!("it would violate {}: {}", mention.show(&|span| sources.place(span)), mention.says)
            });
            (Exit::No, violated.fold(diagnostic, Diagnostic::note))
        }
    }
}
