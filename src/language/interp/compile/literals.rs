//! Reader of literals at f64, which naga's front end has rounded to f32.
//!
//! naga keeps no number as it was written, but keeps its span; and a folded number has the span of
//! the whole expression. That text is read again and evaluated twice side by side, in f64
//! throughout and as naga did, rounding where WGSL's types do. Only if the second result is naga's
//! number bit for bit is the first one used. So a misreading does no harm: naga's number stands.

use std::collections::HashMap;
use std::sync::OnceLock;

use naga::Span;

use super::arithmetic::{ConstantNumber, evaluate};
use crate::wgsl::{DeclarationKind, scan};

/// Length of the longest text that is read again, in bytes.
const MAX_LENGTH: usize = 1000;

/// Greatest number of passes over the module's constants until all that name others are known.
const MAX_PASSES: usize = 32;

/// Text of a module, from which the literals of any number of its functions are read at f64.
#[derive(Clone, Debug)]
pub struct Literals {
    source: String,
    /// Values of the module's constants, computed when a literal is first read.
    constants: OnceLock<HashMap<String, ConstantNumber>>,
}

impl Literals {
    /// Literals of a module that naga read from `source`.
    pub fn of(source: impl Into<String>) -> Self {
        Self { source: source.into(), constants: OnceLock::new() }
    }

    /// Text that naga read.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The f64 in the text where naga read `single`; `None` if the text denotes another number.
    pub fn wide(&self, span: Span, single: f32) -> Option<f64> {
        let range = span.to_range()?;
        let mut text = self.source.get(range.clone())?;
        let rest = self.source.get(range.end..)?;
        // For a call, naga keeps the span of its name.
        if text.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
            && rest.trim_start().starts_with('(')
        {
            text = self.source.get(range.start..range.end + end_of_call(rest)?)?;
        }
        if text.len() > MAX_LENGTH {
            return None;
        }
        let constants = self.constants.get_or_init(|| constants(&self.source));
        let number = evaluate(text, constants)?;
        number.agrees_with(single).then_some(number.wide())
    }
}

/// Values of a module's constants that can be read from its text.
fn constants(source: &str) -> HashMap<String, ConstantNumber> {
    let scan = scan(source);
    let constants = scan
        .declarations
        .iter()
        .filter(|declaration| declaration.kind == DeclarationKind::Constant);
    let mut unknown: Vec<(&str, Option<&str>, &str)> = constants
        .filter_map(|declaration| {
            let (head, value) = source.get(declaration.body.clone())?.split_once('=')?;
            let ty = head.split_once(':').map(|(_, ty)| ty.trim());
            Some((declaration.name.as_str(), ty, value.trim_end().trim_end_matches(';')))
        })
        .filter(|(_, _, value)| value.len() <= MAX_LENGTH)
        .collect();
    let mut known = HashMap::new();
    for _ in 0..MAX_PASSES {
        let before = unknown.len();
        unknown.retain(|(name, ty, value)| {
            let number = evaluate(value, &known).and_then(|number| match ty {
                Some("f32") => Some(number.single()),
                None => Some(number),
                Some(_) => None,
            });
            number.map(|number| known.insert((*name).to_owned(), number)).is_none()
        });
        if unknown.len() == before {
            break;
        }
    }
    known
}

/// End of the bracket that opens `text`.
fn end_of_call(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (index, byte) in text.bytes().enumerate().take(MAX_LENGTH) {
        match byte {
            b'(' => depth += 1,
            b')' => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(index + 1);
                }
            }
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wgsl::{NamedSource, PASSES, SHADER_LIBRARY, link, parse, shipped_nodes};

    /// Every f32 literal of a source: its text, naga's value of it, and the f64 that is read again.
    fn literals(source: &str) -> Vec<(String, f32, Option<f64>)> {
        let module = parse(source).unwrap_or_else(|error| panic!("{error}")).module;
        let literals = Literals::of(source);
        let mut found = Vec::new();
        let mut add = |arena: &naga::Arena<naga::Expression>| {
            for (handle, expression) in arena.iter() {
                if let naga::Expression::Literal(naga::Literal::F32(single)) = *expression {
                    let span = arena.get_span(handle);
                    let text = span.to_range().map_or("", |range| &source[range]);
                    found.push((text.to_owned(), single, literals.wide(span, single)));
                }
            }
        };
        add(&module.global_expressions);
        module.functions.iter().for_each(|(_, function)| add(&function.expressions));
        module.entry_points.iter().for_each(|entry| add(&entry.function.expressions));
        found
    }

    #[test]
    fn every_literal_of_the_shipped_shaders_is_read_again() {
        let (mut count, mut widened) = (0, 0);
        let shaders = [PASSES, SHADER_LIBRARY].into_iter().flatten();
        let shaders = shaders.map(|&(name, text)| (name.to_owned(), text.to_owned()));
        for (name, text) in shaders.chain(shipped_nodes()) {
            let linked = link(&[NamedSource { name: &name, text: &text }])
                .unwrap_or_else(|problems| panic!("{problems:?}"));
            for (text, single, wide) in literals(&linked.text) {
                count += 1;
                let wide = wide.unwrap_or_else(|| {
                    panic!("{name}: `{text}` ({single:?}) could not be read again")
                });
                widened += u32::from(wide != f64::from(single));
                let ulp = f64::from(single).abs() * f64::from(f32::EPSILON);
                assert!(
                    (wide - f64::from(single)).abs() <= ulp,
                    "{name}: `{text}` is {single:?}, not {wide:?}"
                );
            }
        }
        assert!(count > 1000 && widened > 300, "{widened} of {count} literals are wider than f32");
    }

    #[test]
    fn constants_are_followed_to_where_they_are_written() {
        let source = "
            const A = B * 3.0;
            const B: f32 = C / 3.0;
            const C = 0.1;
            const V = vec3f(0.1, A, 1.0 / 3.0);
            fn f(x: f32) -> f32 { return x * A + V.y + (vec3f(0.7) * 0.7).x + log(2.0) - 1e-7; }";
        let expected =
            [0.1 / 3.0 * 3.0, 0.1, 0.1 / 3.0 * 3.0, 1.0 / 3.0, 0.7 * 0.7, 2.0_f64.ln(), 1e-7];
        let found: Vec<f64> =
            literals(source).into_iter().filter_map(|(_, _, wide)| wide).collect();
        for x in expected {
            assert!(found.contains(&x), "{x:?} is not among {found:?}");
        }
    }

    #[test]
    fn a_misreading_does_no_harm() {
        let source =
            "const PI: f32 = 3.5; fn f(x: f32) -> f32 { const PI = 0.1; return x * PI * 2.5; }";
        for (text, single, wide) in literals(source) {
            if text.contains("PI") {
                assert_eq!(wide, None, "`{text}` is {single:?}");
            }
        }
    }
}
