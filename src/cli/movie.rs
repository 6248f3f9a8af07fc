//! `chiaro movie`: frames that move, for review.

use std::ffi::OsStr;
use std::io::{Read as _, Write as _};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use super::frame_files::{FrameFile, ShownFrames};
use super::output::Output;
use crate::diag::Diagnostic;
use crate::files::OutputKind;
use crate::film::{DisplayView, FrameRate, animated, rgb8};
use crate::frame::Picture;
use crate::progress::Progress;

const EXAMPLES: &str = "\
Examples:
  chiaro movie 'out/####.exr' -o review.mp4
  chiaro movie 'out/####.exr' -o review.png --rate 12 --width 640
  chiaro movie 'out/####.exr' --to apng -o review

An MP4 is made by ffmpeg, where the system has it. A PNG moves by itself in every browser.";

/// Arguments of `chiaro movie`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    #[command(flatten)]
    shown: ShownFrames,
    /// The format, whatever the file's name [default: that of the name's ending]
    #[arg(long, value_enum)]
    to: Option<MovieFormat>,
    /// Frames per second: 24, 23.976, 24000/1001
    #[arg(long, default_value = "24")]
    rate: FrameRate,
    /// Greatest width, in pixels
    #[arg(long, default_value_t = 1920, value_parser = clap::value_parser!(u32).range(16..=16_384))]
    width: u32,
}

/// Format of a movie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum MovieFormat {
    /// MP4, by ffmpeg
    Mp4,
    /// PNG that moves
    Apng,
}

/// Keyword of the seal of a movie, before its checksum.
const SEAL: &[u8] = b"Chiaro ";

/// Movies as ffmpeg makes them for Chiaro, which adds a seal.
const MOVIE: OutputKind<'static> =
    OutputKind { name: "a movie", is_own: &is_sealed, has_seal: false };

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let target = arguments.shown.target();
    let format = MovieFormat::of(arguments.to, target).map_err(one)?;
    let kind = match format {
        MovieFormat::Apng => OutputKind::PICTURE,
        MovieFormat::Mp4 => MOVIE,
    };
    let (found, mut outputs) = arguments.shown.found(kind).map_err(one)?;
    let view = arguments.shown.view().map_err(one)?;
    let view = view.as_ref();
    let bytes = output.watch("writing", |progress| match format {
        MovieFormat::Apng => {
            let count = u32::try_from(found.len()).unwrap_or(u32::MAX);
            animated(count, arguments.rate, pictures(arguments, &found, view, progress))
        }
        MovieFormat::Mp4 => mp4(arguments, &found, view, progress),
    });
    let bytes = bytes.map_err(|problem| match problem.place.file {
        None => one(problem.in_file(target.display().to_string())),
        Some(_) => one(problem),
    })?;
    outputs.write(target, kind, &bytes).map_err(one)?;
    let FrameRate { frames, seconds } = arguments.rate;
    let duration = found.len() as f64 * f64::from(seconds) / f64::from(frames);
    let (count, target) = (found.len(), target.display());
    output.message(&format!("{target}: {count} frames, {duration:.2} s"));
    Ok(())
}

impl MovieFormat {
    /// The format that was asked for, or else that of the file's name.
    ///
    /// # Errors
    /// `cannot-write` for a name without a known ending, and `bad-argument` for one of the other
    /// format.
    fn of(asked: Option<Self>, target: &Path) -> Result<Self, Diagnostic> {
        let ending = target.extension().and_then(OsStr::to_str).map(str::to_ascii_lowercase);
        let named = match ending.as_deref() {
            Some("png" | "apng") => Some(Self::Apng),
            Some("mp4") => Some(Self::Mp4),
            _ => None,
        };
        match (asked, named) {
            (Some(asked), Some(named)) if asked != named => {
                let message = format!("--to asks for another format than `{}`", target.display());
                Err(Diagnostic::error("bad-argument", message)
                    .hint("leave --to out, for the name's ending says the format"))
            }
            (Some(format), _) | (None, Some(format)) => Ok(format),
            (None, None) => Err(other_ending(target)),
        }
    }
}

fn other_ending(path: &Path) -> Diagnostic {
    let png = path.with_extension("png");
    let hint = format!("let its name end in .png: -o {}; or say --to apng", png.display());
    Diagnostic::error("cannot-write", "movies are written as MP4, or as PNG that moves")
        .in_file(path.display().to_string())
        .hint(hint)
}

/// The pictures of the frames, one after another.
fn pictures<'a>(
    arguments: &'a Arguments,
    files: &'a [FrameFile],
    view: Option<&'a DisplayView>,
    progress: &'a Progress,
) -> impl Iterator<Item = Result<Picture, Diagnostic>> + use<'a> {
    progress.begin(files.len() as u64);
    files.iter().enumerate().map(move |(at, file)| {
        progress.add(u64::from(at > 0));
        arguments.shown.picture(file, arguments.width, view)
    })
}

/// The bytes of an MP4, by ffmpeg, which takes the pictures through a pipe.
fn mp4(
    arguments: &Arguments,
    files: &[FrameFile],
    view: Option<&DisplayView>,
    progress: &Progress,
) -> Result<Vec<u8>, Diagnostic> {
    let failed = |message: String| Diagnostic::error("ffmpeg", message);
    let mut pictures = pictures(arguments, files, view, progress);
    let first = pictures.next().ok_or_else(|| failed("there are no frames".to_owned()))??;
    let size = first.size;
    // The index of an MP4 is written last and moved to the front: that takes a file.
    let folder = tempfile::tempdir().map_err(|error| failed(error.to_string()))?;
    let made = folder.path().join("review.mp4");
    let mut child = start(size, arguments.rate, &made)?;
    let mut told = String::new();
    {
        let mut pipe = child.stdin.take();
        for picture in std::iter::once(Ok(first)).chain(pictures) {
            let picture = picture.inspect_err(|_| {
                let _ = child.kill();
            })?;
            if picture.size != size {
                let _ = child.kill();
                return Err(failed("the frames of a movie are of one size".to_owned()));
            }
            // A program that ends early says why on its own.
            let is_written =
                pipe.as_mut().is_some_and(|pipe| pipe.write_all(&rgb8(&picture)).is_ok());
            if !is_written {
                break;
            }
        }
    }
    if let Some(mut errors) = child.stderr.take() {
        let _ = errors.read_to_string(&mut told);
    }
    let status = child.wait().map_err(|error| failed(error.to_string()))?;
    if !status.success() {
        let last = told.lines().rev().find(|line| !line.trim().is_empty());
        let reason = last.map_or_else(|| status.to_string(), str::to_owned);
        return Err(failed(format!("ffmpeg could not make the movie: {reason}"))
            .hint("a PNG that moves needs no ffmpeg: let the name end in .png"));
    }
    let bytes = std::fs::read(&made).map_err(|error| failed(error.to_string()))?;
    Ok(sealed(bytes))
}

fn start(size: [u32; 2], rate: FrameRate, target: &Path) -> Result<Child, Diagnostic> {
    let [width, height] = size;
    let FrameRate { frames, seconds } = rate;
    let mut command = Command::new("ffmpeg");
    command.args(["-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24"]);
    command.args(["-s", &format!("{width}x{height}"), "-r", &format!("{frames}/{seconds}")]);
    command.args(["-i", "-", "-an", "-c:v", "libx264", "-crf", "16", "-pix_fmt", "yuv420p"]);
    // Sides of this kind of picture are even, and its colors say by which matrix they were made.
    let filter = "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv";
    command.args(["-vf", filter, "-colorspace", "bt709", "-color_primaries", "bt709"]);
    command.args(["-color_trc", "iec61966-2-1", "-movflags", "+faststart"]).arg(target);
    command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
    command.spawn().map_err(|error| {
        let message = format!("ffmpeg, which makes MP4s, cannot be started: {error}");
        Diagnostic::error("no-ffmpeg", message)
            .hint("install it (Debian: apt-get install ffmpeg)")
            .hint("a PNG that moves needs no ffmpeg: let the name end in .png")
    })
}

/// The movie with a box at its end that players pass over, with a checksum of all before it.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let text = [SEAL, format!("{:016x}", checksum(&bytes)).as_bytes()].concat();
    bytes.extend((text.len() as u32 + 8).to_be_bytes());
    bytes.extend(b"free");
    bytes.extend(text);
    bytes
}

fn is_sealed(bytes: &[u8]) -> bool {
    let length = SEAL.len() + 16;
    let Some((rest, text)) = bytes.len().checked_sub(length).map(|at| bytes.split_at(at)) else {
        return false;
    };
    let Some(movie) = rest.len().checked_sub(8).map(|at| &rest[..at]) else { return false };
    text.strip_prefix(SEAL) == Some(format!("{:016x}", checksum(movie)).as_bytes())
}

/// Checksum that is the same on every machine (FNV-1a).
fn checksum(bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_format_is_asked_for_or_named() {
        let of = |asked, name: &str| {
            MovieFormat::of(asked, Path::new(name)).map_err(|problem| problem.code)
        };
        let (mp4, apng) = (MovieFormat::Mp4, MovieFormat::Apng);
        assert_eq!(
            [of(None, "a.MP4"), of(None, "a.png"), of(None, "a.apng")],
            [Ok(mp4), Ok(apng), Ok(apng)]
        );
        assert_eq!([of(Some(mp4), "a"), of(Some(apng), "a.mov")], [Ok(mp4), Ok(apng)]);
        assert_eq!(of(Some(apng), "a.png"), Ok(apng));
        assert_eq!(of(Some(mp4), "a.png"), Err("bad-argument"));
        assert_eq!(of(None, "a.mov"), Err("cannot-write"));
    }

    #[test]
    fn a_movie_is_known_until_it_is_changed() {
        let mut movie = sealed(b"....ftypisom".to_vec());
        assert!(is_sealed(&movie));
        movie[5] ^= 1;
        assert!(!is_sealed(&movie));
        for cut in 0..movie.len() {
            assert!(!is_sealed(&movie[..cut]), "{cut}");
        }
    }
}
