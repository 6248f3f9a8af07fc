//! How pictures are made: to which grid positions are rounded, on how many threads, and
//! in which pieces.

use half::f16;

use super::coverage::Pixels;

/// The grid that screen positions are rounded to before coverage is decided.
///
/// Coverage is decided in whole numbers of grid steps, so that it is exact: triangles that share an
/// edge cover each sample on it once, whatever the grid. What is interpolated, depth too, lies on
/// the plane through the corners as they are, which the grid does not move: pixels that a triangle
/// covers by being rounded are beside its edge by up to a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Snap {
    /// 2^-32 of a pixel, which is finer than any error that f32 leaves: the truth.
    #[default]
    None,
    /// 2^-n of a pixel, n from 4 (below it the samples of a pixel would lie between the steps) to
    /// 32; GPUs and software Vulkan use 8. For comparing with them.
    Subpixel(u32),
}

impl Snap {
    /// The steps of the grid in a pixel are 2 to this.
    pub(super) fn bits(self) -> u32 {
        match self {
            Self::None => 32,
            Self::Subpixel(bits) => bits.clamp(4, 32),
        }
    }
}

/// What the images of passes hold, for later passes to read: normals and object numbers, depth,
/// curvature. The renderer's hold f32 numbers; halves, which it held once, show what they would
/// cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ImageRounding {
    /// All of every number: the truth.
    #[default]
    None,
    /// Normals in `rgba16float` and the rest in `r32float`, rounded to the nearest as most GPUs do.
    Nearest,
    /// The same, but halves rounded toward zero, as software Vulkan does.
    TowardZero,
}

impl ImageRounding {
    /// What an f16 holds of `x`.
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

    /// What an f32 holds of `x`.
    pub(super) fn single(self, x: f64) -> f64 {
        if self == Self::None { x } else { f64::from(x as f32) }
    }
}

/// Choices that the caller has. Only [`snap`](Self::snap) and [`images`](Self::images) change the
/// picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// The grid of screen positions.
    pub snap: Snap,
    /// The precision of what passes hand on.
    pub images: ImageRounding,
    /// How many threads work; at least 1.
    pub threads: usize,
    /// The side of the squares that threads take, in pixels: even, 2 to 512.
    pub tile: u32,
    /// The pixels that are wanted, left, top, right and bottom, the last two outside; all of them
    /// without it. What the passes before the look must know around them is made too; the rest
    /// stays empty.
    pub region: Option<[u32; 4]>,
    /// Bytes of triangle lists, and of vertices, after which what is there is drawn before more is
    /// gathered.
    pub budget: usize,
}

impl Default for Options {
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        Self {
            snap: Snap::default(),
            images: ImageRounding::default(),
            threads,
            tile: 64,
            region: None,
            budget: 256 << 20,
        }
    }
}

impl Options {
    /// The same with a region that is wider by so many pixels on all sides.
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

    /// Of some pixels those that are wanted.
    pub(super) fn wanted(&self, pixels: Pixels) -> Option<Pixels> {
        let Some([left, top, right, bottom]) = self.region else { return Some(pixels) };
        // Quads are whole.
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
