//! Values that an artist types into unwired inputs.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::described::described;
use super::shape::{F32, FieldKind};
use super::word::WordChoice as _;
use crate::ids::PortName;

/// Value of an unwired input. The node decides which values an input takes: `chiaro nodes` lists
/// them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// Switch, on or off.
    Bool(bool),
    /// Number; angles in radians.
    Number(f64),
    /// Vector or color (`[r, g, b]` is opaque).
    Vector(Vec<f64>),
    /// Choice (`"add"`), a light's id, an asset's path, WGSL source, or a color as `"#rrggbb"` or
    /// `"#rrggbbaa"`.
    Text(String),
    /// Free curve.
    Curve(Curve),
    /// Color ramp.
    Ramp(Ramp),
}

/// Values of a node's unwired inputs by port name; absent inputs have the node's default.
pub type Values = IndexMap<PortName, Value>;

described! {
    /// A function of one number, drawn through points and flat outside them.
    pub struct Curve("curve", Inline) {
        /// `[x, y]` pairs in increasing x; at least one.
        points: Vec<[f64; 2]> = Vec::new(),
            FieldKind::List(&FieldKind::Numbers(2, 2, F32), Curve::MAX_POINTS), required;
        /// Interpolation between neighbors.
        #[serde(default)]
        interpolation: Interpolation = Interpolation::Linear, FieldKind::Word(Interpolation::WORDS);
    }
}

impl Curve {
    /// Greatest number of points, as many as a shader's curve holds.
    pub const MAX_POINTS: usize = 16;
}

described! {
    /// A color that changes along one number.
    pub struct Ramp("ramp", Inline) {
        /// In increasing `at`; at least one.
        stops: Vec<RampStop> = Vec::new(),
            FieldKind::List(&FieldKind::Object(RampStop::shape), Ramp::MAX_STOPS), required;
        /// Interpolation between neighbors.
        #[serde(default)]
        interpolation: Interpolation = Interpolation::Linear, FieldKind::Word(Interpolation::WORDS);
    }
}

impl Ramp {
    /// Greatest number of stops, as many as a shader's ramp holds.
    pub const MAX_STOPS: usize = 16;
}

described! {
    /// One color of a ramp.
    pub struct RampStop("ramp stop", Inline) {
        /// Place along the ramp.
        at: f64, FieldKind::Number(F32), required;
        /// Straight RGB or RGBA in the look's color space.
        color: Vec<f64>, FieldKind::Color { alpha: true }, required, by ColorCodec;
    }
}

/// Interpolation between neighboring points of a curve or a ramp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Interpolation {
    /// Straight line between points.
    #[default]
    Linear,
    /// Smooth curve without overshoot (monotone cubic).
    Smooth,
    /// Step: each point's value holds until the next point.
    Stepped,
}
