//! The gallery: every example has a page whose links lead somewhere, and the nodes' pictures are up
//! to date.
#![cfg(feature = "gpu")]

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use crate::support;
use crate::support::halved;
use crate::support::ledger::{Ledger, ProofKey, is_found_false};
use crate::support::random::Random;
use crate::support::wait::block_on;

use chiaro::diag::{Diagnostic, has_errors};
use chiaro::files::{Disk, Outputs};
use chiaro::frame::Assets;
use chiaro::gallery::nodes::{SIDE, draw_nodes, write_nodes};
use chiaro::gallery::{
    GalleryDocument, GalleryOptions, GalleryReport, List, Section, build, content, list,
};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::Gpu;
use rayon::prelude::*;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The test program's device.
fn gpu() -> Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    let make = || block_on(Gpu::headless()).expect("there is no adapter, not even in software");
    GPU.get_or_init(make).clone()
}

fn options(side: u32, rounds: usize) -> GalleryOptions {
    GalleryOptions {
        size: [side, side],
        samples: 1,
        rounds,
        mesh: None,
        nodes: Some("../nodes.md".to_owned()),
    }
}

fn make(
    list: &List,
    folder: &Path,
    options: &GalleryOptions,
) -> Result<GalleryReport, Vec<Diagnostic>> {
    make_with(Library::built_in(), list, folder, options)
}

fn make_with(
    library: &Library,
    list: &List,
    folder: &Path,
    options: &GalleryOptions,
) -> Result<GalleryReport, Vec<Diagnostic>> {
    let library = |_: &Path| library.clone();
    let mut outputs = Outputs::new(false);
    block_on(build(list, folder, &mut outputs, &gpu(), &library, options, &Progress::new()))
}

/// Targets of the links in a page's attributes named `attribute`.
fn links(page: &str, attribute: &str) -> HashSet<String> {
    let mark = format!("{attribute}=\"");
    page.split(&mark).skip(1).filter_map(|rest| rest.split('"').next()).map(str::to_owned).collect()
}

/// All files of the gallery that some page of it links to.
fn follow(folder: &Path) -> Result<HashSet<String>, String> {
    let mut found = HashSet::new();
    let mut open = vec!["index.html".to_owned()];
    while let Some(name) = open.pop() {
        let text = std::fs::read_to_string(folder.join(&name))
            .map_err(|error| format!("{name}: {error}"))?;
        if text.matches("<div").count() != text.matches("</div>").count() {
            return Err(format!("{name} closes other than it opens"));
        }
        for link in links(&text, "href").into_iter().chain(links(&text, "src")) {
            if link.starts_with("..") {
                if !link.starts_with("../nodes.md#") {
                    return Err(format!("{name} leads to {link}"));
                }
                continue;
            }
            if !folder.join(&link).is_file() {
                return Err(format!("{name} leads to {link}, which is not there"));
            }
            if found.insert(link.clone()) && link.ends_with(".html") {
                open.push(link);
            }
        }
    }
    Ok(found)
}

/// Number of pages that the index links to.
fn pages(found: &HashSet<String>) -> usize {
    found.iter().filter(|name| name.ends_with(".html") && *name != "index.html").count()
}

/// The sweep of pages: a page shows the catalog's words and the drawing of a graph too.
const SWEEP: &[&str] = &["src/compiler/catalog", "src/scene/drawing", "tests/program/gallery.rs"];

/// Maker of keys: meshes and HCBTFs are read once, and HCBTFs are filled for few directions, since
/// keys hold the files themselves.
struct KeyMaker {
    assets: Assets,
    hcbtfs: Vec<(String, Vec<u8>)>,
}

impl KeyMaker {
    fn new() -> Self {
        let mut assets = Assets::default();
        assets.draft();
        let files = support::files::below(&root().join("examples/hcbtf")).into_iter();
        let hcbtfs = files.filter(|path| path.extension().is_some_and(|e| e == "hcbtf"));
        let read = |path: PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            (name, std::fs::read(&path).unwrap())
        };
        Self { assets, hcbtfs: hcbtfs.map(read).collect() }
    }

    /// Key of the verdict on a document's page.
    fn key(&mut self, shown: &GalleryDocument, library: &Library) -> ProofKey {
        let mut key = ProofKey::of_judges(SWEEP).with(gpu().info.driver_info.as_bytes());
        let mut looks = String::new();
        let mut sink = |bytes: &[u8]| {
            key.add(bytes);
            if bytes.starts_with(b"{") {
                looks += &String::from_utf8_lossy(bytes);
            }
        };
        content(shown, library, &options(SIDE_OF_PAGES, 0), &mut self.assets, &mut sink)
            .unwrap_or_else(|problems| panic!("{}: {problems:?}", shown.file.display()));
        for (_, bytes) in self.hcbtfs.iter().filter(|(name, _)| looks.contains(name)) {
            key.add(bytes);
        }
        key
    }
}

/// Side of the pages' pictures here, in pixels.
const SIDE_OF_PAGES: u32 = 48;

/// A number that tells pictures apart: the mean of the channels, each with a weight of its own.
fn figure(picture: &[u8]) -> f64 {
    let mut random = Random::new(48);
    let (mut sum, mut weights) = (0.0, 0.0);
    for channel in picture {
        let weight = random.between(0.5, 1.5);
        sum += weight * f64::from(*channel);
        weights += weight;
    }
    sum / (255.0 * weights)
}

/// Makes a document's page, follows its links, and returns its picture's number.
fn page(shown: &GalleryDocument, library: &Library) -> Result<f64, String> {
    let section = Section { shown: vec![shown.clone()], ..Section::default() };
    let list = List { sections: vec![section], ..List::default() };
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let made = make_with(library, &list, folder.path(), &options(SIDE_OF_PAGES, 0))
        .map_err(|problems| format!("{problems:?}"))?;
    if !made.problems.is_empty() || made.pages != 1 {
        return Err(format!("{:?}", made.problems));
    }
    let found = follow(folder.path())?;
    let pictures: Vec<&String> = found.iter().filter(|name| name.ends_with(".png")).collect();
    let ([picture], 1) = (pictures.as_slice(), pages(&found)) else {
        return Err(format!("the index leads to {found:?}"));
    };
    let picture =
        image::open(folder.path().join(picture)).map_err(|error| error.to_string())?.to_rgba8();
    let colors: HashSet<[u8; 4]> = picture.pixels().map(|pixel| pixel.0).collect();
    if picture.dimensions() != (SIDE_OF_PAGES, SIDE_OF_PAGES) || colors.len() < 2 {
        return Err(format!("{:?}, {} colors", picture.dimensions(), colors.len()));
    }
    Ok(figure(picture.as_raw()))
}

/// A look that draws one color.
const SMALL: &str = r#"{"nodes": [{"kind": "base"}, {"kind": "output"}],
    "wires": [{"from": "base", "to": "output.color"}]}"#;

/// Makes the whole gallery with one small look in place of every document: the index links to a
/// page for each.
fn gallery(list: &List) -> Result<f64, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut list = list.clone();
    let mut count = 0;
    for shown in list.sections.iter_mut().flat_map(|section| &mut section.shown) {
        let name = shown.file.strip_prefix(root()).map_err(|error| error.to_string())?;
        let file = folder.path().join(name);
        std::fs::create_dir_all(file.parent().unwrap_or(folder.path()))
            .and_then(|()| std::fs::write(&file, SMALL))
            .map_err(|error| error.to_string())?;
        (shown.file, shown.mesh) = (file, Some("shape:plane".to_owned()));
        count += 1;
    }
    let out = folder.path().join("out");
    let made = make(&list, &out, &options(4, 0)).map_err(|problems| format!("{problems:?}"))?;
    if !made.problems.is_empty() {
        return Err(format!("{:?}", made.problems));
    }
    let found = follow(&out)?;
    if made.pages == count && pages(&found) == count {
        return Ok(count as f64);
    }
    Err(format!("{count} documents, {} pages, {} in the index", made.pages, pages(&found)))
}

#[test]
fn every_example_is_shown() {
    let list = list::list(&Disk, &[root().join("examples")]).unwrap();
    let examples = ["looks", "shadows", "hcbtf", "images", "scenes"]
        .map(|name| root().join("examples").join(name));
    let files: Vec<PathBuf> =
        examples.iter().flat_map(|folder| support::files::below(folder)).collect();
    let documents: HashSet<PathBuf> =
        files.into_iter().filter(|path| path.extension().is_some_and(|e| e == "json")).collect();
    let shown: Vec<PathBuf> =
        list.sections.iter().flat_map(|section| &section.shown).map(|s| s.file.clone()).collect();
    // A look may be shown in a scene alone if it belongs to that scene: keyed by another of the
    // scene's objects.
    let text = |path: &PathBuf| std::fs::read_to_string(path).unwrap();
    let scenes: String =
        shown.iter().filter(|path| path.starts_with(&examples[4])).map(text).collect();
    let is_worn = |path: &Path| {
        let name = path.file_name().unwrap().display();
        ["looks", "shadows"]
            .iter()
            .any(|folder| scenes.contains(&format!("\"../{folder}/{name}\"")))
    };
    let missing: Vec<_> =
        documents.iter().filter(|path| !shown.contains(path) && !is_worn(path)).collect();
    assert!(missing.is_empty(), "examples/gallery.json does not show {missing:?}");
}

#[test]
fn every_example_has_a_page() {
    let list = list::list(&Disk, &[root().join("examples")]).unwrap();
    let order: Vec<&GalleryDocument> =
        list.sections.iter().flat_map(|section| &section.shown).collect();
    let name = |shown: &GalleryDocument| {
        let file = shown.file.strip_prefix(root()).expect("it lies here");
        file.to_string_lossy().replace('\\', "/")
    };
    let mut ledger = Ledger::open("gallery");
    let whole = format!("{list:?}").replace(&root().display().to_string(), "");
    let whole = ProofKey::of_judges(SWEEP).with(whole.as_bytes());
    ledger.prove("the whole", &whole, || gallery(&list));
    let library = Library::built_in();
    let keys = |shown: &[&GalleryDocument]| -> Vec<ProofKey> {
        let mut maker = KeyMaker::new();
        shown.iter().map(|shown| maker.key(shown, library)).collect()
    };
    let keys: Vec<ProofKey> = order.par_chunks(order.len().div_ceil(2)).flat_map(keys).collect();
    for (index, (shown, key)) in order.iter().zip(&keys).enumerate() {
        // A document may be shown more than once, from different views.
        let before = order[..index].iter().filter(|other| other.file == shown.file).count();
        let case =
            if before == 0 { name(shown) } else { format!("{}, {}", name(shown), before + 1) };
        ledger.prove(&case, key, || page(shown, library));
    }
    let figures: HashSet<u64> = ledger
        .figures()
        .filter(|(case, _)| *case != "the whole")
        .map(|(_, figure)| figure.to_bits())
        .collect();
    if ledger.complaints.is_empty() {
        assert_eq!(figures.len(), order.len(), "the pictures differ");
    }
    ledger.close();
}

/// A changed digit of a shader, and a forged line of the ledger, are both found.
#[test]
fn a_changed_shader_and_a_forged_line_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("half.json");
    std::fs::write(&file, halved::text().to_string()).unwrap();
    let shown = GalleryDocument { file, ..GalleryDocument::default() };
    let (before, after) = (halved::library("0.5"), halved::library("0.5000001"));
    let mut maker = KeyMaker::new();
    let keys =
        [&before, &halved::library("0.5"), &after].map(|library| maker.key(&shown, library).text());
    assert_eq!(keys[0], keys[1]);
    assert_ne!(keys[0], keys[2]);
    let (key, honest) = (maker.key(&shown, &before), page(&shown, &before).unwrap());
    assert!(is_found_false("half", &key, 3.0 * honest, || page(&shown, &before)), "a forged line");
    assert!(!is_found_false("half", &key, honest, || page(&shown, &before)), "an honest line");
}

#[test]
fn a_page_tells_what_it_costs() {
    let file = root().join("examples/looks/figure4-both.json");
    let list = list::list(&Disk, &[file]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let made = make(&list, folder.path(), &options(64, 3)).unwrap();
    assert!(made.problems.is_empty(), "{:?}", made.problems);
    let page = std::fs::read_to_string(folder.path().join("figure4-both.html")).unwrap();
    for told in
        ["<td>exact</td>", "<td>fast</td>", "3 rounds on ", "@fragment", "../nodes.md#output"]
    {
        assert!(page.contains(told), "the page does not say {told}");
    }
    let graph = std::fs::read_to_string(folder.path().join("figure4-both-graph.svg")).unwrap();
    assert!(graph.contains("Output") && graph.contains("</svg>"));
}

#[test]
fn what_cannot_be_shown_is_told_and_the_rest_is_there() {
    let folder = tempfile::tempdir().unwrap();
    let broken = folder.path().join("broken.json");
    std::fs::write(
        &broken,
        r#"{"chiaro": "look", "nodes": [{"id": "a", "kind": "nothing_such"}]}"#,
    )
    .unwrap();
    let good = root().join("examples/looks/figure2-diffuse.json");
    let out = folder.path().join("out");
    let made = make(&list::list(&Disk, &[broken, good]).unwrap(), &out, &options(32, 0)).unwrap();
    assert_eq!(made.pages, 1);
    assert!(
        has_errors(&made.problems) && made.problems[0].to_string().contains("broken.json"),
        "{:?}",
        made.problems
    );
    assert!(out.join("figure2-diffuse.html").is_file() && !out.join("broken.html").exists());
}

#[test]
fn pages_of_others_stay() {
    let folder = tempfile::tempdir().unwrap();
    let index = folder.path().join("index.html");
    std::fs::write(&index, "my own page").unwrap();
    let list = list::list(&Disk, &[root().join("examples/looks/figure2-diffuse.json")]).unwrap();
    let problems = make(&list, folder.path(), &options(32, 0)).unwrap_err();
    assert_eq!(problems[0].code, "in-the-way");
    assert_eq!(std::fs::read_to_string(&index).unwrap(), "my own page");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// Drawings are compared byte for byte, pictures up to the rounding of adapters.
#[test]
fn the_pictures_of_nodes_are_those_of_now() {
    let folder = root().join("docs/nodes");
    if std::env::var_os("CHIARO_BLESS").is_some() {
        let mut outputs = Outputs::new(false);
        block_on(write_nodes(Library::built_in(), &folder, &gpu(), &mut outputs, &Progress::new()))
            .unwrap();
    }
    let mut files = HashSet::new();
    let mut far = Vec::new();
    block_on(draw_nodes(Library::built_in(), &gpu(), &Progress::new(), &mut |node| {
        let name = format!("{}.svg", node.kind);
        let svg = std::fs::read_to_string(folder.join(&name)).unwrap_or_default();
        if svg != node.svg {
            far.push(name.clone());
        }
        files.insert(name);
        if let Some(picture) = node.picture {
            let name = format!("{}.png", node.kind);
            let kept = image::open(folder.join(&name))
                .map(image::DynamicImage::into_rgba8)
                .unwrap_or_default();
            let now = picture.to_rgba8();
            let is_like = kept.dimensions() == (SIDE, SIDE) && {
                let apart = |(a, b): &(&u8, &u8)| a.abs_diff(**b) > 8;
                kept.as_raw().iter().zip(&now).filter(apart).count() * 100 < now.len()
            };
            if !is_like {
                far.push(name.clone());
            }
            files.insert(name);
        }
        Ok(())
    }))
    .unwrap();
    let there = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap());
    far.extend(there.filter(|name| !files.contains(name)));
    assert!(
        far.is_empty(),
        "{far:?} are not as they are drawn now; CHIARO_BLESS=1 writes docs/nodes, delete what is \
         left"
    );
}
