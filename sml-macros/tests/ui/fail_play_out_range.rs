//! A counter that some play drives out of its range.

sml_macros::sml! {
    specification Counter {
        domain d { class Control { count: 0..=2 tick() } class Clock { } class Bell { ring() } }
        object control: Control
        object clock: Clock
        object bell: Bell
        effects {
            clock -> control.tick() { receiver.count = receiver.count + 1 }
        }
        controllable { Control }
        collaboration Counter {
            guarantee scenario Rings {
                clock -> control.tick()
                urgent control -> bell.ring()
            }
        }
    }
}

fn main() {}
