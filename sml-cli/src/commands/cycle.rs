//! `sml cycle`: a controller at work, cycle by cycle.

use super::plant::follow::{self, Follow};
use crate::failure::{Exit, Failure};
use crate::options::Minimize;
use crate::session::Session;
use crate::{input, output};
use std::path::PathBuf;
use synth_core::controller::{Controller, Level, stimulus};
use synth_core::diagnostic::Code;

/// Arguments of `sml cycle`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification, or with `--follow events` a plant; `-` is stdin
    file: PathBuf,
    /// CSV: the header names events, each row is one cycle of 0 and 1
    #[arg(long, value_name = "CSV")]
    stimulus: PathBuf,
    /// The controller to run, as `sml synth` writes it; otherwise the specification's own
    #[arg(long, value_name = "JSON", conflicts_with_all = ["minimize", "no_minimize"])]
    controller: Option<PathBuf>,
    /// Do all super steps that are due in a cycle, up to a second command to a component
    #[arg(long)]
    drain: bool,
    #[command(flatten)]
    minimize: Minimize,
    /// Plants: what the controller goes by; only one that follows `events` has cycles
    #[arg(long, value_enum, conflicts_with = "controller")]
    follow: Option<Follow>,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let Arguments { file, stimulus, controller, drain, .. } = arguments;
    input::one_stdin([file, stimulus].into_iter().chain(controller))?;
    let controller = match controller {
        Some(path) => {
            // A specification that is wrong is wrong, even where it is not needed.
            let loaded = session.load(file)?;
            session.specification(&loaded)?;
            let (controller, level) = input::controller(path)?;
            one_at_a_time(level, &format!("`{}` was minimised so that it", input::name(path)))?;
            controller
        }
        None => own(arguments, session)?,
    };
    let csv = input::text(stimulus, Code::MalformedStimulus)?;
    let rows = stimulus::run(&controller, &csv, *drain)
        .map_err(|why| Failure::malformed(Code::MalformedStimulus, &input::name(stimulus), &why))?;
    output::print(&rows)?;
    Ok(Exit::Done)
}

/// Refuses a controller that is not for cycles.
fn one_at_a_time(level: Level, who: &str) -> Result<(), Failure> {
    if level == Level::Ordered {
        return Err(Failure::usage(format!(
            "a cycle takes several events at once, and {who} needs them one at a time"
        )));
    }
    Ok(())
}

fn own(arguments: &Arguments, session: &mut Session) -> Result<Controller, Failure> {
    let level = arguments.minimize.level();
    one_at_a_time(level, "`--minimize ordered`")?;
    let given = input::given(&arguments.file)?;
    if given.is_plant && Follow::events(arguments.follow) {
        return Ok(follow::follow(&mut session.plant(&given)?, level, "", session)?.controller);
    }
    let loaded = session.specification_only(&given)?;
    follow::refuse(arguments.follow)?;
    let spec = session.specification(&loaded)?;
    let mut solved = session.solve(&loaded, &spec)?;
    Ok(session.synthesize(&loaded, &mut solved, &session.options(level))?.controller)
}
