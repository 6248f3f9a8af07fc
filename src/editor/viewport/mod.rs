//! The look on an object: drag beside the object to orbit, on it to turn the lights; the wheel
//! comes nearer.
//!
//! `surface` knows what is seen at each pixel; on it `isocurves` draws the selected layer's lines,
//! which are dragged there, `lights` the handles of lights, and `strip` the values that have no
//! place on the object.

mod arrows;
mod bar;
mod export;
mod field;
mod isocurves;
mod layer;
mod lights;
mod objects;
pub(crate) mod picture;
mod preparing;
mod show;
pub(crate) mod solo_bar;
mod strip;
mod surface;

use eframe::egui;
use eframe::egui::{
    CursorIcon, PointerButton, Pos2, Rect, Response, Role, Sense, Ui, WidgetInfo, vec2,
};
use glam::DVec3;
use std::path::PathBuf;
use std::sync::Arc;

use crate::commands::table::{self, Place};
use crate::commands::{Command, PictureExport, SceneCommand, ViewCommand, keyboard};
use crate::document::Projection;
use crate::ids::ObjectId;
use crate::render::Gpu;
use crate::state::orbit::Orbit;
use crate::state::scene::ObjectPlace;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;
use crate::tools::fitting::Fitting;
use crate::tools::probe::picture_size;
use crate::tools::{PictureContext, PictureTools, ToolRow};
use crate::viewport::picture::Picture;
use crate::widgets::spots::{self, Spot};
use crate::widgets::theme;
use export::{Destination, Exports, PictureExportResult};
use isocurves::Isocurves;
use layer::{Curve, Layer};
use show::{Place as ReferencePlace, Reference};
use surface::{Key as SurfaceKey, Surface, Surfaces};

/// How fast the turntable turns, in turns of the picture's height a second.
const TURNTABLE: f64 = -0.25;

/// What a drag that is going on does.
#[derive(Clone, Debug, PartialEq)]
enum Drag {
    Camera,
    Lights,
    Pan,
    Curve(isocurves::HeldCurve),
    Light(lights::HeldLight),
}

/// What a drag that is given up goes back to.
struct DragStart {
    view: Orbit,
    /// How many steps of the look were done.
    place: usize,
}

/// The viewport and what it remembers between frames.
pub struct Viewport {
    drag: Option<Drag>,
    /// How everything was when the drag began.
    before: Option<DragStart>,
    rect: Option<Rect>,
    /// What was taken in of this frame, until it is drawn.
    scene: Option<ViewportScene>,
    hint: String,
    /// The object of a scene under the pointer.
    hovered: Option<ObjectId>,
    surfaces: Surfaces,
    isocurves: Isocurves,
    /// Whether arrows toward the eye and the lights are shown, and those of the last frame.
    has_arrows: bool,
    arrows: Vec<arrows::Arrow>,
    turns: bool,
    /// In stops; for this window only.
    exposure: f32,
    exports: Exports,
    preparing: preparing::Preparing,
    reference: Option<Reference>,
    /// The side of baked images, in pixels.
    bake_side: u32,
}

/// What one frame draws: where the picture is, and what is under the pointer.
struct ViewportScene {
    rect: Rect,
    /// The room of a reference image beside the picture.
    beside: Option<Rect>,
    response: Response,
    pointer: Option<Pos2>,
    handles: Handles,
    hovered: Option<objects::HoveredObject>,
}

/// What is shown on the object this time.
struct Handles {
    surface: Option<Arc<Surface>>,
    layer: Option<Layer>,
    /// Whether lines and handles are shown.
    is_on: bool,
    /// Where objects are, where that is news.
    places: Option<Vec<ObjectPlace>>,
}

impl Viewport {
    /// `wake` is called from another thread when there is something new to show.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Clone + Send + 'static) -> Self {
        Self {
            drag: None,
            before: None,
            rect: None,
            scene: None,
            hint: String::new(),
            hovered: None,
            surfaces: Surfaces::new(wake.clone()),
            isocurves: Isocurves::default(),
            has_arrows: false,
            arrows: Vec::new(),
            turns: false,
            exposure: 0.0,
            exports: Exports::new(gpu, wake),
            preparing: preparing::Preparing::default(),
            reference: None,
            bake_side: 512,
        }
    }

    /// Shows the bars, and takes in what the pointer and the keys do over the picture, which has all
    /// the room there is. The camera and the lights belong to the window, not to the look.
    pub(crate) fn interact(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        tools: &mut PictureTools,
    ) -> Vec<Command> {
        let mut out = Vec::new();
        let mut view = session.view.orbit.clone();
        self.bar(ui, session, &mut view, tools, &mut out);
        tools.bars(ui, session);
        self.take_exports(ui, &mut out);
        let (room, _) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
        let (rect, beside) =
            self.reference.as_ref().map_or((room, None), |reference| reference.split(room));
        let response = ui.interact(rect, ui.scope_id().with("picture"), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "Picture"));
        self.rect = Some(rect);
        // By the pixels that are drawn, so that it is the picture that others draw of the scene.
        let [width, height] = picture_size(rect, ui.pixels_per_point()).map(f64::from);
        view.fit_into(width / height);
        spots::note(ui, Spot::Picture, rect);
        let pointer = response
            .contains_pointer()
            .then(|| ui.input(|input| input.pointer.hover_pos()))
            .flatten();
        let is_free = tools.with_pointer().is_none();
        let mut handles = self.handles(rect, session, tools.has_handles, is_free);
        out.extend(handles.places.take().map(SceneCommand::Locate).map(Command::Scene));
        let hovered = objects::seen(
            session,
            handles.surface.as_deref(),
            rect,
            pointer.filter(|_| self.drag.is_none()),
        );
        self.hovered = hovered.as_ref().map(|hovered| hovered.object().clone());
        if response.clicked() && is_free {
            out.extend(objects::pick(session, handles.surface.as_deref(), hovered.as_ref()));
        }
        // Where the hand paints, only what else turns the camera turns it.
        let is_alt = ui.input(|input| input.modifiers.alt);
        let is_stroke =
            self.drag.is_none() && response.dragged_by(PointerButton::Primary) && !is_alt;
        let context = PictureContext { session, response: &response, rect, pointer };
        if !(tools.fitting.is_on() && is_stroke) {
            self.drags(ui, &context, &mut view, &handles, &mut out);
        }
        self.wheel_and_keys(ui, &context, &mut view, &tools.fitting, &mut out);
        self.turn(ui, &mut view);
        out.extend(tools.interact(ui, &context));
        if view != session.view.orbit {
            // What is asked for by name, as to turn all back, comes after.
            out.insert(0, Command::View(ViewCommand::TurnTo(Box::new(view))));
        }
        self.scene = Some(ViewportScene { rect, beside, response, pointer, handles, hovered });
        out
    }

    /// Draws the picture, and what is over it.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        picture: Option<&mut Picture>,
        tools: &mut PictureTools,
    ) -> Vec<Command> {
        let mut out = Vec::new();
        let Some(ViewportScene { rect, beside, response, pointer, handles, hovered: seen }) =
            self.scene.take()
        else {
            return out;
        };
        let owner = tools.with_pointer();
        match picture {
            Some(picture) => {
                show_picture(ui, rect, session, picture, self.turns, self.exposure);
                self.preparing.show(ui, rect, session, picture);
            }
            None => {
                if !tools.fitting.stand_in(ui, rect) {
                    ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
                    stand_in(ui, rect, session);
                }
            }
        }
        match (&self.reference, beside) {
            (Some(reference), Some(beside)) => reference.paint_beside(ui, beside),
            (Some(reference), None) => reference.paint(ui, rect),
            (None, _) => {}
        }
        let free = pointer.filter(|_| self.drag.is_none());
        let context = PictureContext { session, response: &response, rect, pointer: free };
        tools.over(ui, &context, &mut out);
        let is_free = self.drag.is_none() && handles.is_on && owner.is_none() && response.hovered();
        let hovered = pointer.filter(|_| is_free);
        let hovered = hovered.and_then(|at| self.grip(ui, rect, at, session, &handles));
        // The hint of a drag stands before that of the brush, and not before that of the probe.
        let is_told = |tool: &&ToolRow| tool.mark.is_some() || self.drag.is_none();
        self.hint = match owner.filter(is_told).and_then(|tool| tool.hint) {
            Some(hint) => hint(tools).to_owned(),
            None => {
                let hint = self.hint_at(pointer, rect, session, &handles, hovered.as_ref());
                let of_object = seen.as_ref().filter(|_| hovered.is_none());
                of_object.map_or(String::new(), objects::HoveredObject::hint) + &hint
            }
        };
        if !tools.fitting.is_on() {
            objects::paint(ui, rect, session, handles.surface.as_deref(), seen.as_ref());
        }
        let surface = handles.surface.as_deref().filter(|_| self.has_arrows);
        self.arrows =
            surface.map(|surface| arrows::of(session, surface, rect, pointer)).unwrap_or_default();
        arrows::paint(ui, rect, &self.arrows);
        if let Some(mark) = owner.and_then(|tool| tool.mark) {
            response.on_hover_cursor(CursorIcon::Crosshair);
            mark(tools, ui, rect);
        } else if handles.is_on && !tools.fitting.is_on() {
            self.paint(ui, rect, session, &handles, hovered.as_ref(), response.hovered());
            let is_held = matches!(self.drag, Some(Drag::Curve(_) | Drag::Light(_)));
            if is_held || hovered.is_some() {
                ui.ctx().set_cursor_icon(if is_held {
                    CursorIcon::Grabbing
                } else {
                    CursorIcon::Grab
                });
            }
            if let Some(layer) = &handles.layer {
                strip::show(ui, rect, session, layer, &mut out);
            }
        }
        bar::over_top(ui, rect, session, &mut out);
        out
    }

    /// Finds out what is handled, and brings its lines up to date.
    fn handles(&mut self, rect: Rect, session: &Session, is_on: bool, is_free: bool) -> Handles {
        let layer = layer::selected(session).filter(|_| is_on && is_free);
        let wants_lines = is_on && (layer.is_some() || layer::selected_light(session).is_some());
        // Of a scene one wants to know what is where, in any case.
        if !(wants_lines || self.has_arrows || session.stage().is_some()) || rect.area() < 16.0 {
            self.isocurves.clear();
            return Handles { surface: None, layer, is_on, places: None };
        }
        let key = SurfaceKey::new(session, rect.size());
        let with_kappa = layer
            .as_ref()
            .and_then(|layer| layer.warp)
            .is_some_and(|(slope, amount)| slope * amount != 0.0);
        let surface = self.surfaces.update(&key, with_kappa, || session.snapshot());
        let is_elsewhere = |places: &&Vec<ObjectPlace>| {
            session.stage().is_some_and(|stage| stage.placed != **places)
        };
        let places = surface.as_ref().map(|surface| &surface.pieces.placed).filter(is_elsewhere);
        let places = places.cloned();
        match (&surface, &layer) {
            (Some(surface), Some(layer)) => self.isocurves.update(session, surface, layer),
            _ => self.isocurves.clear(),
        }
        Handles { surface, layer, is_on, places }
    }

    /// What there is to be taken at a point of the screen.
    fn grip(
        &self,
        ui: &Ui,
        rect: Rect,
        at: Pos2,
        session: &Session,
        handles: &Handles,
    ) -> Option<Drag> {
        let modifiers = ui.input(|input| input.modifiers);
        let of_layer = handles.layer.as_ref().map(|layer| (layer.light.clone(), layer.shading));
        let chosen = of_layer
            .or_else(|| Some((layer::selected_light(session)?, layer::ShadingType::Diffuse)));
        if let Some((light, shading)) = chosen {
            let is_there =
                handles.surface.as_ref().is_some_and(|surface| surface.is_at(place_in(rect, at)));
            if modifiers.shift && is_there || lights::is_at_middle(self.isocurves.middle(rect), at)
            {
                return Some(Drag::Light(lights::HeldLight::by_middle(light, shading)));
            }
        }
        if let Some(held) = lights::hit(session, rect, at) {
            return Some(Drag::Light(held));
        }
        self.isocurves.hit(rect, at, modifiers.command).map(Drag::Curve)
    }

    fn paint(
        &self,
        ui: &Ui,
        rect: Rect,
        session: &Session,
        handles: &Handles,
        hovered: Option<&Drag>,
        is_near: bool,
    ) {
        let in_hand = self.drag.as_ref().or(hovered);
        let curve = match in_hand {
            Some(Drag::Curve(held)) => Some(held),
            _ => None,
        };
        let light = match in_hand {
            Some(Drag::Light(held)) => Some(held),
            _ => None,
        };
        let is_near = is_near || self.drag.is_some();
        if handles.layer.is_some() {
            self.isocurves.paint(ui, rect, curve, is_near);
            let held = light.filter(|held| held.is_by_middle());
            let pointer = ui.input(|input| input.pointer.interact_pos());
            let is_dragged = held.is_some() && matches!(self.drag, Some(Drag::Light(_)));
            let on_object = |at: &Pos2| {
                handles.surface.as_ref().is_some_and(|it| it.is_at(place_in(rect, *at)))
            };
            let middle =
                if is_dragged { pointer.filter(on_object) } else { self.isocurves.middle(rect) };
            if let Some(middle) = middle {
                lights::paint_middle(ui, rect, middle, held.is_some());
            }
        }
        if is_near {
            let is_turning = self.drag == Some(Drag::Lights);
            lights::paint_needles(ui, rect, session, is_turning, light.map(|held| &held.light));
        }
    }

    fn turn(&self, ui: &Ui, view: &mut Orbit) {
        if self.turns {
            let seconds = ui.input(|input| f64::from(input.stable_dt.min(0.1)));
            view.orbit(TURNTABLE * seconds, 0.0);
            ui.ctx().request_repaint();
        }
    }

    fn drags(
        &mut self,
        ui: &Ui,
        context: &PictureContext<'_>,
        view: &mut Orbit,
        handles: &Handles,
        out: &mut Vec<Command>,
    ) {
        let PictureContext { session, response, rect, .. } = *context;
        let is_alt = ui.input(|input| input.modifiers.alt);
        if response.drag_started()
            && let Some(origin) = ui.input(|input| input.pointer.press_origin())
        {
            self.before =
                Some(DragStart { view: session.view.orbit.clone(), place: session.place() });
            let is_primary = response.dragged_by(PointerButton::Primary);
            let grip = (is_primary && !is_alt && handles.is_on)
                .then(|| self.grip(ui, rect, origin, session, handles));
            self.drag = Some(match grip.flatten() {
                Some(grip) => grip,
                None if !is_primary => Drag::Pan,
                None if !is_alt && is_on_object(origin, rect, session, handles) => Drag::Lights,
                None => Drag::Camera,
            });
        }
        let at = ui.input(|input| input.pointer.interact_pos());
        if response.dragged()
            && let (Some(drag), Some(at)) = (&mut self.drag, at)
        {
            let delta = response.drag_delta() / rect.height().max(1.0);
            let (dx, dy) = (f64::from(delta.x), f64::from(delta.y));
            match drag {
                _ if delta == egui::Vec2::ZERO => {}
                Drag::Camera => view.orbit(dx, dy),
                Drag::Lights => view.turn_lights(dx, dy),
                Drag::Pan => view.pan(dx, dy),
                Drag::Curve(held) => out.extend(self.isocurves.drag(held, session, rect, at)),
                Drag::Light(held) => {
                    out.extend(lights::drag(held, session, handles.surface.as_deref(), rect, at));
                }
            }
        }
        if response.drag_stopped() {
            self.drag = None;
        }
    }

    fn wheel_and_keys(
        &self,
        ui: &Ui,
        PictureContext { session, pointer, .. }: &PictureContext<'_>,
        view: &mut Orbit,
        fitting: &Fitting,
        out: &mut Vec<Command>,
    ) {
        if pointer.is_none() {
            return;
        }
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
        let factor = f64::from((-scroll / 300.0).exp() / pinch);
        // Strokes belong to the view that they were painted in, which a wheel leaves too easily.
        let is_held = fitting.is_on() && !session.sketch().is_empty();
        if factor != 1.0 && !is_held {
            view.dolly(factor);
        }
        if keyboard::is_keyboard_taken(ui.ctx()) {
            return;
        }
        if fitting.is_on() {
            out.extend(table::pressed(ui, Place::Light));
        }
        out.extend(table::pressed(ui, Place::Picture));
    }

    /// Starts or stops the turntable.
    pub(crate) fn toggle_turntable(&mut self) {
        self.turns = !self.turns;
    }

    /// Stops the turntable.
    pub(crate) fn stop_turning(&mut self) {
        self.turns = false;
    }

    /// Whether something is dragged on the picture.
    pub(crate) fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// Gives a drag up. Returns where camera and lights were when it began, and whether the last
    /// step of the look is the drag's, and is to be taken back too.
    pub(crate) fn give_up(&mut self, session: &Session) -> Option<(Orbit, bool)> {
        self.drag = None;
        let before = self.before.take()?;
        Some((before.view, session.place() == before.place + 1))
    }

    fn hint_at(
        &self,
        pointer: Option<Pos2>,
        rect: Rect,
        session: &Session,
        handles: &Handles,
        hovered: Option<&Drag>,
    ) -> String {
        match (self.drag.as_ref().or(hovered), pointer) {
            (Some(Drag::Curve(held)), _) => self.isocurves.hint(held),
            (Some(Drag::Light(held)), _) => held.hint(session),
            (Some(Drag::Lights), _) => {
                "Turning the illumination frame: every light in it turns with it · Esc puts it \
                 back"
                    .to_owned()
            }
            (Some(Drag::Camera), _) => {
                "Turning the camera around the object · Esc puts it back".to_owned()
            }
            (Some(Drag::Pan), _) => "Moving the camera · Esc puts it back".to_owned(),
            (None, None) => String::new(),
            (None, Some(at)) if is_on_object(at, rect, session, handles) => {
                let one = if layer::selected_light(session).is_some()
                    || layer::selected(session).is_some()
                {
                    "Shift-drag turns the layer's light · "
                } else {
                    ""
                };
                format!(
                    "Drag to turn all lights · {one}Alt-drag turns the camera · wheel comes \
                         nearer · R resets"
                )
            }
            (None, Some(_)) => {
                "Drag to turn the camera · right-drag moves it · wheel comes nearer · R resets · F \
                 frames"
                    .to_owned()
            }
        }
    }

    /// What may be done at the pointer; empty while it is elsewhere.
    pub(crate) fn hint(&self) -> &str {
        &self.hint
    }

    /// The object of a scene that was under the pointer in the last frame.
    pub(crate) fn hovered(&self) -> Option<&ObjectId> {
        self.hovered.as_ref()
    }

    /// How wide the picture is, in parts of its height.
    pub(crate) fn aspect(&self) -> f64 {
        objects::aspect(self.rect)
    }

    /// Where the picture is on the screen; for tests.
    pub fn rect(&self) -> Option<Rect> {
        self.rect
    }

    /// Points of a line of the selected layer on the screen, by its input's name (`offset`,
    /// `falloff`, `cutoff`); for tests.
    pub fn curve(&self, port: &str) -> Vec<Pos2> {
        let curve = Curve::ALL.into_iter().find(|curve| curve.port() == port);
        curve
            .zip(self.rect)
            .map(|(curve, rect)| self.isocurves.points(curve, rect))
            .unwrap_or_default()
    }

    /// Where the arrows toward the eye and the lights begin and end on the screen; for tests.
    pub fn arrows(&self) -> impl Iterator<Item = [Pos2; 2]> {
        self.arrows.iter().map(|arrow| [arrow.from, arrow.to])
    }

    /// Where the middle of what the selected layer's light lights is on the screen; for tests.
    pub fn middle(&self) -> Option<Pos2> {
        self.isocurves.middle(self.rect?)
    }

    /// Writes a picture of what is shown.
    pub(crate) fn export(&mut self, session: &Session, export: PictureExport, path: PathBuf) {
        self.exports.draw(export, session.snapshot(), Destination::File(path));
    }

    /// Copies the picture to the clipboard, as large as it is on the screen, or of a usual size
    /// where it never was there.
    pub(crate) fn copy(&mut self, session: &Session, scale: f32) {
        self.exports.draw(
            PictureExport::Picture(self.size_in_pixels(scale)),
            session.snapshot(),
            Destination::Clipboard,
        );
    }

    /// How large the picture is on the screen, or a usual size where it never was there.
    pub(crate) fn size_in_pixels(&self, scale: f32) -> [u32; 2] {
        self.rect.map_or([800, 800], |rect| picture_size(rect, scale)).map(|side| side.max(1))
    }

    /// Shows an image with the picture.
    pub(crate) fn show_reference(&mut self, path: PathBuf) {
        self.exports.read(path);
    }

    fn take_exports(&mut self, ui: &Ui, out: &mut Vec<Command>) {
        for done in self.exports.answers() {
            out.push(Command::Tell(match done {
                PictureExportResult::Saved(path) => format!("Saved {}", path.display()),
                PictureExportResult::Copied(image) => {
                    ui.ctx().copy_image(image);
                    "The picture is in the clipboard".to_owned()
                }
                PictureExportResult::Read(path, image) => {
                    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                    let texture =
                        ui.ctx().load_texture("reference", image, egui::TextureOptions::LINEAR);
                    let (place, opacity) = self
                        .reference
                        .as_ref()
                        .map_or((ReferencePlace::Beside, 0.5), |old| (old.place, old.opacity));
                    let message =
                        format!("{name} is shown with the picture; Options takes it away");
                    self.reference = Some(Reference { name, texture, place, opacity });
                    message
                }
                PictureExportResult::Failed(problem) => problem.message,
            }));
        }
    }
}

impl BackgroundJobs for Viewport {
    fn is_busy(&self) -> bool {
        self.surfaces.is_busy() || self.exports.is_busy()
    }

    fn wait(&self) {
        self.surfaces.wait();
        self.exports.wait();
    }
}

/// A point of the screen in parts of the picture's size.
fn place_in(rect: Rect, at: Pos2) -> [f32; 2] {
    [(at.x - rect.min.x) / rect.width(), (at.y - rect.min.y) / rect.height()]
}

fn show_picture(
    ui: &Ui,
    rect: Rect,
    session: &Session,
    picture: &mut Picture,
    turns: bool,
    stops: f32,
) {
    let size = picture_size(rect, ui.pixels_per_point());
    let (is_held, dt) = ui.input(|input| (input.pointer.any_down(), input.unstable_dt));
    match picture.update(session, size, is_held || turns, dt) {
        Some(texture) => {
            ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
            show::paint_exposed(ui, texture, rect, stops);
        }
        None => {
            ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
            let font = egui::FontId::proportional(theme::TEXT_SIZE);
            let is_broken =
                !picture.problems.is_empty() || crate::diag::has_errors(session.problems());
            let text = match session.held() {
                Some(_) => "Not drawn until you press Try again above",
                None if is_broken => "No picture: Problems says what is to be mended",
                None => "Making the first picture",
            };
            ui.painter().text(
                rect.center(),
                egui::Align2::CENTER_CENTER,
                text,
                font,
                theme::of(ui).dim,
            );
        }
    }
}

/// Where there is no GPU: a ball, so that camera and lights can be turned all the same.
fn stand_in(ui: &Ui, rect: Rect, session: &Session) {
    let radius = session.view.orbit.radius_in_picture() as f32 * rect.height();
    ui.painter().circle(
        rect.center(),
        radius,
        theme::of(ui).node,
        egui::Stroke::new(1.0, theme::of(ui).grid),
    );
    let font = egui::FontId::proportional(theme::TEXT_SIZE);
    let at = rect.center_bottom() - vec2(0.0, 12.0);
    let text = "This window has no GPU to draw with";
    ui.painter().text(at, egui::Align2::CENTER_BOTTOM, text, font, theme::of(ui).dim);
}

/// Whether a point of the screen is on the object, or near enough: its bounding sphere has radius
/// 1.
fn is_on_object(at: Pos2, rect: Rect, session: &Session, handles: &Handles) -> bool {
    if let Some(surface) = &handles.surface {
        return surface.piece_at(place_in(rect, at)).is_some();
    }
    if session.stage().is_some() {
        return false;
    }
    let radius = session.view.orbit.radius_in_picture() as f32 * rect.height();
    let center = project(DVec3::ZERO, rect, session).unwrap_or(rect.center());
    at.distance(center) < radius * 0.92
}

/// A point of the world on the screen; `None` behind the eye.
fn project(point: DVec3, rect: Rect, session: &Session) -> Option<Pos2> {
    let view = &session.view.orbit;
    let (right, up) = view.right_and_up();
    let from_eye = point - (view.target + view.direction() * view.distance);
    let depth = -from_eye.dot(view.direction());
    let span = match view.projection {
        Projection::Perspective if depth <= 1e-6 => return None,
        Projection::Perspective => 2.0 * depth * (view.fov / 2.0).tan(),
        Projection::Orthographic => view.height(),
    };
    let scale = f64::from(rect.height()) / span;
    let (x, y) = (from_eye.dot(right) * scale, from_eye.dot(up) * scale);
    Some(rect.center() + vec2(x as f32, -y as f32))
}
