//! Templates of secondaries: a function block per component that does what the primary commands.
//!
//! A template compiles and runs as it is, but never finishes a command: what the hardware does and says is missing. It
//! knows nothing of the primary but one code and one bit per event, so it lasts as long as those do.

use super::Trigger;
use super::block::Block;
use super::names::{PRIMARY, Scope, SecondaryNames};
use super::owed::OWED;
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
    events: Vec<Watched<'a>>,
    /// Per command the events (indices) that are owed after it.
    answers: Vec<Vec<u32>>,
}

/// An event that the component sends, or one that is owed after its commands and that no secondary sends.
struct Watched<'a> {
    /// In table order.
    index: u32,
    text: &'a str,
    /// The input of the primary; an output here if the component sends it, an input otherwise.
    name: &'a str,
    /// What an event that others send was in the last call, if only its edge counts.
    before: Option<String>,
    is_sent: bool,
    /// Whether the primary waits for it.
    owed: String,
    timer: String,
    stalled: String,
}

/// The names of the secondary's own variables.
struct OwnNames {
    enable: String,
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
        let answers = answers(block.tables, table);
        let events = (0..).zip(block.tables.events.iter().zip(&block.names.events));
        let watched = events.filter_map(|(index, (event, names))| {
            let is_sent = event.event.sender == table.object;
            let is_watched = is_sent || answers.iter().flatten().any(|answer| *answer == index);
            is_watched.then_some((index, event.event.text.as_str(), names.input.as_str(), is_sent))
        });
        // They come first: they are called as the primary's inputs.
        let watched: Vec<_> = watched.inspect(|(_, _, name, _)| drop(scope.claim(name, ""))).collect();
        let mut own = |name| scope.claim(name, "");
        let own = OwnNames {
            enable: own("enable"),
            command: own("command"),
            reset: own("reset"),
            timeout: own("timeout"),
            doing: own("doing"),
            done: own("done"),
        };
        let edges = block.options.trigger == Trigger::Edge;
        let events = watched.into_iter().map(|(index, text, name, is_sent)| Watched {
            index,
            text,
            name,
            before: (edges && !is_sent).then(|| scope.claim(name, "_before")),
            is_sent,
            owed: scope.claim(name, "_owed"),
            timer: scope.claim(name, "_timer"),
            stalled: scope.claim(name, "_stalled"),
        });
        let events = events.collect();
        Secondary { block, table, command, names, own, events, answers }
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
        let events = self.events.iter().map(|event| {
            let word = if event.is_sent { "event" } else { "awaited" };
            format!("{word} {}: {}", event.name, event.text)
        });
        Interface::new(std::iter::once(block).chain(commands).chain(events).collect())
    }

    /// Codes and event texts.
    fn commands(&self) -> impl Iterator<Item = (u32, &str)> {
        (1..).zip(self.table.commands.iter().map(|command| command.text.as_str()))
    }

    /// The events that the component sends.
    fn sent(&self) -> impl Iterator<Item = &Watched<'a>> {
        self.events.iter().filter(|event| event.is_sent)
    }

    /// Those of others that are owed after its commands.
    fn awaited(&self) -> impl Iterator<Item = &Watched<'a>> {
        self.events.iter().filter(|event| !event.is_sent)
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
            "With enable FALSE nothing is done and no event comes, as the primary would not notice; a command is kept.",
        ] {
            out.comment(line);
        }
        out.gap();
    }

    fn declarations(&self) -> Declarations {
        let OwnNames { enable, command, reset, timeout, doing, done } = &self.own;
        let mut declarations = Declarations::default();
        declarations.section("VAR_INPUT", |out| {
            out.comment("as that of the primary");
            out.initialized(enable, "BOOL", "TRUE");
            out.comment("forgets what is being done; as that of the primary");
            out.variable(reset, "BOOL");
            out.comment(&format!("{} of the primary", self.command));
            out.variable(command, "INT");
            if !self.events.is_empty() {
                out.comment("an event that is owed for longer has stalled");
                out.initialized(timeout, "TIME", "T#10s");
            }
            for event in self.awaited() {
                out.comment(&format!("{}, as the primary gets it", event.text));
                out.variable(event.name, "BOOL");
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
                    if event.is_sent {
                        out.variable(event.name, "BOOL");
                    }
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
                if let Some(before) = &event.before {
                    out.variable(before, "BOOL");
                }
            }
        });
        declarations
    }

    fn statements(&self, out: &mut Writer) {
        let OwnNames { enable, command, reset, doing, done, .. } = &self.own;
        for event in self.sent() {
            if !self.answers.iter().flatten().any(|answer| *answer == event.index) {
                out.comment(&format!("to be filled in: whether there is {}", event.text));
            }
            out.code(format_args!("#{} := FALSE;", event.name));
        }
        out.code(format_args!("IF #{done} OR NOT #{enable} THEN"));
        out.indented(|out| {
            out.comment("disabled, or a call between two events, so that the second one rises");
            out.code(format_args!("#{done} := FALSE;"));
        });
        out.code("ELSE");
        out.indented(|out| {
            out.code(format_args!("CASE #{doing} OF"));
            out.indented(|out| {
                for ((code, text), answers) in self.commands().zip(&self.answers) {
                    out.code(format_args!("{code}:"));
                    out.indented(|out| self.branch(out, text, answers));
                }
            });
            out.code("END_CASE;");
        });
        out.code("END_IF;");
        out.when(format_args!("#{done} OR #{reset}"), |out| out.code(format_args!("#{doing} := 0;")));
        out.when(format_args!("#{command} <> 0 AND NOT #{reset}"), |out| {
            out.code(format_args!("#{doing} := #{command};"));
        });
        self.watchdog(out);
    }

    /// A command, and the events that the primary then waits for.
    fn branch(&self, out: &mut Writer, text: &str, answers: &[u32]) {
        let done = &self.own.done;
        let answers = |event: &&Watched<'_>| answers.contains(&event.index);
        out.comment(text);
        for event in self.awaited().filter(answers) {
            out.comment(&format!("the primary then waits for {}", event.text));
        }
        out.comment("to be filled in: drive the hardware; done is what its sensor says");
        out.code(format_args!("#{done} := FALSE;"));
        match self.sent().filter(answers).collect::<Vec<_>>()[..] {
            [] => {}
            [event] => out.code(format_args!("#{} := #{done};", event.name)),
            ref several => {
                out.comment("to be filled in: which of these comes of it");
                for event in several {
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
        out.comment("One that comes may be owed again at once; waiting then starts anew.");
        for Watched { name, before, owed, timer, stalled, .. } in &self.events {
            let mut parts =
                vec![format!("#{timer}(IN :="), format!("#{} AND", self.own.enable), format!("#{owed} AND")];
            match before {
                Some(before) => parts.extend([format!("(#{before} OR"), format!("NOT #{name}),")]),
                None => parts.push(format!("NOT #{name},")),
            }
            parts.push(format!("PT := #{});", self.own.timeout));
            out.code_in_parts(&parts);
            out.code_in_parts(&[format!("#{stalled} :="), format!("#{timer}.Q;")]);
            if let Some(before) = before {
                out.code_in_parts(&[format!("#{before} :="), format!("#{name};")]);
            }
        }
    }

    /// How primary and secondary are wired. Secondaries come first: what they raise then reaches a primary that is
    /// enabled if they are.
    fn wiring(&self, out: &mut Writer) {
        let OwnNames { enable, reset, command, .. } = &self.own;
        let (object, primary) = (&self.names.instance, PRIMARY);
        let frame = self.block.dialect().frame;
        let owed =
            self.events.iter().map(|event| format!("{} := #{primary}.{OWED}[{}]", event.owed, event.index));
        let owed: Vec<String> = owed.collect();
        let mut inputs = vec![
            format!("{enable} := #enable"),
            format!("{reset} := #reset"),
            format!("{command} := #{primary}.{}", self.command),
        ];
        inputs.extend(self.awaited().map(|event| format!("{0} := #{0}", event.name)));
        if self.block.options.owed {
            inputs.extend_from_slice(&owed);
        }
        let mut raised = vec!["enable := #enable".to_owned(), "reset := #reset".to_owned()];
        raised.extend(self.sent().map(|event| format!("{0} := #{object}.{0}", event.name)));
        out.comment(
            "How they are wired in a program with inputs enable and reset: all secondaries first, then the primary, called \
             once a scan, with the events of all templates and its other inputs.",
        );
        out.comment(&format!("  {primary} : {};", frame.block_type(&self.block.names.function_block)));
        out.comment(&format!("  {object} : {};", frame.block_type(&self.names.function_block)));
        out.gap();
        call(out, object, &inputs);
        call(out, primary, &raised);
        if !self.block.options.owed && !owed.is_empty() {
            out.gap();
            out.comment("The watchdog needs a primary exported with --owed, and these inputs as well:");
            owed.iter().for_each(|argument| out.comment_code(&format!("    {argument}")));
        }
    }
}

/// A call of an instance, as comments.
fn call(out: &mut Writer, instance: &str, arguments: &[String]) {
    for (index, argument) in arguments.iter().enumerate() {
        let open = if index == 0 { format!("  #{instance}(") } else { "    ".to_owned() };
        let close = if index + 1 == arguments.len() { ");" } else { "," };
        out.comment_code(&format!("{open}{argument}{close}"));
    }
}
