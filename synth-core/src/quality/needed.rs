//! Assumptions that no guarantee needs.
//!
//! Each is *relaxed* in turn (language reference, "Relaxing"), and the specification explored and solved once more. That costs
//! too much for a large one, so it is done for small ones only.

use super::causes::causes_events;
use super::vacuous::{demands_anything, has_violation};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::{Explored, Limits, explore_with};
use crate::game::solve;
use crate::model::{Kind, Scenario};
use crate::playout::Playout;

/// All explorations together may have so many states, about.
const BUDGET: usize = 20_000;

/// The assumptions without any one of which a realizable specification is still realizable. Those that cause events are
/// needed to cause them; those that the system can break (`warned` of already) would let it, relaxed.
pub(super) fn unneeded(explored: &Explored<'_>, warned: &[Diagnostic]) -> Vec<Diagnostic> {
    let spec = explored.playout.spec();
    let is_broken = |index: usize| {
        let span = spec.scenarios[index].span;
        warned.iter().any(|one| one.code == Code::SystemBreaksAssumption && one.span == span)
    };
    // What was meant to cause an event needs a modality, not to be removed.
    let was_to_cause = |scenario: &Scenario| {
        let marked = warned.iter().filter(|one| one.code == Code::NeverCaused).flat_map(|one| &one.labels);
        scenario.nodes.iter().any(|node| marked.clone().any(|(place, _)| *place == node.span))
    };
    let candidates: Vec<usize> = (0..spec.scenarios.len())
        .filter(|&index| {
            let scenario = &spec.scenarios[index];
            let starts = !warned.iter().any(|one| one.code == Code::NeverStarts && one.span == scenario.span);
            let restricts = demands_anything(scenario) || has_violation(scenario);
            let causes = causes_events(spec, scenario) || was_to_cause(scenario);
            scenario.kind == Kind::Assumption && starts && restricts && !causes && !is_broken(index)
        })
        .collect();
    if candidates.len().saturating_mul(explored.game.states()) > BUDGET {
        return Vec::new();
    }
    let Ok(mut playout) = Playout::new(spec, explored.playout.semantics()) else { return Vec::new() };
    let states = BUDGET / candidates.len().max(1);
    let limits = Limits { states, ..Limits::default() };
    let unneeded = candidates.into_iter().filter(|&index| {
        playout.relax([index]);
        // What was excluded so far may now lead to a mistake, and then the assumption is needed.
        let relaxed = explore_with(&mut playout, &limits);
        relaxed.is_ok_and(|(_, game)| solve(&game).wins(game.initial))
    });
    let warning = |index: usize| {
        let scenario = &spec.scenarios[index];
        let message = format!("no guarantee needs assumption `{}`", scenario.name);
        Diagnostic::warning(Code::NotNeeded, scenario.span, message)
            .label("a controller exists even if the environment breaks this")
            .help("remove it, or keep it as a description of the environment and `--allow SML0099`")
    };
    unneeded.map(warning).collect()
}
