//! Back ends: texts made of [`Tables`](crate::controller::tables::Tables), or of a [`Program`](crate::plant::Program) of
//! rungs ([`scan`]), and nothing else.

pub mod automata;
mod diagram;
pub mod dot;
pub mod mermaid;
pub mod names;
pub mod rust;
pub mod scan;
pub mod shell;
pub mod st;
pub mod template;
