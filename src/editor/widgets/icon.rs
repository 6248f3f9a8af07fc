//! Buttons with a drawing in place of a word, for rows that have no room for words.

use eframe::egui::{
    Painter, Pos2, Response, Role, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2,
};

use super::theme;

/// Width of a button, in points.
const WIDTH: f32 = 28.0;

/// Shows a button that is on or off and has a drawing around its middle, within 8 points of it;
/// `name` is for those who do not see it.
pub(crate) fn icon_toggle(
    ui: &mut Ui,
    is_on: bool,
    name: &str,
    draw: impl FnOnce(&Painter, Pos2, Stroke),
) -> Response {
    let size = vec2(WIDTH, ui.spacing().interact_size.y);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, is_on, name));
    let colors = theme::of(ui);
    let fill = match (is_on, response.hovered()) {
        (true, _) => colors.accent_dim,
        (false, true) => colors.field_hovered,
        (false, false) => colors.field,
    };
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, fill);
    if is_on || response.has_focus() {
        painter.rect_stroke(rect, 4.0, Stroke::new(1.0, colors.accent), StrokeKind::Inside);
    }
    draw(painter, rect.center(), Stroke::new(1.4, colors.text));
    response
}
