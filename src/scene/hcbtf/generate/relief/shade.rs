//! Samples of a relief: the surface that an eye sees, in the light that falls on it, finished as by
//! hand.

use std::sync::OnceLock;

use super::lit::FieldLight;
use super::noise::{chances, hash, mix, mix3, ramp, rough};
use super::pattern::linear;
use super::seen::{FieldHit, VisibleSurface};
use super::{Color, PreparedRelief};
use crate::document::relief::Pattern;
use crate::progress::Progress;

/// The tile of a sample; `None` if the work is stopped.
pub(super) fn tile(
    ready: &PreparedRelief,
    seen: &VisibleSurface,
    lit: &FieldLight,
    view: [f32; 3],
    progress: &Progress,
) -> Option<Vec<Color>> {
    let field = &ready.field;
    let per_texel = field.per_texel;
    let [width, height] = ready.grid.size.map(|side| side as usize);
    let shader = Shader::new(ready, lit, view);
    let mut texels = Vec::with_capacity(width * height);
    for y in 0..height {
        if progress.is_stopped() {
            return None;
        }
        for x in 0..width {
            let mut sum = [0.0; 4];
            for (row, column) in
                (0..per_texel).flat_map(|row| (0..per_texel).map(move |column| (row, column)))
            {
                let ray = (y * per_texel + row) * field.size[0] + x * per_texel + column;
                let ink = seen.ink.get(ray).copied().unwrap_or_default();
                let ([r, g, b], alpha) = shader.color(&seen.hits[ray], ink);
                sum = [sum[0] + r * alpha, sum[1] + g * alpha, sum[2] + b * alpha, sum[3] + alpha];
            }
            let straight = |sum_of: f32| if sum[3] > 0.0 { 255.0 * sum_of / sum[3] } else { 0.0 };
            let count = (per_texel * per_texel) as f32;
            let [r, g, b] = [sum[0], sum[1], sum[2]].map(straight);
            // The grain of paper is one value a texel, the same for all cells in the texel.
            let paper = shader.paper(x, y);
            texels.push(
                [r * paper, g * paper, b * paper, 255.0 * sum[3] / count]
                    .map(|channel| channel.min(255.0)),
            );
        }
    }
    Some(texels)
}

struct Shader<'a> {
    ready: &'a PreparedRelief,
    lit: &'a FieldLight,
    /// Direction half way between the sun and the eye, of length 1.
    half: [f32; 3],
    /// Light of lit windows, linear.
    glow: [f32; 3],
    ink: [f32; 3],
    /// Luminance of a white surface in the sun and under the sky.
    white: f32,
}

impl<'a> Shader<'a> {
    fn new(ready: &'a PreparedRelief, lit: &'a FieldLight, view: [f32; 3]) -> Self {
        let relief = &ready.relief;
        let sum: [f32; 3] = std::array::from_fn(|i| lit.toward[i] + view[i]);
        let length = sum.iter().map(|part| part * part).sum::<f32>().sqrt().max(1e-6);
        let glow = match &relief.pattern {
            Pattern::Facade { lit_color, .. } => {
                linear(*lit_color).map(|channel| channel * lit.lowness)
            }
            _ => [0.0; 3],
        };
        let white = (relief.light.sun_amount + relief.light.sky_amount) as f32;
        Self {
            ready,
            lit,
            half: sum.map(|part| part / length),
            glow,
            ink: relief.finish.ink_color.map(|byte| f32::from(byte) / 255.0),
            white: white.max(1e-3),
        }
    }

    /// The display color at a place, and its alpha.
    fn color(&self, hit: &FieldHit, ink: u8) -> ([f32; 3], f32) {
        let (field, lit, relief) = (&self.ready.field, self.lit, &self.ready.relief);
        let cell = hit.cell as usize;
        let material = &field.materials[cell];
        let normal = field.normal(cell);
        let cosine = dot(normal, lit.toward).max(0.0);
        let visible =
            if cosine > 0.0 { lit.visible_at(&relief.light, field, cell, hit.place) } else { 0.0 };
        let direct = cosine * visible;
        let light: [f32; 3] = std::array::from_fn(|i| lit.sun[i] * direct + lit.ambient[cell][i]);
        let (light, brightness) = self.in_bands(light);
        let shine = if direct > 0.0 {
            visible * self.glint(normal, material.gloss, material.grain)
        } else {
            0.0
        };
        let glow = material.glow;
        let shown = std::array::from_fn(|i| {
            shown(material.color[i] * light[i] + shine * lit.sun[i] + glow * self.glow[i])
        });
        let finish = &relief.finish;
        let lines = if finish.hatch > 0.0 {
            self.hatching(hit, brightness.max(glow * lit.lowness))
        } else {
            0.0
        };
        let pen = (finish.ink as f32 * f32::from(ink) / 255.0).max(finish.hatch as f32 * lines);
        (mix3(shown, self.ink, pen), material.alpha)
    }

    /// The light in steps, and its brightness to the eye, as a share of the full light.
    fn in_bands(&self, light: [f32; 3]) -> ([f32; 3], f32) {
        let luminance = dot(light, [0.2126, 0.7152, 0.0722]);
        let brightness = shown(luminance / self.white);
        let bands = self.ready.relief.finish.bands;
        if bands == 0 || luminance <= 1e-6 {
            return (light, brightness);
        }
        let at = brightness * bands as f32;
        // A short ramp between two steps makes edges smooth.
        let stepped =
            (at.floor() + ramp(0.85, 1.0, at - at.floor())).min(bands as f32) / bands as f32;
        let stepped = mix(0.5 / bands as f32, 1.0, stepped);
        let factor = decode(stepped) * self.white / luminance;
        (light.map(|channel| channel * factor), stepped)
    }

    /// The share of the sun that is mirrored to the eye.
    fn glint(&self, normal: [f32; 3], gloss: f32, grain: u32) -> f32 {
        let glint = &self.ready.relief.glint;
        if glint.amount <= 0.0 || gloss <= 0.0 {
            return 0.0;
        }
        let [there, x, y] =
            chances(hash(self.ready.relief.seed.wrapping_add(80), i64::from(grain), 0));
        if there >= glint.share as f32 {
            return 0.0;
        }
        let lean = glint.lean as f32;
        let leaning =
            [normal[0] + lean * (2.0 * x - 1.0), normal[1] + lean * (2.0 * y - 1.0), normal[2]];
        let length = dot(leaning, leaning).sqrt().max(1e-6);
        let mirrored = (dot(leaning, self.half) / length).max(0.0).powf(glint.sharpness as f32);
        glint.amount as f32 * gloss * mirrored
    }

    /// The amount of hatching at a place: lines that grow with the dark, and a second set across
    /// them in the darkest.
    fn hatching(&self, hit: &FieldHit, brightness: f32) -> f32 {
        let relief = &self.ready.relief;
        let [width, height] = self.ready.field.size.map(|side| side as f32);
        let place = [hit.place[0] / width, hit.place[1] / height];
        let lines = relief.finish.hatch_lines as f32;
        let down = ((5.0 * height / width).round() as u32).max(1);
        let wrapped = place.map(|at| at - at.floor());
        let hand = rough(relief.seed.wrapping_add(90), [5, down], 3, wrapped) - 0.5;
        let dark = 1.0 - brightness;
        let line = |phase: f32, dark: f32| {
            let off = (phase - phase.floor() - 0.5).abs() * 2.0;
            let width = (0.9 * dark).clamp(0.0, 0.85);
            let soft = 2.0 * lines / width.max(1.0) * 0.02 + 0.12;
            if dark <= 0.02 { 0.0 } else { 1.0 - ramp(width - soft, width + soft, off) }
        };
        // Whole numbers of lines along both sides make the lines go on in the next tile.
        let tall = (lines * height / width).round().max(1.0);
        let first = line(lines * place[0] + tall * place[1] + 0.7 * hand, dark - 0.3);
        let second = line(lines * place[0] - tall * place[1] + 0.7 * hand, 1.3 * (dark - 0.62));
        first.max(second)
    }

    /// The brightness of the paper at a texel.
    fn paper(&self, x: usize, y: usize) -> f32 {
        let relief = &self.ready.relief;
        if relief.finish.grain <= 0.0 {
            return 1.0;
        }
        let [width, height] = self.ready.grid.size;
        let place = [(x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32];
        let bumps = [width.div_ceil(3), height.div_ceil(3)];
        let noise = rough(relief.seed.wrapping_add(95), bumps, 2, place);
        1.0 + relief.finish.grain as f32 * (noise - 0.6)
    }
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Number of steps in the table of [`shown`].
const STEPS: usize = 1024;

/// [`encode`] up to 1, from a table over the root of the light, along which the curve is nearly
/// straight.
fn shown(linear: f32) -> f32 {
    static TABLE: OnceLock<Vec<f32>> = OnceLock::new();
    let entry = |step: usize| encode((step as f32 / STEPS as f32).powi(2));
    let table = TABLE.get_or_init(|| (0..=STEPS + 1).map(entry).collect());
    let at = linear.clamp(0.0, 1.0).sqrt() * STEPS as f32;
    let step = at as usize;
    table[step] + (table[step + 1] - table[step]) * (at - step as f32)
}

/// Encodes linear light by the sRGB curve (IEC 61966-2-1).
fn encode(linear: f32) -> f32 {
    if linear <= 0.003_130_8 {
        12.92 * linear.max(0.0)
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

fn decode(shown: f32) -> f32 {
    if shown <= 0.040_45 { shown / 12.92 } else { ((shown + 0.055) / 1.055).powf(2.4) }
}
