//! Asking play-out for what is not known yet.

use super::groups::GroupId;
use super::moves::{Gap, Miss, PackedMoves, Source, moves};
use super::tables::{Place, Reaction, Successors, Wish, class, flag};
use super::trees::{Look, NOTHING, Node};
use crate::game::YIELD;
use crate::model::{Moment, Reads, Value};
use crate::playout::{
    Config, CopyId, EventId, KeyId, Moves, Offers, Outcome, PlayError, Playout, Sight, Urgency,
};

/// What learning came to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Learned {
    /// The moves are known.
    Moves,
    /// Rows have no room for them: the layout must be widened first.
    Narrow,
}

/// Finds the moves of a state and keeps what they follow from. Values that rows have no room for are appended to `narrow`,
/// with their fields.
///
/// # Errors
/// Those of [`Playout::moves`].
pub(crate) fn learn(
    successors: &mut Successors,
    playout: &mut Playout<'_>,
    row: &[u64],
    narrow: &mut Vec<(u32, u32)>,
    out: &mut PackedMoves,
) -> Result<Learned, (Option<EventId>, PlayError)> {
    let noted = narrow.len();
    let mut learner =
        Learner { successors, playout, narrow, before: Vec::new(), after: Vec::new(), stuck: false };
    if moves(&mut learner, row, out).is_err() && !learner.stuck {
        learner.play(row, out)?;
    }
    Ok(if narrow.len() > noted { Learned::Narrow } else { Learned::Moves })
}

impl Successors {
    /// Packs a state; fields that are too narrow are widened, so this is for a time when there are no rows yet.
    pub(crate) fn pack_first(&mut self, playout: &Playout<'_>, config: &Config) -> Vec<u64> {
        let fields = self.take_apart(playout, config);
        self.set_layout(self.widened(&fields));
        let mut row = vec![0; self.layout.words()];
        for (field, value) in fields {
            self.layout.field(field as usize).write(&mut row, value);
        }
        row
    }
}

struct Learner<'l, 's> {
    successors: &'l mut Successors,
    playout: &'l mut Playout<'s>,
    narrow: &'l mut Vec<(u32, u32)>,
    before: Vec<Value>,
    after: Vec<Value>,
    /// An attribute has no room for its value; otherwise whatever cannot be filled is a mistake.
    stuck: bool,
}

impl Source for Learner<'_, '_> {
    fn tables(&self) -> &Successors {
        self.successors
    }

    fn fill(&mut self, gap: Gap, before: &[u64], after: &[u64]) -> Result<(), Miss> {
        match gap {
            Gap::Leaf(place) => return self.leaf(place, before, after),
            Gap::Join(value, copy) => self.successors.groups.join(value, copy),
            Gap::Union(a, b) => {
                self.successors.sets.unite(a, b);
            }
            Gap::Narrow(field, value) => {
                self.narrow.push((field, value));
                self.stuck = true;
            }
        }
        self.successors.keep_up(self.playout);
        Ok(())
    }

    fn widen(&mut self, fields: &[(u32, u32)]) -> Result<(), Miss> {
        self.narrow.extend_from_slice(fields);
        Ok(())
    }
}

impl Learner<'_, '_> {
    /// Computes a leaf, and grows the tree by it. Fails if a mistake shows.
    fn leaf(&mut self, place: Place, before: &[u64], after: &[u64]) -> Result<(), Miss> {
        self.successors.values(self.playout, before, &mut self.before);
        self.successors.values(self.playout, after, &mut self.after);
        let reads = Reads::default();
        let leaf = match place {
            Place::Link(event) => u32::from(!self.playout.observe_link(event, &self.before, &reads)),
            Place::Effects(event) => self.effects(event, &reads)?,
            Place::Starts(event) => {
                let sight = Sight { before: &self.before, after: &self.after };
                let outcome = self.playout.observe_starts(event, sight, &reads);
                self.successors.keep_up(self.playout);
                let mut reaction = Reaction { flags: 0, value: 0, discharged: 0, joins: (0, 0) };
                let start = self.successors.joins.len() as u32;
                self.add(&outcome, &mut reaction)?;
                self.successors.joins.extend_from_slice(&outcome.copies);
                reaction.joins = (start, self.successors.joins.len() as u32);
                self.keep_reaction(reaction, 0)
            }
            Place::Reaction(group, event) | Place::Settling(group, event) => {
                self.reaction(group, event, &reads)?
            }
            Place::Offers(group) => self.offers(group, &reads)?,
        };
        self.successors.keep_up(self.playout);
        let looks = self.looks(reads, before, after);
        let root = self.successors.root(place);
        *self.successors.root_mut(place) = self.successors.trees.grow(root, &looks, leaf);
        if let Place::Reaction(group, event) = place {
            let slot = self.successors.groups.slot_of(self.successors.groups.get(group).copies[0]);
            self.successors.note_bar(slot, event);
        }
        Ok(())
    }

    fn looks(&self, reads: Reads, before: &[u64], after: &[u64]) -> Vec<Look> {
        let looks = reads.into_list().into_iter().filter_map(|(slot, moment)| {
            let field = self.successors.field_of[slot]?;
            let row = if moment == Moment::Before { before } else { after };
            Some(Look { field, moment, value: self.successors.layout.field(field as usize).read(row) })
        });
        looks.collect()
    }

    fn effects(&mut self, event: EventId, reads: &Reads) -> Result<Node, Miss> {
        let mut assigned = Vec::new();
        self.after.clone_from(&self.before);
        if !self.playout.observe_effects(event, &mut self.after, &mut assigned, reads) {
            return Err(Miss);
        }
        assigned.sort_unstable();
        assigned.dedup();
        let start = self.successors.assignments.len() as u32;
        for slot in assigned {
            if let Some(field) = self.successors.field_of[slot] {
                let value = self.successors.number(field, self.after[slot]);
                self.successors.assignments.push((field, value));
            }
        }
        self.successors.effects.push((start, self.successors.assignments.len() as u32));
        Ok(self.successors.effects.len() as Node - 1)
    }

    fn reaction(&mut self, group: GroupId, event: EventId, reads: &Reads) -> Result<Node, Miss> {
        let copies = self.successors.groups.get(group).copies.clone();
        let mut reaction = Reaction { flags: 0, value: 0, discharged: 0, joins: (0, 0) };
        let mut next: Vec<CopyId> = Vec::new();
        for &copy in &copies {
            let sight = Sight { before: &self.before, after: &self.after };
            let outcome = self.playout.observe_reaction(copy, event, sight, reads);
            self.successors.keep_up(self.playout);
            self.add(&outcome, &mut reaction)?;
            next.extend_from_slice(&outcome.copies);
        }
        next.sort_unstable();
        next.dedup();
        let slot = self.successors.groups.slot_of(copies[0]);
        let start = self.successors.joins.len() as u32;
        for &copy in next.iter().filter(|&&copy| self.successors.groups.slot_of(copy) != slot) {
            self.successors.joins.push(copy);
        }
        reaction.joins = (start, self.successors.joins.len() as u32);
        next.retain(|&copy| self.successors.groups.slot_of(copy) == slot);
        let here = self.successors.groups.value(slot, &copies);
        reaction.value = self.successors.groups.value(slot, &next);
        Ok(self.keep_reaction(reaction, here))
    }

    /// Adds what a copy comes to, but for its successors. Fails if a mistake shows.
    fn add(&mut self, outcome: &Outcome, reaction: &mut Reaction) -> Result<(), Miss> {
        if outcome.at_once.error.is_some() || outcome.in_settling.error.is_some() {
            return Err(Miss);
        }
        for breach in outcome.at_once.breaches.iter().chain(&outcome.in_settling.breaches) {
            reaction.flags |= Successors::violation(self.playout, breach.scenario);
        }
        if !outcome.at_once.breaches.is_empty() {
            reaction.flags |= flag::AT_ONCE;
        }
        if outcome.completed {
            reaction.flags |= flag::COMPLETED;
        }
        let mut discharged: Vec<KeyId> = outcome.discharged.clone();
        self.playout.retain_counted(&mut discharged);
        let discharged = self.successors.sets.intern(&discharged);
        reaction.discharged = self.successors.sets.unite(reaction.discharged, discharged);
        Ok(())
    }

    /// The leaf for a reaction of a slot that held `value`.
    fn keep_reaction(&mut self, reaction: Reaction, value: u32) -> Node {
        let Reaction { flags, discharged, joins, .. } = reaction;
        if flags == 0 && reaction.value == value && discharged == 0 && joins.0 == joins.1 {
            return NOTHING;
        }
        self.successors.reactions.push(reaction);
        self.successors.reactions.len() as Node - 1
    }

    fn offers(&mut self, group: GroupId, reads: &Reads) -> Result<Node, Miss> {
        let copies = self.successors.groups.get(group).copies.clone();
        let mut wishes: Vec<Wish> = Vec::new();
        for &copy in &copies {
            let relaxed = self.playout.is_relaxed(self.playout.copy(copy).scenario);
            let Offers { system, environment } = self.playout.observe_offers(copy, &self.before, reads);
            for (modality, wanted) in system {
                let class = match modality.into() {
                    Urgency::Committed => class::SYSTEM_COMMITTED,
                    Urgency::Urgent => class::SYSTEM_URGENT,
                    Urgency::Eventually => class::SYSTEM_EVENTUALLY,
                };
                wishes.push(Wish { class, relaxed, event: wanted.map_err(|_| Miss)? });
            }
            for (modality, event) in environment {
                let class = match modality.map(Urgency::from) {
                    Some(Urgency::Committed) => class::ENVIRONMENT_COMMITTED,
                    Some(Urgency::Urgent) => class::ENVIRONMENT_URGENT,
                    Some(Urgency::Eventually) | None => class::ENVIRONMENT,
                };
                wishes.push(Wish { class, relaxed, event });
            }
        }
        if wishes.is_empty() {
            return Ok(NOTHING);
        }
        let start = self.successors.wishes.len() as u32;
        self.successors.wishes.append(&mut wishes);
        self.successors.offers.push((start, self.successors.wishes.len() as u32));
        Ok(self.successors.offers.len() as Node - 1)
    }

    /// Lets play-out find the moves, since a mistake may be among them.
    fn play(&mut self, row: &[u64], out: &mut PackedMoves) -> Result<(), (Option<EventId>, PlayError)> {
        let (mut config, mut found) = (Config::default(), Moves::default());
        self.successors.load(self.playout, row, &mut self.before, &mut config);
        self.playout.moves(&config, &mut found)?;
        self.successors.keep_up(self.playout);
        let words = self.successors.layout.words();
        out.clear(words);
        (out.turn, out.silent) = (found.turn, found.silent);
        self.successors.open_keys(row, &mut out.open_keys);
        for one in &found.moves {
            let mut target = vec![0; words];
            if one.end.is_none() {
                for (field, value) in self.successors.take_apart(self.playout, &one.config) {
                    let place = self.successors.layout.field(field as usize);
                    if place.fits(value) {
                        place.write(&mut target, value);
                    } else {
                        self.narrow.push((field, value));
                    }
                }
            }
            let discharged = self.successors.sets.intern(&one.discharged);
            out.push_row((one.event.unwrap_or(YIELD), one.end, one.completed, discharged), &target);
        }
        Ok(())
    }
}
