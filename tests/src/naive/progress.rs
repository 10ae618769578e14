//! How an active copy reacts to an event, and which new copies the event starts (section 3, steps 2 and 3).

use super::cut::{Cut, FragmentPath, Inside, extend, is_obligation, is_strict, messages};
use super::eval::{EvalError, names_in};
use super::matching::Context;
use super::spec::Spec;
use super::state::{Attributes, Copy, Key, Roles, State, Variables};
use super::value::Event;
use std::collections::{BTreeMap, BTreeSet};
use synth_core::syntax::ast::{
    ArgumentKind, Body, ConstraintKind, Expr, Fragment, FragmentKind, Message, ScenarioKind,
};

/// What an event does to a copy.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Reaction {
    /// Nothing.
    Stays,
    /// It moves past a message.
    Moves {
        /// Where it stands then, not settled.
        copy: Copy,
        /// The message.
        message: FragmentPath,
    },
    /// It is gone.
    Ends,
    /// It is gone, and its scenario violated.
    Violates,
}

impl Spec {
    /// The reaction of a copy: the first row of the table that applies.
    ///
    /// # Errors
    /// A path through `null` in an argument of a message at the cut, or an integer that a variable does not take.
    pub fn progress(
        &self,
        attributes: &Attributes,
        copy: &Copy,
        event: &Event,
    ) -> Result<Reaction, EvalError> {
        let context = Context::of(self, attributes, copy);
        let body = &context.scenario.body;
        let at_cut = copy.cut.fragments(body);

        for (path, fragment) in &at_cut {
            let FragmentKind::Message(_, message) = &fragment.kind else { continue };
            if let Some((roles, variables)) = context.matches(&path[..path.len() - 1], message, event)? {
                let mut copy = Copy { roles, variables, ..copy.clone() };
                copy.cut.pass_fragment(path);
                return Ok(Reaction::Moves { copy, message: path.clone() });
            }
        }

        let constraints = copy.cut.constraints(body);
        let in_force = |kind| -> Result<bool, EvalError> {
            for (path, constraint) in constraints.iter().filter(|(_, constraint)| constraint.kind == kind) {
                if context.is_like(path, &constraint.message, event)? {
                    return Ok(true);
                }
            }
            Ok(false)
        };
        if in_force(ConstraintKind::Ignore)? {
            return Ok(Reaction::Stays);
        }
        if in_force(ConstraintKind::Forbidden)? {
            return Ok(Reaction::Violates);
        }
        if in_force(ConstraintKind::Interrupt)? {
            return Ok(Reaction::Ends);
        }

        let mut concerned = in_force(ConstraintKind::Consider)?;
        for (path, message) in &messages(body, false) {
            concerned = concerned || context.is_like(path, message, event)?;
        }
        Ok(match (concerned, at_cut.iter().any(|(_, fragment)| is_strict(fragment))) {
            (false, _) => Reaction::Stays,
            (true, true) => Reaction::Violates,
            (true, false) => Reaction::Ends,
        })
    }

    /// The key of an obligation of a copy.
    #[must_use]
    pub fn key(&self, copy: &Copy, path: &[usize], fragment: &Fragment) -> Key {
        let mut names = BTreeSet::new();
        match &fragment.kind {
            FragmentKind::Message(_, message) => {
                for argument in &message.arguments {
                    if let ArgumentKind::Value(expr) = &argument.kind {
                        names.extend(names_in(expr));
                    }
                }
            }
            FragmentKind::Wait { condition, .. } => names.extend(names_in(condition)),
            _ => {}
        }
        let scenario = &self.scenarios[copy.scenario];
        let values = names.into_iter().filter_map(|name| {
            let (declared, _) = scenario.variable(&path[..path.len() - 1], name)?;
            Some((name.to_owned(), copy.variables.get(&(declared, name.to_owned())).cloned()))
        });
        Key {
            scenario: copy.scenario,
            roles: copy.roles.clone(),
            fragment: path.to_vec(),
            values: values.collect(),
        }
    }

    /// The obligations of a copy: fragments at its cut, with their keys.
    #[must_use]
    pub fn obligations(&self, copy: &Copy) -> BTreeMap<FragmentPath, Key> {
        let at_cut = copy.cut.fragments(&self.scenarios[copy.scenario].body).into_iter();
        let obligations = at_cut.filter(|(_, fragment)| is_obligation(fragment));
        obligations.map(|(path, fragment)| (path.clone(), self.key(copy, &path, fragment))).collect()
    }

    /// The keys that are open in a state, all kinds of scenarios together, without relaxed ones.
    #[must_use]
    pub fn open(&self, state: &State) -> BTreeSet<Key> {
        let counted = state.copies.iter().filter(|copy| !self.relaxed.contains(&copy.scenario));
        counted.flat_map(|copy| self.obligations(copy).into_values()).collect()
    }

    /// The copies that an event starts, not settled: `before` are the attributes before its effects, `after` those after.
    ///
    /// # Errors
    /// A path through `null`, or a variable out of its range.
    pub fn activate(
        &self,
        before: &Attributes,
        after: &Attributes,
        event: &Event,
    ) -> Result<Vec<Copy>, EvalError> {
        let mut started = Vec::new();
        for (index, scenario) in self.scenarios.iter().enumerate() {
            if scenario.kind == ScenarioKind::Existential {
                continue;
            }
            for initial in initial_messages(&scenario.body).unwrap_or_default() {
                if let Some(copy) = self.start(index, &initial, before, event)? {
                    started.extend(self.bind_roles(copy, after)?);
                    break;
                }
            }
        }
        Ok(started)
    }

    /// The copy that has just passed an initial message.
    fn start(
        &self,
        scenario: usize,
        initial: &InitialMessage<'_>,
        attributes: &Attributes,
        event: &Event,
    ) -> Result<Option<Copy>, EvalError> {
        let body = &self.scenarios[scenario].body;
        let cut = initial.cut.clone();
        let mut copy = Copy { scenario, roles: Roles::new(), variables: Variables::new(), cut };
        if Context::of(self, attributes, &copy).endpoints_match(initial.message, event).is_none() {
            return Ok(None);
        }
        let path = &initial.path;
        self.declare(attributes, &mut copy, body, &[], path[0])?;
        if let Some(condition) = initial.condition
            && !Context::of(self, attributes, &copy).scope(&[]).condition(condition)?
        {
            return Ok(None);
        }
        if let (Some(inner), [_, _, next]) = (initial.inner, path.as_slice()) {
            self.declare(attributes, &mut copy, inner, &path[..2], *next)?;
        }
        let context = Context::of(self, attributes, &copy);
        let matched = context.matches(&path[..path.len() - 1], initial.message, event)?;
        Ok(matched.map(|(roles, variables)| Copy { roles, variables, ..copy }))
    }

    /// Runs the declarations before fragment `end` of a body.
    fn declare(
        &self,
        attributes: &Attributes,
        copy: &mut Copy,
        body: &Body,
        path: &[usize],
        end: usize,
    ) -> Result<(), EvalError> {
        for fragment in &body.fragments[..end] {
            if let FragmentKind::Variable(ty, name, Some(expr)) = &fragment.kind {
                let value = Context::of(self, attributes, copy).scope(path).value_of_type(expr, ty)?;
                copy.variables.insert((path.to_vec(), name.text.clone()), value);
            }
        }
        Ok(())
    }

    /// Evaluates the `bindings` of a new copy; one that gives `null`, or contradicts the initial message, leaves none.
    ///
    /// # Errors
    /// A path through `null`.
    pub fn bind_roles(&self, mut copy: Copy, attributes: &Attributes) -> Result<Option<Copy>, EvalError> {
        for (role, expr) in &self.scenarios[copy.scenario].bindings {
            match Context::of(self, attributes, &copy).scope(&[]).value(expr)? {
                super::Value::Object(object) => {
                    let bound = copy.roles.entry(role.clone()).or_insert_with(|| object.clone());
                    if *bound != object {
                        return Ok(None);
                    }
                }
                super::Value::Null => return Ok(None),
                other => return Err(EvalError::Malformed(format!("`{role}` bound to `{other}`"))),
            }
        }
        Ok(Some(copy))
    }
}

/// One of the messages with which a scenario can begin.
#[derive(Clone, Debug)]
pub struct InitialMessage<'a> {
    /// Path of the message.
    pub path: Vec<usize>,
    /// The message.
    pub message: &'a Message,
    /// What must hold for the case of an alternative that it stands in.
    pub condition: Option<&'a Expr>,
    /// The case's or branch's body that it stands in, if not the scenario's own.
    pub inner: Option<&'a Body>,
    /// The cut after it.
    pub cut: Cut,
}

/// The initial messages of a scenario; `None` when it starts at once.
#[must_use]
pub fn initial_messages(body: &Body) -> Option<Vec<InitialMessage<'_>>> {
    let (first, fragment) = first_fragment(body)?;
    let at = |inside| Cut { next: first, inside };
    let behind = |next| Cut { next: next + 1, inside: Inside::Before };
    match &fragment.kind {
        FragmentKind::Message(_, message) => {
            let cut = behind(first);
            Some(vec![InitialMessage { path: vec![first], message, condition: None, inner: None, cut }])
        }
        FragmentKind::Alternative(cases) => {
            let initial = cases.iter().enumerate().map(|(index, case)| {
                let (next, message) = first_message(&case.body)?;
                let cut = at(Inside::Body(index, Box::new(behind(next))));
                let path = extend(&[first, index], &[next]);
                Some(InitialMessage {
                    path,
                    message,
                    condition: case.condition.as_ref(),
                    inner: Some(&case.body),
                    cut,
                })
            });
            initial.collect()
        }
        FragmentKind::Parallel(branches) => {
            let initial = branches.iter().enumerate().map(|(index, branch)| {
                let (next, message) = first_message(branch)?;
                let mut cuts = vec![Cut::default(); branches.len()];
                cuts[index] = behind(next);
                let cut = at(Inside::Branches(cuts));
                let path = extend(&[first, index], &[next]);
                Some(InitialMessage { path, message, condition: None, inner: Some(branch), cut })
            });
            initial.collect()
        }
        _ => None,
    }
}

/// The first fragment that is not a declaration.
fn first_fragment(body: &Body) -> Option<(usize, &Fragment)> {
    let mut fragments = body.fragments.iter().enumerate();
    fragments.find(|(_, fragment)| !matches!(fragment.kind, FragmentKind::Variable(..)))
}

fn first_message(body: &Body) -> Option<(usize, &Message)> {
    match first_fragment(body)? {
        (next, Fragment { kind: FragmentKind::Message(_, message), .. }) => Some((next, message)),
        _ => None,
    }
}
