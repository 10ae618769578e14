//! What reports say of an event and what rungs do is the same Boolean function, whatever formulas may do where the plant cannot
//! be. Read and evaluated here anew, on all values of the variables.

use synth_core::explore::Limits;
use synth_core::logic::Expr;
use synth_core::plant::remember::remember;
use synth_core::plant::{DontCare, Options, Plant, Program, read, state_feedback, supervise};
use synth_core::syntax::FileId;

/// A condition in the syntax of plants, one of whose variables are bits of a number.
struct Reader<'a> {
    text: &'a [u8],
    names: &'a [String],
    row: u32,
}

impl Reader<'_> {
    fn eat(&mut self, word: &str) -> bool {
        while self.text.first() == Some(&b' ') {
            self.text = &self.text[1..];
        }
        let is_there = self.text.starts_with(word.as_bytes());
        if is_there {
            self.text = &self.text[word.len()..];
        }
        is_there
    }

    fn any(&mut self) -> bool {
        let mut value = self.all();
        while self.eat("||") {
            value |= self.all();
        }
        value
    }

    fn all(&mut self) -> bool {
        let mut value = self.one();
        while self.eat("&&") {
            value &= self.one();
        }
        value
    }

    fn one(&mut self) -> bool {
        if self.eat("!") {
            return !self.one();
        }
        if self.eat("(") {
            let value = self.any();
            assert!(self.eat(")"));
            return value;
        }
        let _ = self.eat("");
        let end = self.text.iter().position(|c| !c.is_ascii_alphanumeric() && *c != b'_');
        let (name, rest) = self.text.split_at(end.unwrap_or(self.text.len()));
        self.text = rest;
        let place = self.names.iter().position(|other| other.as_bytes() == name).expect("a variable");
        self.row >> place & 1 == 1
    }
}

fn said(text: &str, names: &[String], row: u32) -> bool {
    let mut reader = Reader { text: text.as_bytes(), names, row };
    let value = reader.any();
    assert_eq!(reader.text, b"", "{text}");
    value
}

fn done(expr: &Expr, row: u32) -> bool {
    match expr {
        Expr::Constant(value) => *value,
        Expr::Literal(literal) => (row >> literal.variable & 1 == 1) != literal.negated,
        Expr::And(parts) => !parts.iter().any(|part| !done(part, row)),
        Expr::Or(parts) => parts.iter().any(|part| done(part, row)),
    }
}

/// All values of so many variables are tried at most.
const VARIABLES: usize = 16;

fn names(program: &Program) -> Vec<String> {
    program.variables.iter().map(|variable| variable.name.clone()).collect()
}

/// Returns how many formulas were compared.
#[track_caller]
fn compare(what: &str, plant: &Plant) -> usize {
    let Ok(closed) = supervise(plant, &Limits::default()) else { panic!("{what} has a feedback") };
    let memory = remember(plant, &closed).expect("memory");
    let mut compared = 0;
    for dont_care in [DontCare::None, DontCare::Decodable, DontCare::All] {
        for two_level in [false, true] {
            let options = Options { dont_care, two_level, ..Options::default() };
            let feedback = state_feedback(plant, &closed, &memory, options).expect("formulas");
            let names = names(&feedback.program);
            let kept: usize = plant.signals.len() + memory.iter().map(|it| it.bits as usize).sum::<usize>();
            assert!(kept <= VARIABLES, "{kept} variables");
            for formula in &feedback.formulas {
                let text = formula.text(&feedback.program);
                let rung = feedback.program.rungs.iter().find(|rung| rung.event == Some(formula.event));
                for row in 0..1 << kept {
                    let said = said(&text, &names, row);
                    assert_eq!(done(&formula.factored, row), said, "{what} {options:?} {text} {row:b}");
                    if let Some(rung) = rung {
                        assert_eq!(done(&rung.condition, row), said, "{what} {options:?} {text} {row:b}");
                    }
                }
                compared += 1;
            }
        }
    }
    compared
}

#[test]
fn plants_of_the_corpus() {
    for (name, events) in [("distribution_station", 6), ("tank", 6), ("chute", 4)] {
        let path = format!("{}/plants/{name}.plant", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).expect("the corpus is readable");
        let (plant, _) = read(&text, FileId(0)).expect("a plant");
        assert_eq!(compare(name, &plant), 6 * events, "{name}");
    }
}

/// Ranges that overlap, one that contains another, and an event that never fires.
#[test]
fn ranges_and_constants() {
    let text = "plant Oven {
        output Heat, Vent
        range Warm = Temp in 40..=90
        range Hot = Temp in 70..=200
        range Middle = Temp in 60..=80
        controllable on { set Heat }
        controllable off { reset Heat }
        controllable open { set Vent }
        controllable again { set Vent }
        uncontrollable warms
        uncontrollable heats
        automaton Heater { initial state Off [!Heat] { on -> On } state On [Heat] { off -> Off } }
        automaton Flap { initial state Shut [!Vent] { open -> Open } state Open [Vent] { again -> Open } }
        automaton Air {
            initial state Cold [!Warm && !Hot] { warms -> Fair }
            state Fair [Warm && !Hot] { heats -> Full }
            state Full [Hot && Middle || Hot && !Warm]
        }
        constraint Late: on not when Air.Full
        constraint Stay: off only when Heater.Off
        constraint Draught: open only when Air.Full
    }";
    let (plant, _) = read(text, FileId(0)).expect("a plant");
    assert_eq!(compare("Oven", &plant), 6 * 4);
}
