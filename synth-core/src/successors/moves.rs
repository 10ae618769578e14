//! The moves of a packed state: the rules of [`crate::playout::Playout::moves`] over tables.

use super::UNKNOWN_SET;
use super::groups::GroupId;
use super::sets::SetId;
use super::tables::{Place, Successors, Wish, YIELDED, class, flag, part};
use super::trees::{NOTHING, Node, UNKNOWN, is_leaf};
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
    /// Which row it leads to.
    row: u32,
}

/// A group of copies that is active in the state.
#[derive(Clone, Copy, Debug)]
struct Active {
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
    active: Vec<Active>,
    wishes: Vec<u64>,
    candidates: Vec<u32>,
    target: Vec<u64>,
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
            active: Vec::new(),
            wishes: Vec::new(),
            candidates: Vec::new(),
            target: Vec::new(),
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
        &self.rows[edge.row as usize * self.words..(edge.row as usize + 1) * self.words]
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
        self.active.clear();
        self.wishes.clear();
    }

    /// Appends a move to `self.target`.
    fn push(&mut self, event: EventId, step: Step, end: Option<Turn>) {
        let row = (self.rows.len() / self.words) as u32;
        self.rows.extend_from_slice(&self.target);
        let Step { flags, discharged } = step;
        let completed = flags & flag::COMPLETED != 0;
        self.edges.push(Edge { event, end, completed, discharged, row });
    }

    /// Appends a move to this state.
    pub(super) fn push_row(&mut self, edge: (EventId, Option<Turn>, bool, SetId), row: &[u64]) {
        let (event, end, completed, discharged) = edge;
        let place = (self.rows.len() / self.words) as u32;
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

    /// The events that [`Playout::owed`](crate::playout::Playout::owed) gives, into a cleared list; `room` is overwritten.
    ///
    /// # Errors
    /// As for [`Successors::moves`].
    pub(crate) fn owed(
        &self,
        row: &[u64],
        room: &mut PackedMoves,
        owed: &mut Vec<EventId>,
    ) -> Result<(), Miss> {
        room.clear(self.layout.words());
        survey(&mut &*self, row, room)?;
        let of_environment =
            [class::ENVIRONMENT_COMMITTED, class::ENVIRONMENT_URGENT, class::ENVIRONMENT].map(u64::from);
        let wishes = room.wishes.iter().filter(|wish| of_environment.contains(&(*wish >> 40)));
        owed.clear();
        owed.extend(wishes.map(|&wish| self.by_rank[(wish as u32 >> 1) as usize]));
        owed.sort_unstable();
        owed.dedup();
        Ok(())
    }
}

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

pub(super) fn moves<S: Source>(source: &mut S, row: &[u64], out: &mut PackedMoves) -> Result<(), Miss> {
    out.clear(source.tables().layout.words());
    survey(source, row, out)?;
    let yielded = source.tables().layout.field(YIELDED).read(row) != 0;
    let mut next = 0;
    for (by_system, of_system, by_environment, of_environment) in [
        (
            Turn::SystemCommitted,
            class::SYSTEM_COMMITTED,
            Turn::EnvironmentCommitted,
            class::ENVIRONMENT_COMMITTED,
        ),
        (Turn::SystemUrgent, class::SYSTEM_URGENT, Turn::EnvironmentUrgent, class::ENVIRONMENT_URGENT),
    ] {
        if system_moves(source, row, of_system, &mut next, out)? {
            out.turn = by_system;
            return Ok(());
        }
        // Moves that do not decide the turn, because of what is relaxed: the system may make one of them.
        let offered = out.edges.len();
        out.candidates.clear();
        while let Some(rank) = take(&out.wishes, &mut next, of_environment) {
            out.candidates.push(rank >> 1);
        }
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
        system_moves(source, row, class::SYSTEM_EVENTUALLY, &mut next, out)?;
        if !out.edges.is_empty() {
            offer_yield(source.tables(), row, out);
            return Ok(());
        }
    }
    all_candidates(source.tables(), out);
    environment_moves(source, row, out)?;
    out.turn = Turn::EnvironmentAny;
    out.silent = !source.tables().classic || out.edges.is_empty();
    Ok(())
}

/// Finds the active groups, the open keys, and what is asked for: class, place in the order of texts, and whether only
/// a relaxed guarantee asks.
fn survey<S: Source>(source: &mut S, row: &[u64], out: &mut PackedMoves) -> Result<(), Miss> {
    let tables = source.tables();
    let PackedMoves { active, open_keys, .. } = out;
    open_keys.resize(tables.key_words(), 0);
    tables.active(row, |group, field| {
        active.push(Active { group, field });
        tables.add_open_keys(group, open_keys);
    });
    for index in 0..out.active.len() {
        let offers = leaf(source, Place::Offers(out.active[index].group), row, row)?;
        if offers != NOTHING {
            let tables = source.tables();
            for wish in part(&tables.wishes, tables.offers[offers as usize]) {
                let Wish { class, event, relaxed } = *wish;
                out.wishes.push(u64::from(class) << 40 | u64::from(event) << 1 | u64::from(relaxed));
            }
        }
    }
    // Only now: what was just found out may have brought new events.
    let events = &source.tables().events;
    for wish in &mut out.wishes {
        let rank = events[(*wish as u32 >> 1) as usize].rank;
        *wish = *wish >> 40 << 40 | u64::from(rank) << 1 | *wish & 1;
    }
    if out.wishes.len() > 1 {
        out.wishes.sort_unstable();
        // The same event is asked for once; what a guarantee in force asks for comes first.
        out.wishes.dedup_by_key(|wish| *wish >> 1);
    }
    Ok(())
}

/// The next wish of a class, without the class.
fn take(wishes: &[u64], next: &mut usize, class: u8) -> Option<u32> {
    let wish = *wishes.get(*next)?;
    (wish >> 40 == u64::from(class)).then(|| {
        *next += 1;
        wish as u32
    })
}

/// Appends the system's executable events of one class; whether they decide the turn. They do if one is among them
/// that a guarantee in force asks for and that needs nothing relaxed to be executable.
fn system_moves<S: Source>(
    source: &mut S,
    row: &[u64],
    class: u8,
    next: &mut usize,
    out: &mut PackedMoves,
) -> Result<bool, Miss> {
    let carried = out.edges.len();
    let classic = source.tables().classic;
    let barred = flag::GUARANTEE | if classic { 0 } else { flag::ASSUMPTION };
    let freed = flag::EXCUSED_GUARANTEE | if classic { 0 } else { flag::EXCUSED_ASSUMPTION };
    let mut decides = false;
    while let Some(wish) = take(&out.wishes, next, class) {
        let event = source.tables().by_rank[(wish >> 1) as usize];
        if leaf(source, Place::Link(event), row, row)? != NOTHING {
            continue;
        }
        let step = step(source, row, event, barred, out)?;
        if step.flags & barred != 0 {
            continue;
        }
        let breaks_assumption = step.flags & flag::ASSUMPTION != 0;
        decides = decides || wish & 1 == 0 && step.flags & freed == 0;
        admit(source, event, step, breaks_assumption.then_some(Turn::Won), out)?;
    }
    if carried > 0 {
        let events = &source.tables().events;
        out.edges.sort_by_key(|edge| events[edge.event as usize].rank);
        out.edges.dedup_by_key(|edge| edge.event);
    }
    Ok(decides)
}

/// Appends the environment's executable events among the candidates, which are given in order; whether one of them needs
/// nothing relaxed to be executable.
fn environment_moves<S: Source>(source: &mut S, row: &[u64], out: &mut PackedMoves) -> Result<bool, Miss> {
    let mut decides = false;
    for index in 0..out.candidates.len() {
        let event = source.tables().by_rank[out.candidates[index] as usize];
        if leaf(source, Place::Link(event), row, row)? != NOTHING {
            continue;
        }
        let step = step(source, row, event, flag::ASSUMPTION, out)?;
        if step.flags & flag::ASSUMPTION != 0 {
            continue;
        }
        decides = decides || step.flags & flag::EXCUSED_ASSUMPTION == 0;
        let lost = (step.flags & flag::GUARANTEE != 0).then_some(Turn::Lost);
        admit(source, event, step, lost, out)?;
    }
    Ok(decides)
}

/// The candidates of a state in which the environment may send anything: spontaneous events, and what assumptions
/// say that it sends.
fn all_candidates(tables: &Successors, out: &mut PackedMoves) {
    let PackedMoves { wishes, candidates, .. } = out;
    candidates.clear();
    candidates.extend(tables.spontaneous.iter().map(|&event| tables.events[event as usize].rank));
    let spontaneous = candidates.len();
    for wish in wishes.iter() {
        let class = (wish >> 40) as u8;
        if matches!(class, class::ENVIRONMENT_COMMITTED | class::ENVIRONMENT_URGENT | class::ENVIRONMENT) {
            candidates.push(*wish as u32 >> 1);
        }
    }
    if candidates.len() > spontaneous {
        candidates.sort_unstable();
        candidates.dedup();
    }
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
    out.target.clear();
    out.target.extend_from_slice(row);
    tables.layout.field(YIELDED).write(&mut out.target, 1);
    out.push(YIELD, Step { flags: 0, discharged: 0 }, None);
    out.turn = Turn::SystemEventually;
}

/// What an event does; the state after it is left in `out.target`, and what did not fit there in `out.narrow`. If it violates
/// what is `barred`, nobody asks for that state.
fn step<S: Source>(
    source: &mut S,
    row: &[u64],
    event: EventId,
    barred: u8,
    out: &mut PackedMoves,
) -> Result<Step, Miss> {
    let PackedMoves { active, target, fired, narrow, .. } = out;
    target.clear();
    target.extend_from_slice(row);
    narrow.clear();
    fired.clear();
    let effects = leaf(source, Place::Effects(event), row, row)?;
    let tables = source.tables();
    tables.layout.field(YIELDED).write(target, 0);
    if effects != NOTHING {
        for &(field, value) in part(&tables.assignments, tables.effects[effects as usize]) {
            if !tables.layout.field(field as usize).fits(value) {
                // What copies do depends on the value: nothing can be said before there is room for it.
                source.fill(Gap::Narrow(field, value), row, target)?;
                return Err(Miss);
            }
            tables.layout.field(field as usize).write(target, value);
        }
    }
    let (mut flags, mut discharged) = (0, 0);
    for one in active.iter() {
        let reaction = leaf(source, Place::Reaction(one.group, event), row, target)?;
        if reaction != NOTHING {
            fired.push((reaction, one.field));
            flags |= source.tables().reactions[reaction as usize].flags;
        }
    }
    let starts = leaf(source, Place::Starts(event), row, target)?;
    flags |= source.tables().reactions[starts as usize].flags;
    if flags & barred != 0 {
        return Ok(Step { flags, discharged });
    }
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
    Ok(Step { flags, discharged })
}

/// One more copy comes to its slot.
fn join<S: Source>(
    source: &mut S,
    target: &mut [u64],
    narrow: &mut Vec<(u32, u32)>,
    copy: CopyId,
) -> Result<(), Miss> {
    let tables = source.tables();
    let field = tables.first_slot() as u32 + tables.groups.slot_of(copy);
    let pending = narrow.iter().rev().find(|(other, _)| *other == field);
    let value = pending.map_or_else(|| tables.layout.field(field as usize).read(target), |&(_, value)| value);
    loop {
        if let Some(joined) = source.tables().groups.joined(value, copy) {
            put(source.tables(), target, narrow, field, joined);
            return Ok(());
        }
        source.fill(Gap::Join(value, copy), &[], &[])?;
    }
}

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
