#![no_std]
#![forbid(unsafe_code)]
//! Runtime of generated controllers: `no_std`, without allocation, `unsafe` code or dependencies.
//!
//! A generated module brings static tables and typed names; what is done with them is here, once. It implements
//! [`Tables`] and wraps a [`Machine`] in its own `Controller`, so a program seldom names anything of this crate:
//!
//! ```text
//! let mut controller = production_cell::Controller::new();
//! controller.raise(production_cell::Event::FeedBeltControllerBlankArrived);
//! controller.cycle().dispatch(&mut feed_arm, &mut press);
//! ```
//!
//! | Item | What it is |
//! |---|---|
//! | [`Mappings`] | the published tables of several mapping functions, ascending sources and their targets, searched |
//! | [`Runs`] | several mapping functions over runs of consecutive states: the smallest |
//! | [`Comb`] | all mapping functions interlocked in one array: the fastest |
//! | [`Span`] | a mapping function over consecutive states |
//! | [`Column`] | an array of numbers, or a [`Packed`] byte string of them |
//! | [`Machine`] | state and pending events; `cycle`, `drain` and `react` |
//! | [`Observer`] | sees every transition; costs nothing when unused |
//!
//! No release build has a path to a panic: every access is checked and answers with an `Option`. Generated code needs
//! Rust 1.85 or newer.
//!
//! # Features
//!
//! - `names`: generated modules have the texts of events and commands (`Event::ALL`, `Event::from_text`, `text`).
//!   They lie in flash, and only where a program uses them.

mod bits;
mod column;
mod comb;
mod machine;
mod mappings;
mod runs;
mod span;

pub use bits::{Bits, Ones};
pub use column::{Column, Number, Packed};
pub use comb::Comb;
pub use machine::{CommandSet, Machine, Observer, Tables};
pub use mappings::Mappings;
pub use runs::Runs;
pub use span::Span;

/// Version of the meaning of generated tables; a generated module refuses to compile with any other.
pub const FORMAT_VERSION: u32 = 1;

/// Keeps the items with feature `names`, drops them without; used by generated modules.
#[cfg(feature = "names")]
#[macro_export]
macro_rules! names {
    ($($item:item)*) => { $($item)* };
}

/// Keeps the items with feature `names`, drops them without; used by generated modules.
#[cfg(not(feature = "names"))]
#[macro_export]
macro_rules! names {
    ($($item:item)*) => {};
}
