//! Objects that change places, and the scenarios that thereby do.

use super::{ObjectId, Type, Value};

/// A permutation of objects together with what it makes of scenarios: one in which objects are named becomes the one in
/// which the others are.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Permutation {
    /// Per object the one that takes its place.
    pub objects: Box<[ObjectId]>,
    /// Per scenario what it becomes.
    pub scenarios: Box<[usize]>,
}

impl Permutation {
    /// Nothing changes its place.
    #[must_use]
    pub fn identity(objects: usize, scenarios: usize) -> Self {
        Permutation { objects: (0..objects).collect(), scenarios: (0..scenarios).collect() }
    }

    /// What becomes of a value.
    #[must_use]
    pub fn value(&self, value: Value, ty: Type) -> Value {
        match (ty, usize::try_from(value)) {
            (Type::Class(_), Ok(object)) => self.objects[object] as Value,
            _ => value,
        }
    }

    /// First `self`, then `next`.
    #[must_use]
    pub fn then(&self, next: &Permutation) -> Permutation {
        Permutation {
            objects: self.objects.iter().map(|&object| next.objects[object]).collect(),
            scenarios: self.scenarios.iter().map(|&scenario| next.scenarios[scenario]).collect(),
        }
    }

    /// The way back.
    #[must_use]
    pub fn inverse(&self) -> Permutation {
        let invert = |images: &[usize]| {
            let mut inverse = vec![0; images.len()];
            for (index, &image) in images.iter().enumerate() {
                inverse[image] = index;
            }
            inverse.into_boxed_slice()
        };
        Permutation { objects: invert(&self.objects), scenarios: invert(&self.scenarios) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_permutation_and_its_inverse_change_nothing() {
        let turn = Permutation { objects: [1, 2, 0].into(), scenarios: [1, 0].into() };
        assert_eq!(turn.then(&turn.inverse()), Permutation::identity(3, 2));
        assert_eq!(turn.then(&turn).objects, [2, 0, 1].into());
    }

    #[test]
    fn only_objects_change() {
        let swap = Permutation { objects: [1, 0].into(), scenarios: [].into() };
        let class = Type::Class(0);
        assert_eq!([0, 1, -1, super::super::UNSET].map(|value| swap.value(value, class))[..3], [1, 0, -1]);
        assert_eq!(swap.value(super::super::UNSET, class), super::super::UNSET);
        assert_eq!(swap.value(1, Type::Int(0, 1)), 1);
    }
}
