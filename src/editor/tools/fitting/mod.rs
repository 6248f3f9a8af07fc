//! Painted shading in the window (Okabe et al. 2007): the user paints on the picture where it
//! should be lighter, darker or of a color, and the look's lights, profiles and colors are fitted
//! to the strokes.
//!
//! `sketch` is the painted layer, which `session` holds, so that undo covers it. `ground` is the
//! look's picture under the strokes; `pointer` paints, `target` turns strokes into goals, `work`
//! fits on a thread. The result is shown as a preview of the session, which is no edit until it is
//! applied, as one step.

mod bar;
mod cover;
mod fit;
mod ground;
mod overlay;
mod panel;
mod pointer;
mod target;
mod tools;
mod veil;
mod work;

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{self, Rect, Ui};

use crate::commands::{Command, LightBrush, SketchCommand};
use crate::diag::has_errors;
use crate::document::{Look, Tile};
use crate::fit::{KeptParts, PixelGoal as Painted};
use crate::state::revision::DocumentNumber;
use crate::state::session::Session;
pub(crate) use crate::state::sketch::Standpoint;
use crate::state::worker::{BackgroundJobs, Worker};
use crate::tools::{PictureContext, SwitchPlace, ToolRow};
use fit::{FitOutcome, FitRun, of};
use ground::{Ground, GroundInputs, Grounds};
use overlay::Textures;
use pointer::{LightStroke, WaitingStroke};
use target::FINENESS;
use tools::Tools;
use work::{FitRequest, FitResult};

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Bar,
    |parts| Box::new(FitTool::new(parts.wake())),
    |tools| tools.of::<FitTool>().is_on(),
    |tools, ui, out| tools.of::<FitTool>().toggle(ui, out),
)
.with_pointer(|tools| tools.of::<FitTool>().hint())
.with_drags()
.with_bar(|tools, ui, _| tools.of_mut::<FitTool>().bar(ui))
.with_interaction(|tools, ui, PictureContext { session, response, rect, .. }| {
    tools.of_mut::<FitTool>().interact(ui, response, *rect, session)
})
.with_overlay(|tools, ui, PictureContext { session, response, rect, .. }, out| {
    tools.of_mut::<FitTool>().over(ui, response, *rect, session, out);
})
.with_jobs(|tools| tools.of::<FitTool>());

/// Height of the picture that is fitted at, in pixels: strokes are broad, and a fit looks at some
/// hundred pixels only.
const HEIGHT: u32 = 128;
/// Largest width of that picture, in heights.
const WIDEST: f64 = 2.0;
/// Least number of painted pixels for a fit: fewer do not determine lights.
const LEAST_PAINTED: usize = 12;
/// Number of starting points from which a look is fitted: lights that are far off are found from
/// some of them.
const STARTS: usize = 10;
/// RMS of a channel at which a fit ends, 0 to 1: painting by hand is not precise enough to be worth
/// more time.
const ENOUGH: f64 = 1.0 / 255.0;
/// Time that the view rests before the ground is drawn anew, in seconds.
const REST: f64 = 0.15;

/// Settings of a fit.
#[derive(Clone, Copy, Debug)]
struct FitSettings {
    keep: KeptParts,
    /// Weight of keeping unpainted parts as they are, 0 to 1.
    keep_rest: f64,
    /// Largest number of layers of a fit from nothing.
    layers: usize,
    /// Number of starting points from which a look is fitted.
    starts: usize,
}

/// Overlays that are shown over the picture.
#[derive(Clone, Copy, Debug)]
struct OverlaySettings {
    strokes: bool,
    misses: bool,
}

/// Painted light: the brush, the fit under way, and the result of the last one.
pub struct FitTool {
    is_on: bool,
    /// Height of the picture that is fitted at, in pixels.
    height: u32,
    /// Width of the viewport, in heights.
    aspect: f64,
    tools: Tools,
    how: FitSettings,
    shows: OverlaySettings,
    grounds: Grounds,
    /// Inputs that were seen last, and the time of that, in seconds of the window's clock.
    seen: Option<(GroundInputs, f64)>,
    going: Option<LightStroke>,
    /// Stroke that waits until the picture under it is read.
    waiting: Option<WaitingStroke>,
    /// Document that is painted on; painting ends when another is open.
    document: DocumentNumber,
    goals: Option<(Arc<Tile>, GroundInputs, Vec<Painted>)>,
    fitter: Worker<FitRequest, FitResult>,
    running: Option<FitRun>,
    outcome: Option<FitOutcome>,
    /// Message on the last fit, or on why there was none.
    told: Option<String>,
    textures: Textures,
    hint: &'static str,
    wake: Arc<dyn Fn() + Send + Sync>,
}

impl FitTool {
    /// Starts without strokes. `wake` is called from another thread when a thread has a result or
    /// progress.
    pub(crate) fn new(wake: impl Fn() + Clone + Send + Sync + 'static) -> Self {
        Self {
            is_on: false,
            height: HEIGHT,
            aspect: 1.0,
            tools: Tools::default(),
            how: FitSettings {
                keep: KeptParts::default(),
                keep_rest: 0.5,
                layers: 2,
                starts: STARTS,
            },
            shows: OverlaySettings { strokes: true, misses: false },
            grounds: Grounds::new(wake.clone()),
            seen: None,
            going: None,
            waiting: None,
            document: DocumentNumber::default(),
            goals: None,
            fitter: work::start(wake.clone()),
            running: None,
            outcome: None,
            told: None,
            textures: Textures::default(),
            hint: "",
            wake: Arc::new(wake),
        }
    }

    /// True if the pointer paints on the picture.
    pub fn is_on(&self) -> bool {
        self.is_on
    }

    /// True while a fit is under way.
    pub fn is_fitting(&self) -> bool {
        self.running.is_some()
    }

    /// Number of painted pixels of the object, at the size of the fit.
    pub fn painted(&self) -> usize {
        self.goals.as_ref().map_or(0, |(.., goals)| goals.len())
    }

    /// Errors of the picture against the strokes before and after the last fit: RMS of a channel, 0
    /// to 1.
    pub fn errors(&self) -> Option<[f64; 2]> {
        self.outcome.as_ref().map(|outcome| [outcome.report.before, outcome.report.after])
    }

    /// Message on the last fit, or the reason why nothing could be fitted.
    pub fn told(&self) -> Option<&str> {
        self.told.as_deref()
    }

    /// Sets the height of the picture that is fitted at, in pixels, and the number of starting
    /// points; for programs that drive the window.
    pub fn set_effort(&mut self, height: u32, starts: usize) {
        self.height = height.clamp(16, 512);
        self.how.starts = starts.max(1);
    }

    /// Sets the largest number of layers of a fit from nothing; for programs that drive the window.
    pub fn set_layers(&mut self, layers: usize) {
        self.how.layers = layers.clamp(1, panel::MOST_LAYERS);
    }

    /// Hint on the actions possible at the pointer; empty while painting is off.
    pub(crate) fn hint(&self) -> &str {
        if self.is_on { self.hint } else { "" }
    }

    /// Waits for the picture under the strokes, but not for a fit.
    pub fn wait_for_ground(&self) {
        self.grounds.wait();
    }

    /// Begins or ends painting. The strokes stay.
    pub(crate) fn turn(&mut self, on: bool, session: &Session) -> Vec<Command> {
        self.is_on = on;
        self.document = session.revisions().document;
        (self.going, self.waiting) = (None, None);
        let mut out = vec![Command::Sketch(SketchCommand::Open(on))];
        if !on {
            self.give_up();
            out.extend(self.discard());
            self.grounds.rest();
            self.told = None;
        }
        out
    }

    /// Gives up the innermost activity: a stroke, a fit, a result, or painting itself.
    pub(crate) fn leave(&mut self, session: &Session) -> Vec<Command> {
        if self.going.take().is_some() || self.waiting.take().is_some() {
            return Vec::new();
        }
        if self.running.is_some() {
            self.stop();
            Vec::new()
        } else if self.awaits() {
            let out = self.discard();
            self.told = Some(tr!("What was fitted is discarded: the look is as it was").to_owned());
            out
        } else {
            self.turn(false, session)
        }
    }

    /// Takes the results of threads, and requests what is missing.
    pub(crate) fn tick(&mut self, ui: &Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        if self.is_on && self.document != session.revisions().document {
            // Strokes are kept with their look, and painting on another look was not asked for.
            out.extend(self.turn(false, session));
        }
        let mut previews = session.sketchbook.preview().is_some() && out.is_empty();
        for done in self.fitter.answers() {
            if let Some(look) = self.take(done, session) {
                previews = true;
                out.push(preview(Some(look)));
            }
        }
        if self.running.as_ref().is_some_and(|running| running.of != of(session)) {
            self.give_up();
            self.told = Some(tr!("The look was changed while it was fitted: fit again").to_owned());
        }
        if self.running.as_ref().is_some_and(|running| !running.strokes.are(session)) {
            self.give_up();
            self.told =
                Some(tr!("The strokes were changed while they were fitted: fit again").to_owned());
        }
        if self.outcome.as_ref().is_some_and(|outcome| !outcome.strokes.are(session)) {
            let awaited = self.awaits();
            self.outcome = None;
            previews = false;
            out.push(preview(None));
            self.told = awaited.then(|| tr!("The strokes were changed: fit again").to_owned());
        }
        if self.awaits() && !previews {
            self.outcome = None;
            self.told = Some(
                tr!("The look was changed, and what was fitted to it before is gone: fit again")
                    .to_owned(),
            );
        }
        let applied = self.outcome.as_ref().and_then(|outcome| outcome.applied);
        if applied.is_some_and(|applied| applied != of(session)) {
            // The edit was undone or followed by another, so that the result no longer holds.
            self.outcome = None;
        }
        if !self.is_on {
            return out;
        }
        let moment = GroundInputs::new(session, self.size(session));
        let now = ui.input(|input| input.time);
        let was = self.seen.as_ref().filter(|(seen, _)| *seen == moment).map(|(_, since)| *since);
        let since = was.unwrap_or(now);
        self.seen = Some((moment.clone(), since));
        if now - since >= REST || self.grounds.latest().is_none() {
            self.grounds.update(session, &moment);
        } else {
            ui.ctx().request_repaint_after_secs((REST - (now - since)).max(0.01) as f32);
        }
        self.weigh(session);
        out
    }

    /// Size of the picture that is fitted at: that of the sketch, or one with the viewport's aspect
    /// ratio.
    fn size(&self, session: &Session) -> [u32; 2] {
        match session.sketchbook.sketch().tile() {
            Some(tile) => tile.size().map(|side| side / FINENESS),
            None => {
                let aspect = self.aspect.clamp(0.25, WIDEST);
                [(f64::from(self.height) * aspect).round() as u32, self.height]
            }
        }
    }

    /// Picture under the strokes, if it is that of what is shown now.
    fn ground(&self) -> Option<&Ground> {
        let is_it = self.grounds.moment() == self.seen.as_ref().map(|(seen, _)| seen);
        self.grounds.current().filter(|_| is_it)
    }

    /// Turns the strokes into goals anew, where the strokes or the ground have changed.
    fn weigh(&mut self, session: &Session) {
        let moment = self.grounds.moment();
        let (Some(tile), Some(ground), Some(moment)) =
            (session.sketchbook.sketch().tile(), self.grounds.latest(), moment)
        else {
            self.goals = None;
            return;
        };
        let is_known =
            self.goals.as_ref().is_some_and(|(of, at, _)| Arc::ptr_eq(of, tile) && at == moment);
        if !is_known {
            self.goals = Some((tile.clone(), moment.clone(), target::goals(tile, ground)));
        }
    }

    fn goals(&self) -> &[Painted] {
        self.goals.as_ref().map(|(.., goals)| goals.as_slice()).unwrap_or_default()
    }

    /// True if a result is neither applied nor discarded.
    fn awaits(&self) -> bool {
        self.outcome.as_ref().is_some_and(|outcome| outcome.applied.is_none())
    }

    /// True if the view is the one that the strokes belong to.
    fn is_at_view(session: &Session) -> bool {
        let sketch = session.sketchbook.sketch();
        sketch
            .standpoint()
            .is_none_or(|standpoint| standpoint.sees_as(&session.view.orbit, session.view.time))
    }

    /// Reason why painting or fitting is not possible now.
    fn obstacle(&self, session: &Session) -> Option<&'static str> {
        if session.view.wire.is_some() {
            Some(tr!("A wire is shown in place of the look: show the look first"))
        } else if !session.view.solo.is_empty() {
            Some(tr!("Layers or lights are shown alone or muted: show the whole look first"))
        } else if !Self::is_at_view(session) {
            Some(tr!("The strokes belong to another view: go back to it, or clear them"))
        } else if has_errors(session.compilation().problems()) || self.grounds.problem().is_some() {
            Some(tr!("The look cannot be drawn: Problems tells why"))
        } else if self.running.is_some() {
            Some(tr!("A fit is going on: stop it first"))
        } else if self.awaits() {
            Some(tr!("Apply or discard what was fitted first"))
        } else {
            None
        }
    }

    /// Removes all strokes.
    pub(crate) fn clear(&mut self, session: &Session) -> Vec<Command> {
        (self.going, self.waiting) = (None, None);
        if session.sketchbook.sketch().is_empty() {
            return Vec::new();
        }
        let from = Box::new(Standpoint::new(&session.view.orbit, session.view.time));
        let label = tr!("clear the strokes");
        vec![Command::Sketch(SketchCommand::Paint { label, from, tile: None })]
    }

    /// Selects a brush.
    pub(crate) fn take_brush(&mut self, brush: LightBrush) {
        self.tools.kind = brush;
    }

    /// Makes the brush larger or smaller.
    pub(crate) fn resize_brush(&mut self, is_larger: bool) {
        self.tools.resize(is_larger);
    }

    /// Rectangle of the sketch on the screen, for a viewport in `rect`: of the same height,
    /// centered.
    fn canvas(rect: Rect, size: [u32; 2]) -> Rect {
        let width = rect.height() * size[0] as f32 / size[1].max(1) as f32;
        Rect::from_center_size(rect.center(), egui::vec2(width, rect.height()))
    }

    /// Handles the pointer's painting over the picture in `rect`.
    pub(crate) fn interact(
        &mut self,
        ui: &Ui,
        response: &egui::Response,
        rect: Rect,
        session: &Session,
    ) -> Option<Command> {
        self.aspect = f64::from(rect.width() / rect.height().max(1.0));
        if !self.is_on {
            return None;
        }
        self.paint(ui, response, rect, session)
    }

    /// Shows the overlays of the picture in `rect`.
    pub(crate) fn over(
        &mut self,
        ui: &mut Ui,
        response: &egui::Response,
        rect: Rect,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        if self.is_on {
            self.show_over(ui, response, rect, session, out);
        }
    }
}

impl BackgroundJobs for FitTool {
    fn is_busy(&self) -> bool {
        self.grounds.is_busy() || self.fitter.is_busy()
    }

    fn wait(&self) {
        self.grounds.wait();
        self.fitter.wait();
    }
}

/// Command that shows a look in place of the open one, or the open one again.
fn preview(look: Option<Arc<Look>>) -> Command {
    Command::Sketch(SketchCommand::Preview(look))
}
