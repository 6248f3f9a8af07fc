//! Edits of a look or a scene, told as overrides of the shot over them.

use chiaro_locale::tr;
use serde_json::Value as Json;

use super::{OpenShot, ShotAddress, key_at};
use crate::diag::Diagnostic;
use crate::document::{
    BlendKind, ChangedTo, Extrapolation, FrameRate, Override, Scene, ShotEdit, ShotKey,
    TimeInterpolation, TimeKey, TimeKeys, TimeRange, UnknownFields, Value, ValueDifference,
    json_of_value,
};
use crate::frame::Track;
use crate::state::keying::split::with_key;

/// Writer of overrides, at a time.
pub(crate) struct ShotWriter<'s> {
    shot: &'s OpenShot,
    /// Path of the look whose values are written; `None` for those of the scene.
    look: Option<String>,
    /// Frame of a key that is set now.
    frame: f64,
    edits: Vec<ShotEdit>,
}

impl<'s> ShotWriter<'s> {
    /// A writer of values of a look, by its path as changes tell it, or of the scene. `time` is in
    /// seconds.
    pub(crate) fn new(shot: &'s OpenShot, look: Option<String>, time: f64) -> Self {
        Self { shot, look, frame: shot.rate().frame_within(time), edits: Vec::new() }
    }

    /// The edit of the shot; `None` where nothing is to be changed.
    pub(crate) fn finish(mut self) -> Option<ShotEdit> {
        match self.edits.len() {
            0 => None,
            1 => self.edits.pop(),
            _ => Some(ShotEdit::Group { edits: self.edits }),
        }
    }

    fn at(&self, target: &str) -> ShotAddress {
        ShotAddress { look: self.look.clone(), target: target.to_owned() }
    }

    /// Writes what has become of values. `value_of` gives the present value of a target, its
    /// default included.
    ///
    /// # Errors
    /// A change that no override says.
    pub(crate) fn write(
        &mut self,
        differences: Vec<ValueDifference>,
        value_of: &dyn Fn(&str) -> Option<Value>,
    ) -> Result<(), Diagnostic> {
        // A value beside keys, or without them any more, is what the keys leave.
        let of_keys =
            |it: &ValueDifference| matches!(it.to, ChangedTo::Keys(_) | ChangedTo::Unkeyed);
        let keyed: Vec<String> =
            differences.iter().filter(|it| of_keys(it)).map(|it| it.target.clone()).collect();
        for ValueDifference { target, to } in differences {
            match to {
                ChangedTo::Value(_) if keyed.contains(&target) => {}
                ChangedTo::Value(value) => self.set(&target, value),
                ChangedTo::Keys(keys) => match self.set_within_group(&target, &keys) {
                    Some(value) => self.set(&target, value),
                    None => self.key_all(&target, &keys),
                },
                ChangedTo::Unkeyed | ChangedTo::Default => {
                    let is_default = to == ChangedTo::Default;
                    if is_default && self.shot.own(&self.at(&target)).is_some() {
                        self.take_back(&target);
                        continue;
                    }
                    let Some(value) = value_of(&target) else {
                        let message = tr!("`{target}` without a value is nothing of a shot");
                        return Err(Diagnostic::error("not-of-a-shot", message));
                    };
                    if is_default {
                        self.set(&target, value);
                    } else {
                        self.set_for_all(&target, value);
                    }
                }
            }
        }
        Ok(())
    }

    /// The value that is set of one use of a group, where the shot has set one already: the look
    /// has that as a key, beside which another came, or which was changed.
    fn set_within_group(&self, target: &str, track: &TimeKeys) -> Option<Value> {
        let own = self.shot.own(&self.at(target)).and_then(|own| own.value.as_ref());
        let own = own.filter(|_| target.contains('/'))?;
        track.keys.iter().rev().map(|key| &key.value).find(|value| *value != own).cloned()
    }

    /// Sets a value: at the present frame where it moves, else for all frames.
    pub(crate) fn set(&mut self, target: &str, value: Value) {
        let standing = self.shot.resolved().change_of(self.look.as_deref(), target);
        match standing.is_some_and(|change| change.is_keyed) {
            true => self.key_here(target, value),
            false => self.set_for_all(target, value),
        }
    }

    /// Sets a value for all frames, in place of keys.
    pub(crate) fn set_for_all(&mut self, target: &str, value: Value) {
        let at = self.at(target);
        // A value as it is without this shot needs no override.
        let own = self.shot.own(&at);
        let standing = self.shot.resolved().change_of(at.look.as_deref(), target);
        let under = own.and(standing).map(|change| &change.from);
        if under.is_some_and(|under| same_json(under, &json_of_value(&value))) {
            return self.take_back(target);
        }
        let mut change = own.cloned().unwrap_or_else(|| self.new_override(target));
        (change.value, change.keys, change.step) = (Some(value), Vec::new(), 1);
        self.edits.push(ShotEdit::set_override(change));
    }

    /// Sets a key at the present frame, beside those that stand.
    pub(crate) fn key_here(&mut self, target: &str, value: Value) {
        let at = self.at(target);
        let mut change = self.keyed_override(&at);
        let keys = &mut change.keys;
        match key_at(keys, self.frame) {
            Some(place) => keys[place].value = value,
            None => {
                let place = keys.partition_point(|key| key.frame < self.frame);
                let before = keys.get(place.wrapping_sub(1)).map(|key| key.interpolation);
                let interpolation = before.unwrap_or(TimeInterpolation::Bezier);
                keys.insert(place, ShotKey::new(self.frame, value, interpolation));
            }
        }
        self.edits.push(ShotEdit::set_override(change));
    }

    /// Adds a key at the present frame that leaves the curve of the standing keys as it is; of a
    /// value without keys, the first one, with `value`.
    pub(crate) fn add_key(&mut self, target: &str, value: Value, blend: BlendKind) {
        let mut change = self.keyed_override(&self.at(target));
        if key_at(&change.keys, self.frame).is_some() {
            return;
        }
        let keys: Vec<TimeKey> = change.keys.iter().map(ShotKey::timed).collect();
        // Quaternions of either sign are the same rotation: between these there is no curve.
        let turns_back = |pair: &[TimeKey]| match (&pair[0].value, &pair[1].value) {
            (Value::Vector(a), Value::Vector(b)) => {
                a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() < 0.0
            }
            _ => false,
        };
        let has_curve = blend != BlendKind::Rotation || !keys.windows(2).any(turns_back);
        let track = Track { keys: &keys, ends: change.ends(), turns: blend != BlendKind::Numbers };
        match with_key(track, self.frame).filter(|_| has_curve) {
            Some(keys) => {
                change.keys = keys.into_iter().map(ShotKey::of_frames).collect();
                self.edits.push(ShotEdit::set_override(change));
            }
            None => self.key_here(target, value),
        }
    }

    /// The override that is to have keys: this shot's own, with the keys and the step of the one
    /// that stands.
    fn keyed_override(&self, at: &ShotAddress) -> Override {
        let fresh = self.new_override(&at.target);
        match self.shot.own(at).or_else(|| self.farther(at)) {
            Some(standing) => Override { look: fresh.look, value: None, ..standing.clone() },
            None => fresh,
        }
    }

    /// Sets all keys of a value, in seconds.
    fn key_all(&mut self, target: &str, track: &TimeKeys) {
        let rate = self.shot.rate();
        let mut change = self.keyed_override(&self.at(target));
        let in_frames = |handles: &[[f64; 2]]| {
            handles.iter().map(|[time, value]| [time * rate.per_second(), *value]).collect()
        };
        let key = |key: &TimeKey| {
            ShotKey::of_frames(TimeKey {
                time: rate.frame_within(key.time),
                incoming: in_frames(&key.incoming),
                outgoing: in_frames(&key.outgoing),
                unknown: UnknownFields::new(),
                ..key.clone()
            })
        };
        change.keys = track.keys.iter().map(key).collect();
        (change.before, change.after) = (track.before, track.after);
        self.edits.push(ShotEdit::set_override(change));
    }

    /// Takes this shot's override of a value back.
    pub(crate) fn take_back(&mut self, target: &str) {
        let own = self.shot.own(&self.at(target));
        if let Some(own) = own {
            self.edits.push(ShotEdit::take_back(own.look.clone(), own.target.clone()));
        } else if target.starts_with("camera.") && self.shot.shot().camera.is_some() {
            self.edits.push(ShotEdit::SetShotCamera { camera: None });
        }
    }

    /// Writes a range of times as frames.
    pub(crate) fn set_time(&mut self, before: TimeRange, after: TimeRange) {
        let rate = match after.fps == before.fps {
            true => self.shot.rate(),
            false => {
                let rate = rate_of(after.fps);
                self.edits.push(ShotEdit::SetRate { rate: Some(rate) });
                rate
            }
        };
        let first = rate.frame_within(after.start).round() as i32;
        let last = (rate.frame_within(after.end).round() as i32).max(first);
        self.edits.push(ShotEdit::SetFrames { frames: Some([first, last]) });
    }

    /// Writes a camera in place of the shot's own, where it has one and changes no single value of
    /// it. Returns true if so.
    pub(crate) fn set_camera(&mut self, after: &Scene) -> bool {
        let shot = self.shot.shot();
        let is_single = shot
            .overrides
            .iter()
            .any(|change| change.look.is_none() && change.target.starts_with("camera."));
        let is_whole = shot.camera.is_some() && !is_single;
        if is_whole {
            self.edits.push(ShotEdit::SetShotCamera { camera: Some(after.camera) });
        }
        is_whole
    }

    /// The override of a value in the nearest of the shots under this one.
    fn farther(&self, at: &ShotAddress) -> Option<&'s Override> {
        let change = self.shot.resolved().change_of(at.look.as_deref(), &at.target)?;
        let file = self.shot.stack().shots.iter().find(|file| file.path == change.by)?;
        let index = change.json_path.strip_prefix("overrides[")?.strip_suffix(']')?;
        let change = file.shot.overrides.get(index.parse::<usize>().ok()?)?;
        change.value.is_none().then_some(change)
    }

    fn new_override(&self, target: &str) -> Override {
        Override {
            look: self.look.as_deref().map(|look| self.shot.name_of(look)),
            target: target.to_owned(),
            value: None,
            keys: Vec::new(),
            before: Extrapolation::Hold,
            after: Extrapolation::Hold,
            step: 1,
            unknown: Default::default(),
        }
    }
}

/// The rate of so many frames per second.
fn rate_of(fps: f64) -> FrameRate {
    // Rates of television are written with three digits.
    let written = [format!("{fps}"), format!("{fps:.3}"), format!("{}", fps.round())];
    written.iter().find_map(|text| text.parse().ok()).unwrap_or(FrameRate::FILM)
}

/// True if two values of files mean the same, however their numbers are written.
fn same_json(one: &Json, two: &Json) -> bool {
    match (one, two) {
        (Json::Number(a), Json::Number(b)) => a.as_f64() == b.as_f64(),
        (Json::Array(a), Json::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same_json(a, b))
        }
        _ => one == two,
    }
}
