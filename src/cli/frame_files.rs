//! Files of frames, as commands read them: by a pattern, or one by one.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::target::{OutputPath, outputs};
use super::view::{ViewArguments, shown};
use crate::diag::Diagnostic;
use crate::document::parse_hex;
use crate::files::{OutputKind, Outputs};
use crate::film::sheet::scaled;
use crate::film::{DisplayView, FrameList, FramePattern, StoredFrame};
use crate::frame::Picture;

/// Arguments of commands that show frames as one file.
#[derive(Debug, clap::Args)]
#[group(skip)]
pub(super) struct ShownFrames {
    /// The frames' files, in which `####` stands for the number, and single pictures
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// The file to write
    #[arg(short, long)]
    output: OutputPath,
    /// The frames to show [default: those that are there]
    #[arg(long, allow_hyphen_values = true)]
    frames: Option<FrameList>,
    /// The color behind transparent pictures
    #[arg(long, default_value = "#292a2e", value_parser = parse_backdrop)]
    backdrop: [f64; 3],
    #[command(flatten)]
    view: ViewArguments,
    /// Replace a file that Chiaro did not make
    #[arg(long)]
    force: bool,
}

impl ShownFrames {
    /// Path of the file to write.
    pub(super) fn target(&self) -> &Path {
        self.output.as_ref()
    }

    /// The frames' files, and the outputs of a command that reads them, in which a file of this
    /// kind may be written.
    ///
    /// # Errors
    /// As [`files`] and [`Outputs::check`].
    pub(super) fn found(
        &self,
        kind: OutputKind<'_>,
    ) -> Result<(Vec<FrameFile>, Outputs), Diagnostic> {
        let found = files(&self.files, self.frames.as_ref())?;
        let outputs = outputs(self.force, found.iter().map(|file| &file.path));
        outputs.check(self.target(), kind)?;
        Ok((found, outputs))
    }

    /// The view by which light is shown; `None` for the curve of sRGB.
    ///
    /// # Errors
    /// As [`ViewArguments::open`].
    pub(super) fn view(&self) -> Result<Option<DisplayView>, Diagnostic> {
        self.view.open()
    }

    /// The picture of a frame over the backdrop, by this view, at most so wide.
    ///
    /// # Errors
    /// As [`FrameFile::read`] and [`shown`], with the file.
    pub(super) fn picture(
        &self,
        file: &FrameFile,
        width: u32,
        view: Option<&DisplayView>,
    ) -> Result<Picture, Diagnostic> {
        let picture = shown(&file.read()?, self.backdrop, view);
        let in_file = |problem: Diagnostic| problem.in_file(file.path.display().to_string());
        Ok(scaled(&picture.map_err(in_file)?, width))
    }
}

/// The file of a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct FrameFile {
    /// The frame; `None` for a file that was named by itself.
    pub(super) frame: Option<i32>,
    /// Path of the file.
    pub(super) path: PathBuf,
}

impl FrameFile {
    /// Reads the frame.
    ///
    /// # Errors
    /// `cannot-read`, `exr` or `png`, with the file.
    pub(super) fn read(&self) -> Result<StoredFrame, Diagnostic> {
        let file = self.path.display().to_string();
        let bytes = std::fs::read(&self.path)
            .map_err(|error| Diagnostic::error("cannot-read", error.to_string()).in_file(&file))?;
        StoredFrame::read(&bytes).map_err(|problem| problem.in_file(file))
    }

    /// Label below the picture: the frame's number, or the name of the file.
    pub(super) fn label(&self) -> String {
        let name = || self.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        self.frame.map_or_else(name, |frame| frame.to_string())
    }
}

/// The pattern that a path is.
///
/// # Errors
/// `bad-argument` for a path without a place for a number, or with two.
pub(super) fn pattern_of(path: &Path) -> Result<FramePattern, Diagnostic> {
    let bad = |message: String| {
        Diagnostic::error("bad-argument", message).hint("name the frames as 'out/####.exr'")
    };
    let pattern = FramePattern::of(path).map_err(bad)?;
    pattern
        .ok_or_else(|| bad(format!("`{}` has no place for the number of a frame", path.display())))
}

/// The frames of a pattern whose files are there, in order.
///
/// # Errors
/// `no-frames` where there are none.
pub(super) fn found(pattern: &FramePattern) -> Result<Vec<i32>, Diagnostic> {
    let folder = pattern.folder();
    let here = if folder == Path::new("") { Path::new(".") } else { &folder };
    let entries = std::fs::read_dir(here).into_iter().flatten().flatten();
    let paths = entries.map(|entry| folder.join(entry.file_name()));
    let mut frames: Vec<i32> = paths.filter_map(|path| pattern.frame_of(&path)).collect();
    frames.sort_unstable();
    if frames.is_empty() {
        let name = pattern.path(0);
        let ending = name.extension().and_then(OsStr::to_str).unwrap_or_default();
        let message =
            format!("there are no frames in `{}`, as `{}`", here.display(), name.display());
        return Err(Diagnostic::error("no-frames", message)
            .hint(format!("draw some: chiaro render SCENE -o 'out/####.{ending}' --frames 1-24")));
    }
    Ok(frames)
}

/// The files that arguments name: those of patterns, of the frames that were asked for or that are
/// there, and single ones.
///
/// # Errors
/// As [`found`] and [`pattern_of`].
pub(super) fn files(
    arguments: &[PathBuf],
    frames: Option<&FrameList>,
) -> Result<Vec<FrameFile>, Diagnostic> {
    let mut files = Vec::new();
    for path in arguments {
        if path.is_file() || arguments.len() > 1 && matches!(FramePattern::of(path), Ok(None)) {
            files.push(FrameFile { frame: None, path: path.clone() });
            continue;
        }
        let pattern = pattern_of(path)?;
        let frames = match frames {
            Some(list) => list.frames().to_vec(),
            None => found(&pattern)?,
        };
        let of_pattern = |frame: i32| FrameFile { frame: Some(frame), path: pattern.path(frame) };
        files.extend(frames.into_iter().map(of_pattern));
    }
    Ok(files)
}

/// A color as shown, behind transparent pictures.
fn parse_backdrop(text: &str) -> Result<[f64; 3], String> {
    let color = parse_hex(text).map(|[red, green, blue, _]| [red, green, blue]);
    color.ok_or_else(|| "write a color such as #202428".to_owned())
}
