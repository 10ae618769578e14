//! What to do about warnings: the options, and showing those that go beside a product.

use crate::failure::{Exit, Failure};
use crate::output;
use crate::session::Session;
use synth_core::diagnostic::{Diagnostic, render};
use synth_core::quality::{Policy, Warning};
use synth_core::syntax::Sources;

/// Options about warnings.
#[derive(clap::Args, Clone, Debug)]
pub(crate) struct Warnings {
    /// Fail if there is a warning of this code; several, separated by commas or by repeating the option
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    deny: Vec<Warning>,
    /// Fail if there is any warning
    #[arg(long)]
    deny_warnings: bool,
    /// Do not show warnings of this code, nor fail because of them
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    allow: Vec<Warning>,
}

impl Warnings {
    pub(crate) fn policy(&self) -> Policy {
        let policy = if self.deny_warnings { Policy::default().deny_all() } else { Policy::default() };
        let policy = self.deny.iter().fold(policy, |policy, &code| policy.deny(code));
        self.allow.iter().fold(policy, |policy, &code| policy.allow(code))
    }
}

/// Shows warnings on stderr; fails if one is denied.
pub(crate) fn show(
    mut warnings: Vec<Diagnostic>,
    policy: &Policy,
    sources: &Sources,
    session: &Session,
) -> Result<(), Failure> {
    policy.apply(&mut warnings);
    let (denied, shown): (Vec<_>, Vec<_>) = warnings.into_iter().partition(|one| policy.denies(one));
    if !shown.is_empty() {
        let text = render(&shown, sources, session.color(&std::io::stderr()));
        output::note(text.trim_end());
    }
    if denied.is_empty() { Ok(()) } else { Err(Failure::all(Exit::No, denied, sources.clone())) }
}
