//! Levels of detail (Vulkan 1.3, "Texel coordinate systems": scale factor, level of detail and
//! image level selection).

use super::Vec3;
use crate::interp::resources::{Filter, Sampler, Texture, TextureDimension};

/// Which levels are read, and how.
pub(super) struct Levels {
    pub(super) near: usize,
    /// How much of the next level is mixed in; 0 if there is none.
    pub(super) weight: f64,
    pub(super) filter: Filter,
}

impl Levels {
    /// The levels for a level of detail.
    pub(super) fn choose(texture: &Texture, sampler: &Sampler, detail: f64) -> Self {
        // Of a NaN and a number, max and min give the number.
        let detail = detail.max(sampler.lod_min).min(sampler.lod_max);
        let filter = if detail <= 0.0 { sampler.mag } else { sampler.min };
        let last = texture.levels().len() - 1;
        let detail = detail.clamp(0.0, last as f64);
        match sampler.mip {
            // Half-way goes to the larger level.
            Filter::Nearest => {
                let near = ((detail + 0.5).ceil() - 1.0).max(0.0) as usize;
                Self { near: near.min(last), weight: 0.0, filter }
            }
            Filter::Linear => {
                let near = detail.floor();
                Self { near: near as usize, weight: detail - near, filter }
            }
        }
    }
}

/// The logarithm of the longer axis of a footprint, in texels of the largest level.
pub(super) fn of_footprint(texture: &Texture, gradients: [Vec3; 2]) -> f64 {
    let [width, height, depth] = texture.levels()[0].size().map(f64::from);
    let depth = if texture.dimension() == TextureDimension::D3 { depth } else { 0.0 };
    let length = |[u, v, w]: Vec3| (u * width).hypot(v * height).hypot(w * depth);
    let [x, y] = gradients.map(length);
    x.max(y).log2()
}
