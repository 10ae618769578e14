use super::*;
use crate::pipeline::{Failure, Options, Timings, play_and_solve, specification, synthesize};
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

/// The explanation, one line for each part that says something.
fn explained(body: &str) -> String {
    let text = WORLD.replace("BODY", body);
    let loaded = load("world.sml", text.as_bytes(), &mut |_| Err("no imports".to_owned()));
    let spec = specification(&loaded).expect("a specification");
    let mut timings = Timings::default();
    let options = Options::default();
    let mut solved = play_and_solve(&spec, &options, &mut timings).expect("a game");
    let explanation = explain(&solved);
    match synthesize(&mut solved, &options, &mut timings) {
        Ok(_) => assert_eq!(explanation, None),
        Err(Failure::Unrealizable(unrealizable)) => {
            assert_eq!(Some(&unrealizable.explanation), explanation.as_ref());
        }
        Err(failure) => panic!("{failure:?}"),
    }
    let Some(Explanation { cause, scenarios, play, cycle, starved, blocked, .. }) = explanation else {
        return "realizable".to_owned();
    };
    let mut lines = vec![format!("{} {}", cause.as_str(), scenarios.join(", "))];
    lines.push(format!("play {}", play.join(", ")));
    if !cycle.is_empty() {
        lines.push(format!("loop {}", cycle.join(", ")));
    }
    if let Some(Starved { scenario, fragment }) = starved {
        lines.push(format!(
            "starved {scenario} {}",
            text.lines().nth(fragment.start.line as usize - 1).unwrap()
        ));
    }
    lines.extend(
        blocked.iter().map(|blocked| format!("blocked {} by {}", blocked.event, blocked.by.join(", "))),
    );
    let lines: Vec<String> =
        lines.iter().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    lines.join("\n")
}

#[track_caller]
fn check(body: &str, expect: &str) {
    let expect: Vec<&str> = expect.lines().map(str::trim).collect();
    assert_eq!(explained(body), expect.join("\n"));
}

#[test]
fn nothing_is_explained_where_the_system_wins() {
    check("guarantee scenario G { user -> control.press() urgent control -> lamp.on() }", "realizable");
}
