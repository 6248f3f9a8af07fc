//! The package `unity`: a look as a shader and a component for Unity's Universal Render Pipeline.
//!
//! - `Runtime/STEM.shader` has the passes that the pipeline draws, and the numbers of the look as
//!   properties of the material, all in one block, as the SRP Batcher wants them.
//! - `Runtime/STEM.hlsl` is the look, as `--to hlsl` writes it, without bindings ([`source`]).
//! - `Runtime/CLASSLook.cs` is the component, with parameters, lights and the host work
//!   ([`component`]).
//! - `Samples~/Scene` has a scene that shows the look ([`sample`]).
//!
//! Unity's world is left-handed, Chiaro's right-handed: x is mirrored, as Unity's own importers of
//! meshes do, so that what is to the viewer's left of a mesh stays there. A mesh that Unity has
//! imported has x mirrored itself; shader and component mirror it back before the look sees it.

mod component;
mod images;
pub(super) mod leaves;
mod parameters;
mod sample;
mod scratch;
pub(super) mod shader;
pub(super) mod source;

use chiaro_locale::{text, tr};
use serde_json::json;

use super::super::ExportFile;
use super::super::pretty::pretty;
use super::godot::defaults;
use super::materials::class_name;
use super::parameter_table::parameter_table_with;
use super::stable_id::stable_id;
use super::{Package, PackageRequest};
use crate::diag::Diagnostic;
use crate::document::ColorSpace;
use parameters::ComponentField;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "unity",
    label: text!("Unity (URP)"),
    help: text!(
        "A package for Unity 6 with a shader for the Universal Render Pipeline and a component."
    ),
    opens: None,
    run_with: None,
    is_without_passes: false,
    write,
};

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

/// Folder of what runs in a game, as Unity's packages have it.
const RUNTIME: &str = "Runtime";

/// Text about images, where the look reads some.
const IMAGES: &str = "\
- **Images** are in the component's fields from the start. How they repeat and are filtered are
  their import settings, which the export brings along. A painted surface is a file of bytes, of
  which the component makes one array of textures for all objects.
";

/// The Unity and the pipeline that the text is made for.
const UNITY: &str = "6000.0";

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let told = |pass: &str| {
        tr!("the look draws passes before the picture (the first is `{pass}`), which the package \
             unity does not")
    };
    request.refuse_passes(told).map_err(one)?;
    let mut source = source::Source::of(request, &source::UNITY).map_err(one)?;
    source.text = images::from_below(&source.text).map_err(one)?;
    let leaves = leaves::leaves(request, &source).map_err(one)?;
    let numbers = defaults::numbers(request).map_err(one)?;
    let (stem, class) = (request.stem, class_name(request.stem));
    let parts = parameters::fields(request);
    let images = images::images(request, &source.images, &parts);
    let component = component::write(request, &class, &leaves, &parts, &images).map_err(one)?;
    let title = plain(request.title);
    let mut files = vec![
        ExportFile::text(
            format!("{stem}.shader"),
            shader::write(request, &source, &leaves, &numbers, &images),
        ),
        ExportFile::text(format!("{stem}.hlsl"), source.text.clone()),
        ExportFile::text(format!("{class}Look.cs"), component),
        images::component_meta(stem, &format!("{class}Look.cs"), &images),
        ExportFile::text(format!("Chiaro.{class}.asmdef"), assembly(&class)),
        ExportFile::text("package.json".to_owned(), manifest(&class, &title)),
        ExportFile::text("README.md".to_owned(), readme(request, &class, &title, &parts)),
    ];
    files.extend(images::files(request, &images));
    let has_tangents = source.attributes.iter().any(|it| it.name == "tangent");
    files.extend(sample::files(request, &class, &images, has_tangents));
    // Whatever has no import settings of its own has an id.
    let names: Vec<String> = files.iter().map(|file| file.name.clone()).collect();
    let own = names.iter().map(String::as_str).filter(|name| !name.ends_with(".meta"));
    for name in own.chain([super::EXPECTED, "chiaro.json"]) {
        if !names.contains(&format!("{name}.meta")) {
            files.push(meta(name, stem));
        }
    }
    // Ids come of names without the folder, where packages of earlier exports have the files.
    for file in files.iter_mut().filter(|file| !is_of_package(&file.name)) {
        file.name = format!("{RUNTIME}/{}", file.name);
    }
    files.push(folder_meta(RUNTIME, stem));
    Ok(files)
}

/// True for files that stand beside the folder of what runs: those that packages have there, and
/// the sample.
fn is_of_package(name: &str) -> bool {
    let beside = ["package.json", "README.md", super::EXPECTED, "chiaro.json"];
    let own = name.strip_suffix(".meta").unwrap_or(name);
    beside.contains(&own) || own.starts_with(sample::FOLDER)
}

/// A title without what would end a text of ShaderLab, C#, XML or a menu's entry.
pub(super) fn plain(title: &str) -> String {
    let kept = |c: char| if "\"\\/<>&{}*`".contains(c) || c.is_control() { ' ' } else { c };
    let text: String = title.chars().map(kept).collect();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The assembly that Unity compiles the component into: packages need one.
fn assembly(class: &str) -> String {
    pretty(&json!({"name": format!("Chiaro.{class}"), "rootNamespace": "Chiaro"}))
}

/// File that Unity's package manager reads.
fn manifest(class: &str, title: &str) -> String {
    pretty(&json!({
        "name": format!("com.chiaro.look.{}", class.to_lowercase()),
        "version": env!("CARGO_PKG_VERSION"),
        "displayName": title,
        "description": "A look made with Chiaro.",
        "unity": UNITY,
        "dependencies": {"com.unity.render-pipelines.universal": "17.0.3"},
        "samples": [{
            "displayName": "Scene",
            "description": "The look on a mesh, with a camera.",
            "path": sample::FOLDER,
        }],
        "author": {"name": format!("made by Chiaro {}", env!("CARGO_PKG_VERSION"))},
    }))
}

/// The file by which Unity knows another one: its id is the same in every export of the look, so
/// that scenes that use it stay whole.
fn meta(name: &str, stem: &str) -> ExportFile {
    let text = format!("fileFormatVersion: 2\nguid: {}\n", stable_id(stem, name));
    ExportFile::text(format!("{name}.meta"), text)
}

/// The file by which Unity knows a folder.
fn folder_meta(name: &str, stem: &str) -> ExportFile {
    let text = format!(
        "fileFormatVersion: 2\nguid: {}\nfolderAsset: yes\nDefaultImporter:\n  \
         externalObjects: {{}}\n",
        stable_id(stem, name)
    );
    ExportFile::text(format!("{name}.meta"), text)
}

fn readme(
    request: &PackageRequest<'_>,
    class: &str,
    title: &str,
    fields: &[ComponentField],
) -> String {
    let lights = request.description.lights.iter();
    let lights: Vec<String> = lights.map(|light| format!("`{}`", light.id)).collect();
    let lights = if lights.is_empty() { "none here".to_owned() } else { lights.join(", ") };
    let table = parameter_table_with(request.description, |parameter| {
        let name = parameter.name.as_ref()?;
        let field = fields.iter().find(|field| field.parameter == name.as_str());
        Some(field.map_or_else(|| name.to_string(), |field| field.name.clone()))
    });
    // Only a project of linear light decodes images as they are read.
    let needs_linear = request.look.color_space == ColorSpace::Linear
        && request.description.images.iter().any(|it| it.kind == "image" && it.encoding == "color");
    let gamma = if needs_linear { ": this look's images want a linear project" } else { "" };
    README
        .replace("{{name}}", title)
        .replace("{{class}}", class)
        .replace("{{stem}}", request.stem)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{lights}}", &lights)
        .replace("{{images}}\n", if request.description.images.is_empty() { "" } else { IMAGES })
        .replace("{{gamma}}", gamma)
        .replace("{{table}}\n", &table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_32_digits_and_differ() {
        let id = |name, stem| String::from_utf8(meta(name, stem).bytes).expect("text");
        let one = id("a.shader", "a");
        assert_eq!(one.lines().nth(1).map(str::len), Some("guid: ".len() + 32));
        assert_eq!(one, id("a.shader", "a"));
        assert_ne!(one, id("a.hlsl", "a"));
        assert_ne!(one, id("a.shader", "b"));
    }

    #[test]
    fn titles_end_no_text() {
        assert_eq!(plain("Rim \"light\" / <b> & more\\"), "Rim light b more");
    }
}
