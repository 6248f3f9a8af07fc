//! The package `blender`: an add-on for Blender 5 that draws the look in the 3D viewport, and from
//! scripts.
//!
//! The add-on is one file: the look's shaders and host work ([`super::python`]), then `player.py`,
//! which draws with Blender's GPU module, and `addon.py`, the panel. `__init__.py` and
//! `blender_manifest.toml` make an extension of the whole folder, which carries images along.

mod osl;

use chiaro_locale::{in_english, text, tr};

use super::super::ExportFile;
use super::{Package, PackageRequest, python, refusal};
use crate::diag::Diagnostic;
use serde_json::json;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "blender",
    label: text!("Blender add-on"),
    help: text!("An add-on for Blender 5 that draws the look in the viewport, with a panel."),
    opens: None,
    run_with: Some("Blender 5.0.1, as the Python module bpy"),
    is_without_passes: false,
    write,
};

/// The text of the player.
const PLAYER: &str = include_str!("player.py");

/// The text of the material for Cycles.
const MATERIAL: &str = include_str!("material.py");

/// The text of the panel.
const ADDON: &str = include_str!("addon.py");

/// The file by which the folder is an extension.
const EXTENSION: &str = include_str!("extension.py");

/// The extension's description.
const MANIFEST: &str = include_str!("blender_manifest.toml");

/// Part of the README on the shader for Cycles.
const CYCLES: &str = include_str!("cycles.md");

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    refuse(request)?;
    let look = python::write(request).map_err(|problem| vec![problem])?;
    // The README says why a look has no shader of OSL.
    let shader = in_english(|| osl::OslShader::of(request));
    let cycles = match &shader {
        Ok(shader) => python::literal(&shader.about, 0),
        Err(_) => "None".to_owned(),
    };
    let reason = shader.as_ref().err().map_or_else(String::new, reason_of);
    let (title, version) = (request.title, env!("CARGO_PKG_VERSION"));
    let name = serde_json::Value::from(title);
    let numbers = concat!(
        env!("CARGO_PKG_VERSION_MAJOR"),
        ", ",
        env!("CARGO_PKG_VERSION_MINOR"),
        ", ",
        env!("CARGO_PKG_VERSION_PATCH")
    );
    let stored = stored_name(request.stem);
    let text = format!(
        "# {title}: made by Chiaro {version}, an add-on for Blender 5.\n\
         # Install it as README.md says, or run it in Blender's text editor.\n\n\
         bl_info = {{\n    \
             \"name\": {name},\n    \
             \"author\": \"Chiaro\",\n    \
             \"version\": ({numbers}),\n    \
             \"blender\": (5, 0, 0),\n    \
             \"category\": \"3D View\",\n    \
             \"location\": \"3D Viewport, Sidebar, Chiaro\",\n    \
             \"description\": \"Draws the look in the viewport\",\n\
         }}\n\n\
         import copy\nimport math\nimport os\nimport re\nimport struct\nimport traceback\n\
         import zlib\n\n\
         import bpy\nimport gpu\nimport numpy as np\nfrom mathutils import Matrix, Vector\n\n\
         # Name of the look's settings in a scene, and of the mark of what wears the look.\n\
         STORED = \"{stored}\"\n\n\
         # Names of the parameters of the shader for Cycles; None where there is none, and why.\n\
         CYCLES = {cycles}\n\
         NOT_IN_CYCLES = {}\n\n\
         {look}\n\n{PLAYER}\n\n{MATERIAL}\n\n{ADDON}",
        json!(reason)
    );
    let mut files = vec![
        ExportFile::text(format!("{}.py", module_name(request.stem)), text),
        ExportFile::text("__init__.py".to_owned(), filled(EXTENSION, request)),
        ExportFile::text("blender_manifest.toml".to_owned(), filled(MANIFEST, request)),
        ExportFile::text("README.md".to_owned(), readme(request, &shader)),
    ];
    if let Ok(shader) = shader {
        files.push(ExportFile::text(format!("{}.osl", request.stem), shader.text));
    }
    files.extend(request.textures.iter().cloned());
    Ok(files)
}

/// Refuses what the add-on cannot draw.
fn refuse(request: &PackageRequest<'_>) -> Result<(), Vec<Diagnostic>> {
    request.refuse_blocks(tr!("Blender's scripts"))?;
    let described = serde_json::json!(request.description);
    let mut images = described["images"].as_array().cloned().unwrap_or_default();
    // Painted surfaces are read texel by texel.
    images.retain(|image| image["kind"] != "hcbtf");
    let sampling = |image: &serde_json::Value| [image["wrap"].clone(), image["filter"].clone()];
    if images.iter().any(|image| sampling(image) != sampling(&images[0])) {
        let message = tr!(
            "images of the look have different wraps or filters, and the add-on has one for all"
        );
        let help = tr!("give the look's image nodes the same wrap and the same filter");
        return Err(vec![refusal(message, help)]);
    }
    Ok(())
}

/// Name of the add-on's file, which Python imports by it.
fn module_name(stem: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = stem.chars().map(kept).collect();
    if name.starts_with(|c: char| c.is_ascii_digit()) { format!("look_{name}") } else { name }
}

/// Name of the look's settings in a scene. Blender takes small letters of ASCII, below 64.
fn stored_name(stem: &str) -> String {
    let name = module_name(stem).to_ascii_lowercase();
    format!("chiaro_{}", name.get(..32).unwrap_or(&name))
}

/// Id of the extension: words between single underscores, as Blender wants it.
fn extension_id(stem: &str) -> String {
    let name = module_name(stem).to_ascii_lowercase();
    let words: Vec<&str> = name.split('_').filter(|word| !word.is_empty()).collect();
    words.join("_")
}

/// The README, which tells of Cycles what there is.
fn readme(request: &PackageRequest<'_>, shader: &Result<osl::OslShader, Diagnostic>) -> String {
    let cycles = match shader {
        Ok(_) => CYCLES.to_owned(),
        Err(problem) => {
            format!("**Cycles.** There is no shader for Cycles here: {}.\n", reason_of(problem))
        }
    };
    filled(&README.replace("{{cycles}}\n", &cycles), request)
}

/// The reason of a problem, and what helps.
fn reason_of(problem: &Diagnostic) -> String {
    let parts = [problem.message.as_str()].into_iter().chain(problem.hints.iter().map(|it| &**it));
    parts.collect::<Vec<_>>().join("; ")
}

/// A template with its places filled.
fn filled(template: &str, request: &PackageRequest<'_>) -> String {
    let description = request.description;
    let lights: Vec<String> =
        description.lights.iter().map(|light| format!("`{}`", light.id.as_str())).collect();
    let lights = if lights.is_empty() { "none here".to_owned() } else { lights.join(", ") };
    let light = description.lights.first().map_or("NAME", |light| light.id.as_str());
    let mut floats = description.parameters.iter().filter(|it| it.live && it.ty == "float");
    let parameter = floats.find_map(|it| Some(it.name.as_ref()?.as_str())).unwrap_or("NAME");
    let camera = &request.scene.camera;
    // Blender's axes have z up.
    let place = |[x, y, z]: [f64; 3]| format!("({x:.2}, {:.2}, {y:.2})", -z);
    template
        .replace("{{quoted}}", &serde_json::Value::from(request.title).to_string())
        .replace("{{title}}", request.title)
        .replace("{{stem}}", &module_name(request.stem))
        .replace("{{osl}}", request.stem)
        .replace("{{id}}", &extension_id(request.stem))
        .replace("{{stored}}", &stored_name(request.stem))
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{lights}}", &lights)
        .replace("{{light}}", light)
        .replace("{{parameter}}", parameter)
        .replace("{{eye}}", &place(camera.eye))
        .replace("{{target}}", &place(camera.target))
        .replace("{{fov}}", &format!("{:.0}", camera.fov.to_degrees()))
        .replace("{{table}}", &request.tables())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_such_as_blender_takes() {
        assert_eq!(module_name("2-rim"), "look_2_rim");
        assert_eq!(stored_name("Rim-Light"), "chiaro_rim_light");
        assert_eq!(extension_id("-Rim--Light"), "rim_light");
        assert!(stored_name(&"long".repeat(40)).len() < 40);
    }
}
