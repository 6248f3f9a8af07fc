//! Icons of the tools, drawn by lines.

use eframe::egui::{
    Color32, Painter, Pos2, Response, Role, Sense, Shape, Stroke, Ui, WidgetInfo, vec2,
};

use crate::commands::PaintTool;
use crate::widgets::theme;

/// Side of a tool's button, in points.
const SIDE: f32 = 28.0;

/// Shows a tool's button.
pub(super) fn button(ui: &mut Ui, kind: PaintTool, is_on: bool) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(SIDE, SIDE), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_on, kind.label()));
    let colors = theme::of(ui);
    let fill = match (is_on, response.hovered()) {
        (true, _) => colors.accent_dim,
        (false, true) => colors.field_hovered,
        (false, false) => colors.field,
    };
    ui.painter().rect_filled(rect, 4.0, fill);
    if is_on || response.has_focus() {
        let edge = Stroke::new(1.0, colors.accent);
        ui.painter().rect_stroke(rect, 4.0, edge, eframe::egui::StrokeKind::Inside);
    }
    draw(ui.painter(), kind, rect.center(), colors.text);
    response.on_hover_text(format!("{}: {}", kind.label(), kind.help()))
}

fn draw(painter: &Painter, kind: PaintTool, at: Pos2, ink: Color32) {
    let stroke = Stroke::new(1.6, ink);
    let p = |x: f32, y: f32| at + vec2(x, y);
    let line = |a: (f32, f32), b: (f32, f32)| {
        painter.line_segment([p(a.0, a.1), p(b.0, b.1)], stroke);
    };
    match kind {
        PaintTool::Paint => {
            line((7.5, -7.5), (-1.0, 1.0));
            line((5.5, -8.5), (-2.5, -0.5));
            let tip = vec![p(-2.5, -0.5), p(1.0, 2.5), p(-3.0, 6.5), p(-8.0, 7.5), p(-6.0, 3.0)];
            painter.add(Shape::convex_polygon(tip, ink, Stroke::NONE));
        }
        PaintTool::Erase => {
            let body = vec![p(-7.0, 2.0), p(1.0, -7.0), p(7.0, -2.0), p(-1.0, 7.0)];
            painter.add(Shape::closed_line(body, stroke));
            let end = vec![p(-7.0, 2.0), p(-3.6, -1.8), p(2.4, 3.2), p(-1.0, 7.0)];
            painter.add(Shape::convex_polygon(end, ink, Stroke::NONE));
        }
        PaintTool::Smudge => {
            for (index, radius) in [5.5_f32, 4.0, 2.4].into_iter().enumerate() {
                let fade = ink.gamma_multiply([0.35, 0.6, 1.0][index]);
                painter.circle_filled(
                    p(-5.0 + 5.5 * index as f32, 4.0 - 5.0 * index as f32),
                    radius,
                    fade,
                );
            }
        }
        PaintTool::Line => {
            line((-6.5, 6.5), (6.5, -6.5));
            for end in [p(-6.5, 6.5), p(6.5, -6.5)] {
                painter.circle_filled(end, 2.4, ink);
            }
        }
        PaintTool::Fill => {
            let bucket = vec![p(-6.0, -1.0), p(0.5, -7.0), p(6.0, -1.5), p(-0.5, 5.0)];
            painter.add(Shape::closed_line(bucket, stroke));
            painter.add(Shape::convex_polygon(
                vec![p(-6.0, -1.0), p(6.0, -1.5), p(-0.5, 5.0)],
                ink,
                Stroke::NONE,
            ));
            let drop = vec![p(7.0, 1.0), p(8.8, 5.0), p(7.0, 7.5), p(5.2, 5.0)];
            painter.add(Shape::convex_polygon(drop, ink, Stroke::NONE));
        }
        PaintTool::Stamp => {
            painter.circle_filled(p(0.0, -5.0), 3.6, ink);
            painter.add(Shape::convex_polygon(
                vec![p(-1.6, -3.0), p(1.6, -3.0), p(2.4, 3.0), p(-2.4, 3.0)],
                ink,
                Stroke::NONE,
            ));
            painter.rect_filled(
                eframe::egui::Rect::from_min_max(p(-7.0, 2.6), p(7.0, 5.0)),
                1.0,
                ink,
            );
            line((-7.0, 7.6), (7.0, 7.6));
        }
        PaintTool::Pick => {
            line((-7.0, 7.0), (1.5, -1.5));
            line((-4.6, 7.6), (3.4, -0.4));
            line((-0.5, -3.5), (3.8, 0.8));
            painter.circle_filled(p(4.6, -4.6), 3.6, ink);
        }
    }
}
