//! `--templates DIR`: templates of secondaries, each written once; later runs only look whether it still fits.

use super::Target;
use super::stale::Found;
use crate::failure::{Failure, nowhere};
use crate::output;
use crate::session::Session;
use std::io::ErrorKind;
use std::path::Path;
use synth_core::controller::tables::Tables;
use synth_core::diagnostic::{Code, Diagnostic, Severity, render};
use synth_core::emit::template::{Stale, Template};
use synth_core::emit::{rust, st};

/// The templates for a target that has them, or why it cannot hold the controller.
pub(super) fn of(target: Target, tables: &Tables, options: &st::Options) -> Result<Vec<Template>, String> {
    if target == Target::Rust {
        return Ok(rust::templates(tables));
    }
    st::templates(tables, options).map_err(|unfit| unfit.to_string())
}

/// Refuses to write the product where a template is to stand.
pub(super) fn refuse(output: Option<&Path>, folder: &Path, templates: &[Template]) -> Result<(), Failure> {
    let Some(output) = output.filter(|path| path.as_os_str() != "-") else { return Ok(()) };
    let is_template = templates.iter().any(|template| output::same(output, &folder.join(&template.file)));
    if is_template { Err(output::overwritten(output)) } else { Ok(()) }
}

/// Writes those that are missing, and warns of those that are stale.
pub(super) fn write(folder: &Path, templates: &[Template], session: &Session) -> Result<(), Failure> {
    let unwritable = |path: &Path, error| Failure::unwritable(&path.display().to_string(), &error);
    let mut warnings = Found::default();
    for template in templates {
        let path = folder.join(&template.file);
        match read(&path)? {
            Some(text) => {
                if let Some(diagnostic) = stale(&path, template, &text) {
                    warnings.add(&path, 1, Diagnostic { severity: Severity::Warning, ..diagnostic });
                }
            }
            None => {
                std::fs::create_dir_all(folder).map_err(|error| unwritable(folder, error))?;
                output::create(&path, &template.text).map_err(|error| unwritable(&path, error))?;
            }
        }
    }
    if !warnings.diagnostics.is_empty() {
        let text = render(&warnings.diagnostics, &warnings.sources, session.color(&std::io::stderr()));
        output::note(text.trim_end());
    }
    Ok(())
}

/// What is missing or stale.
pub(super) fn check(found: &mut Found, folder: &Path, templates: &[Template]) -> Result<(), Failure> {
    for template in templates {
        let path = folder.join(&template.file);
        match read(&path)? {
            Some(text) => {
                if let Some(diagnostic) = stale(&path, template, &text) {
                    found.add(&path, 1, diagnostic);
                }
            }
            None => {
                let missing = nowhere(Code::Stale, format!("`{}` is missing", path.display()));
                let help = format!(
                    "run the same without `--check` to write a template of the secondary of `{}`",
                    template.object
                );
                found.add(&path, 1, missing.help(help));
            }
        }
    }
    Ok(())
}

/// The text of a file; none if there is none.
fn read(path: &Path) -> Result<Option<String>, Failure> {
    match std::fs::read(path) {
        Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Failure::unreadable(&path.display().to_string(), &error)),
    }
}

/// Why what stands in a template's file no longer fits, and what to do.
fn stale(path: &Path, template: &Template, text: &str) -> Option<Diagnostic> {
    let path = path.display();
    let (message, notes) = match template.stale(text)? {
        Stale::Unknown => (format!("`{path}` does not say which interface it was written for"), Vec::new()),
        Stale::Changed { new, gone } => {
            let listed = |what: &str, entries: Vec<String>| {
                entries.into_iter().map(|entry| format!("{what}: {entry}")).collect::<Vec<_>>()
            };
            let notes = [listed("new", new), listed("gone", gone)].concat();
            (
                format!(
                    "`{path}` is stale: the secondary of `{}` has another interface now",
                    template.object
                ),
                notes,
            )
        }
    };
    let diagnostic = notes.into_iter().fold(nowhere(Code::Stale, message), Diagnostic::note);
    Some(diagnostic.help(
        "adapt it by hand, then copy the lines about its interface from a template that `--templates` writes into \
         another folder; it is never overwritten",
    ))
}
