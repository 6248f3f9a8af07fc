//! Remainders of negative numbers, which GLSL leaves undefined.
//!
//! In WGSL `a % b` has the sign of a. In GLSL it has no meaning where a or b is below 0: OpenGL of
//! Mesa, for one, gives other numbers then. The source is rewritten before naga translates it:
//! remainders of numbers that may be below 0 become calls of a function that divides, and those of
//! numbers that cannot be, such as counts of a loop, stay as they are.

mod ranges;

use std::collections::{BTreeMap, BTreeSet};

use naga::{BinaryOperator, Expression, ScalarKind, TypeInner};

use crate::wgsl::{ValidModule, identifiers, parse};
use ranges::Ranges;

/// A module whose remainders GLSL defines.
pub(super) struct DefinedRemainders {
    /// The WGSL of the module.
    pub(super) wgsl: String,
    /// naga's form of the WGSL.
    pub(super) valid: ValidModule,
}

impl DefinedRemainders {
    /// The module of a source; `None` where its remainders are defined as they are.
    ///
    /// # Errors
    /// The error of naga for a source that it refuses.
    pub(super) fn of(source: &str) -> Result<Option<Self>, String> {
        if !source.contains('%') {
            return Ok(None);
        }
        let valid = parse(source).map_err(|error| error.to_string())?;
        let mut edits = Edits::of(source);
        for (handle, function) in valid.module.functions.iter() {
            edits.add(source, &valid, function, &valid.info[handle]);
        }
        for (index, point) in valid.module.entry_points.iter().enumerate() {
            edits.add(source, &valid, &point.function, valid.info.get_entry_point(index));
        }
        if edits.inserted.is_empty() {
            return Ok(None);
        }
        let wgsl = edits.applied(source);
        let valid = parse(&wgsl).map_err(|error| error.to_string())?;
        Ok(Some(Self { wgsl, valid }))
    }
}

/// Changes of a source.
struct Edits {
    /// Texts by the place where they are put in, each with the bytes that it takes the place of.
    inserted: BTreeMap<usize, Vec<(usize, String)>>,
    /// Name of the function that divides, without what tells of its type.
    name: String,
    /// Components of the types that the function is needed for, 1 for numbers.
    sizes: BTreeSet<u8>,
}

impl Edits {
    fn of(source: &str) -> Self {
        let mut name = "signed_remainder".to_owned();
        while identifiers(source).iter().any(|word| word.starts_with(&name)) {
            name.push('_');
        }
        Self { inserted: BTreeMap::new(), name, sizes: BTreeSet::new() }
    }

    /// Adds the changes of a function.
    fn add(
        &mut self,
        source: &str,
        valid: &ValidModule,
        function: &naga::Function,
        info: &naga::valid::FunctionInfo,
    ) {
        let module = &valid.module;
        let ranges = Ranges::of(module, function);
        for (handle, expression) in function.expressions.iter() {
            let Expression::Binary { op: BinaryOperator::Modulo, left, right: right_handle } =
                *expression
            else {
                continue;
            };
            let size = match *info[handle].ty.inner_with(&module.types) {
                TypeInner::Scalar(scalar) if scalar.kind == ScalarKind::Sint => 1,
                TypeInner::Vector { size, scalar } if scalar.kind == ScalarKind::Sint => size as u8,
                _ => continue,
            };
            if ranges.is_never_negative(left) && ranges.is_never_negative(right_handle) {
                continue;
            }
            let span = function.expressions.get_span(handle).to_range();
            let Some((span, sign)) =
                span.and_then(|span| Some((span.clone(), sign_within(&source[span])?)))
            else {
                continue;
            };
            self.sizes.insert(size);
            let name = function_name(&self.name, size);
            let sign = span.start + sign;
            let right = source[sign + 1..].trim_start();
            // A number for all components is written out as a vector.
            let is_splat = matches!(function.expressions[right_handle], Expression::Splat { .. });
            let told = right.trim_start_matches(['=', ' ']).strip_prefix(&format!("vec{size}"));
            let is_vector = told.is_some_and(|rest| rest.starts_with(['i', '<', '(']));
            let (open, close) = match is_splat && size > 1 && !is_vector {
                true => (format!("vec{size}i("), "))"),
                false => (String::new(), ")"),
            };
            if let Some(right) = right.strip_prefix('=') {
                // `a %= b`, in which a is a place without calls.
                let place = source[span.start..sign].trim();
                let end = span.end - usize::from(source[span.clone()].ends_with(';'));
                let replaced = source.len() - right.trim_start().len() - sign;
                self.put(sign, replaced, format!("= {name}({place}, {open}"));
                self.put(end, 0, close.to_owned());
            } else {
                self.put_first(span.start, format!("{name}("));
                let before = source[..sign].trim_end().len();
                self.put(before, source.len() - right.len() - before, format!(", {open}"));
                self.put(span.end, 0, close.to_owned());
            }
        }
    }

    fn put(&mut self, at: usize, replaced: usize, text: String) {
        self.inserted.entry(at).or_default().push((replaced, text));
    }

    /// Puts a text before others at the same place: the outer call is written before the inner.
    fn put_first(&mut self, at: usize, text: String) {
        self.inserted.entry(at).or_default().insert(0, (0, text));
    }

    /// The source with the changes, and the functions that it needs.
    fn applied(&self, source: &str) -> String {
        let mut result = String::with_capacity(source.len() + 256);
        let mut from = 0;
        for (at, texts) in &self.inserted {
            result.push_str(&source[from..*at]);
            from = *at;
            for (replaced, text) in texts {
                result.push_str(text);
                from += replaced;
            }
        }
        result.push_str(&source[from..]);
        for size in &self.sizes {
            let ty = match size {
                1 => "i32".to_owned(),
                size => format!("vec{size}i"),
            };
            result += &format!(
                "\n/// a % b with the sign of a, where GLSL defines none for numbers below 0.\n\
                 fn {}(a: {ty}, b: {ty}) -> {ty} {{\n    return a - a / b * b;\n}}\n",
                function_name(&self.name, *size)
            );
        }
        result
    }
}

/// Name of the function for a type.
fn function_name(name: &str, size: u8) -> String {
    match size {
        1 => name.to_owned(),
        size => format!("{name}_vec{size}"),
    }
}

/// Place of the last `%` of an expression that no brackets enclose.
fn sign_within(expression: &str) -> Option<usize> {
    let (mut depth, mut found) = (0_i32, None);
    for (at, c) in expression.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            '%' if depth == 0 => found = Some(at),
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn defined(body: &str) -> Option<String> {
        let source = format!("fn f(a: i32, v: vec2i, w: vec2f) -> vec2i {{\n{body}\n}}\n");
        let made = DefinedRemainders::of(&source).expect("a module");
        made.map(|made| made.wgsl.split_once("\n}").expect("a body").0.to_owned())
    }

    fn body(text: &str) -> Option<String> {
        defined(text).map(|text| text.split_once('\n').expect("a head").1.to_owned())
    }

    #[test]
    fn remainders_of_what_may_be_negative_are_divided() {
        for (given, wanted) in [
            ("return v % vec2i(3);", "return signed_remainder_vec2(v, vec2i(3));"),
            ("return v % 3;", "return signed_remainder_vec2(v, vec2i(3));"),
            (
                "return ((v % vec2i(3)) + vec2i(3)) % vec2i(3);",
                "return ((signed_remainder_vec2(v, vec2i(3))) + vec2i(3)) % vec2i(3);",
            ),
            (
                "return vec2i(a * 2 % 7 % (a % 5));",
                "return vec2i(signed_remainder(signed_remainder(a * 2, 7), \
                 (signed_remainder(a, 5))));",
            ),
            (
                "var b = a;\n    b %= 4;\n    return vec2i(b);",
                "var b = a;\n    b = signed_remainder(b, 4);\n    return vec2i(b);",
            ),
        ] {
            assert_eq!(body(given).as_deref(), Some(wanted), "{given}");
        }
    }

    #[test]
    fn remainders_of_what_is_never_negative_stay() {
        for given in [
            "return vec2i(w % vec2f(3.0));",
            "return vec2i(vec2u(v) % vec2u(3u));",
            "var s = v;\n    for (var i = 0; i < 9; i++) {\n        \
             s += vec2i(i % 3, i / 3 % 2);\n    }\n    return s;",
        ] {
            assert_eq!(body(given), None, "{given}");
        }
        let counts_down = "var s = v;\n    for (var i = 9; i > -9; i--) {\n        \
                           s.x += i % 3;\n    }\n    return s;";
        assert!(body(counts_down).is_some_and(|text| text.contains("signed_remainder(i, 3)")));
    }
}
