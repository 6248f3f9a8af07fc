//! Colors of the two themes, dark and light.

use eframe::egui::Color32;

use crate::accuracy::MeasuredTier;
use crate::document::Tier;
use crate::drawing::palette::{self, Palette};
use crate::library::Type;

/// All colors of the window but those of pictures.
#[derive(Debug)]
pub(crate) struct Colors {
    /// Ground of panels.
    pub(crate) panel: Color32,
    /// Ground of menus and other areas that float above panels.
    pub(crate) window: Color32,
    /// Edges of menus.
    pub(crate) window_edge: Color32,
    /// Ground of the canvas, pictures, curves and plots.
    pub(crate) canvas: Color32,
    /// Dots of the canvas's grid; thin lines between parts of a panel.
    pub(crate) grid: Color32,
    /// Body of a node.
    pub(crate) node: Color32,
    /// Edge of a node.
    pub(crate) node_edge: Color32,
    /// Edge around a color, so that a color like its ground is seen.
    pub(crate) swatch_edge: Color32,
    /// Plain text.
    pub(crate) text: Color32,
    /// Text of less weight: units, hints, line numbers.
    pub(crate) dim: Color32,
    /// Selection, and controls that act when pressed.
    pub(crate) accent: Color32,
    /// Accent behind text.
    pub(crate) accent_dim: Color32,
    /// Marks that differ from the accent: cached, exact.
    pub(crate) second: Color32,
    /// Marks that differ from both: balanced.
    pub(crate) third: Color32,
    /// Errors.
    pub(crate) error: Color32,
    /// Warnings.
    pub(crate) warning: Color32,
    /// Fields that are typed in or dragged.
    pub(crate) field: Color32,
    /// Fields under the pointer.
    pub(crate) field_hovered: Color32,
    /// Ground of text fields.
    pub(crate) well: Color32,
    /// Colors of code.
    pub(crate) code: CodeColors,
    graph: &'static Palette,
    hues: [Color32; 8],
}

/// Colors of WGSL.
#[derive(Debug)]
pub(crate) struct CodeColors {
    pub(crate) keyword: Color32,
    pub(crate) ty: Color32,
    pub(crate) number: Color32,
    pub(crate) comment: Color32,
    pub(crate) function: Color32,
    pub(crate) attribute: Color32,
}

impl Colors {
    /// Color of a type's sockets and wires.
    pub(crate) fn of_type(&self, ty: &Type) -> Color32 {
        rgb(self.graph.of_type(ty))
    }

    /// Color of a category's titles.
    pub(crate) fn of_category(&self, category: &str) -> Color32 {
        rgb(self.graph.of_category(category))
    }

    /// Color of a key, by its index, from a row of colors that can be told apart.
    pub(crate) fn hue(&self, index: usize) -> Color32 {
        self.hues[index % self.hues.len()]
    }

    /// Color of a tier's marks; for `None` that of plain text.
    pub(crate) fn of_tier(&self, tier: MeasuredTier) -> Color32 {
        match tier {
            MeasuredTier::Named(Tier::Exact) => self.second,
            MeasuredTier::Named(Tier::Balanced) => self.third,
            MeasuredTier::Named(Tier::Fast) => self.accent,
            MeasuredTier::Automatic => self.text,
            MeasuredTier::AsSet => self.dim,
        }
    }
}

const fn rgb(hex: u32) -> Color32 {
    Color32::from_rgb((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

/// Dark rim that tells marks on a picture from it, in both themes alike.
pub(crate) const HALO: Color32 = Color32::from_black_alpha(130);
/// Ground of text on a picture.
pub(crate) const PLATE: Color32 = Color32::from_black_alpha(165);
/// Mark of the middle of a lit area, on a picture.
pub(crate) const SUN: Color32 = rgb(0xfff3c4);
/// Colors of the axes x, y and z on a picture.
pub(crate) const AXES: [Color32; 3] = [rgb(0xf0716b), rgb(0x9ccc65), rgb(0x6f9bff)];
/// Colors of offset, fall-off and cut-off on a picture.
const CURVES: [Color32; 3] = [rgb(0xffb347), rgb(0x6f9bff), rgb(0x6ee08a)];

/// Color of a layer's offset, fall-off or cut-off (0, 1, 2) on a picture.
pub(crate) fn curve(index: usize) -> Color32 {
    CURVES[index.min(CURVES.len() - 1)]
}

/// Dark theme: a calm dark ground with one warm accent.
pub(super) static DARK: Colors = Colors {
    panel: rgb(0x222327),
    window: rgb(0x27282d),
    window_edge: rgb(0x3e4046),
    canvas: rgb(palette::DARK.canvas),
    grid: rgb(0x2d2f34),
    node: rgb(palette::DARK.node),
    node_edge: rgb(palette::DARK.node_edge),
    swatch_edge: rgb(palette::DARK.swatch_edge),
    text: rgb(palette::DARK.text),
    dim: rgb(palette::DARK.dim),
    accent: rgb(0xeca454),
    accent_dim: rgb(0x5c442a),
    second: rgb(0x7c92e8),
    third: rgb(0x7ebc8c),
    error: rgb(0xf06258),
    warning: rgb(0xe9c45c),
    field: rgb(0x323439),
    field_hovered: rgb(0x3e4046),
    well: rgb(0x1a1b1e),
    code: CodeColors {
        keyword: rgb(0xd68eb2),
        ty: rgb(0x70bcb4),
        number: rgb(0xb0c480),
        comment: rgb(0x787c82),
        function: rgb(0xe8c484),
        attribute: rgb(0xa096d2),
    },
    graph: &palette::DARK,
    hues: [
        rgb(0xeca454),
        rgb(0x6fa8ec),
        rgb(0x8cc46c),
        rgb(0xd884c4),
        rgb(0x5cc4bc),
        rgb(0xe87c6c),
        rgb(0xd4cc5c),
        rgb(0xa890ec),
    ],
};

/// Light theme: paper, with the same accent in a darker ink.
pub(super) static LIGHT: Colors = Colors {
    panel: rgb(0xf0eeea),
    window: rgb(0xf8f7f4),
    window_edge: rgb(0xc6c1b8),
    canvas: rgb(palette::LIGHT.canvas),
    grid: rgb(0xcfcbc3),
    node: rgb(palette::LIGHT.node),
    node_edge: rgb(palette::LIGHT.node_edge),
    swatch_edge: rgb(palette::LIGHT.swatch_edge),
    text: rgb(palette::LIGHT.text),
    dim: rgb(palette::LIGHT.dim),
    accent: rgb(0xa9530c),
    accent_dim: rgb(0xf3d2ae),
    second: rgb(0x3a53b8),
    third: rgb(0x2f7443),
    error: rgb(0xbb3024),
    warning: rgb(0x7f5f00),
    field: rgb(0xe1ded8),
    field_hovered: rgb(0xd5d1c9),
    well: rgb(0xfdfcfb),
    code: CodeColors {
        keyword: rgb(0x9c2c63),
        ty: rgb(0x1d6f67),
        number: rgb(0x50691a),
        comment: rgb(0x77746c),
        function: rgb(0x87560a),
        attribute: rgb(0x5a4aa6),
    },
    graph: &palette::LIGHT,
    hues: [
        rgb(0xb45c0c),
        rgb(0x2464b4),
        rgb(0x3c7c24),
        rgb(0xa43c8c),
        rgb(0x107c74),
        rgb(0xb83c2c),
        rgb(0x7c6c00),
        rgb(0x6c4cc4),
    ],
};

#[cfg(test)]
mod tests {
    use super::*;

    fn luminance(color: Color32) -> f64 {
        let [r, g, b] = [color.r(), color.g(), color.b()]
            .map(|c| crate::document::srgb_to_linear(f64::from(c) / 255.0));
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    fn contrast(a: Color32, b: Color32) -> f64 {
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        a.max(b) / a.min(b)
    }

    /// Contrast of text as WCAG demands of small text, and of marks as WCAG demands of graphics.
    #[test]
    fn everything_is_legible_on_its_ground() {
        for (name, colors) in [("dark", &DARK), ("light", &LIGHT)] {
            let code = &colors.code;
            let inks = [
                colors.text,
                colors.dim,
                colors.accent,
                colors.second,
                colors.third,
                colors.error,
                colors.warning,
            ];
            let code = [code.keyword, code.ty, code.number, code.function, code.attribute];
            for (index, ink) in inks.into_iter().chain(code).enumerate() {
                let found = contrast(ink, colors.panel);
                assert!(found >= 4.5, "{name}, ink {index} on a panel: {found:.2}");
            }
            for (index, ground) in
                [colors.node, colors.field, colors.accent_dim, colors.well].into_iter().enumerate()
            {
                assert!(contrast(colors.text, ground) >= 4.5, "{name}, text on ground {index}");
            }
            for ground in colors.graph.categories().iter().copied().map(rgb) {
                assert!(contrast(colors.text, ground) >= 4.5, "{name}, a title on {ground:?}");
            }
            for (index, hue) in colors.hues.into_iter().enumerate() {
                let found = contrast(hue, colors.canvas).min(contrast(hue, colors.panel));
                assert!(found >= 3.0, "{name}, hue {index}: {found:.2}");
            }
            for (index, ink) in colors.graph.types().into_iter().map(rgb).enumerate() {
                let found = contrast(ink, colors.node).min(contrast(ink, colors.canvas));
                assert!(found >= 2.6, "{name}, type {index}: {found:.2}");
            }
        }
    }
}
