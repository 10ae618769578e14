//! Plays ten thousand events to the controller of `measured::line`.
#![no_std]
#![no_main]

use measured::line::Controller;
use measured::play;

#[board::entry]
fn main() -> ! {
    board::println!("{}", play::<Controller>());
    board::end(true)
}
