//! The cut: where in a body a copy stands, as an explicit tree.
//!
//! A *body path* leads from the scenario's own body (the empty path) to a nested one: pairs of the fragment's index and the
//! index of the case or branch (0 for a nested body or a loop). A *fragment path* is a body path and one more
//! index.

use std::collections::BTreeMap;
use synth_core::syntax::ast::{Body, Constraint, Fragment, FragmentKind, Message, Modality};

/// Path to a body.
pub type BodyPath = Vec<usize>;
/// Path to a fragment.
pub type FragmentPath = Vec<usize>;

/// A place in one body.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Cut {
    /// Index of the fragment at which the cut stands; the number of fragments at the end.
    pub next: usize,
    /// Where inside that fragment.
    pub inside: Inside,
}

/// Where inside a fragment the cut stands.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub enum Inside {
    /// Before it.
    #[default]
    Before,
    /// In a nested body (index 0), the body of a loop (index 0), or the decided case of an alternative.
    Body(usize, Box<Cut>),
    /// Before the cases of an alternative that are offered.
    Undecided(BTreeMap<usize, Cut>),
    /// In all branches of a parallel.
    Branches(Vec<Cut>),
}

impl Cut {
    /// Passes the fragment at which it stands.
    pub fn pass(&mut self) {
        self.next += 1;
        self.inside = Inside::Before;
    }

    /// Stands behind the last fragment of `body`.
    #[must_use]
    pub fn at_end(&self, body: &Body) -> bool {
        self.next >= body.fragments.len()
    }

    /// The places further inside: body index and cut.
    fn inner(&self) -> Vec<(usize, &Cut)> {
        match &self.inside {
            Inside::Before => Vec::new(),
            Inside::Body(index, cut) => vec![(*index, cut)],
            Inside::Undecided(cases) => cases.iter().map(|(index, cut)| (*index, cut)).collect(),
            Inside::Branches(branches) => branches.iter().enumerate().collect(),
        }
    }

    /// The fragments at which the cut stands, in textual order, each with its path.
    #[must_use]
    pub fn fragments<'a>(&self, body: &'a Body) -> Vec<(FragmentPath, &'a Fragment)> {
        let mut found = Vec::new();
        self.collect_fragments(body, &[], &mut found);
        found
    }

    fn collect_fragments<'a>(
        &self,
        body: &'a Body,
        path: &[usize],
        found: &mut Vec<(FragmentPath, &'a Fragment)>,
    ) {
        let Some(fragment) = body.fragments.get(self.next) else { return };
        if self.inside == Inside::Before {
            found.push((extend(path, &[self.next]), fragment));
        }
        for (index, cut) in self.inner() {
            if let Some(inner) = nested(fragment, index) {
                cut.collect_fragments(inner, &extend(path, &[self.next, index]), found);
            }
        }
    }

    /// The constraints in force: those of every body in which the cut stands, each with the path of its body.
    #[must_use]
    pub fn constraints<'a>(&self, body: &'a Body) -> Vec<(BodyPath, &'a Constraint)> {
        let mut found = Vec::new();
        self.collect_constraints(body, &[], &mut found);
        found
    }

    fn collect_constraints<'a>(
        &self,
        body: &'a Body,
        path: &[usize],
        found: &mut Vec<(BodyPath, &'a Constraint)>,
    ) {
        let Some(fragment) = body.fragments.get(self.next) else { return };
        found.extend(body.constraints.iter().map(|constraint| (path.to_vec(), constraint)));
        for (index, cut) in self.inner() {
            if let Some(inner) = nested(fragment, index) {
                cut.collect_constraints(inner, &extend(path, &[self.next, index]), found);
            }
        }
    }

    /// Moves past the fragment at `path`, at which it must stand; decides the alternatives on the way.
    pub fn pass_fragment(&mut self, path: &[usize]) {
        let [_, index, rest @ ..] = path else { return self.pass() };
        match &mut self.inside {
            Inside::Before => {}
            Inside::Body(_, cut) => cut.pass_fragment(rest),
            Inside::Branches(branches) => branches[*index].pass_fragment(rest),
            Inside::Undecided(cases) => {
                let mut cut = cases.remove(index).unwrap_or_default();
                cut.pass_fragment(rest);
                self.inside = Inside::Body(*index, Box::new(cut));
            }
        }
    }
}

/// `path` and what follows.
#[must_use]
pub fn extend(path: &[usize], more: &[usize]) -> Vec<usize> {
    [path, more].concat()
}

/// The `index`-th body inside a fragment.
#[must_use]
pub fn nested(fragment: &Fragment, index: usize) -> Option<&Body> {
    match &fragment.kind {
        FragmentKind::Body(body) | FragmentKind::While(_, body) if index == 0 => Some(body),
        FragmentKind::Alternative(cases) => cases.get(index).map(|case| &case.body),
        FragmentKind::Parallel(branches) => branches.get(index),
        _ => None,
    }
}

/// All bodies inside a fragment.
pub fn bodies(fragment: &Fragment) -> impl Iterator<Item = (usize, &Body)> {
    (0..).map_while(|index| nested(fragment, index).map(|body| (index, body)))
}

/// All messages of `body` and the bodies inside it, in textual order, with the path of the body in which each stands;
/// those of constraints only with `constraints`.
#[must_use]
pub fn messages(body: &Body, constraints: bool) -> Vec<(BodyPath, &Message)> {
    let mut found = Vec::new();
    collect_messages(body, &[], constraints, &mut found);
    found
}

fn collect_messages<'a>(
    body: &'a Body,
    path: &[usize],
    constraints: bool,
    found: &mut Vec<(BodyPath, &'a Message)>,
) {
    for (next, fragment) in body.fragments.iter().enumerate() {
        if let FragmentKind::Message(_, message) = &fragment.kind {
            found.push((path.to_vec(), message));
        }
        for (index, inner) in bodies(fragment) {
            collect_messages(inner, &extend(path, &[next, index]), constraints, found);
        }
    }
    if constraints {
        found.extend(body.constraints.iter().map(|constraint| (path.to_vec(), &constraint.message)));
    }
}

/// A message or `wait` that makes the cut strict.
#[must_use]
pub fn is_strict(fragment: &Fragment) -> bool {
    match &fragment.kind {
        FragmentKind::Message(modifier, _) => modifier.strict,
        FragmentKind::Wait { strict, .. } => *strict,
        _ => false,
    }
}

/// A message with a modality, or a `wait eventually`.
#[must_use]
pub fn is_obligation(fragment: &Fragment) -> bool {
    match &fragment.kind {
        FragmentKind::Message(modifier, _) => modifier.modality.is_some(),
        FragmentKind::Wait { eventually, .. } => *eventually,
        _ => false,
    }
}

/// The modality with which a message causes its event: none when monitored.
#[must_use]
pub fn causing_modality(fragment: &Fragment) -> Option<Modality> {
    match &fragment.kind {
        FragmentKind::Message(modifier, _) if !modifier.monitored => modifier.modality,
        _ => None,
    }
}
