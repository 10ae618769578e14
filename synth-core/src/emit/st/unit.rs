//! Program organization units: what they declare and what they do.
//!
//! Everything that a text declares goes through here, so that a frame can print it as Structured Text and `plcopen` as
//! elements of XML.

use std::fmt;

use super::integer::Integer;
use super::writer::Writer;

/// A function, a function block or a program.
pub(super) struct Unit<'a> {
    /// What it is for, if its name does not say.
    pub(super) comment: Option<&'static str>,
    pub(super) kind: Kind,
    pub(super) name: &'a str,
    pub(super) declarations: Declarations,
    /// Writes the statements.
    pub(super) body: Box<dyn Fn(&mut Writer) + 'a>,
}

/// What a unit is.
pub(super) enum Kind {
    /// A function, with the type of what it returns.
    Function(Type),
    FunctionBlock,
    Program,
}

impl Kind {
    /// The word that opens it; after `END_` it closes it.
    pub(super) fn keyword(&self) -> &'static str {
        match self {
            Kind::Function(_) => "FUNCTION",
            Kind::FunctionBlock => "FUNCTION_BLOCK",
            Kind::Program => "PROGRAM",
        }
    }
}

/// A type as it stands in a declaration; shown in Structured Text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Type {
    /// The keyword of an elementary type.
    Elementary(&'static str),
    /// A type, a function block or a program by its name.
    Derived(String),
    /// From 0 to `last`.
    Array {
        last: usize,
        element: Box<Type>,
    },
    Pointer(Box<Type>),
}

impl Type {
    /// An array from 0 to `last`.
    pub(super) fn array(last: usize, element: impl Into<Type>) -> Type {
        Type::Array { last, element: Box::new(element.into()) }
    }

    pub(super) fn pointer(target: impl Into<Type>) -> Type {
        Type::Pointer(Box::new(target.into()))
    }
}

/// An elementary type by its keyword.
impl From<&'static str> for Type {
    fn from(keyword: &'static str) -> Type {
        Type::Elementary(keyword)
    }
}

impl From<Integer> for Type {
    fn from(integer: Integer) -> Type {
        Type::Elementary(integer.keyword())
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Type::Elementary(keyword) => f.write_str(keyword),
            Type::Derived(name) => f.write_str(name),
            Type::Array { last, element } => write!(f, "ARRAY [0..{last}] OF {element}"),
            Type::Pointer(target) => write!(f, "POINTER TO {target}"),
        }
    }
}

/// The declarations of a unit, in order.
#[derive(Default)]
pub(super) struct Declarations {
    pub(super) sections: Vec<Section>,
}

impl Declarations {
    /// Adds a section of variables, which `keyword` opens: `VAR_INPUT`, `VAR CONSTANT`, …
    pub(super) fn section(&mut self, keyword: &'static str, inside: impl FnOnce(&mut Section)) {
        let mut section = Section { keyword, items: Vec::new() };
        inside(&mut section);
        self.sections.push(section);
    }
}

/// Variables that share a keyword.
pub(super) struct Section {
    pub(super) keyword: &'static str,
    pub(super) items: Vec<Item>,
}

/// A line of a section.
pub(super) enum Item {
    /// About the next variable and those behind it.
    Comment(String),
    Variable {
        name: String,
        of: Type,
        initial: Option<Value>,
    },
}

/// An initial value.
pub(super) enum Value {
    /// A literal.
    Simple(String),
    /// Of an array, one per element.
    Array(Vec<u32>),
}

impl Section {
    /// Says something about the next variables.
    pub(super) fn comment(&mut self, text: &str) {
        self.items.push(Item::Comment(text.to_owned()));
    }

    /// Declares a variable without an initial value.
    pub(super) fn variable(&mut self, name: &str, of: impl Into<Type>) {
        self.declare(name, of, None);
    }

    /// Declares a variable with a literal as its initial value.
    pub(super) fn initialized(&mut self, name: &str, of: impl Into<Type>, value: impl fmt::Display) {
        self.declare(name, of, Some(Value::Simple(value.to_string())));
    }

    /// Declares an array from 0 with the values of its elements, one at least.
    pub(super) fn array(&mut self, name: &str, element: impl Into<Type>, values: &[u32]) {
        let of = Type::array(values.len().saturating_sub(1), element);
        self.declare(name, of, Some(Value::Array(values.to_vec())));
    }

    fn declare(&mut self, name: &str, of: impl Into<Type>, initial: Option<Value>) {
        self.items.push(Item::Variable { name: name.to_owned(), of: of.into(), initial });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_shown_in_structured_text() {
        assert_eq!(Type::from("BOOL").to_string(), "BOOL");
        assert_eq!(Type::array(3, Integer::Uint).to_string(), "ARRAY [0..3] OF UINT");
        let pointer = Type::pointer(Type::array(0, Type::Derived("T".to_owned())));
        assert_eq!(pointer.to_string(), "POINTER TO ARRAY [0..0] OF T");
    }
}
