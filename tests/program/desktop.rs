//! `chiaro desktop`: desktops accept the files that it writes, it removes all of them again, and it
//! touches no other file.
#![cfg(target_os = "linux")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use chiaro::document::{Directions, Grid, Hcbtf};

/// A user's home, with data of other programs.
struct Home(tempfile::TempDir);

impl Home {
    fn new() -> Self {
        let home = Self(tempfile::tempdir().unwrap());
        for (name, text) in [
            (
                "applications/other.desktop",
                "[Desktop Entry]\nType=Application\nName=Other\nExec=other\n",
            ),
            ("icons/hicolor/scalable/apps/other.svg", "<svg/>"),
            ("notes.txt", "mine"),
        ] {
            let path = home.data().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        home
    }

    fn data(&self) -> PathBuf {
        self.0.path().join("data")
    }

    /// Runs `chiaro desktop` with the desktop's own tools, or with none of them.
    fn run(&self, argument: &str, path: Option<&str>) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command
            .args(["desktop", argument])
            .env("XDG_DATA_HOME", self.data())
            .env("HOME", self.0.path());
        if let Some(path) = path {
            command.env("PATH", path);
        }
        command.output().unwrap()
    }

    /// All files below the data folder, except those that the desktop's tools generate.
    fn files(&self) -> BTreeMap<PathBuf, String> {
        let mut found = BTreeMap::new();
        collect(&self.data(), &mut found);
        found
    }
}

fn collect(folder: &Path, found: &mut BTreeMap<PathBuf, String>) {
    for entry in fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, found);
        } else {
            found.insert(path.clone(), fs::read_to_string(&path).unwrap_or_default());
        }
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn it_installs_and_removes_its_own_files_and_nothing_else() {
    let home = Home::new();
    let before = home.files();
    let printed = home.run("--print", Some(""));
    assert!(printed.status.success());
    assert_eq!(home.files(), before, "printing writes nothing");

    let installed = home.run("--install", Some(""));
    assert!(installed.status.success(), "{}", text(&installed.stderr));
    assert!(
        text(&installed.stderr).contains("next login"),
        "no tool is there, and it is said what that means"
    );
    let after = home.files();
    let new: Vec<&PathBuf> = after.keys().filter(|path| !before.contains_key(*path)).collect();
    assert_eq!(new.len(), 3, "{new:?}");
    for path in &new {
        assert!(text(&installed.stdout).contains(path.to_str().unwrap()), "{path:?} is told");
        assert!(text(&printed.stdout).contains(path.to_str().unwrap()), "{path:?} was announced");
        assert!(text(&printed.stdout).contains(after[*path].trim()), "{path:?} is as announced");
    }
    assert!(before.iter().all(|(path, text)| after.get(path) == Some(text)));
    let entry = &after[&home.data().join("applications/chiaro.desktop")];
    let program = fs::canonicalize(env!("CARGO_BIN_EXE_chiaro")).unwrap();
    assert!(entry.contains(&format!("Exec=\"{}\" edit %f", program.display())), "{entry}");

    // Installing again changes nothing.
    assert!(home.run("--install", Some("")).status.success());
    assert_eq!(home.files(), after);
    let removed = home.run("--remove", Some(""));
    assert!(removed.status.success());
    assert_eq!(home.files(), before);
    assert!(home.run("--remove", Some("")).status.success(), "nothing to remove is no error");
}

#[test]
fn what_is_wanted_must_be_said() {
    let home = Home::new();
    let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
    let none = command.arg("desktop").env("XDG_DATA_HOME", home.data()).output().unwrap();
    assert_eq!(none.status.code(), Some(2));
    assert!(text(&none.stderr).contains("--install"));
}

/// Runs one of the desktop's tools; `None` if it is not installed.
fn tool(name: &str, arguments: &[&Path], data: &Path) -> Option<Output> {
    Command::new(name).args(arguments).env("XDG_DATA_HOME", data).output().ok()
}

#[test]
fn desktops_take_what_is_written() {
    let home = Home::new();
    assert!(home.run("--install", None).status.success());
    let entry = home.data().join("applications/chiaro.desktop");
    if let Some(judged) = tool("desktop-file-validate", &[&entry], &home.data()) {
        assert!(judged.status.success(), "{}{}", text(&judged.stdout), text(&judged.stderr));
    }
    // A look, a scene and a painted surface are recognized by their types, and other JSON is left
    // to other programs.
    if !home.data().join("mime/mime.cache").is_file() {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let plain = home.0.path().join("plain.json");
    fs::write(&plain, r#"{"a": [1, 2]}"#).unwrap();
    let directions = Directions { theta: 1, phi: 1 };
    let grid = Grid { size: [2, 2], light: directions, view: directions };
    let painting = home.0.path().join("grass.hcbtf");
    fs::write(&painting, chiaro::hcbtf::write(&Hcbtf::new(grid)).unwrap()).unwrap();
    for (file, expected) in [
        (painting, "application/vnd.chiaro.hcbtf+zip"),
        (root.join("looks/figure1-layers.json"), "application/vnd.chiaro.look+json"),
        (root.join("scenes/cast.json"), "application/vnd.chiaro.scene+json"),
        (plain, "application/json"),
    ] {
        let what = Path::new("info");
        let Some(told) = tool(
            "gio",
            &[what, Path::new("-a"), Path::new("standard::content-type"), &file],
            &home.data(),
        ) else {
            return;
        };
        assert!(text(&told.stdout).contains(expected), "{file:?}: {}", text(&told.stdout));
    }
    assert!(home.run("--remove", None).status.success());
    assert!(!entry.exists());
}
