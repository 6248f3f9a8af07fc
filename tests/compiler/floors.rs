//! Layers of the source: a module ("room") imports only from floors below its own.
//!
//! Cargo holds the floors that are crates; their manifests are read here for dependencies that
//! Cargo would let pass. Inside a crate the test reads every source file, comments and strings left
//! out, and follows each path that starts at the crate's root, by `crate::` or by `super::`. Test
//! code inside `src/` is held to the same rule.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support;
use crate::support::scan::{self, Reference};

/// The crates of `docs/decisions.md`, lowest first, each with its rooms by floors. A room may
/// import from any line above its own in its crate, and from itself; never from its own line or a
/// line below. A crate may depend on those before it.
///
/// A diagnostic names nodes by their ids, a milestone has a time, a group that the library ships is
/// a document, a drawing shows what the catalog knows, and a frame plan joins what the rest of the
/// scene's rooms make.
const CRATES: &[(&str, &[&[&str]])] = &[
    ("embed", &[]),
    ("locale", &[]),
    (
        "language",
        &[
            &["clock", "figures", "ids"],
            &["diag", "milestones"],
            &["progress", "wgsl"],
            &["interp"],
        ],
    ),
    (
        "compiler",
        &[&["examples"], &["files"], &["document"], &["library"], &["catalog", "compile"]],
    ),
    ("files", &[]),
    (
        "scene",
        &[
            &["cache"],
            &["directions", "geometry", "hcbtf", "import", "photometry", "placing", "threads"],
            &["drawing", "frame"],
            &["export"],
        ],
    ),
    ("reference", &[]),
    ("render", &[]),
    (
        "film",
        &[
            &["changes", "frames", "label", "naming", "tables"],
            &["contributions", "exr"],
            &["cryptomatte"],
            &["layers"],
            &["animation", "comp", "farm", "plan_hash", "sheet", "view"],
            &["stored"],
        ],
    ),
    ("laboratory", &[&["accuracy", "fit"], &["gallery"]]),
    ("sweeps", &[]),
    (
        "editor",
        &[
            &["state"],
            &["commands"],
            &["widgets"],
            &["fields"],
            &["tools"],
            &["canvas", "painter", "viewport"],
            &["panels"],
            &["app"],
        ],
    ),
    ("cli", &[]),
];

/// Imports that the floors would allow and that would make a proof worthless: the reference judges
/// the compiler's output, so it must not be built on the compiler.
const APART: &[(&str, &str, &str)] = &[("reference", "chiaro_compiler", "compile")];

/// Modules of `std` that the compiler may not use: its caller decides where files come from, and
/// which thread work runs on.
const NOT_FOR_THE_COMPILER: &[&str] = &["env", "fs", "net", "process", "thread"];

/// Crates that read what documents and callers name through `Files`, and write through
/// `chiaro-files`.
const READ_THROUGH_FILES: &[&str] = &["scene", "laboratory", "sweeps"];

/// Modules of `std` that those crates may not use.
const NOT_FOR_READERS: &[&str] = &["env", "fs", "net", "process"];

/// Words by which the disk is asked for something: its `Files`, and methods of paths.
const OF_THE_DISK: &[&str] = &[
    "Disk",
    "exists",
    "try_exists",
    "is_file",
    "is_dir",
    "is_symlink",
    "canonicalize",
    "read_dir",
    "read_link",
    "image_dimensions",
];

/// Readers of `chiaro-files` that take a path alone, and so ask the disk.
const READERS_OF_THE_DISK: &[&str] = &["read", "read_text", "walk"];

/// Files of those crates that ask the disk, each with the reason.
const ASKS_THE_DISK: &[(&str, &str)] = &[
    ("scene/frame/store.rs", "reads where a caller says nothing about files"),
    ("scene/hcbtf/exchange.rs", "finds the outputs that an export would replace"),
    ("scene/export/files.rs", "tells own outputs from others', which are not written over"),
    ("laboratory/gallery/mod.rs", "tells own pages from others', which are not written over"),
    ("laboratory/gallery/nodes.rs", "tells own pictures from others', which are not written over"),
];

/// Modules and packages that a room may not use although the floors would allow them. The window's
/// state works without a window, and its widgets fit any state.
const STRANGERS: &[(&str, &str, &[&str])] = &[
    ("editor", "state", &["eframe", "egui", "egui_tiles", "egui_extras"]),
    ("editor", "widgets", &["state"]),
];

/// Modules of the window's state that know the whole session; all others know its parts alone, so
/// that no module of the state lies in a ring with another.
const KNOW_THE_SESSION: &[&str] = &["session", "safety", "fixes"];

/// Packages that only some crates may use: the compiler builds without a GPU and a window, and
/// users who only want WGSL from a graph pay for no command line and no archives. Sweeps measure
/// nodes for whoever makes them, and neither the window nor a library carries them.
const KEPT_TO: &[(&str, &[&str])] = &[
    ("chiaro-sweeps", &["cli"]),
    ("wgpu", &["render", "editor"]),
    ("egui", &["editor"]),
    ("egui_extras", &["editor"]),
    ("egui_tiles", &["editor"]),
    ("eframe", &["editor"]),
    ("rfd", &["editor"]),
    ("notify", &["editor", "cli"]),
    ("clap", &["cli"]),
    ("exr", &["film"]),
    ("png", &["film"]),
    ("skrifa", &["film"]),
    ("ctrlc", &["cli"]),
    ("zip", &["scene"]),
    ("faer", &["scene"]),
    ("gltf", &["scene"]),
    ("rayon", &["scene", "reference", "laboratory", "cli"]),
    ("roxmltree", &["scene"]),
];

/// An executor by name.
struct NamedExecutor {
    name: &'static str,
    /// Modules that have the executor.
    modules: &'static [&'static str],
    /// Files that may name the executor, each with what it does that an `Executor` does not.
    allowed: &'static [(&'static str, &'static str)],
}

/// All executors. Code that only wants a picture takes a `dyn Executor`, and does not know who
/// draws.
const EXECUTORS: &[NamedExecutor] = &[
    NamedExecutor {
        name: "Renderer",
        modules: &["render", "chiaro_render"],
        allowed: &[
            ("cli/bench.rs", "times passes"),
            ("cli/eval.rs", "evaluates samples"),
            ("cli/explain/mod.rs", "times passes"),
            ("cli/tune.rs", "times passes"),
            ("editor/panels/cost/mod.rs", "times passes"),
            ("editor/tools/playback/drawing.rs", "shows frames by a view"),
            ("editor/viewport/picture.rs", "shows the texture itself, and times passes"),
            ("laboratory/accuracy/bench.rs", "times passes"),
            ("laboratory/accuracy/cost.rs", "times passes"),
            ("laboratory/accuracy/tune.rs", "times passes"),
            ("laboratory/gallery/entry.rs", "times passes"),
            ("sweeps/measure.rs", "evaluates samples"),
            ("sweeps/survey.rs", "evaluates samples"),
        ],
    },
    NamedExecutor {
        name: "Reference",
        modules: &["reference", "chiaro_reference"],
        allowed: &[("cli/render/mod.rs", "chooses the executor that was asked for")],
    },
];

/// The rank of a room among the floors of its crate, from 0.
fn floor_of(krate: &str, room: &str) -> Option<usize> {
    let (_, floors) = CRATES.iter().find(|(name, _)| *name == krate)?;
    floors.iter().position(|rooms| rooms.contains(&room))
}

/// The complaint about `reference` in the room `importer` of a crate, if it is not allowed.
fn complaint(krate: &str, importer: &str, reference: &Reference) -> Option<String> {
    let imported = match reference {
        Reference::Module(name) => name.as_str(),
        Reference::WholeCrate => return Some("takes in the whole crate; name the module".into()),
        Reference::Crate(_) => return None,
    };
    if imported == importer {
        return None;
    }
    // Names that are no room come from crates below, which Cargo holds.
    let upper = floor_of(krate, imported)?;
    let own = floor_of(krate, importer)?;
    if upper > own {
        return Some(format!(
            "`{importer}` (floor {own}) reaches up to `{imported}` (floor {upper})"
        ));
    }
    (upper == own).then(|| {
        format!("`{importer}` and `{imported}` share floor {own} and may not know each other")
    })
}

/// All complaints about the source `text` of the file at `path`, relative to `src/`.
fn check_source(path: &Path, text: &str) -> Vec<String> {
    let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy().into_owned()).collect();
    let [krate, inside @ ..] = parts.as_slice() else { return Vec::new() };
    match (krate.as_str(), inside.first().map(String::as_str)) {
        // The root declares the library, so it may name everything.
        ("lib.rs", None) => return Vec::new(),
        ("main.rs", None) => return check_main(text),
        _ => {}
    }
    let mut complaints = check_apart(krate, path, text);
    let rooms = CRATES.iter().find(|(name, _)| name == krate).map_or(0, |(_, floors)| floors.len());
    let Some(room) =
        inside.first().map(|first| first.trim_end_matches(".rs")).filter(|_| rooms > 0)
    else {
        return complaints;
    };
    // The crate's root declares its rooms; a build script is no part of the crate.
    if matches!(room, "lib" | "build") {
        return complaints;
    }
    complaints.extend(check_strangers(krate, room, path, text));
    let depth = inside.len()
        - usize::from(inside.len() > 1 && inside.last().is_some_and(|last| last == "mod.rs"));
    complaints.extend(scan::references(text, depth).into_iter().filter_map(|found| {
        let complaint = complaint(krate, room, &found.reference)?;
        Some(format!("src/{}:{}: `{}`: {complaint}", path.display(), found.line, found.path))
    }));
    complaints
}

/// Complaints about imports that would make a proof worthless.
fn check_apart(krate: &str, path: &Path, text: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    for (_, package, room) in APART.iter().filter(|(name, ..)| *name == krate) {
        let found = scan::crate_paths(text, package).into_iter();
        complaints.extend(
            found
                .filter(|found| match &found.reference {
                    Reference::Module(name) => name == room,
                    other => *other == Reference::WholeCrate,
                })
                .map(|found| {
                    let (line, path) = (found.line, path.display());
                    format!(
                        "src/{path}:{line}: `{}`: `{krate}` may not be built on `{room}`",
                        found.path
                    )
                }),
        );
    }
    complaints
}

/// Complaints about modules and packages that a room may not use.
fn check_strangers(krate: &str, room: &str, path: &Path, text: &str) -> Vec<String> {
    let rules = STRANGERS.iter().filter(|(of, name, _)| *of == krate && *name == room);
    let strangers = rules.flat_map(|(.., strangers)| strangers.iter());
    strangers
        .flat_map(|stranger| {
            let of_package = scan::crate_paths(text, stranger).into_iter();
            let of_crate = scan::crate_paths(text, "crate").into_iter().filter(
                move |found| {
                    matches!(&found.reference, Reference::Module(name) if name == stranger)
                },
            );
            of_package.chain(of_crate).map(move |found| {
                let (line, path) = (found.line, path.display());
                format!("src/{path}:{line}: `{}`: `{room}` may not know `{stranger}`", found.path)
            })
        })
        .collect()
}

/// Complaints about the program's root, which only hands over: it may use `chiaro::cli` and
/// `chiaro::editor`, and no other module of the library.
fn check_main(text: &str) -> Vec<String> {
    scan::crate_paths(text, "chiaro")
        .into_iter()
        .filter(|found| {
            let Reference::Module(name) = &found.reference else { return true };
            name != "cli" && name != "editor"
        })
        .map(|found| {
            let (line, path) = (found.line, found.path);
            format!("src/main.rs:{line}: `{path}`: main hands over to cli or editor only")
        })
        .collect()
}

/// Complaints about dependencies in the manifest of a crate. Sections of tests count as well,
/// except for the project's own crates.
fn check_manifest(krate: &str, manifest: &str) -> Vec<String> {
    let rank = |name: &str| CRATES.iter().position(|(known, _)| *known == name);
    let mut complaints = Vec::new();
    let mut is_dependency = false;
    for line in manifest.lines().map(str::trim) {
        if line.starts_with('[') {
            is_dependency = line.trim_matches(['[', ']']).ends_with("dependencies");
            continue;
        }
        let name = line.split(['.', ' ', '=']).next().unwrap_or_default();
        if !is_dependency || name.is_empty() || name.starts_with('#') {
            continue;
        }
        if let Some(other) = name.strip_prefix("chiaro-")
            && rank(other) >= rank(krate)
        {
            complaints.push(format!("src/{krate}/Cargo.toml: `{krate}` stands below `{other}`"));
        }
        let kept = KEPT_TO.iter().find(|(package, _)| *package == name);
        if let Some((_, owners)) = kept.filter(|(_, owners)| !owners.contains(&krate)) {
            complaints.push(format!(
                "src/{krate}/Cargo.toml: `{name}` belongs to {} only",
                owners.join(", ")
            ));
        }
    }
    complaints
}

/// The folder of the sources, and every `.rs` file in it by its path from there; links are not
/// followed to other files.
fn sources() -> (PathBuf, Vec<PathBuf>) {
    let src = support::root().join("src");
    let is_rust = |path: &PathBuf| path.extension().is_some_and(|name| name == "rs");
    let rust = support::files::below(&src).into_iter().filter(is_rust);
    let rust = rust.map(|path| path.strip_prefix(&src).expect("it was found there").to_path_buf());
    let files = rust.filter(|path| {
        !["examples", "nodes", "shaders"]
            .iter()
            .any(|link| path.iter().nth(1) == Some(link.as_ref()))
    });
    (src.clone(), files.collect())
}

#[test]
fn imports_go_down() {
    let (src, files) = sources();
    assert!(files.len() > 2, "src/ holds more than its roots");
    let complaints: Vec<_> = files
        .iter()
        .flat_map(|path| {
            check_source(path, &fs::read_to_string(src.join(path)).expect("a source is UTF-8"))
        })
        .collect();
    assert!(complaints.is_empty(), "imports that break the floors:\n{}", complaints.join("\n"));
}

/// Complaints about modules of `std` that a crate may not use.
fn check_system(path: &Path, text: &str, forbidden: &[&str]) -> Vec<String> {
    let found = scan::crate_paths(text, "std").into_iter();
    let is_system = |reference: &Reference| match reference {
        Reference::Module(name) => forbidden.contains(&name.as_str()),
        other => *other == Reference::WholeCrate,
    };
    found
        .filter(|found| is_system(&found.reference))
        .map(|found| format!("src/{}:{}: `{}`", path.display(), found.line, found.path))
        .collect()
}

#[test]
fn the_compiler_has_no_files_and_no_threads() {
    let (src, files) = sources();
    let is_own = |path: &&PathBuf| path.starts_with("compiler") && !path.ends_with("build.rs");
    let complaints: Vec<_> = files
        .iter()
        .filter(is_own)
        .flat_map(|path| {
            let text = fs::read_to_string(src.join(path)).expect("a source is UTF-8");
            check_system(path, &text, NOT_FOR_THE_COMPILER)
        })
        .collect();
    assert!(complaints.is_empty(), "the compiler asks the system:\n{}", complaints.join("\n"));
    let check = |text| check_system(Path::new("a"), text, NOT_FOR_THE_COMPILER).len();
    assert_eq!(check("use std::{fs, io};"), 1);
    assert_eq!(check("fn f() { std::thread::yield_now() }"), 1);
}

/// Ways to the disk in the source `text`, each with its line.
fn ways_to_the_disk(text: &str) -> Vec<(String, usize)> {
    let words = scan::words(text).into_iter();
    let mut found: Vec<_> =
        words.filter(|(word, _)| OF_THE_DISK.contains(&word.as_str())).collect();
    found.extend(scan::members(text, "files").into_iter().filter_map(|found| {
        let Reference::Module(member) = &found.reference else { return None };
        let is_reader = READERS_OF_THE_DISK.contains(&member.as_str());
        is_reader.then_some((found.path, found.line))
    }));
    found
}

/// Source without the tests inside, which stand at its end and may write files.
fn without_tests(text: &str) -> &str {
    text.split("#[cfg(test)]\nmod tests {").next().unwrap_or(text)
}

#[test]
fn scenes_and_measurements_read_through_files_alone() {
    let (src, files) = sources();
    let is_test = |path: &Path| {
        path.components().any(|part| part.as_os_str() == "tests" || part.as_os_str() == "tests.rs")
    };
    let is_held = |path: &Path| READ_THROUGH_FILES.iter().any(|krate| path.starts_with(krate));
    let mut idle: BTreeSet<&str> = ASKS_THE_DISK.iter().map(|(path, _)| *path).collect();
    let mut complaints = Vec::new();
    for path in files.iter().filter(|path| is_held(path) && !is_test(path)) {
        let text = fs::read_to_string(src.join(path)).expect("a source is UTF-8");
        let text = without_tests(&text);
        complaints.extend(check_system(path, text, NOT_FOR_READERS));
        let name = path.to_str().expect("sources have plain names");
        let ways = ways_to_the_disk(text);
        if ASKS_THE_DISK.iter().any(|(known, _)| *known == name) {
            idle.retain(|known| *known != name || ways.is_empty());
        } else {
            complaints.extend(ways.iter().map(|(way, line)| format!("src/{name}:{line}: {way}")));
        }
    }
    assert!(complaints.is_empty(), "the disk is asked:\n{}", complaints.join("\n"));
    assert!(idle.is_empty(), "files that do not ask the disk any more: {idle:?}");
    let ways = |text| ways_to_the_disk(without_tests(text)).len();
    assert_eq!(ways("fn f() { path.is_file() || Look::load(&crate::files::Disk, path) }"), 2);
    assert_eq!(ways("use crate::files::{Files, read_text}; fn f() { files::read(path, 5) }"), 2);
    assert_eq!(ways("use crate::document::read_text; fn f() { files.read(path, 5) }"), 0);
    assert_eq!(ways("fn f() {}\n#[cfg(test)]\nmod tests {\n    use crate::files::Disk;\n}"), 0);
    let of_system = |text| check_system(Path::new("a"), text, NOT_FOR_READERS).len();
    assert_eq!(of_system("fn f() { std::fs::read(path) }"), 1);
}

#[test]
fn parts_of_the_windows_state_do_not_know_the_session() {
    let (src, files) = sources();
    let mut modules = BTreeSet::new();
    for path in &files {
        let Ok(inside) = path.strip_prefix("editor/state") else { continue };
        let module = inside.iter().next().unwrap().to_string_lossy();
        let module = module.trim_end_matches(".rs").to_owned();
        let text = fs::read_to_string(src.join(path)).unwrap();
        let knows = text.contains("crate::state::session");
        assert!(
            !knows || KNOW_THE_SESSION.contains(&module.as_str()),
            "{}: `{module}` may know parts of the session, not the whole",
            path.display()
        );
        modules.insert(module);
    }
    assert!(modules.len() > 15, "{modules:?}");
}

#[test]
fn every_room_stands_on_one_floor() {
    let (_, files) = sources();
    for (krate, floors) in CRATES.iter().filter(|(_, floors)| !floors.is_empty()) {
        let rooms: BTreeSet<_> = files
            .iter()
            .filter_map(|path| path.strip_prefix(krate).ok()?.iter().next())
            .map(|first| first.to_string_lossy().trim_end_matches(".rs").to_owned())
            .filter(|room| room != "lib" && room != "build")
            .collect();
        for room in &rooms {
            let count = floors.iter().filter(|rooms| rooms.contains(&room.as_str())).count();
            assert_eq!(
                count, 1,
                "`{krate}/{room}` stands on {count} floors; CRATES must name it once"
            );
        }
        let named = floors.iter().map(|rooms| rooms.len()).sum::<usize>();
        assert_eq!(named, rooms.len(), "CRATES names rooms of `{krate}` that are not there");
    }
}

/// The lines on which `text` names an executor that one of `modules` has.
fn executors_named(text: &str, executor: &str, modules: &[&str]) -> Vec<usize> {
    let found = modules.iter().flat_map(|module| scan::members(text, module));
    let is_executor =
        |found: &scan::FoundPath| found.reference == Reference::Module(executor.to_owned());
    found.filter(is_executor).map(|found| found.line).collect()
}

#[test]
fn who_only_wants_a_picture_does_not_ask_who_draws() {
    let (src, files) = sources();
    let mut complaints = Vec::new();
    for NamedExecutor { name: executor, modules, allowed } in EXECUTORS {
        let mut idle: BTreeSet<&str> = allowed.iter().map(|(path, _)| *path).collect();
        for path in files.iter().filter(|path| !modules.iter().any(|own| path.starts_with(own))) {
            let text = fs::read_to_string(src.join(path)).expect("a source is UTF-8");
            let name = path.to_str().expect("sources have plain names");
            for line in executors_named(&text, executor, modules) {
                if !allowed.iter().any(|(known, _)| *known == name) {
                    complaints.push(format!("src/{name}:{line}: take a `dyn Executor` instead"));
                }
                idle.remove(name);
            }
        }
        assert!(idle.is_empty(), "files that do not name `{executor}` any more: {idle:?}");
    }
    assert!(complaints.is_empty(), "executors named:\n{}", complaints.join("\n"));
    let named = |text: &str| executors_named(text, "Renderer", &["render"]).len();
    assert_eq!(named("use crate::render::{Gpu, Renderer};"), 1);
    assert_eq!(named("fn f() { chiaro::render::Renderer::new(gpu) }"), 1);
    assert_eq!(named("use chiaro_render as render; use crate::render::{self, Gpu};"), 0);
    assert_eq!(named("use eframe::Renderer; // render::Renderer"), 0);
}

/// Names of stages and passes, and the files that may say them beside the table of passes.
const KINDS_OF_PASSES: &[(&str, &[&str])] =
    &[("Stage", &["Draw", "Normals", "DetailNormals", "Eval"]), ("PassId", &["named"])];
const SAYS_A_STAGE: &[(&str, &str)] = &[("scene/frame/samples.rs", "compiles for samples")];

#[test]
fn nobody_tells_passes_apart_by_their_kinds() {
    let (src, files) = sources();
    let mut complaints = Vec::new();
    for path in files.iter().filter(|path| !path.starts_with("compiler/library/passes")) {
        let name = path.to_str().expect("sources have plain names");
        if SAYS_A_STAGE.iter().any(|(known, _)| *known == name) {
            continue;
        }
        let text = fs::read_to_string(src.join(path)).expect("a source is UTF-8");
        for (of, kinds) in KINDS_OF_PASSES {
            complaints.extend(scan::members(&text, of).into_iter().filter_map(|found| {
                let Reference::Module(member) = &found.reference else { return None };
                let is_kind = kinds.contains(&member.as_str());
                is_kind.then(|| {
                    format!("src/{name}:{}: ask the row in place of {}", found.line, found.path)
                })
            }));
        }
    }
    assert!(complaints.is_empty(), "kinds of passes:\n{}", complaints.join("\n"));
}

/// Cargo finds no test program by itself, because one belongs to another package; so a test program
/// that no manifest names would never run.
#[test]
fn every_test_program_is_of_one_package() {
    let manifests = ["Cargo.toml", "src/compiler/Cargo.toml"]
        .map(|path| fs::read_to_string(support::root().join(path)).expect("a manifest"));
    let mut count = 0;
    for entry in fs::read_dir(support::root().join("tests")).expect("there are tests").flatten() {
        if !entry.path().join("main.rs").is_file() {
            continue;
        }
        let path = format!("tests/{}/main.rs\"", entry.file_name().display());
        let times: usize = manifests.iter().map(|text| text.matches(&path).count()).sum();
        assert_eq!(times, 1, "{path} is a target of {times} packages");
        count += 1;
    }
    assert!((2..=9).contains(&count), "{count} test programs; at most 9 are linked in good time");
}

#[test]
fn crates_stand_on_those_below() {
    let (src, _) = sources();
    let mut complaints = Vec::new();
    let mut count = 0;
    for entry in fs::read_dir(&src).expect("there are sources").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let Ok(manifest) = fs::read_to_string(entry.path().join("Cargo.toml")) else { continue };
        assert!(CRATES.iter().any(|(known, _)| *known == name), "CRATES must name `{name}`");
        complaints.extend(check_manifest(&name, &manifest));
        count += 1;
    }
    assert_eq!(count, CRATES.len(), "every crate of CRATES has a manifest");
    assert!(complaints.is_empty(), "manifests that break the floors:\n{}", complaints.join("\n"));
}

/// Every crate says what it is and under which license, and takes version and edition from the
/// workspace; libraries are for registries, and all else says that it is not.
#[test]
fn manifests_say_what_a_registry_asks() {
    let (src, _) = sources();
    for (name, _) in CRATES {
        let manifest = fs::read_to_string(src.join(name).join("Cargo.toml")).expect("a manifest");
        let has = |line: &str| manifest.lines().any(|other| other.starts_with(line));
        for line in ["version", "edition", "rust-version", "license"] {
            assert!(has(&format!("{line}.workspace = true")), "{name}: {line} is the workspace's");
        }
        assert!(has("description = \""), "{name} has no description");
        let is_program = ["cli", "editor", "sweeps"].contains(name);
        let publish = if is_program { "publish = false" } else { "publish.workspace = true" };
        assert!(has(publish), "{name}: `{publish}`");
    }
}

#[cfg(test)]
mod rules {
    use super::*;

    fn check(path: &str, text: &str) -> Vec<String> {
        check_source(Path::new(path), text)
    }

    #[test]
    fn down_is_fine() {
        let text = "use crate::{document::Look, ids::{self, NodePath}};\n\
                    use crate::compile::emit::Map;\nuse wgpu::Device;";
        assert_eq!(check("compiler/compile/mod.rs", text), [""; 0]);
        assert_eq!(check("render/passes/mod.rs", text), [""; 0]);
        assert_eq!(check("lib.rs", "pub use crate::editor::run;"), [""; 0]);
        assert_eq!(check("compiler/lib.rs", "pub use crate::compile::run;"), [""; 0]);
    }

    #[test]
    fn up_and_sideways_are_named_with_their_place() {
        assert_eq!(
            check(
                "scene/hcbtf/file.rs",
                "use crate::ids::NodeId;\n\nuse crate::{\n    diag,\n    frame::Plan,\n};"
            ),
            ["src/scene/hcbtf/file.rs:5: `crate::frame`: `hcbtf` (floor 1) reaches up to \
                 `frame` (floor 2)"]
        );
        let sideways = check("scene/geometry/mod.rs", "fn f() { crate::directions::run() }");
        assert_eq!(sideways.len(), 1);
        assert!(sideways[0].contains("share floor 1"), "{sideways:?}");
    }

    #[test]
    fn floors_have_an_order() {
        assert_eq!(
            check("scene/frame/mod.rs", "use crate::{compile::X, geometry::Y, directions::Z};"),
            [""; 0]
        );
        assert_eq!(check("scene/hcbtf/mod.rs", "use crate::frame::Plan;").len(), 1);
        assert_eq!(check("compiler/library/mod.rs", "use crate::document::Look;"), [""; 0]);
        assert_eq!(check("compiler/document/mod.rs", "use crate::library::NodeDef;").len(), 1);
        assert_eq!(check("compiler/library/mod.rs", "use crate::interp::Value;"), [""; 0]);
        assert_eq!(check("language/ids.rs", "use crate::diag::Diagnostic;").len(), 1);
    }

    #[test]
    fn the_editor_has_floors_of_its_own() {
        assert_eq!(check("editor/panels/history.rs", "use crate::state::Session;"), [""; 0]);
        assert_eq!(check("editor/app/mod.rs", "use crate::{panels, commands::Command};"), [""; 0]);
        assert_eq!(check("editor/state/still.rs", "use crate::panels::stack;").len(), 1);
        assert_eq!(check("editor/canvas/mod.rs", "use crate::viewport::Viewport;").len(), 1);
        assert_eq!(
            check("editor/state/settings.rs", "use eframe::egui;"),
            ["src/editor/state/settings.rs:1: `eframe::egui`: `state` may not know `eframe`"]
        );
        assert!(
            check("editor/widgets/rows.rs", "use crate::state::orbit;")[0]
                .contains("`widgets` may not know `state`")
        );
        assert_eq!(check("editor/widgets/rows.rs", "use eframe::egui;"), [""; 0]);
    }

    #[test]
    fn the_whole_crate_is_refused() {
        assert!(check("compiler/catalog/mod.rs", "use crate::*;")[0].contains("whole crate"));
        assert!(check("compiler/catalog/mod.rs", "use crate as root;")[0].contains("whole crate"));
        assert!(check("language/ids.rs", "use super::*;")[0].contains("whole crate"));
    }

    #[test]
    fn climbing_by_super_counts_too() {
        let of = |text: &str| check("scene/hcbtf/fill/mod.rs", text);
        assert_eq!(of("use super::super::frame::Plan;").len(), 1);
        assert_eq!(of("use super::check; mod tests { use super::super::check; }"), [""; 0]);
        assert_eq!(
            check("scene/hcbtf/mod.rs", "mod tests { use super::super::frame::Plan; }").len(),
            1
        );
        assert_eq!(check("scene/hcbtf/fill.rs", "use super::{super::frame::run, check};").len(), 1);
    }

    #[test]
    fn packages_are_kept_to_their_crates() {
        let manifest = "[package]\nname = \"x\"\n[dependencies]\nwgpu.workspace = true\nclap = \
                        { workspace = true }\n";
        assert_eq!(
            check_manifest("compiler", manifest),
            [
                "src/compiler/Cargo.toml: `wgpu` belongs to render, editor only",
                "src/compiler/Cargo.toml: `clap` belongs to cli only"
            ]
        );
        assert_eq!(
            check_manifest("editor", "[dependencies]\nchiaro-sweeps.workspace = true"),
            ["src/editor/Cargo.toml: `chiaro-sweeps` belongs to cli only"]
        );
        assert!(
            check_manifest("scene", "[dev-dependencies]\negui = \"1\"")[0].contains("editor only")
        );
        assert_eq!(
            check_manifest("scene", "[features]\negui = []\n[dependencies]\nserde = \"1\""),
            [""; 0]
        );
    }

    #[test]
    fn crates_depend_downward() {
        let manifest = "[dependencies]\nchiaro-render = \
                        { workspace = true }\nchiaro-language.workspace = true";
        assert_eq!(
            check_manifest("scene", manifest),
            ["src/scene/Cargo.toml: `scene` stands below `render`"]
        );
        assert_eq!(check_manifest("editor", manifest), [""; 0]);
    }

    #[test]
    fn the_reference_is_not_built_on_the_compiler() {
        assert!(
            check("reference/lib.rs", "use chiaro_compiler::{compile, library};")[0]
                .contains("may not be built")
        );
        assert!(
            check("reference/eval.rs", "use chiaro_compiler::compile::Look;")[0]
                .contains("may not be built")
        );
        assert!(
            check("reference/eval.rs", "use chiaro_compiler::*;")[0].contains("may not be built")
        );
        assert_eq!(check("reference/lib.rs", "use chiaro_compiler::{document, library};"), [""; 0]);
    }

    #[test]
    fn main_only_hands_over() {
        assert_eq!(check("main.rs", "use chiaro::{cli, editor::run};"), [""; 0]);
        assert_eq!(check("main.rs", "fn main() { chiaro::compile::run(); }").len(), 1);
    }
}
