//! Strokes as one eye and one light find them: those that exist, their places on the tile, and
//! their lighting.

use glam::{Vec2, Vec3};

use super::canvas::{Grain, StrokeCorner, StrokeRaster};
use super::scatter::ScatteredStroke;
use crate::document::{Bundle, StrokeShape, Strokes};
use crate::progress::Progress;

/// Greatest factor by which a point moves for its height: toward the horizon it would grow without
/// bound. 4 is that of a direction 76 degrees from the normal.
pub(super) const MAX_SLOPE: f32 = 4.0;

/// The move of a point on the tile for its height, away from the eye or light: a point at height h
/// over q is seen at q - h slope. Along u and v.
pub(super) fn slope(toward: Vec3) -> Vec2 {
    let along = toward.truncate();
    let length = along.length();
    if length < 1e-6 {
        return Vec2::ZERO;
    }
    along / length * (length / toward.z.max(1e-6)).min(MAX_SLOPE)
}

/// Directions toward an eye and a light: unit vectors along u, along v and along the normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rays {
    pub(super) view: Vec3,
    pub(super) light: Vec3,
    /// Share of a turn that the eye went around the normal.
    pub(super) around: f64,
}

/// A point of a stroke.
#[derive(Clone, Copy, Debug)]
struct StrokePoint {
    position: Vec3,
    /// Vector to the stroke's edge, along the surface and up.
    side: Vec3,
    /// Cosines between the light and the stroke's face, and between the light and its side.
    facing: f32,
    aside: f32,
    /// Strength of the highlight.
    shine: f32,
}

/// A stroke that exists in a light.
pub(super) struct VisibleStroke<'a> {
    pub(super) number: u32,
    pub(super) stroke: &'a ScatteredStroke,
    pub(super) bundle: &'a Bundle,
    /// Radius, for a dot.
    radius: f32,
    points: Vec<StrokePoint>,
}

/// All strokes that exist in a light, by number.
pub(super) fn seen<'a>(
    of: &'a Strokes,
    all: &'a [ScatteredStroke],
    rays: Rays,
) -> Vec<Option<VisibleStroke<'a>>> {
    all.iter().enumerate().map(|(number, stroke)| one(of, number as u32, stroke, rays)).collect()
}

fn one<'a>(
    of: &'a Strokes,
    number: u32,
    stroke: &'a ScatteredStroke,
    rays: Rays,
) -> Option<VisibleStroke<'a>> {
    let bundle = of.bundles.get(stroke.bundle)?;
    let tone = f64::from(rays.light.z);
    let share = bundle.tones.map_or(1.0, |tones| tones.share(tone, stroke.rank)) as f32;
    if share <= 0.0 {
        return None;
    }
    // The area of a dot grows as that of a line does, so its radius goes by the root.
    let grown = if bundle.shape == StrokeShape::Dot { share.sqrt() } else { share };
    let radius = stroke.half_width * grown;
    let points = stroke.turned(bundle.turns * rays.around);
    let last = (points.len() - 1).max(1) as f32;
    let point = |index: usize| {
        let (before, after) =
            (points[index.saturating_sub(1)], points[(index + 1).min(points.len() - 1)]);
        let tangent = (after - before).normalize_or(Vec3::Z);
        let part = index as f32 / last;
        let [root, tip] = bundle.taper.map(|taper| taper as f32);
        let width = (1.0 - root * (1.0 - part).powi(2)) * (1.0 - tip * part.powi(2));
        lit(bundle, points[index], tangent, radius * width, rays)
    };
    Some(VisibleStroke {
        number,
        stroke,
        bundle,
        radius,
        points: (0..points.len()).map(point).collect(),
    })
}

/// The lighting and the side of a point of a stroke.
fn lit(bundle: &Bundle, position: Vec3, tangent: Vec3, half_width: f32, rays: Rays) -> StrokePoint {
    let Rays { view, light, .. } = rays;
    let half = (view + light).normalize_or(Vec3::Z);
    let sharpness = bundle.highlight.sharpness as f32;
    if bundle.shape == StrokeShape::Thread {
        // A thread is lit as a round body: its side is at a right angle to the eye, its face toward
        // the eye.
        let level = Vec3::new(tangent.y, -tangent.x, 0.0).normalize_or(Vec3::X);
        let side = tangent.cross(view).normalize_or(level);
        let face = side.cross(tangent);
        let face = if face.dot(view) < 0.0 { -face } else { face };
        let sine = (1.0 - tangent.dot(half).powi(2)).max(0.0).sqrt();
        let shine = sine.powf(sharpness);
        return StrokePoint {
            position,
            side: side * half_width,
            facing: face.dot(light),
            aside: side.dot(light),
            shine,
        };
    }
    let side = Vec3::new(tangent.y, -tangent.x, 0.0).normalize_or(Vec3::X);
    let face = side.cross(tangent).normalize_or(Vec3::Z);
    let face = if face.z < 0.0 || bundle.shape == StrokeShape::Dot { Vec3::Z } else { face };
    let shine = face.dot(half).max(0.0).powf(sharpness);
    StrokePoint { position, side: side * half_width, facing: face.dot(light), aside: 0.0, shine }
}

/// Draws strokes along a slope; `None` if the work is stopped. `scale` is the number of cells in a
/// width of the tile, `height` the tile's height in its widths.
pub(super) fn draw<'a>(
    canvas: &mut StrokeRaster,
    all: impl Iterator<Item = &'a VisibleStroke<'a>>,
    slope: Vec2,
    scale: f32,
    height: f32,
    with_grain: bool,
    progress: &Progress,
) -> Option<()> {
    // v goes up and rows go down.
    let on_tile = |point: Vec3| {
        let at = point.truncate() - point.z * slope;
        Vec2::new(at.x, height - at.y) * scale
    };
    for seen in all {
        if progress.is_stopped() {
            return None;
        }
        let grain = if with_grain { seen.bundle.grain as f32 } else { 0.0 };
        let grain = Grain { amount: grain, stroke: seen.number };
        if let [dot] = seen.points[..] {
            let middle = StrokeCorner {
                at: on_tile(dot.position),
                height: dot.position.z,
                along: 0.0,
                across: 0.0,
            };
            canvas.disc(middle, seen.radius * scale, seen.number, grain);
            continue;
        }
        for (index, pair) in seen.points.windows(2).enumerate() {
            let corner = |which: usize, across: f32| {
                let point = &pair[which];
                let at = on_tile(point.position + across * point.side);
                StrokeCorner { at, height: point.position.z, along: (index + which) as f32, across }
            };
            let [a, b, c, d] = [corner(0, -1.0), corner(0, 1.0), corner(1, 1.0), corner(1, -1.0)];
            canvas.triangle([a, b, c], seen.number, grain);
            canvas.triangle([a, c, d], seen.number, grain);
        }
    }
    Some(())
}

impl VisibleStroke<'_> {
    /// The lighting between two points: the cosines between the light and the stroke's face and
    /// side, and the strength of the highlight.
    pub(super) fn lit(&self, along: f32) -> [f32; 3] {
        let last = self.points.len() - 1;
        let low = (along.max(0.0) as usize).min(last.saturating_sub(1));
        let (a, b) = (&self.points[low], &self.points[(low + 1).min(last)]);
        let part = (along - low as f32).clamp(0.0, 1.0);
        let mix = |a: f32, b: f32| a + (b - a) * part;
        [mix(a.facing, b.facing), mix(a.aside, b.aside), mix(a.shine, b.shine)]
    }

    /// The stroke's own color at a position along it.
    pub(super) fn color(&self, along: f32) -> Vec3 {
        let last = if self.points.len() == 1 { 1.0 } else { (self.points.len() - 1) as f32 };
        self.stroke.root.lerp(self.stroke.tip, (along / last).clamp(0.0, 1.0))
    }
}
