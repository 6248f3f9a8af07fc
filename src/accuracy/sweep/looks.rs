//! Whole looks against their truth: over the sphere of lights and views, from one pixel up, near and far.

use std::path::{Path, PathBuf};

use glam::DVec3;
use serde::Serialize;

use crate::accuracy::station::stations;
use crate::accuracy::{ErrorFigures, Progress, Stopped, truth::Truth};
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::frame::{Assets, PlanOptions, Planner, Setup, open};
use crate::library::Library;
use crate::render::Renderer;

/// What looks are worn by.
pub const MESHES: [&str; 3] = ["shape:sphere", "shape:creature", "shape:plane"];
/// How far the camera is from where it was: near, as it was, and far.
pub const DISTANCES: [f64; 3] = [0.45, 1.0, 20.0];

/// So many pixels beside an edge or the picture's border, what is drawn still depends on what is on the other side: derivatives reach one pixel,
/// the curvature's stencil two.
pub const EDGE_REACH: usize = 2;

/// Inside of what is drawn, no channel of any pixel of an exact look is farther from the truth.
pub const INTERIOR: f64 = 6e-2;
/// No more of its pixels than this share are farther than 1/255.
pub const VISIBLE_SHARE: f64 = 2e-3;

/// Which pictures of a look are compared.
#[derive(Clone, Debug, PartialEq)]
pub struct LookEffort {
    /// Views with their lights.
    pub stations: usize,
    /// Sides of the pictures, in pixels; stations take turns with them, but the first station has all.
    pub sides: Vec<u32>,
}

impl LookEffort {
    /// A second a look.
    pub fn quick() -> Self {
        Self { stations: 4, sides: vec![1, 2, 7, 48] }
    }

    /// Ten seconds a look.
    pub fn full() -> Self {
        Self { stations: 12, sides: vec![1, 2, 3, 16, 61, 160] }
    }

    /// Minutes a look.
    pub fn soak() -> Self {
        Self { stations: 64, sides: vec![1, 2, 3, 5, 16, 61, 128, 333, 1024, 4096] }
    }
}

/// What a look came to.
#[derive(Clone, Debug, Serialize)]
pub struct LookMeasured {
    /// The file's stem.
    pub look: String,
    /// How many pictures were compared.
    pub pictures: usize,
    /// All pictures together.
    pub error: ErrorFigures,
    /// The worst picture in words.
    pub worst_words: String,
    /// What the largest error is held to.
    pub bound: f64,
}

impl LookMeasured {
    /// Whether it keeps what it is held to.
    pub fn holds(&self) -> bool {
        let is_seldom = self.error.visible as f64 <= VISIBLE_SHARE * self.error.pixels as f64;
        self.error.broken == 0 && self.error.max <= self.bound && is_seldom
    }
}

/// The looks of a folder, sorted.
///
/// # Errors
/// A folder that cannot be read.
pub fn looks_in(folder: &Path) -> Result<Vec<PathBuf>, Vec<Diagnostic>> {
    let told = |error: std::io::Error| vec![Diagnostic::error("unreadable", format!("{}: {error}", folder.display()))];
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).map_err(told)?.flatten().map(|entry| entry.path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    files.sort();
    Ok(files)
}

/// Compares a look's pictures with the truth. `precise` draws [precisely](crate::render::Gpu::precise).
///
/// # Errors
/// What is wrong with the look, what the GPU refuses, or that `progress` stopped it.
pub fn measure_look(
    path: &Path,
    library: &Library,
    precise: &mut Renderer,
    effort: &LookEffort,
    progress: &mut Progress<'_>,
) -> Result<LookMeasured, Stopped> {
    let mut assets = Assets::default();
    let mut figures = Vec::new();
    let mut worst = (0.0, String::new());
    for mesh in MESHES {
        let (setup, _) = open(path, Some(mesh), &mut assets)?;
        let (mut planner, mut truths) = (Planner::default(), Planner::for_truth(Assets::default()));
        for (index, station) in stations(&setup, effort.stations).iter().enumerate() {
            let sides = if index == 0 { effort.sides.clone() } else { vec![effort.sides[index % effort.sides.len()]] };
            let distance = DISTANCES[index % DISTANCES.len()];
            let seen = at_distance(station.of(&setup), distance);
            for side in sides {
                let options = PlanOptions { size: [side; 2], samples: 1, time: station.time };
                let truth = Truth::of(&seen, library, &mut truths, &options, progress)?;
                let plan = planner.plan(&seen, library, &Live::Keyed, &options)?;
                let error = truth.compare_beside(precise, &plan, &truth.near_edges(EDGE_REACH))?;
                if error.max > worst.0 {
                    let [x, y] = error.worst;
                    let name = mesh.trim_start_matches("shape:");
                    let words = format!("{name}, {side} px, station {index}, distance {distance}, pixel {x},{y}");
                    worst = (error.max, words);
                }
                figures.push(error);
            }
        }
    }
    let look = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let error = ErrorFigures::join(&figures);
    Ok(LookMeasured { look, pictures: figures.len(), error, worst_words: worst.1, bound: INTERIOR })
}

/// The same from so many times as far.
fn at_distance(mut setup: Setup, times: f64) -> Setup {
    let camera = &mut setup.scene.camera;
    let target = DVec3::from(camera.target);
    camera.eye = (target + times * (DVec3::from(camera.eye) - target)).to_array();
    camera.height *= times;
    setup
}
