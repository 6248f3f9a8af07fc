//! `chiaro comp`: documents of compositors that put frames together from their layers.

use std::path::{Path, PathBuf};

use super::frame_files::{FrameFile, files};
use super::output::Output;
use super::target::{OutputPath, outputs};
use crate::diag::Diagnostic;
use crate::files::{OutputKind, relative, sealed_script};
use crate::film::comp::{COMPOSITORS, Comp, Compositor, LayerSpace, PictureParts};
use crate::film::exr::{self, ExrContent, SampleType};
use crate::film::{FrameList, FrameRate};

const EXAMPLES: &str = "\
Examples:
  chiaro render shot.json -o 'out/####.exr' --aov lights --matte objects
  chiaro comp 'out/####.exr' --to nuke -o regrade.nk
  chiaro comp 'out/####.exr' --to blender -o regrade.py
  blender --python regrade.py

Each light has a gain of its own; with all at 1 the result is the picture. Layers add up in the
space in which the looks blend: the document goes there and back.";

/// Frames of which layers are added to see that they are the picture: reading takes time.
const CHECKED: usize = 3;

/// Arguments of `chiaro comp`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// The frames' files, in which `####` stands for the number, or a picture: EXRs with layers
    #[arg(value_name = "FRAMES")]
    file: PathBuf,
    /// The program: nuke (a script), or blender (a script that makes the compositor)
    #[arg(long, value_parser = parse_compositor)]
    to: Compositor,
    /// The document to write; standard output without it
    #[arg(short, long)]
    output: Option<OutputPath>,
    /// The frames [default: those that are there]
    #[arg(long, allow_hyphen_values = true)]
    frames: Option<FrameList>,
    /// Frames per second [default: as the files say, or 24]
    #[arg(long)]
    rate: Option<FrameRate>,
    /// The layers that get a gain, by names [default: those of lights, or else of layers, that add
    /// up to the picture]
    #[arg(long, value_delimiter = ',')]
    layers: Vec<String>,
    /// The space in which the layers add up, display or linear [default: as the files say]
    #[arg(long, value_parser = parse_space)]
    layers_in: Option<LayerSpace>,
    /// The pictures that the document writes [default: regrade/####.exr beside it]
    #[arg(long, value_name = "FILES")]
    write: Option<PathBuf>,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

fn parse_compositor(word: &str) -> Result<Compositor, String> {
    let words = || COMPOSITORS.iter().map(|one| one.word).collect::<Vec<_>>().join(", ");
    Compositor::named(word).ok_or_else(|| format!("it is one of {}", words()))
}

fn parse_space(word: &str) -> Result<LayerSpace, String> {
    let found = LayerSpace::ALL.into_iter().find(|(known, _)| *known == word);
    found.map(|(_, space)| space).ok_or_else(|| "it is display or linear".to_owned())
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let named = std::slice::from_ref(&arguments.file);
    let found = files(named, arguments.frames.as_ref()).map_err(one)?;
    let mut outputs = outputs(arguments.force, found.iter().map(|file| &file.path));
    let target: Option<&Path> = arguments.output.as_ref().map(AsRef::as_ref);
    if let Some(target) = target {
        check_ending(target, arguments.to).map_err(one)?;
        outputs.check(target, OutputKind::SCRIPT).map_err(one)?;
    }
    let Pictures { first, parts, error } = read(arguments, &found).map_err(one)?;
    let mut warnings = Vec::new();
    if parts.is_stack {
        let message = format!(
            "nodes of a look change the sum of its layers, `{}`: a gain does not pass through them",
            parts.whole
        );
        warnings.push(Diagnostic::warning("not-parted", message).hint(
            "with all gains at 1 the result is the picture; others are near to what a look would \
             draw",
        ));
    }
    let frames = frames_of(&found, &mut warnings);
    let comp = comp(arguments, &found, &first, parts, frames).map_err(one)?;
    let text = arguments.to.document(&comp).map_err(one)?;
    output.diagnostics(&warnings);
    let labels: Vec<&str> = comp.parts.parts.iter().map(|part| part.label.as_str()).collect();
    output.message(&format!(
        "{}: {} add up to {}, within {error:.2} steps of 16 bits for each",
        comp.name,
        labels.join(", "),
        comp.parts.whole
    ));
    let Some(target) = target else {
        output.result(text.trim_end());
        return Ok(());
    };
    let script = sealed_script(&text);
    outputs.write(target, OutputKind::SCRIPT, script.as_bytes()).map_err(one)?;
    let file = target.display().to_string();
    let opened_by = arguments.to.opened_by.replace("FILE", &file);
    output.message(&format!("{file}: {opened_by}"));
    Ok(())
}

fn check_ending(target: &Path, to: Compositor) -> Result<(), Diagnostic> {
    if target.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(to.ending)) {
        return Ok(());
    }
    let message = format!("a document for {} is a .{} file", to.word, to.ending);
    let hint = format!("name it so: -o {}", target.with_extension(to.ending).display());
    Err(Diagnostic::error("bad-argument", message).hint(hint))
}

/// Pictures that were read.
struct Pictures {
    first: ExrContent,
    parts: PictureParts,
    /// Steps of 16 bits, for each layer, by which sums differ from the whole.
    error: f64,
}

/// Reads some of the frames, one after another, and finds the layers that add up in all of them.
fn read(arguments: &Arguments, found: &[FrameFile]) -> Result<Pictures, Diagnostic> {
    let last = found.len().saturating_sub(1);
    let mut places: Vec<usize> = (0..CHECKED).map(|at| at * last / (CHECKED - 1)).collect();
    places.dedup();
    let mut known: Option<(ExrContent, Vec<PictureParts>, f64)> = None;
    for file in places.into_iter().filter_map(|at| found.get(at)) {
        let name = file.path.display().to_string();
        let content = content(&file.path)?;
        let in_file = |problem: Diagnostic| problem.in_file(&name);
        let sets = PictureParts::all_of(&content, &arguments.layers, arguments.layers_in)
            .map_err(in_file)?;
        let Some((first, before, error)) = &mut known else {
            let error = sets.first().map_or(0.0, |parts| parts.error(&content));
            known = Some((content, sets, error));
            continue;
        };
        if content.size != first.size {
            let message = "it has another size than the first frame";
            return Err(in_file(
                Diagnostic::error("no-parts", message).hint("name frames of one size: --frames"),
            ));
        }
        before.retain(|parts| sets.contains(parts));
        let Some(parts) = before.first() else {
            let message = "its layers are others than those of the first frame";
            return Err(in_file(
                Diagnostic::error("no-parts", message)
                    .hint("say which layers are to have gains: --layers light_key,light_rim"),
            ));
        };
        *error = error.max(parts.error(&content));
    }
    let (first, mut sets, error) =
        known.ok_or_else(|| Diagnostic::error("no-frames", "there are no frames"))?;
    // What is kept holds no numbers: frames of films are large.
    let channels = first.channels.into_iter().map(|(name, _)| (name, Vec::new())).collect();
    Ok(Pictures { first: ExrContent { channels, ..first }, parts: sets.remove(0), error })
}

fn content(path: &Path) -> Result<ExrContent, Diagnostic> {
    let file = path.display().to_string();
    let bytes = std::fs::read(path)
        .map_err(|error| Diagnostic::error("cannot-read", error.to_string()).in_file(&file))?;
    exr::decode(&bytes).map_err(|problem| {
        let is_document = path.extension().is_some_and(|ending| ending == "json");
        let hint = if is_document {
            format!("draw it first: chiaro render {file} -o 'out/####.exr' --aov lights")
        } else {
            "name EXRs, as chiaro render -o 'out/####.exr' writes them".to_owned()
        };
        problem.in_file(&file).hint(hint)
    })
}

/// The first and the last frame; warns of gaps, which compositors tell as missing.
fn frames_of(found: &[FrameFile], warnings: &mut Vec<Diagnostic>) -> Option<[i32; 2]> {
    let numbers: Vec<i32> = found.iter().filter_map(|file| file.frame).collect();
    let (first, last) = (*numbers.iter().min()?, *numbers.iter().max()?);
    if i64::from(last) - i64::from(first) + 1 != numbers.len() as i64 {
        let message = format!("not all frames from {first} to {last} are there");
        warnings.push(
            Diagnostic::warning("gaps", message)
                .hint("name a range without gaps: --frames 1-24, or draw the others"),
        );
    }
    Some([first, last])
}

fn comp(
    arguments: &Arguments,
    found: &[FrameFile],
    first: &ExrContent,
    parts: PictureParts,
    frames: Option<[i32; 2]>,
) -> Result<Comp, Diagnostic> {
    let no_folder =
        |error: std::io::Error| Diagnostic::error("cannot-read", format!("no folder: {error}"));
    let absolute = |path: &Path| std::path::absolute(path).map_err(no_folder);
    let document = match &arguments.output {
        Some(target) => absolute(target.as_ref())?.parent().map(Path::to_path_buf),
        None => None,
    };
    let folder = document.map_or_else(|| absolute(Path::new(".")), Ok)?;
    let named = |path: &Path| -> Result<String, Diagnostic> {
        Ok(relative(&folder, &absolute(path)?).replace('\\', "/"))
    };
    let first_file = found.iter().min_by_key(|file| file.frame).map(|file| &file.path);
    let output = match &arguments.write {
        Some(path) => named(path)?,
        None if frames.is_some() => "regrade/####.exr".to_owned(),
        None => "regrade.exr".to_owned(),
    };
    let has_float = |name: &str| {
        let at = first.channels.iter().position(|(known, _)| known == name);
        at.and_then(|at| first.samples.get(at)) == Some(&SampleType::Float)
    };
    Ok(Comp {
        name: name_of(&arguments.file),
        file: named(&arguments.file)?,
        first_file: named(first_file.unwrap_or(&arguments.file))?,
        frames,
        rate: arguments.rate.or(first.rate).unwrap_or(FrameRate::FILM),
        size: first.size,
        samples: if has_float("R") { SampleType::Float } else { SampleType::Half },
        parts,
        mattes: mattes(first),
        output,
    })
}

/// The name of a file without the place of its number and what parts it, or of its folder.
fn name_of(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let is_of_number = |c: char| matches!(c, '#' | '.' | '_' | '-' | '%') || c.is_control();
    let name = stem.trim_matches(is_of_number);
    let name = name.strip_suffix("%04d").unwrap_or(name);
    let folder = || path.parent()?.file_name().map(|name| name.to_string_lossy().into_owned());
    if name.is_empty() { folder().unwrap_or_else(|| "frames".to_owned()) } else { name.to_owned() }
}

/// Names of the mattes: layers whose levels are numbered behind the name.
fn mattes(content: &ExrContent) -> Vec<String> {
    let layers = content.channels.iter().filter_map(|(name, _)| name.strip_suffix("00.R"));
    layers.filter(|name| name.starts_with("Crypto")).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_is_named_as_its_frames_are() {
        let name = |path: &str| name_of(Path::new(path));
        assert_eq!(name("out/sh010.####.exr"), "sh010");
        assert_eq!(name("out/####.exr"), "out");
        assert_eq!(name("####.exr"), "frames");
        assert_eq!(name("still.exr"), "still");
    }
}
