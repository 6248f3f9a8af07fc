//! The look on an object: drag beside the object to orbit, on it to turn the lights; the wheel comes nearer.

use eframe::egui;
use eframe::egui::{
    Color32, CursorIcon, Key, Modifiers, PointerButton, Pos2, Rect, Response, Role, Sense, Ui, WidgetInfo, pos2, vec2,
};
use glam::DVec3;
use std::path::Path;

use super::command::Command;
use super::panels::solo;
use super::picture::Picture;
use super::probe::{Probe, picture_size, wire_name};
use super::session::Session;
use super::theme;
use super::wipe::Wipe;
use super::wire::node_at;
use crate::geometry::SHAPES;

/// What a drag that is going on does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Drag {
    Camera,
    Lights,
    Pan,
}

/// The viewport and what it remembers between frames.
#[derive(Default)]
pub struct Viewport {
    drag: Option<Drag>,
    rect: Option<Rect>,
    hint: &'static str,
}

impl Viewport {
    /// Shows the picture in all the room there is. The camera and the lights belong to the window, not to the look, so
    /// they are changed here and now.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        session: &mut Session,
        picture: Option<&mut Picture>,
        probe: &mut Probe,
        wipe: &mut Wipe,
    ) -> Option<Command> {
        let command = self.bar(ui, session, probe, wipe);
        let command = command.or(wire_bar(ui, session)).or(solo::bar(ui, session));
        wipe.bar(ui, session);
        let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "Picture"));
        self.rect = Some(rect);
        let pointer = response.contains_pointer().then(|| ui.input(|input| input.pointer.hover_pos())).flatten();
        self.drags(ui, &response, rect, session);
        self.wheel_and_keys(ui, pointer, session);
        self.hint = if probe.is_on() { probe_hint(probe) } else { self.hint_at(pointer, rect, session) };
        match picture {
            Some(picture) => show_picture(ui, rect, session, picture),
            None => {
                ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
                stand_in(ui, rect, session);
            }
        }
        wipe.update(ui, session, picture_size(rect, ui.pixels_per_point()));
        wipe.over(ui, rect);
        probe.update(ui, session, rect, pointer.filter(|_| self.drag.is_none()), response.clicked());
        if probe.is_on() {
            response.on_hover_cursor(CursorIcon::Crosshair);
            probe.mark(ui, rect);
        } else if response.hovered() || self.drag == Some(Drag::Lights) {
            light_needles(ui, rect, session, self.drag == Some(Drag::Lights));
        }
        command
    }

    /// The mesh that the look is seen on, and how it stands.
    fn bar(&self, ui: &mut Ui, session: &mut Session, probe: &Probe, wipe: &mut Wipe) -> Option<Command> {
        let mut command = None;
        ui.horizontal(|ui| {
            let label = ui.label("On");
            let mesh = session.view.mesh.clone();
            let shape = SHAPES.iter().find(|shape| mesh.strip_prefix("shape:") == Some(shape.name));
            let file = Path::new(&mesh).file_name().map_or(mesh.clone(), |name| name.to_string_lossy().into_owned());
            let shown = shape.map_or(file.as_str(), |shape| shape.label);
            let combo = egui::ComboBox::from_id_salt("mesh").selected_text(shown).show_ui(ui, |ui| {
                for shape in SHAPES {
                    let is_it = mesh.strip_prefix("shape:") == Some(shape.name);
                    if ui.selectable_label(is_it, shape.label).on_hover_text(shape.help).clicked() {
                        session.view.mesh = format!("shape:{}", shape.name);
                        session.view.z_is_up = false;
                    }
                }
                ui.separator();
                let help =
                    "Shows the look on a mesh of yours (OBJ, PLY, STL, glTF); it can also be dropped on the window";
                if ui.selectable_label(shape.is_none(), "From a file...").on_hover_text(help).clicked() {
                    command = Some(Command::ShowOn(None));
                }
            });
            if shape.is_none() {
                ui.checkbox(&mut session.view.z_is_up, "Z is up")
                    .on_hover_text("Stands up a mesh whose z axis points up");
            }
            combo.response.labelled_by(label.id);
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui.button("Reset").on_hover_text("Turns camera and lights back (R)").clicked() {
                    session.view.reset();
                }
                let mut is_on = probe.is_on();
                let help = "Reads the value on every wire at a pixel, f32 beside f64 (I)";
                if ui.toggle_value(&mut is_on, "Probe pixel").on_hover_text(help).changed() {
                    command = Some(Command::Probe(is_on));
                }
                wipe.choice(ui);
                if session.is_compiling() {
                    ui.label(egui::RichText::new("compiling").color(theme::of(ui).dim));
                }
            });
        });
        command
    }

    fn drags(&mut self, ui: &Ui, response: &Response, rect: Rect, session: &mut Session) {
        let is_alt = ui.input(|input| input.modifiers.alt);
        if response.drag_started()
            && let Some(origin) = ui.input(|input| input.pointer.press_origin())
        {
            let is_primary = response.dragged_by(PointerButton::Primary);
            self.drag = Some(match is_primary {
                false => Drag::Pan,
                true if !is_alt && is_on_object(origin, rect, session) => Drag::Lights,
                true => Drag::Camera,
            });
        }
        if response.dragged()
            && let Some(drag) = self.drag
        {
            let delta = response.drag_delta() / rect.height().max(1.0);
            let (dx, dy) = (f64::from(delta.x), f64::from(delta.y));
            match drag {
                _ if delta == egui::Vec2::ZERO => {}
                Drag::Camera => session.view.orbit(dx, dy),
                Drag::Lights => session.view.turn_lights(dx, dy),
                Drag::Pan => session.view.pan(dx, dy),
            }
        }
        if response.drag_stopped() {
            self.drag = None;
        }
    }

    fn wheel_and_keys(&self, ui: &Ui, pointer: Option<Pos2>, session: &mut Session) {
        if pointer.is_none() {
            return;
        }
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
        let factor = f64::from((-scroll / 300.0).exp() / pinch);
        if factor != 1.0 {
            session.view.dolly(factor);
        }
        if ui.ctx().egui_wants_keyboard_input() {
            return;
        }
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        if pressed(Key::R) {
            session.view.reset();
        }
        if pressed(Key::F) {
            session.view.frame_object();
        }
    }

    fn hint_at(&self, pointer: Option<Pos2>, rect: Rect, session: &Session) -> &'static str {
        match (self.drag, pointer) {
            (Some(Drag::Lights), _) => "Turning the illumination frame: every light in it turns with it",
            (Some(Drag::Camera), _) => "Turning the camera around the object",
            (Some(Drag::Pan), _) => "Moving the camera",
            (None, None) => "",
            (None, Some(at)) if is_on_object(at, rect, session) => {
                "Drag to turn the lights · Alt-drag turns the camera · wheel comes nearer · R resets"
            }
            (None, Some(_)) => {
                "Drag to turn the camera · right-drag moves it · wheel comes nearer · R resets · F frames"
            }
        }
    }

    /// What may be done at the pointer; empty while it is elsewhere.
    pub(crate) fn hint(&self) -> &'static str {
        self.hint
    }

    /// Where the picture is on the screen; for tests.
    pub fn rect(&self) -> Option<Rect> {
        self.rect
    }
}

/// Says that a wire is shown in place of the picture, and leads back.
fn wire_bar(ui: &mut Ui, session: &Session) -> Option<Command> {
    let wire = session.wire()?;
    let node = node_at(session.look(), &session.library, wire.node.ids())?;
    let kind = session.catalog.of(node);
    let name = wire_name(session, &wire.node);
    let port = kind.and_then(|kind| Some(&*kind.outputs[kind.output(wire.port.as_str())?].label)).unwrap_or_default();
    let mut command = None;
    ui.horizontal(|ui| {
        let text = format!("Showing {port} of {name} as {}", wire.style.label().to_lowercase());
        ui.label(egui::RichText::new(text).color(theme::of(ui).accent)).on_hover_text(wire.style.help());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui.button("Show the look").clicked() {
                command = Some(Command::ShowWire(None));
            }
        });
    });
    command
}

fn probe_hint(probe: &Probe) -> &'static str {
    match probe.pinned() {
        None => "Rest the pointer to read a pixel, click to keep it · Esc leaves the probe",
        Some(_) => "This pixel is kept: click another · Esc lets go of it, Esc again leaves the probe",
    }
}

fn show_picture(ui: &Ui, rect: Rect, session: &mut Session, picture: &mut Picture) {
    let size = picture_size(rect, ui.pixels_per_point());
    let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    match picture.update(session, size) {
        Some(texture) => {
            ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
            ui.painter().image(texture, rect, uv, Color32::WHITE);
        }
        None => {
            ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
            let font = egui::FontId::proportional(theme::TEXT_SIZE);
            let is_broken = !picture.problems.is_empty() || crate::diag::has_errors(session.problems());
            let text =
                if is_broken { "No picture until what is listed below is mended" } else { "Making the first picture" };
            ui.painter().text(rect.center(), egui::Align2::CENTER_CENTER, text, font, theme::of(ui).dim);
        }
    }
}

/// Where there is no GPU: a ball, so that camera and lights can be turned all the same.
fn stand_in(ui: &Ui, rect: Rect, session: &Session) {
    let radius = session.view.radius_in_picture() as f32 * rect.height();
    ui.painter().circle(rect.center(), radius, theme::of(ui).node, egui::Stroke::new(1.0, theme::of(ui).grid));
    let font = egui::FontId::proportional(theme::TEXT_SIZE);
    let at = rect.center_bottom() - vec2(0.0, 12.0);
    let text = "This window has no GPU to draw with";
    ui.painter().text(at, egui::Align2::CENTER_BOTTOM, text, font, theme::of(ui).dim);
}

/// Whether a point of the screen is on the object, or near enough: its bounding sphere has radius 1.
fn is_on_object(at: Pos2, rect: Rect, session: &Session) -> bool {
    let radius = session.view.radius_in_picture() as f32 * rect.height();
    let center = project(DVec3::ZERO, rect, session).unwrap_or(rect.center());
    at.distance(center) < radius * 0.92
}

/// A point of the world on the screen; `None` behind the eye.
fn project(point: DVec3, rect: Rect, session: &Session) -> Option<Pos2> {
    let view = &session.view;
    let (right, up) = view.right_and_up();
    let from_eye = point - (view.target + view.direction() * view.distance);
    let depth = -from_eye.dot(view.direction());
    if depth <= 1e-6 {
        return None;
    }
    let scale = f64::from(rect.height()) / (2.0 * depth * (view.fov / 2.0).tan());
    let (x, y) = (from_eye.dot(right) * scale, from_eye.dot(up) * scale);
    Some(rect.center() + vec2(x as f32, -y as f32))
}

/// Shows where the directional lights come from: a needle from the object's outside toward each.
fn light_needles(ui: &Ui, rect: Rect, session: &Session, is_turning: bool) {
    use crate::compile::LightValues;
    use crate::document::LightKind;
    let (right, up) = session.view.right_and_up();
    let camera = glam::DMat3::from_cols(right, up, session.view.direction()).transpose();
    let painter = ui.painter_at(rect);
    let shining = session.look().lights.iter().filter(|(id, _)| !session.solo().is_dark(id)).map(|(_, light)| light);
    for light in shining.filter(|light| light.kind == LightKind::Directional) {
        let toward = LightValues::new(light, session.view.illumination, camera).direction;
        let (Some(from), Some(to)) = (project(toward * 1.06, rect, session), project(toward * 1.25, rect, session))
        else {
            continue;
        };
        let color = light.color.map(|c| (c.clamp(0.0, 1.0) * 255.0) as u8);
        let is_behind = toward.dot(session.view.direction()) < 0.0;
        let strength = if is_turning { 1.0 } else { 0.6 } * if is_behind { 0.45 } else { 1.0 };
        let color = Color32::from_rgb(color[0], color[1], color[2]).gamma_multiply(strength);
        painter.line_segment([from, to], egui::Stroke::new(2.0, color));
        painter.circle_filled(to, 4.0, color);
    }
}
