//! Controls of a tool over the top of the picture: a row above it would resize the picture, and
//! the places that were clicked would no longer be where they were.

use eframe::egui::{Frame, Margin, Rect, Sense, Ui, UiBuilder, Vec2, pos2, vec2};

use crate::state::session::Session;
use crate::widgets::theme;

/// Height of the notices over the top of the picture, below which the bar stands, in points.
const NOTICE: f32 = 36.0;

/// Shows the controls of a tool; presses beside them do not reach the picture.
pub(super) fn over_top(
    ui: &mut Ui,
    rect: Rect,
    salt: &str,
    session: &Session,
    controls: impl FnOnce(&mut Ui),
) {
    let id = ui.scope_id().with(salt);
    let scene = session.open_scene().map(|open_scene| open_scene.scene());
    let is_soloed = scene.is_some_and(|scene| !scene.soloed.is_none());
    let has_notice = is_soloed || session.view.wire.is_some() || !session.view.solo.is_empty();
    let top = rect.top() + 8.0 + if has_notice { NOTICE } else { 0.0 };
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
