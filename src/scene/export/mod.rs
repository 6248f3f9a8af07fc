//! Export of looks as files for other programs.
//!
//! [`export`] compiles a look with its exposed parameters alive, adds the passes that it needs, has
//! each language write every module, and describes the result in one JSON file: the bindings, the
//! values to put there, the order of drawing, and the program that turns the parameters that an
//! artist sets into the numbers that the shader reads. [`description`] documents that file.
//!
//! A language is one file of this module and one line in [`LANGUAGES`]; naga's back ends write the
//! text. Positions in clip space are left exactly as `view.clip_from_world` gives them in every
//! language, so that a host uses the projection matrices of its own API.

pub mod description;
mod exposed;
mod files;
mod glsl;
mod glsl_330;
mod glsl_450;
mod glsl_es300;
mod header;
mod hlsl;
mod host;
pub mod host_code;
mod language;
mod live;
mod modules;
mod msl;
mod one_file;
mod options;
pub mod package;
mod pretty;
mod program;
mod readable;
mod reflect;
mod remainders;
mod slang;
mod spirv;
mod textures;
mod tiers;
mod wgsl;

use std::path::Path;

use chiaro_locale::tr;
use serde_json::json;

use crate::compile::check;
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::Look;
use crate::frame::Assets;
use crate::library::Library;

pub use files::{in_the_way, write};
pub use language::{Language, TextFile};
pub use options::ExportOptions;
pub use spirv::{fragment_spirv_words, spirv_words};

/// All languages, in the order in which the window lists them: WGSL, three versions of GLSL, HLSL,
/// Slang, MSL and SPIR-V.
pub const LANGUAGES: [&Language; 8] = [
    &wgsl::LANGUAGE,
    &glsl_es300::LANGUAGE,
    &glsl_330::LANGUAGE,
    &glsl_450::LANGUAGE,
    &hlsl::LANGUAGE,
    &slang::LANGUAGE,
    &msl::LANGUAGE,
    &spirv::LANGUAGE,
];

/// Slug that stands for all languages.
pub const ALL: &str = "all";

/// The language that `chiaro export --to` calls `slug`.
pub fn language(slug: &str) -> Option<&'static Language> {
    LANGUAGES.into_iter().find(|language| language.slug == slug)
}

/// The languages that these slugs name, each once, in their order; `all` names every language.
///
/// # Errors
/// A problem for each slug that names no language.
pub fn languages<'a>(
    slugs: impl IntoIterator<Item = &'a str>,
) -> Result<Vec<&'static Language>, Vec<Diagnostic>> {
    let known = LANGUAGES.map(|language| language.slug);
    let mut found: Vec<&'static Language> = Vec::new();
    let mut problems = Vec::new();
    for slug in slugs {
        match (slug.trim(), language(slug.trim())) {
            (ALL, _) => found.extend(LANGUAGES),
            (_, Some(language)) => found.push(language),
            (slug, None) => {
                let problem =
                    Diagnostic::error("unknown-language", tr!("there is no language `{slug}`"));
                let hint = tr!("the languages are {names}, or {ALL}", names = known.join(", "));
                problems.push(problem.suggest(slug, known).hint(hint));
            }
        }
    }
    let mut seen: Vec<&str> = Vec::new();
    found.retain(|language| {
        let is_new = !seen.contains(&language.slug);
        seen.push(language.slug);
        is_new
    });
    if problems.is_empty() { Ok(found) } else { Err(problems) }
}

/// The warning about languages whose files no compiler here has seen; `None` where there are none.
pub fn unverified(languages: &[&'static Language]) -> Option<String> {
    let labels: Vec<&str> = languages
        .iter()
        .filter(|language| language.verified_by.is_none())
        .map(|language| language.label)
        .collect();
    let plural = if labels.len() == 1 { "is" } else { "are" };
    let told = || {
        format!("{} {plural} unverified: no compiler here has seen the files", labels.join(" and "))
    };
    (!labels.is_empty()).then(told)
}

/// A file of an export, to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExportFile {
    /// Name of the file, without folders.
    pub name: String,
    /// Content of the file.
    pub bytes: Vec<u8>,
}

impl ExportFile {
    fn text(name: String, text: String) -> Self {
        Self { name, bytes: text.into_bytes() }
    }
}

/// Exports `look` in `languages` as files whose names begin with `stem`, such as `rim` for
/// `rim.frag`. The images and HCBTFs that the look reads, whose paths are relative to `folder`, are
/// read with `assets` and carried along; one that cannot be read is a warning. Returns the files to
/// write, in order; no two files have the same name.
///
/// # Errors
/// All errors of the look, and constructs that a language cannot express.
pub fn export(
    look: &Look,
    library: &Library,
    stem: &str,
    languages: &[&'static Language],
    (folder, assets): (&Path, &mut Assets),
) -> Result<WithWarnings<Vec<ExportFile>>, Vec<Diagnostic>> {
    let (typed, mut warnings) = check(look, library, None)?.into_parts();
    let mut modules = modules::compile(&typed, stem)?;
    let carried = textures::carried(&mut modules.images, stem, folder, assets).tell(&mut warnings);
    let mut files = Vec::new();
    let mut written = Vec::new();
    let mut problems = Vec::new();
    for &language in languages {
        for module in &modules.modules {
            match language.write(module, &modules.title, stem) {
                Ok(found) => {
                    files.extend(found.files);
                    written.push((language, found.described));
                }
                Err(problem) => problems.push(problem),
            }
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let description = description::description(look, library, &typed, &modules, &written);
    files.extend(modules.prepare_files());
    files.push(ExportFile::text(format!("{stem}.json"), pretty::pretty(&json!(description))));
    files.extend(carried);
    Ok(WithWarnings::new(files, warnings))
}
