//! The passes of the look: what each reads, and what it draws into.

use crate::host;
use crate::scene::Mesh;
use crate::uniforms;

/// A pass of a frame.
pub(crate) struct Pass {
    pub(crate) name: &'static str,
    pub(crate) shader: &'static str,
    pub(crate) draws: Draws,
    /// Attributes that the vertex shader reads, with their locations.
    pub(crate) attributes: &'static [(u32, Attribute)],
    /// Contents of the bindings of group 0, with their numbers.
    pub(crate) bindings: &'static [(u32, Feed)],
    /// Bytes of the look's own uniform; none for a pass without it.
    pub(crate) numbers: Option<fn(host::Settings, host::Surroundings) -> Vec<u8>>,
    /// Textures that the pass draws into; none for the picture.
    pub(crate) outputs: &'static [PassOutput],
}

/// Objects that a pass draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Draws {
    /// Every mesh.
    Meshes,
    /// One triangle over the whole target.
    Screen,
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
    /// Numbers of the view.
    Numbers,
    /// A texture that an earlier pass has drawn.
    Pass { pass: usize, output: usize },
}

impl Feed {
    pub(crate) fn binding_type(self) -> wgpu::BindingType {
        let uniform = wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        };
        match self {
            Self::Pass { .. } => wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            Self::View | Self::Object | Self::Look | Self::Numbers => uniform,
        }
    }
}

/// Texture that a pass draws into.
pub(crate) struct PassOutput {
    pub(crate) format: wgpu::TextureFormat,
    pub(crate) clear: wgpu::Color,
}

/// Passes of a frame, in order; the last one draws the picture.
#[rustfmt::skip]
pub(crate) const PASSES: [Pass; 3] = [
    Pass {
        name: "normals",
        shader: include_str!("shaders/normals.wgsl"),
        draws: Draws::Meshes,
        attributes: &[(0, Attribute::Position), (1, Attribute::Normal)],
        bindings: &[(0, Feed::View), (1, Feed::Object), (2, Feed::Look)],
        numbers: Some(|settings, around| {
            uniforms::look(
                host::normals_numbers(settings, around),
                &[35, 71, 95, 119, 124, 126, 128, 130],
            )
        }),
        outputs: &[
            PassOutput {
                format: wgpu::TextureFormat::Rgba32Float,
                clear: wgpu::Color::TRANSPARENT,
            },
        ],
    },
    Pass {
        name: "curvature",
        shader: include_str!("shaders/curvature.wgsl"),
        draws: Draws::Screen,
        attributes: &[],
        bindings: &[(0, Feed::Pass { pass: 0, output: 0 }), (1, Feed::Numbers)],
        numbers: None,
        outputs: &[
            PassOutput {
                format: wgpu::TextureFormat::R32Float,
                clear: wgpu::Color::TRANSPARENT,
            },
        ],
    },
    Pass {
        name: "draw",
        shader: include_str!("shaders/draw.wgsl"),
        draws: Draws::Meshes,
        attributes: &[(0, Attribute::Position), (1, Attribute::Normal)],
        bindings: &[
            (0, Feed::View),
            (1, Feed::Object),
            (2, Feed::Look),
            (3, Feed::Pass { pass: 1, output: 0 }),
        ],
        numbers: Some(|settings, around| {
            uniforms::look(
                host::draw_numbers(settings, around),
                &[35, 71, 95, 119, 124, 126, 128, 130],
            )
        }),
        outputs: &[],
    },
];
