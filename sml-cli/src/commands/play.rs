//! `sml play`: play-out by hand or by script, alone, against the controller, or against the environment's
//! counter-strategy.
//!
//! With `--strategy` the answers are shown like the events that are given, yields included, so what is shown is a
//! script for a play by hand.

mod controller;
mod dialog;
mod environment;
mod expect;
mod player;
mod script;
mod table;
mod view;

use super::plant;
use crate::failure::{Exit, Failure};
use crate::options::{Format, Minimize};
use crate::session::Session;
use crate::{input, output};
use controller::Controlled;
use dialog::Manners;
use environment::Adversary;
use player::Player;
use script::Script;
pub(super) use script::place;
use std::io::IsTerminal as _;
use std::path::PathBuf;
use synth_core::diagnostic::Code;
use synth_core::pipeline::Solved;
use table::{Opponent, Table};

/// Arguments of `sml play`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification or plant; `-` is stdin
    file: PathBuf,
    /// Events to play, one text a line, and `expect` lines; `#` begins a comment. Without it commands are read from
    /// stdin, `help` lists them
    #[arg(long, value_name = "F")]
    script: Option<PathBuf>,
    /// Let the controller answer: only events of the environment are given. If there is none, the environment is
    /// played so that it wins, and events of the system are given
    #[arg(long)]
    strategy: bool,
    #[command(flatten)]
    minimize: Minimize,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let Arguments { file, script, strategy, minimize } = arguments;
    let by_hand = PathBuf::from("-");
    input::one_stdin([file, script.as_ref().unwrap_or(&by_hand)])?;
    let level = minimize.level();
    let given = input::given(file)?;
    if given.is_plant {
        plant::refuse(&[("--strategy", *strategy), ("--minimize", minimize.is_given())])?;
        return plant::play::run(&given, script.as_deref(), session);
    }
    let loaded = session.parse(&given);
    let spec = session.specification(&loaded)?;
    let format = session.format();
    let script = match script {
        Some(path) => {
            let text = input::text(path, Code::Encoding)?;
            Some(Script::parse(&input::name(path), &text, &spec)?)
        }
        None => None,
    };
    let mut solved = if *strategy { Some(session.solve(&loaded, &spec)?) } else { None };
    let wins = |one: &&mut Solved<'_>| one.solution.wins(one.explored.game.initial);
    let verified = match solved.as_mut().filter(wins) {
        Some(solved) => Some(session.synthesize(&loaded, solved, &session.options(level))?),
        None => None,
    };
    let opponent = match (&verified, &solved) {
        (Some(verified), _) => Opponent::Controller(Controlled::new(&verified.controller)),
        (None, Some(solved)) => {
            output::note(
                "the specification is unrealizable: you play the system, and the environment will win",
            );
            Adversary::new(solved).map_or(Opponent::Nobody, |one| Opponent::Environment(Box::new(one)))
        }
        (None, None) => Opponent::Nobody,
    };
    let player = Player::new(&spec, session.semantics());
    let player = player.map_err(|mistake| Failure::at(Exit::Wrong, *mistake, &loaded.sources))?;
    let mut table = Table::new(&loaded, player, opponent);
    begin(&mut table, format)?;
    match script {
        Some(script) => {
            script.play(&mut table, format)?;
            if format == Format::Text {
                output::print(&view::turn(&mut table.player, &loaded.sources))?;
            }
        }
        None => {
            let interactive = std::io::stdin().is_terminal();
            let manners = Manners { format, color: session.color(&std::io::stdout()), interactive };
            dialog::run(&mut table, &mut std::io::stdin().lock(), manners)?;
        }
    }
    Ok(Exit::Done)
}

/// What the opponent does before anything is given.
fn begin(table: &mut Table<'_>, format: Format) -> Result<(), Failure> {
    if !table.is_answered() {
        return Ok(());
    }
    let mut happened = Vec::new();
    let result = table.restart(&mut happened);
    dialog::show(&happened, table, format)?;
    result.map_err(|wrong| dialog::failure(wrong, "", table))
}
