//! The package `web`: a folder whose page opens from a file and draws the look, by WebGPU, or by
//! WebGL 2 where there is none.
//!
//! A page from a file can neither import modules nor read files beside it, so everything is in
//! classic scripts: the look (`LOOK.js`, written with every package), the mesh with its camera
//! ([`scene`]), images as base64, the player, and the page. The player and the page are written as
//! several files each, which lie in this folder, and are joined into one script here. They fetch
//! nothing.
//!
//! The player draws as `docs/exports.md` says, by either of two executors with the same methods,
//! `webgpu.js` and `webgl2.js`. In WebGL it draws with y turned over and shows the picture upside
//! down, so that derivatives are those of WebGPU.

mod scene;

use std::collections::BTreeSet;
use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use crate::export::{ExportFile, header};
use crate::frame::Setup;

/// The page's markup, with places for the look's name and for the name of its files.
const PAGE: &str = include_str!("index.html");

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

/// The page's looks.
const STYLE: &str = include_str!("style.css");

/// Parts of the player, in the order in which they are joined.
const PLAYER: [&str; 9] = [
    include_str!("math.js"),
    include_str!("camera.js"),
    include_str!("assets.js"),
    include_str!("uniforms.js"),
    include_str!("webgpu.js"),
    include_str!("webgl2.js"),
    include_str!("player.js"),
    include_str!("gestures.js"),
    include_str!("api.js"),
];

/// Parts of the page around the player.
const CONTROLS: [&str; 2] = [include_str!("controls.js"), include_str!("page.js")];

/// What the page of a look is made of.
#[derive(Debug)]
pub struct Page<'a> {
    /// Name of the look, for people.
    pub title: &'a str,
    /// Beginning of the names of the look's files: the script of the look is `stem.js`.
    pub stem: &'a str,
    /// The object that wears the look, the camera and the backdrop.
    pub setup: &'a Setup,
    /// Names of the vertices' attributes that the look's modules read.
    pub attributes: BTreeSet<&'a str>,
    /// Images that the look reads, under the names that the look's script has for them.
    pub images: &'a [ExportFile],
    /// Names that the artist gave to the exposed parameters.
    pub parameters: Vec<&'a str>,
}

/// The files of a page beside the look's own script.
pub fn files(page: &Page<'_>) -> Vec<ExportFile> {
    let title = header::title(page.title);
    let texts = [
        ("index.html", filled(PAGE, page)),
        ("style.css", format!("/* {} */\n\n{STYLE}", made(&title, "how the page looks"))),
        ("scene.js", scene::script(page, &made(&title, "the mesh, the camera and the backdrop"))),
        ("textures.js", textures(page.images, &made(&title, "the images that the look reads"))),
        ("player.js", joined(&PLAYER, &made(&title, "what draws the look on a canvas"))),
        ("page.js", joined(&CONTROLS, &made(&title, "the page's tools and settings"))),
        ("README.md", filled(README, page)),
    ];
    texts.map(|(name, text)| ExportFile::text(name.to_owned(), text)).into()
}

/// The line that tells a file of an export from others.
fn made(title: &str, what: &str) -> String {
    format!("{title}: made by Chiaro {}. This is {what}.", env!("CARGO_PKG_VERSION"))
}

/// Scripts joined into one that keeps its names to itself.
fn joined(parts: &[&str], made: &str) -> String {
    format!("// {made}\n(() => {{\n\"use strict\";\n\n{}}})();\n", parts.join("\n"))
}

/// A template with its places filled.
fn filled(template: &str, page: &Page<'_>) -> String {
    let names: Vec<_> = page.parameters.iter().map(|name| format!("`{name}`")).collect();
    let (parameters, first) = match page.parameters.first() {
        Some(first) => (format!("The look has these: {}.", names.join(", ")), *first),
        None => ("The look has none: expose some in Chiaro and export again.".to_owned(), "name"),
    };
    template
        .replace("{{title}}", &escaped(&header::title(page.title)))
        .replace("{{stem}}", page.stem)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{parameters}}", &parameters)
        .replace("{{parameter}}", first)
}

/// A text as HTML and Markdown write it.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The script with the images as base64, by name.
fn textures(images: &[ExportFile], made: &str) -> String {
    let mut script = format!("// {made}\nconst textures = {{\n");
    for image in images {
        let name = serde_json::Value::from(image.name.as_str());
        let _infallible = writeln!(script, "  {name}: \"{}\",", STANDARD.encode(&image.bytes));
    }
    script + "};\n"
}
