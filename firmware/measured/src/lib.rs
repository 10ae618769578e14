//! Controllers whose look-ups and operations can be found in the program, and what plays to them: their instructions are
//! counted while it runs, and their code is read.
//!
//! [`play`] plays ten thousand events, the same on every machine, to [`cell`], the production cell's controller, or
//! [`line`], one of more than a thousand states. [`tour`] looks up every event in every state, of [`engines`].
#![no_std]
#![forbid(unsafe_code)]

mod digest;
mod play;
mod tour;

pub use play::{Outcome, Steps, play};
pub use tour::{Tour, tour};

/// The production cell: 200 states.
pub mod cell {
    include!(concat!(env!("OUT_DIR"), "/production_cell.rs"));
    crate::steps!(production_cell);
}

/// The production line of two presses: more than a thousand states.
pub mod line {
    include!(concat!(env!("OUT_DIR"), "/spec.rs"));
    crate::steps!(production_line);
}

/// A controller of 300 rows, and the production cell's, by every engine.
pub mod engines {
    /// The modules of a controller, with the bytes of their tables.
    macro_rules! engines {
        ($($name:ident: $module:ident, $file:literal;)*) => {
            $(
                #[allow(missing_docs, reason = "they are all alike")]
                pub mod $name {
                    include!(concat!(env!("OUT_DIR"), "/", $file, ".rs"));
                    include!(concat!(env!("OUT_DIR"), "/", $file, "_bytes.rs"));
                    $crate::steps!($module);
                }
            )*

            /// Every controller and engine with its tour.
            pub(crate) fn tours() -> [(&'static str, fn() -> $crate::Tour); 6] {
                [$((stringify!($name), || $crate::tour::<$name::Controller>($name::TABLES))),*]
            }
        };
    }

    engines! {
        rows_search: rows, "rows_search";
        rows_runs: rows, "rows_runs";
        rows_comb: rows, "rows_comb";
        cell_search: production_cell, "cell_search";
        cell_runs: production_cell, "cell_runs";
        cell_comb: production_cell, "cell_comb";
    }
}

/// The names of the modules in [`engines`], each with the tour of its controller.
pub fn tours() -> impl Iterator<Item = (&'static str, fn() -> Tour)> {
    engines::tours().into_iter()
}
