//! Texts with named values: read from a macro's tokens, checked, and written as a lookup.

use proc_macro2::TokenStream;
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::{Error, Expr, Ident, LitStr, Result, Token};

/// Value that is given by name after a text.
struct NamedValue {
    name: Ident,
    value: Expr,
}

impl Parse for NamedValue {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![=]>()?;
        Ok(Self { name, value: input.parse()? })
    }
}

/// Text with its context, without values.
pub(crate) struct Row {
    pub(crate) context: Option<LitStr>,
    pub(crate) text: LitStr,
}

impl Parse for Row {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let first: LitStr = input.parse()?;
        if !input.peek(Token![=>]) {
            return Ok(Self { context: None, text: first });
        }
        input.parse::<Token![=>]>()?;
        Ok(Self { context: Some(first), text: input.parse()? })
    }
}

/// Text with its context and the values that stand in it.
pub(crate) struct FilledText {
    context: Option<LitStr>,
    text: LitStr,
    values: Vec<NamedValue>,
}

impl Parse for FilledText {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let Row { context, text } = input.parse()?;
        Ok(Self { context, text, values: values(input)? })
    }
}

impl FilledText {
    /// Tokens of the text as its user reads it.
    pub(crate) fn tokens(&self) -> Result<TokenStream> {
        let text = &self.text;
        let looked_up = match &self.context {
            Some(context) => quote!(::chiaro_locale::tr_in(#context, #text)),
            None => quote!(::chiaro_locale::tr(#text)),
        };
        let fields = fields(text)?;
        all_used(&fields, &self.values, None)?;
        Ok(if fields.is_empty() {
            looked_up
        } else {
            let values = filled(&fields, &self.values);
            quote!(::chiaro_locale::fill(#looked_up, &[#values]))
        })
    }
}

/// Text that depends on a number, in English's two forms.
pub(crate) struct CountedText {
    count: Expr,
    one: LitStr,
    many: LitStr,
    values: Vec<NamedValue>,
}

impl Parse for CountedText {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let mut values = Vec::new();
        let count = if input.peek2(Token![=]) && !input.peek2(Token![==]) {
            let named: NamedValue = input.parse()?;
            let name = named.name.clone();
            values.push(named);
            syn::parse_quote!(#name)
        } else {
            input.parse()?
        };
        input.parse::<Token![,]>()?;
        let one = input.parse()?;
        input.parse::<Token![,]>()?;
        let many = input.parse()?;
        values.extend(self::values(input)?);
        Ok(Self { count, one, many, values })
    }
}

impl CountedText {
    /// Tokens of the text as its user reads it. The values are worked out once.
    pub(crate) fn tokens(&self) -> Result<TokenStream> {
        let Self { count, one, many, values } = self;
        let mut used = fields(one)?;
        for field in fields(many)? {
            if used.iter().all(|other| other.inside != field.inside) {
                used.push(field);
            }
        }
        let counted = match count {
            Expr::Path(path) => path.path.get_ident(),
            _ => None,
        };
        all_used(&used, values, counted)?;
        let (names, given): (Vec<_>, Vec<_>) =
            values.iter().map(|named| (&named.name, &named.value)).unzip();
        let filled = filled(&used, &[]);
        Ok(quote!({
            #(let #names = #given;)*
            let form = ::chiaro_locale::trn(#one, #many, u64::try_from(#count).unwrap_or(u64::MAX));
            ::chiaro_locale::fill(form, &[#filled])
        }))
    }
}

/// Reads the values after a text, each after a comma.
fn values(input: ParseStream<'_>) -> Result<Vec<NamedValue>> {
    let mut values = Vec::new();
    while !input.is_empty() {
        input.parse::<Token![,]>()?;
        if !input.is_empty() {
            values.push(input.parse()?);
        }
    }
    Ok(values)
}

/// Place in a text where a value stands.
struct Field {
    /// Text within the braces, by which a translation names the value.
    inside: String,
    name: Ident,
    /// Format of the value: a colon and what follows it, or nothing.
    format: String,
}

/// Finds the places of a text where values stand.
fn fields(text: &LitStr) -> Result<Vec<Field>> {
    let value = text.value();
    let mut fields: Vec<Field> = Vec::new();
    let mut rest = value.as_str();
    while let Some(at) = rest.find(['{', '}']) {
        let brace = &rest[at..=at];
        rest = &rest[at + 1..];
        if let Some(after) = rest.strip_prefix(brace) {
            rest = after;
            continue;
        }
        let end = rest.find('}').filter(|_| brace == "{");
        let Some(end) = end else {
            return Err(Error::new(text.span(), "a brace alone; write it twice to mean a brace"));
        };
        let inside = &rest[..end];
        rest = &rest[end + 1..];
        let (name, format) = inside.split_at(inside.find(':').unwrap_or(inside.len()));
        let Ok(mut ident) = syn::parse_str::<Ident>(name) else {
            let wrong = format!("`{{{inside}}}` has no name that a translator could read");
            return Err(Error::new(text.span(), wrong));
        };
        if format.contains('$') {
            return Err(Error::new(text.span(), "format such a value before it is given"));
        }
        ident.set_span(text.span());
        if fields.iter().all(|field| field.inside != inside) {
            let (inside, format) = (inside.to_owned(), format.to_owned());
            fields.push(Field { inside, name: ident, format });
        }
    }
    Ok(fields)
}

/// Asks that every value that is given stands in the text; `counted` may not.
fn all_used(fields: &[Field], values: &[NamedValue], counted: Option<&Ident>) -> Result<()> {
    let stands = |name: &Ident| fields.iter().any(|field| field.name == *name);
    let idle = values.iter().find(|named| !stands(&named.name) && Some(&named.name) != counted);
    idle.map_or(Ok(()), |named| Err(Error::new(named.name.span(), "stands nowhere in the text")))
}

/// Pairs of what stands in the braces and the formatted value.
fn filled(fields: &[Field], values: &[NamedValue]) -> TokenStream {
    let pairs = fields.iter().map(|Field { inside, name, format }| {
        let template = format!("{{{format}}}");
        let given = values.iter().find(|named| named.name == *name);
        let value = given.map_or_else(
            || quote!(#name),
            |named| {
                let value = &named.value;
                quote!(#value)
            },
        );
        quote!((#inside, ::core::format_args!(#template, #value)))
    });
    quote!(#(#pairs),*)
}
