//! Rust's keywords are ordinary names, and nothing in scope disturbs the module.
#![deny(warnings)]
#![allow(non_camel_case_types, dead_code, reason = "they are there to disturb")]

struct Option;
struct Event;
struct u8;
mod core {}
mod controller_template {}

sml_macros::sml! {
    specification Loop {
        domain match { class Self { move(type: bool) } class Fn { ref() } class Impl { } }
        object fn: Fn
        object self: Self
        object impl: Impl
        controllable { Fn }
        collaboration C {
            guarantee scenario Moves {
                impl -> fn.ref()
                urgent fn -> self.move(true)
            }
        }
    }
}

fn main() {
    let mut controller = loop_2::Controller::new();
    controller.raise(loop_2::Event::ImplFnRef);
    assert!(!controller.cycle().is_empty());
}
