//! Marks on the sphere: the keys, the great circles, and the present direction of the light or the
//! view.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Align2, FontId, Key, Pos2, Rect, Stroke, Ui, pos2};
use glam::DVec3;

use super::sphere::Globe;
use super::{KeySetView, STEP, copy, remove};
use crate::commands::Command;
use crate::state::keying::rounded;
use crate::widgets::handle::{self, handle};
use crate::widgets::theme;

/// Shows a key on the sphere, which can be dragged, selected, copied and deleted.
pub(super) fn key_handle(
    ui: &Ui,
    shown: &KeySetView<'_>,
    globe: Globe,
    index: usize,
    direction: DVec3,
    out: &mut Vec<Command>,
) {
    let colors = theme::of(ui);
    let at = globe.project(direction);
    let is_front = globe.is_front(direction);
    let id = ui.scope_id().with(("key", shown.owned.owner, shown.set, index));
    let weight = shown.weights.get(index).copied().unwrap_or(0.0);
    let handled = handle(ui, id, at, &tr!("Direction key {key}", key = index + 1), weight, true);
    let side = handled.response.id.with("side");
    if handled.response.drag_started() {
        ui.data_mut(|data| data.insert_temp(side, is_front));
    }
    if handled.response.clicked() || handled.response.drag_started() {
        out.push(Command::SelectKey(Some(shown.place(index))));
    }
    let moved = match handled.to {
        Some(to) => {
            let stays = ui.data(|data| data.get_temp::<bool>(side)).unwrap_or(is_front);
            Some(globe.direction(to, stays))
        }
        None if handled.steps != egui::Vec2::ZERO => {
            Some(globe.nudge(direction, handled.steps, STEP))
        }
        None => None,
    };
    if let Some(moved) = moved {
        let direction = rounded(moved);
        out.extend(shown.change_held(handled.response.id, |keys| {
            keys.keys[index].direction = direction;
        }));
    }
    if handle::pressed(ui, &handled.response, Key::Delete) {
        remove(&shown.with_key(index), out);
    }
    if handle::pressed(ui, &handled.response, Key::D) {
        copy(&shown.with_key(index), out);
    }
    let is_selected = shown.key == index;
    let radius = if is_front { 8.0 } else { 6.5 };
    let ink = colors.hue(index);
    let edge = if is_selected { colors.text } else { colors.canvas };
    let painter = ui.painter();
    if is_front {
        painter.circle(at, radius, ink, Stroke::new(2.0, edge));
    } else {
        painter.circle(at, radius, colors.canvas.gamma_multiply(0.6), Stroke::new(2.0, ink));
    }
    if is_selected {
        painter.circle_stroke(at, radius + 3.0, Stroke::new(1.5, colors.text));
    }
    let font = FontId::proportional(theme::SMALL_TEXT);
    let text = if is_front { colors.canvas } else { ink };
    painter.text(at, Align2::CENTER_CENTER, index + 1, font, text);
    if !handled.response.dragged() {
        let percent = weight * 100.0;
        handled.response.on_hover_text(tr!(
            "Key {key}, {percent:.0}% now. Drag it over the sphere (arrow keys: 2°), D copies it, \
             Delete removes it.",
            key = index + 1
        ));
    }
}

/// Draws the present direction of the light or the view, as a sun.
pub(super) fn now_mark(ui: &Ui, shown: &KeySetView<'_>, globe: Globe) {
    let colors = theme::of(ui);
    let at = globe.project(shown.now);
    let strength = if globe.is_front(shown.now) { 1.0 } else { 0.45 };
    for (width, color) in [(3.5, colors.canvas), (1.5, colors.text)] {
        let stroke = Stroke::new(width, color.gamma_multiply(strength));
        for ray in 0..8 {
            let way = egui::Vec2::angled(ray as f32 * std::f32::consts::FRAC_PI_4);
            ui.painter().line_segment([at + way * 12.5, at + way * 16.5], stroke);
        }
    }
}

/// Draws the three great circles, on the near or the far side.
pub(super) fn graticule(ui: &Ui, globe: Globe, is_front: bool) {
    const PIECES: usize = 72;
    let colors = theme::of(ui);
    let color = if is_front { colors.text.gamma_multiply(0.22) } else { colors.grid };
    for axis in 0..3 {
        let at = |i: usize| {
            let (sin, cos) = (i as f64 / PIECES as f64 * std::f64::consts::TAU).sin_cos();
            let mut place = [0.0; 3];
            (place[(axis + 1) % 3], place[(axis + 2) % 3]) = (cos, sin);
            DVec3::from(place)
        };
        for i in 0..PIECES {
            let (a, b) = (at(i), at(i + 1));
            if globe.is_front(a) == is_front && globe.is_front(b) == is_front {
                ui.painter()
                    .line_segment([globe.project(a), globe.project(b)], Stroke::new(1.0, color));
            }
        }
    }
}

/// Draws the names of the axes beside the ends of those that are seen from the side.
pub(super) fn names_of_places(ui: &Ui, rect: Rect, globe: Globe, is_view: bool) {
    let [front, back] = match is_view {
        true => [tr!("direction" => "front"), tr!("direction" => "back")],
        false => [tr!("direction" => "toward you"), tr!("direction" => "behind")],
    };
    let [right, left] = [tr!("direction" => "right"), tr!("direction" => "left")];
    let [above, below] = [tr!("direction" => "above"), tr!("direction" => "below")];
    let names = [right, above, front, left, below, back];
    let axes = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z];
    let font = FontId::proportional(theme::SMALL_TEXT);
    for (axis, text) in axes.into_iter().zip(names) {
        let at = globe.project(axis);
        let away: egui::Vec2 = at - globe.center;
        // The name of an axis toward the eye or away from it would cover the keys in the middle.
        if away.length() < 0.55 * globe.radius {
            continue;
        }
        let galley = ui.painter().layout_no_wrap(text.to_owned(), font.clone(), theme::of(ui).dim);
        let out = away.normalized();
        let wished: Pos2 = globe.center + out * (globe.radius + 7.0);
        let room = rect.shrink2(galley.size() / 2.0);
        let at = pos2(
            wished.x.clamp(room.left(), room.right()),
            wished.y.clamp(room.top(), room.bottom()),
        );
        ui.painter().galley(at - galley.size() / 2.0, galley, theme::of(ui).dim);
    }
}
