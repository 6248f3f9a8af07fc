//! The package `babylon`: a look as a material of Babylon.js.
//!
//! `STEM.material.js` has the class, a few lines over a runtime that is the same for all looks and
//! lies beside it as `chiaro.*.js`. WebGL engines are given the module's GLSL, WebGPU engines its
//! WGSL, between what Babylon.js declares by itself. Uniforms are buffers with exactly the bytes of
//! `LOOK.json`. Passes before the picture are render target textures of the material, which
//! Babylon.js draws before each camera's picture, as it does mirrors.

use chiaro_locale::text;

use super::super::ExportFile;
use super::materials::{Materials, with_value_types};
use super::{Package, PackageRequest};
use crate::diag::Diagnostic;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "babylon",
    label: text!("Babylon.js"),
    help: text!("An ES module with a material for Babylon.js, by WebGL and WebGPU."),
    opens: None,
    run_with: Some("Babylon.js 9.35.0 in Chromium, both engines"),
    is_without_passes: false,
    write,
};

/// Version of Babylon.js that the package was run with.
const VERSION: &str = "9.35.0";

/// Files of the runtime: names in this folder, and texts.
const RUNTIME: [(&str, &str); 13] = [
    ("runtime.js", include_str!("runtime.js")),
    ("module.js", include_str!("module.js")),
    ("targets.js", include_str!("targets.js")),
    ("passes.js", include_str!("../shared/passes.js")),
    ("scene.js", include_str!("scene.js")),
    ("shaders.js", include_str!("shaders.js")),
    ("textures.js", include_str!("textures.js")),
    ("frames.js", include_str!("../shared/frames.js")),
    ("ktx2.js", include_str!("../shared/ktx2.js")),
    ("math.js", include_str!("../shared/math.js")),
    ("shadows.js", include_str!("../shared/shadows.js")),
    ("values.js", include_str!("../shared/values.js")),
    ("uniforms.js", include_str!("../shared/uniforms.js")),
];

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    request.refuse_blocks("Babylon.js")?;
    let mut files = vec![request.module()?];
    files.extend(files_of(&Materials::of(request)));
    files.extend(request.textures.iter().cloned());
    Ok(files)
}

/// The files of the package beside the look's own module and images.
fn files_of(materials: &Materials<'_>) -> Vec<ExportFile> {
    let stem = materials.stem;
    let templates = [
        (format!("{stem}.material.js"), include_str!("material.js").to_owned()),
        (format!("{stem}.material.d.ts"), with_value_types(include_str!("material.d.ts"))),
        ("README.md".to_owned(), include_str!("README.md").to_owned()),
        ("package.json".to_owned(), include_str!("package.json").to_owned()),
    ];
    materials.files(templates, &RUNTIME, VERSION)
}

#[cfg(test)]
mod tests {
    use super::super::materials::tests::{example, is_complete, text};
    use super::*;

    #[test]
    fn the_package_is_complete_and_has_the_names_of_the_look() {
        let files = files_of(&example());
        is_complete(&files);
        assert!(text(&files, "2-rim.material.js").contains("class Look2RimMaterial extends"));
        let types = text(&files, "2-rim.material.d.ts");
        assert!(types.contains("  get \"warmth\"(): number;\n"), "{types}");
        assert!(types.contains("  set \"tint\"(value: ColorValue | undefined);\n"), "{types}");
    }
}
