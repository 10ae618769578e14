//! `scan`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::Idents;
use crate::emit::scan::Source;
use crate::logic::Expr;
use crate::plant::{Coil, Drive, Rung, Use};

pub(super) fn scan(source: &Source<'_>, idents: &Idents) -> TokenStream {
    let ranges = source.ranges().map(|(variable, analogue, low, high)| {
        let (name, analogue) = (idents.place(variable), &idents.analogues[analogue as usize]);
        let [least, greatest] = [low, high].map(Literal::i64_unsuffixed);
        // An empty range is an error to Clippy.
        let value = if low <= high {
            quote!((#least..=#greatest).contains(&inputs.#analogue))
        } else {
            quote!(false)
        };
        quote!(let #name = #value;)
    });
    let scratch = idents.variables.iter().zip(&source.program.variables);
    let scratch = scratch.filter(|(_, variable)| variable.usage == Use::Scratch).map(|(name, _)| name);
    let rungs: TokenStream = source.program.rungs.iter().map(|rung| self::rung(idents, rung)).collect();
    let body = if rungs.is_empty() {
        quote!(Events::default())
    } else {
        quote! {
            let mut events = Events::default();
            #(#ranges)*
            #(let mut #scratch = false;)*
            #rungs
            events
        }
    };
    quote! {
        /// Does one scan: from inputs, and outputs as they are, finds what may be done, and does it.
        #[allow(
            unused_assignments,
            unused_mut,
            unused_variables,
            clippy::missing_const_for_fn,
            clippy::needless_pass_by_ref_mut,
            clippy::nonminimal_bool,
            clippy::overly_complex_bool_expr,
            clippy::suspicious_operation_groupings,
            clippy::useless_let_if_seq,
            reason = "formulas are the synthesis's"
        )]
        pub fn scan(inputs: &Inputs, outputs: &mut Outputs) -> Events {
            #body
        }
    }
}

fn rung(idents: &Idents, rung: &Rung) -> TokenStream {
    let condition = formula(idents, &rung.condition, false);
    let event = rung.event.and_then(|event| idents.events[event as usize].as_ref());
    let event = event.map(|variant| quote!(events.insert(Event::#variant);));
    let place = |coil: &Coil| idents.place(coil.variable);
    if rung.coils.is_empty() && event.is_none() {
        return TokenStream::new();
    }
    if let ([Coil { drive: Drive::Out, variable }], None) = (rung.coils.as_slice(), &event) {
        let place = idents.place(*variable);
        return quote!(#place = #condition;);
    }
    if rung.coils.iter().all(|coil| coil.drive != Drive::Out) {
        let commands = rung.coils.iter().map(|coil| {
            let (place, value) = (place(coil), coil.drive == Drive::Set);
            quote!(#place = #value;)
        });
        return quote!(if #condition { #(#commands)* #event });
    }
    let commands = rung.coils.iter().map(|coil| {
        let place = place(coil);
        match coil.drive {
            Drive::Set => quote!(#place |= holds;),
            Drive::Reset => quote!(#place &= !holds;),
            Drive::Out => quote!(#place = holds;),
        }
    });
    let event = event.map(|event| quote!(if holds { #event }));
    quote! {
        let holds = #condition;
        #(#commands)*
        #event
    }
}

/// An expression, in parentheses if it is a disjunction in a conjunction.
fn formula(idents: &Idents, expr: &Expr, inside: bool) -> TokenStream {
    match expr {
        Expr::Constant(value) => quote!(#value),
        Expr::Literal(literal) => {
            let place = idents.place(literal.variable);
            if literal.negated { quote!(!#place) } else { place }
        }
        Expr::And(all) => {
            let all = all.iter().map(|part| formula(idents, part, true));
            quote!(#(#all)&&*)
        }
        Expr::Or(any) => {
            let any = any.iter().map(|part| formula(idents, part, false));
            if inside { quote!((#(#any)||*)) } else { quote!(#(#any)||*) }
        }
    }
}
