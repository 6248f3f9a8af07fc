//! HCBTFs of `examples/hcbtf`, and the looks beside them: the files are small, the looks find them,
//! the memory is bounded, and every sample can be filled.

use std::path::{Path, PathBuf};

use chiaro::compile::{CompileOptions, compile};
use chiaro::document::{Address, Look, Tier, Value};
use chiaro::files::Disk;
use chiaro::hcbtf::fill::sample;
use chiaro::hcbtf::{estimate, layers_bytes, load};
use chiaro::library::Library;
use chiaro::progress::Progress;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/hcbtf")
}

fn files(ending: &str) -> Vec<PathBuf> {
    let all = std::fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> =
        all.filter(|path| path.extension().is_some_and(|found| found == ending)).collect();
    files.sort();
    assert!(files.len() >= 4, "the examples are gone: {files:?}");
    files
}

#[test]
fn the_files_are_small_and_nothing_is_odd_in_them() {
    for path in files("hcbtf") {
        assert!(std::fs::metadata(&path).unwrap().len() < 65_536, "{}", path.display());
        let (hcbtf, notes) = load(&Disk, &path).unwrap().into_parts();
        assert!(notes.is_empty(), "{}: {notes:?}", path.display());
        let needed = layers_bytes(&hcbtf.grid, true);
        assert!(needed < 64 << 20, "{}: {} MiB", path.display(), needed >> 20);
        assert_eq!(estimate(&hcbtf).unwrap().samples, hcbtf.grid.sample_count());
        // Samples seen straight from above in full light, and from low under a low light: both are
        // filled, and they differ.
        let grid = hcbtf.grid;
        let low = Address::new(
            [grid.light.theta - 1, grid.light.phi / 2],
            [grid.view.theta - 1, grid.view.phi / 3],
        );
        let [above, low] = [Address::default(), low]
            .map(|at| sample(&hcbtf, at, &Progress::new()).unwrap().unwrap());
        assert_ne!(above, low, "{}", path.display());
    }
}

#[test]
fn the_looks_beside_them_show_them() {
    for path in files("json") {
        let loaded = Look::load(&chiaro::files::Disk, &path);
        assert!(loaded.diagnostics.is_empty(), "{}: {:?}", path.display(), loaded.diagnostics);
        let mut look = loaded.value.unwrap();
        let sheets = look.graph.nodes.values().flat_map(|node| &node.values);
        let sheets =
            sheets.filter(|(port, _)| port.as_str() == "sheet").map(|(_, value)| match value {
                Value::Text(name) => folder().join(name),
                other => panic!("{other:?}"),
            });
        let sheets: Vec<PathBuf> = sheets.collect();
        assert!(
            !sheets.is_empty() && sheets.iter().all(|sheet| sheet.is_file()),
            "{}: {sheets:?}",
            path.display()
        );
        for tier in [Tier::Exact, Tier::Balanced, Tier::Fast] {
            look.tier = Some(tier);
            let compiled = compile(&look, Library::built_in(), &CompileOptions::default());
            assert!(compiled.is_ok(), "{}: {:?}", path.display(), compiled.err());
        }
    }
}

/// Chalk follows the tone: from ring to ring, as the light sinks, fewer texels are chalk.
#[test]
fn chalk_is_darker_by_other_strokes_and_not_by_dimmer_ones() {
    let hcbtf = load(&Disk, &folder().join("chalk.hcbtf")).unwrap().value;
    let shown = |ring: u32| {
        sample(&hcbtf, Address::new([ring, 0], [0, 0]), &Progress::new()).unwrap().unwrap()
    };
    let tiles = [0, 4, 7, 10].map(shown);
    let bright = |least: u8| {
        let count = |tile: &std::sync::Arc<chiaro::document::Tile>| {
            tile.bytes()
                .chunks(4)
                .filter(|texel| texel[..3].iter().all(|channel| *channel > least))
                .count()
        };
        tiles.each_ref().map(count)
    };
    let [above, high, low, grazing] = bright(150);
    assert!(above > high && high > low && low > grazing, "{above} {high} {low} {grazing}");
    // The remaining strokes are not dimmed: halfway down they are nearly as bright as under the
    // light.
    let [above, high, ..] = bright(180);
    assert!(above > 0 && high > 0, "{above} {high}");
}
