//! The passes of the look: what each reads, and what it draws into.

use crate::host;
use crate::scene::Mesh;
use crate::uniforms;

/// A pass of a frame.
pub(crate) struct Pass {
    pub(crate) name: &'static str,
    pub(crate) shader: &'static str,
    /// Attributes that the vertex shader reads, with their locations.
    pub(crate) attributes: &'static [(u32, Attribute)],
    /// Contents of the bindings of group 0, with their numbers.
    pub(crate) bindings: &'static [(u32, Feed)],
    /// Bytes of the look's own uniform; none for a pass without it.
    pub(crate) numbers: Option<fn(host::Settings, host::Surroundings) -> Vec<u8>>,
}

/// Numbers of a vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Attribute {
    Position,
    Normal,
}

impl Attribute {
    pub(crate) fn buffer(self, mesh: &Mesh) -> &wgpu::Buffer {
        match self {
            Self::Position => &mesh.position,
            Self::Normal => &mesh.normal,
        }
    }

    pub(crate) fn at(self, shader_location: u32) -> wgpu::VertexAttribute {
        let format = match self {
            Self::Position => wgpu::VertexFormat::Float32x3,
            Self::Normal => wgpu::VertexFormat::Float32x3,
        };
        wgpu::VertexAttribute { format, offset: 0, shader_location }
    }
}

/// Content of a binding.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Feed {
    /// The camera's uniform.
    View,
    /// The uniform of an object's place.
    Object,
    /// The look's own uniform.
    Look,
    /// An image, by its place in [`IMAGES`].
    Image(usize),
    /// The sampler of an image.
    Sampler(usize),
}

impl Feed {
    pub(crate) fn binding_type(self) -> wgpu::BindingType {
        let uniform = wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        };
        match self {
            Self::Image(_) => wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: true },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            Self::Sampler(_) => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
            Self::View | Self::Object | Self::Look => uniform,
        }
    }
}

/// An image of the look, and how it is sampled.
pub(crate) struct Image {
    pub(crate) file: &'static str,
    pub(crate) bytes: &'static [u8],
    pub(crate) format: wgpu::TextureFormat,
    pub(crate) wrap: wgpu::AddressMode,
    pub(crate) filter: wgpu::FilterMode,
}

/// Images of the look.
#[rustfmt::skip]
pub(crate) const IMAGES: [Image; 1] = [
    Image {
        file: "xtoon-orientation.tone-ink.png",
        bytes: include_bytes!("images/xtoon-orientation.tone-ink.png"),
        format: wgpu::TextureFormat::Rgba8Unorm,
        wrap: wgpu::AddressMode::ClampToEdge,
        filter: wgpu::FilterMode::Linear,
    },
];

/// Passes of a frame, in order; the last one draws the picture.
#[rustfmt::skip]
pub(crate) const PASSES: [Pass; 1] = [
    Pass {
        name: "draw",
        shader: include_str!("shaders/draw.wgsl"),
        attributes: &[(0, Attribute::Position), (1, Attribute::Normal)],
        bindings: &[
            (0, Feed::View),
            (1, Feed::Object),
            (2, Feed::Look),
            (3, Feed::Image(0)),
            (4, Feed::Sampler(0)),
        ],
        numbers: Some(|settings, around| {
            uniforms::look(host::draw_numbers(settings, around), &[])
        }),
    },
];
