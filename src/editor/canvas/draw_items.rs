//! Draws frames, notes, and the effects that the current drag would have.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::epaint::Mesh;
use eframe::egui::{Color32, FontId, Galley, Painter, Pos2, Rect, Ui, pos2, vec2};

use super::draw::{Pen, SOCKETS, mixed};
use super::inplace::Item;
use super::mesh::{glyphs, plain, ribbon, rounded, socket};
use super::overlay::color;
use super::table::{curve_between, point_at};
use super::{Canvas, Gesture};
use crate::drawing::FRAME_TITLE;
use crate::drawing::TEXT_SIZE;
use crate::library::Type;
use crate::widgets::theme;

/// Padding between a note's edge and its text, in points of the graph.
const PADDING: f32 = 9.0;

impl Canvas {
    /// Lays out the text of notes and sets their heights by it.
    pub(super) fn measure_notes(&mut self, ui: &Ui) {
        for note in self.table.notes.iter_mut().filter(|note| note.text.is_none()) {
            let text = lay_out(
                ui.painter(),
                &note.content,
                2 * TEXT_SIZE as i32,
                note.rect.width(),
                Color32::PLACEHOLDER,
            );
            note.rect.set_height(text.size().y + 2.0 * PADDING);
            note.text = Some((0, text));
        }
    }

    pub(super) fn draw_frames(&mut self, mesh: &mut Mesh, pen: &Pen<'_>) {
        let chosen = match &self.item {
            Some(Item::Frame(id)) => Some(id.clone()),
            _ => None,
        };
        let target = match &self.gesture {
            Gesture::Move(drag) => drag.frame.clone(),
            _ => None,
        };
        let view = self.view;
        for frame in self.table.frames.iter_mut().filter(|frame| frame.rect.intersects(pen.visible))
        {
            let r = view.rect_to_screen(frame.rect);
            let tint = frame.color.map_or(pen.colors.window_edge, color);
            let round = (8.0 * pen.zoom).min(10.0);
            let is_marked =
                chosen.as_ref() == Some(&frame.id) || target.as_ref() == Some(&frame.id);
            let edge =
                if is_marked { pen.colors.accent } else { mixed(pen.colors.canvas, tint, 0.6) };
            rounded(
                mesh,
                r.expand(if is_marked { 2.0 } else { 1.0 }),
                round + 1.0,
                (true, true),
                edge,
            );
            rounded(mesh, r, round, (true, true), mixed(pen.colors.canvas, tint, 0.2));
            let head = Rect::from_min_size(r.min, vec2(r.width(), FRAME_TITLE * pen.zoom));
            rounded(mesh, head, round, (true, false), mixed(pen.colors.canvas, tint, 0.38));
            if pen.zoom < SOCKETS * 0.5 {
                continue;
            }
            // Titles of frames stop shrinking at zoom 0.7, so that they can be read from afar.
            let half_points = ((TEXT_SIZE + 1.0) * pen.zoom.max(0.7) * 2.0).round() as i32;
            if frame.text.as_ref().is_none_or(|(size, _)| *size != half_points) {
                let title =
                    if frame.title.is_empty() { tr!("node" => "Frame") } else { &frame.title };
                let text =
                    one_line(pen.painter, title, half_points, r.width() - 20.0, pen.colors.text);
                frame.text = Some((half_points, text));
            }
            if let Some((_, text)) = &frame.text {
                let at = pos2(r.min.x + 10.0, head.center().y - text.size().y / 2.0);
                glyphs(mesh, at, text, pen.uv, pen.pixels);
            }
        }
    }

    pub(super) fn draw_notes(&mut self, mesh: &mut Mesh, pen: &Pen<'_>) {
        let chosen = match &self.item {
            Some(Item::Note(id)) => Some(id.clone()),
            _ => None,
        };
        let view = self.view;
        for note in self.table.notes.iter_mut().filter(|note| note.rect.intersects(pen.visible)) {
            let r = view.rect_to_screen(note.rect);
            let tint = note.color.map_or(pen.colors.warning, color);
            let round = (4.0 * pen.zoom).min(6.0);
            let is_chosen = chosen.as_ref() == Some(&note.id);
            let edge =
                if is_chosen { pen.colors.accent } else { mixed(pen.colors.canvas, tint, 0.45) };
            rounded(
                mesh,
                r.expand(if is_chosen { 2.0 } else { 1.0 }),
                round + 1.0,
                (true, true),
                edge,
            );
            rounded(mesh, r, round, (true, true), mixed(pen.colors.node, tint, 0.12));
            if pen.zoom < SOCKETS {
                continue;
            }
            let half_points = (TEXT_SIZE * pen.zoom * 2.0).round() as i32;
            if note.text.as_ref().is_none_or(|(size, _)| *size != half_points) {
                let width = note.rect.width() * pen.zoom;
                note.text = Some((
                    half_points,
                    lay_out(pen.painter, &note.content, half_points, width, pen.colors.text),
                ));
            }
            if let Some((_, text)) = &note.text {
                glyphs(mesh, r.min + vec2(PADDING, PADDING) * pen.zoom, text, pen.uv, pen.pixels);
            }
        }
    }

    /// Draws a mark where a wire's value is converted to another type: both colors, in the new
    /// type's shape.
    pub(super) fn draw_conversion(
        &self,
        mesh: &mut Mesh,
        pen: &Pen<'_>,
        c: &[Pos2; 4],
        (from, to): (&Type, &Type),
    ) {
        let at = point_at(c, 0.5);
        let radius = theme::SOCKET * pen.zoom;
        let shape = theme::SocketShape::of(to);
        socket(mesh, shape, at, radius + 2.0, pen.colors.of_type(from));
        socket(mesh, shape, at, radius + 0.5, pen.colors.canvas);
        socket(mesh, shape, at, radius - 1.0 * pen.zoom, pen.colors.of_type(to));
    }

    /// Draws the effects that the current drag would have: rectangles, strokes, guide lines and new
    /// wires.
    pub(super) fn draw_gesture(&self, mesh: &mut Mesh, pen: &Pen<'_>, pointer: Option<Pos2>) {
        let clip = self.view.screen.expand(4.0);
        let accent = pen.colors.accent;
        let mut line = |a: Pos2, b: Pos2, color| {
            let (a, b) = (self.view.to_screen(a), self.view.to_screen(b));
            ribbon(
                mesh,
                &[a, a + (b - a) / 3.0, a + (b - a) * (2.0 / 3.0), b],
                1.2,
                color,
                clip,
                1.0,
            );
        };
        match (&self.gesture, pointer) {
            (Gesture::Box { from, .. }, Some(to)) => {
                let r = Rect::from_two_pos(self.view.to_screen(*from), to);
                plain(mesh, r, accent.gamma_multiply(0.12));
                for (a, b) in [
                    (r.left_top(), r.right_top()),
                    (r.right_top(), r.right_bottom()),
                    (r.right_bottom(), r.left_bottom()),
                    (r.left_bottom(), r.left_top()),
                ] {
                    plain(mesh, Rect::from_two_pos(a, b).expand(0.5), accent.gamma_multiply(0.6));
                }
            }
            (Gesture::Lasso { path, .. }, _) => {
                path.windows(2).for_each(|piece| line(piece[0], piece[1], accent));
                if let (Some(&first), Some(&last)) = (path.first(), path.last()) {
                    line(last, first, accent.gamma_multiply(0.4));
                }
            }
            (Gesture::Cut { path }, _) => {
                path.windows(2).for_each(|piece| line(piece[0], piece[1], pen.colors.error));
            }
            (Gesture::Move(drag), _) => {
                for &(is_upright, at, [from, to]) in &drag.guides {
                    let (a, b) = if is_upright {
                        (pos2(at, from), pos2(at, to))
                    } else {
                        (pos2(from, at), pos2(to, at))
                    };
                    line(a, b, accent);
                }
                if let Some((from, to)) = drag.joins {
                    let c = curve_between(self.table.place(from), self.table.place(to))
                        .map(|p| self.view.to_screen(p));
                    let color =
                        pen.colors.of_type(&self.table.socket_type(from)).gamma_multiply(0.7);
                    ribbon(mesh, &c, (2.4 * pen.zoom).max(1.5), color, clip, 0.25);
                }
            }
            _ => {}
        }
    }
}

/// Lays out a note's text, broken at the note's width.
fn lay_out(
    painter: &Painter,
    text: &str,
    half_points: i32,
    width: f32,
    color: Color32,
) -> Arc<Galley> {
    let size = half_points as f32 / 2.0;
    let padding = PADDING * size / TEXT_SIZE;
    painter.layout(
        text.to_owned(),
        FontId::proportional(size),
        color,
        (width - 2.0 * padding).max(10.0),
    )
}

fn one_line(
    painter: &Painter,
    text: &str,
    half_points: i32,
    width: f32,
    color: Color32,
) -> Arc<Galley> {
    super::text::one_line(painter, text, half_points as f32 / 2.0, width, color)
}
