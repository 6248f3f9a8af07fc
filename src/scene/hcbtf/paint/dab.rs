//! One stamp of a round brush.

use glam::DVec2;

/// How a round brush covers the texels around a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dab {
    center: DVec2,
    hardness: f64,
    /// In texels, where it covers wholly.
    inner: f64,
    /// In texels, where it ends.
    outer: f64,
    /// How much the one texel is covered that a brush without extent meets.
    dot: Option<f64>,
}

impl Dab {
    /// A brush of a diameter in texels. Its edge is at least about a texel wide, half of it outside
    /// where it is hard, so that a hard brush covers as much as its disc. Up to a diameter of 1 it
    /// is one whole texel, the one it is in, covered by the square of the diameter.
    pub(super) fn new(center: DVec2, size: f64, hardness: f64) -> Self {
        let (radius, half) = (size / 2.0, hardness / 2.0);
        if size > 1.0 {
            Self {
                center,
                hardness,
                inner: radius * hardness - half,
                outer: radius + half,
                dot: None,
            }
        } else {
            Self {
                center: center.floor() + 0.5,
                hardness,
                inner: 0.0,
                outer: 0.5,
                dot: Some(size * size),
            }
        }
    }

    /// The rows that it meets.
    pub(super) fn rows(&self) -> [i64; 2] {
        around(self.center.y, self.outer)
    }

    /// The columns that it meets anywhere.
    pub(super) fn columns(&self) -> [i64; 2] {
        around(self.center.x, self.outer)
    }

    /// The columns that it meets in a row.
    pub(super) fn columns_at(&self, row: i64) -> [i64; 2] {
        let down = row as f64 + 0.5 - self.center.y;
        around(self.center.x, (self.outer * self.outer - down * down).max(0.0).sqrt())
    }

    /// How much it covers a texel, from 0 to 1.
    pub(super) fn cover(&self, column: i64, row: i64) -> f64 {
        if let Some(dot) = self.dot {
            return dot;
        }
        let away = DVec2::new(column as f64, row as f64) + 0.5 - self.center;
        // Exact, since places are multiples of a power of two: mirrored texels get the same.
        let square = away.x * away.x + away.y * away.y;
        if square >= self.outer * self.outer {
            0.0
        } else if self.inner > 0.0 && square <= self.inner * self.inner {
            1.0
        } else {
            let within = ((self.outer - square.sqrt()) / (self.outer - self.inner)).min(1.0);
            let smooth = within * within * (3.0 - 2.0 * within);
            smooth + (within - smooth) * self.hardness
        }
    }
}

/// The texels whose middles may be nearer than `reach` to `at`, along an axis.
fn around(at: f64, reach: f64) -> [i64; 2] {
    [(at - reach - 0.5).ceil() as i64, (at + reach - 0.5).floor() as i64 + 1]
}
