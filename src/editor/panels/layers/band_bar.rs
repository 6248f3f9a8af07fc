//! Bar of a layer's bands in its row: a ramp whose edges are dragged.

use eframe::egui::{Rect, Ui, vec2};

use super::row::Row;
use crate::commands::Command;
use crate::document::Value;
use crate::fields::bands::{self, Bands, BandsOf};

/// Width of the bar, and the least width that is left of the name, in points.
const WIDTH: f32 = 76.0;
const LEAST_NAME: f32 = 60.0;

/// Shows the bar at the right of a row's room for the name, where the layer has bands. Returns the
/// room that is left.
pub(super) fn show(ui: &Ui, room: Rect, row: &Row<'_>, out: &mut Vec<Command>) -> Rect {
    let Some(port) = row.port(bands::PORT) else { return room };
    let is_wired = row.session.look().graph.wire_into(row.id, &port.name).is_some();
    let target = row.target(port);
    let value = row.session.keys().value_at(&target);
    let known = match &value {
        Some(Value::Ramp(ramp)) => Bands::of(ramp),
        _ => None,
    };
    let is_shown = !is_wired && room.width() > WIDTH + LEAST_NAME;
    let Some(mut bands) = known.filter(|_| is_shown) else { return room };
    let mut bar = room.shrink2(vec2(0.0, 4.0));
    bar.set_left(room.right() - WIDTH);
    let mut changed = None;
    let space = row.session.look().color_space;
    bands::bar(ui, bar, &mut bands, space, BandsOf::Named(&row.title()), &mut changed);
    if let Some(widget) = changed {
        let edit = row.session.keys().set_at(&target, Value::Ramp(bands.ramp()));
        out.push(Command::EditHeld(widget, edit));
    }
    Rect::from_min_max(room.min, bar.left_bottom() + vec2(-8.0, 4.0))
}
