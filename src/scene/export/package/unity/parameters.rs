//! Exposed parameters as fields of a component.

use serde_json::Value;

use crate::document::{ColorSpace, LightQuantity, Target};
use crate::export::host_code::CSHARP;
use crate::export::package::PackageRequest;
use crate::export::package::javascript::value;
use crate::library::Type;

/// A field of the component.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ComponentField {
    /// The artist's name of the parameter.
    pub(super) parameter: String,
    /// Name of the field.
    pub(super) name: String,
    /// Type of the field in C#.
    pub(super) ty: &'static str,
    /// Value of the field in the look, in C#.
    pub(super) default: String,
    /// Attributes, without brackets.
    pub(super) attributes: Vec<String>,
    /// Group under whose title the field stands; empty for none.
    pub(super) group: String,
    /// The statement that puts the field into `settings`.
    pub(super) setting: String,
}

/// The fields, in the artist's order.
pub(super) fn fields(request: &PackageRequest<'_>) -> Vec<ComponentField> {
    let mut found: Vec<ComponentField> = Vec::new();
    for (index, parameter) in request.description.parameters.iter().enumerate() {
        let Some(name) = parameter.name.as_ref().filter(|_| parameter.live) else { continue };
        let setting = request.work.parameters.iter().find(|setting| setting.index == index);
        let (member, kind, default) = match setting {
            Some(setting) => {
                let member = format!("settings.{}", CSHARP.member_name(&setting.member));
                let Some(kind) = FieldKind::of(&setting.ty) else { continue };
                (member, kind, value(&setting.default))
            }
            None => match of_light(request, name.as_str()) {
                Some((member, kind)) => (member, kind, parameter.default.clone()),
                None => continue,
            },
        };
        let is_taken = |name: &str| found.iter().any(|field| field.name == name);
        let own = name.to_string();
        let name = free_name(name.as_str(), is_taken, request);
        let mut attributes = Vec::new();
        let label = if parameter.label.is_empty() {
            parameter.name.as_ref().map(ToString::to_string)
        } else {
            Some(parameter.label.clone())
        };
        let unit = match parameter.unit.as_str() {
            "" => String::new(),
            unit => format!(", in {unit}"),
        };
        let help = if parameter.help.is_empty() {
            format!("{}{unit}.", label.unwrap_or_default())
        } else {
            format!(
                "{}{}",
                parameter.help,
                if unit.is_empty() { String::new() } else { format!(" ({})", parameter.unit) }
            )
        };
        attributes.push(format!("Tooltip({})", quoted(&help)));
        if matches!(kind, FieldKind::Number | FieldKind::Whole) {
            let end = |x: f64| if kind == FieldKind::Whole { format!("{x}") } else { float(x) };
            match (parameter.min, parameter.max) {
                (Some(min), Some(max)) => {
                    attributes.push(format!("Range({}, {})", end(min), end(max)));
                }
                (Some(min), None) => attributes.push(format!("Min({})", float(min))),
                _ => {}
            }
        }
        found.push(ComponentField {
            parameter: own,
            setting: format!("{member} = {};", kind.read(&name, request)),
            default: kind.literal(&default, request),
            ty: kind.ty(),
            name,
            attributes,
            group: parameter.group.clone(),
        });
    }
    found
}

/// Names that a component has already.
const TAKEN: [&str; 32] = [
    "name",
    "tag",
    "enabled",
    "transform",
    "gameObject",
    "hideFlags",
    "animation",
    "audio",
    "camera",
    "collider",
    "collider2D",
    "constantForce",
    "hingeJoint",
    "light",
    "networkView",
    "particleSystem",
    "renderer",
    "rigidbody",
    "rigidbody2D",
    "runInEditMode",
    "shader",
    "wearer",
    "material",
    "wornBefore",
    "illumination",
    "bothSides",
    "settings",
    "around",
    "numbers",
    "useGUILayout",
    "isActiveAndEnabled",
    "objectId",
];

/// A name that neither the component has nor what is taken.
pub(super) fn free_name(
    wanted: &str,
    is_taken: impl Fn(&str) -> bool,
    request: &PackageRequest<'_>,
) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let word: String = wanted.chars().map(kept).collect();
    let name = CSHARP.member_name(word.trim_start_matches(|c: char| !c.is_ascii_alphabetic()));
    let is_light =
        |name: &str| request.work.lights.iter().any(|light| light_field(light.id.as_str()) == name);
    let is_free =
        |name: &String| !TAKEN.contains(&name.as_str()) && !is_light(name) && !is_taken(name);
    let candidates = [name.clone(), format!("{name}Value")].into_iter();
    let numbered = (2..).map(|number| format!("{name}{number}"));
    candidates.chain(numbered).find(is_free).unwrap_or(name)
}

/// Name of the field of the light that a light of the look follows.
pub(super) fn light_field(id: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let word: String = id.chars().map(kept).collect();
    CSHARP.member_name(&format!("{word}_light"))
}

/// The member that a parameter of a light sets.
fn of_light(request: &PackageRequest<'_>, name: &str) -> Option<(String, FieldKind)> {
    let exposed = request.look.exposed.iter().find(|exposed| exposed.name.as_str() == name)?;
    let Target::Light { light, field } = &exposed.target else { return None };
    let setting = request.work.lights.iter().find(|setting| setting.id == *light)?;
    let member = CSHARP.member_name(&setting.member);
    let kind = match exposed.target.light_field()?.quantity() {
        LightQuantity::Direction | LightQuantity::Position => FieldKind::Vector(3),
        LightQuantity::Color => FieldKind::Rgb,
        LightQuantity::Factor | LightQuantity::Angle | LightQuantity::Distance => FieldKind::Number,
    };
    Some((format!("settings.{member}.{}", CSHARP.member_name(field)), kind))
}

/// Kind of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FieldKind {
    Switch,
    Whole,
    Number,
    Vector(usize),
    Rgb,
    Rgba,
}

impl FieldKind {
    /// The kind of a setting; `None` for what an inspector has no field for.
    fn of(ty: &Type) -> Option<Self> {
        Some(match ty.wgsl() {
            "bool" => Self::Switch,
            "i32" => Self::Whole,
            "f32" => Self::Number,
            "vec2f" => Self::Vector(2),
            "vec3f" => Self::Vector(3),
            "vec4f" if matches!(ty, Type::Color | Type::Composite) => Self::Rgba,
            "vec4f" => Self::Vector(4),
            _ => return None,
        })
    }

    fn ty(self) -> &'static str {
        match self {
            Self::Switch => "bool",
            Self::Whole => "int",
            Self::Number => "float",
            Self::Vector(2) => "Vector2",
            Self::Vector(3) => "Vector3",
            Self::Vector(_) => "Vector4",
            Self::Rgb | Self::Rgba => "Color",
        }
    }

    /// The field's value as the host work takes it.
    fn read(self, name: &str, request: &PackageRequest<'_>) -> String {
        // Fields of colors hold numbers as shown, whatever the project draws in.
        let linear = match request.look.color_space {
            ColorSpace::Linear => ".linear",
            ColorSpace::Display => "",
        };
        match self {
            Self::Switch | Self::Whole | Self::Number => name.to_owned(),
            Self::Vector(2) => format!("new Double2({name}.x, {name}.y)"),
            Self::Vector(3) => format!("new Double3({name}.x, {name}.y, {name}.z)"),
            Self::Vector(_) => format!("new Double4({name}.x, {name}.y, {name}.z, {name}.w)"),
            Self::Rgb => format!("Rgb({name}{linear})"),
            Self::Rgba => {
                let of = format!("{name}{linear}");
                format!("new Double4({of}.r, {of}.g, {of}.b, {of}.a)")
            }
        }
    }

    fn literal(self, value: &Value, request: &PackageRequest<'_>) -> String {
        let numbers: Vec<f64> = match value {
            Value::Array(items) => items.iter().filter_map(Value::as_f64).collect(),
            Value::String(text) => hexadecimal(text),
            other => other.as_f64().into_iter().collect(),
        };
        let number = |index: usize| numbers.get(index).copied().unwrap_or_default();
        let list = |count: usize| {
            (0..count).map(|index| float(number(index))).collect::<Vec<_>>().join(", ")
        };
        match self {
            Self::Switch => value.as_bool().unwrap_or_default().to_string(),
            Self::Whole => format!("{}", number(0)),
            Self::Number => float(number(0)),
            Self::Vector(count) => format!("new Vector{count}({})", list(count)),
            Self::Rgb | Self::Rgba => {
                let alpha =
                    if self == Self::Rgb { 1.0 } else { numbers.get(3).copied().unwrap_or(1.0) };
                let [r, g, b] = [0, 1, 2].map(|index| float(shown(number(index), request)));
                format!("new Color({r}, {g}, {b}, {})", float(alpha))
            }
        }
    }
}

/// A number of a color of the look, as shown.
pub(super) fn shown(x: f64, request: &PackageRequest<'_>) -> f64 {
    match request.look.color_space {
        ColorSpace::Display => x,
        ColorSpace::Linear if x <= 0.003_130_8 => 12.92 * x,
        ColorSpace::Linear => 1.055 * x.powf(1.0 / 2.4) - 0.055,
    }
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

/// A number as a `float` of C#.
pub(super) fn float(x: f64) -> String {
    format!("{}f", x as f32)
}

/// A text of C#.
pub(super) fn quoted(text: &str) -> String {
    let text = text.replace(char::is_control, " ").replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{text}\"")
}
