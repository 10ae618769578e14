//! Settling (section 3, step 4): a copy makes silent moves, one at a time, the textually first one first, until
//! there is none.
//!
//! Nested fragments are entered as soon as the cut reaches them: conditions of loops and cases are asked then, before any
//! further silent move, and neither entering nor passing one decides an `alternative` around it. A case that is
//! over as soon as it is entered ends its alternative.

use super::cut::{Cut, FragmentPath, Inside, bodies, extend, nested};
use super::eval::EvalError;
use super::matching::Context;
use super::spec::Spec;
use super::state::{Attributes, Copy, Variables};
use std::collections::{BTreeMap, BTreeSet};
use synth_core::syntax::ast::{Body, Fragment, FragmentKind};

/// What has become of a copy.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Settled {
    /// It waits for a message, or for a condition.
    Active(Copy),
    /// It has come to its end, or was interrupted.
    Ended,
    /// Its scenario is violated.
    Violated,
}

/// Why settling does not come to an end.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum SettleError {
    /// A condition or value that cannot be evaluated.
    Eval(EvalError),
    /// The same cut and values come round again.
    Loop,
}

impl From<EvalError> for SettleError {
    fn from(error: EvalError) -> Self {
        SettleError::Eval(error)
    }
}

/// One silent move.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Move {
    /// There is none.
    None,
    /// A fragment was passed.
    Passed,
    /// An `interrupt` applies.
    Ended,
    /// A `violation` applies.
    Violated,
}

impl Spec {
    /// Settles a copy; the paths of the waits that it passes are added to `passed_waits`.
    ///
    /// # Errors
    /// See [`SettleError`].
    pub fn settle(
        &self,
        attributes: &Attributes,
        mut copy: Copy,
        passed_waits: &mut BTreeSet<FragmentPath>,
    ) -> Result<Settled, SettleError> {
        let body = &self.scenarios[copy.scenario].body;
        let mut seen = BTreeSet::new();
        loop {
            let mut cut = std::mem::take(&mut copy.cut);
            self.reach(attributes, &mut copy, body, &[], &mut cut)?;
            copy.cut = cut;
            if copy.cut.at_end(body) {
                return Ok(Settled::Ended);
            }
            if !seen.insert((copy.cut.clone(), copy.variables.clone())) {
                return Err(SettleError::Loop);
            }
            match self.silent_move(attributes, &mut copy, passed_waits)? {
                Move::None => return Ok(Settled::Active(copy)),
                Move::Passed => {}
                Move::Ended => return Ok(Settled::Ended),
                Move::Violated => return Ok(Settled::Violated),
            }
        }
    }

    /// Makes the textually first silent move.
    fn silent_move(
        &self,
        attributes: &Attributes,
        copy: &mut Copy,
        passed_waits: &mut BTreeSet<FragmentPath>,
    ) -> Result<Move, EvalError> {
        let scenario = &self.scenarios[copy.scenario];
        for (path, fragment) in copy.cut.fragments(&scenario.body) {
            let body = &path[..path.len() - 1];
            let context = Context::of(self, attributes, copy);
            let scope = context.scope(body);
            match &fragment.kind {
                FragmentKind::Wait { condition, .. } => {
                    if !scope.condition(condition)? {
                        continue;
                    }
                    passed_waits.insert(path.clone());
                }
                FragmentKind::Interrupt(condition) => {
                    if scope.condition(condition)? {
                        return Ok(Move::Ended);
                    }
                }
                FragmentKind::Violation(condition) => {
                    if scope.condition(condition)? {
                        return Ok(Move::Violated);
                    }
                }
                FragmentKind::Variable(_, _, None) => {}
                FragmentKind::Variable(_, name, Some(expr)) | FragmentKind::Assignment(name, expr) => {
                    let unknown = || EvalError::Malformed(format!("no variable `{}`", name.text));
                    let (declared, ty) = scenario.variable(body, &name.text).ok_or_else(unknown)?;
                    let value = scope.value_of_type(expr, ty)?;
                    copy.variables.insert((declared, name.text.clone()), value);
                }
                _ => continue,
            }
            copy.cut.pass_fragment(&path);
            return Ok(Move::Passed);
        }
        Ok(Move::None)
    }

    /// Moves the cut of a body on until it stands before messages and silent fragments, or at the end of the body:
    /// enters what it has reached, and leaves what is over.
    fn reach(
        &self,
        attributes: &Attributes,
        copy: &mut Copy,
        body: &Body,
        path: &[usize],
        cut: &mut Cut,
    ) -> Result<(), EvalError> {
        while let Some(fragment) = body.fragments.get(cut.next) {
            if bodies(fragment).next().is_none() {
                return Ok(());
            }
            let fresh = cut.inside == Inside::Before;
            if fresh {
                let context = Context::of(self, attributes, copy);
                match enter(&context, path, &fragment.kind)? {
                    Some(inside) => cut.inside = inside,
                    None => {
                        cut.pass();
                        continue;
                    }
                }
            }
            let here = extend(path, &[cut.next]);
            if !self.is_over(attributes, copy, fragment, &here, &mut cut.inside)? {
                return Ok(());
            }
            if matches!(fragment.kind, FragmentKind::While(..)) && !fresh {
                // The condition is asked again.
                cut.inside = Inside::Before;
            } else {
                cut.pass();
            }
        }
        Ok(())
    }

    /// Moves the cuts inside a fragment on; whether there is nothing left to do in it.
    fn is_over(
        &self,
        attributes: &Attributes,
        copy: &mut Copy,
        fragment: &Fragment,
        path: &[usize],
        inside: &mut Inside,
    ) -> Result<bool, EvalError> {
        let mut ended = |index: usize, cut: &mut Cut| -> Result<bool, EvalError> {
            let Some(body) = nested(fragment, index) else { return Ok(true) };
            let path = extend(path, &[index]);
            self.reach(attributes, copy, body, &path, cut)?;
            if cut.at_end(body) {
                leave(&mut copy.variables, &path);
            }
            Ok(cut.at_end(body))
        };
        // Every inner cut moves on, whatever the others do.
        let mut ends = Vec::new();
        match inside {
            Inside::Before => {}
            Inside::Body(index, cut) => ends.push(ended(*index, cut)?),
            Inside::Undecided(cases) => {
                for (&index, cut) in cases.iter_mut() {
                    ends.push(ended(index, cut)?);
                }
            }
            Inside::Branches(branches) => {
                for (index, cut) in branches.iter_mut().enumerate() {
                    ends.push(ended(index, cut)?);
                }
            }
        }
        let is_undecided = matches!(inside, Inside::Undecided(_));
        Ok(if is_undecided { ends.contains(&true) } else { !ends.contains(&false) })
    }
}

/// Where the cut stands when it reaches a nested fragment; `None` when it passes it.
fn enter(
    context: &Context<'_>,
    path: &[usize],
    fragment: &FragmentKind,
) -> Result<Option<Inside>, EvalError> {
    let scope = context.scope(path);
    let holds = |condition: &Option<_>| match condition {
        Some(condition) => scope.condition(condition),
        None => Ok(true),
    };
    Ok(match fragment {
        FragmentKind::While(condition, _) if !holds(condition)? => None,
        FragmentKind::Alternative(cases) => {
            let mut offered = BTreeMap::new();
            for (index, case) in cases.iter().enumerate() {
                if holds(&case.condition)? {
                    offered.insert(index, Cut::default());
                }
            }
            match (offered.len(), offered.first_key_value()) {
                (0, _) => None,
                (1, Some((&index, _))) => Some(Inside::Body(index, Box::default())),
                _ => Some(Inside::Undecided(offered)),
            }
        }
        FragmentKind::Parallel(branches) => Some(Inside::Branches(vec![Cut::default(); branches.len()])),
        _ => Some(Inside::Body(0, Box::default())),
    })
}

/// Unsets the variables of a body that the cut has left.
fn leave(variables: &mut Variables, body: &[usize]) {
    variables.retain(|(declared, _), _| !declared.starts_with(body));
}
