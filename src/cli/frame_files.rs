//! Files of frames, as commands read them: by a pattern, or one by one.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::target::{OutputPath, outputs};
use super::view::{ViewArguments, shown};
use crate::diag::Diagnostic;
use crate::document::read_hex;
use crate::figures;
use crate::files::{self, OutputKind, Outputs, WalkBounds};
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

/// Most entries of a folder that are looked at for frames, and patterns that a message names.
const BOUNDS: WalkBounds = WalkBounds { depth: 2, entries: 20_000 };
const NAMED: usize = 3;

/// The problem of a folder or a document that is named in place of its frames, with the patterns of
/// frames that are there.
fn not_frames(path: &Path) -> Option<Diagnostic> {
    let is_document = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    if !(path.is_dir() || is_document && path.is_file()) {
        return None;
    }
    let what = if is_document { "a document" } else { "a folder" };
    let message = format!("`{}` is {what}, and not its frames", path.display());
    let folder = if is_document { path.parent().unwrap_or(Path::new("")) } else { path };
    let patterns = patterns_in(folder);
    let problem = Diagnostic::error("bad-argument", message);
    if patterns.is_empty() {
        let document = if is_document { path.display().to_string() } else { "SHOT".to_owned() };
        return Some(problem.hint(format!(
            "name the files of its frames, which chiaro render {document} -o 'out/####.exr' \
             writes"
        )));
    }
    let named = patterns.iter().take(NAMED);
    let named: Vec<String> = named
        .map(|(pattern, count)| format!("'{pattern}' ({})", figures::count(*count as u64, "frame")))
        .collect();
    Some(problem.hint(format!("name the frames by their pattern: {}", named.join(", "))))
}

/// Patterns of the frames in a folder and in those right below it, each with the number of its
/// frames, the most first.
fn patterns_in(folder: &Path) -> Vec<(String, usize)> {
    let here = if folder == Path::new("") { Path::new(".") } else { folder };
    let paths = files::walk(here, BOUNDS, &|_| true).files;
    let frames = ["exr", "png"];
    let is_frame = |path: &Path| {
        let ending = path.extension().and_then(OsStr::to_str).unwrap_or_default();
        frames.iter().any(|frame| ending.eq_ignore_ascii_case(frame))
    };
    // Files by what stands before and after the last number of their names.
    let mut named: BTreeMap<(String, String), Vec<String>> = BTreeMap::new();
    for path in paths.iter().filter(|path| is_frame(path)) {
        let path = path.strip_prefix("./").unwrap_or(path);
        let (Some(name), Some(folder)) = (path.file_name().and_then(OsStr::to_str), path.parent())
        else {
            continue;
        };
        let Some(end) = name.rfind(|c: char| c.is_ascii_digit()).map(|last| last + 1) else {
            continue;
        };
        let start = name[..end].rfind(|c: char| !c.is_ascii_digit()).map_or(0, |other| other + 1);
        let before = folder.join(&name[..start]).display().to_string();
        named
            .entry((before, name[end..].to_owned()))
            .or_default()
            .push(name[start..end].to_owned());
    }
    let pattern = |((before, after), numbers): ((String, String), Vec<String>)| {
        // Numbers are as long as the shortest that begins with 0, or as they are.
        let padded = numbers.iter().filter(|number| number.starts_with('0') && number.len() > 1);
        let width = padded.map(String::len).min().unwrap_or(1);
        (format!("{before}{}{after}", "#".repeat(width)), numbers.len())
    };
    let mut patterns: Vec<(String, usize)> = named.into_iter().map(pattern).collect();
    patterns.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    patterns
}

/// The pattern that a path is.
///
/// # Errors
/// `bad-argument` for a path without a place for a number, or with two.
pub(super) fn pattern_of(path: &Path) -> Result<FramePattern, Diagnostic> {
    if let Some(problem) = not_frames(path) {
        return Err(problem);
    }
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
        if let Some(problem) = not_frames(path) {
            return Err(problem);
        }
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
    let color = read_hex(text).map(|[red, green, blue, _]| [red, green, blue]);
    color.ok_or_else(|| "write a color such as #202428".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_and_documents_are_told_the_patterns_of_frames_beside_them() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::create_dir(path("out")).unwrap();
        for name in ["out/a.0998.exr", "out/a.1000.exr", "out/a.1001.exr", "v2-9.png", "v2-10.png"]
        {
            std::fs::write(path(name), "").unwrap();
        }
        for name in ["shot.json", "sheet.png"] {
            std::fs::write(path(name), "{}").unwrap();
        }
        let told = |path: &Path| not_frames(path).unwrap().hints.remove(0);
        let at = |name: &str| path(name).display().to_string();
        assert_eq!(
            told(&path("shot.json")),
            format!(
                "name the frames by their pattern: '{}' (3 frames), '{}' (2 frames)",
                at("out/a.####.exr"),
                at("v2-#.png")
            )
        );
        assert!(told(&path("out")).ends_with(&format!("'{}' (3 frames)", at("out/a.####.exr"))));
        std::fs::create_dir(path("empty")).unwrap();
        assert!(told(&path("empty")).contains("chiaro render"));
        assert!(not_frames(&path("out/a.0998.exr")).is_none());
        assert!(pattern_of(&path("out")).is_err() && files(&[path("shot.json")], None).is_err());
    }
}
