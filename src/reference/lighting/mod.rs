//! Account of the lights at a probed pixel: which of them reach the object there, by which rule,
//! how strong each arrives, and what the look's own nodes make of it.

mod arrival;

use chiaro_locale::tr;
use glam::DVec3;

use self::arrival::Arrival;
use super::probe::WireValue;
use super::surface::ProbedSurface;
use crate::diag::Diagnostic;
use crate::document::{LightKind, LightRelation, LightValues, Look};
use crate::frame::{FramePlan, LightReach, Setup};
use crate::ids::{LightId, NodePath};
use crate::library::Library;

/// A value at the pixel that a node computed about one light: a tone, a share of a filter, a
/// shadow.
#[derive(Clone, Debug, PartialEq)]
pub struct LightReading {
    /// Path of the node.
    pub node: NodePath,
    /// Label of the node's output.
    pub label: String,
    /// The value, in f64.
    pub value: f64,
}

/// Account of a light at a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct LightAccount {
    /// The light.
    pub light: LightId,
    /// Name that people read.
    pub name: String,
    /// True if it reaches the pixel's object.
    pub reaches: bool,
    /// The rule that decides, in words; of a light that reaches the object also the nodes that it
    /// does not reach there, each with its rule.
    pub rule: String,
    /// Angle between the normal and the way to the light, in radians.
    pub facing: f64,
    /// Distance to the light, in scene units; `None` for a directional light.
    pub distance: Option<f64>,
    /// Luminance of the light's color times its intensity as it arrives: after keys, masters,
    /// fading and cone, before filters and shadows. 0 for a light that does not reach.
    pub energy: f64,
    /// Values that nodes of the look computed about the light, in the order of computing. A node in
    /// a group that runs for each light has one for each.
    pub readings: Vec<LightReading>,
}

/// Accounts of all lights that the object at a pixel is about: those that reach it, by their
/// energy, then the others. The moment is a plan for probes with its time, in seconds; `wires` and
/// `surface` are what the probe read there.
///
/// # Errors
/// A node of the project that runs without end.
pub fn light_accounts(
    setup: &Setup,
    library: &Library,
    (plan, time): (&FramePlan, f64),
    wires: &[WireValue],
    surface: &ProbedSurface,
) -> Result<Vec<LightAccount>, Diagnostic> {
    let draw = wires.first().map_or(surface.draw, |wire| wire.draw);
    let Some(draw) = plan.draws.get(draw) else { return Ok(Vec::new()) };
    let Some(object) = setup.objects.iter().find(|object| object.id == draw.object) else {
        return Ok(Vec::new());
    };
    let Some(index) = object.look_of(draw) else { return Ok(Vec::new()) };
    let Some(look) = setup.looks.get(index) else { return Ok(Vec::new()) };
    let lights = setup.object_lights((plan, draw), library, time)?;
    let reach = setup.light_reach_of(object);
    let mut kept_away = setup.layer_reach_of((object, index), &reach, library, time);
    kept_away
        .retain(|layer| layer.reach.relation == LightRelation::Layered && !layer.reach.reaches);
    let mut accounts = Vec::new();
    for reach in reach {
        let Some(values) = lights.get(&reach.light) else { continue };
        if let Some(mut account) = account(setup, values, reach, surface)? {
            if account.reaches {
                let of_light = kept_away.iter().filter(|layer| layer.reach.light == account.light);
                // What is left out tells more than what is so, and stands first.
                let away = of_light.map(|layer| (&layer.reach.node, &layer.reach.words));
                let away: String = away
                    .map(|(node, why)| tr!("not {node}: {why}"))
                    .map(|away| format!("{away}; "))
                    .collect();
                account.rule = away + &account.rule;
                account.readings = readings(&look.look, library, &account.light, wires);
            }
            accounts.push(account);
        }
    }
    accounts.sort_by(|a, b| {
        (b.reaches, b.energy)
            .partial_cmp(&(a.reaches, a.energy))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    Ok(accounts)
}

/// Account of one light, without readings.
fn account(
    setup: &Setup,
    values: &LightValues,
    LightReach { light: id, reaches, words, .. }: LightReach,
    surface: &ProbedSurface,
) -> Result<Option<LightAccount>, Diagnostic> {
    let point = &surface.point;
    let Some(arrival) = Arrival::of(values, point.position)? else { return Ok(None) };
    let distance = match values.kind {
        LightKind::Directional => None,
        LightKind::Point | LightKind::Spot => Some(values.position().distance(point.position)),
    };
    let luminance = arrival.color.dot(DVec3::new(0.2126, 0.7152, 0.0722));
    let mut of_looks = setup.looks.iter().filter_map(|worn| worn.look.lights.get(&id));
    let light = setup.scene.lights.get(&id).or_else(|| of_looks.next());
    let name = light.map_or(id.as_str(), |light| light.display_name(&id)).to_owned();
    Ok(Some(LightAccount {
        name,
        light: id,
        reaches,
        rule: words,
        facing: point.normal.dot(arrival.toward).clamp(-1.0, 1.0).acos(),
        distance,
        energy: if reaches { luminance * arrival.intensity } else { 0.0 },
        readings: Vec::new(),
    }))
}

/// Values of single numbers that nodes computed about a light alone.
fn readings(
    look: &Look,
    library: &Library,
    light: &LightId,
    wires: &[WireValue],
) -> Vec<LightReading> {
    let mut readings: Vec<LightReading> = Vec::new();
    for wire in wires.iter().filter(|wire| wire.light.as_ref() == Some(light)) {
        let [value] = wire.double[..] else { continue };
        let Some(label) = label_of(look, library, &wire.node) else { continue };
        let reading = LightReading { node: wire.node.clone(), label, value };
        // A function that is called again has the same values.
        if !readings.contains(&reading) {
            readings.push(reading);
        }
    }
    readings
}

/// The label of a node's output.
fn label_of(look: &Look, library: &Library, path: &NodePath) -> Option<String> {
    let def = library.nodes.get(&library.node_of(look, path.ids())?.1.kind)?;
    Some(def.outputs.first()?.label.clone())
}
