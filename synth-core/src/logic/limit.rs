//! Where minimisation gives up.

use std::fmt;

/// A function needs more than it is given.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TooLarge {
    /// More nodes of decision diagrams than this.
    Nodes(usize),
    /// This many variables in one function, which is more than a cube has.
    Variables(usize),
    /// More terms than this.
    Terms(usize),
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TooLarge::Nodes(limit) => write!(f, "its decision diagram needs more than {limit} nodes"),
            TooLarge::Variables(count) => {
                write!(f, "it depends on {count} variables, and a term can have {}", super::Cube::VARIABLES)
            }
            TooLarge::Terms(limit) => write!(f, "as a disjunction it has more than {limit} terms"),
        }
    }
}

impl std::error::Error for TooLarge {}
