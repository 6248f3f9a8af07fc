//! Files of frames, as commands read them: by a pattern, or one by one.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use crate::diag::Diagnostic;
use crate::document::parse_hex;
use crate::film::{FrameList, FramePattern, StoredFrame};

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
pub(super) fn parse_backdrop(text: &str) -> Result<[f64; 3], String> {
    let color = parse_hex(text).map(|[red, green, blue, _]| [red, green, blue]);
    color.ok_or_else(|| "write a color such as #202428".to_owned())
}
