//! `chiaro probe`: the value on every wire at one pixel, f32 beside f64.

use std::path::PathBuf;

use serde_json::json;

use super::open::{check_nodes_folder, library_for};
use super::output::Output;
use super::render::{Size, parse_time, size_of};
use crate::catalog::{Catalog, wires::WirePart};
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::frame::{Assets, FramePlan, PlanOptions, Planner, Setup, open};
use crate::library::Library;
use crate::progress::Progress;
use crate::reference::{
    LightAccount, ReferenceOptions, WireValue, light_accounts, probe_surface, probe_wires,
    surface_setup,
};

const EXAMPLES: &str = "\
Examples:
  chiaro probe look.json --at 260,180
  chiaro probe look.json --at 260,180 --size 512x512 --mesh shape:sphere
  chiaro probe scene.json --at 40,60 --time 1.5 --json
  chiaro probe scene.json --at 40,60 --lights

The look is run as it is written, nothing folded, by the reference: once with every operation \
rounded to f32, as a GPU
computes, and once in f64. Rows are in the order of computing, so the first one marked `!` is \
where a broken pixel begins.
Angles are in degrees and colors hexadecimal; `--json` has every number, angles as the sine and \
cosine of their half.";

/// Arguments of `chiaro probe`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A look or a scene
    document: PathBuf,
    /// Column and row of the pixel, counted from 0 at the upper left
    #[arg(long, value_parser = parse_pixel)]
    at: [u32; 2],
    /// A mesh or an own shape (shape:creature) in place of the document's
    #[arg(short, long)]
    mesh: Option<String>,
    /// Width and height of the picture in pixels [default: as `chiaro render` has it]
    #[arg(short, long)]
    size: Option<Size>,
    /// The time in seconds [default: 0; of a shot its first frame's]
    #[arg(long, value_parser = parse_time, allow_negative_numbers = true)]
    time: Option<f64>,
    /// A folder of a project's own nodes; `nodes/` beside the document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Tell why the pixel is lit so: each light, how strong it arrives, what the look makes of it,
    /// and the rule by which it reaches the object or does not
    #[arg(long)]
    lights: bool,
    /// Print the values as JSON
    #[arg(long)]
    json: bool,
}

fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once(',')
        .and_then(|(x, y)| Some([x.trim().parse().ok()?, y.trim().parse().ok()?]));
    sides.ok_or_else(|| "write it as 260,180".to_owned())
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    check_nodes_folder(arguments.nodes.as_deref())?;
    let library = library_for(&arguments.document, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let mut assets = Assets::default();
    let (setup, warnings) =
        open(&arguments.document, arguments.mesh.as_deref(), &mut assets)?.into_parts();
    output.diagnostics(&warnings);
    let size = size_of(arguments.size.as_ref(), &setup);
    let time = arguments.time.unwrap_or_else(|| setup.first_time());
    let options = PlanOptions { size, samples: 1, time };
    let mut planner = Planner::for_probes(assets);
    let plan = planner.plan(&setup, &library, &Live::All, &options)?.value;
    let wires = probe_wires(&plan, arguments.at, &ReferenceOptions::default(), &Progress::new())
        .map_err(|one| vec![one])?;
    let Some(wires) = wires else {
        let message = format!("nothing is drawn at {},{}", arguments.at[0], arguments.at[1]);
        return Err(vec![
            Diagnostic::error("nothing-there", message).hint("choose a pixel on an object"),
        ]);
    };
    let lights = if arguments.lights {
        let of_surface = surface_setup(&setup, false);
        let surfaces = planner.plan(&of_surface, &library, &Live::All, &options)?.value;
        let surface = probe_surface(&surfaces, arguments.at, &Progress::new());
        let surface = surface.map_err(|one| vec![one])?;
        let moment = (&plan, time);
        let accounts = surface
            .map(|surface| light_accounts(&setup, &library, moment, &wires, &surface))
            .transpose();
        accounts.map_err(|one| vec![one])?.unwrap_or_default()
    } else {
        Vec::new()
    };
    if arguments.lights && arguments.json {
        output.json(&lights.iter().map(light_json).collect());
    } else if arguments.lights {
        output.result(&light_list(&lights));
    } else if arguments.json {
        let rows = wires.iter().map(|wire| {
            json!({
                "node": wire.node.to_string(), "name": wire.name, "f32": wire.single,
                "f64": wire.double,
                   "difference": wire.difference(), "finite": wire.is_finite()})
        });
        output.json(&rows.collect());
    } else {
        output.result(&table(&wires, worn_look(&setup, &plan, &wires), &library));
    }
    Ok(())
}

/// The look of the object that the pixel shows.
fn worn_look<'s>(setup: &'s Setup, plan: &FramePlan, wires: &[WireValue]) -> Option<&'s Look> {
    let draw = plan.draws.get(wires.first()?.draw)?;
    let object = setup.objects.iter().find(|object| object.id == draw.object)?;
    let part = object.mesh.parts.iter().position(|part| part.indices == draw.indices)?;
    Some(&setup.looks.get((*object.looks.get(part)?)?)?.look)
}

/// A wire a line, by the path of its node and the part of the node that its value is.
fn table(wires: &[WireValue], look: Option<&Look>, library: &Library) -> String {
    let mut catalog = Catalog::new(library);
    look.into_iter().for_each(|look| catalog.sync(look, library));
    let rows: Vec<[String; 3]> = wires
        .iter()
        .map(|wire| {
            let node = look.and_then(|look| library.node_of(look, wire.node.ids()));
            let kind = node.and_then(|(_, node)| catalog.of(node));
            let count = wire.double.len();
            let part = kind.map_or(WirePart::Numbers, |kind| WirePart::of(kind, &wire.name, count));
            let label = part.label().map_or_else(String::new, |label| format!(": {label}"));
            [wire.node.to_string() + &label, part.text(&wire.single), part.text(&wire.double)]
        })
        .collect();
    let width = rows.iter().map(|[name, ..]| name.chars().count()).max().unwrap_or(0);
    let lines = wires.iter().zip(&rows).map(|(wire, [name, single, double])| {
        let mark = if wire.is_finite() { ' ' } else { '!' };
        let truth = if single == double { String::new() } else { format!(", {double} in f64") };
        format!("{mark}{name:<width$}  {single}{truth}, off by {:.1e}", wire.difference())
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn light_json(account: &LightAccount) -> serde_json::Value {
    let readings = account.readings.iter().map(|reading| {
        json!({
            "node": reading.node.to_string(), "what": reading.label, "value": reading.value})
    });
    json!({
        "light": account.light, "name": account.name, "reaches": account.reaches,
        "rule": account.rule, "energy": account.energy, "facing": account.facing,
        "distance": account.distance, "readings": readings.collect::<Vec<_>>()})
}

/// A light a line, those that reach the pixel first; then what the look's nodes make of each.
fn light_list(lights: &[LightAccount]) -> String {
    if lights.is_empty() {
        return "no lights".to_owned();
    }
    let width = lights.iter().map(|account| account.light.as_str().len()).max().unwrap_or(0);
    let mut lines = Vec::new();
    for account in lights {
        let id = account.light.as_str();
        let facing = account.facing.to_degrees();
        let strength = match account.reaches {
            true => {
                format!("arrives with {:.4}, {facing:.1} degrees from the normal", account.energy)
            }
            false => "does not reach it".to_owned(),
        };
        lines.push(format!("{id:<width$}  {strength}: {}", account.rule));
        let pad = " ".repeat(width + 2);
        let told = account.readings.iter().map(|reading| {
            format!("{pad}{} of {}: {:.6}", reading.label, reading.node, reading.value)
        });
        lines.extend(told);
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ids::NodePath;

    #[test]
    fn wires_are_told_in_degrees_and_colors() {
        let look = r#"{"nodes": [{"id": "rim", "kind": "light_layer"}]}"#;
        let look = Look::read(look, "test").value.unwrap();
        let wire = |path: &str, name: &str, single: &[f64], double: &[f64]| WireValue {
            draw: 0,
            node: NodePath::parse(path),
            light: None,
            name: name.to_owned(),
            single: single.to_vec(),
            double: double.to_vec(),
        };
        let (sine, cosine) = 20f64.to_radians().sin_cos();
        let wires = [
            wire("rim/angle", "rim_angle", &[sine, cosine], &[sine, cosine]),
            wire("rim/color", "rim_color_convex", &[1.0; 4], &[1.0; 4]),
            wire("rim/tone", "rim_tone", &[f64::NAN], &[0.5]),
        ];
        let expected = " rim/angle          40°, off by 0.0e0\n \
                        rim/color: Convex  #ffffff, off by 0.0e0\n\
                        !rim/tone           NaN, 0.5 in f64, off by inf";
        assert_eq!(table(&wires, Some(&look), Library::built_in()), expected);
    }
}
