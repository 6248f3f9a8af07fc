//! The artist's names, made legal and unique in WGSL.

use std::collections::HashSet;

/// Words that no identifier may be: WGSL's keywords and reserved words that an artist could think
/// of, its types and builtin functions (which may be shadowed, but would mislead), and the names
/// that the generated frame uses.
const TAKEN: &[&str] = &[
    "abs",
    "acos",
    "acosh",
    "alias",
    "all",
    "any",
    "array",
    "as",
    "asin",
    "asinh",
    "asm",
    "async",
    "atan",
    "atan2",
    "atanh",
    "atomic",
    "attribute",
    "auto",
    "await",
    "become",
    "bitcast",
    "bool",
    "break",
    "case",
    "cast",
    "catch",
    "ceil",
    "clamp",
    "class",
    "const",
    "const_assert",
    "continue",
    "continuing",
    "cos",
    "cosh",
    "cross",
    "default",
    "degrees",
    "delete",
    "determinant",
    "diagnostic",
    "discard",
    "distance",
    "do",
    "dot",
    "dpdx",
    "dpdy",
    "else",
    "enable",
    "enum",
    "exp",
    "exp2",
    "export",
    "extends",
    "extern",
    "external",
    "f16",
    "f32",
    "fallthrough",
    "false",
    "filter",
    "final",
    "finally",
    "floor",
    "fma",
    "fn",
    "for",
    "fract",
    "friend",
    "from",
    "fs_main",
    "fwidth",
    "get",
    "goto",
    "highp",
    "i32",
    "if",
    "impl",
    "implements",
    "import",
    "in",
    "inline",
    "interface",
    "inverse",
    "layout",
    "ldexp",
    "length",
    "let",
    "log",
    "log2",
    "look",
    "loop",
    "lowp",
    "macro",
    "match",
    "max",
    "mediump",
    "meta",
    "min",
    "mix",
    "mod",
    "modf",
    "module",
    "move",
    "mut",
    "namespace",
    "new",
    "nil",
    "noexcept",
    "normalize",
    "null",
    "object",
    "of",
    "operator",
    "override",
    "package",
    "packed",
    "pass",
    "patch",
    "pow",
    "precise",
    "precision",
    "premerge",
    "priv",
    "private",
    "protected",
    "ptr",
    "pub",
    "public",
    "radians",
    "readonly",
    "ref",
    "reflect",
    "refract",
    "regardless",
    "register",
    "requires",
    "resource",
    "restrict",
    "return",
    "round",
    "sampler",
    "saturate",
    "select",
    "self",
    "set",
    "shade",
    "shared",
    "sign",
    "sin",
    "sinh",
    "smooth",
    "smoothstep",
    "sqrt",
    "static",
    "step",
    "storage",
    "struct",
    "super",
    "surface",
    "switch",
    "tan",
    "tanh",
    "target",
    "template",
    "texture_2d",
    "this",
    "throw",
    "trait",
    "transpose",
    "true",
    "trunc",
    "try",
    "type",
    "typedef",
    "u32",
    "uniform",
    "union",
    "unless",
    "unorm",
    "using",
    "var",
    "varying",
    "vec2f",
    "vec3f",
    "vec4f",
    "view",
    "virtual",
    "volatile",
    "vs_main",
    "wgsl",
    "where",
    "while",
    "with",
    "workgroup",
    "writeonly",
    "yield",
];

/// Gives out names, each once.
#[derive(Debug, Default)]
pub(super) struct Names {
    used: HashSet<String>,
}

impl Names {
    /// Keeps `name` from being given out.
    pub(super) fn reserve(&mut self, name: &str) {
        self.used.insert(name.to_owned());
    }

    /// `wanted` itself, or with a number behind it where it was given out before. For names that
    /// are legal already.
    pub(super) fn give_exact(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut number = 2u64;
        while !self.used.insert(name.clone()) {
            name = format!("{wanted}_{number}");
            number += 1;
        }
        name
    }

    /// A legal, unused identifier that reads like `wanted`: `"Rim light!"` becomes `rim_light`,
    /// then `rim_light_2`.
    pub(super) fn give(&mut self, wanted: &str) -> String {
        let name = identifier(wanted);
        let is_free = |name: &str| !self.used.contains(name) && TAKEN.binary_search(&name).is_err();
        let name = if is_free(&name) {
            name
        } else {
            (2u64..).map(|n| format!("{name}_{n}")).find(|name| is_free(name)).unwrap_or(name)
        };
        self.used.insert(name.clone());
        name
    }
}

/// Part of a name that WGSL allows. Letters of other scripts are kept out too: GLSL and HLSL do
/// not take them.
fn identifier(wanted: &str) -> String {
    let mut name = String::new();
    for c in wanted.chars() {
        match c {
            'a'..='z' | '0'..='9' => name.push(c),
            'A'..='Z' => name.push(c.to_ascii_lowercase()),
            _ if name.is_empty() || name.ends_with('_') => {}
            _ => name.push('_'),
        }
        if name.len() >= 48 {
            break;
        }
    }
    let name = name.trim_end_matches('_');
    match name.bytes().next() {
        None => "value".to_owned(),
        Some(b'0'..=b'9') => format!("n{name}"),
        // GLSL keeps `gl_` for itself.
        Some(_) if name.starts_with("gl_") => format!("n_{name}"),
        Some(_) => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_legal_and_unique() {
        let mut names = Names::default();
        assert_eq!(names.give("Rim light!"), "rim_light");
        assert_eq!(names.give("rim LIGHT"), "rim_light_2");
        assert_eq!(names.give("mix"), "mix_2");
        assert_eq!(names.give("2 tone"), "n2_tone");
        assert_eq!(names.give("影"), "value");
        assert_eq!(names.give("a__b"), "a_b");
    }

    #[test]
    fn the_words_are_sorted() {
        assert!(TAKEN.is_sorted());
    }
}
