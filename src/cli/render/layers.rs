//! Layers that `chiaro render` writes beside the picture: `--aov`, `--matte`, `--naming`.

use std::path::Path;

use serde_json::json;

use super::Arguments;
use super::format::PictureFormat;
use crate::compile::wire_outputs;
use crate::diag::{Diagnostic, WithWarnings};
use crate::film::{
    AskedLayers, Contributions, LayerNaming, MatteKind, contributions, light_shares, wire_request,
};
use crate::frame::Setup;
use crate::library::Library;
use crate::output::Output;

pub(super) fn parse_matte(text: &str) -> Result<MatteKind, String> {
    word(text, MatteKind::all())
}

pub(super) fn parse_naming(text: &str) -> Result<LayerNaming, String> {
    word(text, LayerNaming::all())
}

fn word<T>(text: &str, known: impl Iterator<Item = (&'static str, T)>) -> Result<T, String> {
    let known: Vec<_> = known.collect();
    let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
    let wrong = || format!("it is one of {}", names.join(", "));
    known.into_iter().find(|(name, _)| *name == text).map(|(_, found)| found).ok_or_else(wrong)
}

/// Refuses layers that a format cannot hold.
pub(super) fn check(
    arguments: &Arguments,
    format: PictureFormat,
    target: &Path,
) -> Result<(), Diagnostic> {
    let has_layers = !(arguments.aovs.is_empty() && arguments.mattes.is_empty());
    if format != PictureFormat::Png || !has_layers {
        return Ok(());
    }
    let message = "a PNG holds one picture, and no layers beside it";
    let hint = format!("write an EXR: -o {}", target.with_extension("exr").display());
    Err(Diagnostic::error("bad-argument", message).hint(hint))
}

/// The layers that the arguments ask for; warns of looks of which not all can be parted.
pub(super) fn asked(
    arguments: &Arguments,
    setup: &Setup,
    library: &Library,
) -> Result<WithWarnings<AskedLayers>, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let mut asked = AskedLayers { mattes: arguments.mattes.clone(), ..AskedLayers::default() };
    asked.mattes.sort();
    asked.mattes.dedup();
    let mut slices = Vec::new();
    for text in &arguments.aovs {
        match Contributions::all().find(|(name, _)| name == text) {
            Some((_, slice)) if slices.contains(&slice) => {}
            Some((_, slice)) => slices.push(slice),
            None => asked.aovs.push(wire_request(setup, text).map_err(one)?),
        }
    }
    let mut warnings = Vec::new();
    let time = arguments.time_of(setup);
    let moved = setup.at(time);
    if !slices.is_empty() {
        let made = contributions(&moved, library, time, &slices, arguments.naming)?;
        asked.aovs.splice(0..0, made.tell(&mut warnings));
    }
    if asked.mattes.contains(&MatteKind::Lights) {
        asked.lights = light_shares(&moved, library, time)?;
    }
    asked.check().map_err(one)?;
    Ok(WithWarnings::new(asked, warnings))
}

/// Lists the outputs of nodes that `--aov` can name.
pub(super) fn list(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let mut warnings = Vec::new();
    let stage = arguments.open(&mut warnings)?;
    output.diagnostics(&warnings);
    let mut told = Vec::new();
    for (index, _) in stage.setup.looks.iter().enumerate() {
        let objects = &stage.setup.objects;
        let wearer = objects.iter().find(|object| object.looks.contains(&Some(index)));
        let Some(wearer) = wearer else { continue };
        let look = stage.setup.worn(index, wearer, stage.options.time);
        for found in wire_outputs(&look, &stage.library)? {
            let (path, port, ty) =
                (found.path.to_string(), found.port.to_string(), found.ty.to_string());
            if arguments.json {
                told.push(json!({
                    "look": look.name, "node": path, "output": port, "type": ty,
                    "name": found.name,
                }));
            } else {
                let name = &found.name;
                output.result(&format!("{}:{path}.{port}  {ty}  {name}", look.name));
            }
        }
    }
    if arguments.json {
        output.json(&json!(told));
    }
    Ok(())
}
