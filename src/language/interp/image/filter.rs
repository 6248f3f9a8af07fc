//! Filters: texels around a place, and their weighted sum. Texel `i` of `n` has its center at `(i +
//! 1/2) / n`.

use super::{Vec3, cube};
use crate::interp::resources::{
    AddressMode, Filter, Sampler, Texture, TextureDimension, TextureLevel,
};

/// Read of a texture.
pub(super) struct Taps<'t> {
    pub(super) texture: &'t Texture,
    pub(super) sampler: &'t Sampler,
    /// Normalized coordinates; for a cube those on the face.
    pub(super) place: Vec3,
    /// Layer; for a cube, the number of the face with that of the cube.
    pub(super) layer: u32,
    /// Offset, in texels.
    pub(super) offset: [i64; 3],
    /// Reference that every texel is compared with.
    pub(super) reference: Option<f64>,
    pub(super) clamp_to_edge: bool,
    pub(super) is_depth: bool,
}

/// Pair of neighboring texels along one axis.
#[derive(Clone, Copy)]
struct Pair {
    first: i64,
    /// Weight of the second texel.
    weight: f64,
}

impl Taps<'_> {
    /// Filtered texel of a level.
    pub(super) fn filter(&self, level: usize, filter: Filter) -> [f64; 4] {
        let level = &self.texture.levels()[level.min(self.texture.levels().len() - 1)];
        match filter {
            Filter::Nearest => {
                let texel = self.nearest(level);
                self.read(level, texel)
            }
            Filter::Linear => self.linear(level),
        }
    }

    /// Component of the four texels that a linear filter of the largest level joins: those at (0,
    /// 1), (1, 1), (1, 0) and (0, 0).
    pub(super) fn gather(&self, component: usize) -> [f64; 4] {
        let level = &self.texture.levels()[0];
        let [u, v, _] = self.pairs(level);
        [(0, 1), (1, 1), (1, 0), (0, 0)]
            .map(|(x, y)| self.read(level, [u.first + x, v.first + y, 0])[component])
    }

    fn nearest(&self, level: &TextureLevel) -> [i64; 3] {
        self.scaled(level).map(|x| x.floor() as i64)
    }

    fn pairs(&self, level: &TextureLevel) -> [Pair; 3] {
        self.scaled(level).map(|x| {
            let floor = (x - 0.5).floor();
            // A NaN coordinate gives some texel; and the second texel's number must not overflow.
            let weight = x - 0.5 - floor;
            let weight = if weight.is_finite() { weight } else { 0.0 };
            Pair { first: (floor as i64).clamp(i64::MIN / 4, i64::MAX / 4), weight }
        })
    }

    fn linear(&self, level: &TextureLevel) -> [f64; 4] {
        let pairs = self.pairs(level);
        let axes = if self.texture.dimension() == TextureDimension::Cube { 2 } else { self.axes() };
        let mut sum = [0.0; 4];
        for corner in 0..1_usize << axes {
            let mut texel = [0; 3];
            let mut weight = 1.0;
            for axis in 0..axes {
                let Pair { first, weight: second } = pairs[axis];
                let is_second = corner >> axis & 1 == 1;
                texel[axis] = first + i64::from(is_second);
                weight *= if is_second { second } else { 1.0 - second };
            }
            // An infinite texel must not count where it has no weight.
            if weight != 0.0 {
                let texel = self.read(level, texel);
                sum.iter_mut().zip(texel).for_each(|(sum, x)| *sum += weight * x);
            }
        }
        sum
    }

    fn axes(&self) -> usize {
        self.texture.dimension().coordinates()
    }

    /// Coordinates in texels of a level.
    fn scaled(&self, level: &TextureLevel) -> Vec3 {
        let size = level.size().map(f64::from);
        std::array::from_fn(|axis| {
            let x = self.place[axis] * size[axis];
            if self.clamp_to_edge { x.clamp(0.5, (size[axis] - 0.5).max(0.5)) } else { x }
        })
    }

    /// Texel at a place that may lie beyond the edge, compared if there is a reference.
    fn read(&self, level: &TextureLevel, place: [i64; 3]) -> [f64; 4] {
        let texel = if self.texture.dimension() == TextureDimension::Cube {
            cube::texel(level, place, self.layer)
        } else {
            level.texel(self.inside(level, place))
        };
        match (self.reference, self.sampler.compare) {
            (Some(reference), Some(compare)) => [compare.test(reference, texel[0]); 4],
            _ if self.is_depth => [texel[0]; 4],
            _ => texel,
        }
    }

    fn inside(&self, level: &TextureLevel, place: [i64; 3]) -> [u32; 3] {
        let size = level.size();
        let wrapped = |axis: usize| {
            let address = if self.clamp_to_edge {
                AddressMode::ClampToEdge
            } else {
                self.sampler.address[axis]
            };
            address.wrap(place[axis].saturating_add(self.offset[axis]), size[axis])
        };
        let depth =
            if self.texture.dimension() == TextureDimension::D3 { wrapped(2) } else { self.layer };
        // A texture of one axis has a height of 1, where everything wraps to 0.
        [wrapped(0), wrapped(1), depth]
    }
}
