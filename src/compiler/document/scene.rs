//! A scene: objects with looks, shared lights, a camera and a time range.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::described::described;
use super::light::{GroupMaster, LayerLink, Light, LightLink, ShadowLink};
use super::look::{DirectionKeys, Look};
use super::set::{LightSet, ObjectSet};
use super::shape::{FAR, FORMAT, FieldKind, LINE, LONG, MAX_PATH, NumberBounds};
use super::timing::{MAX_MARKERS, Marker, TimeKeys};
use super::value::Values;
use super::word::WordChoice as _;
use crate::ids::{LightGroup, LightId, ObjectId};

described! {
    /// Objects with looks, shared lights, the illumination frame, a camera, a backdrop and a time
    /// range.
    #[serde(default)]
    pub struct Scene("scene", Lines) {
        /// Type of the document.
        "chiaro": FieldKind::Word(&[("scene", "a scene")]), words "what it is opened as";
        /// The version of the format.
        "version": FieldKind::Number(FORMAT), json "1";
        /// A JSON Schema for text editors; kept, and not looked at.
        "$schema": FieldKind::Text(LINE), words "none";
        /// Artist's name of the scene.
        name: String = String::new(), FieldKind::Text(LINE);
        /// Paragraph on the picture and its construction, for whoever finds the scene.
        about: String = String::new(), FieldKind::Text(LONG);
        /// Objects in the picture.
        objects: IndexMap<ObjectId, Object> = IndexMap::new(),
            FieldKind::List(&FieldKind::Object(Object::shape), 100_000), by Objects;
        /// Lights that replace those of the same id in every look of the scene, by id.
        lights: IndexMap<LightId, Light> = IndexMap::new(),
            FieldKind::Map(&FieldKind::Object(Light::shape), 1000);
        /// Masters of groups of lights, by group; those of all groups of a light multiply.
        light_groups: IndexMap<LightGroup, GroupMaster> = IndexMap::new(),
            FieldKind::Map(&FieldKind::Object(GroupMaster::shape), 1000);
        /// Lights that are out, of the scene and of its looks.
        muted: LightSet = LightSet::none(), FieldKind::LightSet;
        /// Lights that shine alone, muted or not; where none of the lights is one of these, all
        /// shine that are not muted.
        soloed: LightSet = LightSet::none(), FieldKind::LightSet;
        /// Values of the scene's lights that change with a direction or with drivers, for each
        /// object that is lit; they stand over those that looks give to the lights.
        direction_keys: Vec<DirectionKeys> = Vec::new(),
            FieldKind::List(&FieldKind::Object(DirectionKeys::shape), 1000);
        /// Values of the scene's lights that change with time.
        time_keys: Vec<TimeKeys> = Vec::new(),
            FieldKind::List(&FieldKind::Object(TimeKeys::shape), 10_000);
        /// Times with a name.
        markers: Vec<Marker> = Vec::new(),
            FieldKind::List(&FieldKind::Object(Marker::shape), MAX_MARKERS);
        /// The rotation of the illumination frame: world from illumination frame.
        illumination: [f64; 4] = [0.0, 0.0, 0.0, 1.0], FieldKind::Rotation;
        /// Camera of the picture.
        camera: Camera = Camera::default(), FieldKind::Object(Camera::shape);
        /// Camera of an object's mesh file, in place of the eye, the direction and the lens of
        /// `camera`.
        file_camera: Option<FileCamera> = None, FieldKind::Object(FileCamera::shape),
            words "none";
        /// Straight RGBA behind the objects, in display colors; null for transparent.
        backdrop: Option<[f64; 4]> = Some([0.16, 0.165, 0.18, 1.0]),
            FieldKind::Backdrop, by Backdrop;
        /// Lines over the picture, drawn after the looks; none while their width is 0.
        outlines: SceneOutlines = SceneOutlines::default(),
            FieldKind::Object(SceneOutlines::shape);
        /// Range of times.
        time: TimeRange = TimeRange::default(), FieldKind::Object(TimeRange::shape);
        unknown;
    }
}

impl Scene {
    /// A look of nothing but the scene's lights and their keys; `None` where there are no keys.
    pub fn keyed_lights(&self) -> Option<Look> {
        let has_keys = !self.direction_keys.is_empty() || !self.time_keys.is_empty();
        has_keys.then(|| Look {
            lights: self.lights.clone(),
            direction_keys: self.direction_keys.clone(),
            time_keys: self.time_keys.clone(),
            ..Look::default()
        })
    }
}

described! {
    /// A mesh, where it stands and what it wears.
    #[serde(default)]
    pub struct Object("object", Lines) {
        /// Id within the scene.
        "id": FieldKind::Slug, words "made from the mesh's name";
        /// A path relative to the scene's file, or `shape:` and the name of an own shape.
        mesh: String = "shape:sphere".to_owned(), FieldKind::Text(MAX_PATH), always;
        /// Animation of the mesh's file that the object plays.
        animation: Option<MeshAnimation> = None, FieldKind::Object(MeshAnimation::shape),
            words "none: the mesh stands still";
        /// Place, turn and size of the object.
        transform: Transform = Transform::default(), FieldKind::Object(Transform::shape);
        /// A look's path, relative to the scene's file; or such paths by material name, where `*`
        /// is for every other material.
        looks: IndexMap<String, String> = IndexMap::new(), FieldKind::Looks, by Looks;
        /// Values of exposed parameters, over those of the looks.
        values: Values = Values::new(), FieldKind::Map(&FieldKind::Value, 10_000);
        /// Lights that reach the object.
        linked: LightSet = LightSet::all(), FieldKind::LightSet;
        /// Lights that do not reach it although they are linked; `{source}` are those.
        unlinked: LightSet = LightSet::none(), FieldKind::LightSet;
        /// Lights whose shadows the object casts, where looks ask for shadows.
        shadowed: LightSet = LightSet::all(), FieldKind::LightSet;
        /// Lights whose shadows it does not cast all the same; `{source}` are those of `shadowed`.
        unshadowed: LightSet = LightSet::none(), FieldKind::LightSet;
        /// Objects that its shadows fall on, itself among them.
        shadows_on: ObjectSet = ObjectSet::all(), FieldKind::ObjectSet;
        /// Objects that they do not fall on all the same; `{source}` are those of `shadows_on`.
        no_shadows_on: ObjectSet = ObjectSet::none(), FieldKind::ObjectSet;
        /// Lights of single nodes of the object's looks: which reach them, and which they filter.
        layers: Vec<LayerLink> = Vec::new(),
            FieldKind::List(&FieldKind::Object(LayerLink::shape), 1000);
        /// True if the object is drawn.
        visible: bool = true, FieldKind::Bool;
        unknown;
    }
}

impl Object {
    /// Lights that reach the object.
    pub fn light_link(&self) -> LightLink {
        LightLink { linked: self.linked.clone(), unlinked: self.unlinked.clone() }
    }

    /// Shadows that the object casts.
    pub fn shadow_link(&self) -> ShadowLink {
        ShadowLink {
            shadowed: self.shadowed.clone(),
            unshadowed: self.unshadowed.clone(),
            shadows_on: self.shadows_on.clone(),
            no_shadows_on: self.no_shadows_on.clone(),
        }
    }
}

described! {
    /// Animation of a mesh's file, and how it plays.
    #[serde(default)]
    pub struct MeshAnimation("animation", Line) {
        /// Name of the animation in the file; of the first for an empty one.
        name: String = String::new(), FieldKind::Text(LINE);
        /// Seconds of the animation in a second of the scene; below 0 backwards.
        speed: f64 = 1.0, FieldKind::Number(NumberBounds::new(-1000.0, 1000.0));
        /// Time in the animation at the scene's time 0, in seconds.
        offset: f64 = 0.0, FieldKind::Number(FAR);
        /// True if it begins anew after its last key; else what it ends with holds.
        loops: bool = true, FieldKind::Bool;
    }
}

described! {
    /// Camera that a mesh's file brings, with the animation that the object plays.
    #[serde(default)]
    pub struct FileCamera("file camera", Line) {
        /// Id of the object.
        object: String = String::new(), FieldKind::Text(LINE);
        /// Name of the camera in the file; of the first for an empty one.
        name: String = String::new(), FieldKind::Text(LINE);
    }
}

described! {
    /// Fit, then scale, then turn, then move.
    #[derive(Copy)]
    #[serde(default)]
    pub struct Transform("transform", Line) {
        /// In scene units.
        translate: [f64; 3] = [0.0; 3], FieldKind::Numbers(3, 3, FAR);
        /// World from object.
        rotate: [f64; 4] = [0.0, 0.0, 0.0, 1.0], FieldKind::Rotation;
        /// Along each axis of the object; none of them 0.
        scale: [f64; 3] = [1.0; 3], FieldKind::Numbers(3, 3, FAR), by Scale;
        /// True if the mesh is first centered and scaled to a bounding sphere of radius 1.
        fit: bool = true, FieldKind::Bool;
    }
}

described! {
    /// Camera of the picture.
    #[derive(Copy)]
    #[serde(default)]
    pub struct Camera("camera", Line) {
        /// The eye, in scene units.
        eye: [f64; 3] = [0.0, 0.0, 4.4], FieldKind::Numbers(3, 3, FAR);
        /// Point that the camera looks at, in scene units; not the eye.
        target: [f64; 3] = [0.0; 3], FieldKind::Numbers(3, 3, FAR);
        /// Direction that is up in the picture; any length but 0, and not along the view.
        up: [f64; 3] = [0.0, 1.0, 0.0], FieldKind::Direction;
        /// Projection onto the picture.
        projection: Projection = Projection::Perspective, FieldKind::Word(Projection::WORDS);
        /// Perspective: the vertical field of view, in radians.
        fov: f64 = 0.5, FieldKind::Number(NumberBounds::new(Camera::FOV[0], Camera::FOV[1]));
        /// Orthographic: the height of the picture, in scene units.
        height: f64 = 2.5, FieldKind::Number(NumberBounds::above(0.0, 1e6));
        /// The width over the height of the picture that it was placed for: a narrower one shows as
        /// much in width, and more above and below. 0 for any.
        aspect: f64 = 0.0, FieldKind::Number(NumberBounds::new(0.0, 100.0));
    }
}

impl Camera {
    /// Least and greatest vertical field of view, of files, views and command lines alike, in
    /// radians.
    pub const FOV: [f64; 2] = [0.001, std::f64::consts::PI - 0.01];

    /// True if a vertical field of view is within [`FOV`](Self::FOV), in radians.
    pub fn holds_fov(fov: f64) -> bool {
        (Self::FOV[0]..=Self::FOV[1]).contains(&fov)
    }

    /// Factor by which the view is higher in a picture whose width is `aspect` times its height.
    pub fn widening(&self, aspect: f64) -> f64 {
        if self.aspect > 0.0 { (self.aspect / aspect.max(1e-6)).max(1.0) } else { 1.0 }
    }
}

described! {
    /// Lines over the picture, drawn after the looks, on objects and beside them alike. Each kind
    /// has a share of the width; all lie evenly on both sides of their edges.
    #[derive(Copy)]
    #[serde(default)]
    pub struct SceneOutlines("outlines", Line) {
        /// Width of a whole line, in thousandths of the picture's height; 0 for no lines.
        width: f64 = 0.0, FieldKind::Number(NumberBounds::new(0.0, SceneOutlines::MOST_WIDTH));
        /// Straight RGBA in display colors.
        color: [f64; 4] = [0.05, 0.05, 0.07, 1.0], FieldKind::Color { alpha: true };
        /// Share where a form ends in front of something else.
        silhouettes: f64 = 1.0, FieldKind::Number(SHARE);
        /// Share where a surface folds by 30 degrees or more.
        creases: f64 = 0.5, FieldKind::Number(SHARE);
        /// Share where two objects meet.
        borders: f64 = 1.0, FieldKind::Number(SHARE);
        /// Share where two materials of an object meet.
        material_borders: f64 = 0.5, FieldKind::Number(SHARE);
        /// Share where the id of a look changes within a material.
        id_borders: f64 = 0.5, FieldKind::Number(SHARE);
    }
}

/// Share of a width.
const SHARE: NumberBounds = NumberBounds::new(0.0, 1.0);

impl SceneOutlines {
    /// Greatest width, in thousandths of the picture's height.
    pub const MOST_WIDTH: f64 = 30.0;

    /// Widths of the lines of each kind in thousandths of the picture's height: silhouettes,
    /// creases, borders of objects, of materials and of ids.
    pub fn widths(&self) -> [f64; 5] {
        let Self { silhouettes, creases, borders, material_borders, id_borders, .. } = *self;
        [silhouettes, creases, borders, material_borders, id_borders]
            .map(|share| share * self.width)
    }

    /// True if anything is drawn.
    pub fn are_drawn(&self) -> bool {
        self.color[3] > 0.0 && self.widths().iter().any(|width| *width > 0.0)
    }
}

/// Projection of the scene onto the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Projection {
    /// Perspective: lines of sight meet at the eye.
    #[default]
    Perspective,
    /// Orthographic: parallel lines stay parallel.
    Orthographic,
}

described! {
    /// Range of times.
    #[derive(Copy)]
    #[serde(default)]
    pub struct TimeRange("time range", Line) {
        /// The first time, in seconds.
        start: f64 = 0.0, FieldKind::Number(FAR);
        /// The last time, in seconds; not before `start`.
        end: f64 = 0.0, FieldKind::Number(FAR);
        /// Frames a second.
        fps: f64 = 24.0, FieldKind::Number(NumberBounds::above(0.0, 1000.0));
    }
}
