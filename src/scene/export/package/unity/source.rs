//! The look in HLSL without bindings: what the exporter writes, made fit to be included.
//!
//! Uniform blocks become variables of the file, which the shader's entry points fill from what
//! Unity has bound; entry points become functions. Names that Unity's includes have are changed.

use std::path::Path;

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::export::description::Feed;
use crate::export::header;
use crate::export::package::PackageRequest;
use crate::wgsl::rename_identifiers;

/// The look's text.
#[derive(Clone, Debug)]
pub(in crate::export::package) struct Source {
    /// The whole file.
    pub(in crate::export::package) text: String,
    /// Attributes of a vertex.
    pub(in crate::export::package) attributes: Vec<Field>,
    /// Name of the type that the vertex function returns, and its members.
    pub(in crate::export::package) varyings: (String, Vec<Field>),
    /// Name of the type that the fragment function takes, and its members.
    pub(in crate::export::package) inputs: (String, Vec<Field>),
    /// True if the fragment asks for its place in the picture.
    pub(in crate::export::package) reads_pixel: bool,
    /// Uniform blocks: name and type.
    pub(in crate::export::package) blocks: Vec<(String, String)>,
    /// Images, in the order of the look's bindings.
    pub(in crate::export::package) images: Vec<SourceImage>,
}

/// An image that the look's text reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::export::package) struct SourceImage {
    /// Name of the texture in the text.
    pub(in crate::export::package) texture: String,
    /// Name of the sampler in the text.
    pub(in crate::export::package) sampler: String,
    /// Index of the image in the description.
    pub(in crate::export::package) image: usize,
    /// True for the layers of a painted surface.
    pub(in crate::export::package) is_painted: bool,
}

/// An engine's own names of things that a look may have, too.
pub(in crate::export::package) struct EngineNames<'a> {
    /// Names of types and macros that get others in the look's text.
    pub(in crate::export::package) taken: &'a [&'a str],
    /// Names of the texture and the sampler of an image of a name such as `tone_air`.
    pub(in crate::export::package) image: fn(&str) -> [String; 2],
}

/// A member of a struct.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::export::package) struct Field {
    /// Type without an array's length.
    pub(in crate::export::package) ty: String,
    pub(in crate::export::package) name: String,
    /// Semantic; empty where the member has none.
    pub(in crate::export::package) semantic: String,
}

/// Unity's names: those of its includes, and those by which it knows a texture's sampler.
pub(super) const UNITY: EngineNames<'_> =
    EngineNames { taken: &TAKEN, image: |name| [format!("_{name}"), format!("sampler_{name}")] };

/// Names of types and macros of Unity's includes that a look may have, too.
const TAKEN: [&str; 14] = [
    "Light",
    "InputData",
    "SurfaceData",
    "Attributes",
    "Interpolators",
    "PI",
    "TWO_PI",
    "FOUR_PI",
    "HALF_PI",
    "INV_PI",
    "INFINITY",
    "real",
    "real3",
    "real4",
];

impl Source {
    /// The source of the look's picture for an engine that has `names` of its own.
    ///
    /// # Errors
    /// - `export-failed`: the look cannot be written as HLSL, or not in the form that is sought.
    pub(in crate::export::package) fn of(
        request: &PackageRequest<'_>,
        names: &EngineNames<'_>,
    ) -> Result<Self, Diagnostic> {
        let lost = |part: &str| {
            Diagnostic::error("export-failed", tr!("the look's HLSL lacks `{part}`"))
                .hint(tr!("please report the look; `--to hlsl` may still carry it"))
        };
        let module = request.modules.modules.iter().find(|module| module.is_draw());
        let module = module.ok_or_else(|| lost("draw"))?;
        let hlsl = crate::export::language("hlsl").ok_or_else(|| lost("hlsl"))?;
        let written = hlsl.write(module, request.title, request.stem)?;
        let file = written.files.first().ok_or_else(|| lost("draw"))?;
        let text = String::from_utf8_lossy(&file.bytes).into_owned();
        let body = text.split_once("\n\n").map_or(text.as_str(), |(_, body)| body);
        let (body, images) = with_images(body, request, names);
        let body = free_names(&body, names.taken);
        let vertex = head(&body, "vs_main").ok_or_else(|| lost("vs_main"))?;
        let fragment = head(&body, "fs_main").ok_or_else(|| lost("fs_main"))?;
        let named = |name: &str| structure(&body, name).ok_or_else(|| lost(name));
        let attributes = named(vertex.parameter)?;
        let varyings = (vertex.result.to_owned(), named(vertex.result)?);
        let inputs = (fragment.parameter.to_owned(), named(fragment.parameter)?);
        let reads_pixel = body.contains("in_.clip_");
        let (body, blocks) = without_bindings(&body);
        let lines = [
            format!("{}: made by Chiaro {}, HLSL.", request.title, env!("CARGO_PKG_VERSION")),
            format!("The look itself; {}.shader includes this file.", request.stem),
        ];
        let text = format!("{}\n{}\n", header::comment(&lines), body.trim_end());
        Ok(Self { text, attributes, varyings, inputs, reads_pixel, blocks, images })
    }

    /// Members of a type of the look, without those that fill up space.
    pub(in crate::export::package) fn members(&self, name: &str) -> Option<Vec<Field>> {
        let mut members = structure(&self.text, name)?;
        let is_filling =
            |field: &Field| field.name.starts_with("_pad") || field.name.starts_with("_end_pad");
        members.retain(|field| !is_filling(field));
        Some(members)
    }
}

/// The text with an engine's names for images and their samplers, after the images' files.
fn with_images(
    text: &str,
    request: &PackageRequest<'_>,
    names: &EngineNames<'_>,
) -> (String, Vec<SourceImage>) {
    let module = request.description.modules.iter().find(|module| module.name == "draw");
    let bindings = module.map_or(&[][..], |module| &module.bindings[..]);
    let mut images: Vec<SourceImage> = Vec::new();
    let mut renamed: Vec<(String, String)> = Vec::new();
    for binding in bindings {
        let Feed::Image { image } = binding.feed else { continue };
        let Some(described) = request.description.images.get(image) else { continue };
        let own = image_name(&described.path);
        let numbered = (2..).map(|number| format!("{own}_{number}"));
        let free = std::iter::once(own.clone()).chain(numbered).map(|name| (names.image)(&name));
        let is_free = |it: &[String; 2]| images.iter().all(|other| other.texture != it[0]);
        let Some([texture, sampler]) = free.into_iter().find(is_free) else { continue };
        let feed = Feed::Sampler { image };
        if let Some(binding) = bindings.iter().find(|binding| binding.feed == feed) {
            renamed.push((binding.name.clone(), sampler.clone()));
        }
        renamed.push((binding.name.clone(), texture.clone()));
        let is_painted = described.kind == "hcbtf";
        images.push(SourceImage { texture, sampler, image, is_painted });
    }
    // Names that end with a digit get a `_` from the writer of HLSL.
    let written = |name: &str| {
        let ends = name.ends_with(|c: char| c.is_ascii_digit());
        if ends { format!("{name}_") } else { name.to_owned() }
    };
    let text = rename_identifiers(text, |word| {
        renamed.iter().find(|(name, _)| written(name) == word).map(|(_, new)| new.clone())
    });
    (text, images)
}

/// A name of the language for an image: `tone_air` of `papers/Tone air.png`.
fn image_name(path: &str) -> String {
    let stem = Path::new(path).file_stem().map_or("image".into(), |stem| stem.to_string_lossy());
    let words = stem.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let name = words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("_");
    match name.chars().next() {
        Some(first) if first.is_ascii_alphabetic() => name,
        _ => format!("image_{name}").trim_end_matches('_').to_owned(),
    }
}

/// The text with other names for what the engine calls so.
fn free_names(text: &str, taken: &[&str]) -> String {
    rename_identifiers(text, |name| {
        let is_loud = name.chars().all(|c| c.is_ascii_uppercase() || c == '_');
        taken.contains(&name).then(|| match name.chars().next() {
            Some(first) if first.is_ascii_lowercase() => format!("{name}_of_look"),
            _ if is_loud => format!("LOOK_{name}"),
            _ => format!("Look{name}"),
        })
    })
}

/// Head of a function.
struct FunctionHead<'a> {
    result: &'a str,
    parameter: &'a str,
}

/// Types of a function's result and of its first parameter.
fn head<'a>(text: &'a str, name: &str) -> Option<FunctionHead<'a>> {
    let line = text.lines().find(|line| line.contains(&format!(" {name}(")))?;
    let (result, rest) = line.split_once(' ')?;
    let (_, parameters) = rest.split_once('(')?;
    Some(FunctionHead { result, parameter: parameters.split_whitespace().next()? })
}

/// Members of a struct.
fn structure(text: &str, name: &str) -> Option<Vec<Field>> {
    let (_, body) = text.split_once(&format!("struct {name} {{\n"))?;
    let (body, _) = body.split_once("\n}")?;
    let lines = body.lines().map(str::trim).filter(|line| !line.starts_with("//"));
    lines
        .map(|line| {
            let line = line.strip_suffix(';')?;
            let (declared, semantic) = line.split_once(" : ").unwrap_or((line, ""));
            let (ty, name) = declared.rsplit_once(' ')?;
            let name = name.split('[').next().unwrap_or_default();
            Some(Field { ty: ty.to_owned(), name: name.to_owned(), semantic: semantic.to_owned() })
        })
        .collect()
}

/// The text with variables for uniform blocks and without semantics, and the blocks.
fn without_bindings(text: &str) -> (String, Vec<(String, String)>) {
    let mut blocks = Vec::new();
    let mut has_images = false;
    let mut result = String::with_capacity(text.len());
    for line in text.lines() {
        // cbuffer look : register(b2) { Look look; }
        let block = line.strip_prefix("cbuffer ").and_then(|rest| {
            let (_, inner) = rest.split_once("{ ")?;
            inner.strip_suffix("; }")?.split_once(' ')
        });
        match block {
            Some((ty, name)) => {
                if blocks.is_empty() {
                    result += "// Filled by the shader's entry points.\n";
                }
                blocks.push((name.to_owned(), ty.to_owned()));
                result += &format!("static {ty} {name};");
            }
            None if line.starts_with("Texture2D") || line.starts_with("SamplerState") => {
                if !has_images {
                    result += "\n// Images, sampled as their import settings say.\n";
                }
                has_images = true;
                let end = line.find(" : register(").map_or("", |_| ";");
                result += line.split(" : register(").next().unwrap_or(line);
                result += end;
            }
            None => result += &without_semantic(line),
        }
        result.push('\n');
    }
    (result, blocks)
}

/// A line without ` : LOC0` or ` : SV_Position`.
fn without_semantic(line: &str) -> String {
    for mark in [" : LOC", " : SV_"] {
        if let Some((before, after)) = line.split_once(mark) {
            let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
            return format!("{before}{}", after.trim_start_matches(is_part));
        }
    }
    line.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
struct Look {
    /// Amount.
    float warmth;
    int _end_pad_0;
    Light lights[2];
};

cbuffer look : register(b2) { Look look; }

struct Vertex {
    float3 position : LOC0;
};

Varyings vs_main(Vertex vertex)
float4 fs_main(Inputs inputs) : SV_Target0
";

    #[test]
    fn structs_are_read() {
        let fields = structure(TEXT, "Look").expect("a struct");
        let names: Vec<&str> = fields.iter().map(|field| field.name.as_str()).collect();
        assert_eq!(names, ["warmth", "_end_pad_0", "lights"]);
        assert_eq!(structure(TEXT, "Vertex").expect("a struct")[0].semantic, "LOC0");
        let head = head(TEXT, "fs_main").expect("a function");
        assert_eq!((head.result, head.parameter), ("float4", "Inputs"));
    }

    #[test]
    fn bindings_and_semantics_go() {
        let (text, blocks) = without_bindings(TEXT);
        assert_eq!(blocks, [("look".to_owned(), "Look".to_owned())]);
        assert!(text.contains("static Look look;\n"), "{text}");
        assert!(text.contains("    float3 position;\n"), "{text}");
        assert!(text.contains("float4 fs_main(Inputs inputs)\n"), "{text}");
    }

    #[test]
    fn names_of_unity_are_left_to_it() {
        assert_eq!(free_names("Light PI real a.PI", &TAKEN), "LookLight LOOK_PI real_of_look a.PI");
    }

    #[test]
    fn images_have_names_of_the_language() {
        assert_eq!(image_name("papers/Tone air.png"), "tone_air");
        assert_eq!(image_name("2-rim.hcbtf"), "image_2_rim");
        assert_eq!(image_name("….png"), "image");
    }
}
