//! Resources that a program reads from outside: buffers, textures and samplers, and how they are
//! bound.

mod bind;
mod content;
mod sampler;
mod texture;

pub use bind::{Bindings, BoundProgram};
pub(super) use content::{BoundContent, BoundResources, SlotSource};
pub use sampler::{AddressMode, Filter, Sampler, SamplerCompare};
pub use texture::{Texture, TextureDimension, TextureLevel};

use super::Shape;

/// Variable of the module that a program reads and the caller must bind.
#[derive(Clone, Debug, PartialEq)]
pub struct Resource {
    /// `@group`
    pub group: u32,
    /// `@binding`
    pub binding: u32,
    /// Name in the source, or empty.
    pub name: String,
    /// Kind of the resource to bind.
    pub kind: ResourceKind,
}

/// Kind of a [`Resource`].
#[derive(Clone, Debug, PartialEq)]
pub enum ResourceKind {
    /// Uniform or storage buffer of a fixed size.
    Buffer(Shape),
    /// Storage buffer that ends in an array of any length.
    Unsized {
        /// Name and shape of each member before the array; none if the whole buffer is the array.
        head: Option<Vec<(String, Shape)>>,
        /// Shape of an element of the array.
        element: Shape,
    },
    /// Texture.
    Texture {
        /// Dimension of the texture.
        dimension: TextureDimension,
        /// True if the texture may have several layers.
        is_arrayed: bool,
        /// Type that a texel is read as.
        texel: Texel,
    },
    /// Sampler.
    Sampler {
        /// True if the sampler compares with a reference depth.
        is_comparison: bool,
    },
}

/// Type that a texel is read as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Texel {
    /// Four floats.
    Float,
    /// Four i32.
    I32,
    /// Four u32.
    U32,
    /// One float.
    Depth,
}
