//! Templates of secondaries: a function block per component that does what the primary commands.
//!
//! A template compiles and runs as it is, but never finishes a command: what the hardware does and says is missing. It
//! knows nothing of the primary but one code and one bit per event, so it lasts as long as those do.

use super::block::Block;
use super::names::{Scope, SecondaryNames};
use super::unit::{Declarations, Kind, Type, Unit};
use super::writer::Writer;
use crate::controller::tables::ComponentTable;
use crate::emit::template::{Interface, Template, answers};

/// A secondary when it is written.
struct Secondary<'a> {
    block: &'a Block<'a>,
    /// Its component.
    table: &'a ComponentTable,
    /// The output of the primary that commands it.
    command: &'a str,
    names: &'a SecondaryNames,
    own: OwnNames,
    events: Vec<Sent<'a>>,
}

/// An event that the component sends.
struct Sent<'a> {
    /// In table order.
    index: u32,
    text: &'a str,
    /// The input of the primary, and the output here.
    name: &'a str,
    /// Whether the primary waits for it.
    owed: String,
    timer: String,
    stalled: String,
}

/// The names of the secondary's own variables.
struct OwnNames {
    command: String,
    reset: String,
    timeout: String,
    doing: String,
    done: String,
}

/// A template for every component.
pub(super) fn templates(block: &Block<'_>) -> Vec<Template> {
    let components = block.tables.components.iter().zip(&block.names.components);
    components
        .zip(&block.names.secondaries)
        .map(|((table, component), names)| Secondary::new(block, table, &component.output, names).template())
        .collect()
}

impl<'a> Secondary<'a> {
    fn new(
        block: &'a Block<'a>,
        table: &'a ComponentTable,
        command: &'a str,
        names: &'a SecondaryNames,
    ) -> Secondary<'a> {
        let mut scope = Scope::new(block.dialect().words, &[&names.function_block]);
        let events = (0..).zip(block.tables.events.iter().zip(&block.names.events));
        let sent = events.filter(|(_, (event, _))| event.event.sender == table.object);
        // The outputs come first: they are called as the primary's inputs.
        let outputs: Vec<_> = sent
            .map(|(index, (event, names))| {
                scope.claim(&names.input, "");
                (index, event.event.text.as_str(), names.input.as_str())
            })
            .collect();
        let mut own = |name| scope.claim(name, "");
        let own = OwnNames {
            command: own("command"),
            reset: own("reset"),
            timeout: own("timeout"),
            doing: own("doing"),
            done: own("done"),
        };
        let events = outputs.into_iter().map(|(index, text, name)| Sent {
            index,
            text,
            name,
            owed: scope.claim(name, "_owed"),
            timer: scope.claim(name, "_timer"),
            stalled: scope.claim(name, "_stalled"),
        });
        let events = events.collect();
        Secondary { block, table, command, names, own, events }
    }

    fn template(&self) -> Template {
        let frame = self.block.dialect().frame;
        let interface = self.interface();
        let mut out = Writer::new(frame);
        self.head(&mut out, &interface);
        let unit = Unit {
            comment: None,
            kind: Kind::FunctionBlock,
            name: &self.names.function_block,
            declarations: self.declarations(),
            body: Box::new(|out| self.statements(out)),
        };
        frame.unit(&mut out, &unit);
        self.wiring(&mut out);
        let (object, file) = (self.table.object.clone(), self.names.file.clone());
        Template { object, file, text: out.finish(), interface }
    }

    fn interface(&self) -> Interface {
        let block = format!("function block {}", self.names.function_block);
        let commands = self.commands().map(|(code, text)| format!("command {code}: {text}"));
        let events = self.events.iter().map(|event| format!("event {}: {}", event.name, event.text));
        Interface::new(std::iter::once(block).chain(commands).chain(events).collect())
    }

    /// Codes and event texts.
    fn commands(&self) -> impl Iterator<Item = (u32, &str)> {
        (1..).zip(self.table.commands.iter().map(|command| command.text.as_str()))
    }

    fn head(&self, out: &mut Writer, interface: &Interface) {
        let (object, target) = (&self.table.object, self.block.options.target.name());
        let version = env!("CARGO_PKG_VERSION");
        out.comment(&format!(
            "Secondary of {object}, to be filled in: how it does what the primary commands."
        ));
        out.comment(&format!(
            "Written once by sml {version} for {target} from {}; never overwritten.",
            self.block.tables.provenance.file
        ));
        out.gap();
        interface.lines().for_each(|line| out.comment(&line));
        out.gap();
        for line in [
            "A command comes for one call; it is remembered until its branch says that it is done. A command that comes \
             earlier takes its place.",
            "An event is TRUE for one call, and FALSE in the next: the primary notices when it rises.",
        ] {
            out.comment(line);
        }
        out.gap();
    }

    fn declarations(&self) -> Declarations {
        let OwnNames { command, reset, timeout, doing, done } = &self.own;
        let mut declarations = Declarations::default();
        declarations.section("VAR_INPUT", |out| {
            out.comment(&format!("{} of the primary", self.command));
            out.variable(command, "INT");
            out.comment("forgets what is being done");
            out.variable(reset, "BOOL");
            if !self.events.is_empty() {
                out.comment("an event that is owed for longer has stalled");
                out.initialized(timeout, "TIME", "T#10s");
            }
            for event in &self.events {
                out.comment(&format!("whether the primary waits for {}", event.text));
                out.variable(&event.owed, "BOOL");
            }
            out.comment("to be filled in: sensors");
        });
        if !self.events.is_empty() {
            declarations.section("VAR_OUTPUT", |out| {
                for event in &self.events {
                    out.comment(event.text);
                    out.variable(event.name, "BOOL");
                    out.variable(&event.stalled, "BOOL");
                }
                out.comment("to be filled in: actuators");
            });
        }
        declarations.section("VAR", |out| {
            out.comment("the command that is being done; 0 is none");
            out.variable(doing, "INT");
            out.variable(done, "BOOL");
            let timer = self.block.dialect().frame.timer();
            for event in &self.events {
                out.variable(&event.timer, Type::Derived(timer.to_owned()));
            }
        });
        declarations
    }

    fn statements(&self, out: &mut Writer) {
        let OwnNames { command, reset, doing, done, .. } = &self.own;
        let answers = answers(self.block.tables, self.table);
        for event in &self.events {
            if !answers.iter().flatten().any(|answer| *answer == event.index) {
                out.comment(&format!("to be filled in: whether there is {}", event.text));
            }
            out.code(format_args!("#{} := FALSE;", event.name));
        }
        out.code(format_args!("IF #{done} THEN"));
        out.indented(|out| {
            out.comment("a call between two events, so that the second one rises");
            out.code(format_args!("#{done} := FALSE;"));
        });
        out.code("ELSE");
        out.indented(|out| {
            out.code(format_args!("CASE #{doing} OF"));
            out.indented(|out| {
                for (code, text) in self.commands() {
                    out.code(format_args!("{code}:"));
                    out.indented(|out| self.branch(out, text, &answers[code as usize - 1]));
                }
            });
            out.code("END_CASE;");
        });
        out.code("END_IF;");
        out.code(format_args!("IF #{done} OR #{reset} THEN"));
        out.indented(|out| out.code(format_args!("#{doing} := 0;")));
        out.code("END_IF;");
        out.code(format_args!("IF #{command} <> 0 AND NOT #{reset} THEN"));
        out.indented(|out| out.code(format_args!("#{doing} := #{command};")));
        out.code("END_IF;");
        self.watchdog(out);
    }

    /// A command, and the events that the primary then waits for.
    fn branch(&self, out: &mut Writer, text: &str, answers: &[u32]) {
        let done = &self.own.done;
        out.comment(text);
        out.comment("to be filled in: drive the hardware; done is what its sensor says");
        out.code(format_args!("#{done} := FALSE;"));
        let answers: Vec<&Sent<'_>> =
            self.events.iter().filter(|event| answers.contains(&event.index)).collect();
        match answers[..] {
            [] => {}
            [event] => out.code(format_args!("#{} := #{done};", event.name)),
            _ => {
                out.comment("to be filled in: which of these comes of it");
                for event in answers {
                    out.code(format_args!("#{} := FALSE;", event.name));
                }
            }
        }
    }

    fn watchdog(&self, out: &mut Writer) {
        if self.events.is_empty() {
            return;
        }
        out.gap();
        out.comment(
            "Watchdog: which event does not come. It is no safety function: it knows the model, not the plant.",
        );
        for event in &self.events {
            let Sent { owed, timer, stalled, .. } = event;
            out.code_in_parts(&[
                format!("#{timer}(IN :="),
                format!("#{owed},"),
                format!("PT := #{});", self.own.timeout),
            ]);
            out.code_in_parts(&[format!("#{stalled} :="), format!("#{timer}.Q;")]);
        }
    }

    fn wiring(&self, out: &mut Writer) {
        let (object, primary) = (&self.names.instance, &self.block.names.function_block);
        let raised: Vec<String> =
            self.events.iter().map(|event| format!("{0} := {object}.{0}", event.name)).collect();
        let mut inputs = vec![format!("{} := primary.{}", self.own.command, self.command)];
        inputs.extend(
            self.events.iter().map(|event| format!("{} := primary.owed[{}]", event.owed, event.index)),
        );
        out.comment(
            "How they are wired in a program with these variables (the primary has owed with --owed):",
        );
        out.comment(&format!("  primary : {primary};"));
        out.comment(&format!("  {object} : {};", self.names.function_block));
        out.gap();
        for (name, arguments) in [("primary", raised), (object.as_str(), inputs)] {
            for (index, argument) in arguments.iter().enumerate() {
                let open = if index == 0 { format!("  {name}(") } else { "    ".to_owned() };
                let close = if index + 1 == arguments.len() { ");" } else { "," };
                out.comment(&format!("{open}{argument}{close}"));
            }
        }
    }
}
