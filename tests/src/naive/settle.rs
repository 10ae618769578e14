//! Settling (section 3, step 4): a copy makes silent moves, one at a time, the textually first one first, until
//! there is none.

use super::cut::{Cut, FragmentPath, Inside, extend, nested};
use super::eval::EvalError;
use super::matching::Context;
use super::spec::Spec;
use super::state::{Attributes, Copy, Variables};
use std::collections::{BTreeMap, BTreeSet};
use synth_core::syntax::ast::{Body, FragmentKind};

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
    /// A nested fragment was entered, which decides no alternative around it.
    Entered,
    /// A fragment was passed, which decides the alternatives around it.
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
            if !seen.insert((copy.cut.clone(), copy.variables.clone())) {
                return Err(SettleError::Loop);
            }
            let mut cut = copy.cut.clone();
            let made = self.silent_move(attributes, &mut copy, body, &[], &mut cut, passed_waits)?;
            copy.cut = cut;
            match made {
                Move::None if copy.cut.at_end(body) => return Ok(Settled::Ended),
                Move::None => return Ok(Settled::Active(copy)),
                Move::Entered | Move::Passed => {}
                Move::Ended => return Ok(Settled::Ended),
                Move::Violated => return Ok(Settled::Violated),
            }
        }
    }

    /// Makes the textually first silent move in a body, whose cut is `cut`; of `copy` only variables change.
    fn silent_move(
        &self,
        attributes: &Attributes,
        copy: &mut Copy,
        body: &Body,
        path: &[usize],
        cut: &mut Cut,
        passed_waits: &mut BTreeSet<FragmentPath>,
    ) -> Result<Move, EvalError> {
        let Some(fragment) = body.fragments.get(cut.next) else { return Ok(Move::None) };
        let here = extend(path, &[cut.next]);
        let context = Context::of(self, attributes, copy);
        let scope = context.scope(path);
        match &fragment.kind {
            FragmentKind::Message(..) => Ok(Move::None),
            FragmentKind::Wait { condition, .. } => {
                if !scope.condition(condition)? {
                    return Ok(Move::None);
                }
                passed_waits.insert(here);
                Ok(passed(cut))
            }
            FragmentKind::Interrupt(condition) if scope.condition(condition)? => Ok(Move::Ended),
            FragmentKind::Violation(condition) if scope.condition(condition)? => Ok(Move::Violated),
            FragmentKind::Interrupt(_) | FragmentKind::Violation(_) | FragmentKind::Variable(_, _, None) => {
                Ok(passed(cut))
            }
            FragmentKind::Variable(ty, name, Some(expr)) => {
                let value = scope.value_of_type(expr, ty)?;
                copy.variables.insert((path.to_vec(), name.text.clone()), value);
                Ok(passed(cut))
            }
            FragmentKind::Assignment(name, expr) => {
                let declaration = self.scenarios[copy.scenario].variable(path, &name.text);
                let (declared, ty) = declaration
                    .ok_or_else(|| EvalError::Malformed(format!("no variable `{}`", name.text)))?;
                let value = scope.value_of_type(expr, ty)?;
                copy.variables.insert((declared, name.text.clone()), value);
                Ok(passed(cut))
            }
            FragmentKind::Body(_)
            | FragmentKind::While(..)
            | FragmentKind::Alternative(_)
            | FragmentKind::Parallel(_) => {
                if cut.inside == Inside::Before {
                    return enter(&context, path, &fragment.kind, cut);
                }
                let mut inside = std::mem::take(&mut cut.inside);
                let inner_move = |index: usize, cut: &mut Cut| -> Result<Inner, EvalError> {
                    let Some(inner) = nested(fragment, index) else { return Ok(Inner::Finished) };
                    let inner_path = extend(&here, &[index]);
                    let made = self.silent_move(attributes, copy, inner, &inner_path, cut, passed_waits)?;
                    if !cut.at_end(inner) {
                        return Ok(Inner::Open(made));
                    }
                    leave(&mut copy.variables, &inner_path);
                    Ok(if made == Move::None { Inner::Finished } else { Inner::Open(made) })
                };
                let made = move_inside(&mut inside, inner_move)?;
                Ok(match made {
                    // The end of a loop's body is where its condition is asked again: before the loop.
                    Inner::Finished if matches!(fragment.kind, FragmentKind::While(..)) => Move::Passed,
                    Inner::Finished => passed(cut),
                    Inner::Open(made) => {
                        cut.inside = inside;
                        made
                    }
                })
            }
        }
    }
}

/// What has happened inside a fragment.
enum Inner {
    /// Nothing, and there is nothing left to do in it.
    Finished,
    /// A move, or nothing while it waits.
    Open(Move),
}

/// Makes the first move inside a nested fragment that has been entered.
fn move_inside(
    inside: &mut Inside,
    mut inner_move: impl FnMut(usize, &mut Cut) -> Result<Inner, EvalError>,
) -> Result<Inner, EvalError> {
    match inside {
        Inside::Before => Ok(Inner::Open(Move::None)),
        Inside::Body(index, cut) => inner_move(*index, cut),
        Inside::Undecided(cases) => {
            for (&index, cut) in cases.iter_mut() {
                match inner_move(index, cut)? {
                    Inner::Open(Move::None) => {}
                    Inner::Open(Move::Passed) => {
                        let cut = std::mem::take(cut);
                        *inside = Inside::Body(index, Box::new(cut));
                        return Ok(Inner::Open(Move::Passed));
                    }
                    // A case without fragments is over at once: leaving it decides for it.
                    made => return Ok(made),
                }
            }
            Ok(Inner::Open(Move::None))
        }
        Inside::Branches(branches) => {
            let mut finished = true;
            for (index, cut) in branches.iter_mut().enumerate() {
                match inner_move(index, cut)? {
                    Inner::Finished => {}
                    Inner::Open(Move::None) => finished = false,
                    made @ Inner::Open(_) => return Ok(made),
                }
            }
            Ok(if finished { Inner::Finished } else { Inner::Open(Move::None) })
        }
    }
}

fn passed(cut: &mut Cut) -> Move {
    cut.pass();
    Move::Passed
}

/// Enters a nested fragment, or passes it.
fn enter(
    context: &Context<'_>,
    path: &[usize],
    fragment: &FragmentKind,
    cut: &mut Cut,
) -> Result<Move, EvalError> {
    let scope = context.scope(path);
    let holds = |condition: &Option<_>| match condition {
        Some(condition) => scope.condition(condition),
        None => Ok(true),
    };
    let inside = match fragment {
        FragmentKind::While(condition, _) if !holds(condition)? => return Ok(passed(cut)),
        FragmentKind::Alternative(cases) => {
            let mut offered = BTreeMap::new();
            for (index, case) in cases.iter().enumerate() {
                if holds(&case.condition)? {
                    offered.insert(index, Cut::default());
                }
            }
            match (offered.len(), offered.first_key_value()) {
                (1, Some((&index, _))) => Inside::Body(index, Box::default()),
                (0, _) => return Ok(passed(cut)),
                _ => Inside::Undecided(offered),
            }
        }
        FragmentKind::Parallel(branches) => Inside::Branches(vec![Cut::default(); branches.len()]),
        _ => Inside::Body(0, Box::default()),
    };
    cut.inside = inside;
    Ok(Move::Entered)
}

/// Unsets the variables of a body that the cut has left.
fn leave(variables: &mut Variables, body: &[usize]) {
    variables.retain(|(declared, _), _| !declared.starts_with(body));
}
