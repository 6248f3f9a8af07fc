//! The look's script: properties for the inspector, and the uniforms that host work makes of them.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use super::super::super::description::ExposedParameter;
use super::super::super::program::ParameterSetting;
use super::super::{PackageRequest, javascript};
use super::uniforms::{Uniform, Uniforms, help_of};
use crate::document::{ColorSpace, Light, Target};
use crate::library::Type;

/// Properties, methods and signals of what scripts are put on, and words of the language.
const TAKEN: &str = " add_child and array as atr await basis bool break call case cast_shadow \
    class color connect const continue custom_aabb disconnect duplicate elif else enum extends \
    false float for free func get hide if illumination in int is layers light lod_bias look_at \
    match material material_overlay material_override mesh move_child multiplayer name not null \
    object_id or owner pass pi position print preload process_mode quaternion range ready return \
    rotate rotation scale self set show signal skeleton skin static super switch tau time tr \
    transform translate transparency true update var visible void while yield ";

/// A property of the script.
pub(super) struct Property<'a> {
    /// Name in the script.
    pub(super) name: String,
    parameter: &'a ExposedParameter,
    ty: Type,
    default: Value,
}

/// The name of a property: that of a setting, which is a word, or one like it.
pub(super) fn property_name(wanted: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let name: String = wanted.chars().map(kept).collect();
    let name = name.trim_matches('_');
    let name = match name.chars().next() {
        None => "value".to_owned(),
        Some(first) if first.is_ascii_digit() => format!("value_{name}"),
        Some(_) => name.to_owned(),
    };
    if TAKEN.contains(&format!(" {name} ")) { format!("{name}_of_look") } else { name }
}

/// The properties of exposed parameters that change the picture, in the artist's order.
pub(super) fn properties<'a>(request: &PackageRequest<'a>) -> Vec<Property<'a>> {
    let mut found: Vec<Property<'a>> = Vec::new();
    let mut taken: Vec<String> =
        request.work.lights.iter().map(|light| light.member.clone()).collect();
    for (index, parameter) in request.description.parameters.iter().enumerate() {
        let Some(own) = parameter.name.as_ref().filter(|_| parameter.live) else { continue };
        let setting = request.work.parameters.iter().find(|setting| setting.index == index);
        let (ty, default) = match setting {
            Some(setting) => (setting.ty.clone(), javascript::value(&setting.default)),
            None => (type_of_field(&parameter.ty), parameter.default.clone()),
        };
        let wanted = property_name(setting.map_or(own.as_str(), |it| it.member.as_str()));
        let numbered = (2..).map(|number| format!("{wanted}_{number}"));
        let mut names = std::iter::once(wanted.clone()).chain(numbered);
        let name = names.find(|name| !taken.contains(name)).unwrap_or_else(|| wanted.clone());
        taken.push(name.clone());
        found.push(Property { name, parameter, ty, default });
    }
    found
}

fn type_of_field(word: &str) -> Type {
    match word {
        "color" => Type::Color,
        "vec2" => Type::Vec2,
        "vec3" => Type::Vec3,
        "vec4" => Type::Vec4,
        "switch" => Type::Bool,
        _ => Type::Float,
    }
}

impl Property<'_> {
    fn is_color(&self) -> bool {
        matches!(self.ty, Type::Color | Type::Composite)
    }

    /// The declaration with the hint that the inspector reads.
    fn declaration(&self, is_linear: bool) -> String {
        let mut text = String::new();
        if let Some(line) = help_of(self.parameter) {
            let _infallible = writeln!(text, "## {line}");
        }
        let ExposedParameter { min, max, unit, .. } = self.parameter;
        let hint = match (min, max, &self.ty) {
            (Some(min), Some(max), Type::Float) => {
                let unit = match unit.as_str() {
                    "" => String::new(),
                    "rad" | "radians" => ", \"radians_as_degrees\"".to_owned(),
                    unit => format!(", \"suffix:{}\"", unit.replace(['"', '\\'], "")),
                };
                format!("@export_range({min:?}, {max:?}, 0.001{unit})")
            }
            (Some(min), Some(max), Type::Int) => format!("@export_range({min}, {max})"),
            _ => "@export".to_owned(),
        };
        let name = &self.name;
        let _infallible = writeln!(text, "{hint} var {name} := {}", self.value(is_linear));
        text
    }

    /// The default.
    fn value(&self, is_linear: bool) -> String {
        let number = |at: usize| self.default[at].as_f64().unwrap_or_default();
        let list = |count: usize, write: &dyn Fn(f64) -> f64| {
            let numbers: Vec<String> = (0..count)
                .map(|at| format!("{:?}", if at == 3 { number(at) } else { write(number(at)) }))
                .collect();
            numbers.join(", ")
        };
        let same = |x: f64| x;
        let shown = |x: f64| {
            if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }
        };
        match &self.ty {
            Type::Bool => self.default.as_bool().unwrap_or_default().to_string(),
            Type::Int => format!("{}", self.default.as_f64().unwrap_or_default() as i64),
            Type::Color | Type::Composite if is_linear => format!("Color({})", list(4, &shown)),
            Type::Color | Type::Composite => format!("Color({})", list(4, &same)),
            Type::Vec2 => format!("Vector2({})", list(2, &same)),
            Type::Vec3 => format!("Vector3({})", list(3, &same)),
            Type::Vec4 => format!("Vector4({})", list(4, &same)),
            Type::Mat3 => "Basis.IDENTITY".to_owned(),
            _ => format!("{:?}", self.default.as_f64().unwrap_or_default()),
        }
    }

    /// The value as host work takes it.
    fn setting(&self, is_linear: bool) -> String {
        let name = &self.name;
        match &self.ty {
            Type::Bool | Type::Int | Type::Float => name.clone(),
            Type::Color | Type::Composite if is_linear => {
                format!("numbers_of({name}.srgb_to_linear())")
            }
            Type::Mat3 => format!("columns_of({name})"),
            _ => format!("numbers_of({name})"),
        }
    }
}

/// The values of a light, each of its numbers a float.
pub(super) fn own_light(light: &Light) -> Map<String, Value> {
    let mut own = match json!(light) {
        Value::Object(members) => members,
        _ => Map::new(),
    };
    own.shift_remove("type");
    own
}

/// Writes the script.
pub(super) fn write(
    request: &PackageRequest<'_>,
    uniforms: &Uniforms<'_>,
    read: &[&Uniform],
    properties: &[Property<'_>],
) -> String {
    let (work, stem) = (request.work, request.stem);
    let is_linear = request.description.color_space == ColorSpace::Linear;
    let mut text = format!(
        "@tool\nextends \"chiaro.look.gd\"\n\
         ## {}: made by Chiaro {}, Godot 4.\n##\n\
         ## Put this script on a MeshInstance3D: it draws the mesh with the look.\n\n\
         const Host := preload(\"{stem}.host.gd\")\n\n",
        request.title,
        env!("CARGO_PKG_VERSION"),
    );
    for light in &work.lights {
        let _infallible = writeln!(
            text,
            "## The light `{}` of the look, in its own frame.\nconst OWN_{} := {}\n",
            light.id,
            light.member.to_uppercase(),
            light_literal(&own_light(&light.light))
        );
    }
    let mut open = String::new();
    for property in properties {
        let group = property.parameter.group.replace(['"', '\\'], "");
        if group != open {
            let _infallible = writeln!(text, "@export_group(\"{group}\")");
            open = group;
        }
        text += &property.declaration(is_linear);
    }
    if !work.lights.is_empty() {
        text += "@export_group(\"Lights\")\n";
    }
    for light in &work.lights {
        let _infallible = writeln!(
            text,
            "## Light of the scene that the look's light `{}` follows; its own values without.\n\
             @export var {}: Light3D",
            light.id, light.member
        );
    }
    if !work.near.is_empty() {
        text += "@export_group(\"Objects\")\n";
    }
    for (id, member) in &work.near {
        let _infallible = writeln!(
            text,
            "## The object `{id}`, whose distance drives keys; far away without.\n\
             @export var {member}: Node3D"
        );
    }
    let _infallible =
        write!(text, "\n\nfunc _shader() -> Shader:\n\treturn preload(\"{stem}.gdshader\")\n");
    if !uniforms.images.is_empty() {
        text += "\n\nfunc _images() -> Dictionary:\n\treturn {\n";
        for image in &uniforms.images {
            let _infallible = writeln!(text, "\t\t{} = preload(\"{}\"),", image.name, image.file);
        }
        text += "\t}\n";
    }
    if !work.near.is_empty() {
        text += "\n\nfunc _surroundings() -> Dictionary:\n\tvar around := super()\n";
        text += "\tvar middle := Vector3(\n\t\taround.object_middle[0], around.object_middle[1], \
                 around.object_middle[2]\n\t)\n";
        for (_, member) in &work.near {
            let _infallible = writeln!(
                text,
                "\tif {member}:\n\
                 \t\taround.{member} = middle.distance_to({member}.global_position)\n\
                 \telse:\n\t\taround.{member} = 1e6"
            );
        }
        text += "\treturn around\n";
    }
    if !read.is_empty() {
        text += &settings(request, properties, is_linear);
        text += &uniform_values(request, uniforms, read);
    }
    text
}

fn settings(request: &PackageRequest<'_>, properties: &[Property<'_>], is_linear: bool) -> String {
    let work = request.work;
    let argument = if work.lights.is_empty() { "_around" } else { "around" };
    let mut text =
        format!("\n\nfunc _settings({argument}: Dictionary) -> Dictionary:\n\treturn {{\n");
    for setting in &work.parameters {
        let value = value_of(setting, request, properties, is_linear);
        let _infallible = writeln!(text, "\t\t{} = {value},", setting.member);
    }
    for light in &work.lights {
        let mut given = Vec::new();
        for exposed in &request.look.exposed {
            if let Target::Light { light: other, field } = &exposed.target
                && *other == light.id
                && let Some(property) =
                    properties.iter().find(|it| it.parameter.name.as_ref() == Some(&exposed.name))
            {
                let value = property.setting(is_linear);
                let value =
                    if property.is_color() { format!("{value}.slice(0, 3)") } else { value };
                given.push(format!("{field} = {value}"));
            }
        }
        let (member, own) = (&light.member, light.member.to_uppercase());
        let given = given.join(", ");
        let _infallible =
            writeln!(text, "\t\t{member} = light_of(OWN_{own}, {{{given}}}, {member}, around),");
    }
    if work.parameters.is_empty() && work.lights.is_empty() {
        text += "\t\tnothing = 0.0,\n";
    }
    text + "\t}\n"
}

/// The expression of a setting: its property, or its own value.
fn value_of(
    setting: &ParameterSetting,
    request: &PackageRequest<'_>,
    properties: &[Property<'_>],
    is_linear: bool,
) -> String {
    let name = request.description.parameters[setting.index].name.as_ref();
    let property =
        properties.iter().find(|it| name.is_some() && it.parameter.name.as_ref() == name);
    match property {
        Some(property) if property.ty == setting.ty => property.setting(is_linear),
        Some(property) => match (&setting.ty, &property.ty) {
            // The same value may be taken as a number here and as a color there.
            (Type::Float | Type::Int, _) => format!("{}[0]", property.setting(is_linear)),
            _ => property.setting(is_linear),
        },
        None => literal(&javascript::value(&setting.default), setting.ty == Type::Int),
    }
}

fn uniform_values(
    request: &PackageRequest<'_>,
    uniforms: &Uniforms<'_>,
    read: &[&Uniform],
) -> String {
    let work = request.work;
    let function = work.modules.iter().find(|it| it.module == "draw");
    let Some(function) = function.map(|it| it.function.as_str()) else { return String::new() };
    let mut text =
        "\n\nfunc _uniforms(settings: Dictionary, around: Dictionary) -> Dictionary:\n".to_owned();
    if work.is_keyed {
        text += "\tsettings = Host.keyed(settings, around)\n";
    }
    let _infallible = write!(text, "\tvar n := Host.{function}(settings, around)\n\treturn {{\n");
    for uniform in read {
        let is_color = uniforms.parameter(uniform).is_some_and(|it| it.is_color);
        let _infallible = writeln!(text, "\t\t{} = {},", uniform.name, packed(uniform, is_color));
    }
    text + "\t}\n"
}

/// The expression that makes a uniform of the block's numbers `n`.
fn packed(uniform: &Uniform, is_color: bool) -> String {
    let (ty, function) = match uniform.ty {
        "vec2" => ("Vector2", "vector2_at"),
        "vec3" => ("Vector3", "vector3_at"),
        "vec4" if is_color => ("Color", "color_at"),
        "vec4" => ("Vector4", "vector4_at"),
        "mat3" => ("Basis", "basis_at"),
        "float" => ("float", ""),
        _ => ("int", ""),
    };
    let value = |at: &str| match function.is_empty() {
        true => format!("n[{at}]"),
        false => format!("{function}(n, {at})"),
    };
    let (word, step) = (uniform.word, uniform.step);
    match uniform.count {
        None => value(&word.to_string()),
        Some(count) => {
            let value = value(&format!("{word} + {step} * i"));
            format!("range({count}).map(func(i: int) -> {ty}: return {value})")
        }
    }
}

/// The values of a light as a dictionary, a line each.
fn light_literal(own: &Map<String, Value>) -> String {
    let member =
        |(name, value): (&String, &Value)| format!("\t{name} = {},\n", literal(value, false));
    format!("{{\n{}}}", own.iter().map(member).collect::<String>())
}

/// A JSON value in GDScript.
fn literal(value: &Value, is_integer: bool) -> String {
    match value {
        Value::Array(parts) => {
            let parts: Vec<String> = parts.iter().map(|part| literal(part, is_integer)).collect();
            format!("[{}]", parts.join(", "))
        }
        Value::Number(number) if !is_integer => {
            format!("{:?}", number.as_f64().unwrap_or_default())
        }
        other => other.to_string(),
    }
}
