//! Inputs, outputs, memory bits and ranges; events and their commands.

use std::collections::BTreeMap;

use super::{Meaning, Resolver, same_but_case};
use crate::diagnostic::{Code, Diagnostic};
use crate::plant::ast::{self, Item};
use crate::plant::{Command, Event, EventId, Signal, SignalId, SignalKind};
use crate::syntax::Span;
use crate::syntax::ast::Name;

impl<'a> Resolver<'a> {
    pub(super) fn signals(&mut self, file: &'a ast::File) {
        // Each analogue input, and where a range names it first.
        let mut named: BTreeMap<&str, (u32, Span)> = BTreeMap::new();
        for item in &file.items {
            let Item::Range(ast::Range { analogue, .. }) = item else { continue };
            named.entry(&analogue.text).or_insert_with(|| {
                self.analogues.push(&analogue.text);
                (self.analogues.len() as u32 - 1, analogue.span)
            });
        }
        for item in &file.items {
            match item {
                Item::Signals(signals) => self.declare_signals(signals, &named),
                Item::Range(range) => self.declare_range(range, &named),
                _ => {}
            }
        }
        // An analogue input that is declared by its range alone.
        for (name, (_, span)) in named {
            self.signal_names.entry(name).or_insert((Meaning::Analogue, span));
        }
        let mut names: Vec<(&str, Span)> =
            self.signal_names.iter().map(|(&name, &(_, span))| (name, span)).collect();
        names.sort_by_key(|(_, span)| span.start);
        for [(first, earlier), (name, span)] in same_but_case(names.into_iter()) {
            let message = format!("`{name}` and `{first}` differ by case only");
            let error = Diagnostic::error(Code::CaseOnly, span, message).also(earlier, "the other one");
            self.error(
                error
                    .note("programmable controllers do not tell the two apart")
                    .help("rename one of the two"),
            );
        }
    }

    fn declare_signals(&mut self, signals: &'a ast::Signals, named: &BTreeMap<&str, (u32, Span)>) {
        for (doc, name) in &signals.names {
            let analogue = named.get(name.text.as_str());
            if analogue.is_some() && signals.kind == SignalKind::Input {
                self.declare("input", |this| &mut this.signal_names, name, Meaning::Analogue);
                continue;
            }
            self.declare_signal(name, signals.kind, signals.doc.iter().chain(doc).cloned().collect());
            if let Some((_, range)) = analogue {
                self.no_analogue(name, signals.kind, *range);
            }
        }
    }

    fn declare_range(&mut self, range: &'a ast::Range, named: &BTreeMap<&str, (u32, Span)>) {
        let ast::Range { doc, name, analogue, low, high, span } = range;
        if low > high {
            let message = format!("the range `{low}..={high}` contains no value");
            let error = Diagnostic::error(Code::OutOfRange, *span, message);
            self.error(error.help(format!("write `{high}..={low}`")));
        }
        let kind = SignalKind::Range { analogue: named[analogue.text.as_str()].0, low: *low, high: *high };
        self.declare_signal(name, kind, doc.clone());
        if let Some(&(_, range)) = named.get(name.text.as_str()) {
            self.no_analogue(name, kind, range);
        }
    }

    /// Reports that a range is one of something else than an analogue input.
    fn no_analogue(&mut self, name: &Name, kind: SignalKind, range: Span) {
        let message = format!("`{}` is {}, and a range is of an analogue input", name.text, what(kind));
        let error = Diagnostic::error(Code::NotBoolean, range, message);
        self.error(error.also(name.span, "declared here").help("name an analogue input"));
    }

    fn declare_signal(&mut self, name: &'a Name, kind: SignalKind, doc: Vec<String>) {
        let id = self.signals.len() as SignalId;
        self.signals.push(Signal { name: name.text.clone(), kind, doc, span: name.span });
        self.declare(noun(kind), |this| &mut this.signal_names, name, Meaning::Signal(id));
    }

    /// What a name of a signal means, unless it means nothing.
    pub(super) fn meaning(&mut self, what: &str, name: &'a Name) -> Option<Meaning> {
        if let Some(&(meaning, _)) = self.signal_names.get(name.text.as_str()) {
            return Some(meaning);
        }
        let known: Vec<&str> = self.signal_names.keys().copied().collect();
        let event = self.event_names.contains_key(name.text.as_str());
        let help = event.then(|| format!("write a name of one: `{}` is an event", name.text));
        self.unknown(what, name, help, &known);
        None
    }

    pub(super) fn events(&mut self, file: &'a ast::File) -> Vec<Event> {
        let events: Vec<&ast::Event> = file
            .items
            .iter()
            .filter_map(|item| match item {
                Item::Event(event) => Some(event),
                _ => None,
            })
            .collect();
        for (id, event) in events.iter().enumerate() {
            self.declare("event", |this| &mut this.event_names, &event.name, id as EventId);
        }
        events
            .into_iter()
            .map(|event| Event {
                name: event.name.text.clone(),
                controllable: event.controllable,
                commands: self.commands(event),
                doc: event.doc.clone(),
                span: event.name.span,
            })
            .collect()
    }

    fn commands(&mut self, event: &'a ast::Event) -> Vec<Command> {
        if let Some(first) = event.commands.first().filter(|_| !event.controllable) {
            let message = format!("`{}` is uncontrollable, so nothing is done to cause it", event.name.text);
            let error = Diagnostic::error(Code::CommandedByNobody, first.span, message);
            let error = error.also(event.name.span, "happens by itself");
            self.error(error.help("remove the commands, or write `controllable`"));
        }
        let mut done: BTreeMap<SignalId, &ast::Command> = BTreeMap::new();
        let mut commands = Vec::new();
        for command in &event.commands {
            let Some(signal) = self.writable(&command.signal) else { continue };
            let Some(earlier) = done.insert(signal, command) else {
                commands.push(Command { signal, set: command.set });
                continue;
            };
            let name = &command.signal.text;
            if earlier.set == command.set {
                let verb = if command.set { "set" } else { "reset" };
                let message = format!("`{name}` is {verb} twice by one event");
                let warning = Diagnostic::warning(Code::Unused, command.span, message);
                self.odd.push(warning.also(earlier.span, "the first time").help("remove one of the two"));
            } else {
                let message = format!("`{name}` is set and reset by one event");
                let error = Diagnostic::error(Code::ContradictoryCommands, command.span, message);
                self.error(error.also(earlier.span, "contradicts this").help("remove one of the two"));
            }
        }
        commands
    }

    fn writable(&mut self, name: &'a Name) -> Option<SignalId> {
        let (message, help) = match self.meaning("output or memory bit", name)? {
            Meaning::Analogue => (format!("`{}` is an analogue input", name.text), "an output"),
            Meaning::Signal(signal) => match self.signals[signal as usize].kind {
                SignalKind::Output | SignalKind::Memory => return Some(signal),
                kind => (format!("`{}` is {}", name.text, what(kind)), "an output"),
            },
        };
        let declared = self.signal_names[name.text.as_str()].1;
        let error = Diagnostic::error(
            Code::NotWritable,
            name.span,
            format!("{message}, which nobody can set or reset"),
        )
        .also(declared, "declared here")
        .help(format!("write the name of {help} or of a memory bit"));
        self.error(error);
        None
    }
}

/// `an input`, …
pub(super) fn what(kind: SignalKind) -> &'static str {
    match kind {
        SignalKind::Input => "an input",
        SignalKind::Output => "an output",
        SignalKind::Memory => "a memory bit",
        SignalKind::Range { .. } => "a range",
    }
}

/// `input`, …
pub(super) fn noun(kind: SignalKind) -> &'static str {
    match kind {
        SignalKind::Input => "input",
        SignalKind::Output => "output",
        SignalKind::Memory => "memory bit",
        SignalKind::Range { .. } => "range",
    }
}
