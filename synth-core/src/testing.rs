//! What the tests of several modules play.

use crate::model::Spec;
use crate::pipeline::specification;
use crate::syntax::{Loaded, load};
use std::path::{Path, PathBuf};
use std::{env, fs, process};

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

/// An empty folder, for as long as it is held.
#[derive(Debug)]
pub(crate) struct Scratch(PathBuf);

impl Scratch {
    /// `name` tells it from those of other tests.
    #[track_caller]
    pub(crate) fn new(name: &str) -> Scratch {
        let path = env::temp_dir().join(format!("synth-core-{}-{name}", process::id()));
        fs::create_dir(&path).expect("a folder");
        Scratch(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What is left over hurts nobody.
        let _ = fs::remove_dir_all(&self.0);
    }
}
