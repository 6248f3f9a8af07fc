//! The looks that the window brings along.

/// Looks of `examples/looks`: the file's name and its text, in the order in which they are best looked at.
pub(crate) static EXAMPLES: [(&str, &str); 16] = [
    ("figure1-layers", include_str!("../../../../examples/looks/figure1-layers.json")),
    ("figure2-diffuse", include_str!("../../../../examples/looks/figure2-diffuse.json")),
    ("figure2-specular", include_str!("../../../../examples/looks/figure2-specular.json")),
    ("figure2-screen-aligned", include_str!("../../../../examples/looks/figure2-screen-aligned.json")),
    ("figure4-color", include_str!("../../../../examples/looks/figure4-color.json")),
    ("figure4-extent", include_str!("../../../../examples/looks/figure4-extent.json")),
    ("figure4-both", include_str!("../../../../examples/looks/figure4-both.json")),
    ("figure5-directional", include_str!("../../../../examples/looks/figure5-directional.json")),
    ("figure6-comics", include_str!("../../../../examples/looks/figure6-comics.json")),
    ("figure6-minimal", include_str!("../../../../examples/looks/figure6-minimal.json")),
    ("figure7-pastel", include_str!("../../../../examples/looks/figure7-pastel.json")),
    ("highlight-shapes", include_str!("../../../../examples/looks/highlight-shapes.json")),
    ("shape-exaggerated", include_str!("../../../../examples/looks/shape-exaggerated.json")),
    ("clay-relief", include_str!("../../../../examples/looks/clay-relief.json")),
    ("warped-light", include_str!("../../../../examples/looks/warped-light.json")),
    ("contours", include_str!("../../../../examples/looks/contours.json")),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_is_there_and_can_be_read() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
        let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let mut found: Vec<String> =
            files.map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect();
        let mut known: Vec<&str> = EXAMPLES.iter().map(|(name, _)| *name).collect();
        found.sort();
        known.sort_unstable();
        assert_eq!(found, known);
        for (name, text) in EXAMPLES {
            assert!(!crate::document::Look::read(text, name).has_errors(), "{name}");
        }
    }
}
