//! Values of contexts where a look is evaluated at samples, without a scene.

use glam::{DMat3, DVec2, DVec3};

use super::Context;
use crate::interp::Value;

/// Part of a sample that a context follows from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SurfacePart {
    /// Normal of the surface.
    Normal,
    /// Tangent of the surface.
    Tangent,
    /// Direction from the surface to the eye.
    View,
    /// Position on the surface.
    Position,
    /// Rotation of the camera.
    Camera,
    /// Texture coordinates.
    Uv,
    /// Color of the vertices.
    VertexColor,
    /// Curvature of the surface.
    Kappa,
    /// Time of the clock.
    Time,
}

/// Point of a surface, its vectors unit and in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Normal of the surface.
    pub normal: DVec3,
    /// Tangent along u, at a right angle to the normal.
    pub tangent: DVec3,
    /// Tangent along v, at a right angle to both.
    pub bitangent: DVec3,
    /// Direction from the surface to the eye.
    pub view: DVec3,
    /// Position, which is the same in the object's own space.
    pub position: DVec3,
    /// Rotation from world to camera axes, with the rows right, up and toward the viewer.
    pub camera: DMat3,
    /// Texture coordinates.
    pub uv: DVec2,
    /// Color of the vertices, as RGBA with straight alpha.
    pub vertex_color: [f64; 4],
    /// Curvature in 1/viewport-height, convex positive.
    pub kappa: f64,
}

impl Default for SurfacePoint {
    fn default() -> Self {
        Self {
            normal: DVec3::Z,
            tangent: DVec3::X,
            bitangent: DVec3::Y,
            view: DVec3::Z,
            position: DVec3::ZERO,
            camera: DMat3::IDENTITY,
            uv: DVec2::ZERO,
            vertex_color: [1.0; 4],
            kappa: 0.0,
        }
    }
}

/// Value of a context at a sample.
#[derive(Clone, Copy, Debug)]
pub enum ContextSample {
    /// Value that follows from parts of the sample.
    Of {
        /// Parts that are read.
        parts: &'static [SurfacePart],
        /// Function that computes the value.
        value: fn(&SurfacePoint) -> Value,
    },
    /// Numbers of the context's own, which a sample gives under the context's word.
    Own {
        /// Numbers for a sample that gives none.
        default: &'static [f64],
        /// Least and greatest number that are documented.
        range: (Option<f64>, Option<f64>),
    },
    /// No value at the surface: the host computes the value, from these parts of a sample where
    /// any.
    None(&'static [SurfacePart]),
}

impl ContextSample {
    /// Parts of a sample that the value follows from.
    pub fn parts(&self) -> &'static [SurfacePart] {
        match self {
            Self::Of { parts, .. } | Self::None(parts) => parts,
            Self::Own { .. } => &[],
        }
    }

    /// Value of `context`, the row's own context, at a point; `given` are the context's own numbers
    /// where a sample gives any.
    pub fn value(&self, context: Context, point: &SurfacePoint, given: Option<&[f64]>) -> Value {
        match self {
            Self::Of { value, .. } => value(point),
            Self::Own { default, .. } => {
                let number = |index: usize| {
                    let given = given.and_then(|numbers| numbers.get(index));
                    given.or_else(|| default.get(index)).copied().unwrap_or_default()
                };
                if context.wgsl_type() == "f32" {
                    return Value::Float(number(0));
                }
                Value::vec(&(0..default.len()).map(number).collect::<Vec<_>>())
            }
            Self::None(_) => Value::Float(0.0),
        }
    }
}

/// Vector as a value.
pub(super) fn vec3(vector: DVec3) -> Value {
    Value::vec(&vector.to_array())
}
