//! What each stage took, and how large it left things.

use crate::controller::Controller;
use crate::explore::Explored;
use crate::game::Strategy;
use crate::plant::{ClosedLoop, EventId};
use std::time::{Duration, Instant};

/// Stages so far, in order.
#[derive(Clone, Debug, Default)]
pub struct Timings {
    stages: Vec<Stage>,
    /// Most bytes that the process has held so far; none if nobody can say.
    peak: Option<fn() -> Option<u64>>,
}

/// A stage that ended.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stage {
    /// Its name; a stage can run twice.
    pub name: &'static str,
    /// How long it ran.
    pub time: Duration,
    /// How large its product is, if that is a graph.
    pub size: Option<Size>,
    /// Most bytes that the process had held when it ended.
    pub peak: Option<u64>,
}

/// The size of a graph: of a game, a strategy, a controller, or a product with it.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Size {
    /// States or nodes.
    pub states: usize,
    /// Transitions, if they are kept; of a controller its rows and super steps.
    pub edges: Option<usize>,
    /// Bytes held for the states, with their index and with what is remembered of steps, if they are counted.
    pub of_states: Option<usize>,
    /// Bytes held for the edges, if they are counted.
    pub of_edges: Option<usize>,
}

impl Timings {
    /// Stages are to be asked after how many bytes the process has held at most.
    #[must_use]
    pub fn with_peak(peak: fn() -> Option<u64>) -> Self {
        Timings { stages: Vec::new(), peak: Some(peak) }
    }

    /// Runs one stage.
    // One function for each stage: profilers can tell stages apart by it.
    #[inline(never)]
    pub fn stage<T>(&mut self, name: &'static str, run: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = run();
        let (time, peak) = (start.elapsed(), self.peak.and_then(|peak| peak()));
        self.stages.push(Stage { name, time, size: None, peak });
        result
    }

    /// How large the product of the last stage is.
    pub fn size(&mut self, size: Size) {
        if let Some(last) = self.stages.last_mut() {
            last.size = Some(size);
        }
    }

    /// Stages so far, in order.
    #[must_use]
    pub fn stages(&self) -> &[Stage] {
        &self.stages
    }

    /// Time of all stages.
    #[must_use]
    pub fn total(&self) -> Duration {
        self.stages.iter().map(|stage| stage.time).sum()
    }
}

impl Size {
    /// Without edges and without bytes.
    #[must_use]
    pub fn of_nodes(states: usize) -> Size {
        Size { states, ..Size::default() }
    }

    /// Of the explored game.
    #[must_use]
    pub fn of_game(explored: &Explored<'_>) -> Size {
        Size {
            states: explored.game.states(),
            edges: Some(explored.game.edges()),
            of_states: Some(explored.memory_of_states()),
            of_edges: Some(explored.memory_of_edges()),
        }
    }

    /// Of a strategy.
    #[must_use]
    pub fn of_strategy(strategy: &Strategy) -> Size {
        let Strategy { state, first, edge, target } = strategy;
        Size {
            states: strategy.nodes(),
            edges: Some(edge.len()),
            of_states: Some((state.capacity() + first.capacity()) * size_of::<u32>()),
            of_edges: Some((edge.capacity() + target.capacity()) * size_of::<u32>()),
        }
    }

    /// Of a plant under its feedback.
    #[must_use]
    pub fn of_closed_loop(closed: &ClosedLoop) -> Size {
        let ClosedLoop { states, first, edges, first_inhibited, inhibited, .. } = closed;
        let numbers = first.capacity() + first_inhibited.capacity() + inhibited.capacity();
        Size {
            states: closed.len(),
            edges: Some(edges.len()),
            of_states: Some(states.capacity() * size_of::<u16>() + numbers * size_of::<u32>()),
            of_edges: Some(edges.capacity() * size_of::<(EventId, u32)>()),
        }
    }

    /// Of a controller.
    #[must_use]
    pub fn of_controller(controller: &Controller) -> Size {
        let Controller { states, environment, super_steps, owed, .. } = controller;
        let numbers = |lists: &mut dyn Iterator<Item = usize>| lists.sum::<usize>() * size_of::<u32>();
        let of_rows = 2 * numbers(&mut environment.iter().map(Vec::capacity));
        let of_super_steps =
            numbers(&mut [&super_steps.source, &super_steps.target].into_iter().map(Vec::capacity))
                + super_steps.events.memory();
        Size {
            states: *states as usize,
            edges: Some(environment.iter().map(Vec::len).sum::<usize>() + super_steps.len()),
            of_states: Some(owed.memory()),
            of_edges: Some(of_rows + of_super_steps),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Size, Timings};

    #[test]
    fn a_size_belongs_to_the_stage_before_it() {
        let mut timings = Timings::with_peak(|| Some(7));
        timings.size(Size::of_nodes(1));
        assert_eq!(timings.stage("explore", || 5), 5);
        timings.size(Size::of_nodes(2));
        timings.stage("solve", || ());
        let found: Vec<_> =
            timings.stages().iter().map(|stage| (stage.name, stage.size, stage.peak)).collect();
        assert_eq!(found, [("explore", Some(Size::of_nodes(2)), Some(7)), ("solve", None, Some(7))]);
        assert_eq!(timings.total(), timings.stages()[0].time + timings.stages()[1].time);
    }
}
