//! `sml cycle`.

use crate::support::{scratch, sml, sml_reading};

/// All columns but the state.
fn commands(csv: &str) -> Vec<&str> {
    csv.lines().map(|line| line.split_once(',').map_or("", |(_, commands)| commands)).collect()
}

#[test]
fn one_line_a_cycle() {
    let run = sml_reading("cycle memory/spec.sml --stimulus -", b"clock -> control.tick()\n0\n0\n1\n1\n");
    assert_eq!((run.code, run.stdout.as_str()), (0, "state,lamp\n2,2\n2,0\n3,1\n2,2\n"));
}

#[test]
fn minimisation_changes_no_command() {
    let events = sml("synth production_cell/spec.sml").json();
    let events: Vec<&String> = events["environment"].as_object().expect("rows").keys().collect();
    let mut csv = events.iter().map(|event| format!("\"{event}\"")).collect::<Vec<_>>().join(",");
    let mut seed = 1_u64;
    for _ in 0..300 {
        let row = events.iter().map(|_| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            if seed >> 62 == 0 { "1" } else { "0" }
        });
        csv = format!("{csv}\n{}", row.collect::<Vec<_>>().join(","));
    }
    for drain in ["", "--drain"] {
        let run = |options: &str| {
            sml_reading(
                &format!("cycle production_cell/spec.sml --stimulus - {options} {drain}"),
                csv.as_bytes(),
            )
        };
        let (none, exact) = (run("--minimize none"), run(""));
        assert_eq!((none.code, exact.code), (0, 0), "{}", none.stderr);
        assert_eq!(commands(&none.stdout), commands(&exact.stdout));
        assert!(exact.stdout.lines().skip(1).any(|line| line.contains(",1")), "no command at all");
    }
}

#[test]
fn a_given_controller_runs_instead() {
    let path = scratch("a_given_controller").join("c.json");
    let controller = sml("synth memory/spec.sml").stdout.replace("\"initial\":0", "\"initial\":2");
    std::fs::write(&path, controller).expect("a file");
    let arguments = format!("cycle memory/spec.sml --stimulus - --controller {}", path.display());
    let run = sml_reading(&arguments, b"clock -> control.tick()\n0\n1\n");
    assert_eq!((run.code, run.stdout.as_str()), (0, "state,lamp\n2,0\n3,1\n"), "{}", run.stderr);
}

#[test]
fn a_controller_for_one_event_at_a_time_has_no_cycles() {
    let path = scratch("one_at_a_time").join("c.json");
    let controller = sml("synth memory/spec.sml --minimize ordered").stdout;
    assert!(controller.contains("\"minimize\":\"ordered\""), "{controller}");
    std::fs::write(&path, controller).expect("a file");
    let arguments = format!("cycle memory/spec.sml --stimulus - --controller {}", path.display());
    let run = sml_reading(&arguments, b"clock -> control.tick()\n1\n");
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("needs them one at a time"), "{}", run.stderr);
    let verified = sml(&format!("verify memory/spec.sml {}", path.display()));
    assert_eq!((verified.code, verified.stdout.contains("for one event at a time")), (0, true));
}

#[test]
fn unrealizable_has_no_controller_of_its_own() {
    assert_eq!(sml_reading("cycle unreal_clash/spec.sml --stimulus -", b"x\n").code, 1);
}
