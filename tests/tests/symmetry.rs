//! Verdict and figures up to symmetry are those of the whole game.

use sml_tests::families::arbiter;
use sml_tests::random::{Features, Options as RandomOptions, specification};
use sml_tests::{corpus, fast};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use synth_core::explore::{ExploreError, explore};
use synth_core::model::Spec;
use synth_core::pipeline::{Failure, Timings};
use synth_core::symmetry::{Reduced, Symmetry, decide};

/// Larger games are not compared.
const MOST_STATES: usize = 4000;

/// The names of interchangeable objects, in sets.
fn groups(spec: &Spec, symmetry: &Symmetry) -> String {
    let name = |&object: &usize| spec.domain.objects[object].name.as_str();
    let group = |group: &Vec<usize>| group.iter().map(name).collect::<Vec<_>>().join(" ");
    symmetry.groups().iter().map(group).collect::<Vec<_>>().join(", ")
}

fn reduced(spec: &Spec, classic: bool) -> Result<Reduced, ExploreError> {
    let options = fast::options(classic, MOST_STATES);
    decide(spec, options.semantics, &Symmetry::of(spec), &options.limits, &mut Timings::default())
}

/// Compares with the whole game in both semantics; the verdicts, the default one first, and how many representatives there are in it.
/// Nothing if a play reaches a mistake, or if there are too many states.
#[track_caller]
fn compare(name: &str, text: &str, spec: &Spec) -> Option<([bool; 2], usize)> {
    let mut verdicts = [false; 2];
    let mut representatives = 0;
    for classic in [true, false] {
        let found = reduced(spec, classic);
        let solved = match fast::solved(spec, &fast::options(classic, MOST_STATES)) {
            Ok(solved) => solved,
            Err(Failure::Wrong(wrong)) => {
                let Err(ExploreError::Play(mistake, play)) = found else {
                    panic!("{name}: {found:?}\n{text}")
                };
                let codes: Vec<_> = wrong.iter().map(|one| one.code).collect();
                assert_eq!(codes, [mistake.code], "{name}\n{text}");
                assert!(shows(spec, classic, &play), "{name}: {play:?}\n{text}");
                return None;
            }
            Err(Failure::Limit(_)) => return None,
            Err(failure) => panic!("{name}: {failure:?}"),
        };
        let found = found.unwrap_or_else(|error| panic!("{name}: {error:?}\n{text}"));
        let figures = solved.figures();
        assert_eq!(found.realizable, figures.realizable, "{name}, classic: {classic}\n{text}");
        assert_eq!(found.figures, Some(figures.into()), "{name}, classic: {classic}\n{text}");
        assert!(found.representatives <= solved.explored.store.len(), "{name}: {found:?}");
        verdicts[usize::from(classic)] = found.realizable;
        representatives = found.representatives;
    }
    Some((verdicts, representatives))
}

/// Whether the play leads to a mistake, and none that is shorter does.
fn shows(spec: &Spec, classic: bool, play: &[String]) -> bool {
    let options = fast::options(classic, MOST_STATES);
    let Err(ExploreError::Play(_, shortest)) = explore(spec, options.semantics, &options.limits) else {
        return false;
    };
    let mut playout = synth_core::playout::Playout::new(spec, options.semantics).expect("few events");
    let Ok(mut config) = playout.initial() else { return play.is_empty() };
    let mut moves = synth_core::playout::Moves::default();
    for event in play {
        if let Err((mistaken, _)) = playout.moves(&config, &mut moves) {
            return play.len() == shortest.len() && mistaken.is_none_or(|at| playout.text(Some(at)) == event);
        }
        let next = moves.moves.iter().find(|one| playout.text(one.event) == event);
        let Some(next) = next else { return false };
        config = next.config.clone();
    }
    play.len() == shortest.len() && playout.moves(&config, &mut moves).is_err()
}

/// `expect` are the sets of interchangeable objects, the verdicts (default and classic), and the number of representatives.
#[track_caller]
fn check(text: &str, expect: (&str, [bool; 2], usize)) {
    let spec = fast::resolved(text).unwrap_or_else(|wrong| panic!("{wrong}"));
    let groups = groups(&spec, &Symmetry::of(&spec));
    let (verdicts, representatives) = compare("specification", text, &spec).expect("a small game");
    assert_eq!((&*groups, verdicts, representatives), expect);
}

#[test]
fn arbiters() {
    for clients in 2..=6 {
        let text = arbiter(clients);
        let names: Vec<String> = (1..=clients).map(|client| format!("client{client}")).collect();
        // With nothing granted, so many clients wait, who are asked whether to yield if there are any; or one has it.
        check(&text, (&names.join(" "), [true; 2], 3 * clients as usize + 1));
    }
}

#[test]
fn many_clients_are_counted() {
    let text = arbiter(40);
    let spec = fast::resolved(&text).expect("a specification");
    let found = reduced(&spec, false).expect("a small game");
    assert!(found.realizable);
    let figures = found.figures.expect("exact");
    assert_eq!(figures.states, u128::from(arbiter::states(40)));
    // Whoever has yielded while somebody waits loses, since nobody need send anything more.
    assert_eq!(figures.yielded_states, (1 << 40) - 1);
    assert_eq!(figures.winning_states, figures.states - figures.yielded_states);
    assert_eq!(figures.transitions, u128::from(arbiter::transitions(40)));
}

/// A dispatcher and its clients.
fn clients(objects: &str, scenarios: &str) -> String {
    format!(
        "specification Clients {{
  domain d {{
    class Client {{ busy: bool  peer: Client  grant() refuse() }}
    class Server {{ request() release() hint(who: Client) }}
  }}
  object server: Server
  {objects}
  controllable {{ Server }}
  non-spontaneous events {{ Server.release }}
  collaboration C {{
    dynamic role Client client
    dynamic role Client other
    {scenarios}
  }}
}}
"
    )
}

const THREE: &str = "object a: Client  object b: Client  object c: Client";
const ASKS: &str = "client -> server.request()";
const ONCE: &str = "assumption scenario Once { client -> server.request() server -> client.grant() }
    constraints [ forbidden client -> server.request() ]";

#[test]
fn guarantees_with_a_key_each() {
    let granted = format!("guarantee scenario G {{ {ASKS} eventually server -> client.grant() }}");
    check(&clients(THREE, &granted), ("a b c", [true; 2], 7));
    let alternately = format!(
        "{granted}
        guarantee scenario Two {{ server -> client.grant() client -> server.request() }}
          constraints [ forbidden server -> other.grant() ]"
    );
    // Who was granted need never ask again.
    check(&clients(THREE, &alternately), ("a b c", [false; 2], 10));
}

#[test]
fn assumptions_with_a_key_each() {
    let scenarios = |modality: &str| {
        format!(
            "guarantee scenario G {{ {ASKS} eventually server -> client.grant() }}
            guarantee scenario Mutex {{ server -> client.grant() client -> server.release() }}
              constraints [ forbidden server -> other.grant() ]
            assumption scenario R {{ server -> client.grant() {modality} client -> server.release() }}"
        )
    };
    check(&clients(THREE, &scenarios("strict eventually")), ("a b c", [true; 2], 13));
    check(&clients(THREE, &scenarios("strict monitored eventually")), ("a b c", [true; 2], 13));
}

#[test]
fn one_of_them_is_special() {
    let text = clients(
        THREE,
        &format!(
            "guarantee scenario G {{ {ASKS} eventually server -> client.grant() }}
            guarantee scenario B {{ b -> server.request() urgent server -> b.refuse() }}"
        ),
    );
    check(&text, ("a c", [true; 2], 14));
}

#[test]
fn initial_values_tell_objects_apart() {
    let objects =
        "object a: Client { busy: true } object b: Client object c: Client { busy: true } object d: Client";
    let text = clients(
        objects,
        &format!("guarantee scenario G {{ {ASKS} eventually server -> client.setBusy(true) }}"),
    );
    check(&text, ("a c, b d", [true; 2], 57));
    let pairs = "object a: Client { peer: b } object b: Client { peer: a } object c: Client { peer: c }";
    check(
        &clients(pairs, &format!("guarantee scenario G {{ {ASKS} eventually server -> client.grant() }}")),
        ("a b", [true; 2], 11),
    );
}

#[test]
fn scenarios_written_out_for_each() {
    let of_each = |client: &str, others: [&str; 2]| {
        let [one, other] = others;
        format!(
            "guarantee scenario G{client} {{ {client} -> server.request() eventually server -> {client}.grant() }}
            guarantee scenario M{client} {{ server -> {client}.grant() {client} -> server.release() }}
              constraints [ forbidden server -> {one}.grant() forbidden server -> {other}.grant() ]
            assumption scenario R{client} {{ server -> {client}.grant() strict eventually {client} -> server.release() }}"
        )
    };
    let all = [of_each("a", ["b", "c"]), of_each("b", ["a", "c"]), of_each("c", ["b", "a"])];
    check(&clients(THREE, &all.join("\n")), ("a b c", [true; 2], 13));
    // Without that of one, only the others are alike.
    check(&clients(THREE, &all[..2].join("\n")), ("a b", [true; 2], 9));
    let doubled = all.join("\n") + &all.join("\n").replace("scenario ", "scenario Again");
    check(&clients(THREE, &doubled), ("a b c", [true; 2], 13));
}

#[test]
fn variables_and_attributes_hold_objects() {
    let turns = "guarantee scenario Turn { var Client who client -> server.hint(bind who)
          interrupt [who == client] eventually client -> client.setPeer(who) eventually server -> client.grant() }
        assumption scenario Sets { client -> server.hint(*) eventually client -> client.setPeer(*) }";
    check(&clients("object a: Client object b: Client", turns), ("a b", [false; 2], 101));
    let peers = "guarantee scenario Peer { client -> client.setPeer(*) eventually server -> client.grant() }";
    check(&clients(THREE, peers), ("a b c", [true; 2], 124));
    let literal = "guarantee scenario Peer { client -> client.setPeer(*) interrupt [client.peer == a]
          eventually server -> client.grant() }";
    check(&clients(THREE, literal), ("b c", [true; 2], 192));
}

#[test]
fn promises_that_are_kept_by_one_for_another() {
    // The server is lost with one who never answers, but not if all do.
    let scenarios = |modality: &str| {
        format!(
            "guarantee scenario G {{ {ASKS} eventually server -> client.grant() }}
            guarantee scenario Wait {{ server -> client.refuse() client -> server.release() }}
              constraints [ forbidden server -> client.grant() ]
            guarantee scenario First {{ client -> server.request() urgent server -> client.refuse() }}
            assumption scenario R {{ server -> client.refuse() {modality} client -> server.release() }}
            {ONCE}"
        )
    };
    check(&clients(THREE, &scenarios("eventually")), ("a b c", [true; 2], 22));
    let of_any = scenarios("eventually")
        .replace("eventually client -> server.release()", "eventually other -> server.release()");
    check(&clients(THREE, &of_any), ("a b c", [false; 2], 39));
}

#[test]
fn nothing_is_alike() {
    check(
        &clients(
            "object a: Client",
            &format!("guarantee scenario G {{ {ASKS} urgent server -> client.grant() }}"),
        ),
        ("", [true; 2], 2),
    );
}

#[test]
fn two_sets_of_alike_objects() {
    let text = clients(
        THREE,
        &format!(
            "guarantee scenario G {{ {ASKS} eventually server -> client.grant() }}
        guarantee scenario D {{ device -> server.release() eventually server -> device.stop() }}"
        ),
    )
    .replace("class Server", "class Device { stop() } class Server")
    .replace("object a:", "object d1: Device object d2: Device object a:")
    .replace("non-spontaneous events { Server.release }", "")
    .replace("dynamic role Client other", "dynamic role Client other dynamic role Device device");
    check(&text, ("d1 d2, a b c", [true; 2], 23));
}

#[test]
fn mistakes_come_with_a_play() {
    let level = |values: &str| {
        clients(THREE, &format!("guarantee scenario G {{ {ASKS} urgent server -> client.grant() }}"))
            .replace("busy: bool", &format!("level: {values}"))
            .replace(
                "controllable",
                "effects { Server -> Client.grant() { receiver.level = receiver.level + 1 } } controllable",
            )
    };
    let text = level("0..=2");
    let spec = fast::resolved(&text).expect("a specification");
    assert_eq!(compare("level", &text, &spec), None);
    let Err(ExploreError::Play(mistake, play)) = reduced(&spec, false) else { panic!("a mistake") };
    let grants = play.iter().filter(|event| event.ends_with("grant()")).collect::<BTreeSet<_>>();
    assert_eq!((play.len(), grants.len()), (6, 1), "{play:?}");
    let client = &play[5]["server -> ".len()..][..1];
    assert!(mistake.message.contains(&format!("`{client}.level`")), "{} after {play:?}", mistake.message);
}

#[test]
fn the_corpus() {
    let mut with_groups = BTreeSet::new();
    for corpus::Entry { name, text, .. } in corpus::all() {
        let Ok(spec) = fast::resolved(&text) else { continue };
        if !Symmetry::of(&spec).groups().is_empty() {
            with_groups.insert(name.clone());
        }
        compare(&name, &text, &spec);
    }
    assert!(with_groups.contains("arbiter_2"), "{with_groups:?}");
}

/// A random specification, made symmetric: what it says of a device it says of each. `None` if it speaks of none.
fn symmetric(seed: u64, features: Features) -> Option<String> {
    const DEVICES: [&str; 3] = ["dev1", "dev2", "dev3"];
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let text = specification(seed, RandomOptions { size: 2, features });
    let mut all = String::new();
    for line in text.lines() {
        let indent = line.len() - line.trim_start().len();
        let images: BTreeSet<String> = ORDERS
            .iter()
            .map(|order| {
                let aside = DEVICES.iter().enumerate().fold(line.to_owned(), |line, (index, device)| {
                    line.replace(device, &format!("#{index}"))
                });
                let back = order.iter().enumerate();
                back.fold(aside, |line, (index, &image)| line.replace(&format!("#{index}"), DEVICES[image]))
            })
            .collect();
        if line.contains("object dev1") {
            let links = line.contains("link:");
            for device in DEVICES {
                let own = if links { format!(" {{ link: {device} }}") } else { String::new() };
                _ = writeln!(all, "  object {device}: Dev{own}");
            }
        } else if line.contains("object dev2") {
        } else if line.contains("parameter ranges") {
            let ranges = line.replace("[dev1]", "[dev1, dev2, dev3]").replace("[dev2]", "[dev1, dev2, dev3]");
            _ = writeln!(all, "{ranges}");
        } else if line.contains(" scenario ") {
            for (index, image) in images.iter().enumerate() {
                let (before, name) = image.split_once(" scenario S")?;
                _ = writeln!(all, "{before} scenario I{index}S{name}");
            }
        } else if indent == 4 && line.contains(" -> ") {
            let end = if line.trim_start().starts_with("Ctl") { "receiver" } else { "sender" };
            for image in images {
                let image = DEVICES
                    .iter()
                    .fold(image, |line, device| line.replace(&format!("= {device}"), &format!("= {end}")));
                _ = writeln!(all, "{image}");
            }
        } else {
            _ = writeln!(all, "{line}");
        }
    }
    Some(all)
}

/// Of random specifications with these features that are alike in several objects: how many are compared, and how many of these are
/// realizable.
fn random(seeds: std::ops::Range<u64>, features: Features) -> [usize; 2] {
    let mut counts = [0; 2];
    for seed in seeds {
        let Some(text) = symmetric(seed, features) else { continue };
        let spec = fast::resolved(&text).unwrap_or_else(|wrong| panic!("{seed}: {wrong}\n{text}"));
        if Symmetry::of(&spec).groups().is_empty() {
            continue;
        }
        let Some(([realizable, _], _)) = compare(&seed.to_string(), &text, &spec) else { continue };
        counts[0] += 1;
        counts[1] += usize::from(realizable);
    }
    counts
}

#[test]
fn random_specifications() {
    for features in [Features::FULL, Features { dynamic: true, ..Features::CORE }] {
        let [all, realizable] = random(0..80, features);
        assert!(all > 40 && realizable > 10 && realizable < all, "{all}, {realizable}");
    }
}

/// Who asks waits for a release, one at a time, while the other one goes through phases and so changes places with him.
fn waits_among_others(promise: &str) -> String {
    let scenarios = format!(
        "guarantee scenario Waits {{ client -> server.request() monitored eventually client -> server.release() }}
        assumption scenario Once {{ client -> server.request() client -> server.release() }}
          constraints [ forbidden other -> server.request() forbidden client -> server.t0() ]
        assumption scenario Phases {{ client -> server.t0() strict eventually client -> server.t1()
          strict eventually client -> server.t2() strict eventually client -> server.t3() }}
        {promise}"
    );
    clients("object a: Client  object b: Client", &scenarios)
        .replace("request() release()", "request() release() t0() t1() t2() t3()")
        .replace("{ Server.release }", "{ Server.release Server.t1 Server.t2 Server.t3 }")
}

#[test]
fn a_goal_is_followed_to_another_place() {
    check(&waits_among_others(""), ("a b", [false; 2], 26));
}

#[test]
fn a_promise_is_followed_to_another_place() {
    let promise =
        "assumption scenario R { client -> server.request() eventually client -> server.release() }";
    check(&waits_among_others(promise), ("a b", [true; 2], 26));
}
