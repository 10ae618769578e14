//! `sml play`: play-out by hand or by script, alone or against the controller.
//!
//! With `--strategy` the controller's events are shown like the others, yields included, so what is shown is a
//! script for a play by hand.

mod player;
mod strategy;

use crate::failure::{Exit, Failure};
use crate::options::{Format, Minimize};
use crate::session::Session;
use crate::{input, output};
use player::{Happened, Player, Trouble};
use serde::Serialize;
use std::io::{BufRead as _, IsTerminal as _};
use std::path::PathBuf;
use strategy::Strategy;
use synth_core::diagnostic::{Code, render};
use synth_core::model::Spec;
use synth_core::syntax::{Loaded, Sources};

/// Arguments of `sml play`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification; `-` is stdin
    file: PathBuf,
    /// Events to play, one text a line; `#` begins a comment. Without it events are asked for, or read from stdin
    #[arg(long, value_name = "F")]
    script: Option<PathBuf>,
    /// Let the controller answer: only events of the environment are given
    #[arg(long)]
    strategy: bool,
    #[command(flatten)]
    minimize: Minimize,
}

#[derive(Serialize)]
struct Line<'a> {
    event: &'a str,
    turn: &'a str,
    violated: &'a [String],
    enabled: Vec<&'a str>,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let Arguments { file, script, strategy, minimize } = arguments;
    let by_hand = PathBuf::from("-");
    let source = script.as_ref().unwrap_or(&by_hand);
    input::one_stdin([file, source])?;
    let level = minimize.level().map_err(Failure::unsupported)?;
    let loaded = session.load(file)?;
    let spec = session.specification(&loaded)?;
    let controller = if *strategy {
        let mut solved = session.solve(&loaded, &spec)?;
        Some(session.synthesize(&loaded, &mut solved, level)?.controller)
    } else {
        None
    };
    let mut table = Table::new(&loaded, &spec, controller.as_ref().map(Strategy::new), session)?;
    table.begin()?;
    if script.is_none() && std::io::stdin().is_terminal() {
        table.ask()?;
    } else {
        let text = input::text(source, Code::Encoding)?;
        table.script(&text)?;
    }
    Ok(Exit::Done)
}

/// Where the game is played: both players, and the audience.
struct Table<'a> {
    loaded: &'a Loaded,
    player: Player<'a>,
    strategy: Option<Strategy<'a>>,
    format: Format,
    color: bool,
}

impl<'a> Table<'a> {
    fn new(
        loaded: &'a Loaded,
        spec: &'a Spec,
        strategy: Option<Strategy<'a>>,
        session: &Session,
    ) -> Result<Self, Failure> {
        let player = Player::new(spec, session.semantics());
        let player = player.map_err(|mistake| Failure::at(Exit::Wrong, *mistake, loaded))?;
        Ok(Table {
            loaded,
            player,
            strategy,
            format: session.format(),
            color: session.color(&std::io::stderr()),
        })
    }

    /// The controller's events before any of the environment's.
    fn begin(&mut self) -> Result<(), Failure> {
        let events = self.strategy.as_mut().map_or(Vec::new(), Strategy::begin);
        self.respond(&events).map_err(|trouble| self.failure(trouble))
    }

    fn script(&mut self, text: &str) -> Result<(), Failure> {
        for line in text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
            self.given(line).map_err(|trouble| self.failure(trouble))?;
        }
        self.show_enabled()
    }

    /// Asks for events until there are no more.
    fn ask(&mut self) -> Result<(), Failure> {
        let mut lines = std::io::stdin().lock().lines();
        loop {
            self.show_enabled()?;
            output::print("> ")?;
            let Some(Ok(line)) = lines.next() else { return output::print("\n") };
            let line = line.trim();
            if line == "quit" {
                return Ok(());
            }
            match self.given(&self.chosen(line)) {
                Err(Trouble::NotExecutable(why)) => {
                    output::note(render(&[*why], &Sources::new(), self.color).trim_end());
                }
                result => result.map_err(|trouble| self.failure(trouble))?,
            }
        }
    }

    /// The event with this number, or the text itself.
    fn chosen(&self, text: &str) -> String {
        let number = text.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
        let enabled = self.player.enabled();
        number.and_then(|number| enabled.get(number).copied()).unwrap_or(text).to_owned()
    }

    /// Plays an event that was given, and what the controller answers.
    fn given(&mut self, text: &str) -> Result<(), Trouble> {
        let happened = self.player.play(text)?;
        self.show(&happened)?;
        let answer = self.strategy.as_mut().map_or(Vec::new(), |strategy| strategy.answer(&happened.event));
        self.respond(&answer)
    }

    /// Plays the controller's events, and yields where it has no more to send.
    fn respond(&mut self, events: &[&str]) -> Result<(), Trouble> {
        for event in events {
            let happened = self.player.play(event)?;
            self.show(&happened)?;
        }
        while self.strategy.is_some() && self.player.may_yield() {
            let happened = self.player.play("yield")?;
            self.show(&happened)?;
        }
        Ok(())
    }

    fn show(&self, happened: &Happened) -> Result<(), Failure> {
        let Happened { event, turn, violated } = happened;
        let turn = turn.name();
        output::print(&match self.format {
            Format::Json => {
                let line = Line { event, turn, violated, enabled: self.player.enabled() };
                format!("{}\n", serde_json::to_string(&line).expect("strings always serialize"))
            }
            Format::Text if violated.is_empty() => format!("{turn}: {event}\n"),
            Format::Text => format!("{turn}: {event}\n  violates {}\n", violated.join(", ")),
        })
    }

    fn show_enabled(&self) -> Result<(), Failure> {
        if self.format == Format::Json {
            return Ok(());
        }
        let enabled = self.player.enabled();
        if enabled.is_empty() {
            return output::print("nothing is enabled\n");
        }
        let lines: String = enabled.iter().zip(1..).map(|(text, n)| format!("  {n}  {text}\n")).collect();
        output::print(&format!("enabled for the {}:\n{lines}", self.player.turn().name()))
    }

    fn failure(&self, trouble: Trouble) -> Failure {
        match trouble {
            Trouble::NotExecutable(why) => Failure::at(Exit::No, *why, self.loaded),
            Trouble::Mistake(mistake) => Failure::at(Exit::Wrong, *mistake, self.loaded),
            Trouble::Unshown(failure) => failure,
        }
    }
}
