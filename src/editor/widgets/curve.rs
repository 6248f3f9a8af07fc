//! Editor of a free curve: drag its points, double-click to add one, double-click a point to remove
//! it.

use chiaro_locale::tr;
use eframe::egui::epaint::PathShape;
use eframe::egui::{ComboBox, Id, Pos2, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

use crate::document::{Curve, Interpolation, Value};
use crate::widgets::theme;

/// Height of the editor, in points.
const HEIGHT: f32 = 150.0;

/// Edits a curve. Returns the id of the widget and the new curve where it changed.
pub(crate) fn show(ui: &mut Ui, label: Id, value: Option<&Value>) -> Option<(Id, Value)> {
    let Some(Value::Curve(curve)) = value else { return None };
    let mut curve = curve.clone();
    let size = vec2(ui.available_width(), HEIGHT);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Curve")));
    let area = rect.shrink(6.0);
    let bounds = bounds(&curve);
    let to_screen = |p: [f64; 2]| {
        let t = |x: f64, range: &[f64; 2]| ((x - range[0]) / (range[1] - range[0])) as f32;
        pos2(
            area.min.x + t(p[0], &bounds[0]) * area.width(),
            area.max.y - t(p[1], &bounds[1]) * area.height(),
        )
    };
    let from_screen = |p: Pos2| {
        let at = |t: f32, range: &[f64; 2]| range[0] + f64::from(t) * (range[1] - range[0]);
        let round = |x: f64| (x * 1e3).round() / 1e3;
        [
            round(at(((p.x - area.min.x) / area.width()).clamp(0.0, 1.0), &bounds[0])),
            round(at(((area.max.y - p.y) / area.height()).clamp(0.0, 1.0), &bounds[1])),
        ]
    };
    let near = |curve: &Curve, p: Pos2| {
        let distances =
            curve.points.iter().enumerate().map(|(i, &point)| (i, to_screen(point).distance(p)));
        distances.filter(|(_, d)| *d < 12.0).min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
    };
    let mut changed = false;
    let held_id = response.id.with("held");
    let pointer = response.interact_pointer_pos();
    if response.drag_started() {
        let origin = ui.input(|input| input.pointer.press_origin());
        let held = origin.and_then(|origin| near(&curve, origin));
        ui.data_mut(|data| data.insert_temp(held_id, held));
    }
    if let (true, Some(p)) = (response.dragged(), pointer)
        && let Some(Some(held)) = ui.data(|data| data.get_temp::<Option<usize>>(held_id))
        && held < curve.points.len()
    {
        curve.points[held] = between_neighbors(&curve, held, from_screen(p));
        changed = true;
    }
    if let (true, Some(p)) = (response.double_clicked(), pointer) {
        let near = near(&curve, p);
        changed = add_or_remove(&mut curve, near, from_screen(p));
    }
    paint(ui, rect, &curve, &to_screen);
    let combo = interpolation(ui, label, &mut curve.interpolation);
    (changed || combo).then_some((response.id, Value::Curve(curve)))
}

/// Shown range of x and of y: at least 0 to 1.
fn bounds(curve: &Curve) -> [[f64; 2]; 2] {
    [0, 1].map(|axis| {
        let numbers = curve.points.iter().map(|point| point[axis]);
        let min = numbers.clone().fold(0.0, f64::min);
        [min, numbers.fold(1.0, f64::max)]
    })
}

fn between_neighbors(curve: &Curve, index: usize, [x, y]: [f64; 2]) -> [f64; 2] {
    const GAP: f64 = 1e-3;
    let low = index.checked_sub(1).map_or(f64::NEG_INFINITY, |i| curve.points[i][0] + GAP);
    let high = curve.points.get(index + 1).map_or(f64::INFINITY, |point| point[0] - GAP);
    [x.max(low).min(high.max(low)), y]
}

fn add_or_remove(curve: &mut Curve, near: Option<usize>, point: [f64; 2]) -> bool {
    match near {
        Some(index) if curve.points.len() > 2 => {
            curve.points.remove(index);
            true
        }
        None if curve.points.len() < Curve::MAX_POINTS => {
            let index = curve.points.partition_point(|other| other[0] < point[0]);
            curve.points.insert(index, point);
            curve.points[index] = between_neighbors(curve, index, point);
            true
        }
        _ => false,
    }
}

fn paint(ui: &Ui, rect: Rect, curve: &Curve, to_screen: &dyn Fn([f64; 2]) -> Pos2) {
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 4.0, theme::of(ui).canvas);
    for i in 1..4 {
        let t = f64::from(i) / 4.0;
        let stroke = Stroke::new(1.0, theme::of(ui).grid);
        painter.line_segment([to_screen([t, 0.0]), to_screen([t, 1.0])], stroke);
        painter.line_segment([to_screen([0.0, t]), to_screen([1.0, t])], stroke);
    }
    let line = outline(curve).into_iter().map(to_screen).collect();
    painter.add(PathShape::line(line, Stroke::new(2.0, theme::of(ui).accent)));
    for &point in &curve.points {
        painter.circle(
            to_screen(point),
            4.5,
            theme::of(ui).panel,
            Stroke::new(2.0, theme::of(ui).accent),
        );
    }
}

/// The curve as straight pieces, flat to both sides.
fn outline(curve: &Curve) -> Vec<[f64; 2]> {
    let (Some(first), Some(last)) = (curve.points.first(), curve.points.last()) else {
        return Vec::new();
    };
    let [x_range, _] = bounds(curve);
    let mut line = vec![[x_range[0], first[1]], *first];
    for (i, pair) in curve.points.windows(2).enumerate() {
        match curve.interpolation {
            Interpolation::Linear => {}
            Interpolation::Stepped => line.push([pair[1][0], pair[0][1]]),
            Interpolation::Smooth => {
                let (m0, m1) = (slope(&curve.points, i), slope(&curve.points, i + 1));
                line.extend((1..16).map(|step| hermite(pair, m0, m1, f64::from(step) / 16.0)));
            }
        }
        line.push(pair[1]);
    }
    line.push([x_range[1], last[1]]);
    line
}

/// Slope at a point by Fritsch and Carlson: 0 at extremes, the harmonic mean of the neighbors
/// elsewhere.
fn slope(points: &[[f64; 2]], i: usize) -> f64 {
    let secant =
        |i: usize| (points[i + 1][1] - points[i][1]) / (points[i + 1][0] - points[i][0]).max(1e-9);
    if i == 0 {
        return secant(0);
    }
    if i + 1 == points.len() {
        return secant(i - 1);
    }
    let (a, b) = (secant(i - 1), secant(i));
    if a * b <= 0.0 { 0.0 } else { 2.0 * a * b / (a + b) }
}

fn hermite(pair: &[[f64; 2]], m0: f64, m1: f64, t: f64) -> [f64; 2] {
    let width = pair[1][0] - pair[0][0];
    let (t2, t3) = (t * t, t * t * t);
    let y = (2.0 * t3 - 3.0 * t2 + 1.0) * pair[0][1]
        + (t3 - 2.0 * t2 + t) * width * m0
        + (3.0 * t2 - 2.0 * t3) * pair[1][1]
        + (t3 - t2) * width * m1;
    [pair[0][0] + t * width, y]
}

/// Shows the choice of the interpolation between neighbors. Returns true if it changed.
pub(crate) fn interpolation(ui: &mut Ui, label: Id, current: &mut Interpolation) -> bool {
    let name = |interpolation| match interpolation {
        Interpolation::Linear => tr!("Straight"),
        Interpolation::Smooth => tr!("Smooth"),
        Interpolation::Stepped => tr!("Stepped"),
    };
    let before = *current;
    let combo =
        ComboBox::from_id_salt("interpolation").selected_text(name(before)).show_ui(ui, |ui| {
            for choice in [Interpolation::Linear, Interpolation::Smooth, Interpolation::Stepped] {
                ui.selectable_value(current, choice, name(choice));
            }
        });
    combo.response.labelled_by(label);
    *current != before
}
