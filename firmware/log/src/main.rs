//! Logs every transition with defmt: names and texts stay on the host, an event is three bytes. In the middle the controller is
//! saved as bytes, as for flash or a backup RAM, and another goes on from them.
#![no_std]
#![no_main]

use controller_template::Observer;
use defmt_semihosting as _;
use measured::cell::{Commands, Controller, Event, Saved};

/// Tells the host of every transition.
struct Log;

impl Observer<Event, Commands> for Log {
    fn consumed(&mut self, event: Event, source: u32, target: u32) {
        defmt::println!("{} -> {}: {}", source, target, event);
    }

    fn stepped(&mut self, commands: Commands, source: u32, target: u32) {
        defmt::println!("{} -> {}: {}", source, target, commands);
    }
}

#[board::entry]
fn main() -> ! {
    let mut controller = Controller::new();
    controller.raise(Event::FeedBeltControllerBlankArrived);
    let _ = controller.drain_observed(&mut Log);
    // It fits later.
    controller.raise(Event::FeedBeltControllerBlankArrived);
    let bytes = controller.save().to_bytes();

    defmt::println!("reset");
    let saved = Saved::from_bytes(&bytes);
    let same = match saved.and_then(|saved| Controller::restore(&saved)) {
        Ok(mut restored) => {
            let same = restored == controller;
            defmt::println!("restored: {}", restored);
            restored.raise(Event::FeedArmControllerPickedUpItem);
            let _ = restored.drain_observed(&mut Log);
            same
        }
        Err(error) => {
            defmt::println!("not restored: {}", error);
            false
        }
    };
    let mut damaged = bytes;
    damaged[4] ^= 1;
    defmt::println!("one bit is another: {}", Saved::from_bytes(&damaged).map(|saved| saved.state()));
    board::end(same)
}
