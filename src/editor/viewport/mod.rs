//! Viewport: the look on an object. A drag beside the object orbits, a drag on it turns the lights;
//! the wheel moves the camera nearer.
//!
//! `surface` holds the visible surface at each pixel; on it `isocurves` draws the selected layer's
//! lines, which are dragged there, `lights` the handles of lights, `filters` those of what stands
//! in their way, and `strip` the values that have no place on the object.

mod arrows;
mod backdrop;
mod bar;
mod colors;
mod export;
mod field;
mod filters;
mod gizmo;
mod highlight;
mod hints;
mod isocurves;
mod keyboard_handles;
mod lamps;
mod lights;
mod look_through;
mod lying;
mod needle;
mod objects;
pub(crate) mod picture;
mod place;
mod preparing;
mod readout;
mod show;
pub(crate) mod solo_bar;
mod stopwatch;
mod strip;
mod surface;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{
    CursorIcon, PointerButton, Pos2, Rect, Response, Role, ScrollArea, Sense, Ui, WidgetInfo,
};
use std::path::PathBuf;
use std::sync::Arc;

use crate::commands::table::{self, KeyScope};
use crate::commands::{Command, PictureExport, SceneCommand, ViewCommand, keyboard};
use crate::fields::layer::{self, Curve, SelectedLayer};
use crate::ids::ObjectId;
use crate::placing::Parametrization;
use crate::render::Gpu;
use crate::state::orbit::Orbit;
use crate::state::scene::ObjectPlace;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;
use crate::tools::fitting::FitTool;
use crate::tools::flip::FlipBook;
use crate::tools::handles::HandlesSwitch;
use crate::tools::masking::MaskTool;
use crate::tools::onion::OnionSkin;
use crate::tools::placing::PlacingTool;
use crate::tools::playback::Playback;
use crate::tools::probe::picture_size;
use crate::tools::safe_frame::SafeFrame;
use crate::tools::wipe::Wipe;
use crate::tools::{PictureContext, PictureTools, ToolRow};
use crate::viewport::picture::ViewportPicture;
use crate::widgets::spots::{self, Spot};
use crate::widgets::theme;
use backdrop::{show_frame, show_picture, stand_in};
use export::{Destination, Exports, PictureExportResult};
use highlight::HighlightGizmo;
use isocurves::Isocurves;
use look_through::LookThrough;

use place::{is_on_object, place_in, project};
use show::{ReferenceImage, ReferencePlacement};
use surface::{Key as SurfaceKey, Surface, Surfaces};

/// Speed of the turntable, as a horizontal drag in heights of the picture per second.
const TURNTABLE: f64 = -0.25;
/// Height that rows of controls leave the picture, in points.
const LEAST_PICTURE: f32 = 40.0;

/// Drag that is under way.
#[derive(Clone, Debug, PartialEq)]
enum Drag {
    Camera,
    Lights,
    Pan,
    Curve(isocurves::HeldCurve),
    Light(lights::HeldLight),
    Highlight(highlight::HeldHighlight),
}

/// State that a canceled drag goes back to.
struct DragStart {
    view: Orbit,
    /// Number of steps of the history that were done.
    place: usize,
}

/// The viewport and its state between frames.
pub struct Viewport {
    drag: Option<Drag>,
    /// State when the drag began.
    before: Option<DragStart>,
    rect: Option<Rect>,
    /// Input of this frame, kept until the frame is drawn.
    scene: Option<ViewportScene>,
    hint: String,
    /// Object of a scene under the pointer.
    hovered: Option<ObjectId>,
    surfaces: Surfaces,
    isocurves: Isocurves,
    highlight: HighlightGizmo,
    /// True if arrows toward the eye and the lights are shown; then the arrows of the last frame.
    has_arrows: bool,
    arrows: Vec<arrows::Arrow>,
    turns: bool,
    /// True if the illumination frame turns with the camera.
    takes_lights: bool,
    /// Light that is looked through.
    through: Option<LookThrough>,
    /// Exposure in stops; for this window only.
    exposure: f32,
    /// Configurations in the menu of views.
    colors: colors::ColorMenu,
    exports: Exports,
    stands: lying::StandUpOffer,
    preparing: preparing::PictureDelay,
    reference: Option<ReferenceImage>,
    /// Side of baked images, in pixels.
    bake_side: u32,
}

/// Input of one frame: the place of the picture, and what is under the pointer.
struct ViewportScene {
    rect: Rect,
    /// Area of a reference image beside the picture.
    beside: Option<Rect>,
    response: Response,
    pointer: Option<Pos2>,
    handles: Handles,
    hovered: Option<objects::HoveredObject>,
}

/// Handles on the object in this frame.
struct Handles {
    surface: Option<Arc<Surface>>,
    layer: Option<SelectedLayer>,
    /// True if lines and handles are shown.
    is_on: bool,
    /// Places of the objects, where they have changed.
    places: Option<Vec<ObjectPlace>>,
}

impl Handles {
    /// No handles, while the picture moves.
    fn none() -> Self {
        Self { surface: None, layer: None, is_on: false, places: None }
    }
}

impl Viewport {
    /// `wake` is called from another thread when a surface or an export is done.
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
            highlight: HighlightGizmo::default(),
            has_arrows: false,
            arrows: Vec::new(),
            turns: false,
            takes_lights: false,
            through: None,
            exposure: 0.0,
            colors: colors::ColorMenu::default(),
            exports: Exports::new(gpu, wake),
            stands: lying::StandUpOffer::default(),
            preparing: preparing::PictureDelay::default(),
            reference: None,
            bake_side: 512,
        }
    }

    /// Shows the bars, and handles the pointer and the keys over the picture, which takes all
    /// available space. The camera and the lights belong to the window, not to the look.
    pub(crate) fn interact(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        tools: &mut PictureTools,
    ) -> Vec<Command> {
        let mut out = Vec::new();
        let mut view = session.view.orbit.clone();
        self.bar(ui, session, &mut view, tools, &mut out);
        tool_bars(ui, session, tools);
        self.take_exports(ui, &mut out);
        let (room, _) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
        let (rect, beside) =
            self.reference.as_ref().map_or((room, None), |reference| reference.split(room));
        let rect = tools.of::<SafeFrame>().place(rect, session);
        let response = ui.interact(rect, ui.scope_id().with("picture"), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Picture")));
        self.rect = Some(rect);
        // The aspect ratio is that of whole pixels, as in the picture that is drawn of the scene.
        let [width, height] = picture_size(rect, ui.pixels_per_point()).map(f64::from);
        view.fit_into(width / height);
        spots::note(ui, Spot::Picture, rect);
        let pointer = response
            .contains_pointer()
            .then(|| ui.input(|input| input.pointer.hover_pos()))
            .flatten();
        let is_free = tools.with_pointer().is_none();
        // The handles stand on a surface of this moment, which takes longer than a frame may.
        let is_playing = tools.playback().is_moving();
        let is_in_place = !is_playing && !tools.of::<Wipe>().is_beside();
        let has_handles = tools.of::<HandlesSwitch>().is_on && is_in_place;
        // While a light is placed, the layer's lines show where it has come.
        let has_lines = is_free || tools.of::<PlacingTool>().is_on();
        let mut handles = match is_playing {
            true => Handles::none(),
            false => self.handles(rect, session, has_handles, has_lines),
        };
        out.extend(handles.places.take().map(SceneCommand::Locate).map(Command::Scene));
        let hovered = objects::seen(
            session,
            handles.surface.as_deref(),
            rect,
            pointer.filter(|_| self.drag.is_none()),
        );
        self.hovered = hovered.as_ref().map(|hovered| hovered.object().clone());
        if response.double_clicked() && is_free && handles.is_on {
            let held =
                response.interact_pointer_pos().and_then(|at| lights::hit(session, rect, at));
            out.extend(held.and_then(|held| lights::turned_over(&held, session)));
        } else if response.clicked() && is_free {
            let at = response.interact_pointer_pos().filter(|_| handles.is_on);
            let light = at.and_then(|at| lights::hit(session, rect, at));
            let pick = || objects::pick(session, handles.surface.as_deref(), hovered.as_ref());
            out.extend(light.map(|held| Command::ChooseLight(held.light)).or_else(pick));
        }
        // While the pointer paints, only the other ways to turn the camera remain.
        let is_alt = ui.input(|input| input.modifiers.alt);
        let is_stroke =
            self.drag.is_none() && response.dragged_by(PointerButton::Primary) && !is_alt;
        let context = PictureContext { session, response: &response, rect, pointer };
        if !(tools.takes_drags() && is_stroke) {
            self.drags(ui, &context, &mut view, &handles, &mut out);
        }
        self.wheel_and_keys(ui, &context, &mut view, tools.of(), &mut out);
        self.turn(ui, &mut view);
        out.extend(tools.interact(ui, &context));
        if let Some(through) = &mut self.through {
            out.extend(through.follow(session, &mut view));
        } else if self.takes_lights && view.has_turned(&session.view.orbit) {
            view.take_lights_along(&session.view.orbit);
        }
        if view != session.view.orbit {
            // Commands by name, such as the reset of the view, apply after the drag.
            out.insert(0, Command::View(ViewCommand::TurnTo(Box::new(view))));
        }
        self.scene = Some(ViewportScene { rect, beside, response, pointer, handles, hovered });
        out
    }

    /// Draws the picture and its overlays.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        mut picture: Option<&mut ViewportPicture>,
        tools: &mut PictureTools,
    ) -> Vec<Command> {
        let mut out = Vec::new();
        let Some(ViewportScene { rect, beside, response, pointer, handles, hovered: seen }) =
            self.scene.take()
        else {
            return out;
        };
        let owner = tools.with_pointer();
        // No texture has a side of no pixel, however little room there is.
        let size = picture_size(rect, ui.pixels_per_point()).map(|side| side.max(1));
        let (flip, playback) = tools.pair::<FlipBook, Playback>();
        flip.exposure = self.exposure;
        flip.show_by(session.view().display());
        let mut demands = flip.update(session, playback, size);
        let (onion, playback) = tools.pair::<OnionSkin, Playback>();
        demands.frames.extend(onion.demands(session, playback));
        let frame = playback.update(ui, session, size, &demands);
        match picture.as_deref_mut() {
            Some(picture) if frame.is_some() => {
                picture.is_covered = true;
                frame.into_iter().for_each(|frame| show_frame(ui, rect, frame, self.exposure));
            }
            Some(picture) => {
                picture.is_covered = false;
                show_picture(ui, rect, session, picture, self.turns, self.exposure);
                self.preparing.show(ui, rect, session, picture);
            }
            None => {
                if !tools.of_mut::<FitTool>().stand_in(ui, rect) {
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
        // The hint of a drag goes before that of the brush, but not before that of the probe.
        let is_told = |tool: &&ToolRow| tool.mark.is_some() || self.drag.is_none();
        self.hint = match owner.filter(is_told).and_then(|tool| tool.hint) {
            Some(hint) => hint(tools).to_owned(),
            None => {
                let hint = self.hint_at(pointer, rect, session, &handles, hovered.as_ref());
                let of_object = seen.as_ref().filter(|_| hovered.is_none());
                of_object.map_or(String::new(), objects::HoveredObject::hint) + &hint
            }
        };
        if !tools.of::<FitTool>().is_on() {
            objects::paint(ui, rect, session, handles.surface.as_deref(), seen.as_ref());
        }
        let surface = handles.surface.as_deref().filter(|_| self.has_arrows);
        self.arrows =
            surface.map(|surface| arrows::of(session, surface, rect, pointer)).unwrap_or_default();
        arrows::paint(ui, rect, &self.arrows);
        let mut is_strip_open = false;
        if let Some(mark) = owner.and_then(|tool| tool.mark) {
            response.on_hover_cursor(CursorIcon::Crosshair);
            mark(tools, ui, rect);
        } else if handles.is_on && !has_brush(tools) {
            // The other picture of a comparison has no handles.
            let clip = ui.clip_rect();
            ui.set_clip_rect(clip.intersect(tools.of::<Wipe>().left_side(rect)));
            self.paint(ui, rect, session, &handles, hovered.as_ref(), response.hovered());
            ui.set_clip_rect(clip);
            out.extend(keyboard_handles::show(ui, rect, session));
            out.extend(self.highlight.keyboard(ui, rect, session));
            let is_free = owner.is_none() && self.drag.is_none();
            let is_filter_held = owner.is_none() && filters::show(ui, rect, session, &mut out);
            let is_object_held = is_free && gizmo::show(ui, rect, session, &mut out);
            if is_filter_held || is_object_held {
                self.hint.clear();
            }
            let is_held =
                matches!(self.drag, Some(Drag::Curve(_) | Drag::Light(_) | Drag::Highlight(_)));
            if is_held || hovered.is_some() {
                ui.ctx().set_cursor_icon(if is_held {
                    CursorIcon::Grabbing
                } else {
                    CursorIcon::Grab
                });
            }
            if let Some(layer) = &handles.layer {
                let told = picture.as_deref().map(|picture| readout::width(ui, rect, picture));
                let layer = (layer, told.unwrap_or_default());
                is_strip_open = strip::show(ui, rect, session, layer, &mut out);
            }
        }
        let through = self.through.as_ref().map(|through| through.name(session));
        bar::over_top(ui, rect, session, through.as_deref(), &mut self.stands, &mut out);
        if let Some(picture) = picture.filter(|_| !is_strip_open) {
            readout::show(ui, rect, picture, &mut out);
        }
        out
    }

    /// Finds the handles of the selection, and brings its lines up to date.
    fn handles(&mut self, rect: Rect, session: &Session, is_on: bool, is_free: bool) -> Handles {
        let layer = layer::selected(session).filter(|_| is_on && is_free);
        let wants_lines = is_on && (layer.is_some() || layer::light_at_hand(session).is_some());
        // In a scene the surface is needed in any case, to find the object under the pointer.
        let is_wanted = wants_lines
            || self.has_arrows
            || session.open_scene().is_some()
            || self.stands.wants_surface(session);
        if !is_wanted || rect.area() < 16.0 {
            self.isocurves.clear();
            self.highlight.update(session, None, None);
            return Handles { surface: None, layer, is_on, places: None };
        }
        let key = SurfaceKey::new(session, rect.size());
        let with_kappa = layer
            .as_ref()
            .and_then(|layer| layer.warp)
            .is_some_and(|(slope, amount)| slope * amount != 0.0);
        let surface = self.surfaces.update(&key, with_kappa, || session.snapshot());
        self.stands.judge(session, surface.as_deref());
        let is_elsewhere = |places: &&Vec<ObjectPlace>| {
            session.open_scene().is_some_and(|open_scene| open_scene.placed != **places)
        };
        let places =
            surface.as_ref().map(|surface| &surface.parts_seen.placed).filter(is_elsewhere);
        let places = places.cloned();
        match (&surface, &layer) {
            (Some(surface), Some(layer)) => self.isocurves.update(session, surface, layer),
            _ => self.isocurves.clear(),
        }
        let highlight = layer::selected_highlight(session).filter(|_| is_on && is_free);
        self.highlight.update(session, surface.as_ref(), highlight);
        Handles { surface, layer, is_on, places }
    }

    /// Drag that would begin at a point of the screen.
    fn grip(
        &self,
        ui: &Ui,
        rect: Rect,
        at: Pos2,
        session: &Session,
        handles: &Handles,
    ) -> Option<Drag> {
        let modifiers = ui.input(|input| input.modifiers);
        if let Some(held) = self.highlight.hit(rect, at).filter(|_| !modifiers.shift) {
            return Some(Drag::Highlight(held));
        }
        if let Some(light) = layer::light_at_hand(session) {
            let of_layer = handles.layer.as_ref().filter(|layer| layer.light == light);
            let shading = of_layer.map_or(Parametrization::Diffuse, |layer| layer.shading);
            let is_there =
                handles.surface.as_ref().is_some_and(|surface| surface.is_at(place_in(rect, at)));
            // Shift takes the middle from any point of the object, as it may lie out of sight.
            let is_at_middle =
                of_layer.is_some() && lights::is_at_middle(self.isocurves.middle(rect), at);
            if modifiers.shift && is_there || is_at_middle {
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
        let highlight = match in_hand {
            Some(Drag::Highlight(held)) => Some(held),
            _ => None,
        };
        self.highlight.paint(ui, rect, highlight, is_near);
        if is_near {
            let is_turning = self.drag == Some(Drag::Lights);
            if matches!(&self.drag, Some(Drag::Light(held)) if held.is_by_needle()) {
                needle::paint_rim(&ui.painter_at(rect), rect, session);
            }
            lights::paint_needles(ui, rect, session, is_turning, light.map(|held| &held.light));
            lamps::paint(ui, rect, session, light.and_then(lights::HeldLight::lamp));
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
                Some(DragStart { view: session.view.orbit.clone(), place: session.steps().done() });
            let is_primary = response.dragged_by(PointerButton::Primary);
            let grip = (is_primary && !is_alt && handles.is_on)
                .then(|| self.grip(ui, rect, origin, session, handles));
            self.drag = Some(match grip.flatten() {
                Some(grip) => {
                    if let Drag::Light(held) = &grip {
                        out.push(Command::ChooseLight(held.light.clone()));
                    }
                    grip
                }
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
                // Where no light follows the frame, a turn would only be one more override.
                Drag::Lights if !session.keys().has_turning_lights() => {}
                Drag::Lights => view.turn_lights(dx, dy),
                Drag::Pan => view.pan(dx, dy),
                Drag::Curve(held) => out.extend(self.isocurves.drag(held, session, rect, at)),
                Drag::Highlight(held) => {
                    let in_steps = ui.input(|input| input.modifiers.shift);
                    out.extend(self.highlight.drag(held, session, rect, at, in_steps));
                }
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
        fitting: &FitTool,
        out: &mut Vec<Command>,
    ) {
        if pointer.is_none() {
            return;
        }
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
        let factor = f64::from((-scroll / 300.0).exp() / pinch);
        // Strokes belong to the view that they were painted in, which the wheel would leave too
        // easily.
        let is_held = fitting.is_on() && !session.sketchbook.sketch().is_empty();
        if factor != 1.0 && !is_held {
            view.dolly(factor);
        }
        // What is typed over an open list or menu is meant for that.
        if keyboard::is_keyboard_taken(ui.ctx()) || egui::Popup::is_any_open(ui.ctx()) {
            return;
        }
        if fitting.is_on() {
            out.extend(table::pressed(ui, KeyScope::Light));
        }
        out.extend(table::pressed(ui, KeyScope::Picture));
    }

    /// Starts or stops the turntable.
    pub(crate) fn toggle_turntable(&mut self) {
        self.turns = !self.turns;
    }

    /// Stops the turntable.
    pub(crate) fn stop_turning(&mut self) {
        self.turns = false;
    }

    /// Begins to look through the selected light, or ends it; gives the view from then on.
    ///
    /// # Errors
    /// The reason why there is no light to look through, as a sentence without its end.
    pub(crate) fn look_through(&mut self, session: &Session) -> Result<Orbit, String> {
        if let Some(through) = self.through.take() {
            return Ok(through.end(session));
        }
        let through = LookThrough::begin(session)?;
        let view = through.view().clone();
        self.through = Some(through);
        Ok(view)
    }

    /// True while a light is looked through.
    pub fn is_looking_through(&self) -> bool {
        self.through.is_some()
    }

    /// Forgets the light that is looked through, as another document is open.
    pub(crate) fn stop_looking_through(&mut self) {
        self.through = None;
    }

    /// True while a drag on the picture is under way.
    pub(crate) fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// Cancels the drag. Returns the camera and the lights at its beginning, and true if the last
    /// step of the history is the drag's and is to be undone too.
    pub(crate) fn give_up(&mut self, session: &Session) -> Option<(Orbit, bool)> {
        self.drag = None;
        let before = self.before.take()?;
        Some((before.view, session.steps().done() == before.place + 1))
    }

    /// Hint on the actions possible at the pointer; empty while the pointer is not over the
    /// picture.
    pub(crate) fn hint(&self) -> &str {
        &self.hint
    }

    /// Object of a scene that was under the pointer in the last frame.
    pub(crate) fn hovered(&self) -> Option<&ObjectId> {
        self.hovered.as_ref()
    }

    /// Width of the picture, in heights.
    pub(crate) fn aspect(&self) -> f64 {
        objects::aspect(self.rect)
    }

    /// Rectangle of the picture on the screen; for tests.
    pub fn rect(&self) -> Option<Rect> {
        self.rect
    }

    /// Points on the screen of a line of the selected layer, by its input's name (`offset`,
    /// `falloff`, `cutoff`), or of the edge of a band by its number from 0; for tests.
    pub fn curve(&self, port: &str) -> Vec<Pos2> {
        let curve = Curve::ALL.into_iter().find(|curve| curve.port() == port);
        let curve = curve.or_else(|| port.parse().ok().map(Curve::Edge));
        curve
            .zip(self.rect)
            .map(|(curve, rect)| self.isocurves.points(curve, rect))
            .unwrap_or_default()
    }

    /// Ends on the screen of the arrows toward the eye and the lights; for tests.
    pub fn arrows(&self) -> impl Iterator<Item = [Pos2; 2]> {
        self.arrows.iter().map(|arrow| [arrow.from, arrow.to])
    }

    /// Position on the screen of the middle of the part lit by the selected layer's light; for
    /// tests.
    pub fn middle(&self) -> Option<Pos2> {
        self.isocurves.middle(self.rect?)
    }

    /// Place on the screen of a handle of the selected highlight layer, by its label; for tests.
    pub fn highlight_handle(&self, label: &str) -> Option<Pos2> {
        self.highlight.place_of(label, self.rect?)
    }

    /// Writes the present picture to a file.
    pub(crate) fn export(&mut self, session: &Session, export: PictureExport, path: PathBuf) {
        self.exports.draw(export, session.snapshot(), Destination::File(path));
    }

    /// Copies the picture to the clipboard, at its size on the screen, or at a default size before
    /// it was shown.
    pub(crate) fn copy(&mut self, session: &Session, scale: f32) {
        self.exports.draw(
            PictureExport::Picture(self.size_in_pixels(scale)),
            session.snapshot(),
            Destination::Clipboard,
        );
    }

    /// Size of the picture on the screen, or a default size before it was shown.
    pub(crate) fn size_in_pixels(&self, scale: f32) -> [u32; 2] {
        self.rect.map_or([800, 800], |rect| picture_size(rect, scale)).map(|side| side.max(1))
    }

    /// Shows an image with the picture.
    pub(crate) fn show_reference(&mut self, session: &Session, path: PathBuf) {
        self.exports.read(path, session.assets.clone());
    }

    fn take_exports(&mut self, ui: &Ui, out: &mut Vec<Command>) {
        for done in self.exports.answers() {
            out.push(Command::Tell(match done {
                PictureExportResult::Saved(path) => tr!("Saved {file}", file = path.display()),
                PictureExportResult::Copied(image) => {
                    ui.ctx().copy_image(image);
                    tr!("The picture is in the clipboard").to_owned()
                }
                PictureExportResult::Read(path, image) => {
                    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                    let texture =
                        ui.ctx().load_texture("reference", image, egui::TextureOptions::LINEAR);
                    let (place, opacity) = self
                        .reference
                        .as_ref()
                        .map_or((ReferencePlacement::Beside, 0.5), |old| (old.place, old.opacity));
                    let message = tr!("{name} is shown with the picture; Options takes it away");
                    self.reference = Some(ReferenceImage { name, texture, place, opacity });
                    message
                }
                PictureExportResult::Failed(problem) => problem.message,
            }));
        }
    }
}

impl BackgroundJobs for Viewport {
    fn is_busy(&self) -> bool {
        self.surfaces.is_busy() || self.exports.is_busy() || self.colors.is_busy()
    }

    fn wait(&self) {
        self.surfaces.wait();
        self.exports.wait();
        self.colors.wait();
    }
}

/// Shows the rows of controls of the tools. Where they would leave the picture less than its least
/// height, they scroll, and where not even one row has room beside the picture, they are not shown.
fn tool_bars(ui: &mut Ui, session: &Session, tools: &mut PictureTools) {
    let key = ui.scope_id().with("height of the rows of the tools");
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let most = ui.available_height() - LEAST_PICTURE;
    if most < row {
        return;
    }
    // The height is that of the frame before.
    let known: f32 = ui.data(|data| data.get_temp(key)).unwrap_or_default();
    let height = if known > most {
        let area = ScrollArea::vertical().id_salt("tools").max_height(most);
        let area = area.min_scrolled_height(row).auto_shrink([false, true]);
        area.show(ui, |ui| tools.bars(ui, session)).content_size.y
    } else {
        let top = ui.cursor().top();
        tools.bars(ui, session);
        ui.cursor().top() - top
    };
    if (height - known).abs() > 0.5 {
        ui.data_mut(|data| data.insert_temp(key, height));
        if (height > most) != (known > most) {
            ui.ctx().request_discard("the rows of the tools have another height");
        }
    }
}

/// True while strokes are painted on the picture: handles, which cannot be dragged then, would lie
/// over the brush's controls.
fn has_brush(tools: &PictureTools) -> bool {
    tools.of::<FitTool>().is_on() || tools.of::<MaskTool>().is_on()
}
