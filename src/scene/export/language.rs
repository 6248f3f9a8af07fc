//! Languages of exports: their common description.

use chiaro_locale::tr;
use serde::Serialize;
use serde_json::{Map, Value};

use super::ExportFile;
use super::modules::ShaderModule;
use crate::diag::Diagnostic;

/// A language that looks are exported to.
#[derive(Debug)]
pub struct Language {
    /// Name of the language for `--to`.
    pub slug: &'static str,
    /// Name of the language for people.
    pub label: &'static str,
    /// Name of the language in menus: without a version where there is but one.
    pub short_label: &'static str,
    /// API that reads the language, where its name does not say so; may be empty.
    pub api: &'static str,
    /// Files of a look that are text, for users who copy one of them; none where the window copies
    /// the look in another way.
    pub texts: &'static [TextFile],
    /// Program, not one of Chiaro's, that accepts every golden output; `None` where there is none,
    /// and files say so.
    pub verified_by: Option<&'static str>,
    /// Conventions of the language's API for positions.
    pub clip_space: ClipSpace,
    /// Further hints for a host; may be empty.
    pub note: &'static str,
    pub(super) write: fn(&Request<'_>) -> Result<ExportedModule, String>,
}

/// A text file that every exported look has.
#[derive(Debug)]
pub struct TextFile {
    /// Ending of the file's name.
    pub ending: &'static str,
    /// Content of the file: `shader`, or one stage of it.
    pub content: &'static str,
}

/// The text files of a language with a file for each stage, such as GLSL; `$version` comes before
/// the stage in the names' endings.
macro_rules! stages {
    ($version:literal) => {
        &[
            $crate::export::language::TextFile {
                ending: concat!(".", $version, ".frag"),
                content: "fragment shader",
            },
            $crate::export::language::TextFile {
                ending: concat!(".", $version, ".vert"),
                content: "vertex shader",
            },
        ]
    };
}
pub(super) use stages;

/// Conventions of an API for the positions that a vertex shader gives, and for the order of an
/// image's rows. Exported shaders convert nothing: `clip_from_world` is the host's.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ClipSpace {
    /// Direction of y in clip space: `up` or `down` the picture.
    pub y: &'static str,
    /// Values of z / w of the nearest and the farthest point.
    pub depth: [f64; 2],
    /// Position of the first row of a rendered image: `top` or `bottom`.
    pub first_row: &'static str,
}

impl ClipSpace {
    /// Conventions of Direct3D, Metal and WebGPU.
    pub(super) const WEBGPU: Self = Self { y: "up", depth: [0.0, 1.0], first_row: "top" };
    /// Conventions of OpenGL, OpenGL ES and WebGL.
    pub(super) const OPENGL: Self = Self { y: "up", depth: [-1.0, 1.0], first_row: "bottom" };
    /// Conventions of Vulkan.
    pub(super) const VULKAN: Self = Self { y: "down", depth: [0.0, 1.0], first_row: "top" };
}

/// Request to write a module in a language.
pub(super) struct Request<'a> {
    pub(super) language: &'static Language,
    pub(super) module: &'a ShaderModule,
    /// Name of the look, fit for a comment.
    pub(super) title: &'a str,
    /// Beginning of the names of this module's files.
    pub(super) stem: String,
    /// Name of the JSON description.
    pub(super) description: String,
}

/// A module written in one language.
pub(super) struct ExportedModule {
    pub(super) files: Vec<ExportFile>,
    pub(super) described: LanguageModule,
}

/// Description of a module in one language.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LanguageModule {
    /// Name of the module.
    pub module: String,
    /// Files that hold the module.
    pub files: Vec<LanguageFile>,
    /// Places and names of the module's bindings.
    pub bindings: Vec<LanguageBinding>,
    /// Names of the module's vertex attributes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub attributes: Vec<LanguageAttribute>,
}

/// A file of a module.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LanguageFile {
    /// Name of the file, beside the description.
    pub file: String,
    /// Entry points in the file.
    pub entry_points: Vec<LanguageEntryPoint>,
}

/// An entry point as it is named in a language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LanguageEntryPoint {
    /// Stage: `vertex` or `fragment`.
    pub stage: &'static str,
    /// Name to pass to the API.
    pub name: String,
}

/// A binding in one language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LanguageBinding {
    /// Name of the module's binding.
    pub binding: String,
    /// Sampler that is combined with this texture, in languages that join the two.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sampler: Option<String>,
    /// Name of the binding in this language, for APIs that ask for names.
    pub name: String,
    /// Place of the binding, in the API's words: `{"group": 0, "binding": 1}`, `{"unit": 0}`,
    /// `{"register": "b0"}`.
    pub at: Map<String, Value>,
}

impl LanguageBinding {
    pub(super) fn new(binding: &str, name: &str, at: &[(&str, Value)]) -> Self {
        let at = at.iter().map(|(key, value)| ((*key).to_owned(), value.clone())).collect();
        Self { binding: binding.to_owned(), sampler: None, name: name.to_owned(), at }
    }
}

/// A vertex attribute in one language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LanguageAttribute {
    /// Name of the module's attribute.
    pub attribute: String,
    /// Name of the attribute in this language.
    pub name: String,
}

impl Language {
    /// Writes one module.
    pub(super) fn write(
        &'static self,
        module: &ShaderModule,
        title: &str,
        stem: &str,
    ) -> Result<ExportedModule, Diagnostic> {
        let of_module =
            if module.is_draw() { stem.to_owned() } else { format!("{stem}.{}", module.name) };
        let request = Request {
            language: self,
            module,
            title,
            stem: of_module,
            description: format!("{stem}.json"),
        };
        (self.write)(&request).map_err(|reason| {
            Diagnostic::error(
                "export-failed",
                tr!(
                    "the module `{module}` cannot be written as {language}: {reason}",
                    module = module.name,
                    language = self.label
                ),
            )
            .hint(tr!("another language may take it; where it should, please report the look"))
        })
    }
}

/// The entry points as the back ends of most languages name them: by their own names.
pub(super) fn entry_points(module: &ShaderModule) -> Vec<LanguageEntryPoint> {
    let point = |point: &super::reflect::EntryPoint| LanguageEntryPoint {
        stage: point.stage,
        name: point.name.clone(),
    };
    module.entry_points.iter().map(point).collect()
}
