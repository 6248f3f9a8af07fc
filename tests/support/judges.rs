//! Sources that judge: everything of the project, and of others, whose code decides on the verdict
//! of a sweep.
//!
//! No sweep lists its judges. They are found from the sweep's own file: each room that the file
//! imports, each room that those rooms import, and so on, as far as `ROOMS` says that a room's
//! code can decide on a verdict at all. The crates of others that compute are in every key with
//! their versions.

use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::ledger::ProofKey;
use crate::scan::{self, Reference};
use crate::{files, root};

/// Rooms by name, each with its sources that decide on verdicts.
///
/// Keys hold the results of the compiler (modules, numbers), of exports (files), and the texts of
/// documents: another source that gives the same results leaves a verdict as it is. What plans and
/// pictures take from these rooms at other times and from other views is named: arithmetic of
/// documents, and the tables of passes and contexts, which executors walk.
const ROOMS: &[(&str, &[&str])] = &[
    // The language.
    ("clock", &[]),
    ("diag", &[]),
    ("figures", &[]),
    ("ids", &[]),
    ("interp", &["src/language/interp"]),
    ("milestones", &[]),
    ("progress", &[]),
    ("wgsl", &["src/language/wgsl"]),
    // The compiler.
    ("catalog", &[]),
    ("compile", &[]),
    (
        "document",
        &[
            "src/compiler/document/color.rs",
            "src/compiler/document/hcbtf",
            "src/compiler/document/light",
            "src/compiler/document/rotation.rs",
            "src/compiler/document/value.rs",
        ],
    ),
    ("examples", &[]),
    ("files", &[]),
    ("library", &["src/compiler/library/context", "src/compiler/library/passes"]),
    // Scenes. The cache gives what its makers made, and tests have none.
    ("cache", &[]),
    ("directions", &["src/scene/directions"]),
    ("drawing", &[]),
    ("export", &[]),
    ("frame", &["src/scene/frame"]),
    ("geometry", &["src/scene/geometry"]),
    ("hcbtf", &["src/scene/hcbtf"]),
    ("placing", &[]),
    ("threads", &[]),
    // Executors.
    ("reference", &["src/reference"]),
    ("render", &["src/render"]),
    // The laboratory and the sweeps.
    ("accuracy", &["src/laboratory/accuracy"]),
    ("fit", &["src/laboratory/fit"]),
    ("gallery", &["src/laboratory/gallery"]),
    ("sweeps", &["src/sweeps"]),
    // Code that the test programs share. Ledgers, walks over folders and waiting judge nothing and
    // are left out.
    (
        "support",
        &[
            "tests/drawing",
            "tests/support/badf.rs",
            "tests/support/color.rs",
            "tests/support/noise.rs",
            "tests/support/random.rs",
            "tests/support/report.rs",
        ],
    ),
];

/// Crates of the project whose modules are rooms.
const HOUSES: &[&str] =
    &["crate", "chiaro", "chiaro_language", "chiaro_compiler", "chiaro_scene", "chiaro_laboratory"];

/// Crates of the project that are one room each.
const SINGLE_ROOMS: &[(&str, &str)] = &[
    ("chiaro_files", "files"),
    ("chiaro_reference", "reference"),
    ("chiaro_render", "render"),
    ("chiaro_sweeps", "sweeps"),
    ("chiaro_test_drawing", "support"),
    ("chiaro_test_support", "support"),
];

/// Crates of the project that say things, and compute nothing that is judged.
const SAYING: &[&str] = &["chiaro_locale"];

/// Crates of others whose code computes what is judged or judges it: shaders, pictures, images,
/// meshes, vectors.
pub const COMPUTING: &[&str] = &[
    "bevy_mikktspace",
    "block_compression",
    "exr",
    "faer",
    "glam",
    "gltf",
    "half",
    "image",
    "ktx2",
    "naga",
    "png",
    "wgpu",
    "wgpu-core",
    "wgpu-hal",
    "wgpu-naga-bridge",
    "wgpu-types",
    "zune-jpeg",
];

impl ProofKey {
    /// Key of a verdict of the sweep in these files and folders, with everything that judges it.
    pub fn of_judges(sweep: &[&str]) -> Self {
        static KNOWN: Mutex<Option<HashMap<String, ProofKey>>> = Mutex::new(None);
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let make = || {
            let judges = judges(sweep);
            let lock = fs::read_to_string(root().join("Cargo.lock")).expect("it lies at the root");
            Self::of_sources(&judges.iter().map(String::as_str).collect::<Vec<_>>())
                .with(versions(&lock).as_bytes())
        };
        known.get_or_insert_default().entry(sweep.join(" ")).or_insert_with(make).clone()
    }
}

/// Files and folders whose sources decide on the verdict of the sweep in these files and folders,
/// relative to the project's root.
pub fn judges(sweep: &[&str]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open: Vec<String> = sweep.iter().map(|&path| path.to_owned()).collect();
    while let Some(next) = open.pop() {
        if !found.insert(next.clone()) {
            continue;
        }
        for path in sources(&root().join(&next)) {
            open.extend(used_by(&path));
        }
    }
    let all = found.clone();
    let is_within = |path: &str, folder: &str| {
        path.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/'))
    };
    found.retain(|path| !all.iter().any(|folder| is_within(path, folder)));
    found
}

/// The Rust sources of a file or a folder.
fn sources(path: &Path) -> Vec<PathBuf> {
    let all = if path.is_file() { vec![path.to_path_buf()] } else { files::below(path) };
    all.into_iter().filter(|path| path.extension().is_some_and(|kind| kind == "rs")).collect()
}

/// Sources of the rooms that a source imports, as far as they decide on verdicts; remembered.
fn used_by(path: &Path) -> Vec<String> {
    static KNOWN: Mutex<Option<HashMap<PathBuf, Vec<String>>>> = Mutex::new(None);
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let known = known.get_or_insert_default();
    known.entry(path.to_path_buf()).or_insert_with(|| read_used_by(path)).clone()
}

fn read_used_by(path: &Path) -> Vec<String> {
    let text =
        fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let name = path.strip_prefix(root()).expect("it lies in the project");
    let known = |name: &str| {
        SAYING.contains(&name)
            || HOUSES.contains(&name)
            || SINGLE_ROOMS.iter().any(|(single, _)| *single == name)
    };
    let foreign = scan::references(&text, name.iter().count()).into_iter().find(|found| {
        let first = found.path.split("::").next().unwrap_or_default();
        first.starts_with("chiaro_") && !known(first)
    });
    if let Some(found) = foreign {
        panic!("{}: judges.rs must name the crate of `{}`", name.display(), found.path);
    }
    let mut used = Vec::new();
    for house in HOUSES.iter().filter(|house| text.contains(**house)) {
        for found in scan::crate_paths(&text, house) {
            let Reference::Module(module) = found.reference else { continue };
            match ROOMS.iter().find(|(room, _)| *room == module) {
                Some((_, sources)) => used.extend(sources.iter().map(|&path| path.to_owned())),
                None => used.extend(sibling(name, &module)),
            }
        }
    }
    for (name, room) in SINGLE_ROOMS {
        let sources = ROOMS.iter().find(|(known, _)| known == room).map(|(_, sources)| sources);
        if text.contains(name) && !scan::crate_paths(&text, name).is_empty() {
            used.extend(sources.into_iter().flat_map(|sources| sources.iter()).map(|&s| s.into()));
        }
    }
    used
}

/// A module at the root of the crate or test program that `importer` belongs to: a source of its
/// own. Panics where there is none, and the name is neither an item nor of the shared helpers.
fn sibling(importer: &Path, module: &str) -> Option<String> {
    let crate_folder: PathBuf = importer.iter().take(2).collect();
    let candidates = [crate_folder.join(format!("{module}.rs")), crate_folder.join(module)];
    let found = candidates.iter().find(|path| root().join(path).exists());
    let found = found.map(|path| path.to_string_lossy().into_owned());
    let is_shared = ["tests/drawing", "tests/support"].iter().any(|f| importer.starts_with(f));
    let is_item = module.starts_with(char::is_uppercase) || is_shared;
    assert!(
        found.is_some() || is_item,
        "{} imports `{module}`: ROOMS in tests/support/judges.rs must name it",
        importer.display()
    );
    found
}

/// The lines of a `Cargo.lock` that say which versions of [`COMPUTING`] are built.
pub fn versions(lock: &str) -> String {
    let mut versions = String::new();
    for package in lock.split("[[package]]") {
        let value = |key: &str| {
            package.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "))
        };
        let name = value("name").unwrap_or_default().trim_matches('"');
        if COMPUTING.contains(&name) {
            versions += &format!("{name} {}\n", value("version").unwrap_or_default());
        }
    }
    versions
}
