//! Turning a tile's content about its middle.
//!
//! Content that points along v (up) at no turn points along u (right) after a quarter, as phi goes.
//! Each texel is looked up in the unturned source by Catmull-Rom's cubic, which is sharper than a
//! linear filter and gives the texels themselves at their positions, so that quarter turns of a
//! square tile lose nothing. The result is clamped to the range of the four nearest texels, so
//! strokes get no halo, and computed on premultiplied colors, so transparent texels do not bleed
//! in.

use std::f64::consts::TAU;

/// A straight RGBA color from 0 to 255.
pub(super) type Color = [f32; 4];

/// Look-up in a tile that is turned.
pub(super) struct TurnedTile<F> {
    pub(super) size: [u32; 2],
    /// True if the tile repeats beyond its edges; false if it is transparent there.
    pub(super) is_tiling: bool,
    cos_sin: [f64; 2],
    texel: F,
}

impl<F: Fn(usize, usize) -> Color> TurnedTile<F> {
    /// A tile of the given size, whose texels `texel` gives by x and y, turned by `turns` in [0,
    /// 1).
    pub(super) fn new(size: [u32; 2], is_tiling: bool, turns: f64, texel: F) -> Self {
        let quarters = 4.0 * turns;
        // Quarter turns are exact: a cosine of 6e-17 would move texels by a rounding error.
        let cos_sin = match quarters as u32 {
            _ if quarters.fract() != 0.0 => [(TAU * turns).cos(), (TAU * turns).sin()],
            0 => [1.0, 0.0],
            1 => [0.0, 1.0],
            2 => [-1.0, 0.0],
            _ => [0.0, -1.0],
        };
        Self { size, is_tiling, cos_sin, texel }
    }

    /// The color at a texel of the turned tile.
    pub(super) fn at(&self, x: usize, y: usize) -> Color {
        let [width, height] = self.size.map(f64::from);
        let middle = [0.5 * (width - 1.0), 0.5 * (height - 1.0)];
        let (dx, dy) = (x as f64 - middle[0], y as f64 - middle[1]);
        let [cos, sin] = self.cos_sin;
        // Rows go down: clockwise is from v toward u, and the source lies the other way.
        let (x, fx) = split(middle[0] + dx * cos + dy * sin);
        let (y, fy) = split(middle[1] - dx * sin + dy * cos);
        if fx == 0.0 && fy == 0.0 { self.texel(x, y) } else { self.between(x, y, fx, fy) }
    }

    fn texel(&self, x: i64, y: i64) -> Color {
        let [width, height] = self.size.map(i64::from);
        if self.is_tiling {
            (self.texel)(x.rem_euclid(width) as usize, y.rem_euclid(height) as usize)
        } else if (0..width).contains(&x) && (0..height).contains(&y) {
            (self.texel)(x as usize, y as usize)
        } else {
            [0.0; 4]
        }
    }

    fn between(&self, x: i64, y: i64, fx: f32, fy: f32) -> Color {
        let (across, down) = (cubic(fx), cubic(fy));
        let mut sum = [0.0; 4];
        let (mut least, mut most) = ([f32::INFINITY; 4], [f32::NEG_INFINITY; 4]);
        // Colors for transparent texels: those of the nearest texels, whatever their alpha.
        let mut hidden = [0.0; 3];
        for (row, weight_down) in down.into_iter().enumerate() {
            for (column, weight_across) in across.into_iter().enumerate() {
                let texel = self.texel(x + column as i64 - 1, y + row as i64 - 1);
                let [r, g, b, a] = texel;
                let weight = weight_down * weight_across;
                let premultiplied = [r * a, g * a, b * a, a];
                (0..4).for_each(|i| sum[i] += weight * premultiplied[i]);
                if (1..3).contains(&row) && (1..3).contains(&column) {
                    // Invisible texels do not bound the colors, only the alpha.
                    for i in if a > 0.0 { 0..4 } else { 3..4 } {
                        least[i] = least[i].min(texel[i]);
                        most[i] = most[i].max(texel[i]);
                    }
                    let near = |f: f32, is_second: bool| if is_second { f } else { 1.0 - f };
                    let weight = near(fx, column == 2) * near(fy, row == 2);
                    hidden =
                        [hidden[0] + weight * r, hidden[1] + weight * g, hidden[2] + weight * b];
                }
            }
        }
        let alpha = sum[3].max(least[3]).min(most[3]);
        if alpha > 0.0 {
            // The sum of alphas can be 0 where the clamped one is not: then any color within bounds
            // is as good.
            let straight =
                |i: usize| (sum[i] / sum[3].max(f32::MIN_POSITIVE)).max(least[i]).min(most[i]);
            [straight(0), straight(1), straight(2), alpha]
        } else {
            [hidden[0], hidden[1], hidden[2], 0.0]
        }
    }
}

/// The texel before a position, and the distance of the position beyond it; a position with a
/// rounding error beside a texel becomes that texel.
fn split(place: f64) -> (i64, f32) {
    let nearest = place.round();
    if (place - nearest).abs() < 1e-9 {
        return (nearest as i64, 0.0);
    }
    (place.floor() as i64, (place - place.floor()) as f32)
}

/// Catmull-Rom's weights of four texels for a place between the middle two.
fn cubic(f: f32) -> [f32; 4] {
    let (square, cube) = (f * f, f * f * f);
    [
        0.5 * (2.0 * square - f - cube),
        0.5 * (2.0 - 5.0 * square + 3.0 * cube),
        0.5 * (f + 4.0 * square - 3.0 * cube),
        0.5 * (cube - square),
    ]
}
