//! Calls controllers at random, and once with every event pending, and prints the most probes that a call makes.

use controller_template::take_probes;

/// A controller with events as positions in table order.
trait Measure {
    const EVENTS: usize;
    /// Of `accepts`, `react`, `cycle` and `drain`.
    const BOUNDS: [u32; 4];

    fn start() -> Self;
    fn raise(&mut self, event: usize);
    fn accepts(&self, event: usize) -> bool;
    fn react(&mut self, event: usize);
    fn cycle(&mut self);
    fn drain(&mut self);
}

macro_rules! measure {
    ($module:ident) => {
        impl Measure for $module::Controller {
            const EVENTS: usize = $module::Event::ALL.len();
            const BOUNDS: [u32; 4] =
                [Self::ACCEPTS_PROBES, Self::REACT_PROBES, Self::CYCLE_PROBES, Self::DRAIN_PROBES];

            fn start() -> Self {
                Self::new()
            }
            fn raise(&mut self, event: usize) {
                self.raise($module::Event::ALL[event]);
            }
            fn accepts(&self, event: usize) -> bool {
                self.accepts($module::Event::ALL[event])
            }
            fn react(&mut self, event: usize) {
                let _ = self.react($module::Event::ALL[event]);
            }
            fn cycle(&mut self) {
                let _ = self.cycle();
            }
            fn drain(&mut self) {
                let _ = self.drain();
            }
        }
    };
}

/// The greater of what was found and what was just made.
fn note(most: &mut u32) {
    *most = take_probes().max(*most);
}

fn print<C: Measure>(name: &str) {
    let mut most = [0; 4];
    for drains in [false, true] {
        let mut controller = C::start();
        (0..C::EVENTS).for_each(|event| controller.raise(event));
        if drains {
            controller.drain();
            note(&mut most[3]);
        } else {
            controller.cycle();
            note(&mut most[2]);
        }
    }
    let mut random = 1_u32;
    let mut below = |bound: usize| {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (random >> 16) as usize % bound
    };
    let mut controller = C::start();
    for round in 0..2000 {
        if round % 50 == 0 {
            controller = C::start();
        }
        if C::EVENTS > 0 {
            (0..below(C::EVENTS + 1)).for_each(|_| controller.raise(below(C::EVENTS)));
            for event in 0..C::EVENTS {
                let accepted = controller.accepts(event);
                note(&mut most[0]);
                if accepted && below(4) == 0 {
                    controller.react(event);
                    note(&mut most[1]);
                }
            }
        }
        if below(3) == 0 {
            controller.drain();
            note(&mut most[3]);
        } else {
            controller.cycle();
            note(&mut most[2]);
        }
    }
    let numbers: Vec<String> = most.iter().chain(&C::BOUNDS).map(ToString::to_string).collect();
    println!("{name} {}", numbers.join(" "));
}
