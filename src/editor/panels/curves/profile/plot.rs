//! Plot of a profile: the tone over the angle, with handles that keep their order.

use std::f64::consts::PI;
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::epaint::PathShape;
use eframe::egui::{
    Align2, Color32, FontId, Key, Pos2, Rect, Role, Sense, Shape as Drawn, Stroke, Ui, Vec2,
    WidgetInfo,
};
use eframe::egui::{pos2, vec2};

use super::sample::Bend;
use super::{ANGLES, Curve, ProfileNode};
use crate::commands::Command;
use crate::document::Value;
use crate::fields::edge::{EdgeField, ProfileEdge};
use crate::values;
use crate::widgets::handle::{self, HandleResponse, handle};
use crate::widgets::theme;

/// Margins for the numbers of the axes, in points.
const LEFT: f32 = 26.0;
const RIGHT: f32 = 14.0;
const TOP: f32 = 20.0;
const BOTTOM: f32 = 18.0;

/// Curves to draw.
pub(super) struct Curves {
    pub(super) own: Arc<Curve>,
    /// Curves where the surface is as convex, and as concave, as it can be.
    pub(super) warped: [Arc<Curve>; 2],
    /// Curves at each key that moves the profile, with the key's index.
    pub(super) keys: Vec<(usize, Arc<Curve>)>,
}

/// Area of the plot; maps angles and tones to the screen.
#[derive(Clone, Copy)]
struct Axes(Rect);

impl Axes {
    fn x(self, radians: f64) -> f32 {
        self.0.left() + (radians / PI) as f32 * self.0.width()
    }

    fn y(self, tone: f64) -> f32 {
        self.0.bottom() - tone as f32 * self.0.height()
    }

    fn at(self, radians: f64, tone: f64) -> Pos2 {
        pos2(self.x(radians), self.y(tone))
    }

    fn angle(self, x: f32) -> f64 {
        f64::from((x - self.0.left()) / self.0.width().max(1.0)) * PI
    }

    fn line(self, curve: &Curve) -> Vec<Pos2> {
        curve.angles.iter().zip(&curve.tones).map(|(&u, &tone)| self.at(u, tone)).collect()
    }
}

/// Color of offset, fall-off or cut-off.
pub(super) fn color_of(ui: &Ui, part: usize) -> Color32 {
    let colors = theme::of(ui);
    [colors.accent, colors.second, colors.third][part]
}

/// Draws the curves and handles the pointer. Returns the area whose horizontal range is that of the
/// angles.
pub(super) fn show(
    ui: &mut Ui,
    layer: &ProfileNode<'_>,
    curves: &Curves,
    size: Vec2,
    can_edit: bool,
    out: &mut Vec<Command>,
) -> Rect {
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| {
        WidgetInfo::labeled(
            Role::Canvas,
            true,
            tr!("Tone of {name} over the angle", name = layer.name()),
        )
    });
    let area = Rect::from_min_max(rect.min + vec2(LEFT, TOP), rect.max - vec2(RIGHT, BOTTOM));
    let axes = Axes(area);
    ground(ui, rect, axes);
    paint_curves(ui, layer, axes, curves);
    let handles = handles(ui, layer, axes, curves, can_edit);
    for (index, (at, handled)) in handles.iter().enumerate() {
        if let Some(edit) = moved(ui, layer, axes, index, handled) {
            out.push(edit);
        }
        paint_handle(ui, layer, axes, index, *at, handled);
    }
    labels(ui, layer, axes, &handles);
    if let (Some(pointer), true) =
        (response.hover_pos(), handles.iter().all(|(_, h)| !h.response.dragged()))
    {
        read_off(ui, axes, &curves.own, pointer);
    }
    area
}

fn ground(ui: &Ui, rect: Rect, Axes(area): Axes) {
    let colors = theme::of(ui);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 4.0, colors.canvas);
    let font = FontId::proportional(theme::SMALL_TEXT);
    let axes = Axes(area);
    for step in 0..=6 {
        let u = f64::from(step) * PI / 6.0;
        let strength = if step == 3 { 1.0 } else { 0.6 };
        painter.vline(
            axes.x(u),
            area.y_range(),
            Stroke::new(1.0, colors.grid.gamma_multiply(strength)),
        );
        let text = format!("{}°", 30 * step);
        painter.text(
            pos2(axes.x(u), area.bottom() + 3.0),
            Align2::CENTER_TOP,
            text,
            font.clone(),
            colors.dim,
        );
    }
    for (tone, text) in [(0.0, "0"), (0.5, ""), (1.0, "1")] {
        painter.hline(area.x_range(), axes.y(tone), Stroke::new(1.0, colors.grid));
        let at = pos2(area.left() - 6.0, axes.y(tone));
        painter.text(at, Align2::RIGHT_CENTER, text, font.clone(), colors.dim);
    }
}

fn paint_curves(ui: &Ui, layer: &ProfileNode<'_>, axes: Axes, curves: &Curves) {
    let colors = theme::of(ui);
    let painter = ui.painter();
    if layer.warp() != 0.0 {
        let [convex, concave] = &curves.warped;
        painter.add(PathShape::line(axes.line(convex), Stroke::new(1.0, colors.dim)));
        painter.extend(Drawn::dashed_line(
            &axes.line(concave),
            Stroke::new(1.0, colors.dim),
            4.0,
            3.0,
        ));
        legend(ui, axes);
    }
    for (key, curve) in &curves.keys {
        painter.add(PathShape::line(
            axes.line(curve),
            Stroke::new(1.5, colors.hue(*key).gamma_multiply(0.75)),
        ));
    }
    painter.add(PathShape::line(axes.line(&curves.own), Stroke::new(2.0, colors.text)));
    if let Bend::Twice(second) | Bend::Elsewhere(second) = Bend::of(layer.shape) {
        let at = axes.at(second, tone_at(&curves.own, second));
        let diamond =
            [vec2(0.0, -5.0), vec2(5.0, 0.0), vec2(0.0, 5.0), vec2(-5.0, 0.0)].map(|d| at + d);
        painter.add(Drawn::convex_polygon(
            diamond.to_vec(),
            colors.canvas,
            Stroke::new(1.5, colors.warning),
        ));
        let font = FontId::proportional(theme::SMALL_TEXT);
        painter.text(
            at + vec2(8.0, -8.0),
            Align2::LEFT_CENTER,
            tr!("bends here"),
            font,
            colors.warning,
        );
    }
}

/// Names the faint curves, as the reader rarely knows them.
fn legend(ui: &Ui, axes: Axes) {
    let colors = theme::of(ui);
    let (painter, font) = (ui.painter(), FontId::proportional(theme::SMALL_TEXT));
    for (row, text) in [tr!("most convex"), tr!("most concave")].into_iter().enumerate() {
        let y = axes.0.top() + 9.0 + 14.0 * row as f32;
        let rect = painter.text(
            pos2(axes.0.right() - 4.0, y),
            Align2::RIGHT_CENTER,
            text,
            font.clone(),
            colors.dim,
        );
        let line = [pos2(rect.left() - 24.0, y), pos2(rect.left() - 6.0, y)];
        let stroke = Stroke::new(1.0, colors.dim);
        match row {
            0 => drop(painter.line_segment(line, stroke)),
            _ => painter.extend(Drawn::dashed_line(&line, stroke, 4.0, 3.0)),
        }
    }
}

/// Tone of a sampled curve at an angle.
fn tone_at(curve: &Curve, u: f64) -> f64 {
    let index =
        curve.angles.partition_point(|&known| known < u).min(curve.angles.len().saturating_sub(1));
    curve.tones.get(index).copied().unwrap_or(0.0)
}

/// Handles and their positions: the offset on top, the cut-off below, the fall-off on the curve,
/// but never on one of the others.
fn handles(
    ui: &Ui,
    layer: &ProfileNode<'_>,
    axes: Axes,
    curves: &Curves,
    can_edit: bool,
) -> [(Pos2, HandleResponse); 3] {
    let shape = layer.shape.sanitized();
    let is_step = Bend::of(layer.shape) == Bend::Step;
    let middle = if is_step { 0.5 } else { tone_at(&curves.own, shape.falloff).clamp(0.16, 0.84) };
    let places = [(shape.offset, 1.0), (shape.falloff, middle), (shape.cutoff, 0.0)];
    [0, 1, 2].map(|index| {
        let (u, tone) = places[index];
        let at = axes.at(u, tone);
        let id = ui.scope_id().with(("handle", ANGLES[index].port));
        let label = ANGLES[index].handle.tr();
        (at, handle(ui, id, at, label, u.to_degrees(), can_edit && !layer.wired[index]))
    })
}

/// Range of a part, in radians: between its two neighbors.
fn limits(layer: &ProfileNode<'_>, part: usize) -> [f64; 2] {
    let shape = layer.shape.sanitized();
    let row = [0.0, shape.offset, shape.falloff, shape.cutoff, PI];
    [row[part], row[part + 2]]
}

/// Edit that moving a handle asks for: the part moves between its neighbors; with Shift all three
/// parts move together.
fn moved(
    ui: &Ui,
    layer: &ProfileNode<'_>,
    axes: Axes,
    part: usize,
    handled: &HandleResponse,
) -> Option<Command> {
    let shape = layer.shape.sanitized();
    let own = [shape.offset, shape.falloff, shape.cutoff];
    let wished = match handled.to {
        Some(to) => axes.angle(to.x).to_degrees(),
        None if handled.steps.x != 0.0 => own[part].to_degrees() + f64::from(handled.steps.x),
        None => return None,
    };
    let to_grid = |degrees: f64| {
        let grid = if handled.to.is_some() { 2.0 } else { 10.0 };
        ((degrees * grid).round() / grid).to_radians()
    };
    let target = |index: usize| layer.target(ANGLES[index].port);
    let is_free = !layer.wired.contains(&true);
    let edit = if ui.input(|input| input.modifiers.shift) && handled.to.is_some() && is_free {
        let shift = (to_grid(wished) - own[part]).clamp(-own[0], PI - own[2]);
        layer
            .session
            .keys()
            .set_all_at([0, 1, 2].map(|index| (target(index), Value::Number(own[index] + shift))))
    } else {
        if let Some((field, edge)) = whole_edge(ui, layer, part) {
            return Some(field.set(handled.response.id, edge.moved_to(to_grid(wished))));
        }
        let [low, high] = limits(layer, part);
        layer.session.keys().set_at(&target(part), Value::Number(to_grid(wished).clamp(low, high)))
    };
    Some(Command::EditHeld(handled.response.id, edit))
}

/// Edge that the handle of the fall-off takes along: unless Ctrl is held it stands for the edge,
/// where the profile is one.
fn whole_edge<'a>(
    ui: &Ui,
    layer: &'a ProfileNode<'_>,
    part: usize,
) -> Option<(EdgeField<'a>, ProfileEdge)> {
    if part != 1 || ui.input(|input| input.modifiers.command) {
        return None;
    }
    let field = layer.edge_field()?;
    let edge = field.edge()?;
    Some((field, edge))
}

fn paint_handle(
    ui: &mut Ui,
    layer: &ProfileNode<'_>,
    axes: Axes,
    part: usize,
    at: Pos2,
    handled: &HandleResponse,
) {
    let colors = theme::of(ui);
    let color = color_of(ui, part);
    let is_held = handled.response.dragged();
    let is_hot = is_held || handled.response.hovered() || handled.response.has_focus();
    let painter = ui.painter();
    let stem = Stroke::new(1.0, color.gamma_multiply(if is_hot { 0.9 } else { 0.45 }));
    painter.extend(Drawn::dashed_line(
        &[pos2(at.x, axes.0.top()), pos2(at.x, axes.0.bottom())],
        stem,
        3.0,
        3.0,
    ));
    if is_held {
        reach(ui, layer, axes, part, handled);
    }
    let radius = if is_hot { 6.5 } else { 5.5 };
    let fill = if is_held { color } else { colors.canvas };
    painter.circle(at, radius, fill, Stroke::new(2.0, color));
    handle::focus_ring(ui, &handled.response, at, radius);
    let what = ANGLES[part].help;
    let help = match whole_edge(ui, layer, part) {
        Some(_) => {
            tr!("{what}. Drag, or arrow keys (Shift: a tenth). It moves the whole edge; Ctrl-drag \
                 moves it alone.")
        }
        None => tr!("{what}. Drag, or arrow keys (Shift: a tenth). Shift-drag moves all three."),
    };
    if !is_held {
        handled.response.clone().on_hover_text(help);
    }
    // Escape ends the handle's focus here, before the same key can leave the panel.
    if handle::pressed(ui, &handled.response, Key::Escape) {
        handled.response.surrender_focus();
    }
}

/// Names the handles, each beside its handle where it covers no other handle or name: the three of
/// a cartoon profile nearly coincide.
fn labels(ui: &Ui, layer: &ProfileNode<'_>, axes: Axes, handles: &[(Pos2, HandleResponse); 3]) {
    let shape = layer.shape.sanitized();
    let values = [shape.offset, shape.falloff, shape.cutoff];
    let font = FontId::proportional(theme::SMALL_TEXT);
    let room = axes.0.expand2(vec2(RIGHT, TOP + 4.0));
    let mut taken: Vec<Rect> =
        handles.iter().map(|(at, _)| Rect::from_center_size(*at, Vec2::splat(13.0))).collect();
    // The handle in use is named first, as its name is the longest and must move the least.
    let mut order = [0, 2, 1];
    order.sort_by_key(|part| !is_hot(&handles[*part].1));
    for part in order {
        let (at, handled) = &handles[part];
        let text = match is_hot(handled) {
            true => format!(
                "{} {}°",
                ANGLES[part].label,
                values::number_text(values[part].to_degrees(), 1)
            ),
            false => ANGLES[part].label.tr().to_owned(),
        };
        let galley = ui.painter().layout_no_wrap(text, font.clone(), color_of(ui, part));
        let rect = place(&taken, room, *at, galley.size(), part);
        // The curve and its stems run below the names, not through them.
        ui.painter().rect_filled(
            rect.expand2(vec2(2.0, -1.0)),
            2.0,
            theme::of(ui).canvas.gamma_multiply(0.8),
        );
        ui.painter().galley(rect.min, galley, color_of(ui, part));
        taken.push(rect);
    }
}

fn is_hot(handled: &HandleResponse) -> bool {
    handled.response.dragged() || handled.response.hovered() || handled.response.has_focus()
}

/// Rectangle of a handle's name: of the places around the handle, the first of those within the
/// room that cover least.
fn place(taken: &[Rect], room: Rect, at: Pos2, size: Vec2, part: usize) -> Rect {
    let above = (Align2::CENTER_BOTTOM, vec2(0.0, -7.0));
    let sides = [(Align2::LEFT_CENTER, 11.0), (Align2::RIGHT_CENTER, -11.0)];
    let beside = [0.0, -14.0, 14.0, -28.0, 28.0]
        .into_iter()
        .flat_map(|y| sides.map(|(align, x)| (align, vec2(x, y))));
    let first = (part != 1).then_some(above);
    let rects = first.into_iter().chain(beside).map(|(align, by)| align.anchor_size(at + by, size));
    let within = |rect: Rect| {
        let left = rect.left().clamp(room.left(), (room.right() - size.x).max(room.left()));
        Rect::from_min_size(pos2(left, rect.top()), size)
    };
    let covers = |rect: &Rect| -> f32 {
        let common = |other: &Rect| {
            let common = rect.intersect(*other);
            if common.is_positive() { common.area() } else { 0.0 }
        };
        let outside =
            if room.y_range().contains(rect.top()) && room.y_range().contains(rect.bottom()) {
                0.0
            } else {
                size.x * size.y
            };
        taken.iter().map(common).sum::<f32>() + outside
    };
    rects
        .map(within)
        .min_by(|a, b| covers(a).total_cmp(&covers(b)))
        .unwrap_or(Rect::from_min_size(at, size))
}

/// Shows the range of a handle while it is dragged, and the limit that stops it.
fn reach(ui: &Ui, layer: &ProfileNode<'_>, axes: Axes, part: usize, handled: &HandleResponse) {
    let colors = theme::of(ui);
    let painter = ui.painter();
    let [low, high] = limits(layer, part);
    let is_all = ui.input(|input| input.modifiers.shift);
    if is_all || whole_edge(ui, layer, part).is_some() {
        return;
    }
    let band = Rect::from_x_y_ranges(axes.x(low)..=axes.x(high), axes.0.y_range());
    painter.rect_filled(band, 0.0, color_of(ui, part).gamma_multiply(0.08));
    let Some(to) = handled.to else { return };
    let (limit, other) = match to.x {
        x if x < axes.x(low) - 2.0 && part > 0 => (low, part - 1),
        x if x > axes.x(high) + 2.0 && part < 2 => (high, part + 1),
        _ => return,
    };
    painter.vline(axes.x(limit), axes.0.y_range(), Stroke::new(2.0, colors.warning));
    let is_right = axes.x(limit) > axes.0.center().x;
    let (align, dx) =
        if is_right { (Align2::RIGHT_CENTER, -8.0) } else { (Align2::LEFT_CENTER, 8.0) };
    let text = ANGLES[other].stop.tr().to_owned();
    let font = FontId::proportional(theme::TEXT_SIZE);
    let galley = painter.layout_no_wrap(text, font, colors.warning);
    let at = align.anchor_size(pos2(axes.x(limit) + dx, axes.y(0.72)), galley.size());
    // A text that is longer than the room beside the limit lies over it.
    let room = axes.0.left()..=(axes.0.right() - at.width()).max(axes.0.left());
    let at =
        Rect::from_min_size(pos2(at.left().clamp(*room.start(), *room.end()), at.top()), at.size());
    painter.rect_filled(at.expand(3.0), 3.0, colors.canvas);
    painter.galley(at.min, galley, colors.warning);
}

/// Shows the tone under the pointer.
fn read_off(ui: &Ui, axes: Axes, curve: &Curve, pointer: Pos2) {
    if !axes.0.contains(pointer) || curve.tones.is_empty() {
        return;
    }
    let colors = theme::of(ui);
    let u = axes.angle(pointer.x);
    let tone = tone_at(curve, u);
    let at = axes.at(u, tone);
    ui.painter().circle_filled(at, 2.5, colors.text);
    let degrees = values::number_text(u.to_degrees(), 0);
    let text = format!("{degrees}°: {}", values::number_text(tone, 2));
    let font = FontId::proportional(theme::SMALL_TEXT);
    let corner = pos2(axes.0.right(), axes.0.top() - 4.0);
    ui.painter().text(corner, Align2::RIGHT_BOTTOM, text, font, colors.dim);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_handles_that_are_near_each_other_stand_apart() {
        let room = Rect::from_min_size(Pos2::ZERO, vec2(420.0, 160.0));
        for (offset, falloff, cutoff) in
            [(100.0, 104.0, 108.0), (0.0, 0.0, 0.0), (418.0, 419.0, 420.0), (40.0, 200.0, 400.0)]
        {
            let handles = [pos2(offset, 20.0), pos2(falloff, 80.0), pos2(cutoff, 140.0)];
            let mut taken: Vec<Rect> =
                handles.map(|at| Rect::from_center_size(at, Vec2::splat(13.0))).to_vec();
            for part in [0, 2, 1] {
                let rect = place(&taken, room, handles[part], vec2(60.0, 14.0), part);
                assert!(room.contains_rect(rect), "{rect}");
                assert!(
                    !taken.iter().any(|other| other.intersect(rect).is_positive()),
                    "{part} of {handles:?}: {rect}"
                );
                taken.push(rect);
            }
        }
    }
}
