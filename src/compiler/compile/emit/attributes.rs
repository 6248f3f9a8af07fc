//! Vertex attributes of a mesh, and the varyings by which they reach a fragment.

use super::surface::ExpressionInputs;
use crate::compile::Needs;
use crate::library::Context;

/// A vertex attribute.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum VertexAttribute {
    /// Object space, `vec3f`, location 0.
    Position,
    /// Unit, object space, `vec3f`, location 1.
    Normal,
    /// Unit with handedness, object space, `vec4f`, location 2.
    Tangent,
    /// `vec2f`, location 3.
    Uv,
    /// Straight RGBA, `vec4f`, location 4.
    Color,
    /// Position before the mesh was deformed, object space, `vec3f`, location 5.
    Rest,
}

impl VertexAttribute {
    /// All of them, by location.
    pub const ALL: [Self; 6] =
        [Self::Position, Self::Normal, Self::Tangent, Self::Uv, Self::Color, Self::Rest];

    /// Location, the same in every module.
    pub fn location(self) -> u32 {
        self as u32
    }

    /// Name in WGSL.
    pub fn name(self) -> &'static str {
        match self {
            Self::Position => "position",
            Self::Normal => "normal",
            Self::Tangent => "tangent",
            Self::Uv => "uv",
            Self::Color => "color",
            Self::Rest => "rest",
        }
    }

    /// Type in WGSL.
    pub fn wgsl_type(self) -> &'static str {
        match self {
            Self::Position | Self::Normal | Self::Rest => "vec3f",
            Self::Tangent | Self::Color => "vec4f",
            Self::Uv => "vec2f",
        }
    }
}

/// A number that is interpolated over triangles.
#[derive(Debug)]
pub(super) struct SurfaceVarying {
    /// Name of the varying: expressions read it as a member of `in`.
    pub(super) name: &'static str,
    pub(super) wgsl_type: &'static str,
    /// The value at a vertex.
    pub(super) value: &'static str,
    /// The attribute that it is made from.
    pub(super) attribute: VertexAttribute,
}

impl SurfaceVarying {
    /// Name of the place in the object's own space, to which marks stick: of a deformed mesh the
    /// place before.
    const PLACE: &'static str = "position_object";

    /// The value at a vertex, of a mesh that is deformed or not.
    pub(super) fn value_on(&self, is_deformed: bool) -> &'static str {
        if is_deformed && self.name == Self::PLACE { "vertex.rest" } else { self.value }
    }

    /// The attribute that the value is made from, on a mesh that is deformed or not.
    fn attribute_on(&self, is_deformed: bool) -> VertexAttribute {
        let is_rest = is_deformed && self.name == Self::PLACE;
        if is_rest { VertexAttribute::Rest } else { self.attribute }
    }
}

/// Every varying that there is, in the order of locations. The place in clip space, `in.clip`, is
/// there without being asked for.
pub(super) const VARYINGS: [SurfaceVarying; 6] = [
    SurfaceVarying {
        name: "position",
        wgsl_type: "vec3f",
        value: "world.xyz",
        attribute: VertexAttribute::Position,
    },
    SurfaceVarying {
        name: "position_object",
        wgsl_type: "vec3f",
        value: "vertex.position",
        attribute: VertexAttribute::Position,
    },
    SurfaceVarying {
        name: "normal",
        wgsl_type: "vec3f",
        value: "object.world_from_normal * vertex.normal",
        attribute: VertexAttribute::Normal,
    },
    // An object that is mirrored has its bitangents on the other side of normal and tangent.
    SurfaceVarying {
        name: "tangent",
        wgsl_type: "vec4f",
        value: "vec4f((object.world_from_object * vec4f(vertex.tangent.xyz, 0.0)).xyz, \
                select(vertex.tangent.w, -vertex.tangent.w, \
                determinant(object.world_from_normal) < 0.0))",
        attribute: VertexAttribute::Tangent,
    },
    SurfaceVarying {
        name: "uv",
        wgsl_type: "vec2f",
        value: "vertex.uv",
        attribute: VertexAttribute::Uv,
    },
    SurfaceVarying {
        name: "color",
        wgsl_type: "vec4f",
        value: "vertex.color",
        attribute: VertexAttribute::Color,
    },
];

impl Needs {
    /// The vertex attributes that a module with these needs reads.
    pub fn attributes(&self) -> Vec<VertexAttribute> {
        let of_contexts = self
            .contexts
            .iter()
            .flat_map(|context| VertexAttribute::read_on(self.is_deformed, *context));
        let mut attributes: Vec<VertexAttribute> =
            std::iter::once(VertexAttribute::Position).chain(of_contexts).collect();
        attributes.sort_unstable();
        attributes.dedup();
        attributes
    }
}

impl VertexAttribute {
    /// The attributes that a context is made from where a mesh is drawn.
    pub fn read_by(context: Context) -> Vec<Self> {
        Self::read_on(false, context)
    }

    /// The attributes that a context is made from where a mesh is drawn that is deformed or not.
    fn read_on(is_deformed: bool, context: Context) -> Vec<Self> {
        let reads = ExpressionInputs::of(context);
        let read = VARYINGS.iter().filter(|varying| reads.varying(varying.name));
        read.map(|varying| varying.attribute_on(is_deformed)).collect()
    }
}
