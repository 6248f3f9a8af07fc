//! Coverage of a sketch's pixels by a stroke.
//!
//! A stroke is the path of a round brush: the coverage of a pixel depends on its distance from the
//! path, so that a stroke that crosses itself, or goes slowly, covers no more there, and its edge
//! stays as soft as the brush's.

use glam::DVec2;

/// Coverage of a stroke.
pub(super) struct Cover {
    size: [u32; 2],
    /// Radius of the brush, in pixels.
    radius: f64,
    /// Part of the radius that is covered fully, 0 to 1.
    hardness: f64,
    last: Option<DVec2>,
    /// Coverage of each pixel, rows from the top, 0 to 1.
    shares: Vec<f32>,
}

impl Cover {
    /// Empty coverage of a sketch.
    pub(super) fn new(size: [u32; 2], radius: f64, hardness: f64) -> Self {
        Self {
            size,
            radius,
            hardness,
            last: None,
            shares: vec![0.0; size[0] as usize * size[1] as usize],
        }
    }

    /// Extends the stroke to a place in pixels. Returns the pixels whose coverage has grown, with
    /// their new coverage.
    pub(super) fn to(&mut self, at: DVec2) -> Vec<([u32; 2], f64)> {
        let from = self.last.replace(at).unwrap_or(at);
        let range = |axis: usize| {
            let (low, high) = (from[axis].min(at[axis]), from[axis].max(at[axis]));
            let side = f64::from(self.size[axis]);
            let first = (low - self.radius - 1.0).clamp(0.0, side) as u32;
            first..(high + self.radius + 1.0).clamp(0.0, side).ceil() as u32
        };
        let (columns, rows) = (range(0), range(1));
        let mut more = Vec::new();
        for (x, y) in rows.flat_map(|y| columns.clone().map(move |x| (x, y))) {
            let place = DVec2::new(f64::from(x), f64::from(y)) + 0.5;
            let share = self.share(distance(place, from, at));
            let known = &mut self.shares[y as usize * self.size[0] as usize + x as usize];
            if share as f32 > *known {
                *known = share as f32;
                more.push(([x, y], share));
            }
        }
        more
    }

    /// Coverage at a distance from the path, in pixels.
    fn share(&self, distance: f64) -> f64 {
        // The hardest edge is still one pixel wide.
        let soft = (1.0 - self.hardness) * self.radius + 1.0;
        let part = ((self.radius + 0.5 - distance) / soft).clamp(0.0, 1.0);
        part * part * (3.0 - 2.0 * part)
    }
}

/// Distance of a place from the segment between two others.
fn distance(place: DVec2, from: DVec2, to: DVec2) -> f64 {
    let way = to - from;
    let length = way.length_squared();
    let part = if length > 0.0 { ((place - from).dot(way) / length).clamp(0.0, 1.0) } else { 0.0 };
    place.distance(from + part * way)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_that_is_gone_twice_covers_no_more() {
        let mut once = Cover::new([60, 40], 8.0, 0.5);
        let places = [[15.0, 20.0], [45.0, 20.0]].map(DVec2::from);
        assert!(places.iter().map(|at| once.to(*at).len()).sum::<usize>() > 400);
        let first = once.shares.clone();
        for at in [places[0], DVec2::new(30.0, 20.0), places[1]] {
            assert!(once.to(at).is_empty());
        }
        assert_eq!(once.shares, first);
        let at = |x: usize, y: usize| once.shares[y * 60 + x];
        assert_eq!((at(30, 20), at(30, 22), at(30, 35)), (1.0, 1.0, 0.0));
        // The place lies halfway through the soft edge, which reaches from 3.5 to 8.5 pixels.
        let half = Cover::new([1, 1], 8.0, 0.5).share(6.0);
        assert!((half - 0.5).abs() < 1e-12, "{half}");
    }
}
