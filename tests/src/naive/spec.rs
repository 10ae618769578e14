//! The specification as tables that are looked up by name (language reference, section 1).

use super::cut;
use super::state::Attributes;
use super::value::{Event, Value};
use std::collections::{BTreeMap, BTreeSet};
use synth_core::syntax::ast::{
    self, Body, DomainItem, Expr, ExprKind, FragmentKind, ScenarioKind, Section, Type, TypeKind,
};

/// A class.
#[derive(Clone, Debug)]
pub struct Class {
    /// The class it inherits from.
    pub base: Option<String>,
    /// Its own attributes.
    pub attributes: Vec<ast::Attribute>,
    /// Its own operations.
    pub operations: Vec<ast::Operation>,
}

/// A scenario with what it needs of its collaboration.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// `Collaboration.Scenario`.
    pub name: String,
    /// Assumption, guarantee or existential.
    pub kind: ScenarioKind,
    /// Dynamic roles and their classes.
    pub roles: BTreeMap<String, String>,
    /// `role = expr`, in textual order.
    pub bindings: Vec<(String, Expr)>,
    /// What it says.
    pub body: Body,
}

/// A specification.
#[derive(Clone, Debug, Default)]
pub struct Spec {
    /// Literals of each enum.
    pub enums: BTreeMap<String, Vec<String>>,
    /// Classes by name.
    pub classes: BTreeMap<String, Class>,
    /// Class of each object.
    pub objects: BTreeMap<String, String>,
    /// Initial values.
    pub attributes: Attributes,
    /// In textual order.
    pub effects: Vec<ast::Effect>,
    /// Classes listed as controllable.
    pub controllable: BTreeSet<String>,
    /// Class and operation of events that do not happen by themselves.
    pub non_spontaneous: BTreeSet<(String, String)>,
    /// Class, operation, parameter, and the values that it takes.
    pub ranges: Vec<(String, String, String, Vec<Value>)>,
    /// In textual order.
    pub channels: Vec<ast::Channel>,
    /// In textual order.
    pub scenarios: Vec<Scenario>,
    /// Indices of those whose demands do not count.
    pub relaxed: BTreeSet<usize>,
}

impl Spec {
    /// Reads the tables off the syntax tree of one file without imports.
    ///
    /// # Errors
    /// A name that is not declared, where it is needed to build the tables.
    pub fn new(file: &ast::File) -> Result<Spec, String> {
        let mut spec = Spec::default();
        for section in &file.sections {
            spec.add_section(section);
        }
        // Literals are told from objects by name, so values wait for all declarations.
        for section in &file.sections {
            match section {
                Section::Object(object) => spec.add_initial_values(object)?,
                Section::ParameterRanges(ranges) => spec.add_ranges(ranges)?,
                _ => {}
            }
        }
        Ok(spec)
    }

    fn add_section(&mut self, section: &Section) {
        match section {
            Section::Domain(items) => items.iter().for_each(|item| self.add_domain_item(item)),
            Section::Object(object) => {
                self.objects.insert(object.name.text.clone(), object.class.text.clone());
            }
            Section::Effects(effects) => self.effects.extend(effects.iter().cloned()),
            Section::Controllable(classes) => {
                self.controllable.extend(classes.classes.iter().map(|name| name.text.clone()));
            }
            Section::NonSpontaneous(events) => self
                .non_spontaneous
                .extend(events.iter().map(|event| (event.class.text.clone(), event.operation.text.clone()))),
            Section::ParameterRanges(_) => {}
            Section::Channels(channels) => self.channels.extend(channels.iter().cloned()),
            Section::Collaboration(collaboration) => self.add_collaboration(collaboration),
        }
    }

    fn add_domain_item(&mut self, item: &DomainItem) {
        match item {
            DomainItem::Enum(item) => {
                let literals = item.literals.iter().map(|name| name.text.clone()).collect();
                self.enums.insert(item.name.text.clone(), literals);
            }
            DomainItem::Class(class) => {
                let entry = Class {
                    base: class.base.as_ref().map(|name| name.text.clone()),
                    attributes: class.attributes.clone(),
                    operations: class.operations.clone(),
                };
                self.classes.insert(class.name.text.clone(), entry);
            }
        }
    }

    fn add_collaboration(&mut self, collaboration: &ast::Collaboration) {
        let roles: BTreeMap<String, String> = collaboration
            .roles
            .iter()
            .filter(|role| role.dynamic)
            .map(|role| (role.name.text.clone(), role.class.text.clone()))
            .collect();
        for scenario in &collaboration.scenarios {
            self.scenarios.push(Scenario {
                name: format!("{}.{}", collaboration.name.text, scenario.name.text),
                kind: scenario.kind,
                roles: roles.clone(),
                bindings: scenario
                    .bindings
                    .iter()
                    .map(|(role, expr)| (role.text.clone(), expr.clone()))
                    .collect(),
                body: scenario.body.clone(),
            });
        }
    }

    /// Declared values of the object, else of the attribute, else the type's first.
    fn add_initial_values(&mut self, object: &ast::Object) -> Result<(), String> {
        for attribute in self.attributes_of(&object.class.text) {
            let own = object.values.iter().find(|(name, _)| name.text == attribute.name.text);
            let declared = own.map(|(_, value)| value).or(attribute.initial.as_ref());
            let value = match declared {
                Some(literal) => self.literal(literal)?,
                None => self.default_value(&attribute.ty)?,
            };
            self.attributes.insert((object.name.text.clone(), attribute.name.text.clone()), value);
        }
        Ok(())
    }

    fn add_ranges(&mut self, ranges: &[ast::ParameterRanges]) -> Result<(), String> {
        for range in ranges {
            for (parameter, spans) in &range.parameters {
                let mut values = Vec::new();
                for span in spans {
                    match (self.literal(&span.low)?, &span.high) {
                        (Value::Int(low), Some(high)) => {
                            let Value::Int(high) = self.literal(high)? else {
                                return Err("a range that does not end in an integer".into());
                            };
                            values.extend((low..=high).map(Value::Int));
                        }
                        (value, _) => values.push(value),
                    }
                }
                let event = &range.event;
                self.ranges.push((
                    event.class.text.clone(),
                    event.operation.text.clone(),
                    parameter.text.clone(),
                    values,
                ));
            }
        }
        Ok(())
    }

    /// The value of a literal.
    fn literal(&self, expr: &Expr) -> Result<Value, String> {
        match &expr.kind {
            ExprKind::Bool(value) => Ok(Value::Bool(*value)),
            ExprKind::Int(value) => Ok(Value::Int(*value)),
            ExprKind::Null => Ok(Value::Null),
            ExprKind::Literal(_, literal) => Ok(Value::Literal(literal.text.clone())),
            ExprKind::Path(path) if path.names.len() == 1 => Ok(self.object_or_literal(&path.names[0].text)),
            ExprKind::Path(_) | ExprKind::Unary(..) | ExprKind::Binary(..) => Err("not a literal".into()),
        }
    }

    /// What a name means when it is no variable, parameter or role.
    #[must_use]
    pub fn object_or_literal(&self, name: &str) -> Value {
        if self.objects.contains_key(name) { Value::Object(name.into()) } else { Value::Literal(name.into()) }
    }

    fn default_value(&self, ty: &Type) -> Result<Value, String> {
        Ok(match &ty.kind {
            TypeKind::Bool => Value::Bool(false),
            TypeKind::Int(low, _) => Value::Int(*low),
            TypeKind::Named(name) => match self.enums.get(name) {
                Some(literals) => Value::Literal(literals.first().ok_or("an enum without literals")?.clone()),
                None => Value::Null,
            },
        })
    }

    /// All values of a type; of a class its objects, without `null`.
    #[must_use]
    pub fn values_of(&self, ty: &Type) -> Vec<Value> {
        match &ty.kind {
            TypeKind::Bool => vec![Value::Bool(false), Value::Bool(true)],
            TypeKind::Int(low, high) => (*low..=*high).map(Value::Int).collect(),
            TypeKind::Named(name) => match self.enums.get(name) {
                Some(literals) => literals.iter().cloned().map(Value::Literal).collect(),
                None => self.objects_of(name).into_iter().map(Value::Object).collect(),
            },
        }
    }

    /// Whether a value belongs to a type; `null` belongs to every class.
    #[must_use]
    pub fn fits(&self, value: &Value, ty: &Type) -> bool {
        match (value, &ty.kind) {
            (Value::Bool(_), TypeKind::Bool) => true,
            (Value::Int(value), TypeKind::Int(low, high)) => (low..=high).contains(&value),
            (Value::Literal(value), TypeKind::Named(name)) => {
                self.enums.get(name).is_some_and(|literals| literals.contains(value))
            }
            (Value::Object(object), TypeKind::Named(name)) => self.is_instance(object, name),
            (Value::Null, TypeKind::Named(name)) => self.classes.contains_key(name),
            _ => false,
        }
    }

    /// The class and those it inherits from, itself first.
    fn lineage(&self, class: &str) -> Vec<String> {
        let mut lineage: Vec<String> = Vec::new();
        let mut next = Some(class.to_owned());
        while let Some(class) = next.filter(|class| !lineage.contains(class)) {
            next = self.classes.get(&class).and_then(|entry| entry.base.clone());
            lineage.push(class);
        }
        lineage
    }

    /// Whether an object is of a class or one that inherits from it.
    #[must_use]
    pub fn is_instance(&self, object: &str, class: &str) -> bool {
        self.objects.get(object).is_some_and(|own| self.lineage(own).iter().any(|each| each == class))
    }

    /// The objects of a class and of those that inherit from it.
    #[must_use]
    pub fn objects_of(&self, class: &str) -> Vec<String> {
        self.objects.keys().filter(|object| self.is_instance(object, class)).cloned().collect()
    }

    /// Whether an endpoint of an effect, an object or a class, means this object.
    #[must_use]
    pub fn is_endpoint(&self, object: &str, endpoint: &str) -> bool {
        object == endpoint || self.is_instance(object, endpoint)
    }

    fn attributes_of(&self, class: &str) -> Vec<ast::Attribute> {
        self.lineage(class)
            .iter()
            .filter_map(|class| self.classes.get(class))
            .flat_map(|class| class.attributes.clone())
            .collect()
    }

    /// The type of an attribute of an object.
    #[must_use]
    pub fn attribute_type(&self, object: &str, attribute: &str) -> Option<Type> {
        let class = self.objects.get(object)?;
        let found = self.attributes_of(class).into_iter().find(|each| each.name.text == attribute);
        found.map(|attribute| attribute.ty)
    }

    /// The attribute that an implicit `setX` sets, unless the class declares an operation of that name.
    #[must_use]
    pub fn set_attribute(&self, receiver: &str, operation: &str) -> Option<String> {
        let class = self.objects.get(receiver)?;
        if self.declared_operation(class, operation).is_some() {
            return None;
        }
        let names = self.attributes_of(class).into_iter().map(|attribute| attribute.name.text);
        names.into_iter().find(|name| setter_name(name) == operation)
    }

    fn declared_operation(&self, class: &str, operation: &str) -> Option<ast::Operation> {
        self.lineage(class)
            .iter()
            .filter_map(|class| self.classes.get(class))
            .flat_map(|class| &class.operations)
            .find(|each| each.name.text == operation)
            .cloned()
    }

    /// Names and types of the parameters of an operation of an object.
    #[must_use]
    pub fn parameters(&self, receiver: &str, operation: &str) -> Option<Vec<(String, Type)>> {
        let class = self.objects.get(receiver)?;
        if let Some(operation) = self.declared_operation(class, operation) {
            return Some(operation.parameters.into_iter().map(|(name, ty)| (name.text, ty)).collect());
        }
        let attribute = self.set_attribute(receiver, operation)?;
        let ty = self.attribute_type(receiver, &attribute)?;
        Some(vec![(attribute, ty)])
    }

    /// The values that `parameter ranges` give a parameter, all entries together; `None` without one.
    fn given_range(&self, receiver: &str, operation: &str, parameter: &str) -> Option<BTreeSet<Value>> {
        let given: Vec<&Vec<Value>> = self
            .ranges
            .iter()
            .filter(|(class, name, of, _)| {
                name == operation && of == parameter && self.is_instance(receiver, class)
            })
            .map(|(.., values)| values)
            .collect();
        (!given.is_empty()).then(|| given.into_iter().flatten().cloned().collect())
    }

    /// The values over which a parameter is expanded: its range, or its whole type.
    #[must_use]
    pub fn range(&self, receiver: &str, operation: &str, parameter: &str, ty: &Type) -> Vec<Value> {
        match self.given_range(receiver, operation, parameter) {
            Some(values) => values.into_iter().collect(),
            None => self.values_of(ty),
        }
    }

    /// Whether a range is given for the parameter that does not contain the value.
    #[must_use]
    pub fn is_outside_range(&self, receiver: &str, operation: &str, parameter: &str, value: &Value) -> bool {
        self.given_range(receiver, operation, parameter).is_some_and(|values| !values.contains(value))
    }

    /// Whether the system sends what this object sends.
    #[must_use]
    pub fn is_controllable(&self, object: &str) -> bool {
        self.controllable.iter().any(|class| self.is_instance(object, class))
    }

    /// Whether an event is listed under `non-spontaneous events`.
    #[must_use]
    pub fn is_non_spontaneous(&self, event: &Event) -> bool {
        self.non_spontaneous.iter().any(|(class, operation)| {
            *operation == event.operation && self.is_instance(&event.receiver, class)
        })
    }

    /// Whether the event has a link to go over, or needs none.
    #[must_use]
    pub fn has_channel(&self, attributes: &Attributes, event: &Event) -> bool {
        let mut channels = self
            .channels
            .iter()
            .filter(|channel| {
                channel.event.operation.text == event.operation
                    && self.is_instance(&event.receiver, &channel.event.class.text)
            })
            .peekable();
        channels.peek().is_none()
            || channels.any(|channel| {
                let link = (event.sender.clone(), channel.reference.text.clone());
                self.is_instance(&event.sender, &channel.class.text)
                    && attributes.get(&link) == Some(&Value::Object(event.receiver.clone()))
            })
    }
}

impl Scenario {
    /// The body at a path.
    #[must_use]
    pub fn body_at(&self, path: &[usize]) -> Option<&Body> {
        path.chunks(2).try_fold(&self.body, |body, step| match step {
            [next, index] => cut::nested(body.fragments.get(*next)?, *index),
            _ => None,
        })
    }

    /// The variable that a name means in the body at `path`: the path of the body that declares it, and its type.
    #[must_use]
    pub fn variable(&self, path: &[usize], name: &str) -> Option<(Vec<usize>, &Type)> {
        for length in (0..=path.len()).rev().step_by(2) {
            let path = &path[..length];
            let declaration =
                self.body_at(path)?.fragments.iter().find_map(|fragment| match &fragment.kind {
                    FragmentKind::Variable(ty, declared, _) if declared.text == name => Some(ty),
                    _ => None,
                });
            if let Some(ty) = declaration {
                return Some((path.to_vec(), ty));
            }
        }
        None
    }
}

/// `setX` for an attribute `x`.
#[must_use]
pub fn setter_name(attribute: &str) -> String {
    let (first, rest) = attribute.split_at(1);
    format!("set{}{rest}", first.to_uppercase())
}
