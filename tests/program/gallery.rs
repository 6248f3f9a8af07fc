//! The gallery: every example has a page whose links lead somewhere, and the nodes' pictures are
//! those of now.
#![cfg(feature = "gpu")]

use crate::support;
use crate::support::wait::block_on;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

use chiaro::diag::{Diagnostic, has_errors};
use chiaro::document::Outputs;
use chiaro::gallery::nodes::{SIDE, draw_nodes, write_nodes};
use chiaro::gallery::{GalleryReport, List, Options, build, list};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::Gpu;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn gpu() -> Gpu {
    block_on(Gpu::headless()).expect("there is no adapter, not even in software")
}

fn options(side: u32, rounds: usize) -> Options {
    Options {
        size: [side, side],
        samples: 1,
        rounds,
        mesh: None,
        nodes: Some("../nodes.md".to_owned()),
    }
}

fn make(list: &List, folder: &Path, options: &Options) -> Result<GalleryReport, Vec<Diagnostic>> {
    let library = |_: &Path| Library::built_in().clone();
    block_on(build(
        list,
        folder,
        &mut Outputs::new(false),
        &gpu(),
        &library,
        options,
        &Progress::new(),
    ))
}

/// What a page's attributes of a name lead to.
fn links(page: &str, attribute: &str) -> HashSet<String> {
    let mark = format!("{attribute}=\"");
    page.split(&mark).skip(1).filter_map(|rest| rest.split('"').next()).map(str::to_owned).collect()
}

/// Every file of the gallery that some page of it leads to.
fn follow(folder: &Path) -> HashSet<String> {
    let mut found = HashSet::new();
    let mut open = vec!["index.html".to_owned()];
    while let Some(name) = open.pop() {
        let text = std::fs::read_to_string(folder.join(&name))
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(text.matches("<div").count(), text.matches("</div>").count(), "{name}");
        for link in links(&text, "href").into_iter().chain(links(&text, "src")) {
            if link.starts_with("..") {
                assert!(link.starts_with("../nodes.md#"), "{name} leads to {link}");
                continue;
            }
            assert!(folder.join(&link).is_file(), "{name} leads to {link}, which is not there");
            if found.insert(link.clone()) && link.ends_with(".html") {
                open.push(link);
            }
        }
    }
    found
}

#[test]
fn every_example_has_a_page() {
    let list = list::list(&[root().join("examples")]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let made = make(&list, folder.path(), &options(48, 0)).unwrap();
    assert!(made.problems.is_empty(), "{:?}", made.problems);
    let examples =
        ["looks", "hcbtf", "images", "scenes"].map(|name| root().join("examples").join(name));
    let files: Vec<PathBuf> =
        examples.iter().flat_map(|folder| support::files::below(folder)).collect();
    let documents: HashSet<PathBuf> =
        files.into_iter().filter(|path| path.extension().is_some_and(|e| e == "json")).collect();
    let shown: Vec<PathBuf> =
        list.sections.iter().flat_map(|section| &section.shown).map(|s| s.file.clone()).collect();
    // A look may be seen in a scene alone, where it is of that scene: keyed by another of its
    // objects.
    let text = |path: &PathBuf| std::fs::read_to_string(path).unwrap();
    let scenes: String =
        shown.iter().filter(|path| path.starts_with(&examples[3])).map(text).collect();
    let is_worn = |path: &Path| {
        scenes.contains(&format!("\"../looks/{}\"", path.file_name().unwrap().display()))
    };
    let missing: Vec<_> =
        documents.iter().filter(|path| !shown.contains(path) && !is_worn(path)).collect();
    assert!(missing.is_empty(), "examples/gallery.json does not show {missing:?}");
    assert_eq!(made.pages, shown.len());

    let found = follow(folder.path());
    let pages =
        found.iter().filter(|name| name.ends_with(".html") && *name != "index.html").count();
    assert_eq!(pages, shown.len(), "the index leads to every page");
    let mut pictures = HashSet::new();
    for name in found.iter().filter(|name| name.ends_with(".png")) {
        let picture = image::open(folder.path().join(name)).unwrap().to_rgba8();
        assert_eq!(picture.dimensions(), (48, 48), "{name}");
        let colors: HashSet<[u8; 4]> = picture.pixels().map(|pixel| pixel.0).collect();
        assert!(colors.len() > 1, "nothing is seen in {name}");
        pictures.insert(picture.into_raw());
    }
    assert_eq!(pictures.len(), pages, "the pictures differ");
}

#[test]
fn a_page_tells_what_it_costs() {
    let file = root().join("examples/looks/figure4-both.json");
    let list = list::list(&[file]).unwrap();
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
    let made = make(&list::list(&[broken, good]).unwrap(), &out, &options(32, 0)).unwrap();
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
    let list = list::list(&[root().join("examples/looks/figure2-diffuse.json")]).unwrap();
    let problems = make(&list, folder.path(), &options(32, 0)).unwrap_err();
    assert_eq!(problems[0].code, "in-the-way");
    assert_eq!(std::fs::read_to_string(&index).unwrap(), "my own page");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// The drawings byte for byte; the pictures as adapters round.
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
