//! Image of a file as a picture: fitted into the frame, whole, with nothing around it.

use crate::frame::Picture;

/// Image of straight RGBA bytes, as large as it fits into a picture of `size` pixels with its
/// proportions; what is left is transparent.
pub(super) fn fitted(source: [u32; 2], rgba: &[u8], size: [u32; 2]) -> Picture {
    let [width, height] = source.map(|side| f64::from(side.max(1)));
    let scale = (f64::from(size[0]) / width).min(f64::from(size[1]) / height);
    let offset = [size[0], size[1]]
        .into_iter()
        .zip([width, height])
        .map(|(room, side)| 0.5 * (f64::from(room) - side * scale))
        .collect::<Vec<f64>>();
    // Many pixels of a large image are one of the picture: the mean of some of them.
    let steps = (1.0 / scale).ceil().clamp(1.0, 4.0) as u32;
    let pixel = |index: u32| {
        let [x, y] = [index % size[0].max(1), index / size[0].max(1)];
        let mut sum = [0.0_f32; 4];
        for part in 0..steps * steps {
            let within =
                |at: u32, part: u32| f64::from(at) + (f64::from(part) + 0.5) / f64::from(steps);
            let at = [
                (within(x, part % steps) - offset[0]) / scale,
                (within(y, part / steps) - offset[1]) / scale,
            ];
            let [r, g, b, a] = texel(source, rgba, at);
            for (sum, part) in sum.iter_mut().zip([r * a, g * a, b * a, a]) {
                *sum += part / (steps * steps) as f32;
            }
        }
        let [r, g, b, a] = sum;
        if a > 0.0 { [r / a, g / a, b / a, a] } else { [0.0; 4] }
    };
    Picture { size, rgba: (0..size[0] * size[1]).map(pixel).collect() }
}

/// Texel at a place in the image, straight RGBA; transparent outside.
fn texel([width, height]: [u32; 2], rgba: &[u8], [x, y]: [f64; 2]) -> [f32; 4] {
    if !(0.0..f64::from(width)).contains(&x) || !(0.0..f64::from(height)).contains(&y) {
        return [0.0; 4];
    }
    let at = 4 * (y as usize * width as usize + x as usize);
    let of = |channel: usize| rgba.get(at + channel).map_or(0.0, |byte| f32::from(*byte) / 255.0);
    [of(0), of(1), of(2), of(3)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_is_fitted_whole_with_nothing_around_it() {
        let rgba = [[255, 0, 0, 255], [0, 0, 255, 255]].concat();
        let picture = fitted([2, 1], &rgba, [4, 4]);
        assert_eq!(picture.pixel(0, 0), [0.0; 4]);
        assert_eq!(picture.pixel(0, 1), [1.0, 0.0, 0.0, 1.0]);
        assert_eq!((picture.pixel(3, 2), picture.pixel(3, 3)), ([0.0, 0.0, 1.0, 1.0], [0.0; 4]));
        // A large one is a mean, and a broken one is no panic.
        let large: Vec<u8> = [[0, 0, 0, 255], [255, 255, 255, 255]].concat().repeat(8);
        let small = fitted([16, 1], &large, [4, 1]);
        assert!((small.pixel(1, 0)[0] - 0.5).abs() < 0.2, "{:?}", small.pixel(1, 0));
        assert_eq!(fitted([3, 3], &rgba, [2, 2]).rgba.len(), 4);
        assert_eq!(fitted([0, 0], &[], [2, 2]).rgba, [[0.0; 4]; 4]);
    }
}
