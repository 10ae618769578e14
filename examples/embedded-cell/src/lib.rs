//! A `no_std` library that embeds a controller: what a firmware crate does.
//!
//! The specification is read from its file when this crate is compiled, and again when it changes. All tables are
//! `static`; the controller itself is a few bytes.
#![no_std]
#![forbid(unsafe_code)]

sml_macros::sml!("../production-cell/specs/production_cell.sml");

use production_cell::{Controller, DepositArm, Event, FeedArm, Press};

/// The cell: the controller and the drives that carry out its commands.
#[derive(Debug)]
pub struct Cell<F, D, P> {
    controller: Controller,
    feed_arm: F,
    deposit_arm: D,
    press: P,
}

impl<F: FeedArm, D: DepositArm, P: Press> Cell<F, D, P> {
    /// A cell in its initial state.
    pub const fn new(feed_arm: F, deposit_arm: D, press: P) -> Self {
        Cell { controller: Controller::new(), feed_arm, deposit_arm, press }
    }

    /// A sensor has changed; `false` if the event is pending already.
    pub fn sensed(&mut self, event: Event) -> bool {
        self.controller.raise(event)
    }

    /// One turn of the main loop.
    pub fn turn(&mut self) {
        self.controller.cycle().dispatch(&mut self.deposit_arm, &mut self.feed_arm, &mut self.press);
    }
}

#[cfg(test)]
mod tests {
    use super::production_cell::{Controller, Event};

    #[test]
    fn the_controller_is_small() {
        // The state and ten pending events.
        assert!(size_of::<Controller>() <= 8);
        let mut controller = Controller::new();
        assert!(controller.raise(Event::FeedBeltControllerBlankArrived));
        assert!(!controller.raise(Event::FeedBeltControllerBlankArrived));
        assert!(controller.cycle().feed_arm.is_some());
    }
}
