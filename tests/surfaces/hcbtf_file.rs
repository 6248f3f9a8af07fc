//! `.hcbtf` files: written files are read back, and wrong files are refused with diagnostics.

use std::io::{Cursor, Read as _, Write as _};
use std::sync::Arc;

use crate::support::cases::hold;
use crate::support::random::Random;
use chiaro::diag::{Diagnostic, WithWarnings};
use chiaro::document::{
    Address, Bundle, Directions, Grid, Hcbtf, HcbtfAngle, Placement, Relief, Rule, StrokeTones,
    Strokes, Tile,
};
use chiaro::hcbtf::{BytePicture, fill::fill, read, sheet, write};
use chiaro::progress::Progress;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

const GRID: Grid = Grid {
    size: [5, 3],
    light: Directions { theta: 3, phi: 4 },
    view: Directions { theta: 2, phi: 6 },
};

fn noise(random: &mut Random, size: [u32; 2]) -> Arc<Tile> {
    let bytes = (0..4 * size[0] * size[1]).map(|_| random.bits() as u8).collect();
    Arc::new(Tile::new(size, bytes).unwrap())
}

/// An HCBTF with a rule of every kind.
fn sample() -> Hcbtf {
    let mut random = Random::new(7);
    let mut hcbtf = Hcbtf::new(GRID);
    hcbtf.is_tiling = false;
    for address in [Address::default(), Address::new([2, 3], [1, 5]), Address::new([1, 0], [0, 0])]
    {
        hcbtf.painted.insert(address, noise(&mut random, GRID.size));
    }
    let from = Address::new([2, 3], [1, 5]);
    hcbtf.rules = vec![
        Rule::Mirror { color: [1, 2, 3, 4], width: 0.1 + 0.2 },
        Rule::Specular { from, width: 0.5 },
        Rule::Lock { angles: vec![HcbtfAngle::LightPhi, HcbtfAngle::ViewTheta] },
        Rule::Blend { sharpness: 1.5 },
        Rule::Morph { sharpness: 2.5 },
        Rule::Copy { from },
        Rule::Color { color: [9; 4] },
        Rule::Lambert { shadow: [1, 0, 2], amount: 1.0 / 3.0 },
        Rule::Rotate { turns: -1.0 },
        Rule::Recolor { angle: HcbtfAngle::ViewPhi, from: [255; 3], to: [0, 128, 255] },
        Rule::Relief(Box::new(Relief { depth: 0.1 + 0.2, ..Relief::default() })),
    ];
    hcbtf.rules.extend(Strokes::PRESETS.map(|name| Rule::Strokes(Box::new(Strokes::preset(name)))));
    let paths = Placement::Paths(vec![vec![[0.1, 0.2, 0.3], [-1.0 / 3.0, 0.5, 0.0]], Vec::new()]);
    let tones = Some(StrokeTones { first: 0.1, all: 0.9, growth: 1.0 / 3.0 });
    let drawn = Bundle { place: paths, tones, curl: -0.1, ..Bundle::default() };
    hcbtf
        .rules
        .push(Rule::Strokes(Box::new(Strokes { bundles: vec![drawn], ..Strokes::default() })));
    hcbtf
}

/// The entries of a zip file, in order.
fn entries(bytes: &[u8]) -> Vec<(String, Vec<u8>)> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    (0..archive.len())
        .map(|index| {
            let mut entry = archive.by_index(index).unwrap();
            let mut content = Vec::new();
            entry.read_to_end(&mut content).unwrap();
            (entry.name().unwrap().into_owned(), content)
        })
        .collect()
}

fn pack(entries: &[(String, Vec<u8>)], method: CompressionMethod) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in entries {
        writer
            .start_file(name.as_str(), SimpleFileOptions::default().compression_method(method))
            .unwrap();
        writer.write_all(content).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// A valid file with some entries changed.
fn with(change: impl FnOnce(&mut Vec<(String, Vec<u8>)>)) -> Vec<u8> {
    let mut all = entries(&write(&sample()).unwrap());
    change(&mut all);
    pack(&all, CompressionMethod::Deflated)
}

/// A valid file with its manifest changed as text.
fn with_manifest(from: &str, to: &str) -> Vec<u8> {
    with(|all| {
        let text = String::from_utf8(all[0].1.clone()).unwrap();
        assert!(text.contains(from), "`{from}` is in {text}");
        all[0].1 = text.replacen(from, to, 1).into_bytes();
    })
}

fn png(size: [u32; 2], byte: u8) -> Vec<u8> {
    let rgba = vec![byte; 4 * size[0] as usize * size[1] as usize];
    BytePicture { size, rgba }.to_png().unwrap()
}

/// Diagnostics of a file that must be refused.
fn errors(bytes: &[u8]) -> Vec<Diagnostic> {
    read(bytes, "grass.hcbtf").expect_err("it cannot be used")
}

/// Asserts that a file gives an error of this code, with the file's name and these words.
fn expect(bytes: &[u8], code: &str, words: &[&str]) {
    let told = errors(bytes);
    let error = told
        .iter()
        .find(|problem| problem.code == code)
        .unwrap_or_else(|| panic!("{code}: {told:?}"));
    let text = error.to_string();
    assert!(text.starts_with("grass.hcbtf: error["), "{text}");
    words.iter().for_each(|word| assert!(text.contains(word), "`{word}` is in {text}"));
}

#[test]
fn what_is_written_is_read() {
    for hcbtf in [
        sample(),
        Hcbtf::new(Grid::THESIS),
        Hcbtf { rules: Vec::new(), is_tiling: true, ..sample() },
    ] {
        let bytes = write(&hcbtf).unwrap();
        let (back, notes) = read(&bytes, "grass.hcbtf").unwrap().into_parts();
        assert_eq!(back, hcbtf);
        assert!(notes.is_empty(), "{notes:?}");
        assert_eq!(write(&back).unwrap(), bytes, "equal for equal");
    }
}

#[test]
fn a_file_is_a_zip_that_other_programs_open() {
    let all = entries(&write(&sample()).unwrap());
    let names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
    let samples = ["samples/l0.0_v0.0.png", "samples/l1.0_v0.0.png", "samples/l2.3_v1.5.png"];
    assert_eq!(names, [&["manifest.json", "thumbnail.png"][..], &samples[..]].concat());
    let text = std::str::from_utf8(&all[0].1).unwrap();
    assert!(
        text.starts_with("{\n  \"chiaro\": \"hcbtf\",\n  \"version\": 1,\n  \"grid\": "),
        "{text}"
    );
    assert!(text.contains(
        "    { \"light\": [2, 3], \"view\": [1, 5], \"file\": \"samples/l2.3_v1.5.png\" }\n  ]\n}\n"
    ));
    let image = image::load_from_memory(&all[4].1).unwrap();
    assert_eq!(image.color(), image::ColorType::Rgba8);
    assert_eq!(
        image.into_rgba8().into_raw(),
        sample().painted[&Address::new([2, 3], [1, 5])].bytes()
    );
}

#[test]
fn the_example_in_the_docs_is_read_and_every_rule_is_in_them() {
    let docs = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/format.md");
    let text = std::fs::read_to_string(docs).unwrap();
    let example =
        text.split("```jsonc\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let image = png([32, 32], 200);
    let entry = |name: &str, content: &[u8]| (name.to_owned(), content.to_vec());
    let all = [
        entry("manifest.json", example.as_bytes()),
        entry("samples/l0.0_v0.0.png", &image),
        entry("samples/l5.3_v2.9.png", &image),
    ];
    let (hcbtf, notes) = read(&pack(&all, CompressionMethod::Stored), "g").unwrap().into_parts();
    assert!(notes.is_empty() && hcbtf.rules.len() == 3 && hcbtf.grid == Grid::THESIS, "{notes:?}");
    // The HCBTF is written as the same text again.
    let written = entries(&write(&hcbtf).unwrap()).swap_remove(0).1;
    let plain = |text: &str| text.split_whitespace().collect::<String>();
    assert_eq!(plain(std::str::from_utf8(&written).unwrap()), plain(example));
    for word in Rule::WORDS {
        assert!(text.contains(&format!("\n| `{word}` | ")), "{word}");
    }
    let strokes = text
        .split("```jsonc\n")
        .find(|block| block.starts_with("{ \"rule\": \"strokes\""))
        .unwrap();
    let strokes: Rule = serde_json::from_str(strokes.split("```").next().unwrap()).unwrap();
    strokes.check(&GRID).unwrap();
    assert!(sample().rules.iter().map(Rule::word).all(|word| Rule::WORDS.contains(&word)));
}

#[test]
fn any_zip_and_any_png_that_comes_back_is_taken() {
    let all = entries(&write(&sample()).unwrap());
    for method in [CompressionMethod::Stored, CompressionMethod::Deflated] {
        // Entries in another order, folders as entries, no thumbnail.
        let mut shuffled: Vec<_> =
            all.iter().rev().filter(|(name, _)| name != "thumbnail.png").cloned().collect();
        shuffled.insert(0, ("samples/".to_owned(), Vec::new()));
        assert_eq!(read(&pack(&shuffled, method), "g").unwrap(), sample().into());
    }
    let rgb = image::RgbImage::from_pixel(5, 3, image::Rgb([1, 2, 3]));
    let gray = image::ImageBuffer::<image::Luma<u16>, _>::from_pixel(5, 3, image::Luma([257 * 40]));
    let as_png = |image: image::DynamicImage| {
        let mut bytes = Cursor::new(Vec::new());
        image.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
        bytes.into_inner()
    };
    let bytes = with(|all| {
        all[2].1 = as_png(rgb.into());
        all[3].1 = as_png(gray.into());
    });
    let (hcbtf, notes) = read(&bytes, "g").unwrap().into_parts();
    assert_eq!(hcbtf.painted[&Address::default()].texel(0, 0), [1, 2, 3, 255]);
    assert_eq!(hcbtf.painted[&Address::new([1, 0], [0, 0])].texel(0, 0), [40, 40, 40, 255]);
    assert!(notes.len() == 1 && notes[0].code == "hcbtf-16-bit", "{notes:?}");
}

#[test]
fn what_is_painted_is_what_is_looked_up() {
    let hcbtf = sample();
    let back = read(&write(&hcbtf).unwrap(), "g").unwrap().value;
    let filled = fill(&back, &Progress::new()).unwrap();
    for (address, tile) in &hcbtf.painted {
        assert_eq!(filled.tile(*address), Some(tile));
    }
    let baked = sheet::export(&filled).unwrap();
    let again = sheet::import(&baked, GRID, "s").unwrap().value;
    for (address, tile, _) in filled.iter() {
        let is_empty = tile.bytes().iter().all(|byte| *byte == 0);
        assert_eq!(again.painted(address), (!is_empty).then_some(tile), "{address}");
    }
}

#[test]
fn odd_things_are_warned_of() {
    let warned = |bytes: &[u8]| {
        let (hcbtf, notes) = read(bytes, "g").unwrap().into_parts();
        assert_eq!(hcbtf.painted, sample().painted);
        notes.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    let told = warned(&with_manifest("\"tiling\": false", "\"tilling\": 1, \"tiling\": false"));
    assert!(told.contains("unknown-field") && told.contains("did you mean `tiling`"), "{told}");
    let told = warned(&with_manifest(
        "\"file\": \"samples/l0.0",
        "\"by\": \"me\", \"file\": \"samples/l0.0",
    ));
    assert!(told.contains("painted[0].by"), "{told}");
    let told = warned(&with_manifest("\"phi\": 4 }", "\"phi\": 4, \"rho\": 1 }"));
    assert!(told.contains("grid.light.rho"), "{told}");
    let told = warned(&with(|all| all.push(("samples/new.png".to_owned(), png([5, 3], 9)))));
    assert!(
        told.contains("hcbtf-stray") && told.contains("`samples/new.png` is not listed"),
        "{told}"
    );
    let told = warned(&with_manifest(
        "\"rules\": [",
        "\"rules\": [{\"rule\":\"copy\",\"from\":{\"light\":[1,1],\"view\":[0,0]}},",
    ));
    assert!(told.contains("hcbtf-idle-rule") && told.contains("rules[0]"), "{told}");
}

#[test]
fn what_is_no_hcbtf_is_told() {
    expect(b"", "empty-file", &["empty"]);
    expect(b"{\"chiaro\": \"look\"}", "hcbtf-archive", &["no painted surface (HCBTF)"]);
    expect(b"PK\x03\x04 and nothing else", "hcbtf-archive", &["help:"]);
    expect(
        &with(|all| all.retain(|(name, _)| name != "manifest.json")),
        "hcbtf-manifest",
        &["manifest.json"],
    );
    expect(
        &with(|all| all[0].0 = "grass/manifest.json".to_owned()),
        "hcbtf-manifest",
        &["not in a folder"],
    );
    let valid = write(&sample()).unwrap();
    expect(&valid[..valid.len() / 2], "hcbtf-archive", &["cut off"]);
    expect(&with(|all| all[0].1 = b"[1]".to_vec()), "wrong-document", &["object"]);
    expect(&with(|all| all[0].1 = b"[".repeat(100_000)), "too-deep", &[]);
}

/// Diagnostics of manifests: `tests/cases/hcbtf`, each in a file with its three samples.
#[test]
fn manifests() {
    hold("hcbtf", |name, manifest| {
        let bytes = with(|all| all[0].1 = manifest.to_vec());
        let file = format!("{name}.hcbtf");
        match read(&bytes, &file) {
            Ok(read) => (true, read.warnings),
            Err(problems) => {
                let is_told = |d: &Diagnostic| d.to_string().starts_with(&format!("{file}: "));
                assert!(problems.iter().any(Diagnostic::is_error), "{name}: {problems:?}");
                assert!(problems.iter().all(is_told), "{name}: {problems:?}");
                (false, problems)
            }
        }
    });
}

#[test]
fn rules_are_counted() {
    let many: Vec<String> =
        (0..1001).map(|_| "{\"rule\":\"blend\",\"sharpness\":1}".to_owned()).collect();
    expect(
        &with_manifest("\"rules\": [", &format!("\"rules\": [{},", many.join(","))),
        "too-many",
        &["1000"],
    );
}

#[test]
fn wrong_samples_are_told_by_their_name() {
    let last = "samples/l2.3_v1.5.png";
    expect(
        &with(|all| all.retain(|(name, _)| name != last)),
        "hcbtf-entry",
        &[last, "no such entry", "painted"],
    );
    expect(&with(|all| all[4].1 = png([6, 3], 1)), "hcbtf-sample", &[last, "6 x 3", "5 x 3"]);
    expect(&with(|all| all[4].1 = b"GIF89a".to_vec()), "hcbtf-sample", &[last, "no PNG"]);
    expect(&with(|all| all[4].1.truncate(60)), "hcbtf-sample", &[last, "decoded"]);
    let huge = with(|all| all[4].1[16..24].copy_from_slice(&[0x7f; 8]));
    expect(&huge, "hcbtf-sample", &[last, "2139062143 x 2139062143"]);
    // All problems are told, not only the first.
    let two = with(|all| {
        all[3].1 = png([1, 1], 1);
        all[4].1 = png([2, 2], 1);
    });
    assert_eq!(errors(&two).len(), 2);
}

#[test]
fn damage_is_noticed() {
    let mut bytes = write(&sample()).unwrap();
    let (_, png) = entries(&bytes).swap_remove(3);
    let at = bytes.windows(png.len()).position(|window| window == png).unwrap();
    bytes[at + png.len() - 20] ^= 1;
    expect(&bytes, "hcbtf-entry", &["samples/l1.0_v0.0.png"]);
}

#[test]
fn what_unpacks_to_too_much_is_refused_as_it_unpacks() {
    // Zeros pack a thousandfold. The bound of a sample is the size of the largest PNG of the tile's
    // size with its notes.
    let bomb = vec![0_u8; 80 << 20];
    let bytes = with(|all| all[4].1 = bomb.clone());
    expect(&bytes, "too-large", &["samples/l2.3_v1.5.png", "help:"]);
    expect(&with(|all| all[0].1 = bomb.clone()), "too-large", &["manifest.json"]);
    // The same entry, which now claims to be small.
    let mut lying = bytes;
    let size = (80_u32 << 20).to_le_bytes();
    let places: Vec<usize> = lying
        .windows(4)
        .enumerate()
        .filter(|(_, window)| *window == size)
        .map(|(at, _)| at)
        .collect();
    assert!(!places.is_empty());
    places.iter().for_each(|at| lying[*at..at + 4].copy_from_slice(&100_u32.to_le_bytes()));
    assert!(!errors(&lying).is_empty());
    // A file with more samples than the bound on memory allows, refused before any sample is
    // unpacked.
    let listed: Vec<String> = (0..3)
        .flat_map(|t| (0..4).map(move |p| (t, p)))
        .filter(|(t, p)| *t > 0 || *p == 0)
        .flat_map(|(t, p)| {
            (1..6).map(move |v| {
                format!("{{\"light\":[{t},{p}],\"view\":[1,{v}],\"file\":\"x.png\"}}")
            })
        })
        .collect();
    let wide = with(|all| {
        let text = String::from_utf8(all[0].1.clone()).unwrap().replace("[5, 3]", "[4095, 4095]");
        let start = text.find("\"painted\"").unwrap();
        all[0].1 = format!("{}\"painted\": [{}]}}", &text[..start], listed.join(",")).into_bytes();
    });
    expect(&wide, "too-large", &["MiB", "coarser grid"]);
}

#[test]
fn directories_that_lie_are_refused() {
    let valid = write(&sample()).unwrap();
    let mut huge = vec![0_u8; 200_000];
    huge[..valid.len().min(4)].copy_from_slice(b"PK\x03\x04");
    // The zip64 end of a directory, with 150,000 entries that are not there; then its locator; then
    // the plain end.
    let at = huge.len() as u64;
    huge.extend(b"PK\x06\x06");
    huge.extend(44_u64.to_le_bytes());
    huge.extend([45, 0, 45, 0]);
    huge.extend([0; 8]);
    huge.extend(
        [150_000_u64, 150_000, u64::MAX >> 1, 180_000].into_iter().flat_map(u64::to_le_bytes),
    );
    huge.extend(b"PK\x06\x07\0\0\0\0");
    huge.extend(at.to_le_bytes());
    huge.extend(1_u32.to_le_bytes());
    huge.extend(b"PK\x05\x06\0\0\0\0\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\0\0");
    expect(&huge, "too-many", &["65535 entries"]);
    let mut ends = valid.clone();
    (0..100).for_each(|_| ends.extend(b"PK\x05\x06\0\0\0\0\x01\0\x01\0\xff\xff\0\0\0\0\0\0\0\0"));
    expect(&ends, "too-many", &["one directory"]);
}

#[test]
fn what_could_not_be_read_again_is_not_written() {
    let mut hcbtf = sample();
    hcbtf.painted.insert(Address::new([1, 1], [0, 0]), Arc::new(Tile::filled([9, 9], [1; 4])));
    assert_eq!(write(&hcbtf).unwrap_err().code, "hcbtf-sample");
    let mut hcbtf = sample();
    hcbtf.painted.insert(Address::new([9, 1], [0, 0]), Arc::new(Tile::filled(GRID.size, [1; 4])));
    assert_eq!(write(&hcbtf).unwrap_err().code, "out-of-range");
    let mut hcbtf = sample();
    hcbtf.rules.push(Rule::Blend { sharpness: f64::NAN });
    assert_eq!(write(&hcbtf).unwrap_err().code, "hcbtf-rule");
    assert_eq!(write(&Hcbtf::new(Grid { size: [0, 1], ..GRID })).unwrap_err().code, "hcbtf-grid");
}

/// Files from a hostile author never cause a panic, and an HCBTF read from one can be filled.
#[test]
fn mutated_files_never_panic() {
    let valid = write(&sample()).unwrap();
    let unpacked = pack(&entries(&valid), CompressionMethod::Stored);
    let mut random = Random::new(2026);
    let mut read_well = 0;
    for turn in 0..6000 {
        let mut bytes = if turn % 2 == 0 { valid.clone() } else { unpacked.clone() };
        match random.index(5) {
            0 => bytes.truncate(random.index(bytes.len())),
            1 => {
                let (at, count) = (random.index(bytes.len()), random.index(40));
                bytes.drain(at..(at + count).min(bytes.len()));
            }
            2 => {
                let (from, to) = (random.index(bytes.len()), random.index(bytes.len()));
                let piece: Vec<u8> = bytes[from..].iter().take(random.index(60)).copied().collect();
                bytes.splice(to..to, piece);
            }
            _ => {}
        }
        for _ in 0..random.index(8) {
            // Ends of directories lie at the file's end, and their lengths and offsets do the most
            // harm.
            let near_the_end = random.chance(0.5);
            let span = if near_the_end { bytes.len().min(500) } else { bytes.len() };
            if span > 0 {
                let at = bytes.len() - span + random.index(span);
                bytes[at] = if random.chance(0.3) { 0xff } else { random.bits() as u8 };
            }
        }
        if let Ok(WithWarnings { value: hcbtf, .. }) = read(&bytes, "fuzzed.hcbtf") {
            read_well += 1;
            assert!(hcbtf.painted.values().all(|tile| tile.size() == hcbtf.grid.size));
            if hcbtf.grid.texels() as u64 * hcbtf.grid.sample_count() < 1 << 16 {
                fill(&hcbtf, &Progress::new()).unwrap();
            }
        }
    }
    assert!(read_well > 20, "{read_well}: some mutations miss everything that matters");
}

/// Mutated manifests never cause a panic; in mutated files the zip's checksums would protect the
/// manifest's text.
#[test]
fn mutated_manifests_never_panic() {
    let all = entries(&write(&sample()).unwrap());
    let mut random = Random::new(5);
    let words = [
        "0",
        "-1",
        "1e308",
        "4095",
        "255",
        "null",
        "[]",
        "{}",
        "\"\"",
        "true",
        ",",
        "]",
        "}",
        "\\",
        "99999999999",
    ];
    for _ in 0..4000 {
        let mut changed = all.clone();
        let text = &mut changed[0].1;
        for _ in 0..1 + random.index(4) {
            let at = random.index(text.len());
            let end = (at + random.index(6)).min(text.len());
            text.splice(at..end, random.pick(&words).bytes());
        }
        if let Ok(WithWarnings { value: hcbtf, .. }) =
            read(&pack(&changed, CompressionMethod::Stored), "fuzzed.hcbtf")
        {
            assert!(hcbtf.grid.check().is_ok() && write(&hcbtf).is_ok());
        }
    }
}
