//! The file `LOOK.ush`: the look as functions that a Custom node calls.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use chiaro_locale::{text, tr};

use super::arguments::{Argument, ArgumentKind};
use super::host::{self, FUNCTION, HostText};
use super::images::{self, UnrealImage};
use super::pieces::{HlslDeclaration, declarations, joined};
use super::plain;
use crate::diag::Diagnostic;
use crate::document::ColorSpace;
use crate::export::package::unity::leaves::{Leaf, leaves};
use crate::export::package::unity::source::{EngineNames, Source};
use crate::export::package::{PackageRequest, refusal};

/// The text around the look's own.
const TEMPLATE: &str = include_str!("look.ush");

/// The shader and what it asks of the material.
pub(super) struct UnrealShader<'a> {
    /// The file.
    pub(super) text: String,
    /// Members of `PixelInUnreal` that the look needs.
    pub(super) inputs: Vec<&'static PixelInput>,
    /// Images that the look reads.
    pub(super) images: Vec<UnrealImage<'a>>,
    /// True if the look cuts parts away.
    pub(super) cuts: bool,
}

/// A member of `PixelInUnreal`.
pub(super) struct PixelInput {
    pub(super) name: &'static str,
    /// Type of the member in HLSL.
    pub(super) ty: &'static str,
    /// Value of the member in the code of the Custom node.
    pub(super) value: &'static str,
}

const fn input(name: &'static str, ty: &'static str, value: &'static str) -> PixelInput {
    PixelInput { name, ty, value }
}

/// All members, in their order. Values are inputs of the Custom node, or what Unreal knows of the
/// view.
const INPUTS: [PixelInput; 17] = [
    input("WorldPosition", "float3", "WorldPosition"),
    input("LocalPosition", "float3", "LocalPosition"),
    input("VertexNormal", "float3", "VertexNormal"),
    input("Tangent", "float3", "Parameters.TangentToWorld[0]"),
    input("Bitangent", "float3", "Parameters.TangentToWorld[1]"),
    input("TwoSidedSign", "float", "TwoSidedSign"),
    input("TexCoord", "float2", "TexCoord"),
    input("VertexColor", "float4", "float4(VertexColor, VertexAlpha)"),
    input("CameraPosition", "float3", "CameraPosition"),
    input("ViewRight", "float3", "ResolvedView.ViewRight"),
    input("ViewUp", "float3", "ResolvedView.ViewUp"),
    input("ViewForward", "float3", "ResolvedView.ViewForward"),
    input("IsParallel", "bool", "ResolvedView.ViewToClip[3][3] >= 1.0"),
    input(
        "ClipScale",
        "float2",
        "float2(ResolvedView.ViewToClip[0][0], ResolvedView.ViewToClip[1][1])",
    ),
    input("Position", "float2", "Parameters.SvPosition.xy - ResolvedView.ViewRectMin.xy"),
    input("ViewSize", "float2", "ResolvedView.ViewSizeAndInvSize.xy"),
    input("ObjectPosition", "float3", "ObjectPosition"),
];

/// The time, which only keys and animated looks read.
const TIME: PixelInput = input("Time", "float", "Time");

/// Unreal's names: a texture that is an input of a Custom node has a sampler of that name.
const UNREAL: EngineNames<'_> = EngineNames {
    taken: &TAKEN,
    image: |name| [format!("{}Image", capitals(name)), format!("{}ImageSampler", capitals(name))],
};

/// `ToneAir` of `tone_air`.
pub(super) fn capitals(words: &str) -> String {
    let words = words.split(|c: char| !c.is_ascii_alphanumeric()).filter(|it| !it.is_empty());
    words.map(|word| word[..1].to_ascii_uppercase() + &word[1..]).collect()
}

/// Names of Unreal's that no namespace hides: constants and macros, and uniform blocks, whose
/// members Unreal finds by the text alone.
const TAKEN: [&str; 10] = [
    "View",
    "Object",
    "Material",
    "Primitive",
    "PI",
    "TWO_PI",
    "HALF_PI",
    "INV_PI",
    "INFINITY",
    "real",
];

/// Writes the shader.
///
/// # Errors
/// - `not-in-package`: what a Custom node does not know.
/// - `export-failed`: a form of HLSL that is not known.
pub(super) fn write<'a>(
    request: &PackageRequest<'a>,
    class: &str,
    arguments: &[Argument<'_>],
) -> Result<UnrealShader<'a>, Diagnostic> {
    let source = Source::of(request, &UNREAL)?;
    let leaves = leaves(request, &source)?;
    let mut look = look(&source);
    let images = images::images(request, &source.images)?;
    let readers = images::handed_on(&mut look, &images);
    refuse(&look)?;
    let of_look = look.iter().map(|it| it.name.clone());
    let taken: BTreeSet<String> = of_look.chain(TAKEN.map(str::to_owned)).collect();
    let host = host::write(request, arguments, &leaves, &taken)?;
    // Functions that naga adds to both texts are there once.
    let of_host: Vec<HlslDeclaration> = host.as_ref().map_or_else(Vec::new, |host| {
        let mut found = declarations(&host.hlsl);
        found.retain(|it| !look.contains(it));
        found
    });
    if let Some(host) = &host {
        refuse_surroundings(host)?;
    }
    let mut body = Body::new(request, &source, &look, host.as_ref());
    body.surroundings();
    body.numbers(arguments, &leaves);
    let of_main = if readers.contains("fs_main") { images::arguments(&images) } else { vec![] };
    body.drawing(&of_main);
    let inputs: Vec<&PixelInput> =
        INPUTS.iter().chain([&TIME]).filter(|it| body.reads(it.name)).collect();
    let members = inputs.iter().map(|it| format!("    {} {};\n", it.ty, it.name));
    let members: String = members.collect();
    let host_text = match of_host.as_slice() {
        [] => String::new(),
        list => format!(
            "// Numbers of the look, from its parameters, lights and surroundings\n\n{}",
            joined(list)
        ),
    };
    let text = TEMPLATE
        .replace("{{title}}", &plain(request.title))
        .replace("{{stem}}", request.stem)
        .replace("{{class}}", class)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{look}}\n", &joined(&look))
        .replace("{{host}}\n\n", &if host_text.is_empty() { host_text } else { host_text + "\n" })
        .replace("{{members}}\n", &members)
        .replace("{{curves}}\n\n", &curves(request, arguments))
        .replace("{{arguments}}", &heads(arguments, &images))
        .replace("{{body}}\n", &body.text);
    Ok(UnrealShader { text, inputs, images, cuts: body.cuts })
}

/// The arguments of the function.
fn heads(arguments: &[Argument<'_>], images: &[UnrealImage<'_>]) -> String {
    let mut text = String::new();
    let mut width = "float4 Draw(".len();
    let arguments = arguments.iter().map(|it| format!("{} {}", it.kind.hlsl(), it.input));
    for one in arguments.chain(images.iter().flat_map(UnrealImage::heads)) {
        let one = format!("{one}, ");
        if width + one.len() > 96 {
            text = text.trim_end().to_owned() + "\n    ";
            width = 4;
        }
        width += one.len();
        text += &one;
    }
    let last = "PixelInUnreal pixel";
    if width + last.len() > 98 {
        text = text.trim_end().to_owned() + "\n    ";
    }
    text + last
}

/// The look's declarations without its vertex stage: a Custom node runs for pixels.
fn look(source: &Source) -> Vec<HlslDeclaration> {
    let body = source.text.split_once("\n\n").map_or(source.text.as_str(), |(_, body)| body);
    let body = body.replace("// Filled by the shader's entry points.\n", "// Filled by `Draw`.\n");
    let body = body.replace("discard;", "is_cut = true;");
    let mut found = declarations(&body);
    let vertex = [source.varyings.0.as_str(), "Vertex", "vs_main", "ConstructVaryings"];
    found.retain(|it| !vertex.contains(&it.name.as_str()));
    let is_read =
        |found: &[HlslDeclaration], part: &str| found.iter().any(|it| it.text.contains(part));
    if !is_read(&found, "object.") {
        found.retain(|it| it.name != "LookObject" && it.name != "object");
    }
    for member in ["clip_from_world", "screen"] {
        if !is_read(&found, &format!("view.{member}"))
            && let Some(view) = found.iter_mut().find(|it| it.name == "LookView")
        {
            view.text = without_member(&view.text, member);
        }
    }
    if is_read(&found, "is_cut = true;") {
        let at = found.iter().position(|it| it.name == "view").unwrap_or_default();
        let text = "// True where the look is cut away.\nstatic bool is_cut;".to_owned();
        found.insert(at, HlslDeclaration { name: "is_cut".to_owned(), text });
    }
    found
}

/// A struct without a member and the comment before it.
fn without_member(text: &str, member: &str) -> String {
    let mut kept: Vec<&str> = Vec::new();
    for line in text.lines() {
        if line.ends_with(&format!(" {member};")) {
            while kept.last().is_some_and(|line| line.trim_start().starts_with("///")) {
                kept.pop();
            }
        } else {
            kept.push(line);
        }
    }
    kept.join("\n")
}

/// Refuses what a Custom node does not know of a pixel.
fn refuse(look: &[HlslDeclaration]) -> Result<(), Diagnostic> {
    let refusal = |what: &str| {
        let message = tr!("the look reads {what}, which the package unreal does not carry yet");
        let help = tr!("export the look `--to hlsl` for a material of your own, or `--to web`");
        refusal(message, help)
    };
    // Comments speak of objects, too.
    let lines = look.iter().flat_map(|it| it.text.lines());
    let code: Vec<&str> = lines.filter(|line| !line.trim_start().starts_with("//")).collect();
    let reads = |part: &str| code.iter().any(|line| line.contains(part));
    if reads("object.world_from_") {
        return Err(refusal(tr!("the object's own axes")));
    }
    if reads("object.id") {
        return Err(refusal(tr!("a number of each object")));
    }
    Ok(())
}

/// Refuses surroundings that a Custom node does not know.
fn refuse_surroundings(host: &HostText) -> Result<(), Diagnostic> {
    for (member, message) in [
        (
            "object_axes",
            text!(
                "the package unreal carries no looks that have lights or keys that turn with the \
                 object yet"
            ),
        ),
        ("object_id", text!("the package unreal carries no looks that tell objects apart yet")),
        ("frame", text!("the package unreal carries no looks that count frames yet")),
    ] {
        if host.reads.contains(member) {
            let help = tr!("use another frame or driver, or export `--to unity`, `godot` or `web`");
            return Err(refusal(message.tr(), help));
        }
    }
    Ok(())
}

/// Varyings of the look by their own names, with the members of the fragment's struct that take
/// them.
fn located(source: &Source) -> Vec<(String, String)> {
    let plain = |name: &str| {
        let end = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let is_numbered = end.len() < name.len();
        let end = if is_numbered { end.strip_suffix('_').unwrap_or(name) } else { name };
        end.trim_end_matches('_').to_owned()
    };
    let inputs = source.inputs.1.iter();
    inputs
        .filter_map(|input| {
            let passed = source.varyings.1.iter().find(|it| it.semantic == input.semantic);
            let name = match input.semantic.as_str() {
                "SV_Position" => "clip".to_owned(),
                "SV_IsFrontFace" => "is_front".to_owned(),
                _ => plain(&passed?.name),
            };
            Some((name, input.name.clone()))
        })
        .collect()
}

/// Writer of the body of `Draw`.
struct Body<'a> {
    request: &'a PackageRequest<'a>,
    source: &'a Source,
    host: Option<&'a HostText>,
    /// True if the look reads a member of the view.
    reads_axes: bool,
    reads_clip: bool,
    reads_screen: bool,
    reads_eye: bool,
    cuts: bool,
    text: String,
}

impl<'a> Body<'a> {
    fn new(
        request: &'a PackageRequest<'a>,
        source: &'a Source,
        look: &[HlslDeclaration],
        host: Option<&'a HostText>,
    ) -> Self {
        let is_read = |part: &str| look.iter().any(|it| it.text.contains(part));
        Self {
            request,
            source,
            host,
            reads_axes: is_read("view.camera_from_world"),
            reads_clip: is_read("view.clip_from_world"),
            reads_screen: is_read("view.screen"),
            reads_eye: is_read("view.eye"),
            cuts: is_read("is_cut = true;"),
            text: String::new(),
        }
    }

    /// True if the body reads a member of the pixel.
    fn reads(&self, member: &str) -> bool {
        let mut rest = self.text.as_str();
        while let Some((_, after)) = rest.split_once("pixel.") {
            let word = after.split(|c: char| !c.is_ascii_alphanumeric()).next();
            if word == Some(member) {
                return true;
            }
            rest = after;
        }
        false
    }

    fn line(&mut self, line: &str) {
        let _ = writeln!(self.text, "    {line}");
    }

    fn host_reads(&self, member: &str) -> bool {
        self.host.is_some_and(|host| host.reads.contains(member))
    }

    /// Surroundings of the pixel, for the look and its host work.
    fn surroundings(&mut self) {
        let needs_axes = self.reads_axes || self.reads_clip || self.host_reads("camera_from_world");
        let needs_toward = self.reads_eye || self.host_reads("parallel") || needs_axes;
        let needs_eye =
            self.reads_eye || self.reads_axes || self.reads_clip || self.host_reads("eye");
        if needs_toward {
            self.line("float3 toward_viewer = -direction_in_look(pixel.ViewForward);");
        }
        if needs_eye {
            self.line("float3 eye = place_in_look(pixel.CameraPosition);");
        }
        if needs_axes {
            self.line("// Rows are axes: to the right, up and toward the viewer.");
            self.line("float3x3 camera = float3x3(");
            self.line(
                "    direction_in_look(pixel.ViewRight), direction_in_look(pixel.ViewUp), \
                       toward_viewer);",
            );
        }
        if self.reads_eye {
            self.line(
                "view.eye = pixel.IsParallel ? float4(toward_viewer, 0.0) : \
                       float4(eye, 1.0);",
            );
        }
        if self.reads_axes {
            self.line("// The look's matrices have columns as rows.");
            self.line("view.camera_from_world = float4x4(");
            self.line("    float4(camera._11_21_31, 0.0), float4(camera._12_22_32, 0.0),");
            self.line("    float4(camera._13_23_33, 0.0), float4(-mul(camera, eye), 1.0));");
        }
        if self.reads_clip {
            self.line("// Clip space without its depth; a parallel view counts in centimeters.");
            self.line(
                "float2 scale = pixel.IsParallel ? 100.0 * pixel.ClipScale : pixel.ClipScale;",
            );
            self.line("float3x4 clip = float3x4(");
            self.line("    scale.x * float4(camera[0], -dot(camera[0], eye)),");
            self.line("    scale.y * float4(camera[1], -dot(camera[1], eye)),");
            self.line(
                "    pixel.IsParallel ? float4(0.0, 0.0, 0.0, 1.0) : \
                 float4(-toward_viewer, dot(toward_viewer, eye)));",
            );
            self.line("view.clip_from_world = float4x4(");
            self.line(
                "    float4(clip._11_21, 0.0, clip._31), float4(clip._12_22, 0.0, clip._32),",
            );
            self.line(
                "    float4(clip._13_23, 0.0, clip._33), float4(clip._14_24, 0.0, clip._34));",
            );
        }
        if self.reads_screen {
            self.line("view.screen = float4(1.0, 1.0, 0.0, 0.0);");
        }
        if self.cuts {
            self.line("is_cut = false;");
        }
    }

    /// The numbers of the look.
    fn numbers(&mut self, arguments: &[Argument<'_>], leaves: &[Leaf]) {
        if self.host.is_none() {
            return;
        }
        self.line("Surroundings around = (Surroundings)0;");
        for (member, value) in [
            ("illumination", "float3x3(1, 0, 0, 0, 1, 0, 0, 0, 1)"),
            ("camera_from_world", "transpose(camera)"),
            ("eye", "eye"),
            ("parallel", "pixel.IsParallel ? toward_viewer : (0.0).xxx"),
            ("object_middle", "place_in_look(pixel.ObjectPosition)"),
            ("viewport", "pixel.ViewSize"),
            ("time", "pixel.Time"),
        ] {
            if self.host_reads(member) {
                self.line(&format!("around.{member} = {value};"));
            }
        }
        let is_shown = self.request.look.color_space == ColorSpace::Display;
        let value = |argument: &Argument<'_>| match argument.kind {
            ArgumentKind::Rgb if is_shown => format!("display_from_linear({})", argument.input),
            ArgumentKind::Rgba if is_shown => {
                format!("float4(display_from_linear({0}.rgb), {0}.a)", argument.input)
            }
            _ => argument.input.clone(),
        };
        let values: String = arguments.iter().map(|it| value(it) + ", ").collect();
        let mut call = format!("Numbers numbers = {FUNCTION}({values}around);");
        while call.len() > 96 {
            let Some(at) = call[..96].rfind(", ") else { break };
            let (line, rest) = call.split_at(at + 1);
            let (line, rest) = (line.to_owned(), format!("    {}", rest.trim_start()));
            self.line(&line);
            call = rest;
        }
        self.line(&call);
        let members = self.host.map(|host| host.members.clone()).unwrap_or_default();
        for (leaf, member) in leaves.iter().zip(members) {
            self.line(&format!("{} = numbers.{member};", leaf.place));
        }
    }

    /// The pixel and its color.
    fn drawing(&mut self, images: &[String]) {
        let ty = self.source.inputs.0.clone();
        let passed = located(self.source);
        if passed.iter().any(|(name, _)| name == "tangent") {
            self.line(
                "// Rows of images run down in Unreal, and the third axis of tangents with them.",
            );
            self.line("float3 normal = direction_in_look(pixel.VertexNormal);");
            self.line("float3 tangent = direction_in_look(pixel.Tangent);");
            self.line("float3 bitangent = -direction_in_look(pixel.Bitangent);");
            self.line("float side = dot(cross(normal, tangent), bitangent) < 0.0 ? -1.0 : 1.0;");
        }
        self.line(&format!("{ty} input;"));
        for (name, member) in passed {
            let value = match name.as_str() {
                "position" => "place_in_look(pixel.WorldPosition)",
                "position_object" => "place_in_look(pixel.LocalPosition)",
                "normal" => "direction_in_look(pixel.VertexNormal)",
                "tangent" => "float4(tangent, side)",
                "uv" => "float2(pixel.TexCoord.x, 1.0 - pixel.TexCoord.y)",
                "color" => "pixel.VertexColor",
                "is_front" => "pixel.TwoSidedSign > 0.0",
                "clip" if self.source.reads_pixel => "float4(pixel.Position, 0.0, 1.0)",
                _ => "(0.0).xxxx",
            };
            self.line(&format!("input.{member} = {value};"));
        }
        let images: String = images.iter().map(|image| format!(", {image}")).collect();
        self.line(&format!("float4 color = fs_main(input{images});"));
        if self.cuts {
            self.line("color.a = is_cut ? 0.0 : color.a;");
        }
        match self.request.look.color_space {
            ColorSpace::Display => {
                self.line("// The look's colors are numbers as shown.");
                self.line("return float4(linear_from_display(saturate(color.rgb)), color.a);");
            }
            ColorSpace::Linear => self.line("return color;"),
        }
    }
}

/// The functions between numbers as shown and linear light that the look needs.
fn curves(request: &PackageRequest<'_>, arguments: &[Argument<'_>]) -> String {
    if request.look.color_space == ColorSpace::Linear {
        return String::new();
    }
    let mut text = LINEAR_FROM_DISPLAY.to_owned();
    if arguments.iter().any(|argument| argument.kind.is_color()) {
        text += DISPLAY_FROM_LINEAR;
    }
    text
}

const LINEAR_FROM_DISPLAY: &str = "/// Linear light of numbers as shown, 0 to 1.
float3 linear_from_display(float3 shown)
{
    float3 high = pow((shown + 0.055) / 1.055, (2.4).xxx);
    return lerp(high, shown / 12.92, step(shown, (0.04045).xxx));
}

";

const DISPLAY_FROM_LINEAR: &str = "/// Numbers as shown of linear light, 0 or more.
float3 display_from_linear(float3 light)
{
    float3 high = 1.055 * pow(max(light, 0.0), (1.0 / 2.4).xxx) - 0.055;
    return lerp(high, light * 12.92, step(light, (0.0031308).xxx));
}

";
