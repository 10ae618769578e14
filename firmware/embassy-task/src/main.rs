//! The controller in a task of embassy's executor: the timer's interrupt lets the plant go on and sends the sensors'
//! events through a channel, on which the task waits.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;
use embassy_executor::Executor;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::channel::Channel;
// Its critical sections stand for compare-and-swap.
use portable_atomic as _;
use production_cell::production_cell::{Controller, Event};
use static_cell::StaticCell;

/// Items until the end.
const ITEMS: u64 = 500;
/// Cycles of the processor between two interrupts.
const TICK: u32 = 2_000;

static PLANT: rig::Shared = rig::Shared::new();
/// Ten events can be on their way at once, each but once.
static SENSORS: Channel<CriticalSectionRawMutex, Event, 16> = Channel::new();
static EXECUTOR: StaticCell<Executor> = StaticCell::new();

#[exception]
fn SysTick() {
    PLANT.advance(|event| SENSORS.try_send(event).expect("every event fits"));
}

#[embassy_executor::task]
async fn control() {
    let mut controller = Controller::new();
    let mut accidents = 0;
    while PLANT.delivered() < ITEMS && accidents == 0 {
        let event = SENSORS.receive().await;
        assert!(controller.raise(event), "no event is lost");
        // What came at the same time belongs to the same cycle.
        while let Ok(event) = SENSORS.try_receive() {
            assert!(controller.raise(event), "no event is lost");
        }
        PLANT.carry_out(controller.drain());
        accidents = PLANT.accidents().len();
    }
    board::println!("{ITEMS} items delivered by a task, {accidents} accidents");
    board::end(accidents == 0)
}

#[board::entry]
fn main() -> ! {
    rig::heap();
    PLANT.begin(1);
    if let Some(Peripherals { mut SYST, .. }) = Peripherals::take() {
        SYST.set_clock_source(SystClkSource::Core);
        SYST.set_reload(TICK);
        SYST.clear_current();
        SYST.enable_counter();
        SYST.enable_interrupt();
    }
    EXECUTOR.init(Executor::new()).run(|spawner| spawner.spawn(control().expect("one task fits")))
}
