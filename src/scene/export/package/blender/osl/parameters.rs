//! Parameters of the shader: what the artist exposed, and the fields of lights.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use serde_json::{Map, Value as Json, json};

use super::super::super::PackageRequest;
use super::super::super::numbers::{number as float, numbers};
use crate::document::{ColorSpace, Light, LightField, LightQuantity, Target, srgb_to_linear};
use crate::export::exposed::ExposedParameter;
use crate::export::host_code::OSL;
use crate::ids::LightId;
use crate::interp::Value;
use crate::library::Type;

/// The parameters, and how the shader's settings are made of them.
#[derive(Clone, Debug)]
pub(super) struct Parameters {
    /// Declarations.
    pub(super) text: String,
    /// Statements that fill the settings.
    pub(super) settings: String,
    /// Names of the shader's parameters by those of the look, for the add-on.
    pub(super) names: Json,
}

/// Writer of parameters.
struct Writer<'a> {
    request: &'a PackageRequest<'a>,
    taken: BTreeSet<String>,
    text: String,
    /// Statements that bring colors into the look's space.
    colors: String,
    parameters: Map<String, Json>,
    lights: Map<String, Json>,
}

impl Parameters {
    /// The parameters of a look. `extra` are names that the shader takes for itself.
    pub(super) fn of(request: &PackageRequest<'_>, extra: &[&str]) -> Self {
        let taken = extra.iter().map(|name| (*name).to_owned()).collect();
        let mut writer = Writer {
            request,
            taken,
            text: String::new(),
            colors: String::new(),
            parameters: Map::new(),
            lights: Map::new(),
        };
        let mut values = Vec::new();
        let work = request.work;
        for setting in &work.parameters {
            let told = request.description.parameters.get(setting.index);
            let told = told.filter(|told| told.live && setting.name.is_some());
            values.push(match (told, &setting.name) {
                (Some(told), Some(name)) => {
                    writer.exposed(told, name.as_str(), &setting.ty, &setting.default)
                }
                _ => literal(&setting.ty, &setting.default),
            });
        }
        let mut lights = String::new();
        for light in &work.lights {
            let lines = writer.light(&light.id, &light.light);
            let member = OSL.member_name(&light.member);
            let _ = write!(lights, "    LightSettings {member} = LightSettings(\n{lines}    );\n");
            values.push(member);
        }
        if values.is_empty() {
            values.push("0.0".to_owned());
        }
        let mut settings = format!("{}{lights}", writer.colors);
        let _ = writeln!(settings, "    Settings settings = Settings({});", values.join(", "));
        let names = json!({ "parameters": writer.parameters, "lights": writer.lights });
        Self { text: writer.text, settings, names }
    }
}

impl Writer<'_> {
    /// A name for a parameter like `wanted`, which none has.
    fn name(&mut self, wanted: &str) -> String {
        let kept = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let mut name = OSL.member_name(&wanted.chars().map(kept).collect::<String>());
        if name.starts_with(|c: char| c.is_ascii_digit()) {
            name.insert(0, '_');
        }
        while !self.taken.insert(name.clone()) {
            name.push('_');
        }
        name
    }

    fn declare(&mut self, ty: &str, name: &str, default: &str, told: &[String]) {
        let head = format!("    {ty} {name} = {default}");
        let told = told.join(",\n            ");
        let _ = writeln!(self.text, "{head}\n        [[ {told} ]],");
    }

    /// Declares an exposed parameter; its value in the settings.
    fn exposed(
        &mut self,
        told: &ExposedParameter,
        key: &str,
        ty: &Type,
        default: &Value,
    ) -> String {
        let numbers = numbers(default);
        let number = |index: usize| numbers.get(index).copied().unwrap_or_default();
        let about = told_of(told);
        let (word, value) = match ty {
            Type::Float => ("float", float(number(0))),
            Type::Int => ("int", format!("{:.0}", number(0))),
            Type::Bool => ("int", format!("{:.0}", number(0))),
            Type::Vec2 | Type::Vec3 => (
                "vector",
                format!("vector({}, {}, {})", float(number(0)), float(number(1)), float(number(2))),
            ),
            Type::Color | Type::Composite | Type::Vec4 => ("color", self.color(&numbers)),
            _ => return literal(ty, default),
        };
        let name = self.name(key);
        let mut about = about;
        if *ty == Type::Bool {
            about.push("string widget = \"checkBox\"".to_owned());
        }
        self.declare(word, &name, &value, &about);
        let mut names = vec![name.clone()];
        let text = match ty {
            Type::Bool => format!("{name} != 0"),
            Type::Vec2 => format!("vector2({name}[0], {name}[1])"),
            Type::Color | Type::Composite | Type::Vec4 => {
                let alpha = self.name(&format!("{key}_alpha"));
                let mut about = told_of(told);
                about[0] = format!("string label = \"{} alpha\"", escaped(&told.label));
                self.declare("float", &alpha, &float(number(3)), &about);
                names.push(alpha.clone());
                let color = self.in_looks_space(&name);
                format!("vector4({color}[0], {color}[1], {color}[2], {alpha})")
            }
            _ => name,
        };
        self.parameters.insert(key.to_owned(), json!(names));
        text
    }

    /// A color as Blender has it, linear, of numbers in the look's space.
    fn color(&self, numbers: &[f64]) -> String {
        let linear = |x: f64| match self.request.look.color_space {
            ColorSpace::Display => srgb_to_linear(x),
            ColorSpace::Linear => x,
        };
        let items: Vec<String> = (0..3)
            .map(|index| float(linear(numbers.get(index).copied().unwrap_or_default())))
            .collect();
        format!("color({})", items.join(", "))
    }

    /// A color in the look's space, of one as Blender has it.
    fn in_looks_space(&mut self, name: &str) -> String {
        let (ending, value) = match self.request.look.color_space {
            ColorSpace::Display => ("shown", format!("shown_of_light({name})")),
            ColorSpace::Linear => ("linear", format!("(vector){name}")),
        };
        let own = self.name(&format!("{}_{ending}", name.trim_end_matches('_')));
        let _ = writeln!(self.colors, "    vector {own} = {value};");
        own
    }

    /// Declares the fields of a light; the lines of its settings.
    fn light(&mut self, id: &LightId, light: &Light) -> String {
        let mut names = Map::new();
        let fields: Vec<LightField> = light.fields().collect();
        let mut values = std::collections::BTreeMap::new();
        for field in fields {
            let is_it = |target: &Target| {
                matches!(target, Target::Light { light, field: name }
                    if light == id && name == field.name())
            };
            let exposed = self.request.look.exposed.iter().find(|it| is_it(&it.target));
            let told = exposed.and_then(|exposed| {
                let mut parameters = self.request.description.parameters.iter();
                parameters.find(|it| it.live && it.name.as_ref() == Some(&exposed.name))
            });
            let about = told.map_or_else(|| about_field(id, light, field), told_of);
            let key = told.and_then(|told| told.name.as_ref());
            let wanted = key.map_or_else(|| format!("{id}_{}", field.name()), ToString::to_string);
            let name = self.name(&wanted);
            let numbers = field.numbers(light);
            let (ty, default, value) = match (field.quantity(), numbers) {
                (LightQuantity::Color, _) => {
                    ("color", self.color(numbers), self.in_looks_space(&name))
                }
                (_, [number]) => ("float", float(*number), name.clone()),
                _ => ("vector", vector(numbers), name.clone()),
            };
            self.declare(ty, &name, &default, &about);
            if let Some(key) = key {
                self.parameters.insert(key.to_string(), json!([name]));
            }
            names.insert(field.name().to_owned(), json!(name));
            values.insert(field.name(), value);
        }
        self.lights.insert(id.to_string(), Json::Object(names));
        let mut lines = String::new();
        for field in ORDER {
            let own = || {
                let numbers = LightField::named(field).map(|it| it.numbers(light));
                match numbers {
                    Some([number]) => float(*number),
                    Some(numbers) => vector(numbers),
                    // Aimed at no other object, and in no shadow maps.
                    None if field == "aimed_at" => "vector4(0.0, 0.0, 0.0, 0.0)".to_owned(),
                    None => "vector4(0.0, 0.0, 1.0, -1.0)".to_owned(),
                }
            };
            let value = values.get(field).cloned().unwrap_or_else(own);
            let end = if field == "shadow_map" { "" } else { "," };
            let _ = writeln!(lines, "        {value}{end} // {}", field.replace('_', " "));
        }
        lines
    }
}

/// Members of a light's settings, in their order.
const ORDER: [&str; 11] = [
    "direction",
    "position",
    "aim",
    "color",
    "intensity",
    "inner",
    "outer",
    "half_distance",
    "range",
    "aimed_at",
    "shadow_map",
];

/// Metadata that tells people of an exposed parameter.
fn told_of(told: &ExposedParameter) -> Vec<String> {
    let mut about = vec![format!("string label = \"{}\"", escaped(&told.label))];
    if !told.group.is_empty() {
        about.push(format!("string page = \"{}\"", escaped(&told.group)));
    }
    let is_whole = told.ty == "int";
    for (word, bound) in [("min", told.min), ("max", told.max)] {
        if let Some(bound) = bound {
            about.push(match is_whole {
                true => format!("int {word} = {bound:.0}"),
                false => format!("float {word} = {}", float(bound)),
            });
        }
    }
    if !told.unit.is_empty() {
        about.push(format!("string units = \"{}\"", escaped(&told.unit)));
    }
    if !told.help.is_empty() {
        about.push(format!("string help = \"{}\"", escaped(&told.help)));
    }
    about
}

fn about_field(id: &LightId, light: &Light, field: LightField) -> Vec<String> {
    let (name, label) = (light.display_name(id), field.label_text().english());
    let (label, group) = (label.to_lowercase(), "Lights");
    let mut about = vec![
        format!("string label = \"{} {}\"", escaped(name), escaped(&label)),
        format!("string page = \"{group}\""),
    ];
    if !field.unit().is_empty() {
        about.push(format!("string units = \"{}\"", field.unit()));
    }
    about.push(format!("string help = \"{}\"", escaped(field.help_text().english())));
    about
}

/// A text within quotes.
fn escaped(text: &str) -> String {
    let plain = text.replace(char::is_control, " ");
    plain.replace('\\', "\\\\").replace('"', "\\\"")
}

fn vector(numbers: &[f64]) -> String {
    let items: Vec<String> = numbers.iter().map(|x| float(*x)).collect();
    format!("vector({})", items.join(", "))
}

/// A value that nothing sets.
fn literal(ty: &Type, value: &Value) -> String {
    let numbers = numbers(value);
    let items: Vec<String> = numbers.iter().map(|x| float(*x)).collect();
    match ty {
        Type::Float => float(numbers.first().copied().unwrap_or_default()),
        Type::Int | Type::Bool => format!("{:.0}", numbers.first().copied().unwrap_or_default()),
        Type::Vec2 => format!("vector2({})", items.join(", ")),
        Type::Vec3 => format!("vector({})", items.join(", ")),
        Type::Mat3 => {
            let columns: Vec<String> = numbers.chunks(3).map(vector).collect();
            format!("Matrix3({})", columns.join(", "))
        }
        _ => format!("vector4({})", items.join(", ")),
    }
}
