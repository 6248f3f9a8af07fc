//! The Open Shading Language, in which renderers take shaders: Cycles, Arnold, RenderMan.
//!
//! Vectors of three are the language's own `vector`, those of two and four the structs of
//! `vector2.h` and `vector4.h`, which come with it; truth values of vectors are 0 and 1 in these.
//! Integers have signs, constants are macros, for there are no global ones, and a part can only be
//! taken of what has a name.

mod helpers;
mod makers;
mod operations;

use super::dialect::{
    Dialect, Head, HelperSource, Helpers, Kind, Level, MemberSource, NameOf, Term, ValueType,
    function_head,
};

pub(in super::super) use helpers::with_preamble;

/// The Open Shading Language.
pub(super) struct Osl;

/// Components of `vector2` and `vector4`, and of the structs of integers.
const AXES: [&str; 4] = ["x", "y", "z", "w"];

impl Dialect for Osl {
    fn keywords(&self) -> &'static [&'static str] {
        KEYWORDS
    }

    #[expect(clippy::cast_possible_truncation, reason = "floats of the language have 32 bits")]
    fn float(&self, value: f64) -> Term {
        let single = value as f32;
        let text = format!("{:?}", single.abs());
        if single.is_sign_negative() {
            Term::new(format!("-{text}"), Level::Unary)
        } else {
            Term::primary(text)
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "the bits are the same in 32 bits")]
    fn integer(&self, value: i64, _: Kind) -> Term {
        let signed = value as i32;
        match signed {
            // The least one has no digits of its own.
            i32::MIN => Term::new("-2147483647 - 1", Level::Sum),
            _ if signed < 0 => Term::new(signed.to_string(), Level::Unary),
            _ => Term::primary(signed.to_string()),
        }
    }

    fn truth(&self, value: bool) -> Term {
        Term::primary(if value { "1" } else { "0" })
    }

    fn scalar(
        &self,
        operation: &str,
        kind: Kind,
        operands: &[Term],
        _: &mut Helpers,
    ) -> Option<Term> {
        operations::scalar(operation, kind, operands)
    }

    fn typed(
        &self,
        operation: &str,
        types: &[ValueType],
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term> {
        operations::whole(operation, types, operands)
            .or_else(|| operations::of_matrices(operation, types, operands, helpers))
            .or_else(|| operations::by_components(operation, types, operands, helpers))
    }

    fn choice(
        &self,
        types: &[ValueType],
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term> {
        operations::choice(types, operands, helpers)
    }

    fn takes_parts_of_results(&self) -> bool {
        false
    }

    fn list(&self, items: &[Term], ty: &ValueType) -> Term {
        let texts: Vec<&str> = items.iter().map(|item| item.text.as_str()).collect();
        let first = texts.first().copied().unwrap_or_default();
        match ty {
            ValueType::Array(..) => Term::primary(format!("{{{}}}", texts.join(", "))),
            ValueType::Vector(3, Kind::Float | Kind::Bool) => {
                let named = |ends: [&str; 3]| {
                    let base = first.strip_suffix(ends[0])?;
                    let is_same = |(text, end): (&&str, &str)| text.strip_suffix(end) == Some(base);
                    texts.iter().zip(ends).all(is_same).then_some(base)
                };
                if let Some(base) = named(["[0]", "[1]", "[2]"]) {
                    return Term::primary(base);
                }
                if let Some(base) = named([".x", ".y", ".z"]) {
                    return Term::primary(format!("xyz({base})"));
                }
                if texts.iter().all(|text| *text == first) {
                    return Term::primary(format!("vector({first})"));
                }
                Term::call("vector", items)
            }
            _ => Term::call(&self.ty(ty), items),
        }
    }

    fn repeated(&self, item: &Term, count: usize) -> Term {
        Term::primary(format!("{{{}}}", vec![item.text.as_str(); count].join(", ")))
    }

    fn splat(&self, value: &Term, ty: &ValueType) -> Option<Term> {
        let is_own = *ty == ValueType::Vector(3, Kind::Float);
        is_own.then(|| Term::primary(format!("vector({})", value.text)))
    }

    fn structure(&self, name: &str, members: &[(String, Term)]) -> Term {
        let members: Vec<Term> = members.iter().map(|(_, term)| term.clone()).collect();
        Term::call(name, &members)
    }

    fn part(&self, base: &Term, index: usize, ty: &ValueType) -> Term {
        let base = base.at(Level::Primary);
        match ty {
            ValueType::Vector(count, kind) => {
                let is_own = *count == 3 && matches!(kind, Kind::Float | Kind::Bool);
                let part = match is_own {
                    true => format!("{base}[{index}]"),
                    false => format!("{base}.{}", AXES[index.min(3)]),
                };
                match kind {
                    Kind::Bool => Term::new(format!("(int){part}"), Level::Unary),
                    _ => Term::primary(part),
                }
            }
            ValueType::Matrix(..) => Term::primary(format!("{base}.c{index}")),
            _ => Term::primary(format!("{base}[{index}]")),
        }
    }

    fn component(&self, base: &Term, index: &Term, ty: &ValueType) -> Term {
        match ty {
            ValueType::Vector(3, Kind::Float) => self.element(base, index),
            _ => Term::call("component", &[base.clone(), index.clone()]),
        }
    }

    fn copy(&self, value: &Term, _: &ValueType) -> Term {
        value.clone()
    }

    fn each(&self, _: &str, _: usize, _: [Kind; 2], _: &str) -> String {
        // `typed` writes operations of vectors.
        String::new()
    }

    fn helpers(&self) -> &'static [HelperSource] {
        // `preamble` has them.
        &[]
    }

    fn ty(&self, ty: &ValueType) -> String {
        match ty {
            ValueType::Scalar(Kind::Float) => "float".to_owned(),
            ValueType::Scalar(_) => "int".to_owned(),
            ValueType::Vector(3, Kind::Float | Kind::Bool) => "vector".to_owned(),
            ValueType::Vector(count, Kind::Float | Kind::Bool) => format!("vector{count}"),
            ValueType::Vector(count, _) => format!("Int{count}"),
            ValueType::Matrix(3, 3) => "Matrix3".to_owned(),
            ValueType::Matrix(columns, rows) => format!("Matrix{columns}x{rows}"),
            ValueType::Array(_, element) => self.ty(element),
            ValueType::Struct(name) => self.styled(name, NameOf::Structure),
        }
    }

    fn styled(&self, name: &str, of: NameOf) -> String {
        match of {
            // Macros reach into everything that is called like them.
            NameOf::Constant => name.to_ascii_uppercase(),
            NameOf::Member if KEYWORDS.contains(&name) => format!("{name}_"),
            _ => name.to_owned(),
        }
    }

    fn declare(&self, name: &str, ty: &ValueType, value: &Term, _: bool) -> String {
        let declared = declared(name, ty);
        // An array is set to a list where it is declared, to another array afterwards.
        let is_array = matches!(ty, ValueType::Array(..)) && !value.text.starts_with('{');
        if is_array {
            return format!("{declared};\n{name} = {};", value.text);
        }
        format!("{declared} = {};", value.text)
    }

    fn declare_empty(&self, name: &str, ty: &ValueType) -> Option<String> {
        matches!(ty, ValueType::Struct(_)).then(|| format!("{};", declared(name, ty)))
    }

    fn open(&self, head: &Head<'_>) -> String {
        match head {
            Head::If(condition) => format!("if ({}) {{", condition.text),
            Head::Else => "} else {".to_owned(),
            Head::ElseIf(condition) => format!("}} else if ({}) {{", condition.text),
            Head::While(condition) => format!("while ({}) {{", condition.text),
            Head::Forever => "while (1) {".to_owned(),
            Head::Function { name, parameters, result } => {
                let parameters: Vec<String> =
                    parameters.iter().map(|(name, ty)| declared(name, ty)).collect();
                function_head(&format!("{} {name}", self.ty(result)), &parameters, 100) + "\n{"
            }
        }
    }

    fn around_members(&self, name: &str) -> Option<(String, &'static str)> {
        Some((format!("struct {name} {{"), "};"))
    }

    fn declare_member(&self, member: &MemberSource) -> String {
        format!("{};", declared(&member.name, &member.ty))
    }

    fn constant(&self, name: &str, _: &ValueType, value: &Term) -> String {
        format!("#define {name} {}", value.at(Level::Primary))
    }

    fn doc(&self, lines: &[String]) -> Vec<String> {
        lines.iter().map(|line| format!("// {line}").trim_end().to_owned()).collect()
    }
}

/// A name with its type, as declarations have it.
fn declared(name: &str, ty: &ValueType) -> String {
    match ty {
        ValueType::Array(count, _) => format!("{} {name}[{count}]", Osl.ty(ty)),
        _ => format!("{} {name}", Osl.ty(ty)),
    }
}

/// Words of the language, and names that its headers and the text's own helpers take.
const KEYWORDS: &[&str] = &[
    // Types and statements.
    "and",
    "break",
    "catch",
    "char",
    "class",
    "closure",
    "color",
    "const",
    "continue",
    "default",
    "delete",
    "displacement",
    "do",
    "double",
    "else",
    "emit",
    "enum",
    "extern",
    "false",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "illuminance",
    "illuminate",
    "inline",
    "int",
    "long",
    "matrix",
    "new",
    "normal",
    "not",
    "operator",
    "or",
    "output",
    "point",
    "private",
    "protected",
    "public",
    "return",
    "shader",
    "short",
    "signed",
    "sizeof",
    "static",
    "string",
    "struct",
    "surface",
    "switch",
    "template",
    "this",
    "throw",
    "true",
    "try",
    "typedef",
    "uniform",
    "union",
    "unsigned",
    "varying",
    "vector",
    "virtual",
    "void",
    "volatile",
    "volume",
    "while",
    // Structs and functions of headers.
    "vector2",
    "vector4",
    "color2",
    "color4",
    "matrix33",
    "abs",
    "acos",
    "aastep",
    "area",
    "arraylength",
    "asin",
    "atan",
    "atan2",
    "background",
    "backfacing",
    "bevel",
    "blackbody",
    "bump",
    "calculatenormal",
    "cbrt",
    "ceil",
    "cell",
    "cellnoise",
    "clamp",
    "concat",
    "cos",
    "cosh",
    "cross",
    "debug",
    "degrees",
    "determinant",
    "dict_find",
    "diffuse",
    "displace",
    "distance",
    "dot",
    "emission",
    "endswith",
    "erf",
    "erfc",
    "error",
    "exit",
    "exp",
    "exp2",
    "expm1",
    "fabs",
    "faceforward",
    "filterwidth",
    "floor",
    "fmod",
    "format",
    "fprintf",
    "fresnel",
    "getattribute",
    "getchar",
    "getmatrix",
    "getmessage",
    "getspline",
    "gettextureinfo",
    "hair",
    "hash",
    "hashnoise",
    "holdout",
    "hypot",
    "inversesqrt",
    "isconnected",
    "isconstant",
    "isfinite",
    "isinf",
    "isnan",
    "length",
    "linearstep",
    "log",
    "log10",
    "log2",
    "logb",
    "luminance",
    "max",
    "microfacet",
    "min",
    "mix",
    "mod",
    "noise",
    "normalize",
    "object_id",
    "phong",
    "pnoise",
    "pointcloud_get",
    "pow",
    "printf",
    "psnoise",
    "radians",
    "random",
    "raytype",
    "reflect",
    "reflection",
    "refract",
    "refraction",
    "regex_match",
    "rotate",
    "round",
    "select",
    "setmessage",
    "sheen",
    "sign",
    "sin",
    "sincos",
    "sinh",
    "smooth_linearstep",
    "smoothstep",
    "snoise",
    "spline",
    "splineinverse",
    "sqrt",
    "startswith",
    "step",
    "stoi",
    "strlen",
    "substr",
    "subsurface",
    "surfacearea",
    "tan",
    "tanh",
    "texture",
    "texture3d",
    "trace",
    "transform",
    "transformc",
    "transformu",
    "translucent",
    "transparent",
    "trunc",
    "velvet",
    "ward",
    "warning",
    "wavelength_color",
    // Values of the point that is shaded.
    "Ci",
    "Dx",
    "Dy",
    "Dz",
    "I",
    "L",
    "N",
    "Ng",
    "P",
    "Ps",
    "dPdtime",
    "dPdu",
    "dPdv",
    "dtime",
    "dtimedt",
    "time",
    // Helpers and the names of the shader around.
    "Alpha",
    "Color",
    "Int2",
    "Int3",
    "Int4",
    "Matrix3",
    "BSDF",
    "UV",
    "all",
    "any",
    "choose",
    "component",
    "divide_unsigned",
    "float_of_unsigned",
    "fract",
    "fwidth",
    "is_below",
    "light_of_shown",
    "multiply",
    "radius",
    "middle",
    "frame",
    "remainder_unsigned",
    "shift_right",
    "shown_of_light",
    "to_y_up",
    "transpose",
    "unsigned_of_float",
    "xyz",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_parts_are_those_of_the_language() {
        assert_eq!(Osl.float(-0.1).text, "-0.1");
        assert_eq!(Osl.integer(0x9e37_79b9, Kind::Unsigned).text, "-1640531527");
        let float3 = ValueType::Vector(3, Kind::Float);
        let items = [".x", ".y", ".z"].map(|axis| Term::primary(format!("body{axis}")));
        assert_eq!(Osl.list(&items, &float3).text, "xyz(body)");
        assert_eq!(Osl.part(&Term::primary("n"), 1, &float3).text, "n[1]");
        let float4 = ValueType::Vector(4, Kind::Float);
        assert_eq!(Osl.part(&Term::primary("c"), 3, &float4).text, "c.w");
        assert_eq!(Osl.styled("normal", NameOf::Member), "normal_");
    }
}
