//! Names that nothing declares, each at its own token.

sml_macros::plant! {
    plant Clamp {
        output Air
        input Shut
        controllable close { set Airr }
        uncontrollable closed

        automaton Jaw {
            initial state Open [!Air && Shutt] { close -> Closes }
            state Closes [Air && !Shut] { closedd -> Shut }
            state Shut [Air && Shut]
        }
        constraint Never: close only when Jaw.Opn
    }
}

fn main() {}
