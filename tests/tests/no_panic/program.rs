//! A program without an operating system or a standard library that uses all of every controller. It links only if
//! the optimiser has removed every path to a panic, since the function that the panic handler calls is nowhere.

#![no_std]
#![no_main]

use core::hint::black_box;

include!("cell.rs");
include!("empty.rs");
include!("dense.rs");
include!("wide.rs");
include!("packed.rs");

unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    unsafe { a_panic_is_reachable() }
}

/// Comparing strings calls this. The program is linked, never run.
#[no_mangle]
extern "C" fn bcmp(_: *const u8, _: *const u8, _: usize) -> i32 {
    black_box(0)
}

macro_rules! use_all {
    ($module:ident) => {
        let mut controller = $module::Controller::new();
        let controller = black_box(&mut controller);
        let event = $module::Event::from_text(black_box("a"));
        if let Some(event) = black_box(event) {
            black_box(controller.raise(event));
            black_box(controller.is_pending(event));
            black_box(controller.accepts(event));
            black_box(controller.react(event));
            black_box(event.text());
        }
        let _ = black_box(controller.cycle());
        let _ = black_box(controller.drain());
        black_box(controller.pending().count());
        black_box(controller.owed().count());
        black_box(controller.state());
        controller.reset();
    };
}

struct Hardware(u32);

impl small_cell::Arm for Hardware {
    fn hold(&mut self) {
        self.0 += 1;
    }

    fn move_to_m1(&mut self) {
        self.0 += 2;
    }

    fn move_to_belt(&mut self) {
        self.0 += 3;
    }
}

impl small_cell::Press for Hardware {
    fn press(&mut self) {
        self.0 += 4;
    }
}

#[no_mangle]
extern "C" fn _start() -> ! {
    use_all!(small_cell);
    use_all!(empty);
    use_all!(dense);
    use_all!(wide);
    use_all!(packed);
    let commands = black_box(small_cell::Controller::new().cycle());
    let (mut arm, mut press) = (Hardware(0), Hardware(0));
    commands.dispatch(&mut arm, &mut press);
    black_box(commands.arm.and_then(|arm| small_cell::ArmCommand::from_code(arm.code())));
    black_box((arm.0, press.0));
    #[cfg(feature = "control")]
    black_box([1_u8, 2, 3][black_box(2_usize)]);
    loop {}
}
