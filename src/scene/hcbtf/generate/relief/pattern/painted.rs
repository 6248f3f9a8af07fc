//! Pattern of a relief from painted samples.

use super::{CellMaterial, linear};
use crate::document::Tile;
use crate::document::relief::Channel;

/// Heights and colors from painted samples.
pub(in crate::hcbtf::generate::relief) struct PaintedPattern<'a> {
    size: [u32; 2],
    heights: Vec<f32>,
    colors: &'a Tile,
    is_opaque: bool,
}

impl<'a> PaintedPattern<'a> {
    pub(super) fn new(
        heights: &Tile,
        channel: Channel,
        is_inverted: bool,
        colors: &'a Tile,
    ) -> Self {
        let height = |texel: &[u8]| {
            let height = match (channel, texel) {
                (Channel::Luminance, [r, g, b, ..]) => {
                    0.2126 * f32::from(*r) + 0.7152 * f32::from(*g) + 0.0722 * f32::from(*b)
                }
                (Channel::Alpha, [.., a]) => f32::from(*a),
                _ => 0.0,
            };
            if is_inverted { 1.0 - height / 255.0 } else { height / 255.0 }
        };
        let heights_of = heights.bytes().chunks_exact(4).map(height).collect();
        Self {
            size: heights.size(),
            heights: heights_of,
            colors,
            is_opaque: channel == Channel::Alpha,
        }
    }

    /// The height at a position: bilinear between the middles of texels.
    pub(super) fn height(&self, place: [f32; 2]) -> f32 {
        let [(x, fx), (y, fy)] = [0, 1].map(|axis| {
            let at = place[axis] * self.size[axis] as f32 - 0.5;
            (at.floor() as i64, at - at.floor())
        });
        let [width, height] = self.size.map(i64::from);
        let texel = |dx: i64, dy: i64| {
            let (x, y) = ((x + dx).rem_euclid(width), (y + dy).rem_euclid(height));
            self.heights[(y * width + x) as usize]
        };
        let row = |dy| texel(0, dy) + (texel(1, dy) - texel(0, dy)) * fx;
        row(0) + (row(1) - row(0)) * fy
    }

    /// The material of the texel at a position.
    pub(super) fn material(&self, place: [f32; 2]) -> CellMaterial {
        let [width, height] = self.colors.size().map(|side| side as f32);
        let (x, y) = ((place[0] * width).floor() as i64, (place[1] * height).floor() as i64);
        let [r, g, b, a] = self.colors.texel(x, y);
        let alpha = if self.is_opaque { 1.0 } else { f32::from(a) / 255.0 };
        let grain = (y * self.size[0] as i64 + x) as u32;
        CellMaterial { alpha, grain, ..CellMaterial::of(linear([r, g, b])) }
    }
}
