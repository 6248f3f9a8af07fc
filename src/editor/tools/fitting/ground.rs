//! Ground: the picture under the strokes, small and from the reference renderer, so that strokes
//! are compared with the same picture that the fit uses.
//!
//! A stroke of more light asks for a color, made from the visible one. So the look's picture is
//! drawn once for each look and view, on a thread, at the size of the fit; strokes read it between
//! its pixels.

use eframe::egui::ColorImage;

use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::frame::{CullMode, PlanOptions, Planner, Setup};
use crate::interp::Precision;
use crate::progress::{Interruption, Progress};
use crate::reference::{Modules, ReferenceOptions, execute};
use crate::state::session::Session;
use crate::state::snapshot::{CachedPlanner, RenderSnapshot, Stamp};
use crate::state::worker::Worker;

/// Inputs of a ground: for the same inputs the known ground is used.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct GroundInputs {
    stamp: Stamp,
    size: [u32; 2],
}

impl GroundInputs {
    pub(super) fn new(session: &Session, size: [u32; 2]) -> Self {
        Self { stamp: session.stamp(), size }
    }
}

/// The look's picture at a small size. Lists have one entry per pixel, rows from the top.
pub(super) struct Ground {
    pub(super) size: [u32; 2],
    /// Straight RGB as shown.
    pub(super) colors: Vec<[f64; 3]>,
    /// True for pixels that show an object with the open look.
    wears: Vec<bool>,
    /// True for pixels that show the open look and nothing else: at outlines a smooth picture has
    /// mixed colors.
    pub(super) counts: Vec<bool>,
    /// The ground as an image of the window.
    pub(super) image: ColorImage,
}

impl Ground {
    /// Color of the pixel at a place in pixels, and the share of its surroundings that show the
    /// look, 0 to 1. Colors are not interpolated: a stroke that keeps the picture as it is would
    /// otherwise ask for another picture.
    pub(super) fn at(&self, x: f64, y: f64) -> ([f64; 3], f64) {
        let [width, height] = self.size.map(|side| side as usize);
        let pixel = |at: f64, side: usize| (at.max(0.0) as usize).min(side - 1);
        let color = self.colors[pixel(y, height) * width + pixel(x, width)];
        let (x, y) = (x - 0.5, y - 0.5);
        let mut share = 0.0;
        for (down, weight_y) in [(0.0, 1.0 - (y - y.floor())), (1.0, y - y.floor())] {
            for (across, weight_x) in [(0.0, 1.0 - (x - x.floor())), (1.0, x - x.floor())] {
                let place =
                    pixel(y.floor() + down, height) * width + pixel(x.floor() + across, width);
                share += weight_x * weight_y * f64::from(u8::from(self.wears[place]));
            }
        }
        (color, share)
    }
}

#[cfg(test)]
impl Ground {
    /// Ground of one color, which shows the look everywhere.
    pub(super) fn flat(size: [u32; 2], color: [f64; 3]) -> Self {
        let count = (size[0] * size[1]) as usize;
        let image =
            ColorImage::filled(size.map(|side| side as usize), eframe::egui::Color32::BLACK);
        Self {
            size,
            colors: vec![color; count],
            wears: vec![true; count],
            counts: vec![true; count],
            image,
        }
    }
}

struct GroundRequest {
    moment: GroundInputs,
    snapshot: RenderSnapshot,
    progress: Progress,
}

struct GroundResult {
    moment: GroundInputs,
    result: Result<Ground, Vec<Diagnostic>>,
}

/// Thread that draws grounds, with the last one.
pub(super) struct Grounds {
    worker: Worker<GroundRequest, GroundResult>,
    asked: Option<GroundInputs>,
    progress: Progress,
    known: Option<GroundResult>,
}

impl Grounds {
    /// `wake` is called from another thread when a new ground is drawn.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let mut planner =
            CachedPlanner::new(|assets| Planner::new(assets).culling(CullMode::Objects));
        let draw = move |job: GroundRequest| GroundResult {
            result: draw(&mut planner, &job),
            moment: job.moment,
        };
        Self {
            worker: Worker::new("ground", wake, draw),
            asked: None,
            progress: Progress::new(),
            known: None,
        }
    }

    /// Takes a finished ground, and requests one for what is shown now.
    pub(super) fn update(&mut self, session: &Session, moment: &GroundInputs) {
        for done in self.worker.answers() {
            // The same ground may have been given up and requested again.
            let is_whole =
                done.result.as_ref().err().is_none_or(|problems| !Interruption::is_among(problems));
            if is_whole && self.asked.as_ref() == Some(&done.moment) {
                self.known = Some(done);
            }
        }
        if self.asked.as_ref() != Some(moment) {
            self.rest();
            self.progress = Progress::new();
            self.asked = Some(moment.clone());
            let job = GroundRequest {
                moment: moment.clone(),
                snapshot: session.snapshot(),
                progress: self.progress.clone(),
            };
            self.worker.request(|_| job);
        }
    }

    /// Gives up the ground that is being drawn, as it is not needed.
    pub(super) fn rest(&mut self) {
        self.progress.stop();
        if self.asked.as_ref() != self.known.as_ref().map(|known| &known.moment) {
            self.asked = None;
        }
    }

    /// Ground of what is shown now.
    pub(super) fn current(&self) -> Option<&Ground> {
        let known =
            self.known.as_ref().filter(|known| Some(&known.moment) == self.asked.as_ref())?;
        known.result.as_ref().ok()
    }

    /// Last ground, whatever its inputs.
    pub(super) fn latest(&self) -> Option<&Ground> {
        self.known.as_ref()?.result.as_ref().ok()
    }

    /// Reason why there is no ground.
    pub(super) fn problem(&self) -> Option<&Diagnostic> {
        let known =
            self.known.as_ref().filter(|known| Some(&known.moment) == self.asked.as_ref())?;
        known.result.as_ref().err()?.first()
    }

    /// Inputs of the last ground.
    pub(super) fn moment(&self) -> Option<&GroundInputs> {
        self.known.as_ref().map(|known| &known.moment)
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

impl Drop for Grounds {
    fn drop(&mut self) {
        self.rest();
    }
}

fn draw(planner: &mut CachedPlanner, job: &GroundRequest) -> Result<Ground, Vec<Diagnostic>> {
    let one = |problem| vec![problem];
    let GroundRequest { moment: GroundInputs { size, .. }, snapshot, progress } = job;
    let planner = planner.of(&snapshot.look, &snapshot.library);
    let setup = snapshot.setup(&mut planner.assets)?.value;
    let options = PlanOptions { size: *size, samples: 1, time: snapshot.time };
    let plan = planner.plan(&setup, &snapshot.library, &Live::Keyed, &options)?.value;
    let modules = Modules::new(&plan, Precision::F64).map_err(one)?;
    let picture = execute(&plan, &modules, &ReferenceOptions::default(), progress).map_err(one)?;
    let is_worn: Vec<bool> = plan.draws.iter().map(|draw| is_of_open_look(&setup, draw)).collect();
    let [width, height] = *size;
    let places = || (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let on_top = |x: u32, y: u32| picture.coverage(x, y).draw;
    let wears: Vec<bool> =
        places().map(|(x, y)| on_top(x, y).is_some_and(|draw| is_worn[draw as usize])).collect();
    let is_inner = |(x, y): (u32, u32)| {
        let around = |at: u32, side: u32| at.saturating_sub(1)..(at + 2).min(side);
        around(y, height).all(|v| around(x, width).all(|u| on_top(u, v) == on_top(x, y)))
    };
    let counts = places().zip(&wears).map(|(at, wears)| *wears && is_inner(at)).collect();
    let backdrop = plan.backdrop.unwrap_or_default();
    // Transparent parts of the look are laid over the backdrop, as in the viewport.
    let seen = |(x, y): (u32, u32)| -> [f64; 3] {
        let [r, g, b, a] = picture.straight(x, y);
        let rgb = [r, g, b];
        std::array::from_fn(|channel| {
            rgb[channel] * a + backdrop[channel] * backdrop[3] * (1.0 - a)
        })
    };
    let colors: Vec<[f64; 3]> = places().map(seen).collect();
    let bytes: Vec<u8> =
        colors.iter().flatten().map(|x| x.clamp(0.0, 1.0).mul_add(255.0, 0.5) as u8).collect();
    let image = ColorImage::from_rgb(size.map(|side| side as usize), &bytes);
    Ok(Ground { size: *size, colors, wears, counts, image })
}

/// True if a draw shows the open look, which is the first of the setup.
fn is_of_open_look(setup: &Setup, draw: &crate::frame::Draw) -> bool {
    let object = setup.objects.iter().find(|object| object.id == draw.object);
    object.is_some_and(|object| {
        let part = object.mesh.parts.iter().position(|part| part.indices == draw.indices);
        part.and_then(|part| object.looks.get(part)).is_some_and(|look| *look == Some(0))
    })
}
