//! What the tests of several modules play.

use crate::model::Spec;
use crate::pipeline::specification;
use crate::syntax::{Loaded, load};

/// A controller and its surroundings, as a text; `body` is a collaboration's and begins in line 12.
pub(crate) fn world(body: &str) -> String {
    const WORLD: &str = "specification World {
  domain d {
    class User { }
    class Control { press() release() tick() }
    class Lamp { on() off() blink() }
  }
  object user: User
  object control: Control
  object lamp: Lamp
  controllable { Control }
  collaboration C {
BODY
  }
}";
    WORLD.replace("BODY", body)
}

/// A text that imports nothing.
pub(crate) fn loaded(text: &str) -> Loaded {
    load("world.sml", text.as_bytes(), &mut |_| Err("no imports".to_owned()))
}

/// The specification of a text.
#[track_caller]
pub(crate) fn spec(text: &str) -> Spec {
    specification(&loaded(text)).expect("a specification")
}
