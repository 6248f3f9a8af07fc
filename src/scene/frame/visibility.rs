//! Objects that cannot be seen, and lights that are dark: they are left out before any look is
//! compiled.
//!
//! Every test is conservative. An object is off-screen where the eight corners of its mesh's box
//! lie beyond one and the same side of the view; a light is dark for an object where it is out or
//! black, or where the sphere around the object lies beyond its range or outside of its cone.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::{Arc, Weak};

use chiaro_locale::tr;
use glam::{DMat3, DMat4, DVec3, DVec4};
use indexmap::IndexMap;

use super::camera::View;
use super::coverage::clip_corners;
use super::setup::{Setup, SetupObject};
use crate::compile::{LightValues, Proof};
use crate::document::{
    AimPlaces, Light, LightField, LightInput, LightKind, Look, ObjectFrame, Target,
};
use crate::geometry::{Bounds, Mesh};
use crate::ids::LightId;

/// Parts that a planner may leave out because they are not seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CullMode {
    /// Nothing is left out: the plans that all others are compared with.
    Nothing,
    /// Objects. For looks that are being edited, whose lights may change at any time.
    Objects,
    /// Objects, and lights that are dark.
    #[default]
    All,
}

/// Placement of an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct ObjectPlacement {
    /// Bounds of the object's mesh, in object space.
    pub(super) bounds: Bounds,
    /// Center of the mesh's box, in world space.
    pub(super) center: DVec3,
    /// Radius of a sphere around the center that holds the mesh, in scene units.
    pub(super) radius: f64,
}

/// Bounds of meshes, each computed once.
#[derive(Clone, Debug, Default)]
pub(super) struct KnownBounds(HashMap<usize, (Weak<Mesh>, Bounds)>);

impl KnownBounds {
    /// The placements of the objects.
    pub(super) fn place(&mut self, objects: &[SetupObject]) -> Vec<ObjectPlacement> {
        self.0.retain(|_, (mesh, _)| mesh.strong_count() > 0);
        objects.iter().map(|object| self.placed(object)).collect()
    }

    fn placed(&mut self, object: &SetupObject) -> ObjectPlacement {
        // The weak handle beside the bounds keeps the mesh's address from being used again, so the
        // address identifies the mesh.
        let key = Arc::as_ptr(&object.mesh) as usize;
        let fresh = || (Arc::downgrade(&object.mesh), object.mesh.bounds());
        let bounds = self.0.entry(key).or_insert_with(fresh).1;
        let (scale, ..) = object.world_from_object.to_scale_rotation_translation();
        ObjectPlacement {
            bounds,
            center: object.world_from_object.transform_point3(bounds.center()),
            radius: bounds.radius * scale.abs().max_element(),
        }
    }
}

/// The reason why nothing of an object is seen; `None` where something may be seen.
pub(super) fn hidden(
    object: &SetupObject,
    placed: &ObjectPlacement,
    view: &View,
) -> Option<(Proof, &'static str)> {
    if object.looks.iter().all(Option::is_none) {
        return Some((Proof::NoLook, tr!("no part of it wears a look")));
    }
    let worn = object.mesh.parts.iter().zip(&object.looks).filter(|(_, look)| look.is_some());
    if worn.clone().all(|(part, _)| part.indices.is_empty()) {
        return Some((Proof::NoSurface, tr!("what of it wears a look has no triangles")));
    }
    if is_line(object.world_from_object) {
        return Some((Proof::NoSurface, tr!("its scale leaves it no area")));
    }
    is_outside(object.world_from_object, &placed.bounds, view)
        .then_some((Proof::OffScreen, tr!("it lies outside of the picture")))
}

/// True if a transform flattens everything to a line or a point.
fn is_line(matrix: DMat4) -> bool {
    let DMat3 { x_axis: x, y_axis: y, z_axis: z } = DMat3::from_mat4(matrix);
    [x.cross(y), y.cross(z), z.cross(x)].iter().all(|area| *area == DVec3::ZERO)
}

fn is_outside(world_from_object: DMat4, bounds: &Bounds, view: &View) -> bool {
    let corners = clip_corners(world_from_object, bounds, view);
    if corners.iter().any(|corner| !corner.is_finite()) {
        return false;
    }
    // The margin beyond each side allows for the shader's f32: an object just beyond a side may
    // still be seen.
    let beyond = |side: fn(DVec4) -> f64| {
        corners.iter().all(|&corner| {
            side(corner) > 1e-4 * (corner.w.abs() + corner.truncate().length()) + 1e-12
        })
    };
    beyond(|c| c.x - c.w)
        || beyond(|c| -c.x - c.w)
        || beyond(|c| c.y - c.w)
        || beyond(|c| -c.y - c.w)
        || beyond(|c| c.z - c.w)
        || beyond(|c| -c.z)
}

/// Inputs from a look's lights that are known for an object because the light is dark there, each
/// with the reason; `lights` replace the look's, and `unlit` ones do not reach the object. Of the
/// others those that keys or exposed parameters move are never dark.
pub(super) fn dark_lights(
    (setup, aims): (&Setup, &Arc<AimPlaces>),
    look: &Look,
    lights: &IndexMap<LightId, Light>,
    (placed, object): (&ObjectPlacement, &SetupObject),
    view: &View,
    unlit: &IndexMap<LightId, Cow<'static, str>>,
) -> Vec<((LightId, LightInput), Cow<'static, str>)> {
    let mut moved = moved_lights(look);
    let keyed = setup.scene.keyed_lights();
    moved.extend(keyed.iter().flat_map(moved_lights));
    let frame = ObjectFrame::new(placed.center, object.world_from_object);
    let frames = setup.light_frames(view, frame, aims);
    let mut dark = Vec::new();
    for (id, own) in &look.lights {
        let mut put_out = |reason: &Cow<'static, str>| {
            dark.extend(LightInput::all_unlit().map(|input| ((id.clone(), input), reason.clone())));
        };
        if let Some(reason) = unlit.get(id) {
            put_out(reason);
            continue;
        }
        if moved.contains(id) {
            continue;
        }
        let light = lights.get(id).unwrap_or(own);
        let values = LightValues::new(light, &frames);
        // A lamp that is out casts no shadow: `PlannedCasters::tell` says the same.
        if values.intensity() == 0.0 {
            put_out(&tr!("its intensity is 0").into());
            continue;
        }
        let field = |field| (id.clone(), LightInput::Field(field));
        if values.color() == DVec3::ZERO {
            dark.push((field(LightField::Color), tr!("it is black").into()));
        }
        if let Some(reason) = why_out_of_reach(&values, placed) {
            dark.push((field(LightField::Intensity), reason.into()));
        }
    }
    dark
}

fn moved_lights(look: &Look) -> HashSet<&LightId> {
    let timed = look.time_keys.iter().map(|track| &track.target);
    let exposed = look.exposed.iter().map(|exposed| &exposed.target);
    let keyed = look
        .direction_keys
        .iter()
        .flat_map(|keys| keys.keys.iter().flat_map(|key| key.values.keys()));
    let lights = timed.chain(exposed).chain(keyed).filter_map(|target| match target {
        Target::Light { light, .. } => Some(light),
        Target::Input { .. } => None,
    });
    lights.collect()
}

fn why_out_of_reach(light: &LightValues, placed: &ObjectPlacement) -> Option<&'static str> {
    if light.kind == LightKind::Directional || !light.intensity().is_finite() {
        return None;
    }
    let offset = placed.center - light.position();
    let distance = offset.length();
    let range = light.range();
    // The range is taken a little larger, because the shader measures in f32.
    if range > 0.0 && distance - placed.radius > range * 1.0001 + 1e-5 * light.position().length() {
        return Some(tr!("everything that wears the look is beyond its range"));
    }
    // The cone is not tested for an object around the light: it lies in every direction from the
    // light.
    let is_around = distance <= placed.radius * 1.0001;
    if light.kind == LightKind::Spot && !is_around {
        let off_axis = light.aim().angle_between(offset);
        let spread = (placed.radius / distance).clamp(0.0, 1.0).asin();
        let outer = light.cone[1].clamp(-1.0, 1.0).acos();
        if off_axis - spread > outer + 1e-3 {
            return Some(tr!("everything that wears the look is outside of its cone"));
        }
    }
    None
}

/// The known inputs from dark lights, without the reasons.
pub(super) fn inputs_of(
    dark: &[((LightId, LightInput), Cow<'static, str>)],
) -> BTreeSet<(LightId, LightInput)> {
    dark.iter().map(|(input, _)| input.clone()).collect()
}
