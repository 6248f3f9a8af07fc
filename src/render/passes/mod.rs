//! Encoding of passes for the GPU: meshes with the looks' modules, one triangle over the picture,
//! and the picture itself.

use wgpu::util::DeviceExt as _;

mod blank;
mod lists;
mod look;
mod meshes;
mod parts;
mod resources;
mod screen;

pub(crate) use blank::BlankPipeline;
pub(crate) use look::{background, cleared, depth_attachment};
pub(crate) use parts::{
    DepthTest, PipelineParts, UNFILTERED, layout_of, targets_of, texels_type, uniform_type,
};
pub(crate) use screen::{ScreenPipeline, tested_depth};

/// A uniform buffer with these contents.
pub(crate) fn uniform(device: &wgpu::Device, contents: &[u8]) -> wgpu::Buffer {
    device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("uniform"),
        contents,
        usage: wgpu::BufferUsages::UNIFORM,
    })
}
