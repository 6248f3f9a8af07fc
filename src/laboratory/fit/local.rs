//! Fit of light layers over the look as it is: each lies where it was painted, with a light of its
//! own, and nothing else of the look changes.
//!
//! The picture of the look is the ground, which stays: its pixels count four times as much as the
//! painted ones, but for those close to a stroke. Over it one layer after another is searched for
//! (`local_layer`): a light that falls on all of the object, or one that is confined to a place. A
//! layer that hardly helps is not laid.
//!
//! The reference draws the picture twice, for the ground and for the result, and the surface twice,
//! for normals and positions. The search evaluates formulas, and takes about as long as the
//! result's picture.

use std::collections::{HashMap, HashSet};

use chiaro_locale::tr;
use glam::DVec3;

use super::build::{APART, name_of, values_of};
use super::choose::{SurfaceSamples, goals_of, pixels_of, positions_of, thinned, wearing};
use super::local_layer::{LocalLayer, PaintedSample, error, next_layer};
use super::model::{FitShot, Model};
use super::place::LayerPlace;
use super::report::{
    ComparedPixel, ComparedPixels, FitReport, compared_as_is, compared_at, painted,
};
use super::rest::{UnpaintedPixels, seen_of};
use super::target::{FitTarget, PixelGoal};
use super::{FitOptions, FittedLook};
use crate::diag::Diagnostic;
use crate::document::{
    ColorSpace, Edit, Endpoint, Light, Look, Node, Value, Values, Wire, srgb_to_linear,
};
use crate::frame::Setup;
use crate::ids::{LightId, NodeId, make_slug};
use crate::library::Library;
use crate::progress::Progress;

/// Largest number of layers that are laid over the look.
const MOST_LAYERS: usize = 3;
/// Share of the squared error that a layer has to take away.
const LEAST_GAIN: f64 = 0.08;
/// Node that weighs a place, its output, and the layer's input that the output is wired into.
const PLACE: [&str; 3] = ["nearby", "weight", "opacity"];

/// Lays light layers over look number `look` of `setup` so that it shows the goals of `target`
/// where they were painted, and stays as it is elsewhere. The given look comes back where no layer
/// brings it nearer.
///
/// # Errors
/// `fit-target` if no painted pixel can be compared; `fit-output` for a look whose output has no
/// color; problems of the setup.
pub fn fit_local(
    setup: &Setup,
    look: usize,
    library: &Library,
    target: &FitTarget,
    options: &FitOptions,
    progress: &Progress,
) -> Result<FittedLook, Vec<Diagnostic>> {
    let given_look = &setup.looks[look].look;
    let Some(top) = top_of(given_look) else {
        let message = tr!("nothing is wired into the look's output");
        return Err(vec![
            Diagnostic::error("fit-output", message)
                .hint(tr!("wire a color into it: light is painted over what it shows")),
        ]);
    };
    progress.begin(MOST_LAYERS as u64 + 3);
    let shot = FitShot { setup, look, library, size: target.size, time: options.time };
    let PaintedGround { given, before, mut samples } = ground(&shot, target, progress)?;
    let mut layers: Vec<(LocalLayer, [f64; 3])> = Vec::new();
    for _ in 0..MOST_LAYERS {
        let found = next_layer(&samples, progress).map_err(|one| vec![one])?;
        progress.add(1);
        let Some(laid) = found else { break };
        if error(&laid.samples) > (1.0 - LEAST_GAIN) * error(&samples) || progress.is_stopped() {
            break;
        }
        samples = laid.samples;
        layers.push((laid.layer, laid.color));
    }
    let mut fitted = laid_over(given_look, &top, &layers, setup);
    let worn = wearing(&shot, fitted.clone());
    let mut after = compared_as_is(&FitShot { setup: &worn, ..shot }, &given)?;
    progress.add(1);
    let mut report = FitReport::new(&shot, &fitted, target, &before, &after, options)?;
    // The formula is not the shader: what the reference sees decides.
    if report.after >= report.before {
        fitted = given_look.clone();
        after.clone_from(&before);
        report = FitReport::new(&shot, &fitted, target, &before, &after, options)?;
    }
    let report = FitReport { is_stopped: progress.is_stopped(), ..report };
    let misses = painted(&after);
    let edit = Edit::Replace { look: Box::new(fitted.clone()) };
    Ok(FittedLook { look: fitted, edit, report, misses })
}

/// Picture of the look that layers are laid over.
struct PaintedGround {
    /// Goals of the painted pixels, and of the rest.
    given: Vec<PixelGoal>,
    before: ComparedPixels,
    samples: Vec<PaintedSample>,
}

/// The picture below the layers, drawn once for all of its pixels, with the surface that it shows.
fn ground(
    shot: &FitShot<'_>,
    target: &FitTarget,
    progress: &Progress,
) -> Result<PaintedGround, Vec<Diagnostic>> {
    let mut given = thinned(target);
    let chosen = seen_of(target.size).chain(pixels_of(&given)).collect();
    let model = Model::new(shot, Vec::new(), &chosen)?;
    progress.add(1);
    goals_of(&model.pixels, &given)?;
    given.extend(UnpaintedPixels::of(&model, target, 1.0)?.goals);
    let chosen: HashSet<[u32; 2]> = pixels_of(&given);
    let (before, surface) = rayon::join(
        || compared_at(&model, &given),
        || rayon::join(|| SurfaceSamples::new(shot, &chosen), || positions_of(shot, &chosen)),
    );
    let (before, surface, positions) = (before?, surface.0?, surface.1?);
    progress.add(1);
    let directions: HashMap<[u32; 2], [DVec3; 2]> =
        surface.pixels.iter().copied().zip(surface.directions).collect();
    let is_linear = shot.setup.looks[shot.look].look.color_space == ColorSpace::Linear;
    let own = |color: [f64; 3]| if is_linear { color.map(srgb_to_linear) } else { color };
    let sample = |one: &ComparedPixel| {
        let goal = one.goal();
        Some(PaintedSample {
            directions: *directions.get(&goal.pixel)?,
            position: *positions.get(&goal.pixel)?,
            below: own(one.missed.shown),
            goal: PixelGoal { color: own(goal.color), ..goal },
        })
    };
    let samples = before.iter().filter_map(sample).collect();
    Ok(PaintedGround { given, before, samples })
}

/// Node of the output, and the wire that ends at its color.
struct LookTop {
    output: NodeId,
    wire: usize,
}

fn top_of(look: &Look) -> Option<LookTop> {
    let (output, _) = look.graph.nodes.iter().find(|(_, node)| node.kind == "output")?;
    let wires = &look.graph.wires;
    let wire = wires.iter().position(|wire| wire.to == Endpoint::new(output.as_str(), "color"))?;
    Some(LookTop { output: output.clone(), wire })
}

/// The look with layers between what it shows and its output, each with a light of its own.
fn laid_over(look: &Look, top: &LookTop, layers: &[(LocalLayer, [f64; 3])], setup: &Setup) -> Look {
    let mut new = look.clone();
    let to_frame = setup.illumination().inverse();
    let mut at = look.graph.nodes[&top.output].position;
    for (LocalLayer { lit, place }, color) in layers {
        let name = name_of(lit.kind, new.graph.nodes.values().map(|node| node.name.as_str()));
        let light = make_slug("painted light", |id| new.lights.contains_key(id));
        let direction = (to_frame * lit.direction).normalize_or(DVec3::Z).to_array();
        let own = Light { name: name.clone(), direction, ..Light::default() };
        new.lights.insert(LightId::new(light.as_str()), own);
        let id = make_slug("painted light", |id| new.graph.nodes.contains_key(id));
        let values = values_of(lit, &light, *color, "alpha");
        let kind = "light_layer".to_owned();
        let node = Node { kind, name: name.clone(), position: at, values, ..Node::default() };
        new.graph.nodes.insert(NodeId::new(id.as_str()), node);
        let from = std::mem::replace(
            &mut new.graph.wires[top.wire].from,
            Endpoint::new(id.as_str(), "below"),
        );
        new.graph.wires.push(Wire { from, to: Endpoint::new(id.as_str(), "below") });
        if let Some(place) = place {
            confine(&mut new, &id, place, &name);
        }
        at[0] += APART;
    }
    new.graph.nodes[&top.output].position = at;
    new
}

/// Confines layer `layer` of a look to a place: a node beside it weighs its opacity.
fn confine(look: &mut Look, layer: &str, place: &LayerPlace, name: &str) {
    let [kind, output, input] = PLACE;
    let id = make_slug("painted place", |id| look.graph.nodes.contains_key(id));
    let [x, y] = look.graph.nodes[layer].position;
    let values: Values = [
        ("center", Value::Vector(place.center.to_array().to_vec())),
        ("radius", Value::Number(place.radius)),
        ("hardness", Value::Number(place.hardness)),
    ]
    .into_iter()
    .map(|(port, value)| (port.into(), value))
    .collect();
    let node = Node {
        kind: kind.to_owned(),
        name: format!("{name}: place"),
        position: [x - 0.5 * APART, y + APART],
        values,
        ..Node::default()
    };
    look.graph.nodes.insert(NodeId::new(id.as_str()), node);
    let wire = Wire { from: Endpoint::new(id.as_str(), output), to: Endpoint::new(layer, input) };
    look.graph.wires.push(wire);
}
