//! Drawing of a highlight's handles, each with a mark of its own.

use chiaro_locale::tr;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Ui, Vec2, vec2};

use super::frame::HandleFrame;
use super::handle::{HighlightHandle, Side};
use super::{HeldHighlight, HighlightGizmo, within};
use crate::widgets::theme;

/// Radius of a handle, of one under the pointer, and of one that begins a shape, in points.
const SIZE: f32 = 5.0;
const HELD: f32 = 6.5;
const IDLE: f32 = 2.5;

/// Colors and sizes of the handles of one frame.
#[derive(Clone, Copy)]
struct HandleInk {
    size: f32,
    color: Color32,
    halo: Color32,
}

impl HighlightGizmo {
    /// Draws the handles; `marked` is dragged or under the pointer.
    pub(in crate::viewport) fn paint(
        &self,
        ui: &Ui,
        rect: Rect,
        marked: Option<&HeldHighlight>,
        is_near: bool,
    ) {
        let (Some(frame), Some(layer)) = (self.frame(rect), self.layer()) else { return };
        let painter = ui.painter_at(rect);
        let strength = if is_near || marked.is_some() { 1.0 } else { 0.6 };
        let is_marked = |handle| marked.is_some_and(|held| held.handle == handle);
        let halo = theme::HALO.gamma_multiply(strength);
        if !self.is_seen() {
            let at = within(rect, frame.at);
            let size = if is_marked(HighlightHandle::Middle) { HELD } else { SIZE };
            painter.circle_stroke(at, size, Stroke::new(4.0, halo));
            let color = theme::SUN.gamma_multiply(strength);
            painter.circle_stroke(at, size, Stroke::new(1.8, color));
            plate(&painter, rect, at, tr!("{layer} is out of sight", layer = layer.name));
            return;
        }
        self.paint_lines(&painter, rect, &frame, (is_marked(HighlightHandle::Ring), strength));
        for (handle, at) in self.handles(rect) {
            let is_held = is_marked(handle);
            let is_idle = handle.is_idle(layer) && !is_held;
            if is_idle && !is_near {
                continue;
            }
            let color = if is_held { Color32::WHITE } else { theme::SUN }.gamma_multiply(strength);
            if is_idle {
                painter.circle_filled(at, IDLE + 1.5, halo);
                painter.circle_filled(at, IDLE, color.gamma_multiply(0.8));
                continue;
            }
            let size = if is_held { HELD } else { SIZE };
            paint_handle(&painter, &frame, handle, (at, HandleInk { size, color, halo }));
        }
        if let Some(held) = marked {
            let at = within(rect, frame.place(held.handle));
            plate(&painter, rect, at, held.handle.value_text(layer));
        }
    }

    /// Draws the ring, and the axis along which the highlight is stretched and split.
    fn paint_lines(
        &self,
        painter: &Painter,
        rect: Rect,
        frame: &HandleFrame,
        (is_held, strength): (bool, f32),
    ) {
        let line = |width: f32, color: Color32| Stroke::new(width, color.gamma_multiply(strength));
        let ring = if is_held { 2.5 } else { 1.3 };
        painter.circle_stroke(frame.at, frame.ring(), line(ring + 2.0, theme::HALO));
        painter.circle_stroke(frame.at, frame.ring(), line(ring, theme::SUN));
        let ends = [HighlightHandle::Split(Side::Behind), HighlightHandle::Stretch];
        let ends = ends.map(|handle| within(rect, frame.place(handle)));
        painter.line_segment(ends, line(3.0, theme::HALO));
        painter.line_segment(ends, line(1.2, theme::SUN));
    }
}

/// Draws a handle with its mark.
fn paint_handle(
    painter: &Painter,
    frame: &HandleFrame,
    handle: HighlightHandle,
    (at, ink): (Pos2, HandleInk),
) {
    let HandleInk { size, color, halo } = ink;
    let [x, y] = frame.axes();
    let line = |ends: [Pos2; 2]| {
        painter.line_segment(ends, Stroke::new(4.0, halo));
        painter.line_segment(ends, Stroke::new(2.0, color));
    };
    match handle {
        HighlightHandle::Stretch => {
            let square = |size: f32| Rect::from_center_size(at, Vec2::splat(2.0 * size));
            painter.rect_filled(square(size + 1.5), 1.0, halo);
            painter.rect_filled(square(size - 0.5), 1.0, color);
        }
        HighlightHandle::Split(_) | HighlightHandle::SplitUp(_) => {
            let along = if matches!(handle, HighlightHandle::Split(_)) { x } else { y };
            let aside = along.rot90();
            for way in [-1.0, 1.0] {
                let place = at + way * 3.0 * along;
                line([place - size * aside, place + size * aside]);
            }
        }
        HighlightHandle::Square => {
            // A corner of the square, which points outward.
            let arms = [-1.5 * size * y, 1.5 * size * x];
            arms.into_iter().for_each(|arm| line([at, at + arm]));
        }
        HighlightHandle::Star => {
            let diamond = |size: f32| {
                let ends = [vec2(size, 0.0), vec2(0.0, size), vec2(-size, 0.0), vec2(0.0, -size)];
                ends.map(|end| at + end).to_vec()
            };
            let filled = |size: f32, color| {
                painter.add(Shape::convex_polygon(diamond(size), color, Stroke::NONE));
            };
            filled(size + 3.0, halo);
            filled(size + 0.5, color);
        }
        HighlightHandle::Rays => {
            for turn in 0..3_u8 {
                let arm = Vec2::angled(f32::from(turn) * std::f32::consts::PI / 3.0) * size;
                line([at - arm, at + arm]);
            }
        }
        HighlightHandle::Middle | HighlightHandle::Ring | HighlightHandle::Size => {
            painter.circle_filled(at, size + 2.0, halo);
            painter.circle_filled(at, size, color);
        }
    }
}

/// Writes words beside a handle, within the picture.
fn plate(painter: &Painter, rect: Rect, at: Pos2, text: String) {
    let font = FontId::proportional(theme::SMALL_TEXT);
    let galley = painter.layout_no_wrap(text, font, Color32::WHITE);
    let place = Align2::LEFT_TOP.anchor_size(at + vec2(9.0, 7.0), galley.size());
    let beyond = (place.max - rect.shrink(6.0).max).max(Vec2::ZERO);
    let place = place.translate(-beyond);
    painter.rect_filled(place.expand2(vec2(4.0, 1.5)), 3.0, theme::PLATE);
    painter.galley(place.min, galley, Color32::WHITE);
}
