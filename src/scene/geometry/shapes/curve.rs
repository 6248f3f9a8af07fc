//! Round tubes along smooth curves, as signed distances.

use glam::{DVec3, DVec4};

/// Number of samples of a span among which the search for the nearest point on the curve begins.
const SAMPLES: usize = 5;
/// Number of Newton steps that refine the nearest point.
const REFINEMENTS: usize = 3;

/// A tube through points `[x, y, z, radius]`: the natural cubic spline, whose curvature is
/// continuous.
#[derive(Clone, Debug)]
pub(super) struct Tube {
    /// Coefficients of each span between two points: the value is
    /// `s[0] + s[1] t + s[2] t² + s[3] t³`, t from 0 to 1.
    spans: Vec<[DVec4; 4]>,
    samples: Vec<DVec3>,
}

impl Tube {
    /// The tube through at least two points.
    pub(super) fn through(points: &[[f64; 4]]) -> Self {
        let points: Vec<DVec4> = points.iter().copied().map(DVec4::from).collect();
        let slopes = natural_slopes(&points);
        let spans: Vec<[DVec4; 4]> = points
            .windows(2)
            .zip(slopes.windows(2))
            .map(|(p, m)| {
                let chord = p[1] - p[0];
                [p[0], m[0], chord * 3.0 - m[0] * 2.0 - m[1], m[0] + m[1] - chord * 2.0]
            })
            .collect();
        let count = spans.len() * SAMPLES;
        let mut curve = Self { spans, samples: Vec::new() };
        curve.samples =
            (0..=count).map(|i| curve.at(i as f64 / SAMPLES as f64).truncate()).collect();
        curve
    }

    fn span(&self, t: f64) -> (&[DVec4; 4], f64) {
        let index = (t as usize).min(self.spans.len() - 1);
        (&self.spans[index], t - index as f64)
    }

    /// The position and radius at `t`, 0 to the number of spans.
    pub(super) fn at(&self, t: f64) -> DVec4 {
        let (s, t) = self.span(t);
        s[0] + (s[1] + (s[2] + s[3] * t) * t) * t
    }

    /// The derivative of the position by `t`.
    pub(super) fn slope(&self, t: f64) -> DVec3 {
        let (s, t) = self.span(t);
        (s[1] + (s[2] * 2.0 + s[3] * (3.0 * t)) * t).truncate()
    }

    /// A ball that holds the tube: its center and radius.
    pub(super) fn hull(&self) -> (DVec3, f64) {
        let middle = self.samples.iter().sum::<DVec3>() / self.samples.len() as f64;
        let reach = |i: usize| {
            let p = self.at(i as f64 / SAMPLES as f64);
            p.truncate().distance(middle) + p.w
        };
        // Between samples the curve bows out by a little.
        (middle, 1.05 * (0..self.samples.len()).map(reach).fold(0.0, f64::max))
    }

    /// The signed distance from the tube's surface, negative inside. The nearest point of the axis
    /// is where the line to it is perpendicular to the curve.
    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let mut nearest = (f64::INFINITY, 0);
        for (i, sample) in self.samples.iter().enumerate() {
            let d = p.distance_squared(*sample);
            if d < nearest.0 {
                nearest = (d, i);
            }
        }
        let step = 1.0 / SAMPLES as f64;
        let start = nearest.1 as f64 * step;
        let (low, high) = ((start - step).max(0.0), (start + step).min(self.spans.len() as f64));
        let mut t = start;
        for _ in 0..REFINEMENTS {
            let (s, u) = self.span(t);
            let away = (s[0] + (s[1] + (s[2] + s[3] * u) * u) * u).truncate() - p;
            let slope = (s[1] + (s[2] * 2.0 + s[3] * (3.0 * u)) * u).truncate();
            let bend = (s[2] * 2.0 + s[3] * (6.0 * u)).truncate();
            // The bend is left out where it would lead away from the least distance.
            let steep = slope.length_squared();
            let change = steep + away.dot(bend);
            t = (t - away.dot(slope) / if change > 0.3 * steep { change } else { steep })
                .clamp(low, high);
        }
        let found = self.at(t);
        p.distance(found.truncate()) - found.w
    }
}

/// The derivatives at the points of the spline without bend at its ends: solves the tridiagonal
/// system by elimination.
fn natural_slopes(points: &[DVec4]) -> Vec<DVec4> {
    let last = points.len() - 1;
    let right = |i: usize| (points[(i + 1).min(last)] - points[i.saturating_sub(1)]) * 3.0;
    let mut upper = vec![0.0; points.len()];
    let mut slopes = vec![DVec4::ZERO; points.len()];
    for i in 0..=last {
        let diagonal = if i == 0 || i == last { 2.0 } else { 4.0 };
        let (before, slope_before) =
            if i == 0 { (0.0, DVec4::ZERO) } else { (upper[i - 1], slopes[i - 1]) };
        upper[i] = 1.0 / (diagonal - before);
        slopes[i] = (right(i) - slope_before) * upper[i];
    }
    for i in (0..last).rev() {
        let next = slopes[i + 1];
        slopes[i] -= next * upper[i];
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_tube_is_a_capsule() {
        let tube =
            Tube::through(&[[0.0, 0.0, 0.0, 0.5], [1.0, 0.0, 0.0, 0.5], [3.0, 0.0, 0.0, 0.5]]);
        for (p, d) in
            [([2.0, 1.0, 0.0], 0.5), ([-2.0, 0.0, 0.0], 1.5), ([4.0, 0.0, 1.0], 2f64.sqrt() - 0.5)]
        {
            assert!(
                (tube.distance(p.into()) - d).abs() < 1e-3,
                "{p:?}: {} instead of {d}",
                tube.distance(p.into())
            );
        }
    }

    #[test]
    fn the_curve_meets_its_points_smoothly() {
        let points = [
            [0.0, 0.0, 0.0, 0.1],
            [1.0, 1.0, 0.0, 0.2],
            [2.0, 0.0, 1.0, 0.3],
            [4.0, 0.0, 0.0, 0.1],
        ];
        let curve = Tube::through(&points);
        for (i, p) in points.iter().enumerate() {
            assert!(curve.at(i as f64).distance(DVec4::from(*p)) < 1e-12);
        }
        for pair in curve.spans.windows(2) {
            let [end, start] = [(&pair[0], 1.0), (&pair[1], 0.0)].map(|(s, t)| {
                (s[1] + (s[2] * 2.0 + s[3] * (3.0 * t)) * t, s[2] * 2.0 + s[3] * (6.0 * t))
            });
            assert!(end.0.distance(start.0) < 1e-12 && end.1.distance(start.1) < 1e-12);
        }
    }
}
