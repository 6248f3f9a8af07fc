//! Editor of a color ramp: drag its stops, double-click to add one, set the color of the selected
//! one.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::epaint::{Mesh, Vertex};
use eframe::egui::{
    Color32, Id, Painter, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use super::{color, curve};
use crate::document::{ColorSpace, Interpolation, Ramp, RampStop, Value};
use crate::widgets::theme;

/// Height of the bar of colors, in points.
const BAR: f32 = 26.0;
/// Height of the row of handles below the bar, in points.
const HANDLES: f32 = 16.0;

/// Edits a ramp. Returns the id of the widget and the new ramp where it changed.
pub(crate) fn show(ui: &mut Ui, label: Id, value: Option<&Value>) -> Option<(Id, Value)> {
    let Some(Value::Ramp(ramp)) = value else { return None };
    let mut ramp = ramp.clone();
    if ramp.stops.is_empty() {
        return None;
    }
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), BAR + HANDLES), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Ramp")));
    let bar = Rect::from_min_size(rect.min, vec2(rect.width(), BAR)).shrink2(vec2(8.0, 0.0));
    let low = ramp.stops.iter().map(|stop| stop.at).fold(0.0, f64::min);
    let high = ramp.stops.iter().map(|stop| stop.at).fold(1.0, f64::max);
    let to_screen = |at: f64| bar.min.x + ((at - low) / (high - low)) as f32 * bar.width();
    let from_screen = |p: Pos2| {
        let t = f64::from(((p.x - bar.min.x) / bar.width()).clamp(0.0, 1.0));
        ((low + t * (high - low)) * 1e3).round() / 1e3
    };
    let near = |ramp: &Ramp, p: Pos2| {
        let distances =
            ramp.stops.iter().enumerate().map(|(i, stop)| (i, (to_screen(stop.at) - p.x).abs()));
        distances.filter(|(_, d)| *d < 9.0).min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
    };
    let selected_id = response.id.with("selected");
    let mut selected =
        ui.data(|data| data.get_temp::<usize>(selected_id)).unwrap_or(0).min(ramp.stops.len() - 1);
    let mut changed = None;
    let pressed = response.drag_started() || response.clicked();
    let press = ui.input(|input| input.pointer.press_origin()).or(response.interact_pointer_pos());
    if let (true, Some(found)) = (pressed, press.and_then(|p| near(&ramp, p))) {
        selected = found;
    }
    if let (true, Some(p)) = (response.dragged(), response.interact_pointer_pos()) {
        let low = selected.checked_sub(1).map_or(f64::NEG_INFINITY, |i| ramp.stops[i].at);
        let high = ramp.stops.get(selected + 1).map_or(f64::INFINITY, |stop| stop.at);
        ramp.stops[selected].at = from_screen(p).max(low).min(high);
        changed = Some(response.id);
    }
    if let (true, Some(p)) = (response.double_clicked(), response.interact_pointer_pos()) {
        let near = near(&ramp, p);
        if let Some(index) = add_or_remove(&mut ramp, near, from_screen(p)) {
            selected = index.min(ramp.stops.len() - 1);
            changed = Some(response.id);
        }
    }
    ui.data_mut(|data| data.insert_temp(selected_id, selected));
    paint(ui, rect, bar, &ramp, selected, &to_screen);
    ui.horizontal(|ui| {
        // Ramps hold colors of the look's space; they are edited in the common one, which is as
        // shown.
        if let Some((id, color)) =
            color::edit(ui, label, rgba(&ramp.stops[selected]), ColorSpace::Display, true)
        {
            let opaque = color[3] == 1.0;
            ramp.stops[selected].color = if opaque { color[..3].to_vec() } else { color.to_vec() };
            changed = Some(id);
        }
        if curve::interpolation(ui, label, &mut ramp.interpolation) {
            changed = Some(ui.scope_id().with("interpolation"));
        }
    });
    changed.map(|id| (id, Value::Ramp(ramp)))
}

/// Removes the stop under a double click, or adds one elsewhere. Returns the stop to select then.
fn add_or_remove(ramp: &mut Ramp, near: Option<usize>, at: f64) -> Option<usize> {
    match near {
        Some(index) if ramp.stops.len() > 1 => {
            ramp.stops.remove(index);
            Some(index)
        }
        None if ramp.stops.len() < Ramp::MAX_STOPS => {
            let color = color_at(ramp, at).to_vec();
            let index = ramp.stops.partition_point(|stop| stop.at < at);
            ramp.stops.insert(index, RampStop { at, color });
            Some(index)
        }
        _ => None,
    }
}

fn rgba(stop: &RampStop) -> [f64; 4] {
    let channel = |i: usize, otherwise| stop.color.get(i).copied().unwrap_or(otherwise);
    [channel(0, 0.0), channel(1, 0.0), channel(2, 0.0), channel(3, 1.0)]
}

fn color_at(ramp: &Ramp, at: f64) -> [f64; 4] {
    let after = ramp.stops.partition_point(|stop| stop.at <= at);
    match (after.checked_sub(1).and_then(|i| ramp.stops.get(i)), ramp.stops.get(after)) {
        (Some(a), Some(b)) if ramp.interpolation != Interpolation::Stepped => {
            let t = (at - a.at) / (b.at - a.at).max(1e-9);
            let t = if ramp.interpolation == Interpolation::Smooth {
                t * t * (3.0 - 2.0 * t)
            } else {
                t
            };
            let (a, b) = (rgba(a), rgba(b));
            [0, 1, 2, 3].map(|i| a[i] + (b[i] - a[i]) * t)
        }
        (Some(a), _) => rgba(a),
        (None, Some(b)) => rgba(b),
        (None, None) => [0.0, 0.0, 0.0, 1.0],
    }
}

fn shown(color: [f64; 4]) -> Color32 {
    let [r, g, b, a] = color.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    Color32::from_rgba_unmultiplied(r, g, b, a)
}

/// Paints the colors of a ramp, from 0 at the left to 1 at the right.
pub(crate) fn swatch(painter: &Painter, rect: Rect, ramp: &Ramp) {
    colors(painter, rect, ramp, [rect.left(), rect.right()]);
}

/// Paints the colors of a ramp, with 0 and 1 at these places of the screen, in points.
fn colors(painter: &Painter, bar: Rect, ramp: &Ramp, [low, high]: [f32; 2]) {
    const PIECES: usize = 96;
    let mut mesh = Mesh::default();
    for i in 0..=PIECES {
        let t = i as f32 / PIECES as f32;
        let x = bar.min.x + t * bar.width();
        let at = f64::from((x - low) / (high - low));
        let color = shown(color_at(ramp, at));
        mesh.vertices.push(Vertex::untextured(pos2(x, bar.min.y), color));
        mesh.vertices.push(Vertex::untextured(pos2(x, bar.max.y), color));
        if i > 0 {
            let k = 2 * i as u32;
            mesh.indices.extend_from_slice(&[k - 2, k - 1, k, k, k - 1, k + 1]);
        }
    }
    painter.add(Shape::mesh(mesh));
}

fn paint(
    ui: &Ui,
    rect: Rect,
    bar: Rect,
    ramp: &Ramp,
    selected: usize,
    to_screen: &dyn Fn(f64) -> f32,
) {
    let painter = ui.painter_at(rect);
    painter.rect_filled(bar, 3.0, theme::of(ui).canvas);
    colors(&painter, bar, ramp, [to_screen(0.0), to_screen(1.0)]);
    for (index, stop) in ramp.stops.iter().enumerate() {
        let x = to_screen(stop.at);
        let color = if index == selected { theme::of(ui).accent } else { theme::of(ui).dim };
        let handle = Rect::from_center_size(pos2(x, bar.max.y + HANDLES / 2.0), vec2(11.0, 11.0));
        painter
            .line_segment([pos2(x, bar.max.y - 4.0), handle.center_top()], Stroke::new(1.5, color));
        let [r, g, b, _] = rgba(stop);
        painter.rect(
            handle,
            2.0,
            shown([r, g, b, 1.0]),
            Stroke::new(1.5, color),
            egui::StrokeKind::Outside,
        );
    }
}
