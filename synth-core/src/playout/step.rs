//! One step: `step(state, event)` of the language reference, section 3.

use super::copies::CopyId;
use super::cut::{Rest, Walker};
use super::events::{Event, EventId};
use super::keys::KeyId;
use super::react::{Consequence, Occasion, Outcome, bind_roles, plays};
use super::reasons::{Breach, Objection};
use super::{Config, PlayError, Playout, ValuationId, play_error};
use crate::diagnostic::Code;
use crate::model::{
    Effect, EffectAssignment, Endpoint, Failure, Kind, Moment, Reads, Scope, SlotId, Snapshot, Spec, UNSET,
    Value,
};

/// What a step leads to. Reused from step to step to save allocations.
#[derive(Clone, Debug, Default)]
pub struct Step {
    /// The state after it.
    pub config: Config,
    /// Scenarios that it violates, as indices, ascending, without relaxed ones.
    pub violated: Vec<usize>,
    /// Relaxed scenarios that it violates, which does not count; ascending.
    pub excused: Vec<usize>,
    /// Keys that it discharges, ascending, without duplicates.
    pub discharged: Vec<KeyId>,
    /// A copy of the existential scenario that is followed comes to its end.
    pub completed: bool,
    /// A mistake met on the way; the rest of the result is then a best effort.
    pub error: Option<PlayError>,
}

impl Step {
    fn add(&mut self, outcome: &Outcome, settling: &mut Consequence) {
        self.config.copies.extend_from_slice(&outcome.copies);
        self.discharged.extend_from_slice(&outcome.discharged);
        self.completed |= outcome.completed;
        self.violated.extend(outcome.at_once.breaches.iter().map(|breach| breach.scenario));
        settling.breaches.extend_from_slice(&outcome.in_settling.breaches);
        for (all, one) in [(&mut self.error, &outcome.at_once), (&mut settling.error, &outcome.in_settling)] {
            if all.is_none() {
                all.clone_from(&one.error);
            }
        }
    }

    /// Whether a scenario of this kind is violated.
    #[must_use]
    pub fn violates(&self, spec: &Spec, kind: Kind) -> bool {
        self.violated.iter().any(|&scenario| spec.scenarios[scenario].kind == kind)
    }
}

impl Playout<'_> {
    /// The initial state: declared values and the copies of scenarios that start at once, settled.
    ///
    /// # Errors
    /// A scenario is violated from the start, or a mistake shows while settling.
    pub fn initial(&mut self) -> Result<Config, PlayError> {
        Ok(self.begin()?.config)
    }

    /// The initial state like [`Playout::initial`], as if a step had led there.
    ///
    /// # Errors
    /// The same.
    pub fn begin(&mut self) -> Result<Step, PlayError> {
        let mut begin = Step::default();
        let config = &mut begin.config;
        for index in 0..self.spec.scenarios.len() {
            let scenario = &self.spec.scenarios[index];
            if !plays(scenario, index, self.followed) || !scenario.initial.is_empty() {
                continue;
            }
            let reads = Reads::default();
            let mut walker = Walker {
                spec: self.spec,
                scenario,
                attributes: Snapshot {
                    values: &self.spec.domain.initial,
                    moment: Moment::After,
                    reads: &reads,
                },
                roles: vec![UNSET; scenario.roles.len()],
                variables: vec![UNSET; scenario.variables.len()],
                cut: Vec::new(),
                passed: Vec::new(),
                error: None,
            };
            let is_bound = bind_roles(&mut walker);
            let rest = if is_bound && walker.enter(0) { walker.settle() } else { Rest::Ended };
            if let Some(error) = walker.error {
                return Err(error);
            }
            match rest {
                Rest::Waits => {
                    let Walker { roles, variables, cut, .. } = walker;
                    let identity = super::copies::Identity {
                        scenario: index,
                        roles: roles.into(),
                        variables: variables.into(),
                        cut: cut.into(),
                    };
                    config.copies.push(self.copies.intern(self.spec, &mut self.keys, identity));
                }
                Rest::Violated(_) | Rest::Ended if self.followed == Some(index) => {
                    begin.completed = is_bound && walker.is_completed(rest);
                }
                Rest::Violated(_) if !self.is_relaxed(index) => {
                    return Err(PlayError {
                        code: Code::ViolatedInitially,
                        span: scenario.span,
                        message: format!("scenario `{}` is violated in the initial state", scenario.name),
                    });
                }
                Rest::Violated(_) | Rest::Ended => {}
            }
        }
        config.copies.sort_unstable();
        Ok(begin)
    }

    /// What `event` does in `config`, whether or not it may happen there.
    pub fn step(&mut self, config: &Config, event: EventId, step: &mut Step) {
        step.violated.clear();
        step.discharged.clear();
        step.config.copies.clear();
        step.config.yielded = false;
        step.completed = false;
        let (valuation, mistake) = self.effects(config.valuation, event);
        step.config.valuation = valuation;
        step.error = mistake;
        let mut settling = Consequence::default();
        self.outcomes(config, event, valuation, |_, outcome| step.add(outcome, &mut settling));
        // Behind a mistake, settling would look at values that are none.
        if step.error.is_none() {
            step.violated.extend(settling.breaches.iter().map(|breach| breach.scenario));
            step.error = settling.error;
        }
        for list in [&mut step.config.copies, &mut step.discharged] {
            list.sort_unstable();
            list.dedup();
        }
        step.violated.sort_unstable();
        step.violated.dedup();
        self.excuse(step);
    }

    /// Visits what becomes of every active copy, and then what the event starts. `after` is the valuation behind the
    /// event's effects.
    fn outcomes(
        &mut self,
        config: &Config,
        event: EventId,
        after: ValuationId,
        mut visit: impl FnMut(Option<CopyId>, &Outcome),
    ) {
        let occasion = Occasion {
            spec: self.spec,
            followed: self.followed,
            id: event,
            event: self.events.get(event),
            valuation: config.valuation,
            before: self.valuations.get(config.valuation),
            after: self.valuations.get(after),
        };
        for &copy in &config.copies {
            visit(Some(copy), self.reactions.react(&mut self.copies, &mut self.keys, copy, &occasion));
        }
        visit(None, self.reactions.start(&mut self.copies, &mut self.keys, &occasion));
    }

    /// How the event violates scenarios in `config`, and the copies that it starts.
    pub(super) fn breaches(&mut self, config: &Config, event: EventId) -> (Vec<Objection>, Vec<CopyId>) {
        let (after, mistake) = self.effects(config.valuation, event);
        let (mut objections, mut in_settling, mut started) = (Vec::new(), Vec::new(), Vec::new());
        let mut mistaken = mistake.is_some();
        self.outcomes(config, event, after, |copy, outcome| {
            let objection =
                |breach: &Breach| Objection { copy, scenario: breach.scenario, ground: breach.ground };
            mistaken |= outcome.at_once.error.is_some();
            objections.extend(outcome.at_once.breaches.iter().map(objection));
            in_settling.extend(outcome.in_settling.breaches.iter().map(objection));
            if copy.is_none() {
                started.extend_from_slice(&outcome.copies);
            }
        });
        if !mistaken {
            objections.append(&mut in_settling);
        }
        objections.retain(|objection| !self.is_relaxed(objection.scenario));
        objections.sort_by_key(|objection| (objection.scenario, objection.copy));
        (objections, started)
    }

    /// The valuation after the event's effects: those that match in textual order, then the implicit `setX`.
    fn effects(&mut self, valuation: ValuationId, event: EventId) -> (ValuationId, Option<PlayError>) {
        let event = self.events.get(event);
        if !has_effects(self.spec, event) {
            return (valuation, None);
        }
        let mut values = self.valuations.get(valuation).to_vec();
        let mistake = apply_effects(self.spec, event, &mut values, &Reads::default(), &mut Vec::new());
        (self.valuations.intern(&values), mistake)
    }
}

/// Whether an event assigns anything.
pub(super) fn has_effects(spec: &Spec, event: &Event) -> bool {
    spec.domain.operations[event.operation].sets.is_some()
        || spec.effects.iter().any(|effect| applies(spec, effect, event))
}

/// Runs the effects that match in textual order, then the implicit `setX`, and appends the slots that they assign. Every
/// read counts as one of the state before, also where an assignment went before it: what was assigned follows from
/// that state, too.
pub(super) fn apply_effects(
    spec: &Spec,
    event: &Event,
    values: &mut [Value],
    reads: &Reads,
    assigned: &mut Vec<SlotId>,
) -> Option<PlayError> {
    let mut mistake = None;
    for effect in spec.effects.iter().filter(|effect| applies(spec, effect, event)) {
        for assignment in &effect.assignments {
            match assign(spec, event, assignment, values, reads) {
                Ok(slot) => assigned.push(slot),
                Err(error) => mistake = mistake.or(Some(error)),
            }
        }
    }
    if let Some(attribute) = spec.domain.operations[event.operation].sets {
        // The parameter has the attribute's type, so the value fits.
        let slot = spec.domain.slot(event.receiver, attribute);
        values[slot] = event.arguments[0];
        assigned.push(slot);
    }
    mistake
}

fn applies(spec: &Spec, effect: &Effect, event: &Event) -> bool {
    let at = |endpoint: Endpoint, object: usize| match endpoint {
        Endpoint::Object(o) => o == object,
        Endpoint::Class(class) => spec.domain.is_a(spec.domain.objects[object].class, class),
    };
    effect.operation == event.operation
        && at(effect.sender, event.sender)
        && at(effect.receiver, event.receiver)
}

fn assign(
    spec: &Spec,
    event: &Event,
    assignment: &EffectAssignment,
    values: &mut [Value],
    reads: &Reads,
) -> Result<SlotId, PlayError> {
    let scope = Scope {
        domain: &spec.domain,
        attributes: Snapshot { values, moment: Moment::Before, reads },
        roles: &[],
        variables: &[],
        event: (event.sender as Value, event.receiver as Value, &event.arguments),
    };
    let eval = |expr| scope.eval(expr).map_err(|failure| play_error(failure, assignment.span));
    let owner = eval(&assignment.owner)?;
    let value = eval(&assignment.value)?;
    let Ok(owner) = usize::try_from(owner) else {
        return Err(play_error(Failure::Null(assignment.span), assignment.span));
    };
    if !spec.domain.fits(value, assignment.ty) {
        let class = &spec.domain.classes[assignment.owner_class];
        return Err(PlayError {
            code: Code::PlayOutRange,
            span: assignment.span,
            message: format!(
                "`{}.{}` would become `{value}`, which is not in `{}`",
                spec.domain.objects[owner].name,
                class.attributes[assignment.attribute].name,
                spec.domain.show_type(assignment.ty)
            ),
        });
    }
    let slot = spec.domain.slot(owner, assignment.attribute);
    values[slot] = value;
    Ok(slot)
}
