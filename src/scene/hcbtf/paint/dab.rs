//! Dabs: single stamps of a round brush.

use glam::DVec2;

/// A round brush's coverage of the texels around a position.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dab {
    center: DVec2,
    hardness: f64,
    /// Radius within which the coverage is whole, in texels.
    inner: f64,
    /// Radius at which the coverage ends, in texels.
    outer: f64,
    /// Coverage of the one texel under a brush of at most one texel.
    dot: Option<f64>,
}

impl Dab {
    /// A dab of a diameter in texels. Its edge is at least about a texel wide, half of it outside
    /// the radius for a hard brush, so that such a brush covers as much as its disc. Up to a
    /// diameter of 1 the dab is one whole texel, the one that contains the center, covered by the
    /// square of the diameter.
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

    /// The rows that the dab meets.
    pub(super) fn rows(&self) -> [i64; 2] {
        around(self.center.y, self.outer)
    }

    /// The columns that the dab meets in any row.
    pub(super) fn columns(&self) -> [i64; 2] {
        around(self.center.x, self.outer)
    }

    /// The columns that the dab meets in one row.
    pub(super) fn columns_at(&self, row: i64) -> [i64; 2] {
        let down = row as f64 + 0.5 - self.center.y;
        around(self.center.x, (self.outer * self.outer - down * down).max(0.0).sqrt())
    }

    /// The coverage of a texel, from 0 to 1.
    pub(super) fn cover(&self, column: i64, row: i64) -> f64 {
        if let Some(dot) = self.dot {
            return dot;
        }
        let away = DVec2::new(column as f64, row as f64) + 0.5 - self.center;
        // The square is exact, since positions are multiples of a power of two: mirrored texels get
        // the same coverage.
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
