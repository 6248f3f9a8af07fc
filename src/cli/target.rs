//! Output paths of commands, as the command line names them.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::diag::Diagnostic;
use crate::files::{OutputKind, Outputs};
use crate::frame::{Assets, Setup};

/// A file or a folder that a command writes. Every argument that names an output is of this type,
/// and is written through [`Outputs`] alone; tests/program/outputs.rs finds the arguments by this
/// type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputPath(PathBuf);

impl From<OsString> for OutputPath {
    fn from(text: OsString) -> Self {
        Self(text.into())
    }
}

impl AsRef<Path> for OutputPath {
    fn as_ref(&self) -> &Path {
        &self.0
    }
}

/// The outputs of a command that reads these files and folders; inputs that are no path, such as
/// `shape:knot`, do no harm.
pub(super) fn outputs<P: AsRef<Path>>(
    is_forced: bool,
    inputs: impl IntoIterator<Item = P>,
) -> Outputs {
    let mut outputs = Outputs::new(is_forced);
    inputs.into_iter().for_each(|path| outputs.reads(path.as_ref()));
    outputs
}

/// Adds the files that were opened with a document: what a shot changes, the looks and meshes of a
/// scene, and images.
pub(super) fn reads_all(outputs: &mut Outputs, setup: &Setup, assets: &Assets) {
    if let Some(shot) = &setup.shot {
        shot.stack.shots.iter().for_each(|file| outputs.reads(&file.path));
        outputs.reads(&shot.stack.scene_path);
    }
    let folder = &setup.folder;
    for object in setup.scene.objects.values() {
        let named = object.looks.values().chain([&object.mesh]);
        named.for_each(|name| outputs.reads(&folder.join(name)));
    }
    assets.files().for_each(|path| outputs.reads(path));
}

/// Refuses to write over another document than the one that is changed, and over inputs.
pub(super) fn check_document(
    outputs: &Outputs,
    written: Option<&OutputPath>,
) -> Result<(), Diagnostic> {
    written.map_or(Ok(()), |path| outputs.check(path.as_ref(), OutputKind::DOCUMENT))
}
