//! The package `unity`: a look as a shader and a component for Unity's Universal Render Pipeline.
//!
//! - `STEM.shader` has the passes that the pipeline draws, and the numbers of the look as
//!   properties of the material, all in one block, as the SRP Batcher wants them.
//! - `STEM.hlsl` is the look, as `--to hlsl` writes it, without bindings ([`source`]).
//! - `CLASSLook.cs` is the component, with parameters, lights and the host work ([`component`]).
//!
//! Unity's world is left-handed, Chiaro's right-handed: x is mirrored, as Unity's own importers of
//! meshes do, so that what is to the viewer's left of a mesh stays there. A mesh that Unity has
//! imported has x mirrored itself; shader and component mirror it back before the look sees it.

mod component;
pub(super) mod leaves;
mod parameters;
pub(super) mod shader;
pub(super) mod source;

use serde_json::json;

use super::super::ExportFile;
use super::super::pretty::pretty;
use super::materials::class_name;
use super::stable_id::stable_id;
use super::{Package, PackageRequest};
use crate::diag::Diagnostic;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "unity",
    label: "Unity (URP)",
    help: "A package for Unity 6 with a shader for the Universal Render Pipeline and a component.",
    opens: None,
    run_with: None,
    write,
};

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

/// The Unity and the pipeline that the text is made for.
const UNITY: &str = "6000.0";

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    request.refuse_passes("the package unity does not").map_err(one)?;
    request.refuse_images("unity", IMAGES_HELP).map_err(one)?;
    let source = source::Source::of(request, &source::TAKEN).map_err(one)?;
    let leaves = leaves::leaves(request, &source).map_err(one)?;
    let (stem, class) = (request.stem, class_name(request.stem));
    let component = component::write(request, &class, &leaves).map_err(one)?;
    let title = plain(request.title);
    let mut files = vec![
        ExportFile::text(format!("{stem}.shader"), shader::write(request, &source, &leaves)),
        ExportFile::text(format!("{stem}.hlsl"), source.text),
        ExportFile::text(format!("{class}Look.cs"), component),
        ExportFile::text(format!("Chiaro.{class}.asmdef"), assembly(&class)),
        ExportFile::text("package.json".to_owned(), manifest(&class, &title)),
        ExportFile::text("README.md".to_owned(), readme(request, &class, &title)),
    ];
    let others = files.clone();
    files.extend(others.iter().map(|file| meta(&file.name, stem)));
    files.push(meta(super::EXPECTED, stem));
    files.push(meta("chiaro.json", stem));
    Ok(files)
}

/// Help for images, which the packages for Unity and Unreal do not carry.
pub(super) const IMAGES_HELP: &str =
    "export the look `--to hlsl` and bind its images, or `--to web` or `three`";

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
        "author": {"name": format!("made by Chiaro {}", env!("CARGO_PKG_VERSION"))},
    }))
}

/// The file by which Unity knows another one: its id is the same in every export of the look, so
/// that scenes that use it stay whole.
fn meta(name: &str, stem: &str) -> ExportFile {
    let text = format!("fileFormatVersion: 2\nguid: {}\n", stable_id(stem, name));
    ExportFile::text(format!("{name}.meta"), text)
}

fn readme(request: &PackageRequest<'_>, class: &str, title: &str) -> String {
    let lights = request.description.lights.iter();
    let lights: Vec<String> = lights.map(|light| format!("`{}`", light.id)).collect();
    let parameters = parameters::fields(request);
    let parameters: Vec<String> =
        parameters.iter().map(|field| format!("`{}`", field.name)).collect();
    let list = |names: &[String], none: &str| match names {
        [] => none.to_owned(),
        _ => names.join(", "),
    };
    README
        .replace("{{name}}", title)
        .replace("{{class}}", class)
        .replace("{{stem}}", request.stem)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{lights}}", &list(&lights, "none here"))
        .replace(
            "{{parameters}}",
            &list(&parameters, "none here: expose some in Chiaro, or export with `--live`"),
        )
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
