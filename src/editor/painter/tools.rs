//! Settings of painting: the tool, its brush, two colors and the symmetry.

use std::sync::Arc;

use crate::commands::PaintTool;
use crate::document::Tile;
use crate::hcbtf::paint::{Brush, Flood, Pressure, Symmetry, Tool};

/// Largest brush, in texels.
pub(super) const LARGEST: f64 = 512.0;

/// Colors of the palette: grays, earths, greens, blues, and bright colors.
pub(super) const PALETTE: [[u8; 3]; 20] = [
    [0x14, 0x12, 0x18],
    [0x4a, 0x48, 0x50],
    [0x8c, 0x8a, 0x90],
    [0xf4, 0xf0, 0xe8],
    [0x4a, 0x2c, 0x20],
    [0x8a, 0x4b, 0x2e],
    [0xb9, 0x6b, 0x3c],
    [0xe3, 0xb7, 0x7d],
    [0x1f, 0x3d, 0x24],
    [0x3f, 0x7a, 0x34],
    [0x8f, 0xb3, 0x4a],
    [0xdc, 0xe3, 0x8a],
    [0x16, 0x2a, 0x4f],
    [0x2f, 0x5f, 0xa8],
    [0x6f, 0xa8, 0xdc],
    [0xc6, 0xe4, 0xf2],
    [0x8e, 0x1b, 0x2c],
    [0xd9, 0x3a, 0x2f],
    [0xf2, 0xa0, 0x2c],
    [0xf7, 0xdb, 0x4b],
];

/// Settings of painting.
#[derive(Clone, Debug)]
pub(super) struct Tools {
    pub(super) kind: PaintTool,
    /// Tool to return to after a color was picked.
    before: PaintTool,
    /// Diameter of the brush, in texels.
    pub(super) size: f64,
    pub(super) hardness: f64,
    pub(super) opacity: f64,
    pub(super) flow: f64,
    pub(super) pressure: Pressure,
    /// Pressure of the pen, 0 to 1; `None` while no pen is down.
    pub(super) pen: Option<f64>,
    /// Current color and the other one.
    pub(super) colors: [[u8; 4]; 2],
    pub(super) symmetry: Symmetry,
    /// Largest difference of a color from the one clicked at which a fill covers it, 0 to 1.
    pub(super) tolerance: f64,
    /// Distance that a fill goes under soft edges, in texels.
    pub(super) edge: u32,
    /// Tile that the stamp lays down.
    pub(super) stamp: Option<Arc<Tile>>,
}

impl Default for Tools {
    fn default() -> Self {
        Self {
            kind: PaintTool::Paint,
            before: PaintTool::Paint,
            size: 4.0,
            hardness: 0.8,
            opacity: 1.0,
            flow: 1.0,
            pressure: Pressure::None,
            pen: None,
            colors: [[0xb9, 0x6b, 0x3c, 255], [0xf4, 0xf0, 0xe8, 255]],
            symmetry: Symmetry::default(),
            tolerance: 0.1,
            edge: Flood::EDGE,
            stamp: None,
        }
    }
}

impl Tools {
    /// Takes another tool.
    pub(super) fn take(&mut self, kind: PaintTool) {
        if kind == PaintTool::Pick && self.kind != PaintTool::Pick {
            self.before = self.kind;
        }
        self.kind = kind;
    }

    /// Takes a picked color, and returns to the tool from before.
    pub(super) fn picked(&mut self, color: [u8; 4]) {
        if color[3] > 0 {
            self.colors[0] = color;
        }
        if self.kind == PaintTool::Pick {
            self.kind = self.before;
        }
    }

    /// Makes the brush larger or smaller, by a step that suits its size.
    pub(super) fn resize(&mut self, is_larger: bool) {
        let step = if self.size < 10.0 { 1.0 } else { (self.size * 0.15).round() };
        self.size = (self.size + if is_larger { step } else { -step }).clamp(1.0, LARGEST);
    }

    /// Makes the current color brighter or darker; its hue stays.
    pub(super) fn change_value(&mut self, by: f32) {
        let [r, g, b, a] = self.colors[0];
        let mut hsva = eframe::egui::ecolor::Hsva::from_srgb([r, g, b]);
        hsva.v = (hsva.v + by).clamp(0.0, 1.0);
        let [r, g, b] = hsva.to_srgb();
        self.colors[0] = [r, g, b, a];
    }

    /// Brush for a stroke; the stamp tool without a tile paints.
    pub(super) fn brush(&self) -> Brush {
        let tool = match (self.kind, &self.stamp) {
            (PaintTool::Erase, _) => Tool::Erase,
            (PaintTool::Smudge, _) => Tool::Smudge,
            (PaintTool::Stamp, Some(tile)) => Tool::Stamp(tile.clone()),
            _ => Tool::Paint,
        };
        // Stamps are laid beside each other, not over each other.
        let spacing = if matches!(tool, Tool::Stamp(_)) { 1.0 } else { Brush::default().spacing };
        Brush {
            tool,
            size: self.size,
            hardness: self.hardness,
            opacity: self.opacity,
            flow: self.flow,
            spacing,
            color: self.colors[0],
            pressure: self.pressure,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn value_goes_and_the_hue_stays() {
        let mut tools = Tools { colors: [[200, 100, 50, 255], [0; 4]], ..Tools::default() };
        tools.change_value(-0.3);
        let [r, g, b, a] = tools.colors[0];
        assert!(r < 200 && g < 100 && b < 50 && a == 255);
        tools.change_value(0.3);
        let near = |x: u8, y: u8| x.abs_diff(y) <= 2;
        let [r, g, b, _] = tools.colors[0];
        assert!(near(r, 200) && near(g, 100) && near(b, 50), "{r} {g} {b}");
    }

    #[test]
    fn picking_gives_the_tool_back() {
        let mut tools = Tools::default();
        tools.take(PaintTool::Smudge);
        tools.take(PaintTool::Pick);
        tools.picked([1, 2, 3, 255]);
        assert_eq!((tools.kind, tools.colors[0]), (PaintTool::Smudge, [1, 2, 3, 255]));
        tools.picked([9, 9, 9, 0]);
        assert_eq!(tools.colors[0], [1, 2, 3, 255], "nothing is no color");
    }
}
