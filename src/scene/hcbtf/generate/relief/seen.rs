//! Surface that an eye sees: for every cell of the tile as it lies there, the point that hides
//! everything behind it.

use super::field::HeightField;
use super::noise::{ramp, rough};
use crate::document::Relief;
use crate::progress::Progress;

/// Greatest angle between the normal and an eye, in radians; eyes farther away see as from here,
/// because nearer to the horizon they would see only the field's tops.
pub(super) const FARTHEST_VIEW: f32 = 78.0 * std::f32::consts::PI / 180.0;

/// Least change of height, as a share of the relief's, from one ray to the next but one that counts
/// as an edge.
const EDGE: f32 = 0.16;

/// The point where an eye's ray meets the field.
#[derive(Clone, Copy)]
pub(super) struct FieldHit {
    pub(super) place: [f32; 3],
    pub(super) cell: u32,
}

/// Surface that an eye sees.
pub(super) struct VisibleSurface {
    /// Points that are seen, one for each cell of the tile, row by row.
    pub(super) hits: Vec<FieldHit>,
    /// Amount of ink at each cell, from 0 to 255.
    pub(super) ink: Vec<u8>,
}

impl VisibleSurface {
    /// The surface that is seen from a direction: along x, along y (down), and out of the tile.
    /// `None` if the work is stopped.
    pub(super) fn new(
        relief: &Relief,
        field: &HeightField,
        toward: [f32; 3],
        progress: &Progress,
    ) -> Option<Self> {
        let [width, height] = field.size;
        let mut hits = Vec::with_capacity(width * height);
        let eye = Eye::new(relief, field, toward);
        for y in 0..height {
            if progress.is_stopped() {
                return None;
            }
            hits.extend((0..width).map(|x| eye.hit(x, y)));
        }
        let ink = if relief.finish.ink > 0.0 { inked(relief, field, &hits) } else { Vec::new() };
        Some(Self { hits, ink })
    }
}

struct Eye<'a> {
    relief: &'a Relief,
    field: &'a HeightField,
    /// Direction along the tile, away from the eye, of length 1.
    away: [f32; 2],
    /// Tangent of the angle from the normal.
    tangent: f32,
}

impl<'a> Eye<'a> {
    fn new(relief: &'a Relief, field: &'a HeightField, [x, y, z]: [f32; 3]) -> Self {
        let across = x.hypot(y);
        let theta = across.atan2(z).clamp(0.0, FARTHEST_VIEW);
        let away = if across > 1e-6 { [-x / across, -y / across] } else { [0.0; 2] };
        let away = away.map(|part| if part.abs() < 1e-6 { 0.0 } else { part });
        Self { relief, field, away, tangent: if across > 1e-6 { theta.tan() } else { 0.0 } }
    }

    /// The point where the ray through the middle of a cell, at the height that stays in place,
    /// meets the field.
    fn hit(&self, x: usize, y: usize) -> FieldHit {
        let field = self.field;
        let [width, height] = field.size.map(|side| side as f32);
        let mut start = [x as f32 + 0.5, y as f32 + 0.5];
        let wobble = self.relief.finish.wobble as f32;
        if wobble > 0.0 {
            let place = [start[0] / width, start[1] / height];
            let down = ((4.0 * height / width).round() as u32).max(1);
            for (axis, along) in start.iter_mut().enumerate() {
                let stray =
                    rough(self.relief.seed.wrapping_add(60 + axis as u32), [4, down], 3, place)
                        - 0.5;
                *along += 2.0 * wobble * width * stray;
            }
        }
        if self.tangent == 0.0 {
            let place = [start[0], start[1], field.height(start[0], start[1])];
            return FieldHit { place, cell: field.cell(start[0], start[1]) as u32 };
        }
        // The ray starts where it is level with the highest place of the field.
        let back = (1.0 - self.relief.pivot as f32) * field.top * self.tangent;
        let entry = [start[0] - back * self.away[0], start[1] - back * self.away[1]];
        let mut before = (0.0, field.top - field.height(entry[0], entry[1]));
        let mut found = (0.0, field.cell(entry[0], entry[1]));
        let most = field.top * self.tangent + 2.0;
        field.follow(entry, self.away, most, |crossing| {
            let gap = field.top - crossing.distance / self.tangent - crossing.height;
            if gap <= 0.0 {
                let (distance, above) = before;
                let share = if above > gap { (above / (above - gap)).clamp(0.0, 1.0) } else { 0.0 };
                found = (distance + share * (crossing.distance - distance), crossing.cell);
                return false;
            }
            before = (crossing.distance, gap);
            found = (crossing.distance, crossing.cell);
            true
        });
        let (distance, cell) = found;
        let place = [
            entry[0] + distance * self.away[0],
            entry[1] + distance * self.away[1],
            (field.top - distance / self.tangent).max(0.0),
        ];
        FieldHit { place, cell: cell as u32 }
    }
}

/// The ink where one part of the surface stands before another: where the points that neighboring
/// rays meet differ greatly in height.
fn inked(relief: &Relief, field: &HeightField, hits: &[FieldHit]) -> Vec<u8> {
    let [width, height] = field.size;
    let at = |x: usize, y: usize| hits[(y % height) * width + x % width].place[2];
    let edge = |x: usize, y: usize| {
        let across = (at(x + 1, y) - at(x + width - 1, y)).abs();
        let down = (at(x, y + 1) - at(x, y + height - 1)).abs();
        across.max(down) > EDGE * field.range.max(1e-3)
    };
    let edges: Vec<bool> =
        (0..width * height).map(|cell| edge(cell % width, cell / width)).collect();
    let radius = 0.5 * relief.finish.ink_width as f32 * field.per_texel as f32;
    let reach = radius.ceil() as usize;
    let down = ((6.0 * height as f32 / width as f32).round() as u32).max(1);
    let ink = |cell: usize| {
        let (x, y) = (cell % width, cell / width);
        // The pressure of the pen varies.
        let place = [(x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32];
        let pressed =
            radius * (0.55 + 0.9 * rough(relief.seed.wrapping_add(70), [6, down], 2, place));
        let mut most = 0.0_f32;
        for (dx, dy) in (0..=2 * reach).flat_map(|dy| (0..=2 * reach).map(move |dx| (dx, dy))) {
            let (column, row) = (
                (x + dx + width - reach % width) % width,
                (y + dy + height - reach % height) % height,
            );
            if edges[row * width + column] {
                let distance = (dx as f32 - reach as f32).hypot(dy as f32 - reach as f32);
                most = most.max(1.0 - ramp(pressed - 0.5, pressed + 0.5, distance));
            }
        }
        (255.0 * most) as u8
    };
    (0..width * height).map(ink).collect()
}
