//! Purposes that files are asked for, and the endings of such files.

use std::path::{Path, PathBuf};

use chiaro_locale::tr;

use super::{PictureExport, PictureImport};
use crate::document::Storage;
use crate::hcbtf::exchange::ExchangeFormat;
use crate::photometry::LAMP_FILE;

/// Purpose that a file is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FilePurpose {
    Open,
    Save,
    /// A file for the look, beside copies of the files that lie with the look.
    SaveWithFiles,
    Mesh,
    /// A mesh for one more object.
    AddMesh,
    /// A mesh for the object that the question is about.
    ObjectMesh,
    /// A look for the object that the question is about.
    ObjectLook,
    SaveScene,
    /// A file for the scene, beside copies of the files that lie with the scene.
    SaveSceneWithFiles,
    SaveShot,
    SavePainting,
    /// Pictures of other programs, or a folder of them.
    ImportPainting(PictureImport),
    /// An HCBTF to bake the open look into.
    BakeLook,
    /// A file or folder to write the painting to, for other programs.
    ExportPainting(ExchangeFormat, Storage),
    /// A folder to write shaders into, of a language or of all.
    Shaders(&'static str),
    /// A picture file to write.
    Export(PictureExport),
    /// An image for the input that the question is about.
    Image,
    /// An image to show.
    Reference,
    /// A look or an image to compare the picture with.
    Comparison,
    /// One of the frames that were rendered, or another document, to compare with.
    Frames,
    /// A folder to render frames into.
    FrameFolder,
    /// A folder of parts that others share.
    LibraryFolder,
    /// Configuration of OpenColorIO.
    Colors,
}

/// File endings of meshes that can be read.
pub(crate) const MESHES: [&str; 5] = ["obj", "ply", "stl", "gltf", "glb"];

/// File endings of images that can be read.
pub(crate) const IMAGES: [&str; 5] = ["png", "jpg", "jpeg", "exr", "hdr"];

/// True if a file is an image, by its name.
pub(crate) fn is_image(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    IMAGES.iter().any(|known| known.eq_ignore_ascii_case(ending))
}

/// File ending of HCBTFs.
pub(crate) const PAINTING: &str = "hcbtf";

impl FilePurpose {
    /// Name of such files, and their endings.
    pub(crate) fn files(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Open => (
                tr!("Look, scene, shot, painted surface, sheet of a wedge, or graph to import"),
                &["json", PAINTING, "mtlx", "png"],
            ),
            Self::Save | Self::SaveWithFiles | Self::ObjectLook => (tr!("Chiaro look"), &["json"]),
            Self::SaveScene | Self::SaveSceneWithFiles => (tr!("Chiaro scene"), &["json"]),
            Self::SaveShot => (tr!("Chiaro shot"), &["json"]),
            Self::SavePainting | Self::BakeLook => (tr!("Painted surface"), &[PAINTING]),
            Self::Mesh | Self::AddMesh | Self::ObjectMesh => (tr!("Mesh"), &MESHES),
            Self::ImportPainting(PictureImport { form, .. }) | Self::ExportPainting(form, _) => {
                match form {
                    ExchangeFormat::Folder => (tr!("Folder"), &[]),
                    ExchangeFormat::Contact | ExchangeFormat::Sheet => ("PNG", &["png"]),
                    ExchangeFormat::Ktx2 => ("KTX2", &["ktx2"]),
                }
            }
            Self::Shaders(_) | Self::FrameFolder | Self::LibraryFolder => (tr!("Folder"), &[]),
            Self::Export(_) => ("PNG", &["png"]),
            Self::Image => {
                (tr!("Image, or lamp file"), &["png", "jpg", "jpeg", "exr", "hdr", LAMP_FILE])
            }
            Self::Reference => (tr!("Image"), &IMAGES),
            Self::Comparison => {
                (tr!("Look or image"), &["json", "png", "jpg", "jpeg", "exr", "hdr"])
            }
            Self::Colors => (tr!("OpenColorIO configuration"), &["ocio", "ocioz"]),
            Self::Frames => (tr!("Rendered frame, look, scene or shot"), &["exr", "png", "json"]),
        }
    }

    /// True if the file is written.
    pub(crate) fn writes(self) -> bool {
        let is_file = !self.is_folder();
        is_file
            && matches!(
                self,
                Self::Save
                    | Self::SaveWithFiles
                    | Self::SaveScene
                    | Self::SaveSceneWithFiles
                    | Self::SaveShot
                    | Self::SavePainting
                    | Self::BakeLook
                    | Self::Export(_)
                    | Self::ExportPainting(..)
            )
    }

    /// True if a folder is asked for; a folder to write into is created if it does not exist.
    pub(crate) fn is_folder(self) -> bool {
        match self {
            Self::Shaders(_)
            | Self::FrameFolder
            | Self::LibraryFolder
            | Self::ExportPainting(ExchangeFormat::Folder, _) => true,
            Self::ImportPainting(import) => import.form == ExchangeFormat::Folder,
            _ => false,
        }
    }

    /// A path with an ending added, where a file is to be written and has none.
    pub(crate) fn complete(self, mut path: PathBuf) -> PathBuf {
        let (_, endings) = self.files();
        if self.writes() && path.extension().is_none() {
            path.set_extension(endings[0]);
        }
        path
    }
}
