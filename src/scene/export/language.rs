//! What every language has in common.

use serde::Serialize;
use serde_json::{Map, Value};

use super::File;
use super::modules::ShaderModule;
use crate::diag::Diagnostic;

/// A language that looks are exported to.
#[derive(Debug)]
pub struct Language {
    /// What `--to` takes.
    pub slug: &'static str,
    /// What people call it.
    pub label: &'static str,
    /// What menus call it: without a version where there is but one.
    pub short_label: &'static str,
    /// What reads it, where its name does not say so; may be empty.
    pub api: &'static str,
    /// The files of a look that are text, for who copies one of them; none where the window copies
    /// it in another way.
    pub texts: &'static [TextFile],
    /// The program, none of ours, that accepts every golden output; `None` where there is none, and
    /// files say so.
    pub verified_by: Option<&'static str>,
    /// What its API expects of positions.
    pub clip_space: ClipSpace,
    /// What else a host has to know; may be empty.
    pub note: &'static str,
    pub(super) write: fn(&Request<'_>) -> Result<Written, String>,
}

/// A file of every exported look that is text.
#[derive(Debug)]
pub struct TextFile {
    /// What its name ends with.
    pub ending: &'static str,
    /// What it holds: `shader`, or one stage of it.
    pub content: &'static str,
}

/// A file for each stage, as GLSL has them: how the names end after that of the version.
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

/// What an API expects of the positions that a vertex shader gives, and how it counts the rows of
/// images. Exported shaders convert nothing: `clip_from_world` is the host's.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ClipSpace {
    /// Which way y points in clip space: `up` or `down` the picture.
    pub y: &'static str,
    /// z / w of what is nearest and farthest.
    pub depth: [f64; 2],
    /// Where the first row of a rendered image is: `top` or `bottom`.
    pub first_row: &'static str,
}

impl ClipSpace {
    /// Direct3D, Metal and WebGPU.
    pub(super) const WEBGPU: Self = Self { y: "up", depth: [0.0, 1.0], first_row: "top" };
    /// OpenGL, OpenGL ES and WebGL.
    pub(super) const OPENGL: Self = Self { y: "up", depth: [-1.0, 1.0], first_row: "bottom" };
    /// Vulkan.
    pub(super) const VULKAN: Self = Self { y: "down", depth: [0.0, 1.0], first_row: "top" };
}

/// What a language is asked to write.
pub(super) struct Request<'a> {
    pub(super) language: &'static Language,
    pub(super) module: &'a ShaderModule,
    /// The look's name, fit for a comment.
    pub(super) title: &'a str,
    /// What the names of this module's files begin with.
    pub(super) stem: String,
    /// The JSON description's name.
    pub(super) description: String,
}

/// A module in one language.
pub(super) struct Written {
    pub(super) files: Vec<File>,
    pub(super) described: LanguageModule,
}

/// How a module goes in one language.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LanguageModule {
    /// The module.
    pub module: String,
    /// The files it lies in.
    pub files: Vec<LanguageFile>,
    /// Where its bindings are and what they are called.
    pub bindings: Vec<LanguageBinding>,
    /// What its vertex attributes are called.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub attributes: Vec<LanguageAttribute>,
}

/// A file of a module.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LanguageFile {
    /// Its name, beside the description.
    pub file: String,
    /// The entry points in it.
    pub entry_points: Vec<LanguageEntryPoint>,
}

/// An entry point as a language calls it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LanguageEntryPoint {
    /// `vertex` or `fragment`.
    pub stage: &'static str,
    /// What to ask the API for.
    pub name: String,
}

/// A binding in one language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LanguageBinding {
    /// The module's binding.
    pub binding: String,
    /// The sampler that is one with this texture, in languages that join the two.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sampler: Option<String>,
    /// What it is called here, to the API where that asks for names.
    pub name: String,
    /// Where it is, in the API's words: `{"group": 0, "binding": 1}`, `{"unit": 0}`, `{"register":
    /// "b0"}`.
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
    /// The module's attribute.
    pub attribute: String,
    /// What it is called here.
    pub name: String,
}

impl Language {
    /// Writes one module.
    pub(super) fn write(
        &'static self,
        module: &ShaderModule,
        title: &str,
        stem: &str,
    ) -> Result<Written, Diagnostic> {
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
                format!(
                    "the module `{}` cannot be written as {}: {reason}",
                    module.name, self.label
                ),
            )
            .hint("another language may take it; where it should, please report the look")
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
