//! Curves of an opened track: its values over time, number by number, with keys and handles.

use chiaro_locale::tr;
use eframe::egui::{
    Align2, Color32, FontId, Pos2, Rect, Shape, Stroke, Ui, epaint::PathShape, pos2, vec2,
};

use super::axis::Axis;
use super::sheet::KeyAt;
use super::{Timeline, rows};
use crate::commands::Command;
use crate::document::{Edit, TimeInterpolation, TimeKeys, Value};
use crate::fields::lighting::OwnedKeys;
use crate::frame::Track;
use crate::state::keying::retime;
use crate::values;
use crate::widgets::handle::{focus_ring, handle};
use crate::widgets::theme;

/// Least and greatest height of an opened track, in points.
pub(super) const HEIGHTS: std::ops::RangeInclusive<f32> = 100.0..=240.0;
/// Space above and below the curves, in points.
const MARGIN: f32 = 16.0;
/// Height of the bar of colors, in points.
const COLORS: f32 = 7.0;
/// Greatest number of keys that are handles at once.
const MOST_KEYS: usize = 200;
/// Greatest number of selected keys that show their handles.
const MOST_HANDLES: usize = 40;
/// Least difference between the values at the edges, as a share of their size.
const LEAST_HEIGHT: f64 = 1e-6;

/// Mapping of values to the screen.
#[derive(Clone, Copy)]
struct Scale {
    lane: Rect,
    values: [f64; 2],
}

impl Scale {
    fn y(self, value: f64) -> f32 {
        let [low, high] = self.values;
        let share = ((value - low) / (high - low)).clamp(-100.0, 100.0) as f32;
        let inner = self.lane.height() - 2.0 * MARGIN;
        self.lane.bottom() - MARGIN - inner * share
    }

    fn value(self, y: f32) -> f64 {
        let [low, high] = self.values;
        let inner = self.lane.height() - 2.0 * MARGIN;
        low + f64::from((self.lane.bottom() - MARGIN - y) / inner) * (high - low)
    }

    /// Change of the value for a point upward.
    fn unit(self) -> f64 {
        self.value(0.0) - self.value(1.0)
    }
}

/// Number of a value's component; switches are 0 and 1.
fn number(value: &Value, at: usize) -> Option<f64> {
    match value {
        Value::Number(x) if at == 0 => Some(*x),
        Value::Bool(on) if at == 0 => Some(f64::from(u8::from(*on))),
        Value::Vector(numbers) => numbers.get(at).copied().or((at == 3).then_some(1.0)),
        Value::Text(_) => value.color().map(|color| color[at.min(3)]),
        _ => None,
    }
}

/// Length by which numbers of a value are divided as they are drawn: directions and rotations have
/// length 1 between keys, and so at them, too, however long they are written.
fn length(track: &TimeKeys, value: &Value) -> f64 {
    match value {
        Value::Vector(numbers) if Track::of(track).turns && matches!(numbers.len(), 3 | 4) => {
            let length = numbers.iter().map(|x| x * x).sum::<f64>().sqrt();
            if length > 0.0 && length.is_finite() { length } else { 1.0 }
        }
        _ => 1.0,
    }
}

/// Number of a value's component as a track draws it.
pub(super) fn drawn(track: &TimeKeys, value: &Value, at: usize) -> Option<f64> {
    Some(number(value, at)? / length(track, value))
}

/// Count of numbers of a track's values; those of a color without its opacity where all are opaque.
pub(super) fn width(track: &TimeKeys) -> Option<usize> {
    let first = track.keys.first()?;
    let width = match &first.value {
        Value::Number(_) => 1,
        Value::Vector(numbers) => numbers.len(),
        value => value.color().map(|color| if color[3] == 1.0 { 3 } else { 4 })?,
    };
    Some(width)
}

/// True for tracks of numbers, which have curves.
pub(super) fn has_curves(track: &TimeKeys) -> bool {
    width(track).is_some()
}

/// Color of the curve of one number.
pub(super) fn ink(ui: &Ui, width: usize, at: usize) -> Color32 {
    let colors = theme::of(ui);
    match (width, at) {
        (1, _) => colors.second,
        (_, 0) => Color32::from_rgb(0xe0, 0x6c, 0x62),
        (_, 1) => Color32::from_rgb(0x6f, 0xba, 0x6a),
        (_, 2) => Color32::from_rgb(0x62, 0x94, 0xe0),
        _ => colors.dim,
    }
}

/// Name of one number of a track's values.
fn component_name(is_color: bool, width: usize, at: usize) -> &'static str {
    match (width, is_color) {
        (1, _) => "",
        (_, true) => [tr!("red"), tr!("green"), tr!("blue"), tr!("opacity")][at.min(3)],
        _ => ["x", "y", "z", "w"][at.min(3)],
    }
}

/// Places along a lane at which curves are drawn.
pub(super) fn places(lane: Rect) -> impl Iterator<Item = f32> + Clone {
    let count = (lane.width() / 2.0).clamp(2.0, 800.0) as usize;
    (0..=count).map(move |i| lane.left() + lane.width() * i as f32 / count as f32)
}

/// Corners of the line of a value that is held: level while the time whose value is seen stays, and
/// upright where that changes. `held` is that time at a place, `y` the height of a time's value.
pub(super) fn steps(
    places: impl Iterator<Item = f32>,
    held: impl Fn(f32) -> f64,
    y: impl Fn(f64) -> Option<f32>,
) -> Vec<Pos2> {
    let mut corners: Vec<Pos2> = Vec::new();
    let (mut seen, mut end) = (None, None);
    for x in places {
        let time = held(x);
        if seen != Some(time) {
            seen = Some(time);
            corners.extend(corners.last().map(|before| pos2(x, before.y)));
            corners.extend(y(time).map(|y| pos2(x, y)));
        }
        end = Some(x);
    }
    corners.extend(corners.last().zip(end).map(|(before, x)| pos2(x, before.y)));
    corners
}

/// Shows the curves of a track, its keys and their handles.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &Ui,
    owned: OwnedKeys<'_>,
    (axis, lane): (Axis, Rect),
    index: usize,
    out: &mut Vec<Command>,
) {
    let track = &owned.look().time_keys[index];
    let Some(width) = width(track) else { return };
    let colors = theme::of(ui);
    let painter = ui.painter_at(lane);
    painter.rect_filled(lane, 3.0, colors.canvas);
    let is_color = rows::is_color(owned, track);
    if is_color {
        let top = Rect::from_min_size(lane.min, vec2(lane.width(), COLORS));
        rows::color_bar(ui, owned, axis, top, track);
    }
    let curves = curves(axis, lane, track, width);
    let scale = Scale { lane, values: heights(timeline, ui, owned, index, &curves) };
    grid(ui, owned, track, scale);
    let holds = rows::Holds::of(owned, track);
    for (at, curve) in curves.iter().enumerate() {
        let line = curve.iter().map(|&(x, value)| pos2(x, scale.y(value)));
        let ink = ink(ui, width, at);
        let Some(holds) = holds else {
            painter.add(PathShape::line(line.collect(), Stroke::new(1.5, ink)));
            continue;
        };
        // The curve is what is edited, the steps are what the picture shows.
        painter.add(PathShape::line(line.collect(), Stroke::new(1.5, ink.gamma_multiply(0.5))));
        let y = |time: f64| {
            let value = Track::of(track).at(time)?;
            Some(scale.y(drawn(track, &value, at)?))
        };
        let steps = steps(places(lane), |x| holds.time(axis.time(x)), y);
        painter.add(PathShape::line(steps, Stroke::new(1.0, ink)));
    }
    let visible = rows::visible_keys(axis, track);
    if visible.len() > MOST_KEYS {
        return;
    }
    let picked = visible.clone().filter(|key| {
        let key = KeyAt { owner: owned.owner, track: index, key: *key };
        timeline.sheet.selected.contains(&key)
    });
    let picked: Vec<usize> = picked.take(MOST_HANDLES).collect();
    let graph = Graph { owned, axis, scale, index, width, is_color };
    for at in 0..width {
        for key in visible.clone() {
            graph.key(timeline, ui, (key, at), out);
        }
        for &key in &picked {
            graph.handles(ui, key, at, out);
        }
    }
}

/// Values along the lane, for each number.
fn curves(axis: Axis, lane: Rect, track: &TimeKeys, width: usize) -> Vec<Vec<(f32, f64)>> {
    let mut curves = vec![Vec::new(); width];
    for x in places(lane) {
        let Some(value) = Track::of(track).at(axis.time(x)) else { continue };
        for (at, curve) in curves.iter_mut().enumerate() {
            curve.extend(drawn(track, &value, at).map(|value| (x, value)));
        }
    }
    curves
}

/// Values at the edges: those of the curves and keys in view. They stay while anything is dragged.
fn heights(
    timeline: &mut Timeline,
    ui: &Ui,
    owned: OwnedKeys<'_>,
    index: usize,
    curves: &[Vec<(f32, f64)>],
) -> [f64; 2] {
    let track = &owned.look().time_keys[index];
    let place = (owned.owner, track.target.clone());
    let is_down = ui.input(|input| input.pointer.any_down());
    if let Some(known) = timeline.sheet.heights.get(&place).filter(|_| is_down) {
        return *known;
    }
    let all = curves.iter().flatten().map(|(_, value)| *value);
    let (low, high) =
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
    let (low, high) = if low.is_finite() { (low, high) } else { (0.0, 1.0) };
    let least = LEAST_HEIGHT * low.abs().max(high.abs()).max(1.0);
    let heights = if high - low > least { [low, high] } else { [low - 0.5, high + 0.5] };
    timeline.sheet.heights.insert(place, heights);
    heights
}

/// Draws lines at the edges and half way, with their values.
fn grid(ui: &Ui, owned: OwnedKeys<'_>, track: &TimeKeys, scale: Scale) {
    let colors = theme::of(ui);
    let painter = ui.painter_at(scale.lane);
    let port = owned.keys.base.port_at(&track.target);
    let [low, high] = scale.values;
    for value in [low, 0.5 * (low + high), high] {
        let y = scale.y(value);
        painter.hline(scale.lane.x_range(), y, Stroke::new(1.0, colors.grid));
        let shown = match (&port, &track.keys[0].value) {
            (Some(port), Value::Number(_)) => values::short(port, &Value::Number(value)),
            _ => values::number_text(value, 2),
        };
        let font = FontId::proportional(theme::SMALL_TEXT);
        let at = pos2(scale.lane.left() + 4.0, y - 1.0);
        painter.text(at, Align2::LEFT_BOTTOM, shown, font, colors.dim);
    }
}

/// Curves of one track on the screen.
#[derive(Clone, Copy)]
struct Graph<'s> {
    owned: OwnedKeys<'s>,
    axis: Axis,
    scale: Scale,
    index: usize,
    width: usize,
    is_color: bool,
}

impl Graph<'_> {
    fn track(&self) -> &TimeKeys {
        &self.owned.look().time_keys[self.index]
    }

    /// Name of one number of the track, for screen readers.
    fn name(&self, at: usize) -> String {
        let [owner, what] = rows::owner_and_name(self.owned, self.track());
        let component = component_name(self.is_color, self.width, at);
        let space = if component.is_empty() { "" } else { " " };
        format!("{owner}: {what}{space}{component}")
    }

    /// Place of a key on the screen.
    fn place(&self, key: usize, at: usize) -> Option<Pos2> {
        let key = &self.track().keys[key];
        Some(pos2(self.axis.x(key.time), self.scale.y(drawn(self.track(), &key.value, at)?)))
    }

    /// Shows a key on the curve of one number.
    fn key(
        &self,
        timeline: &mut Timeline,
        ui: &Ui,
        (index, at): (usize, usize),
        out: &mut Vec<Command>,
    ) {
        let Some(place) = self.place(index, at) else { return };
        let key = &self.track().keys[index];
        let id = ui.scope_id().with(("graph key", self.owned.owner, self.index, index, at));
        let label = tr!("Time key {key} of {name}", key = index + 1, name = self.name(at));
        let handled = handle(ui, id, place, &label, key.time, true);
        let key_at = KeyAt { owner: self.owned.owner, track: self.index, key: index };
        timeline.sheet.shown_at(key_at, place);
        let height = Some((at, self.scale.unit() * length(self.track(), &key.value)));
        let session = self.owned.session;
        rows::grab(timeline, ui, session, &handled.response, (key_at, key.time), height);
        rows::type_keys(timeline, ui, &handled, key_at);
        let is_selected = timeline.sheet.selected.contains(&key_at);
        rows::paint_key(ui, place, key.interpolation, is_selected, handled.response.hovered());
        focus_ring(ui, &handled.response, place, 7.0);
        rows::key_menu(&handled.response, self.owned, key_at, out);
        rows::explain(timeline, handled.response, key.time);
    }

    /// Shows the handles of a key, where cubics lead to it or from it.
    fn handles(&self, ui: &Ui, index: usize, at: usize, out: &mut Vec<Command>) {
        let (keys, track) = (&self.track().keys, Track::of(self.track()));
        let is_cubic =
            |key: &crate::document::TimeKey| key.interpolation == TimeInterpolation::Bezier;
        let before = index.checked_sub(1).and_then(|before| keys.get(before));
        let leads_out = is_cubic(&keys[index]) && index + 1 < keys.len();
        if before.is_some_and(is_cubic) {
            self.handle(ui, (index, at, false), track.incoming(index, at), out);
        }
        if leads_out {
            self.handle(ui, (index, at, true), track.outgoing(index, at), out);
        }
    }

    fn handle(
        &self,
        ui: &Ui,
        (index, at, is_outgoing): (usize, usize, bool),
        [time, value]: [f64; 2],
        out: &mut Vec<Command>,
    ) {
        let Some(from) = self.place(index, at) else { return };
        let key = &self.track().keys[index];
        let Some(own) = drawn(self.track(), &key.value, at) else { return };
        let end = pos2(self.axis.x(key.time + time), self.scale.y(own + value));
        let id =
            ui.scope_id().with(("handle", self.owned.owner, self.index, index, at, is_outgoing));
        let (key_number, name) = (index + 1, self.name(at));
        let label = match is_outgoing {
            true => tr!("Handle after key {key_number} of {name}"),
            false => tr!("Handle before key {key_number} of {name}"),
        };
        let handled = handle(ui, id, end, &label, value, true);
        if let Some(to) = handled.to {
            let to = [self.axis.time(to.x) - key.time, self.scale.value(to.y) - own];
            let keys = retime::with_handle(self.track(), index, at, is_outgoing, to);
            let edit = Edit::SetTimeKeys { index: self.index, keys };
            out.extend(self.owned.held(handled.response.id, edit));
        }
        let is_hot = handled.response.hovered() || handled.response.dragged();
        let color = if is_hot { theme::of(ui).accent } else { ink(ui, self.width, at) };
        let painter = ui.painter_at(self.scale.lane);
        painter.line_segment([from, end], Stroke::new(1.0, color.gamma_multiply(0.8)));
        painter.add(Shape::circle_filled(end, 3.5, color));
        focus_ring(ui, &handled.response, end, 4.0);
        handled.response.on_hover_text(tr!(
            "Drag it to shape the curve. Handles: automatic, aligned or free, in the row below"
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Target, TimeKey};

    #[test]
    fn a_value_that_is_held_is_drawn_as_steps() {
        // Two points a frame, on twos: a value that is its time.
        let places = (0..=9).map(|i| 2.0 * i as f32);
        let held = |x: f32| f64::from(x / 8.0).floor() * 2.0;
        let corners = steps(places, held, |time| Some(time as f32));
        let told: Vec<(f32, f32)> = corners.iter().map(|at| (at.x, at.y)).collect();
        let wanted = [(0.0, 0.0), (8.0, 0.0), (8.0, 2.0), (16.0, 2.0), (16.0, 4.0), (18.0, 4.0)];
        assert_eq!(told, wanted);
        assert!(steps([].into_iter(), held, |_| None).is_empty());
    }

    #[test]
    fn a_direction_is_drawn_without_a_jump_at_its_keys() {
        let key = |time: f64, value: [f64; 3]| {
            TimeKey::new(time, Value::Vector(value.to_vec()), TimeInterpolation::Linear)
        };
        let target = Target::parse("lights.key.direction").unwrap();
        let keys = vec![key(0.0, [0.0, 0.0, 2.0]), key(1.0, [3.0, 0.0, 4.0])];
        let track = TimeKeys { keys, ..TimeKeys::new(target) };
        let at = |time: f64, component| {
            drawn(&track, &Track::of(&track).at(time).unwrap(), component).unwrap()
        };
        for (component, last) in [(0, 0.6), (1, 0.0), (2, 0.8)] {
            for (before, after) in [(-1e-6, 1e-6), (1.0 - 1e-6, 1.0), (1.0, 2.0)] {
                let jump = at(before, component) - at(after, component);
                assert!(jump.abs() < 1e-4, "{component}: {jump} at {after}");
            }
            assert!((at(1.0, component) - last).abs() < 1e-9);
        }
    }
}
