//! The fields of a scene.

use super::Default::{Json, Required, Words};
use super::Kind::{
    Backdrop, Bool, Direction, List, Looks, Map, Number, Numbers, Object, Rotation, Slug, Text,
    Value, Word,
};
use super::look::LIGHT;
use super::{Bounds, FAR, Field, LINE, Shape, field};
use crate::document::word::Word as _;
use crate::document::{Camera, Projection, VERSION as CURRENT};

pub(super) const VERSION: Field = field(
    "version",
    Number(Bounds::whole(1.0, CURRENT as f64)),
    Json("1"),
    "The version of the format.",
);
pub(super) const SCHEMA: Field = field(
    "$schema",
    Text(LINE),
    Words("none"),
    "A JSON Schema for text editors; kept, and not looked at.",
);

pub(in crate::document) static SCENE: Shape = Shape {
    name: "scene",
    help: "Objects with looks, shared lights, the illumination frame, a camera, a backdrop and a \
           time range.",
    fields: &[
        field(
            "chiaro",
            Word(&[("scene", "a scene")]),
            Words("what it is opened as"),
            "What the document is.",
        ),
        VERSION,
        SCHEMA,
        field("name", Text(LINE), Json("\"\""), "What the artist calls it."),
        super::look::ABOUT,
        field("objects", List(&Object(&OBJECT), 100_000), Json("[]"), "What is in the picture."),
        field(
            "lights",
            Map(&Object(&LIGHT), 1000),
            Json("{}"),
            "Lights that replace those of the same id in every look of the scene, by id.",
        ),
        field(
            "illumination",
            Rotation,
            Json("[0, 0, 0, 1]"),
            "The rotation of the illumination frame: world from illumination frame.",
        ),
        field("camera", Object(&CAMERA), Json("{}"), "Where the picture is taken from."),
        field(
            "backdrop",
            Backdrop,
            Json("[0.16, 0.165, 0.18, 1]"),
            "Straight RGBA behind the objects, in display colors; null for transparent.",
        ),
        field("time", Object(&TIME_RANGE), Json("{}"), "Which times there are."),
    ],
};

pub(in crate::document) static OBJECT: Shape = Shape {
    name: "object",
    help: "A mesh, where it stands and what it wears.",
    fields: &[
        field("id", Slug, Words("made from the mesh's name"), "Its id within the scene."),
        field(
            "mesh",
            Text(4096),
            Json("\"shape:sphere\""),
            "A path relative to the scene's file, or `shape:` and the name of an own shape.",
        ),
        field("transform", Object(&TRANSFORM), Json("{}"), "Where it stands."),
        field(
            "looks",
            Looks,
            Json("{}"),
            "A look's path, relative to the scene's file; or such paths by material name, where \
             `*` is for every other material.",
        ),
        field(
            "values",
            Map(&Value, 10_000),
            Json("{}"),
            "Values of exposed parameters, over those of the looks.",
        ),
        field("visible", Bool, Json("true"), "Whether it is drawn."),
    ],
};

pub(in crate::document) static TRANSFORM: Shape = Shape {
    name: "transform",
    help: "Fit, then scale, then turn, then move.",
    fields: &[
        field("translate", Numbers(3, 3, FAR), Json("[0, 0, 0]"), "In scene units."),
        field("rotate", Rotation, Json("[0, 0, 0, 1]"), "World from object."),
        field(
            "scale",
            Numbers(3, 3, FAR),
            Json("[1, 1, 1]"),
            "Along each axis of the object; none of them 0.",
        ),
        field(
            "fit",
            Bool,
            Json("true"),
            "Whether the mesh is first centred and scaled to a bounding sphere of radius 1.",
        ),
    ],
};

pub(in crate::document) static AXIS_ANGLE: Shape = Shape {
    name: "axis and angle",
    help: "A rotation by the right-hand rule.",
    fields: &[
        field("axis", Direction, Required, "The axis; any length but 0."),
        field("angle", Number(FAR), Required, "How far, in radians."),
    ],
};

pub(in crate::document) static CAMERA: Shape = Shape {
    name: "camera",
    help: "Where the picture is taken from.",
    fields: &[
        field("eye", Numbers(3, 3, FAR), Json("[0, 0, 4.4]"), "The eye, in scene units."),
        field(
            "target",
            Numbers(3, 3, FAR),
            Json("[0, 0, 0]"),
            "What it looks at, in scene units; not the eye.",
        ),
        field(
            "up",
            Direction,
            Json("[0, 1, 0]"),
            "What is up in the picture; any length but 0, and not along the view.",
        ),
        field(
            "projection",
            Word(Projection::WORDS),
            Json("\"perspective\""),
            "How depth becomes smaller.",
        ),
        field(
            "fov",
            Number(Bounds::new(Camera::FOV[0], Camera::FOV[1])),
            Json("0.5"),
            "Perspective: the vertical field of view, in radians.",
        ),
        field(
            "height",
            Number(Bounds::above(0.0, 1e6)),
            Json("2.5"),
            "Orthographic: the height of the picture, in scene units.",
        ),
        field(
            "aspect",
            Number(Bounds::new(0.0, 100.0)),
            Json("0"),
            "The width over the height of the picture that it was placed for: a narrower one shows \
             as much in width, and \
             more above and below. 0 for any.",
        ),
    ],
};

pub(in crate::document) static TIME_RANGE: Shape = Shape {
    name: "time range",
    help: "Which times there are.",
    fields: &[
        field("start", Number(FAR), Json("0"), "The first time, in seconds."),
        field("end", Number(FAR), Json("0"), "The last time, in seconds; not before `start`."),
        field("fps", Number(Bounds::above(0.0, 1000.0)), Json("24"), "Frames a second."),
    ],
};
