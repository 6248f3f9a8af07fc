//! Track: its name, its values over time, and its keys.

use eframe::egui;
use eframe::egui::epaint::{Mesh, PathShape, Vertex};
use eframe::egui::{
    Color32, Key, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use super::axis::Axis;
use super::{NAMES, ROW, Timeline, bar};
use crate::catalog::Port;
use crate::commands::Command;
use crate::document::{Interpolation, TimeKeys, Value};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::fields::mark;
use crate::frame::{at_time, is_direction};
use crate::library::Type;
use crate::values;
use crate::widgets::handle::{self, handle};
use crate::widgets::text::cell;
use crate::widgets::theme;

/// Names of the light or node and of the field that a track moves; lights of the scene are told
/// from those of the look.
pub(super) fn owner_and_name(owned: OwnedKeys<'_>, track: &TimeKeys) -> [String; 2] {
    let [owner, what] = owned.keys.base.names_of(&track.target);
    match owned.owner {
        Owner::Look => [owner, what],
        Owner::Scene => [format!("{owner} of the scene"), what],
    }
}

/// Shows a track.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &mut Ui,
    owned: OwnedKeys<'_>,
    axis: Axis,
    index: usize,
    out: &mut Vec<Command>,
) {
    let track = &owned.look().time_keys[index];
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    if !ui.is_rect_visible(rect) {
        return;
    }
    let names = Rect::from_min_size(rect.min, vec2(NAMES - 8.0, ROW));
    let mut head =
        ui.new_child(egui::UiBuilder::new().id_salt((owned.owner, index)).max_rect(names));
    name(&mut head, owned, index, track, out);
    let lane = Rect::from_x_y_ranges(axis.lane.x_range(), rect.y_range());
    let [owner, what] = owner_and_name(owned, track);
    let response = ui.interact(
        lane,
        ui.scope_id().with(("lane", owned.owner, index)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| {
        WidgetInfo::labeled(egui::Role::Canvas, true, format!("Track of {owner}: {what}"))
    });
    if response.dragged() {
        timeline.seen = axis.panned(response.drag_delta().x);
    }
    if response.double_clicked()
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let time = timeline.snapped(axis.time(pointer.x));
        if let Some(value) = at_time(&track.keys, time, is_direction(&track.target)) {
            out.extend(owned.once(owned.keys.set_in_time(index, time, value)));
        }
    }
    response.on_hover_text("Double-click adds a key; drag pans; drag a key to move it in time");
    paint(ui, owned, axis, lane, track);
    for key in 0..track.keys.len() {
        key_handle(timeline, ui, owned, axis, (index, key), lane, out);
    }
}

/// Shows the diamond that keys the value at the playhead, the value's name, and its present value.
fn name(ui: &mut Ui, owned: OwnedKeys<'_>, index: usize, track: &TimeKeys, out: &mut Vec<Command>) {
    let colors = theme::of(ui);
    let [owner, what] = owner_and_name(owned, track);
    ui.horizontal_centered(|ui| {
        let here =
            track.keys.iter().position(|key| (key.time - owned.session.view.time).abs() < 1e-6);
        let verb = if here.is_some() { "Delete key of" } else { "Add key of" };
        let diamond = mark::of(ui, owned.keys, &track.target, &format!("{verb} {owner}: {what}"));
        let help = if here.is_some() {
            "Deletes the key at the playhead"
        } else {
            "Adds a key at the playhead"
        };
        if diamond.on_hover_text(help).clicked() {
            let edit = match here {
                Some(key) => Some(bar::removed(owned, index, key)),
                None => owned.keys.key_in_time(&track.target),
            };
            out.extend(edit.and_then(|edit| owned.once(edit)));
        }
        let keys = owned.keys;
        let now = keys.value_now(&track.target).zip(keys.base.port_at(&track.target));
        let space = owned.session.look().color_space;
        let shown = now.map(|(value, port)| {
            match value.color_in(space).filter(|_| port.ty == Type::Color) {
                Some(color) => values::hex(color),
                None => values::short(&port, &value),
            }
        });
        let shown = shown.unwrap_or_default();
        let rect = ui.available_rect_before_wrap();
        let value_width = 62.0;
        let font = egui::TextStyle::Body.resolve(ui.style());
        let left = Rect::from_min_max(rect.min, pos2(rect.right() - value_width, rect.bottom()));
        // Two lines: tracks of one light differ only in what comes last.
        let middle = left.top() + 0.46 * left.height();
        let small = egui::FontId::proportional(theme::SMALL_TEXT);
        let above = Rect::from_x_y_ranges(left.x_range(), left.top()..=middle);
        let below = Rect::from_x_y_ranges(left.x_range(), middle..=left.bottom());
        cell(ui, above, &owner, small, colors.dim);
        cell(ui, below, &what, font.clone(), colors.text);
        let right =
            Rect::from_min_max(pos2(rect.right() - value_width + 4.0, rect.top()), rect.max);
        cell(ui, right, &shown, font, colors.dim);
    });
}

/// Draws the values over time: numbers as a line, colors as themselves.
fn paint(ui: &Ui, owned: OwnedKeys<'_>, axis: Axis, lane: Rect, track: &TimeKeys) {
    let colors = theme::of(ui);
    let painter = ui.painter_at(lane);
    painter.rect_filled(lane, 3.0, colors.canvas);
    let port = owned.keys.base.port_at(&track.target);
    let of = |time: f64| at_time(&track.keys, time, is_direction(&track.target));
    let count = (lane.width() / 3.0).clamp(2.0, 400.0) as usize;
    let places = (0..=count).map(|i| lane.left() + lane.width() * i as f32 / count as f32);
    let is_color =
        port.as_ref().is_some_and(|port: &Port| matches!(port.ty, Type::Color | Type::Composite));
    if is_color {
        let space = owned.session.look().color_space;
        let bar = lane.shrink2(vec2(0.0, 7.0));
        let mut mesh = Mesh::default();
        for (i, x) in places.enumerate() {
            let color =
                of(axis.time(x)).and_then(|value| value.color_in(space)).unwrap_or_default();
            let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
            let [r, g, b, _] = color.map(byte);
            for y in [bar.top(), bar.bottom()] {
                mesh.vertices.push(Vertex::untextured(pos2(x, y), Color32::from_rgb(r, g, b)));
            }
            if i > 0 {
                let k = 2 * i as u32;
                mesh.indices.extend_from_slice(&[k - 2, k - 1, k, k, k - 1, k + 1]);
            }
        }
        painter.add(Shape::mesh(mesh));
        return;
    }
    let numbers = track.keys.iter().filter_map(|key| number(&key.value));
    let (low, high) =
        numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
    if low.is_finite() {
        let y = |x: f64| {
            let t = if high > low { (x - low) / (high - low) } else { 0.5 };
            lane.bottom() - 7.0 - (lane.height() - 14.0) * t as f32
        };
        let line: Vec<Pos2> =
            places.filter_map(|x| Some(pos2(x, y(number(&of(axis.time(x))?)?)))).collect();
        painter.add(PathShape::line(line, Stroke::new(1.5, colors.second)));
    }
}

fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        Value::Bool(on) => Some(f64::from(u8::from(*on))),
        _ => None,
    }
}

fn key_handle(
    timeline: &mut Timeline,
    ui: &Ui,
    owned: OwnedKeys<'_>,
    axis: Axis,
    (track, index): (usize, usize),
    lane: Rect,
    out: &mut Vec<Command>,
) {
    let of_track = &owned.look().time_keys[track];
    let key = &of_track.keys[index];
    let at = pos2(axis.x(key.time), lane.center().y);
    if !lane.x_range().expand(6.0).contains(at.x) {
        return;
    }
    let [owner, what] = owner_and_name(owned, of_track);
    let label = format!("Time key {} of {owner}: {what}", index + 1);
    let handled = handle(
        ui,
        ui.scope_id().with(("key", owned.owner, track, index)),
        at,
        &label,
        key.time,
        true,
    );
    if handled.response.clicked() || handled.response.drag_started() {
        timeline.selected = Some((owned.owner, track, index));
    }
    let step = f64::from(handled.steps.x) / timeline.fps;
    let wished = handled.to.map(|to| axis.time(to.x)).or((step != 0.0).then_some(key.time + step));
    if let Some(time) = wished {
        let edit = bar::moved(timeline, owned, track, index, time);
        out.extend(owned.held(handled.response.id, edit));
    }
    if handled.response.double_clicked() {
        timeline.go(key.time, out);
    }
    if handle::pressed(ui, &handled.response, Key::Delete) {
        out.extend(owned.once(bar::removed(owned, track, index)));
    }
    let is_selected = timeline.selected == Some((owned.owner, track, index));
    paint_key(ui, at, key.interpolation, is_selected, handled.response.hovered());
    handle::focus_ring(ui, &handled.response, at, 7.0);
    let time = values::number_text(key.time, 3);
    handled.response.on_hover_text(format!(
        "{time} s. Drag it, or arrow keys (a frame); double-click brings the playhead here; Delete \
         removes it."
    ));
}

/// Draws a key: a circle for smooth interpolation, a diamond for linear, a square for stepped.
fn paint_key(ui: &Ui, at: Pos2, interpolation: Interpolation, is_selected: bool, is_hot: bool) {
    let colors = theme::of(ui);
    let fill = if is_selected { colors.accent } else { colors.text };
    let edge = if is_hot { colors.accent } else { colors.canvas };
    let stroke = Stroke::new(1.5, edge);
    match interpolation {
        Interpolation::Linear => mark::diamond(ui, at, 6.0, fill, edge),
        Interpolation::Smooth => drop(ui.painter().circle(at, 5.5, fill, stroke)),
        Interpolation::Stepped => {
            let square = Rect::from_center_size(at, Vec2::splat(10.0));
            ui.painter().rect(square, 1.0, fill, stroke, egui::StrokeKind::Middle);
        }
    }
}
