//! Identifiers of Structured Text for a program of rungs.

use crate::emit::names::identifier;
use crate::emit::scan::Source;
use crate::emit::st::Target;
use crate::emit::st::names::{Runner, Scope};

/// Does nothing while FALSE.
pub(in crate::emit::st) const ENABLE: &str = "enable";

/// The function block in the program.
pub(in crate::emit::st) const INSTANCE: &str = "controller";

/// The text's own names.
const OWN: &[&str] = &[ENABLE, INSTANCE, "holds", "Config0", "Res0", "PLC", "Cyclic", "Main0"];

/// All identifiers that depend on the plant.
pub(in crate::emit::st) struct Names {
    pub(in crate::emit::st) function_block: String,
    pub(in crate::emit::st) program: String,
    /// Per variable.
    pub(in crate::emit::st) variables: Vec<String>,
    /// Per analogue input.
    pub(in crate::emit::st) analogues: Vec<String>,
    data_block: String,
    organization_block: String,
}

impl Names {
    /// Names everything, what stands outside first; the scope can claim more.
    pub(in crate::emit::st) fn new(source: &Source<'_>, target: Target) -> (Names, Scope) {
        let program = source.program;
        let mut scope = Scope::new(target.dialect().words, OWN);
        let plant = identifier(&program.name);
        let names = Names {
            function_block: scope.claim(&plant, "_Controller"),
            program: scope.claim(&plant, "_Main"),
            variables: program.variables.iter().map(|it| scope.claim(&identifier(&it.name), "")).collect(),
            analogues: program.analogues.iter().map(|name| scope.claim(&identifier(name), "")).collect(),
            data_block: scope.claim(&plant, "_Main_DB"),
            organization_block: scope.claim(&plant, "_Cyclic"),
        };
        (names, scope)
    }

    /// What runs the program.
    pub(in crate::emit::st) fn runner(&self) -> Runner<'_> {
        let Names { program, data_block, organization_block, .. } = self;
        Runner { program, data_block, organization_block }
    }
}
