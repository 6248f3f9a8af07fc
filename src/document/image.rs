//! Documents as they lie in memory, for journals: also what no file says, such as the unknown fields of a part that is
//! gone now and that undo may bring back. Files hold the canonical form instead.

use indexmap::IndexMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{
    Camera, ColorSpace, Definition, DirectionKeys, Exposed, Graph, Light, Look, Object, Scene, Tier, TimeKeys,
    TimeRange, Unknown,
};
use crate::ids::{DefinitionId, LightId, ObjectId};

/// Every field of [`Look`], as the compiler sees to.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Look")]
pub(super) struct LookImage {
    name: String,
    color_space: ColorSpace,
    tier: Tier,
    tuned: String,
    graph: Graph,
    lights: IndexMap<LightId, Light>,
    definitions: IndexMap<DefinitionId, Definition>,
    exposed: Vec<Exposed>,
    direction_keys: Vec<DirectionKeys>,
    time_keys: Vec<TimeKeys>,
    unknown: Unknown,
}

/// Every field of [`Scene`].
#[derive(Serialize, Deserialize)]
#[serde(remote = "Scene")]
pub(super) struct SceneImage {
    name: String,
    objects: IndexMap<ObjectId, Object>,
    lights: IndexMap<LightId, Light>,
    illumination: [f64; 4],
    camera: Camera,
    backdrop: Option<[f64; 4]>,
    time: TimeRange,
    unknown: Unknown,
}

pub(super) fn serialize<S: Serializer>(look: &Look, serializer: S) -> Result<S::Ok, S::Error> {
    LookImage::serialize(look, serializer)
}

pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Box<Look>, D::Error> {
    LookImage::deserialize(deserializer).map(Box::new)
}

/// The same for scenes.
pub(super) mod of_scene {
    use serde::{Deserializer, Serializer};

    use super::SceneImage;
    use crate::document::Scene;

    pub(in crate::document) fn serialize<S: Serializer>(scene: &Scene, serializer: S) -> Result<S::Ok, S::Error> {
        SceneImage::serialize(scene, serializer)
    }

    pub(in crate::document) fn deserialize<'de, D: Deserializer<'de>>(source: D) -> Result<Box<Scene>, D::Error> {
        SceneImage::deserialize(source).map(Box::new)
    }
}
