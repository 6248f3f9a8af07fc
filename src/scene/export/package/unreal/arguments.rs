//! Exposed parameters as parameters of a material, inputs of its node and arguments of the look.

use serde_json::Value;

use super::shader::capitals;
use crate::document::{ColorSpace, LightQuantity, Target};
use crate::export::exposed::ExposedParameter;
use crate::export::package::PackageRequest;
use crate::export::package::javascript::value;
use crate::library::Type;

/// A parameter of the material.
#[derive(Clone, Debug)]
pub(super) struct Argument<'a> {
    /// Name of the parameter, the artist's.
    pub(super) name: &'a str,
    /// Name of the input of the node and of the argument.
    pub(super) input: String,
    /// Member of the host work's settings that the argument sets.
    pub(super) member: String,
    pub(super) kind: ArgumentKind,
    /// Numbers of the default, as the look has them.
    pub(super) default: [f64; 4],
    /// The parameter's range, group and help.
    pub(super) described: &'a ExposedParameter,
}

/// Kind of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ArgumentKind {
    /// 0 or 1.
    Switch,
    /// A whole number, `i32` or `u32`.
    Whole(&'static str),
    Number,
    /// Two to four numbers.
    Vector(usize),
    Rgb,
    Rgba,
}

impl ArgumentKind {
    fn of(ty: &Type) -> Option<Self> {
        Some(match ty.wgsl() {
            "bool" => Self::Switch,
            "i32" => Self::Whole("i32"),
            "u32" => Self::Whole("u32"),
            "f32" => Self::Number,
            "vec2f" => Self::Vector(2),
            "vec3f" => Self::Vector(3),
            "vec4f" if matches!(ty, Type::Color | Type::Composite) => Self::Rgba,
            "vec4f" => Self::Vector(4),
            _ => return None,
        })
    }

    /// True for a single number.
    pub(super) fn is_scalar(self) -> bool {
        self.count() == 1
    }

    /// True for a color.
    pub(super) fn is_color(self) -> bool {
        matches!(self, Self::Rgb | Self::Rgba)
    }

    /// Number of numbers.
    pub(super) fn count(self) -> usize {
        match self {
            Self::Switch | Self::Whole(_) | Self::Number => 1,
            Self::Vector(count) => count,
            Self::Rgb => 3,
            Self::Rgba => 4,
        }
    }

    /// Type of the argument in HLSL.
    pub(super) fn hlsl(self) -> &'static str {
        ["float", "float2", "float3", "float4"][self.count() - 1]
    }

    /// Type of the argument in WGSL.
    pub(super) fn wgsl(self) -> &'static str {
        ["f32", "vec2f", "vec3f", "vec4f"][self.count() - 1]
    }

    /// The value of a setting, of an argument in WGSL.
    pub(super) fn setting(self, argument: &str) -> String {
        match self {
            Self::Switch => format!("{argument} > 0.5"),
            Self::Whole(ty) => format!("{ty}(round({argument}))"),
            _ => argument.to_owned(),
        }
    }
}

/// Names that the function and the material's code have for themselves.
const TAKEN: [&str; 16] = [
    "Parameters",
    "Pixel",
    "WorldPosition",
    "LocalPosition",
    "VertexNormal",
    "TwoSidedSign",
    "TexCoord",
    "VertexColor",
    "VertexAlpha",
    "CameraPosition",
    "ObjectPosition",
    "Time",
    "View",
    "ResolvedView",
    "Opacity",
    "PI",
];

/// The arguments, in the artist's order. None has the name of the namespace, `class`.
pub(super) fn arguments<'a>(request: &PackageRequest<'a>, class: &str) -> Vec<Argument<'a>> {
    let mut found: Vec<Argument<'a>> = Vec::new();
    for (index, described) in request.description.parameters.iter().enumerate() {
        let Some(name) = described.name.as_ref().filter(|_| described.live) else { continue };
        let setting = request.work.parameters.iter().find(|setting| setting.index == index);
        let of_setting = setting.and_then(|setting| {
            let kind = ArgumentKind::of(&setting.ty)?;
            Some((setting.member.clone(), kind, value(&setting.default)))
        });
        let of_light = || {
            let (member, kind) = of_light(request, name.as_str())?;
            Some((member, kind, described.default.clone()))
        };
        let Some((member, kind, default)) = of_setting.or_else(of_light) else { continue };
        found.push(Argument {
            input: free_name(name.as_str(), class, &found),
            name: name.as_str(),
            member,
            kind,
            default: numbers(&default, kind),
            described,
        });
    }
    found
}

/// The member that a parameter of a light sets.
fn of_light(request: &PackageRequest<'_>, name: &str) -> Option<(String, ArgumentKind)> {
    let exposed = request.look.exposed.iter().find(|exposed| exposed.name.as_str() == name)?;
    let Target::Light { light, field } = &exposed.target else { return None };
    let setting = request.work.lights.iter().find(|setting| setting.id == *light)?;
    let kind = match exposed.target.light_field()?.quantity() {
        LightQuantity::Direction | LightQuantity::Position => ArgumentKind::Vector(3),
        LightQuantity::Color => ArgumentKind::Rgb,
        _ => ArgumentKind::Number,
    };
    Some((format!("{}.{field}", setting.member), kind))
}

/// `MoveX` of `move_x`, unlike `class` and all before.
fn free_name(wanted: &str, class: &str, before: &[Argument<'_>]) -> String {
    let name = capitals(wanted);
    let name = match name.chars().next() {
        Some(first) if first.is_ascii_alphabetic() => name,
        _ => format!("Value{name}"),
    };
    // The fourth number of an argument has an input of its own, with a letter more.
    let is_free = |name: &String| {
        !TAKEN.contains(&name.as_str())
            && name != class
            && before.iter().all(|it| {
                it.input != *name
                    && format!("{}A", it.input) != *name
                    && format!("{name}A") != it.input
            })
    };
    let candidates = [name.clone(), format!("{name}OfLook")].into_iter();
    let numbered = (2..).map(|number| format!("{name}{number}"));
    candidates.chain(numbered).find(is_free).unwrap_or(name)
}

/// The numbers of a default.
fn numbers(value: &Value, kind: ArgumentKind) -> [f64; 4] {
    let list: Vec<f64> = match value {
        Value::Array(items) => items.iter().filter_map(Value::as_f64).collect(),
        Value::String(text) => hexadecimal(text),
        Value::Bool(is_on) => vec![f64::from(u8::from(*is_on))],
        other => other.as_f64().into_iter().collect(),
    };
    let opacity = if kind.is_color() { 1.0 } else { 0.0 };
    [0, 1, 2, 3]
        .map(|index| list.get(index).copied().unwrap_or(if index == 3 { opacity } else { 0.0 }))
}

/// Numbers of a color that is written `#rrggbb`.
fn hexadecimal(text: &str) -> Vec<f64> {
    let digits = text.trim_start_matches('#').as_bytes();
    let pair = |pair: &[u8]| {
        let text = std::str::from_utf8(pair).ok()?;
        u8::from_str_radix(text, 16).ok().map(|byte| f64::from(byte) / 255.0)
    };
    digits.chunks(2).filter_map(pair).collect()
}

/// The default as the material has it: colors of materials are linear light.
pub(super) fn shown_default(argument: &Argument<'_>, space: ColorSpace) -> [f64; 4] {
    let mut numbers = argument.default;
    if argument.kind.is_color() && space == ColorSpace::Display {
        for number in &mut numbers[..3] {
            *number = linear_from_display(*number);
        }
    }
    numbers
}

fn linear_from_display(x: f64) -> f64 {
    if x <= 0.040_45 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}
