//! Where a controller fits, and what it is for the compiler.

mod generated {
    include!("../benches/step/bench.rs");
}

use std::sync::Mutex;

use generated::bench::{Commands, Controller, Event, Saved};
use static_cell::{ConstStaticCell, StaticCell};

/// For several threads, tasks or interrupts; without lazy initialisation.
static SHARED: Mutex<Controller> = Mutex::new(Controller::new());
static OWNED: StaticCell<Controller> = StaticCell::new();
static CONST: ConstStaticCell<Controller> = ConstStaticCell::new(Controller::new());

const fn is_send_and_sync<T: Send + Sync + 'static>() {}
const fn is_copy<T: Copy>() {}

const _: () = {
    is_send_and_sync::<Controller>();
    is_send_and_sync::<Saved>();
    is_send_and_sync::<Event>();
    is_send_and_sync::<Commands>();
    is_send_and_sync::<controller_template::RestoreError>();
    is_copy::<Saved>();
    is_copy::<Event>();
    is_copy::<Commands>();
    // The state and a word of pending events.
    assert!(size_of::<Controller>() == 8);
    assert!(size_of::<Saved>() == 12);
};

#[test]
fn statics() {
    fn step(controller: &mut Controller) -> u32 {
        controller.raise(Event::EnvCtlE0000);
        let _ = controller.cycle();
        controller.state()
    }
    let expected = step(&mut Controller::new());
    assert_eq!(step(&mut SHARED.lock().expect("nobody panicked")), expected);
    assert_eq!(step(OWNED.init(Controller::new())), expected);
    assert_eq!(step(CONST.take()), expected);
}
