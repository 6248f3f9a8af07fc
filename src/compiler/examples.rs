//! The examples that every Chiaro brings along: looks, scenes and HCBTFs, as files that are named
//! wherever they lie.
//!
//! `example:hcbtf/arch.json` is `examples/hcbtf/arch.json` of the source. Such a name may stand
//! wherever a path may, behind any folder, so that what names one can be saved anywhere; the meshes
//! of examples are the program's own shapes.

use std::path::{Component, Path};

/// What the names of examples begin with.
pub const PREFIX: &str = "example:";

macro_rules! files {
    ($($name:literal,)*) => { [$(($name, include_bytes!(concat!("examples/", $name)) as &[u8])),*] };
}

/// Their names and what is in them, in the order in which they are best looked at.
static FILES: &[(&str, &[u8])] = &files![
    "looks/figure1-layers.json",
    "looks/figure2-code.json",
    "looks/figure2-diffuse.json",
    "looks/figure2-specular.json",
    "looks/figure2-screen-aligned.json",
    "looks/figure3-profile.json",
    "looks/figure3-curves.json",
    "looks/figure3-isocurves.json",
    "looks/figure4-color.json",
    "looks/figure4-extent.json",
    "looks/figure4-both.json",
    "looks/figure5-unkeyed.json",
    "looks/figure5-directional.json",
    "looks/figure6-comics.json",
    "looks/figure6-minimal.json",
    "looks/figure6-dual-hard.json",
    "looks/figure6-dual-soft.json",
    "looks/figure6-glossy-jade.json",
    "looks/figure6-glossy-lacquer.json",
    "looks/figure6-manga-contours.json",
    "looks/figure6-manga-embossed.json",
    "looks/figure7-pastel.json",
    "looks/figure7-beetle.json",
    "looks/figure7-bone.json",
    "looks/figure7-lemon.json",
    "looks/figure7-orange.json",
    "looks/figure7-organ.json",
    "looks/figure7-vessel.json",
    "looks/clay-relief.json",
    "looks/contours.json",
    "looks/halftone-comic.json",
    "looks/hatching.json",
    "looks/highlight-shapes.json",
    "looks/paper-wash.json",
    "looks/shape-exaggerated.json",
    "looks/stipple.json",
    "looks/warped-light.json",
    "looks/anime-face.json",
    "looks/neon-noir.json",
    "looks/stained-glass.json",
    "looks/clay.json",
    "looks/technical-cutaway.json",
    "looks/screen-print.json",
    "looks/watercolor-wash.json",
    "looks/chalk-board.json",
    "looks/woodcut.json",
    "looks/botanical-plate.json",
    "looks/oil-portrait.json",
    "looks/highlight-moves.json",
    "looks/highlight-cut.json",
    "looks/silk-ring.json",
    "looks/bent-light.json",
    "looks/local-control.json",
    "looks/travel-poster.json",
    "looks/one-bit.json",
    "looks/film-print.json",
    "looks/glaze.json",
    "looks/mean-curvature.json",
    "looks/material-phong.json",
    "looks/material-blinn.json",
    "looks/material-ggx.json",
    "looks/material-ward.json",
    "looks/material-oren-nayar.json",
    "looks/material-wrap.json",
    "looks/material-film.json",
    "looks/material-drawn.json",
    "looks/painted-before.json",
    "looks/painted-light.json",
    "looks/near-lantern.json",
    "looks/lantern.json",
    "looks/far-and-turned.json",
    "looks/mood.json",
    "hcbtf/grass.json",
    "hcbtf/grass-flat.json",
    "hcbtf/brick.json",
    "hcbtf/arch.json",
    "hcbtf/asphalt.json",
    "hcbtf/asphalt-scattered.json",
    "hcbtf/city.json",
    "hcbtf/city-dusk.json",
    "hcbtf/pencil.json",
    "hcbtf/pencil-far.json",
    "hcbtf/halftone.json",
    "hcbtf/stripes.json",
    "hcbtf/chalk.json",
    "hcbtf/copper.json",
    "images/xtoon-distance.json",
    "images/xtoon-focus.json",
    "images/xtoon-orientation.json",
    "images/xtoon-highlight.json",
    "images/sculpting-pair.json",
    "images/gouache.json",
    "images/painted-strokes.json",
    "scenes/painted.json",
    "scenes/city.json",
    "scenes/cast.json",
    "scenes/figure2-parametrizations.json",
    "scenes/figure3-profiles.json",
    "scenes/figure4-curvature.json",
    "scenes/figure5-from-behind.json",
    "scenes/figure6-illustrations.json",
    "scenes/figure7-pastel-behind.json",
    "scenes/figure7-beetle-turned.json",
    "scenes/figure7-fruit.json",
    "scenes/figure7-symbolic.json",
    "scenes/figure28-arch.json",
    "scenes/figure29-flat-grass.json",
    "scenes/figure30-grass.json",
    "scenes/figure31-asphalt.json",
    "scenes/figure32-pencil.json",
    "scenes/figure33-sunset.json",
    "scenes/figure34-stripes.json",
    "scenes/figure35-studio.json",
    "scenes/figure36-brick.json",
    "scenes/pencil-far.json",
    "scenes/asphalt-scattered.json",
    "scenes/technical-cutaway.json",
    "scenes/highlight-moves.json",
    "scenes/xtoon-distance.json",
    "scenes/xtoon-focus.json",
    "scenes/materials.json",
    "scenes/keys-near.json",
    "scenes/keys-far-turned.json",
    "scenes/keys-mood.json",
    "hcbtf/grass.hcbtf",
    "hcbtf/grass-flat.hcbtf",
    "hcbtf/brick.hcbtf",
    "hcbtf/arch.hcbtf",
    "hcbtf/asphalt.hcbtf",
    "hcbtf/city.hcbtf",
    "hcbtf/pencil.hcbtf",
    "hcbtf/halftone.hcbtf",
    "hcbtf/stripes.hcbtf",
    "hcbtf/chalk.hcbtf",
    "hcbtf/copper.hcbtf",
    "images/ball-hollow.png",
    "images/ball-ridge.png",
    "images/painted-strokes.png",
    "images/stroke.png",
    "images/tone-air.png",
    "images/tone-gloss.png",
    "images/tone-ink.png",
];

/// What the gallery shows of them: `examples/gallery.json`.
pub const GALLERY: &str = include_str!("examples/gallery.json");

/// The names of all looks and scenes among them, without [`PREFIX`].
pub fn documents() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|(name, _)| *name).filter(|name| name.ends_with(".json"))
}

/// The names of all example files, without [`PREFIX`].
pub fn names() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|(name, _)| *name)
}

/// What is in the example that a path means, if it means one.
pub fn file(path: &Path) -> Option<&'static [u8]> {
    let name = name(path)?;
    FILES.iter().find(|(known, _)| *known == name).map(|(_, bytes)| *bytes)
}

/// The text of the look or scene that a path means, if it means one. What it names has names that
/// hold in any folder.
pub fn text(path: &Path) -> Option<String> {
    let text = std::str::from_utf8(file(path)?).ok()?;
    let mut text = text.to_owned();
    for folder in ["looks", "hcbtf", "images"] {
        text = text.replace(&format!("\"../{folder}/"), &format!("\"{PREFIX}{folder}/"));
    }
    // What looks name beside themselves.
    for (beside, _) in FILES.iter().filter(|(name, _)| !name.ends_with(".json")) {
        let name = beside.rsplit('/').next().unwrap_or(beside);
        text = text.replace(&format!("\"{name}\""), &format!("\"{PREFIX}{beside}\""));
    }
    Some(text)
}

/// The name of an example in a path, without [`PREFIX`].
fn name(path: &Path) -> Option<String> {
    let mut parts: Option<Vec<&str>> = None;
    for component in path.components() {
        match (component, &mut parts) {
            (Component::Normal(part), parts) => {
                match (part.to_str()?.strip_prefix(PREFIX), parts) {
                    (Some(first), parts) => *parts = Some(vec![first]),
                    (None, Some(parts)) => parts.push(part.to_str()?),
                    (None, None) => {}
                }
            }
            (Component::ParentDir, Some(parts)) => drop(parts.pop()),
            _ => {}
        }
    }
    parts.map(|parts| parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_examples_name_is_an_example_in_any_folder() {
        let city = Path::new("/a/example:scenes/../hcbtf/city.json");
        let text = text(city).unwrap();
        assert!(text.contains("\"example:hcbtf/city.hcbtf\"") && !text.contains("\"city.hcbtf\""));
        assert!(
            file(Path::new("examples/hcbtf/city.json")).is_none()
                && file(Path::new("example:city")).is_none()
        );
        for name in documents() {
            let text = super::text(Path::new(&format!("{PREFIX}{name}"))).unwrap();
            assert!(!text.contains("\"../"), "{name}");
        }
    }
}
