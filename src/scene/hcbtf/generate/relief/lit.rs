//! Light of the sun and the sky on the field: the share of the sun that every cell sees, and the
//! ambient light that reaches it.

use super::field::HeightField;
use super::noise::{mix3, ramp};
use super::pattern::linear;
use super::transport::Transport;
use crate::document::Relief;
use crate::document::relief::Illumination;
use crate::progress::Progress;

/// Difference in height between corners above which a cell is a wall, whose shadow is computed at
/// each point that is seen, in cells.
const WALL: f32 = 1.5;

/// Light on the field.
pub(super) struct FieldLight {
    /// Direction toward the sun: along x, along y (down), and out of the tile.
    pub(super) toward: [f32; 3],
    /// Color of the sun's own light, linear.
    pub(super) sun: [f32; 3],
    /// Lowness of the sun, from 0 to 1.
    pub(super) lowness: f32,
    /// Share of the sun's disc that every cell sees.
    pub(super) visible: Vec<f32>,
    /// Light that reaches every cell from the sky and from other cells, linear.
    pub(super) ambient: Vec<[f32; 3]>,
}

impl FieldLight {
    /// The light on a field; `None` if the work is stopped.
    pub(super) fn new(
        relief: &Relief,
        field: &HeightField,
        transport: &Transport,
        toward: [f32; 3],
        progress: &Progress,
    ) -> Option<Self> {
        let light = &relief.light;
        let lowness = lowness(light, toward);
        let amount = |colors: [[u8; 3]; 2], amount: f64| {
            mix3(linear(colors[0]), linear(colors[1]), lowness)
                .map(|channel| channel * amount as f32)
        };
        let sun = amount([light.sun, light.low_sun], light.sun_amount);
        let sky = amount([light.sky, light.low_sky], light.sky_amount);
        let shadows = FieldShadows::new(light, toward);
        let width = field.size[0];
        let cells = width * field.size[1];
        let (mut visible, mut direct) = (Vec::with_capacity(cells), Vec::with_capacity(cells));
        for cell in 0..cells {
            if cell % width == 0 && progress.is_stopped() {
                return None;
            }
            let cosine = shadows.cosine(field, cell);
            let seen =
                if cosine > 0.0 { shadows.visible(field, cell, field.middle(cell)) } else { 0.0 };
            visible.push(seen);
            direct.push(seen * cosine);
        }
        let own =
            |cell: usize| -> [f32; 3] { std::array::from_fn(|i| transport.sky[cell] * sky[i]) };
        let mut ambient: Vec<[f32; 3]> = (0..cells).map(own).collect();
        for _ in 0..light.bounces {
            if progress.is_stopped() {
                return None;
            }
            let sent = |cell: usize| -> [f32; 3] {
                let color = field.materials[cell].color;
                std::array::from_fn(|i| color[i] * (sun[i] * direct[cell] + ambient[cell][i]))
            };
            let sent: Vec<[f32; 3]> = (0..cells).map(sent).collect();
            let next = |cell: usize| -> [f32; 3] {
                let (own, gathered) = (own(cell), transport.gathered(cell, &sent));
                std::array::from_fn(|i| own[i] + gathered[i])
            };
            ambient = (0..cells).map(next).collect();
        }
        Some(Self { toward, sun, lowness, visible, ambient })
    }

    /// The share of the sun that is seen from a place of a cell.
    pub(super) fn visible_at(
        &self,
        light: &Illumination,
        field: &HeightField,
        cell: usize,
        place: [f32; 3],
    ) -> f32 {
        if field.steepness(cell) < WALL {
            return self.visible[cell];
        }
        FieldShadows::new(light, self.toward).visible(field, cell, place)
    }
}

/// The lowness of the sun: 0 overhead, 1 at the horizon, or level with an upright tile.
fn lowness(light: &Illumination, toward: [f32; 3]) -> f32 {
    let up = if light.is_upright { -toward[1] } else { toward[2] };
    1.0 - ramp(0.0, 0.7, up)
}

/// Computation of the shadows of a light.
pub(super) struct FieldShadows {
    toward: [f32; 3],
    /// Direction along the tile, of length 1.
    along: [f32; 2],
    /// Elevation above the tile, in radians.
    elevation: f32,
    softness: f32,
}

impl FieldShadows {
    pub(super) fn new(light: &Illumination, toward: [f32; 3]) -> Self {
        let [x, y, z] = toward;
        let across = x.hypot(y);
        let along = if across > 1e-6 { [x / across, y / across] } else { [0.0; 2] };
        let along = along.map(|part| if part.abs() < 1e-6 { 0.0 } else { part });
        Self {
            toward,
            along,
            elevation: z.max(0.0).atan2(across),
            softness: (light.softness as f32).max(1e-4),
        }
    }

    /// The cosine between the sun and the normal of a cell, 0 where the sun is behind it.
    fn cosine(&self, field: &HeightField, cell: usize) -> f32 {
        let normal = field.normal(cell);
        (0..3).map(|i| normal[i] * self.toward[i]).sum::<f32>().max(0.0)
    }

    /// The share of the sun's disc above the horizon of a place.
    pub(super) fn visible(&self, field: &HeightField, cell: usize, place: [f32; 3]) -> f32 {
        if self.along == [0.0; 2] {
            return 1.0;
        }
        let [x, y] = field.slopes[cell];
        // A cell does not shadow itself.
        let plane = x * self.along[0] + y * self.along[1];
        let slope = |elevation: f32| elevation.clamp(-1.5, 1.5).tan();
        let (lower, upper) =
            (slope(self.elevation - self.softness), slope(self.elevation + self.softness));
        let least = plane.max(lower);
        let horizon = field.horizon(place, self.along, least, upper);
        if horizon <= least {
            return 1.0;
        }
        // The disc's lower half sinks first; its hidden part counts by the horizon's height above
        // the cell's own plane.
        let hidden = 0.5 + (horizon.atan() - self.elevation) / (2.0 * self.softness);
        let own = ((horizon.atan() - plane.atan()) / self.softness).clamp(0.0, 1.0);
        1.0 - hidden.clamp(0.0, 1.0) * own
    }
}
