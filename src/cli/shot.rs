//! `chiaro shot`: what a shot changes, and by which document; and changes taken back.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde_json::{Value as Json, json};

use super::open::{beside, library_for};
use super::output::Output;
use super::target::outputs;
use crate::diag::{Diagnostic, has_errors};
use crate::document::{ColorSpace, Document, LoadedDocument, Override, Shot, value_address};
use crate::files::{Disk, OutputKind};
use crate::film::{color_space, color_text, is_hex, value_before};
use crate::frame::{Assets, ResolvedShot, Setup, SetupLook, ValueChange, open};
use crate::library::Library;

const EXAMPLES: &str = "\
Examples:
  chiaro shot sh020.json                       its scene, frames, rate, and what it changes
  chiaro shot sh020.json --diff                every change of the shot and of its sequence
  chiaro shot sh020.json --diff --json         the same for a script
  chiaro shot sh020.json --reset lights.rim.color
  chiaro shot sh020.json --reset '../looks/hero.json#rim.offset'

`chiaro render SHOT -o 'out/####.exr'` draws its frames.";

/// Arguments of `chiaro shot`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A shot
    shot: PathBuf,
    /// Tell every value that the shot changes, and every one that the shots under it change: from
    /// what, to what, and by which file
    #[arg(long)]
    diff: bool,
    /// Take a change of this file back, by its address as --diff tells it; `camera` for the shot's
    /// own camera
    #[arg(long, value_name = "ADDRESS", conflicts_with = "diff")]
    reset: Vec<String>,
    /// Print JSON
    #[arg(long, conflicts_with = "reset")]
    json: bool,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    if !arguments.reset.is_empty() {
        return reset(&arguments.shot, &arguments.reset, output);
    }
    let (setup, warnings) = open(&arguments.shot, None, &mut Assets::default())?.into_parts();
    output.diagnostics(&warnings);
    let Some(shot) = &setup.shot else { return Err(vec![not_a_shot(&arguments.shot)]) };
    let library = || library_for(&arguments.shot, None);
    match (arguments.diff, arguments.json) {
        (true, true) => output.json(&json!(shot.changes)),
        (true, false) => output.result(&diff(&setup, &library(), shot)),
        (false, true) => output.json(&summary_json(&setup, shot)),
        (false, false) => output.result(summary(&setup, &library(), shot).trim_end()),
    }
    Ok(())
}

fn not_a_shot(path: &Path) -> Diagnostic {
    Diagnostic::error("wrong-document", "this is no shot")
        .in_file(path.display().to_string())
        .hint("a shot says \"chiaro\": \"shot\" and names a \"scene\"; see docs/format.md")
}

/// Every change, by the files that make them, the farthest first.
fn diff(setup: &Setup, library: &Library, shot: &ResolvedShot) -> String {
    let mut text = String::new();
    for file in shot.stack.shots.iter().rev() {
        let changes = shot.changes.iter().filter(|change| change.by == file.path);
        let changes: Vec<ValueChange> = changes.cloned().collect();
        let path = file.path.display();
        let over = file.shot.scene.as_str();
        if changes.is_empty() {
            let _ = writeln!(text, "{path}, over {over}: changes nothing");
        } else {
            let changes = changes_text(&changes, false, setup, library);
            let _ = writeln!(text, "{path}, over {over}\n{changes}");
        }
    }
    text.trim_end().to_owned()
}

fn summary(setup: &Setup, library: &Library, shot: &ResolvedShot) -> String {
    let stack = &shot.stack;
    let [first, last] = stack.frames();
    let mut text = String::new();
    for file in &stack.shots {
        let name = if file.shot.name.is_empty() { "" } else { ", " };
        let _ = writeln!(text, "{}{name}{}", file.path.display(), file.shot.name);
    }
    let _ = writeln!(text, "over the scene {}", stack.scene_path.display());
    let _ = writeln!(text, "frames {first} to {last}, at {} a second", stack.rate());
    if let Some([width, height]) = stack.size() {
        let _ = writeln!(text, "{width}x{height} pixels");
    }
    let _ = writeln!(text, "shading {}", stepping(stack.step()));
    let standing = shot.changes.iter().filter(|change| change.stands);
    let standing: Vec<ValueChange> = standing.cloned().collect();
    if standing.is_empty() {
        text += "changes nothing\n";
    } else {
        let changes = changes_text(&standing, stack.shots.len() > 1, setup, library);
        let _ = writeln!(text, "changes\n{changes}");
    }
    text
}

fn summary_json(setup: &Setup, shot: &ResolvedShot) -> Json {
    let stack = &shot.stack;
    let files: Vec<String> =
        stack.shots.iter().map(|file| file.path.display().to_string()).collect();
    json!({
        "shots": files,
        "scene": stack.scene_path.display().to_string(),
        "frames": stack.frames(),
        "rate": stack.rate().to_string(),
        "size": stack.size(),
        "step": stack.step(),
        "start": setup.first_time(),
        "changes": shot.changes.iter().filter(|change| change.stands).collect::<Vec<_>>(),
    })
}

/// A step in the words of animators.
fn stepping(step: u32) -> String {
    match step {
        1 => "on ones".to_owned(),
        2 => "on twos".to_owned(),
        3 => "on threes".to_owned(),
        4 => "on fours".to_owned(),
        step => format!("held for {step} frames"),
    }
}

/// Changes, one a line: address, from, to, and where it is asked for the file.
pub(super) fn changes_text(
    changes: &[ValueChange],
    with_files: bool,
    setup: &Setup,
    library: &Library,
) -> String {
    let addresses: Vec<String> = changes.iter().map(ValueChange::address).collect();
    let width = addresses.iter().map(|address| address.chars().count()).max().unwrap_or_default();
    let mut text = String::new();
    for (change, address) in changes.iter().zip(&addresses) {
        let space = color_space_of(change, setup);
        let from = value_text(&from_value(change, setup, library), space);
        let to = value_text(&change.to, space);
        let _ = write!(text, "  {address:width$}  {from} -> {to}");
        if change.step > 1 {
            let _ = write!(text, " {}", stepping(change.step));
        }
        if from == to {
            text += "  (the same as below)";
        }
        if !change.stands {
            text += "  (changed again)";
        }
        if with_files {
            let _ = write!(text, "  by {}", change.by.display());
        }
        text.push('\n');
    }
    text.truncate(text.trim_end().len());
    text
}

/// Value before a change, by the library where the change is of a group of it.
fn from_value(change: &ValueChange, setup: &Setup, library: &Library) -> Json {
    let is_it = |look: &&SetupLook| {
        change.look.as_ref() == Some(&ResolvedShot::name_of_look(look.source.file().as_ref()))
    };
    let look = setup.looks.iter().find(is_it);
    look.map_or_else(|| change.from.clone(), |look| value_before(change, &look.look, library))
}

/// The space of the numbers of a color; `None` where the value is none.
fn color_space_of(change: &ValueChange, setup: &Setup) -> Option<ColorSpace> {
    // Lights have the space of the looks that they light.
    let is_meant = |look: &&SetupLook| {
        change.look.as_deref().is_none_or(|path| Path::new(path) == Path::new(look.source.file()))
    };
    let mut looks = setup.looks.iter().filter(is_meant).map(|look| look.look.color_space);
    let first = looks.next().unwrap_or_default();
    let is_one = looks.all(|space| space == first);
    color_space(change, if is_one { first } else { ColorSpace::Display })
}

/// A value on a line, of a color in a space as fields have it; keys by their frames.
fn value_text(value: &Json, color: Option<ColorSpace>) -> String {
    let key = |key: &Json| {
        let (value, frame) = (key.get("value")?, key.get("frame")?);
        Some(format!("{} at {frame}", value_text(value, color)))
    };
    let keys = value.as_array().filter(|keys| !keys.is_empty());
    let keys: Option<Vec<String>> = keys.and_then(|keys| keys.iter().map(key).collect());
    match (keys, value) {
        (Some(keys), _) => keys.join(", "),
        (None, Json::Null) => "default".to_owned(),
        (None, Json::Array(numbers)) => {
            if let Some(text) = color.and_then(|space| color_text(numbers, space)) {
                return text;
            }
            let numbers: Vec<String> = numbers.iter().map(number_text).collect();
            format!("[{}]", numbers.join(", "))
        }
        (None, Json::String(text)) if is_hex(value) => text.clone(),
        (None, value) => number_text(value),
    }
}

/// A number with as many digits as people read.
fn number_text(value: &Json) -> String {
    match value.as_f64() {
        Some(number) => format!("{}", (number * 1e6).round() / 1e6),
        None => value.to_string(),
    }
}

/// Takes changes out of a shot's file; what else the file says stays as it is written.
fn reset(path: &Path, addresses: &[String], output: &Output) -> Result<(), Vec<Diagnostic>> {
    let mut outputs = outputs(false, std::iter::empty::<&Path>());
    outputs.changes(path);
    let Document::Shot(loaded) = Document::load(&Disk, path) else {
        return Err(vec![not_a_shot(path)]);
    };
    let LoadedDocument { value, mut source, diagnostics } = loaded;
    let Some(mut shot) = value.filter(|_| !has_errors(&diagnostics)) else {
        return Err(diagnostics);
    };
    output.diagnostics(&diagnostics);
    let mut text = source.text().to_string();
    for address in addresses {
        let places = places_of(path, &shot, address)
            .map_err(|problem| vec![problem.in_file(path.display().to_string())])?;
        // The last one first, which leaves the others where they are.
        for place in places.iter().rev() {
            let shorter = source.text_without(place).ok_or_else(|| vec![not_found(path, place)])?;
            let read = Shot::read(&shorter, source.file());
            shot = read.value.ok_or_else(|| vec![not_found(path, place)])?;
            (text, source) = (shorter, read.source);
        }
    }
    outputs.write(path, OutputKind::DOCUMENT, text.as_bytes()).map_err(|problem| vec![problem])?;
    for address in addresses {
        output.message(&format!("{}: `{address}` is as before", path.display()));
    }
    Ok(())
}

fn not_found(path: &Path, place: &str) -> Diagnostic {
    let message = format!("the file has no `{place}` that could be taken out");
    Diagnostic::error("unknown-target", message).in_file(path.display().to_string())
}

/// JSON paths of a shot's changes of a value, in the order of the file.
fn places_of(path: &Path, shot: &Shot, address: &str) -> Result<Vec<String>, Diagnostic> {
    if address == "camera" && shot.camera.is_some() {
        return Ok(vec!["camera".to_owned()]);
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    // Looks are named as the shot names them, or as --diff does.
    let is_it = |changed: &Override| {
        let told = changed.look.as_deref().map(|look| beside(folder, look));
        changed.address() == address || value_address(told.as_deref(), &changed.target) == address
    };
    let own = shot.overrides.iter().enumerate().filter(|(_, changed)| is_it(changed));
    let found: Vec<String> = own.map(|(index, _)| format!("overrides[{index}]")).collect();
    if !found.is_empty() {
        return Ok(found);
    }
    let mut known: Vec<String> = shot.overrides.iter().map(|own| own.address()).collect();
    known.extend(shot.camera.map(|_| "camera".to_owned()));
    let problem =
        Diagnostic::error("unknown-target", format!("this shot does not change `{address}`"));
    let problem = problem.suggest(address, known.iter().map(String::as_str));
    Err(if known.is_empty() {
        problem.hint("it changes nothing by itself; what lies under it is changed by its own file")
    } else {
        problem.hint(format!("it changes {}", known.join(", ")))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_told_on_a_line() {
        let of = |json: &str, space| value_text(&serde_json::from_str(json).unwrap(), space);
        let told = |json: &str| of(json, None);
        assert_eq!(told("1"), "1");
        assert_eq!(told("0.30000000000000004"), "0.3");
        assert_eq!(told("[1, 0.5, 0]"), "[1, 0.5, 0]");
        assert_eq!(told("\"#ff8800\""), "#ff8800");
        assert_eq!(of("[1, 0.5, 0]", Some(ColorSpace::Display)), "#ff8000");
        assert_eq!(of("[1, 0.5, 0, 0.5]", Some(ColorSpace::Linear)), "#ffbc0080");
        assert_eq!(of("[4, 0.5, 0]", Some(ColorSpace::Linear)), "[4, 0.5, 0]", "no screen's");
        assert_eq!(told("null"), "default");
        assert_eq!(
            told("[{\"frame\": 1, \"value\": 2}, {\"frame\": 9, \"value\": 3}]"),
            "2 at 1, 3 at 9"
        );
    }
}
