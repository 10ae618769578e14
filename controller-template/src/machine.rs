//! State and pending events of a controller, and the three ways to step it.

use crate::{Bits, Number};

/// What a generated module says of its controller.
///
/// A state may have rows of environment events and a super step: events go first. Chains of super steps that command
/// nothing end.
pub trait Tables {
    /// A state: the narrowest type that holds their number.
    type State: Number;
    /// An environment event.
    type Event: Copy;
    /// At most one command to each component.
    type Commands: CommandSet;

    /// What tables are the same: a [`Saved`](crate::Saved) state goes back to those that saved it. Not 0.
    const VERSION: u32;

    /// States are below.
    const STATES: u32;

    /// Where the controller starts.
    const INITIAL: Self::State;

    /// Position of an event in table order.
    fn index(event: Self::Event) -> usize;

    /// The event at a position in table order.
    fn event(index: usize) -> Option<Self::Event>;

    /// Where `event` leads from `state`, if it fits there.
    fn environment(event: Self::Event, state: Self::State) -> Option<Self::State>;

    /// The super step that is due in `state`: its target and commands.
    fn super_step(state: Self::State) -> Option<(Self::State, Self::Commands)>;
}

/// Commands, at most one to each component; the default is none.
pub trait CommandSet: Copy + Default {
    /// Whether some component has a command in both.
    fn overlaps(self, other: Self) -> bool;

    /// The commands of both; where they overlap, those of `self`.
    #[must_use]
    fn union(self, other: Self) -> Self;
}

/// Sees the transitions of a controller, for logs and tests.
///
/// Methods do nothing unless they are written; `()` observes nothing and costs nothing.
pub trait Observer<E, C> {
    /// `event` was consumed.
    #[inline]
    fn consumed(&mut self, event: E, source: u32, target: u32) {
        let _ = (event, source, target);
    }

    /// A super step was done; `commands` may be empty, since messages between controllable objects command nothing.
    #[inline]
    fn stepped(&mut self, commands: C, source: u32, target: u32) {
        let _ = (commands, source, target);
    }
}

impl<E, C> Observer<E, C> for () {}

/// A controller at work: its state and its pending events, `32 * W` of them at most.
///
/// Several events may be pending at once, as in a scan of a PLC: [`raise`](Self::raise) them, then
/// [`cycle`](Self::cycle) or [`drain`](Self::drain). A program that gets one event at a time calls
/// [`react`](Self::react) instead.
///
/// It is not `Copy`, though small: who steps a copy by mistake leaves the original behind. What [`save`](Self::save)
/// gives is.
#[derive(Clone, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Machine<T: Tables, const W: usize> {
    state: T::State,
    pending: Bits<W>,
}

impl<T: Tables, const W: usize> Machine<T, W> {
    /// In the initial state, with nothing pending.
    #[must_use]
    pub const fn new() -> Self {
        Machine { state: T::INITIAL, pending: Bits::new([0; W]) }
    }

    pub(crate) const fn at(state: T::State, pending: Bits<W>) -> Self {
        Machine { state, pending }
    }

    /// Makes an event pending; `false` if it is already, and then once is all it counts.
    #[inline]
    pub fn raise(&mut self, event: T::Event) -> bool {
        self.pending.insert(T::index(event))
    }

    /// Whether an event is pending.
    #[inline]
    pub fn is_pending(&self, event: T::Event) -> bool {
        self.pending.contains(T::index(event))
    }

    /// The events that are pending; after a cycle, those that fit nowhere.
    #[inline]
    pub const fn pending(&self) -> Bits<W> {
        self.pending
    }

    /// The state's number.
    #[inline]
    pub fn state(&self) -> u32 {
        self.state.into()
    }

    /// Whether the state has a row of `event`.
    #[inline]
    pub fn accepts(&self, event: T::Event) -> bool {
        T::environment(event, self.state).is_some()
    }

    /// One cycle: consumes pending events in table order until none fits, then does one super step.
    #[inline]
    pub fn cycle(&mut self, observer: &mut impl Observer<T::Event, T::Commands>) -> T::Commands {
        self.consume(observer);
        match T::super_step(self.state) {
            Some((target, commands)) => self.step(target, commands, observer),
            None => T::Commands::default(),
        }
    }

    /// Cycles until no super step is due, and returns all their commands.
    ///
    /// Stops before a super step that would command a component already commanded in this call, and leaves it to the
    /// next one; events consumed by then stay consumed.
    #[inline]
    pub fn drain(&mut self, observer: &mut impl Observer<T::Event, T::Commands>) -> T::Commands {
        let mut all = T::Commands::default();
        loop {
            self.consume(observer);
            match T::super_step(self.state) {
                Some((target, commands)) if !all.overlaps(commands) => {
                    all = all.union(self.step(target, commands, observer));
                }
                _ => return all,
            }
        }
    }

    /// Takes one event with its super step.
    ///
    /// Refuses with `None`, and changes nothing, if the event does not fit the state. In controllers of scenarios none does
    /// while a super step is due: the initial one, the rest of one that is split, or one that [`drain`](Self::drain) left.
    /// [`cycle`](Self::cycle) delivers these, one a call. Events that are pending stay so.
    #[inline]
    pub fn react(
        &mut self,
        event: T::Event,
        observer: &mut impl Observer<T::Event, T::Commands>,
    ) -> Option<T::Commands> {
        let target = T::environment(event, self.state)?;
        self.enter(event, target, observer);
        Some(match T::super_step(target) {
            Some((target, commands)) => self.step(target, commands, observer),
            None => T::Commands::default(),
        })
    }

    /// Pass after pass over the pending events, until one consumes nothing.
    #[inline]
    fn consume(&mut self, observer: &mut impl Observer<T::Event, T::Commands>) {
        loop {
            let mut changed = false;
            for index in self.pending.ones() {
                let Some(event) = T::event(index) else { continue };
                if let Some(target) = T::environment(event, self.state) {
                    self.pending.remove(index);
                    self.enter(event, target, observer);
                    changed = true;
                }
            }
            if !changed {
                return;
            }
        }
    }

    #[inline]
    fn enter(
        &mut self,
        event: T::Event,
        target: T::State,
        observer: &mut impl Observer<T::Event, T::Commands>,
    ) {
        observer.consumed(event, self.state.into(), target.into());
        self.state = target;
    }

    #[inline]
    fn step(
        &mut self,
        target: T::State,
        commands: T::Commands,
        observer: &mut impl Observer<T::Event, T::Commands>,
    ) -> T::Commands {
        observer.stepped(commands, self.state.into(), target.into());
        self.state = target;
        commands
    }
}

impl<T: Tables, const W: usize> Default for Machine<T, W> {
    fn default() -> Self {
        Self::new()
    }
}
