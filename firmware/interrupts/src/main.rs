//! Interrupts and a main loop: at every tick of the timer the plant goes on, and its sensors put their events into a
//! queue without a lock; the main loop takes them out, and the controller's commands go back to the plant.
//!
//! An event that finds the queue full, or the same event pending, would be lost. None is.
#![no_std]
#![no_main]

use controller_template::{EventQueue, EventSender};
use core::cell::{Cell, RefCell};
use cortex_m::Peripherals;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;
use critical_section::Mutex;
// Its critical sections stand for compare-and-swap.
use portable_atomic as _;
use production_cell::production_cell::{Controller, Event};
use static_cell::StaticCell;

/// Items until the end.
const ITEMS: u64 = 500;
/// Cycles of the processor between two interrupts.
const TICK: u32 = 2_000;

/// Ten events can be on their way at once, each but once.
static QUEUE: StaticCell<EventQueue<Event, 16>> = StaticCell::new();
static SENSORS: Mutex<RefCell<Option<EventSender<'static, Event>>>> = Mutex::new(RefCell::new(None));
static PLANT: rig::Shared = rig::Shared::new();
static SENT: Mutex<Cell<u32>> = Mutex::new(Cell::new(0));

#[exception]
fn SysTick() {
    PLANT.advance(|event| {
        critical_section::with(|token| {
            if let Some(sensors) = SENSORS.borrow_ref_mut(token).as_mut() {
                sensors.send(event);
            }
            SENT.borrow(token).update(|count| count + 1);
        });
    });
}

#[board::entry]
fn main() -> ! {
    rig::heap();
    let (sensors, mut events) = QUEUE.init(EventQueue::new()).split();
    critical_section::with(|token| SENSORS.replace(token, Some(sensors)));
    PLANT.begin(1);
    start_timer();

    let mut controller = Controller::new();
    let mut taken = 0;
    let mut accidents = 0;
    while PLANT.delivered() < ITEMS && accidents == 0 {
        taken += events.deliver(|event| controller.raise(event));
        PLANT.carry_out(controller.cycle());
        accidents = PLANT.accidents().len();
        if events.is_empty() {
            cortex_m::asm::wfi();
        }
    }

    cortex_m::interrupt::disable();
    taken += events.deliver(|event| controller.raise(event));
    let sent = critical_section::with(|token| SENT.borrow(token).get());
    let lost = events.lost() + events.absorbed();
    board::println!("{ITEMS} items delivered by interrupts, {accidents} accidents, {lost} events lost");
    board::println!("every event that was sent was taken: {}", sent == taken);
    board::end(lost == 0 && accidents == 0 && sent == taken)
}

fn start_timer() {
    if let Some(Peripherals { mut SYST, .. }) = Peripherals::take() {
        SYST.set_clock_source(SystClkSource::Core);
        SYST.set_reload(TICK);
        SYST.clear_current();
        SYST.enable_counter();
        SYST.enable_interrupt();
    }
}
