//! Plays ten thousand events to the controller of `measured::cell`.
#![no_std]
#![no_main]

use measured::cell::Controller;
use measured::play;

#[board::entry]
fn main() -> ! {
    board::println!("{}", play::<Controller>());
    board::end(true)
}
