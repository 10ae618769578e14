//! Every name of the module of a program, given once so that none clash.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::names::{Namer, identifier};
use crate::emit::rust::case::{camel, numbered_camel, snake};
use crate::emit::rust::idents::{ident, is_keyword};
use crate::emit::scan::Source;
use crate::logic::Var;
use crate::plant::Use;

/// Names of one program.
pub(super) struct Idents {
    pub(super) module: Ident,
    /// Per variable: a field, or what is computed in a scan.
    pub(super) variables: Vec<Ident>,
    /// Per analogue input its field.
    pub(super) analogues: Vec<Ident>,
    /// Per event of the plant its variant, if it is controllable.
    pub(super) events: Vec<Option<Ident>>,
    usages: Vec<Use>,
}

impl Idents {
    pub(super) fn new(source: &Source<'_>) -> Idents {
        let program = source.program;
        let mut values = Namer::new(is_own_value);
        let mut value = |name: &str| ident(&values.name(&snake(&identifier(name))));
        let variables = program.variables.iter().map(|variable| value(&variable.name)).collect();
        let analogues = program.analogues.iter().map(|name| value(name)).collect();
        let mut variants = Namer::new(|name| name == "Self").numbered(numbered_camel);
        let mut variant = |name: &str| ident(&variants.name(&camel(&identifier(name))));
        Idents {
            module: ident(&Namer::new(is_keyword).name(&snake(&identifier(&program.name)))),
            variables,
            analogues,
            events: source
                .events
                .iter()
                .map(|event| event.controllable.then(|| variant(&event.name)))
                .collect(),
            usages: program.variables.iter().map(|variable| variable.usage).collect(),
        }
    }

    /// How a variable is read and written in a scan.
    pub(super) fn place(&self, variable: Var) -> TokenStream {
        let name = &self.variables[variable as usize];
        match self.usages[variable as usize] {
            Use::Input => quote!(inputs.#name),
            Use::Output => quote!(outputs.#name),
            Use::Memory(_) => quote!(outputs.memory.#name),
            Use::Scratch | Use::Range(..) => quote!(#name),
        }
    }
}

/// Names of `scan`, and keywords.
fn is_own_value(name: &str) -> bool {
    is_keyword(name) || matches!(name, "events" | "holds" | "inputs" | "memory" | "outputs" | "scan")
}
