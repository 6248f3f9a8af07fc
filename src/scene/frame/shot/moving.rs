//! Values of a scene that move, put into a setup at a time.

use std::borrow::Cow;

use glam::DMat4;

use super::ResolvedShot;
use crate::document::{BlendKind, Object, TimeKey, TrackEnds, Transform};
use crate::frame::keys::Track;
use crate::frame::setup::{Setup, placed};
use crate::ids::ObjectId;

/// Parts of an object that shade it, and do not place it.
const SHADING: [&str; 8] = [
    "values",
    "linked",
    "unlinked",
    "shadowed",
    "unshadowed",
    "shadows_on",
    "no_shadows_on",
    "layers",
];

/// A value of the scene that keys of a shot move.
#[derive(Clone, Debug)]
pub(in crate::frame) struct MovingValue {
    pub(super) address: String,
    /// Keys by time, in seconds.
    pub(super) keys: Vec<TimeKey>,
    pub(super) ends: TrackEnds,
    pub(super) blend: BlendKind,
    /// Frames for which the value is held.
    pub(super) step: u32,
}

impl MovingValue {
    /// Id of the object whose value it is.
    pub(super) fn object(&self) -> Option<&str> {
        object_of(&self.address).map(|(id, _)| id)
    }

    /// The keys as they are evaluated.
    fn track(&self) -> Track<'_> {
        let turns = matches!(self.blend, BlendKind::Direction | BlendKind::Rotation);
        Track { keys: &self.keys, ends: self.ends, turns }
    }

    /// True if the value is one of those that a stepped look holds.
    fn shades(&self) -> bool {
        match object_of(&self.address) {
            Some((_, field)) => SHADING.contains(&field),
            None => {
                let first = self.address.split('.').next().unwrap_or_default();
                ["lights", "light_groups", "muted", "soloed", "illumination"].contains(&first)
            }
        }
    }
}

/// Id of the object that an address is of, and the field of it.
pub(super) fn object_of(address: &str) -> Option<(&str, &str)> {
    let mut steps = address.strip_prefix("objects.")?.split('.');
    Some((steps.next()?, steps.next().unwrap_or_default()))
}

impl Setup {
    /// The setup as the shot over it has moved it at a time, in seconds. What a look or a light has
    /// in keys stays in keys.
    pub fn at(&self, time: f64) -> Cow<'_, Self> {
        let Some(shot) = self.shot.as_ref().filter(|shot| !shot.moving.is_empty()) else {
            return Cow::Borrowed(self);
        };
        let mut setup = self.clone();
        for moving in &shot.moving {
            shot.put(moving, &mut setup, time);
        }
        let touched: Vec<&str> = shot.moving.iter().filter_map(MovingValue::object).collect();
        for id in touched {
            let id = ObjectId::new(id);
            let (then, now) = (self.scene.objects.get(&id), setup.scene.objects.get(&id).cloned());
            if let (Some(then), Some(now)) = (then, now) {
                setup.place_again(&id, then, &now);
            }
        }
        Cow::Owned(setup)
    }

    /// The time at which everything that shades is seen, in seconds: that of the frame which a
    /// stepped look holds.
    pub fn shading_time(&self, time: f64) -> f64 {
        self.shot.as_ref().map_or(time, |shot| shot.clock.held(time, shot.clock.shading_step))
    }

    /// The time of the shot's first frame, in seconds; 0 without a shot.
    pub fn first_time(&self) -> f64 {
        self.shot.as_ref().map_or(0.0, |shot| shot.clock.rate.time(shot.clock.first))
    }

    /// Lets no key of the shot move what lies at an address or under it, where the command line or
    /// a view stands over it.
    pub fn hold(&mut self, address: &str) {
        let Some(shot) = self.shot.as_mut() else { return };
        let is_under = |moving: &MovingValue| {
            moving
                .address
                .strip_prefix(address)
                .is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        if shot.moving.iter().any(is_under) {
            std::sync::Arc::make_mut(shot).moving.retain(|moving| !is_under(moving));
        }
    }

    /// Takes over what has changed in an object of the scene.
    fn place_again(&mut self, id: &ObjectId, then: &Object, now: &Object) {
        if !now.visible {
            self.objects.retain(|object| object.id != *id);
            return;
        }
        let Some(object) = self.objects.iter_mut().find(|object| object.id == *id) else { return };
        if now.transform != then.transform {
            object.world_from_object =
                moved(&then.transform, &now.transform) * object.world_from_object;
        }
        object.values.clone_from(&now.values);
        object.light_link = now.light_link();
        object.shadow_link = now.shadow_link();
        object.layers.clone_from(&now.layers);
    }
}

/// The motion from one placement of an object to another one.
fn moved(from: &Transform, to: &Transform) -> DMat4 {
    placed(to, DMat4::IDENTITY) * placed(from, DMat4::IDENTITY).inverse()
}

impl ResolvedShot {
    /// Puts a value into the scene as it is at a time. One that cannot stand there, such as a scale
    /// on its way through 0, leaves the value before it.
    fn put(&self, moving: &MovingValue, setup: &mut Setup, time: f64) {
        let step = if moving.shades() { self.clock.shading_step } else { 1 };
        let time = self.clock.held(self.clock.held(time, step), moving.step);
        if let Some(value) = moving.track().at(time) {
            let _ = setup.scene.set_value(&moving.address, &value);
        }
    }
}
