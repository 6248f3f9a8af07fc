//! `chiaro lights`: the lights of a scene, which of them reach which objects and nodes of their
//! looks, which nodes filter them, and whose shadows fall on what, each with the rule that decides.
//! Needs no GPU.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::hash::Hash;
use std::path::PathBuf;

use indexmap::IndexMap;
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

/// Number of objects that a line names.
const MOST_NAMED: usize = 6;

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

/// A line for each rule by which lights do not reach things, do not pass through them, or cast no
/// shadows onto them, with all that it decides about.
fn exceptions(found: &LightMatrix) -> String {
    let objects = found.reach.iter().map(|cell| cell.object.as_str());
    let count = objects.collect::<BTreeSet<_>>().len();
    let mut text = String::new();
    let dark = found.reach.iter().filter(|cell| !cell.reaches);
    let unreached = dark.map(|LightReach { object, light, words, .. }| {
        ((format!("{light} does not reach"), words.as_str()), object.to_string())
    });
    for ((begin, words), objects) in joined(unreached) {
        let _ = writeln!(text, "{begin} {}: {words}", listed(&objects, count));
    }
    let dark = found.reach.iter().flat_map(|cell| found.dark_layers(cell));
    write_layers(&mut text, "does not reach", dark, count);
    let is_passed = |layer: &&LayerReach| {
        layer.reach.relation == LightRelation::Filtered && !layer.reach.reaches
    };
    write_layers(&mut text, "passes by", found.layers.iter().filter(is_passed), count);
    let linked = found.shadows.iter().filter(|shadow| shadow.is_by_link && !shadow.falls);
    let onto = joined(linked.map(|shadow| {
        let ShadowReach { light, caster, onto, words, .. } = shadow;
        let onto = if caster == onto { "itself" } else { onto.as_str() };
        ((caster.as_str(), light.to_string(), words.as_str()), onto.to_owned())
    }));
    let lights = joined(
        onto.into_iter()
            .map(|((caster, light, words), onto)| ((caster, listed(&onto, count), words), light)),
    );
    for ((caster, onto, words), lights) in lights {
        let lights = lights.join(", ");
        let _ = writeln!(text, "{caster} casts no shadow of {lights} onto {onto}: {words}");
    }
    text
}

/// Lines for nodes of looks that lights leave out: those of one rule together.
fn write_layers<'m>(
    text: &mut String,
    verb: &str,
    layers: impl Iterator<Item = &'m LayerReach>,
    count: usize,
) {
    let nodes = joined(layers.map(|LayerReach { object, reach, .. }| {
        let NodeReach { light, node, words, .. } = reach;
        ((object.to_string(), light.to_string(), words.as_str()), node.to_string())
    }));
    let objects = joined(
        nodes.into_iter().map(|((object, light, words), nodes)| ((light, nodes, words), object)),
    );
    for ((light, nodes, words), objects) in objects {
        let (nodes, objects) = (nodes.join(", "), listed(&objects, count));
        let _ = writeln!(text, "{light} {verb} {nodes} of {objects}: {words}");
    }
}

/// Things of one key together, in the order in which the keys come first.
fn joined<K: Hash + Eq>(all: impl Iterator<Item = (K, String)>) -> IndexMap<K, Vec<String>> {
    let mut joined: IndexMap<K, Vec<String>> = IndexMap::new();
    for (key, thing) in all {
        joined.entry(key).or_default().push(thing);
    }
    joined
}

/// Objects by name, or in a word where they are all of a number above [`MOST_NAMED`].
fn listed(objects: &[String], count: usize) -> String {
    if objects.len() == count && count > MOST_NAMED {
        format!("all {count} objects")
    } else if objects.len() > MOST_NAMED {
        let rest = objects.len() - MOST_NAMED;
        format!("{} and {rest} more (--json names them)", objects[..MOST_NAMED].join(", "))
    } else {
        objects.join(", ")
    }
}
