//! What nobody can prevent, at the constraint.

sml_macros::plant! {
    plant Boiler {
        output Burner
        input Hot, Whole
        controllable light { set Burner }
        uncontrollable boil
        uncontrollable burst

        automaton Water {
            initial state Cold [!Hot && Whole] { boil -> Boils }
            state Boils [Hot && Whole] { burst -> Gone }
            state Gone [!Whole]
        }
        automaton Fire {
            initial state Out [!Burner] { light -> Burns }
            state Burns [Burner]
        }
        constraint Stays: never Water.Gone
    }
}

fn main() {}
