//! The package `unreal`: a look as a material of Unreal Engine 5, without C++.
//!
//! - `STEM.ush` has the look and its host work as functions of HLSL, in a namespace of their own
//!   ([`shader`], [`host`]).
//! - `STEM.material.txt` is a material graph for the clipboard: a Custom node that calls the
//!   functions, a parameter for each that is exposed, and what Unreal knows of the pixel
//!   ([`graph`]).
//!
//! Unreal's world is left-handed with z up, in centimeters. Chiaro's y and z are Unreal's z and y,
//! as Unreal's own importers of glTF and FBX turn meshes: one reflection, which is its own inverse.

mod arguments;
mod graph;
mod host;
mod images;
mod pieces;
mod shader;

use chiaro_locale::{text, tr};

use super::super::ExportFile;
use super::materials::class_name;
use super::unity::plain;
use super::unity::shader::draws_both_sides;
use super::{Package, PackageRequest, refusal};
use crate::diag::Diagnostic;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "unreal",
    label: text!("Unreal Engine"),
    help: text!(
        "Shader functions and a material graph to paste into Unreal Engine 5, without C++."
    ),
    opens: None,
    run_with: None,
    is_without_passes: false,
    write,
};

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    refuse(request).map_err(|problem| vec![problem])?;
    request.refuse_blocks(tr!("Unreal's importer"))?;
    let one = |problem: Diagnostic| vec![problem];
    let (stem, class) = (request.stem, class_name(request.stem));
    let arguments = arguments::arguments(request, &class);
    let shader = shader::write(request, &class, &arguments).map_err(one)?;
    let material = graph::write(request, &class, &arguments, &shader);
    let readme = readme(request, &shader);
    let mut files = vec![
        ExportFile::text(format!("{stem}.ush"), shader.text),
        ExportFile::text(format!("{stem}.material.txt"), material),
        ExportFile::text("README.md".to_owned(), readme),
    ];
    files.extend(images::files(request, &shader.images));
    Ok(files)
}

/// Refuses what the package cannot draw.
fn refuse(request: &PackageRequest<'_>) -> Result<(), Diagnostic> {
    request.refuse_passes(|pass| {
        tr!("the look draws passes before the picture (the first is `{pass}`), which the package \
             unreal does not")
    })?;
    if !request.work.near.is_empty() {
        return Err(refusal(
            tr!(
                "keys of the look follow the distance of other objects, which a material does not \
                 know"
            ),
            tr!("drive the keys otherwise, or export `--to unity` or `web`"),
        ));
    }
    Ok(())
}

fn readme(request: &PackageRequest<'_>, shader: &shader::UnrealShader<'_>) -> String {
    let is_opaque = request.description.opaque;
    let (blend, links) = match (shader.cuts, is_opaque) {
        (true, _) => (
            "*Masked*: the look cuts parts away",
            "*return* into *Emissive Color*, *Opacity* into *Opacity Mask*",
        ),
        (_, false) => (
            "*Translucent*; *Opaque* is the same while the alpha of every color is 1",
            "*return* into *Emissive Color*, *Opacity* into *Opacity*",
        ),
        _ => ("*Opaque*", "*return* into *Emissive Color*"),
    };
    let sides = if draws_both_sides(request) {
        "on: through what is cut away the inside shows"
    } else {
        "off; on for open meshes"
    };
    README
        .replace("{{name}}", &plain(request.title))
        .replace("{{stem}}", request.stem)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{include}}", &graph::include_path(request))
        .replace("{{blend}}", blend)
        .replace("{{sides}}", sides)
        .replace("{{links}}", links)
        .replace("{{images}}\n", &images::steps(&shader.images, request.look.color_space))
        .replace("{{table}}\n", &request.tables())
}
