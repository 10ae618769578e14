//! Types that are more than one cell, and the room that they take.

use crate::kind::Kind;

/// An index into [`Types`].
pub(crate) type TypeId = usize;

/// Characters of a `STRING` without a length.
pub(crate) const DEFAULT_TEXT: u32 = 80;

#[derive(Clone, Debug)]
pub(crate) enum Type {
    Elementary(Kind),
    Subrange {
        base: Kind,
        low: i64,
        high: i64,
    },
    Enumeration {
        name: String,
        values: Vec<(String, i64)>,
    },
    /// A cell for the length, one per character, and one for the zero behind the last.
    Text {
        capacity: u32,
    },
    Array {
        /// Lower and upper limit of each dimension.
        limits: Vec<(i64, i64)>,
        element: TypeId,
        named: Option<String>,
    },
    Structure {
        name: String,
        fields: Vec<Field>,
    },
    /// A function block or program, by its index.
    Block {
        name: String,
        pou: usize,
    },
    Pointer(TypeId),
}

#[derive(Clone, Debug)]
pub(crate) struct Field {
    /// In capitals.
    pub(crate) name: String,
    pub(crate) ty: TypeId,
    pub(crate) offset: u32,
}

/// All types of a unit.
#[derive(Clone, Debug, Default)]
pub(crate) struct Types {
    entries: Vec<Entry>,
}

#[derive(Clone, Debug)]
struct Entry {
    ty: Type,
    /// What a variable of the type holds without an initial value; its length is the size.
    image: Vec<i64>,
}

impl Types {
    pub(crate) fn get(&self, id: TypeId) -> &Type {
        &self.entries[id].ty
    }

    /// In cells.
    pub(crate) fn size(&self, id: TypeId) -> u32 {
        self.entries[id].image.len() as u32
    }

    pub(crate) fn image(&self, id: TypeId) -> &[i64] {
        &self.entries[id].image
    }

    pub(crate) fn add(&mut self, ty: Type, image: Vec<i64>) -> TypeId {
        self.entries.push(Entry { ty, image });
        self.entries.len() - 1
    }

    pub(crate) fn elementary(&mut self, kind: Kind) -> TypeId {
        let known = self.entries.iter().position(|e| matches!(e.ty, Type::Elementary(k) if k == kind));
        known.unwrap_or_else(|| self.add(Type::Elementary(kind), vec![0]))
    }

    pub(crate) fn text(&mut self, capacity: u32) -> TypeId {
        let known =
            self.entries.iter().position(|e| matches!(e.ty, Type::Text { capacity: c } if c == capacity));
        known.unwrap_or_else(|| self.add(Type::Text { capacity }, vec![0; capacity as usize + 2]))
    }

    pub(crate) fn pointer(&mut self, target: TypeId) -> TypeId {
        let known = self.entries.iter().position(|e| matches!(e.ty, Type::Pointer(t) if t == target));
        known.unwrap_or_else(|| self.add(Type::Pointer(target), vec![0]))
    }

    /// The elementary type that is computed with.
    pub(crate) fn kind(&self, id: TypeId) -> Option<Kind> {
        match self.get(id) {
            Type::Elementary(kind) | Type::Subrange { base: kind, .. } => Some(*kind),
            _ => None,
        }
    }

    /// Whether one cell holds a value.
    pub(crate) fn is_scalar(&self, id: TypeId) -> bool {
        match self.get(id) {
            Type::Elementary(_) | Type::Subrange { .. } | Type::Enumeration { .. } | Type::Pointer(_) => true,
            Type::Text { .. } | Type::Array { .. } | Type::Structure { .. } | Type::Block { .. } => false,
        }
    }

    /// The elementary type of all cells, if it is one.
    pub(crate) fn uniform(&self, id: TypeId) -> Option<Kind> {
        match self.get(id) {
            Type::Elementary(kind) | Type::Subrange { base: kind, .. } => Some(*kind),
            Type::Array { element, .. } => self.uniform(*element),
            _ => None,
        }
    }

    /// What `SIZEOF` says: without padding.
    pub(crate) fn bytes(&self, id: TypeId) -> u32 {
        match self.get(id) {
            Type::Elementary(kind) | Type::Subrange { base: kind, .. } => kind.bytes(),
            Type::Enumeration { .. } => 2,
            Type::Text { capacity } => capacity + 1,
            Type::Array { element, limits, .. } => {
                let count: i64 = limits.iter().map(|(low, high)| high - low + 1).product();
                count as u32 * self.bytes(*element)
            }
            Type::Structure { fields, .. } => fields.iter().map(|field| self.bytes(field.ty)).sum(),
            Type::Block { .. } | Type::Pointer(_) => 8,
        }
    }

    /// Whether values are of one type by their shape.
    pub(crate) fn same_shape(&self, a: TypeId, b: TypeId) -> bool {
        a == b
            || match (self.get(a), self.get(b)) {
                (
                    Type::Array { limits: la, element: ea, .. },
                    Type::Array { limits: lb, element: eb, .. },
                ) => la == lb && self.same_shape(*ea, *eb),
                (Type::Pointer(a), Type::Pointer(b)) => self.same_shape(*a, *b),
                _ => false,
            }
    }

    /// How messages call it.
    pub(crate) fn name(&self, id: TypeId) -> String {
        match self.get(id) {
            Type::Elementary(kind) => kind.name().to_owned(),
            Type::Subrange { base, low, high } => format!("{} ({low}..{high})", base.name()),
            Type::Text { .. } => "STRING".to_owned(),
            Type::Enumeration { name, .. } | Type::Structure { name, .. } | Type::Block { name, .. } => {
                name.clone()
            }
            Type::Array { named: Some(name), .. } => name.clone(),
            Type::Array { limits, element, .. } => {
                let limits: Vec<String> = limits.iter().map(|(low, high)| format!("{low}..{high}")).collect();
                format!("ARRAY [{}] OF {}", limits.join(", "), self.name(*element))
            }
            Type::Pointer(target) => format!("POINTER TO {}", self.name(*target)),
        }
    }
}
