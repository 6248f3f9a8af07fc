//! The system's file dialogs, which wait on a thread of their own. Where the system has none to
//! show, the window asks for a path itself.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use super::painting::Import;
use super::viewport::Export;
use super::worker::{start, wait};
use crate::clock::Clock;
use crate::document::Storage;
use crate::hcbtf::exchange::Form;

/// What a file is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    Open,
    Save,
    Mesh,
    /// A mesh for one more object.
    AddMesh,
    /// A mesh for the object that is asked for.
    ObjectMesh,
    /// A look for the object that is asked for.
    ObjectLook,
    SaveScene,
    SavePainting,
    /// Pictures of other programs, or a folder of them.
    ImportPainting(Import),
    /// The open look is baked into an HCBTF.
    BakeLook,
    /// What is painted is written for other programs.
    ExportPainting(Form, Storage),
    /// Shaders of a language, or of all, are written into a folder.
    Shaders(&'static str),
    /// A picture is written.
    Export(Export),
    /// An image is shown.
    Reference,
}

/// The endings of meshes that can be read.
pub(crate) const MESHES: [&str; 5] = ["obj", "ply", "stl", "gltf", "glb"];

/// The endings of images that can be read.
pub(crate) const IMAGES: [&str; 5] = ["png", "jpg", "jpeg", "exr", "hdr"];

/// The ending of HCBTFs.
pub(crate) const PAINTING: &str = "hcbtf";

/// A dialog that is over before anybody could have seen it, in seconds, was none: there is no
/// portal and no program that shows one.
const UNSEEN: f64 = 0.35;

impl Purpose {
    /// What such files are called, and their endings.
    pub(crate) fn files(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Open => ("Chiaro look, scene or HCBTF", &["json", PAINTING]),
            Self::Save | Self::ObjectLook => ("Chiaro look", &["json"]),
            Self::SaveScene => ("Chiaro scene", &["json"]),
            Self::SavePainting | Self::BakeLook => ("HCBTF", &[PAINTING]),
            Self::Mesh | Self::AddMesh | Self::ObjectMesh => ("Mesh", &MESHES),
            Self::ImportPainting(Import { form, .. }) | Self::ExportPainting(form, _) => match form
            {
                Form::Folder => ("Folder", &[]),
                Form::Contact | Form::Sheet => ("PNG", &["png"]),
                Form::Ktx2 => ("KTX2", &["ktx2"]),
            },
            Self::Shaders(_) => ("Folder", &[]),
            Self::Export(_) => ("PNG", &["png"]),
            Self::Reference => ("Image", &IMAGES),
        }
    }

    /// Whether the file is written.
    pub(crate) fn writes(self) -> bool {
        let is_file = !self.is_folder();
        is_file
            && matches!(
                self,
                Self::Save
                    | Self::SaveScene
                    | Self::SavePainting
                    | Self::BakeLook
                    | Self::Export(_)
                    | Self::ExportPainting(..)
            )
    }

    /// Whether a folder is asked for; one that is written into is made where there is none.
    pub(crate) fn is_folder(self) -> bool {
        match self {
            Self::Shaders(_) | Self::ExportPainting(Form::Folder, _) => true,
            Self::ImportPainting(import) => import.form == Form::Folder,
            _ => false,
        }
    }

    /// The path with an ending, where one is to be written and has none.
    pub(crate) fn complete(self, mut path: PathBuf) -> PathBuf {
        let (_, endings) = self.files();
        if self.writes() && path.extension().is_none() {
            path.set_extension(endings[0]);
        }
        path
    }
}

/// What became of a dialog.
#[derive(Debug)]
pub(crate) enum Answer {
    /// This file was chosen.
    File(Purpose, PathBuf),
    /// There is no dialog; with the path that it would have begun at.
    NoDialog(Purpose, PathBuf),
}

/// How files are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// By the system's dialogs.
    System,
    /// By a path field in the window.
    Window,
    /// Not at all: nobody is there to answer.
    Silent,
}

/// Dialogs that are open, and what became of them.
pub(crate) struct Dialogs {
    answers: Arc<Mutex<Vec<Answer>>>,
    wake: Arc<dyn Fn() + Send + Sync>,
    pub(crate) way: Way,
    /// What is answered in place of whom the dialogs would ask, for programs that drive the window.
    pub(crate) prepared: VecDeque<PathBuf>,
}

impl Dialogs {
    /// `wake` is called from another thread when a file was chosen.
    pub(crate) fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            answers: Arc::default(),
            wake: Arc::new(wake),
            way: Way::System,
            prepared: VecDeque::new(),
        }
    }

    /// Asks for a file, beginning in the folder of `near`.
    pub(crate) fn ask(&mut self, purpose: Purpose, near: Option<&Path>) {
        if let Some(path) = self.prepared.pop_front() {
            return self.answer(Answer::File(purpose, path));
        }
        match self.way {
            Way::System => self.ask_system(purpose, near),
            Way::Window => self.answer(Answer::NoDialog(purpose, suggested(purpose, near))),
            Way::Silent => {}
        }
    }

    fn ask_system(&self, purpose: Purpose, near: Option<&Path>) {
        let suggested = suggested(purpose, near);
        let (kind, endings) = purpose.files();
        let mut dialog = rfd::AsyncFileDialog::new();
        if !purpose.is_folder() {
            dialog = dialog.add_filter(kind, endings);
        }
        // A folder that is only suggested is not there yet: its own folder is.
        if let Some(folder) =
            suggested.ancestors().skip(usize::from(!purpose.is_folder())).find(|path| path.is_dir())
        {
            dialog = dialog.set_directory(folder);
        }
        let name = suggested.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let (answers, wake) = (self.answers.clone(), self.wake.clone());
        let _ = start("dialog", move || {
            let clock = Clock::start();
            let file = match purpose.writes() {
                _ if purpose.is_folder() => wait(dialog.pick_folder()),
                false => wait(dialog.pick_file()),
                true => wait(dialog.set_file_name(name).save_file()),
            };
            let answer = match file {
                Some(file) => Answer::File(purpose, purpose.complete(file.path().to_path_buf())),
                None if clock.seconds() < UNSEEN => Answer::NoDialog(purpose, suggested),
                None => return,
            };
            answers.lock().unwrap_or_else(PoisonError::into_inner).push(answer);
            wake();
        });
    }

    fn answer(&self, answer: Answer) {
        self.answers.lock().unwrap_or_else(PoisonError::into_inner).push(answer);
        (self.wake)();
    }

    /// What became of dialogs since the last call. Once there was none to show, the system is not
    /// asked again.
    pub(crate) fn answers(&mut self) -> Vec<Answer> {
        let answers =
            std::mem::take(&mut *self.answers.lock().unwrap_or_else(PoisonError::into_inner));
        if self.way == Way::System
            && answers.iter().any(|answer| matches!(answer, Answer::NoDialog(..)))
        {
            self.way = Way::Window;
        }
        answers
    }
}

/// Where a dialog begins: beside `near`, under its name where a file is written; at `near` where a
/// folder is asked for.
fn suggested(purpose: Purpose, near: Option<&Path>) -> PathBuf {
    if purpose.is_folder() {
        return near.and_then(|near| std::path::absolute(near).ok()).unwrap_or_default();
    }
    let folder =
        near.and_then(Path::parent).filter(|folder| folder.is_dir()).map(Path::to_path_buf);
    let folder = folder.or_else(|| std::env::current_dir().ok()).unwrap_or_default();
    if !purpose.writes() {
        return folder.join("");
    }
    let name = near
        .and_then(Path::file_name)
        .map_or_else(|| "look.json".into(), std::borrow::ToOwned::to_owned);
    let (_, endings) = purpose.files();
    folder.join(Path::new(&name).with_extension(endings[0]))
}
