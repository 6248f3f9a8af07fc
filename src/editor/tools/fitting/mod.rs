//! Painted shading in the window (Okabe et al. 2007): paint on the picture where it should be
//! lighter, darker or of a color, and the look's lights, profiles and colors are fitted to the
//! strokes.
//!
//! `sketch` holds what was painted, and `session` holds that, so that undo knows it. `ground` is
//! what the look shows under the strokes; `hand` paints, `target` makes wishes of it, `work` fits
//! on a thread. What comes of that is shown as a preview of the session, which is no edit until it
//! is applied, as one step.

mod bar;
mod cover;
mod fit;
mod ground;
mod hand;
mod overlay;
mod panel;
mod target;
mod tools;
mod veil;
mod work;

use std::sync::Arc;

use eframe::egui::{self, Rect, Ui};

use crate::commands::{Command, LightBrush, SketchCommand};
use crate::diag::has_errors;
use crate::document::{Look, Tile};
use crate::fit::{Keep, Wish as Painted};
use crate::state::revision::DocumentNumber;
use crate::state::session::Session;
pub(crate) use crate::state::sketch::Standpoint;
use crate::state::worker::{BackgroundJobs, Worker};
use crate::tools::{PictureContext, SwitchPlace, ToolRow};
use fit::{Outcome, Running, of};
use ground::{Ground, GroundInputs, Grounds};
use hand::{LightStroke, WaitingStroke};
use overlay::Textures;
use target::FINENESS;
use tools::Tools;
use work::{FitRequest, FitResult};

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Bar,
    |tools| tools.fitting.is_on(),
    |tools, ui, out| tools.fitting.toggle(ui, out),
)
.with_pointer(|tools| tools.fitting.hint())
.with_bar(|tools, ui, _| tools.fitting.bar(ui))
.with_interaction(|tools, ui, PictureContext { session, response, rect, .. }| {
    tools.fitting.interact(ui, response, *rect, session)
})
.with_overlay(|tools, ui, PictureContext { session, response, rect, .. }, out| {
    tools.fitting.over(ui, response, *rect, session, out);
});

/// The height of the picture that is fitted at, in pixels: what is painted is broad, and a fit
/// looks at some hundred pixels only.
const HEIGHT: u32 = 128;
/// The widest such picture, in parts of its height.
const WIDEST: f64 = 2.0;
/// Fewer painted pixels than this tell nothing of lights.
const LEAST_PAINTED: usize = 12;
/// From how many beginnings a look is turned: lights that are far off are found by some of them.
const STARTS: usize = 10;
/// A hand is not so exact that more would be worth the time: RMS of a channel, from 0 to 1.
const ENOUGH: f64 = 1.0 / 255.0;
/// The view rests for so many seconds before the ground is drawn anew.
const REST: f64 = 0.15;

/// How to fit.
#[derive(Clone, Copy, Debug)]
struct FitSettings {
    keep: Keep,
    /// How far what is not painted stays as it is, from 0 to 1.
    keep_rest: f64,
    /// The most layers of a fit from nothing.
    layers: usize,
    /// From how many beginnings a look is turned.
    starts: usize,
}

/// What is seen over the picture.
#[derive(Clone, Copy, Debug)]
struct OverlaySettings {
    strokes: bool,
    misses: bool,
}

/// Painted light: the brush, the fit that is going on, and what came of the last one.
pub struct Fitting {
    is_on: bool,
    /// Of the picture that is fitted at, in pixels.
    height: u32,
    /// How wide the viewport is, in parts of its height.
    aspect: f64,
    tools: Tools,
    how: FitSettings,
    shows: OverlaySettings,
    grounds: Grounds,
    /// What was seen last, and when, in seconds of the window's clock.
    seen: Option<(GroundInputs, f64)>,
    going: Option<LightStroke>,
    /// A stroke that waits until the picture under it is read.
    waiting: Option<WaitingStroke>,
    /// The document that is painted on: no other is.
    document: DocumentNumber,
    wishes: Option<(Arc<Tile>, GroundInputs, Vec<Painted>)>,
    fitter: Worker<FitRequest, FitResult>,
    running: Option<Running>,
    outcome: Option<Outcome>,
    /// What there is to be said of the last fit, or why there was none.
    told: Option<String>,
    textures: Textures,
    hint: &'static str,
    wake: Arc<dyn Fn() + Send + Sync>,
}

impl Fitting {
    /// Nothing is painted yet. `wake` is called from another thread when there is news.
    pub(crate) fn new(wake: impl Fn() + Clone + Send + Sync + 'static) -> Self {
        Self {
            is_on: false,
            height: HEIGHT,
            aspect: 1.0,
            tools: Tools::default(),
            how: FitSettings { keep: Keep::default(), keep_rest: 0.5, layers: 2, starts: STARTS },
            shows: OverlaySettings { strokes: true, misses: false },
            grounds: Grounds::new(wake.clone()),
            seen: None,
            going: None,
            waiting: None,
            document: DocumentNumber::default(),
            wishes: None,
            fitter: work::start(wake.clone()),
            running: None,
            outcome: None,
            told: None,
            textures: Textures::default(),
            hint: "",
            wake: Arc::new(wake),
        }
    }

    /// Whether the pointer paints on the picture.
    pub fn is_on(&self) -> bool {
        self.is_on
    }

    /// Whether something is fitted at this moment.
    pub fn is_fitting(&self) -> bool {
        self.running.is_some()
    }

    /// How many pixels of the object are painted, at the size that is fitted at.
    pub fn painted(&self) -> usize {
        self.wishes.as_ref().map_or(0, |(.., wishes)| wishes.len())
    }

    /// How far the picture was off what is painted before the last fit, and how far it is after it:
    /// RMS of a channel, from 0 to 1.
    pub fn errors(&self) -> Option<[f64; 2]> {
        self.outcome.as_ref().map(|outcome| [outcome.report.before, outcome.report.after])
    }

    /// What there is to be said, or why nothing could be fitted.
    pub fn told(&self) -> Option<&str> {
        self.told.as_deref()
    }

    /// Fits at pictures of another height, in pixels, and from another number of beginnings; for
    /// programs that drive the window.
    pub fn set_effort(&mut self, height: u32, starts: usize) {
        self.height = height.clamp(16, 512);
        self.how.starts = starts.max(1);
    }

    /// Lays up to so many layers from nothing; for programs that drive the window.
    pub fn set_layers(&mut self, layers: usize) {
        self.how.layers = layers.clamp(1, panel::MOST_LAYERS);
    }

    /// What may be done at the pointer; empty while nothing is painted on.
    pub(crate) fn hint(&self) -> &str {
        if self.is_on { self.hint } else { "" }
    }

    /// Waits for what is under the strokes, and not for a fit.
    pub fn wait_for_ground(&self) {
        self.grounds.wait();
    }

    /// Begins or ends painting. The strokes stay.
    pub(crate) fn turn(&mut self, on: bool, session: &Session) -> Vec<Command> {
        self.is_on = on;
        self.document = session.document_number();
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

    /// Gives up the nearest thing that is going on: a stroke, a fit, what was fitted, the painting.
    pub(crate) fn leave(&mut self, session: &Session) -> Vec<Command> {
        if self.going.take().is_some() || self.waiting.take().is_some() {
            return Vec::new();
        }
        if self.running.is_some() {
            self.stop();
            Vec::new()
        } else if self.awaits() {
            let out = self.discard();
            self.told = Some("What was fitted is discarded: the look is as it was".to_owned());
            out
        } else {
            self.turn(false, session)
        }
    }

    /// Takes what was done on threads, and asks for what is missing.
    pub(crate) fn tick(&mut self, ui: &Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        if self.is_on && self.document != session.document_number() {
            // Strokes went aside with their look, and nobody asked to paint on another.
            out.extend(self.turn(false, session));
        }
        let mut previews = session.preview().is_some() && out.is_empty();
        for done in self.fitter.answers() {
            if let Some(look) = self.take(done, session) {
                previews = true;
                out.push(preview(Some(look)));
            }
        }
        if self.running.as_ref().is_some_and(|running| running.of != of(session)) {
            self.give_up();
            self.told = Some("The look was changed while it was fitted: fit again".to_owned());
        }
        if self.running.as_ref().is_some_and(|running| !running.strokes.are(session)) {
            self.give_up();
            self.told =
                Some("The strokes were changed while they were fitted: fit again".to_owned());
        }
        if self.outcome.as_ref().is_some_and(|outcome| !outcome.strokes.are(session)) {
            let awaited = self.awaits();
            self.outcome = None;
            previews = false;
            out.push(preview(None));
            self.told = awaited.then(|| "The strokes were changed: fit again".to_owned());
        }
        if self.awaits() && !previews {
            self.outcome = None;
            self.told = Some(
                "The look was changed, and what was fitted to it before is gone: fit again"
                    .to_owned(),
            );
        }
        let applied = self.outcome.as_ref().and_then(|outcome| outcome.applied);
        if applied.is_some_and(|applied| applied != of(session)) {
            // It was undone or gone on from, and what is told of it holds no more.
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

    /// The picture that is fitted at: that of the sketch, or as the viewport is.
    fn size(&self, session: &Session) -> [u32; 2] {
        match session.sketch().tile() {
            Some(tile) => tile.size().map(|side| side / FINENESS),
            None => {
                let aspect = self.aspect.clamp(0.25, WIDEST);
                [(f64::from(self.height) * aspect).round() as u32, self.height]
            }
        }
    }

    /// What is under the strokes, if it is what is seen now.
    fn ground(&self) -> Option<&Ground> {
        let is_it = self.grounds.moment() == self.seen.as_ref().map(|(seen, _)| seen);
        self.grounds.current().filter(|_| is_it)
    }

    /// Makes wishes of the strokes, where either is another.
    fn weigh(&mut self, session: &Session) {
        let moment = self.grounds.moment();
        let (Some(tile), Some(ground), Some(moment)) =
            (session.sketch().tile(), self.grounds.latest(), moment)
        else {
            self.wishes = None;
            return;
        };
        let is_known =
            self.wishes.as_ref().is_some_and(|(of, at, _)| Arc::ptr_eq(of, tile) && at == moment);
        if !is_known {
            self.wishes = Some((tile.clone(), moment.clone(), target::wishes(tile, ground)));
        }
    }

    fn wishes(&self) -> &[Painted] {
        self.wishes.as_ref().map(|(.., wishes)| wishes.as_slice()).unwrap_or_default()
    }

    /// Whether something was fitted that is neither applied nor discarded.
    fn awaits(&self) -> bool {
        self.outcome.as_ref().is_some_and(|outcome| outcome.applied.is_none())
    }

    /// Whether the view is the one that the strokes belong to.
    fn is_at_view(session: &Session) -> bool {
        let sketch = session.sketch();
        sketch
            .standpoint()
            .is_none_or(|standpoint| standpoint.sees_as(&session.view.orbit, session.view.time))
    }

    /// Why nothing can be painted or fitted now.
    fn obstacle(&self, session: &Session) -> Option<&'static str> {
        if session.wire().is_some() {
            Some("A wire is shown in place of the look: show the look first")
        } else if !session.solo().is_empty() {
            Some("Layers or lights are shown alone or muted: show the whole look first")
        } else if !Self::is_at_view(session) {
            Some("The strokes belong to another view: go back to it, or clear them")
        } else if has_errors(session.problems()) || self.grounds.problem().is_some() {
            Some("The look cannot be drawn: Problems tells why")
        } else if self.running.is_some() {
            Some("A fit is going on: stop it first")
        } else if self.awaits() {
            Some("Apply or discard what was fitted first")
        } else {
            None
        }
    }

    /// Takes all strokes away.
    pub(crate) fn clear(&mut self, session: &Session) -> Vec<Command> {
        (self.going, self.waiting) = (None, None);
        if session.sketch().is_empty() {
            return Vec::new();
        }
        let from = Standpoint::new(&session.view.orbit, session.view.time);
        let label = "clear the strokes";
        vec![Command::Sketch(SketchCommand::Paint { label, from, tile: None })]
    }

    /// Takes a brush in hand.
    pub(crate) fn take_brush(&mut self, brush: LightBrush) {
        self.tools.kind = brush;
    }

    /// Makes the brush larger or smaller.
    pub(crate) fn resize_brush(&mut self, is_larger: bool) {
        self.tools.resize(is_larger);
    }

    /// Where the sketch lies on the screen, of a viewport in `rect`: as high, in the middle.
    fn canvas(rect: Rect, size: [u32; 2]) -> Rect {
        let width = rect.height() * size[0] as f32 / size[1].max(1) as f32;
        Rect::from_center_size(rect.center(), egui::vec2(width, rect.height()))
    }

    /// Takes in what the pointer paints over the picture in `rect`.
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

    /// Shows what is over the picture in `rect`.
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

impl BackgroundJobs for Fitting {
    fn is_busy(&self) -> bool {
        self.grounds.is_busy() || self.fitter.is_busy()
    }

    fn wait(&self) {
        self.grounds.wait();
        self.fitter.wait();
    }
}

/// Shows a look in place of the open one, or the open one again.
fn preview(look: Option<Arc<Look>>) -> Command {
    Command::Sketch(SketchCommand::Preview(look))
}
