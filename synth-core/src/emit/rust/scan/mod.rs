//! Programs of rungs as Rust: a module with a function that does a scan.
//!
//! ```text
//! pub mod distribution_station {
//!     pub struct Inputs { pub x0: bool, … }          what sensors say; an `i32` per analogue input
//!     pub struct Outputs { pub y0: bool, … }         read and written; memory, if there is any, in a field `memory`
//!     pub enum Event { Inject, … }                   what a scan can cause
//!     pub struct Events(…)                           what one did cause, a bit each
//!     pub fn scan(inputs: &Inputs, outputs: &mut Outputs) -> Events
//! }
//! ```
//!
//! The module depends on nothing but `::core`, allocates nothing and cannot panic.
//!
//! # Why conditions are `&&` and `||`
//!
//! A condition could be tested in one word of all signals, a mask and a comparison a term. For the distribution station that takes
//! 49 instructions of x86-64 a scan instead of 92, but 117 with putting the signals into the word and getting them out again
//! (callgrind, optimised for speed; 58, 92 and 131 for size): it pays only for callers that have such a word already, and
//! all others would pay for them.
//!
//! A ring of twelve machines of which one runs at a time, 36 signals and 24 conditions of up to 36 literals, is about the best
//! that can happen to masks. There a scan takes 413 instructions with `&&` and `||`; 284 with one word of 64 bits, filled and
//! emptied in every scan; 395 with two words of 32 bits, which coils write to beside the fields. Registers of small machines
//! have 32 bits, and there every mask and every number are constants that take two instructions to load.

mod events;
mod idents;
mod rungs;
mod structs;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use self::idents::Idents;
use super::layout;
use crate::emit::scan::{NameMap, Source, origin};

/// `pub mod <plant>`.
#[must_use]
pub fn module(source: &Source<'_>) -> TokenStream {
    let idents = Idents::new(source);
    let (structs, events, scan) =
        (structs::items(source, &idents), events::items(source, &idents), rungs::scan(source, &idents));
    let title = format!(" State-feedback controller of the plant `{}`.", source.program.name);
    let doc = doc(std::iter::once(title.as_str()).chain(gap(&source.program.doc)));
    let name = &idents.module;
    quote! {
        #doc
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
            rustdoc::bare_urls,
            reason = "names and texts are the plant's"
        )]
        #[allow(
            clippy::cognitive_complexity,
            clippy::many_single_char_names,
            clippy::struct_excessive_bools,
            clippy::too_many_lines,
            clippy::trivially_copy_pass_by_ref,
            reason = "sizes are the plant's"
        )]
        pub mod #name {
            #structs
            #events
            #scan
        }
    }
}

/// The module as a file to be read: formatted, its origin at the top; it can be `include!`d.
#[must_use]
pub fn text(source: &Source<'_>) -> String {
    let file = syn::parse2(module(source)).expect("generated items are Rust");
    let mut out = String::new();
    // What the plant says of itself stands at the module.
    let plain = crate::plant::Program { doc: Vec::new(), ..source.program.clone() };
    for line in origin(&Source { program: &plain, ..*source }, "State-feedback controller of", "rust") {
        out.push_str(&format!("// {}\n", line.split_whitespace().collect::<Vec<_>>().join(" ")));
    }
    out.push('\n');
    out + &layout::tidy(&prettyplease::unparse(&file))
}

/// What things are called in the module: variables by their fields, events by their variants.
#[must_use]
pub fn names(source: &Source<'_>) -> NameMap {
    let Idents { module, variables, analogues, events, .. } = Idents::new(source);
    let texts = |idents: Vec<Ident>| idents.iter().map(Ident::to_string).collect();
    NameMap {
        target: "rust",
        function_block: format!("{module}::scan"),
        program: module.to_string(),
        variables: texts(variables),
        analogues: texts(analogues),
        events: texts(events.into_iter().flatten().collect()),
    }
}

/// A blank line, if lines follow, and these.
fn gap(lines: &[String]) -> impl Iterator<Item = &str> {
    (!lines.is_empty()).then_some("").into_iter().chain(lines.iter().map(String::as_str))
}

/// Doc attributes, a line each.
fn doc<'a>(lines: impl IntoIterator<Item = &'a str>) -> TokenStream {
    let lines = lines.into_iter().map(|line| match line.trim() {
        "" => String::new(),
        line => format!(" {line}"),
    });
    quote!(#(#[doc = #lines])*)
}
