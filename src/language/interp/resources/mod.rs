//! What a program reads from outside: buffers, textures and samplers, and how they are handed to
//! it.

mod bind;
mod sampler;
mod texture;
mod world;

pub use bind::{Bindings, Bound};
pub use sampler::{Address, Filter, Sampler, SamplerCompare};
pub use texture::{Level, Texture, TextureDimension};
pub(super) use world::{Held, Source, World};

use super::Shape;

/// A variable of the module that a program reads and somebody must fill.
#[derive(Clone, Debug, PartialEq)]
pub struct Resource {
    /// `@group`
    pub group: u32,
    /// `@binding`
    pub binding: u32,
    /// Its name in the source, or empty.
    pub name: String,
    /// What is to be bound.
    pub kind: ResourceKind,
}

/// What a [`Resource`] takes.
#[derive(Clone, Debug, PartialEq)]
pub enum ResourceKind {
    /// A uniform or storage buffer of a fixed size.
    Buffer(Shape),
    /// A storage buffer that ends in an array of any length.
    Unsized {
        /// Name and shape of each member before the array; none if the whole buffer is the array.
        head: Option<Vec<(String, Shape)>>,
        /// An element of the array.
        element: Shape,
    },
    /// A texture.
    Texture {
        /// Its dimension.
        dimension: TextureDimension,
        /// Whether it may have several layers.
        is_arrayed: bool,
        /// What a texel is read as.
        texel: Texel,
    },
    /// A sampler.
    Sampler {
        /// Whether it compares with a reference depth.
        is_comparison: bool,
    },
}

/// What a texel is read as.
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
