//! `tr!` and `trn!`: texts for the user, written as for `format!`.
//!
//! A text is looked up in the catalog of the user's language, so that its values stand in it by
//! name: `{name}`, `{name:.2}`. Names are variables that are in scope, or are given after the text:
//! `tr!("{count} of {all}", all = list.len())`. How a value is formatted is decided here, when the
//! program is built; a translation repeats the braces as they are.

mod text;

use proc_macro::TokenStream;
use quote::quote;
use syn::parse_macro_input;

use crate::text::{CountedText, FilledText, Row};

/// Text for the user, in the user's language: a `&'static str` where nothing is filled in, else a
/// `String`.
///
/// A text that means two things in two places, as "Normal" does, has a context before an arrow:
/// `tr!("blend mode" => "Normal")`.
#[proc_macro]
pub fn tr(input: TokenStream) -> TokenStream {
    let filled = parse_macro_input!(input as FilledText);
    filled.tokens().unwrap_or_else(syn::Error::into_compile_error).into()
}

/// Text for the user that depends on a number: `trn!(count, "{count} layer", "{count} layers")`, a
/// `String`. The number is a variable, or is named: `trn!(n = list.len(), ...)`.
#[proc_macro]
pub fn trn(input: TokenStream) -> TokenStream {
    let counted = parse_macro_input!(input as CountedText);
    counted.tokens().unwrap_or_else(syn::Error::into_compile_error).into()
}

/// Text of a table's row, in English; it is looked up when it is shown: `text!("Lights")`, a
/// `chiaro_locale::Text`. It may have a context, as that of [`tr!`] may.
#[proc_macro]
pub fn text(input: TokenStream) -> TokenStream {
    let Row { context, text } = parse_macro_input!(input as Row);
    match context {
        Some(context) => quote!(::chiaro_locale::Text::of(#context, #text)).into(),
        None => quote!(::chiaro_locale::Text::new(#text)).into(),
    }
}
