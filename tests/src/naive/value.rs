//! Values and events.

use std::fmt;

/// A value. An enum literal is its name alone: well-typed specifications never compare literals of two enums.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Value {
    /// `true`, `false`.
    Bool(bool),
    /// An integer.
    Int(i64),
    /// An enum literal.
    Literal(String),
    /// An object.
    Object(String),
    /// No object.
    Null,
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Bool(value) => write!(f, "{value}"),
            Value::Int(value) => write!(f, "{value}"),
            Value::Literal(name) | Value::Object(name) => f.write_str(name),
            Value::Null => f.write_str("null"),
        }
    }
}

/// A message that is sent: (sender object, receiver object, operation, argument values).
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Event {
    /// Name of the object that sends.
    pub sender: String,
    /// Name of the object that receives.
    pub receiver: String,
    /// Operation of the receiver.
    pub operation: String,
    /// One value for each parameter.
    pub arguments: Vec<Value>,
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} -> {}.{}(", self.sender, self.receiver, self.operation)?;
        for (index, argument) in self.arguments.iter().enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            write!(f, "{separator}{argument}")?;
        }
        f.write_str(")")
    }
}
