//! What tests share: a naive reference implementation of the language, random specifications, and a reference
//! interpreter of tables.

pub mod beside;
pub mod corpus;
pub mod families;
pub mod fast;
pub mod memory_naive;
pub mod naive;
pub mod plant_builder;
pub mod plant_families;
pub mod plant_naive;
pub mod published;
pub mod random;
pub mod random_plant;
pub mod random_signals;
pub mod reference;
pub mod same;
pub mod scan;
pub mod scratch;
pub mod smallest;
pub mod survive;
pub mod tables;
