//! Enums, classes, attributes, operations, objects.

use super::super::domain::{Attribute, Class, Enumeration, NULL, Object, Operation, Type};
use super::super::{ClassId, Expr, Value};
use super::{Meaning, Resolver};
use crate::diagnostic::Code;
use crate::syntax::ast;
use std::collections::BTreeMap;

impl Resolver {
    /// Declares everything that has a name of its own.
    pub(super) fn declare(&mut self, sections: &[&ast::Section]) {
        let items = || {
            sections.iter().filter_map(|section| match section {
                ast::Section::Domain(items) => Some(items),
                _ => None,
            })
        };
        let classes: Vec<&ast::Class> = items().flatten().filter_map(as_class).collect();
        let objects: Vec<&ast::Object> = sections.iter().filter_map(as_object).collect();
        for item in items().flatten() {
            self.declare_item(item);
        }
        let classes = self.inherit(&classes);
        self.declare_members(&classes);
        for object in objects {
            self.declare_object(object);
        }
        self.set_initial_values(&classes, sections);
    }

    fn declare_name(&mut self, what: &str, name: &ast::Name, meaning: Meaning) -> bool {
        if let Some(&(_, first)) = self.names.get(&name.text) {
            self.duplicate(what, name, first);
            return false;
        }
        self.names.insert(name.text.clone(), (meaning, name.span));
        true
    }

    fn declare_item(&mut self, item: &ast::DomainItem) {
        match item {
            ast::DomainItem::Enum(e) => {
                if self.declare_name("enum", &e.name, Meaning::Enum(self.domain.enums.len())) {
                    self.check_unique("literal", e.literals.iter());
                    let literals = e.literals.iter().map(|literal| literal.text.clone()).collect();
                    self.domain.enums.push(Enumeration { name: e.name.text.clone(), literals });
                }
            }
            ast::DomainItem::Class(class) => {
                if self.declare_name("class", &class.name, Meaning::Class(self.domain.classes.len())) {
                    self.domain.classes.push(Class {
                        name: class.name.text.clone(),
                        base: None,
                        is_abstract: class.is_abstract,
                        attributes: Vec::new(),
                        operations: Vec::new(),
                    });
                }
            }
        }
    }

    pub(super) fn check_unique<'a>(&mut self, what: &str, names: impl Iterator<Item = &'a ast::Name>) {
        let mut seen = BTreeMap::new();
        for name in names {
            if let Some(&first) = seen.get(name.text.as_str()) {
                self.duplicate(what, name, first);
            } else {
                seen.insert(name.text.as_str(), name.span);
            }
        }
    }

    /// Links classes to their bases; gives the declarations back so that a base comes before what inherits from it.
    fn inherit<'a>(&mut self, classes: &[&'a ast::Class]) -> Vec<(ClassId, &'a ast::Class)> {
        let mut own: Vec<(ClassId, &ast::Class)> = Vec::new();
        for &class in classes {
            if let Some(&(Meaning::Class(id), span)) = self.names.get(&class.name.text)
                && span == class.name.span
            {
                own.push((id, class));
            }
        }
        for &(id, class) in &own {
            let Some(base) = &class.base else { continue };
            let Some(base_id) = self.class(base) else {
                self.orphans.insert(id);
                continue;
            };
            if self.domain.is_a(base_id, id) {
                let message = format!("class `{}` inherits from itself", class.name.text);
                self.error(Code::CyclicInheritance, base.span, message).help =
                    Some("remove one of the bases on the circle".to_owned());
            } else {
                self.domain.classes[id].base = Some(base_id);
            }
        }
        let depth = |id: ClassId| std::iter::successors(Some(id), |&c| self.domain.classes[c].base).count();
        own.sort_by_key(|&(id, _)| (depth(id), id));
        own
    }

    fn declare_members(&mut self, classes: &[(ClassId, &ast::Class)]) {
        for &(id, class) in classes {
            if let Some(base) = self.domain.classes[id].base {
                self.domain.classes[id].attributes = self.domain.classes[base].attributes.clone();
                self.domain.classes[id].operations = self.domain.classes[base].operations.clone();
            }
            self.declare_attributes(id, class);
            self.declare_operations(id, class, classes);
        }
    }

    fn declare_attributes(&mut self, id: ClassId, class: &ast::Class) {
        self.check_unique("attribute", class.attributes.iter().map(|attribute| &attribute.name));
        for attribute in &class.attributes {
            let name = &attribute.name;
            if self.domain.classes[id].attributes.iter().any(|a| a.name == name.text) {
                if class.attributes.iter().filter(|a| a.name.text == name.text).count() == 1 {
                    let message = format!("attribute `{}` is inherited already", name.text);
                    self.error(Code::DuplicateName, name.span, message);
                }
                continue;
            }
            let Some(ty) = self.ty(&attribute.ty) else {
                self.lost.extend([name.text.clone(), setter_name(&name.text)]);
                continue;
            };
            let initial = match ty {
                Type::Bool | Type::Enum(_) => 0,
                Type::Int(low, _) => low,
                Type::Class(_) => NULL,
            };
            let position = self.domain.classes[id].attributes.len();
            self.domain.classes[id].attributes.push(Attribute { name: name.text.clone(), ty, initial });
            let setter = Operation {
                name: setter_name(&name.text),
                parameters: vec![(name.text.clone(), ty)],
                sets: Some(position),
                mentioned: false,
            };
            self.domain.classes[id].operations.push(self.domain.operations.len());
            self.domain.operations.push(setter);
        }
    }

    fn declare_operations(&mut self, id: ClassId, class: &ast::Class, classes: &[(ClassId, &ast::Class)]) {
        for operation in &class.operations {
            let name = &operation.name;
            let earlier = self.domain.classes[id]
                .operations
                .iter()
                .copied()
                .find(|&op| self.domain.operations[op].name == name.text);
            if let Some(earlier) = earlier {
                match place_of(&self.domain.operations[earlier], classes) {
                    Some(first) => {
                        self.duplicate("operation", name, first);
                        if self.domain.operations[earlier].sets.is_some() {
                            self.explain_setter(name);
                        }
                    }
                    None => {
                        let message = format!("operation `{}` exists already", name.text);
                        self.error(Code::DuplicateName, name.span, message);
                    }
                }
                continue;
            }
            self.check_unique("parameter", operation.parameters.iter().map(|(name, _)| name));
            let typed = operation.parameters.iter().map(|(name, ty)| (name.text.clone(), self.ty(ty)));
            let typed: Vec<(String, Option<Type>)> = typed.collect();
            let parameters: Option<Vec<(String, Type)>> =
                typed.into_iter().map(|(name, ty)| Some((name, ty?))).collect();
            let Some(parameters) = parameters else {
                self.lost.insert(name.text.clone());
                continue;
            };
            self.domain.classes[id].operations.push(self.domain.operations.len());
            let operation = Operation { name: name.text.clone(), parameters, sets: None, mentioned: false };
            self.domain.operations.push(operation);
        }
    }

    /// That an operation is declared twice need not be plain: nobody has written the setter of an attribute.
    fn explain_setter(&mut self, name: &ast::Name) {
        if let Some(last) = self.diagnostics.last_mut() {
            last.labels
                .iter_mut()
                .for_each(|label| label.1 = format!("`{}` exists because of this", name.text));
            last.help =
                Some("remove it: the setter of an attribute exists without being declared".to_owned());
        }
    }

    fn declare_object(&mut self, object: &ast::Object) {
        let id = self.domain.objects.len();
        if !self.declare_name("object", &object.name, Meaning::Object(id)) {
            return;
        }
        let class = self.class(&object.class);
        if let Some(class) = class
            && self.domain.classes[class].is_abstract
        {
            let message = format!("class `{}` is abstract and has no objects", object.class.text);
            self.error(Code::TypeMismatch, object.class.span, message).help =
                Some("name a class that inherits from it".to_owned());
        }
        let Some(class) = class else {
            self.names.remove(&object.name.text);
            self.lost.insert(object.name.text.clone());
            return;
        };
        let first_slot = self.domain.slot_types.len();
        for attribute in &self.domain.classes[class].attributes {
            self.domain.slot_types.push(attribute.ty);
            self.domain.initial.push(attribute.initial);
            self.domain.mutable.push(true);
        }
        self.domain.objects.push(Object { name: object.name.text.clone(), class, first_slot });
    }

    /// Declared initial values; after all objects are known, because a value may be an object.
    fn set_initial_values(&mut self, classes: &[(ClassId, &ast::Class)], sections: &[&ast::Section]) {
        for &(id, class) in classes {
            for attribute in &class.attributes {
                let Some(literal) = &attribute.initial else { continue };
                let position =
                    self.domain.classes[id].attributes.iter().position(|a| a.name == attribute.name.text);
                let Some(position) = position else { continue };
                let ty = self.domain.classes[id].attributes[position].ty;
                let Some(value) = self.literal(literal, ty) else { continue };
                for object in 0..self.domain.objects.len() {
                    if self.domain.is_a(self.domain.objects[object].class, id) {
                        let slot = self.domain.slot(object, position);
                        self.domain.initial[slot] = value;
                    }
                }
            }
        }
        for object in sections.iter().filter_map(as_object) {
            let Some(&(Meaning::Object(id), span)) = self.names.get(&object.name.text) else { continue };
            if span != object.name.span {
                continue;
            }
            self.check_unique("value of", object.values.iter().map(|(name, _)| name));
            for (name, literal) in &object.values {
                let class = self.domain.objects[id].class;
                let Some(position) = self.attribute(class, name) else { continue };
                let ty = self.domain.classes[class].attributes[position].ty;
                if let Some(value) = self.literal(literal, ty) {
                    let slot = self.domain.slot(id, position);
                    self.domain.initial[slot] = value;
                }
            }
        }
    }

    /// The position of an attribute.
    pub(super) fn attribute(&mut self, class: ClassId, name: &ast::Name) -> Option<usize> {
        let is_orphan = self.is_orphan(class);
        let class = &self.domain.classes[class];
        let position = class.attributes.iter().position(|attribute| attribute.name == name.text);
        if position.is_none() && is_orphan {
            self.silenced += 1;
        } else if position.is_none() {
            let known: Vec<String> = class.attributes.iter().map(|a| a.name.clone()).collect();
            let what = format!("attribute of class `{}`:", class.name);
            self.unknown(&what, name, known.iter().map(String::as_str));
        }
        position
    }

    /// The value of a literal of type `ty`.
    pub(super) fn literal(&mut self, literal: &ast::Expr, ty: Type) -> Option<Value> {
        let scope = super::expr::Names::default();
        match self.value_of_type(literal, ty, &scope, false)? {
            Expr::Const(value) => Some(value),
            other => other.constant(),
        }
    }
}

fn as_class(item: &ast::DomainItem) -> Option<&ast::Class> {
    match item {
        ast::DomainItem::Class(class) => Some(class),
        ast::DomainItem::Enum(_) => None,
    }
}

fn as_object<'a>(section: &&'a ast::Section) -> Option<&'a ast::Object> {
    match section {
        ast::Section::Object(object) => Some(object),
        _ => None,
    }
}

/// `setLocation` for `location`.
fn setter_name(attribute: &str) -> String {
    let (first, rest) = attribute.split_at(1);
    format!("set{}{rest}", first.to_ascii_uppercase())
}

/// Where an operation was declared, a setter at its attribute.
fn place_of(operation: &Operation, classes: &[(ClassId, &ast::Class)]) -> Option<crate::syntax::Span> {
    let declared = classes.iter().flat_map(|(_, class)| &class.operations);
    let attributes = classes.iter().flat_map(|(_, class)| &class.attributes);
    match operation.sets {
        None => declared.map(|op| &op.name).find(|name| name.text == operation.name).map(|name| name.span),
        Some(_) => attributes
            .map(|attribute| &attribute.name)
            .find(|name| name.text == operation.parameters[0].0)
            .map(|name| name.span),
    }
}
