//! Which slots an event concerns: those whose scenario has a message or a constraint of its operation, sender and
//! receiver. Copies elsewhere stay where they are, unless its effects let them go on; so most events concern few slots,
//! and the bits of these in a row tell at once which copies are to be asked.

use super::layout::{Field, Layout};
use super::tables::flag;
use crate::playout::{CopyId, EventId, Playout};

/// For all events and slots known so far.
#[derive(Debug, Default)]
pub(super) struct Concerns {
    /// Per slot: one of its copies.
    copies: Vec<CopyId>,
    /// Per event: the slots that it concerns, ascending.
    slots: Vec<Vec<u32>>,
    /// Per event: the bits of these slots in a row, in `words` words.
    masks: Vec<u64>,
    /// Per event: the bits of slots whose copies, if there are any, violate a guarantee at once, whatever they are; and
    /// those for assumptions. All copies of a slot are of one scenario, so of one kind. Whatever else the event would do,
    /// a mistake of its effects or of another copy, play-out counts what is violated at once; so nobody need ask.
    bars: Vec<u64>,
    words: usize,
}

impl Concerns {
    /// Adds a slot that has this copy.
    pub(super) fn add_slot(&mut self, playout: &Playout<'_>, copy: CopyId) {
        let slot = self.copies.len() as u32;
        self.copies.push(copy);
        for (event, slots) in self.slots.iter_mut().enumerate() {
            if playout.concerns(event as EventId, copy) {
                slots.push(slot);
            }
        }
    }

    /// Adds the next event.
    pub(super) fn add_event(&mut self, playout: &Playout<'_>) {
        let event = self.slots.len() as EventId;
        let slots = (0..).zip(&self.copies).filter(|&(_, &copy)| playout.concerns(event, copy));
        self.slots.push(slots.map(|(slot, _)| slot).collect());
    }

    /// Fields lie as this says; those of slots begin with `first`.
    pub(super) fn lay_out(&mut self, layout: &Layout, first: usize) {
        self.words = layout.words();
        self.masks.clear();
        self.masks.resize(self.slots.len() * self.words, 0);
        for (slots, mask) in self.slots.iter().zip(self.masks.chunks_exact_mut(self.words)) {
            for &slot in slots {
                layout.field(first + slot as usize).fill(mask, true);
            }
        }
        self.bars.clear();
        self.bars.resize(2 * self.masks.len(), 0);
    }

    /// The slots that an event concerns, ascending.
    pub(super) fn slots(&self, event: EventId) -> &[u32] {
        &self.slots[event as usize]
    }

    /// From now on this says what all copies of the slot with this field violate at once: no [`flag`] but those two.
    pub(super) fn set_bar(&mut self, event: EventId, slot: Field, violated: u8) {
        let start = 2 * event as usize * self.words;
        let bars = self.bars[start..][..2 * self.words].chunks_exact_mut(self.words);
        for (bars, kind) in bars.zip([flag::GUARANTEE, flag::ASSUMPTION]) {
            slot.fill(bars, violated & kind != 0);
        }
    }

    /// Whether it is plain that the event violates at once what is barred.
    #[inline]
    pub(super) fn is_barred(&self, event: EventId, row: &[u64], barred: u8) -> bool {
        let start = 2 * event as usize * self.words;
        let (guarantees, assumptions) = self.bars[start..][..2 * self.words].split_at(self.words);
        let meets = |bars: &[u64]| row.iter().zip(bars).any(|(word, bars)| word & bars != 0);
        barred & flag::GUARANTEE != 0 && meets(guarantees)
            || barred & flag::ASSUMPTION != 0 && meets(assumptions)
    }

    /// The bits of the slots that an event concerns, in a row.
    #[inline]
    pub(super) fn mask(&self, event: EventId) -> &[u64] {
        &self.masks[event as usize * self.words..][..self.words]
    }

    /// Bytes held, about.
    pub(super) fn memory(&self) -> usize {
        let pairs: usize = self.slots.iter().map(Vec::capacity).sum();
        (self.copies.capacity() + pairs) * size_of::<u32>()
            + self.slots.capacity() * size_of::<Vec<u32>>()
            + (self.masks.capacity() + self.bars.capacity()) * size_of::<u64>()
    }
}

#[cfg(test)]
mod tests {
    use crate::explore::{Limits, explore_with};
    use crate::playout::{EventId, Playout, Semantics};
    use crate::testing::{spec, world};

    /// Which scenarios' copies the event concerns.
    fn concerned(playout: &Playout<'_>, event: &str) -> Vec<String> {
        let event = (0..playout.event_count() as EventId).find(|&id| playout.event(id).text == event);
        let event = event.expect("an event");
        let copies = (0..playout.copy_count() as u32).filter(|&copy| playout.concerns(event, copy));
        let scenarios = copies.map(|copy| playout.copy(copy).scenario);
        let mut names: Vec<String> =
            scenarios.map(|scenario| playout.spec().scenarios[scenario].name.clone()).collect();
        names.sort();
        names.dedup();
        names
    }

    /// Nobody looks at the effects of what is forbidden anyhow, at first or once that is known.
    #[test]
    fn what_is_barred_makes_no_mistake() {
        let explored = |constraint: &str| {
            let spec = spec(&format!(
                "specification Counts {{
                  domain {{ class User {{ n: 0..=1  count() }} class Control {{ }} }}
                  object user: User  object control: Control
                  controllable {{ User }}
                  effects {{ Control -> User.count() {{ receiver.n = receiver.n + 1 }} }}
                  collaboration C {{
                    assumption scenario Once {{ control -> user.count()  wait [false] }} {constraint}
                  }}
                }}"
            ));
            let mut playout = Playout::new(&spec, Semantics::default()).expect("few events");
            explore_with(&mut playout, &Limits::default()).map(|(_, game)| game.states()).ok()
        };
        assert_eq!(explored(""), None, "counting twice is too much");
        assert_eq!(explored("constraints [ forbidden control -> user.count() ]"), Some(2));
    }

    #[test]
    fn messages_and_constraints_concern_a_copy() {
        let spec = spec(&world(
            "guarantee scenario Shine { user -> control.press()  urgent control -> lamp.on() }
             guarantee scenario Dark { user -> control.release()  urgent control -> lamp.off() }
             constraints [ forbidden user -> control.press() ]",
        ));
        let mut playout = Playout::new(&spec, Semantics::default()).expect("few events");
        explore_with(&mut playout, &Limits::default()).expect("a game");
        assert_eq!(concerned(&playout, "user -> control.press()"), ["C.Dark", "C.Shine"]);
        assert_eq!(concerned(&playout, "user -> control.release()"), ["C.Dark"]);
        assert_eq!(concerned(&playout, "control -> lamp.on()"), ["C.Shine"]);
    }
}
