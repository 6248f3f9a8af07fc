//! Difference of two frames.

use chiaro_locale::tr;
use eframe::egui::{Color32, ColorImage};

use crate::tools::playback::cache::PictureKey;

/// Difference of a frame from that of another version.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FrameDelta {
    /// Pictures that were compared: the present one, and that of the other version.
    pub(crate) of: [PictureKey; 2],
    pub(crate) kind: DeltaKind,
}

/// Result of a comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum DeltaKind {
    /// The greatest difference of a channel, in steps of 1/255, the pixel that has it (column and
    /// row), and the mean of all channels.
    Compared { greatest: u8, pixel: [u32; 2], mean: f64 },
    /// Pictures of two sizes, in pixels, which cannot be compared.
    OtherSize([[u32; 2]; 2]),
}

impl DeltaKind {
    /// Difference of two pictures.
    pub(super) fn of(ours: &ColorImage, other: &ColorImage) -> Self {
        if ours.size != other.size {
            let size = |image: &ColorImage| image.size.map(|side| side as u32);
            return Self::OtherSize([size(ours), size(other)]);
        }
        let (mut greatest, mut at, mut sum) = (0, 0, 0_u64);
        for (index, (a, b)) in ours.pixels.iter().zip(&other.pixels).enumerate() {
            if a == b {
                continue;
            }
            let apart = apart(*a, *b);
            sum += apart.iter().map(|apart| u64::from(*apart)).sum::<u64>();
            let most = apart.into_iter().max().unwrap_or(0);
            if most > greatest {
                (greatest, at) = (most, index);
            }
        }
        let width = ours.size[0].max(1);
        let mean = sum as f64 / (4 * ours.pixels.len().max(1)) as f64;
        Self::Compared { greatest, pixel: [(at % width) as u32, (at / width) as u32], mean }
    }

    /// The greatest difference, in steps of 1/255; that of pictures of two sizes is the greatest
    /// of all.
    pub(crate) fn greatest(self) -> u8 {
        match self {
            Self::Compared { greatest, .. } => greatest,
            Self::OtherSize(_) => u8::MAX,
        }
    }

    /// The difference in words.
    pub(crate) fn text(self) -> String {
        match self {
            Self::Compared { greatest: 0, .. } => tr!("no difference").to_owned(),
            Self::Compared { greatest, pixel: [x, y], .. } => {
                tr!("differs by {greatest}/255, most at pixel {x}, {y}")
            }
            Self::OtherSize([[width, height], [other_width, other_height]]) => {
                tr!("is {width}×{height}, and in the other version {other_width}×{other_height}")
            }
        }
    }
}

fn apart(a: Color32, b: Color32) -> [u8; 4] {
    let (a, b) = (a.to_array(), b.to_array());
    [0, 1, 2, 3].map(|channel: usize| a[channel].abs_diff(b[channel]))
}

/// Picture of a difference, brighter by `stops`; black where there is none. `None` for pictures of
/// two sizes.
pub(super) fn image(ours: &ColorImage, other: &ColorImage, stops: i32) -> Option<ColorImage> {
    let gain = f64::from(stops).exp2();
    let table: Vec<u8> =
        (0..256).map(|step| (f64::from(step) * gain).round().min(255.0) as u8).collect();
    let pixel = |(a, b): (&Color32, &Color32)| {
        let [red, green, blue, alpha] = apart(*a, *b).map(|apart| table[usize::from(apart)]);
        // What covers differs in all colors.
        Color32::from_rgb(red.max(alpha), green.max(alpha), blue.max(alpha))
    };
    let pixels = || ours.pixels.iter().zip(&other.pixels).map(pixel).collect();
    (ours.size == other.size).then(|| ColorImage::new(ours.size, pixels()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_greatest_difference_has_its_place() {
        let plain = ColorImage::filled([4, 3], Color32::from_rgb(10, 20, 30));
        let mut other = plain.clone();
        let same = DeltaKind::of(&plain, &other);
        assert_eq!((same.greatest(), same.text().as_str()), (0, "no difference"));
        other.pixels[1] = Color32::from_rgb(10, 25, 30);
        other.pixels[6] = Color32::from_rgb(10, 20, 93);
        let found = DeltaKind::of(&plain, &other);
        let mean = (5.0 + 63.0) / 48.0;
        assert_eq!(found, DeltaKind::Compared { greatest: 63, pixel: [2, 1], mean });
        assert_eq!(found.text(), "differs by 63/255, most at pixel 2, 1");
        let shown = image(&plain, &other, 2).unwrap();
        assert_eq!(shown.pixels[1], Color32::from_rgb(0, 20, 0));
        assert_eq!(
            (shown.pixels[6], shown.pixels[0]),
            (Color32::from_rgb(0, 0, 252), Color32::BLACK)
        );
        let wide = ColorImage::filled([6, 2], Color32::BLACK);
        assert!(DeltaKind::of(&plain, &wide).text().contains("6×2"));
        assert!(image(&plain, &wide, 0).is_none());
    }
}
