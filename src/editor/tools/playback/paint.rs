//! Painting of pictures within a rectangle, as bright as the display is set.

use eframe::egui::{self, Color32, Painter, Rect, TextureId, Vec2};

use crate::widgets::rows::whole;

/// Exponent of a display's transfer function, approximately.
const DISPLAY_GAMMA: f32 = 2.2;

/// Place of a picture of some size within a rectangle: in the middle, as large as fits. One of the
/// rectangle's shape, but for the rounding to pixels, takes all of it.
pub(crate) fn fit(rect: Rect, size: Vec2) -> Rect {
    let scale = (rect.size() / size.max(Vec2::splat(1.0))).min_elem();
    let place = Rect::from_center_size(rect.center(), size * scale);
    let rest = rect.size() - place.size();
    if rest.max_elem() <= 1.0 { rect } else { place }
}

/// Shows a picture brighter or darker by `stops`. The texture stays as it is: it is drawn in part,
/// or several times, which a display's power law allows.
pub(crate) fn paint_exposed(painter: &Painter, texture: TextureId, rect: Rect, stops: f32) {
    let mut gain = (stops / DISPLAY_GAMMA).exp2();
    let first = egui::lerp(0.0..=255.0, gain.min(1.0)).round() as u8;
    painter.image(
        texture,
        rect,
        whole(),
        Color32::from_rgba_premultiplied(first, first, first, 255),
    );
    gain -= 1.0;
    while gain > 1.0 / 255.0 {
        // A color without alpha is added.
        let part = (gain.min(1.0) * 255.0).round() as u8;
        painter.image(
            texture,
            rect,
            whole(),
            Color32::from_rgba_premultiplied(part, part, part, 0),
        );
        gain -= 1.0;
    }
}
