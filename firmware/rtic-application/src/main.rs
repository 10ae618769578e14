//! The controller as a local resource of an RTIC application: the timer's task lets the plant go on and puts the
//! sensors' events into a queue; a software task of lower priority takes them and steps the controller.
#![no_std]
#![no_main]

use board as _;

#[rtic::app(device = lm3s6965, dispatchers = [GPIOA])]
mod app {
    use controller_template::{EventQueue, EventReceiver, EventSender};
    use cortex_m::peripheral::syst::SystClkSource;
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
        sensors: EventSender<'static, Event>,
        events: EventReceiver<'static, Event>,
    }

    // Ten events can be on their way at once, each but once.
    #[init(local = [queue: EventQueue<Event, 16> = EventQueue::new()])]
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
            context.local.sensors.send(event);
            sensed = true;
        });
        if sensed {
            // Fails if the task is to run already: then it takes these events, too.
            let _ = control::spawn();
        }
    }

    #[task(local = [controller, events], priority = 1)]
    async fn control(context: control::Context) {
        let control::LocalResources { controller, events, .. } = context.local;
        events.deliver(|event| controller.raise(event));
        assert!(events.lost() == 0 && events.absorbed() == 0, "no event is lost");
        PLANT.carry_out(controller.drain());
        let accidents = PLANT.accidents().len();
        if PLANT.delivered() >= ITEMS || accidents > 0 {
            board::println!("{ITEMS} items delivered by RTIC, {accidents} accidents");
            board::end(accidents == 0);
        }
    }
}
