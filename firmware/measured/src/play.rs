//! The play: which events come, and how the controller is called.

use crate::digest::Digest;
use core::fmt;
use core::hash::Hash;

/// Events of a play.
const EVENTS: u32 = 10_000;

/// States that are told apart.
const STATES: usize = 4096;

/// The operations of a controller, each in a function of its own.
pub trait Steps {
    /// What the environment may say.
    type Event: Copy + Hash + 'static;
    /// What is commanded.
    type Commands: Hash;

    /// All events in table order.
    const EVENTS: &'static [Self::Event];

    /// A controller in its initial state.
    fn start() -> Self;
    /// The state's number.
    fn state(&self) -> u32;
    /// One look-up of an event.
    fn accepts(&self, event: Self::Event) -> bool;
    /// Makes an event pending.
    fn raise(&mut self, event: Self::Event) -> bool;
    /// One cycle.
    fn cycle(&mut self) -> Self::Commands;
    /// Cycles until no super step is due.
    fn drain(&mut self) -> Self::Commands;
    /// Takes one event with its super step.
    fn react(&mut self, event: Self::Event) -> Option<Self::Commands>;
}

/// What a play came to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Outcome {
    /// Events that were raised or reacted to.
    pub events: u32,
    /// States that were seen between the calls.
    pub states: u32,
    /// Of every event, what the controller answered, and its state afterwards.
    pub digest: u32,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Outcome { events, states, digest } = self;
        write!(f, "{events} events, {states} states, digest {digest:08x}")
    }
}

/// Plays to a new controller. Three events of four fit if any does; the controller is called in every way.
pub fn play<C: Steps>() -> Outcome {
    let mut controller = C::start();
    let mut random = Random(1);
    let mut digest = Digest::new();
    let mut seen = [0_u32; STATES / 32];
    let mut states = 0;
    for _ in 0..EVENTS {
        let event = choose(&controller, &mut random);
        digest.add(&event);
        match random.below(4) {
            0 => digest.add(&controller.react(event)),
            1 => digest.add(&controller.raise(event)),
            2 => {
                digest.add(&controller.raise(event));
                digest.add(&controller.drain());
            }
            _ => {
                digest.add(&controller.raise(event));
                digest.add(&controller.cycle());
            }
        }
        let state = controller.state();
        digest.add(&state);
        if let Some(word) = seen.get_mut(state as usize / 32) {
            states += u32::from(*word >> (state % 32) & 1 == 0);
            *word |= 1 << (state % 32);
        }
    }
    Outcome { events: EVENTS, states, digest: digest.value() }
}

/// An event at random, or the next in table order that fits.
fn choose<C: Steps>(controller: &C, random: &mut Random) -> C::Event {
    let count = C::EVENTS.len();
    let first = random.below(count as u32) as usize;
    if random.below(4) > 0 {
        let around = C::EVENTS.iter().cycle().skip(first).take(count);
        for &event in around {
            if controller.accepts(event) {
                return event;
            }
        }
    }
    C::EVENTS[first]
}

/// A linear congruence, of which the upper half is used: no division.
struct Random(u32);

impl Random {
    fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        ((self.0 >> 16) * bound) >> 16
    }
}

/// Puts each operation of the generated module's controller in a function that is never inlined, and called through a
/// pointer, so that the optimiser knows nothing of its arguments: `measured::cell::cycle` is a name in the program.
#[macro_export]
#[doc(hidden)]
macro_rules! steps {
    ($module:ident) => {
        use core::hint::black_box;
        pub use $module::{Commands, Controller, Event, Saved};

        /// [`Controller::accepts`]
        #[inline(never)]
        pub fn accepts(controller: &Controller, event: Event) -> bool {
            controller.accepts(event)
        }

        /// [`Controller::raise`]
        #[inline(never)]
        pub fn raise(controller: &mut Controller, event: Event) -> bool {
            controller.raise(event)
        }

        /// [`Controller::cycle`]
        #[inline(never)]
        pub fn cycle(controller: &mut Controller) -> Commands {
            controller.cycle()
        }

        /// [`Controller::drain`]
        #[inline(never)]
        pub fn drain(controller: &mut Controller) -> Commands {
            controller.drain()
        }

        /// [`Controller::react`]
        #[inline(never)]
        pub fn react(controller: &mut Controller, event: Event) -> Option<Commands> {
            controller.react(event)
        }

        impl $crate::Steps for Controller {
            type Event = Event;
            type Commands = Commands;

            const EVENTS: &'static [Event] = &Event::ALL;

            fn start() -> Self {
                Controller::new()
            }
            fn state(&self) -> u32 {
                Controller::state(self)
            }
            fn accepts(&self, event: Event) -> bool {
                black_box(black_box(accepts as fn(&Controller, Event) -> bool)(
                    black_box(self),
                    black_box(event),
                ))
            }
            fn raise(&mut self, event: Event) -> bool {
                black_box(black_box(raise as fn(&mut Controller, Event) -> bool)(
                    black_box(self),
                    black_box(event),
                ))
            }
            fn cycle(&mut self) -> Commands {
                black_box(black_box(cycle as fn(&mut Controller) -> Commands)(black_box(self)))
            }
            fn drain(&mut self) -> Commands {
                black_box(black_box(drain as fn(&mut Controller) -> Commands)(black_box(self)))
            }
            fn react(&mut self, event: Event) -> Option<Commands> {
                black_box(black_box(react as fn(&mut Controller, Event) -> Option<Commands>)(
                    black_box(self),
                    black_box(event),
                ))
            }
        }
    };
}
