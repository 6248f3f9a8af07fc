//! Keys of a camera, made of the cameras of frames, such as those of a mesh's file.
//!
//! Every frame could have a key, and nobody could edit them. So the first and the last frame have
//! one, then the frame that the curves between them miss most, and so on until they miss none.

use std::collections::BTreeSet;

use glam::DVec3;

use crate::document::{
    Camera, Extrapolation, HandlePair, Override, ShotKey, TimeInterpolation, TimeKey, TrackEnds,
    Value,
};
use crate::frame::Track;

/// Greatest distance of an eye or a target from where a frame has it, as a share of their distance
/// from each other: a pixel of a picture of usual width. Of a direction of length 1 by itself.
const OFF: f64 = 5e-4;
/// Sine of the angle by which a camera leans to the side that counts as none.
const UPRIGHT: f64 = 1e-4;
/// Difference of numbers that are the same, which files have in 32 bits.
const SAME: f64 = 1e-6;

/// Value of the camera over frames.
struct CameraPath {
    target: &'static str,
    /// True for a direction, which turns.
    turns: bool,
    values: Vec<[f64; 3]>,
    /// Distance from each value that is not seen.
    allowed: Vec<f64>,
}

impl CameraPath {
    fn moves(&self) -> bool {
        let first = DVec3::from(self.values[0]);
        self.values.iter().any(|value| DVec3::from(*value).distance(first) > SAME)
    }

    /// Keys at frames, counted from the first, with handles along the path; directions have
    /// automatic ones.
    fn keys(&self, frames: &[usize]) -> Vec<TimeKey> {
        let key = |(index, &frame): (usize, &usize)| {
            let value = Value::Vector(self.values[frame].map(tidy).to_vec());
            let key = TimeKey::new(frame as f64, value, TimeInterpolation::Bezier);
            if self.turns {
                return key;
            }
            let toward = |other: Option<&usize>| -> Vec<[f64; 2]> {
                let Some(reach) = other.map(|&other| other as f64 - frame as f64) else {
                    return Vec::new();
                };
                let slope = self.slope(frame, reach > 0.0);
                slope.map(|slope| [tidy(reach / 3.0), tidy(slope * reach / 3.0)]).to_vec()
            };
            let before = index.checked_sub(1).and_then(|before| frames.get(before));
            TimeKey {
                incoming: toward(before),
                outgoing: toward(frames.get(index + 1)),
                handles: HandlePair::Free,
                ..key
            }
        };
        frames.iter().enumerate().map(key).collect()
    }

    /// Change of the value from frame to frame at a frame, along the parabola through it and the
    /// two that follow or come before: a path may have a corner.
    fn slope(&self, frame: usize, is_after: bool) -> [f64; 3] {
        let at = |steps: usize| {
            let at = if is_after { Some(frame + steps) } else { frame.checked_sub(steps) };
            at.and_then(|at| self.values.get(at))
        };
        let way = if is_after { 1.0 } else { -1.0 };
        let here = self.values[frame];
        std::array::from_fn(|part| match (at(1), at(2)) {
            (Some(next), Some(other)) => {
                way * (2.0 * next[part] - 1.5 * here[part] - 0.5 * other[part])
            }
            (Some(next), None) => way * (next[part] - here[part]),
            _ => 0.0,
        })
    }

    /// Distance of a frame's value from the curve of some keys, in units of what is not seen.
    fn miss(&self, keys: &[TimeKey], frame: usize) -> f64 {
        let ends = TrackEnds { before: Extrapolation::Hold, after: Extrapolation::Hold };
        let found = Track { keys, ends, turns: self.turns }.at(frame as f64);
        let Some(Value::Vector(found)) = found else { return 0.0 };
        let found = <[f64; 3]>::try_from(found).map_or(DVec3::ZERO, DVec3::from);
        found.distance(self.values[frame].into()) / self.allowed[frame]
    }
}

/// A number as files have it.
fn tidy(number: f64) -> f64 {
    (number * 1e6).round() / 1e6
}

/// Overrides of a shot that make its camera that of these frames, from `first` on: of the eye, of
/// the target, and of the direction that is up. What does not move is set. The lens is not theirs.
pub(super) fn camera_overrides(first: i32, cameras: &[Camera]) -> Vec<Override> {
    if cameras.is_empty() {
        return Vec::new();
    }
    let paths = paths(cameras);
    let moving: Vec<&CameraPath> = paths.iter().filter(|path| path.moves()).collect();
    let frames = key_frames(&moving, cameras.len() - 1);
    let overridden = |path: &CameraPath| {
        let key =
            |key: TimeKey| ShotKey::of_frames(TimeKey { time: f64::from(first) + key.time, ..key });
        let moves = path.moves();
        Override {
            look: None,
            target: path.target.to_owned(),
            value: (!moves).then(|| Value::Vector(path.values[0].map(tidy).to_vec())),
            keys: match moves {
                true => path.keys(&frames).into_iter().map(key).collect(),
                false => Vec::new(),
            },
            before: Extrapolation::Hold,
            after: Extrapolation::Hold,
            step: 1,
            unknown: Default::default(),
        }
    };
    paths.iter().map(overridden).collect()
}

/// Values of the cameras that place them. A camera that never leans has one direction that is up,
/// so that no key of it has to follow the target.
fn paths(cameras: &[Camera]) -> [CameraPath; 3] {
    let values = |of: fn(&Camera) -> [f64; 3]| cameras.iter().map(of).collect::<Vec<_>>();
    let path = |target, turns, values, allowed| CameraPath { target, turns, values, allowed };
    let distance = |it: &Camera| DVec3::from(it.eye).distance(it.target.into());
    let seen: Vec<f64> = cameras.iter().map(|it| OFF * distance(it).max(SAME)).collect();
    let up = match cameras.iter().any(leans) {
        true => values(|it| it.up),
        false => vec![[0.0, 1.0, 0.0]; cameras.len()],
    };
    [
        path("camera.eye", false, values(|it| it.eye), seen.clone()),
        path("camera.target", false, values(|it| it.target), seen),
        path("camera.up", true, up, vec![OFF; cameras.len()]),
    ]
}

/// True for a camera that leans to a side, or looks along the vertical.
fn leans(camera: &Camera) -> bool {
    let forward = DVec3::from(camera.target) - DVec3::from(camera.eye);
    let (forward, up) = (forward.normalize_or_zero(), DVec3::from(camera.up).normalize_or_zero());
    let side = forward.cross(DVec3::Y);
    side.length() < UPRIGHT || up.y <= 0.0 || side.normalize().dot(up).abs() > UPRIGHT
}

/// Frames of the keys that all paths have, counted from the first.
fn key_frames(paths: &[&CameraPath], last: usize) -> Vec<usize> {
    let mut chosen = BTreeSet::from([0, last]);
    loop {
        let frames: Vec<usize> = chosen.iter().copied().collect();
        let curves: Vec<Vec<TimeKey>> = paths.iter().map(|path| path.keys(&frames)).collect();
        let miss = |frame: usize| {
            let of_paths = paths.iter().zip(&curves).map(|(path, keys)| path.miss(keys, frame));
            of_paths.fold(0.0, f64::max)
        };
        let worst = |between: &[usize]| {
            let inner = (between[0] + 1..between[1]).map(|frame| (frame, miss(frame)));
            inner.max_by(|one, other| one.1.total_cmp(&other.1)).filter(|(_, miss)| *miss > 1.0)
        };
        let missed: Vec<usize> = frames.windows(2).filter_map(worst).map(|it| it.0).collect();
        if missed.is_empty() {
            return frames;
        }
        chosen.extend(missed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(eye: [f64; 3], target: [f64; 3], up: [f64; 3]) -> Camera {
        Camera { eye, target, up, ..Camera::default() }
    }

    /// The value of an override at a frame.
    fn at(change: &Override, frame: f64) -> Vec<f64> {
        let keys: Vec<TimeKey> = change.keys.iter().map(ShotKey::timed).collect();
        let ends = TrackEnds { before: Extrapolation::Hold, after: Extrapolation::Hold };
        let track = Track { keys: &keys, ends, turns: change.target == "camera.up" };
        match track.at(frame).or(change.value.clone()) {
            Some(Value::Vector(numbers)) => numbers,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_smooth_path_has_a_few_keys_and_every_frame_is_where_it_was() {
        let frame = |index: i32| {
            let turn = f64::from(index) * 0.05;
            camera([5.0 * turn.sin(), 1.0 + turn, 5.0 * turn.cos()], [0.0; 3], [0.0, 1.0, 0.0])
        };
        let cameras: Vec<Camera> = (0..48).map(frame).collect();
        let changes = camera_overrides(1, &cameras);
        let named: Vec<&str> = changes.iter().map(|change| change.target.as_str()).collect();
        assert_eq!(named, ["camera.eye", "camera.target", "camera.up"]);
        let [eye, target, up] = changes.try_into().unwrap();
        assert!((3..20).contains(&eye.keys.len()), "{} keys", eye.keys.len());
        assert_eq!((eye.keys[0].frame, eye.keys.last().unwrap().frame), (1.0, 48.0));
        for (index, camera) in cameras.iter().enumerate() {
            let found = at(&eye, 1.0 + index as f64);
            let off = DVec3::from_slice(&found).distance(camera.eye.into());
            assert!(off < 5.0 * OFF * 1.5, "{off} at {index}");
        }
        // What stands still is set.
        assert_eq!(target.value, Some(Value::Vector(vec![0.0; 3])));
        assert_eq!(up.value, Some(Value::Vector(vec![0.0, 1.0, 0.0])));
    }

    #[test]
    fn a_leaning_camera_keeps_its_roll_and_a_cut_its_frame() {
        let frame = |index: i32| {
            let roll = 0.02 * f64::from(index);
            let x = if index < 10 { 0.0 } else { 3.0 };
            camera([x, 0.0, 4.0], [x, 0.0, 0.0], [roll.sin(), roll.cos(), 0.0])
        };
        let cameras: Vec<Camera> = (0..20).map(frame).collect();
        let [eye, _, up] = camera_overrides(0, &cameras).try_into().unwrap();
        assert_eq!(at(&eye, 9.0)[0], 0.0);
        assert_eq!(at(&eye, 10.0)[0], 3.0, "no frame lies in between");
        for (index, camera) in cameras.iter().enumerate() {
            let off = DVec3::from_slice(&at(&up, index as f64)).distance(camera.up.into());
            assert!(off < 2.0 * OFF, "{off} at {index}");
        }
    }

    #[test]
    fn one_frame_and_none_are_told_too() {
        assert!(camera_overrides(1, &[]).is_empty());
        let one = camera_overrides(1, &[Camera::default()]);
        assert!(one.iter().all(|change| change.keys.is_empty() && change.value.is_some()));
    }
}
