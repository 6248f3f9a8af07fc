//! Target of a fit: colors that some pixels of a picture should show.

use std::io::Cursor;

use chiaro_locale::tr;
use image::{DynamicImage, ImageDecoder as _, Limits};

use crate::diag::Diagnostic;

/// Largest side of a painted picture, in pixels.
pub const MAX_SIDE: u32 = 8192;

/// Color that one pixel should show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelGoal {
    /// Column and row of the pixel.
    pub pixel: [u32; 2],
    /// Straight RGB as shown (sRGB-encoded), 0 to 1.
    pub color: [f64; 3],
    /// Weight of the pixel, above 0.
    pub weight: f64,
    /// True for an unpainted pixel, which is to keep the color that the look shows.
    pub is_rest: bool,
}

/// A painted picture: goals for some of its pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FitTarget {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Goals of pixels, each pixel at most once.
    pub goals: Vec<PixelGoal>,
}

impl FitTarget {
    /// The target of a picture in straight RGBA, rows from the top: alpha is the weight of a pixel,
    /// and a pixel with alpha 0 has no goal.
    pub fn from_rgba8(size: [u32; 2], rgba: &[u8]) -> Self {
        let channel = |byte: u8| f64::from(byte) / 255.0;
        let goals = rgba.chunks_exact(4).zip(0_u32..).filter(|(texel, _)| texel[3] > 0).map(
            |(texel, index)| PixelGoal {
                pixel: [index % size[0].max(1), index / size[0].max(1)],
                color: [channel(texel[0]), channel(texel[1]), channel(texel[2])],
                weight: channel(texel[3]),
                is_rest: false,
            },
        );
        Self { size, goals: goals.collect() }
    }

    /// Reads a target from a PNG: see [`from_rgba8`](Self::from_rgba8).
    ///
    /// # Errors
    /// `fit-target`: the bytes are no PNG, are broken, or hold a picture that is larger than
    /// [`MAX_SIDE`] or has no painted pixel.
    pub fn from_png(bytes: &[u8]) -> Result<Self, Diagnostic> {
        let problem = |message: String| Diagnostic::error("fit-target", message);
        let broken = |error: image::ImageError| {
            problem(tr!("the painted picture cannot be decoded: {error}"))
        };
        let mut limits = Limits::default();
        (limits.max_image_width, limits.max_image_height) = (Some(MAX_SIDE), Some(MAX_SIDE));
        let decoder = image::codecs::png::PngDecoder::with_limits(Cursor::new(bytes), limits)
            .map_err(broken)?;
        let (width, height) = decoder.dimensions();
        if width.max(height) > MAX_SIDE {
            let message = tr!(
                "the painted picture is {width}x{height} pixels, and a side may have {MAX_SIDE}"
            );
            return Err(problem(message));
        }
        let rgba = DynamicImage::from_decoder(decoder).map_err(broken)?.into_rgba8();
        let target = Self::from_rgba8([width, height], rgba.as_raw());
        if target.goals.is_empty() {
            let problem = problem(
                tr!("all of the painted picture is transparent, so nothing is wished").to_owned(),
            );
            return Err(problem.hint(tr!(
                "paint on a transparent layer over the rendered picture, and save that layer"
            )));
        }
        Ok(target)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::Picture;

    #[test]
    fn transparent_pixels_wish_nothing_and_alpha_is_the_weight() {
        let rgba = vec![[1.0, 0.0, 0.0, 1.0], [0.0; 4], [0.0, 1.0, 0.0, 0.2], [0.0, 0.0, 1.0, 0.0]];
        let png = Picture { size: [2, 2], rgba }.to_png().unwrap();
        let target = FitTarget::from_png(&png).unwrap();
        assert_eq!(target.size, [2, 2]);
        let goal = |pixel, color, weight| PixelGoal { pixel, color, weight, is_rest: false };
        assert_eq!(
            target.goals,
            [goal([0, 0], [1.0, 0.0, 0.0], 1.0), goal([0, 1], [0.0, 1.0, 0.0], 0.2)]
        );
    }

    #[test]
    fn what_wishes_nothing_or_is_no_picture_is_told() {
        let clear = Picture { size: [1, 1], rgba: vec![[0.0; 4]] }.to_png().unwrap();
        for bytes in [&clear[..], b"no picture", &clear[..20]] {
            assert_eq!(FitTarget::from_png(bytes).unwrap_err().code, "fit-target");
        }
    }
}
