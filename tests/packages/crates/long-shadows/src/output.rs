//! Targets of pictures.

/// Numbers that are written into a color target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Colors as they are shown, encoded as sRGB: so the look is made, and what is transparent
    /// blends as it does in Chiaro.
    Shown,
    /// Linear light: for formats that encode as sRGB what is written, and for targets of floats
    /// that are tone mapped or shown in high dynamic range.
    Linear,
}

/// Kind of target that the material draws its picture into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Output {
    /// Format of the color target.
    pub color: wgpu::TextureFormat,
    /// Numbers that are written there.
    pub encoding: Encoding,
    /// Format of the depth buffer.
    pub depth: wgpu::TextureFormat,
    /// True where depth is 1 at the near plane and 0 at the far one, as that of cameras is then to
    /// be; see [`Camera::reversed`](crate::Camera::reversed).
    pub is_depth_reversed: bool,
    /// Samples of a pixel: 1, or 4 for smooth edges.
    pub samples: u32,
}

impl Output {
    /// A target of a color format, with the encoding that goes with it: linear light for formats
    /// that encode as sRGB and for floats, else colors as shown. The depth buffer has 32 bits, 1 is
    /// far, and a pixel has one sample.
    #[must_use]
    pub fn new(color: wgpu::TextureFormat) -> Self {
        let is_float = matches!(
            color,
            wgpu::TextureFormat::Rgba16Float
                | wgpu::TextureFormat::Rgba32Float
                | wgpu::TextureFormat::Rg11b10Ufloat
        );
        let is_linear = is_float || color.is_srgb();
        let encoding = if is_linear { Encoding::Linear } else { Encoding::Shown };
        Self {
            color,
            encoding,
            depth: wgpu::TextureFormat::Depth32Float,
            is_depth_reversed: false,
            samples: 1,
        }
    }

    /// A depth buffer for pictures of that width and height in pixels.
    #[must_use]
    pub fn depth_buffer(&self, device: &wgpu::Device, [width, height]: [u32; 2]) -> wgpu::Texture {
        device.create_texture(&wgpu::TextureDescriptor {
            label: Some("depth"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: self.samples,
            dimension: wgpu::TextureDimension::D2,
            format: self.depth,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        })
    }

    /// Depth of the far plane.
    pub(crate) fn far(&self) -> f32 {
        if self.is_depth_reversed { 0.0 } else { 1.0 }
    }
}

/// Target of a picture, in the formats of an [`Output`].
#[derive(Clone, Copy, Debug)]
pub struct Target<'a> {
    /// Color target. The picture is premultiplied by its alpha.
    pub color: &'a wgpu::TextureView,
    /// Texture that takes the color where the target has several samples.
    pub resolve: Option<&'a wgpu::TextureView>,
    /// Depth buffer.
    pub depth: &'a wgpu::TextureView,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Color behind the objects.
    pub clear: wgpu::Color,
}
