//! Divider between two pictures in one place, and names of pictures.

use chiaro_locale::tr;
use eframe::egui::{
    Align2, Color32, CursorIcon, FontId, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use crate::widgets::theme;

/// Half of the width within which the divider can be grabbed, in points.
const REACH: f32 = 6.0;
/// Distance of a name from the edges of the picture, in points.
const MARGIN: f32 = 8.0;

/// Upper corner of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Corner {
    Left,
    Right,
}

/// Moves the divider, at a part of the width, as it is dragged; true while the pointer is at it.
pub(crate) fn drag(ui: &Ui, rect: Rect, split: &mut f32) -> bool {
    let x = rect.left() + *split * rect.width();
    let grip = Rect::from_x_y_ranges(x - REACH..=x + REACH, rect.y_range());
    let response = ui.interact(grip, ui.scope_id().with("divider"), Sense::drag());
    let response = response.on_hover_cursor(CursorIcon::ResizeHorizontal);
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, tr!("Divider")));
    if response.dragged()
        && let Some(at) = response.interact_pointer_pos()
    {
        *split = ((at.x - rect.left()) / rect.width().max(1.0)).clamp(0.0, 1.0);
    }
    response.hovered() || response.dragged()
}

/// Both sides of the divider.
pub(crate) fn halves(rect: Rect, split: f32) -> [Rect; 2] {
    let x = rect.left() + split * rect.width();
    [
        Rect::from_min_max(rect.min, pos2(x, rect.bottom())),
        Rect::from_min_max(pos2(x, rect.top()), rect.max),
    ]
}

/// Draws the divider.
pub(crate) fn paint(ui: &Ui, rect: Rect, split: f32, is_hot: bool) {
    let painter = ui.painter_at(rect);
    let x = rect.left() + split * rect.width();
    let color = if is_hot { theme::of(ui).accent } else { Color32::WHITE };
    painter.vline(x, rect.y_range(), Stroke::new(3.0, Color32::from_black_alpha(110)));
    painter.vline(x, rect.y_range(), Stroke::new(1.0, color));
    painter.circle(pos2(x, rect.center().y), 5.0, theme::of(ui).panel, Stroke::new(1.5, color));
}

/// Writes the name of a picture into a corner.
pub(crate) fn tag(ui: &Ui, rect: Rect, corner: Corner, text: &str) {
    let (at, align) = match corner {
        Corner::Left => (rect.left_top() + vec2(MARGIN, MARGIN), Align2::LEFT_TOP),
        Corner::Right => (rect.right_top() + vec2(-MARGIN, MARGIN), Align2::RIGHT_TOP),
    };
    let galley = ui.painter().layout_no_wrap(
        text.to_owned(),
        FontId::proportional(theme::SMALL_TEXT),
        theme::of(ui).text,
    );
    let place = align.anchor_size(at, galley.size());
    ui.painter().rect_filled(place.expand2(vec2(5.0, 2.0)), 3.0, Color32::from_black_alpha(150));
    ui.painter().galley(place.min, galley, theme::of(ui).text);
}
