//! Options of the reference: rounding of positions and images, number of threads, size of tiles,
//! region and memory.

use half::f16;

use super::coverage::Pixels;

/// Grid that screen positions are rounded to before coverage is decided.
///
/// Coverage is decided in whole numbers of grid steps, so that it is exact: triangles that share an
/// edge cover each sample on it once, whatever the grid. Interpolated values, and depth, lie on the
/// plane through the unrounded corners, which the grid does not move: pixels that a triangle covers
/// only by rounding are beside its edge by up to a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SnapGrid {
    /// Steps of 2^-32 of a pixel, which is finer than any error that f32 leaves: the truth.
    #[default]
    None,
    /// Steps of 2^-n of a pixel, n from 4 (with fewer the samples of a pixel would lie between the
    /// steps) to 32; GPUs and software Vulkan use 8. Meant for comparisons with these.
    Subpixel(u32),
}

impl SnapGrid {
    /// Binary logarithm of the number of steps in a pixel.
    pub(super) fn bits(self) -> u32 {
        match self {
            Self::None => 32,
            Self::Subpixel(bits) => bits.clamp(4, 32),
        }
    }
}

/// Rounding of the images of passes, for later passes to read: slopes with depth and object
/// numbers, normals, curvature. The renderer's images hold f32 numbers; halves, which the renderer
/// used once, show what they would cost in accuracy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ImageRounding {
    /// No rounding: the truth.
    #[default]
    None,
    /// Surfaces in `rgba16float` and the rest in `r32float`, rounded to the nearest, as most GPUs
    /// do.
    Nearest,
    /// Rounding as by `Nearest`, but halves are rounded toward zero, as in software Vulkan.
    TowardZero,
}

impl ImageRounding {
    /// The value of `x` in an f16.
    pub(super) fn half(self, x: f64) -> f64 {
        let nearest = f16::from_f64(x);
        match self {
            Self::None => x,
            Self::TowardZero if nearest.to_f64().abs() > x.abs() => {
                f16::from_bits(nearest.to_bits() - 1).to_f64()
            }
            _ => nearest.to_f64(),
        }
    }

    /// The value of `x` in an f32.
    pub(super) fn single(self, x: f64) -> f64 {
        if self == Self::None { x } else { f64::from(x as f32) }
    }
}

/// Options of the caller. Only [`snap`](Self::snap) and [`images`](Self::images) change the
/// picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReferenceOptions {
    /// Grid of screen positions.
    pub snap: SnapGrid,
    /// Rounding of the passes' images.
    pub images: ImageRounding,
    /// Number of threads; at least 1.
    pub threads: usize,
    /// Side of the tiles that threads work on, in pixels: even, 2 to 512.
    pub tile: u32,
    /// Pixels that are wanted: left, top, right and bottom, the last two exclusive; all pixels if
    /// `None`. Passes before the look also draw the surroundings that they must know; the rest
    /// stays empty.
    pub region: Option<[u32; 4]>,
    /// Size of triangle lists, and of vertices, from which on these are drawn before more are
    /// gathered, in bytes.
    pub budget: usize,
}

impl Default for ReferenceOptions {
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        Self {
            snap: SnapGrid::default(),
            images: ImageRounding::default(),
            threads,
            tile: 64,
            region: None,
            budget: 256 << 20,
        }
    }
}

impl ReferenceOptions {
    /// The options with a region that is wider by `pixels` on all sides.
    pub(super) fn widened(&self, pixels: u32) -> Self {
        let wider = |[left, top, right, bottom]: [u32; 4]| {
            [
                left.saturating_sub(pixels),
                top.saturating_sub(pixels),
                right.saturating_add(pixels),
                bottom.saturating_add(pixels),
            ]
        };
        Self { region: self.region.map(wider), ..*self }
    }

    /// The part of `pixels` within the region, which is widened to whole quads; all of `pixels`
    /// where there is no region.
    pub(super) fn wanted(&self, pixels: Pixels) -> Option<Pixels> {
        let Some([left, top, right, bottom]) = self.region else { return Some(pixels) };
        // Quads are drawn whole, so the region is widened to them.
        let least = [left, top].map(|side| i64::from(side & !1));
        let most = [right, bottom].map(|side| i64::from(side.next_multiple_of(2)) - 1);
        pixels.and(least, most)
    }

    pub(super) fn tile(&self) -> u32 {
        self.tile.clamp(2, 512).next_multiple_of(2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_are_rounded_either_way() {
        // Between 1 and 2 an f16 has steps of 2^-10.
        let step = 1.0 / 1024.0;
        let x = 1.0 + 0.75 * step;
        for (rounding, wanted) in [
            (ImageRounding::None, x),
            (ImageRounding::Nearest, 1.0 + step),
            (ImageRounding::TowardZero, 1.0),
        ] {
            assert_eq!([rounding.half(x), rounding.half(-x)], [wanted, -wanted], "{rounding:?}");
            assert_eq!(rounding.half(0.0), 0.0);
        }
        assert_eq!(ImageRounding::TowardZero.half(1e6), 65504.0);
        assert_eq!(ImageRounding::TowardZero.half(1e-12), 0.0);
        assert_eq!(ImageRounding::Nearest.single(0.1), f64::from(0.1_f32));
    }
}
