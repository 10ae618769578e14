//! The controller as a local resource of an RTIC application: the timer's task lets the plant go on and puts the
//! sensors' events into a queue; a software task of lower priority takes them and steps the controller.
#![no_std]
#![no_main]

use board as _;

#[rtic::app(device = lm3s6965, dispatchers = [GPIOA])]
mod app {
    use cortex_m::peripheral::syst::SystClkSource;
    use heapless::spsc::{Consumer, Producer, Queue};
    use production_cell::production_cell::{Controller, Event};

    /// Items until the end.
    const ITEMS: u64 = 500;
    /// Cycles of the processor between two interrupts.
    const TICK: u32 = 2_000;

    static PLANT: rig::Shared = rig::Shared::new();

    #[shared]
    struct Shared {}

    #[local]
    struct Local {
        controller: Controller,
        sensors: Producer<'static, Event>,
        events: Consumer<'static, Event>,
    }

    // Ten events can be on their way at once, each but once.
    #[init(local = [queue: Queue<Event, 16> = Queue::new()])]
    fn init(context: init::Context) -> (Shared, Local) {
        rig::heap();
        PLANT.begin(1);
        let mut timer = context.core.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(TICK);
        timer.clear_current();
        timer.enable_counter();
        timer.enable_interrupt();
        let (sensors, events) = context.local.queue.split();
        (Shared {}, Local { controller: Controller::new(), sensors, events })
    }

    #[task(binds = SysTick, local = [sensors], priority = 2)]
    fn tick(context: tick::Context) {
        let mut sensed = false;
        PLANT.advance(|event| {
            context.local.sensors.enqueue(event).expect("every event fits");
            sensed = true;
        });
        if sensed {
            // Fails if the task is to run already: then it takes these events, too.
            let _ = control::spawn();
        }
    }

    #[task(local = [controller, events], priority = 1)]
    async fn control(context: control::Context) {
        while let Some(event) = context.local.events.dequeue() {
            assert!(context.local.controller.raise(event), "no event is lost");
        }
        PLANT.carry_out(context.local.controller.drain());
        let accidents = PLANT.accidents().len();
        if PLANT.delivered() >= ITEMS || accidents > 0 {
            board::println!("{ITEMS} items delivered by RTIC, {accidents} accidents");
            board::end(accidents == 0);
        }
    }
}
