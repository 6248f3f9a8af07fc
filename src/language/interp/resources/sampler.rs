//! Samplers: how coordinates meet texels.

/// What lies beyond the edge of a texture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Address {
    /// The edge goes on.
    #[default]
    ClampToEdge,
    /// The texture begins again.
    Repeat,
    /// The texture is mirrored, again and again.
    MirrorRepeat,
}

impl Address {
    /// The texel that stands at `index` in a row of `size`, which is at least 1.
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

/// How texels or mip levels are joined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The nearest alone.
    #[default]
    Nearest,
    /// The neighbours, weighted by their distance.
    Linear,
}

/// How the reference stands to a texel that passes; see [`Sampler::compare`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SamplerCompare {
    /// None passes.
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
    /// All pass.
    Always,
}

impl SamplerCompare {
    /// 1 if the texel passes, else 0.
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

/// How a texture is sampled. There is no anisotropy: the footprint is as wide as its longer axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampler {
    /// Along u, v and w.
    pub address: [Address; 3],
    /// Where texels are larger than the footprint.
    pub mag: Filter,
    /// Where they are smaller.
    pub min: Filter,
    /// Between mip levels.
    pub mip: Filter,
    /// The least level of detail.
    pub lod_min: f64,
    /// The greatest level of detail.
    pub lod_max: f64,
    /// Makes it a comparison sampler.
    pub compare: Option<SamplerCompare>,
}

impl Default for Sampler {
    /// Clamped and nearest, with all levels, as WebGPU's.
    fn default() -> Self {
        Self {
            address: [Address::ClampToEdge; 3],
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
    /// One mode of address for all axes, and one filter for all uses.
    pub fn new(address: Address, filter: Filter) -> Self {
        Self { address: [address; 3], mag: filter, min: filter, mip: filter, ..Self::default() }
    }
}
