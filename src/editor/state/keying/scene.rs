//! Keys of a scene's lights, read and edited as those of a look that has nothing but these lights:
//! all that is done with keys of looks is done with them, too.

use std::collections::HashMap;

use super::{KeyEvaluation, KeyedLook, Owner};
use crate::document::{Edit, Look, Scene, SceneEdit};
use crate::frame::{KeyedValues, Rig, RigInputs};
use crate::state::reading::LookWithLibrary;

/// The lights of a scene with their keys, and the values of the present moment.
pub(super) struct SceneKeys {
    look: Look,
    pub(super) evaluation: KeyEvaluation,
}

/// A look of nothing but a scene's lights and their keys.
fn keyed_lights(scene: &Scene) -> Look {
    Look {
        lights: scene.lights.clone(),
        direction_keys: scene.direction_keys.clone(),
        time_keys: scene.time_keys.clone(),
        ..Look::default()
    }
}

impl SceneKeys {
    /// The keys of a scene at a moment.
    pub(super) fn of(scene: &Scene, known: Option<&Self>, moment: &RigInputs<'_>) -> Self {
        let look = keyed_lights(scene);
        let rig = match known.and_then(|known| known.evaluation.rig.as_ref()) {
            Some(rig) => rig.renewed(&look).value,
            None => Rig::new(&look).value,
        };
        // Without wires nothing runs, and so nothing fails.
        let moment = RigInputs { scene_values: &HashMap::new(), ..*moment };
        let now: KeyedValues = rig.keyed_values(&|_, _| None, None, &moment).unwrap_or_default();
        let followed = known.map(|known| known.evaluation.followed.clone()).unwrap_or_default();
        let rig = Some(rig);
        Self { look, evaluation: KeyEvaluation { rig, now, followed, ..<_>::default() } }
    }

    /// The keys as those of a look, in the view of the open one.
    pub(super) fn seen<'a>(&'a self, view: KeyedLook<'a>) -> KeyedLook<'a> {
        KeyedLook {
            owner: Owner::Scene,
            base: LookWithLibrary { look: &self.look, ..view.base },
            evaluation: &self.evaluation,
            typed: None,
            shader: None,
            ..view
        }
    }
}

/// The edit of a scene that does what an edit of the look of its lights does; `None` where nothing
/// changes.
pub(crate) fn scene_edit(scene: &Scene, edit: Edit) -> Option<SceneEdit> {
    let mut look = keyed_lights(scene);
    look.apply(edit).ok()?;
    let is_changed = |(id, light): &(_, _)| scene.lights.get(*id) != Some(*light);
    let mut edits: Vec<SceneEdit> = look
        .lights
        .iter()
        .filter(is_changed)
        .map(|(id, light)| SceneEdit::SetLight { id: id.clone(), light: light.clone() })
        .collect();
    let Look { direction_keys, time_keys, .. } = look;
    if direction_keys != scene.direction_keys || time_keys != scene.time_keys {
        edits.push(SceneEdit::SetLightKeys { direction_keys, time_keys });
    }
    match edits.len() {
        0 => None,
        1 => edits.pop(),
        _ => Some(SceneEdit::Group { edits }),
    }
}
