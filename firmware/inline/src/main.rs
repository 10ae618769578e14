//! A specification in the program itself: two clients, one at a time. The controller is verified when this is compiled.
#![no_std]
#![no_main]

sml_macros::sml! {
    specification Arbiter {
      domain arbiter {
        class Client { grant() }
        class Arbiter { request()  release() }
      }
      object arbiter: Arbiter
      object left: Client
      object right: Client
      controllable { Arbiter }
      non-spontaneous events { Arbiter.release }
      collaboration Arbiter {
        dynamic role Client client
        dynamic role Client other
        guarantee scenario RequestIsGranted {
          client -> arbiter.request()
          eventually arbiter -> client.grant()
        }
        guarantee scenario OneAtATime {
          arbiter -> client.grant()
          client -> arbiter.release()
        } constraints [ forbidden arbiter -> other.grant() ]
        assumption scenario ClientReleases {
          arbiter -> client.grant()
          strict eventually client -> arbiter.release()
        }
        assumption scenario RequestOnce {
          client -> arbiter.request()
          client -> arbiter.release()
        } constraints [ forbidden client -> arbiter.request() ]
      }
    }
}

use arbiter::{Controller, Event, Left, Right};

/// Who has been granted what it asked for.
#[derive(Default)]
struct Granted {
    left: u32,
    right: u32,
}

struct Client<'g>(&'g mut u32);

impl Left for Client<'_> {
    fn grant(&mut self) {
        *self.0 += 1;
    }
}

impl Right for Client<'_> {
    fn grant(&mut self) {
        *self.0 += 1;
    }
}

#[board::entry]
fn main() -> ! {
    let mut controller = Controller::new();
    let mut granted = Granted::default();
    let mut scan = |events: &[Event]| {
        for &event in events {
            controller.raise(event);
        }
        controller.cycle().dispatch(&mut Client(&mut granted.left), &mut Client(&mut granted.right));
        board::println!("{events:?}: granted {} and {}", granted.left, granted.right);
        granted.left + granted.right
    };
    scan(&[Event::LeftArbiterRequest, Event::RightArbiterRequest]);
    scan(&[]);
    scan(&[Event::LeftArbiterRelease]);
    let all = scan(&[Event::RightArbiterRelease]);
    board::end(all == 2)
}
