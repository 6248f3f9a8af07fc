//! Display of the picture in the window: exposure, and a reference image over it or beside it.

use eframe::egui::{Color32, Rect, TextureHandle, Ui, Vec2, vec2};

use crate::widgets::rows::whole;
use crate::widgets::theme;

/// Largest exposure up and down, in stops.
pub(super) const MOST_STOPS: f32 = 4.0;

/// Place of a reference image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ReferencePlacement {
    /// Left of the picture, at the same size.
    Beside,
    /// Over the picture, translucent.
    Over,
}

/// Reference image to work from.
pub(super) struct ReferenceImage {
    pub(super) name: String,
    pub(super) texture: TextureHandle,
    pub(super) place: ReferencePlacement,
    pub(super) opacity: f32,
}

impl ReferenceImage {
    /// Splits the available area: the picture's part, and the part of an image beside it.
    pub(super) fn split(&self, room: Rect) -> (Rect, Option<Rect>) {
        match self.place {
            ReferencePlacement::Over => (room, None),
            ReferencePlacement::Beside => {
                let (left, right) = room.split_left_right_at_fraction(0.5);
                (right, Some(left))
            }
        }
    }

    /// Shows the whole image, centered in `rect`.
    pub(super) fn paint(&self, ui: &Ui, rect: Rect) {
        let size = self.texture.size_vec2();
        let scale = (rect.size() / size.max(Vec2::splat(1.0))).min_elem();
        let opacity = if self.place == ReferencePlacement::Over { self.opacity } else { 1.0 };
        let at = Rect::from_center_size(rect.center(), size * scale);
        ui.painter_at(rect).image(
            self.texture.id(),
            at,
            whole(),
            Color32::WHITE.gamma_multiply(opacity),
        );
    }

    pub(super) fn paint_beside(&self, ui: &Ui, rect: Rect) {
        ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
        self.paint(ui, rect.shrink2(vec2(2.0, 2.0)));
    }
}
