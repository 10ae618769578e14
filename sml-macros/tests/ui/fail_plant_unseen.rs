//! A constraint that counts what no sensor shows.

sml_macros::plant! {
    plant Belt {
        output Run
        input Light
        controllable start { set Run }
        controllable stop { reset Run }
        uncontrollable passed

        automaton Drive {
            initial state Stands [!Run] { start -> Runs }
            state Runs [Run] { stop -> Stands, passed -> Runs }
        }
        constraint automaton Three {
            initial state Zero { passed -> One }
            state One { passed -> Two }
            state Two { stop -> Zero, passed -> Two }
        }
    }
}

fn main() {}
