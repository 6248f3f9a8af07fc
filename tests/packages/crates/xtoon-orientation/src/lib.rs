//! Ink at the turn: made by Chiaro 0.1.0, a look as a material for wgpu 30.
//!
//! ```no_run
//! use xtoon_orientation::{Camera, Error, Material, Mesh, MeshData, Object, Output, Target};
//!
//! /// Draws the look on a triangle into a texture.
//! pub fn draw(
//!     device: &wgpu::Device,
//!     queue: &wgpu::Queue,
//!     texture: &wgpu::Texture,
//! ) -> Result<(), Error> {
//!     let output = Output::new(texture.format());
//!     let mut material = Material::new(device, queue, output)?;
//!     material.lights.key.intensity = 1.0;
//!
//!     let data = MeshData {
//!         positions: &[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]],
//!         normals: &[[0.0, 0.0, 1.0]; 3],
//!         indices: &[0, 1, 2],
//!         parts: &[],
//!     };
//!     let mesh = Mesh::new(device, &data)?;
//!     let object = Object { mesh: &mesh, world_from_object: mesh.fit() };
//!     let size = [texture.width(), texture.height()];
//!     let aspect = f64::from(size[0]) / f64::from(size[1]);
//!     let (eye, up) = ([0.0, 0.0, 4.4], [0.0, 1.0, 0.0]);
//!     let camera = Camera::perspective(eye, [0.0; 3], up, 0.5, aspect, [0.1, 10.0]);
//!
//!     let whole = wgpu::TextureViewDescriptor::default();
//!     let target = Target {
//!         color: &texture.create_view(&whole),
//!         resolve: None,
//!         depth: &output.depth_buffer(device, size).create_view(&whole),
//!         size,
//!         clear: wgpu::Color::TRANSPARENT,
//!     };
//!     let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
//!     material.draw(device, queue, &mut encoder, &target, &camera, &[object]);
//!     queue.submit([encoder.finish()]);
//!     Ok(())
//! }
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
mod output;
mod scene;
mod uniforms;

pub use error::Error;
pub use lights::{DirectionalLight, Lights};
pub use material::{Material, Picture};
pub use output::{Encoding, Output, Target};
pub use scene::{Camera, Mesh, MeshBuffers, MeshData, MeshPart, Object};
