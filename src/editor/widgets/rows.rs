//! Small controls that several panels share: buttons with icons, names that are changed in place,
//! grounds of rows.

use eframe::egui;
use eframe::egui::{
    Color32, Key, Modifiers, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, TextEdit,
    Ui, WidgetInfo, pos2, vec2,
};

use crate::commands::{Command, keyboard};
use crate::widgets::theme;

/// Side of an icon's button, in points.
pub(crate) const ICON: f32 = 22.0;

/// Icon of a button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Icon {
    /// An eye: seen, or with a stroke through it hidden.
    Eye,
    /// A bulb: shining, or with a stroke through it out.
    Bulb,
    /// The letter S, known to everybody who mixes sound or light: alone.
    Solo,
    /// A round hole in a sheet, as paint programs have it: a mask.
    Mask,
    /// Three dots: there is more.
    More,
    /// A triangle that points down: what lies in it is listed.
    Opened,
    /// A triangle that points right: what lies in it is not listed.
    Closed,
}

/// Shows a button with an icon. `is_on` is the state that the icon shows: seen, shining, alone.
pub(crate) fn icon(ui: &mut Ui, icon: Icon, is_on: bool, label: &str, help: &str) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(ICON, ICON), Sense::click());
    let is_toggle = matches!(icon, Icon::Eye | Icon::Bulb | Icon::Solo);
    response.widget_info(|| match is_toggle {
        true => WidgetInfo::selected(Role::CheckBox, true, is_on, label),
        false => WidgetInfo::labeled(Role::Button, true, label),
    });
    let colors = theme::of(ui);
    let is_alone = icon == Icon::Solo && is_on;
    let ink = match (is_on, response.hovered() || response.has_focus()) {
        _ if is_alone => colors.panel,
        (_, true) => colors.text,
        (true, false) if icon != Icon::Solo => colors.text,
        _ => colors.dim,
    };
    if is_alone {
        ui.painter().rect_filled(rect.shrink(2.0), 4.0, colors.accent);
    } else if response.hovered() {
        ui.painter().rect_filled(rect.shrink(1.0), 4.0, colors.field_hovered);
    }
    if response.has_focus() {
        ui.painter().rect_stroke(
            rect.shrink(1.0),
            4.0,
            Stroke::new(1.0, colors.accent),
            egui::StrokeKind::Inside,
        );
    }
    draw(ui.painter(), icon, rect.center(), ink, is_on);
    response.on_hover_text(help)
}

/// Paints an icon.
pub(crate) fn draw(painter: &Painter, icon: Icon, at: Pos2, ink: Color32, is_on: bool) {
    let stroke = Stroke::new(1.4, ink);
    match icon {
        Icon::Eye => {
            let lid = |side: f32| {
                let of = |step: u8| {
                    let t = f32::from(step) / 8.0 * 2.0 - 1.0;
                    at + vec2(t * 7.0, side * 4.4 * (1.0 - t * t))
                };
                Shape::line((0..=8).map(of).collect(), stroke)
            };
            painter.add(lid(-1.0));
            painter.add(lid(1.0));
            painter.circle_filled(at, 2.2, ink);
        }
        Icon::Bulb => {
            painter.circle_stroke(at - vec2(0.0, 1.5), 4.4, stroke);
            painter.line_segment([at + vec2(-2.0, 4.6), at + vec2(2.0, 4.6)], stroke);
            painter.line_segment([at + vec2(-1.4, 6.8), at + vec2(1.4, 6.8)], stroke);
        }
        Icon::Solo => {
            let font = egui::FontId::proportional(theme::TEXT_SIZE);
            painter.text(at, egui::Align2::CENTER_CENTER, "S", font, ink);
        }
        Icon::Mask => {
            let sheet = Rect::from_center_size(at, vec2(15.0, 11.0));
            painter.rect_stroke(sheet, 2.0, stroke, egui::StrokeKind::Inside);
            painter.circle_filled(at, 3.2, ink);
        }
        Icon::Opened | Icon::Closed => {
            let corners = [vec2(-4.5, -2.5), vec2(4.5, -2.5), vec2(0.0, 4.0)];
            let turned = |corner: egui::Vec2| match icon {
                Icon::Closed => at + vec2(corner.y, corner.x),
                _ => at + corner,
            };
            painter.add(Shape::convex_polygon(corners.map(turned).to_vec(), ink, Stroke::NONE));
        }
        Icon::More => {
            for x in [-4.5, 0.0, 4.5] {
                painter.circle_filled(at + vec2(x, 0.0), 1.5, ink);
            }
        }
    }
    if !is_on && matches!(icon, Icon::Eye | Icon::Bulb) {
        painter.line_segment([at + vec2(-6.5, 6.5), at + vec2(6.5, -6.5)], stroke);
    }
}

/// A name that is being changed.
#[derive(Clone, Debug)]
pub(crate) struct NameEdit<I> {
    pub(crate) id: I,
    text: String,
    is_new: bool,
}

impl<I> NameEdit<I> {
    pub(crate) fn new(id: I, name: &str) -> Self {
        Self { id, text: name.to_owned(), is_new: true }
    }

    /// Shows a field in place of the name. Returns the new name, or `Some(None)` when the change is
    /// given up.
    pub(crate) fn show(&mut self, ui: &mut Ui, hint: &str, label: &str) -> Option<Option<String>> {
        let edit = TextEdit::singleline(&mut self.text)
            .hint_text(hint)
            .desired_width(f32::INFINITY)
            .char_limit(80);
        let response = ui.add(edit.margin(vec2(4.0, 1.0)));
        let field = response.id;
        response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, label));
        if std::mem::take(&mut self.is_new) {
            response.request_focus();
            let all = egui::text::CCursorRange::select_all(&ui.fonts_mut(|fonts| {
                fonts.layout_no_wrap(
                    self.text.clone(),
                    egui::FontId::proportional(theme::TEXT_SIZE),
                    Color32::WHITE,
                )
            }));
            let mut state = TextEdit::load_state(ui.ctx(), field).unwrap_or_default();
            state.cursor.set_char_range(Some(all));
            state.store(ui.ctx(), field);
        }
        if !response.lost_focus() {
            return None;
        }
        Some(leaves_with_text(ui).then(|| self.text.trim().to_owned()))
    }
}

/// True if a field that lost the keyboard in this frame was left with its text, and not given up by
/// Escape.
pub(crate) fn leaves_with_text(ui: &Ui) -> bool {
    !keyboard::is_escape_pressed(ui.ctx())
}

/// Takes the keys of undo and redo for a row that has the keyboard, as the window leaves keys to
/// the focus.
pub(crate) fn undo_keys(ui: &Ui, out: &mut Vec<Command>) {
    let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
    if pressed(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z) || pressed(Modifiers::COMMAND, Key::Y)
    {
        out.push(Command::Redo);
    } else if pressed(Modifiers::COMMAND, Key::Z) {
        out.push(Command::Undo);
    }
}

/// Gives a row's keyboard back when the pointer goes on to another panel, so that keys work there
/// without a click.
pub(crate) fn leave_with_pointer(ui: &Ui, response: &Response) {
    let goes_elsewhere = ui.input(|input| {
        let at = input.pointer.latest_pos();
        input.pointer.delta() != egui::Vec2::ZERO
            && at.is_some_and(|at| !ui.clip_rect().contains(at))
    });
    if goes_elsewhere && response.has_focus() {
        response.surrender_focus();
    }
}

/// Paints the ground of a row: selected, under the pointer, or with the keyboard.
pub(crate) fn row_ground(ui: &Ui, rect: Rect, response: &Response, is_selected: bool) {
    let colors = theme::of(ui);
    if is_selected {
        ui.painter().rect_filled(rect, 4.0, colors.accent_dim);
    } else if response.hovered() {
        ui.painter().rect_filled(rect, 4.0, colors.field);
    }
    if response.has_focus() {
        ui.painter().rect_stroke(
            rect,
            4.0,
            Stroke::new(1.0, colors.accent),
            egui::StrokeKind::Inside,
        );
    }
}

/// Paints the ground of a row that has fields of its own, which must be seen on it: selected, with
/// a bar at its left in place of a fill.
pub(crate) fn card_ground(ui: &Ui, rect: Rect, response: &Response, is_selected: bool) {
    let colors = theme::of(ui);
    if is_selected || response.hovered() {
        ui.painter().rect_filled(rect, 4.0, colors.node);
    }
    if is_selected {
        ui.painter().rect_filled(
            Rect::from_min_size(rect.min, vec2(3.0, rect.height())),
            1.5,
            colors.accent,
        );
    }
    if response.has_focus() {
        ui.painter().rect_stroke(
            rect,
            4.0,
            Stroke::new(1.0, colors.accent_dim),
            egui::StrokeKind::Inside,
        );
    }
}

/// Paints a frame around the picture of a row.
pub(crate) fn picture_frame(ui: &Ui, rect: Rect) {
    ui.painter().rect_stroke(
        rect,
        3.0,
        Stroke::new(1.0, theme::of(ui).swatch_edge),
        egui::StrokeKind::Inside,
    );
}

/// Largest rectangle in the middle of `rect` in which a picture of `size` texels keeps its shape.
pub(crate) fn fitted(rect: Rect, size: [u32; 2]) -> Rect {
    let [width, height] = size.map(|side| side.max(1) as f32);
    let scale = (rect.width() / width).min(rect.height() / height);
    Rect::from_center_size(rect.center(), vec2(width, height) * scale)
}

/// Shows a label before a field, of a width that lets fields begin below each other.
pub(crate) fn lead(ui: &mut Ui, text: &str, width: f32) -> Response {
    let size = vec2(width, ui.spacing().interact_size.y);
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    ui.allocate_ui_with_layout(size, layout, |ui| {
        ui.set_min_size(size);
        ui.label(text)
    })
    .inner
}

/// Shows widgets that belong together, such as a name and its field: in a row that wraps they go to
/// the next line together.
pub(crate) fn together<R>(ui: &mut Ui, salt: &str, add: impl FnOnce(&mut Ui) -> R) -> R {
    let id = ui.scope_id().with(("together", salt));
    // The width is that of the frame before.
    let known: f32 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let size = vec2(known, ui.spacing().interact_size.y);
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let shown = ui.allocate_ui_with_layout(size, layout, add);
    let width = shown.response.rect.width();
    if (width - known).abs() > 0.5 {
        ui.data_mut(|data| data.insert_temp(id, width));
        ui.ctx().request_discard("widgets that belong together have another width");
    }
    shown.inner
}

/// Rectangle of a whole texture.
pub(crate) fn whole() -> Rect {
    Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_keeps_its_shape_in_the_middle_of_its_place() {
        let place = Rect::from_min_size(pos2(10.0, 20.0), vec2(100.0, 80.0));
        let found = fitted(place, [64, 16]);
        assert_eq!((found.center(), found.size()), (place.center(), vec2(100.0, 25.0)));
        assert_eq!(fitted(place, [16, 64]).size(), vec2(20.0, 80.0));
    }
}
