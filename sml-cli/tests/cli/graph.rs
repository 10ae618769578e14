//! `sml graph`.

use crate::support::{corpus, sml, sml_reading};
use serde_json::{Value, json};

#[test]
fn the_graph_has_the_published_figures() {
    for (name, expected) in corpus() {
        for (semantics, figures) in expected.as_object().expect("figures by semantics") {
            let classic = if semantics == "classic" { "--classic" } else { "" };
            let graph = sml(&format!("graph {name}/spec.sml {classic}")).json();
            let states = graph["states"].as_array().expect("states");
            let count = |counts: &dyn Fn(&Value) -> bool| json!(states.iter().filter(|s| counts(s)).count());
            let keys = |kind: &str| {
                let keys = graph["keys"].as_array().expect("keys").iter();
                let open = keys.filter(|key| key["kind"] == kind && key["open"] != json!([]));
                open.count()
            };
            let found = [
                ("states", json!(states.len())),
                ("transitions", json!(graph["edges"].as_array().expect("edges").len())),
                ("system_states", count(&|state| state["owner"] == "system")),
                ("environment_states", count(&|state| state["owner"] == "environment")),
                ("yielded_states", count(&|state| state["yielded"] == true)),
                ("assumption_sets", json!(keys("assumption"))),
                ("guarantee_sets", json!(keys("guarantee") + 1)),
            ];
            for (figure, value) in found {
                assert_eq!(value, figures[figure], "{name}, {semantics}: {figure}");
            }
            consistent(&graph);
        }
    }
}

/// Ids are positions, and everything refers to something.
fn consistent(graph: &Value) {
    let states = graph["states"].as_array().expect("states");
    let keys = graph["keys"].as_array().expect("keys");
    for (id, state) in states.iter().enumerate() {
        assert_eq!(state["id"], json!(id));
        let owner = state["owner"].as_str().expect("an owner");
        let expected = match state["case"].as_u64() {
            Some(1 | 3 | 5) => "system",
            Some(2 | 4 | 6) => "environment",
            _ => "none",
        };
        assert_eq!(owner, expected, "{state}");
    }
    for edge in graph["edges"].as_array().expect("edges") {
        for end in [0, 2] {
            assert!(edge[end].as_u64().expect("a state") < states.len() as u64, "{edge}");
        }
        for key in edge[3].as_array().expect("keys") {
            assert!(key.as_u64().expect("a key") < keys.len() as u64, "{edge}");
        }
    }
    let used = |key: usize| {
        let edges = graph["edges"].as_array().expect("edges");
        keys[key]["open"] != json!([])
            || edges.iter().any(|edge| edge[3].as_array().expect("keys").contains(&json!(key)))
    };
    assert!((0..keys.len()).all(used));
}

const EVERYTHING: &str = "specification Everything {
  domain d {
    enum Color { red, green }
    class Part { color: Color  next: Part }
    class Env { }
    class Ctl { on: bool  level: -1..=2 = 1  color: Color = green  part: Part  go(p: Part, n: 0..=1) done(p: Part, n: 0..=1) }
  }
  object a: Part { next: b }
  object b: Part
  object env: Env
  object ctl: Ctl { part: a }
  controllable { Ctl }
  collaboration C {
    dynamic role Part r
    guarantee scenario S bindings [ r = ctl.part ] {
      var 0..=1 n
      env -> ctl.go(*, bind n)
      urgent ctl -> env.ack(n)
    }
  }
}";

#[test]
fn values_of_every_type() {
    let text = EVERYTHING.replace("class Env { }", "class Env { ack(n: 0..=1) }");
    let run = sml_reading("graph -", text.as_bytes());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let graph = run.json();
    let expected = json!({
        "a.color": "red", "a.next": "b", "b.color": "red", "b.next": null,
        "ctl.on": false, "ctl.level": 1, "ctl.color": "green", "ctl.part": "a",
    });
    assert_eq!(graph["states"][0]["attributes"], expected);
    assert_eq!(graph["states"][0]["copies"], json!([]));
    let started = graph["states"].as_array().expect("states").iter().find(|state| state["owner"] == "system");
    let copies = &started.expect("a state of the system")["copies"];
    assert_eq!(
        *copies,
        json!([{ "scenario": "C.S", "roles": { "r": "a" }, "variables": { "n": 0 }, "cut": "18:7" }])
    );
    let key = &graph["keys"][0];
    assert_eq!(
        (&key["scenario"], &key["kind"], &key["values"]),
        (&json!("C.S[r=a]"), &json!("guarantee"), &json!([0]))
    );
    assert_eq!((&key["line"], &key["column"]), (&json!(18), &json!(7)));
}
