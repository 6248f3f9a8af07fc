//! Triangles that cast shadows, on the GPU: one texture, of which only the first rows are written
//! anew when objects move.

use std::sync::Arc;

use super::gpu::Gpu;
use crate::frame::{Casters, FramePlan};
use crate::{RenderError, Renderer};

/// Number of bytes that are written at a time.
const PIECE: usize = 32 << 20;

/// Size of a texel, in bytes.
const TEXEL: usize = 16;

/// The casters of the last plan that had any.
#[derive(Debug)]
pub(crate) struct CastersTexture {
    casters: Arc<Casters>,
    texture: wgpu::Texture,
    view: wgpu::TextureView,
}

impl CastersTexture {
    /// The texture of these casters.
    ///
    /// # Errors
    /// A scene that is larger than a texture of this device.
    pub(crate) fn new(gpu: &Gpu, casters: &Arc<Casters>) -> Result<Self, RenderError> {
        let [width, height] = casters.size();
        gpu.check_size([width, height])?;
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("casters"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let made = Self { casters: casters.clone(), texture, view };
        let mut row = made.write(gpu, 0, &casters.head());
        for tree in casters.trees() {
            row = made.write(gpu, row, &tree.texels);
        }
        Ok(made)
    }

    /// Writes texels from the beginning of a row, and returns the next free row.
    fn write(&self, gpu: &Gpu, row: u32, texels: &[[f32; 4]]) -> u32 {
        let width = self.texture.width() as usize;
        let rows_at_once = (PIECE / (TEXEL * width)).max(1);
        let mut row = row;
        for piece in texels.chunks(rows_at_once * width) {
            let mut piece = std::borrow::Cow::Borrowed(piece);
            if piece.len() % width != 0 {
                let whole = piece.len().next_multiple_of(width);
                piece.to_mut().resize(whole, [0.0; 4]);
            }
            let rows = (piece.len() / width) as u32;
            gpu.queue.write_texture(
                wgpu::TexelCopyTextureInfo {
                    texture: &self.texture,
                    mip_level: 0,
                    origin: wgpu::Origin3d { x: 0, y: row, z: 0 },
                    aspect: wgpu::TextureAspect::All,
                },
                bytemuck::cast_slice(&piece),
                wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some((TEXEL * width) as u32),
                    rows_per_image: None,
                },
                wgpu::Extent3d { width: width as u32, height: rows, depth_or_array_layers: 1 },
            );
            row += rows;
        }
        row
    }

    /// True if only the first rows differ from those of `casters`.
    fn has_trees_of(&self, casters: &Casters) -> bool {
        let (own, other) = (self.casters.trees(), casters.trees());
        self.casters.size() == casters.size()
            && own.len() == other.len()
            && own.iter().zip(other).all(|(own, other)| Arc::ptr_eq(own, other))
    }

    /// The texture, ready to be bound.
    pub(crate) fn resource(&self) -> wgpu::BindingResource<'_> {
        wgpu::BindingResource::TextureView(&self.view)
    }
}

impl Renderer {
    /// Brings the casters of a plan to the GPU; forgets those of the plan before where it has none.
    pub(crate) fn prepare_casters(&mut self, plan: &FramePlan) -> Result<(), RenderError> {
        let Some(casters) = &plan.casters else {
            self.casters = None;
            return Ok(());
        };
        match &mut self.casters {
            Some(known) if known.casters.hash() == casters.hash() => {}
            Some(known) if known.has_trees_of(casters) => {
                known.write(&self.gpu, 0, &casters.head());
                known.casters = casters.clone();
            }
            _ => self.casters = Some(CastersTexture::new(&self.gpu, casters)?),
        }
        Ok(())
    }
}
