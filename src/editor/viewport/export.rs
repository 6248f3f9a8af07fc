//! Pictures that leave the window, made on a thread of their own: a screenshot of any size, and the
//! look baked to the image of a ball (a LitSphere). Reference images come in the same way.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eframe::egui::ColorImage;
use glam::DVec3;

use crate::commands::PictureExport;
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::Projection;
use crate::files::{OutputKind, Outputs};
use crate::frame::{Assets, Picture, PlanOptions, Planner};
use crate::render::{Gpu, Renderer, block_on};
use crate::state::orbit::Orbit;
use crate::state::snapshot::RenderSnapshot;
use crate::state::worker::Worker;

/// A baked ball's radius over the image's width: what a LitSphere node takes where nothing else is
/// said.
const BALL_RADIUS: f64 = 0.49;
/// What is nearer to the ball's rim than this, in pixels, takes the color from here: the rim
/// itself is half backdrop.
const RIM: f64 = 1.25;
/// Reference images are shown with at most so many pixels along a side.
const MOST_SHOWN: u32 = 4096;

/// Where it goes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Destination {
    File(PathBuf),
    Clipboard,
}

enum PictureExportRequest {
    Draw { export: PictureExport, still: Box<RenderSnapshot>, to: Destination },
    Read(PathBuf),
}

/// What became of a job.
pub(super) enum PictureExportResult {
    Saved(PathBuf),
    Copied(ColorImage),
    Read(PathBuf, ColorImage),
    Failed(Diagnostic),
}

/// The thread that does it.
pub(super) struct Exports {
    worker: Worker<Vec<PictureExportRequest>, Vec<PictureExportResult>>,
}

impl Exports {
    /// `wake` is called from another thread when something is done. Without a `gpu` nothing is
    /// drawn.
    pub(super) fn new(gpu: Option<Gpu>, wake: impl Fn() + Send + 'static) -> Self {
        let mut drawer =
            gpu.map(|gpu| Drawer { renderer: Renderer::new(gpu), assets: Assets::default() });
        let work = move |jobs: Vec<PictureExportRequest>| {
            let done = jobs.into_iter().map(|job| run(job, drawer.as_mut()));
            done.map(|done| done.unwrap_or_else(PictureExportResult::Failed)).collect()
        };
        Self { worker: Worker::new("export", wake, work) }
    }

    /// Draws and saves or copies.
    pub(super) fn draw(&self, export: PictureExport, still: RenderSnapshot, to: Destination) {
        self.add(PictureExportRequest::Draw { export, still: Box::new(still), to });
    }

    /// Reads an image to be shown.
    pub(super) fn read(&self, path: PathBuf) {
        self.add(PictureExportRequest::Read(path));
    }

    fn add(&self, job: PictureExportRequest) {
        // Nothing that waits is dropped.
        self.worker
            .request(|waiting| waiting.unwrap_or_default().into_iter().chain([job]).collect());
    }

    pub(super) fn answers(&self) -> impl Iterator<Item = PictureExportResult> + use<> {
        self.worker.answers().into_iter().flatten()
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

fn run(
    job: PictureExportRequest,
    drawer: Option<&mut Drawer>,
) -> Result<PictureExportResult, Diagnostic> {
    match job {
        PictureExportRequest::Read(path) => {
            let image = Assets::default().image(Path::new(""), &path.display().to_string())?;
            Ok(PictureExportResult::Read(path, shown(image.size, &image.rgba())))
        }
        PictureExportRequest::Draw { export, still, to } => {
            let drawer = drawer.ok_or_else(|| {
                Diagnostic::error("no-gpu", "there is no GPU to draw with")
                    .hint("`chiaro render --on reference` needs none")
            })?;
            let picture = drawer.draw(export, *still)?;
            match to {
                Destination::File(path) => {
                    // The dialog has asked about what is there; but the picture must not take what
                    // it is made of.
                    let mut outputs = Outputs::new(true);
                    drawer.assets.files().for_each(|path| outputs.reads(path));
                    outputs.write(&path, OutputKind::PICTURE, &picture.to_png()?)?;
                    Ok(PictureExportResult::Saved(path))
                }
                Destination::Clipboard => {
                    let size = picture.size.map(|side| side as usize);
                    Ok(PictureExportResult::Copied(ColorImage::from_rgba_unmultiplied(
                        size,
                        &picture.to_rgba8(),
                    )))
                }
            }
        }
    }
}

/// An image as the window shows it: of a large one every second, third... pixel.
fn shown(size: [u32; 2], rgba: &[u8]) -> ColorImage {
    let step = size[0].max(size[1]).div_ceil(MOST_SHOWN).max(1);
    let small = size.map(|side| side.div_ceil(step));
    let pixel = |x: u32, y: u32| {
        let at = 4 * (y * step * size[0] + x * step) as usize;
        rgba[at..at + 4].iter().copied()
    };
    let pixels: Vec<u8> =
        (0..small[1]).flat_map(|y| (0..small[0]).flat_map(move |x| pixel(x, y))).collect();
    ColorImage::from_rgba_unmultiplied(small.map(|side| side as usize), &pixels)
}

struct Drawer {
    renderer: Renderer,
    assets: Assets,
}

impl Drawer {
    fn draw(
        &mut self,
        export: PictureExport,
        mut still: RenderSnapshot,
    ) -> Result<Picture, Diagnostic> {
        let size = match export {
            PictureExport::Picture(size) => size,
            PictureExport::LitSphere(side) => {
                still.orbit = before_a_ball(&still.orbit);
                still.stage = None;
                [side; 2]
            }
        };
        let mut planner = Planner::new(std::mem::take(&mut self.assets));
        let drawn = self.try_draw(&mut planner, &still, export, size);
        self.assets = planner.assets;
        // The list of problems tells all of them; one is enough to say why.
        let picture = drawn.map_err(|mut problems| {
            if problems.is_empty() {
                Diagnostic::error("no-picture", "nothing was drawn")
            } else {
                problems.remove(0)
            }
        })?;
        Ok(if matches!(export, PictureExport::LitSphere(_)) { filled(picture) } else { picture })
    }

    fn try_draw(
        &mut self,
        planner: &mut Planner,
        still: &RenderSnapshot,
        export: PictureExport,
        size: [u32; 2],
    ) -> Result<Picture, Vec<Diagnostic>> {
        let (mut setup, _) = still.setup(&mut planner.assets)?;
        if matches!(export, PictureExport::LitSphere(_)) {
            setup.scene.backdrop = None;
        }
        let options = PlanOptions { size, samples: 4, time: still.time };
        let plan = planner.plan(&setup, &still.library, &Live::Keyed, &options)?;
        block_on(self.renderer.picture(&plan)).map_err(|error| vec![error.into()])
    }
}

/// The same lights and direction of view, on a ball that fills the picture.
fn before_a_ball(orbit: &Orbit) -> Orbit {
    let distance = orbit.distance.max(2.0);
    let height = 1.0 / BALL_RADIUS;
    Orbit {
        mesh: "shape:sphere".to_owned(),
        z_is_up: false,
        target: DVec3::ZERO,
        distance,
        fov: 2.0 * (0.5 * height / distance).atan(),
        placed_for: 0.0,
        projection: Projection::Orthographic,
        backdrop: None,
        ..orbit.clone()
    }
}

/// A ball's picture with the colors of its rim all around, so that no filter mixes in what is
/// outside.
fn filled(mut picture: Picture) -> Picture {
    let size = f64::from(picture.size[0]);
    let (center, radius) = (0.5 * size, BALL_RADIUS * size - RIM);
    let source = Arc::new(picture.rgba.clone());
    let texel = |x: f64, y: f64| {
        let [x, y] = [x, y].map(|at| at.clamp(0.0, size - 1.0) as usize);
        source[y * picture.size[0] as usize + x]
    };
    for (index, pixel) in picture.rgba.iter_mut().enumerate() {
        let [x, y] = [index as u32 % picture.size[0], index as u32 / picture.size[0]]
            .map(|at| f64::from(at) + 0.5);
        let (dx, dy) = (x - center, y - center);
        let distance = dx.hypot(dy);
        if distance <= radius {
            continue;
        }
        // Between four pixels, all of them within the rim.
        let (x, y) = (center + dx / distance * radius - 0.5, center + dy / distance * radius - 0.5);
        let (s, t) = ((x - x.floor()) as f32, (y - y.floor()) as f32);
        let mix =
            |a: [f32; 4], b: [f32; 4], t: f32| std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t);
        let row = |y: f64| mix(texel(x.floor(), y), texel(x.floor() + 1.0, y), s);
        *pixel = mix(row(y.floor()), row(y.floor() + 1.0), t);
    }
    picture
}
