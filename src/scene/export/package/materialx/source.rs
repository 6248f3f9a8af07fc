//! The look as one function of GLSL.
//!
//! The fragment shader of the look and its host work are two sources of WGSL. They become one
//! module whose entry point calls both, naga writes the module, and the function that MaterialX
//! calls takes the place of the entry point. What were uniforms are variables of the file, which
//! that function fills. Every name gets the node's in front: a shader may hold several looks.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use chiaro_locale::tr;
use naga::back::glsl::{Options, Version, WriterFlags};

use super::super::{PackageRequest, refusal};
use super::inputs::{NodeInput, light_text};
use super::literal;
use crate::compile::write_line;
use crate::diag::Diagnostic;
use crate::document::ColorSpace;
use crate::export::header;
use crate::export::readable::{SourceComments, WrittenText};
use crate::export::remainders::DefinedRemainders;
use crate::export::{glsl, modules::ShaderModule};
use crate::wgsl::{self, Declaration, identifiers, rename_identifiers, scan, validate};

/// A value that the graph around the function gives it, of what MaterialX knows.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct GivenValue {
    /// Name of the function's argument and of its input.
    pub(super) name: &'static str,
    /// Type in MaterialX, and in GLSL.
    pub(super) ty: (&'static str, &'static str),
    /// Node of MaterialX whose output the value is, and the node's space.
    pub(super) node: (&'static str, Option<&'static str>),
}

/// Values that the graph may give, in the order of arguments.
pub(super) const GIVEN: [GivenValue; 8] = [
    GivenValue { name: "position", ty: ("vector3", "vec3"), node: ("position", Some("world")) },
    GivenValue {
        name: "object_position",
        ty: ("vector3", "vec3"),
        node: ("position", Some("object")),
    },
    GivenValue { name: "normal", ty: ("vector3", "vec3"), node: ("normal", Some("world")) },
    GivenValue { name: "tangent", ty: ("vector3", "vec3"), node: ("tangent", Some("world")) },
    GivenValue { name: "bitangent", ty: ("vector3", "vec3"), node: ("bitangent", Some("world")) },
    GivenValue { name: "uv", ty: ("vector2", "vec2"), node: ("texcoord", None) },
    GivenValue { name: "time", ty: ("float", "float"), node: ("time", None) },
    GivenValue { name: "frame", ty: ("float", "float"), node: ("frame", None) },
];

/// Values of a surface that the look's vertices pass on: the member, and its value.
const SURFACE: [(&str, &str); 5] = [
    ("position", "position"),
    ("normal", "normal"),
    ("position_object", "object_position"),
    ("uv", "uv"),
    ("tangent", "vec4(tangent, dot(cross(normal, tangent), bitangent) < 0.0 ? -1.0 : 1.0)"),
];

/// Name that the look's entry point has as a function.
pub(super) const PICTURE: &str = "look_color";

/// Name of an entry point that only keeps functions from being left out.
const ENTRY: &str = "entry_of_export";

/// Light of a color as it is shown; `NAME` is the node's name.
const LIGHT_OF_SHOWN: &str = "\
/// Linear light of a color as it is shown, by the curve of sRGB.
vec3 NAME_light_of_shown(vec3 shown) {
    vec3 color = clamp(shown, 0.0, 1.0);
    vec3 light = pow((color + 0.055) / 1.055, vec3(2.4));
    return mix(light, color / 12.92, lessThanEqual(color, vec3(0.04045)));
}

";

/// The function's file, and what it takes.
#[derive(Clone, Debug)]
pub(super) struct Source {
    /// The whole file.
    pub(super) text: String,
    /// Values that the graph gives, in the order of arguments; the eye comes after them.
    pub(super) given: Vec<&'static GivenValue>,
}

/// Parts of the look that the function is made of.
pub(super) struct Parts {
    /// The look and its host work in one source.
    pub(super) wgsl: String,
    /// Members of what a vertex passes on.
    pub(super) varyings: Vec<String>,
    /// True if the picture asks which side is seen.
    pub(super) is_told_side: bool,
    /// Name of the function that makes the look's numbers; `None` where there are none.
    pub(super) numbers: Option<String>,
}

impl Source {
    /// The source of the look's function, `NAME_surface_color`.
    ///
    /// # Errors
    /// - `export-failed`: the look cannot be written as GLSL.
    pub(super) fn of(
        request: &PackageRequest<'_>,
        name: &str,
        inputs: &[NodeInput<'_>],
        parts: &Parts,
    ) -> Result<Self, Diagnostic> {
        let text = written(parts).map_err(failed)?;
        let functions = with_variables(&text);
        let members = members(&functions, "Settings");
        let reads_eye = declared(&functions).contains("u_view");
        let functions = prefixed(&functions, name);
        let function = Function { request, name, inputs, parts, members: &members, reads_eye };
        let (function, given) = function.write();
        let lines = [
            format!("{}: made by Chiaro {}, GLSL.", request.title, env!("CARGO_PKG_VERSION")),
            format!("{name}_surface_color is the look; {}.mtlx says what it takes.", request.stem),
        ];
        let decoding = match request.look.color_space {
            ColorSpace::Display => LIGHT_OF_SHOWN.replace("NAME", name),
            ColorSpace::Linear => String::new(),
        };
        let header = header::comment(&lines);
        let text = format!("{header}\n{}\n\n{decoding}{function}", functions.trim());
        Ok(Self { text, given })
    }
}

fn failed(problem: impl std::fmt::Display) -> Diagnostic {
    Diagnostic::error("export-failed", tr!("the look's GLSL: {problem}"))
        .hint(tr!("please report the look; `--to glsl-330` may still carry it"))
}

/// The WGSL of the look and its host work in one.
///
/// # Errors
/// - `not-in-package`: a value that MaterialX does not know.
pub(super) fn parts(request: &PackageRequest<'_>) -> Result<Parts, Diagnostic> {
    let module: Option<&ShaderModule> =
        request.modules.modules.iter().find(|module| module.is_draw());
    let module = module.ok_or_else(|| failed(tr!("there is no picture")))?;
    let source = module.wgsl();
    let mut text = String::new();
    let mut known: BTreeMap<String, String> = BTreeMap::new();
    let (mut varyings, mut is_told_side) = (Vec::new(), false);
    for declaration in scan(source).declarations {
        let own = &source[declaration.span.clone()];
        let kept = match declaration.name.as_str() {
            "vs_main" | "Vertex" | "Object" | "object" => continue,
            // The rest of the view is asked for by nothing, which is seen to below.
            "View" => "struct View {\n    /// The eye and 1.\n    eye: vec4f,\n}".to_owned(),
            "Varyings" => {
                varyings = carried(&declaration)?;
                without_attributes(own, |line| !line.trim_start().starts_with("clip:"))
            }
            "fs_main" => {
                refuse_unknown(own)?;
                is_told_side = own.contains("@builtin(front_facing)");
                without_attributes(own, |_| true).replacen("fs_main", PICTURE, 1)
            }
            _ => {
                refuse_unknown(own)?;
                own.to_owned()
            }
        };
        text += &format!("{kept}\n\n");
        known.insert(declaration.name.clone(), own.to_owned());
    }
    let numbers = request.work.modules.iter().find(|it| it.module == module.name);
    if let Some(numbers) = numbers {
        let function = numbers.structure.wgsl();
        let words = identifiers(&function);
        let asks = |word: &str| words.iter().any(|it| it == word);
        if asks("viewport") {
            return Err(refuse_pixels());
        }
        if ["camera_from_world", "object_axes", "object_middle"].into_iter().any(asks) {
            return Err(refuse_axes());
        }
        let own: Vec<&str> = request.work.modules.iter().map(|it| it.function.as_str()).collect();
        let host = rename_clashes(&format!("{}{function}", request.work.wgsl), &known);
        for declaration in scan(&host).declarations {
            let is_known = known.contains_key(&declaration.name);
            if !is_known && !own.contains(&declaration.name.as_str()) {
                text += &format!("{}\n\n", &host[declaration.span]);
            }
        }
    }
    Ok(Parts {
        wgsl: text,
        varyings,
        is_told_side,
        numbers: numbers.map(|numbers| numbers.structure.name.clone()),
    })
}

/// The host work with other names for functions that the look has in another form: the compiler
/// leaves out of the look's what its constants decide.
pub(in super::super) fn rename_clashes(host: &str, known: &BTreeMap<String, String>) -> String {
    let differs = |declaration: &Declaration| {
        let own = known.get(&declaration.name);
        own.is_some_and(|own| *own != host[declaration.span.clone()])
    };
    let declarations = scan(host).declarations.into_iter();
    let clashes: BTreeSet<String> =
        declarations.filter(differs).map(|declaration| declaration.name).collect();
    rename_identifiers(host, |word| clashes.contains(word).then(|| format!("{word}_before")))
}

/// Names of what a vertex passes on.
fn carried(varyings: &Declaration) -> Result<Vec<String>, Diagnostic> {
    let names = varyings.fields.iter().map(|field| field.name.clone());
    let names: Vec<String> = names.filter(|name| name != "clip").collect();
    match names.iter().find(|name| SURFACE.iter().all(|(known, _)| known != name)) {
        None => Ok(names),
        Some(name) => Err(refusal(
            tr!("the look asks its surface for `{name}`, which MaterialX does not know"),
            tr!("export the look `--to web` or `three`"),
        )),
    }
}

/// Refuses a function that asks for what MaterialX does not tell.
fn refuse_unknown(function: &str) -> Result<(), Diagnostic> {
    let words = ["view.clip_from_world", "view.camera_from_world", "view.screen", "object."];
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let asks = |word: &str| {
        let mut found = function.match_indices(word);
        found.any(|(at, _)| !function[..at].ends_with(is_word))
    };
    if function.contains("in.clip") {
        return Err(refuse_pixels());
    }
    match words.iter().find(|word| asks(word)) {
        None => Ok(()),
        Some(_) => Err(refuse_axes()),
    }
}

fn refuse_axes() -> Diagnostic {
    refusal(
        tr!(
            "the look asks for the axes of the camera or the object, which a node of MaterialX is \
             not told of"
        ),
        tr!("export the look `--to web` or `three`"),
    )
}

fn refuse_pixels() -> Diagnostic {
    refusal(
        tr!("the look counts pixels of the picture, whose size MaterialX does not tell"),
        tr!("lay the pattern over the surface instead, or export the look `--to web` or `three`"),
    )
}

/// A declaration without the attributes of entry points, and of its lines those that are wanted.
pub(in super::super) fn without_attributes(text: &str, is_wanted: impl Fn(&str) -> bool) -> String {
    let mut result = String::new();
    for line in text.lines() {
        let mut kept = line.replace("@fragment", "");
        while let Some((before, rest)) = kept.split_once('@') {
            let after = rest.split_once(')').map_or("", |(_, after)| after);
            kept = format!("{before}{}", after.trim_start());
        }
        if is_wanted(&kept) {
            result += &format!("{kept}\n");
        }
    }
    result.trim().to_owned()
}

/// The GLSL of the parts, as a person would write it.
fn written(parts: &Parts) -> Result<String, String> {
    let (side, told) = match parts.is_told_side {
        true => ("@builtin(front_facing) is_front: bool", ", is_front"),
        false => ("", ""),
    };
    let numbers = parts.numbers.as_ref().map_or_else(String::new, |function| {
        format!("    let numbers = {function}(Settings(), Surroundings());\n")
    });
    let source = format!(
        "{}@fragment\nfn {ENTRY}({side}) -> @location(0) vec4f {{\n{numbers}    \
         return {PICTURE}(Varyings(){told});\n}}\n",
        parts.wgsl
    );
    let source = DefinedRemainders::of(&source)?.map_or(source, |defined| defined.wgsl);
    let mut module = wgsl::parse(&source).map_err(|error| error.to_string())?.module;
    naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
    let valid = validate(module).map_err(|error| error.to_string())?;
    let options = Options {
        version: Version::Desktop(400),
        writer_flags: WriterFlags::empty(),
        ..Options::default()
    };
    let point = &valid.module.entry_points[0];
    let (text, _) = glsl::written_text(&valid, point, &options)?;
    let mut uniforms = BTreeMap::new();
    for (_, variable) in valid.module.global_variables.iter() {
        if let (Some(place), Some(name)) = (&variable.binding, &variable.name) {
            let own = format!("_group_{}_binding_{}_fs", place.group, place.binding);
            uniforms.insert(own, format!("u_{name}"));
        }
    }
    let written = WrittenText {
        text: rename_identifiers(&text, |word| uniforms.get(word).cloned()),
        valid: &valid,
        uniforms: uniforms.values().cloned().collect(),
        renamed: BTreeMap::new(),
    };
    written.readable(&SourceComments::of(&source), |valid| {
        let point = &valid.module.entry_points[0];
        glsl::written_text(valid, point, &options).map(|(text, _)| text)
    })
}

/// The text without version and entry point, and with variables for uniform blocks.
fn with_variables(text: &str) -> String {
    let (text, _) = text.split_once("void main() {").unwrap_or((text, ""));
    let mut result = String::new();
    for line in text.lines() {
        let is_block = line.contains("uniform ") && !line.starts_with([' ', '/']);
        if is_block {
            // layout(std140) uniform Block { Look u_look; };
            let inner = line.split_once("{ ").and_then(|(_, rest)| rest.strip_suffix(" };"));
            if let Some(inner) = inner {
                result += &format!("{inner}\n");
            }
        } else if !["#", "layout(", "precision ", "in ", "out ", "smooth ", "flat "]
            .iter()
            .any(|start| line.starts_with(start))
        {
            result += &format!("{line}\n");
        }
    }
    // One blank line where several were left.
    while result.contains("\n\n\n") {
        result = result.replace("\n\n\n", "\n\n");
    }
    result
}

/// Names of a struct's members.
fn members(text: &str, name: &str) -> Vec<String> {
    let inner = text.split_once(&format!("struct {name} {{\n"));
    let inner = inner.and_then(|(_, rest)| rest.split_once("\n}")).map_or("", |(inner, _)| inner);
    let lines = inner.lines().map(str::trim).filter(|line| !line.starts_with("//"));
    let names = lines.filter_map(|line| line.trim_end_matches(';').rsplit_once(' '));
    names.map(|(_, name)| name.to_owned()).collect()
}

/// Names that a text declares at its left edge: structs, constants, variables and functions.
fn declared(text: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for line in text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_alphabetic())) {
        let head = line.split(['(', '=', '{', '[', ';']).next().unwrap_or_default();
        names.extend(head.split_whitespace().last().map(str::to_owned));
    }
    names
}

/// The text with the node's name before each of its own.
fn prefixed(text: &str, name: &str) -> String {
    let names = declared(text);
    let renamed = |word: &str| {
        let plain = word.strip_prefix("u_").filter(|plain| ["look", "view"].contains(plain));
        names.contains(word).then(|| format!("{name}_{}", plain.unwrap_or(word)))
    };
    let mut result = String::new();
    let mut rest = text;
    // Members of structs keep their names, as they do behind a point.
    while let Some(at) = rest.find("struct ") {
        let end = rest[at..].find("};").map_or(rest.len(), |end| at + end);
        result += &rename_identifiers(&rest[..at], renamed);
        for line in rest[at..end].split_inclusive('\n') {
            let split = if line.starts_with(' ') { line.trim_end().rfind(' ') } else { None };
            let (ty, member) = line.split_at(split.unwrap_or(line.len()));
            result += &rename_identifiers(ty, renamed);
            result += member;
        }
        rest = &rest[end..];
    }
    result += &rename_identifiers(rest, renamed);
    // Longer names make longer lines.
    let mut broken = String::with_capacity(result.len());
    for line in result.lines() {
        let statement = line.trim_start();
        let indent = line.len() - statement.len();
        if line.len() <= 100 || statement.starts_with('/') {
            broken += &format!("{line}\n");
        } else {
            write_line(statement, indent / 4, &mut broken);
        }
    }
    broken
}

/// The function that MaterialX calls.
struct Function<'a> {
    request: &'a PackageRequest<'a>,
    name: &'a str,
    inputs: &'a [NodeInput<'a>],
    parts: &'a Parts,
    /// Members of the settings, as GLSL has them.
    members: &'a [String],
    /// True if the look's own functions ask for the eye.
    reads_eye: bool,
}

impl Function<'_> {
    fn write(&self) -> (String, Vec<&'static GivenValue>) {
        let Self { name, inputs, parts, .. } = self;
        let names = self.argument_names();
        let body = self.body(&names);
        let surface: Vec<&str> =
            parts.varyings.iter().filter_map(|member| surface_value(member)).collect();
        let surface = surface.join(", ");
        let mut words = identifiers(&body);
        words.extend(identifiers(&surface));
        let is_read = |given: &&GivenValue| words.iter().any(|word| word == given.name);
        let given: Vec<&'static GivenValue> = GIVEN.iter().filter(is_read).collect();
        let mut arguments: Vec<String> =
            given.iter().map(|given| format!("{} {}", given.ty.1, given.name)).collect();
        arguments.push("vec3 eye".to_owned());
        arguments.extend(
            inputs.iter().zip(&names).map(|(input, name)| format!("{} {name}", input.ty.1)),
        );
        arguments.extend(["out vec3 color".to_owned(), "out float opacity".to_owned()]);
        let side = if parts.is_told_side { ", gl_FrontFacing" } else { "" };
        let color = match self.request.look.color_space {
            ColorSpace::Display => format!("{name}_light_of_shown(picture.rgb)"),
            ColorSpace::Linear => "picture.rgb".to_owned(),
        };
        let text = format!(
            "/// The look at a point of a surface: linear light, straight alpha.\n\
             void {name}_surface_color(\n    {}\n) {{\n{body}    \
             vec4 picture = {name}_{PICTURE}(\n        {name}_Varyings({}){side}\n    );\n    \
             color = {color};\n    opacity = picture.a;\n}}\n",
            arguments.join(",\n    "),
            surface,
        );
        (text, given)
    }

    /// Statements that fill the variables of the file.
    fn body(&self, names: &[String]) -> String {
        let Self { name, inputs, parts, members, .. } = self;
        let mut text = String::new();
        if let Some(function) = &parts.numbers {
            let work = self.request.work;
            let argument = |setting: &str| {
                let at = inputs.iter().position(|it| it.light.is_none() && it.name == setting)?;
                names.get(at).cloned()
            };
            let mut values = Vec::new();
            for setting in &work.parameters {
                let own = || {
                    let ty = super::inputs::types(&setting.ty).map_or("float", |ty| ty.1);
                    literal::glsl(ty, &setting.default)
                };
                let set = setting.name.as_ref().and_then(|name| argument(name.as_str()));
                values.push(set.unwrap_or_else(own));
            }
            for (index, light) in work.lights.iter().enumerate() {
                let variable = &members[work.parameters.len() + index];
                let given = |field: &str| {
                    let is_it = |it: &NodeInput<'_>| it.light == Some((&light.id, field));
                    inputs.iter().position(is_it).and_then(|at| names.get(at).cloned())
                };
                let made = light_text(&light.light, given);
                let _ = writeln!(
                    text,
                    "    {name}_LightSettings {variable} = {name}_LightSettings(\n{made}    );"
                );
                values.push(variable.clone());
            }
            if values.is_empty() {
                values.push("0.0".to_owned());
            }
            let settings = values.join(", ");
            write_line(
                &format!("{name}_Settings settings = {name}_Settings({settings});"),
                1,
                &mut text,
            );
            let _ = write!(
                text,
                "    \
                 {name}_Surroundings around = {name}_Surroundings(\n        \
                     mat3(1.0), // illumination\n        \
                     mat3(1.0), // camera from world\n        \
                     eye,\n        \
                     vec3(0.0), // the view is no parallel one\n        \
                     mat3(1.0), // axes of the object\n        \
                     vec3(0.0), // middle of the object\n        \
                     0.0, // id of the object\n        \
                     vec2(1.0), // viewport\n        \
                     {},\n        \
                     {}\n    );\n    \
                 {name}_look = {name}_{function}(settings, around);\n",
                self.surrounding("time"),
                self.surrounding("frame"),
            );
        }
        if self.reads_eye {
            let _ = writeln!(text, "    {name}_view.eye = vec4(eye, 1.0);");
        }
        text
    }

    /// The time or the frame where the look asks for it.
    fn surrounding(&self, word: &'static str) -> &'static str {
        let asked = format!("around.{word}");
        let is_asked = self.parts.wgsl.contains(&asked);
        if is_asked { word } else { "0.0" }
    }

    /// Names of the function's arguments for the inputs: none is taken.
    fn argument_names(&self) -> Vec<String> {
        let mut taken: BTreeSet<String> = GIVEN.iter().map(|given| given.name.to_owned()).collect();
        let own = ["eye", "color", "opacity", "settings", "around", "picture"];
        taken.extend(own.map(str::to_owned));
        let work = self.request.work;
        let lights = self.members.iter().skip(work.parameters.len());
        taken.extend(lights.cloned());
        let name = |input: &NodeInput<'_>| {
            let settings = work.parameters.iter().zip(self.members);
            let mut settings = settings.filter(|(setting, _)| {
                let name = setting.name.as_ref().map(|name| name.as_str());
                input.light.is_none() && name == Some(input.name)
            });
            // naga has seen to words of GLSL.
            let wanted = settings.next().map_or(input.name, |(_, member)| member.as_str());
            let mut name = wanted.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
            while !taken.insert(name.clone()) {
                name.push_str("_in");
            }
            name
        };
        self.inputs.iter().map(name).collect()
    }
}

fn surface_value(member: &str) -> Option<&'static str> {
    SURFACE.iter().find(|(known, _)| *known == member).map(|(_, value)| *value)
}
