//! Calls every operation of controllers of every engine for ever. Panics call a function that is defined nowhere, so that this links
//! only if no operation can panic; with the feature `control` one can, and it must not link.
#![no_std]
#![no_main]

use core::hint::black_box;
use measured::{Steps, cell, engines, line};

#[board::entry]
fn main() -> ! {
    let mut cell = cell::Controller::new();
    let mut line = line::Controller::new();
    loop {
        let saved = black_box(cell.save().to_bytes());
        black_box(
            cell::Saved::from_bytes(&saved).and_then(|saved| cell::Controller::restore(&saved)).is_ok(),
        );
        let saved = black_box(line.save().to_bytes());
        black_box(
            line::Saved::from_bytes(&saved).and_then(|saved| line::Controller::restore(&saved)).is_ok(),
        );
        call(&mut cell, black_box(cell::Event::FeedBeltControllerBlankArrived));
        call(&mut line, black_box(LINE));
        engines();
        #[cfg(feature = "control")]
        black_box(TABLE[black_box(cell.state() as usize)]);
    }
}

const LINE: line::Event = line::Event::ALL[0];

#[cfg(feature = "control")]
static TABLE: [u8; 3] = [1, 2, 3];

fn engines() {
    call_new::<engines::rows_search::Controller>();
    call_new::<engines::rows_runs::Controller>();
    call_new::<engines::rows_comb::Controller>();
    call_new::<engines::cell_search::Controller>();
    call_new::<engines::cell_runs::Controller>();
    call_new::<engines::cell_comb::Controller>();
}

fn call_new<C: Steps>() {
    for &event in C::EVENTS {
        call(&mut C::start(), black_box(event));
    }
}

fn call<C: Steps>(controller: &mut C, event: C::Event) {
    black_box(controller.accepts(event));
    black_box(controller.raise(event));
    black_box(controller.cycle());
    black_box(controller.drain());
    black_box(controller.react(event));
    black_box(controller.state());
}
