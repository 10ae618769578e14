//! A misspelt keyword, and an operator of another language.

sml_macros::plant! {
    plant Clamp {
        output Air
        input Shut
        controlable close { set Air }
        automaton Jaw {
            initial state Open [NOT Air] { close -> Shut }
            state Shut [Air AND Shut]
        }
    }
}

fn main() {}
