//! Values as a test reads and writes them.

use std::time::Duration;

/// What a variable holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Value {
    /// `BOOL`.
    Bool(bool),
    /// Any integer, bit string or character; an enumeration's value.
    Int(i128),
    /// `TIME`, in nanoseconds.
    Time(i64),
    /// `STRING`.
    Text(String),
    /// Row by row, whatever the limits.
    Array(Vec<Value>),
    /// The fields of a structure, or the variables of a function block, in the order of their declaration.
    Structure(Vec<(String, Value)>),
}

impl Value {
    /// The value of a `BOOL`.
    #[must_use]
    pub fn as_bool(&self) -> Option<bool> {
        match self {
            Value::Bool(value) => Some(*value),
            _ => None,
        }
    }

    /// The value of an integer, bit string, character or enumeration.
    #[must_use]
    pub fn as_int(&self) -> Option<i128> {
        match self {
            Value::Int(value) => Some(*value),
            _ => None,
        }
    }

    /// The elements of an array.
    #[must_use]
    pub fn as_array(&self) -> Option<&[Value]> {
        match self {
            Value::Array(values) => Some(values),
            _ => None,
        }
    }
}

impl From<bool> for Value {
    fn from(value: bool) -> Value {
        Value::Bool(value)
    }
}

impl From<i32> for Value {
    fn from(value: i32) -> Value {
        Value::Int(value.into())
    }
}

impl From<i64> for Value {
    fn from(value: i64) -> Value {
        Value::Int(value.into())
    }
}

impl From<u32> for Value {
    fn from(value: u32) -> Value {
        Value::Int(value.into())
    }
}

impl From<&str> for Value {
    fn from(value: &str) -> Value {
        Value::Text(value.to_owned())
    }
}

impl From<Duration> for Value {
    fn from(value: Duration) -> Value {
        Value::Time(i64::try_from(value.as_nanos()).unwrap_or(i64::MAX))
    }
}
