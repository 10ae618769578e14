//! The Rust back end: a module of static tables and typed names over the runtime crate `controller-template`.
//!
//! The module names nothing but itself, `::core` and `::controller_template`, so no name of a specification can
//! shadow what it uses. It compiles without warnings under `clippy::pedantic`.

mod case;
mod columns;
mod commands;
mod controller;
mod docs;
mod engine;
mod event;
mod idents;
mod layout;
mod macros;
pub mod scan;
mod secondary;
mod tables;
mod template;

use proc_macro2::TokenStream;
use quote::quote;

pub use self::engine::Engine;
use self::engine::Rows;
use self::idents::Idents;
use crate::controller::tables::{FORMAT_VERSION, Tables};
use crate::emit::shell;
use crate::emit::st::{ComponentNames, NameMap};
use crate::emit::template::Template;

/// What is emitted.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// For controllers minimised for one event at a time: the interface for several at once is left out.
    pub ordered: bool,
    /// How rows are found.
    pub engine: Engine,
}

/// `pub mod <specification>`.
#[must_use]
pub fn module(tables: &Tables, options: &Options) -> TokenStream {
    let idents = Idents::new(tables);
    let rows = engine::rows(options.engine, tables);
    let docs = docs::module(tables, options, &*rows);
    let items = items(tables, &idents, options, &*rows);
    let name = &idents.module;
    quote! {
        #docs
        #[allow(dead_code, unreachable_pub, reason = "no program needs every item")]
        #[allow(
            clippy::disallowed_names,
            clippy::doc_markdown,
            clippy::enum_variant_names,
            clippy::module_inception,
            clippy::module_name_repetitions,
            clippy::similar_names,
            clippy::struct_field_names,
            clippy::upper_case_acronyms,
            clippy::wrong_self_convention,
            rustdoc::bare_urls,
            reason = "names and texts are the specification's"
        )]
        #[allow(
            clippy::many_single_char_names,
            clippy::too_many_arguments,
            clippy::too_many_lines,
            clippy::trivially_copy_pass_by_ref,
            clippy::type_complexity,
            reason = "sizes are the specification's"
        )]
        pub mod #name {
            #items
        }
    }
}

/// The module as a file to be read: formatted, tables laid out as tables, its origin at the top.
///
/// It can be `include!`d. The same tables and options give the same bytes.
#[must_use]
pub fn text(tables: &Tables, options: &Options) -> String {
    let module = macros::as_modules(module(tables, options));
    let file = syn::parse2(module).expect("generated items are Rust");
    let formatted = macros::from_modules(&prettyplease::unparse(&file));
    format!("{}{}", header(tables, options.engine), layout::tidy(&formatted))
}

/// A template of a secondary per component, in order of the objects' names.
#[must_use]
pub fn templates(tables: &Tables) -> Vec<Template> {
    template::templates(tables, &Idents::new(tables))
}

/// What events, components and codes are called in the module: an event by its variant of `Event`, a component by its
/// field of `Commands`.
#[must_use]
pub fn name_map(tables: &Tables) -> NameMap {
    let Idents { module, events, components } = Idents::new(tables);
    let inputs = tables.events.iter().zip(events);
    let outputs = tables.components.iter().zip(components);
    NameMap {
        target: "rust",
        function_block: format!("{module}::Controller"),
        program: module.to_string(),
        state: "state".to_owned(),
        owed: "owed".to_owned(),
        events: inputs.map(|(table, name)| (table.event.text.clone(), name.to_string())).collect(),
        components: outputs
            .map(|(table, names)| ComponentNames {
                object: table.object.clone(),
                output: names.field.to_string(),
                secondary: names.secondary.to_string(),
                file: template::file(&names),
                codes: table.commands.iter().map(|command| command.text.clone()).zip(1..).collect(),
            })
            .collect(),
    }
}

fn items(tables: &Tables, idents: &Idents, options: &Options, rows: &dyn Rows) -> TokenStream {
    let event = event::items(tables, idents);
    let commands = commands::items(tables, idents);
    let secondaries = secondary::items(tables, idents);
    let controller = controller::items(tables, options, rows);
    let event_names = event::names(tables, idents);
    let command_names = commands::names(tables, idents);
    let serialized = commands::serialized(idents);
    let tables = tables::items(tables, idents, rows);
    quote! {
        #controller
        #event
        #commands
        #secondaries
        #tables
        ::controller_template::names! { #event_names #command_names }
        ::controller_template::serialized! { #serialized }
    }
}

/// Bytes of flash of the tables in [`module`], but for what is owed.
#[must_use]
pub fn bytes(tables: &Tables, options: &Options) -> usize {
    engine::bytes(&*engine::rows(options.engine, tables))
}

/// The option of the command line that chooses an engine, if it need be said.
fn engine_option(engine: Engine) -> String {
    if engine == Engine::default() { String::new() } else { format!(" --engine {}", engine.name()) }
}

/// Origin of the file; no time or place, so that the same input gives the same bytes.
fn header(tables: &Tables, engine: Engine) -> String {
    let line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let provenance = &tables.provenance;
    format!(
        "// Generated by `sml` {version} from `{file}` (input {hash}, table format {FORMAT_VERSION}).\n\
         // Do not edit: change the specification, then run `sml export {argument} --target rust{engine}{options}` again.\n\n",
        version = env!("CARGO_PKG_VERSION"),
        file = line(&provenance.file),
        argument = line(&shell::input(&provenance.file)),
        hash = line(&provenance.hash),
        engine = engine_option(engine),
        options = provenance.options,
    )
}
