//! Layers that `chiaro render` writes beside the picture: `--aov`, `--matte`, `--naming`.

use std::path::{Path, PathBuf};

use serde_json::{Value as Json, json};

use super::format::PictureFormat;
use super::{Arguments, Stage};
use crate::compile::wire_outputs;
use crate::diag::{Diagnostic, WithWarnings};
use crate::files::Outputs;
use crate::film::exr::ExrAttribute;
use crate::film::{
    AskedLayers, CUBE, ContributionLayers, Contributions, FramePattern, LayerNaming, LayerTable,
    MatteKind, contributions, light_shares, named_outputs, shadow_outputs, wire_request,
};
use crate::frame::{AovRequest, Setup};
use crate::library::Library;
use crate::output::Output;

/// Words for the named outputs of all looks, and for the shadows of all lights.
const NAMED: &str = "named";
const SHADOWS: &str = "shadows";

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
    let (mut slices, mut warnings) = (Vec::new(), Vec::new());
    let time = arguments.time_of(setup);
    let moved = setup.at(time);
    for text in &arguments.aovs {
        match Contributions::all().find(|(name, _)| name == text) {
            Some((_, slice)) if slices.contains(&slice) => {}
            Some((_, slice)) => slices.push(slice),
            None if text == NAMED => {
                let named = named_outputs(setup);
                let none = "no look names an output in its `aovs`";
                warnings.extend(named.is_empty().then(|| nothing_asked(text, none)));
                asked.aovs.extend(named);
            }
            None if text == SHADOWS => {
                let shadows = shadow_outputs(&moved, library, time)?;
                let none = "no look draws the shadow of a light";
                warnings.extend(shadows.is_empty().then(|| nothing_asked(text, none)));
                asked.aovs.extend(shadows);
            }
            None => asked.aovs.push(wire_request(setup, text).map_err(one)?),
        }
    }
    if !slices.is_empty() {
        let made = contributions(&moved, library, time, &slices, arguments.naming)?;
        let ContributionLayers { layers, tables } = made.tell(&mut warnings);
        asked.aovs.splice(0..0, layers);
        asked.tables = tables;
    }
    if asked.mattes.contains(&MatteKind::Lights) {
        asked.lights = light_shares(&moved, library, time)?;
    }
    asked.check().map_err(one)?;
    Ok(WithWarnings::new(asked, warnings))
}

/// The note that a word asks for no layer, and why.
fn nothing_asked(word: &str, reason: &str) -> Diagnostic {
    Diagnostic::note("no-layers", format!("`--aov {word}` adds nothing: {reason}"))
}

/// Checks that the tables of layers can be written beside the picture, and lets the header say
/// which file is whose.
///
/// # Errors
/// As [`Outputs::check`].
pub(super) fn check_tables(
    asked: &mut AskedLayers,
    (target, pattern): (&Path, Option<&FramePattern>),
    outputs: &Outputs,
) -> Result<(), Diagnostic> {
    for LayerTable { layer, .. } in &asked.tables {
        let path = table_path(target, pattern, layer);
        outputs.check(&path, CUBE)?;
        let text = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        asked.notes.push(ExrAttribute { name: format!("chiaro/table/{layer}"), text });
    }
    Ok(())
}

/// Writes the tables of layers beside the picture.
///
/// # Errors
/// As [`Outputs::write`].
pub(super) fn write_tables(
    asked: &AskedLayers,
    (target, pattern): (&Path, Option<&FramePattern>),
    outputs: &mut Outputs,
) -> Result<(), Diagnostic> {
    let mut tables = asked.tables.iter();
    tables.try_for_each(|table| {
        outputs.write(&table_path(target, pattern, &table.layer), CUBE, &table.cube())
    })
}

fn table_path(target: &Path, pattern: Option<&FramePattern>, layer: &str) -> PathBuf {
    match pattern {
        Some(pattern) => pattern.beside(&format!("{layer}.cube")),
        None => target.with_extension(format!("{layer}.cube")),
    }
}

/// Layer that can be asked for, in a list of them.
struct ListedLayer {
    /// Words after `--aov` that ask for the layer.
    asked: String,
    /// Type of the value; of contributions and shadows empty.
    ty: String,
    /// The layer's name, or the artist's name of the node.
    name: String,
    json: Json,
}

/// Heading of layers of one kind, and the layers.
type ListedGroup = (&'static str, Vec<ListedLayer>);

/// Lists what `--aov` can name: slices of the picture, shadows, named outputs, and the outputs of
/// nodes.
pub(super) fn list(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    if arguments.list_views {
        return arguments.view.list(output, arguments.json).map_err(|problem| vec![problem]);
    }
    let mut warnings = Vec::new();
    let stage = arguments.open(&mut warnings)?;
    output.diagnostics(&warnings);
    let time = stage.options.time;
    let shadows = shadow_outputs(&stage.setup.at(time), &stage.library, time)?;
    let groups = [
        ("What layers and lights add", listed_contributions(arguments, &stage)?),
        ("Shadows", listed_requests(SHADOWS, &shadows)),
        ("Outputs that looks name", listed_requests(NAMED, &named_outputs(&stage.setup))),
        ("Outputs of nodes, as --aov NAME=LOOK:NODE.OUTPUT", listed_wires(&stage)?),
    ];
    if arguments.json {
        let all = groups.iter().flat_map(|(_, layers)| layers.iter().map(|layer| &layer.json));
        output.json(&json!(all.collect::<Vec<_>>()));
    } else {
        output.result(&list_text(&groups));
    }
    Ok(())
}

/// Layers that each slice of the picture has.
fn listed_contributions(
    arguments: &Arguments,
    stage: &Stage,
) -> Result<Vec<ListedLayer>, Vec<Diagnostic>> {
    let mut listed = Vec::new();
    let time = stage.options.time;
    let moved = stage.setup.at(time);
    for (word, slice) in Contributions::all() {
        let naming = arguments.naming;
        let made = contributions(&moved, &stage.library, time, &[slice], naming)?.value;
        listed.extend(listed_requests(word, &made.layers));
    }
    Ok(listed)
}

/// Layers that one word asks for.
fn listed_requests(word: &str, requests: &[AovRequest]) -> Vec<ListedLayer> {
    let listed = |request: &AovRequest| ListedLayer {
        asked: word.to_owned(),
        ty: String::new(),
        name: request.name.clone(),
        json: json!({"layer": request.name, "by": word}),
    };
    requests.iter().map(listed).collect()
}

/// Outputs of the nodes of all looks.
fn listed_wires(stage: &Stage) -> Result<Vec<ListedLayer>, Vec<Diagnostic>> {
    let mut listed = Vec::new();
    for (index, _) in stage.setup.looks.iter().enumerate() {
        let objects = &stage.setup.objects;
        let wearer = objects.iter().find(|object| object.looks.contains(&Some(index)));
        let Some(wearer) = wearer else { continue };
        let look = stage.setup.worn(index, wearer, &stage.library, stage.options.time);
        listed.extend(wire_outputs(&look, &stage.library)?.into_iter().map(|found| {
            let (path, port, ty) =
                (found.path.to_string(), found.port.to_string(), found.ty.to_string());
            ListedLayer {
                asked: format!("{}:{path}.{port}", look.name),
                json: json!({
                    "look": look.name, "node": path, "output": port, "type": ty,
                    "name": found.name,
                }),
                ty,
                name: found.name,
            }
        }));
    }
    Ok(listed)
}

/// Layers by kind, in columns: of one word's layers all names on a line, of outputs one a line.
fn list_text(groups: &[ListedGroup]) -> String {
    let mut blocks = Vec::new();
    for (heading, layers) in groups.iter().filter(|(_, layers)| !layers.is_empty()) {
        let mut rows: Vec<[String; 3]> = Vec::new();
        for ListedLayer { asked, ty, name, .. } in layers {
            let is_word = ty.is_empty();
            match rows.last_mut().filter(|row| is_word && row[0] == format!("--aov {asked}")) {
                Some(row) => row[2] = format!("{}, {name}", row[2]),
                None if is_word => {
                    rows.push([format!("--aov {asked}"), String::new(), name.clone()]);
                }
                None => rows.push([asked.clone(), ty.clone(), name.clone()]),
            }
        }
        let width = |column: usize| {
            rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default()
        };
        let (first, second) = (width(0), width(1));
        let lines = rows.iter().map(|[asked, ty, name]| {
            let gap = if second > 0 { "  " } else { "" };
            let line = format!("  {asked:first$}{gap}{ty:second$}  {name}");
            line.trim_end().to_owned()
        });
        blocks.push(format!("{heading}\n{}", lines.collect::<Vec<_>>().join("\n")));
    }
    blocks.join("\n\n")
}
