//! `JourneyUser`: a simulated user at a window that draws; `Studio`: a folder for the files made
//! there.

use std::ops::{Deref, DerefMut};
use std::path::{Path, PathBuf};
use std::process::Command;

use chiaro::editor::App;
use eframe::egui::{Context, Key, Modifiers, Pos2, pos2};

use super::picture::Picture;
use crate::editor_support::User;
use crate::support::files;
use crate::support::validators::{ShaderStage, glslang, tint};

/// Width and height of the compared pictures, in pixels.
const SIZE: [u32; 2] = [96, 72];

/// A folder for one journey, which windows are opened in.
pub(super) struct Studio(tempfile::TempDir);

impl Studio {
    pub(super) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub(super) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(super) fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    pub(super) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    /// A new window, with a new look.
    pub(super) fn window(&self) -> JourneyUser {
        let program = Path::new(env!("CARGO_BIN_EXE_chiaro"));
        let prepare = move |app: App, _: &Context| app.without_dialogs().rendering_by(program);
        JourneyUser::at(User::drawing_coarsely(prepare))
    }

    /// A new window in which a look is opened.
    pub(super) fn window_with(&self, look: &Path) -> JourneyUser {
        let mut artist = self.window();
        artist.open(look);
        artist
    }

    /// Runs the program without a window in this folder, asserts success, and gives its output.
    #[track_caller]
    pub(super) fn chiaro(&self, arguments: &[&str]) -> String {
        let program = env!("CARGO_BIN_EXE_chiaro");
        let mut command = Command::new(program);
        command.args(arguments).current_dir(self.0.path()).env("CHIARO_CACHE_DIR", "");
        let output = command.output().unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        assert!(
            output.status.success(),
            "chiaro {arguments:?}: {}{}",
            text(&output.stdout),
            text(&output.stderr)
        );
        text(&output.stdout)
    }

    /// The picture that the program without a window draws of a look.
    #[track_caller]
    pub(super) fn rendered(&self, look: &str, more: &[&str]) -> Picture {
        let size = format!("{}x{}", SIZE[0], SIZE[1]);
        self.chiaro(&[&["render", look, "-o", "rendered.png", "--size", &size], more].concat());
        Picture::read(&self.path("rendered.png"))
    }

    /// Exports a look, has other compilers take the exported files, and gives the WGSL's text.
    #[track_caller]
    pub(super) fn exported(&self, look: &str) -> String {
        self.chiaro(&["export", look, "--to", "wgsl,glsl-es300,glsl-450", "-o", "out"]);
        let written = files::below(&self.path("out"));
        let of = |ending: &str| -> Vec<&PathBuf> {
            written
                .iter()
                .filter(|path| path.extension().is_some_and(|found| found == ending))
                .collect()
        };
        let wgsl = of("wgsl");
        assert!(!wgsl.is_empty() && of("vert").len() >= 2 && of("frag").len() >= 2, "{written:?}");
        tint(&wgsl).unwrap();
        for (ending, stage) in [("vert", ShaderStage::Vertex), ("frag", ShaderStage::Fragment)] {
            for file in of(ending) {
                glslang(&std::fs::read_to_string(file).unwrap(), stage, &[]).unwrap();
            }
        }
        wgsl.iter().map(|path| std::fs::read_to_string(path).unwrap()).collect()
    }

    /// The end of every journey. The look is saved under `name`; another window opens it and shows
    /// the same picture; the program without a window draws that picture too; and other compilers
    /// take the exported files. Gives the exported WGSL.
    #[track_caller]
    pub(super) fn finish(&self, mut artist: JourneyUser, name: &str) -> String {
        let mesh = artist.app().session().view().orbit().mesh.clone();
        artist.save_under(&self.path(name));
        artist.look_from_the_front();
        assert_eq!(
            artist.app().session().view().time(),
            0.0,
            "pictures of files are of their first moment"
        );
        let (look, picture) = (artist.look().clone(), artist.picture());
        assert!(picture.object().count() > 500, "there is something to be seen");
        drop(artist);

        let mut other = self.window();
        other.app_mut().show_on(&mesh);
        other.open(&self.path(name));
        assert_eq!(*other.look(), look, "the file holds what the window held");
        assert!(
            !other.app().session().is_dirty() && other.errors().is_empty(),
            "{:?}",
            other.errors()
        );
        let wgsl = self.exported(name);
        let shows = |drawn: &Picture| {
            if wgsl.contains("texture_2d_array") {
                drawn.is_near(&picture);
            } else {
                drawn.equals(&picture);
            }
        };
        shows(&other.picture());
        drop(other);
        shows(&self.rendered(name, &["--mesh", &mesh]));
        wgsl
    }
}

/// A simulated user at a window that draws.
pub(super) struct JourneyUser(User);

impl Deref for JourneyUser {
    type Target = User;

    fn deref(&self) -> &User {
        &self.0
    }
}

impl DerefMut for JourneyUser {
    fn deref_mut(&mut self) -> &mut User {
        &mut self.0
    }
}

impl JourneyUser {
    pub(super) fn at(hand: User) -> Self {
        Self(hand)
    }

    /// Opens a file by the key and the file dialog.
    pub(super) fn open(&mut self, path: &Path) {
        self.app_mut().answer_dialog(path);
        self.key_with(Modifiers::COMMAND, Key::O);
        self.settle();
        assert_eq!(self.app().session().path(), Some(path), "{:?}", self.app().message());
    }

    /// Saves by the key; a look that has another file or none is saved under `path`.
    #[track_caller]
    pub(super) fn save_under(&mut self, path: &Path) {
        if self.app().session().path() == Some(path) {
            self.key_with(Modifiers::COMMAND, Key::S);
        } else {
            self.app_mut().answer_dialog(path);
            self.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
        }
        self.settle();
        assert!(!self.app().session().is_dirty() && path.is_file(), "{:?}", self.app().message());
    }

    /// Carries out a command by its name in the palette.
    pub(super) fn palette(&mut self, name: &str) {
        self.key_with(Modifiers::COMMAND, Key::P);
        self.type_text(name);
        self.key(Key::Enter);
        self.settle();
    }

    /// A place of the canvas, in parts of its width and height.
    pub(super) fn on_canvas(&self, x: f32, y: f32) -> Pos2 {
        let canvas = self.place("Node canvas");
        pos2(canvas.min.x + x * canvas.width(), canvas.min.y + y * canvas.height())
    }

    /// Adds a node by the search that Tab opens; gives the node's id.
    #[track_caller]
    pub(super) fn add_node(&mut self, at: Pos2, query: &str) -> String {
        self.hover(at);
        self.key(Key::Tab);
        self.type_text(query);
        self.key(Key::Enter);
        self.settle();
        let selected = self.selected();
        assert_eq!(selected.len(), 1, "\"{query}\" added {selected:?}");
        selected.into_iter().next().unwrap()
    }

    /// Gives the selected node a name, on the canvas.
    pub(super) fn name_node(&mut self, name: &str) {
        let at = self.on_canvas(0.5, 0.97);
        self.hover(at);
        self.key(Key::F2);
        self.key_with(Modifiers::COMMAND, Key::A);
        self.type_text(name);
        self.key(Key::Enter);
        self.settle();
    }

    /// Adds a node and names it; gives the node's id.
    #[track_caller]
    pub(super) fn add_named(&mut self, at: Pos2, query: &str, name: &str) -> String {
        let id = self.add_node(at, query);
        self.name_node(name);
        id
    }

    /// Draws a wire between two sockets that are named.
    #[track_caller]
    pub(super) fn wire(&mut self, from: &str, to: &str) {
        let count = self.app().session().graph().wires.clone();
        let (from_at, to_at) = (self.place(from).center(), self.place(to).center());
        self.drag(from_at, to_at);
        self.settle();
        assert_ne!(self.app().session().graph().wires, count, "{from} and {to} are not wired");
    }

    /// Brings the whole graph into view.
    pub(super) fn show_all(&mut self) {
        let at = self.on_canvas(0.5, 0.97);
        self.hover(at);
        self.key(Key::Home);
        self.settle();
    }

    /// Puts camera and lights back to their defaults.
    pub(super) fn look_from_the_front(&mut self) {
        let at = self.app().viewport().rect().unwrap().center();
        self.hover(at);
        self.key(Key::R);
        self.settle();
    }

    /// A small picture of the window's look.
    pub(super) fn picture(&mut self) -> Picture {
        let file = tempfile::Builder::new().suffix(".png").tempfile().unwrap();
        self.app_mut().save_picture(SIZE, file.path());
        self.settle();
        Picture::read(file.path())
    }

    /// Undoes all steps by the key.
    pub(super) fn undo_all(&mut self) {
        let at = self.on_canvas(0.5, 0.97);
        self.hover(at);
        while self.app().session().steps().undo_label().is_some() {
            let before = self.steps();
            self.key_with(Modifiers::COMMAND, Key::Z);
            assert_eq!(self.steps() + 1, before);
        }
        self.settle();
    }
}
