//! What every program here needs of its board: start, output and end by semihosting, and what happens on a panic.
//!
//! The memory of each target's board is in `memory/`.
#![no_std]

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;
pub use semihosting::{print, println};

// Their critical sections.
#[cfg(target_arch = "arm")]
use cortex_m as _;
#[cfg(target_arch = "riscv32")]
use riscv as _;
use semihosting::process;

/// Ends the program; the emulator exits with 0 if it `succeeded`, else with 1.
pub fn end(succeeded: bool) -> ! {
    process::exit(i32::from(!succeeded))
}

#[cfg(all(target_os = "none", not(feature = "no-panic")))]
#[panic_handler]
fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
    println!("{info}");
    process::exit(101)
}

#[cfg(all(target_os = "none", feature = "no-panic"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    unsafe extern "C" {
        // Defined nowhere: the linker names it if a panic can be reached.
        safe fn a_panic_can_be_reached() -> !;
    }
    a_panic_can_be_reached()
}
