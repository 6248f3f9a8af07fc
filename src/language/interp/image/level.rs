//! Levels of detail (Vulkan 1.3, "Texel coordinate systems": scale factor, level of detail and
//! image level selection).

use super::Vec3;
use crate::interp::resources::{Filter, Sampler, Texture, TextureDimension};

/// Levels that are read, and their filter.
pub(super) struct Levels {
    pub(super) near: usize,
    /// Weight of the next level; 0 if there is none.
    pub(super) weight: f64,
    pub(super) filter: Filter,
}

impl Levels {
    /// Levels for a level of detail.
    pub(super) fn choose(texture: &Texture, sampler: &Sampler, detail: f64) -> Self {
        // `max` and `min` of a NaN and a number give the number.
        let detail = detail.max(sampler.lod_min).min(sampler.lod_max);
        let filter = if detail <= 0.0 { sampler.mag } else { sampler.min };
        let last = texture.levels().len() - 1;
        let detail = detail.clamp(0.0, last as f64);
        match sampler.mip {
            // Half-way values go to the larger level.
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

/// Level of detail of a footprint: the logarithm to base 2 of its longer axis, in texels of the
/// largest level.
pub(super) fn of_footprint(texture: &Texture, gradients: [Vec3; 2]) -> f64 {
    let [width, height, depth] = texture.levels()[0].size().map(f64::from);
    let depth = if texture.dimension() == TextureDimension::D3 { depth } else { 0.0 };
    let length = |[u, v, w]: Vec3| (u * width).hypot(v * height).hypot(w * depth);
    let [x, y] = gradients.map(length);
    x.max(y).log2()
}
