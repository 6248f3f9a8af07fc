//! The component: parameters, lights and host work in C#.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::images::{self, UnityImage};
use super::leaves::Leaf;
use super::parameters::{ComponentField, light_field, quoted};
use super::scratch::without_garbage;
use super::{plain, shader};
use crate::diag::Diagnostic;
use crate::document::{ColorSpace, LightSpace};
use crate::export::host_code::{CSHARP, translate};
use crate::export::package::PackageRequest;
use crate::export::package::javascript::value;
use crate::export::program::LightSetting;

/// The text around the look's own.
const TEMPLATE: &str = include_str!("Look.cs");

/// Functions of a component whose lights may follow those of the scene.
const FOLLOW: &str = include_str!("Follow.cs");

/// The type of the table of properties.
const PROPERTY: &str = include_str!("Property.cs");

/// Writes the component.
///
/// # Errors
/// Host work that C# cannot express.
pub(super) fn write(
    request: &PackageRequest<'_>,
    class: &str,
    leaves: &[Leaf],
    parts: &[ComponentField],
    images: &[UnityImage<'_>],
) -> Result<String, Diagnostic> {
    let work = request.work;
    let draw = work.modules.iter().find(|it| it.module == "draw");
    let mut functions: Vec<&str> = draw.iter().map(|it| it.function.as_str()).collect();
    if work.is_keyed {
        functions.push("keyed");
    }
    let title = plain(request.title);
    let (host, set, properties) = match draw {
        Some(draw) => {
            let host = translate(&work.wgsl, &functions, &CSHARP)?;
            let function = CSHARP.function_name(&draw.function);
            let (host, count) = without_garbage(&host, &function);
            (host, set(request, &function, count), properties(leaves, count))
        }
        None => (String::new(), String::new(), String::new()),
    };
    let is_linear = request.look.color_space == ColorSpace::Linear;
    let reads_colors = parts.iter().any(|field| field.setting.contains("Rgb("));
    let follow = FOLLOW.replace("{{linear}}", if is_linear { ".linear" } else { "" });
    let (follow, rgb) = follow.split_once("// And colors.\n").unwrap_or((&follow, ""));
    let mut functions = String::new();
    if !work.lights.is_empty() {
        functions += follow;
    }
    if reads_colors || !work.lights.is_empty() {
        functions += rgb;
    }
    let using = using(class, &host);
    let layers = images::layers(images);
    let collections = match layers.as_str() {
        "" => "",
        _ => "using System.Collections.Generic;\n",
    };
    functions += &layers;
    let own_work = if host.is_empty() {
        String::new()
    } else {
        format!(
            "\n    /// <summary>Numbers of the shader, from parameters, lights and what surrounds \
             the object.</summary>\n    internal static class {class}Work\n    {{\n{}    }}\n",
            indented(host.trim_end(), 8)
        )
    };
    Ok(TEMPLATE
        .replace("{{collections}}\n", collections)
        .replace("{{using}}\n", &using)
        .replace("{{title}}", &title)
        .replace("{{class}}", class)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{fields}}\n", &(field_texts(request, parts) + &images::fields(images)))
        .replace("{{both}}", if shader::draws_both_sides(request) { "true" } else { "false" })
        .replace("{{own_lights}}\n", &own_lights(request))
        .replace("{{properties}}\n", &properties)
        .replace("{{set}}\n", &(set + &images::set(images)))
        .replace("{{settings}}\n", &settings(request, parts))
        .replace("{{around}}\n", &around(request, !host.is_empty()))
        .replace("{{follow}}\n", &functions)
        .replace("{{property}}\n", if properties.is_empty() { "" } else { PROPERTY })
        .replace("{{work}}\n", &own_work))
}

/// Names that the file uses without the places that they come from.
fn using(class: &str, host: &str) -> String {
    if host.is_empty() {
        return String::new();
    }
    let mut text = format!("using static Chiaro.{class}Work;\n");
    // The host work has structs of its own that are called as Unity's classes are.
    for name in ["Light", "Camera", "Color", "Material", "Renderer", "Shader", "Transform"] {
        if host.contains(&format!("public struct {name}\n")) {
            let _ = writeln!(text, "using {name} = UnityEngine.{name};");
        }
    }
    text
}

fn indented(text: &str, spaces: usize) -> String {
    let line = |line: &str| match line {
        "" => "\n".to_owned(),
        _ => format!("{:spaces$}{line}\n", ""),
    };
    text.lines().map(line).collect()
}

/// The fields of parameters and lights.
fn field_texts(request: &PackageRequest<'_>, parts: &[ComponentField]) -> String {
    let mut text = String::new();
    let mut group = "";
    for field in parts {
        if field.group != group {
            group = &field.group;
            if !group.is_empty() {
                let _ = writeln!(text, "        [Header({})]", quoted(group));
            }
        }
        let attributes = field.attributes.join(", ");
        let _ = write!(
            text,
            "        [{attributes}]\n        public {} {} = {};\n\n",
            field.ty, field.name, field.default
        );
    }
    for (index, light) in request.work.lights.iter().enumerate() {
        if index == 0 {
            text += "        [Header(\"Lights\")]\n";
        }
        let help =
            format!("The light of the scene that `{}` follows; none for the look's own.", light.id);
        let _ = write!(
            text,
            "        [Tooltip({})]\n        public Light {};\n\n",
            quoted(&help),
            light_field(light.id.as_str())
        );
    }
    for (index, (id, member)) in request.work.near.iter().enumerate() {
        if index == 0 {
            text += "        [Header(\"Objects\")]\n";
        }
        let help = format!("The object whose distance moves keys, `{id}` in the look.");
        let _ = write!(
            text,
            "        [Tooltip({})]\n        public Transform {};\n\n",
            quoted(&help),
            CSHARP.member_name(member)
        );
    }
    text
}

/// The look's own lights, each in its own frame.
fn own_lights(request: &PackageRequest<'_>) -> String {
    let mut text = String::new();
    for light in &request.work.lights {
        let described = json!(light.light);
        let vector = |field: &str| {
            let numbers = described[field].as_array().cloned().unwrap_or_default();
            let number = |index: usize| double(numbers.get(index).unwrap_or(&Value::Null));
            format!("new Double3({}, {}, {})", number(0), number(1), number(2))
        };
        let _ = writeln!(
            text,
            "        static readonly LightSettings {} = new LightSettings",
            own(light)
        );
        text += "        {\n";
        for field in ["direction", "position", "aim", "color"] {
            let _ = writeln!(text, "            {field} = {},", vector(field));
        }
        for field in ["intensity", "inner", "outer", "half_distance", "range"] {
            let number = double(&described[field]);
            let _ = writeln!(text, "            {} = {number},", CSHARP.member_name(field));
        }
        text += "            shadowMap = new Double4(0.0, 0.0, 1.0, -1.0),\n        };\n\n";
    }
    text
}

/// Name of the constant of a light.
fn own(light: &LightSetting) -> String {
    format!("Own{}", CSHARP.function_name(&light.member))
}

fn double(value: &Value) -> String {
    format!("{:?}", value.as_f64().unwrap_or_default())
}

/// The table of properties, and the array of numbers that the host work fills, if it fills one.
fn properties(leaves: &[Leaf], count: Option<usize>) -> String {
    let mut text = "        /// <summary>Properties of the shader, with the numbers that are \
                    theirs.</summary>\n        \
                    static readonly Property[] Properties =\n        {\n"
        .to_owned();
    for leaf in leaves {
        let (kind, name) =
            (if leaf.is_integer() { "Whole" } else { "Number" }, quoted(&leaf.property));
        let _ = match leaf.count {
            1 => writeln!(text, "            Property.{kind}({name}, {}),", leaf.word),
            count => writeln!(text, "            Property.Vector({name}, {}, {count}),", leaf.word),
        };
    }
    text += "        };\n\n";
    if let Some(count) = count {
        let _ = write!(text, "        readonly double[] numbers = new double[{count}];\n\n");
    }
    text
}

/// The statements that set the material's numbers.
fn set(request: &PackageRequest<'_>, function: &str, count: Option<usize>) -> String {
    let settings = if request.work.is_keyed { "Keyed(settings, around)" } else { "settings" };
    let call = match count {
        Some(_) => format!("{function}({settings}, around, numbers);"),
        None => format!("double[] numbers = {function}({settings}, around);"),
    };
    format!(
        "            Surroundings around = Around(camera);\n            \
         Settings settings = SettingsIn(around);\n            {call}\n            \
         foreach (Property property in Properties)\n            {{\n                \
         property.Set(material, numbers);\n            }}\n",
    )
}

/// The function that brings fields into the form that the host work takes.
fn settings(request: &PackageRequest<'_>, parts: &[ComponentField]) -> String {
    let work = request.work;
    if work.modules.iter().all(|it| it.module != "draw") {
        return String::new();
    }
    let mut text = "        /// <summary>Parameters and lights, as the host work takes them.\
                    </summary>\n        \
                    Settings SettingsIn(Surroundings around)\n        {\n            \
                    var settings = new Settings();\n"
        .to_owned();
    for setting in &work.parameters {
        // What nobody can set has the look's own value, which keys move.
        let member = format!("settings.{}", CSHARP.member_name(&setting.member));
        let is_field = parts.iter().any(|field| field.setting.starts_with(&format!("{member} = ")));
        if !is_field {
            let _ = writeln!(
                text,
                "            {member} = {};",
                constant(&value(&setting.default), setting.ty.wgsl())
            );
        }
    }
    for light in &work.lights {
        let member = CSHARP.member_name(&light.member);
        let _ = writeln!(text, "            settings.{member} = {};", own(light));
    }
    for field in parts {
        let _ = writeln!(text, "            {}", field.setting);
    }
    for light in &work.lights {
        let (member, field) = (CSHARP.member_name(&light.member), light_field(light.id.as_str()));
        let (axes, origin) = match light.light.space {
            LightSpace::Illumination => ("around.illumination", "new Double3(0.0)"),
            LightSpace::World => ("Identity", "new Double3(0.0)"),
            LightSpace::Camera => ("Turned(around.cameraFromWorld)", "new Double3(0.0)"),
            LightSpace::Object => ("around.objectAxes", "around.objectMiddle"),
        };
        let _ =
            writeln!(text, "            Follow(ref settings.{member}, {field}, {axes}, {origin});");
    }
    text + "            return settings;\n        }\n\n"
}

/// A constant of the host work's own types.
fn constant(value: &Value, ty: &str) -> String {
    match (value, ty) {
        (Value::Array(columns), _) if columns.iter().any(Value::is_array) => {
            let columns: Vec<String> =
                columns.iter().map(|column| constant(column, "vec3f")).collect();
            format!("new Double{0}x{0}({1})", columns.len(), columns.join(", "))
        }
        (Value::Array(numbers), _) => {
            let list: Vec<String> = numbers.iter().map(double).collect();
            format!("new Double{}({})", numbers.len(), list.join(", "))
        }
        (Value::Bool(is_on), _) => is_on.to_string(),
        (number, "i32" | "u32") => number.to_string(),
        (number, _) => double(number),
    }
}

/// The function that tells what surrounds the object.
fn around(request: &PackageRequest<'_>, has_work: bool) -> String {
    if !has_work {
        return String::new();
    }
    let near: String = request
        .work
        .near
        .iter()
        .map(|(_, member)| {
            let member = CSHARP.member_name(member);
            format!("                {member} = DistanceTo({member}),\n")
        })
        .collect();
    let function = if near.is_empty() { "" } else { NEAR };
    format!("{}{function}", AROUND.replace("{{near}}\n", &near))
}

const NEAR: &str = "
        /// <summary>Distance from the middle of the object.</summary>
        double DistanceTo(Transform other) =>
            other == null ? 1e6 : Vector3.Distance(wearer.bounds.center, other.position);

";

const AROUND: &str =
    "        /// <summary>What surrounds the object while a camera draws.</summary>
        /// <remarks>x is mirrored: the look's space is right-handed.</remarks>
        Surroundings Around(Camera camera)
        {
            Matrix4x4 view = camera.worldToCameraMatrix;
            Transform eye = camera.transform;
            return new Surroundings
            {
                illumination = illumination == null ? Identity : Axes(illumination),
                // x to the right, y up, z toward the viewer, for Unity as for the look.
                cameraFromWorld = new Double3x3(
                    new Double3(-view.m00, -view.m10, -view.m20),
                    new Double3(view.m01, view.m11, view.m21),
                    new Double3(view.m02, view.m12, view.m22)),
                eye = Mirrored(eye.position),
                parallel = camera.orthographic ? Mirrored(-eye.forward) : new Double3(0.0),
                objectAxes = Axes(transform),
                objectMiddle = Mirrored(wearer.bounds.center),
                objectId = 0.0,
                viewport = new Double2(camera.pixelWidth, camera.pixelHeight),
                time = Application.isPlaying ? Time.time : 0.0,
                frame = Application.isPlaying ? Time.frameCount : 0.0,
{{near}}
            };
        }

        static readonly Double3x3 Identity = new Double3x3(
            new Double3(1.0, 0.0, 0.0), new Double3(0.0, 1.0, 0.0), new Double3(0.0, 0.0, 1.0));

        static Double3 Mirrored(Vector3 v) => new Double3(-v.x, v.y, v.z);

        /// <summary>The axes of a transform in the world, all with x mirrored.</summary>
        static Double3x3 Axes(Transform of) =>
            new Double3x3(Mirrored(-of.right), Mirrored(of.up), Mirrored(of.forward));

";
