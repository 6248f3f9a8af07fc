//! The package `materialx`: a look as a node of MaterialX, with a material that wears it.
//!
//! - `STEM.mtlx` has the node with the exposed parameters, the graph that gives it the surface, and
//!   the material ([`document`]).
//! - `STEM.glsl` is the look as one function, host work within ([`source`]). Generators for OpenGL,
//!   its embedded form and Vulkan read it.

mod document;
mod inputs;
mod literal;
mod source;

use super::super::ExportFile;
use super::{Package, PackageRequest, refusal};
use crate::diag::Diagnostic;
use crate::document::LightSpace;

pub(super) use source::{rename_clashes, without_attributes};

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "materialx",
    label: "MaterialX",
    help: "A MaterialX document with the look as a node, its function in GLSL, and a material.",
    opens: None,
    run_with: Some("MaterialX 1.39.5: validator and generator"),
    write,
};

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    refuse(request).map_err(one)?;
    let name = node_name(request.stem);
    let inputs = inputs::inputs(request).map_err(one)?;
    let source = source::Source::of(request, &name, &inputs).map_err(one)?;
    let document = document::write(request, &name, &inputs, &source);
    Ok(vec![
        ExportFile::text(format!("{}.mtlx", request.stem), document),
        ExportFile::text(format!("{}.glsl", request.stem), source.text),
        ExportFile::text("README.md".to_owned(), readme(request, &name)),
    ])
}

/// Refuses what a node of MaterialX cannot draw.
fn refuse(request: &PackageRequest<'_>) -> Result<(), Diagnostic> {
    request.refuse_passes("MaterialX has no place for")?;
    request.refuse_images("materialx", "export the look `--to web`, `three` or `blender`")?;
    if request.work.is_keyed {
        return Err(refusal(
            "the look has keys, which MaterialX has no place for",
            "take the keys away and expose what they move, or export `--to web` or `three`",
        ));
    }
    let is_carried =
        |space: LightSpace| matches!(space, LightSpace::Illumination | LightSpace::World);
    let mut lights = request.work.lights.iter();
    if let Some(light) = lights.find(|light| !is_carried(light.light.space)) {
        return Err(refusal(
            format!(
                "the light `{}` goes with the camera or the object, which a node of MaterialX is \
                 not told of",
                light.id
            ),
            "give the light the space `world`, or export `--to web` or `three`",
        ));
    }
    Ok(())
}

/// Name of the node, and beginning of the names in its GLSL: a word of small letters.
fn node_name(stem: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let name: String = stem.chars().map(kept).collect();
    // GLSL keeps two underscores in a row for itself.
    let words: Vec<&str> = name.split('_').filter(|word| !word.is_empty()).collect();
    let name = words.join("_");
    match name.chars().next() {
        Some(first) if first.is_ascii_alphabetic() => name,
        _ => format!("look_{name}").trim_end_matches('_').to_owned(),
    }
}

fn readme(request: &PackageRequest<'_>, name: &str) -> String {
    let lights = request.description.lights.iter();
    let lights: Vec<String> = lights.map(|light| format!("`{}`", light.id)).collect();
    let lights = if lights.is_empty() { "none here".to_owned() } else { lights.join(", ") };
    README
        .replace("{{title}}", request.title)
        .replace("{{stem}}", request.stem)
        .replace("{{node}}", name)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{lights}}", &lights)
        .replace("{{table}}", &request.parameter_table())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_have_names_of_both_languages() {
        assert_eq!(node_name("Rim--Light"), "rim_light");
        assert_eq!(node_name("2-rim"), "look_2_rim");
        assert_eq!(node_name("…"), "look");
    }
}
