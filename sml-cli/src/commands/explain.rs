//! `sml explain`: the long text of a diagnostic.

use crate::failure::{Exit, Failure};
use crate::options::Format;
use crate::output;
use crate::session::Session;
use serde_json::json;
use synth_core::diagnostic::Code;

/// Arguments of `sml explain`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// A code such as SML0007, also written 7; without one, all are listed
    code: Option<String>,
}

pub(super) fn run(arguments: &Arguments, session: &Session) -> Result<Exit, Failure> {
    let text = match &arguments.code {
        None => list(session.format()),
        Some(name) => {
            let code = Code::from_text(name).ok_or_else(|| unknown(name))?;
            long_text(code, session.format())
        }
    };
    output::print(&text)?;
    Ok(Exit::Done)
}

fn unknown(name: &str) -> Failure {
    let digits = name.trim_start_matches(|c: char| !c.is_ascii_digit());
    let nearest = digits
        .parse()
        .ok()
        .and_then(|number: u16| Code::ALL.iter().min_by_key(|&&code| (code as u16).abs_diff(number)));
    let nearest = nearest.map_or(String::new(), |code| format!("; the nearest is {code}, {}", code.title()));
    Failure::usage(format!("there is no diagnostic `{name}`{nearest}; `sml explain` lists all"))
}

fn long_text(code: Code, format: Format) -> String {
    match format {
        Format::Text => format!("{code}: {}\n\n{}", code.title(), code.explanation()),
        Format::Json => {
            let (title, text) = (code.title(), code.explanation());
            format!("{}\n", json!({ "version": 1, "code": code.to_string(), "title": title, "text": text }))
        }
    }
}

fn list(format: Format) -> String {
    match format {
        Format::Text => Code::ALL.iter().map(|code| format!("{code}  {}\n", code.title())).collect(),
        Format::Json => {
            let codes =
                Code::ALL.iter().map(|code| json!({ "code": code.to_string(), "title": code.title() }));
            format!("{}\n", json!({ "version": 1, "codes": codes.collect::<Vec<_>>() }))
        }
    }
}
