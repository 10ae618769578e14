//! Looks up every event in every state of two controllers, by every engine.
#![no_std]
#![no_main]

use measured::tours;

#[board::entry]
fn main() -> ! {
    for (name, tour) in tours() {
        board::println!("{name}: {}", tour());
    }
    board::end(true)
}
