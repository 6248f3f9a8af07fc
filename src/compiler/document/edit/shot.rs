//! Edits of shots.

use chiaro_locale::tr;
use serde::{Deserialize, Serialize};

use super::{EditResult, Editable, all_or_none, labels, trial};
use crate::document::{Camera, FrameRate, Override, Shot, ShotMarker};

/// Edit of a shot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "edit", rename_all = "snake_case")]
#[allow(missing_docs, reason = "the fields are named after what they set")]
pub enum ShotEdit {
    /// Several edits as one: all or none.
    Group { edits: Vec<ShotEdit> },
    /// Replaces the whole shot, as when another program changed its file.
    Replace { shot: Box<Shot> },
    /// Names the shot.
    SetShotName { name: String },
    /// Sets the override of a value, in the place of the one that the shot has for it or at an
    /// index, else as the last; `None` takes the override back.
    SetOverride {
        look: Option<String>,
        target: String,
        change: Option<Box<Override>>,
        index: Option<usize>,
    },
    /// Sets the first and the last frame.
    SetFrames { frames: Option<[i32; 2]> },
    /// Sets the frames per second.
    SetRate { rate: Option<FrameRate> },
    /// Sets the size of the picture, in pixels.
    SetSize { size: Option<[u32; 2]> },
    /// Sets the frames for which everything that shades is held.
    SetStep { step: Option<u32> },
    /// Sets the greatest number of frames of a farm's task.
    SetChunk { chunk: Option<u32> },
    /// Sets the camera in place of that of what is changed.
    SetShotCamera { camera: Option<Camera> },
    /// Sets the frames that have a name.
    SetShotMarkers { markers: Vec<ShotMarker> },
}

impl ShotEdit {
    /// The edit that sets an override in the place of the one that a shot has for the value.
    pub fn set_override(change: Override) -> Self {
        let (look, target) = (change.look.clone(), change.target.clone());
        Self::SetOverride { look, target, change: Some(Box::new(change)), index: None }
    }

    /// The edit that takes an override back.
    pub fn take_back(look: Option<String>, target: String) -> Self {
        Self::SetOverride { look, target, change: None, index: None }
    }
}

impl Shot {
    /// Index of the override of a value that stands, where the shot has one; the look by its name
    /// in the shot.
    pub fn override_of(&self, look: Option<&str>, target: &str) -> Option<usize> {
        let is_it = |change: &Override| change.look.as_deref() == look && change.target == target;
        self.overrides.iter().rposition(is_it)
    }

    /// Applies an edit and returns the edit that undoes it.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; the shot is then as it was.
    pub fn apply(&mut self, edit: ShotEdit) -> EditResult<ShotEdit> {
        self.edit(edit, false)
    }

    /// Sets or takes back an override; returns the one before, with its index.
    fn exchange(
        &mut self,
        (look, target): (Option<&str>, &str),
        change: Option<Override>,
        index: Option<usize>,
    ) -> (Option<Box<Override>>, Option<usize>) {
        let before = self.override_of(look, target);
        match (before, change) {
            (Some(at), Some(change)) => {
                let old = std::mem::replace(&mut self.overrides[at], change);
                (Some(Box::new(old)), Some(at))
            }
            (Some(at), None) => (Some(Box::new(self.overrides.remove(at))), Some(at)),
            (None, Some(change)) => {
                let last = self.overrides.len();
                self.overrides.insert(index.unwrap_or(last).min(last), change);
                (None, None)
            }
            (None, None) => (None, None),
        }
    }
}

impl Editable for Shot {
    type Edit = ShotEdit;

    fn edit(&mut self, edit: ShotEdit, is_known_good: bool) -> EditResult<ShotEdit> {
        use std::mem::replace;
        if !is_known_good {
            trial::check_shot(&edit)?;
        }
        Ok(match edit {
            ShotEdit::Group { edits } => {
                ShotEdit::Group { edits: all_or_none(self, edits, is_known_good)? }
            }
            ShotEdit::Replace { shot } => {
                ShotEdit::Replace { shot: Box::new(replace(self, *shot)) }
            }
            ShotEdit::SetShotName { name } => {
                ShotEdit::SetShotName { name: replace(&mut self.name, name) }
            }
            ShotEdit::SetOverride { look, target, change, index } => {
                let change = change.map(|change| *change);
                let (change, index) = self.exchange((look.as_deref(), &target), change, index);
                ShotEdit::SetOverride { look, target, change, index }
            }
            ShotEdit::SetFrames { frames } => {
                ShotEdit::SetFrames { frames: replace(&mut self.frames, frames) }
            }
            ShotEdit::SetRate { rate } => ShotEdit::SetRate { rate: replace(&mut self.rate, rate) },
            ShotEdit::SetSize { size } => ShotEdit::SetSize { size: replace(&mut self.size, size) },
            ShotEdit::SetStep { step } => ShotEdit::SetStep { step: replace(&mut self.step, step) },
            ShotEdit::SetChunk { chunk } => {
                ShotEdit::SetChunk { chunk: replace(&mut self.chunk, chunk) }
            }
            ShotEdit::SetShotCamera { camera } => {
                ShotEdit::SetShotCamera { camera: replace(&mut self.camera, camera) }
            }
            ShotEdit::SetShotMarkers { markers } => {
                ShotEdit::SetShotMarkers { markers: replace(&mut self.markers, markers) }
            }
        })
    }

    fn label(&self, edit: &ShotEdit) -> String {
        match edit {
            ShotEdit::Group { edits } => {
                let changed = edits.iter().map(|edit| match edit {
                    ShotEdit::SetOverride { target, change: Some(change), .. } => {
                        change.value.as_ref().map(|_| target)
                    }
                    _ => None,
                });
                let targets: Option<Vec<_>> = changed.collect();
                match (targets, &edits[..]) {
                    (Some(targets), [_, _, ..]) => {
                        tr!("change {target} in the shot", target = labels::names(targets))
                    }
                    (_, [first, ..]) => self.label(first),
                    _ => tr!("nothing").to_owned(),
                }
            }
            ShotEdit::Replace { .. } => tr!("load the file again").to_owned(),
            ShotEdit::SetShotName { .. } => tr!("rename the shot").to_owned(),
            ShotEdit::SetOverride { target, change, .. } => match change {
                None => tr!("reset {target}"),
                Some(change) if change.value.is_none() => tr!("key {target} in the shot"),
                Some(_) => tr!("change {target} in the shot"),
            },
            ShotEdit::SetFrames { .. } => tr!("change the frames").to_owned(),
            ShotEdit::SetRate { .. } => tr!("change the rate").to_owned(),
            ShotEdit::SetSize { .. } => tr!("change the size of the picture").to_owned(),
            ShotEdit::SetStep { .. } => tr!("change the step").to_owned(),
            ShotEdit::SetChunk { .. } => tr!("change the frames a task").to_owned(),
            ShotEdit::SetShotCamera { .. } => tr!("move the camera").to_owned(),
            ShotEdit::SetShotMarkers { .. } => tr!("change markers").to_owned(),
        }
    }

    fn does_nothing(edit: &ShotEdit) -> bool {
        match edit {
            ShotEdit::Group { edits } => edits.is_empty(),
            _ => false,
        }
    }

    fn is_annotation(edit: &ShotEdit) -> bool {
        match edit {
            ShotEdit::Group { edits } => edits.iter().all(Self::is_annotation),
            ShotEdit::SetShotName { .. }
            | ShotEdit::SetShotMarkers { .. }
            | ShotEdit::SetChunk { .. } => true,
            _ => false,
        }
    }

    fn covers(older: &ShotEdit, newer: &ShotEdit) -> bool {
        match (older, newer) {
            (
                ShotEdit::SetOverride { look: a, target: b, .. },
                ShotEdit::SetOverride { look, target, .. },
            ) => (a, b) == (look, target),
            // A drag of a vector, or of a light by its place, sets the same values each time.
            (ShotEdit::Group { edits: older }, ShotEdit::Group { edits: newer }) => {
                older.len() == newer.len()
                    && newer.iter().all(|new| older.iter().any(|old| Self::covers(old, new)))
            }
            (ShotEdit::SetShotName { .. }, ShotEdit::SetShotName { .. })
            | (ShotEdit::SetFrames { .. }, ShotEdit::SetFrames { .. })
            | (ShotEdit::SetRate { .. }, ShotEdit::SetRate { .. })
            | (ShotEdit::SetSize { .. }, ShotEdit::SetSize { .. })
            | (ShotEdit::SetStep { .. }, ShotEdit::SetStep { .. })
            | (ShotEdit::SetChunk { .. }, ShotEdit::SetChunk { .. })
            | (ShotEdit::SetShotCamera { .. }, ShotEdit::SetShotCamera { .. })
            | (ShotEdit::SetShotMarkers { .. }, ShotEdit::SetShotMarkers { .. }) => true,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{History, Value};

    fn brighter(intensity: f64) -> ShotEdit {
        ShotEdit::set_override(Override {
            look: None,
            target: "lights.key.intensity".to_owned(),
            value: Some(Value::Number(intensity)),
            keys: Vec::new(),
            before: Default::default(),
            after: Default::default(),
            step: 1,
            unknown: Default::default(),
        })
    }

    #[test]
    fn overrides_are_set_in_place_and_taken_back() {
        let text = r#"{"chiaro": "shot", "scene": "s.json", "overrides": [
            {"target": "lights.key.intensity", "value": 2},
            {"target": "camera.fov", "value": 0.5}]}"#;
        let shot = Shot::read(text, "").value.unwrap();
        let mut history = History::new(shot.clone());
        history.apply_in(1, brighter(3.0)).unwrap();
        history.apply_in(1, brighter(4.0)).unwrap();
        assert_eq!(history.steps(), (1, 0), "a drag is one step");
        assert_eq!(history.document().overrides[0].value, Some(Value::Number(4.0)));
        let back = ShotEdit::take_back(None, "lights.key.intensity".to_owned());
        history.apply(back).unwrap();
        assert_eq!(history.document().overrides.len(), 1);
        history.undo();
        assert_eq!(history.document().overrides[0].target, "lights.key.intensity");
        history.undo();
        assert_eq!(*history.document(), shot, "in its old place");
    }

    #[test]
    fn frames_of_a_task_are_the_shots_and_draw_nothing_else() {
        let mut history = History::new(Shot::default());
        let chunk = |chunk: u32| ShotEdit::SetChunk { chunk: Some(chunk) };
        history.apply_in(1, chunk(4)).unwrap();
        history.apply_in(1, chunk(6)).unwrap();
        assert_eq!((history.document().chunk, history.steps()), (Some(6), (1, 0)));
        assert!(Shot::is_annotation(&chunk(4)), "no picture is drawn anew");
        assert!(history.apply(chunk(0)).is_err(), "a task has a frame");
        history.undo();
        assert_eq!(history.document().chunk, None);
    }

    #[test]
    fn an_override_that_no_file_can_hold_is_refused() {
        let mut shot = Shot::default();
        let edit = brighter(f64::NAN);
        assert!(shot.apply(edit).is_err());
        assert_eq!(shot, Shot::default());
    }
}
