//! Back ends: texts made of [`Tables`](crate::controller::tables::Tables) and nothing else.

mod diagram;
pub mod dot;
pub mod mermaid;
pub mod names;
pub mod rust;
pub mod shell;
pub mod st;
pub mod template;
