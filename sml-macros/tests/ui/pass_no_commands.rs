//! A controller that has nothing to command, and one that has nothing to hear.
#![deny(warnings, missing_docs)]

sml_macros::sml! {
    specification Listener {
        domain d { class Control { heard() } class Source { } }
        object control: Control
        object source: Source
        controllable { Control }
        collaboration C {
            guarantee scenario Hears { source -> control.heard() }
        }
    }
}

sml_macros::sml! {
    specification Idle {
        domain d { class Control { } }
        object control: Control
        controllable { Control }
    }
}

fn main() {
    let mut listener = listener::Controller::new();
    assert!(listener.raise(listener::Event::SourceControlHeard));
    assert!(listener.cycle().is_empty());
    assert!(idle::Controller::new().cycle().is_empty());
}
