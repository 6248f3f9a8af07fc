//! Draws the visible part of the canvas into one mesh, whose memory is used again each frame; the
//! farther the zoom, the less detail.
//!
//! Zoom above 0.4: everything. 0.25 to 0.4: titles and sockets. 0.1 to 0.25: boxes in two tones.
//! Below 0.1: plain boxes. Selection and errors show at every level.

use chiaro_locale::tr;
use eframe::egui;
use std::sync::Arc;

use eframe::egui::epaint::Mesh;
use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Ui, pos2, vec2};

use super::mesh::{glyphs, plain, ribbon, rounded, socket};
use super::table::{CanvasItem, Socket, curve_between};
use super::text::lay_out;
use super::{Canvas, Gesture};
use crate::diag::Severity;
use crate::document::Node;
use crate::drawing::{ROW_HEIGHT, TITLE_HEIGHT};
use crate::state::session::Session;
use crate::widgets::theme::{self, Colors};

pub(super) const ALL_TEXT: f32 = 0.4;
pub(super) const SOCKETS: f32 = 0.25;
const BOXES: f32 = 0.1;

/// Constants of one frame's drawing.
pub(super) struct Pen<'a> {
    pub(super) painter: &'a Painter,
    pub(super) colors: &'static Colors,
    pub(super) uv: egui::Vec2,
    pub(super) pixels: f32,
    pub(super) zoom: f32,
    pub(super) visible: Rect,
    session: &'a Session,
    /// Predicate of the sockets that the wire being drawn may end at; `None` while no wire is
    /// drawn.
    fits: Option<&'a dyn Fn(Socket) -> bool>,
}

impl Canvas {
    /// Draws the canvas, with a wire under way to `loose_end`.
    pub(super) fn draw(&mut self, ui: &Ui, session: &Session, loose_end: Option<Pos2>) {
        let painter = &ui.painter_at(self.view.screen);
        let fits = match &self.gesture {
            Gesture::Wire(drag) => Some(self.fitting_sockets(drag.fixed)),
            _ => None,
        };
        let fits = fits.as_ref().map(|fits| {
            move |socket: Socket| fits.contains(&(socket.node, socket.port, socket.is_output))
        });
        let mut buffer = std::mem::take(&mut self.buffer);
        // The renderer has dropped its share of the last frame's mesh by now, so `make_mut` copies
        // nothing.
        let mesh = Arc::make_mut(&mut buffer);
        mesh.clear();
        let [u, v] = painter.fonts(|fonts| fonts.font_image_size().map(|side| 1.0 / side as f32));
        let pen = Pen {
            painter,
            colors: theme::of(ui),
            uv: vec2(u, v),
            pixels: painter.pixels_per_point(),
            zoom: self.view.zoom,
            visible: self.view.visible(),
            session,
            fits: fits.as_ref().map(|fits| fits as &dyn Fn(Socket) -> bool),
        };
        mesh.add_colored_rect(self.view.screen, pen.colors.canvas);
        self.draw_grid(mesh, pen.colors);
        self.draw_frames(mesh, &pen);
        self.draw_notes(mesh, &pen);
        self.draw_wires(mesh, &pen);
        for index in 0..self.table.nodes.len() {
            if self.table.nodes[index].rect.expand(8.0).intersects(pen.visible) {
                self.draw_node(mesh, &pen, index);
            }
        }
        self.draw_loose_wire(mesh, pen.colors, loose_end);
        self.draw_gesture(mesh, &pen, loose_end);
        painter.add(Shape::Mesh(buffer.clone()));
        self.buffer = buffer;
    }

    fn draw_grid(&self, mesh: &mut Mesh, colors: &Colors) {
        const STEP: f32 = 24.0;
        let mut step = STEP;
        while step * self.view.zoom < 18.0 {
            step *= 4.0;
        }
        let visible = self.view.visible();
        let fade = ((step * self.view.zoom - 18.0) / 30.0).clamp(0.25, 1.0);
        let color = colors.grid.gamma_multiply(fade);
        let first =
            pos2((visible.min.x / step).floor() * step, (visible.min.y / step).floor() * step);
        let columns = (visible.width() / step) as usize + 2;
        let rows = (visible.height() / step) as usize + 2;
        for row in 0..rows {
            for column in 0..columns {
                let p = self.view.to_screen(first + vec2(column as f32, row as f32) * step);
                mesh.add_colored_rect(Rect::from_center_size(p, vec2(1.5, 1.5)), color);
            }
        }
    }

    fn draw_wires(&self, mesh: &mut Mesh, pen: &Pen<'_>) {
        let zoom = pen.zoom;
        let tolerance = if zoom < SOCKETS { 0.75 } else { 0.25 };
        let width = (2.4 * zoom).clamp(1.0, 4.0);
        // Wires fade with distance: at full strength they would cover everything.
        let fade = if zoom < SOCKETS { 0.35 + 0.65 * (zoom / SOCKETS) } else { 1.0 };
        let clip = self.view.screen.expand(4.0);
        let picked = match &self.gesture {
            Gesture::Wire(drag) => drag.picked,
            _ => None,
        };
        let cut = match &self.gesture {
            Gesture::Cut { path } => Some(path.as_slice()),
            _ => None,
        };
        for (index, wire) in self.table.wires.iter().enumerate() {
            if !wire.bounds.intersects(pen.visible) || picked == Some(wire.index) {
                continue;
            }
            let c = self.table.curve(wire).map(|p| self.view.to_screen(p));
            let is_hovered = self.hovered == Some(CanvasItem::Wire(index));
            let color = pen.colors.of_type(&wire.ty);
            let is_marked = match &self.gesture {
                Gesture::Move(drag) => drag.into == Some(index),
                _ => is_hovered,
            };
            let is_cut = cut.is_some_and(|path| self.is_cut(wire, path));
            let (width, color) = match (is_cut, is_marked) {
                (true, _) => (width + 1.5, pen.colors.error),
                (_, true) => (width + 1.5, lighter(color)),
                _ if self.table.nodes[wire.from.node].is_unused => {
                    (width, color.gamma_multiply(fade * 0.4))
                }
                _ => (width, color.gamma_multiply(fade)),
            };
            ribbon(mesh, &c, width, color, clip, tolerance);
            if let Some(becomes) = &wire.becomes
                && zoom > ALL_TEXT
            {
                self.draw_conversion(mesh, pen, &c, (&wire.ty, becomes));
            }
        }
    }

    fn draw_loose_wire(&self, mesh: &mut Mesh, colors: &Colors, end: Option<Pos2>) {
        let (Gesture::Wire(drag), Some(end)) = (&self.gesture, end) else { return };
        let fixed = self.table.place(drag.fixed);
        let end =
            drag.target.map_or_else(|| self.view.to_graph(end), |socket| self.table.place(socket));
        let c = if drag.fixed.is_output {
            curve_between(fixed, end)
        } else {
            curve_between(end, fixed)
        };
        let c = c.map(|p| self.view.to_screen(p));
        let color = colors.of_type(&self.table.socket_type(drag.fixed));
        ribbon(
            mesh,
            &c,
            (2.4 * self.view.zoom).max(1.5) + 0.6,
            color,
            self.view.screen.expand(4.0),
            0.25,
        );
    }

    fn draw_node(&mut self, mesh: &mut Mesh, pen: &Pen<'_>, index: usize) {
        let row = &self.table.nodes[index];
        let r = self.view.rect_to_screen(row.rect);
        let mark = self.marks.get(&row.id).map(|mark| mark.severity);
        let is_selected = pen.session.selection.nodes.contains(&row.id);
        let title = if row.kind.is_missing {
            pen.colors.error.gamma_multiply(0.5)
        } else {
            pen.colors.of_category(&row.kind.category)
        };
        let outline = if is_selected {
            Some(pen.colors.accent)
        } else {
            mark.filter(|severity| *severity == Severity::Error).map(|_| pen.colors.error)
        };
        if pen.zoom < BOXES {
            if let Some(color) = outline {
                plain(mesh, r.expand(1.5), color);
            }
            return plain(mesh, r, lighter(title));
        }
        let round = (6.0 * pen.zoom).min(8.0);
        let (edge, color) = match outline {
            Some(color) => ((1.2 + pen.zoom).min(2.5), color),
            None => (1.0, pen.colors.node_edge),
        };
        rounded(mesh, r.expand(edge), round + edge, (true, true), color);
        rounded(mesh, r, round, (true, true), pen.colors.node);
        let head = Rect::from_min_size(r.min, vec2(r.width(), TITLE_HEIGHT * pen.zoom));
        let is_hovered = self.hovered == Some(CanvasItem::Node(index));
        let is_head = row.is_collapsed;
        rounded(
            mesh,
            head,
            round,
            (true, is_head),
            if is_hovered { lighter(title) } else { title },
        );
        let is_dim = row.is_muted || self.idle_of(row).is_some();
        if pen.zoom > SOCKETS {
            self.draw_text(mesh, pen, index);
        }
        if is_dim {
            rounded(mesh, r, round, (true, true), pen.colors.canvas.gamma_multiply(0.55));
        }
        if pen.zoom > SOCKETS {
            self.draw_sockets(mesh, pen, index, is_dim);
        }
        if pen.zoom > SOCKETS
            && let Some((offset, tag)) = &self.table.nodes[index].text.tag
        {
            glyphs(mesh, r.min + *offset * pen.zoom, tag, pen.uv, pen.pixels);
        }
        self.draw_shot_mark(mesh, pen, index);
        if let Some(severity) = mark {
            self.draw_badge(mesh, pen, r, severity);
        }
    }

    fn draw_sockets(&self, mesh: &mut Mesh, pen: &Pen<'_>, index: usize, is_dim: bool) {
        // The sockets of a collapsed node lie on one another: only the first of each side is drawn,
        // and any that fits the wire being drawn.
        let row = &self.table.nodes[index];
        let is_first = |at: &Socket| {
            let mut sockets =
                self.table.sockets(index).filter(|other| other.is_output == at.is_output);
            sockets.next() == Some(*at) || pen.fits.is_some_and(|fits| fits(*at))
        };
        for at in self.table.sockets(index).filter(|at| !row.is_collapsed || is_first(at)) {
            let ty = &self.table.socket_type(at);
            let center = self.view.to_screen(self.table.place(at));
            let is_hovered = self.hovered == Some(CanvasItem::Socket(at));
            let is_out = pen.fits.is_some_and(|fits| !fits(at));
            let radius = theme::SOCKET * pen.zoom * if is_hovered && !is_out { 1.4 } else { 1.0 };
            let color = match (is_out, is_dim) {
                (true, _) => mixed(pen.colors.of_type(ty), pen.colors.node, 0.8),
                (_, true) => mixed(pen.colors.of_type(ty), pen.colors.canvas, 0.55),
                _ => pen.colors.of_type(ty),
            };
            if pen.zoom > ALL_TEXT {
                socket(
                    mesh,
                    theme::SocketShape::of(ty),
                    center,
                    radius + 1.5,
                    pen.colors.node_edge,
                );
            }
            socket(mesh, theme::SocketShape::of(ty), center, radius, color);
        }
    }

    fn draw_text(&mut self, mesh: &mut Mesh, pen: &Pen<'_>, index: usize) {
        let look = pen.session.look();
        let row = &self.table.nodes[index];
        let tag = match row.is_muted {
            true => tr!("node" => "muted"),
            false => self.idle_of(row).map_or("", |idle| idle.word.tr()),
        };
        let id = row.id.clone();
        let each_of = row.each_of.clone();
        let value = if tag.is_empty() {
            each_of.or_else(|| self.value_of(pen.session, &id).map(str::to_owned))
        } else {
            None
        };
        let row = &mut self.table.nodes[index];
        let end = Node::default();
        let node = match pen.session.graph().nodes.get(&row.id) {
            Some(node) => node,
            None if row.is_end => &end,
            None => return,
        };
        let has_rows = pen.zoom > ALL_TEXT;
        lay_out(
            row,
            (pen.painter, pen.colors),
            (pen.zoom, has_rows),
            pen.session.revision(),
            look,
            node,
            (tag, value.as_deref()),
        );
        let corner = self.view.to_screen(row.rect.min);
        for (offset, galley) in &row.text.lines {
            glyphs(mesh, corner + *offset * pen.zoom, galley, pen.uv, pen.pixels);
        }
        for (offset, name) in &row.text.passes {
            let size = vec2(name.size().x + 8.0 * pen.zoom, (ROW_HEIGHT - 5.0) * pen.zoom);
            let left = corner + *offset * pen.zoom;
            let tag = Rect::from_min_size(left - vec2(0.0, size.y / 2.0), size);
            rounded(mesh, tag, 3.0 * pen.zoom, (true, true), pen.colors.accent);
            let at = tag.center() - name.size() / 2.0;
            glyphs(mesh, at, name, pen.uv, pen.pixels);
        }
        for (offset, color) in &row.text.swatches {
            let size = vec2(28.0, ROW_HEIGHT - 7.0) * pen.zoom;
            let r = Rect::from_center_size(corner + *offset * pen.zoom, size);
            rounded(mesh, r.expand(1.0), 3.0 * pen.zoom, (true, true), pen.colors.swatch_edge);
            let [red, green, blue, alpha] =
                color.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
            // The left half is opaque, so that the hue of a transparent color is seen.
            rounded(mesh, r, 2.0 * pen.zoom, (true, true), Color32::from_rgb(red, green, blue));
            if alpha < 255 {
                let right = Rect::from_min_max(r.center_top(), r.max);
                mesh.add_colored_rect(right, pen.colors.node);
                mesh.add_colored_rect(
                    right,
                    Color32::from_rgba_unmultiplied(red, green, blue, alpha),
                );
            }
        }
    }

    fn draw_badge(&self, mesh: &mut Mesh, pen: &Pen<'_>, node: Rect, severity: Severity) {
        let color = if severity == Severity::Error { pen.colors.error } else { pen.colors.warning };
        let radius = (8.0 * pen.zoom).clamp(4.0, 10.0);
        let center = node.right_top() + vec2(-2.0 * pen.zoom, 2.0 * pen.zoom);
        socket(mesh, theme::SocketShape::Circle, center, radius + 1.5, pen.colors.node_edge);
        socket(mesh, theme::SocketShape::Circle, center, radius, color);
        // The mark is an exclamation mark, of two strokes.
        let unit = radius / 8.0;
        let stroke = |y: f32, height: f32| {
            Rect::from_center_size(center + vec2(0.0, y * unit), vec2(2.0, height) * unit)
        };
        mesh.add_colored_rect(stroke(-1.6, 5.6), pen.colors.node_edge);
        mesh.add_colored_rect(stroke(3.6, 2.0), pen.colors.node_edge);
    }
}

pub(super) fn lighter(color: Color32) -> Color32 {
    mixed(color, Color32::WHITE, 0.14)
}

pub(super) fn mixed(a: Color32, b: Color32, t: f32) -> Color32 {
    let mix = |a: u8, b: u8| (f32::from(a) + (f32::from(b) - f32::from(a)) * t).round() as u8;
    Color32::from_rgb(mix(a.r(), b.r()), mix(a.g(), b.g()), mix(a.b(), b.b()))
}
