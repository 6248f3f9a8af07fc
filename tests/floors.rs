//! The house stands: a module of `src/` imports only from floors below its own.
//!
//! The test reads every source file, comments and strings left out, and follows each path that starts at the crate's
//! root, whether it says `crate::` or climbs there by `super::`. Test code inside `src/` is held to the same rule.

#[path = "floors/scan.rs"]
mod scan;
mod support;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use scan::Reference;

/// The floors of `docs/decisions.md`, lowest first. A module may import from any line above its own here, and from
/// itself; never from its own line or a line below.
///
/// The half floors hold what stands on a neighbour of the same floor: a diagnostic names nodes by their ids, a milestone
/// has a time, a group that the library ships is a document, a drawing shows what the catalog knows, and a frame plan
/// joins what the rest of floor 3 makes.
const FLOORS: &[(&str, &[&str])] = &[
    ("0", &["base64", "clock", "examples", "figures", "ids", "math", "threads"]),
    ("0½", &["diag", "milestones"]),
    ("1", &["wgsl"]),
    ("2", &["document", "interp"]),
    ("2½", &["library"]),
    ("3", &["catalog", "compile", "directions", "geometry", "hcbtf"]),
    ("3½", &["drawing", "frame"]),
    ("4", &["export", "reference", "render"]),
    ("5", &["accuracy", "fit"]),
    ("5½", &["gallery"]),
    ("6", &["cli", "editor"]),
];

/// Imports that the floors would allow and that would make a proof worthless: the reference judges the compiler's
/// output, so it must not be built on the compiler.
const APART: &[(&str, &str)] = &[("reference", "compile")];

/// Crates that belong to some modules only: the compiler is to build without a GPU and without a window.
const KEPT_TO: &[(&str, &[&str])] = &[
    ("wgpu", &["render", "accuracy", "editor"]),
    ("egui", &["editor"]),
    ("egui_extras", &["editor"]),
    ("eframe", &["editor"]),
    ("rfd", &["editor"]),
    ("notify", &["editor"]),
];

/// The rank of a module's floor, and the floor's name.
fn floor_of(module: &str) -> Option<(usize, &'static str)> {
    FLOORS.iter().enumerate().find(|(_, (_, modules))| modules.contains(&module)).map(|(rank, (name, _))| (rank, *name))
}

/// What is wrong with `reference` standing in the top-level module `importer`, if anything.
fn complaint(importer: &str, reference: &Reference) -> Option<String> {
    let imported = match reference {
        Reference::Module(name) => name.as_str(),
        Reference::WholeCrate => return Some("takes in the whole crate; name the module".into()),
        Reference::Crate(name) => {
            let (_, owners) = KEPT_TO.iter().find(|(kept, _)| kept == name)?;
            let wrong = !owners.contains(&importer);
            return wrong.then(|| format!("`{name}` belongs to {} only", owners.join(", ")));
        }
    };
    if imported == importer {
        return None;
    }
    let Some((upper, upper_name)) = floor_of(imported) else {
        return Some(format!("`{imported}` stands on no floor; add it to FLOORS in tests/floors.rs"));
    };
    let (own, own_name) = floor_of(importer)?;
    if upper > own {
        return Some(format!("`{importer}` (floor {own_name}) reaches up to `{imported}` (floor {upper_name})"));
    }
    if upper == own {
        return Some(format!("`{importer}` and `{imported}` share floor {own_name} and may not know each other"));
    }
    APART.contains(&(importer, imported)).then(|| format!("`{importer}` may not be built on `{imported}`"))
}

/// Everything wrong with the source `text` of the file at `path`, relative to `src/`.
fn check_source(path: &Path, text: &str) -> Vec<String> {
    let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy().into_owned()).collect();
    let Some(top) = parts.first().map(|first| first.trim_end_matches(".rs")) else { return Vec::new() };
    let depth = parts.len() - usize::from(parts.len() > 1 && parts.last().is_some_and(|last| last == "mod.rs"));
    match (parts.len(), top) {
        // The root declares the modules, so it may name them all.
        (1, "lib") => return Vec::new(),
        (1, "main") => return check_main(text),
        _ => {}
    }
    scan::references(text, depth)
        .into_iter()
        .filter_map(|found| {
            let complaint = complaint(top, &found.reference)?;
            Some(format!("src/{}:{}: `{}`: {complaint}", path.display(), found.line, found.path))
        })
        .collect()
}

/// The program only hands over: it may know `chiaro::cli` and `chiaro::editor`, and nothing else of the library.
fn check_main(text: &str) -> Vec<String> {
    scan::crate_paths(text, "chiaro")
        .into_iter()
        .filter(|found| !matches!(&found.reference, Reference::Module(name) if name == "cli" || name == "editor"))
        .map(|found| format!("src/main.rs:{}: `{}`: main hands over to cli or editor only", found.line, found.path))
        .collect()
}

/// The folder of the sources, and every `.rs` file in it with its path from there.
fn sources() -> (PathBuf, Vec<PathBuf>) {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let rust = support::files::below(&src).into_iter().filter(|path| path.extension().is_some_and(|name| name == "rs"));
    let files = rust.map(|path| path.strip_prefix(&src).expect("it was found there").to_path_buf()).collect();
    (src, files)
}

#[test]
fn imports_go_down() {
    let (src, files) = sources();
    assert!(files.len() > 2, "src/ holds more than its roots");
    let complaints: Vec<_> = files
        .iter()
        .flat_map(|path| check_source(path, &fs::read_to_string(src.join(path)).expect("a source is UTF-8")))
        .collect();
    assert!(complaints.is_empty(), "imports that break the floors:\n{}", complaints.join("\n"));
}

#[test]
fn every_module_stands_on_one_floor() {
    let (_, files) = sources();
    let roots: BTreeSet<_> = files
        .iter()
        .filter_map(|path| path.iter().next())
        .map(|first| first.to_string_lossy().trim_end_matches(".rs").to_owned())
        .filter(|root| root != "lib" && root != "main")
        .collect();
    for root in &roots {
        let count = FLOORS.iter().filter(|(_, modules)| modules.contains(&root.as_str())).count();
        assert_eq!(count, 1, "`{root}` stands on {count} floors; FLOORS in tests/floors.rs must name it once");
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
        let text =
            "use crate::{diag::Diagnostic, ids::{self, NodePath}};\nuse crate::compile::emit::Map;\nuse wgpu::Device;";
        assert_eq!(check("render/mod.rs", text), [""; 0]);
        assert_eq!(check("lib.rs", "pub use crate::editor::run;"), [""; 0]);
    }

    #[test]
    fn up_and_sideways_are_named_with_their_place() {
        assert_eq!(
            check("compile/emit.rs", "use crate::ids::NodeId;\n\nuse crate::{\n    diag,\n    render::Device,\n};"),
            ["src/compile/emit.rs:5: `crate::render`: `compile` (floor 3) reaches up to `render` (floor 4)"]
        );
        let sideways = check("geometry/mod.rs", "fn f() { crate::compile::run() }");
        assert_eq!(sideways.len(), 1);
        assert!(sideways[0].contains("share floor 3"), "{sideways:?}");
    }

    #[test]
    fn half_floors_have_an_order() {
        assert_eq!(check("frame/mod.rs", "use crate::{compile::X, geometry::Y, directions::Z};"), [""; 0]);
        assert_eq!(check("compile/mod.rs", "use crate::frame::Plan;").len(), 1);
        assert_eq!(check("library/mod.rs", "use crate::document::Look;"), [""; 0]);
        assert_eq!(check("document/mod.rs", "use crate::library::NodeDef;").len(), 1);
        assert_eq!(check("library/mod.rs", "use crate::interp::Value;"), [""; 0]);
        assert_eq!(check("ids.rs", "use crate::diag::Diagnostic;").len(), 1);
    }

    #[test]
    fn unknown_modules_and_the_whole_crate_are_refused() {
        assert!(check("cli/mod.rs", "use crate::util::x;")[0].contains("no floor"));
        assert!(check("cli/mod.rs", "use crate::*;")[0].contains("whole crate"));
        assert!(check("cli/mod.rs", "use crate as root;")[0].contains("whole crate"));
        assert!(check("ids.rs", "use super::*;")[0].contains("whole crate"));
    }

    #[test]
    fn climbing_by_super_counts_too() {
        assert_eq!(check("compile/emit/mod.rs", "use super::super::render::Device;").len(), 1);
        assert_eq!(check("compile/emit/mod.rs", "use super::check; mod tests { use super::super::check; }"), [""; 0]);
        assert_eq!(check("compile/mod.rs", "mod tests { use super::super::render::Device; }").len(), 1);
        assert_eq!(check("compile/emit.rs", "use super::{super::cli::run, check};").len(), 1);
    }

    #[test]
    fn crates_are_kept_to_their_modules() {
        assert!(check("compile/mod.rs", "fn f(d: &wgpu::Device) {}")[0].contains("belongs to render"));
        assert_eq!(check("compile/mod.rs", "use naga::{wgpu::x};\nlet wgpu = 1;"), [""; 0]);
        assert!(check("cli/mod.rs", "use egui::Ui;")[0].contains("editor only"));
    }

    #[test]
    fn the_reference_is_not_built_on_the_compiler() {
        assert!(check("reference/mod.rs", "use crate::compile::Look;")[0].contains("may not be built"));
        assert_eq!(check("reference/mod.rs", "use crate::{frame::Plan, interp::Lanes};"), [""; 0]);
    }

    #[test]
    fn main_only_hands_over() {
        assert_eq!(check("main.rs", "use chiaro::{cli, editor::run};"), [""; 0]);
        assert_eq!(check("main.rs", "fn main() { chiaro::compile::run(); }").len(), 1);
    }
}
