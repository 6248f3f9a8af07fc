//! Samplers: the mapping from coordinates to texels.

/// Address mode: the content beyond the edge of a texture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AddressMode {
    /// Continuation of the edge.
    #[default]
    ClampToEdge,
    /// Repetition of the texture.
    Repeat,
    /// Repetition of the texture, mirrored every other time.
    MirrorRepeat,
}

impl AddressMode {
    /// Texel that stands at `index` in a row of `size`, which is at least 1.
    pub(in crate::interp) fn wrap(self, index: i64, size: u32) -> u32 {
        let size = i64::from(size);
        let wrapped = match self {
            Self::ClampToEdge => index.clamp(0, size - 1),
            Self::Repeat => index.rem_euclid(size),
            Self::MirrorRepeat => {
                let place = index.rem_euclid(2 * size);
                place.min(2 * size - 1 - place)
            }
        };
        wrapped as u32
    }
}

/// Filter that joins texels or mip levels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// Nearest texel alone.
    #[default]
    Nearest,
    /// Neighbors, weighted by their distance.
    Linear,
}

/// Comparison of the reference with a texel that passes; see [`Sampler::compare`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SamplerCompare {
    /// No texel passes.
    Never,
    /// `reference < texel`
    Less,
    /// `reference == texel`
    Equal,
    /// `reference <= texel`
    LessEqual,
    /// `reference > texel`
    Greater,
    /// `reference != texel`
    NotEqual,
    /// `reference >= texel`
    GreaterEqual,
    /// All texels pass.
    Always,
}

impl SamplerCompare {
    /// Result of the test: 1 if the texel passes, else 0.
    pub(in crate::interp) fn test(self, reference: f64, texel: f64) -> f64 {
        let passes = match self {
            Self::Never => false,
            Self::Less => reference < texel,
            Self::Equal => reference == texel,
            Self::LessEqual => reference <= texel,
            Self::Greater => reference > texel,
            Self::NotEqual => reference != texel,
            Self::GreaterEqual => reference >= texel,
            Self::Always => true,
        };
        f64::from(u8::from(passes))
    }
}

/// Sampler of a texture. There is no anisotropy: the footprint is as wide as its longer axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampler {
    /// Address modes along u, v and w.
    pub address: [AddressMode; 3],
    /// Filter where texels are larger than the footprint.
    pub mag: Filter,
    /// Filter where texels are smaller than the footprint.
    pub min: Filter,
    /// Filter between mip levels.
    pub mip: Filter,
    /// Least level of detail.
    pub lod_min: f64,
    /// Greatest level of detail.
    pub lod_max: f64,
    /// Comparison of a comparison sampler; `None` for any other sampler.
    pub compare: Option<SamplerCompare>,
}

impl Default for Sampler {
    /// Sampler with clamped coordinates, nearest filters and all levels, as WebGPU's default.
    fn default() -> Self {
        Self {
            address: [AddressMode::ClampToEdge; 3],
            mag: Filter::Nearest,
            min: Filter::Nearest,
            mip: Filter::Nearest,
            lod_min: 0.0,
            lod_max: 32.0,
            compare: None,
        }
    }
}

impl Sampler {
    /// Sampler with one address mode for all axes, and one filter for all uses.
    pub fn new(address: AddressMode, filter: Filter) -> Self {
        Self { address: [address; 3], mag: filter, min: filter, mip: filter, ..Self::default() }
    }
}
