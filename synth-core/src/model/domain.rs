//! Classes, objects and the values that attributes and parameters can take.

use super::expr::{UNSET, Value};

/// Index into [`Domain::classes`].
pub type ClassId = usize;
/// Index into [`Domain::objects`]; also the [`Value`] of an object.
pub type ObjectId = usize;
/// Index into [`Domain::operations`].
pub type OperationId = usize;
/// Index of one attribute of one object.
pub type SlotId = usize;

/// A type. Values are integers: `false` 0 and `true` 1, an enum's literals from 0, objects by id, `null` -1.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Type {
    /// `bool`.
    Bool,
    /// `lo..=hi`.
    Int(i64, i64),
    /// An enum, by index.
    Enum(usize),
    /// An object of this class or a subclass, or `null`.
    Class(ClassId),
}

/// The value of `null`.
pub(crate) const NULL: Value = -1;

/// An enum.
#[derive(Clone, Debug)]
pub struct Enumeration {
    /// Its name.
    pub name: String,
    /// Its literals.
    pub literals: Vec<String>,
}

/// A class; inherited attributes come first, so that a position means the same in every subclass.
#[derive(Clone, Debug)]
pub struct Class {
    /// Its name.
    pub name: String,
    /// The class it inherits from.
    pub base: Option<ClassId>,
    /// Has no objects of its own.
    pub is_abstract: bool,
    /// Inherited ones first.
    pub attributes: Vec<Attribute>,
    /// Its own and inherited operations, implicit setters too.
    pub operations: Vec<OperationId>,
}

/// An attribute of a class.
#[derive(Clone, Debug)]
pub struct Attribute {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Its declared or default initial value.
    pub initial: Value,
}

/// An operation.
#[derive(Clone, Debug)]
pub struct Operation {
    /// Its name.
    pub name: String,
    /// Name and type of each parameter.
    pub parameters: Vec<(String, Type)>,
    /// For an implicit `setX`: the position of `x` among the receiver's attributes.
    pub sets: Option<usize>,
    /// Some scenario names it; a setter that none names never happens.
    pub mentioned: bool,
}

/// An object.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its name.
    pub name: String,
    /// Its class.
    pub class: ClassId,
    /// The slot of its first attribute; the others follow.
    pub first_slot: SlotId,
}

/// All classes, enums, objects and operations.
#[derive(Clone, Debug, Default)]
pub struct Domain {
    /// In textual order.
    pub enums: Vec<Enumeration>,
    /// In textual order.
    pub classes: Vec<Class>,
    /// In textual order.
    pub objects: Vec<Object>,
    /// Declared and implicit operations.
    pub operations: Vec<Operation>,
    /// Per slot: its type.
    pub slot_types: Vec<Type>,
    /// Per slot: its initial value.
    pub initial: Vec<Value>,
    /// Per slot: some effect or `setX` may change it. The others are constants.
    pub mutable: Vec<bool>,
}

impl Domain {
    /// Whether `class` is `base` or inherits from it.
    #[must_use]
    pub fn is_a(&self, class: ClassId, base: ClassId) -> bool {
        let mut next = Some(class);
        while let Some(class) = next {
            if class == base {
                return true;
            }
            next = self.classes[class].base;
        }
        false
    }

    /// The slot of an object's attribute.
    #[must_use]
    pub fn slot(&self, object: ObjectId, attribute: usize) -> SlotId {
        self.objects[object].first_slot + attribute
    }

    /// Whether `value` is one of `ty`.
    #[must_use]
    pub fn fits(&self, value: Value, ty: Type) -> bool {
        match ty {
            Type::Bool => value == 0 || value == 1,
            Type::Int(low, high) => (low..=high).contains(&value),
            Type::Enum(e) => (0..self.enums[e].literals.len() as i64).contains(&value),
            Type::Class(class) => value == NULL || self.is_instance(value, class),
        }
    }

    /// Whether `value` is an object (not `null`) of `class` or a subclass.
    #[must_use]
    pub fn is_instance(&self, value: Value, class: ClassId) -> bool {
        usize::try_from(value)
            .is_ok_and(|object| self.objects.get(object).is_some_and(|object| self.is_a(object.class, class)))
    }

    /// Every value of `ty` in ascending order; for a class its objects without `null`.
    pub fn values(&self, ty: Type) -> Box<dyn Iterator<Item = Value> + '_> {
        match ty {
            Type::Bool => Box::new(0..=1),
            Type::Int(low, high) => Box::new(low..=high),
            Type::Enum(e) => Box::new(0..self.enums[e].literals.len() as Value),
            Type::Class(class) => Box::new(
                (0..self.objects.len() as Value).filter(move |&object| self.is_instance(object, class)),
            ),
        }
    }

    /// Number of values that an attribute of `ty` can have, `null` included.
    #[must_use]
    pub fn cardinality(&self, ty: Type) -> u64 {
        match ty {
            Type::Bool => 2,
            Type::Int(low, high) => high.abs_diff(low).saturating_add(1),
            Type::Enum(e) => self.enums[e].literals.len() as u64,
            Type::Class(_) => self.objects.len() as u64 + 1,
        }
    }

    /// The least value that an attribute of `ty` can have.
    #[must_use]
    pub fn lowest(&self, ty: Type) -> Value {
        match ty {
            Type::Bool | Type::Enum(_) => 0,
            Type::Int(low, _) => low,
            Type::Class(_) => NULL,
        }
    }

    /// The value as it stands in event texts.
    #[must_use]
    pub fn show(&self, value: Value, ty: Type) -> String {
        match ty {
            _ if value == UNSET => "?".to_owned(),
            Type::Bool => (value != 0).to_string(),
            Type::Int(..) => value.to_string(),
            Type::Enum(e) => self.enums[e].literals[value as usize].clone(),
            Type::Class(_) if value == NULL => "null".to_owned(),
            Type::Class(_) => self.objects[value as usize].name.clone(),
        }
    }

    /// The type as it is written.
    #[must_use]
    pub fn show_type(&self, ty: Type) -> String {
        match ty {
            Type::Bool => "bool".to_owned(),
            Type::Int(low, high) => format!("{low}..={high}"),
            Type::Enum(e) => self.enums[e].name.clone(),
            Type::Class(class) => self.classes[class].name.clone(),
        }
    }
}
