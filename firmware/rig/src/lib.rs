//! The simulated plant of the production cell, shared between an interrupt and the main program, with memory for it. The
//! controller needs no heap; the plant does.
#![no_std]

extern crate alloc;

use alloc::{boxed::Box, string::String, vec::Vec};
use core::cell::RefCell;
use core::mem::MaybeUninit;
use critical_section::Mutex;
use embedded_alloc::LlffHeap;
use production_cell::plant::Plant;
use production_cell::production_cell::{Commands, Event};
use production_cell::random::Random;

#[global_allocator]
static HEAP: LlffHeap = LlffHeap::empty();

/// Bytes for what the plant and the monitor keep and say.
const SIZE: usize = 4096;

/// Gives the heap its memory, once.
///
/// # Panics
///
/// If it has it already.
pub fn heap() {
    static mut MEMORY: [MaybeUninit<u8>; SIZE] = [MaybeUninit::uninit(); SIZE];
    // SAFETY: nothing else names this memory, and a second call panics.
    unsafe { HEAP.init((&raw mut MEMORY) as usize, SIZE) }
}

/// A plant that an interrupt and the main program reach. In a box, since an absent one is all zeros then: what a static
/// begins with need not be kept in flash.
pub struct Shared(Mutex<RefCell<Option<Box<Plant>>>>);

impl Shared {
    /// Without a plant; nothing happens until [`begin`](Self::begin).
    #[must_use]
    pub const fn new() -> Self {
        Shared(Mutex::new(RefCell::new(None)))
    }

    /// Puts an empty cell there.
    pub fn begin(&self, seed: u64) {
        critical_section::with(|token| {
            self.0.borrow_ref_mut(token).replace(Box::new(Plant::new(Random::new(seed))));
        });
    }

    /// One cycle later: `sensor` gets every event.
    pub fn advance(&self, sensor: impl FnMut(Event)) {
        self.with(|plant| plant.advance().into_iter().for_each(sensor));
    }

    /// Has the drives do what is commanded.
    pub fn carry_out(&self, commands: Commands) {
        self.with(|plant| {
            commands.dispatch(&mut plant.deposit_arm, &mut plant.feed_arm, &mut plant.press);
        });
    }

    /// Items on the deposit belt.
    pub fn delivered(&self) -> u64 {
        self.with(|plant| plant.delivered()).unwrap_or(0)
    }

    /// What the plant took badly since the last call.
    pub fn accidents(&self) -> Vec<String> {
        self.with(Plant::accidents).unwrap_or_default()
    }

    fn with<R>(&self, act: impl FnOnce(&mut Plant) -> R) -> Option<R> {
        critical_section::with(|token| self.0.borrow_ref_mut(token).as_deref_mut().map(act))
    }
}

impl Default for Shared {
    fn default() -> Self {
        Self::new()
    }
}
