//! Lighting and shadows of the strokes that are seen, and their mean over a texel.

use glam::{Vec2, Vec3};

use super::canvas::{GROUND, StrokeHit, StrokeRaster};
use super::seen::{Rays, VisibleStroke, slope};
use super::{BIAS, CELLS, Color, PreparedStrokes};

/// Shadow map of a light: the strokes that stand highest between the light and each place of the
/// tile.
pub(super) struct ShadowMap {
    pub(super) canvas: StrokeRaster,
    /// Number of cells in a width of the tile.
    pub(super) scale: f32,
}

/// Light on the strokes that an eye sees.
pub(super) struct StrokeLight<'a> {
    there: &'a [Option<VisibleStroke<'a>>],
    shadows: Option<&'a ShadowMap>,
    jitter: &'a [Vec2],
    /// Color of the lit ground, and the part of it that shadows take.
    ground: Vec3,
    shadowed: Vec3,
    ground_color: Color,
    /// Share of the light that shadows take, and their blur for the distance over which they fall.
    amount: f32,
    softness: f32,
    tallest: f32,
    /// Offset, for its height, of a point from the place where the light through the point meets
    /// the ground; rows go down.
    shift: Vec2,
    /// Size of a cell, in widths of the tile.
    cell: f32,
}

impl<'a> StrokeLight<'a> {
    pub(super) fn new(
        of: &'a PreparedStrokes,
        rays: Rays,
        there: &'a [Option<VisibleStroke<'a>>],
        shadows: Option<&'a ShadowMap>,
    ) -> Self {
        let ground = &of.strokes.ground;
        let ground_color = ground.color.map(f32::from);
        let color = Vec3::from_slice(&ground_color);
        let diffuse = ground.diffuse as f32 * rays.light.z.max(0.0);
        let shift = slope(rays.view) - slope(rays.light);
        Self {
            there,
            shadows,
            jitter: &of.jitter,
            ground: color * (ground.ambient as f32 + diffuse),
            shadowed: color * diffuse,
            ground_color,
            amount: of.strokes.shadow.amount as f32,
            softness: of.strokes.shadow.softness as f32,
            tallest: of.tallest,
            shift: Vec2::new(shift.x, -shift.y),
            cell: 1.0 / (of.grid.size[0] as f32 * CELLS as f32),
        }
    }

    /// The mean color over the places of a texel; `y` is the texel's first row of cells.
    pub(super) fn texel(&self, canvas: &StrokeRaster, x: usize, y: usize) -> Color {
        let (mut sum, mut alphas) = (Vec3::ZERO, 0.0);
        for down in 0..CELLS {
            let row = canvas.row(y + down);
            for across in 0..CELLS {
                let cell = [x * CELLS + across, y + down];
                let (color, alpha) =
                    self.color(&row[cell[0]], cell, self.jitter[down * CELLS + across]);
                sum += color * alpha;
                alphas += alpha;
            }
        }
        let count = (CELLS * CELLS) as f32;
        if alphas > 0.0 {
            let color = sum / alphas;
            [color.x, color.y, color.z, alphas / count]
        } else {
            let [r, g, b, _] = self.ground_color;
            [r, g, b, 0.0]
        }
    }

    /// The lit color at a cell: straight RGB from 0 to 255, and alpha.
    fn color(&self, hit: &StrokeHit, cell: [usize; 2], jitter: Vec2) -> (Vec3, f32) {
        let shadow = self.amount * self.shadow(hit, cell, jitter);
        let seen =
            (hit.stroke != GROUND).then(|| self.there.get(hit.stroke as usize)?.as_ref()).flatten();
        let (color, alpha) = match seen {
            None => (self.ground - self.shadowed * shadow, self.ground_color[3]),
            Some(seen) => {
                let [facing, aside, shine] = seen.lit(hit.along);
                let round = (1.0 - hit.across * hit.across).max(0.0).sqrt();
                let toward =
                    if aside == 0.0 { facing } else { round * facing + hit.across * aside };
                let bundle = seen.bundle;
                let shone = bundle.diffuse as f32 * toward.max(0.0)
                    + bundle.translucent as f32 * (-toward).max(0.0);
                let reach = 1.0 - shadow;
                let highlight = Vec3::from(bundle.highlight.color.map(f32::from));
                let highlight = highlight * (bundle.highlight.amount as f32 * shine * reach);
                (seen.color(hit.along) * (bundle.ambient as f32 + shone * reach) + highlight, 255.0)
            }
        };
        (color.clamp(Vec3::ZERO, Vec3::splat(255.0)), alpha)
    }

    /// The shadow on the point that is seen at a cell: 1 if a stroke stands between the light and
    /// the point, else 0.
    fn shadow(&self, hit: &StrokeHit, cell: [usize; 2], jitter: Vec2) -> f32 {
        let Some(shadows) = self.shadows else { return 0.0 };
        let height = hit.height.max(0.0);
        let seen_at = Vec2::new(cell[0] as f32 + 0.5, cell[1] as f32 + 0.5) * self.cell;
        let blur = self.softness * (self.tallest - height).max(0.0);
        let ground = seen_at + height * self.shift + jitter * blur;
        let above = shadows.canvas.at(ground * shadows.scale);
        f32::from(u8::from(above.stroke != hit.stroke && above.height > height + BIAS))
    }
}
