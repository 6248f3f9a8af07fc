//! Placement of objects and camera, the objects that are seen, and the lights that replace a look's
//! lights of the same id.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use chiaro_locale::tr;
use glam::DVec3;
use indexmap::IndexMap;

use super::planner::Planner;
use super::{DroppedEffect, PlanOptions};
use crate::compile::Live;
use crate::document::{AimPlaces, Light, Look, Values};
use crate::frame::camera::View;
use crate::frame::cost::EffectCost;
use crate::frame::coverage::PixelArea;
use crate::frame::effects::EffectKind;
use crate::frame::keys::{SceneRig, structural_look};
use crate::frame::layers::with_lights_of;
use crate::frame::mix::LightMix;
use crate::frame::nearest::nearest_surface;
use crate::frame::setup::{Setup, SetupLook, SetupObject};
use crate::frame::values::live_for_values;
use crate::frame::visibility::{CullMode, ObjectPlacement, hidden};
use crate::ids::{LightId, ObjectId};
use crate::library::Library;

/// A scene whose objects and camera are placed for a picture.
pub(super) struct PlacedScene<'a> {
    pub(super) setup: &'a Setup,
    pub(super) library: &'a Library,
    pub(super) options: &'a PlanOptions,
    /// Kind of liveness of each look.
    pub(super) lives: Vec<Live>,
    /// Looks with the words that they have at the time, on objects that set no values.
    looks: Vec<Cow<'a, Look>>,
    /// Placement of each object.
    pub(super) placed: Vec<ObjectPlacement>,
    pub(super) view: View,
    /// Mutes, solos and masters of the lights.
    pub(super) mix: LightMix,
    /// Keys of the scene's lights; `None` where it has none.
    pub(super) rig: Option<Arc<SceneRig>>,
    /// Places of objects that lights are aimed at.
    pub(super) aims: Arc<AimPlaces>,
}

/// An object of which something may be seen, with its number in the scene.
#[derive(Clone, Copy)]
pub(super) struct VisibleObject<'a> {
    pub(super) number: usize,
    pub(super) object: &'a SetupObject,
}

impl PlacedScene<'_> {
    /// Lights that replace those that a look was compiled with: the scene's lights, and for a look
    /// that is being edited its own lights as they are now.
    pub(super) fn lights(&self, look: usize) -> Cow<'_, IndexMap<LightId, Light>> {
        let setup = self.setup;
        if setup.edited != Some(look) {
            return Cow::Borrowed(&setup.scene.lights);
        }
        let mut lights = setup.looks[look].look.lights.clone();
        lights.extend(setup.scene.lights.iter().map(|(id, light)| (id.clone(), light.clone())));
        Cow::Owned(lights)
    }

    /// The look of that number as an object wears it: with the words that the object's values set,
    /// and the lights that it gives to nodes.
    pub(super) fn worn(&self, look: usize, object: &SetupObject) -> Cow<'_, Look> {
        if object.values.is_empty() && object.layers.is_empty() {
            return Cow::Borrowed(&self.looks[look]);
        }
        self.setup.worn(look, object, self.library, self.options.time)
    }

    /// The center of each object, in world space.
    pub(super) fn centers(&self) -> HashMap<&ObjectId, DVec3> {
        let objects = self.setup.objects.iter().zip(&self.placed);
        objects.map(|(object, placed)| (&object.id, placed.center)).collect()
    }

    /// Pixels in which the visible objects may be seen.
    pub(super) fn covered(&self, visible: &[VisibleObject<'_>]) -> PixelArea {
        visible.iter().map(|visible| self.area(visible)).fold(PixelArea::EMPTY, PixelArea::joined)
    }

    /// Pixels in which an object may be seen.
    pub(super) fn area(&self, VisibleObject { number, object }: &VisibleObject<'_>) -> PixelArea {
        let bounds = &self.placed[*number].bounds;
        PixelArea::of_box(object.world_from_object, bounds, &self.view, self.options.size)
    }

    /// Pixels of the whole picture.
    pub(super) fn whole(&self) -> PixelArea {
        PixelArea::whole(self.options.size)
    }
}

impl Planner {
    /// Places the objects and the camera.
    pub(super) fn place<'a>(
        &mut self,
        setup: &'a Setup,
        library: &'a Library,
        live: &Live,
        options: &'a PlanOptions,
    ) -> PlacedScene<'a> {
        let placed = self.bounds.place(&setup.objects);
        let (center, radius) = bounds(&placed);
        let view = View::new(&setup.scene.camera, options.size, center, radius);
        let view = view.with_surface_at(nearest_surface(
            &setup.objects,
            &placed,
            view.eye,
            view.least_distance(),
        ));
        let none = Values::new();
        let now = |look: &'a SetupLook| {
            let look = structural_look(&look.look, library, options.time, &none);
            with_lights_of(&setup.scene, look)
        };
        let looks = setup.looks.iter().map(now).collect();
        let (lives, mix) = (lives(setup, live), setup.light_mix());
        self.scene_rig = SceneRig::of(&setup.scene, self.scene_rig.as_ref());
        let (rig, aims) =
            (self.scene_rig.clone(), setup.aim_places(|number| placed[number].center));
        PlacedScene { setup, library, options, lives, looks, placed, view, mix, rig, aims }
    }

    /// The objects of which something may be seen; the others are dropped.
    pub(super) fn visible<'a>(
        &self,
        scene: &PlacedScene<'a>,
        dropped: &mut Vec<DroppedEffect>,
    ) -> Vec<VisibleObject<'a>> {
        let mut visible = Vec::new();
        for (number, object) in scene.setup.objects.iter().enumerate() {
            let hidden = hidden(object, &scene.placed[number], &scene.view);
            match hidden.filter(|_| self.cull != CullMode::Nothing) {
                Some((proof, why)) => dropped.push(DroppedEffect {
                    what: tr!("object `{id}`", id = object.id),
                    why: why.to_owned(),
                    kind: EffectKind::Object,
                    proof,
                    look: None,
                    cost: EffectCost::bytes(4 * object.mesh.indices.len() as u64),
                }),
                None => visible.push(VisibleObject { number, object }),
            }
        }
        visible
    }
}

/// The liveness of each look: looks whose objects set values by name are live for these values at
/// least.
fn lives(setup: &Setup, live: &Live) -> Vec<Live> {
    let sets_values = |look: usize| {
        setup
            .objects
            .iter()
            .any(|object| !object.values.is_empty() && object.looks.contains(&Some(look)))
    };
    let asked = |look: usize| match setup.edited {
        Some(edited) if edited != look => &Live::Keyed,
        _ => live,
    };
    (0..setup.looks.len()).map(|look| live_for_values(asked(look), sets_values(look))).collect()
}

/// A text that is the same for equal values only; empty for none.
pub(super) fn values_key(values: &Values) -> String {
    if values.is_empty() { String::new() } else { format!("{values:?}") }
}

fn bounds(objects: &[ObjectPlacement]) -> (DVec3, f64) {
    let mut min = DVec3::INFINITY;
    let mut max = DVec3::NEG_INFINITY;
    for object in objects {
        min = min.min(object.center - object.radius);
        max = max.max(object.center + object.radius);
    }
    if min.is_finite() && max.is_finite() {
        (0.5 * (min + max), 0.5 * (max - min).length())
    } else {
        (DVec3::ZERO, 1.0)
    }
}
