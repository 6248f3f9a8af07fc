//! Probe: the value of every wire at the pixel under the pointer, computed in the background by the
//! reference, once with the rounding of a GPU and once in f64.

mod lights;
mod panel;

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Pos2, Rect, Stroke, Ui, pos2, vec2};

use crate::commands::{Command, Switch, table};
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::fields::wire_value::{WireReadings, readings, row_names};
use crate::frame::{Draw, PlanOptions, Planner, Setup};
use crate::progress::Progress;
use crate::reference::{LightAccount, ReferenceOptions, WireValue, light_accounts, probe_wires};
use crate::state::session::Session;
use crate::state::snapshot::{CachedPlanner, RenderSnapshot, Stamp};
use crate::state::worker::{BackgroundJobs, Worker};
use crate::tools::surface::read_surface;
use crate::tools::{PictureContext, SwitchPlace, ToolRow};
use crate::widgets::theme;

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Bar,
    |parts| Box::new(Probe::new(parts.wake())),
    |tools| tools.of::<Probe>().is_on(),
    |tools, ui, out| {
        let mut is_on = tools.of::<Probe>().is_on();
        let help = table::help_of(&Command::Probe(Switch::Toggle));
        if ui.toggle_value(&mut is_on, tr!("Probe pixel")).on_hover_text(help).changed() {
            out.push(Command::Probe(is_on.into()));
        }
    },
)
.with_pointer(|tools| match tools.of::<Probe>().pinned() {
    None => tr!("Rest the pointer to read a pixel, click to keep it · Esc leaves the probe"),
    Some(_) => {
        tr!("This pixel is kept: click another · Esc lets go of it, Esc again leaves the probe")
    }
})
.with_overlay(|tools, ui, PictureContext { session, response, rect, pointer }, _| {
    tools.of_mut::<Probe>().update(ui, session, *rect, *pointer, response.clicked());
})
.with_mark(|tools, ui, rect| tools.of::<Probe>().mark(ui, rect))
.with_jobs(|tools| tools.of::<Probe>());

/// Time after which the pointer counts as resting, in seconds.
const REST: f64 = 0.15;

/// Place and state of a probe: for the same ones the known result is used.
#[derive(Clone, Debug, PartialEq)]
struct ProbeSpot {
    stamp: Stamp,
    pixel: [u32; 2],
    size: [u32; 2],
}

struct ProbeRequest {
    spot: ProbeSpot,
    snapshot: RenderSnapshot,
    progress: Progress,
}

struct ProbeResult {
    spot: ProbeSpot,
    /// Values of the wires, and the lights there; `None` where nothing is drawn.
    result: Result<Option<ProbedPixel>, Vec<Diagnostic>>,
}

/// Values at a pixel.
struct ProbedPixel {
    wires: Vec<WireValue>,
    lights: Vec<LightAccount>,
}

/// The probe and its last result.
pub struct Probe {
    worker: Worker<ProbeRequest, ProbeResult>,
    is_on: bool,
    /// True if the pixel stays where it is while the pointer moves on.
    is_pinned: bool,
    pixel: Option<[u32; 2]>,
    seen: Option<ProbeSpot>,
    seen_at: f64,
    asked: Option<ProbeSpot>,
    progress: Progress,
    found: Option<ProbeResult>,
    /// The result in few words, for the canvas.
    readings: Arc<WireReadings>,
    /// Names of the wires' rows.
    names: Vec<String>,
    jump: bool,
    /// True if the panel lists lights and not wires.
    lists_lights: bool,
}

impl Probe {
    /// Creates a probe that is off. `wake` is called from another thread when there is a result.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let mut planners = [0; 2].map(|_| CachedPlanner::new(Planner::for_probes));
        Self {
            worker: Worker::new("probe", wake, move |query| probe(&mut planners, query)),
            is_on: false,
            is_pinned: false,
            pixel: None,
            seen: None,
            seen_at: 0.0,
            asked: None,
            progress: Progress::new(),
            found: None,
            readings: Arc::default(),
            names: Vec::new(),
            jump: false,
            lists_lights: false,
        }
    }

    /// True if the pointer probes.
    pub fn is_on(&self) -> bool {
        self.is_on
    }

    /// Pixel that was pinned by a click.
    pub fn pinned(&self) -> Option<[u32; 2]> {
        self.pixel.filter(|_| self.is_pinned)
    }

    /// Wires of the last result, in the order of their computation.
    pub fn wires(&self) -> &[WireValue] {
        self.pixel_found().map_or(&[], |found| &found.wires)
    }

    /// Account of each light at the pixel: those that reach it, by their energy, then the others.
    pub fn lights(&self) -> &[LightAccount] {
        self.pixel_found().map_or(&[], |found| &found.lights)
    }

    fn pixel_found(&self) -> Option<&ProbedPixel> {
        self.found.as_ref().and_then(|found| found.result.as_ref().ok()?.as_ref())
    }

    /// Values at the pixel for the canvas, while the probe is on and has a pixel; true if they are
    /// those of the present place and state.
    pub(crate) fn readings(&self) -> (Option<Arc<WireReadings>>, bool) {
        let is_shown = self.is_on && self.pixel.is_some();
        (is_shown.then(|| self.readings.clone()), self.is_current())
    }

    pub(crate) fn turn(&mut self, on: bool) {
        self.is_on = on;
        self.is_pinned = false;
        if !on {
            self.progress.stop();
            self.asked = None;
            self.pixel = None;
            self.seen = None;
        }
    }

    /// Unpins the pixel, or else turns the probe off.
    pub(crate) fn escape(&mut self) {
        if self.is_pinned {
            self.is_pinned = false;
        } else {
            self.turn(false);
        }
    }

    /// Takes a result, and probes under the pointer once it rests. `pointer` is over the picture in
    /// `rect`.
    pub(crate) fn update(
        &mut self,
        ui: &Ui,
        session: &Session,
        rect: Rect,
        pointer: Option<Pos2>,
        is_click: bool,
    ) {
        for found in self.worker.answers() {
            if self.asked.as_ref() == Some(&found.spot) {
                self.found = Some(found);
                let look = session.look_with_library();
                self.readings = Arc::new(readings(look, self.wires()));
                self.names = row_names(look, self.wires());
            }
        }
        if !self.is_on {
            return;
        }
        let scale = ui.pixels_per_point();
        let size = picture_size(rect, scale);
        if let Some(at) = pointer.filter(|at| rect.contains(*at) && (is_click || !self.is_pinned)) {
            let offset = (at - rect.min) * scale;
            self.pixel = Some([
                (offset.x as u32).min(size[0].max(1) - 1),
                (offset.y as u32).min(size[1].max(1) - 1),
            ]);
        }
        if is_click && self.pixel.is_some() {
            self.is_pinned = true;
        }
        let Some(pixel) = self.pixel.filter(|pixel| pixel[0] < size[0] && pixel[1] < size[1])
        else {
            return;
        };
        let spot = ProbeSpot { stamp: session.stamp(), pixel, size };
        let now = ui.input(|input| input.time);
        if self.seen.as_ref() != Some(&spot) {
            self.seen = Some(spot.clone());
            self.seen_at = now;
        }
        if self.asked.as_ref() == Some(&spot) {
            return;
        }
        let rested = now - self.seen_at;
        if is_click || rested >= REST {
            self.ask(session, spot);
        } else {
            ui.ctx().request_repaint_after_secs((REST - rested).max(0.01) as f32);
        }
    }

    fn ask(&mut self, session: &Session, spot: ProbeSpot) {
        self.progress.stop();
        self.progress = Progress::new();
        self.asked = Some(spot.clone());
        let query =
            ProbeRequest { spot, snapshot: session.snapshot(), progress: self.progress.clone() };
        self.worker.request(|_| query);
    }

    /// True if the last result is of the present place and state.
    fn is_current(&self) -> bool {
        self.found.as_ref().is_some_and(|found| Some(&found.spot) == self.seen.as_ref())
    }

    /// Draws the cross-hair over the picture.
    pub(crate) fn mark(&self, ui: &Ui, rect: Rect) {
        let Some(pixel) = self.pixel.filter(|_| self.is_on) else { return };
        let at =
            rect.min + vec2(pixel[0] as f32 + 0.5, pixel[1] as f32 + 0.5) / ui.pixels_per_point();
        let color = if self.is_pinned { theme::of(ui).accent } else { egui::Color32::WHITE };
        let painter = ui.painter_at(rect);
        for (width, color) in [(3.0, egui::Color32::from_black_alpha(120)), (1.0, color)] {
            let stroke = Stroke::new(width, color);
            for (near, far) in [(5.0, 14.0), (-5.0, -14.0)] {
                painter.line_segment([at + vec2(near, 0.0), at + vec2(far, 0.0)], stroke);
                painter.line_segment([at + vec2(0.0, near), at + vec2(0.0, far)], stroke);
            }
            if self.is_pinned {
                painter.rect_stroke(
                    Rect::from_center_size(at, vec2(6.0, 6.0)),
                    0.0,
                    stroke,
                    egui::StrokeKind::Middle,
                );
            }
        }
        let text = format!("{}, {}", pixel[0], pixel[1]);
        let is_right = at.x > rect.center().x;
        let align = if is_right { egui::Align2::RIGHT_TOP } else { egui::Align2::LEFT_TOP };
        let corner = pos2(at.x + if is_right { -8.0 } else { 8.0 }, at.y + 8.0);
        let galley = painter.layout_no_wrap(text, egui::FontId::monospace(11.0), color);
        let place = align.anchor_size(corner, galley.size());
        painter.rect_filled(place.expand(2.0), 2.0, egui::Color32::from_black_alpha(150));
        painter.galley(place.min, galley, color);
    }
}

impl BackgroundJobs for Probe {
    fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    fn wait(&self) {
        self.worker.wait();
    }
}

impl Drop for Probe {
    fn drop(&mut self) {
        self.progress.stop();
    }
}

/// Size in pixels of a picture that fills `rect`.
pub(crate) fn picture_size(rect: Rect, scale: f32) -> [u32; 2] {
    [rect.width(), rect.height()].map(|side| (side * scale).round().clamp(0.0, 8192.0) as u32)
}

/// Note for an object that wears another look than the open one, whose nodes are not on the canvas.
fn other_look(setup: &Setup, draw: &Draw) -> Option<Diagnostic> {
    let object = setup.objects.iter().find(|object| object.id == draw.object)?;
    let part = object.mesh.parts.iter().position(|part| part.indices == draw.indices)?;
    // The open look is the first of the setup.
    let is_other = *object.looks.get(part)? != Some(0);
    is_other.then(|| {
        let message = tr!(
            "`{object}` wears another look, {look}",
            object = draw.object,
            look = draw.look_name
        );
        Diagnostic::note("other-look", message)
            .hint(tr!("leave the probe and click the object to open its look"))
    })
}

/// Probes a pixel. The second planner is for the surface there alone.
fn probe(
    [planner, of_surface]: &mut [CachedPlanner; 2],
    ProbeRequest { spot, snapshot, progress }: ProbeRequest,
) -> ProbeResult {
    let planner = planner.of(&snapshot.look, &snapshot.library);
    let mut find = || {
        let setup = snapshot.setup(&mut planner.assets)?.value;
        let options = PlanOptions { size: spot.size, samples: 1, time: snapshot.time };
        let plan = planner.plan(&setup, &snapshot.library, &Live::All, &options)?.value;
        let wires = probe_wires(&plan, spot.pixel, &ReferenceOptions::default(), &progress)
            .map_err(|problem| vec![problem])?;
        let seen = wires.as_ref().and_then(|wires| plan.draws.get(wires.first()?.draw));
        if let Some(problem) = seen.and_then(|draw| other_look(&setup, draw)) {
            return Err(vec![problem]);
        }
        let Some(wires) = wires else { return Ok(None) };
        let place = (spot.pixel, spot.size);
        let surface = read_surface(of_surface, &snapshot, place, false, &progress)?;
        let moment = (&plan, snapshot.time);
        let lights = surface
            .map(|surface| light_accounts(&setup, &snapshot.library, moment, &wires, &surface.seen))
            .transpose();
        let lights = lights.map_err(|problem| vec![problem])?.unwrap_or_default();
        Ok(Some(ProbedPixel { wires, lights }))
    };
    let result = find();
    ProbeResult { spot, result }
}
