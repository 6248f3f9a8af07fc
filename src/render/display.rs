//! The last step of a picture that is shown otherwise than by the curve of sRGB: one triangle that
//! reads the picture, with the module of a view.

use std::sync::Arc;

use wgpu::util::DeviceExt as _;

use super::gpu::Gpu;
use super::passes::{
    PipelineParts, UNFILTERED, cleared, layout_of, texels_type, uniform, uniform_type,
};
use super::target;
use crate::frame::{DisplayModule, DisplayTable};

/// Name of the pass and its resources, for debuggers of GPUs.
const LABEL: &str = "display";

/// A [`DisplayModule`] on a GPU, with the picture that it makes.
#[derive(Debug)]
pub(super) struct Display {
    module: Arc<DisplayModule>,
    pipeline: wgpu::RenderPipeline,
    of_picture: wgpu::BindGroupLayout,
    /// The module's own bindings.
    tables: wgpu::BindGroup,
    target: Option<wgpu::Texture>,
}

impl Display {
    pub(super) fn new(gpu: &Gpu, module: Arc<DisplayModule>) -> Self {
        let device = &gpu.device;
        let fragment = wgpu::ShaderStages::FRAGMENT;
        let image = texels_type(UNFILTERED, wgpu::TextureViewDimension::D2);
        let of_picture = layout_of(device, LABEL, fragment, [(0, image)]);
        let numbers = module.uniforms.iter().map(|(at, _)| (*at, uniform_type(false)));
        let textures = module.tables.iter();
        let textures = textures.map(|table| (table.binding, texels_type(UNFILTERED, shape(table))));
        let of_tables = layout_of(device, LABEL, fragment, numbers.chain(textures));
        let text = format!("{}\n{}", include_str!("display.wgsl"), module.text);
        let parts = PipelineParts {
            label: LABEL,
            text: &text,
            layouts: &[Some(&of_picture), Some(&of_tables)],
            buffers: &[],
            primitive: wgpu::PrimitiveState::default(),
            depth: None,
            samples: 1,
            targets: &[Some(gpu.picture.into())],
        };
        let pipeline = parts.pipeline(device);
        let numbers = module.uniforms.as_ref().map(|(at, bytes)| (*at, uniform(device, bytes)));
        let textures: Vec<_> =
            module.tables.iter().map(|table| (table.binding, upload(gpu, table))).collect();
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        let numbers = numbers.iter().map(|(at, buffer)| entry(*at, buffer.as_entire_binding()));
        let textures =
            textures.iter().map(|(at, view)| entry(*at, wgpu::BindingResource::TextureView(view)));
        let tables = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(LABEL),
            layout: &of_tables,
            entries: &numbers.chain(textures).collect::<Vec<_>>(),
        });
        Self { module, pipeline, of_picture, tables, target: None }
    }

    /// True if this is the display of a module.
    pub(super) fn is_of(&self, module: &Arc<DisplayModule>) -> bool {
        Arc::ptr_eq(&self.module, module)
    }

    /// Draws what is shown of a picture.
    pub(super) fn draw(
        &mut self,
        gpu: &Gpu,
        picture: &wgpu::Texture,
        encoder: &mut wgpu::CommandEncoder,
    ) {
        let is_it = |made: &wgpu::Texture| {
            made.size() == picture.size() && made.format() == picture.format()
        };
        let target = match self.target.take().filter(is_it) {
            Some(made) => made,
            None => {
                let usage = wgpu::TextureUsages::RENDER_ATTACHMENT
                    | wgpu::TextureUsages::TEXTURE_BINDING
                    | wgpu::TextureUsages::COPY_SRC;
                let size = [picture.width(), picture.height()];
                target::texture(gpu, size, picture.format(), 1, usage)
            }
        };
        let read = view_of(picture);
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(LABEL),
            layout: &self.of_picture,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&read),
            }],
        });
        let written = view_of(&target);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(LABEL),
            color_attachments: &[Some(cleared(&written, wgpu::Color::TRANSPARENT))],
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.set_bind_group(DisplayModule::GROUP, &self.tables, &[]);
        pass.draw(0..3, 0..1);
        drop(pass);
        self.target = Some(target);
    }

    /// The picture that was drawn last.
    pub(super) fn picture(&self) -> Option<&wgpu::Texture> {
        self.target.as_ref()
    }
}

fn view_of(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

fn shape(table: &DisplayTable) -> wgpu::TextureViewDimension {
    match table.dimensions {
        1 => wgpu::TextureViewDimension::D1,
        2 => wgpu::TextureViewDimension::D2,
        _ => wgpu::TextureViewDimension::D3,
    }
}

/// The texture of a table.
fn upload(gpu: &Gpu, table: &DisplayTable) -> wgpu::TextureView {
    let [width, height, depth_or_array_layers] = table.size;
    let dimension = match table.dimensions {
        1 => wgpu::TextureDimension::D1,
        2 => wgpu::TextureDimension::D2,
        _ => wgpu::TextureDimension::D3,
    };
    let format = match table.has_colors {
        true => wgpu::TextureFormat::Rgba32Float,
        false => wgpu::TextureFormat::R32Float,
    };
    let descriptor = wgpu::TextureDescriptor {
        label: Some(LABEL),
        size: wgpu::Extent3d { width, height, depth_or_array_layers },
        mip_level_count: 1,
        sample_count: 1,
        dimension,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    let order = wgpu::util::TextureDataOrder::LayerMajor;
    let texture =
        gpu.device.create_texture_with_data(&gpu.queue, &descriptor, order, &table.texels);
    view_of(&texture)
}
