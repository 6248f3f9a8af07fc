//! Contexts where a look is evaluated at samples, without a scene.

use glam::{DMat3, DVec2, DVec3};

use super::Context;
use crate::interp::Value;

/// A part of a sample that a context follows from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SurfacePart {
    /// The surface's normal.
    Normal,
    /// The surface's tangent.
    Tangent,
    /// The direction to the eye.
    View,
    /// The place on the surface.
    Position,
    /// The camera's rotation.
    Camera,
    /// Texture coordinates.
    Uv,
    /// The vertices' color.
    VertexColor,
    /// The curvature.
    Kappa,
    /// The clock.
    Time,
}

/// A point of a surface, its vectors unit and in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The surface's normal.
    pub normal: DVec3,
    /// Along u, at a right angle to the normal.
    pub tangent: DVec3,
    /// Along v, at a right angle to both.
    pub bitangent: DVec3,
    /// From the surface to the eye.
    pub view: DVec3,
    /// The place, which is the same in the object's own space.
    pub position: DVec3,
    /// Rows right, up and toward the viewer: camera from world.
    pub camera: DMat3,
    /// Texture coordinates.
    pub uv: DVec2,
    /// Straight RGBA of the vertices.
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

/// The value of a context at a sample.
#[derive(Clone, Copy, Debug)]
pub enum ContextSample {
    /// What follows from parts of the sample.
    Of {
        /// The parts that are read.
        parts: &'static [SurfacePart],
        /// The value.
        value: fn(&SurfacePoint) -> Value,
    },
    /// Numbers of its own, which a sample gives under the context's word.
    Own {
        /// The numbers of a sample that gives none.
        default: &'static [f64],
        /// The least and the greatest that are documented.
        range: (Option<f64>, Option<f64>),
    },
    /// Nothing at the surface: the host computes it, from these parts of a sample where any.
    None(&'static [SurfacePart]),
}

impl ContextSample {
    /// The parts of a sample that the value follows from.
    pub fn parts(&self) -> &'static [SurfacePart] {
        match self {
            Self::Of { parts, .. } | Self::None(parts) => parts,
            Self::Own { .. } => &[],
        }
    }

    /// The value of `context`, whose row this is of, at a point; `given` are its own numbers where a
    /// sample gives any.
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

/// A vector as a value.
pub(super) fn vec3(vector: DVec3) -> Value {
    Value::vec(&vector.to_array())
}
