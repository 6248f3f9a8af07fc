//! Placing of a light by what it does: a click or a drag on the model says where the light's
//! highlight, its shadow or its terminator shall be.
//!
//! The surface under the pointer is read by the reference on a thread (`work`), so that the light
//! goes exactly where the probe then reads what was asked; [`placing`](crate::placing) has the
//! formulas. Results arrive while a drag goes on: the light follows, and all is one step.

mod bar;
mod work;

use chiaro_locale::tr;
use eframe::egui::{
    Align2, CursorIcon, FontId, Id, PointerButton, Pos2, Rect, Stroke, Ui, pos2, vec2,
};
use glam::DVec3;
use indexmap::IndexSet;

use crate::commands::{Command, LightMark, PlacingCommand, table};
use crate::fields::layer::{self, RegionLayers, SelectedLayer};
use crate::fields::lighting::{OwnedLight, Owner, light_in_view, set_light_like};
use crate::ids::LightId;
use crate::placing::{KeptDistance, Parametrization, PlacedLight, terminator_angle};
use crate::progress::Progress;
use crate::state::session::Session;
use crate::state::snapshot::CachedPlanner;
use crate::state::worker::{BackgroundJobs, Worker};
use crate::tools::probe::picture_size;
use crate::tools::{PictureContext, SwitchPlace, ToolRow};
use crate::widgets::icon::icon_toggle;
use crate::widgets::spots::{self, Spot};
use crate::widgets::theme;
use work::{PlacingAnswer, PlacingRequest, PlacingTask, SurfaceAnswer, WantedMark};

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Bar,
    |parts| Box::new(PlacingTool::new(parts.wake())),
    |tools| tools.of::<PlacingTool>().is_on(),
    |tools, ui, out| tools.of::<PlacingTool>().toggle(ui, out),
)
.with_pointer(|tools| &tools.of::<PlacingTool>().hint)
.with_drags()
.with_interaction(|tools, ui, context| tools.of_mut::<PlacingTool>().interact(ui, context))
.with_overlay(|tools, ui, context, _| tools.of_mut::<PlacingTool>().over(ui, context))
.with_jobs(|tools| tools.of::<PlacingTool>());

/// Light that is being placed, from the press on.
struct HeldPlacing {
    /// Number of the press.
    number: u64,
    id: LightId,
    /// Pixel that was asked about last.
    pixel: [u32; 2],
    /// Number of steps that were done when the press began.
    steps: usize,
    /// True while the pointer is pressed.
    is_down: bool,
    /// Hint on effects that the result leaves out.
    leaves_out: Option<&'static str>,
    /// Work at the pixel, with the light as it was when the press began: solutions nearest to that
    /// are chosen.
    task: PlacingTask,
}

/// The tool and its state.
pub struct PlacingTool {
    worker: Worker<PlacingRequest, PlacingAnswer>,
    progress: Progress,
    is_on: bool,
    mark: LightMark,
    /// Light that was chosen in the bar; `None` for the selected one.
    chosen: Option<LightId>,
    /// Point of the caster whose shadow is placed, in world space.
    caster: Option<DVec3>,
    held: Option<HeldPlacing>,
    presses: u64,
    /// Sentence on the last result.
    told: Option<String>,
    hint: String,
}

impl PlacingTool {
    /// Creates the tool, off. `wake` is called from another thread when a result is there.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let mut planner = CachedPlanner::new(crate::frame::Planner::for_truth);
        Self {
            worker: Worker::new("placing", wake, move |request| {
                work::place(&mut planner, &request)
            }),
            progress: Progress::new(),
            is_on: false,
            mark: LightMark::Highlight,
            chosen: None,
            caster: None,
            held: None,
            presses: 0,
            told: None,
            hint: String::new(),
        }
    }

    /// True if the pointer places a light.
    pub fn is_on(&self) -> bool {
        self.is_on
    }

    /// Hint on the actions possible, after the result of the last one; for tests.
    pub fn hint(&self) -> &str {
        &self.hint
    }

    /// Begins or ends placing.
    pub(crate) fn turn(&mut self, on: bool) {
        self.is_on = on;
        self.forget();
        if !on {
            self.chosen = None;
        }
    }

    /// Places by a mark from now on. Returns false where that mark was in use: placing then ends.
    pub(crate) fn take(&mut self, mark: LightMark) -> bool {
        let ends = self.is_on && self.mark == mark;
        self.mark = mark;
        self.turn(!ends);
        !ends
    }

    /// Gives up one activity. Returns true where the last step is the drag's, and is to be undone.
    pub(crate) fn leave(&mut self, session: &Session) -> bool {
        let held = self.held.take().filter(|held| held.is_down);
        if let Some(held) = held {
            self.told = Some(tr!("The light is where it was").to_owned());
            return session.steps().done() == held.steps + 1;
        }
        if self.caster.take().is_none() {
            self.turn(false);
        }
        self.told = None;
        false
    }

    fn forget(&mut self) {
        self.progress.stop();
        self.progress = Progress::new();
        (self.held, self.caster, self.told) = (None, None, None);
    }

    /// Lights that can be placed: the look's, then those that the scene has besides.
    fn lights(session: &Session) -> IndexSet<&LightId> {
        let of = |owner: Owner| owner.lights(session).into_iter().flat_map(|lights| lights.keys());
        of(Owner::Look).chain(of(Owner::Scene)).collect()
    }

    /// The light that is placed: the chosen one, that of the selection, or the first.
    fn light(&self, session: &Session) -> Option<LightId> {
        let lights = Self::lights(session);
        let selected = || layer::light_at_hand(session);
        let chosen = self.chosen.clone().filter(|id| lights.contains(id));
        chosen.or_else(selected).or_else(|| lights.first().map(|id| (*id).clone()))
    }

    /// Goal of the mark for a light, and the effects that the goal leaves out.
    ///
    /// # Errors
    /// The reason why there is none, as a sentence without its end.
    fn wanted(
        &self,
        session: &Session,
        light: &LightId,
    ) -> Result<(WantedMark, Option<&'static str>), String> {
        match self.mark {
            LightMark::Highlight => Ok(highlight(session, light)),
            LightMark::Terminator => terminator(&edge_layer(session, light)?),
            LightMark::Shadow => self
                .caster
                .map(|caster| (WantedMark::Shadow(caster), None))
                .ok_or_else(|| tr!("Click what casts the shadow first").to_owned()),
        }
    }

    fn interact(&mut self, ui: &Ui, context: &PictureContext<'_>) -> Option<Command> {
        let PictureContext { session, response, rect, .. } = *context;
        let command = self.take_answers(session);
        if !self.is_on {
            return command;
        }
        let (is_pressed, is_down, is_alt, at) = ui.input(|input| {
            let pointer = &input.pointer;
            let is_alt = input.modifiers.alt;
            (pointer.primary_pressed(), pointer.primary_down(), is_alt, pointer.interact_pos())
        });
        let size = picture_size(rect, ui.pixels_per_point());
        let pixel_at = |at: Pos2| {
            let offset = (at - rect.min) * ui.pixels_per_point();
            [0, 1].map(|axis| (offset[axis].max(0.0) as u32).min(size[axis].max(1) - 1))
        };
        let is_on_picture =
            response.is_pointer_button_down_on() || response.clicked_by(PointerButton::Primary);
        if let Some(at) = at.filter(|_| is_pressed && is_on_picture && !is_alt) {
            self.begin(session, pixel_at(at), size);
        } else if let Some(held) = self.held.as_mut().filter(|held| held.is_down) {
            held.is_down = is_down;
            let pixel = at.map(pixel_at).filter(|pixel| *pixel != held.pixel);
            // The caster is where the press was.
            if let Some(pixel) = pixel.filter(|_| !matches!(held.task, PlacingTask::Caster)) {
                held.pixel = pixel;
                self.ask(session, size);
            }
        }
        self.hint = self.hint_for(session);
        command
    }

    /// Begins a click or a drag at a pixel.
    fn begin(&mut self, session: &Session, pixel: [u32; 2], size: [u32; 2]) {
        (self.held, self.told) = (None, None);
        self.presses += 1;
        let Some(id) = self.light(session) else { return };
        let Some(start) = light_in_view(session, &id).cloned() else { return };
        let chooses_caster = self.mark == LightMark::Shadow && self.caster.is_none();
        let task = match self.wanted(session, &id) {
            _ if chooses_caster => Ok((PlacingTask::Caster, None)),
            Ok((goal, left_out)) => Ok((PlacingTask::Place(Box::new(start), goal), left_out)),
            Err(why) => Err(why),
        };
        let (task, leaves_out) = match task {
            Ok(task) => task,
            Err(why) => {
                self.told = Some(why);
                return;
            }
        };
        let (number, steps) = (self.presses, session.steps().done());
        self.held = Some(HeldPlacing { number, id, pixel, steps, is_down: true, leaves_out, task });
        self.ask(session, size);
    }

    fn ask(&self, session: &Session, size: [u32; 2]) {
        let Some(held) = &self.held else { return };
        let request = PlacingRequest {
            number: held.number,
            pixel: held.pixel,
            size,
            snapshot: session.snapshot(),
            task: held.task.clone(),
            progress: self.progress.clone(),
        };
        self.worker.request(|_| request);
    }

    /// Takes the newest answer of the present press.
    fn take_answers(&mut self, session: &Session) -> Option<Command> {
        let answer = self.worker.answers().pop()?;
        let held = self.held.as_ref().filter(|held| held.number == answer.number)?;
        match answer.found {
            Err(why) => {
                self.told = Some(why);
                None
            }
            Ok(SurfaceAnswer::Caster(point)) => {
                self.caster = Some(point);
                self.told = None;
                None
            }
            Ok(SurfaceAnswer::Placed(placed)) => {
                self.told = Some(self.said(session, held, &placed));
                let change = set_light_like(session, &held.id, &placed.light)?;
                Some(change.held(Id::unique("placed light").with(held.number)))
            }
        }
    }

    /// Sentence on a light that was placed, and on what is kept of it.
    fn said(&self, session: &Session, held: &HeldPlacing, placed: &PlacedLight) -> String {
        let name = name(session, &held.id);
        let mut said = match self.mark {
            LightMark::Highlight => tr!("The highlight of {name} is there"),
            LightMark::Shadow => tr!("The shadow that {name} throws of the caster is there"),
            LightMark::Terminator => tr!("The terminator of {name} is there"),
        };
        match placed.kept {
            Some(KeptDistance::FromPoint) => said += tr!(", at the light's distance as before"),
            Some(KeptDistance::FromCaster) => {
                said += tr!(", at its distance from the caster as before");
            }
            None => {}
        }
        if placed.is_aimed {
            said += tr!("; it shone past that place, and is aimed at it now");
        }
        if let Some(left_out) = held.leaves_out {
            said += &tr!("; without {left_out}");
        }
        said
    }

    /// Hint on the actions possible, after the sentence on the last result.
    fn hint_for(&self, session: &Session) -> String {
        let next = match self.light(session) {
            None => tr!("The look has no light that could be placed · Esc leaves").to_owned(),
            Some(id) => {
                let name = name(session, &id);
                match (self.mark, self.caster) {
                    (LightMark::Highlight, _) => {
                        let mirrors = match highlight(session, &id).0 {
                            WantedMark::Angle { parametrization, .. } => parametrization.mirrors(),
                            WantedMark::Shadow(_) => true,
                        };
                        match mirrors {
                            true => tr!(
                                "Click or drag on the model: the highlight of {name} goes there"
                            ),
                            false => tr!(
                                "Click or drag on the model: the bright middle of {name} goes there"
                            ),
                        }
                    }
                    (LightMark::Terminator, _) => match edge_layer(session, &id) {
                        Ok(layer) => tr!(
                            "Click or drag on the model: the terminator of {name} in {layer} goes \
                             there",
                            layer = layer.name
                        ),
                        Err(why) => why,
                    },
                    (LightMark::Shadow, None) => {
                        tr!("Click what casts the shadow of {name}")
                    }
                    (LightMark::Shadow, Some(_)) => {
                        tr!("Click or drag where the shadow of {name} shall fall")
                    }
                }
            }
        };
        let escape = match (self.held.as_ref().is_some_and(|held| held.is_down), self.caster) {
            (true, _) => tr!("Esc puts the light back"),
            (false, Some(_)) => tr!("Esc chooses another caster"),
            (false, None) => tr!("Esc leaves"),
        };
        let told = self.told.as_ref().filter(|told| **told != next);
        let told = told.map(|told| format!("{told} · "));
        format!("{}{next} · {escape}", told.unwrap_or_default())
    }

    /// Shows the bar over the picture, the caster, and the way from it to the pointer.
    fn over(&mut self, ui: &mut Ui, context: &PictureContext<'_>) {
        if !self.is_on {
            return;
        }
        let PictureContext { session, response, rect, .. } = *context;
        if response.hovered() {
            ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
        }
        self.bar(ui, rect, session);
        let Some([x, y]) = self.caster.and_then(|at| session.view.orbit.place_in_picture(at))
        else {
            return;
        };
        let at = rect.center() + vec2(x as f32, -y as f32) * rect.height();
        paint_caster(ui, rect, at, context.pointer);
    }

    /// Shows the button that begins and ends placing.
    fn toggle(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let command = Command::Placing(PlacingCommand::Turn(crate::commands::Switch::Toggle));
        let help = tr!("Place light: {help}", help = table::help_of(&command));
        // A light, and the way from it to a place.
        let button = icon_toggle(ui, self.is_on, tr!("Place light"), |painter, at, stroke| {
            let (light, place) = (at + vec2(3.5, -3.5), at + vec2(-5.5, 5.5));
            painter.circle_filled(light, 3.4, stroke.color);
            painter.line_segment([light.lerp(place, 0.45), light.lerp(place, 0.75)], stroke);
            painter.circle_filled(place, 1.6, stroke.color);
        });
        spots::note(ui, Spot::PlaceLight, button.rect);
        if button.on_hover_text(help).clicked() {
            out.push(command);
        }
    }
}

/// Display name of a light.
fn name(session: &Session, id: &LightId) -> String {
    OwnedLight::lighting(session, id).map_or_else(|| id.to_string(), |light| light.full_name())
}

/// Goal of a highlight: where the view is mirrored, or the middle of what the layers light, where
/// none of them mirrors.
fn highlight(session: &Session, light: &LightId) -> (WantedMark, Option<&'static str>) {
    let mut layers = layer::fed_by(session, light);
    layers.extend(RegionLayers::of(session, light).layers);
    let mirroring = layers.iter().find(|layer| layer.shading.mirrors());
    let layer = mirroring.or_else(|| layers.first());
    // A half-vector lies on the normal where the mirrored view lies on the light.
    let shading = layer.map(|layer| layer.shading).or_else(|| layer::shading_of_sets(session));
    let parametrization = match shading {
        None | Some(Parametrization::HalfVector) => Parametrization::Specular,
        Some(shading) => shading,
    };
    let goal = WantedMark::Angle { parametrization, angle: 0.0, warp: None };
    (goal, layer.and_then(|layer| layer.leaves_out))
}

/// The layer whose terminator is meant: the first of the open graph, which is the selected one, or
/// the one of a group that runs for each light.
///
/// # Errors
/// The reason why there is none, or why it is not known which, as a sentence without its end.
fn edge_layer(session: &Session, light: &LightId) -> Result<SelectedLayer, String> {
    let regions = RegionLayers::of(session, light);
    if let Some(index) = regions.selected {
        return Ok(regions.layers[index].clone());
    }
    if let Some(layer) = layer::fed_by(session, light).into_iter().next() {
        return Ok(layer);
    }
    let (name, groups) = (name(session, light), regions.groups.join(", "));
    let names: Vec<&str> = regions.layers.iter().map(|layer| layer.name.as_str()).collect();
    match &regions.layers[..] {
        [layer] => Ok(layer.clone()),
        [] if groups.is_empty() => Err(tr!(
            "No layer of this graph draws {name}, so that it has no terminator: place it by its \
             highlight or its shadow"
        )),
        [] => Err(tr!(
            "{groups} draws {name}, but by no profile of that light's angle alone, so that it has \
             no terminator: place it by its highlight or its shadow"
        )),
        _ => Err(tr!(
            "{name} has {count} terminators: {layers}. Open the group, select the profile that is \
             meant, and click again",
            count = names.len(),
            layers = names.join(", ")
        )),
    }
}

/// Goal of a terminator.
fn terminator(layer: &SelectedLayer) -> Result<(WantedMark, Option<&'static str>), String> {
    if layer.is_shape_wired() {
        return Err(tr!(
            "The angles of {layer} come by wires, so that its terminator is not known",
            layer = layer.name
        ));
    }
    let [offset, falloff, cutoff] = layer.angles();
    let angle = terminator_angle(offset, falloff, cutoff).ok_or_else(|| {
        let name = &layer.name;
        tr!("{name} is ambient: its tone is the same at every angle")
    })?;
    let warp = layer.warp.filter(|(slope, amount)| slope * amount != 0.0);
    let goal = WantedMark::Angle { parametrization: layer.shading, angle, warp };
    Ok((goal, layer.leaves_out))
}

fn paint_caster(ui: &Ui, rect: Rect, at: Pos2, pointer: Option<Pos2>) {
    let painter = ui.painter_at(rect);
    let color = theme::SUN;
    if let Some(to) = pointer.filter(|to| to.distance(at) > 12.0) {
        let from = at + (to - at).normalized() * 7.0;
        painter.line_segment([from, to], Stroke::new(3.5, theme::HALO));
        painter.line_segment([from, to], Stroke::new(1.5, color));
    }
    painter.circle_stroke(at, 6.0, Stroke::new(4.0, theme::HALO));
    painter.circle_stroke(at, 6.0, Stroke::new(2.0, color));
    let text = tr!("caster").to_owned();
    let galley = painter.layout_no_wrap(text, FontId::proportional(theme::SMALL_TEXT), color);
    let place = Align2::LEFT_CENTER.anchor_size(pos2(at.x + 12.0, at.y), galley.size());
    painter.rect_filled(place.expand(3.0), 3.0, theme::PLATE);
    painter.galley(place.min, galley, color);
}

impl BackgroundJobs for PlacingTool {
    fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    fn wait(&self) {
        self.worker.wait();
    }
}

impl Drop for PlacingTool {
    fn drop(&mut self) {
        self.progress.stop();
    }
}

#[cfg(test)]
mod tests;
