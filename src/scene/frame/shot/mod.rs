//! Shots: a scene as documents over it change it.
//!
//! [`ShotStack`] reads a shot and all that it changes, down to the scene. `resolve` puts every
//! override into the scene and its looks, the farthest document first, so that the nearest wins,
//! and lists them ([`ValueChange`]). Values of lights and looks that are keyed become time keys
//! there; all others that move are put into the scene when a frame is planned (`moving`).

mod keys;
mod moving;
mod resolve;
mod stack;

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde_json::Value as Json;

use super::setup::{Setup, SetupLook};
use crate::diag::Diagnostic;
use crate::document::{FrameRate, Scene, TimeKeys, Value, value_address};
use crate::files::shortened;
use keys::held_track;
use moving::MovingValue;

pub use resolve::ShotResolver;
pub use resolve::open_shot;
pub use stack::{ShotFile, ShotStack, scene_of};

/// A shot, put into a setup.
#[derive(Clone, Debug)]
pub struct ResolvedShot {
    /// The shot and the shots that it changes, the nearest first, and the scene under them.
    pub stack: ShotStack,
    /// Values that are changed, in the order in which they are: the farthest document first.
    pub changes: Vec<ValueChange>,
    pub(in crate::frame) moving: Vec<MovingValue>,
    pub(in crate::frame) clock: FrameClock,
}

/// A value that a shot changes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ValueChange {
    /// Path of the look that it is of; `None` for a value of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub look: Option<String>,
    /// Address of the value in the look or the scene.
    pub target: String,
    /// The value before the document changed it; null for a node's own default.
    pub from: Json,
    /// The value afterwards; of keys the list of them.
    pub to: Json,
    /// True if the value is keyed.
    pub is_keyed: bool,
    /// Frames for which a keyed value is held.
    pub step: u32,
    /// File that changes it.
    pub by: PathBuf,
    /// JSON path of the change in that file.
    #[serde(skip)]
    pub json_path: String,
    /// True unless a nearer document changes the value again.
    pub stands: bool,
}

impl ValueChange {
    /// The value in words: the look that it is of, if any, and its place there.
    pub fn address(&self) -> String {
        value_address(self.look.as_deref(), &self.target)
    }
}

impl ResolvedShot {
    /// True if the shot changes values of the look.
    pub fn changes_look(&self, look: &SetupLook) -> bool {
        self.changes_of(look).next().is_some()
    }

    /// A scene, resolved under the shot, as values that keys of the shot move are at a time, in
    /// seconds.
    pub fn scene_at<'s>(&self, scene: &'s Scene, time: f64) -> Cow<'s, Scene> {
        let mut scene = Cow::Borrowed(scene);
        for moving in &self.moving {
            self.put(moving, scene.to_mut(), time);
        }
        scene
    }

    /// True if keys of the shot move an object or its values.
    pub fn moves_objects(&self) -> bool {
        self.moving.iter().any(|moving| moving.object().is_some())
    }

    /// The time of the frame that everything which shades is held at, in seconds.
    pub fn shading_time(&self, time: f64) -> f64 {
        self.clock.held(time, self.clock.shading_step)
    }

    /// The time of the frame that is held at a time where a value is held for so many frames, as
    /// the picture shows it. In seconds.
    pub fn held_time(&self, time: f64, step: u32) -> f64 {
        self.clock.held(self.shading_time(time), step)
    }

    /// Holds the values of tracks of a setup's lights and looks, as the shot says.
    pub fn hold_tracks(&self, setup: &mut Setup) {
        self.hold_those_of(None, &mut setup.scene.time_keys);
        for worn in &mut setup.looks {
            if self.changes_look(worn) {
                let name = Self::name_of_look(worn.source.file().as_ref());
                self.hold_those_of(Some(&name), &mut worn.look.time_keys);
            }
        }
    }

    fn hold_those_of(&self, look: Option<&str>, tracks: &mut [TimeKeys]) {
        for track in tracks {
            let change = self.change_of(look, &track.target.to_string());
            if let Some(change) = change.filter(|change| change.is_keyed && change.step > 1)
                && let Some(held) = held_track(self.clock, track, change.step)
            {
                *track = held;
            }
        }
    }

    /// The change of a value that stands; `look` by its path as changes tell it.
    pub fn change_of(&self, look: Option<&str>, target: &str) -> Option<&ValueChange> {
        let is_it = |change: &&ValueChange| {
            change.stands && change.look.as_deref() == look && change.target == target
        };
        self.changes.iter().find(is_it)
    }

    /// Path of a look's file as changes tell it.
    pub fn name_of_look(file: &Path) -> String {
        shortened(file).display().to_string()
    }

    /// Single values of the camera that the shot changes, as they are in `scene`.
    pub(in crate::frame) fn camera_values(&self, scene: &Scene) -> Vec<(String, Value)> {
        let of_camera = |change: &&ValueChange| {
            change.stands && change.look.is_none() && change.target.starts_with("camera.")
        };
        let read = |change: &ValueChange| {
            let json = scene.value_at(&change.target).ok()?.value;
            Some((change.target.clone(), serde_json::from_value(json).ok()?))
        };
        self.changes.iter().filter(of_camera).filter_map(read).collect()
    }

    fn changes_of(&self, look: &SetupLook) -> impl Iterator<Item = &ValueChange> {
        let name = Self::name_of_look(look.source.file().as_ref());
        self.changes
            .iter()
            .filter(move |change| change.stands && change.look.as_deref() == Some(name.as_str()))
    }

    /// Gives a problem of a value of a look the place in the shot that changes the value, if the
    /// shot does.
    pub fn locate(&self, look: &SetupLook, problem: &mut Diagnostic) {
        let place = &problem.place;
        let of_input = place.node.as_ref().zip(place.port.as_ref());
        let of_input = of_input.map(|(node, port)| format!("{node}.{port}"));
        // Keys of the look come from the shot, too.
        let of_key = place.json_path.as_deref().and_then(|path| {
            let index = path.strip_prefix("time_keys[")?.split(']').next()?;
            Some(look.look.time_keys.get(index.parse::<usize>().ok()?)?.target.to_string())
        });
        let Some(target) = of_key.or(of_input) else { return };
        let Some(change) = self.changes_of(look).find(|change| change.target == target) else {
            return;
        };
        let Some(file) = self.stack.shots.iter().find(|file| file.path == change.by) else {
            return;
        };
        problem.place.file = None;
        problem.place.json_path = Some(change.json_path.clone());
        problem.place.at = None;
        file.source.locate(problem);
    }
}

/// Frames of a shot, and those that are held.
#[derive(Clone, Copy, Debug)]
pub(super) struct FrameClock {
    /// The shot's first frame.
    pub(super) first: i32,
    /// The shot's last frame.
    pub(super) last: i32,
    pub(super) rate: FrameRate,
    /// Frames for which everything that shades is held.
    pub(super) shading_step: u32,
}

impl FrameClock {
    /// The time of the frame that is held at a time, of `step` frames counted from the shot's
    /// first. In seconds. A time that was rounded in between is that of its frame.
    pub(super) fn held(self, time: f64, step: u32) -> f64 {
        if step <= 1 {
            return self.rate.exact(time);
        }
        let frame = self.rate.frame_at(time);
        self.rate.time(self.held_frame(frame, step))
    }

    /// The frame that is held at a frame.
    pub(super) fn held_frame(self, frame: i32, step: u32) -> i32 {
        let (first, step) = (i64::from(self.first), i64::from(step.max(1)));
        let held = first + (i64::from(frame) - first).div_euclid(step) * step;
        held.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_held_from_the_first_on() {
        let clock = FrameClock { first: 1, last: 9, rate: FrameRate::FILM, shading_step: 1 };
        let held = |step| [0, 1, 2, 3, 4, 5].map(|frame| clock.held_frame(frame, step));
        assert_eq!(held(1), [0, 1, 2, 3, 4, 5]);
        assert_eq!(held(2), [-1, 1, 1, 3, 3, 5]);
        assert_eq!(held(3), [-2, 1, 1, 1, 4, 4]);
        assert_eq!(clock.held(FrameRate::FILM.time(4), 2), FrameRate::FILM.time(3));
        for frame in 1..10 {
            let rounded = (FrameRate::FILM.time(frame) * 1e6).round() / 1e6;
            for step in [1, 2, 3] {
                let held = FrameRate::FILM.time(clock.held_frame(frame, step));
                assert_eq!(clock.held(rounded, step), held, "{frame} by {step}");
            }
        }
        assert_eq!(clock.held(0.123, 1), 0.123, "on ones nothing is held, between frames either");
    }
}
