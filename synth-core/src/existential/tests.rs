use super::*;
use crate::pipeline::{Timings, play_and_solve, specification, synthesize};
use crate::syntax::load;

/// A controller and its surroundings; `BODY` is a collaboration's.
const WORLD: &str = "specification World {
  domain d {
    class User { }
    class Control { press() release() tick() }
    class Lamp { on() off() }
  }
  object user: User
  object control: Control
  object lamp: Lamp
  controllable { Control }
  collaboration C {
BODY
  }
}";

/// One line for each existential scenario.
fn examined(body: &str) -> String {
    let text = WORLD.replace("BODY", body);
    let loaded = load("world.sml", text.as_bytes(), &mut |_| Err("no imports".to_owned()));
    let spec = specification(&loaded).expect("a specification");
    let mut timings = Timings::default();
    let options = Options::default();
    let mut solved = play_and_solve(&spec, &options, &mut timings).expect("a game");
    let verified = synthesize(&mut solved, &options, &mut timings).ok();
    let controller = verified.as_ref().map(|verified| &verified.controller);
    let lines = existential(&spec, &options, &solved, controller).expect("no mistakes");
    let line = |existential: Existential| {
        let Existential { scenario, reachable, possible, witness } = existential;
        let verdict = match (reachable, possible) {
            (true, true) => "reachable",
            (false, true) => "possible",
            (false, false) => "impossible",
            (true, false) => panic!("{scenario} is reachable, but not possible"),
        };
        format!("{scenario} {verdict}: {}", witness.join(", "))
    };
    lines.into_iter().map(line).collect::<Vec<_>>().join("\n")
}

#[track_caller]
fn check(body: &str, expect: &str) {
    let expect: Vec<&str> = expect.lines().map(str::trim).collect();
    assert_eq!(examined(body), expect.join("\n"));
}

const LAMP: &str = "guarantee scenario G { user -> control.press() urgent control -> lamp.on() }";

#[test]
fn without_existential_scenarios_there_is_nothing_to_say() {
    check(LAMP, "");
}

#[test]
fn what_the_controller_does_is_reachable() {
    let example = "existential scenario E { user -> control.press() control -> lamp.on() }";
    check(&format!("{LAMP} {example}"), "C.E reachable: user -> control.press(), control -> lamp.on()");
}
