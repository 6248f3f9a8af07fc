//! Colors near a color: other hues, darker and lighter, as they are tried on a sheet.

/// Saturation below which a color has no hue to turn.
const GRAY: f64 = 0.02;
/// Distance of the first neighbors, as [`around`] has it: hues a sixteenth of the circle apart.
const NEAR: f64 = 0.15;
/// Times that [`neighbors`] goes once more around, farther away.
const ROUNDS: u32 = 4;
/// Neighbors of a color in the order in which they are tried: hue and brightness, in steps.
const ORDER: [[f64; 2]; 10] = [
    [-1.0, 0.0],
    [1.0, 0.0],
    [0.0, -2.0],
    [0.0, 2.0],
    [-1.0, -2.0],
    [1.0, -2.0],
    [-1.0, 2.0],
    [1.0, 2.0],
    [0.0, -4.0],
    [0.0, 4.0],
];

/// Neighbors of a color, red, green and blue of 0 to 1, the most useful ones first: near hues,
/// darker and lighter, both, and then all of these farther away.
pub(crate) fn neighbors(color: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    let round = move |round| {
        let at = move |offset| around(color, offset, NEAR * f64::from(round));
        ORDER.into_iter().map(at)
    };
    (1..=ROUNDS).flat_map(round)
}

/// A color with another hue, and another brightness, each by a part of `spread`, 0 to 1. A gray
/// becomes cool to the left and warm to the right.
pub(crate) fn around(color: [f64; 3], [across, up]: [f64; 2], spread: f64) -> [f64; 3] {
    let (hue, mut saturation, mut value) = hsv(color);
    let turn = if saturation < GRAY && across != 0.0 {
        saturation = 0.5 * spread;
        if across < 0.0 { 0.6 } else { 0.08 }
    } else {
        hue + across * 0.4 * spread
    };
    value *= 1.0 + 0.8 * up * spread;
    if up > 0.0 {
        // A bright color can only become brighter by becoming paler, and a black by some light.
        let over = (value - 1.0).max(0.0);
        saturation *= (1.0 - over).max(0.3);
        value += 0.2 * up * spread;
    }
    rgb(turn, saturation, value.clamp(0.0, 1.0))
}

/// Hue, saturation and value of a color, each 0 to 1.
fn hsv([r, g, b]: [f64; 3]) -> (f64, f64, f64) {
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let range = most - least;
    if most <= 0.0 || range <= 0.0 {
        return (0.0, 0.0, most.max(0.0));
    }
    let sixth = if most == r {
        (g - b) / range
    } else if most == g {
        2.0 + (b - r) / range
    } else {
        4.0 + (r - g) / range
    };
    (sixth / 6.0, range / most, most)
}

/// Color of a hue, a saturation and a value, each 0 to 1; the hue goes round.
fn rgb(hue: f64, saturation: f64, value: f64) -> [f64; 3] {
    [5.0, 3.0, 1.0].map(|offset| {
        let at = (offset + 6.0 * hue).rem_euclid(6.0);
        value * (1.0 - saturation * at.min(4.0 - at).clamp(0.0, 1.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hues_come_back() {
        for color in [[0.8, 0.4, 0.2], [0.1, 0.9, 0.3], [0.2, 0.2, 0.7], [0.5, 0.5, 0.5]] {
            let (hue, saturation, value) = hsv(color);
            let back = rgb(hue, saturation, value);
            assert!(
                back.iter().zip(color).all(|(a, b)| (a - b).abs() < 1e-9),
                "{color:?} {back:?}"
            );
        }
    }

    #[test]
    fn neighbors_of_a_blue_moon_are_blue() {
        let moon = [0.45, 0.62, 1.0];
        let near: Vec<[f64; 3]> = neighbors(moon).take(8).collect();
        for [r, g, b] in &near {
            assert!(b > r && b > g, "{near:?}");
        }
        let [hue, darker] = [hsv(near[0]).0, hsv(near[2]).2];
        assert!((hsv(moon).0 - hue - 0.06).abs() < 1e-9 && darker < 0.8);
        assert!(near[3][0] > moon[0], "what is bright already becomes paler");
        let gray: Vec<[f64; 3]> = neighbors([0.5; 3]).take(2).collect();
        assert!(gray[0][2] > gray[0][0] && gray[1][0] > gray[1][2], "cool, and warm: {gray:?}");
    }
}
