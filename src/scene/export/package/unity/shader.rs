//! The shader: ShaderLab around the look's HLSL.

use std::fmt::Write as _;

use super::images::{self, UnityImage};
use super::leaves::Leaf;
use super::plain;
use super::source::{Field, Source};
use crate::document::ColorSpace;
use crate::export::package::PackageRequest;

/// The text around the look's own.
const TEMPLATE: &str = include_str!("look.shader");

/// Writes the shader. `numbers` are those of the uniform's words while nothing is set.
pub(super) fn write(
    request: &PackageRequest<'_>,
    source: &Source,
    leaves: &[Leaf],
    numbers: &[f64],
    images: &[UnityImage<'_>],
) -> String {
    let description = request.description;
    let (queue, blend) = if description.opaque {
        ("\"RenderType\" = \"Opaque\" \"Queue\" = \"Geometry\"", "")
    } else {
        (
            "\"RenderType\" = \"Transparent\" \"Queue\" = \"Transparent\"",
            "            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha\n",
        )
    };
    let shown = match description.color_space {
        ColorSpace::Display => {
            "    // The look's colors are numbers as shown.\n\
             #ifndef UNITY_COLORSPACE_GAMMA\n    \
             color.rgb = linear_from_display(saturate(color.rgb));\n\
             #endif\n"
        }
        ColorSpace::Linear => {
            "    // The look's colors are linear light.\n\
             #ifdef UNITY_COLORSPACE_GAMMA\n    \
             color.rgb = display_from_linear(saturate(color.rgb));\n\
             #endif\n"
        }
    };
    let curve = match description.color_space {
        ColorSpace::Display => LINEAR_FROM_DISPLAY,
        ColorSpace::Linear => DISPLAY_FROM_LINEAR,
    };
    let cuts = source.text.contains("discard;");
    TEMPLATE
        .replace("{{title}}", &plain(request.title))
        .replace("{{stem}}", request.stem)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{queue}}", queue)
        .replace("{{blend}}\n", blend)
        .replace("{{cull}}", if draws_both_sides(request) { "0" } else { "2" })
        .replace("{{properties}}\n", &(images::properties(images) + &properties(leaves, numbers)))
        .replace("{{numbers}}\n", &declarations(leaves))
        .replace("{{attributes}}\n", &attributes(source))
        .replace("{{varyings}}\n", &varyings(source))
        .replace("{{surroundings}}\n", &surroundings(source))
        .replace("{{settings}}\n", &settings(leaves))
        .replace("{{vertex}}\n", &vertex(source))
        .replace("{{inputs}}\n", &inputs(source))
        .replace("{{pixel}}\n", if source.reads_pixel { PIXEL } else { "" })
        .replace("{{curve}}\n", curve)
        .replace("{{depth}}\n", if cuts { DEPTH_OF_CUT } else { DEPTH })
        .replace("{{cut}}\n", if cuts { CUT } else { "" })
        .replace("{{shown}}\n", &indented(shown))
}

/// True if both sides of triangles are drawn: the look cuts parts away, or may.
pub(in crate::export::package) fn draws_both_sides(request: &PackageRequest<'_>) -> bool {
    let draw = request.description.passes.iter().find(|pass| pass.module == "draw");
    draw.is_some_and(|pass| {
        pass.sides == Some(crate::export::description::DrawnSides::Both)
            || pass.sides_parameter.is_some()
    })
}

/// The pixel's place from the picture's upper left corner: positions of targets may have rows from
/// either end.
const PIXEL: &str =
    "        // The pixel, rows from the top of the picture; targets may have them from either end.
        float4 pixel_of(Passed passed)
        {
            float2 seen = passed.projected.xy / passed.projected.w;
            float2 pixel = (0.5 + 0.5 * float2(seen.x, -seen.y)) * _ScreenParams.xy;
            return float4(pixel, passed.clip.zw);
        }

";

const DEPTH: &str = "            float4 depth(Passed passed) : SV_Target
            {
                return passed.clip.z;
            }
";

const DEPTH_OF_CUT: &str =
    "            float4 depth(Passed passed, bool is_front : SV_IsFrontFace) : SV_Target
            {
                // The look cuts parts away.
                fragment_of_look(passed, is_front);
                return passed.clip.z;
            }
";

const CUT: &str = "                // The look cuts parts away.
                fragment_of_look(input.passed, is_front);
";

const LINEAR_FROM_DISPLAY: &str = "        // Linear light of numbers as shown, 0 to 1.
        float3 linear_from_display(float3 shown)
        {
            float3 high = pow((shown + 0.055) / 1.055, 2.4);
            return lerp(high, shown / 12.92, step(shown, 0.04045));
        }
";

const DISPLAY_FROM_LINEAR: &str = "        // Numbers as shown of linear light, 0 to 1.
        float3 display_from_linear(float3 light)
        {
            float3 high = 1.055 * pow(light, 1.0 / 2.4) - 0.055;
            return lerp(high, light * 12.92, step(light, 0.0031308));
        }
";

/// Lines within a function of a pass.
fn indented(text: &str) -> String {
    let line = |line: &str| match line {
        "" => "\n".to_owned(),
        _ => format!("            {line}\n"),
    };
    text.lines().map(line).collect()
}

/// The properties, with the look's own numbers: a material shows the look before its component
/// runs.
fn properties(leaves: &[Leaf], numbers: &[f64]) -> String {
    let line = |leaf: &Leaf| {
        let word = |part: u32| numbers.get((leaf.word + part) as usize).copied();
        let number = |part: u32| match word(part) {
            // ShaderLab reads no numbers beyond those of 32 bits.
            Some(x) if part < leaf.count && x.is_finite() => (x as f32).clamp(f32::MIN, f32::MAX),
            _ => 0.0,
        };
        let (kind, value) = match leaf.count {
            1 if leaf.is_integer() => ("Integer", (number(0) as i32).to_string()),
            1 => ("Float", written(number(0))),
            _ => ("Vector", format!("({})", [0, 1, 2, 3].map(|at| written(number(at))).join(", "))),
        };
        format!("        [HideInInspector] {} (\"\", {kind}) = {value}\n", leaf.property)
    };
    leaves.iter().map(line).collect()
}

/// A number of ShaderLab: the shortest that is the same in 32 bits.
fn written(x: f32) -> String {
    // Zeros without a sign.
    let plain = format!("{}", x + 0.0);
    if plain.len() > 14 { format!("{x:e}") } else { plain }
}

fn declarations(leaves: &[Leaf]) -> String {
    let line = |leaf: &Leaf| {
        let ty = match leaf.count {
            1 if leaf.is_integer() => "int",
            1 => "float",
            _ => "float4",
        };
        format!("        {ty} {};\n", leaf.property)
    };
    leaves.iter().map(line).collect()
}

/// The statements that take the material's numbers.
fn settings(leaves: &[Leaf]) -> String {
    let line = |leaf: &Leaf| {
        let part = match leaf.count {
            2 => ".xy",
            3 => ".xyz",
            _ => "",
        };
        format!("            {} = {}{part};\n", leaf.place, leaf.property)
    };
    leaves.iter().map(line).collect()
}

/// The attribute of Unity's for an attribute of the look's: its declaration, and its value as the
/// look has it.
fn attribute(name: &str) -> Option<(&'static str, &'static str)> {
    Some(match name {
        "position" => ("float3 position : POSITION;", "mirrored(mesh.position)"),
        "normal" => ("float3 normal : NORMAL;", "mirrored(mesh.normal)"),
        // A mirrored cross product points the other way.
        "tangent" => {
            ("float4 tangent : TANGENT;", "float4(mirrored(mesh.tangent.xyz), -mesh.tangent.w)")
        }
        "uv" => ("float2 uv : TEXCOORD0;", "mesh.uv"),
        "color" => ("float4 color : COLOR;", "mesh.color"),
        _ => return None,
    })
}

fn attributes(source: &Source) -> String {
    let mut names: Vec<&str> = source.attributes.iter().map(|it| it.name.as_str()).collect();
    // Shadows and normals need these, whatever the look reads.
    for name in ["position", "normal"] {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let found = names.iter().filter_map(|name| attribute(name));
    found.map(|(declared, _)| format!("            {declared}\n")).collect()
}

/// The varyings of the look: those that have a location.
fn located(fields: &[Field]) -> impl Iterator<Item = &Field> {
    fields.iter().filter(|field| field.semantic.starts_with("LOC"))
}

fn varyings(source: &Source) -> String {
    let mut text = String::new();
    let mut count = 0;
    for field in located(&source.varyings.1) {
        let _ = writeln!(text, "            {} {} : TEXCOORD{count};", field.ty, varying(field));
        count += 1;
    }
    if source.reads_pixel {
        text += "            // Clip space as OpenGL has it, whatever the target is.\n";
        let _ = writeln!(text, "            float4 projected : TEXCOORD{count};");
    }
    text
}

/// Name of a varying between the stages.
fn varying(field: &Field) -> String {
    format!("varying{}", field.semantic.trim_start_matches("LOC"))
}

fn vertex(source: &Source) -> String {
    let mut text = "            Vertex vertex;\n".to_owned();
    for field in &source.attributes {
        if let Some((_, value)) = attribute(&field.name) {
            let _ = writeln!(text, "            vertex.{} = {value};", field.name);
        }
    }
    let (ty, fields) = &source.varyings;
    let _ = writeln!(text, "            {ty} look_vertex = vs_main(vertex);");
    text += "            Passed passed;\n";
    for field in fields {
        if field.semantic == "SV_Position" {
            let _ = writeln!(text, "            passed.clip = look_vertex.{};", field.name);
        }
    }
    for field in located(fields) {
        let _ =
            writeln!(text, "            passed.{} = look_vertex.{};", varying(field), field.name);
    }
    if source.reads_pixel {
        text += "            float3 world = TransformObjectToWorld(mesh.position);\n            \
                 passed.projected = mul(unity_CameraProjection, \
                 mul(UNITY_MATRIX_V, float4(world, 1.0)));\n";
    }
    text
}

fn inputs(source: &Source) -> String {
    let (ty, fields) = &source.inputs;
    let mut text = format!("            {ty} input;\n");
    for field in fields {
        let value = match field.semantic.as_str() {
            "SV_Position" if source.reads_pixel => "pixel_of(passed)".to_owned(),
            "SV_Position" => "passed.clip".to_owned(),
            "SV_IsFrontFace" => "is_front".to_owned(),
            _ => format!("passed.{}", varying(field)),
        };
        let _ = writeln!(text, "            input.{} = {value};", field.name);
    }
    text
}

/// The statements that take what Unity has bound, and a function for the pixel's place.
fn surroundings(source: &Source) -> String {
    let mut text = String::new();
    for (name, ty) in &source.blocks {
        let members: &[(&str, &str)] = match ty.as_str() {
            "View" => &[
                ("clip_from_world", "transpose(mul(UNITY_MATRIX_VP, MIRROR))"),
                ("camera_from_world", "transpose(mul(UNITY_MATRIX_V, MIRROR))"),
                ("eye", "eye_of_camera()"),
                // `pixel_of` counts rows from the top.
                ("screen", "float4(1.0, 1.0, 0.0, 0.0)"),
            ],
            "Object" => &[
                ("world_from_object", "transpose(mul(mul(MIRROR, UNITY_MATRIX_M), MIRROR))"),
                ("world_from_normal", "(float3x3)mul(mul(MIRROR, UNITY_MATRIX_I_M), MIRROR)"),
                ("id", "_object_id"),
                ("cutoff", "0.0"),
                ("material", "0.0"),
            ],
            _ => continue,
        };
        let known = source.members(ty).unwrap_or_default();
        for (member, value) in members {
            if known.iter().any(|field| field.name == *member) {
                let _ = writeln!(text, "            {name}.{member} = {value};");
            }
        }
    }
    text
}
