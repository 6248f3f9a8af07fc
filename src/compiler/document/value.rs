//! The values that an artist types into unwired inputs.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::ids::PortName;

/// The value of an unwired input. What an input takes is the node's business: `chiaro nodes` lists
/// it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// On or off.
    Bool(bool),
    /// A number; angles in radians.
    Number(f64),
    /// A vector or a color (`[r, g, b]` is opaque).
    Vector(Vec<f64>),
    /// A choice (`"add"`), a light's id, an asset's path, WGSL source, or a color as `"#rrggbb"`
    /// or `"#rrggbbaa"`.
    Text(String),
    /// A free curve.
    Curve(Curve),
    /// A color ramp.
    Ramp(Ramp),
}

/// The values of a node's unwired inputs by port name; what is left out has the node's default.
pub type Values = IndexMap<PortName, Value>;

/// A function of one number, drawn through points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// `[x, y]` pairs in increasing x; at most [`Curve::MAX_POINTS`]. Outside the first and last x
    /// the curve is flat.
    pub points: Vec<[f64; 2]>,
    /// How neighbouring points are joined.
    #[serde(default)]
    pub interpolation: Interpolation,
}

impl Curve {
    /// As many points as a shader's curve holds.
    pub const MAX_POINTS: usize = 16;
}

/// A color that changes along one number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ramp {
    /// In increasing `at`; at most [`Ramp::MAX_STOPS`].
    pub stops: Vec<RampStop>,
    /// How neighbouring stops are joined.
    #[serde(default)]
    pub interpolation: Interpolation,
}

impl Ramp {
    /// As many stops as a shader's ramp holds.
    pub const MAX_STOPS: usize = 16;
}

/// One color of a ramp.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RampStop {
    /// Where along the ramp.
    pub at: f64,
    /// Straight RGB or RGBA.
    pub color: Vec<f64>,
}

/// How neighbouring points of a curve, a ramp or a time track are joined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Interpolation {
    /// Straight.
    #[default]
    Linear,
    /// Smooth, without overshoot (monotone cubic).
    Smooth,
    /// Each point's value holds until the next point.
    Stepped,
}
