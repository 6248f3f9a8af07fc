//! Long shadows: made by Chiaro 0.1.0, a look as a material for wgpu 30.
//!
//! ```no_run
//! # use long_shadows::{Camera, Material, Object, Output, Target};
//! # fn draw(device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder,
//! #     target: &Target, camera: &Camera, object: Object) -> Result<(), long_shadows::Error> {
//! let mut material = Material::new(device, Output {
//!     color: wgpu::TextureFormat::Rgba8Unorm,
//!     depth: wgpu::TextureFormat::Depth32Float,
//!     samples: 4,
//! })?;
//! material.lights.sun.intensity = 1.0;
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
mod lights;
mod look;
mod material;
mod math;
mod scene;
mod shadow_maps;
mod targets;
mod uniforms;

pub use error::Error;
pub use lights::{DirectionalLight, Lights};
pub use material::{Material, Output, Picture, Target};
pub use scene::{Camera, Mesh, MeshData, MeshPart, Object};
