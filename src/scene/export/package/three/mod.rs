//! The package `three`: a look as materials of three.js.
//!
//! `STEM.material.js` has the class for `WebGLRenderer`, `STEM.node-material.js` that for
//! `WebGPURenderer`; both are a few lines over a runtime that is the same for all looks and lies
//! beside them as `chiaro.*.js`. The look itself, its shaders and its host work, is the ES module
//! `STEM.js`, which is written with every package.
//!
//! - `webgl.js`: the module's GLSL in a `RawShaderMaterial`. Blocks become plain uniforms, which
//!   three.js sets for each object; buffers of blocks it would fill once a frame.
//! - `webgpu.js`: the module's WGSL in a `NodeMaterial`. three.js binds everything by itself, so
//!   that the module's functions are called with what three.js has bound.
//! - `look.js`, `scene.js`, `textures.js`: what both have: values, lights, camera, images.
//!
//! Passes before the picture are drawn by the materials themselves, inside of the renderer's
//! `render`, as three's own mirrors do.

use chiaro_locale::text;

use super::super::ExportFile;
use super::materials::{Materials, with_value_types};
use super::{Package, PackageRequest};
use crate::diag::Diagnostic;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "three",
    label: text!("three.js"),
    help: text!(
        "ES modules with a material for each of three.js's renderers, and a page that shows it."
    ),
    opens: None,
    run_with: Some("three.js 0.187.0 in Chromium, both renderers"),
    is_without_passes: false,
    write,
};

/// Version of three.js that the package was run with.
const VERSION: &str = "0.187.0";

/// Files of the runtime: names in this folder, and texts.
const RUNTIME: [(&str, &str); 13] = [
    ("webgl.js", include_str!("webgl.js")),
    ("webgpu.js", include_str!("webgpu.js")),
    ("look.js", include_str!("look.js")),
    ("scene.js", include_str!("scene.js")),
    ("textures.js", include_str!("textures.js")),
    ("values.js", include_str!("../shared/values.js")),
    ("passes.js", include_str!("../shared/passes.js")),
    ("shadows.js", include_str!("../shared/shadows.js")),
    ("uniforms.js", include_str!("../shared/uniforms.js")),
    ("mirror.js", include_str!("mirror.js")),
    ("frames.js", include_str!("../shared/frames.js")),
    ("math.js", include_str!("../shared/math.js")),
    ("ktx2.js", include_str!("../shared/ktx2.js")),
];

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
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
        (format!("{stem}.node-material.js"), include_str!("node-material.js").to_owned()),
        (format!("{stem}.material.d.ts"), typings(&WEBGL)),
        (format!("{stem}.node-material.d.ts"), typings(&WEBGPU)),
        ("index.html".to_owned(), include_str!("index.html").to_owned()),
        ("README.md".to_owned(), include_str!("README.md").to_owned()),
        ("package.json".to_owned(), include_str!("package.json").to_owned()),
    ];
    materials.files(templates, &RUNTIME, VERSION)
}

/// Difference between the typings of one class and those of the other.
struct Typings {
    class: &'static str,
    renderer: &'static str,
    base: &'static str,
    module: &'static str,
}

const WEBGL: Typings = Typings {
    class: "{{class}}Material",
    renderer: "WebGLRenderer",
    base: "RawShaderMaterial",
    module: "three",
};

const WEBGPU: Typings = Typings {
    class: "{{class}}NodeMaterial",
    renderer: "WebGPURenderer",
    base: "NodeMaterial",
    module: "three/webgpu",
};

/// The template of the typings for one renderer.
fn typings(of: &Typings) -> String {
    with_value_types(include_str!("material.d.ts"))
        .replace("{{type}}", of.class)
        .replace("{{renderer}}", of.renderer)
        .replace("{{base}}", of.base)
        .replace("{{module}}", of.module)
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
        assert!(text(&files, "2-rim.material.js").starts_with("// Rim and light: a look"));
        let image =
            "  \"2-rim.50% #1.png\": new URL(\"./2-rim.50%25 %231.png\", import.meta.url),\n";
        assert!(text(&files, "2-rim.node-material.js").contains(image));
        let types = text(&files, "2-rim.node-material.d.ts");
        assert!(types.contains("class Look2RimNodeMaterial extends NodeMaterial"), "{types}");
        assert!(types.contains("  get \"warmth\"(): number;\n"), "{types}");
        assert!(types.contains("  set \"tint\"(value: ColorValue | undefined);\n"), "{types}");
        assert!(types.contains("follow(id: \"key\", light"), "{types}");
    }
}
