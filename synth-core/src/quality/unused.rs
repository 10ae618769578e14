//! Declarations without which the specification would mean the same.

use super::mentions::Mentions;
use super::reads::{Place, attributes, expressions, has_effect, patterns, players};
use crate::diagnostic::{Code, Diagnostic};
use crate::model::{Argument, ClassId, EventRef, Expr, ObjectId, OperationId, Role, Scenario, Spec, Type};
use crate::syntax::ast::{self, DomainItem, FragmentKind, Name, Section};
use crate::syntax::{Loaded, Span};
use std::collections::BTreeSet;

/// The unused declarations of the main file. Imported files may be there for other specifications, too.
pub(super) fn declarations(files: &[ast::File], spec: &Spec) -> Vec<Diagnostic> {
    let mentions = Mentions::of_files(files);
    let mut finder = Finder { spec, mentions, uses: Uses::of(spec), named: Vec::new(), warnings: Vec::new() };
    let sections: Vec<&Section> = files.iter().flat_map(|file| &file.sections).collect();
    finder.effects(&sections);
    finder.events(&sections);
    finder.collaborations(&sections);
    for section in sections {
        match section {
            Section::Domain(items) => items.iter().for_each(|item| finder.item(item)),
            Section::Object(object) => finder.object(object),
            _ => {}
        }
    }
    finder.warnings.retain(|warning| warning.span.file == Loaded::MAIN);
    finder.warnings
}

/// What the specification uses, by what names mean.
struct Uses {
    /// Class of the owner and position of every attribute that is read.
    attributes: BTreeSet<(ClassId, usize)>,
    /// Operations that some scenario mentions.
    operations: BTreeSet<OperationId>,
}

impl Uses {
    fn of(spec: &Spec) -> Self {
        let mut read = BTreeSet::new();
        let mut visit = |class, attribute| {
            read.insert((class, attribute));
        };
        for scenario in &spec.scenarios {
            let place = Place::Scenario(scenario);
            expressions(scenario, &mut |expr| attributes(spec, place, expr, &mut visit));
        }
        for effect in &spec.effects {
            for assignment in &effect.assignments {
                for expr in [&assignment.owner, &assignment.value] {
                    attributes(spec, Place::Effect(effect), expr, &mut visit);
                }
            }
        }
        read.extend(spec.channels.iter().map(|channel| (channel.class, channel.reference)));
        let operations = spec.scenarios.iter().flat_map(patterns).map(|message| message.operation).collect();
        Uses { attributes: read, operations }
    }
}

struct Finder<'a> {
    spec: &'a Spec,
    mentions: Mentions<'a>,
    uses: Uses,
    /// Where effects and entries about events name an operation that no scenario mentions.
    named: Vec<(OperationId, Span)>,
    warnings: Vec<Diagnostic>,
}

impl Finder<'_> {
    fn warn(&mut self, span: Span, message: String, help: &str) {
        self.warnings.push(Diagnostic::warning(Code::Unused, span, message).help(help));
    }

    fn item(&mut self, item: &DomainItem) {
        match item {
            DomainItem::Enum(declared) if !self.mentions.contains(&declared.name.text) => {
                let message = format!("enum `{}` is never used", declared.name.text);
                self.warn(declared.name.span, message, "remove it");
            }
            DomainItem::Enum(_) => {}
            DomainItem::Class(class) if !self.mentions.contains(&class.name.text) => {
                let message = format!("class `{}` is never used", class.name.text);
                self.warn(class.name.span, message, "remove it, or declare an object of it");
            }
            DomainItem::Class(class) => {
                let Some(id) = self.spec.domain.classes.iter().position(|c| c.name == class.name.text) else {
                    return;
                };
                class.attributes.iter().for_each(|attribute| self.attribute(id, &attribute.name));
                class.operations.iter().for_each(|operation| self.operation(id, &operation.name));
            }
        }
    }

    fn attribute(&mut self, class: ClassId, name: &Name) {
        let domain = &self.spec.domain;
        let Some(position) = domain.classes[class].attributes.iter().position(|a| a.name == name.text) else {
            return;
        };
        let mut setters = domain.classes[class].operations.iter();
        let is_set = setters
            .any(|&op| domain.operations[op].sets == Some(position) && self.uses.operations.contains(&op));
        let mut read = self.uses.attributes.iter();
        if is_set || read.any(|&(reader, at)| at == position && domain.is_a(reader, class)) {
            return;
        }
        let related = |other: ClassId| domain.is_a(other, class) || domain.is_a(class, other);
        let mut assignments = self.spec.effects.iter().flat_map(|effect| &effect.assignments);
        let written = assignments.find(|a| a.attribute == position && related(a.owner_class));
        let message = format!("attribute `{}` is never read", name.text);
        let mut warning = Diagnostic::warning(Code::Unused, name.span, message);
        if let Some(assignment) = written {
            warning = warning.also(assignment.span, "it is only written");
        }
        self.warnings.push(warning.help("remove it"));
    }

    fn operation(&mut self, class: ClassId, name: &Name) {
        let domain = &self.spec.domain;
        let mut operations = domain.classes[class].operations.iter();
        let Some(&operation) = operations.find(|&&op| domain.operations[op].name == name.text) else {
            return;
        };
        if self.uses.operations.contains(&operation) {
            return;
        }
        let message = format!("no scenario mentions operation `{}`", name.text);
        let mut warning = Diagnostic::warning(Code::Unused, name.span, message);
        for &(_, span) in self.named.iter().filter(|(named, _)| *named == operation) {
            warning = warning.also(span, "this concerns nothing, then");
        }
        self.warnings.push(warning.help("remove it, or write the scenario in which it happens"));
    }

    fn object(&mut self, object: &ast::Object) {
        let Some(id) = self.spec.domain.objects.iter().position(|o| o.name == object.name.text) else {
            return;
        };
        if !self.mentions.contains(&object.name.text) && !self.can_be_bound(id) {
            let message = format!("object `{}` is never used", object.name.text);
            self.warn(object.name.span, message, "remove it");
        }
    }

    /// Whether a role or an argument can stand for the object without naming it.
    fn can_be_bound(&self, object: ObjectId) -> bool {
        let domain = &self.spec.domain;
        let is_a = |class| domain.is_a(domain.objects[object].class, class);
        let mut roles = self.spec.scenarios.iter().flat_map(|scenario| &scenario.roles);
        let mut parameters = self.uses.operations.iter().flat_map(|&op| &domain.operations[op].parameters);
        roles.any(|role: &Role| is_a(role.class))
            || parameters.any(|(_, ty)| matches!(*ty, Type::Class(class) if is_a(class)))
    }

    /// Effects of events that do not occur.
    fn effects(&mut self, sections: &[&Section]) {
        let written = sections.iter().flat_map(|section| match section {
            Section::Effects(effects) => effects.as_slice(),
            _ => &[],
        });
        // Every effect was resolved, in this order.
        for (written, effect) in written.zip(&self.spec.effects) {
            if !self.uses.operations.contains(&effect.operation) {
                self.named.push((effect.operation, written.operation.span));
                continue;
            }
            let applies = self.spec.scenarios.iter().any(|scenario| {
                patterns(scenario).any(|message| has_effect(self.spec, scenario, message, effect))
            });
            if !applies {
                let ends = format!("{} -> {}", written.sender.text, written.receiver.text);
                let message =
                    format!("no scenario has a message `{ends}.{}` with this effect", written.operation.text);
                let span = written.sender.span.to(written.operation.span);
                self.warn(span, message, "remove it, or correct its sender or receiver");
            }
        }
    }

    /// Entries about events that do not occur.
    fn events(&mut self, sections: &[&Section]) {
        for written in sections.iter().flat_map(|section| entries(section)) {
            let Some(event) = self.resolve(written) else { continue };
            if !self.uses.operations.contains(&event.operation) {
                self.named.push((event.operation, written.operation.span));
                continue;
            }
            let occurs = self.spec.scenarios.iter().any(|scenario| {
                patterns(scenario).any(|message| {
                    players(self.spec, scenario, message.receiver)
                        .any(|receiver| self.spec.refers(event, receiver, message.operation))
                })
            });
            if !occurs {
                let message =
                    format!("no scenario mentions `{}.{}`", written.class.text, written.operation.text);
                self.warn(
                    written.class.span.to(written.operation.span),
                    message,
                    "remove it, or correct its class",
                );
            }
        }
    }

    fn resolve(&self, written: &ast::EventRef) -> Option<EventRef> {
        let domain = &self.spec.domain;
        let class = domain.classes.iter().position(|class| class.name == written.class.text)?;
        let mut operations = domain.classes[class].operations.iter().copied();
        let operation = operations.find(|&op| domain.operations[op].name == written.operation.text)?;
        Some(EventRef { class, operation })
    }

    fn collaborations(&mut self, sections: &[&Section]) {
        // Every scenario was resolved, in this order.
        let mut scenarios = self.spec.scenarios.iter();
        for section in sections {
            let Section::Collaboration(collaboration) = section else { continue };
            let mentions = Mentions::of_scenarios(collaboration);
            for role in collaboration.roles.iter().filter(|role| !mentions.contains(&role.name.text)) {
                // An object that nothing uses is reported itself.
                if role.dynamic || self.mentions.contains(&role.name.text) {
                    let message =
                        format!("no scenario of the collaboration mentions role `{}`", role.name.text);
                    self.warn(role.name.span, message, "remove it");
                }
            }
            for (written, scenario) in collaboration.scenarios.iter().zip(scenarios.by_ref()) {
                self.variables(written, scenario);
            }
        }
    }

    fn variables(&mut self, written: &ast::Scenario, scenario: &Scenario) {
        let mut names = Vec::new();
        variables_of(&written.body, &mut names);
        let mut read = BTreeSet::new();
        expressions(scenario, &mut |expr| {
            expr.walk(&mut |part| {
                if let Expr::Variable(variable) = part {
                    read.insert(*variable);
                }
            });
        });
        // Variables are numbered in textual order.
        for (variable, name) in names.into_iter().enumerate().filter(|(variable, _)| !read.contains(variable))
        {
            match binding(self.spec, scenario, variable) {
                Binding::Selects => {}
                Binding::Binds => {
                    let message = format!("variable `{}` is bound, but never read", name.text);
                    let help = format!("write `*` in place of `bind {}`", name.text);
                    self.warn(name.span, message, &help);
                }
                Binding::None => {
                    self.warn(name.span, format!("variable `{}` is never read", name.text), "remove it");
                }
            }
        }
    }
}

/// What `bind` does with a variable.
enum Binding {
    None,
    /// It takes every value.
    Binds,
    /// It takes objects of a narrower class only: that is a use.
    Selects,
}

fn binding(spec: &Spec, scenario: &Scenario, variable: usize) -> Binding {
    let mut binding = Binding::None;
    for message in patterns(scenario) {
        let parameters = &spec.domain.operations[message.operation].parameters;
        for (argument, (_, parameter)) in message.arguments.iter().zip(parameters) {
            if !matches!(argument, Argument::Bind(bound) if *bound == variable) {
                continue;
            }
            binding = match (scenario.variables[variable].ty, *parameter) {
                (Type::Class(held), Type::Class(given)) if !spec.domain.is_a(given, held) => {
                    return Binding::Selects;
                }
                _ => Binding::Binds,
            };
        }
    }
    binding
}

/// The names of the variables that a body declares, in textual order.
fn variables_of<'a>(body: &'a ast::Body, names: &mut Vec<&'a Name>) {
    for fragment in &body.fragments {
        match &fragment.kind {
            FragmentKind::Variable(_, name, _) => names.push(name),
            FragmentKind::Body(body) | FragmentKind::While(_, body) => variables_of(body, names),
            FragmentKind::Alternative(cases) => cases.iter().for_each(|case| variables_of(&case.body, names)),
            FragmentKind::Parallel(branches) => {
                branches.iter().for_each(|branch| variables_of(branch, names));
            }
            FragmentKind::Message(..)
            | FragmentKind::Wait { .. }
            | FragmentKind::Interrupt(_)
            | FragmentKind::Violation(_)
            | FragmentKind::Assignment(..) => {}
        }
    }
}

/// The entries of a section about events.
fn entries(section: &Section) -> Vec<&ast::EventRef> {
    match section {
        Section::NonSpontaneous(events) => events.iter().collect(),
        Section::ParameterRanges(ranges) => ranges.iter().map(|range| &range.event).collect(),
        Section::Channels(channels) => channels.iter().map(|channel| &channel.event).collect(),
        _ => Vec::new(),
    }
}
