//! `chiaro lights`: the lights of a scene, and which of them reach which objects by which rule.
//! Needs no GPU.

use std::fmt::Write as _;
use std::path::PathBuf;

use serde_json::{Value as Json, json};

use super::output::Output;
use crate::diag::Diagnostic;
use crate::document::Light;
use crate::frame::{Assets, LightReach, Setup, open};
use crate::ids::LightId;

const EXAMPLES: &str = "\
Examples:
  chiaro lights scene.json            every light, with its kind, its groups and its owner
  chiaro lights scene.json --matrix   which lights reach which objects, and the rule that decides
  chiaro lights scene.json --matrix --json   the same for a script";

/// Arguments of `chiaro lights`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A scene, or a look
    document: PathBuf,
    /// Tell for every visible object which lights reach it, and why
    #[arg(long)]
    matrix: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
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
    let reach = setup.light_reach();
    if arguments.json {
        let mut told = json!({ "lights": lights.iter().map(light_json).collect::<Vec<_>>() });
        if arguments.matrix {
            told["matrix"] = reach.iter().map(reach_json).collect();
        }
        output.json(&told);
    } else if arguments.matrix {
        output.result(matrix(&lights, &reach).trim_end());
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
fn matrix(lights: &[OwnedLight], reach: &[LightReach]) -> String {
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
            let mark = match row.iter().find(|cell| cell.light == *id).map(|cell| cell.reaches) {
                Some(true) => "x",
                Some(false) => "-",
                None => "",
            };
            let _ = write!(text, "  {mark:^0$}", id.as_str().len());
        }
        text = text.trim_end().to_owned() + "\n";
    }
    text += "\nx: it reaches the object; -: it does not; nothing: no look of the object has it\n";
    let apart: Vec<&LightReach> = reach.iter().filter(|cell| !cell.reaches).collect();
    if !apart.is_empty() {
        text.push('\n');
    }
    for LightReach { object, light, words, .. } in apart {
        let _ = writeln!(text, "{light} does not reach {object}: {words}");
    }
    text
}
