//! Plants whose feedback is known from the literature, or by counting.

use sml_tests::plant_builder::{PlantBuilder, event};
use sml_tests::plant_families::{philosophers, transfer_line};
use synth_core::diagnostic::Code;
use synth_core::explore::Limits;
use synth_core::plant::{
    ClosedLoop, EventId, Figures, Plant, Realization, Reason, SuperviseError, Synthesis, Unavoidable, Why,
    supervise, write_json,
};
use synth_core::syntax::FileId;

#[track_caller]
fn feedback(plant: &Plant) -> ClosedLoop {
    supervise(plant, &Limits::default()).expect("a feedback")
}

/// Why an event is inhibited in an entry.
fn why(plant: &Plant, closed: &ClosedLoop, entry: usize, event: EventId) -> Option<Why> {
    let synthesis = Synthesis::new(plant, &Limits::default()).expect("a feedback");
    synthesis.why(closed, entry, event)
}

#[track_caller]
fn refusal(plant: &Plant) -> Unavoidable {
    match supervise(plant, &Limits::default()) {
        Err(SuperviseError::Refused(refusal)) => *refusal,
        other => panic!("{other:?}"),
    }
}

fn names(plant: &Plant, events: impl IntoIterator<Item = u32>) -> String {
    let names: Vec<&str> =
        events.into_iter().map(|event| plant.events[event as usize].name.as_str()).collect();
    names.join(" ")
}

fn states(plant: &Plant, states: &[u16]) -> String {
    let names =
        plant.automata.iter().zip(states).map(|(one, &state)| one.states[state as usize].name.as_str());
    names.collect::<Vec<_>>().join(" ")
}

/// Entries whose text contains this, as `states: inhibited`.
fn rows(plant: &Plant, closed: &ClosedLoop, with: &str) -> Vec<String> {
    (0..closed.len())
        .map(|entry| {
            let inhibited = names(plant, closed.inhibited(entry).iter().copied());
            format!("{}: {inhibited}", states(plant, closed.entry(entry)))
        })
        .filter(|row| row.contains(with))
        .collect()
}

/// Festo's distribution station (Côté, St-Denis, Kerjean, ETFA 2005, section 5).
const STATION: &str = include_str!("../plants/distribution_station.plant");

#[track_caller]
fn read(text: &str) -> Plant {
    synth_core::plant::read(text, FileId(0)).expect("a plant").0
}

#[test]
fn the_distribution_station_is_that_of_the_publication() {
    let plant = read(STATION);
    let closed = feedback(&plant);
    assert_eq!((closed.plant, closed.len()), (Some((128, 512)), 52));
    // The fourteen rows of Table 1, in order of the file.
    let expected = [
        "I2B BE B2D HF: inject right grab",
        "I2B BE B2D HH: inject right rls",
        "I2B BF B2D HF: inject grab",
        "I2B BF B2D HH: inject rls",
        "I2D BE B2D HF: reset right",
        "I2D BE B2D HG: reset right",
        "I2D BE B2D HH: right rls",
        "I2D BF B2D HF: reset right",
        "I2D BF B2D HG: reset right",
        "I2D BF B2D HH: right rls",
        "IMB BE B2D HF: grab",
        "IMB BE B2D HH: rls",
        "IMB BF B2D HF: grab",
        "IMB BF B2D HH: rls",
    ];
    assert_eq!(rows(&plant, &closed, " B2D "), expected);
}

#[test]
fn what_must_never_be_is_kept_by_inhibiting_what_leads_there() {
    let kept = read(STATION);
    let free = STATION.replace(" && !Injector.IMD", "");
    assert!(free.len() < STATION.len());
    let end = free.rfind('}').expect("a brace");
    let plant = read(&format!("{} constraint Clear: never Injector.IMD && !Boom.B2T }}", &free[..end]));
    let (kept, closed) = (feedback(&kept), feedback(&plant));
    assert_eq!(closed.len(), 52);
    let of = |closed: &ClosedLoop| (closed.states.clone(), closed.edges.clone(), closed.inhibited.clone());
    assert_eq!(of(&closed), of(&kept));

    let left = event(&plant, "left");
    let entry = (0..closed.len()).find(|&one| states(&plant, closed.entry(one)) == "IMD BE B2T HF");
    let reason = why(&plant, &closed, entry.expect("an entry"), left).expect("inhibited");
    assert_eq!(reason.text(&plant), "`Clear` would be violated");
}

#[test]
fn transfer_lines_have_two_times_five_to_the_power_of_buffers() {
    for machines in 2..=7 {
        let plant = transfer_line(machines);
        let closed = feedback(&plant);
        assert_eq!(closed.len(), 2 * 5_usize.pow(machines - 1), "{machines} machines");
        let (states, transitions) = (1 << machines, u64::from(machines) << machines);
        assert_eq!(closed.plant, Some((states, transitions)));
        // Buffers are the memory.
        assert_eq!(closed.memory(&plant).len() as u32, machines - 1);
    }
}

#[test]
fn a_line_is_held_where_its_buffer_would_overflow() {
    let plant = transfer_line(2);
    let closed = feedback(&plant);
    let expected = ["I I 0: start2", "I I 2: start1", "I W 2: start1", "W I 0: start2"];
    let rows = rows(&plant, &closed, "");
    assert_eq!(rows.iter().filter(|row| !row.ends_with(": ")).collect::<Vec<_>>(), expected.each_ref());
    let entry = |text: &str| rows.iter().position(|row| row.starts_with(text)).expect("an entry");
    let reason =
        |text: &str, of: &str| why(&plant, &closed, entry(text), event(&plant, of)).expect("inhibited");
    assert!(matches!(reason("I I 0", "start2"), Why::Forbidden(_)));
    assert_eq!(reason("I I 0", "start2").text(&plant), "`Buffer1` forbids it");
    assert_eq!(reason("I I 2", "start1").text(&plant), "`done1` could happen, which `Buffer1` forbids");
}

/// A philosopher thinks (T), holds the left fork (L) or eats (E), and who eats has the fork of the right neighbour, who then
/// thinks. So states are the words in a circle over T, L and E with T behind every E: as many as the Pell-Lucas numbers
/// 2, 6, 14, 34, 82, ... (q(n) = 2 q(n - 1) + q(n - 2)). One of them blocks: all hold their left forks.
#[test]
fn philosophers_are_kept_from_taking_all_left_forks() {
    let (mut before, mut states) = (2, 6);
    for count in 2..=8 {
        let plant = philosophers(count);
        let closed = feedback(&plant);
        assert_eq!(closed.constrained.0, states, "{count} philosophers");
        assert_eq!(closed.len() as u64, states - 1, "{count} philosophers");
        (before, states) = (states, 2 * states + before);
    }
    let plant = philosophers(3);
    let closed = feedback(&plant);
    assert_eq!(
        rows(&plant, &closed, "T L L ").first().map(|row| row.split(": ").nth(1).unwrap_or_default()),
        Some("left0")
    );
    let take = event(&plant, "left0");
    let entry = (0..closed.len()).find(|&entry| closed.entry(entry).starts_with(&[0, 1, 1])).expect("one");
    assert_eq!(
        why(&plant, &closed, entry, take).expect("inhibited").text(&plant),
        "no marked state of `Philosopher0` could be reached any more"
    );
}

/// Wonham's small factory ("Notes on control of discrete-event systems", chapter 3): two machines that may break down while
/// they work, a buffer of one place between them, and machine 2 is repaired first. With an empty buffer the machines are in
/// any of their nine states, with 20 transitions; with a full one machine 1 is idle, which leaves three states and four
/// transitions.
#[test]
fn a_workcell_with_breakdowns() {
    let machine = |i: u32| format!("I* start{i} W, W done{i} I, W break{i} D, D repair{i} I");
    let plant = PlantBuilder::new()
        .controllable("start1 start2 repair1 repair2")
        .uncontrollable("done1 done2 break1 break2")
        .component("Machine1", &machine(1))
        .component("Machine2", &machine(2))
        .constraint("Buffer", "Empty* done1 Full, Full start2 Empty")
        .constraint("Priority", "Fine* break2 Broken, Broken repair2 Fine, Fine repair1 Fine")
        .build();
    let closed = feedback(&plant);
    assert_eq!(closed.plant, Some((9, 24)));
    assert_eq!((closed.len(), closed.edges.len()), (12, 24));
}

/// The maze of Wonham and Ramadge ("On the supremal controllable sublanguage of a given language", SIAM Journal on Control and
/// Optimization 1987, section 7.3): a cat and a mouse in five rooms, with doors for the one or the other; the door `c7` is
/// always open. They are to be able to come back to where they started, and never to meet.
#[test]
fn cat_and_mouse() {
    let meet: Vec<String> = (0..5).map(|room| format!("Cat.r{room} && Mouse.r{room}")).collect();
    let plant = PlantBuilder::new()
        .controllable("c1 c2 c3 c4 c5 c6 m1 m2 m3 m4 m5 m6")
        .uncontrollable("c7")
        .component("Cat", "r2* c3 r0, r0 c1 r1, r0 c4 r3, r1 c2 r2, r1 c7 r3, r3 c7 r1, r3 c5 r4, r4 c6 r0")
        .component("Mouse", "r4* m5 r3, r0 m1 r2, r0 m4 r4, r1 m3 r0, r2 m2 r1, r3 m6 r0")
        .never("Apart", &meet.join(" || "))
        .build();
    let closed = feedback(&plant);
    assert_eq!(closed.plant, Some((25, 70)));
    let expected = ["r2 r4: ", "r2 r3: c3", "r2 r0: c3 m1", "r0 r4: m5", "r1 r4: m5", "r3 r4: c5 m5"];
    assert_eq!(rows(&plant, &closed, ""), expected);
    assert_eq!(closed.edges.len(), 9);
}

#[test]
fn a_tank_that_nobody_can_stop() {
    let plant = PlantBuilder::new()
        .controllable("open")
        .uncontrollable("rise")
        .component("Valve", "Shut open Open")
        .component("Level", "Low rise High, High rise Over")
        .never("Dry", "Level.Over")
        .build();
    let refusal = refusal(&plant);
    assert_eq!(names(&plant, refusal.play.iter().copied()), "rise rise");
    assert_eq!((refusal.forced, &refusal.reason), (2, &Reason::Never(0)));
    let diagnostic = refusal.diagnostic(&plant);
    assert_eq!(diagnostic.message, "no feedback can keep `Dry`");
    assert_eq!(diagnostic.label, "this holds at the end of the play");
    assert_eq!(
        diagnostic.notes,
        [
            "the play:\n  rise  (the plant, and nobody can prevent it)\n  rise  (the plant, and nobody can prevent it)",
            "the automata at the end of the play: Valve.Shut, Level.Over",
        ]
    );
}

/// Nothing bad happens unless one starts, but only who starts comes to a marked state.
#[test]
fn the_only_way_leads_to_what_cannot_be_prevented() {
    let plant = PlantBuilder::new()
        .controllable("start stop jump")
        .uncontrollable("burst")
        .component("Press", "Idle start Up, Up stop Done*, Up burst Broken, Idle jump Broken, Done, Broken")
        .never("Whole", "Press.Broken")
        .build();
    let refusal = refusal(&plant);
    assert_eq!(names(&plant, refusal.play.iter().copied()), "start burst");
    assert_eq!((refusal.forced, &refusal.reason), (1, &Reason::Never(0)));
}

#[test]
fn a_plant_that_is_bad_from_the_start() {
    let plant = PlantBuilder::new()
        .controllable("go")
        .uncontrollable("drop")
        .component("Arm", "Up drop Down, Up go Up, Down go Up")
        .only("drop", "Arm.Down")
        .build();
    let refusal = refusal(&plant);
    assert_eq!((refusal.play.len(), refusal.forced), (0, 0));
    assert!(matches!(refusal.reason, Reason::Forbidden(1, _)));
    assert_eq!(refusal.diagnostic(&plant).label, "forbids `drop` in the initial state");
}

#[test]
fn a_plant_without_a_way_to_marked_states() {
    let plant = PlantBuilder::new()
        .controllable("go back")
        .component("Arm", "Up go Down*, Down back Up")
        .only("go", "Arm.Down")
        .build();
    let refusal = refusal(&plant);
    assert!(refusal.play.is_empty());
    let Reason::Blocked { unmarked, forbidden } = &refusal.reason else { panic!("{:?}", refusal.reason) };
    assert_eq!((unmarked.as_slice(), forbidden.len()), (&[0][..], 1));
    let diagnostic = refusal.diagnostic(&plant);
    assert_eq!(diagnostic.message, "no feedback is nonblocking");
    assert_eq!(diagnostic.labels[0].1, "forbids `go` there");
}

/// A hundred pumps that a conveyor of two states lets run one at a time: the components alone have 2^100 states.
#[test]
fn constraints_cut_products_on_the_way() {
    let pumps = 0..100;
    let events: Vec<String> = pumps.clone().map(|i| format!("on{i} off{i}")).collect();
    let mut builder = PlantBuilder::new().controllable(&events.join(" "));
    for i in pumps.clone() {
        builder = builder.component(&format!("Pump{i}"), &format!("Off on{i} On, On off{i} Off"));
    }
    let one: Vec<String> = pumps.map(|i| format!("None on{i} Some, Some off{i} None")).collect();
    let closed = feedback(&builder.constraint("One", &one.join(", ")).build());
    assert_eq!((closed.plant, closed.len()), (None, 101));
}

fn json(plant: &Plant, closed: &ClosedLoop) -> serde_json::Value {
    let realization = Realization {
        formulas: vec![("right".to_owned(), "X2 && !X3".to_owned())],
        figures: Figures { instructions: 116, stack_depth: 2, rungs: 6, literals: 80 },
    };
    let mut text = Vec::new();
    write_json(plant, closed, Some(&realization), &mut text).expect("written");
    serde_json::from_slice(&text).expect("JSON")
}

#[test]
fn json_has_figures_feedback_and_formulas() {
    let plant = read(STATION);
    let found = json(&plant, &feedback(&plant));
    for (member, value) in [
        ("version", 1),
        ("plant_states", 128),
        ("plant_transitions", 512),
        ("entries", 52),
        ("instructions", 116),
        ("stack_depth", 2),
        ("rungs", 6),
    ] {
        assert_eq!(found[member], value, "{member}");
    }
    assert_eq!(found["feedback"].as_array().map(Vec::len), Some(52));
    let first = serde_json::json!({
        "state": {"Injector": "I2B", "Barrel": "BE", "Boom": "B2D", "Hook": "HF"},
        "inhibited": ["inject", "right", "grab"],
        "enabled": [],
    });
    assert_eq!(found["feedback"][0], first);
    assert_eq!(found["formulas"], serde_json::json!({"right": "X2 && !X3"}));
}

#[test]
fn states_name_constraint_automata_that_carry_memory() {
    let line = transfer_line(2);
    let closed = feedback(&line);
    let last = serde_json::json!({"Machine1": "W", "Machine2": "W", "Buffer1": "1"});
    assert_eq!(json(&line, &closed)["feedback"][9]["state"], last);
    assert_eq!(closed.table(&line).lines().nth(1), Some("I         I         0        start2     start1"));
    assert_eq!(
        closed.figures(),
        "plant: 4 states, 8 transitions\nconstrained: 12 states, 18 transitions\nfeedback: 10 entries\n"
    );
    // What follows a component remembers nothing.
    let plant = PlantBuilder::new()
        .controllable("on off")
        .component("Lamp", "Dark on Lit, Lit off Dark")
        .constraint("Same", "A on B, B off A")
        .build();
    let closed = feedback(&plant);
    assert_eq!(json(&plant, &closed)["feedback"][1]["state"], serde_json::json!({"Lamp": "Lit"}));
}

/// The text behind `label` in an explanation, with the lines that continue it.
fn example(code: Code, label: &str) -> String {
    let mut lines = code.explanation().lines().skip_while(|line| !line.starts_with(label));
    let first = lines.next().and_then(|line| line.strip_prefix(label)).expect("an example");
    let more: Vec<&str> = lines.take_while(|line| line.starts_with(' ')).collect();
    format!("{first}\n{}", more.join("\n"))
}

#[test]
fn the_example_of_the_diagnostic_is_wrong_and_right() {
    let wrong = read(&example(Code::NoFeedback, "Wrong:"));
    let diagnostic = refusal(&wrong).diagnostic(&wrong);
    assert_eq!(diagnostic.code, Code::NoFeedback);
    // The name of the constraint.
    assert_eq!((diagnostic.span.start.line, diagnostic.span.start.column), (1, 45));
    feedback(&read(&example(Code::NoFeedback, "Right:")));
}
