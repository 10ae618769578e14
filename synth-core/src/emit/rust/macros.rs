//! Calls of the runtime's macros, whose content is items, formatted like other items: formatters do not look into macros,
//! so that to them each is a module.

use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};
use quote::quote;

/// The macros that generated modules call.
const MACROS: [&str; 3] = ["formatted", "names", "serialized"];

/// A name that no specification gives to a module: those are in lower case.
fn stand_in(name: &str) -> String {
    format!("{name}_STAND_IN")
}

/// `::controller_template::names! { … }` becomes `mod names_STAND_IN { … }`.
pub(super) fn as_modules(items: TokenStream) -> TokenStream {
    let mut replaced: Vec<TokenTree> = Vec::new();
    let mut items = items.into_iter().peekable();
    while let Some(item) = items.next() {
        let name = replaced.last().map(ToString::to_string).unwrap_or_default();
        let is_call = matches!(&item, TokenTree::Punct(mark) if mark.as_char() == '!');
        if is_call && MACROS.contains(&name.as_str()) && matches!(items.peek(), Some(TokenTree::Group(_))) {
            // The path `::controller_template::name` is six tokens.
            replaced.truncate(replaced.len() - 6);
            let module = Ident::new(&stand_in(&name), Span::call_site());
            replaced.extend(quote!(mod #module));
            continue;
        }
        replaced.push(match item {
            TokenTree::Group(group) => Group::new(group.delimiter(), as_modules(group.stream())).into(),
            other => other,
        });
    }
    replaced.into_iter().collect()
}

/// The reverse, in text.
pub(super) fn from_modules(text: &str) -> String {
    MACROS.iter().fold(text.to_owned(), |text, name| {
        text.replace(&format!("mod {} {{", stand_in(name)), &format!("::controller_template::{name}! {{"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        let items = quote! {
            pub mod m {
                ::controller_template::formatted! { struct S { field: u8 } }
                const A: bool = !names::f();
                ::core::assert!(A);
            }
        };
        let file = syn::parse2(as_modules(items)).expect("items");
        let text = from_modules(&prettyplease::unparse(&file));
        let expected = "pub mod m {\n    ::controller_template::formatted! {\n        struct S {\n            \
                        field: u8,\n        }\n    }\n    const A: bool = !names::f();\n    ::core::assert!(A);\n}\n";
        assert_eq!(text, expected);
    }
}
