//! What files are asked for, and how such files end.

use std::path::PathBuf;

use super::{PictureExport, PictureImport};
use crate::document::Storage;
use crate::hcbtf::exchange::Form;

/// What a file is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FilePurpose {
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
    ImportPainting(PictureImport),
    /// The open look is baked into an HCBTF.
    BakeLook,
    /// What is painted is written for other programs.
    ExportPainting(Form, Storage),
    /// Shaders of a language, or of all, are written into a folder.
    Shaders(&'static str),
    /// A picture is written.
    Export(PictureExport),
    /// An image is shown.
    Reference,
}

/// The endings of meshes that can be read.
pub(crate) const MESHES: [&str; 5] = ["obj", "ply", "stl", "gltf", "glb"];

/// The endings of images that can be read.
pub(crate) const IMAGES: [&str; 5] = ["png", "jpg", "jpeg", "exr", "hdr"];

/// The ending of HCBTFs.
pub(crate) const PAINTING: &str = "hcbtf";

impl FilePurpose {
    /// What such files are called, and their endings.
    pub(crate) fn files(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Open => ("Chiaro look, scene or HCBTF", &["json", PAINTING]),
            Self::Save | Self::ObjectLook => ("Chiaro look", &["json"]),
            Self::SaveScene => ("Chiaro scene", &["json"]),
            Self::SavePainting | Self::BakeLook => ("HCBTF", &[PAINTING]),
            Self::Mesh | Self::AddMesh | Self::ObjectMesh => ("Mesh", &MESHES),
            Self::ImportPainting(PictureImport { form, .. }) | Self::ExportPainting(form, _) => {
                match form {
                    Form::Folder => ("Folder", &[]),
                    Form::Contact | Form::Sheet => ("PNG", &["png"]),
                    Form::Ktx2 => ("KTX2", &["ktx2"]),
                }
            }
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
