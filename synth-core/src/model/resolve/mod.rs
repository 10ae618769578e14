//! From syntax trees to the resolved [`Spec`]: names, types, and everything that can be refused before play-out.
//!
//! One pass per kind of declaration, in the order in which they need each other. A pass that finds a mistake
//! records it and goes on with what it has, so that one run shows as many mistakes as possible.

mod domain;
mod expr;
mod flow;
mod scenario;
mod sections;

use super::{ClassId, Domain, EventRef, ObjectId, OperationId, Spec, Type};
use crate::diagnostic::{Code, Diagnostic};
use crate::suggest::nearest;
use crate::syntax::Span;
use crate::syntax::ast;
use std::collections::{BTreeMap, BTreeSet};

/// Resolves a specification: the files in order of import, the one that was asked for last.
///
/// The specification is present only if there is no error.
#[must_use]
pub fn resolve(files: &[ast::File]) -> (Option<Spec>, Vec<Diagnostic>) {
    let Some(main) = files.last() else { return (None, Vec::new()) };
    let sections: Vec<&ast::Section> = files.iter().flat_map(|file| &file.sections).collect();
    let mut resolver = Resolver::default();
    resolver.declare(&sections);
    let effects = resolver.effects(&sections);
    let controllable = resolver.controllable(&sections, main.name.span);
    let non_spontaneous = resolver.non_spontaneous(&sections);
    let ranges = resolver.ranges(&sections);
    let channels = resolver.channels(&sections);
    let scenarios = resolver.collaborations(&sections, &controllable);
    let Resolver { mut domain, diagnostics, .. } = resolver;
    if !diagnostics.is_empty() {
        return (None, diagnostics);
    }
    mark_mutable(&mut domain, &effects);
    let name = main.name.text.clone();
    (
        Some(Spec { name, domain, effects, controllable, non_spontaneous, ranges, channels, scenarios }),
        diagnostics,
    )
}

/// So many other places of one mistake are shown.
const MOST_LABELS: usize = 3;

/// What a top-level name stands for. Classes, enums and objects share one name space.
#[derive(Clone, Copy, Debug)]
enum Meaning {
    Enum(usize),
    Class(ClassId),
    Object(ObjectId),
}

/// The state of the passes.
#[derive(Default)]
struct Resolver {
    domain: Domain,
    names: BTreeMap<String, (Meaning, Span)>,
    /// Names of declarations that were wrong: that they are unknown follows from a mistake reported already.
    lost: BTreeSet<String>,
    /// The error about each unknown name, apart for members of classes.
    unknown: BTreeMap<(bool, String), usize>,
    /// Classes whose base is unknown, and so what they inherit.
    orphans: BTreeSet<ClassId>,
    diagnostics: Vec<Diagnostic>,
    /// What was read in the scenario at hand before it was bound.
    unbound: BTreeSet<String>,
    /// Mistakes that follow from others and are not reported.
    silenced: usize,
}

impl Resolver {
    /// Grows with every mistake, reported or not.
    fn mistakes(&self) -> usize {
        self.diagnostics.len() + self.silenced
    }

    /// Whether nobody knows all that the class inherits; then what seems wrong with it is no mistake of its own.
    fn is_orphan(&self, class: ClassId) -> bool {
        std::iter::successors(Some(class), |&c| self.domain.classes[c].base)
            .any(|c| self.orphans.contains(&c))
    }

    fn error(&mut self, code: Code, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        self.diagnostics.push(Diagnostic::error(code, span, message));
        let last = self.diagnostics.len() - 1;
        &mut self.diagnostics[last]
    }

    fn duplicate(&mut self, what: &str, name: &ast::Name, first: Span) {
        let diagnostic = Diagnostic::error(
            Code::DuplicateName,
            name.span,
            format!("{what} `{}` is declared a second time", name.text),
        );
        self.diagnostics.push(diagnostic.also(first, "first declared here").help("rename one of the two"));
    }

    /// Reports a name that means nothing, with the nearest of `candidates` if one is near, unless its declaration was
    /// reported. A name that was unknown before becomes a label of the error about the first one.
    fn unknown<'a>(&mut self, what: &str, name: &ast::Name, candidates: impl Iterator<Item = &'a str>) {
        if self.lost.contains(&name.text) {
            self.silenced += 1;
            return;
        }
        let is_member = what.contains(" of ");
        let key = (is_member, if is_member { attribute_name(&name.text) } else { name.text.clone() });
        if let Some(&first) = self.unknown.get(&key) {
            self.silenced += 1;
            let labels = &mut self.diagnostics[first].labels;
            if labels.len() < MOST_LABELS {
                labels.push((name.span, "and here".to_owned()));
            }
            return;
        }
        self.unknown.insert(key, self.diagnostics.len());
        let help = match foreign(&name.text, what).or_else(|| {
            nearest(&name.text, candidates).map(|near| format!("write `{near}`, which is declared"))
        }) {
            Some(help) => help,
            None => format!("declare `{}`, or write a name that is declared", name.text),
        };
        let diagnostic = self.error(Code::UnknownName, name.span, format!("unknown {what} `{}`", name.text));
        diagnostic.help = Some(help);
    }

    fn class(&mut self, name: &ast::Name) -> Option<ClassId> {
        if let Some((Meaning::Class(class), _)) = self.names.get(&name.text) {
            return Some(*class);
        }
        let classes: Vec<String> = self.domain.classes.iter().map(|class| class.name.clone()).collect();
        self.unknown("class", name, classes.iter().map(String::as_str));
        None
    }

    fn ty(&mut self, ty: &ast::Type) -> Option<Type> {
        match &ty.kind {
            ast::TypeKind::Bool => Some(Type::Bool),
            ast::TypeKind::Int(low, high) if low > high => {
                let message = format!("the range `{low}..={high}` contains no value");
                self.error(Code::OutOfRange, ty.span, message).help = Some(format!("write `{high}..={low}`"));
                None
            }
            ast::TypeKind::Int(low, high) if *low == i64::MIN || high.abs_diff(*low) >= 1 << 32 => {
                let message = format!("the range `{low}..={high}` has more than 2^32 values");
                self.error(Code::OutOfRange, ty.span, message).help = Some("narrow the range".to_owned());
                None
            }
            ast::TypeKind::Int(low, high) => Some(Type::Int(*low, *high)),
            ast::TypeKind::Named(name) => match self.names.get(name) {
                Some((Meaning::Enum(e), _)) => Some(Type::Enum(*e)),
                Some((Meaning::Class(class), _)) => Some(Type::Class(*class)),
                _ => {
                    let name = ast::Name { text: name.clone(), span: ty.span };
                    let types: Vec<String> = self
                        .domain
                        .classes
                        .iter()
                        .map(|class| class.name.clone())
                        .chain(self.domain.enums.iter().map(|e| e.name.clone()))
                        .chain(["bool".to_owned()])
                        .collect();
                    self.unknown("type", &name, types.iter().map(String::as_str));
                    None
                }
            },
        }
    }

    /// The operation of that name that objects of `class` understand.
    fn operation(&mut self, class: ClassId, name: &ast::Name) -> Option<OperationId> {
        let domain = &self.domain;
        let operations = domain.classes[class].operations.iter();
        if let Some(&found) = operations.clone().find(|&&op| domain.operations[op].name == name.text) {
            return Some(found);
        }
        let known: Vec<String> = operations.map(|&op| domain.operations[op].name.clone()).collect();
        if self.is_orphan(class) {
            self.silenced += 1;
            return None;
        }
        let what = format!("operation of class `{}`:", domain.classes[class].name);
        self.unknown(&what, name, known.iter().map(String::as_str));
        None
    }

    fn event_ref(&mut self, event: &ast::EventRef) -> Option<EventRef> {
        let class = self.class(&event.class)?;
        let operation = self.operation(class, &event.operation)?;
        Some(EventRef { class, operation })
    }
}

/// `location` for `setLocation`; other names as they are.
fn attribute_name(operation: &str) -> String {
    match operation.strip_prefix("set").and_then(|rest| rest.split_at_checked(1)) {
        Some((first, rest)) => format!("{}{rest}", first.to_ascii_lowercase()),
        None => operation.to_owned(),
    }
}

/// Help for types and values that other languages have.
fn foreign(name: &str, what: &str) -> Option<String> {
    const INTEGERS: [&str; 9] = ["int", "Int", "integer", "Integer", "i32", "u32", "u8", "long", "short"];
    const TEXTS: [&str; 4] = ["String", "string", "str", "char"];
    let help = match (what, name) {
        ("type", "boolean" | "Boolean" | "Bool" | "BOOL") => "write `bool`".to_owned(),
        ("type", _) if INTEGERS.contains(&name) => "write a range of integers such as `0..=9`".to_owned(),
        ("type", _) if TEXTS.contains(&name) => "declare an `enum` with the texts that can occur".to_owned(),
        ("name", "True" | "TRUE" | "yes") => "write `true`".to_owned(),
        ("name", "False" | "FALSE" | "no") => "write `false`".to_owned(),
        ("name", "None" | "nil" | "NULL" | "Null" | "nullptr") => "write `null`".to_owned(),
        ("name", "self" | "this") => "write the name of the object".to_owned(),
        _ => return None,
    };
    Some(help)
}

/// Finds out which attributes can change at all: those at a position that an effect assigns in a related class, and
/// those with a `setX` that some scenario names. All others are constants, and what depends only on them can be
/// computed once for all states.
fn mark_mutable(domain: &mut Domain, effects: &[super::Effect]) {
    let mut assigned: Vec<(ClassId, usize)> = Vec::new();
    for assignment in effects.iter().flat_map(|effect| &effect.assignments) {
        assigned.push((assignment.owner_class, assignment.attribute));
    }
    for object in 0..domain.objects.len() {
        let class = domain.objects[object].class;
        for attribute in 0..domain.classes[class].attributes.len() {
            let by_effect = assigned.iter().any(|&(owner, position)| {
                position == attribute && (domain.is_a(class, owner) || domain.is_a(owner, class))
            });
            let by_setter = domain.classes[class]
                .operations
                .iter()
                .any(|&op| domain.operations[op].sets == Some(attribute) && domain.operations[op].mentioned);
            let slot = domain.slot(object, attribute);
            domain.mutable[slot] = by_effect || by_setter;
        }
    }
}
