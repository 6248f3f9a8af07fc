//! Looks are exported from the window as shaders: the files that the menus write and the text that
//! they copy are those of `chiaro export`, byte for byte.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::editor_support::User;
use crate::editor_support::home::Home;
use chiaro::document::{Edit, GraphId, Look};
use chiaro::editor::App;
use eframe::egui::{Key, Modifiers, Role};

const MENU: [(&str, &str); 9] = [
    ("Export to all languages...", "all"),
    ("Export to WGSL, for WebGPU...", "wgsl"),
    ("Export to GLSL ES 3.00, for WebGL 2...", "glsl-es300"),
    ("Export to GLSL 3.30, for OpenGL 3.3...", "glsl-330"),
    ("Export to GLSL 4.50, for OpenGL 4.5...", "glsl-450"),
    ("Export to HLSL, for Direct3D 12...", "hlsl"),
    ("Export to Slang...", "slang"),
    ("Export to Metal Shading Language...", "msl"),
    ("Export to SPIR-V, for Vulkan...", "spirv"),
];

/// A window with a file open that asks for paths by its own fields.
fn window(file: &Path) -> User {
    let file = file.to_owned();
    User::with(move |ctx| {
        let mut app = App::new(ctx, None).with_path_fields();
        app.open(&file);
        app
    })
}

/// A copy of an example in the user's folder, under another name.
fn example(home: &Home, name: &str) -> std::path::PathBuf {
    let path = home.file("rim.json");
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks").join(name);
    fs::copy(example, &path).unwrap();
    path
}

/// Every file of a folder: its name and its bytes.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .flatten();
    entries
        .map(|entry| {
            (entry.file_name().to_string_lossy().into_owned(), fs::read(entry.path()).unwrap())
        })
        .collect()
}

/// Files that the program without a window exports.
#[track_caller]
fn exported(look: &Path, language: &str) -> BTreeMap<String, Vec<u8>> {
    let folder = tempfile::tempdir().unwrap();
    let mut program = Command::new(env!("CARGO_BIN_EXE_chiaro"));
    let ran = program
        .arg("export")
        .arg(look)
        .args(["--to", language, "-o"])
        .arg(folder.path())
        .env("CHIARO_CACHE_DIR", "")
        .output()
        .unwrap();
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    files(folder.path())
}

fn told(hand: &User) -> &str {
    hand.app().message().unwrap_or_default()
}

#[track_caller]
fn is_same(found: &BTreeMap<String, Vec<u8>>, wanted: &BTreeMap<String, Vec<u8>>, what: &str) {
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(found), names(wanted), "{what}");
    for (name, bytes) in wanted {
        assert!(found[name] == *bytes, "{what}: {name} is another");
    }
}

#[test]
fn the_menu_exports_what_the_program_does() {
    let home = Home::new();
    let look = example(&home, "figure5-directional.json");
    let mut hand = window(&look);
    for (item, language) in MENU {
        let folder = home.file(&format!("out-{language}"));
        hand.press("Export");
        hand.press(item);
        assert!(hand.says("Export the look into a folder"), "{language}");
        let field = hand.text_field("Path");
        hand.type_over(field, folder.to_str().unwrap());
        assert!(!hand.says("Export the look into a folder"), "{language}");
        assert!(
            told(&hand).starts_with("Exported ") && told(&hand).contains(folder.to_str().unwrap()),
            "{}",
            told(&hand)
        );
        assert_eq!(
            told(&hand).contains("unverified"),
            ["all", "msl"].contains(&language),
            "{}",
            told(&hand)
        );
        is_same(&files(&folder), &exported(&look, language), language);
    }
    assert!(!hand.app().session().is_dirty(), "nothing was done to the look");
}

#[test]
fn what_is_not_saved_is_exported_and_the_looks_own_folder_does_no_harm() {
    let home = Home::new();
    let look = example(&home, "figure1-layers.json");
    let text = fs::read_to_string(&look).unwrap();
    let mut hand = window(&look);
    hand.press("Layer Back-light");
    hand.set("Cut-off", "40");
    // The suggested place is a new folder beside the look.
    hand.press("Export");
    hand.press("Export to WGSL, for WebGPU...");
    assert!(hand.says("The folder will be made"));
    hand.press("Export here");
    let own = home.file("rim-shaders");
    let unsaved = files(&own);
    assert!(!unsaved.is_empty() && unsaved != exported(&look, "wgsl"), "{:?}", unsaved.keys());

    // In the look's own folder the export's description would overwrite the look; so a folder of
    // its own is suggested again.
    fs::remove_dir_all(&own).unwrap();
    hand.app_mut().answer_dialog(look.parent().unwrap());
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text("export wgsl");
    hand.key(Key::Enter);
    hand.settle();
    is_same(&files(&own), &unsaved, "the palette");
    assert!(told(&hand).contains("rim-shaders"), "{}", told(&hand));
    assert_eq!(fs::read_to_string(&look).unwrap(), text, "the look is as it was");

    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    is_same(&files(&own), &exported(&look, "wgsl"), "what was exported is what is saved now");
    let saved = Look::load(&chiaro::files::Disk, &look);
    assert_eq!(saved.value.as_ref(), Some(hand.look()));
}

#[test]
fn of_a_scene_the_open_look_is_exported() {
    let home = Home::new();
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes/cast.json");
    let mut hand = window(&scene);
    let look = hand.app().session().path().expect("a scene opens one of its looks").to_owned();
    let folder = home.file("out");
    hand.app_mut().answer_dialog(&folder);
    hand.press("Export");
    hand.press("Export to all languages...");
    is_same(&files(&folder), &exported(&look, "all"), "the open look");
}

#[test]
fn what_cannot_be_exported_says_where_and_why() {
    let home = Home::new();
    let look = example(&home, "figure1-layers.json");
    let mut hand = window(&look);
    // A file is no folder.
    hand.app_mut().answer_dialog(&look);
    hand.press("Export");
    hand.press("Export to WGSL, for WebGPU...");
    assert!(
        told(&hand).starts_with("Not exported: ") && told(&hand).contains("rim.json"),
        "{}",
        told(&hand)
    );
    let edit = Edit::SetKind {
        graph: GraphId::Look,
        id: "specular".into(),
        kind: "nothing_such".to_owned(),
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    let folder = home.file("out");
    hand.app_mut().answer_dialog(&folder);
    hand.press("Export");
    hand.press("Export to all languages...");
    assert!(
        told(&hand).starts_with("Not exported: ") && told(&hand).contains("node specular"),
        "{}",
        told(&hand)
    );
    assert!(!folder.exists(), "nothing is left behind");
}

/// Presses a menu's item and waits for a text to come to the clipboard.
fn copied(hand: &mut User, item: &str) -> Option<String> {
    hand.press("Copy as");
    let at = hand.place(item).center();
    hand.click(at);
    hand.settle();
    hand.take_copied()
}

#[test]
fn copy_as_has_the_same_languages() {
    let home = Home::new();
    let look = example(&home, "figure1-layers.json");
    let all = exported(&look, "all");
    let mut hand = window(&look);
    for (item, file) in [
        ("Copy the fragment shader as GLSL ES 3.00", "rim.es300.frag"),
        ("Copy the vertex shader as GLSL ES 3.00", "rim.es300.vert"),
        ("Copy the fragment shader as GLSL 3.30", "rim.330.frag"),
        ("Copy the vertex shader as GLSL 3.30", "rim.330.vert"),
        ("Copy the fragment shader as GLSL 4.50", "rim.450.frag"),
        ("Copy the vertex shader as GLSL 4.50", "rim.450.vert"),
        ("Copy the shader as HLSL", "rim.hlsl"),
        ("Copy the shader as Slang", "rim.slang"),
        ("Copy the shader as Metal Shading Language", "rim.metal"),
    ] {
        let text = copied(&mut hand, item).unwrap_or_else(|| panic!("{item}: {}", told(&hand)));
        assert!(text.as_bytes() == all[file], "{item} is {file}");
        assert!(
            told(&hand).contains(file) && told(&hand).contains("other passes"),
            "{}",
            told(&hand)
        );
    }
}

#[test]
fn a_card_writes_a_page_that_opens() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().join("page");
    let mut hand = User::drawing();
    hand.press("Export");
    hand.press("Export to a program or a page");
    hand.settle();
    assert!(hand.says("This look has 1 light"), "the look's needs are told");
    assert!(hand.says("three.js") && hand.says("kB"), "cards tell what folders weigh");
    hand.app_mut().answer_dialog(&out);
    hand.bring(Role::Button, "Export for Web page");
    hand.press("Export for Web page");
    hand.settle();
    for file in ["index.html", "player.js", "expected.png", "chiaro.json"] {
        assert!(out.join(file).is_file(), "{file}: {:?}", hand.app().message());
    }
    // What is written once may be written again.
    hand.app_mut().answer_dialog(&out);
    hand.press("Export for Web page");
    hand.settle();
    let told = hand.app().message().unwrap_or_default().to_owned();
    assert!(told.starts_with("Exported") && told.contains("page"), "{told}");
    assert!(!out.join("look-shaders").exists(), "no second folder: {told}");
}
