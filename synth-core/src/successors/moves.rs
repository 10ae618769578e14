//! The moves of a packed state: the rules of [`crate::playout::Playout::moves`] over tables.

use super::UNKNOWN_SET;
use super::groups::GroupId;
use super::sets::SetId;
use super::tables::{Place, Successors, YIELDED, class, flag, part};
use super::trees::{NOTHING, Node, UNKNOWN, is_leaf};
use super::wishes::{Wishes, take};
use crate::game::{Turn, YIELD};
use crate::playout::{CopyId, EventId};

/// Something is not known, or a mistake may show.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Miss;

/// What is not known.
#[derive(Clone, Copy, Debug)]
pub(super) enum Gap {
    /// The leaf of a tree.
    Leaf(Place),
    /// The value of a slot with one more copy.
    Join(u32, CopyId),
    /// The union of two sets.
    Union(SetId, SetId),
    /// An attribute would take this value, and its field is too narrow.
    Narrow(u32, u32),
}

/// Tables, and what to do at a gap.
pub(super) trait Source {
    fn tables(&self) -> &Successors;

    /// Fills a gap, given the state before the event and the one behind its effects, or gives up.
    fn fill(&mut self, gap: Gap, before: &[u64], after: &[u64]) -> Result<(), Miss>;

    /// A move needs wider fields for these values.
    fn widen(&mut self, fields: &[(u32, u32)]) -> Result<(), Miss>;
}

/// Only looks up.
impl Source for &Successors {
    fn tables(&self) -> &Successors {
        self
    }

    fn fill(&mut self, _: Gap, _: &[u64], _: &[u64]) -> Result<(), Miss> {
        Err(Miss)
    }

    fn widen(&mut self, _: &[(u32, u32)]) -> Result<(), Miss> {
        Err(Miss)
    }
}

/// A move.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Edge {
    /// The event, or [`YIELD`].
    pub event: EventId,
    /// The game ends with it.
    pub end: Option<Turn>,
    /// A copy of the scenario that is followed comes to its end.
    pub completed: bool,
    /// The keys that it discharges.
    pub discharged: SetId,
    /// Where the row begins that it leads to.
    row: u32,
}

/// A group of the state that may go on when attributes change.
#[derive(Clone, Copy, Debug)]
struct Watching {
    group: GroupId,
    field: u32,
}

/// The moves of one state, and room to find them.
#[derive(Clone, Debug)]
pub struct PackedMoves {
    /// Whose turn it is.
    pub turn: Turn,
    /// The environment may do nothing.
    pub silent: bool,
    /// The set of the keys that are open, or `u32::MAX` where nobody has asked for its number yet.
    pub open: SetId,
    pub(super) open_keys: Vec<u64>,
    edges: Vec<Edge>,
    words: usize,
    rows: Vec<u64>,
    watching: Vec<Watching>,
    wishes: Wishes,
    candidates: Vec<u64>,
    fired: Vec<(u32, u32)>,
    narrow: Vec<(u32, u32)>,
}

impl Default for PackedMoves {
    fn default() -> Self {
        PackedMoves {
            turn: Turn::EnvironmentAny,
            silent: false,
            open: UNKNOWN_SET,
            open_keys: Vec::new(),
            edges: Vec::new(),
            words: 1,
            rows: Vec::new(),
            watching: Vec::new(),
            wishes: Wishes::default(),
            candidates: Vec::new(),
            fired: Vec::new(),
            narrow: Vec::new(),
        }
    }
}

impl PackedMoves {
    /// The moves in the order of the events' texts, a yield last.
    #[must_use]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The state that a move leads to.
    #[must_use]
    #[inline]
    pub fn target(&self, edge: &Edge) -> &[u64] {
        &self.rows[edge.row as usize..][..self.words]
    }

    /// The keys that are open, as a bit for each, 64 a word; words that are left out are 0.
    #[must_use]
    pub(crate) fn open_keys(&self) -> &[u64] {
        &self.open_keys
    }

    pub(super) fn clear(&mut self, words: usize) {
        self.words = words;
        self.silent = false;
        self.open = UNKNOWN_SET;
        self.open_keys.clear();
        self.edges.clear();
        self.rows.clear();
        self.watching.clear();
    }

    /// Appends a move to the last of the rows.
    fn push(&mut self, event: EventId, step: Step, end: Option<Turn>) {
        let row = (self.rows.len() - self.words) as u32;
        let Step { flags, discharged } = step;
        let completed = flags & flag::COMPLETED != 0;
        self.edges.push(Edge { event, end, completed, discharged, row });
    }

    /// Gives up the last of the rows.
    fn drop_row(&mut self) {
        self.rows.truncate(self.rows.len() - self.words);
    }

    /// Appends a move to this state.
    pub(super) fn push_row(&mut self, edge: (EventId, Option<Turn>, bool, SetId), row: &[u64]) {
        let (event, end, completed, discharged) = edge;
        let place = self.rows.len() as u32;
        self.rows.extend_from_slice(row);
        self.edges.push(Edge { event, end, completed, discharged, row: place });
    }
}

/// What a step comes to, beside the state after it.
#[derive(Clone, Copy)]
struct Step {
    flags: u8,
    discharged: SetId,
}

impl Successors {
    /// Finds the moves of a state.
    ///
    /// # Errors
    /// Something is not known yet; [`super::learn`] knows more.
    pub(crate) fn moves(&self, row: &[u64], out: &mut PackedMoves) -> Result<(), Miss> {
        self.moves_and_keys(row, out)?;
        out.open = self.sets.find_bits(&out.open_keys);
        Ok(())
    }

    /// The same for those who look up [`PackedMoves::open_keys`] themselves: [`PackedMoves::open`] is not known.
    ///
    /// # Errors
    /// As for [`Successors::moves`].
    pub(crate) fn moves_and_keys(&self, row: &[u64], out: &mut PackedMoves) -> Result<(), Miss> {
        moves(&mut &*self, row, out)
    }

    /// The same for an event of the system that is known to be wanted: if it shows by itself that its turn has come, its move
    /// is the only one.
    ///
    /// # Errors
    /// As for [`Successors::moves`], or it takes all moves to say whose turn it is.
    pub(crate) fn command(&self, row: &[u64], event: EventId, out: &mut PackedMoves) -> Result<(), Miss> {
        out.clear(self.layout.words());
        survey(&mut &*self, row, out)?;
        let pressing = |one: &&Pressing| out.wishes.has(one.of_system) || out.wishes.has(one.of_environment);
        let (turn, class) = match PRESSING.iter().find(pressing) {
            Some(one) => (one.by_system, one.of_system),
            None if self.layout.field(YIELDED).read(row) == 0 => {
                (Turn::SystemEventually, class::SYSTEM_EVENTUALLY)
            }
            None => return Err(Miss),
        };
        let is_firm = out.wishes.asks(class, self.events[event as usize].rank).ok_or(Miss)?;
        let decides = offer(&mut &*self, row, event, is_firm, out)?;
        out.turn = turn;
        if decides || turn == Turn::SystemEventually && !out.edges.is_empty() { Ok(()) } else { Err(Miss) }
    }

    /// The events that [`Playout::owed`](crate::playout::Playout::owed) gives, into a cleared list.
    ///
    /// # Errors
    /// As for [`Successors::moves`].
    pub(crate) fn owed(&self, row: &[u64], owed: &mut Vec<EventId>) -> Result<(), Miss> {
        owed.clear();
        for (index, &word) in row.iter().enumerate() {
            let mut bits = word & self.layout.slots(index);
            while bits != 0 {
                let (field, value) = self.layout.take(index, word, &mut bits);
                let offers = leaf(&mut &*self, Place::Offers(self.group(field, value)), row, row)?;
                if offers != NOTHING {
                    let wishes = part(&self.wishes, self.offers[offers as usize]).iter();
                    let caused = wishes.filter(|wish| ENVIRONMENT.contains(&wish.class));
                    owed.extend(caused.map(|wish| wish.event));
                }
            }
        }
        owed.sort_unstable();
        owed.dedup();
        Ok(())
    }
}

/// The classes of what assumptions say that the environment sends.
const ENVIRONMENT: [u8; 3] = [class::ENVIRONMENT_COMMITTED, class::ENVIRONMENT_URGENT, class::ENVIRONMENT];

/// The leaf of a tree for the state. Most roots are leaves.
#[inline(always)]
fn leaf<S: Source>(source: &mut S, place: Place, before: &[u64], after: &[u64]) -> Result<Node, Miss> {
    let root = source.tables().root(place);
    if is_leaf(root) { Ok(root) } else { walk(source, place, before, after) }
}

fn walk<S: Source>(source: &mut S, place: Place, before: &[u64], after: &[u64]) -> Result<Node, Miss> {
    loop {
        let tables = source.tables();
        let leaf = tables.trees.walk(tables.root(place), &tables.layout, before, after);
        if leaf != UNKNOWN {
            return Ok(leaf);
        }
        source.fill(Gap::Leaf(place), before, after)?;
    }
}

#[inline]
fn union<S: Source>(source: &mut S, a: SetId, b: SetId) -> Result<SetId, Miss> {
    loop {
        if let Some(union) = source.tables().sets.union(a, b) {
            return Ok(union);
        }
        source.fill(Gap::Union(a, b), &[], &[])?;
    }
}

/// What comes before all that is not pressing: first the system's wishes of a class, then the environment's.
struct Pressing {
    by_system: Turn,
    of_system: u8,
    by_environment: Turn,
    of_environment: u8,
}

/// The classes of pressing wishes, the most pressing first.
const PRESSING: [Pressing; 2] = [
    Pressing {
        by_system: Turn::SystemCommitted,
        of_system: class::SYSTEM_COMMITTED,
        by_environment: Turn::EnvironmentCommitted,
        of_environment: class::ENVIRONMENT_COMMITTED,
    },
    Pressing {
        by_system: Turn::SystemUrgent,
        of_system: class::SYSTEM_URGENT,
        by_environment: Turn::EnvironmentUrgent,
        of_environment: class::ENVIRONMENT_URGENT,
    },
];

pub(super) fn moves<S: Source>(source: &mut S, row: &[u64], out: &mut PackedMoves) -> Result<(), Miss> {
    out.clear(source.tables().layout.words());
    survey(source, row, out)?;
    let yielded = source.tables().layout.field(YIELDED).read(row) != 0;
    for Pressing { by_system, of_system, by_environment, of_environment } in PRESSING {
        if system_moves(source, row, of_system, out)? {
            out.turn = by_system;
            return Ok(());
        }
        if !out.wishes.has(of_environment) {
            continue;
        }
        // Moves that do not decide the turn, because of what is relaxed: the system may make one of them.
        let offered = out.edges.len();
        out.candidates.clear();
        out.candidates.resize(out.wishes.words(), 0);
        out.wishes.add_to(of_environment, &mut out.candidates);
        if environment_moves(source, row, out)? {
            if offered > 0 && !yielded {
                out.edges.truncate(offered);
                offer_yield(source.tables(), row, out);
            } else {
                out.edges.drain(..offered);
                out.turn = by_environment;
            }
            return Ok(());
        }
        out.edges.truncate(offered);
    }
    if yielded {
        out.edges.clear();
    } else {
        system_moves(source, row, class::SYSTEM_EVENTUALLY, out)?;
        if !out.edges.is_empty() {
            offer_yield(source.tables(), row, out);
            return Ok(());
        }
    }
    out.candidates.clear();
    out.candidates.extend_from_slice(&source.tables().spontaneous);
    add_caused(out);
    environment_moves(source, row, out)?;
    out.turn = Turn::EnvironmentAny;
    out.silent = !source.tables().classic || out.edges.is_empty();
    Ok(())
}

/// Finds what is asked for, the open keys, and the groups that may go on when attributes change.
fn survey<S: Source>(source: &mut S, row: &[u64], out: &mut PackedMoves) -> Result<(), Miss> {
    'anew: loop {
        let events = source.tables().events.len();
        let PackedMoves { watching, open_keys, wishes, .. } = &mut *out;
        wishes.clear(events);
        watching.clear();
        open_keys.clear();
        open_keys.resize(source.tables().key_words(), 0);
        for (index, &word) in row.iter().enumerate() {
            let mut bits = word & source.tables().layout.slots(index);
            while bits != 0 {
                let tables = source.tables();
                let (field, value) = tables.layout.take(index, word, &mut bits);
                let group = tables.group(field, value);
                tables.add_open_keys(group, open_keys);
                if tables.entries[group as usize].settling != NOTHING {
                    watching.push(Watching { group, field });
                }
                let offers = leaf(source, Place::Offers(group), row, row)?;
                // What was just found out may have brought new events, and with them other places in the order.
                if source.tables().events.len() != events {
                    continue 'anew;
                }
                if offers != NOTHING {
                    let tables = source.tables();
                    for wish in part(&tables.wishes, tables.offers[offers as usize]) {
                        let rank = tables.events[wish.event as usize].rank;
                        wishes.insert(wish.class, wish.relaxed, rank);
                    }
                }
            }
        }
        return Ok(());
    }
}

/// Adds to the candidates what assumptions say that the environment sends.
fn add_caused(out: &mut PackedMoves) {
    let PackedMoves { wishes, candidates, .. } = out;
    for class in ENVIRONMENT {
        wishes.add_to(class, candidates);
    }
}

/// Appends the system's executable events of one class; whether they decide the turn. They do if one is among them
/// that a guarantee in force asks for and that needs nothing relaxed to be executable.
fn system_moves<S: Source>(
    source: &mut S,
    row: &[u64],
    class: u8,
    out: &mut PackedMoves,
) -> Result<bool, Miss> {
    if !out.wishes.has(class) {
        return Ok(false);
    }
    let carried = out.edges.len();
    let mut decides = false;
    for index in 0..out.wishes.words() {
        let (mut bits, firm) = out.wishes.word(class, index);
        while bits != 0 {
            let is_firm = firm & bits & bits.wrapping_neg() != 0;
            let event = source.tables().by_rank[take(&mut bits, index)];
            decides |= offer(source, row, event, is_firm, out)?;
        }
    }
    if carried > 0 {
        let events = &source.tables().events;
        out.edges.sort_by_key(|edge| events[edge.event as usize].rank);
        out.edges.dedup_by_key(|edge| edge.event);
    }
    Ok(decides)
}

/// Appends an event of the system if it is executable; whether it decides the turn, being asked for by a guarantee in force if
/// `is_firm`.
#[inline]
fn offer<S: Source>(
    source: &mut S,
    row: &[u64],
    event: EventId,
    is_firm: bool,
    out: &mut PackedMoves,
) -> Result<bool, Miss> {
    let classic = source.tables().classic;
    let barred = flag::GUARANTEE | if classic { 0 } else { flag::ASSUMPTION };
    let freed = flag::EXCUSED_GUARANTEE | if classic { 0 } else { flag::EXCUSED_ASSUMPTION };
    if source.tables().concerns.is_barred(event, row, barred) {
        return Ok(false);
    }
    let Some(step) = step(source, row, event, barred, out)? else { return Ok(false) };
    let breaks_assumption = step.flags & flag::ASSUMPTION != 0;
    admit(source, event, step, breaks_assumption.then_some(Turn::Won), out)?;
    Ok(is_firm && step.flags & freed == 0)
}

/// Appends the environment's executable events among the candidates; whether one of them needs nothing relaxed to be
/// executable.
fn environment_moves<S: Source>(source: &mut S, row: &[u64], out: &mut PackedMoves) -> Result<bool, Miss> {
    let mut decides = false;
    for index in 0..out.candidates.len() {
        let mut bits = out.candidates[index];
        while bits != 0 {
            let event = source.tables().by_rank[take(&mut bits, index)];
            if source.tables().concerns.is_barred(event, row, flag::ASSUMPTION) {
                continue;
            }
            let Some(step) = step(source, row, event, flag::ASSUMPTION, out)? else { continue };
            decides |= step.flags & flag::EXCUSED_ASSUMPTION == 0;
            let lost = (step.flags & flag::GUARANTEE != 0).then_some(Turn::Lost);
            admit(source, event, step, lost, out)?;
        }
    }
    Ok(decides)
}

/// Appends a move if it can be.
fn admit<S: Source>(
    source: &mut S,
    event: EventId,
    step: Step,
    end: Option<Turn>,
    out: &mut PackedMoves,
) -> Result<(), Miss> {
    if !out.narrow.is_empty() && end.is_none() {
        source.widen(&out.narrow)?;
    }
    out.push(event, step, end);
    Ok(())
}

/// Turn 5: the system makes one of the moves that are there, or yields.
fn offer_yield(tables: &Successors, row: &[u64], out: &mut PackedMoves) {
    let start = out.rows.len();
    out.rows.extend_from_slice(row);
    tables.layout.field(YIELDED).write(&mut out.rows[start..], 1);
    out.push(YIELD, Step { flags: 0, discharged: 0 }, None);
    out.turn = Turn::SystemEventually;
}

/// What an event does, if it has its link and violates nothing that is `barred`. The state after it is then the last of
/// the rows; what did not fit there is in `out.narrow`.
fn step<S: Source>(
    source: &mut S,
    row: &[u64],
    event: EventId,
    barred: u8,
    out: &mut PackedMoves,
) -> Result<Option<Step>, Miss> {
    if leaf(source, Place::Link(event), row, row)? != NOTHING {
        return Ok(None);
    }
    let start = out.rows.len();
    out.rows.extend_from_slice(row);
    let PackedMoves { watching, rows, fired, narrow, .. } = &mut *out;
    let target = &mut rows[start..];
    narrow.clear();
    fired.clear();
    let changed = assign(source, row, event, target)?;
    let mut flags = 0;
    for (index, &word) in row.iter().enumerate() {
        let mut bits = word & source.tables().concerns.mask(event)[index];
        while bits != 0 {
            let tables = source.tables();
            let (field, value) = tables.layout.take(index, word, &mut bits);
            let place = Place::Reaction(tables.group(field, value), event);
            let reaction = react(source, place, field, row, target, fired)?;
            flags |= reaction;
            // All copies of a group violate the same.
            if reaction & barred != 0 && reaction & flag::AT_ONCE != 0 {
                out.drop_row();
                return Ok(None);
            }
        }
    }
    if changed {
        for &Watching { group, field } in watching.iter() {
            let tables = source.tables();
            if !tables.layout.field(field as usize).is_in(tables.concerns.mask(event)) {
                flags |= react(source, Place::Settling(group, event), field, row, target, fired)?;
            }
        }
    }
    let starts = leaf(source, Place::Starts(event), row, target)?;
    flags |= source.tables().reactions[starts as usize].flags;
    if flags & barred != 0 {
        out.drop_row();
        return Ok(None);
    }
    let mut discharged = 0;
    for &(reaction, field) in fired.iter() {
        let tables = source.tables();
        let reaction = tables.reactions[reaction as usize];
        put(tables, target, narrow, field, reaction.value);
        discharged = union(source, discharged, reaction.discharged)?;
    }
    // All copies that were there have reacted: what is new joins what they have become.
    let started = (starts, 0);
    for &(reaction, _) in fired.iter().chain([&started]) {
        let (start, end) = source.tables().reactions[reaction as usize].joins;
        for index in start..end {
            let copy = source.tables().joins[index as usize];
            join(source, target, narrow, copy)?;
        }
    }
    Ok(Some(Step { flags, discharged }))
}

/// Runs the effects of an event; whether an attribute changes.
fn assign<S: Source>(source: &mut S, row: &[u64], event: EventId, target: &mut [u64]) -> Result<bool, Miss> {
    let effects = leaf(source, Place::Effects(event), row, row)?;
    let tables = source.tables();
    tables.layout.field(YIELDED).write(target, 0);
    let mut changed = false;
    if effects != NOTHING {
        for &(field, value) in part(&tables.assignments, tables.effects[effects as usize]) {
            let place = tables.layout.field(field as usize);
            if !place.fits(value) {
                // What copies do depends on the value: nothing can be said before there is room for it.
                source.fill(Gap::Narrow(field, value), row, target)?;
                return Err(Miss);
            }
            changed |= place.read(row) != value;
            place.write(target, value);
        }
    }
    Ok(changed)
}

/// Notes what becomes of a group; what that violates.
#[inline(always)]
fn react<S: Source>(
    source: &mut S,
    place: Place,
    field: u32,
    before: &[u64],
    after: &[u64],
    fired: &mut Vec<(u32, u32)>,
) -> Result<u8, Miss> {
    let reaction = leaf(source, place, before, after)?;
    if reaction == NOTHING {
        return Ok(0);
    }
    fired.push((reaction, field));
    Ok(source.tables().reactions[reaction as usize].flags)
}

/// One more copy comes to its slot. Most slots are empty and have room.
#[inline]
fn join<S: Source>(
    source: &mut S,
    target: &mut [u64],
    narrow: &mut Vec<(u32, u32)>,
    copy: CopyId,
) -> Result<(), Miss> {
    let tables = source.tables();
    let (slot, alone) = tables.groups.alone(copy);
    let field = tables.first_slot() as u32 + slot;
    let place = tables.layout.field(field as usize);
    match alone {
        Some(value) if narrow.is_empty() && place.read(target) == 0 && place.fits(value) => {
            place.write(target, value);
            Ok(())
        }
        _ => join_others(source, target, narrow, field, copy),
    }
}

fn join_others<S: Source>(
    source: &mut S,
    target: &mut [u64],
    narrow: &mut Vec<(u32, u32)>,
    field: u32,
    copy: CopyId,
) -> Result<(), Miss> {
    let pending = narrow.iter().rev().find(|(other, _)| *other == field);
    let place = source.tables().layout.field(field as usize);
    let value = pending.map_or_else(|| place.read(target), |&(_, value)| value);
    loop {
        if let Some(joined) = source.tables().groups.joined(value, copy) {
            put(source.tables(), target, narrow, field, joined);
            return Ok(());
        }
        source.fill(Gap::Join(value, copy), &[], &[])?;
    }
}

#[inline]
fn put(tables: &Successors, target: &mut [u64], narrow: &mut Vec<(u32, u32)>, field: u32, value: u32) {
    let place = tables.layout.field(field as usize);
    if place.fits(value) {
        if !narrow.is_empty() {
            narrow.retain(|(other, _)| *other != field);
        }
        place.write(target, value);
    } else {
        narrow.push((field, value));
    }
}
