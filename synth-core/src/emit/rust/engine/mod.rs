//! How a generated module finds the row of a state: one engine each, behind the same items.

mod comb;
mod runs;
mod search;

use std::str::FromStr;

use proc_macro2::TokenStream;

use super::columns::{Column, Layout};
use crate::controller::tables::Tables;

/// How a module finds the row of a state. All do the same.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Engine {
    /// [`Engine::Comb`], unless its tables are larger than those of [`Engine::Search`]; then that.
    #[default]
    Auto,
    /// Two arrays per event, those of all events one behind the other, and a binary search, as published (Gritzner and
    /// Greenyer 2018, section 4): the reference.
    Search,
    /// Runs of consecutive states, and targets of as few bits as they need: the smallest. With more than 2^25 states,
    /// [`Engine::Search`].
    Runs,
    /// All rows in one array, found in the same few instructions whatever state and event: the fastest.
    Comb,
}

impl Engine {
    /// All of them, the choice between them first.
    pub const ALL: [Engine; 4] = [Engine::Auto, Engine::Search, Engine::Runs, Engine::Comb];

    /// As on the command line and in attributes of the macro.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Engine::Auto => "auto",
            Engine::Search => "search",
            Engine::Runs => "runs",
            Engine::Comb => "comb",
        }
    }
}

impl FromStr for Engine {
    type Err = String;

    /// Reads a [`Engine::name`].
    fn from_str(name: &str) -> Result<Engine, String> {
        Engine::ALL.into_iter().find(|engine| engine.name() == name).ok_or_else(|| {
            let names = Engine::ALL.map(|engine| format!("`{}`", engine.name()));
            format!("unknown engine `{name}`; there are {}", names.join(", "))
        })
    }
}

/// Tables in the form that an engine wants, and how it uses them.
pub(super) trait Rows {
    /// All columns.
    fn columns(&self) -> Vec<&Column>;

    /// Bytes beside the columns.
    fn further_bytes(&self) -> usize {
        0
    }

    /// The most comparisons with entries that a look-up of an event takes, and one of a super step.
    fn probes(&self) -> (u32, u32);

    /// Expression of type `Option<Self::State>`: where `event` leads from `state`.
    fn environment(&self) -> TokenStream;

    /// Statements that make `row` the place of the commands of the super step from `state`, or return `None`; and the
    /// expression of its target, an `Option`.
    fn super_step(&self) -> (TokenStream, TokenStream);

    /// Per component its codes, by `row` of the super step.
    fn codes(&self) -> &[Column];

    /// The other statics.
    fn statics(&self, layout: Layout) -> TokenStream;
}

/// The rows as an engine has them.
pub(super) fn rows(engine: Engine, tables: &Tables) -> Box<dyn Rows> {
    match engine {
        Engine::Auto => {
            let (comb, search) = (comb::Comb::new(tables), search::Search::new(tables));
            if bytes(&comb) <= bytes(&search) { Box::new(comb) } else { Box::new(search) }
        }
        Engine::Runs if tables.states <= runs::MOST_STATES => Box::new(runs::Runs::new(tables)),
        Engine::Runs | Engine::Search => Box::new(search::Search::new(tables)),
        Engine::Comb => Box::new(comb::Comb::new(tables)),
    }
}

/// Bytes of flash of all rows.
pub(super) fn bytes(rows: &dyn Rows) -> usize {
    let columns = rows.columns().into_iter().chain(rows.codes());
    columns.map(Column::bytes).sum::<usize>() + rows.further_bytes()
}

/// The most comparisons of a binary search in so many rows.
fn searched(rows: usize) -> u32 {
    rows.max(1).next_power_of_two().ilog2() + u32::from(rows > 0)
}
