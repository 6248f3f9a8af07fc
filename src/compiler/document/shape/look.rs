//! The fields of a look.

use std::f64::consts::PI;

use super::Default::{Json, Required, Words};
use super::Kind::{
    Bool, Color, Direction, Input, KeyDirection, List, Map, Number, Numbers, Object, Output, Slug,
    TargetValues, Text, Value, Word,
};
use super::{
    Bounds, F32, FAR, Field, Kind, LINE, LONG, MAX_NODES, MAX_WIRES, POSITIVE, Shape, field,
};
use crate::document::word::Word as _;
use crate::document::{
    ColorSpace, Curve, Interpolation, KeyScheme, LightKind, LightSpace, Ramp, Tier,
};

const NAME: Field = field("name", Text(LINE), Json("\"\""), "What the artist calls it.");
pub(super) const ABOUT: Field = field(
    "about",
    Text(LONG),
    Json("\"\""),
    "What it shows and how it is built: a paragraph for who finds it.",
);
const A_NODE: &Kind = &Object(&NODE);
const A_WIRE: &Kind = &Object(&WIRE);
const A_FRAME: &Kind = &Object(&FRAME);
const A_NOTE: &Kind = &Object(&NOTE);
const A_BOOKMARK: &Kind = &Object(&BOOKMARK);
const NODES: Field = field("nodes", List(A_NODE, MAX_NODES), Json("[]"), "The nodes of the graph.");
const WIRES: Field = field("wires", List(A_WIRE, MAX_WIRES), Json("[]"), "The wires between them.");
const FRAMES: Field =
    field("frames", Map(A_FRAME, 10_000), Json("{}"), "Titled frames on the canvas, by id.");
const NOTES: Field = field("notes", Map(A_NOTE, 10_000), Json("{}"), "Texts on the canvas, by id.");
const BOOKMARKS: Field = field(
    "bookmarks",
    List(A_BOOKMARK, 9),
    Json("[]"),
    "Views of the canvas that a key brings back.",
);
const AT: Field = field(
    "at",
    Numbers(2, 2, Bounds::new(-1e9, 1e9)),
    Json("[0, 0]"),
    "Where it lies on the canvas, in points, x right and y down.",
);
const INTERPOLATION: Field = field(
    "interpolation",
    Word(Interpolation::WORDS),
    Json("\"linear\""),
    "How neighbours are joined; for a time key, how it goes on to the next.",
);

pub(in crate::document) static LOOK: Shape = Shape {
    name: "look",
    help: "One shading graph with its lights, groups and keys.",
    fields: &[
        field(
            "chiaro",
            Word(&[("look", "a look")]),
            Words("what it is opened as"),
            "What the document is.",
        ),
        super::scene::VERSION,
        super::scene::SCHEMA,
        NAME,
        ABOUT,
        field(
            "color_space",
            Word(ColorSpace::WORDS),
            Json("\"display\""),
            "What the numbers of colors mean.",
        ),
        field(
            "tier",
            Word(Tier::WORDS),
            Json("\"exact\""),
            "Which implementation is asked for of nodes that do not say their own.",
        ),
        field(
            "tuned",
            Text(LINE),
            Json("\"\""),
            "What `chiaro tune` measured when it chose tiers.",
        ),
        field(
            "lights",
            Map(&Object(&LIGHT), 1000),
            Json("{}"),
            "The lights that Light nodes name, by id.",
        ),
        NODES,
        WIRES,
        FRAMES,
        NOTES,
        BOOKMARKS,
        field(
            "definitions",
            Map(&Object(&DEFINITION), 10_000),
            Json("{}"),
            "Groups by id; a node uses one as its kind.",
        ),
        field(
            "exposed",
            List(&Object(&EXPOSED), 10_000),
            Json("[]"),
            "Inputs that scenes, scripts and exported shaders may set.",
        ),
        field(
            "direction_keys",
            List(&Object(&DIRECTION_KEYS), 1000),
            Json("[]"),
            "Values that change with a direction.",
        ),
        field(
            "time_keys",
            List(&Object(&TIME_KEYS), 10_000),
            Json("[]"),
            "Values that change with time.",
        ),
    ],
};

pub(in crate::document) static LIGHT: Shape = Shape {
    name: "light",
    help: "A light, of a look or of a scene.",
    fields: &[
        field("name", Text(LINE), Json("\"\""), "What the artist calls it; empty for the id."),
        field("type", Word(LightKind::WORDS), Json("\"directional\""), "What the light is."),
        field(
            "space",
            Word(LightSpace::WORDS),
            Json("\"illumination\""),
            "The frame of `direction`, `position` and `aim`.",
        ),
        field(
            "direction",
            Direction,
            Json("[0, 0, 1]"),
            "Directional lights: toward the light; any length but 0.",
        ),
        field(
            "position",
            Numbers(3, 3, FAR),
            Json("[0, 0, 3]"),
            "Point and spot lights: where it is, in scene units.",
        ),
        field(
            "aim",
            Direction,
            Json("[0, 0, -1]"),
            "Spot lights: the way it shines, from the light outward; any length but 0.",
        ),
        field(
            "inner",
            Number(Bounds::new(0.0, PI)),
            Json("0.35"),
            "Spot lights: the half-angle of the full cone, in radians; at most `outer`.",
        ),
        field(
            "outer",
            Number(Bounds::above(0.0, PI)),
            Json("0.5"),
            "Spot lights: the half-angle at which nothing is left, in radians.",
        ),
        field(
            "color",
            Color { alpha: false },
            Json("[1, 1, 1]"),
            "Straight RGB in the look's color space.",
        ),
        field("intensity", Number(POSITIVE), Json("1"), "A factor."),
        field(
            "half_distance",
            Number(POSITIVE),
            Json("0"),
            "Point and spot lights: the distance at which half the intensity is left, in scene \
             units; 0 for no fading, \
             and 1e-30 for less than that.",
        ),
        field(
            "range",
            Number(POSITIVE),
            Json("0"),
            "Point and spot lights: the distance beyond which nothing is left, in scene units; 0 \
             for no end, and \
             1e-30 for less than that.",
        ),
    ],
};

pub(in crate::document) static NODE: Shape = Shape {
    name: "node",
    help: "A node of a graph.",
    fields: &[
        field(
            "id",
            Slug,
            Words("the kind, if no other node has that id"),
            "Its id within the graph; wires and keys name it.",
        ),
        field("kind", Text(64), Required, "A node of the library, or the id of a definition."),
        field(
            "name",
            Text(LINE),
            Json("\"\""),
            "What the artist calls it; empty for the kind's label.",
        ),
        AT,
        field("values", Map(&Value, 1000), Json("{}"), "The values of unwired inputs, by port."),
        field(
            "tier",
            Word(Tier::WORDS),
            Words("that of the group's node it lies in, or else the look's"),
            "Which implementation is asked for; of a group's node, for every node in it.",
        ),
        field(
            "muted",
            Bool,
            Json("false"),
            "Whether it is left out: what comes in goes out as it is.",
        ),
        field(
            "collapsed",
            Bool,
            Json("false"),
            "Whether the canvas shows no more of it than its title.",
        ),
    ],
};

pub(in crate::document) static WIRE: Shape = Shape {
    name: "wire",
    help: "A wire from an output to an input.",
    fields: &[
        field(
            "from",
            Output,
            Required,
            "The output, `node.port`; `node` alone is its only or first output.",
        ),
        field("to", Input, Required, "The input, `node.port`."),
    ],
};

pub(in crate::document) static FRAME: Shape = Shape {
    name: "frame",
    help: "A titled rectangle behind nodes.",
    fields: &[
        field(
            "title",
            Text(LINE),
            Json("\"\""),
            "What is written on it; names the function that its nodes become.",
        ),
        field("color", Color { alpha: false }, Words("the theme's own"), "Straight RGB, as shown."),
        field("nodes", List(&Slug, MAX_NODES), Json("[]"), "The ids of the nodes in it."),
    ],
};

pub(in crate::document) static NOTE: Shape = Shape {
    name: "note",
    help: "A text on the canvas.",
    fields: &[
        field("text", Text(LONG), Json("\"\""), "What it says."),
        AT,
        field("width", Number(Bounds::new(40.0, 1e4)), Json("220"), "How wide it is, in points."),
        field("color", Color { alpha: false }, Words("the theme's own"), "Straight RGB, as shown."),
    ],
};

pub(in crate::document) static BOOKMARK: Shape = Shape {
    name: "bookmark",
    help: "A view of the canvas that a key brings back.",
    fields: &[
        field("key", Number(Bounds::whole(1.0, 9.0)), Required, "The key."),
        field(
            "at",
            Numbers(2, 2, Bounds::new(-1e9, 1e9)),
            Json("[0, 0]"),
            "The point of the graph at the canvas's centre, x right and y down.",
        ),
        field(
            "zoom",
            Number(Bounds::new(0.001, 1000.0)),
            Json("1"),
            "Points of the screen for each point of the graph.",
        ),
    ],
};

pub(in crate::document) static DEFINITION: Shape = Shape {
    name: "definition",
    help: "A group: a graph with inputs and outputs, used by nodes whose kind is its id.",
    fields: &[
        field("label", Text(LINE), Json("\"\""), "What its nodes are called; empty for the id."),
        field("help", Text(LONG), Json("\"\""), "What it does."),
        field(
            "inputs",
            List(&Object(&INTERFACE_PORT), 1000),
            Json("[]"),
            "Its inputs: inside, outputs of the node `inputs`.",
        ),
        field(
            "outputs",
            List(&Object(&INTERFACE_PORT), 1000),
            Json("[]"),
            "Its outputs: inside, inputs of the node `outputs`.",
        ),
        NODES,
        WIRES,
        FRAMES,
        NOTES,
        BOOKMARKS,
    ],
};

pub(in crate::document) static INTERFACE_PORT: Shape = Shape {
    name: "interface port",
    help: "An input or output of a group. What is left out comes from the inner port that it is \
           wired to first.",
    fields: &[
        field("name", Slug, Required, "Its name."),
        field("label", Text(LINE), Words("the inner port's"), "What is written beside the socket."),
        field("help", Text(LONG), Words("the inner port's"), "What is said about it."),
        field("default", Value, Words("the inner port's"), "Its value while unwired."),
        field("min", Number(F32), Words("the inner port's"), "The least value."),
        field(
            "max",
            Number(F32),
            Words("the inner port's"),
            "The greatest value, not below `min`.",
        ),
    ],
};

pub(in crate::document) static EXPOSED: Shape = Shape {
    name: "exposed parameter",
    help: "An input that may be set from outside by name.",
    fields: &[
        field("name", Slug, Required, "The parameter's name, used once."),
        field("target", super::Kind::Target, Required, "What it sets."),
        field(
            "label",
            Text(LINE),
            Json("\"\""),
            "What is written beside it; empty for the port's label.",
        ),
    ],
};

pub(in crate::document) static DIRECTION_KEYS: Shape = Shape {
    name: "direction keys",
    help: "Values pinned at directions and interpolated over the sphere between them.",
    fields: &[
        field("name", Text(LINE), Json("\"\""), "What the artist calls it."),
        field(
            "by",
            KeyDirection,
            Required,
            "Which direction decides, or which numbers: see [drivers](#drivers).",
        ),
        field(
            "scheme",
            Word(KeyScheme::WORDS),
            Json("\"biharmonic\""),
            "How weights are computed.",
        ),
        field("keys", List(&Object(&DIRECTION_KEY), 1000), Json("[]"), "The keys."),
    ],
};

pub(in crate::document) static DIRECTION_KEY: Shape = Shape {
    name: "direction key",
    help: "Values at one direction.",
    fields: &[
        field(
            "direction",
            Direction,
            Words("required, unless drivers decide"),
            "Where, unless drivers decide; any length but 0. By a light: in camera axes (x right, \
             y up, z toward the viewer). By view: from the object's centre to the eye, in world \
             space.",
        ),
        field(
            "at",
            Numbers(1, 3, FAR),
            Words("required, if drivers decide"),
            "Where, if drivers decide: a number for each, in their order.",
        ),
        field(
            "values",
            TargetValues,
            Json("{}"),
            "The values there, by target; what is left out has the look's own value.",
        ),
    ],
};

pub(in crate::document) static TIME_KEYS: Shape = Shape {
    name: "time keys",
    help: "The values of one target over time.",
    fields: &[
        field("target", super::Kind::Target, Required, "What changes."),
        field(
            "keys",
            List(&Object(&TIME_KEY), 100_000),
            Json("[]"),
            "The keys, in increasing time.",
        ),
    ],
};

pub(in crate::document) static TIME_KEY: Shape = Shape {
    name: "time key",
    help: "A value at one time.",
    fields: &[
        field("time", Number(FAR), Required, "When, in seconds."),
        field("value", Value, Required, "The value then."),
        INTERPOLATION,
    ],
};

pub(in crate::document) static CURVE: Shape = Shape {
    name: "curve",
    help: "A function of one number, drawn through points and flat outside them.",
    fields: &[
        field(
            "points",
            List(&Numbers(2, 2, F32), Curve::MAX_POINTS),
            Required,
            "`[x, y]` pairs in increasing x; at least one.",
        ),
        INTERPOLATION,
    ],
};

pub(in crate::document) static RAMP: Shape = Shape {
    name: "ramp",
    help: "A color that changes along one number.",
    fields: &[
        field(
            "stops",
            List(&Object(&RAMP_STOP), Ramp::MAX_STOPS),
            Required,
            "In increasing `at`; at least one.",
        ),
        INTERPOLATION,
    ],
};

pub(in crate::document) static RAMP_STOP: Shape = Shape {
    name: "ramp stop",
    help: "One color of a ramp.",
    fields: &[
        field("at", Number(F32), Required, "Where along the ramp."),
        field(
            "color",
            Color { alpha: true },
            Required,
            "Straight RGB or RGBA in the look's color space.",
        ),
    ],
};
