//! Frame of the module around a look: structs, bindings and entry points.

use std::fmt::Write as _;

use super::attributes::{SurfaceVarying, VARYINGS, VertexAttribute};
use super::loops::is_struct;
use super::surface::{ExpressionInputs, expression};
use super::{Binding, BindingKind, Emitter};
use crate::compile::ImageShape;
use crate::compile::functions::write_line;
use crate::compile::host::UniformMember;
use crate::compile::intervals;
use crate::compile::specialize::aov_name;
use crate::document::{ColorSpace, Tier};
use crate::library::{PassId, StageValue, Type};

/// Names that the frame uses, kept from the artist's; those of passes' maps stand in their rows.
pub(super) const RESERVED: &[&str] = &[
    "View",
    "Object",
    "Look",
    "Surface",
    "Sample",
    "Vertex",
    "Varyings",
    "Shaded",
    "Targets",
    "view",
    "object",
    "look",
    "surface",
    "samples",
    "casters",
    "shadow_map",
    "shadow_map_behind",
    "shade",
    "vs_main",
    "fs_main",
    "SAMPLES_PER_ROW",
];

/// Number of samples in a row of an evaluation's target; each sample takes two by two pixels.
pub const SAMPLES_PER_ROW: u32 = 256;

const VIEW: &str = "\
struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
}
";

/// `View` of a look that reads the pixel's place in the picture.
const VIEW_WITH_SCREEN: &str = "\
struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    screen: vec4f,
}
";

/// First members of `Object`, which every module has.
const OBJECT: &str = "\
struct Object {
    world_from_object: mat4x4f,
    /// The inverse transpose, for normals.
    world_from_normal: mat3x3f,
    id: f32,
";

/// Member of `Object` in a module that tells the materials of one object apart.
const OBJECT_MATERIAL: &str = "    \
    /// The number of the material, from 0 on, for the borders of materials.
    material: f32,
";

/// Member of `Object` in a module that a mesh's material may cut. The material's number stands
/// before it, so that every module finds each member in the same place.
const OBJECT_CUTOFF: &str = "    \
    /// The alpha cutoff of the material, 0 for none.
    cutoff: f32,
";

impl Emitter<'_> {
    /// True if the picture's colors are encoded for display where they leave the shader.
    fn encodes(&self) -> bool {
        self.options.display
            && self.options.stage.is_picture()
            && self.graph.color_space == ColorSpace::Linear
    }

    /// True if ranges prove every number of what is shown finite.
    fn is_finite_root(&self) -> bool {
        let root = &self.special.values[self.special.root];
        let is_color = matches!(root.ty, Type::Color | Type::Vec4 | Type::Float | Type::Vec3);
        let is_finite = |range: &intervals::Range| match range {
            intervals::Range::Float(x) => x.is_within(-f64::from(f32::MAX), f32::MAX.into()),
            _ => true,
        };
        !self.options.unspecialized
            && is_color
            && root.ranges_in_fragments().is_some_and(|ranges| ranges.iter().all(is_finite))
    }

    /// True if what is shown is known to be a unit vector.
    fn is_unit_root(&self) -> bool {
        let root = &self.special.values[self.special.root];
        let is_unit = |range: &intervals::Range| match range {
            intervals::Range::Float(x) => x.length == intervals::Length::One && !x.nan,
            _ => false,
        };
        matches!(self.options.stage.row().value, StageValue::Context(_))
            || root.ranges.as_ref().is_some_and(|ranges| ranges.iter().all(is_unit))
    }

    /// The functions of the library that the frame may call.
    pub(super) fn frame_functions(&self) -> Vec<String> {
        let stage = self.options.stage;
        if !stage.draws_meshes() {
            return Vec::new();
        }
        let root = &self.special.values[self.special.root].ty;
        let own = [
            (self.normalize_seen(), true),
            ("normalize_or", stage.draws_normals() && !self.is_unit_root()),
            ("surface_texel", stage.draws_normals()),
            ("facet_number", stage.row().tells_parts),
            ("straight", *root == Type::Composite || self.straightens_beside()),
            ("angle_radians", *root == Type::Angle || self.has_angles_beside()),
            ("finite_vec4", !stage.draws_normals() && (!self.is_finite_root() || self.has_aovs())),
            ("display_from_linear", self.encodes()),
            ("linear_from_display", self.graph.color_space == ColorSpace::Linear),
        ];
        let own = own.into_iter().filter(|(_, is_used)| *is_used).map(|(name, _)| name.to_owned());
        let contexts = self.needs.contexts.iter();
        own.chain(contexts.flat_map(|context| ExpressionInputs::at(*context, stage).functions))
            .collect()
    }

    /// True if the module writes values beside the picture.
    fn has_aovs(&self) -> bool {
        self.options.stage.is_picture() && !self.graph.aovs.is_empty()
    }

    fn straightens_beside(&self) -> bool {
        self.has_aovs() && (0..self.graph.aovs.len()).any(|number| self.is_straightened(number))
    }

    fn has_angles_beside(&self) -> bool {
        let mut beside = self.special.beside.iter();
        beside.any(|output| self.special.values[output.value].ty == Type::Angle)
    }

    /// The targets of the fragment's values: the picture, and each value beside it.
    fn write_targets(&mut self) {
        self.out.push_str("\nstruct Targets {\n    @location(0) picture: vec4f,\n");
        for number in 0..self.graph.aovs.len() {
            let (location, name) = (number + 1, aov_name(number));
            let _ = writeln!(self.out, "    @location({location}) {name}: vec4f,");
        }
        self.out.push_str("}\n");
    }

    /// True if a value beside the picture is a part of a picture that may be transparent.
    fn is_straightened(&self, number: usize) -> bool {
        let aov = self.graph.aovs[number].as_ref().ok().and_then(Option::as_ref);
        aov.is_some_and(|aov| aov.is_part_of_picture()) && !self.special.is_opaque()
    }

    /// The values beside a picture's pixel, each with the pixel's alpha.
    fn aov_pixels(&self) -> Vec<String> {
        let value = |number: usize| {
            let name = aov_name(number);
            let Some(value) = self.special.named(&name) else {
                return "vec4f(0.0, 0.0, 0.0, pixel.w)".to_owned();
            };
            let numbers = beside(&self.special.values[value].ty, &format!("shaded.{name}"));
            if self.is_straightened(number) {
                // What is drawn is multiplied by the pixel's alpha, which contributions hold.
                return format!("finite_vec4(straight(vec4f({numbers}, pixel.w)))");
            }
            format!("finite_vec4(vec4f({numbers}, pixel.w))")
        };
        (0..self.graph.aovs.len()).map(value).collect()
    }

    /// The pass whose surfaces the module leaves out.
    fn front(&self) -> Option<PassId> {
        self.options.stage.row().behind.and_then(PassId::from_slug)
    }

    /// The name of the function that normalizes what is interpolated, in the cheapest tier that all
    /// nodes of the look allow.
    fn normalize_seen(&self) -> &'static str {
        let nodes =
            self.calls.iter().map(|&id| self.graph.nodes[self.special.values[id].node].tier);
        let is_exact = self.options.unspecialized || nodes.min().is_none_or(|t| t == Tier::Exact);
        if is_exact { "normalize_seen" } else { "normalize_seen_balanced" }
    }

    pub(super) fn write_structs(&mut self) {
        let draws_meshes = self.options.stage.draws_meshes();
        if draws_meshes {
            let reads_screen = self.needs.contexts.iter().any(|c| ExpressionInputs::of(*c).screen);
            self.out.push_str(if reads_screen { VIEW_WITH_SCREEN } else { VIEW });
            self.out.push('\n');
            let cutout = self.options.cutout;
            self.out.push_str(OBJECT);
            if self.options.stage.row().tells_parts || cutout || self.options.mattes {
                self.out.push_str(OBJECT_MATERIAL);
            }
            self.out.push_str(if cutout { OBJECT_CUTOFF } else { "" });
            self.out.push_str("}\n");
            self.out.push('\n');
        }
        if !self.host.members.is_empty() {
            self.write_element_structs();
            self.out.push_str("/// What is known before the fragment.\nstruct Look {\n");
            let mut after_struct = false;
            let mut lines = String::new();
            let mut array = "";
            for member in &self.host.members {
                let (line, is_struct) = match &member.place {
                    Some(place) if place.array == array => continue,
                    Some(place) => {
                        array = &place.array;
                        (format!("{array}: array<{}, {}>,", place.element, place.count), true)
                    }
                    None => (self.member_line(member, &member.name), is_struct(&member.ty)),
                };
                // Uniform buffers want structs, and what follows one, on 16 bytes.
                let align = if is_struct || after_struct { "@align(16) " } else { "" };
                let _ = writeln!(lines, "    {align}{line}");
                after_struct = is_struct;
            }
            self.out.push_str(&lines);
            self.out.push_str("}\n\n");
        }
        if self.has_surface() {
            self.out.push_str(
                "/// The surface under the fragment, in world space.\nstruct Surface {\n",
            );
            for context in &self.needs.contexts {
                let ty = Type::from_wgsl(context.wgsl_type());
                let _ = writeln!(self.out, "    {}: {},", context.word(), ty.wgsl());
            }
            self.out.push_str("}\n\n");
        }
        if !draws_meshes {
            self.out.push_str("struct Sample {\n");
            if self.has_surface() {
                self.out.push_str("    surface: Surface,\n");
            }
            if !self.host.members.is_empty() {
                self.out.push_str("    look: Look,\n");
            }
            // A struct may not be empty.
            self.out.push_str("    padding: vec4f,\n}\n\n");
        }
    }

    /// The declaration of a member by this name.
    pub(super) fn member_line(&self, member: &UniformMember, name: &str) -> String {
        let node = self
            .host_steps
            .iter()
            .find(|(_, step)| **step == member.step)
            .map_or(0, |(id, _)| self.special.values[*id].node);
        let ty = if member.ty == Type::Bool {
            "u32".to_owned()
        } else {
            self.type_name(&member.ty, node)
        };
        format!("{name}: {ty},")
    }

    pub(super) fn image_name(&self, image: usize) -> String {
        format!("image_{}", image + 1)
    }

    pub(super) fn write_bindings(&mut self) -> Vec<Binding> {
        let mut bindings: Vec<(BindingKind, String, String)> = Vec::new();
        let texture = "texture_2d<f32>";
        let mut push = |kind, name: &str, declaration: String| {
            bindings.push((kind, name.to_owned(), declaration));
        };
        if self.options.stage.draws_meshes() {
            push(BindingKind::View, "view", "var<uniform> view: View;".to_owned());
            push(BindingKind::Object, "object", "var<uniform> object: Object;".to_owned());
            if !self.host.members.is_empty() {
                push(BindingKind::Look, "look", "var<uniform> look: Look;".to_owned());
            }
            // Passes are made from normals, so that what draws those cannot read them.
            let draws_normals = self.options.stage.draws_normals();
            let mut passes: Vec<PassId> = Vec::new();
            for pass in self.needs.contexts.iter().filter_map(|context| context.pass()) {
                if !draws_normals && !passes.contains(&pass) {
                    passes.push(pass);
                    let name = pass.row().map;
                    push(BindingKind::Pass(pass), name, format!("var {name}: {texture};"));
                }
            }
            // What lies behind is what the pass of the first surfaces does not show.
            if let Some(front) = self.front() {
                let name = front.row().map;
                push(BindingKind::Pass(front), name, format!("var {name}: {texture};"));
            }
        } else {
            let samples = "var<storage, read> samples: array<Sample>;".to_owned();
            push(BindingKind::Samples, "samples", samples);
        }
        for resource in &self.needs.resources {
            let (name, ty) = (resource.word(), resource.wgsl_type());
            let kind = resource.pass().map_or(BindingKind::Casters, BindingKind::Pass);
            push(kind, name, format!("var {name}: {ty};"));
        }
        for image in 0..self.needs.images.len() {
            if self.image_is_used(image) {
                let name = self.image_name(image);
                let (shape, texture) =
                    (self.needs.images[image].shape, self.needs.images[image].shape.wgsl());
                let kind = match shape {
                    ImageShape::Flat => BindingKind::Image(image),
                    ImageShape::Hcbtf { .. } => BindingKind::Hcbtf(image),
                };
                push(kind, &name, format!("var {name}: {texture};"));
                push(
                    BindingKind::Sampler(image),
                    &format!("{name}_sampler"),
                    format!("var {name}_sampler: sampler;"),
                );
            }
        }
        let mut numbered = Vec::new();
        for (binding, (kind, name, declaration)) in (0u32..).zip(bindings) {
            let _ = writeln!(self.out, "@group(0) @binding({binding}) {declaration}");
            numbered.push(Binding { binding, name, kind });
        }
        if !self.options.stage.draws_meshes() && !self.host.members.is_empty() {
            self.out.push_str("/// Each sample has values of its own.\nvar<private> look: Look;\n");
        }
        self.out.push('\n');
        numbered
    }

    pub(super) fn write_entry_points(&mut self) {
        if self.options.stage.draws_meshes() {
            self.write_vertex();
            self.write_fragment();
        } else {
            self.write_eval();
        }
    }

    fn write_vertex(&mut self) {
        let attributes = self.needs.attributes();
        let out = &mut self.out;
        out.push_str("\nstruct Vertex {\n");
        for attribute in &attributes {
            let (location, name) = (attribute.location(), attribute.name());
            let _ = writeln!(out, "    @location({location}) {name}: {},", attribute.wgsl_type());
        }
        out.push_str("}\n\nstruct Varyings {\n    @builtin(position) clip: vec4f,\n");
        let varyings = self.varyings();
        let out = &mut self.out;
        for (location, SurfaceVarying { name, wgsl_type, .. }) in varyings.iter().enumerate() {
            let _ = writeln!(out, "    @location({location}) {name}: {wgsl_type},");
        }
        out.push_str("}\n\n@vertex\nfn vs_main(vertex: Vertex) -> Varyings {\n");
        out.push_str("    let world = object.world_from_object * vec4f(vertex.position, 1.0);\n");
        let values = varyings.iter().map(|varying| varying.value_on(self.options.deformed));
        let values: Vec<&str> =
            std::iter::once("view.clip_from_world * world").chain(values).collect();
        write_line(&format!("return Varyings({});", values.join(", ")), 1, out);
        out.push_str("}\n");
    }

    /// The varyings that the fragment reads.
    fn varyings(&self) -> Vec<&'static SurfaceVarying> {
        let attributes = self.needs.attributes();
        let reads: Vec<ExpressionInputs> =
            self.needs.contexts.iter().map(|c| ExpressionInputs::of(*c)).collect();
        let is_read = |varying: &&SurfaceVarying| match varying.attribute {
            // Normals are drawn with their depth.
            VertexAttribute::Position => {
                reads.iter().any(|reads| reads.varying(varying.name))
                    || (varying.name == "position" && self.options.stage.draws_normals())
            }
            attribute => attributes.contains(&attribute),
        };
        VARYINGS.iter().filter(is_read).collect()
    }

    fn write_fragment(&mut self) {
        let stage = self.options.stage;
        let draws_normals = stage.draws_normals();
        let uses_front = self.needs.contexts.iter().any(|c| ExpressionInputs::at(*c, stage).normal);
        let front = if uses_front { ", @builtin(front_facing) is_front: bool" } else { "" };
        let has_aovs = self.has_aovs();
        if has_aovs {
            self.write_targets();
        }
        let result = if has_aovs { "Targets" } else { "@location(0) vec4f" };
        let _ = writeln!(self.out, "\n@fragment\nfn fs_main(in: Varyings{front}) -> {result} {{");
        if uses_front {
            let normalize = self.normalize_seen();
            let _ = writeln!(self.out, "    let facing = {normalize}(in.normal);");
            self.out.push_str(if draws_normals {
                // Slivers at outlines may be taken for backs; turned around, one of them would bend
                // all that is near.
                // Nothing nearer than the near plane is drawn, so that this has a length.
                "    let toward = normalize(view.eye.xyz - view.eye.w * in.position);\n    \
                 let is_behind = !is_front && dot(facing, toward) < -0.1;\n    \
                 let normal = select(facing, -facing, is_behind);\n"
            } else {
                "    let normal = select(-facing, facing, is_front);\n"
            });
        }
        let arguments = if self.has_surface() {
            let values = self.needs.contexts.iter().map(|&context| {
                let value = expression(context, stage);
                let is_color = Type::from_wgsl(context.wgsl_type()) == Type::Color;
                if is_color && self.graph.color_space == ColorSpace::Linear {
                    format!("linear_from_display({value})")
                } else {
                    value
                }
            });
            let values: Vec<String> = values.collect();
            let line = format!("let surface = Surface({});", values.join(", "));
            write_line(&line, 1, &mut self.out);
            "surface"
        } else {
            ""
        };
        let root = &self.special.values[self.special.root].ty;
        let is_read_once = self.special.beside.is_empty() && *root != Type::Light;
        let call = format!("shade({arguments})");
        if !is_read_once {
            let _ = writeln!(self.out, "    let shaded = {call};");
        }
        if self.special.cutoff().is_some() {
            let cutoff = if self.options.cutout {
                "max(shaded.cutoff, object.cutoff)"
            } else {
                "shaded.cutoff"
            };
            let _ =
                writeln!(self.out, "    if shaded.color.w < {cutoff} {{\n        discard;\n    }}");
        }
        let value = if is_read_once {
            call.as_str()
        } else if self.special.beside.is_empty() {
            "shaded"
        } else {
            "shaded.value"
        };
        let _ = if draws_normals {
            // Texels hold unit normals. A normal that an artist wires may have any length.
            let unit = if self.is_unit_root() {
                "seen"
            } else {
                "normalize_or(seen, vec3f(0.0, 0.0, 1.0))"
            };
            let number = match self.special.named("id") {
                _ if !stage.row().tells_parts => "object.id + 1.0",
                Some(_) => "facet_number(object.id, object.material, shaded.id)",
                None => "facet_number(object.id, object.material, 0.0)",
            };
            let left_out = self.front().map_or_else(String::new, |front| {
                let map = front.row().map;
                format!(
                    "    // No nearer than the first surface, but for rounding.\n    \
                     let first = textureLoad({map}, vec2i(in.clip.xy), 0).z;\n    \
                     if depth <= first + 1e-5 * abs(first) {{\n        discard;\n    }}\n"
                )
            });
            writeln!(
                self.out,
                "    let seen = (view.camera_from_world * vec4f({value}, 0.0)).xyz;\n    \
                 let depth = -(view.camera_from_world * vec4f(in.position, 1.0)).z;\n\
                 {left_out}    \
                 return surface_texel({unit}, depth, {number});\n}}"
            )
        } else {
            self.write_pixel(value)
        };
    }

    /// Writes the end of a fragment that draws the picture, whose color is `value`.
    fn write_pixel(&mut self, value: &str) -> std::fmt::Result {
        let pixel = shown(&self.special.values[self.special.root].ty, value);
        let pixel = if self.is_finite_root() { pixel } else { format!("finite_vec4({pixel})") };
        let pixel = if self.encodes() { format!("display_from_linear({pixel})") } else { pixel };
        let is_cut = self.special.cutoff().is_some() && self.options.cutout;
        if self.options.mattes {
            return write_matte(&pixel, is_cut, self.special.is_opaque(), &mut self.out);
        }
        if !is_cut && !self.has_aovs() {
            return writeln!(self.out, "    return {pixel};\n}}");
        }
        writeln!(self.out, "    let pixel = {pixel};")?;
        let picture = if is_cut {
            // A material with a mask is opaque wherever it is not cut out (glTF 2.0, 3.9.4).
            "vec4f(pixel.xyz, select(pixel.w, 1.0, object.cutoff > 0.0))"
        } else {
            "pixel"
        };
        if self.has_aovs() {
            let values = std::iter::once(picture.to_owned()).chain(self.aov_pixels());
            let line = format!("return Targets({});", values.collect::<Vec<_>>().join(", "));
            write_line(&line, 1, &mut self.out);
            writeln!(self.out, "}}")
        } else {
            writeln!(self.out, "    return {picture};\n}}")
        }
    }

    fn write_eval(&mut self) {
        let _ = writeln!(
            self.out,
            "\nconst SAMPLES_PER_ROW = {SAMPLES_PER_ROW}u;\n\n@vertex\nfn \
             vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {{\n    \
             // One triangle over a viewport of twice the target's size: it covers the target and \
             is not clipped, for a\n    \
             // clipped one falls into two whose seam cuts through the pixels of a sample.\n    \
             return vec4f(f32(index >> 1u) * 2.0 - 1.0, 1.0 - f32(index & 1u) * 2.0, 0.0, \
             1.0);\n}}\n\n\
             @fragment\nfn fs_main(@builtin(position) at: vec4f) -> @location(0) vec4f {{\n    \
             // Two by two pixels a sample: every derivative is 0.\n    \
             let index = (u32(at.y) / 2u) * SAMPLES_PER_ROW + u32(at.x) / 2u;\n    \
             let place = min(index, arrayLength(&samples) - 1u);"
        );
        if !self.host.members.is_empty() {
            self.out.push_str("    look = samples[place].look;\n");
        }
        let arguments = if self.has_surface() { "samples[place].surface" } else { "" };
        let root = &self.special.values[self.special.root].ty;
        let _ = writeln!(
            self.out,
            "    let value = shade({arguments});\n    return {};\n}}",
            raw(root, "value")
        );
    }
}

/// Writes the end of a fragment of a matte: the numbers of its object and its material. What lets
/// more than half of what is behind through is no part of a matte.
fn write_matte(pixel: &str, is_cut: bool, is_opaque: bool, out: &mut String) -> std::fmt::Result {
    // Three numbers that half floats hold exactly.
    let numbers =
        "vec4f(object.id % 1024.0 + 1.0, floor(object.id / 1024.0), object.material, 1.0)";
    if !is_opaque {
        let cut = if is_cut { " && object.cutoff <= 0.0" } else { "" };
        writeln!(out, "    if ({pixel}).w < 0.5{cut} {{\n        discard;\n    }}")?;
    }
    writeln!(out, "    return {numbers};\n}}")
}

/// A value of any type as three numbers; colors are premultiplied.
fn beside(ty: &Type, value: &str) -> String {
    match ty {
        Type::Float | Type::Int => format!("f32({value}), 0.0, 0.0"),
        Type::Bool => format!("select(0.0, 1.0, {value}), 0.0, 0.0"),
        Type::Vec2 => format!("{value}, 0.0"),
        Type::Angle => format!("angle_radians({value}), 0.0, 0.0"),
        Type::Light => format!("{value}.color * {value}.intensity"),
        Type::Composite => format!("{value}.xyz"),
        Type::Color | Type::Vec4 => format!("{value}.xyz * clamp({value}.w, 0.0, 1.0)"),
        _ => value.to_owned(),
    }
}

/// A value of any type as a pixel.
fn shown(ty: &Type, value: &str) -> String {
    match ty {
        Type::Float | Type::Int => format!("vec4f(vec3f(f32({value})), 1.0)"),
        Type::Bool => format!("vec4f(vec3f(select(0.0, 1.0, {value})), 1.0)"),
        Type::Vec2 => format!("vec4f({value}, 0.0, 1.0)"),
        Type::Vec3 => format!("vec4f({value}, 1.0)"),
        Type::Composite => format!("straight({value})"),
        Type::Angle => format!("vec4f(vec3f(angle_radians({value}) / 3.14159265), 1.0)"),
        Type::Light => format!("vec4f({value}.color * {value}.intensity, 1.0)"),
        Type::Mat3 => format!("vec4f({value}[0], 1.0)"),
        _ => value.to_owned(),
    }
}

/// A value of any type as four numbers to read back.
fn raw(ty: &Type, value: &str) -> String {
    match ty {
        Type::Float | Type::Int => format!("vec4f(f32({value}), 0.0, 0.0, 0.0)"),
        Type::Bool => format!("vec4f(select(0.0, 1.0, {value}), 0.0, 0.0, 0.0)"),
        Type::Vec2 => format!("vec4f({value}, 0.0, 0.0)"),
        Type::Vec3 => format!("vec4f({value}, 0.0)"),
        Type::Angle => format!("vec4f({value}.half_sin, {value}.half_cos, 0.0, 0.0)"),
        Type::Light => format!("vec4f({value}.direction, {value}.intensity)"),
        Type::Mat3 => format!("vec4f({value}[0], 0.0)"),
        _ => value.to_owned(),
    }
}
