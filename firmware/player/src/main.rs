//! Gives a run of events to a machine and prints a digest of its answers, and the size of its value.
#![no_std]
#![no_main]

use core::hash::{Hash, Hasher};
use core::hint::black_box;
use machine::{Commands, Event, Machine, event, new, step};

/// Numbers of the events.
static RUN: &[u8] = include_bytes!(env!("RUN", "`cargo xtask compare` names the file"));

#[board::entry]
fn main() -> ! {
    // Through a pointer, so that the optimiser knows nothing of the arguments.
    let step = black_box(step as fn(&mut Machine, Event) -> Option<Commands>);
    let mut machine = new();
    let mut digest = Digest(1);
    for event in RUN.iter().filter_map(|&number| event(number)) {
        step(&mut machine, event).hash(&mut digest);
    }
    board::println!("{:08x} {}", digest.0, size_of::<Machine>());
    board::end(true)
}

/// Of words: discriminants are hashed as `isize`.
struct Digest(u32);

impl Hasher for Digest {
    fn finish(&self) -> u64 {
        self.0.into()
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_isize(isize::from(byte)));
    }

    fn write_isize(&mut self, word: isize) {
        self.0 = (self.0.rotate_left(5) ^ word as u32).wrapping_mul(0x9E37_79B9);
    }
}
