//! The product of controller and specification, breadth first.

use super::batch::{add, fill};
use super::graph::{Graph, Rest};
use super::machine::Machine;
use super::nodes::{Control, Nodes};
use super::rules::{Step, steps};
use super::{Refutation, VerifyError};
use crate::controller::Controller;
use crate::model::{Kind, Spec};
use crate::parallel;
use crate::playout::{EventId, KeyId, Playout, Semantics};
use crate::successors::{Block, InOrder, Learned, PackedMoves, SetId, next_batch};
use std::ops::Range;

/// Fewer nodes are not worth another thread.
const LEAST_SHARE: usize = 1 << 10;

/// Edges have `u32` offsets; one node adds fewer than the rest.
const MOST_EDGES: usize = (u32::MAX - (1 << 24)) as usize;

/// The product, and what its numbers mean.
pub(super) struct Product<'s> {
    playout: Playout<'s>,
    nodes: Nodes,
    pub(super) graph: Graph,
}

/// Why exploration ends at a node.
type End = (u32, VerifyError);

impl<'s> Product<'s> {
    /// Explores everything, or stops at the first thing that must not happen.
    pub(super) fn explore(
        spec: &'s Spec,
        semantics: Semantics,
        controller: &Controller,
        most_nodes: usize,
        threads: usize,
    ) -> Result<Self, VerifyError> {
        let unplayed = |error| VerifyError::Play(error, Vec::new());
        let mut playout = Playout::new(spec, semantics).map_err(unplayed)?;
        let config = playout.initial().map_err(unplayed)?;
        let control = Control { state: controller.initial, position: 0 };
        let machine = Machine::new(controller);
        let nodes = Nodes::new(&playout, &config, control, machine.most());
        let product = Product { playout, nodes, graph: Graph::new() };
        let explorer =
            Explorer { product, machine, blocks: Vec::new(), looked_at_again: Block::default(), most_nodes };
        let product = explorer.run(threads)?;
        // Last, because what the play itself shows says more.
        check_components(spec, controller)?;
        Ok(product)
    }

    /// How many sets of keys the graph can name; they are below it.
    pub(super) fn sets(&self) -> SetId {
        let Graph { open, steps, .. } = &self.graph;
        open.iter().chain(&steps.discharged).max().map_or(0, |set| set + 1)
    }

    /// The keys of a set, ascending.
    pub(super) fn keys(&self, set: SetId) -> impl Iterator<Item = KeyId> + use<'_> {
        self.nodes.keys(set)
    }

    /// Texts of a shortest play into a node.
    pub(super) fn play(&self, node: u32) -> Vec<String> {
        self.graph.play(node).into_iter().map(|edge| self.edge_text(edge)).collect()
    }

    /// The text of an edge.
    pub(super) fn edge_text(&self, edge: u32) -> String {
        self.text(self.graph.event(edge))
    }

    fn text(&self, event: Option<EventId>) -> String {
        self.playout.text(event).to_owned()
    }

    /// A play into a node, and then perhaps an event.
    fn play_and(&self, node: u32, last: Option<EventId>) -> Vec<String> {
        let mut play = self.play(node);
        play.extend(last.map(|event| self.text(Some(event))));
        play
    }

    /// Whether a key belongs to an assumption.
    pub(super) fn is_assumed(&self, key: KeyId) -> bool {
        self.playout.spec().scenarios[self.playout.key(key).scenario].kind == Kind::Assumption
    }

    /// The keys that are open in some node, ascending; there are so many sets of them.
    pub(super) fn open_keys(&self, sets: SetId) -> Vec<KeyId> {
        let mut used = vec![false; sets as usize];
        self.graph.open.iter().for_each(|&set| used[set as usize] = true);
        let used = (0..sets).filter(|&set| used[set as usize]);
        let mut is_open = vec![false; self.playout.key_count()];
        used.flat_map(|set| self.keys(set)).for_each(|key| is_open[key as usize] = true);
        (0..).zip(is_open).filter_map(|(key, is_open)| is_open.then_some(key)).collect()
    }

    /// The name of the scenario that a key belongs to.
    pub(super) fn scenario_of(&self, key: KeyId) -> &str {
        &self.playout.spec().scenarios[self.playout.key(key).scenario].name
    }
}

/// Makes the product.
struct Explorer<'c, 's> {
    product: Product<'s>,
    machine: Machine<'c>,
    /// The batch: what threads found, and the nodes that had to be looked at again.
    blocks: Vec<Block>,
    looked_at_again: Block,
    most_nodes: usize,
}

impl<'s> Explorer<'_, 's> {
    fn run(mut self, threads: usize) -> Result<Product<'s>, VerifyError> {
        while self.product.graph.nodes() < self.product.nodes.len() {
            let Product { graph, nodes, .. } = &self.product;
            let batch = next_batch(graph.nodes(), nodes.len(), graph.target.len());
            let (filled, end) = self.find(&batch, threads);
            let (blocks, again) =
                (std::mem::take(&mut self.blocks), std::mem::take(&mut self.looked_at_again));
            self.merge(&blocks[..filled], &again, end.as_ref().map(|end| end.0), threads)?;
            if let Some((_, error)) = end {
                return Err(error);
            }
            (self.blocks, self.looked_at_again) = (blocks, again);
        }
        Ok(self.product)
    }

    /// Finds what a batch leads to, up to the first node with which something is wrong; how many blocks have been filled.
    fn find(&mut self, batch: &Range<u32>, threads: usize) -> (usize, Option<End>) {
        let Explorer { product, machine, blocks, looked_at_again: again, .. } = self;
        let mut moves = PackedMoves::default();
        let (mut found, mut row): (Vec<Step>, _) = Default::default();
        loop {
            let filled = fill(blocks, &product.nodes, machine, batch.clone(), threads);
            again.clear(product.nodes.known());
            let mut narrow = Vec::new();
            let mut end = None;
            let heads = blocks[..filled].iter().flat_map(Block::heads);
            for (node, _) in batch.clone().zip(heads).filter(|(_, head)| head.missed) {
                match product.nodes.learn(&mut product.playout, node, &mut narrow, &mut moves) {
                    Ok(Learned::Moves) => {}
                    Ok(Learned::Narrow) => continue,
                    Err((event, mistake)) => {
                        end = Some((node, VerifyError::Play(mistake, product.play_and(node, event))));
                        break;
                    }
                }
                machine.keep_up(&product.playout);
                let (_, control) = product.nodes.get(node, &mut row);
                if let Err(fault) = steps(machine, control, &moves, &mut found) {
                    let (event, reason) = fault.reason(machine, control, &product.playout);
                    let play = product.play_and(node, event);
                    end = Some((node, VerifyError::Refuted(Refutation { reason, play, cycle: Vec::new() })));
                    break;
                }
                add(again, &product.nodes, &moves, &found);
            }
            if narrow.is_empty() {
                again.look_up(product.nodes.known());
                return (filled, end);
            }
            product.nodes.widen(&narrow);
        }
    }

    /// Numbers what was found and adds it to the graph, up to a node.
    fn merge(
        &mut self,
        blocks: &[Block],
        again: &Block,
        end: Option<u32>,
        threads: usize,
    ) -> Result<(), VerifyError> {
        let Product { nodes: Nodes { successors, rows, .. }, graph, .. } = &mut self.product;
        let mut steps = std::mem::take(&mut graph.steps);
        let size = blocks.iter().map(|block| block.heads().len()).sum::<usize>() / LEAST_SHARE;
        let number = || {
            let mut states = InOrder::new(blocks, again);
            while let Some((head, edges, reader)) = states.next() {
                if rows.len() > self.most_nodes || graph.target.len() > MOST_EDGES {
                    return Err(VerifyError::TooLarge(self.most_nodes));
                }
                if end == Some(graph.nodes() as u32) {
                    break;
                }
                graph.add_edges(edges.iter().map(|_| reader.target(rows)));
                let open = reader.open(head, successors.key_sets_builder_mut());
                graph.add_node(open, Rest { environment: head.turn.is_environment(), silent: head.silent });
            }
            Ok(())
        };
        let copy = || {
            let mut states = InOrder::new(blocks, again);
            while let Some((_, edges, _)) = states.next() {
                steps.add(edges.iter().map(|edge| (edge.event, edge.discharged)));
            }
        };
        let numbered = parallel::both(size, threads, number, copy);
        graph.steps = steps;
        numbered
    }
}

/// Every command of a super step must have a code at the component that receives it.
fn check_components(spec: &Spec, controller: &Controller) -> Result<(), VerifyError> {
    let is_controllable = |name: &str| {
        let object = spec.domain.objects.iter().position(|object| object.name == name);
        object.is_some_and(|object| spec.controllable[object])
    };
    for &command in controller.super_steps.iter().flat_map(|step| step.events) {
        let event = &controller.commands[command as usize];
        let component = controller.components.iter().find(|component| component.object == event.receiver);
        let has_code = component.is_some_and(|component| component.commands.contains(&command));
        if !has_code && !is_controllable(&event.receiver) {
            let reason = format!("`{}` has no command code at `{}`", event.text, event.receiver);
            return Err(VerifyError::Refuted(Refutation { reason, play: Vec::new(), cycle: Vec::new() }));
        }
    }
    Ok(())
}
