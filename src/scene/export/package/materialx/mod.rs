//! The package `materialx`: a look as a node of MaterialX, with a material that wears it.
//!
//! - `STEM.mtlx` has the node with the exposed parameters, the graph that gives it the surface, and
//!   the material ([`document`]).
//! - `STEM.glsl` is the look as one function, host work within ([`source`]). Generators for OpenGL,
//!   its embedded form and Vulkan read it.
//!
//! For all other hosts the document has the look once more, as a graph of MaterialX's own nodes
//! ([`standard`]), where those can express it.

mod document;
mod inputs;
mod literal;
mod source;
mod standard;

use chiaro_locale::{in_english, text, tr};

use super::super::ExportFile;
use super::{Package, PackageRequest, refusal};
use crate::diag::Diagnostic;
use crate::document::LightSpace;

pub(super) use source::{rename_clashes, without_attributes};

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "materialx",
    label: text!("MaterialX"),
    help: text!(
        "A MaterialX document with the look as a node, its function in GLSL, and a material."
    ),
    opens: None,
    run_with: Some("MaterialX 1.39.5 and its renderer, on llvmpipe"),
    is_without_passes: false,
    write,
};

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    refuse(request).map_err(one)?;
    let name = node_name(request.stem);
    let inputs = inputs::inputs(request).map_err(one)?;
    let parts = source::parts(request).map_err(one)?;
    let source = source::Source::of(request, &name, &inputs, &parts).map_err(one)?;
    // The README says why a look has no graph of standard nodes.
    let standard = in_english(|| standard::graph(request, &name, &inputs, &parts));
    let graph = standard.as_ref().map_or("", |graph| graph.text.as_str());
    let document = document::write(request, &name, &inputs, &source, graph);
    Ok(vec![
        ExportFile::text(format!("{}.mtlx", request.stem), document),
        ExportFile::text(format!("{}.glsl", request.stem), source.text),
        ExportFile::text("README.md".to_owned(), readme(request, &name, &standard)),
    ])
}

/// Refuses what a node of MaterialX cannot draw.
fn refuse(request: &PackageRequest<'_>) -> Result<(), Diagnostic> {
    request.refuse_passes(|pass| {
        tr!(
            "the look draws passes before the picture (the first is `{pass}`), which MaterialX has \
             no place for"
        )
    })?;
    let help = tr!("export the look `--to web`, `three` or `blender`");
    request.refuse_images("materialx", help)?;
    if request.work.is_keyed {
        return Err(refusal(
            tr!("the look has keys, which MaterialX has no place for"),
            tr!("take the keys away and expose what they move, or export `--to web` or `three`"),
        ));
    }
    let is_carried =
        |space: LightSpace| matches!(space, LightSpace::Illumination | LightSpace::World);
    let mut lights = request.work.lights.iter();
    if let Some(light) = lights.find(|light| !is_carried(light.light.space)) {
        return Err(refusal(
            tr!(
                "the light `{light}` goes with the camera or the object, which a node of MaterialX \
                 is not told of",
                light = light.id
            ),
            tr!("give the light the space `world`, or export `--to web` or `three`"),
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

fn readme(
    request: &PackageRequest<'_>,
    name: &str,
    standard: &Result<standard::StandardGraph, String>,
) -> String {
    let targets = match standard {
        Ok(graph) => format!(
            "The node has two forms, and generators choose by themselves.\n\n\
             - GLSL, `{{{{stem}}}}.glsl`: the look as Chiaro draws it. OpenGL, WebGL and Vulkan \
             (`genglsl`, `genessl`,\n  `genvk`) take it, and with them MaterialXView.\n\
             - A graph, `NG_{name}_standard`: the look as {} of MaterialX's own nodes. OSL, MDL, \
             MSL and all\n  others take it, and so do programs that import graphs. Its nodes are \
             not told of pixels, so edges\n  are as sharp as pixels are, nor of sides, so all is \
             lit as from the front.\n\n\
             Where both can be had, take the GLSL; take the graph to go on in nodes.",
            graph.nodes
        ),
        Err(reason) => format!(
            "GLSL alone, `{{{{stem}}}}.glsl`, for OpenGL, WebGL and Vulkan: `genglsl`, `genessl` \
             and `genvk`, and\nwith them MaterialXView. None of OSL, MDL or MSL. There is no \
             graph of MaterialX's\nown nodes, for {reason}."
        ),
    };
    let lights = request.description.lights.iter();
    let lights: Vec<String> = lights.map(|light| format!("`{}`", light.id)).collect();
    let lights = if lights.is_empty() { "none here".to_owned() } else { lights.join(", ") };
    README
        .replace("{{targets}}", &targets)
        .replace("{{title}}", request.title)
        .replace("{{stem}}", request.stem)
        .replace("{{node}}", name)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{lights}}", &lights)
        .replace("{{table}}", &request.tables())
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
