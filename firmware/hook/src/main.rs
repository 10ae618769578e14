//! The three steps of a controller, in functions whose code is compared: observed by `()`, as when a program does not observe
//! it; with the feature `hookless` those of the same loop without a hook; with `counting` observed by something. Never run.
#![no_std]
#![no_main]

use core::hint::black_box;
use production_cell::machine::Controller;
use production_cell::{Commands, Event};

include!(concat!(env!("OUT_DIR"), "/hook.rs"));

/// Counts transitions.
#[cfg(feature = "counting")]
struct Counter(u32);

#[cfg(feature = "counting")]
impl controller_template::Observer<Event, Commands> for Counter {
    fn consumed(&mut self, _: Event, source: u32, target: u32) {
        self.0 = self.0.wrapping_add(source ^ target);
    }

    fn stepped(&mut self, _: Commands, source: u32, target: u32) {
        self.0 = self.0.wrapping_add(source ^ target);
    }
}

/// Calls a method of the controller with the observer of this build.
macro_rules! step {
    ($controller:ident.$step:ident($($event:ident)?)) => {{
        #[cfg(feature = "hookless")]
        return $controller.$step($($event)?);
        #[cfg(not(any(feature = "hookless", feature = "counting")))]
        return $controller.$step($($event,)? &mut ());
        #[cfg(feature = "counting")]
        return counted(|counter| $controller.$step($($event,)? counter));
    }};
}

#[inline(never)]
fn cycle(controller: &mut Controller) -> Commands {
    step!(controller.cycle())
}

#[inline(never)]
fn drain(controller: &mut Controller) -> Commands {
    step!(controller.drain())
}

#[inline(never)]
fn react(controller: &mut Controller, event: Event) -> Option<Commands> {
    step!(controller.react(event))
}

#[cfg(feature = "counting")]
#[inline(always)]
fn counted<R>(step: impl FnOnce(&mut Counter) -> R) -> R {
    let mut counter = Counter(0);
    let result = step(&mut counter);
    black_box(counter.0);
    result
}

#[board::entry]
fn main() -> ! {
    let mut controller = Controller::new();
    loop {
        let event = black_box(Event::FeedBeltControllerBlankArrived);
        black_box(controller.raise(event));
        let _ = black_box(black_box(cycle as fn(&mut Controller) -> Commands)(black_box(&mut controller)));
        let _ = black_box(black_box(drain as fn(&mut Controller) -> Commands)(black_box(&mut controller)));
        black_box(black_box(react as fn(&mut Controller, Event) -> Option<Commands>)(
            black_box(&mut controller),
            black_box(event),
        ));
    }
}
