//! Edits of a scene's objects, and the objects' positions.

use chiaro_locale::tr;
use glam::{DQuat, DVec3, EulerRot};

use super::{OPEN_LOOK, OpenScene};
use crate::document::{Object, Scene, SceneEdit, Transform};
use crate::frame::{ANY_MATERIAL, SHAPE_PREFIX};
use crate::geometry::SHAPES;
use crate::ids::{ObjectId, is_slug, make_slug};
use crate::state::orbit::Orbit;

/// Distance between two objects that stand side by side, in scene units.
const GAP: f64 = 0.15;

/// Position of an object, and its materials: found out with the picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ObjectPlace {
    pub(crate) id: ObjectId,
    /// Middle of the object's mesh, in world space.
    pub(crate) center: DVec3,
    /// Radius of a sphere around the middle, in scene units.
    pub(crate) radius: f64,
    /// True if the mesh is highest along z, as one that lies on its back.
    pub(crate) seems_to_lie: bool,
    /// Materials of the object's mesh, each once.
    pub(crate) materials: Vec<String>,
    /// Names of the animations that the mesh's file brings.
    pub(crate) animations: Vec<String>,
    /// Names of the cameras that it brings.
    pub(crate) cameras: Vec<String>,
}

/// Display name of a mesh: a built-in shape's label, or a file's name.
pub(crate) fn mesh_label(mesh: &str) -> String {
    let shape = mesh.strip_prefix(SHAPE_PREFIX);
    match SHAPES.iter().find(|known| shape == Some(known.name)) {
        Some(known) => known.label.tr().to_owned(),
        None => file_label(mesh),
    }
}

/// Name of a file without its folders.
pub(crate) fn file_label(name: &str) -> String {
    name.rsplit(['/', '\\']).next().unwrap_or(name).to_owned()
}

/// Rotation of a document, whose quaternion may have any length; none where that is 0.
pub(crate) fn unit_rotation(rotation: [f64; 4]) -> DQuat {
    let rotation = DQuat::from_array(rotation);
    if rotation.length_squared() > 1e-18 { rotation.normalize() } else { DQuat::IDENTITY }
}

/// Angles of a rotation around the vertical axis, around the axis to the right and around the one
/// toward the viewer, in degrees. The rotation is made of them in the reverse order.
pub(crate) fn to_degrees(rotation: [f64; 4]) -> [f64; 3] {
    let (y, x, z) = unit_rotation(rotation).to_euler(EulerRot::YXZ);
    // Rounding hides the last digits of a quaternion, and adding 0 the sign of -0: neither is
    // anybody's wish.
    [x, y, z].map(|angle| (angle.to_degrees() * 1e9).round() / 1e9 + 0.0)
}

/// Rotation of angles in degrees: the inverse of `to_degrees`.
pub(crate) fn from_degrees([x, y, z]: [f64; 3]) -> [f64; 4] {
    DQuat::from_euler(EulerRot::YXZ, y.to_radians(), x.to_radians(), z.to_radians())
        .normalize()
        .to_array()
}

/// A rotation that also stands up a mesh whose z axis points up, by a quarter turn.
pub(crate) fn stood_up(rotation: [f64; 4]) -> [f64; 4] {
    (DQuat::from_array(rotation) * DQuat::from_rotation_x(-std::f64::consts::FRAC_PI_2))
        .normalize()
        .to_array()
}

/// A rotation that also turns by half around the vertical axis of the world.
pub(crate) fn turned_around(rotation: [f64; 4]) -> [f64; 4] {
    (DQuat::from_rotation_y(std::f64::consts::PI) * DQuat::from_array(rotation))
        .normalize()
        .to_array()
}

/// An unsaved scene with one object: the viewport's picture of a look that was opened alone.
pub(crate) fn scene_of(orbit: &Orbit, look: String) -> Scene {
    let normal = Transform::default();
    let rotate = if orbit.z_is_up { stood_up(normal.rotate) } else { normal.rotate };
    let object = Object {
        mesh: orbit.mesh.clone(),
        transform: Transform { rotate, ..normal },
        looks: [(ANY_MATERIAL.to_owned(), look)].into_iter().collect(),
        ..Object::default()
    };
    let mut scene = Scene::default();
    scene.camera = orbit.camera();
    scene.illumination = orbit.illumination.to_array();
    scene.backdrop = orbit.backdrop.or(scene.backdrop);
    scene.objects.insert(free_id(&scene, &orbit.mesh), object);
    scene
}

/// An id that no object has, after the name of a mesh.
fn free_id(scene: &Scene, mesh: &str) -> ObjectId {
    let name = mesh.strip_prefix(SHAPE_PREFIX).map_or_else(|| file_label(mesh), str::to_owned);
    let name = name.split('.').next().unwrap_or_default().to_owned();
    ObjectId::new(make_slug(&name, |slug| scene.objects.contains_key(slug)))
}

/// Largest distance of an object's mesh from its position, for a mesh that is fitted.
fn reach(transform: &Transform) -> f64 {
    transform.scale.iter().fold(0.0, |most: f64, scale| most.max(scale.abs()))
}

impl OpenScene {
    /// Adds an object on a mesh, to the right of the others, in the look of the selected object or
    /// else the open look.
    pub(crate) fn add(&self, mesh: &str) -> (ObjectId, SceneEdit) {
        let scene = self.scene();
        let looks = match self.selected() {
            Some((_, object)) => object.looks.get(ANY_MATERIAL).cloned(),
            None => None,
        };
        let look = looks.unwrap_or_else(|| self.open_name());
        let object = Object {
            mesh: mesh.to_owned(),
            looks: [(ANY_MATERIAL.to_owned(), look)].into_iter().collect(),
            ..Object::default()
        };
        let id = free_id(scene, mesh);
        (id.clone(), self.add_beside(id, object))
    }

    /// Adds a copy of an object, to the right of all.
    pub(crate) fn duplicate(&self, id: &ObjectId) -> Option<(ObjectId, SceneEdit)> {
        let object = self.scene().objects.get(id)?.clone();
        let base = id.as_str().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
        let base = if base.is_empty() { id.as_str() } else { base };
        let new = ObjectId::new(make_slug(base, |slug| self.scene().objects.contains_key(slug)));
        Some((new.clone(), self.add_beside(new, object)))
    }

    fn add_beside(&self, id: ObjectId, mut object: Object) -> SceneEdit {
        let objects = &self.scene().objects;
        let right =
            objects.values().map(|other| other.transform.translate[0] + reach(&other.transform));
        if let Some(right) = right.reduce(f64::max) {
            let last = objects.values().last().map_or([0.0; 3], |last| last.transform.translate);
            object.transform.translate = [right + GAP + reach(&object.transform), last[1], last[2]];
        }
        SceneEdit::AddObject { id, object: Box::new(object), index: None }
    }

    /// Renames an object: a name that is no valid id is turned into one. `None` where nothing
    /// changes.
    pub(crate) fn rename(&self, id: &ObjectId, name: &str) -> Option<(ObjectId, SceneEdit)> {
        let objects = &self.scene().objects;
        let (index, _, object) = objects.get_full(id)?;
        let is_free = |slug: &str| slug == id.as_str() || !objects.contains_key(slug);
        let new = if is_slug(name) && is_free(name) {
            name.to_owned()
        } else {
            make_slug(name, |slug| !is_free(slug))
        };
        let new = ObjectId::new(new);
        let edits = vec![
            SceneEdit::RemoveObject { id: id.clone() },
            SceneEdit::AddObject {
                id: new.clone(),
                object: Box::new(object.clone()),
                index: Some(index),
            },
        ];
        (new != *id).then_some((new, SceneEdit::Group { edits }))
    }

    /// Changes an object; `None` where the object no longer exists.
    pub(crate) fn change(
        &self,
        id: &ObjectId,
        change: impl FnOnce(&mut Object),
    ) -> Option<SceneEdit> {
        let mut object = self.scene().objects.get(id)?.clone();
        change(&mut object);
        Some(SceneEdit::SetObject { id: id.clone(), object: Box::new(object) })
    }

    /// Renames the open look on every object that wears it; `None` where no object does.
    pub(crate) fn rename_open(
        &self,
        name: &str,
        change: &dyn Fn(&mut Object),
    ) -> Option<SceneEdit> {
        let renamed = |(id, object): (&ObjectId, &Object)| {
            let mut object = object.clone();
            object
                .looks
                .values_mut()
                .filter(|worn| self.is_open(worn))
                .for_each(|worn| name.clone_into(worn));
            change(&mut object);
            SceneEdit::SetObject { id: id.clone(), object: Box::new(object) }
        };
        let wear = self.scene().objects.iter().filter(|(_, object)| self.wears_open(object));
        let mut edits: Vec<SceneEdit> = wear.map(renamed).collect();
        if edits.len() > 1 { Some(SceneEdit::Group { edits }) } else { edits.pop() }
    }

    /// Name of the open look in the scene.
    pub(crate) fn open_name(&self) -> String {
        let worn = self.scene().objects.values().flat_map(|object| object.looks.values());
        let known = worn.into_iter().find(|name| self.is_open(name)).cloned();
        known
            .or_else(|| self.open_file.as_deref().map(|file| self.name_of(file)))
            .unwrap_or_else(|| OPEN_LOOK.to_owned())
    }

    /// Display name of the open look in lists of objects.
    pub(crate) fn open_label(&self) -> String {
        let file = self.open_file.as_deref().and_then(|file| file.file_name());
        file.map_or_else(|| tr!("New look").to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// Names of the scene's looks, the open one first, each once.
    pub(crate) fn looks(&self) -> Vec<String> {
        let mut names = vec![self.open_name()];
        for name in self.scene().objects.values().flat_map(|object| object.looks.values()) {
            if !names.contains(name) && !self.is_open(name) {
                names.push(name.clone());
            }
        }
        names
    }

    /// A sphere around an object, or around all that are seen; `None` where there are none.
    pub(crate) fn sphere(&self, only: Option<&ObjectId>) -> Option<(DVec3, f64)> {
        let objects = self.scene().objects.iter();
        let objects =
            objects.filter(|(id, object)| only.map_or(object.visible, |only| *id == only));
        let spheres: Vec<(DVec3, f64)> =
            objects.map(|(id, object)| self.sphere_of(id, object)).collect();
        let least = spheres.iter().map(|(center, radius)| *center - *radius).reduce(DVec3::min)?;
        let most = spheres.iter().map(|(center, radius)| *center + *radius).reduce(DVec3::max)?;
        let middle = 0.5 * (least + most);
        let radius = spheres
            .iter()
            .map(|(center, radius)| center.distance(middle) + radius)
            .fold(0.0, f64::max);
        Some((middle, radius))
    }

    fn sphere_of(&self, id: &ObjectId, object: &Object) -> (DVec3, f64) {
        let placed = self.placed.iter().find(|placed| placed.id == *id && !object.transform.fit);
        let fitted = || (DVec3::from(object.transform.translate), reach(&object.transform));
        placed.map_or_else(fitted, |placed| (placed.center, placed.radius))
    }

    /// Findings on an object, from the picture.
    pub(crate) fn place(&self, id: &ObjectId) -> Option<&ObjectPlace> {
        self.placed.iter().find(|placed| placed.id == *id)
    }

    /// Materials of an object's mesh, as far as they are known.
    pub(crate) fn materials(&self, id: &ObjectId) -> &[String] {
        self.placed.iter().find(|placed| placed.id == *id).map_or(&[], |placed| &placed.materials)
    }
}

/// The sphere that needles of lights stand on: around the selected object, or else the first, that
/// wears the open look; around the origin without a scene.
pub(crate) fn sphere_of_lights(open_scene: Option<&OpenScene>) -> (DVec3, f64) {
    let unit = (DVec3::ZERO, 1.0);
    let Some(open_scene) = open_scene else { return unit };
    let selected = open_scene.selected().filter(|(_, object)| open_scene.wears_open(object));
    let objects = open_scene.scene().objects.iter().filter(|(_, object)| object.visible);
    let worn =
        selected.or_else(|| objects.into_iter().find(|(_, object)| open_scene.wears_open(object)));
    worn.and_then(|(id, _)| open_scene.sphere(Some(id))).unwrap_or(unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::revision::StepTime;

    #[test]
    fn turns_are_read_back() {
        for degrees in [[0.0, 0.0, 0.0], [30.0, -120.0, 10.0], [-80.0, 45.0, 170.0]] {
            let back = to_degrees(from_degrees(degrees));
            for (a, b) in degrees.iter().zip(back) {
                assert!((a - b).abs() < 1e-9, "{degrees:?} {back:?}");
            }
        }
        assert_eq!(to_degrees([0.0; 4]), [0.0; 3], "no rotation is none");
    }

    #[test]
    fn objects_stand_side_by_side_under_names_of_their_own() {
        let mut open_scene = OpenScene::unsaved(scene_of(&Orbit::default(), OPEN_LOOK.to_owned()));
        for wanted in ["torus", "torus_2", "torus_3"] {
            let (id, edit) = open_scene.add("shape:torus");
            assert_eq!(id.as_str(), wanted);
            assert!(open_scene.apply(edit, None, StepTime(1)).unwrap());
        }
        let places: Vec<f64> = open_scene
            .scene()
            .objects
            .values()
            .map(|object| object.transform.translate[0])
            .collect();
        assert!(places.windows(2).all(|pair| pair[1] - pair[0] > 2.0), "{places:?}");
        let (id, edit) = open_scene.rename(&"torus_2".into(), "Big ring").unwrap();
        assert_eq!(id.as_str(), "big_ring");
        open_scene.apply(edit, None, StepTime(2)).unwrap();
        let ids: Vec<&str> = open_scene.scene().objects.keys().map(ObjectId::as_str).collect();
        assert_eq!(ids, ["creature", "torus", "big_ring", "torus_3"]);
        assert!(open_scene.rename(&"torus".into(), "torus").is_none());
        let (center, radius) = open_scene.sphere(None).unwrap();
        assert!((center.x - 0.5 * places[3]).abs() < 1e-9 && radius > 0.5 * places[3] + 0.99);
    }
}
