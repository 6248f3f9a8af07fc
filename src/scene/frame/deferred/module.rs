//! Modules that run a look over the picture, and modules that number triangles beneath.
//!
//! Both are made from the text of a compiled module, whose entry points become functions that new
//! entry points call: what a look computes is written once, and exports know nothing of it.

use std::fmt::Write as _;

use chiaro_locale::tr;

use super::derivatives::Derivatives;
use crate::compile::{CompiledShader, VertexAttribute};
use crate::wgsl::{self, ValidModule};

/// Number of texels in a row of the textures that hold a mesh.
pub const MESH_TEXELS_PER_ROW: u32 = 2048;

const VERTEX_HEAD: &str = "@vertex\nfn vs_main(vertex: Vertex) -> Varyings {";
const VARYINGS_HEAD: &str = "struct Varyings {\n    @builtin(position) clip: vec4f,\n";
const FRONT_HEAD: &str = "@fragment\nfn fs_main(in: Varyings, @builtin(front_facing) is_front: \
                          bool) -> @location(0) vec4f {";
const PLAIN_HEAD: &str = "@fragment\nfn fs_main(in: Varyings) -> @location(0) vec4f {";

/// Module of a look that is drawn over the picture: a pixel's triangle is known, its corners are
/// read, and the look's own functions shade the place in between.
///
/// Group 0 has the bindings of the look's own module. Group 1 has at 0 the picture's triangles, at
/// 1 the [numbers of the draw](super::DeferredDraw::numbers), at 2 the corners of the mesh's
/// triangles, and from 3 on the attributes of its vertices, in their order, as textures of
/// [`MESH_TEXELS_PER_ROW`].
#[derive(Debug)]
pub struct DeferredModule {
    /// Source of the module, in WGSL.
    pub text: String,
    /// The module as naga validated it.
    pub valid: ValidModule,
    /// Attributes that the module reads.
    pub attributes: Vec<VertexAttribute>,
}

impl DeferredModule {
    /// The module for a look's own.
    ///
    /// # Errors
    /// The reason why the look cannot be drawn so.
    pub fn new(shader: &CompiledShader) -> Result<Self, &'static str> {
        if shader.wgsl.contains("discard;") {
            return Err(tr!("it cuts parts of its surface away"));
        }
        let derivatives = Derivatives::of(&shader.valid)?;
        let attributes = shader.needs.attributes();
        let mut text = derivatives.noted(&shader.wgsl)?;
        let has_front = turn_into_functions(&mut text)?;
        text.push_str(BINDINGS);
        write_corners(&mut text, &attributes);
        text.push_str(SURFACE);
        write_fragment(&mut text, &derivatives, has_front);
        let valid = wgsl::parse(&text).map_err(|_| tr!("a name in it is one that this takes"))?;
        Ok(Self { text, valid, attributes })
    }
}

/// The module of a look's surface (slopes, depth and object) that also draws numbers of triangles,
/// at location 1 of its targets: a vertex's number and its instance's, together. 0 is left for
/// pixels that show nothing.
///
/// # Errors
/// The reason why there is none.
pub(super) fn numbered_surface(shader: &CompiledShader) -> Result<String, &'static str> {
    let mut text = shader.wgsl.clone();
    let has_front = turn_into_functions(&mut text)?;
    let members = varyings(&text);
    let (parameter, argument) = front(has_front);
    let of = |owner: &str| {
        let members = members.iter().map(|(_, name, _)| format!("{owner}.{name}"));
        members.collect::<Vec<_>>().join(", ")
    };
    let declared: String = members
        .iter()
        .map(|(attribute, name, ty)| format!("    {attribute} {name}: {ty},\n"))
        .collect();
    let (seen, given) = (of("seen"), of("in"));
    let _ = write!(
        text,
        "
struct DeferredVaryings {{
{declared}    @location(7) @interpolate(flat, first) deferred_triangle: u32,
}}

struct DeferredTexels {{
    @location(0) surface: vec4f,
    @location(1) triangle: u32,
}}

@vertex
fn vs_main(vertex: Vertex, @builtin(vertex_index) number: u32, @builtin(instance_index) first: u32)
    -> DeferredVaryings {{
    let seen = deferred_varyings(vertex);
    return DeferredVaryings({seen}, number + first);
}}

@fragment
fn fs_main(in: DeferredVaryings{parameter}) -> DeferredTexels {{
    return DeferredTexels(deferred_pixel(Varyings({given}){argument}), in.deferred_triangle);
}}
"
    );
    match wgsl::parse(&text) {
        Ok(_) => Ok(text),
        Err(_) => Err(tr!("a name in its surface is one that this takes")),
    }
}

/// Members of the varyings of a module: attribute, name and type of each.
fn varyings(text: &str) -> Vec<(&str, &str, &str)> {
    let members = text.split_once("struct Varyings {\n").map_or("", |(_, after)| after);
    let member = |line: &'_ str| -> Option<(usize, usize)> {
        Some((line.find(") ")? + 1, line.rfind(": ")?))
    };
    let lines = members.lines().take_while(|line| *line != "}").map(str::trim);
    let lines = lines.filter_map(|line| Some((line, member(line)?)));
    lines
        .map(|(line, (name, ty))| {
            (&line[..name], &line[name + 1..ty], line[ty + 2..].trim_end_matches(','))
        })
        .collect()
}

/// Parameter and argument that tell the side that is seen.
fn front(has_front: bool) -> (&'static str, &'static str) {
    if has_front { (", @builtin(front_facing) is_front: bool", ", is_front") } else { ("", "") }
}

/// Turns the entry points of a text into functions `deferred_varyings` and `deferred_pixel`. True
/// if the latter asks for the side that is seen.
fn turn_into_functions(text: &mut String) -> Result<bool, &'static str> {
    let has_front = text.contains(FRONT_HEAD);
    let head = if has_front { FRONT_HEAD } else { PLAIN_HEAD };
    if [VERTEX_HEAD, VARYINGS_HEAD, head].iter().any(|part| text.matches(part).count() != 1) {
        return Err(tr!("its entry points are not those of a generated module"));
    }
    let parameter = if has_front { ", is_front: bool" } else { "" };
    *text = text
        .replacen(VERTEX_HEAD, "fn deferred_varyings(vertex: Vertex) -> Varyings {", 1)
        .replacen(head, &format!("fn deferred_pixel(in: Varyings{parameter}) -> vec4f {{"), 1);
    Ok(has_front)
}

const BINDINGS: &str = "
struct DeferredDraw {
    /// The number of the draw's first triangle in the picture, and how many there are.
    first: u32,
    count: u32,
    /// Bit 0 where back faces are drawn, too; bit 1 where an object is mirrored.
    sides: u32,
}

/// Triangles that the picture's pixels show, counted over all draws from 1; 0 where nothing is.
@group(1) @binding(0) var deferred_triangles: texture_2d<u32>;
@group(1) @binding(1) var<uniform> deferred_draw: DeferredDraw;
/// Vertices of the mesh's triangles.
@group(1) @binding(2) var deferred_corners: texture_2d<u32>;
";

fn write_corners(out: &mut String, attributes: &[VertexAttribute]) {
    for (binding, attribute) in (3..).zip(attributes) {
        let name = attribute.name();
        let _ =
            writeln!(out, "@group(1) @binding({binding}) var deferred_{name}: texture_2d<f32>;");
    }
    let _ = write!(
        out,
        "
/// Place of a texel of the mesh.
fn deferred_texel(index: u32) -> vec2u {{
    return vec2u(index % {MESH_TEXELS_PER_ROW}u, index / {MESH_TEXELS_PER_ROW}u);
}}

/// The vertex in between three, of which it has these shares.
fn deferred_between(corners: vec3u, shares: vec3f) -> Vertex {{
    var vertex: Vertex;
"
    );
    for attribute in attributes {
        let name = attribute.name();
        let channels = match attribute.wgsl_type() {
            "vec2f" => "xy",
            "vec3f" => "xyz",
            _ => "xyzw",
        };
        let _ = write!(out, "    vertex.{name} = ");
        for (index, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let before = if index > 0 { "\n        + " } else { "" };
            let _ = write!(
                out,
                "{before}shares.{axis} * textureLoad(deferred_{name}, \
                 deferred_texel(corners.{axis}), 0).{channels}"
            );
        }
        out.push_str(";\n");
    }
    out.push_str("    return vertex;\n}\n");
}

const SURFACE: &str = "
struct DeferredTriangle {
    corners: vec3u,
    /// Corners in clip space, without their depths.
    a: vec3f,
    b: vec3f,
    c: vec3f,
}

fn deferred_corner(index: u32) -> vec3f {
    let position = textureLoad(deferred_position, deferred_texel(index), 0).xyz;
    let clip = view.clip_from_world * (object.world_from_object * vec4f(position, 1.0));
    return clip.xyw;
}

fn deferred_triangle_of(number: u32) -> DeferredTriangle {
    let corners = textureLoad(deferred_corners, deferred_texel(number), 0).xyz;
    return DeferredTriangle(corners, deferred_corner(corners.x), deferred_corner(corners.y),
        deferred_corner(corners.z));
}

/// Areas that a place of the picture, in pixels, has beside the edges of a triangle, each times
/// what makes them shares of the corners opposite: no corner is divided by its distance, so that
/// corners behind the eye do no harm.
fn deferred_areas(triangle: DeferredTriangle, pixel: vec2f) -> vec3f {
    let size = vec2f(textureDimensions(deferred_triangles));
    let place = vec2f(2.0, -2.0) * pixel / size + vec2f(-1.0, 1.0);
    let a = triangle.a.xy - place * triangle.a.z;
    let b = triangle.b.xy - place * triangle.b.z;
    let c = triangle.c.xy - place * triangle.c.z;
    return vec3f(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x);
}

/// The varyings of a triangle at a place of the picture, in pixels.
fn deferred_seen(triangle: DeferredTriangle, pixel: vec2f) -> Varyings {
    let areas = deferred_areas(triangle, pixel);
    let sum = areas.x + areas.y + areas.z;
    let vertex = deferred_between(triangle.corners, areas / select(sum, 1.0, sum == 0.0));
    var seen = deferred_varyings(vertex);
    seen.clip = vec4f(pixel, 0.0, 1.0);
    return seen;
}

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}
";

fn write_fragment(out: &mut String, derivatives: &Derivatives, has_front: bool) {
    out.push_str(
        "
@fragment
fn fs_main(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let number = textureLoad(deferred_triangles, vec2u(at.xy), 0).x - deferred_draw.first;
    if number >= deferred_draw.count {
        discard;
    }
    let triangle = deferred_triangle_of(number);
",
    );
    let argument = if has_front {
        out.push_str(
            "    let areas = deferred_areas(triangle, at.xy);\n    \
             let is_turned =\n        \
             (areas.x + areas.y + areas.z < 0.0) != (deferred_draw.sides >= 2u);\n    \
             let is_front = !is_turned || (deferred_draw.sides & 1u) == 0u;\n",
        );
        ", is_front"
    } else {
        ""
    };
    if !derivatives.is_empty() {
        out.push_str(
            "    // Quads begin at even pixels.\n    \
             deferred_side = 1.0 - 2.0 * vec2f(vec2u(at.xy) & vec2u(1u));\n",
        );
        for (run, change) in ["deferred_side.x, 0.0", "0.0, deferred_side.y"].iter().enumerate() {
            let _ = write!(
                out,
                "    deferred_run = {run}u;\n    \
                 _ = deferred_pixel(deferred_seen(triangle, at.xy + vec2f({change})){argument});\n"
            );
        }
        out.push_str("    deferred_run = 2u;\n");
        out.push_str(&derivatives.rewound());
    }
    let _ =
        write!(out, "    return deferred_pixel(deferred_seen(triangle, at.xy){argument});\n}}\n");
}
