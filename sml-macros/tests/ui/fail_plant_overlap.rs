//! Two states that look the same, two edges for one event, and no initial state: told in one run.

sml_macros::plant! {
    plant Clamp {
        output Air
        input Shut
        controllable close { set Air }
        uncontrollable closed

        automaton Jaw {
            initial state Open [!Air] { close -> Closes, close -> Shut }
            state Closes [Air && !Shut] { closed -> Shut }
            state Shut [Air && Shut]
        }
        automaton Lid {
            state Up [Shut]
            state Down [!Shut]
        }
    }
}

sml_macros::plant! {
    plant Press {
        output Air
        input Shut
        controllable close { set Air }
        uncontrollable closed

        automaton Jaw {
            initial state Open [!Air] { close -> Closes }
            state Closes [Air] { closed -> Shut }
            state Shut [Air && Shut]
        }
    }
}

fn main() {}
