//! The canonical text of a plant's tree: it reads as the same tree, places apart.

use super::ast::{Automaton, Constraint, Event, File, Item, Range, Rule, Signals, State};
use super::{Condition, SignalKind};
use crate::syntax::ast::Path;

/// The canonical text of `file`, four spaces to a level, ending in a newline.
#[must_use]
pub fn print(file: &File) -> String {
    let mut out = Printer::default();
    out.doc(&file.doc);
    out.open(&format!("plant {} {{", file.name.text));
    for item in &file.items {
        match item {
            Item::Signals(signals) => out.signals(signals),
            Item::Range(range) => out.range(range),
            Item::Event(event) => out.event(event),
            Item::Component(automaton) => out.automaton("automaton", automaton),
            Item::ConstraintAutomaton(automaton) => out.automaton("constraint automaton", automaton),
            Item::Constraint(constraint) => out.constraint(constraint),
        }
    }
    out.close();
    out.text
}

#[derive(Default)]
struct Printer {
    text: String,
    level: usize,
}

impl Printer {
    fn line(&mut self, text: &str) {
        for _ in 0..self.level {
            self.text.push_str("    ");
        }
        self.text.push_str(text);
        self.text.push('\n');
    }

    fn doc(&mut self, lines: &[String]) {
        for line in lines {
            self.line(format!("/// {line}").trim_end());
        }
    }

    fn open(&mut self, text: &str) {
        self.line(text);
        self.level += 1;
    }

    fn close(&mut self) {
        self.level -= 1;
        self.line("}");
    }

    fn signals(&mut self, signals: &Signals) {
        self.doc(&signals.doc);
        let word = match signals.kind {
            SignalKind::Output => "output",
            SignalKind::Memory => "memory",
            SignalKind::Input | SignalKind::Range { .. } => "input",
        };
        if signals.names.iter().all(|(doc, _)| doc.is_empty()) {
            let names: Vec<&str> = signals.names.iter().map(|(_, name)| name.text.as_str()).collect();
            return self.line(&format!("{word} {}", names.join(", ")));
        }
        self.open(word);
        for (index, (doc, name)) in signals.names.iter().enumerate() {
            self.doc(doc);
            let separator = if index + 1 < signals.names.len() { "," } else { "" };
            self.line(&format!("{}{separator}", name.text));
        }
        self.level -= 1;
    }

    fn range(&mut self, range: &Range) {
        let Range { doc, name, analogue, low, high, .. } = range;
        self.doc(doc);
        self.line(&format!("range {} = {} in {low}..={high}", name.text, analogue.text));
    }

    fn event(&mut self, event: &Event) {
        self.doc(&event.doc);
        let word = if event.controllable { "controllable" } else { "uncontrollable" };
        let verb = |set| if set { "set" } else { "reset" };
        let commands =
            event.commands.iter().map(|command| format!(" {} {}", verb(command.set), command.signal.text));
        let commands: String = commands.collect();
        let block = if commands.is_empty() { String::new() } else { format!(" {{{commands} }}") };
        self.line(&format!("{word} {}{block}", event.name.text));
    }

    fn automaton(&mut self, word: &str, automaton: &Automaton) {
        self.doc(&automaton.doc);
        self.open(&format!("{word} {} {{", automaton.name.text));
        for state in &automaton.states {
            self.state(state);
        }
        self.close();
    }

    fn state(&mut self, state: &State) {
        self.doc(&state.doc);
        let mut line = String::new();
        if state.initial.is_some() {
            line.push_str("initial ");
        }
        if state.marked {
            line.push_str("marked ");
        }
        line.push_str(&format!("state {}", state.name.text));
        if let Some(formula) = &state.formula {
            line.push_str(&format!(" [{}]", condition(formula)));
        }
        if !state.edges.is_empty() {
            line.push_str(" {");
            for edge in &state.edges {
                line.push_str(&format!(" {} -> {}", edge.event.text, edge.target.text));
            }
            line.push_str(" }");
        }
        self.line(&line);
    }

    fn constraint(&mut self, constraint: &Constraint) {
        self.doc(&constraint.doc);
        let rule = match &constraint.rule {
            Rule::Only(event, when) => format!("{} only when {}", event.text, condition(when)),
            Rule::Not(event, when) => format!("{} not when {}", event.text, condition(when)),
            Rule::Never(never) => format!("never {}", condition(never)),
        };
        self.line(&format!("constraint {}: {rule}", constraint.name.text));
    }
}

fn condition(condition: &Condition<Path>) -> String {
    condition.text(&|path| path.names.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join("."))
}
