//! Account of the lights at a probed pixel: which of them reach the object there, by which rule,
//! how strong each arrives, and what the look's own nodes make of it.

mod names;

use glam::{DQuat, DVec3};

use super::probe::WireValue;
use super::surface::ProbedSurface;
use crate::document::{Light, LightFrames, LightKind, LightValues, Look, ObjectFrame};
use crate::frame::{FramePlan, LightReach, Setup, SetupObject};
use crate::ids::{LightId, NodePath};
use crate::library::Library;
use names::LightNames;

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
    /// The rule that decides, in words.
    pub rule: String,
    /// Angle between the normal and the way to the light, in radians.
    pub facing: f64,
    /// Distance to the light, in scene units; `None` for a directional light.
    pub distance: Option<f64>,
    /// Luminance of the light's color times its intensity as it arrives: after masters, fading and
    /// cone, before filters and shadows. 0 for a light that does not reach.
    pub energy: f64,
    /// Values that nodes of the look computed about the light, in the order of computing. Values of
    /// groups that run for each light are not told apart, and left out.
    pub readings: Vec<LightReading>,
}

/// Accounts of all lights that the object at a pixel is about: those that reach it, by their
/// energy, then the others. `wires` and `surface` are what the probe read there.
pub fn light_accounts(
    setup: &Setup,
    library: &Library,
    plan: &FramePlan,
    wires: &[WireValue],
    surface: &ProbedSurface,
) -> Vec<LightAccount> {
    let draw = wires.first().map_or(surface.draw, |wire| wire.draw);
    let Some(draw) = plan.draws.get(draw) else { return Vec::new() };
    let Some(object) = setup.objects.iter().find(|object| object.id == draw.object) else {
        return Vec::new();
    };
    let part = object.mesh.parts.iter().position(|part| part.indices == draw.indices);
    let look = part.and_then(|part| object.looks.get(part).copied().flatten());
    let Some(look) = look.and_then(|look| setup.looks.get(look)).map(|worn| &worn.look) else {
        return Vec::new();
    };
    let place = ProbedPlace { setup, object, look, plan, surface };
    let names = LightNames { look, library };
    let reach = setup.light_reach().into_iter().filter(|reach| reach.object == object.id);
    let mut accounts: Vec<LightAccount> = reach
        .filter_map(|reach| {
            let mut account = place.account(reach)?;
            if account.reaches {
                account.readings = names.readings(&account.light, wires);
            }
            Some(account)
        })
        .collect();
    accounts.sort_by(|a, b| {
        (b.reaches, b.energy)
            .partial_cmp(&(a.reaches, a.energy))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    accounts
}

/// Surroundings of a probed pixel.
struct ProbedPlace<'a> {
    setup: &'a Setup,
    object: &'a SetupObject,
    look: &'a Look,
    plan: &'a FramePlan,
    surface: &'a ProbedSurface,
}

impl ProbedPlace<'_> {
    fn account(&self, reach: LightReach) -> Option<LightAccount> {
        let LightReach { light: id, reaches, words, .. } = reach;
        let of_looks = || self.setup.looks.iter().find_map(|worn| worn.look.lights.get(&id));
        let light = self.setup.scene.lights.get(&id).or_else(|| self.look.lights.get(&id));
        let light = light.or_else(of_looks)?;
        let values = self.values(light);
        let point = &self.surface.point;
        let (toward, distance) = match light.kind {
            LightKind::Directional => (values.direction(), None),
            LightKind::Point | LightKind::Spot => {
                let offset = values.position() - point.position;
                (offset.normalize_or(DVec3::Z), Some(offset.length()))
            }
        };
        let arriving = distance.map_or(1.0, |distance| {
            let cone = match light.kind {
                LightKind::Spot => cone(-toward.dot(values.aim()), values.cone),
                _ => 1.0,
            };
            fading(distance, light.half_distance, values.range()) * cone
        });
        let luminance = values.color().dot(DVec3::new(0.2126, 0.7152, 0.0722));
        let energy = if reaches { luminance * values.intensity() * arriving } else { 0.0 };
        Some(LightAccount {
            name: light.display_name(&id).to_owned(),
            light: id,
            reaches,
            rule: words,
            facing: point.normal.dot(toward).clamp(-1.0, 1.0).acos(),
            distance,
            energy,
            readings: Vec::new(),
        })
    }

    /// The light in world space, behind the masters of its groups.
    fn values(&self, light: &Light) -> LightValues {
        let scene = &self.setup.scene;
        let frames = LightFrames {
            illumination: DQuat::from_array(scene.illumination).normalize(),
            camera_from_world: self.plan.view.rotation(),
            object: ObjectFrame::new(self.object.center(), self.object.world_from_object),
            aims: self.setup.aims(),
        };
        let mut values = LightValues::new(light, &frames);
        for master in light.groups.iter().filter_map(|group| scene.light_groups.get(group)) {
            let (factor, tint) = master.factors();
            values.multiply(factor, tint);
        }
        values
    }
}

/// Part of a light that is left at a distance (docs/math.md 13).
fn fading(distance: f64, half: f64, range: f64) -> f64 {
    let faded = if half > 0.0 { 1.0 / (1.0 + (distance / half).powi(2)) } else { 1.0 };
    let end = if range > 0.0 { (1.0 - (distance / range).min(1.0).powi(4)).powi(2) } else { 1.0 };
    faded * end
}

/// Part of a spot's light at a cosine from its axis; `cone` has the cosines of its inner and outer
/// angle (docs/math.md 13).
fn cone(cosine: f64, [inner, outer]: [f64; 2]) -> f64 {
    if inner <= outer {
        return f64::from(u8::from(cosine >= outer));
    }
    let t = ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
