//! What follows from a mistake is no mistake of its own: each of these is reported once.

sml_macros::sml! {
    specification Lamp {
        domain lamp {
            class Bulb { lit: boolean on(level: levels) }
            class Button { }
            class Control { pressed() }
        }
        object control: Control
        object bulb: Bulb
        object button: Buton
        effects { control -> bulb.on(level) { receiver.lit = true } }
        controllable { Control }
        collaboration Lamp {
            dynamic role Control someone
            dynamic role Contrl other
            guarantee scenario Answers {
                var Butten which
                button -> control.pressed()
                wait [bulb.lit]
                urgent control -> bulb.on(1)
                other -> bulb.setLit(false)
                wait [which == which]
                someone -> bulb.on(2)
            }
        }
    }
}

fn main() {}
