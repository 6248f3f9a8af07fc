//! The system's file dialogs, which wait on a thread of their own.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use super::viewport::Export;
use super::worker::start;
use crate::render::block_on;

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
    /// A picture is written.
    Export(Export),
    /// An image is shown.
    Reference,
}

/// The endings of meshes that can be read.
pub(crate) const MESHES: [&str; 5] = ["obj", "ply", "stl", "gltf", "glb"];

/// The endings of images that can be read.
pub(crate) const IMAGES: [&str; 5] = ["png", "jpg", "jpeg", "exr", "hdr"];

/// Dialogs that are open, and what became of them.
pub(crate) struct Dialogs {
    answers: Arc<Mutex<Vec<(Purpose, PathBuf)>>>,
    wake: Arc<dyn Fn() + Send + Sync>,
    /// Whether nobody is there to answer one.
    pub(crate) is_silent: bool,
}

impl Dialogs {
    /// `wake` is called from another thread when a file was chosen.
    pub(crate) fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self { answers: Arc::default(), wake: Arc::new(wake), is_silent: false }
    }

    /// Asks for a file, beginning in the folder of `near`.
    pub(crate) fn ask(&self, purpose: Purpose, near: Option<&Path>) {
        if self.is_silent {
            return;
        }
        let dialog = rfd::AsyncFileDialog::new();
        let mut dialog = match purpose {
            Purpose::Open => dialog.add_filter("Chiaro look or scene", &["json"]),
            Purpose::Save | Purpose::ObjectLook => dialog.add_filter("Chiaro look", &["json"]),
            Purpose::SaveScene => dialog.add_filter("Chiaro scene", &["json"]),
            Purpose::Mesh | Purpose::AddMesh | Purpose::ObjectMesh => dialog.add_filter("Mesh", &MESHES),
            Purpose::Export(_) => dialog.add_filter("PNG", &["png"]),
            Purpose::Reference => dialog.add_filter("Image", &IMAGES),
        };
        if let Some(folder) = near.and_then(Path::parent).filter(|folder| folder.is_dir()) {
            dialog = dialog.set_directory(folder);
        }
        let new = if purpose == Purpose::SaveScene { "scene.json" } else { "look.json" };
        let name = near.and_then(Path::file_name).map_or(new.into(), |name| name.to_string_lossy().into_owned());
        let name = match purpose {
            Purpose::Export(_) => Path::new(&name).with_extension("png").to_string_lossy().into_owned(),
            _ => name,
        };
        let (answers, wake) = (self.answers.clone(), self.wake.clone());
        let _ = start("dialog", move || {
            let file = match purpose {
                Purpose::Save | Purpose::SaveScene | Purpose::Export(_) => {
                    block_on(dialog.set_file_name(name).save_file())
                }
                _ => block_on(dialog.pick_file()),
            };
            if let Some(file) = file {
                let mut path = file.path().to_path_buf();
                let ending = match purpose {
                    Purpose::Save | Purpose::SaveScene => "json",
                    Purpose::Export(_) => "png",
                    _ => "",
                };
                if !ending.is_empty() && path.extension().is_none() {
                    path.set_extension(ending);
                }
                answers.lock().unwrap_or_else(PoisonError::into_inner).push((purpose, path));
                wake();
            }
        });
    }

    /// Files that were chosen since the last call.
    pub(crate) fn answers(&self) -> impl Iterator<Item = (Purpose, PathBuf)> + use<> {
        std::mem::take(&mut *self.answers.lock().unwrap_or_else(PoisonError::into_inner)).into_iter()
    }
}
