//! Controls of a tool over the top of the picture: a row above it would resize the picture, and
//! the places that were clicked would no longer be where they were.

use eframe::egui::{Context, Frame, Id, Margin, Rect, Sense, Ui, UiBuilder, Vec2, pos2, vec2};

use crate::widgets::theme;

/// Distance of the bar from the notices, or from the edge of the picture, in points.
const GAP: f32 = 8.0;

/// Key of the height of the notices.
fn height_id() -> Id {
    Id::unique("height of the notices over the picture")
}

/// Tells tools how high the notices over the top of the picture are, in points, so that bars stand
/// below them from the next frame on; 0 for none.
pub(crate) fn stand_below(context: &Context, height: f32) {
    let before: f32 = context.data(|data| data.get_temp(height_id())).unwrap_or_default();
    if (before - height).abs() > 0.5 {
        context.data_mut(|data| data.insert_temp(height_id(), height));
        context.request_repaint();
    }
}

/// Top of a tool's bar over a picture.
fn top_of(context: &Context, rect: Rect) -> f32 {
    let notices: f32 = context.data(|data| data.get_temp(height_id())).unwrap_or_default();
    rect.top() + GAP + if notices > 0.0 { notices + GAP } else { 0.0 }
}

/// Shows the controls of a tool; presses beside them do not reach the picture.
pub(super) fn over_top(ui: &mut Ui, rect: Rect, salt: &str, controls: impl FnOnce(&mut Ui)) {
    let id = ui.scope_id().with(salt);
    let top = top_of(ui.ctx(), rect);
    let room = Rect::from_min_max(pos2(rect.left() + 8.0, top), rect.max - vec2(8.0, 8.0));
    // The size is that of the frame before.
    let known: Option<Vec2> = ui.data(|data| data.get_temp(id));
    let size = known.unwrap_or(vec2(room.width(), 30.0));
    ui.interact(Rect::from_min_size(room.min, size), id, Sense::click_and_drag());
    let frame = Frame::new()
        .fill(theme::of(ui).panel.gamma_multiply(0.92))
        .corner_radius(4.0)
        .inner_margin(Margin::symmetric(8, 4));
    let builder = UiBuilder::new().id_salt(salt).max_rect(room);
    let shown = ui.scope_builder(builder, |ui| {
        frame.show(ui, |ui| ui.horizontal_wrapped(controls)).response.rect.size()
    });
    ui.data_mut(|data| data.insert_temp(id, shown.inner));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_stand_below_the_notices_of_any_height() {
        let (context, rect) =
            (Context::default(), Rect::from_min_size(pos2(10.0, 20.0), Vec2::ZERO));
        assert_eq!(top_of(&context, rect), 28.0);
        stand_below(&context, 62.0);
        assert_eq!(top_of(&context, rect), 28.0 + 62.0 + 8.0, "two notices");
        stand_below(&context, 0.0);
        assert_eq!(top_of(&context, rect), 28.0);
    }
}
