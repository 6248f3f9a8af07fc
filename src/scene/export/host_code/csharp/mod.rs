//! C#, as Unity has it: versions 7 and later, for .NET Standard 2.1.
//!
//! The text are members of a static class. Vectors and matrices are structs that the text declares
//! itself ([`types`]), so that nothing is allocated while a game runs; arrays are arrays.

mod scalars;
mod types;
mod whole;

use super::dialect::{
    Dialect, Head, HelperSource, Helpers, Kind, Level, MemberSource, NameOf, Term, ValueType,
    function_head,
};
use super::expressions::result_kind;

/// C#.
pub(super) struct CSharp;

impl Dialect for CSharp {
    fn keywords(&self) -> &'static [&'static str] {
        KEYWORDS
    }

    fn float(&self, value: f64) -> Term {
        Term::float(value, "double.NaN", "double.PositiveInfinity")
    }

    fn integer_ending(&self, kind: Kind) -> &'static str {
        if kind == Kind::Unsigned { "u" } else { "" }
    }

    fn truth(&self, value: bool) -> Term {
        Term::primary(value.to_string())
    }

    fn scalar(
        &self,
        operation: &str,
        kind: Kind,
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term> {
        scalars::scalar(operation, kind, operands, helpers)
    }

    fn typed(
        &self,
        operation: &str,
        types: &[ValueType],
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term> {
        whole::operator(operation, types, operands)
            .or_else(|| whole::function(operation, types, operands, helpers))
            .or_else(|| self.by_components(operation, types, operands, helpers))
    }

    fn list(&self, items: &[Term], ty: &ValueType) -> Term {
        let items: Vec<&str> = items.iter().map(|item| item.text.as_str()).collect();
        Term::primary(match ty {
            ValueType::Array(..) => format!("new {} {{ {} }}", self.ty(ty), items.join(", ")),
            _ => format!("new {}({})", self.ty(ty), items.join(", ")),
        })
    }

    fn repeated(&self, item: &Term, count: usize) -> Term {
        // Only zeros are repeated, which arrays have from the beginning.
        let word = match item.text.as_str() {
            "0.0" => "double",
            "0u" => "uint",
            "false" => "bool",
            _ => "int",
        };
        Term::primary(format!("new {word}[{count}]"))
    }

    fn splat(&self, value: &Term, ty: &ValueType) -> Option<Term> {
        Some(Term::primary(format!("new {}({})", self.ty(ty), value.text)))
    }

    fn structure(&self, name: &str, members: &[(String, Term)]) -> Term {
        let member = |(name, term): &(String, Term)| format!("{name} = {}", term.text);
        let members: Vec<String> = members.iter().map(member).collect();
        Term::primary(format!("new {name} {{ {} }}", members.join(", ")))
    }

    fn part(&self, base: &Term, index: usize, ty: &ValueType) -> Term {
        let base = base.at(Level::Primary);
        // `new` would take what comes after it into itself.
        let base = if base.starts_with("new ") { format!("({base})") } else { base };
        Term::primary(match ty {
            ValueType::Vector(..) => format!("{base}.{}", types::AXES[index.min(3)]),
            ValueType::Matrix(..) => format!("{base}.c{index}"),
            _ => format!("{base}[{index}]"),
        })
    }

    fn copy(&self, value: &Term, ty: &ValueType) -> Term {
        match ty {
            ValueType::Array(..) => {
                Term::primary(format!("({}){}.Clone()", self.ty(ty), value.at(Level::Primary)))
            }
            _ => value.clone(),
        }
    }

    fn each(&self, _: &str, _: usize, _: [Kind; 2], _: &str) -> String {
        // `typed` writes operations of vectors.
        String::new()
    }

    fn helpers(&self) -> &'static [HelperSource] {
        scalars::HELPERS
    }

    fn ty(&self, ty: &ValueType) -> String {
        match ty {
            ValueType::Scalar(kind) => types::word(*kind).to_owned(),
            ValueType::Vector(count, kind) => format!("{}{count}", types::vector_word(*kind)),
            ValueType::Matrix(columns, rows) => format!("Double{rows}x{columns}"),
            ValueType::Array(_, element) => format!("{}[]", self.ty(element)),
            ValueType::Struct(name) => self.styled(name, NameOf::Structure),
        }
    }

    fn types_of(&self, text: &str) -> String {
        types::declarations(text)
    }

    fn styled(&self, name: &str, of: NameOf) -> String {
        match of {
            NameOf::Function | NameOf::Structure | NameOf::Constant => pascal(name),
            NameOf::Member | NameOf::Value => {
                let pascal = pascal(name);
                let (first, rest) = pascal.split_at(1);
                let name = first.to_ascii_lowercase() + rest;
                if KEYWORDS.contains(&name.as_str()) { name + "_" } else { name }
            }
        }
    }

    fn declare(&self, name: &str, ty: &ValueType, value: &Term, _: bool) -> String {
        format!("{} {name} = {};", self.ty(ty), value.text)
    }

    fn open(&self, head: &Head<'_>) -> String {
        match head {
            Head::If(condition) => format!("if ({})\n{{", condition.text),
            Head::Else => "}\nelse\n{".to_owned(),
            Head::ElseIf(condition) => format!("}}\nelse if ({})\n{{", condition.text),
            Head::While(condition) => format!("while ({})\n{{", condition.text),
            Head::Forever => "while (true)\n{".to_owned(),
            Head::Function { name, parameters, result } => {
                let parameters: Vec<String> =
                    parameters.iter().map(|(name, ty)| format!("{} {name}", self.ty(ty))).collect();
                let start = format!("public static {} {name}", self.ty(result));
                function_head(&start, &parameters, 96) + "\n{"
            }
        }
    }

    fn around_members(&self, name: &str) -> Option<(String, &'static str)> {
        Some((format!("public struct {name}\n{{"), "}"))
    }

    fn declare_member(&self, member: &MemberSource) -> String {
        format!("public {} {};", self.ty(&member.ty), member.name)
    }

    fn constant(&self, name: &str, ty: &ValueType, value: &Term) -> String {
        let kind = if ty.is_composite() { "static readonly" } else { "const" };
        format!("{kind} {} {name} = {};", self.ty(ty), value.text)
    }

    fn doc(&self, lines: &[String]) -> Vec<String> {
        let escaped = |line: &String| {
            line.trim().replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
        };
        let lines: Vec<String> = lines.iter().map(escaped).collect();
        match &lines[..] {
            [] => Vec::new(),
            [line] => vec![format!("/// <summary>{line}</summary>")],
            [first, middle @ .., last] => {
                let mut text = vec![format!("/// <summary>{first}")];
                text.extend(middle.iter().map(|line| format!("/// {line}").trim_end().to_owned()));
                text.push(format!("/// {last}</summary>"));
                text
            }
        }
    }
}

impl CSharp {
    /// An operation of scalars on each component, as a function of vectors of one length.
    fn by_components(
        &self,
        operation: &str,
        types: &[ValueType],
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term> {
        let vector = types.iter().find_map(|ty| match ty {
            ValueType::Vector(count, _) => Some(*count),
            _ => None,
        });
        let count = vector?;
        let kind_of = |ty: &ValueType| match ty {
            ValueType::Scalar(kind) | ValueType::Vector(_, kind) => *kind,
            _ => Kind::Float,
        };
        let deciding = if operation == "select" { types.get(1)? } else { types.first()? };
        let kind = kind_of(deciding);
        let names = &["x", "y", "z"][..operands.len().min(3)];
        let places: Vec<Term> = names.iter().map(|name| Term::primary(*name)).collect();
        let body = self.scalar(operation, kind, &places, helpers)?.text;
        let result = self.ty(&ValueType::Vector(count, result_kind(operation, kind)));
        let name = function_of(operation);
        let vectors = types.iter().map(|ty| ValueType::Vector(count, kind_of(ty)));
        let vectors: Vec<ValueType> = vectors.collect();
        let parameters: Vec<String> =
            vectors.iter().zip(names).map(|(ty, name)| format!("{} {name}", self.ty(ty))).collect();
        let items: Vec<String> = types::AXES[..count]
            .iter()
            .map(|axis| {
                let is_name = |name: &str| names.contains(&name);
                crate::wgsl::rename_identifiers(&body, |name| {
                    is_name(name).then(|| format!("{name}.{axis}"))
                })
            })
            .collect();
        let parameters = parameters.join(", ");
        let source = format!(
            "static {result} {name}({parameters}) =>\n    new {result}({});\n",
            items.join(", ")
        );
        helpers.made.insert(format!("{name} {parameters}"), source);
        let operands: Vec<Term> = operands
            .iter()
            .zip(types)
            .zip(&vectors)
            .map(|((term, ty), vector)| match ty {
                ValueType::Vector(..) => term.clone(),
                _ => Term::primary(format!("new {}({})", self.ty(vector), term.text)),
            })
            .collect();
        Some(Term::call(&name, &operands))
    }
}

/// Name of the function that runs an operation on each component.
fn function_of(operation: &str) -> String {
    let word = match operation {
        "/" => "divide",
        "%" => "remainder",
        "==" => "equal",
        "!=" => "not_equal",
        "<" => "less",
        "<=" => "less_equal",
        ">" => "greater",
        ">=" => "greater_equal",
        "&" | "&&" => "and",
        "|" | "||" => "or",
        "^" => "exclusive_or",
        "<<" => "shift_left",
        ">>" => "shift_right",
        "!" | "~" => "not",
        "to_float" => "to_double",
        "inversesqrt" => "inverse_sqrt",
        "smoothstep" => "smooth_step",
        other => other,
    };
    pascal(word)
}

/// A name of several words, each with a capital: `light_in_world` and `LIGHT_IN_WORLD` are
/// `LightInWorld`. A number keeps its `_`, so that no two names become one.
fn pascal(name: &str) -> String {
    let is_loud = name.len() > 1 && !name.contains(|c: char| c.is_ascii_lowercase());
    let mut result = String::new();
    for word in name.split('_').filter(|word| !word.is_empty()) {
        let word = if is_loud { word.to_ascii_lowercase() } else { word.to_owned() };
        let (first, rest) = word.split_at(word.chars().next().map_or(0, char::len_utf8));
        if first.starts_with(|c: char| c.is_ascii_digit()) {
            result.push('_');
        }
        result += &first.to_ascii_uppercase();
        result += rest;
    }
    if name.ends_with('_') || result.is_empty() {
        result.push('_');
    }
    result
}

/// Words of the language, and the names that the text gives to functions of its own.
const KEYWORDS: &[&str] = &[
    "abstract",
    "as",
    "base",
    "bool",
    "break",
    "byte",
    "case",
    "catch",
    "char",
    "checked",
    "class",
    "const",
    "continue",
    "decimal",
    "default",
    "delegate",
    "do",
    "double",
    "else",
    "enum",
    "event",
    "explicit",
    "extern",
    "false",
    "finally",
    "fixed",
    "float",
    "for",
    "foreach",
    "goto",
    "if",
    "implicit",
    "in",
    "int",
    "interface",
    "internal",
    "is",
    "lock",
    "long",
    "namespace",
    "new",
    "null",
    "object",
    "operator",
    "out",
    "override",
    "params",
    "private",
    "protected",
    "public",
    "readonly",
    "ref",
    "return",
    "sbyte",
    "sealed",
    "short",
    "sizeof",
    "stackalloc",
    "static",
    "string",
    "struct",
    "switch",
    "this",
    "throw",
    "true",
    "try",
    "typeof",
    "uint",
    "ulong",
    "unchecked",
    "unsafe",
    "ushort",
    "using",
    "virtual",
    "void",
    "volatile",
    "while",
    "var",
    "Math",
    "BitConverter",
    "Array",
    "Dot",
    "Cross",
    "Length",
    "Distance",
    "Normalize",
    "Reflect",
    "Transpose",
    "Multiply",
    "Add",
    "Subtract",
    "All",
    "Any",
    "Min",
    "Max",
    "Clamp",
    "Saturate",
    "Fract",
    "Radians",
    "Degrees",
    "Round",
    "Pow",
    "Mix",
    "Step",
    "SmoothStep",
    "Fma",
    "Sign",
    "ToInt",
    "ToUInt",
    "DivideInt",
    "DivideUInt",
    "RemainderInt",
    "RemainderUInt",
    "CountOneBits",
    "CountLeadingZeros",
    "Select",
    "Abs",
    "Floor",
    "Ceil",
    "Sin",
    "Cos",
    "Tan",
    "Exp",
    "Log",
    "Sqrt",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_language() {
        assert_eq!(pascal("light_in_world"), "LightInWorld");
        assert_eq!(pascal("DIRECTIONAL_LIGHT"), "DirectionalLight");
        assert_eq!(pascal("LightFrame"), "LightFrame");
        assert_eq!(pascal("track_0"), "Track_0");
        assert_eq!(CSharp.styled("own_from_world", NameOf::Member), "ownFromWorld");
        assert_eq!(CSharp.styled("base", NameOf::Value), "base_");
        assert_ne!(CSharp.styled("key_1", NameOf::Member), CSharp.styled("key1", NameOf::Member));
    }
}
