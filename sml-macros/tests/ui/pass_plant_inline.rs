//! A user's crate that suffers no warnings; the controller remembers what no sensor shows.
#![deny(warnings, missing_docs, unreachable_pub, missing_debug_implementations, rust_2018_idioms, unused)]
#![forbid(unsafe_code)]

sml_macros::plant! {
    /// A stamp that is used once.
    plant Stamp {
      output
        /// The valve.
        Down
      input Top, Bottom
      controllable lower { set Down }
      controllable lift { reset Down }
      uncontrollable arrived
      uncontrollable returned
      automaton Head {
        initial state Above [!Down && Top] { lower -> Sinks }
        state Sinks [Down && !Bottom] { arrived -> Below }
        state Below [Down && Bottom] { lift -> Rises }
        state Rises [!Down && !Top] { returned -> Above }
      }
      /// Once.
      constraint automaton Once {
        initial state Never { lower -> Done }
        state Done
      }
    }
}

fn main() {
    use stamp::{Event, Inputs, Outputs, scan};
    let (above, below) = (Inputs { top: true, bottom: false }, Inputs { top: false, bottom: true });
    let mut outputs = Outputs::default();
    let mut events = |inputs| scan(&inputs, &mut outputs).iter().collect::<Vec<_>>();
    assert_eq!(events(above), [Event::Lower]);
    assert_eq!(events(below), [Event::Lift]);
    assert_eq!(events(above), []);
}
