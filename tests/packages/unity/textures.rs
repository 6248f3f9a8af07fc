//! Textures as an engine has them in memory, for pictures that stand-ins draw.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use wgpu::util::DeviceExt as _;

/// A texture, or layers of one, with how it is sampled.
#[derive(Clone, Debug)]
pub(crate) struct Texture {
    pub(crate) size: [u32; 2],
    /// Numbers of 8 bits of every layer, in the order of the engine's memory.
    pub(crate) bytes: Vec<u8>,
    /// Number of layers; `None` for a flat image.
    pub(crate) layers: Option<u32>,
    /// True if colors are decoded to linear light as they are read.
    pub(crate) is_decoded: bool,
    pub(crate) is_linear: bool,
    pub(crate) wrap: wgpu::AddressMode,
}

/// Textures by the names that shaders have for them.
pub(crate) type Textures = BTreeMap<String, Texture>;

impl Texture {
    /// An image as Unity imports it, by its file of settings. Rows begin at the bottom.
    pub(super) fn imported(path: &Path) -> Self {
        let meta = fs::read_to_string(format!("{}.meta", path.display())).expect("settings");
        let number = |name: &str| -> u32 {
            let mut lines = meta.lines().filter_map(|line| line.trim().strip_prefix(name));
            let found = lines.next().unwrap_or_else(|| panic!("{name} in {meta}"));
            found.trim().parse().expect("a number")
        };
        assert_eq!((number("enableMipMap:"), number("nPOTScale:")), (0, 0), "{meta}");
        assert_eq!((number("aniso:"), number("textureCompression:")), (0, 0), "{meta}");
        let image = image::open(path).expect("an image").to_rgba8();
        let image = image::imageops::flip_vertical(&image);
        Self {
            size: image.dimensions().into(),
            bytes: image.into_raw(),
            layers: None,
            is_decoded: number("sRGBTexture:") == 1,
            is_linear: number("filterMode:") == 1,
            wrap: match number("wrapU:") {
                0 => wgpu::AddressMode::Repeat,
                1 => wgpu::AddressMode::ClampToEdge,
                _ => wgpu::AddressMode::MirrorRepeat,
            },
        }
    }

    /// The texture for a device.
    fn view(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> wgpu::TextureView {
        let format = match self.is_decoded {
            true => wgpu::TextureFormat::Rgba8UnormSrgb,
            false => wgpu::TextureFormat::Rgba8Unorm,
        };
        let [width, height] = self.size;
        let texture = device.create_texture_with_data(
            queue,
            &wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d {
                    width,
                    height,
                    depth_or_array_layers: self.layers.unwrap_or(1),
                },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            },
            wgpu::util::TextureDataOrder::LayerMajor,
            &self.bytes,
        );
        texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(self.dimension()),
            ..wgpu::TextureViewDescriptor::default()
        })
    }

    fn dimension(&self) -> wgpu::TextureViewDimension {
        match self.layers {
            Some(_) => wgpu::TextureViewDimension::D2Array,
            None => wgpu::TextureViewDimension::D2,
        }
    }

    fn sampler(&self, device: &wgpu::Device) -> wgpu::Sampler {
        let filter =
            if self.is_linear { wgpu::FilterMode::Linear } else { wgpu::FilterMode::Nearest };
        device.create_sampler(&wgpu::SamplerDescriptor {
            address_mode_u: self.wrap,
            address_mode_v: self.wrap,
            mag_filter: filter,
            min_filter: filter,
            ..wgpu::SamplerDescriptor::default()
        })
    }
}

/// A texture or a sampler that a shader binds.
pub(super) enum BoundTexture {
    View(wgpu::TextureView, wgpu::TextureViewDimension),
    Sampler(wgpu::Sampler),
}

impl BoundTexture {
    pub(super) fn layout(&self, binding: u32) -> wgpu::BindGroupLayoutEntry {
        let ty = match self {
            Self::View(_, view_dimension) => wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: true },
                view_dimension: *view_dimension,
                multisampled: false,
            },
            Self::Sampler(_) => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        };
        let visibility = wgpu::ShaderStages::VERTEX_FRAGMENT;
        wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None }
    }

    pub(super) fn resource(&self) -> wgpu::BindingResource<'_> {
        match self {
            Self::View(view, _) => wgpu::BindingResource::TextureView(view),
            Self::Sampler(sampler) => wgpu::BindingResource::Sampler(sampler),
        }
    }
}

/// The textures and samplers of a shader in WGSL, by their bindings. A sampler has its texture's
/// name after `sampler`, as Unity wants it, or before `Sampler`, as Unreal does.
pub(super) fn bound(
    wgsl: &str,
    textures: &Textures,
    device: &wgpu::Device,
    queue: &wgpu::Queue,
) -> Vec<(u32, BoundTexture)> {
    let mut found = Vec::new();
    for line in wgsl.lines() {
        // `@binding(2) @group(0) var _tone_air_0 : texture_2d<f32>;`
        let Some((binding, rest)) =
            line.strip_prefix("@binding(").and_then(|rest| rest.split_once(") @group(0) var "))
        else {
            continue;
        };
        let (name, ty) = rest.split_once(" : ").expect("a type");
        let name = name.rsplit_once('_').expect("a number").0;
        let of_sampler = |texture: &str| {
            name == format!("sampler{texture}") || name == format!("{texture}Sampler")
        };
        let bound = if ty.starts_with("sampler") {
            let texture = textures.iter().find(|(texture, _)| of_sampler(texture));
            let (_, texture) = texture.unwrap_or_else(|| panic!("a texture of {name}"));
            BoundTexture::Sampler(texture.sampler(device))
        } else {
            let texture = textures.get(name).unwrap_or_else(|| panic!("a texture {name}"));
            BoundTexture::View(texture.view(device, queue), texture.dimension())
        };
        found.push((binding.parse().expect("a number"), bound));
    }
    found
}
