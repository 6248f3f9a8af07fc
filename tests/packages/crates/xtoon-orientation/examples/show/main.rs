//! Ink at the turn: made by Chiaro 0.1.0. Draws the look into a picture, without a window:
//!
//! ```sh
//! cargo run --example show-xtoon-orientation -- picture.png 800 800
//! ```

mod scene;

use std::error::Error;

use xtoon_orientation::{Material, Object, Output, Target};

/// Samples of a pixel.
const SAMPLES: u32 = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let file = arguments.first().map_or("picture.png", String::as_str);
    let side = |index: usize| arguments.get(index).map_or(Ok(800), |text| text.parse());
    let size = [side(1)?, side(2)?];
    let (device, queue) = pollster::block_on(open())?;

    let format = Material::view_format(wgpu::TextureFormat::Rgba8UnormSrgb);
    let output = Output { samples: SAMPLES, ..Output::new(format) };
    let mut material = Material::new(&device, &queue, output)?;
    material.lights.key.intensity = 1.0;

    let picture = texture(&device, format, 1, size);
    let sampled = texture(&device, format, SAMPLES, size);
    let depth = output.depth_buffer(&device, size);
    let [picture_view, sampled, depth] = [&picture, &sampled, &depth].map(view);
    let target = Target {
        color: if SAMPLES > 1 { &sampled } else { &picture_view },
        resolve: (SAMPLES > 1).then_some(&picture_view),
        depth: &depth,
        size,
        clear: scene::BACKDROP,
    };
    let mesh = scene::mesh(&device)?;
    let object = Object { mesh: &mesh, world_from_object: scene::WORLD_FROM_OBJECT };
    let camera = scene::camera(f64::from(size[0]) / f64::from(size[1]));

    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    material.draw(&device, &queue, &mut encoder, &target, &camera, &[object]);
    queue.submit([encoder.finish()]);
    scene::save(&device, &queue, &picture, file)?;
    println!("{file}");
    Ok(())
}

/// The graphics card that the system offers first.
async fn open() -> Result<(wgpu::Device, wgpu::Queue), Box<dyn Error>> {
    let instance = wgpu::Instance::default();
    let adapter = instance.request_adapter(&wgpu::RequestAdapterOptions::default()).await?;
    let descriptor =
        wgpu::DeviceDescriptor { required_limits: adapter.limits(), ..Default::default() };
    Ok(adapter.request_device(&descriptor).await?)
}

fn texture(
    device: &wgpu::Device,
    format: wgpu::TextureFormat,
    sample_count: u32,
    [width, height]: [u32; 2],
) -> wgpu::Texture {
    let is_read = sample_count == 1;
    let read = if is_read { wgpu::TextureUsages::COPY_SRC } else { wgpu::TextureUsages::empty() };
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | read,
        view_formats: &[],
    })
}

fn view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
