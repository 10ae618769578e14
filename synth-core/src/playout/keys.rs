//! Fairness keys: obligations by what tells them apart (language reference, section 5).

use crate::intern::Indexed;
use crate::model::{NodeId, Value};

/// Index of a key, in order of discovery.
pub type KeyId = u32;

/// An obligation of some copy: a message with a modality or a `wait eventually`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Key {
    /// Index of the scenario.
    pub scenario: usize,
    /// Role bindings of the copy.
    pub roles: Box<[Value]>,
    /// The fragment.
    pub node: NodeId,
    /// The values of the variables that the fragment reads.
    pub values: Box<[Value]>,
}

/// All keys met so far.
pub(super) type Keys = Indexed<Key>;
