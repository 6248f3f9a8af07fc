//! Looks that send rays in their exact tier are exported with maps in a cheaper one.

use std::fs;
use std::path::Path;

use crate::support::validators::tint;
use crate::verdicts::verdict;
use chiaro::document::{Look, Tier};
use chiaro::export::{LANGUAGES, export};
use chiaro::frame::Assets;
use chiaro::library::Library;
use serde_json::{Value as Json, json};

/// Looks of `examples/shadows` pass every language's own compiler, and the description says how to
/// draw what they read.
#[test]
fn looks_with_shadow_maps_pass_their_validators() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/shadows");
    let out = tempfile::tempdir().expect("a folder");
    let mut of_tint = Vec::new();
    for (stem, tier) in [("long-shadows", Tier::Balanced), ("comic-street", Tier::Fast)] {
        let path = examples.join(stem).with_extension("json");
        let mut look = Look::load(&chiaro::files::Disk, &path).value.expect("an example");
        look.set_every_tier(tier);
        let assets = (Path::new(""), &mut Assets::default());
        let exported = export(&look, Library::built_in(), stem, &LANGUAGES, assets);
        let files = exported.unwrap_or_else(|problems| panic!("{stem}: {problems:?}")).value;
        let mut judged = 0;
        for file in &files {
            let name = &file.name;
            if name.ends_with(".wgsl") {
                let path = out.path().join(name);
                fs::write(&path, &file.bytes).expect("a file");
                of_tint.push(path);
            }
            let Some(verdict) = verdict(name, &file.bytes) else { continue };
            judged += 1;
            verdict.unwrap_or_else(|refused| panic!("{stem}, {name}: {refused}"));
        }
        assert!(judged > 20, "{stem}: only {judged} files were judged");
        let description = files.iter().find(|file| file.name == format!("{stem}.json"));
        let described: Json =
            serde_json::from_slice(&description.expect("a description").bytes).expect("JSON");
        let passes = described["passes"].as_array().expect("passes");
        let maps = passes.iter().filter(|pass| pass["draws"] == json!("lights"));
        let named: Vec<&Json> = maps.map(|pass| &pass["name"]).collect();
        assert_eq!(named, [&json!("shadow_map"), &json!("shadow_map_behind")], "{stem}");
        let look_reads = &passes.last().expect("the look's")["inputs"];
        let reads = |name: &str| {
            look_reads
                .as_array()
                .is_some_and(|inputs| inputs.iter().any(|i| i["pass"] == json!(name)))
        };
        assert!(reads("shadow_map") && reads("shadow_map_behind"), "{stem}: {look_reads}");
    }
    let paths: Vec<_> = of_tint.iter().collect();
    tint(&paths).unwrap_or_else(|refused| panic!("{refused}"));
}
