//! Parts that Chiaro ships.

use std::path::Path;
use std::sync::{Arc, LazyLock};

use super::Part;
use super::reader::of_look;
use crate::catalog::Catalog;
use crate::document::Look;
use crate::library::Library;

/// Folder that the paths of shipped parts begin with; no file lies there.
pub(super) const PREFIX: &str = "shipped:library";

/// Texts of the parts, by stem.
const TEXTS: [(&str, &str); 9] = [
    ("cel-shadow", include_str!("shipped/cel-shadow.json")),
    ("cool-rim", include_str!("shipped/cool-rim.json")),
    ("hard-highlight", include_str!("shipped/hard-highlight.json")),
    ("three-points", include_str!("shipped/three-points.json")),
    ("moon-and-lamp", include_str!("shipped/moon-and-lamp.json")),
    ("soft-terminator", include_str!("shipped/soft-terminator.json")),
    ("tight-glint", include_str!("shipped/tight-glint.json")),
    ("dusk-ramp", include_str!("shipped/dusk-ramp.json")),
    ("skin-ramp", include_str!("shipped/skin-ramp.json")),
];

/// Part that Chiaro ships: a look, under the stem of a file that is nowhere.
pub(crate) fn shipped_part(stem: &str, look: Look, catalog: &mut Catalog) -> Arc<Part> {
    let path = Path::new(PREFIX).join(format!("{stem}.json"));
    Arc::new(of_look(&path, look, catalog))
}

/// The shipped parts, read once.
pub(crate) fn shipped() -> &'static [Arc<Part>] {
    static PARTS: LazyLock<Vec<Arc<Part>>> = LazyLock::new(|| {
        let mut catalog = Catalog::new(Library::built_in());
        let part = |(stem, text): &(&str, &str)| {
            Some(shipped_part(stem, Look::read(text, stem).value?, &mut catalog))
        };
        TEXTS.iter().filter_map(part).collect()
    });
    &PARTS
}
