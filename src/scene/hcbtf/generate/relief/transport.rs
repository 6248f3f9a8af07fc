//! Light transport on the field: the shares of the sky and of the other cells that every cell sees.
//!
//! Around every cell's middle the horizon is followed in [`AZIMUTHS`] directions, from the plane of
//! the cell itself up. Each time the horizon rises, the cell that raised it fills the angles
//! between, weighed by the cosine to the cell's normal; the rest is sky. With e the elevation, n
//! the normal's part along z and t its part along the direction, the weight below e is n sin(e)^2 /
//! 2 + t (e + sin(e) cos(e)) / 2, the integral of the cosine over the wedge. The weights of a cell,
//! with the sky's, add up to 1, so no light is made or lost: under a white sky a white relief of
//! any form is white.

use std::f32::consts::{FRAC_PI_2, TAU};

use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::field::{Crossing, HeightField};
use crate::progress::Progress;

/// Number of directions around a cell.
const AZIMUTHS: usize = 16;
/// Greatest number of cells that are stored of those seen in a direction.
const SEEN_IN_DIRECTION: usize = 3;
/// Least rise of the horizon's slope that is searched for.
const LEAST_RISE: f32 = 0.02;

/// Shares of the surroundings that every cell sees.
pub(super) struct Transport {
    /// Share of the sky, by cell.
    pub(super) sky: Vec<f32>,
    /// Index in `seen` where the cells seen from each cell begin, and the end of the last cell's.
    starts: Vec<u32>,
    /// Cells that are seen, one cell's after the other's.
    seen: Vec<Share>,
}

/// A cell that is seen, and the share of the surroundings that it fills.
type Share = (u32, f32);

/// The share that the sky fills, and the cells that are seen.
type Surroundings = (f32, Vec<Share>);

impl Transport {
    /// The light transport of a field; `None` if the work is stopped.
    pub(super) fn new(field: &HeightField, progress: &Progress) -> Option<Self> {
        let [width, height] = field.size;
        let row = |y: usize| -> Option<Vec<Surroundings>> {
            let cell = |x: usize| around(field, y * width + x);
            if progress.is_stopped() {
                return None;
            }
            let row = (0..width).map(cell).collect();
            // Several rows of cells are one row of texels.
            if y.is_multiple_of(field.per_texel) {
                progress.add(super::TRANSPORT_TILES);
            }
            Some(row)
        };
        let rows: Vec<_> = (0..height).into_par_iter().map(row).collect::<Option<_>>()?;
        let mut transport = Self { sky: Vec::new(), starts: vec![0], seen: Vec::new() };
        for (sky, seen) in rows.into_iter().flatten() {
            transport.sky.push(sky);
            transport.seen.extend(seen);
            transport.starts.push(transport.seen.len() as u32);
        }
        Some(transport)
    }

    /// The light that reaches a cell from the cells that it sees, each sending its color in `sent`.
    pub(super) fn gathered(&self, cell: usize, sent: &[[f32; 3]]) -> [f32; 3] {
        let mut sum = [0.0; 3];
        for (from, weight) in &self.seen[self.starts[cell] as usize..self.starts[cell + 1] as usize]
        {
            let color = sent[*from as usize];
            (0..3).for_each(|i| sum[i] += weight * color[i]);
        }
        sum
    }
}

/// The share of the sky that a cell sees, and the other cells with their shares.
fn around(field: &HeightField, cell: usize) -> Surroundings {
    let middle = field.middle(cell);
    let normal = field.normal(cell);
    let (mut sky, mut seen, mut all) = (0.0, Vec::new(), 0.0);
    for azimuth in 0..AZIMUTHS {
        // Directions lie off the axes, where rays would run along grid lines.
        let turn = TAU * (azimuth as f32 + 0.5) / AZIMUTHS as f32;
        let direction = [turn.sin(), turn.cos()];
        let wedge =
            Wedge { up: normal[2], along: normal[0] * direction[0] + normal[1] * direction[1] };
        let plane = -wedge.along / wedge.up;
        let mut slope = plane;
        let begin = wedge.below(plane.atan());
        let mut risen: Vec<(u32, f32)> = Vec::new();
        let mut last = begin;
        let above = field.top - middle[2];
        let visit = |Crossing { distance, height, cell }| {
            let found = (height - middle[2]) / distance;
            if found > slope + 1e-4 {
                slope = found;
                let reached = wedge.below(found.atan());
                risen.push((cell as u32, reached - last));
                last = reached;
            }
            above > (slope + LEAST_RISE).max(LEAST_RISE) * distance
        };
        field.follow([middle[0], middle[1]], direction, field.farthest(), visit);
        let end = wedge.below(FRAC_PI_2);
        sky += end - last;
        all += end - begin;
        merge(&mut risen, last - begin);
        seen.append(&mut risen);
    }
    // The whole is 0 also where a cell is so steep that rounding leaves nothing.
    if all <= 1e-6 {
        return (1.0, Vec::new());
    }
    seen.iter_mut().for_each(|(_, weight)| *weight /= all);
    (sky / all, seen)
}

/// A direction around a cell: the parts of the cell's normal, up and along the direction.
struct Wedge {
    up: f32,
    along: f32,
}

impl Wedge {
    /// The integral of the cosine over the elevations below `elevation`.
    fn below(&self, elevation: f32) -> f32 {
        let (sin, cos) = elevation.sin_cos();
        0.5 * self.up * sin * sin + 0.5 * self.along * (elevation + sin * cos)
    }
}

/// Merges the cells of a direction into few: neighbors are joined, and the largest of them stands
/// for all.
fn merge(risen: &mut Vec<(u32, f32)>, whole: f32) {
    if risen.len() <= SEEN_IN_DIRECTION {
        return;
    }
    let mut merged: Vec<(u32, f32)> = Vec::with_capacity(SEEN_IN_DIRECTION);
    let (mut sum, mut largest) = (0.0, (0, -1.0));
    for (cell, weight) in risen.drain(..) {
        sum += weight;
        if weight > largest.1 {
            largest = (cell, weight);
        }
        let is_last = merged.len() + 1 == SEEN_IN_DIRECTION;
        if !is_last && sum >= whole / SEEN_IN_DIRECTION as f32 {
            merged.push((largest.0, sum));
            (sum, largest) = (0.0, (0, -1.0));
        }
    }
    if sum > 0.0 {
        merged.push((largest.0, sum));
    }
    *risen = merged;
}
