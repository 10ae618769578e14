//! Disjunctions of terms, each a conjunction of literals.

use super::{Bdd, Expr, Function, Literal, TooLarge, Var};

/// A set of up to [`Cube::VARIABLES`] variables, by their positions among the variables of a [`Cover`].
pub(super) type Mask = u128;

/// A term: what variables it mentions, and what it wants them to be.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Cube {
    /// The variables that it mentions.
    pub(super) care: Mask,
    /// Those of them that it does not negate.
    pub(super) value: Mask,
}

impl Cube {
    /// How many variables a term can mention.
    pub const VARIABLES: usize = Mask::BITS as usize;

    /// The term without literals, which always holds.
    pub(super) const ALL: Cube = Cube { care: 0, value: 0 };

    /// How many literals it has.
    #[must_use]
    pub fn literals(self) -> u32 {
        self.care.count_ones()
    }

    /// It holds wherever `other` does.
    #[must_use]
    pub fn covers(self, other: Cube) -> bool {
        self.care & !other.care == 0 && (self.value ^ other.value) & self.care == 0
    }

    /// With the literal of the variable at `position`.
    #[must_use]
    pub(super) fn with(self, position: u32, value: bool) -> Cube {
        Cube { care: self.care | 1 << position, value: self.value | Mask::from(value) << position }
    }

    /// Without the variables of `mask`.
    #[must_use]
    pub(super) fn without(self, mask: Mask) -> Cube {
        Cube { care: self.care & !mask, value: self.value & !mask }
    }

    /// Variables that one of the two negates and the other does not.
    pub(super) fn conflicts(self, other: Cube) -> Mask {
        self.care & other.care & (self.value ^ other.value)
    }

    /// The positions of its variables, ascending, and what it wants them to be.
    pub fn iter(self) -> impl Iterator<Item = (u32, bool)> {
        bits(self.care).map(move |position| (position, self.value >> position & 1 == 1))
    }
}

/// The members of a set, ascending.
pub(super) fn bits(mut mask: Mask) -> impl Iterator<Item = u32> {
    std::iter::from_fn(move || {
        (mask != 0).then(|| {
            let position = mask.trailing_zeros();
            mask &= mask - 1;
            position
        })
    })
}

/// A disjunction of terms.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cover {
    /// The variables, ascending; terms mention them by their positions.
    pub variables: Vec<Var>,
    /// The terms.
    pub cubes: Vec<Cube>,
}

impl Cover {
    /// How many literals its terms have together.
    #[must_use]
    pub fn literals(&self) -> usize {
        self.cubes.iter().map(|cube| cube.literals() as usize).sum()
    }

    /// The literals of a term, by variable.
    pub fn literals_of(&self, cube: Cube) -> impl Iterator<Item = Literal> {
        cube.iter()
            .map(|(position, value)| Literal { variable: self.variables[position as usize], negated: !value })
    }

    /// As an expression in two levels.
    #[must_use]
    pub fn expr(&self) -> Expr {
        Expr::any(
            self.cubes
                .iter()
                .map(|&cube| Expr::all(self.literals_of(cube).map(Expr::Literal).collect()))
                .collect(),
        )
    }

    /// The same with other variables: `rename` says which stands for which. Terms and literals are put in order.
    #[must_use]
    pub fn renamed(&self, rename: impl Fn(Var) -> Var) -> Cover {
        let mut variables: Vec<Var> = self.variables.iter().map(|&variable| rename(variable)).collect();
        let positions = variables.clone();
        variables.sort_unstable();
        let at: Vec<u32> = positions
            .iter()
            .map(|variable| variables.partition_point(|other| other < variable) as u32)
            .collect();
        let mut cubes: Vec<Cube> = self
            .cubes
            .iter()
            .map(|cube| {
                cube.iter()
                    .fold(Cube::ALL, |renamed, (position, value)| renamed.with(at[position as usize], value))
            })
            .collect();
        sort(&mut cubes);
        Cover { variables, cubes }
    }

    /// As text in the syntax of plants: `!Y1 && X2 || X3`.
    ///
    /// There are no constants in that syntax. What never holds is written `x && !x` and what always holds `x || !x`, with
    /// `any` for the variable; nobody can ask for them without one.
    #[must_use]
    pub fn text(&self, name: impl Fn(Var) -> String, any: Var) -> String {
        if self.cubes.is_empty() {
            return format!("{0} && !{0}", name(any));
        }
        if self.cubes.contains(&Cube::ALL) {
            return format!("{0} || !{0}", name(any));
        }
        let term = |&cube: &Cube| {
            let literals: Vec<String> = self
                .literals_of(cube)
                .map(|literal| {
                    format!("{}{}", if literal.negated { "!" } else { "" }, name(literal.variable))
                })
                .collect();
            literals.join(" && ")
        };
        self.cubes.iter().map(term).collect::<Vec<_>>().join(" || ")
    }

    /// As a function.
    pub fn function(&self, bdd: &mut Bdd) -> Result<Function, TooLarge> {
        self.cubes.iter().try_fold(Function::FALSE, |sum, &cube| {
            let term = term(bdd, &self.variables, cube)?;
            bdd.or(sum, term)
        })
    }
}

/// By their literals, in the order of variables, those that are not negated first.
pub(super) fn sort(cubes: &mut [Cube]) {
    cubes.sort_by_key(|cube| (cube.care.reverse_bits(), cube.value.reverse_bits()));
    cubes.reverse();
}

/// A term as a function.
pub(super) fn term(bdd: &mut Bdd, variables: &[Var], cube: Cube) -> Result<Function, TooLarge> {
    // Last variable first, so that every step adds one node on top.
    let literals: Vec<(u32, bool)> = cube.iter().collect();
    literals.iter().rev().try_fold(Function::TRUE, |product, &(position, value)| {
        let literal = bdd.literal(variables[position as usize], value)?;
        bdd.and(literal, product)
    })
}
