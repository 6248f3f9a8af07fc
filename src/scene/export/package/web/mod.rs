//! The package `web`: a folder whose page opens from a file and draws the look, by WebGPU, or by
//! WebGL 2 where there is none.
//!
//! A page from a file can neither import modules nor read files beside it, so everything is in
//! classic scripts: the look (`LOOK.js`), the mesh with its camera ([`scene`]), images as base64,
//! the player, and the page. What scripts of an export define lies at [`place`], so that a page may
//! have several exports and names of its own. The player and the page are written as several files
//! each, which lie in this folder, and are joined into one script here. They fetch nothing.
//!
//! The player draws as `docs/hosts.md` says, by either of two executors with the same methods,
//! `webgpu.js` and `webgl2.js`. In WebGL it draws with y turned over and shows the picture upside
//! down, so that derivatives are those of WebGPU.

mod scene;

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use chiaro_locale::text;

use super::super::ExportFile;
use super::super::description::{Description, ExposedParameter};
use super::{Package, PackageRequest};
use crate::diag::Diagnostic;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "web",
    label: text!("Web page"),
    help: text!(
        "A page that opens from a file, by WebGPU or WebGL 2, with sliders for what is exposed."
    ),
    opens: Some("index.html"),
    run_with: Some("Chromium, by WebGPU and WebGL 2"),
    is_without_passes: false,
    write,
};

/// The page's markup, with places for the look's name and for the name of its files.
const PAGE: &str = include_str!("index.html");

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

/// The page's looks.
const STYLE: &str = include_str!("style.css");

/// Parts of the player, in the order in which they are joined.
const PLAYER: [&str; 17] = [
    include_str!("../shared/math.js"),
    include_str!("../shared/frames.js"),
    include_str!("../shared/shadows.js"),
    include_str!("../shared/passes.js"),
    include_str!("../shared/uniforms.js"),
    include_str!("../shared/ktx2.js"),
    include_str!("math.js"),
    include_str!("camera.js"),
    include_str!("assets.js"),
    include_str!("geometry.js"),
    include_str!("uniforms.js"),
    include_str!("webgpu.js"),
    include_str!("webgl2.js"),
    include_str!("checks.js"),
    include_str!("player.js"),
    include_str!("gestures.js"),
    include_str!("api.js"),
];

/// Parts of the page around the player.
const CONTROLS: [&str; 5] = [
    include_str!("controls.js"),
    include_str!("effects.js"),
    include_str!("link.js"),
    include_str!("panel.js"),
    include_str!("page.js"),
];

/// Names of the package's own scripts, which no look's script may take.
const OWN: [&str; 4] = ["scene", "textures", "player", "page"];

/// Name of the look's script, without its ending.
fn look_name(stem: &str) -> String {
    let is_taken = OWN.iter().any(|own| own.eq_ignore_ascii_case(stem));
    if is_taken { format!("{stem}-look") } else { stem.to_owned() }
}

/// The place that the scripts of an export share, and that no other one on the page has: scripts
/// that are opened from a file cannot export names.
fn place(request: &PackageRequest<'_>) -> String {
    let name = serde_json::Value::from(look_name(request.stem));
    format!("((window.chiaroExports ??= {{}})[{name}] ??= {{}}).")
}

/// The files of the package.
fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let title = request.title;
    let texts = [
        ("index.html", filled(PAGE, request)),
        ("style.css", format!("/* {} */\n\n{STYLE}", made(title, "how the page looks"))),
        ("scene.js", scene::script(request, &made(title, "the mesh, the camera and the backdrop"))),
        ("textures.js", textures(request, &made(title, "the images that the look reads"))),
        ("player.js", joined(&PLAYER, &made(title, "what draws the look on a canvas"))),
        ("page.js", joined(&CONTROLS, &made(title, "the page's tools and settings"))),
        ("README.md", filled(README, request)),
    ];
    let texts = texts.map(|(name, text)| ExportFile::text(name.to_owned(), text));
    let script = request.javascript_file(&format!("{}look = ", place(request)))?;
    let look = ExportFile { name: look_name(request.stem) + ".js", ..script };
    Ok(std::iter::once(look).chain(texts).collect())
}

/// The line that tells a file of an export from others.
fn made(title: &str, what: &str) -> String {
    format!("{title}: made by Chiaro {}. This is {what}.", env!("CARGO_PKG_VERSION"))
}

/// Scripts joined into one that keeps its names to itself. What other packages have as modules
/// loses its imports and exports.
fn joined(parts: &[&str], made: &str) -> String {
    let plain: Vec<String> = parts.iter().map(|part| without_modules(part)).collect();
    format!("// {made}\n(() => {{\n\"use strict\";\n\n{}}})();\n", plain.join("\n"))
}

/// A module's text as a part of a script.
fn without_modules(module: &str) -> String {
    let mut text = String::new();
    let mut is_import = false;
    for line in module.lines() {
        is_import |= line.starts_with("import ");
        if is_import {
            is_import = !line.ends_with(';');
            continue;
        }
        // The line after the imports is blank, as is the one before them.
        if !(line.is_empty() && text.ends_with("\n\n")) {
            text += line.strip_prefix("export ").unwrap_or(line);
            text.push('\n');
        }
    }
    text
}

/// A template with its places filled.
fn filled(template: &str, request: &PackageRequest<'_>) -> String {
    let lights: Vec<String> =
        request.description.lights.iter().map(|light| format!("`{}`", light.id)).collect();
    let lights = if lights.is_empty() { "none here".to_owned() } else { lights.join(", ") };
    template
        .replace("{{title}}", &escaped(request.title))
        .replace("{{stem}}", &look_name(request.stem))
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{lights}}", &lights)
        .replace("{{example}}", &example(request.description))
        .replace("{{table}}\n", &request.tables())
}

/// A call that is seen in the picture.
fn example(description: &Description) -> String {
    if let Some(light) = description.lights.first() {
        return format!(
            "player.light(\"{}\", {{ color: \"#ff9a5c\", intensity: 1.5 }});",
            light.id
        );
    }
    let is_color = |parameter: &&ExposedParameter| parameter.live && parameter.ty == "color";
    let mut colors = description.parameters.iter().filter(is_color);
    match colors.find_map(|parameter| parameter.name.as_ref()) {
        Some(name) => format!("player.set(\"{name}\", \"#ff9a5c\");"),
        None => "player.gestures.turn(0.5, 0, \"view\");".to_owned(),
    }
}

/// A text as HTML and Markdown write it.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The script with the images as base64, by name.
fn textures(request: &PackageRequest<'_>, made: &str) -> String {
    let mut script = format!("// {made}\n{}textures = {{\n", place(request));
    for image in request.textures {
        let name = serde_json::Value::from(image.name.as_str());
        let _infallible = writeln!(script, "  {name}: \"{}\",", STANDARD.encode(&image.bytes));
    }
    script + "};\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_looks_script_takes_the_place_of_an_own_one() {
        for own in OWN {
            assert_ne!(look_name(own), own);
            assert_ne!(look_name(&own.to_uppercase()).to_lowercase(), own);
        }
        assert_eq!(look_name("clay"), "clay");
    }

    #[test]
    fn modules_become_parts_of_a_script() {
        let module = "// Title.\n\nimport {\n  a,\n} from \"./a.js\";\n\nexport const b = a;\n";
        assert_eq!(without_modules(module), "// Title.\n\nconst b = a;\n");
    }

    #[test]
    fn names_are_no_markup() {
        assert_eq!(escaped("<b> & \"c\""), "&lt;b&gt; &amp; &quot;c&quot;");
    }
}
