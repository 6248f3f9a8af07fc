//! The library: every node is one WGSL file, and this room reads what the file says of itself.
//!
//! A file `nodes/<category>/<kind>.wgsl` holds one or more functions whose names begin with the
//! kind. The first one's doc comment tells label, help, ports and presets (see [`docs`]); its
//! signature and those of its siblings tell ports and types. What a name has after the kind says
//! what the function is:
//!
//! - a choice's word (`blend_add`): the implementation for that choice;
//! - `vec2`, `vec3`, `vec4`, `color`: the implementation for wider inputs;
//! - `balanced`, `fast`: a cheaper tier;
//! - `prepare`: turns artist's parameters into what the other functions take as their parameter of
//!   its result's type.
//!
//! Files under a project's own `nodes/` folder are read the same way and add to the library. A file
//! `nodes/<category>/<name>.json` is a look whose `definitions` become groups of the library.

mod context;
pub mod docs;
mod embedded;
mod group;
mod load;
mod node;
mod passes;
mod read;
mod types;

/// The categories that have a color of their own, in the order of palettes and of tables. The
/// folder that a node's file lies in is its category, and a project's folders may be any others.
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
    Bounds, Context, ContextRow, ContextSample, ContextSource, HostSurroundings, Rate, SurfacePart,
    SurfacePoint,
};
pub use embedded::NODES;
pub use group::{CUSTOM_CODE, CUSTOM_KIND, GroupPorts};
pub use load::node_files;
pub use load::{GroupDef, Library};
pub use node::{
    Bypass, BypassResult, Condition, Fallback, Input, Limit, NodeDef, NodeModule, Output,
    Parameter, Prepare, Preset, Special, Test, TierError, Variant,
};
pub use passes::{PassId, PassInput, PassOutput, PassRow, PassWork, Stage, TexelFormat};
pub use read::load_node;
pub use types::{Conversion, Type};
