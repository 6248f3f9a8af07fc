//! Draws what is in view into one mesh whose memory is used again each frame; far away, with less detail.
//!
//! Zoom above 0.4: everything. 0.25 to 0.4: titles and sockets. 0.1 to 0.25: boxes in two tones. Below: plain boxes.
//! Selection and errors show at every level.

use eframe::egui;
use std::sync::Arc;

use eframe::egui::epaint::Mesh;
use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Ui, pos2, vec2};

use super::super::session::Session;
use super::super::theme::{self, Colors, ROW_HEIGHT, TITLE_HEIGHT, type_shape};
use super::mesh::{glyphs, plain, ribbon, rounded, socket};
use super::table::{Hit, Socket, curve_between};
use super::text::lay_out;
use super::{Canvas, Gesture};
use crate::diag::Severity;

const ALL_TEXT: f32 = 0.4;
const SOCKETS: f32 = 0.25;
const BOXES: f32 = 0.1;

/// What a frame's drawing needs again and again.
struct Pen<'a> {
    painter: &'a Painter,
    colors: &'static Colors,
    uv: egui::Vec2,
    pixels: f32,
    zoom: f32,
    visible: Rect,
    session: &'a Session,
    /// While a wire is drawn: the sockets that it may end at.
    fits: Option<&'a dyn Fn(Socket) -> bool>,
}

impl Canvas {
    /// Draws the canvas, with a wire on its way to `loose_end`.
    pub(super) fn draw(&mut self, ui: &Ui, session: &Session, loose_end: Option<Pos2>) {
        let painter = &ui.painter_at(self.view.screen);
        let fits = match &self.gesture {
            Gesture::Wire(drag) => Some(self.fitting_sockets(drag.fixed)),
            _ => None,
        };
        let fits = fits
            .as_ref()
            .map(|fits| move |socket: Socket| fits.contains(&(socket.node, socket.port, socket.is_output)));
        let mut buffer = std::mem::take(&mut self.buffer);
        // The frame before has let go of its share by now, so this copies nothing.
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
        self.draw_wires(mesh, &pen);
        for index in 0..self.table.nodes.len() {
            if self.table.nodes[index].rect.expand(8.0).intersects(pen.visible) {
                self.draw_node(mesh, &pen, index);
            }
        }
        self.draw_loose_wire(mesh, pen.colors, loose_end);
        if let (Gesture::Box { from, .. }, Some(to)) = (&self.gesture, loose_end) {
            let r = Rect::from_two_pos(self.view.to_screen(*from), to);
            rounded(mesh, r, 2.0, (true, true), pen.colors.accent.gamma_multiply(0.12));
        }
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
        let first = pos2((visible.min.x / step).floor() * step, (visible.min.y / step).floor() * step);
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
        // Far away wires would cover everything.
        let fade = if zoom < SOCKETS { 0.35 + 0.65 * (zoom / SOCKETS) } else { 1.0 };
        let clip = self.view.screen.expand(4.0);
        let picked = match &self.gesture {
            Gesture::Wire(drag) => drag.picked,
            _ => None,
        };
        for (index, wire) in self.table.wires.iter().enumerate() {
            if !wire.bounds.intersects(pen.visible) || picked == Some(wire.index) {
                continue;
            }
            let c = self.table.curve(wire).map(|p| self.view.to_screen(p));
            let is_hovered = self.hovered == Some(Hit::Wire(index));
            let color = pen.colors.of_type(&wire.ty);
            let (width, color) =
                if is_hovered { (width + 1.5, lighter(color)) } else { (width, color.gamma_multiply(fade)) };
            ribbon(mesh, &c, width, color, clip, tolerance);
        }
    }

    fn draw_loose_wire(&self, mesh: &mut Mesh, colors: &Colors, end: Option<Pos2>) {
        let (Gesture::Wire(drag), Some(end)) = (&self.gesture, end) else { return };
        let fixed = self.table.place(drag.fixed);
        let end = drag.target.map_or_else(|| self.view.to_graph(end), |socket| self.table.place(socket));
        let c = if drag.fixed.is_output { curve_between(fixed, end) } else { curve_between(end, fixed) };
        let c = c.map(|p| self.view.to_screen(p));
        let color = colors.of_type(&self.table.socket_type(drag.fixed));
        ribbon(mesh, &c, (2.4 * self.view.zoom).max(1.5) + 0.6, color, self.view.screen.expand(4.0), 0.25);
    }

    fn draw_node(&mut self, mesh: &mut Mesh, pen: &Pen<'_>, index: usize) {
        let row = &self.table.nodes[index];
        let r = self.view.rect_to_screen(row.rect);
        let mark = self.marks.get(&row.id).map(|mark| mark.severity);
        let is_selected = pen.session.selection.contains(&row.id);
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
        let is_hovered = self.hovered == Some(Hit::Node(index));
        rounded(mesh, head, round, (true, false), if is_hovered { lighter(title) } else { title });
        if pen.zoom > SOCKETS {
            self.draw_sockets(mesh, pen, index);
            self.draw_text(mesh, pen, index);
        }
        if let Some(severity) = mark {
            self.draw_badge(mesh, pen, r, severity);
        }
    }

    fn draw_sockets(&self, mesh: &mut Mesh, pen: &Pen<'_>, index: usize) {
        for at in self.table.sockets(index) {
            let ty = &self.table.socket_type(at);
            let center = self.view.to_screen(self.table.place(at));
            let is_hovered = self.hovered == Some(Hit::Socket(at));
            let is_out = pen.fits.is_some_and(|fits| !fits(at));
            let radius = theme::SOCKET * pen.zoom * if is_hovered && !is_out { 1.4 } else { 1.0 };
            let color =
                if is_out { mixed(pen.colors.of_type(ty), pen.colors.node, 0.8) } else { pen.colors.of_type(ty) };
            if pen.zoom > ALL_TEXT {
                socket(mesh, type_shape(ty), center, radius + 1.5, pen.colors.node_edge);
            }
            socket(mesh, type_shape(ty), center, radius, color);
        }
    }

    fn draw_text(&mut self, mesh: &mut Mesh, pen: &Pen<'_>, index: usize) {
        let look = pen.session.look();
        let row = &mut self.table.nodes[index];
        let Some(node) = look.graph.nodes.get(&row.id) else { return };
        let has_rows = pen.zoom > ALL_TEXT;
        lay_out(row, pen.painter, pen.colors, (pen.zoom, has_rows), pen.session.revision(), look, node);
        let corner = self.view.to_screen(row.rect.min);
        for (offset, galley) in &row.text.lines {
            glyphs(mesh, corner + *offset * pen.zoom, galley, pen.uv, pen.pixels);
        }
        for (offset, color) in &row.text.swatches {
            let size = vec2(28.0, ROW_HEIGHT - 7.0) * pen.zoom;
            let r = Rect::from_center_size(corner + *offset * pen.zoom, size);
            rounded(mesh, r.expand(1.0), 3.0 * pen.zoom, (true, true), pen.colors.swatch_edge);
            let [red, green, blue, alpha] = color.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
            // Left half opaque, so that the hue of a transparent colour is seen.
            rounded(mesh, r, 2.0 * pen.zoom, (true, true), Color32::from_rgb(red, green, blue));
            if alpha < 255 {
                let right = Rect::from_min_max(r.center_top(), r.max);
                mesh.add_colored_rect(right, pen.colors.node);
                mesh.add_colored_rect(right, Color32::from_rgba_unmultiplied(red, green, blue, alpha));
            }
        }
    }

    fn draw_badge(&self, mesh: &mut Mesh, pen: &Pen<'_>, node: Rect, severity: Severity) {
        let color = if severity == Severity::Error { pen.colors.error } else { pen.colors.warning };
        let radius = (8.0 * pen.zoom).clamp(4.0, 10.0);
        let center = node.right_top() + vec2(-2.0 * pen.zoom, 2.0 * pen.zoom);
        socket(mesh, theme::SocketShape::Circle, center, radius + 1.5, pen.colors.node_edge);
        socket(mesh, theme::SocketShape::Circle, center, radius, color);
        // An exclamation mark.
        let unit = radius / 8.0;
        let stroke =
            |y: f32, height: f32| Rect::from_center_size(center + vec2(0.0, y * unit), vec2(2.0, height) * unit);
        mesh.add_colored_rect(stroke(-1.6, 5.6), pen.colors.node_edge);
        mesh.add_colored_rect(stroke(3.6, 2.0), pen.colors.node_edge);
    }
}

fn lighter(color: Color32) -> Color32 {
    mixed(color, Color32::WHITE, 0.14)
}

fn mixed(a: Color32, b: Color32, t: f32) -> Color32 {
    let mix = |a: u8, b: u8| (f32::from(a) + (f32::from(b) - f32::from(a)) * t).round() as u8;
    Color32::from_rgb(mix(a.r(), b.r()), mix(a.g(), b.g()), mix(a.b(), b.b()))
}
