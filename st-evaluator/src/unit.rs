//! A text that was checked and compiled.

use std::collections::BTreeMap;

use crate::declare::{Analysis, Pou, PouKind, Program, Section, Variable};
use crate::dialect::Dialect;
use crate::error::{AccessError, Error};
use crate::instance::{Instance, Root};
use crate::task::Task;
use crate::tree::Source;
use crate::types::Types;

/// A text that was checked and compiled, ready to be [instantiated](Unit::instance).
#[derive(Debug)]
pub struct Unit {
    pub(crate) types: Types,
    pub(crate) pous: Vec<Pou>,
    pub(crate) globals: BTreeMap<String, Variable>,
    pub(crate) constants: Vec<i64>,
    pub(crate) global_cells: Vec<i64>,
    programs: Vec<Program>,
    tasks: Vec<Task>,
}

impl Unit {
    /// Checks and compiles a text.
    ///
    /// # Errors
    ///
    /// Everything that a compiler of the dialect would refuse, in the order of the text. If the grammar cannot read
    /// it, that is all that is found out.
    pub fn parse(text: &str, dialect: Dialect) -> Result<Unit, Vec<Error>> {
        let (source, tree) = Source::parse(text, dialect)?;
        let analysis = Analysis::of(&source, tree.root_node());
        let Analysis { mut errors, types, pous, globals, constants, global_cells, programs, tasks, .. } =
            analysis;
        if errors.is_empty() {
            return Ok(Unit { types, pous, globals, constants, global_cells, programs, tasks });
        }
        errors.sort();
        errors.dedup();
        Err(errors)
    }

    /// A fresh instance of a function block, program or function, which is then run by itself.
    ///
    /// # Errors
    ///
    /// There is none of this name, or it has `VAR_IN_OUT`, for which there is nothing to refer to.
    pub fn instance(&self, name: &str) -> Result<Instance<'_>, AccessError> {
        let index = self.pous.iter().position(|pou| pou.name.eq_ignore_ascii_case(name));
        let Some(index) = index else { return Err(AccessError(format!("there is no `{name}`"))) };
        let pou = &self.pous[index];
        if pou.scope.variables.iter().any(|variable| variable.section == Section::InOut) {
            return Err(AccessError(format!("`{name}` has `VAR_IN_OUT`")));
        }
        let root = Root { name: String::new(), pou: index };
        Ok(Instance::new(self, vec![root]))
    }

    /// All programs of the configuration. A call is one scan: each program runs once, in the order of the text;
    /// names begin with that of the program, `Main0.state_no`.
    ///
    /// # Errors
    ///
    /// No configuration names a program.
    pub fn configuration(&self) -> Result<Instance<'_>, AccessError> {
        if self.programs.is_empty() {
            return Err(AccessError("no configuration names a program".to_owned()));
        }
        let roots = self.programs.iter().map(|program| Root { name: program.name.clone(), pou: program.pou });
        Ok(Instance::new(self, roots.collect()))
    }

    /// The tasks of all configurations, in the order of the text.
    #[must_use]
    pub fn tasks(&self) -> &[Task] {
        &self.tasks
    }

    /// The names of the function blocks, programs and functions of the text, in its order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.pous.iter().filter(|pou| pou.counted).map(|pou| pou.name.as_str())
    }

    pub(crate) fn is_function(&self, index: usize) -> bool {
        self.pous[index].kind == PouKind::Function
    }
}
