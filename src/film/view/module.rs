//! Views as WGSL, with the tables that they read.

use ::ocio::gpu::wgsl::WgslTextureFormat;
use ::ocio::gpu::{GpuShaderCreator as _, GpuShaderDesc};
use ::ocio::{Error, GpuLanguage, Processor};

use crate::frame::{DisplayModule, DisplayTable};

/// The largest side of a table, in texels: what every device has.
const MOST_TEXELS: u32 = 4096;

/// The module of a view.
pub(super) fn module(processor: &Processor) -> Result<DisplayModule, Error> {
    let mut shader = GpuShaderDesc::new();
    shader.set_language(GpuLanguage::Wgsl);
    shader.set_function_name(DisplayModule::FUNCTION);
    shader.set_resource_prefix("view_");
    shader.set_texture_max_width(MOST_TEXELS);
    shader.set_descriptor_set_index(DisplayModule::GROUP, 1)?;
    processor.default_gpu_processor()?.extract_gpu_shader_info(&mut shader)?;
    let bindings = shader.wgsl_bindings().cloned().unwrap_or_default();
    let uniforms = match bindings.uniform_binding {
        Some(binding) => Some((binding, bindings.uniform_buffer(&shader)?)),
        None => None,
    };
    let mut tables = Vec::with_capacity(bindings.textures.len());
    for texture in &bindings.textures {
        let flat = (0..shader.num_textures()).map(|at| shader.texture(at));
        let solid = (0..shader.num_3d_textures()).map(|at| shader.texture_3d(at));
        let mut all = flat.chain(solid).flatten();
        let source = all.find(|one| one.texture_name == texture.texture_name);
        let values = source.map_or(&[][..], |one| one.values.as_slice());
        tables.push(DisplayTable {
            binding: texture.binding,
            dimensions: texture.dimensions,
            size: [texture.width, texture.height, texture.depth],
            has_colors: texture.format == WgslTextureFormat::Rgba32Float,
            texels: texture.texel_data(values)?,
        });
    }
    Ok(DisplayModule { text: shader.shader_text().to_owned(), uniforms, tables })
}
