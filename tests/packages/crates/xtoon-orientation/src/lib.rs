//! Ink at the turn: made by Chiaro 0.1.0, a look as a material for wgpu 30.
//!
//! ```no_run
//! # use xtoon_orientation::{Camera, Material, Object, Output, Target};
//! # fn draw(device: &wgpu::Device, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder,
//! #     target: &Target, camera: &Camera, object: Object) -> Result<(), xtoon_orientation::Error> {
//! let mut material = Material::new(device, queue, Output {
//!     color: wgpu::TextureFormat::Rgba8Unorm,
//!     depth: wgpu::TextureFormat::Depth32Float,
//!     samples: 4,
//! })?;
//! material.lights.key.intensity = 1.0;
//! material.draw(device, encoder, target, camera, &[object]);
//! # Ok(())
//! # }
//! ```
//!
//! In a render pass of your own: [`Material::prepare`], then [`Picture::paint`].

mod error;
// Translated code, as it was written.
#[rustfmt::skip]
mod host;
mod images;
mod lights;
mod look;
mod material;
mod math;
mod scene;
mod uniforms;

pub use error::Error;
pub use lights::{DirectionalLight, Lights};
pub use material::{Material, Output, Picture, Target};
pub use scene::{Camera, Mesh, MeshData, MeshPart, Object};
