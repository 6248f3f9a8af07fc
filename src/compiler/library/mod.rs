//! The library of nodes. Every node is one WGSL file, which this module reads with its description.
//!
//! A file `nodes/<category>/<kind>.wgsl` holds one or more functions whose names begin with the
//! kind. The first function's doc comment gives label, help, ports and presets (see [`docs`]); the
//! signatures of all functions give ports and types. The part of a name after the kind gives the
//! role of the function:
//!
//! - a choice's word (`blend_add`): the implementation for that choice;
//! - `vec2`, `vec3`, `vec4`, `color`: the implementation for wider inputs;
//! - `balanced`, `fast`: a cheaper tier;
//! - `prepare`: computes, from the artist's parameters, the struct that the other functions take as
//!   their parameter of that type.
//!
//! A parameter of the name of a choice, an `i32`, takes the position of the choice's word.
//!
//! Files under a project's own `nodes/` folder are read the same way and add to the library. A file
//! `nodes/<category>/<name>.json` is a look whose `definitions` become groups of the library.

mod context;
pub mod docs;
mod embedded;
mod group;
mod load;
mod lookup;
mod module;
mod node;
mod passes;
mod read;
mod rules;
mod types;

/// Categories that have a color of their own, in the order of palettes and of tables. The category
/// of a node is the folder of its file, and a project's folders may have any names.
pub const CATEGORIES: [&str; 14] = [
    "layer",
    "light",
    "curvature",
    "geometry",
    "color",
    "vector",
    "math",
    "input",
    "highlight",
    "material",
    "texture",
    "shape",
    "marks",
    "screen",
];

pub use context::{
    Context, ContextBounds, ContextRow, ContextSample, ContextSource, HostSurroundings,
    MAX_COORDINATE, MAX_CURVATURE, MAX_LINE_REACH, MAX_NORMAL_SCALE, MAX_ON_SCREEN, MAX_PLACE,
    Rate, SurfacePart, SurfacePoint,
};
pub use embedded::NODES;
pub use group::{CUSTOM_CODE, CUSTOM_KIND, GroupPorts};
pub use load::node_files;
pub use load::{GroupDef, Library};
pub use module::{ModuleDeclaration, NodeModule};
pub use node::{
    ArgumentSource, Bypass, BypassResult, Condition, Fallback, Input, LightFeed, Limit, NodeDef,
    NodeFunction, Output, PrepareFunction, Preset, Test, TierError, Treatment,
};
pub use passes::{
    PassId, PassInput, PassOutput, PassRow, PassWork, ScreenExtent, Stage, StageRow, StageValue,
    TexelFormat,
};
pub use read::load_node;
pub use rules::{Fact, FactLimit, FormRule};
pub use types::{Conversion, Type};
