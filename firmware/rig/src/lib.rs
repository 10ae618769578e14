//! The simulated plant of the production cell, with memory for it. The controller needs no heap; the plant does.
#![no_std]

use core::mem::MaybeUninit;
use embedded_alloc::LlffHeap;

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
