//! Field that asks for a file by its path, in the window itself: for systems that show no file
//! dialog, and for users who would rather type.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use chiaro_locale::tr;
use eframe::egui::{
    Button, Context, Frame, Id, Key, Label, Margin, Modal, RichText, Role, ScrollArea, TextEdit,
    Ui, WidgetInfo, text::CCursor, text::CCursorRange,
};

use crate::commands::FilePurpose;
use crate::diag::Diagnostic;
use crate::state::problem_text::sentence;
use crate::widgets::confirm;
use crate::widgets::theme;

/// Largest number of a folder's entries that are read.
const MOST_ENTRIES: usize = 4000;
/// Number of rows that are seen at once.
const ROWS: f32 = 7.0;
/// Width of the field, in points.
const WIDTH: f32 = 520.0;

/// A path that is being typed.
pub(crate) struct PathField {
    pub(crate) purpose: FilePurpose,
    /// True if the field stands in for a dialog that the system does not have.
    stands_in: bool,
    text: String,
    is_new: bool,
    /// Path that nothing could be written to, and the reason.
    refused: Option<(PathBuf, String)>,
    /// Entries of the folder, and the text that they were found for.
    beside: Option<(String, Vec<Entry>)>,
}

/// A file or a folder whose name begins as the typed one.
struct Entry {
    name: String,
    is_folder: bool,
}

/// Effect of a typed path.
#[derive(Debug, PartialEq, Eq)]
enum PathEffect {
    /// A file that can be read, or written anew.
    Good,
    /// An existing file that would be replaced.
    Replaces,
    /// A folder, to go into.
    Folder,
    /// An unusable path, with the reason.
    Bad(&'static str),
}

impl PathField {
    /// Asks for a file, beginning at a path.
    pub(crate) fn new(purpose: FilePurpose, path: &Path, stands_in: bool) -> Self {
        let text = path.display().to_string();
        Self { purpose, stands_in, text, is_new: true, refused: None, beside: None }
    }

    /// Asks again, since nothing could be written to a path.
    pub(crate) fn refused(mut self, path: &Path, problem: &Diagnostic) -> Self {
        // A look beside a scene has another file than the one that was asked for.
        let file = problem.place.file.clone().unwrap_or_else(|| path.display().to_string());
        let reason = format!("{}\n{}", tr!("Not saved: {file}"), sentence(problem));
        self.refused = Some((path.to_owned(), reason));
        self
    }

    /// Shows the field. Returns the chosen path, or `Some(None)` when the user cancels.
    pub(crate) fn show(&mut self, ctx: &Context) -> Option<Option<PathBuf>> {
        let mut answer = None;
        let frame = Frame::popup(&ctx.global_style()).inner_margin(Margin::same(14));
        let modal = Modal::new(Id::unique("path field")).frame(frame).show(ctx, |ui| {
            ui.spacing_mut().item_spacing.y = 8.0;
            ui.set_width(WIDTH.min(ctx.content_rect().width() - 60.0));
            ui.heading(title(self.purpose));
            if self.stands_in {
                ui.label(
                    RichText::new(tr!("This system shows no file dialog, so type the path here."))
                        .color(theme::of(ui).dim),
                );
            }
            let confirms = confirm::enters(ui);
            let enters = self.field(ui) || confirms;
            let opens = ui.scope(|ui| self.entries(ui)).inner;
            let path = self.path();
            let verdict = verdict(self.purpose, &path);
            let refused = self.refused.as_ref().filter(|(refused, _)| *refused == path);
            let reason = match verdict {
                PathEffect::Bad(reason) => reason,
                _ if self.purpose.is_folder() && !path.exists() => tr!("The folder will be made"),
                PathEffect::Replaces => tr!("There is such a file; it would be replaced"),
                PathEffect::Good | PathEffect::Folder => "",
            };
            match refused {
                // Long paths take several lines, so that all of the reason is seen.
                Some((_, reason)) => {
                    ui.add(Label::new(RichText::new(reason).color(theme::of(ui).error)).wrap())
                }
                None => ui.label(RichText::new(reason).color(theme::of(ui).warning)),
            };
            self.files_along(ui);
            ui.horizontal(|ui| {
                let label = match (&verdict, self.purpose.writes()) {
                    _ if self.purpose.is_folder() => tr!("Export here"),
                    (PathEffect::Replaces, _) => tr!("Replace the file"),
                    (_, true) => tr!("Save here"),
                    (_, false) => tr!("Open this"),
                };
                let is_file = matches!(verdict, PathEffect::Good | PathEffect::Replaces);
                if ui.add_enabled(is_file, Button::new(label)).clicked()
                    || enters && is_file
                    || opens && verdict == PathEffect::Good
                {
                    answer = Some(Some(path));
                }
                if ui.button(tr!("Cancel")).clicked() {
                    answer = Some(None);
                }
            });
            match verdict {
                PathEffect::Folder if enters => self.go_into(),
                // It is typed again.
                PathEffect::Bad(_) if enters => self.is_new = true,
                _ => {}
            }
        });
        if modal.should_close() {
            answer = Some(None);
        }
        answer
    }

    /// Shows the choice whether the files of a look or a scene go along into another folder.
    fn files_along(&mut self, ui: &mut Ui) {
        let [without, with] = match self.purpose {
            FilePurpose::Save | FilePurpose::SaveWithFiles => {
                [FilePurpose::Save, FilePurpose::SaveWithFiles]
            }
            FilePurpose::SaveScene | FilePurpose::SaveSceneWithFiles => {
                [FilePurpose::SaveScene, FilePurpose::SaveSceneWithFiles]
            }
            _ => return,
        };
        let mut is_along = self.purpose == with;
        let help = tr!(
            "In another folder: files that lie with the document are copied with it; all others \
             are used where they are"
        );
        if ui.checkbox(&mut is_along, tr!("Copy its files along")).on_hover_text(help).changed() {
            self.purpose = if is_along { with } else { without };
        }
    }

    /// Shows the text field. Returns true if Enter was pressed in it.
    fn field(&mut self, ui: &mut Ui) -> bool {
        let edit = TextEdit::singleline(&mut self.text)
            .desired_width(f32::INFINITY)
            .font(eframe::egui::TextStyle::Monospace);
        let response = ui.add(edit);
        response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, tr!("Path")));
        if std::mem::take(&mut self.is_new) {
            response.request_focus();
            let end = CCursor::new(self.text.chars().count());
            let mut state = TextEdit::load_state(ui.ctx(), response.id).unwrap_or_default();
            state.cursor.set_char_range(Some(CCursorRange::one(end)));
            state.store(ui.ctx(), response.id);
        }
        response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
    }

    /// Shows the folders and files that begin as the typed name; a click takes one. Returns true if
    /// the one that was taken is clicked again.
    fn entries(&mut self, ui: &mut Ui) -> bool {
        // Once a file is taken the list stays, so that a second click meets the same file.
        if self.beside.as_ref().is_none_or(|(of, _)| *of != self.text) {
            self.beside = Some((self.text.clone(), entries(self.purpose, &self.text)));
        }
        let Some((_, entries)) = &self.beside else { return false };
        let (mut taken, mut opens) = (None, false);
        ui.spacing_mut().item_spacing.y = 1.0;
        let height = ui.spacing().interact_size.y;
        let area =
            ScrollArea::vertical().max_height(ROWS * height).min_scrolled_height(ROWS * height);
        area.auto_shrink([false, false]).show_rows(ui, height, entries.len(), |ui, rows| {
            for entry in &entries[rows] {
                let name =
                    if entry.is_folder { format!("{}/", entry.name) } else { entry.name.clone() };
                let color = if entry.is_folder { theme::of(ui).accent } else { theme::of(ui).text };
                let row = ui.add(Button::new(RichText::new(name).color(color)).frame(false));
                opens |= row.double_clicked() && !entry.is_folder;
                if row.clicked() {
                    taken = Some((entry.name.clone(), entry.is_folder));
                }
            }
        });
        if let Some((name, is_folder)) = taken {
            let (folder, _) = split(&self.text);
            self.text = format!("{folder}{name}");
            self.is_new = true;
            if is_folder {
                self.go_into();
            } else if let Some((of, _)) = &mut self.beside {
                of.clone_from(&self.text);
            }
        }
        opens
    }

    fn go_into(&mut self) {
        if !self.text.ends_with(std::path::is_separator) {
            self.text.push(std::path::MAIN_SEPARATOR);
        }
        self.is_new = true;
    }

    fn path(&self) -> PathBuf {
        let path = expand(self.text.trim(), std::env::var_os("HOME"));
        if self.text.trim().ends_with(std::path::is_separator) {
            path
        } else {
            self.purpose.complete(path)
        }
    }
}

fn title(purpose: FilePurpose) -> &'static str {
    match purpose {
        FilePurpose::Open => {
            tr!("Open a look, a scene, a shot, a painted surface or a sheet of a wedge")
        }
        FilePurpose::Save => tr!("Save the look"),
        FilePurpose::SaveWithFiles => tr!("Save the look and its files"),
        FilePurpose::SaveScene => tr!("Save the scene"),
        FilePurpose::SaveSceneWithFiles => tr!("Save the scene and its files"),
        FilePurpose::SaveShot => tr!("Save the shot"),
        FilePurpose::SavePainting => tr!("Save the painting"),
        FilePurpose::BakeLook => tr!("Bake the look onto a tile"),
        FilePurpose::ImportPainting(_) => tr!("Import painted pictures"),
        FilePurpose::ExportPainting(..) => tr!("Export the painting"),
        FilePurpose::Mesh => tr!("Show the look on a mesh"),
        FilePurpose::AddMesh => tr!("Add an object of a mesh"),
        FilePurpose::ObjectMesh => tr!("Give the object another mesh"),
        FilePurpose::ObjectLook => tr!("Give the object another look"),
        FilePurpose::Shaders(_) => tr!("Export the look into a folder"),
        FilePurpose::Export(_) => tr!("Save the picture"),
        FilePurpose::Image => tr!("Choose an image"),
        FilePurpose::Reference => tr!("Show an image with the picture"),
        FilePurpose::Comparison => tr!("Compare with a look or a picture"),
        FilePurpose::Frames => tr!("Compare with frames or a document"),
        FilePurpose::FrameFolder => tr!("Render frames into a folder"),
        FilePurpose::LibraryFolder => tr!("Add a shared folder to the library"),
        FilePurpose::Colors => tr!("Take the views of an OpenColorIO configuration"),
    }
}

/// Path with `~` replaced by the user's home.
fn expand(text: &str, home: Option<OsString>) -> PathBuf {
    match (text.strip_prefix("~/"), home) {
        (Some(rest), Some(home)) => PathBuf::from(home).join(rest),
        _ => PathBuf::from(text),
    }
}

fn verdict(purpose: FilePurpose, path: &Path) -> PathEffect {
    let has_folder =
        path.parent().is_some_and(|folder| folder.as_os_str().is_empty() || folder.is_dir());
    match purpose.writes() {
        _ if path.as_os_str().is_empty() => PathEffect::Bad(tr!("Type a path")),
        _ if purpose.is_folder() && path.is_file() => {
            PathEffect::Bad(tr!("This is a file, and no folder"))
        }
        _ if purpose == FilePurpose::LibraryFolder && !path.is_dir() => {
            PathEffect::Bad(tr!("There is no such folder"))
        }
        _ if purpose.is_folder() && !has_folder => {
            PathEffect::Bad(tr!("There is no folder to make this one in"))
        }
        _ if purpose.is_folder() => PathEffect::Good,
        _ if path.is_dir() => PathEffect::Folder,
        false if path.is_file() => PathEffect::Good,
        false => PathEffect::Bad(tr!("There is no such file")),
        true if !has_folder => PathEffect::Bad(tr!("There is no such folder")),
        true if path.exists() => PathEffect::Replaces,
        true => PathEffect::Good,
    }
}

/// Splits a typed path into the folder, with its separator, and the beginning of a name there.
fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    text.split_at(text.rfind(std::path::is_separator).map_or(0, |at| at + 1))
}

/// Entries of a folder that begin as the typed name, or all of them where none does; folders first.
fn entries(purpose: FilePurpose, text: &str) -> Vec<Entry> {
    let (folder, typed) = split(text);
    let folder = if folder.is_empty() {
        PathBuf::from(".")
    } else {
        expand(folder, std::env::var_os("HOME"))
    };
    let typed = typed.to_lowercase();
    let (_, endings) = purpose.files();
    let begins = |name: &str| name.to_lowercase().starts_with(&typed);
    let fits = |name: &str, is_folder: bool| {
        let ending =
            Path::new(name).extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let is_hidden = name.starts_with('.') && !typed.starts_with('.');
        !is_hidden && (is_folder || endings.contains(&ending.to_lowercase().as_str()))
    };
    let found = std::fs::read_dir(folder).into_iter().flatten().take(MOST_ENTRIES).flatten();
    let found = found.map(|entry| Entry {
        name: entry.file_name().to_string_lossy().into_owned(),
        is_folder: entry.path().is_dir(),
    });
    let mut found: Vec<Entry> = found.filter(|entry| fits(&entry.name, entry.is_folder)).collect();
    // A new name matches no entry, and is seen among all that exist.
    if found.iter().any(|entry| begins(&entry.name)) {
        found.retain(|entry| begins(&entry.name));
    }
    found.sort_by_cached_key(|entry| (!entry.is_folder, entry.name.to_lowercase()));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_judged_by_what_is_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::write(path("a.json"), "{}").unwrap();
        std::fs::create_dir(path("inner")).unwrap();
        for (purpose, name, expected) in [
            (FilePurpose::Open, "a.json", PathEffect::Good),
            (FilePurpose::Open, "b.json", PathEffect::Bad("There is no such file")),
            (FilePurpose::Open, "inner", PathEffect::Folder),
            (FilePurpose::Save, "a.json", PathEffect::Replaces),
            (FilePurpose::Save, "b.json", PathEffect::Good),
            (FilePurpose::Save, "no/b.json", PathEffect::Bad("There is no such folder")),
            (FilePurpose::Shaders("all"), "inner", PathEffect::Good),
            (FilePurpose::Shaders("all"), "inner/", PathEffect::Good),
            (FilePurpose::Shaders("all"), "new", PathEffect::Good),
            (
                FilePurpose::Shaders("all"),
                "no/new",
                PathEffect::Bad("There is no folder to make this one in"),
            ),
            (
                FilePurpose::Shaders("all"),
                "a.json",
                PathEffect::Bad("This is a file, and no folder"),
            ),
        ] {
            assert_eq!(verdict(purpose, &path(name)), expected, "{name}");
        }
        assert_eq!(verdict(FilePurpose::Open, Path::new("")), PathEffect::Bad("Type a path"));
    }

    #[test]
    fn entries_begin_as_what_is_typed() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["rim.json", "Rind.json", "rim.png", ".hidden.json", "other.json"] {
            std::fs::write(folder.path().join(name), "{}").unwrap();
        }
        std::fs::create_dir(folder.path().join("rinks")).unwrap();
        let names = |purpose, typed: &str| -> Vec<String> {
            let text = format!("{}/{typed}", folder.path().display());
            entries(purpose, &text).into_iter().map(|entry| entry.name).collect()
        };
        assert_eq!(names(FilePurpose::Open, "ri"), ["rinks", "rim.json", "rim.png", "Rind.json"]);
        assert_eq!(names(FilePurpose::Reference, "rim"), ["rim.png"]);
        assert_eq!(
            names(FilePurpose::Save, "new").len(),
            4,
            "what is new is seen beside what is there"
        );
        assert_eq!(
            names(FilePurpose::Open, "").len(),
            5,
            "a folder is listed whole, but for what is hidden"
        );
        assert_eq!(names(FilePurpose::Open, "."), [".hidden.json"]);
    }

    #[test]
    fn endings_and_homes_are_filled_in() {
        assert_eq!(FilePurpose::Save.complete("/a/rim".into()), PathBuf::from("/a/rim.json"));
        assert_eq!(FilePurpose::Open.complete("/a/rim".into()), PathBuf::from("/a/rim"));
        assert_eq!(expand("~/a", Some("/home/b".into())), PathBuf::from("/home/b/a"));
        assert_eq!(expand("~a", Some("/home/b".into())), PathBuf::from("~a"));
    }
}
