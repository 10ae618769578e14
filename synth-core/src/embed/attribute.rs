//! `#![name]` and `#![name = "value"]` in front of what a macro is given.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::quote_spanned;

/// A choice that the macro's user makes.
pub(super) struct Attribute {
    pub(super) name: Ident,
    /// With the place of the string.
    pub(super) value: Option<(String, Span)>,
    /// Of all of it.
    pub(super) span: Span,
}

/// Something wrong with an attribute, and where.
pub(super) type Wrong = (Span, String);

/// Takes all attributes off the beginning, and has each of them understood.
///
/// # Errors
///
/// A `compile_error!` at the first that `take` does not understand, that has another form, or a name for the second time.
pub(super) fn take_off(
    tokens: &TokenStream,
    expected: &str,
    mut take: impl FnMut(&Attribute) -> Result<(), Wrong>,
) -> Result<TokenStream, TokenStream> {
    let (groups, rest) = split(tokens);
    let mut names = Vec::new();
    for group in groups {
        let done = attribute(&group).ok_or_else(|| (group.span(), format!("expected {expected}")));
        let done = done.and_then(|attribute| {
            if names.contains(&attribute.name) {
                return Err((attribute.span, format!("`{}` is chosen twice", attribute.name)));
            }
            names.push(attribute.name.clone());
            take(&attribute)
        });
        done.map_err(|(span, why)| quote_spanned!(span=> ::core::compile_error! { #why }))?;
    }
    Ok(rest)
}

/// What stands in the brackets of each, and what comes behind the last.
fn split(tokens: &TokenStream) -> (Vec<Group>, TokenStream) {
    let mut groups = Vec::new();
    let mut rest = tokens.clone().into_iter();
    loop {
        let mut ahead = rest.clone();
        match (ahead.next(), ahead.next(), ahead.next()) {
            (
                Some(TokenTree::Punct(hash)),
                Some(TokenTree::Punct(bang)),
                Some(TokenTree::Group(attribute)),
            ) if hash.as_char() == '#'
                && bang.as_char() == '!'
                && attribute.delimiter() == Delimiter::Bracket =>
            {
                groups.push(attribute);
                rest = ahead;
            }
            _ => return (groups, rest.collect()),
        }
    }
}

fn attribute(group: &Group) -> Option<Attribute> {
    let span = group.span();
    let mut inner = group.stream().into_iter();
    let (name, equals, value) = (inner.next(), inner.next(), inner.next());
    match (name, equals, value, inner.next()) {
        (Some(TokenTree::Ident(name)), None, None, None) => Some(Attribute { name, value: None, span }),
        (
            Some(TokenTree::Ident(name)),
            Some(TokenTree::Punct(equals)),
            Some(TokenTree::Literal(value)),
            None,
        ) if equals.as_char() == '=' => {
            let text = syn::parse_str::<syn::LitStr>(&value.to_string()).ok()?;
            Some(Attribute { name, value: Some((text.value(), value.span())), span })
        }
        _ => None,
    }
}
