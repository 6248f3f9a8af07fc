//! Positions of the stamps along a stroke.
//!
//! Stamps lie at even distances along the path, whatever pieces the pointer's events cut it into:
//! the rest of the distance until the next stamp is carried from piece to piece. The sums of
//! differently cut paths differ in their last bits, so positions and pressures are rounded to a
//! grid afterwards, whose borders lie where no reasonable number is.

use glam::DVec2;

/// Grid of positions, in texels: sums, mirror images and squares of its multiples are exact in f64.
const GRID: f64 = 1.0 / 256.0;
/// Grid of pressures.
const PRESSURE_GRID: f64 = 1.0 / 4096.0;
/// Position of the rounding border between two multiples: at no simple fraction.
const BORDER: f64 = 0.414_213_562_373_095;
/// Distance beyond the end of a piece within which a stamp belongs to the piece, in texels.
const SLACK: f64 = 1e-7 * BORDER;
/// Length of the shortest move, in texels; shorter moves are added to the next.
const SHORTEST: f64 = 1e-9;
/// Greatest coordinate of a position, in texels; farther positions are ignored.
const FARTHEST: f64 = 1_048_576.0;

/// Rounds a position to the grid.
pub(super) fn settled(at: DVec2) -> DVec2 {
    (at / GRID + BORDER).floor() * GRID
}

/// The path of a pen.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Path {
    /// Last position, and the pressure there.
    last: Option<(DVec2, f64)>,
    /// Distance from the last position along the path to the next stamp, in texels.
    left: f64,
}

impl Path {
    /// Goes straight on and calls `lay` with the position and the pressure of every stamp on the
    /// way, at most `most` and one: on a longer way stamps lie farther apart. Positions and
    /// pressures that are not finite, or too far away, are ignored.
    pub(super) fn to(
        &mut self,
        at: DVec2,
        pressure: f64,
        most: f64,
        step: impl Fn(f64) -> f64,
        mut lay: impl FnMut(DVec2, f64),
    ) {
        let is_place = at.is_finite() && at.abs().max_element() <= FARTHEST;
        if !is_place || !pressure.is_finite() {
            return;
        }
        let pressure = pressure.clamp(0.0, 1.0);
        let on_grid = |pressure: f64| (pressure / PRESSURE_GRID + BORDER).floor() * PRESSURE_GRID;
        let Some((from, before)) = self.last else {
            self.last = Some((at, pressure));
            let pressure = on_grid(pressure);
            lay(settled(at), pressure);
            self.left = step(pressure);
            return;
        };
        let way = at - from;
        let length = way.length();
        if length < SHORTEST {
            return;
        }
        self.last = Some((at, pressure));
        while self.left <= length + SLACK {
            let part = self.left / length;
            let pressure = on_grid((before + (pressure - before) * part).clamp(0.0, 1.0));
            lay(settled(from + way * part), pressure);
            self.left += step(pressure).max(length / most);
        }
        self.left -= length;
    }
}
