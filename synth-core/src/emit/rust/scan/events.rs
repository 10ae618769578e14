//! `Event`, what a scan can cause, and `Events`, a set of them.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Idents, doc, gap};
use crate::emit::scan::formula::PLANT;
use crate::emit::scan::{Source, commands};
use crate::plant::Event;

/// Bits of a word of the set.
const WORD: usize = 32;

pub(super) fn items(source: &Source<'_>, idents: &Idents) -> TokenStream {
    let named: Vec<_> = (0..)
        .zip(source.events)
        .zip(&idents.events)
        .filter_map(|((number, event), variant)| Some((number, event, variant.as_ref()?)))
        .collect();
    let variants: Vec<_> = named.iter().map(|(_, _, variant)| *variant).collect();
    let texts: Vec<&str> = named.iter().map(|(_, event, _)| event.name.as_str()).collect();
    let docs = named.iter().map(|(number, event, _)| event_doc(source, *number, event));
    let count = Literal::usize_unsuffixed(named.len());
    let words = Literal::usize_unsuffixed(named.len().div_ceil(WORD).max(1));
    // The bit of an event, by its position; none of an enum without variants.
    let (number, name) = if named.is_empty() {
        (quote!(match self {}), quote!(match self {}))
    } else {
        (quote!(self as usize), quote!(match self { #(Self::#variants => #texts,)* }))
    };
    let bits = Literal::usize_unsuffixed(WORD);
    quote! {
        /// What a scan can cause.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Event {
            #(#docs #variants,)*
        }
        impl Event {
            /// All of them, in the order of the plant.
            pub const ALL: [Self; #count] = [#(Self::#variants),*];
            /// As the plant has it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                #name
            }
            const fn number(self) -> usize {
                #number
            }
        }
        /// What a scan caused.
        #[derive(Clone, Copy, Default, PartialEq, Eq, Hash, Debug)]
        pub struct Events([u32; #words]);
        impl Events {
            /// Whether an event is one of them.
            #[must_use]
            pub const fn contains(self, event: Event) -> bool {
                self.0[event.number() / #bits] >> (event.number() % #bits) & 1 != 0
            }
            /// Whether nothing was caused.
            #[must_use]
            pub fn is_empty(self) -> bool {
                self.0.iter().all(|&word| word == 0)
            }
            /// All of them, in the order of the plant.
            pub fn iter(self) -> impl Iterator<Item = Event> {
                Event::ALL.into_iter().filter(move |&event| self.contains(event))
            }
            const fn insert(&mut self, event: Event) {
                self.0[event.number() / #bits] |= 1 << (event.number() % #bits);
            }
        }
    }
}

/// What an event is, what it does, and when it may fire.
fn event_doc(source: &Source<'_>, number: u32, event: &Event) -> TokenStream {
    let name = |variable| source.name(variable).to_owned();
    let mut rungs = source.program.rungs.iter().filter(|rung| rung.event == Some(number)).peekable();
    let mut lines: Vec<String> = vec![format!("`{}`", event.name)];
    lines.extend(gap(&event.doc).map(str::to_owned));
    if rungs.peek().is_none() {
        lines.extend([String::new(), "No scan causes it: it has no rung.".to_owned()]);
    }
    for rung in rungs {
        let condition = PLANT.text(&rung.condition, &name);
        let commands = commands(source, rung);
        let does = if commands.is_empty() { "nothing is to be done" } else { &commands };
        lines.push(String::new());
        lines.push(format!("Where `{condition}`: {does}."));
        lines.extend(gap(&rung.comment).map(str::to_owned));
    }
    doc(lines.iter().map(String::as_str))
}
