//! Edits of scenes.

use chiaro_locale::tr;
use serde::{Deserialize, Serialize};

use super::parts::{insert, remove_named};
use super::{EditResult, Editable, all_or_none, labels, missing, trial};
use crate::document::{
    Camera, DirectionKeys, FileCamera, GroupMaster, Light, LightSet, Marker, Object, Scene,
    SceneOutlines, Target, TimeKeys, TimeRange,
};
use crate::ids::{LightGroup, LightId, ObjectId};

/// Edit of a scene.
///
/// An `index` is the position of a new part among its like; without one the part comes last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "edit", rename_all = "snake_case")]
#[allow(missing_docs, reason = "the fields are named after what they set")]
pub enum SceneEdit {
    /// Several edits as one: all or none.
    Group { edits: Vec<SceneEdit> },
    /// Replaces the whole scene, as when another program changed its file.
    Replace { scene: Box<Scene> },
    /// Names the scene.
    SetSceneName { name: String },
    /// Sets the text on what the scene shows and how it is built.
    SetSceneAbout { about: String },
    /// Adds an object under a new id.
    AddObject { id: ObjectId, object: Box<Object>, index: Option<usize> },
    /// Changes an object.
    SetObject { id: ObjectId, object: Box<Object> },
    /// Removes an object.
    RemoveObject { id: ObjectId },
    /// Adds a light under a new id.
    AddLight { id: LightId, light: Light, index: Option<usize> },
    /// Changes a light.
    SetLight { id: LightId, light: Light },
    /// Removes a light with its keys.
    RemoveLight { id: LightId },
    /// Sets the keys of the scene's lights.
    SetLightKeys { direction_keys: Vec<DirectionKeys>, time_keys: Vec<TimeKeys> },
    /// Sets the times with names.
    SetMarkers { markers: Vec<Marker> },
    /// Sets the master of a group of lights; `None` for none.
    SetMaster { group: LightGroup, master: Option<GroupMaster>, index: Option<usize> },
    /// Sets the lights that are out.
    SetMutedLights { muted: LightSet },
    /// Sets the lights that shine alone.
    SetSoloedLights { soloed: LightSet },
    /// Sets the rotation of the illumination frame: a unit quaternion `[x, y, z, w]`.
    SetIllumination { rotation: [f64; 4] },
    /// Moves the camera.
    SetCamera { camera: Camera },
    /// Takes the camera from a mesh's file; `None` for the scene's own.
    SetFileCamera { camera: Option<FileCamera> },
    /// Changes the backdrop; `None` for transparent.
    SetBackdrop { color: Option<[f64; 4]> },
    /// Changes the lines over the picture.
    SetOutlines { outlines: SceneOutlines },
    /// Changes the time range.
    SetTime { time: TimeRange },
}

impl Scene {
    /// Applies an edit and returns the edit that undoes it.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; the scene is then as it was.
    pub fn apply(&mut self, edit: SceneEdit) -> EditResult<SceneEdit> {
        self.edit(edit, false)
    }

    /// The edit of the keys that leaves none of a light; `None` where it has none.
    fn keys_without(&self, id: &LightId) -> Option<SceneEdit> {
        let is_of = |target: &Target| matches!(target, Target::Light { light, .. } if light == id);
        let mut direction_keys = self.direction_keys.clone();
        direction_keys.retain(|keys| !keys.by.lights().contains(&id));
        for key in direction_keys.iter_mut().flat_map(|keys| &mut keys.keys) {
            key.values.retain(|target, _| !is_of(target));
        }
        let mut time_keys = self.time_keys.clone();
        time_keys.retain(|track| !is_of(&track.target));
        let is_same = direction_keys == self.direction_keys && time_keys == self.time_keys;
        (!is_same).then_some(SceneEdit::SetLightKeys { direction_keys, time_keys })
    }
}

impl Scene {
    /// Label of edits that are one step.
    fn label_of_several(&self, edits: &[SceneEdit]) -> String {
        let objects: Option<Vec<_>> = edits
            .iter()
            .map(|edit| match edit {
                SceneEdit::SetObject { id, object } => {
                    Some((id, self.objects.get(id), object.as_ref()))
                }
                _ => None,
            })
            .collect();
        let lights: Option<Vec<_>> = edits
            .iter()
            .map(|edit| match edit {
                SceneEdit::SetLight { id, light } => Some((id, self.lights.get(id), light)),
                _ => None,
            })
            .collect();
        match (objects, lights, edits) {
            (Some(objects), _, [_, _, ..]) => labels::of_objects(objects.into_iter()),
            (_, Some(lights), [_, _, ..]) => labels::of_lights(lights.into_iter()),
            (_, _, [first, ..]) => self.label(first),
            _ => tr!("nothing").to_owned(),
        }
    }
}

impl Editable for Scene {
    type Edit = SceneEdit;

    fn edit(&mut self, edit: SceneEdit, is_known_good: bool) -> EditResult<SceneEdit> {
        use std::mem::replace;
        if !is_known_good {
            trial::check_scene(&edit)?;
        }
        Ok(match edit {
            SceneEdit::Group { edits } => {
                SceneEdit::Group { edits: all_or_none(self, edits, is_known_good)? }
            }
            SceneEdit::Replace { scene } => {
                SceneEdit::Replace { scene: Box::new(replace(self, *scene)) }
            }
            SceneEdit::SetSceneName { name } => {
                SceneEdit::SetSceneName { name: replace(&mut self.name, name) }
            }
            SceneEdit::SetSceneAbout { about } => {
                SceneEdit::SetSceneAbout { about: replace(&mut self.about, about) }
            }
            SceneEdit::AddObject { id, object, index } => {
                insert(&mut self.objects, tr!("part" => "object"), id.clone(), *object, index)?;
                SceneEdit::RemoveObject { id }
            }
            SceneEdit::SetObject { id, object } => {
                let old = self
                    .objects
                    .get_mut(&id)
                    .ok_or_else(|| missing(tr!("part" => "object"), &id))?;
                SceneEdit::SetObject { object: Box::new(replace(old, *object)), id }
            }
            SceneEdit::RemoveObject { id } => {
                let (index, object) =
                    remove_named(&mut self.objects, tr!("part" => "object"), &id)?;
                SceneEdit::AddObject { id, object: Box::new(object), index: Some(index) }
            }
            SceneEdit::AddLight { id, light, index } => {
                insert(&mut self.lights, tr!("part" => "light"), id.clone(), light, index)?;
                SceneEdit::RemoveLight { id }
            }
            SceneEdit::SetLight { id, light } => {
                let old =
                    self.lights.get_mut(&id).ok_or_else(|| missing(tr!("part" => "light"), &id))?;
                SceneEdit::SetLight { light: replace(old, light), id }
            }
            SceneEdit::RemoveLight { id } => {
                if let Some(keys) = self.keys_without(&id) {
                    let edits = vec![keys, SceneEdit::RemoveLight { id }];
                    return Ok(SceneEdit::Group { edits: all_or_none(self, edits, true)? });
                }
                let (index, light) = remove_named(&mut self.lights, tr!("part" => "light"), &id)?;
                SceneEdit::AddLight { id, light, index: Some(index) }
            }
            SceneEdit::SetLightKeys { direction_keys, time_keys } => SceneEdit::SetLightKeys {
                direction_keys: replace(&mut self.direction_keys, direction_keys),
                time_keys: replace(&mut self.time_keys, time_keys),
            },
            SceneEdit::SetMarkers { markers } => {
                SceneEdit::SetMarkers { markers: replace(&mut self.markers, markers) }
            }
            SceneEdit::SetMaster { group, master, index } => {
                let old = self.light_groups.shift_remove_full(&group);
                let (at, old) = old.map(|(at, _, old)| (at, old)).unzip();
                if let Some(master) = master {
                    let last = self.light_groups.len();
                    let index = at.or(index).unwrap_or(last).min(last);
                    self.light_groups.shift_insert(index, group.clone(), master);
                }
                SceneEdit::SetMaster { group, master: old, index: at }
            }
            SceneEdit::SetMutedLights { muted } => {
                SceneEdit::SetMutedLights { muted: replace(&mut self.muted, muted) }
            }
            SceneEdit::SetSoloedLights { soloed } => {
                SceneEdit::SetSoloedLights { soloed: replace(&mut self.soloed, soloed) }
            }
            SceneEdit::SetIllumination { rotation } => {
                SceneEdit::SetIllumination { rotation: replace(&mut self.illumination, rotation) }
            }
            SceneEdit::SetCamera { camera } => {
                SceneEdit::SetCamera { camera: replace(&mut self.camera, camera) }
            }
            SceneEdit::SetFileCamera { camera } => {
                SceneEdit::SetFileCamera { camera: replace(&mut self.file_camera, camera) }
            }
            SceneEdit::SetBackdrop { color } => {
                SceneEdit::SetBackdrop { color: replace(&mut self.backdrop, color) }
            }
            SceneEdit::SetOutlines { outlines } => {
                SceneEdit::SetOutlines { outlines: replace(&mut self.outlines, outlines) }
            }
            SceneEdit::SetTime { time } => {
                SceneEdit::SetTime { time: replace(&mut self.time, time) }
            }
        })
    }

    fn label(&self, edit: &SceneEdit) -> String {
        match edit {
            SceneEdit::Group { edits } => self.label_of_several(edits),
            SceneEdit::Replace { .. } => tr!("load the file again").to_owned(),
            SceneEdit::SetSceneName { .. } => tr!("rename the scene").to_owned(),
            SceneEdit::SetSceneAbout { .. } => tr!("describe the scene").to_owned(),
            SceneEdit::AddObject { id, .. } => tr!("add {id}"),
            SceneEdit::SetObject { id, object } => {
                labels::of_object(id, self.objects.get(id), object)
            }
            SceneEdit::RemoveObject { id } => tr!("remove {id}"),
            SceneEdit::AddLight { id, .. } => tr!("add the light {id}"),
            SceneEdit::SetLight { id, light } => labels::of_light(id, self.lights.get(id), light),
            SceneEdit::RemoveLight { id } => tr!("remove the light {id}"),
            SceneEdit::SetLightKeys { .. } => tr!("key the lights").to_owned(),
            SceneEdit::SetMarkers { .. } => tr!("change markers").to_owned(),
            SceneEdit::SetMaster { group, .. } => tr!("mix the lights of {group}"),
            SceneEdit::SetMutedLights { .. } => tr!("mute lights").to_owned(),
            SceneEdit::SetSoloedLights { .. } => tr!("solo lights").to_owned(),
            SceneEdit::SetIllumination { .. } => tr!("turn the lights").to_owned(),
            SceneEdit::SetCamera { .. } => tr!("move the camera").to_owned(),
            SceneEdit::SetFileCamera { .. } => tr!("choose the camera").to_owned(),
            SceneEdit::SetBackdrop { .. } => tr!("change the backdrop").to_owned(),
            SceneEdit::SetOutlines { .. } => tr!("change the outlines").to_owned(),
            SceneEdit::SetTime { .. } => tr!("change the time range").to_owned(),
        }
    }

    fn does_nothing(edit: &SceneEdit) -> bool {
        matches!(edit, SceneEdit::Group { edits } if edits.is_empty())
    }

    fn is_annotation(edit: &SceneEdit) -> bool {
        match edit {
            SceneEdit::Group { edits } => edits.iter().all(Self::is_annotation),
            SceneEdit::SetSceneName { .. }
            | SceneEdit::SetSceneAbout { .. }
            | SceneEdit::SetMarkers { .. } => true,
            _ => false,
        }
    }

    fn covers(older: &SceneEdit, newer: &SceneEdit) -> bool {
        match (older, newer) {
            (SceneEdit::SetObject { id: a, .. }, SceneEdit::SetObject { id: b, .. }) => a == b,
            (SceneEdit::SetLight { id: a, .. }, SceneEdit::SetLight { id: b, .. }) => a == b,
            (SceneEdit::SetMaster { group: a, .. }, SceneEdit::SetMaster { group: b, .. }) => {
                a == b
            }
            (SceneEdit::SetLightKeys { .. }, SceneEdit::SetLightKeys { .. })
            | (SceneEdit::SetMarkers { .. }, SceneEdit::SetMarkers { .. })
            | (SceneEdit::SetIllumination { .. }, SceneEdit::SetIllumination { .. })
            | (SceneEdit::SetCamera { .. }, SceneEdit::SetCamera { .. })
            | (SceneEdit::SetFileCamera { .. }, SceneEdit::SetFileCamera { .. })
            | (SceneEdit::SetBackdrop { .. }, SceneEdit::SetBackdrop { .. })
            | (SceneEdit::SetOutlines { .. }, SceneEdit::SetOutlines { .. })
            | (SceneEdit::SetTime { .. }, SceneEdit::SetTime { .. }) => true,
            _ => false,
        }
    }
}
