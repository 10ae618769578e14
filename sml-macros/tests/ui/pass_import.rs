//! The domain is imported, its path relative to the package too.
#![deny(warnings)]

sml_macros::sml! {
    import "specs/devices.sml"
    specification Lamp {
        controllable { Control }
        collaboration Lamp {
            guarantee scenario Answers {
                button -> control.pressed()
                urgent control -> bulb.on()
            }
        }
    }
}

fn main() {
    let mut controller = lamp::Controller::new();
    let commands = controller.react(lamp::Event::ButtonControlPressed).expect("it fits");
    assert_eq!(commands.bulb, Some(lamp::BulbCommand::On));
}
