//! Hand-painted 6D textures (HCBTFs): how their files are read and written, how rules fill what is not painted, and how
//! all of it becomes the texture that shaders look up.

mod layers;

pub use layers::{LayerOptions, Layers, layers, layers_bytes, layers_size};
