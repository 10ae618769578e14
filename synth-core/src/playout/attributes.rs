//! Interned valuations: the values of all attributes of all objects.

use crate::intern::Rows;
use crate::model::{Domain, Value};

/// Index of a valuation, in order of discovery; 0 is the initial one.
pub type ValuationId = u32;

/// All valuations met so far, by slot.
pub(super) type Valuations = Rows<Value>;

/// With the declared initial values as valuation 0.
pub(super) fn valuations(domain: &Domain) -> Valuations {
    let mut valuations = Rows::new(domain.initial.len());
    valuations.intern(&domain.initial);
    valuations
}
