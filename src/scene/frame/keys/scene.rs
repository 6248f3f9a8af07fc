//! Keys of a scene's lights, which stand over those that looks give to the lights.

use std::collections::HashMap;
use std::sync::Arc;

use super::{Rig, RigInputs};
use crate::diag::Diagnostic;
use crate::document::{Look, Scene, Target, Value};

/// Keys of a scene's lights with their weights solved.
#[derive(Clone, Debug)]
pub struct SceneRig {
    /// The lights and keys that the rig was made from.
    keyed: Look,
    rig: Rig,
    /// Warnings of keys that are merged or lie too close.
    pub warnings: Vec<Diagnostic>,
}

impl SceneRig {
    /// The rig of a scene, which is `known` as long as nothing of its keys changes; `None` where
    /// the scene has no keys.
    pub fn of(scene: &Scene, known: Option<&Arc<Self>>) -> Option<Arc<Self>> {
        let keyed = scene.keyed_lights()?;
        let (rig, warnings) = match known {
            // Present lights come with the inputs; which there are is the rig's.
            Some(known) if known.has_keys_of(&keyed) => return Some(known.clone()),
            Some(known) => known.rig.renewed(&keyed).into_parts(),
            None => Rig::new(&keyed).into_parts(),
        };
        Some(Arc::new(Self { keyed, rig, warnings }))
    }

    fn has_keys_of(&self, keyed: &Look) -> bool {
        self.keyed.direction_keys == keyed.direction_keys
            && self.keyed.time_keys == keyed.time_keys
            && self.keyed.lights.keys().eq(keyed.lights.keys())
    }

    /// The rig of the keys.
    pub(in crate::frame) fn rig(&self) -> &Rig {
        &self.rig
    }

    /// True if values differ from object to object.
    pub(in crate::frame) fn follows_objects(&self) -> bool {
        !self.keyed.direction_keys.is_empty()
    }

    /// Values of the scene's lights for one object at one time; the lights of `inputs` are the
    /// scene's.
    pub fn values(&self, inputs: &RigInputs<'_>) -> HashMap<Target, Value> {
        // Without wires nothing runs, and so nothing fails.
        let keyed = self.rig.keyed_values(&|_, _| None, None, inputs);
        keyed.map(|keyed| keyed.values).unwrap_or_default()
    }
}
