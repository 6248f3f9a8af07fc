//! Names of the handles of lights, for screen readers and whoever works without a pointer: Tab goes
//! from one to the next, and arrow keys move it. The pointer's drags are `lights`'.

use eframe::egui::{Id, Rect, Sense, Ui, Vec2, WidgetInfo, vec2};

use super::lights;
use crate::commands::Command;
use crate::state::session::Session;
use crate::widgets::handle::{arrows, focus_ring};

/// Side of a handle, in points.
const SIDE: f32 = 16.0;
/// Way that an arrow key moves a handle, in points.
const STEP: f32 = 4.0;

/// Names the handles, and moves the one that has the keyboard.
pub(super) fn show(ui: &Ui, rect: Rect, session: &Session) -> Vec<Command> {
    let mut out = Vec::new();
    for mut handle in lights::named(session, rect) {
        let id = Id::unique("handle of a light")
            .with((&handle.held.light, handle.held.lamp().map(|(_, of)| of)));
        let area = Rect::from_center_size(handle.at, Vec2::splat(SIDE));
        let response = ui.interact(area, id, Sense::focusable_noninteractive());
        let value = f64::from(handle.at.x - rect.left());
        response.widget_info(|| WidgetInfo::slider(true, value, &handle.name));
        focus_ring(ui, &response, handle.at, 6.0);
        if !response.has_focus() {
            continue;
        }
        let steps = arrows(ui, id);
        if steps != Vec2::ZERO {
            let to = handle.at + vec2(steps.x, -steps.y) * STEP;
            out.push(Command::ChooseLight(handle.held.light.clone()));
            out.extend(lights::drag(&mut handle.held, session, None, rect, to));
        }
    }
    out
}
