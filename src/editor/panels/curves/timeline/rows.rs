//! Track: its name, its values over time, and its keys; opened, its curves.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::epaint::{Mesh, PathShape, Vertex};
use eframe::egui::{
    Color32, Key, Modifiers, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo,
    pos2, vec2,
};

use super::axis::Axis;
use super::key_bar::INTERPOLATIONS;
use super::sheet::KeyAt;
use super::{NAMES, ROW, Timeline, graph};
use crate::catalog::Port;
use crate::commands::Command;
use crate::document::{Edit, Target, TimeInterpolation, TimeKeys};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::fields::mark;
use crate::frame::{ResolvedShot, Track};
use crate::library::Type;
use crate::state::keying::retime;
use crate::state::session::Session;
use crate::values;
use crate::widgets::handle::{self, HandleResponse, handle};
use crate::widgets::text::cell;
use crate::widgets::theme;

/// Names of the light or node and of the field that a track moves.
pub(super) fn owner_and_name(owned: OwnedKeys<'_>, track: &TimeKeys) -> [String; 2] {
    names_of(owned, &track.target)
}

/// Names of what has a value, and of the value; lights of the scene are told from those of the
/// look.
pub(super) fn names_of(owned: OwnedKeys<'_>, target: &Target) -> [String; 2] {
    let [owner, what] = owned.keys.base.names_of(target);
    match owned.owner {
        Owner::Look => [owner, what],
        Owner::Scene => [tr!("{owner} of the scene"), what],
    }
}

/// Greatest number of keys that are handles at once; more are marks.
const MOST_HANDLES: usize = 400;

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
    let place = (owned.owner, track.target.clone());
    let is_open = timeline.sheet.open.contains(&place) && graph::has_curves(track);
    let height = if is_open { timeline.curve_height } else { ROW };
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    if !ui.is_rect_visible(rect) {
        return;
    }
    let names = Rect::from_min_size(rect.min, vec2(NAMES - 8.0, ROW));
    let mut head =
        ui.new_child(egui::UiBuilder::new().id_salt((owned.owner, index)).max_rect(names));
    name(timeline, &mut head, owned, index, track, out);
    let lane = Rect::from_x_y_ranges(axis.lane.x_range(), rect.y_range());
    let [owner, what] = owner_and_name(owned, track);
    let response = ui.interact(
        lane,
        ui.scope_id().with(("lane", owned.owner, index)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| {
        WidgetInfo::labeled(egui::Role::Canvas, true, tr!("Track of {owner}: {what}"))
    });
    let is_pan = ui.input(|input| input.modifiers.alt || input.pointer.middle_down());
    if response.dragged() && is_pan {
        timeline.seen = axis.panned(response.drag_delta().x);
    } else if !is_pan {
        timeline.sheet.drag_box(ui, &response);
    }
    if response.double_clicked()
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let time = timeline.snapped(axis.time(pointer.x));
        out.extend(owned.once(owned.keys.add_in_time(index, time)));
    }
    if is_open {
        graph::show(timeline, ui, owned, (axis, lane), index, out);
        return;
    }
    paint(ui, owned, axis, lane, track);
    let visible = visible_keys(axis, track);
    if visible.len() > MOST_HANDLES {
        let color = theme::of(ui).text;
        let painter = ui.painter_at(lane);
        for key in &track.keys[visible] {
            painter.vline(axis.x(key.time), lane.shrink(8.0).y_range(), Stroke::new(1.0, color));
        }
        return;
    }
    for key in visible {
        key_handle(timeline, ui, owned, axis, (index, key), lane, out);
    }
}

/// Indices of the keys in view.
pub(super) fn visible_keys(axis: Axis, track: &TimeKeys) -> std::ops::Range<usize> {
    let [from, to] = [axis.lane.left() - 6.0, axis.lane.right() + 6.0].map(|x| axis.time(x));
    let first = track.keys.partition_point(|key| key.time < from);
    first..track.keys.partition_point(|key| key.time <= to).max(first)
}

/// Shows the triangle that opens the track, the diamond that keys the value at the playhead, the
/// value's name, and its present value.
fn name(
    timeline: &mut Timeline,
    ui: &mut Ui,
    owned: OwnedKeys<'_>,
    index: usize,
    track: &TimeKeys,
    out: &mut Vec<Command>,
) {
    let colors = theme::of(ui);
    let [owner, what] = owner_and_name(owned, track);
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        opener(timeline, ui, owned, track, &format!("{owner}: {what}"));
        let here =
            track.keys.iter().position(|key| (key.time - owned.session.view.time).abs() < 1e-6);
        let (name, help) = match here {
            Some(_) => {
                (tr!("Delete key of {owner}: {what}"), tr!("Deletes the key at the playhead"))
            }
            None => (tr!("Add key of {owner}: {what}"), tr!("Adds a key at the playhead")),
        };
        let diamond = mark::of(ui, owned.keys, &track.target, &name);
        if diamond.on_hover_text(help).clicked() {
            let edit = match here {
                Some(_) if track.keys.len() < 2 => Some(owned.keys.unkey(&track.target)),
                Some(key) => {
                    let keys = retime::without(track, &[key]);
                    Some(Edit::SetTimeKeys { index, keys })
                }
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

/// Shows the triangle that opens the curves of a track.
fn opener(
    timeline: &mut Timeline,
    ui: &mut Ui,
    owned: OwnedKeys<'_>,
    track: &TimeKeys,
    name: &str,
) {
    let size = vec2(12.0, ui.spacing().interact_size.y);
    if !graph::has_curves(track) {
        ui.allocate_exact_size(size, Sense::hover());
        return;
    }
    let place = (owned.owner, track.target.clone());
    let is_open = timeline.sheet.open.contains(&place);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let name = match is_open {
        true => tr!("Close curves of {name}"),
        false => tr!("Open curves of {name}"),
    };
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &name));
    let colors = theme::of(ui);
    let color = if response.hovered() || response.has_focus() { colors.text } else { colors.dim };
    let corners = match is_open {
        true => [vec2(-4.5, -2.5), vec2(4.5, -2.5), vec2(0.0, 3.5)],
        false => [vec2(-2.5, -4.5), vec2(3.5, 0.0), vec2(-2.5, 4.5)],
    };
    let corners = corners.map(|d| rect.center() + d).to_vec();
    ui.painter().add(Shape::convex_polygon(corners, color, Stroke::NONE));
    if response.clicked() {
        if is_open {
            timeline.sheet.open.remove(&place);
        } else {
            timeline.sheet.open.insert(place);
        }
    }
    response.on_hover_text(tr!("Shows the curves with their handles"));
}

/// Draws the values over time: numbers as lines, colors as themselves.
fn paint(ui: &Ui, owned: OwnedKeys<'_>, axis: Axis, lane: Rect, track: &TimeKeys) {
    let colors = theme::of(ui);
    let painter = ui.painter_at(lane);
    painter.rect_filled(lane, 3.0, colors.canvas);
    if is_color(owned, track) {
        color_bar(ui, owned, axis, lane.shrink2(vec2(0.0, 7.0)), track);
        return;
    }
    let width = graph::width(track).unwrap_or(1);
    let shown = track.keys.iter().step_by((track.keys.len() / 2000).max(1));
    let numbers =
        shown.flat_map(|key| (0..width).filter_map(move |at| graph::drawn(track, &key.value, at)));
    let (low, high) =
        numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
    if !low.is_finite() {
        return;
    }
    let y = |x: f64| {
        let t = if high > low { (x - low) / (high - low) } else { 0.5 };
        lane.bottom() - 7.0 - (lane.height() - 14.0) * t.clamp(-1.0, 2.0) as f32
    };
    let holds = Holds::of(owned, track);
    for at in 0..width {
        let color = if width == 1 { colors.second } else { graph::ink(ui, width, at) };
        let y_at = |time: f64| {
            let value = Track::of(track).at(time)?;
            Some(y(graph::drawn(track, &value, at)?))
        };
        let point = |x: f32| Some(pos2(x, y_at(axis.time(x))?));
        let curve: Vec<Pos2> = graph::places(lane).filter_map(point).collect();
        let Some(holds) = holds else {
            painter.add(PathShape::line(curve, Stroke::new(1.5, color)));
            continue;
        };
        // What the picture shows stands over what the keys say.
        painter.add(PathShape::line(curve, Stroke::new(1.0, colors.dim)));
        let steps = graph::steps(graph::places(lane), |x| holds.time(axis.time(x)), y_at);
        painter.add(PathShape::line(steps, Stroke::new(1.5, color)));
    }
}

/// Frames that a shot holds the values of a track for, the track's own and those of everything that
/// shades.
#[derive(Clone, Copy)]
pub(super) struct Holds<'s> {
    shot: &'s ResolvedShot,
    step: u32,
}

impl<'s> Holds<'s> {
    /// The frames for which the open shot holds a track; `None` where each frame has its value.
    pub(super) fn of(owned: OwnedKeys<'s>, track: &TimeKeys) -> Option<Self> {
        let shot = owned.session.shot()?;
        let change = owned.session.change_by_shot(owned.owner, &track.target.to_string());
        let step = change.filter(|change| change.is_keyed).map_or(1, |change| change.step);
        let is_held = step > 1 || shot.stack().step() > 1;
        is_held.then(|| Self { shot: shot.resolved(), step })
    }

    /// The time whose value is seen at a time, in seconds.
    pub(super) fn time(self, time: f64) -> f64 {
        self.shot.held_time(time, self.step)
    }
}

/// True for tracks whose values are colors.
pub(super) fn is_color(owned: OwnedKeys<'_>, track: &TimeKeys) -> bool {
    let port = owned.keys.base.port_at(&track.target);
    port.as_ref().is_some_and(|port: &Port| matches!(port.ty, Type::Color | Type::Composite))
}

/// Draws the colors of a track over time.
pub(super) fn color_bar(ui: &Ui, owned: OwnedKeys<'_>, axis: Axis, bar: Rect, track: &TimeKeys) {
    let space = owned.session.look().color_space;
    let holds = Holds::of(owned, track);
    let mut mesh = Mesh::default();
    for (i, x) in graph::places(bar).enumerate() {
        let time = axis.time(x);
        let value = Track::of(track).at(holds.map_or(time, |holds| holds.time(time)));
        let color = value.and_then(|value| value.color_in(space)).unwrap_or_default();
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
    ui.painter_at(bar).add(Shape::mesh(mesh));
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
    let [owner, what] = owner_and_name(owned, of_track);
    let label = tr!("Time key {key} of {owner}: {what}", key = index + 1);
    let id = ui.scope_id().with(("key", owned.owner, track, index));
    let handled = handle(ui, id, at, &label, key.time, true);
    let place = KeyAt { owner: owned.owner, track, key: index };
    timeline.sheet.shown_at(place, at);
    grab(timeline, ui, owned.session, &handled.response, (place, key.time), None);
    type_keys(timeline, ui, &handled, place);
    let is_selected = timeline.sheet.selected.contains(&place);
    paint_key(ui, at, key.interpolation, is_selected, handled.response.hovered());
    handle::focus_ring(ui, &handled.response, at, 7.0);
    key_menu(&handled.response, owned, place, out);
    explain(timeline, handled.response, key.time);
}

/// Shows the menu of a key, by a right click: how values go on from it, and the way out.
pub(super) fn key_menu(
    response: &Response,
    owned: OwnedKeys<'_>,
    KeyAt { track: index, key, .. }: KeyAt,
    out: &mut Vec<Command>,
) {
    let Some(track) = owned.look().time_keys.get(index) else { return };
    let now = track.keys[key].interpolation;
    response.context_menu(|ui| {
        for (choice, text, help) in INTERPOLATIONS {
            if ui.radio(now == choice, text.tr()).on_hover_text(help.tr()).clicked() {
                let keys = retime::interpolated(track, &[key], choice);
                out.extend(owned.once(Edit::SetTimeKeys { index, keys }));
                ui.close();
            }
        }
        ui.separator();
        if ui.button(tr!("Delete key")).clicked() {
            let edit = owned.keys.without_key(index, key);
            out.extend(edit.and_then(|edit| owned.once(edit)));
            ui.close();
        }
    });
}

/// Selects a key that is pressed, and begins to drag the selected ones; `height` is the number of
/// the value that is dragged, and its change for a point upward.
pub(super) fn grab(
    timeline: &mut Timeline,
    ui: &Ui,
    session: &Session,
    response: &Response,
    (place, time): (KeyAt, f64),
    height: Option<(usize, f64)>,
) {
    let modifiers = ui.input(|input| input.modifiers);
    if response.clicked() {
        timeline.sheet.press(place, modifiers, false);
    }
    if response.drag_started() {
        timeline.sheet.press(place, modifiers, true);
        timeline.sheet.begin_drag(ui, session, response.id, time, height);
    }
    if response.double_clicked() {
        timeline.went = Some(time);
    }
}

/// Takes keys of the keyboard that the key with the focus is moved or deleted by; what is selected
/// goes with it.
pub(super) fn type_keys(timeline: &mut Timeline, ui: &Ui, handled: &HandleResponse, at: KeyAt) {
    let is_deleted = handle::pressed(ui, &handled.response, Key::Delete);
    if handled.steps.x == 0.0 && !is_deleted {
        return;
    }
    if !timeline.sheet.selected.contains(&at) {
        timeline.sheet.press(at, Modifiers::NONE, false);
    }
    timeline.is_deleting |= is_deleted;
    if handled.steps.x != 0.0 {
        timeline.steps = Some(f64::from(handled.steps.x) / timeline.fps);
    }
}

pub(super) fn explain(timeline: &Timeline, response: Response, time: f64) {
    let frame = (time * timeline.fps * 100.0).round() / 100.0;
    let time = values::number_text(time, 3);
    response.on_hover_text(tr!(
        "{time} s, frame {frame}. Drag it, or arrow keys (a frame); Shift selects more; a right \
         click shapes it; double-click brings the playhead here; Delete removes it."
    ));
}

/// Draws a key: a hollow circle for handles, a circle for smooth interpolation, a diamond for
/// linear, a square for stepped.
pub(super) fn paint_key(
    ui: &Ui,
    at: Pos2,
    interpolation: TimeInterpolation,
    is_selected: bool,
    is_hot: bool,
) {
    let colors = theme::of(ui);
    let fill = if is_selected { colors.accent } else { colors.text };
    let edge = if is_hot { colors.accent } else { colors.canvas };
    let stroke = Stroke::new(1.5, edge);
    match interpolation {
        TimeInterpolation::Linear => mark::diamond(ui, at, 6.0, fill, edge),
        TimeInterpolation::Smooth => drop(ui.painter().circle(at, 5.5, fill, stroke)),
        TimeInterpolation::Bezier => {
            ui.painter().circle(at, 5.5, fill, stroke);
            ui.painter().circle_filled(at, 2.5, colors.canvas);
        }
        TimeInterpolation::Stepped => {
            let square = Rect::from_center_size(at, Vec2::splat(10.0));
            ui.painter().rect(square, 1.0, fill, stroke, egui::StrokeKind::Middle);
        }
    }
}
