//! Distance of a picture from the truth. Colors are compared where both pictures show the same
//! objects; pixels on edges are counted apart.

use serde::Serialize;

use crate::frame::Picture;

/// Smallest difference that eight bits a channel can show.
pub const VISIBLE: f64 = 1.0 / 255.0;

/// A picture in f64: premultiplied RGBA, rows from the top.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PremultipliedPicture<'a> {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Pixels, row by row.
    pub rgba: std::borrow::Cow<'a, [[f64; 4]]>,
}

impl From<&Picture> for PremultipliedPicture<'static> {
    fn from(picture: &Picture) -> Self {
        let premultiplied = |pixel: &[f32; 4]| {
            let [r, g, b, a] = pixel.map(f64::from);
            [r * a, g * a, b * a, a]
        };
        Self { size: picture.size, rgba: picture.rgba.iter().map(premultiplied).collect() }
    }
}

/// Figures of one comparison of a picture with the truth.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ErrorFigures {
    /// Number of pixels that were compared.
    pub pixels: u64,
    /// The largest difference in a channel.
    pub max: f64,
    /// The root of the mean square over all channels.
    pub rms: f64,
    /// Error that all but one pixel in a thousand stay below.
    pub p999: f64,
    /// The largest difference in perceived color: a distance in Oklab, where black and white are 1
    /// apart.
    pub color: f64,
    /// Number of pixels that differ by more than 1/255.
    pub visible: u64,
    /// Column and row of the pixel that differs most.
    pub worst: [u32; 2],
    /// Number of pixels that are NaN or infinite in the picture.
    pub broken: u64,
    /// Number of pixels on edges, where coverage differs by how triangles are rounded to the pixel
    /// grid.
    pub edges: u64,
    /// The largest difference of a pixel on an edge.
    pub edge_max: f64,
    /// Number of pixels on edges that differ by more than 1/255.
    pub edge_visible: u64,
}

impl ErrorFigures {
    /// The worst figures of several comparisons; means are taken over all pixels.
    pub fn join<'a>(figures: impl IntoIterator<Item = &'a Self>) -> Self {
        let mut joined = Self::default();
        let mut squares = 0.0;
        for one in figures {
            if one.max > joined.max || joined.pixels == 0 {
                joined.worst = one.worst;
            }
            squares += one.rms * one.rms * one.pixels as f64;
            joined.pixels += one.pixels;
            joined.max = joined.max.max(one.max);
            joined.p999 = joined.p999.max(one.p999);
            joined.color = joined.color.max(one.color);
            joined.visible += one.visible;
            joined.broken += one.broken;
            joined.edges += one.edges;
            joined.edge_max = joined.edge_max.max(one.edge_max);
            joined.edge_visible += one.edge_visible;
        }
        joined.rms = if joined.pixels > 0 { (squares / joined.pixels as f64).sqrt() } else { 0.0 };
        joined
    }
}

/// Compares `picture` with `truth` pixel by pixel. `is_edge` tells, by index, the pixels whose
/// coverage may differ; their figures are kept apart.
///
/// Pictures of different sizes cannot be compared: the figures then count no pixels.
pub fn compare(
    picture: &PremultipliedPicture<'_>,
    truth: &PremultipliedPicture<'_>,
    is_edge: impl Fn(usize) -> bool,
) -> ErrorFigures {
    let mut figures = ErrorFigures::default();
    if picture.size != truth.size {
        return figures;
    }
    let width = picture.size[0].max(1) as usize;
    let mut largest: Vec<f64> = Vec::with_capacity(picture.rgba.len());
    let mut squares = 0.0;
    for (index, (got, wanted)) in picture.rgba.iter().zip(truth.rgba.iter()).enumerate() {
        if got.iter().any(|x| !x.is_finite()) {
            figures.broken += 1;
            continue;
        }
        let difference = difference(got, wanted);
        if is_edge(index) {
            figures.edges += 1;
            figures.edge_max = figures.edge_max.max(difference);
            figures.edge_visible += u64::from(difference > VISIBLE);
            continue;
        }
        squares += got.iter().zip(wanted).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        if difference > figures.max || largest.is_empty() {
            figures.worst = [(index % width) as u32, (index / width) as u32];
            figures.max = difference;
        }
        figures.visible += u64::from(difference > VISIBLE);
        figures.color = figures.color.max(oklab_distance(got, wanted));
        largest.push(difference);
    }
    figures.pixels = largest.len() as u64;
    if figures.pixels > 0 {
        figures.rms = (squares / (4.0 * figures.pixels as f64)).sqrt();
        let rank = (largest.len() * 999 / 1000).min(largest.len() - 1);
        figures.p999 = *largest.select_nth_unstable_by(rank, f64::total_cmp).1;
    }
    figures
}

/// The largest difference of any channel.
pub(super) fn difference(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The distance of two premultiplied display-referred colors in Oklab (Ottosson 2020), over black.
fn oklab_distance(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    if a == b {
        return 0.0;
    }
    let (a, b) = (oklab(a), oklab(b));
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

fn oklab(rgba: &[f64; 4]) -> [f64; 3] {
    let linear = |x: f64| crate::document::srgb_to_linear(x.clamp(0.0, 1.0));
    let (r, g, b) = (linear(rgba[0]), linear(rgba[1]), linear(rgba[2]));
    let l = (0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b).cbrt();
    let m = (0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b).cbrt();
    let s = (0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b).cbrt();
    [
        0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
        1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
        0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn colors(rgba: &[[f64; 4]]) -> PremultipliedPicture<'_> {
        PremultipliedPicture { size: [rgba.len() as u32, 1], rgba: rgba.into() }
    }

    #[test]
    fn figures_of_a_known_difference() {
        let truth = vec![[0.5, 0.5, 0.5, 1.0]; 2000];
        let mut picture = truth.clone();
        picture[7][1] += 0.25;
        picture[9][0] -= 0.5;
        picture[11][2] = f64::NAN;
        picture[13] = [0.0; 4];
        let figures = compare(&colors(&picture), &colors(&truth), |index| index == 13);
        assert_eq!((figures.pixels, figures.broken, figures.edges), (1998, 1, 1));
        assert_eq!((figures.max, figures.worst, figures.visible), (0.5, [9, 0], 2));
        assert_eq!((figures.edge_max, figures.edge_visible), (1.0, 1));
        let wanted = ((0.25_f64.powi(2) + 0.5_f64.powi(2)) / (4.0 * 1998.0)).sqrt();
        assert!((figures.rms - wanted).abs() < 1e-15);
        assert_eq!(figures.p999, 0.25, "one pixel in a thousand is above");
        assert!(figures.color > 0.1);
    }

    #[test]
    fn black_and_white_are_one_apart() {
        let distance = oklab_distance(&[0.0, 0.0, 0.0, 1.0], &[1.0; 4]);
        assert!((distance - 1.0).abs() < 1e-6, "{distance}");
    }

    #[test]
    fn joined_figures_are_those_of_one_large_comparison() {
        let truth = vec![[0.2, 0.4, 0.6, 1.0]; 50];
        let a: Vec<_> = (0..50).map(|i| [0.2 + 0.001 * f64::from(i), 0.4, 0.6, 1.0]).collect();
        let b: Vec<_> = (0..50).map(|i| [0.2, 0.4 - 0.003 * f64::from(i), 0.6, 1.0]).collect();
        let parts = [
            compare(&colors(&a), &colors(&truth), |_| false),
            compare(&colors(&b), &colors(&truth), |_| false),
        ];
        let joined = ErrorFigures::join(&parts);
        let (both, truths) = ([a, b].concat(), [truth.clone(), truth].concat());
        let whole = compare(&colors(&both), &colors(&truths), |_| false);
        assert!((joined.rms - whole.rms).abs() < 1e-15);
        assert_eq!(
            (joined.max, joined.visible, joined.pixels),
            (whole.max, whole.visible, whole.pixels)
        );
    }
}
