//! Export of pictures from the window, on a thread of its own: a screenshot of any size, and the
//! look baked to the image of a ball (a LitSphere). Reference images are read by the same thread.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::ColorImage;
use glam::DVec3;

use crate::commands::PictureExport;
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::Projection;
use crate::files::{OutputKind, Outputs};
use crate::frame::{AssetStore, Assets, Executor, Picture, PlanOptions, Planner};
use crate::progress::Progress;
use crate::render::Gpu;
use crate::state::orbit::Orbit;
use crate::state::snapshot::RenderSnapshot;
use crate::state::worker::Worker;

/// Radius of a baked ball, as a part of the image's width: the default of a LitSphere node.
const BALL_RADIUS: f64 = 0.49;
/// Distance from the ball's rim, in pixels, within which colors are taken from this distance: the
/// rim itself is half backdrop.
const RIM: f64 = 1.25;
/// Largest side of a reference image as shown, in pixels.
const MOST_SHOWN: u32 = 4096;

/// Destination of a picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Destination {
    File(PathBuf),
    Clipboard,
}

enum PictureExportRequest {
    Draw { export: PictureExport, snapshot: Box<RenderSnapshot>, to: Destination },
    Read(PathBuf, AssetStore),
}

/// Result of a request.
pub(super) enum PictureExportResult {
    Saved(PathBuf),
    Copied(ColorImage),
    Read(PathBuf, ColorImage),
    Failed(Diagnostic),
}

/// Thread that exports pictures.
pub(super) struct Exports {
    worker: Worker<Vec<PictureExportRequest>, Vec<PictureExportResult>>,
}

impl Exports {
    /// `wake` is called from another thread when a request is done. Without a `gpu` no pictures are
    /// drawn.
    pub(super) fn new(gpu: Option<Gpu>, wake: impl Fn() + Send + 'static) -> Self {
        let mut drawer =
            gpu.map(|gpu| Drawer { executor: gpu.executor(), assets: Assets::default() });
        let work = async move |jobs: Vec<PictureExportRequest>| {
            let mut all = Vec::new();
            for job in jobs {
                let done = run(job, drawer.as_mut()).await;
                all.push(done.unwrap_or_else(PictureExportResult::Failed));
            }
            all
        };
        Self { worker: Worker::waiting("export", wake, work) }
    }

    /// Draws a picture, and saves or copies it.
    pub(super) fn draw(&self, export: PictureExport, snapshot: RenderSnapshot, to: Destination) {
        self.add(PictureExportRequest::Draw { export, snapshot: Box::new(snapshot), to });
    }

    /// Reads an image to be shown, with the assets that the window's pictures share.
    pub(super) fn read(&self, path: PathBuf, assets: AssetStore) {
        self.add(PictureExportRequest::Read(path, assets));
    }

    fn add(&self, job: PictureExportRequest) {
        // Requests that wait are kept, none is dropped.
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

async fn run(
    job: PictureExportRequest,
    drawer: Option<&mut Drawer>,
) -> Result<PictureExportResult, Diagnostic> {
    match job {
        PictureExportRequest::Read(path, assets) => {
            let image = Assets::of(&assets).image(Path::new(""), &path.display().to_string())?;
            Ok(PictureExportResult::Read(path, shown(image.size, &image.rgba())))
        }
        PictureExportRequest::Draw { export, snapshot, to } => {
            let drawer = drawer.ok_or_else(|| {
                Diagnostic::error("no-gpu", tr!("there is no GPU to draw with"))
                    .hint(tr!("`chiaro render --on reference` needs none"))
            })?;
            // Saved and copied pictures are as the window shows them; a baked ball is no picture.
            let display = snapshot.display.clone();
            let display = display.filter(|_| matches!(export, PictureExport::Picture(_)));
            let picture = drawer.draw(export, *snapshot).await?;
            let picture = display.map_or_else(|| picture.clone(), |display| display.show(&picture));
            match to {
                Destination::File(path) => {
                    // Overwriting was confirmed in the dialog; but the picture must not replace a
                    // file that it is made from.
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

/// Image as the window shows it: of a large one every second, third... pixel.
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
    executor: Box<dyn Executor + Send>,
    assets: Assets,
}

impl Drawer {
    async fn draw(
        &mut self,
        export: PictureExport,
        mut snapshot: RenderSnapshot,
    ) -> Result<Picture, Diagnostic> {
        let size = match export {
            PictureExport::Picture(size) => size,
            PictureExport::LitSphere(side) => {
                snapshot.orbit = before_a_ball(&snapshot.orbit);
                snapshot.scene = None;
                [side; 2]
            }
        };
        let mut planner = Planner::new(std::mem::take(&mut self.assets));
        let drawn = self.try_draw(&mut planner, &snapshot, export, size).await;
        self.assets = planner.assets;
        // The list of problems shows all of them; one is enough for the reason here.
        let picture = drawn.map_err(|mut problems| {
            if problems.is_empty() {
                Diagnostic::error("no-picture", tr!("nothing was drawn"))
            } else {
                problems.remove(0)
            }
        })?;
        Ok(if matches!(export, PictureExport::LitSphere(_)) { filled(picture) } else { picture })
    }

    async fn try_draw(
        &mut self,
        planner: &mut Planner,
        snapshot: &RenderSnapshot,
        export: PictureExport,
        size: [u32; 2],
    ) -> Result<Picture, Vec<Diagnostic>> {
        let mut setup = snapshot.setup(&mut planner.assets)?.value;
        if matches!(export, PictureExport::LitSphere(_)) {
            setup.scene.backdrop = None;
        }
        let options = PlanOptions { size, samples: 4, time: snapshot.time };
        let plan = planner.plan(&setup, &snapshot.library, &Live::Keyed, &options)?.value;
        self.executor.picture(&plan, &Progress::new()).await.map_err(|problem| vec![problem])
    }
}

/// View with the same lights and direction, on a ball that fills the picture.
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

/// Picture of a ball with the colors of its rim continued outward, so that no filter mixes in the
/// backdrop.
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
        // The color is interpolated between four pixels, all of them within the rim.
        let (x, y) = (center + dx / distance * radius - 0.5, center + dy / distance * radius - 0.5);
        let (s, t) = ((x - x.floor()) as f32, (y - y.floor()) as f32);
        let mix =
            |a: [f32; 4], b: [f32; 4], t: f32| std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t);
        let row = |y: f64| mix(texel(x.floor(), y), texel(x.floor() + 1.0, y), s);
        *pixel = mix(row(y.floor()), row(y.floor() + 1.0), t);
    }
    picture
}
