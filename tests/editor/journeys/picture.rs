//! Pictures that are compared.

use std::path::Path;

use image::RgbaImage;

/// A picture of 8-bit RGBA pixels.
#[derive(PartialEq)]
pub(super) struct Picture(RgbaImage);

/// Difference of two pictures, in steps of 1/255.
#[derive(Debug, PartialEq)]
pub(super) struct PictureDifference {
    pub(super) mean: f64,
    pub(super) max: u8,
    /// Number of pixels that differ by more than 2 in a channel.
    pub(super) far: usize,
}

impl Picture {
    pub(super) fn read(path: &Path) -> Self {
        Self(
            image::open(path)
                .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
                .into_rgba8(),
        )
    }

    pub(super) fn at(&self, x: f32, y: f32) -> [u8; 4] {
        let (width, height) = self.0.dimensions();
        self.0.get_pixel((x * width as f32) as u32, (y * height as f32) as u32).0
    }

    /// Pixels of the object: all that differ from the color of the corner.
    pub(super) fn object(&self) -> impl Iterator<Item = [u8; 4]> + '_ {
        let backdrop = self.0.get_pixel(0, 0).0;
        self.0.pixels().map(|pixel| pixel.0).filter(move |pixel| *pixel != backdrop)
    }

    /// Share of the object's pixels that have this color, within 2/255. From 0 to 1.
    pub(super) fn share_of(&self, color: [u8; 3]) -> f64 {
        let is_it = |pixel: &[u8; 4]| color.iter().zip(pixel).all(|(a, b)| a.abs_diff(*b) <= 2);
        self.object().filter(is_it).count() as f64 / self.object().count().max(1) as f64
    }

    /// Mean of the object's color channels.
    pub(super) fn brightness(&self) -> f64 {
        let sum: f64 =
            self.object().flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).map(f64::from).sum();
        sum / (3.0 * self.object().count().max(1) as f64)
    }

    pub(super) fn difference_from(&self, other: &Self) -> PictureDifference {
        assert_eq!(self.0.dimensions(), other.0.dimensions());
        let differences = self.0.pixels().zip(other.0.pixels());
        let of_pixel =
            differences.map(|(a, b)| (0..4).map(|k| a.0[k].abs_diff(b.0[k])).max().unwrap_or(0));
        let all: Vec<u8> = of_pixel.collect();
        PictureDifference {
            mean: all.iter().map(|&d| f64::from(d)).sum::<f64>() / all.len() as f64,
            max: all.iter().copied().max().unwrap_or(0),
            far: all.iter().filter(|&&d| d > 2).count(),
        }
    }

    #[track_caller]
    pub(super) fn equals(&self, other: &Self) {
        let difference = self.difference_from(other);
        assert_eq!(difference.max, 0, "{difference:?}");
    }

    /// Asserts that no channel differs by more than a step: what is painted is drawn without
    /// blending once a file says that it is opaque, and rounds elsewhere.
    #[track_caller]
    pub(super) fn is_near(&self, other: &Self) {
        let difference = self.difference_from(other);
        assert!(difference.max <= 1, "{difference:?}");
    }

    #[track_caller]
    pub(super) fn differs(&self, other: &Self) {
        let difference = self.difference_from(other);
        assert!(difference.far > 20, "the pictures are the same: {difference:?}");
    }
}
