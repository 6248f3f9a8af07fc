//! Another version of the frames: kept from the cache, files that were rendered, or another
//! document. Files are read, documents drawn and frames compared on a thread of their own.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::ColorImage;

use super::difference::{DeltaKind, FrameDelta};
use super::document::{DocumentDrawer, DocumentFrame, DocumentView};
use crate::diag::Diagnostic;
use crate::files;
use crate::film::{FramePattern, StoredFrame};
use crate::render::Gpu;
use crate::state::display::PictureDisplay;
use crate::state::revision::RequestNumber;
use crate::tools::playback::cache::{FrameCache, PictureKey};

/// Greatest length of a frame's file, in bytes.
const MAX_FILE: u64 = 1 << 30;
/// Endings of files of frames.
const ENDINGS: [&str; 2] = ["exr", "png"];

/// Picture with its key.
pub(super) type KeyedPicture = (PictureKey, Arc<ColorImage>);

/// Files of frames, by the number of the frame.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FrameFiles {
    /// Name of the files within their folder's, with a `#` for each digit of the number.
    pub(super) name: String,
    pub(super) paths: BTreeMap<i32, PathBuf>,
}

impl FrameFiles {
    /// All files of the sequence that a file, or the first one in a folder, belongs to.
    ///
    /// # Errors
    /// The reason why there is none, as a sentence.
    pub(super) fn of(path: &Path) -> Result<Self, String> {
        let folder = if path.is_dir() { path } else { path.parent().unwrap_or(path) };
        let entries = std::fs::read_dir(folder)
            .map_err(|error| tr!("{file} is not read: {error}", file = folder.display()))?;
        let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
        files.sort_unstable();
        let found = match path.is_dir() {
            true => files.iter().find_map(|file| pattern_of(file)),
            false => pattern_of(path),
        };
        let none = || {
            tr!(
                "{file} is no frame: its name ends with the frame's number and .exr or .png, as in \
                 0012.exr",
                file = path.display()
            )
        };
        let (name, pattern) = found.ok_or_else(none)?;
        let paths: BTreeMap<i32, PathBuf> =
            files.into_iter().filter_map(|file| Some((pattern.frame_of(&file)?, file))).collect();
        // Frames of several versions have the same names: their folders tell them apart.
        let name = match folder.file_name() {
            Some(folder) => format!("{}/{name}", folder.to_string_lossy()),
            None => name,
        };
        if paths.is_empty() { Err(none()) } else { Ok(Self { name, paths }) }
    }
}

/// Pattern of the files that a frame's file is one of, with its name.
fn pattern_of(file: &Path) -> Option<(String, FramePattern)> {
    let ending = file.extension()?.to_str()?;
    if !ENDINGS.iter().any(|known| known.eq_ignore_ascii_case(ending)) {
        return None;
    }
    let stem = file.file_stem()?.to_str()?;
    let before = stem.trim_end_matches(|digit: char| digit.is_ascii_digit());
    let digits = stem.len() - before.len();
    let name = format!("{}{}.{ending}", before.trim_end_matches('-'), "#".repeat(digits));
    let pattern = FramePattern::of(&file.with_file_name(&name)).ok()??;
    (digits > 0).then_some((name, pattern))
}

/// Source of another version's frames.
pub(super) enum VersionSource {
    /// The frames are there.
    Kept,
    /// Files, by the number of the frame.
    Files(BTreeMap<i32, PathBuf>),
    /// A document that is drawn, and the view in which its frames were drawn so far.
    Document(PathBuf, Option<Box<DocumentView>>),
}

/// Another version of the frames.
pub(super) struct OtherVersion {
    pub(super) name: String,
    pub(super) source: VersionSource,
    pub(super) frames: FrameCache<ColorImage>,
    /// Size of the first frame, in pixels.
    pub(super) size: Option<[u32; 2]>,
    /// Memory of the largest frame so far, in bytes.
    pub(super) bytes: usize,
    /// Files that could not be read, with the reasons.
    pub(super) failed: BTreeMap<i32, Diagnostic>,
}

impl OtherVersion {
    /// True if the frames are there, and nowhere else.
    pub(super) fn is_kept(&self) -> bool {
        matches!(self.source, VersionSource::Kept)
    }

    /// True if the version has a frame, whether it is read or not.
    pub(super) fn has(&self, frame: i32) -> bool {
        match &self.source {
            VersionSource::Kept => self.frames.holds(frame),
            VersionSource::Files(files) => files.contains_key(&frame),
            VersionSource::Document(..) => true,
        }
    }
}

/// Picture of the other version.
pub(super) enum OtherPicture {
    Known(KeyedPicture),
    /// File, and the view that its light is shown by.
    File(PathBuf, Option<PictureDisplay>),
    Document(Box<DocumentFrame>),
}

pub(super) enum FlipRequest {
    /// Finds the files of a sequence.
    Open(PathBuf),
    /// Reads a frame, and compares it with the present one.
    Frame { version: RequestNumber, frame: i32, ours: Option<KeyedPicture>, other: OtherPicture },
}

/// Version that was found.
pub(super) enum FoundVersion {
    Files(FrameFiles),
    /// A look, a scene or a shot.
    Document(PathBuf),
}

pub(super) enum FlipAnswer {
    Opened(Result<FoundVersion, String>),
    Frame {
        version: RequestNumber,
        frame: i32,
        other: Result<KeyedPicture, Box<Diagnostic>>,
        delta: Option<FrameDelta>,
    },
}

/// State of the thread of the flip book.
pub(super) struct FlipThread {
    documents: DocumentDrawer,
}

impl FlipThread {
    pub(super) fn new(gpu: Option<&Gpu>) -> Self {
        Self { documents: DocumentDrawer::new(gpu) }
    }

    /// Answers a request.
    pub(super) async fn run(&mut self, request: FlipRequest) -> FlipAnswer {
        match request {
            FlipRequest::Open(path) => FlipAnswer::Opened(found(path)),
            FlipRequest::Frame { version, frame, ours, other } => {
                let other = match other {
                    OtherPicture::Known(picture) => Ok(picture),
                    OtherPicture::File(path, display) => {
                        read(&path, display.as_ref()).map_err(Box::new)
                    }
                    OtherPicture::Document(frame) => self.documents.draw(*frame).await,
                };
                let delta = ours.zip(other.as_ref().ok()).map(|((ours, image), (key, theirs))| {
                    let same = DeltaKind::Compared { greatest: 0, pixel: [0; 2], mean: 0.0 };
                    let kind = if ours == *key { same } else { DeltaKind::of(&image, theirs) };
                    FrameDelta { of: [ours, *key], kind }
                });
                FlipAnswer::Frame { version, frame, other, delta }
            }
        }
    }
}

/// The version that a path means: a document by its ending, else frames.
fn found(path: PathBuf) -> Result<FoundVersion, String> {
    let is_document = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    match is_document {
        true if path.is_file() => Ok(FoundVersion::Document(path)),
        true => Err(tr!("there is no file {file}", file = path.display())),
        false => FrameFiles::of(&path).map(FoundVersion::Files),
    }
}

fn read(path: &Path, display: Option<&PictureDisplay>) -> Result<KeyedPicture, Diagnostic> {
    let bytes = files::read(path, MAX_FILE).map_err(|error| {
        Diagnostic::error("frame-file", tr!("{file} is not read: {error}", file = path.display()))
    })?;
    let picture = StoredFrame::read(&bytes).and_then(|frame| {
        let picture = frame.picture()?;
        let display = display.filter(|_| frame.is_light());
        Ok(display.map_or_else(|| picture.clone(), |display| display.show(&picture)))
    });
    let picture = picture.map_err(|mut of| {
        of.message = format!("{}: {}", path.display(), of.message);
        of
    })?;
    let size = picture.size.map(|side| side as usize);
    let image = ColorImage::from_rgba_unmultiplied(size, &picture.to_rgba8());
    // Equal frames of several files are kept once.
    let mut hasher = DefaultHasher::new();
    (image.size, image.as_raw()).hash(&mut hasher);
    Ok((PictureKey(u128::from(hasher.finish())), Arc::new(image)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_file_or_its_folder_is_the_whole_sequence() {
        let folder = tempfile::tempdir().unwrap();
        let put = |name: &str| std::fs::write(folder.path().join(name), b"").unwrap();
        let names = ["a.0001.png", "a.0002.png", "a.0010.png", "b.0001.png", "a.12.png", "a.png"];
        names.into_iter().for_each(put);
        let found = FrameFiles::of(&folder.path().join("a.0002.png")).unwrap();
        let within = folder.path().file_name().unwrap().to_string_lossy();
        assert_eq!(found.name, format!("{within}/a.####.png"));
        assert_eq!(found.paths.keys().copied().collect::<Vec<i32>>(), [1, 2, 10]);
        assert_eq!(FrameFiles::of(folder.path()).unwrap(), found, "the first one of the folder");
        for wrong in ["a.png", "a.0001.jpg", "none/a.0001.png"] {
            let told = FrameFiles::of(&folder.path().join(wrong)).unwrap_err();
            assert!(told.contains("no frame") || told.contains("not read"), "{told}");
        }
    }

    #[test]
    fn a_file_that_is_no_frame_is_told_by_its_name() {
        let file = tempfile::Builder::new().suffix("0001.png").tempfile().unwrap();
        std::fs::write(file.path(), b"\x89PNG and no more").unwrap();
        let told = read(file.path(), None).unwrap_err();
        assert!(told.message.contains("0001.png"), "{told:?}");
        assert!(
            read(Path::new("/no/such.0001.png"), None).unwrap_err().message.contains("not read")
        );
    }
}
