//! The look's shader for Bevy: WGSL with its preprocessor's words.

use std::fmt::Write as _;

use serde_json::Value;

use super::super::super::header;
use super::super::rust::FragmentEntry;
use super::super::{PackageRequest, javascript};
use crate::document::ColorSpace;

/// Functions that take camera and object from Bevy; words in capitals are places.
const ENTRIES: &str = "
/// The camera, as Bevy has it.
fn view_of_camera() -> View {
    let is_parallel = mesh_view_bindings::view.clip_from_view[3].w == 1.0;
    let eye = vec4f(mesh_view_bindings::view.world_position, 1.0);
    let toward = vec4f(mesh_view_bindings::view.world_from_view[2].xyz, 0.0);
    return View(
        mesh_view_bindings::view.clip_from_world,
        mesh_view_bindings::view.view_from_world,
        select(eye, toward, is_parallel),SCREEN
    );
}

/// The mesh in its place, as Bevy has it.
fn object_of_mesh(instance: u32) -> Object {
    return object_in_place(mesh_functions::get_world_from_local(instance));
}

/// An object in its place.
fn object_in_place(world_from_object: mat4x4f) -> Object {
    let x = world_from_object[0].xyz;
    let y = world_from_object[1].xyz;
    let z = world_from_object[2].xyz;
    let cofactors = mat3x3f(cross(y, z), cross(z, x), cross(x, y));
    return Object(world_from_object, cofactors * (1.0 / dot(x, cofactors[0])), 0.0MATERIAL);
}
";

/// Columns of an object's matrix, as members of what fragments are given name them.
const COLUMNS: [&str; 4] = ["x", "y", "z", "origin"];

/// The entry point of fragments for looks whose colors are as shown: Bevy's targets encode.
const DISPLAY: &str = "
/// Linear light of a color as shown: Bevy's targets encode what is drawn.
LINEAR_OF_SHOWN

@fragment
fn fragment(PARAMETERS) -> @location(0) vec4f {
    view = view_of_camera();
    let shown = look_color(ARGUMENTS);
    return vec4f(linear_of_shown(shown.rgb), shown.a);
}
";

/// The entry point of fragments for looks in linear light.
const LINEAR: &str = "
@fragment
fn fragment(PARAMETERS) -> @location(0) vec4f {
    view = view_of_camera();
    return look_color(ARGUMENTS);
}
";

/// Bindings of an image and its sampler in the material's group, by the image's index.
pub(super) fn places(image: usize) -> (usize, usize) {
    (1 + 2 * image, 2 + 2 * image)
}

/// A texture that an earlier pass draws.
pub(super) struct PassMap {
    /// Name of the texture in the shader.
    pub(super) name: String,
    /// Binding in the material's group.
    pub(super) binding: usize,
    /// Indices of the pass and of its output.
    pub(super) source: [usize; 2],
    /// True for an array of layers.
    pub(super) is_array: bool,
}

/// The textures of earlier passes that the module reads.
pub(super) fn pass_maps(request: &PackageRequest<'_>, module: &Value) -> Vec<PassMap> {
    let passes = &request.description.passes;
    let bindings = module["bindings"].as_array().into_iter().flatten();
    let read = bindings.filter(|binding| binding["feed"]["from"] == "pass");
    let first = places(request.description.images.len()).0;
    let map = |(index, binding): (usize, &Value)| {
        let feed = &binding["feed"];
        let pass = passes.iter().position(|it| feed["pass"] == it.name).unwrap_or_default();
        let outputs = passes.get(pass).map(|it| it.outputs.as_slice()).unwrap_or_default();
        let output = outputs.iter().position(|it| feed["output"] == it.name);
        PassMap {
            name: binding["name"].as_str().unwrap_or_default().to_owned(),
            binding: first + index,
            source: [pass, output.unwrap_or_default()],
            is_array: binding["type"].as_str().is_some_and(|it| it.contains("array")),
        }
    };
    read.enumerate().map(map).collect()
}

/// The shader; `None` for a source that has not the form that the compiler gives it.
pub(super) fn write(request: &PackageRequest<'_>, module: &Value) -> Option<String> {
    let source = javascript::source(request.sources, "wgsl", "draw", ".wgsl");
    // The header's lines are about the WGSL of other packages.
    let (_, source) = source.split_once("\n\n")?;
    let maps = pass_maps(request, module);
    let mut text = header::comment(&[
        format!("{}: made by Chiaro {}, WGSL for Bevy.", request.title, env!("CARGO_PKG_VERSION")),
        "Camera and object are Bevy's; the look's own bindings lie in the material's group."
            .to_owned(),
    ]);
    text += "\n#import bevy_pbr::{mesh_functions, mesh_view_bindings}\n\n";
    text += source;
    for binding in module["bindings"].as_array().into_iter().flatten() {
        let old = format!("@group(0) @binding({}) ", binding["wgsl"]["binding"]);
        let image = binding["feed"]["image"].as_u64().unwrap_or_default() as usize;
        let group = "@group(#{MATERIAL_BIND_GROUP})";
        let name = binding["name"].as_str().unwrap_or_default();
        let new = match binding["feed"]["from"].as_str()? {
            "pass" => {
                let map = maps.iter().find(|map| map.name == name)?;
                format!("{group} @binding({}) ", map.binding)
            }
            "view" | "object" => String::new(),
            "look" => format!("{group} @binding(0) "),
            "image" => format!("{group} @binding({}) ", places(image).0),
            _ => format!("{group} @binding({}) ", places(image).1),
        };
        text = text.replacen(&old, &new, 1);
    }
    for name in ["view", "object"] {
        text = text.replacen(&format!("var<uniform> {name}:"), &format!("var<private> {name}:"), 1);
    }
    let members = |feed: &str| {
        let mut bindings = module["bindings"].as_array().into_iter().flatten();
        let found = bindings.find(|binding| binding["feed"]["from"] == feed);
        let members = found.and_then(|binding| binding["members"].as_array());
        let has = |name: &str| members.is_some_and(|it| it.iter().any(|it| it["name"] == name));
        (has("screen"), has("material"))
    };
    let (has_screen, has_material) = (members("view").0, members("object").1);
    let entries = ENTRIES
        .replace("SCREEN", if has_screen { "\n        vec4f(1.0, 1.0, 0.0, 0.0)," } else { "" })
        .replace("MATERIAL", if has_material { ", 0.0" } else { "" });
    let (before, after) = text.split_once("\n@vertex\n")?;
    let (vertex, fragment) = after.split_once("\n@fragment\n")?;
    let is_code = |line: &&str| !line.trim_start().starts_with("//");
    let mut code = before.lines().chain(fragment.lines()).filter(is_code);
    let reads_object = code.any(reads_object);
    let mut before = before.to_owned();
    let mut vertex = vertex.to_owned();
    if reads_object {
        (before, vertex) = with_place(&before, &vertex)?;
    }
    let before = before.replacen(
        "struct Vertex {\n",
        "struct Vertex {\n    @builtin(instance_index) instance: u32,\n",
        1,
    );
    let vertex = vertex
        .replacen("fn vs_main(", "fn vertex(", 1)
        .replacen(
            "{\n",
            "{\n    view = view_of_camera();\n    object = object_of_mesh(vertex.instance);\n",
            1,
        )
        .replace("vertex.uv", "vec2f(vertex.uv.x, 1.0 - vertex.uv.y)")
        .replace("vertex.", "corner.")
        .replace("(vertex: Vertex)", "(corner: Vertex)");
    let fragment = FragmentEntry::of(fragment)?;
    let is_linear = request.description.color_space == ColorSpace::Linear;
    let entry = if is_linear { LINEAR } else { DISPLAY };
    let mut entry = fragment.fill(entry);
    if reads_object {
        let surface = fragment.surface()?;
        let columns = COLUMNS.map(|name| {
            let w = if name == "origin" { "1.0" } else { "0.0" };
            format!("        vec4f({surface}.object_{name}, {w}),\n")
        });
        let set = format!(
            "view = view_of_camera();\n    object = object_in_place(mat4x4f(\n{}    ));",
            columns.concat()
        );
        entry = entry.replacen("view = view_of_camera();", &set, 1);
    }
    let mut whole = before;
    let function = fragment.function();
    let _infallible = write!(whole, "{entries}\n@vertex\n{vertex}\n{function}{entry}");
    Some(whole)
}

/// True for a line that reads a member of the variable `object`.
fn reads_object(line: &str) -> bool {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    line.match_indices("object.").any(|(at, _)| !line[..at].ends_with(is_word))
}

/// The declarations and the vertex shader with the object's place among what fragments are given.
/// Fragments do not read it from Bevy's buffer: where a pixel beside a triangle is shaded for the
/// sake of derivatives, Vulkan in software reads zeros there.
fn with_place(before: &str, vertex: &str) -> Option<(String, String)> {
    let (start, varyings) = before.split_once("struct Varyings {\n")?;
    let (members, rest) = varyings.split_once("\n}")?;
    let first = members.matches("@location(").count();
    let mut before =
        format!("{start}struct Varyings {{\n{members}\n    // Columns of the object's matrix.\n");
    let (body, end) = vertex.rsplit_once(");\n}")?;
    let mut vertex = format!("{body},");
    for (column, name) in COLUMNS.iter().enumerate() {
        let location = first + column;
        let _infallible =
            writeln!(before, "    @location({location}) @interpolate(flat) object_{name}: vec3f,");
        // Two in a line.
        let between = if column % 2 == 0 { "\n        " } else { " " };
        let comma = if column + 1 < COLUMNS.len() { "," } else { "" };
        let _infallible = write!(vertex, "{between}object.world_from_object[{column}].xyz{comma}");
    }
    Some((format!("{before}}}{rest}"), format!("{vertex});\n}}{end}")))
}
