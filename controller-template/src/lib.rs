#![no_std]
#![forbid(unsafe_code)]
//! Runtime of generated controllers: `no_std`, without allocation, `unsafe` code or, but for features, dependencies.
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
//! | [`Saved`] | state and pending events as plain numbers or bytes, for a warm start |
//! | `EventQueue` | takes events from interrupts to the main loop; with feature `heapless` |
//!
//! No release build has a path to a panic: every access is checked and answers with an `Option`. Generated code needs
//! Rust 1.85 or newer.
//!
//! # Features
//!
//! All are optional, none needs `std` or an allocator, and any of them go together. A program turns them on here; the
//! crate with the generated module needs no other dependency for them.
//!
//! | Feature | Brings |
//! |---|---|
//! | `names` | the texts of events and commands in generated modules: `Event::ALL`, `from_text`, `text`; they lie in flash, and only where a program uses them |
//! | `defmt` | `defmt::Format` for [`Machine`], [`Saved`], [`RestoreError`] and [`Bits`], and in generated modules for `Event`, commands, `Commands` and `Controller`; names stay on the host |
//! | `serde` | `Serialize` and `Deserialize` for [`Saved`] and [`Bits`], and in generated modules for `Event`, commands and `Commands`; turns on `names` |
//! | `heapless` | `EventQueue`, over `heapless::spsc`; needs Rust 1.87, as `heapless` does |
//!
//! Events and commands are serialised by their texts in every format. A number would be shorter, and it is what compact
//! formats make of the variants of an `enum`; but numbers move when a specification gets or loses an event, and what an
//! older program wrote would be read as another event. A text is read as what it says, or refused.

mod bits;
mod column;
mod comb;
mod generated;
mod machine;
mod mappings;
mod probes;
#[cfg(feature = "heapless")]
mod queue;
mod runs;
mod saved;
#[cfg(feature = "serde")]
mod serial;
mod span;

#[cfg(test)]
extern crate std;

pub use bits::{Bits, Ones};
pub use column::{Column, Number, Packed};
pub use comb::Comb;
pub use machine::{CommandSet, Machine, Observer, Tables};
pub use mappings::Mappings;
#[cfg(count_probes)]
#[doc(hidden)]
pub use probes::take_probes;
#[cfg(feature = "heapless")]
pub use queue::{EventQueue, EventReceiver, EventSender};
pub use runs::Runs;
pub use saved::{RestoreError, Saved};
#[cfg(feature = "serde")]
#[doc(hidden)]
pub use serial::from_text;
pub use span::Span;

#[cfg(feature = "defmt")]
#[doc(hidden)]
pub use defmt;
#[cfg(feature = "serde")]
#[doc(hidden)]
pub use serde;

/// Version of the meaning of generated tables; a generated module refuses to compile with any other.
pub const FORMAT_VERSION: u32 = 1;
