//! `sml names`: what generated code calls events, components and codes.

use super::plant::follow::{self, Follow};
use crate::failure::{Exit, Failure};
use crate::input::Given;
use crate::session::{ReadPlant, Session};
use crate::{input, output};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::PathBuf;
use synth_core::controller::tables::Tables;
use synth_core::controller::{self, Level, interface};
use synth_core::emit::{rust, st};
use synth_core::pipeline::{Options, alphabet, tables};
use synth_core::plant::event_based;

/// Arguments of `sml names`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification or plant; `-` is stdin
    file: PathBuf,
    /// Whose names
    #[arg(long, value_name = "T")]
    target: super::export::Target,
    #[command(flatten)]
    xml: super::export::Xml,
    /// Plants: what the controller goes by; `states` otherwise
    #[arg(long, value_enum)]
    follow: Option<Follow>,
    /// Names in the monitor of a controller, which `sml export --monitor` writes
    #[arg(long)]
    monitor: bool,
}

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    target: &'a str,
    function_block: &'a str,
    program: &'a str,
    state: &'a str,
    owed: &'a str,
    events: Vec<Event<'a>>,
    components: Vec<Component<'a>>,
}

#[derive(Serialize)]
struct Event<'a> {
    event: &'a str,
    input: &'a str,
}

#[derive(Serialize)]
struct Component<'a> {
    object: &'a str,
    output: &'a str,
    secondary: &'a str,
    file: &'a str,
    codes: BTreeMap<&'a str, u32>,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    use super::export::Target;
    arguments.xml.fits(arguments.target)?;
    let given = input::given(&arguments.file)?;
    let follows_events = Follow::events(arguments.follow);
    if given.is_plant {
        super::plant::refuse(&[("--monitor", arguments.monitor)])?;
    }
    if given.is_plant && !follows_events {
        return super::plant::names::run(&given, arguments.target, arguments.xml, session);
    }
    if follows_events {
        super::plant::export::no_rungs(arguments.target)?;
    }
    let structured_text = arguments.target.structured_text(arguments.xml);
    match arguments.target {
        Target::Rust => {}
        Target::Json | Target::Dot | Target::Mermaid => {
            return Err(Failure::usage(format!("target `{}` gives nothing a name", arguments.target)));
        }
        _ if structured_text.is_some() => {}
        other => return Err(Failure::unsupported(&format!("--target {other}"))),
    }
    let tables = if given.is_plant {
        let ReadPlant { plant, provenance, .. } = session.plant(&given)?;
        // Names come from the events, so there is no need to know the states.
        Tables::new(&plant.name, &event_based::interface(&plant), provenance)
    } else {
        follow::refuse(arguments.follow)?;
        of_specification(&given, arguments.monitor, session)?
    };
    let names = match structured_text {
        Some(target) => st::names(&tables, &st::Options { target, ..st::Options::default() }),
        None => rust::name_map(&tables),
    };
    output::print(&json(&arguments.target.to_string(), &names))?;
    Ok(Exit::Done)
}

fn of_specification(given: &Given, monitor: bool, session: &mut Session) -> Result<Tables, Failure> {
    let loaded = session.parse(given);
    let spec = session.specification(&loaded)?;
    let explored = session.explore(&loaded, &spec)?;
    // Names come from the whole graph, so there is no need to know who wins.
    let controller = interface(&explored.game, &alphabet(&explored.playout));
    let controller = if monitor { controller::monitor(&controller) } else { controller };
    let options = Options { monitor, ..session.options(Level::default()) };
    Ok(tables(&loaded, &spec, &options, &controller))
}

fn json(target: &str, names: &st::NameMap) -> String {
    let document = Document {
        version: 1,
        target,
        function_block: &names.function_block,
        program: &names.program,
        state: &names.state,
        owed: &names.owed,
        events: names.events.iter().map(|(event, input)| Event { event, input }).collect(),
        components: names
            .components
            .iter()
            .map(|component| Component {
                object: &component.object,
                output: &component.output,
                secondary: &component.secondary,
                file: &component.file,
                codes: component.codes.iter().map(|(text, code)| (text.as_str(), *code)).collect(),
            })
            .collect(),
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings always serialize"))
}
