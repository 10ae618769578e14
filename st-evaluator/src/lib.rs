//! Checks and runs IEC 61131-3 Structured Text.

mod arithmetic;
mod code;
mod compile;
mod declare;
mod dialect;
mod error;
mod instance;
mod kind;
mod machine;
mod prelude;
mod reserved;
mod spelling;
mod tree;
mod types;
mod unit;
mod value;

pub use dialect::Dialect;
pub use error::{AccessError, Error, RuntimeError};
pub use instance::Instance;
pub use machine::Stats;
pub use unit::Unit;
pub use value::Value;
