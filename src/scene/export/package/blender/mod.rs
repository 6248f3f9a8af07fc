//! The package `blender`: an add-on for Blender 5 that draws the look in the 3D viewport, and from
//! scripts.
//!
//! The add-on is one file: the look's shaders and host work ([`super::python`]), then `player.py`,
//! which draws with Blender's GPU module, and `addon.py`, the panel.

use super::super::ExportFile;
use super::{Package, PackageRequest, python};
use crate::diag::Diagnostic;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "blender",
    label: "Blender add-on",
    help: "An add-on for Blender 5 that draws the look in the viewport, with a panel.",
    opens: None,
    run_with: Some("Blender 5.0.1, as the Python module bpy"),
    write,
};

/// The text of the player.
const PLAYER: &str = include_str!("player.py");

/// The text of the panel.
const ADDON: &str = include_str!("addon.py");

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    refuse(request)?;
    let look = python::write(request).map_err(|problem| vec![problem])?;
    let (title, version) = (request.title, env!("CARGO_PKG_VERSION"));
    let name = serde_json::Value::from(title);
    let text = format!(
        "# {title}: made by Chiaro {version}, an add-on for Blender 5.\n\
         # Install it as README.md says, or run it in Blender's text editor.\n\n\
         bl_info = {{\n    \
             \"name\": {name},\n    \
             \"blender\": (5, 0, 0),\n    \
             \"category\": \"3D View\",\n    \
             \"location\": \"3D Viewport, Sidebar, Chiaro\",\n    \
             \"description\": \"Draws the look in the viewport\",\n\
         }}\n\n\
         import copy\nimport math\nimport os\nimport re\nimport struct\nimport traceback\n\n\
         import bpy\nimport gpu\nimport numpy as np\nfrom mathutils import Matrix, Vector\n\n\
         {look}\n\n{PLAYER}\n\n{ADDON}"
    );
    let mut files = vec![
        ExportFile::text(format!("{}.py", module_name(request.stem)), text),
        ExportFile::text("README.md".to_owned(), readme(request)),
    ];
    files.extend(request.textures.iter().cloned());
    Ok(files)
}

/// Refuses what the add-on cannot draw.
fn refuse(request: &PackageRequest<'_>) -> Result<(), Vec<Diagnostic>> {
    let refusal = |message: &str, help: &str| {
        Err(vec![Diagnostic::error("blender-package", message).hint(help)])
    };
    if request.textures.iter().any(|file| file.name.ends_with(".ktx2")) {
        return refusal(
            "Blender's scripts read no KTX2 files, in which painted surfaces are",
            "export the look to `web` or `three`, or take the HCBTF node out of it",
        );
    }
    let described = serde_json::json!(request.description);
    let images = described["images"].as_array().cloned().unwrap_or_default();
    let sampling = |image: &serde_json::Value| [image["wrap"].clone(), image["filter"].clone()];
    if images.iter().any(|image| sampling(image) != sampling(&images[0])) {
        return refusal(
            "images of the look have different wraps or filters, and the add-on has one for all",
            "give the look's image nodes the same wrap and the same filter",
        );
    }
    Ok(())
}

/// Name of the add-on's file, which Python imports by it.
fn module_name(stem: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = stem.chars().map(kept).collect();
    if name.starts_with(|c: char| c.is_ascii_digit()) { format!("look_{name}") } else { name }
}

fn readme(request: &PackageRequest<'_>) -> String {
    let parameters = &request.description.parameters;
    let names: Vec<String> =
        parameters.iter().filter_map(|it| Some(format!("`{}`", it.name.as_ref()?))).collect();
    let listed = if names.is_empty() {
        "The look has no parameters: expose some in Chiaro and export again.".to_owned()
    } else {
        format!("The look has these parameters: {}.", names.join(", "))
    };
    README
        .replace("{{title}}", request.title)
        .replace("{{stem}}", &module_name(request.stem))
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{parameters}}", &listed)
}
