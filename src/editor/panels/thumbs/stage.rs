//! Stage of a look's thumbnail: the mesh that suits the look, the camera, and what stands behind,
//! as the gallery's list has them.

use serde::Deserialize;

use crate::document::{Scene, parse_hex};
use crate::frame::{PlacementError, place_camera, turn_lights};

/// Stage that a look is shown on; what is absent is that of all looks.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(default)]
pub(crate) struct ThumbStage {
    /// Mesh: a path, or `shape:` and the name of a built-in shape.
    pub(crate) mesh: Option<String>,
    /// Placement of the camera, as [`place_camera`] reads it.
    camera: Option<String>,
    /// Turn of all lights, as [`turn_lights`] reads it.
    turn_lights: Option<String>,
    /// Color behind the look, `#rrggbb` as shown.
    backdrop: Option<String>,
}

impl ThumbStage {
    /// Places camera and lights of a scene, and sets what stands behind.
    ///
    /// # Errors
    /// A camera or lights that cannot be read so.
    pub(super) fn set(&self, scene: &mut Scene) -> Result<(), PlacementError> {
        scene.backdrop = self.backdrop.as_deref().and_then(parse_hex);
        if let Some(text) = &self.camera {
            place_camera(&mut scene.camera, text)?;
        }
        self.turn_lights.as_ref().map_or(Ok(()), |text| turn_lights(scene, text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stage_of_the_gallery_can_be_set() {
        let gallery: serde_json::Value = serde_json::from_str(crate::examples::GALLERY).unwrap();
        let sections = gallery["sections"].as_array().unwrap();
        let entries = sections.iter().flat_map(|section| section["entries"].as_array().unwrap());
        let mut count = 0;
        for entry in entries.filter(|entry| entry.is_object()) {
            let stage = ThumbStage::deserialize(entry).unwrap();
            let mut scene = Scene::default();
            assert!(stage.set(&mut scene).is_ok(), "{entry}");
            assert_eq!(scene.backdrop.is_some(), stage.backdrop.is_some(), "{entry}");
            count += 1;
        }
        assert!(count > 60, "{count}");
    }
}
