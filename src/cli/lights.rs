//! `chiaro lights`: the lights of a scene, which of them reach which objects and nodes of their
//! looks, which nodes filter them, and whose shadows fall on what, each with the rule that decides.
//! Needs no GPU.

use std::fmt::Write as _;
use std::path::PathBuf;

use serde_json::{Value as Json, json};

use super::open::library_for;
use super::output::Output;
use crate::compile::NodeReach;
use crate::diag::Diagnostic;
use crate::document::{Light, LightRelation};
use crate::frame::{Assets, LayerReach, LightReach, Setup, ShadowReach, open};
use crate::ids::LightId;

const EXAMPLES: &str = "\
Examples:
  chiaro lights scene.json            every light, with its kind, its groups and its owner
  chiaro lights scene.json --matrix   which lights reach which objects and nodes of their looks,
                                      which nodes filter them, whose shadows fall on what, and the
                                      rules that decide
  chiaro lights scene.json --matrix --json   the same for a script";

/// Arguments of `chiaro lights`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A scene, or a look
    document: PathBuf,
    /// Tell for every visible object which lights reach it and its layers, and whose shadows, and
    /// why
    #[arg(long)]
    matrix: bool,
    /// The time in seconds, at which words of looks may be keyed
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    time: f64,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Number of shadows, of a light from an object onto another, that are told one by one.
const MOST_SHADOWS: usize = 20_000;

/// Relations of lights to objects, to nodes of their looks, and to shadows.
struct LightMatrix {
    reach: Vec<LightReach>,
    layers: Vec<LayerReach>,
    shadows: Vec<ShadowReach>,
}

impl LightMatrix {
    fn new(setup: &Setup, arguments: &Arguments, output: &Output) -> Self {
        let library = library_for(&arguments.document, None);
        output.diagnostics(&library.problems);
        let count = setup.all_lights().len() * setup.objects.len().pow(2);
        if count > MOST_SHADOWS {
            let message = format!(
                "the {count} shadows of lights by objects onto objects are more than \
                 {MOST_SHADOWS}: only those are told that do not fall"
            );
            output.diagnostics(&[Diagnostic::warning("too-many-shadows", message)]);
        }
        let is_told = |shadow: &ShadowReach| count <= MOST_SHADOWS || !shadow.falls;
        Self {
            reach: setup.light_reach(),
            layers: setup.layer_reach(&library, arguments.time),
            shadows: setup.shadow_reach().filter(is_told).take(MOST_SHADOWS).collect(),
        }
    }

    /// Layers of an object that a light does not reach although it reaches the object.
    fn dark_layers<'m>(&'m self, cell: &'m LightReach) -> impl Iterator<Item = &'m LayerReach> {
        let is_of = |layer: &&LayerReach| {
            layer.object == cell.object && layer.reach.light == cell.light && !layer.reach.reaches
        };
        let is_layer = |layer: &&LayerReach| layer.reach.relation == LightRelation::Layered;
        self.layers.iter().filter(move |layer| cell.reaches && is_of(layer) && is_layer(layer))
    }
}

/// A light with those who have it.
struct OwnedLight {
    id: LightId,
    light: Light,
    /// True if the scene has it.
    is_of_scene: bool,
    /// Names of the looks that have a light of that id.
    looks: Vec<String>,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let setup = open(&arguments.document, None, &mut Assets::default())?;
    output.diagnostics(&setup.warnings);
    let setup = setup.value;
    output.diagnostics(&setup.light_warnings());
    let lights = owned_lights(&setup);
    let found = arguments.matrix.then(|| LightMatrix::new(&setup, arguments, output));
    if arguments.json {
        let mut told = json!({ "lights": lights.iter().map(light_json).collect::<Vec<_>>() });
        if let Some(LightMatrix { reach, layers, shadows }) = &found {
            told["matrix"] = reach.iter().map(reach_json).collect();
            told["layers"] = layers.iter().map(layer_json).collect();
            told["shadows"] = shadows.iter().map(shadow_json).collect();
        }
        output.json(&told);
    } else if let Some(found) = &found {
        output.result(matrix(&lights, found).trim_end());
    } else {
        output.result(list(&lights).trim_end());
    }
    Ok(())
}

/// Lights of the scene, then those that its looks have besides.
fn owned_lights(setup: &Setup) -> Vec<OwnedLight> {
    let owned = |(id, light): (LightId, Light)| {
        let having = setup.looks.iter().filter(|look| look.look.lights.contains_key(&id));
        let looks = having.map(|look| look.look.name.clone()).collect();
        OwnedLight { is_of_scene: setup.scene.lights.contains_key(&id), id, light, looks }
    };
    setup.all_lights().into_iter().map(owned).collect()
}

fn groups(light: &Light) -> Vec<&str> {
    light.groups.iter().map(AsRef::as_ref).collect()
}

fn light_json(OwnedLight { id, light, is_of_scene, looks }: &OwnedLight) -> Json {
    json!({
        "id": id,
        "name": light.name,
        "type": light.kind,
        "groups": groups(light),
        "scene": is_of_scene,
        "looks": looks,
    })
}

fn reach_json(LightReach { object, light, reaches, words }: &LightReach) -> Json {
    json!({ "object": object, "light": light, "reaches": reaches, "rule": words })
}

fn layer_json(LayerReach { object, look, reach }: &LayerReach) -> Json {
    json!({
        "object": object,
        "look": look,
        "node": reach.node.to_string(),
        "light": reach.light,
        "relation": reach.relation.fields()[0],
        "reaches": reach.reaches,
        "rule": reach.words,
    })
}

fn shadow_json(shadow: &ShadowReach) -> Json {
    json!({
        "light": shadow.light,
        "caster": shadow.caster,
        "onto": shadow.onto,
        "falls": shadow.falls,
        "rule": shadow.words,
    })
}

/// One light a line.
fn list(lights: &[OwnedLight]) -> String {
    if lights.is_empty() {
        return "no lights".to_owned();
    }
    let width = lights.iter().map(|light| light.id.as_str().len()).max().unwrap_or_default();
    let mut text = String::new();
    for OwnedLight { id, light, is_of_scene, looks } in lights {
        let kind = json!(light.kind);
        let mut about = vec![kind.as_str().unwrap_or_default().to_owned()];
        if !light.name.is_empty() {
            about.push(format!("\"{}\"", light.name));
        }
        if !light.groups.is_empty() {
            about.push(format!("groups {}", groups(light).join(", ")));
        }
        about.push(match (is_of_scene, looks.len()) {
            (true, 0) => "of the scene; no look has a light of this id".to_owned(),
            (true, _) => "of the scene".to_owned(),
            (false, 1) => format!("of the look {}", looks[0]),
            (false, count) => format!("of {count} looks"),
        });
        let _ = writeln!(text, "{:width$}  {}", id.as_str(), about.join("; "));
    }
    text
}

/// A row an object and a column a light, then the rules behind what does not reach.
fn matrix(lights: &[OwnedLight], found: &LightMatrix) -> String {
    let reach = &found.reach;
    let objects: Vec<&[LightReach]> = reach.chunk_by(|a, b| a.object == b.object).collect();
    let widest = objects.iter().map(|row| row[0].object.as_str().len()).max().unwrap_or_default();
    let mut text = format!("{:widest$}", "");
    for OwnedLight { id, .. } in lights {
        let _ = write!(text, "  {id}");
    }
    text.push('\n');
    for row in &objects {
        let _ = write!(text, "{:widest$}", row[0].object.as_str());
        for OwnedLight { id, .. } in lights {
            let mark = match row.iter().find(|cell| cell.light == *id) {
                Some(cell) if found.dark_layers(cell).next().is_some() => "~",
                Some(cell) if cell.reaches => "x",
                Some(_) => "-",
                None => "",
            };
            let _ = write!(text, "  {mark:^0$}", id.as_str().len());
        }
        text = text.trim_end().to_owned() + "\n";
    }
    text += "\nx: it reaches the object; -: it does not; nothing: no look of the object has it\n";
    if text.contains('~') {
        text += "~: it reaches the object, and not all nodes that are about it\n";
    }
    let lines = exceptions(found);
    if !lines.is_empty() {
        text.push('\n');
    }
    text + &lines
}

/// A line for each light that does not reach a thing, does not pass through it, or casts no shadow
/// onto it, with the rule.
fn exceptions(found: &LightMatrix) -> String {
    let mut text = String::new();
    for LightReach { object, light, words, .. } in found.reach.iter().filter(|cell| !cell.reaches) {
        let _ = writeln!(text, "{light} does not reach {object}: {words}");
    }
    for LayerReach { object, reach, .. } in found.reach.iter().flat_map(|c| found.dark_layers(c)) {
        let NodeReach { light, node, words, .. } = reach;
        let _ = writeln!(text, "{light} does not reach {node} of {object}: {words}");
    }
    let is_passed = |layer: &&LayerReach| {
        layer.reach.relation == LightRelation::Filtered && !layer.reach.reaches
    };
    for LayerReach { object, reach, .. } in found.layers.iter().filter(is_passed) {
        let NodeReach { light, node, words, .. } = reach;
        let _ = writeln!(text, "{light} passes by {node} of {object}: {words}");
    }
    for shadow in found.shadows.iter().filter(|shadow| shadow.is_by_link && !shadow.falls) {
        let ShadowReach { light, caster, onto, words, .. } = shadow;
        let onto = if caster == onto { "itself" } else { onto.as_str() };
        let _ = writeln!(text, "{caster} casts no shadow of {light} onto {onto}: {words}");
    }
    text
}
