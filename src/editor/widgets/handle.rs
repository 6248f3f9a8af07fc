//! Handle on a drawing: dragged, or moved by arrow keys once it has the focus.

use eframe::egui;
use eframe::egui::{
    CursorIcon, EventFilter, Id, Key, Modifiers, Pos2, Rect, Response, Sense, Ui, Vec2, WidgetInfo,
    vec2,
};

/// Side of the square that catches the pointer, in points.
const REACH: f32 = 18.0;

/// Result of showing a handle.
pub(crate) struct HandleResponse {
    /// Response of the widget.
    pub(crate) response: Response,
    /// Position that the handle was dragged to; the point that was grabbed stays under the pointer.
    pub(crate) to: Option<Pos2>,
    /// Number of steps by arrow keys: right and up are positive.
    pub(crate) steps: Vec2,
}

/// Lays a handle over a drawing. `value` is its value for screen readers.
pub(crate) fn handle(
    ui: &Ui,
    id: Id,
    at: Pos2,
    label: &str,
    value: f64,
    is_on: bool,
) -> HandleResponse {
    let rect = Rect::from_center_size(at, Vec2::splat(REACH));
    let sense = if is_on { Sense::click_and_drag() } else { Sense::hover() };
    let response = ui.interact(rect, id, sense);
    response.widget_info(|| WidgetInfo::slider(is_on, value, label));
    let grip = id.with("grip");
    if response.drag_started() {
        let origin = ui.input(|input| input.pointer.press_origin()).unwrap_or(at);
        ui.data_mut(|data| data.insert_temp(grip, at - origin));
    }
    if response.drag_started() || response.clicked() {
        response.request_focus();
    }
    let pointer = response.interact_pointer_pos().filter(|_| response.dragged());
    let to = pointer
        .map(|pointer| pointer + ui.data(|data| data.get_temp::<Vec2>(grip)).unwrap_or_default());
    let steps = if response.has_focus() { arrows(ui, id) } else { Vec2::ZERO };
    let response = if is_on { response.on_hover_cursor(CursorIcon::Grab) } else { response };
    HandleResponse { response, to, steps }
}

/// Presses of arrow keys, which would otherwise move the focus; with Shift each counts a tenth.
pub(crate) fn arrows(ui: &Ui, id: Id) -> Vec2 {
    let filter =
        EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, filter));
    let mut steps = Vec2::ZERO;
    let ways = [
        (Key::ArrowRight, vec2(1.0, 0.0)),
        (Key::ArrowLeft, vec2(-1.0, 0.0)),
        (Key::ArrowUp, vec2(0.0, 1.0)),
        (Key::ArrowDown, vec2(0.0, -1.0)),
    ];
    for (key, way) in ways {
        for (modifiers, scale) in [(Modifiers::NONE, 1.0), (Modifiers::SHIFT, 0.1)] {
            let presses = ui.input_mut(|input| input.count_and_consume_key(modifiers, key));
            steps += way * presses as f32 * scale;
        }
    }
    steps
}

/// True if a key was pressed while a handle has the focus.
pub(crate) fn pressed(ui: &Ui, response: &Response, key: Key) -> bool {
    response.has_focus() && ui.input_mut(|input| input.consume_key(Modifiers::NONE, key))
}

/// Paints a ring around the handle that has the keyboard.
pub(crate) fn focus_ring(ui: &Ui, response: &Response, at: Pos2, radius: f32) {
    if response.has_focus() {
        let stroke = egui::Stroke::new(1.0, crate::widgets::theme::of(ui).accent);
        ui.painter().circle_stroke(at, radius + 3.0, stroke);
    }
}
