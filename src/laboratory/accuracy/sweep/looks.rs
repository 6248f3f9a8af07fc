//! Whole looks against their truth: over the sphere of lights and views, from one pixel up, near
//! and far.

use std::path::{Path, PathBuf};

use glam::DVec3;
use serde::Serialize;

use crate::accuracy::error::VISIBLE;
use crate::accuracy::viewpoint::viewpoints;
use crate::accuracy::{Colors, ErrorFigures, MeasureError, Variant, truth::Truth};
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::{Look, Tier};
use crate::frame::{Assets, PlanOptions, Planner, Setup, open};
use crate::library::Library;
use crate::progress::Progress;
use crate::render::Renderer;

/// What looks are worn by.
pub const MESHES: [&str; 3] = ["shape:sphere", "shape:creature", "shape:plane"];
/// How far the camera is from where it was: near, as it was, and far.
pub const DISTANCES: [f64; 3] = [0.45, 1.0, 20.0];

/// What whole looks are held to in a tier.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LookBound {
    /// The largest difference of a channel away from edges; none where a tier is held by its mean
    /// alone.
    pub max: Option<f64>,
    /// The root of the mean square there.
    pub rms: f64,
    /// Which share of the pixels at edges may be off by more than 1/255; any where a tier is held
    /// by its mean alone.
    pub edge_share: Option<f64>,
}

impl LookBound {
    /// That of a tier.
    ///
    /// - *exact* errs by f32's rounding. A normal is off by a few 1e-7, which curvature multiplies:
    ///   it divides differences of normals by some pixels and gives them per height of the picture,
    ///   which makes up to 270 of it (from 800 pixels on), and warps and cartoon edges are steep
    ///   beside. That comes to 1e-3 of single pixels, and 1e-6 as a mean.
    /// - *balanced* is what nobody sees, by its definition.
    /// - *fast* may leave out the curvature pass, and take curvature from each triangle's own
    ///   normals: constant over it, 0 on one that is flat, and a warp by another curvature is
    ///   another picture there.
    pub const fn of(tier: Tier) -> Self {
        match tier {
            Tier::Exact => Self { max: Some(VISIBLE), rms: 1e-5, edge_share: Some(EDGE_SHARE) },
            Tier::Balanced => Self { max: Some(VISIBLE), rms: 1e-4, edge_share: Some(EDGE_SHARE) },
            Tier::Fast => Self { max: None, rms: 0.1, edge_share: None },
        }
    }

    /// The same in pictures of so many pixels a side: the cover of a pattern's edge is off by as
    /// much as its [place](place_rounding), and one pixel in a hundred lies on such an edge.
    pub fn at(self, side: u32) -> Self {
        Self { rms: self.rms.max(0.1 * place_rounding(side)), ..self }
    }

    /// That of a look in a tier. Where one of its nodes states that more than eight bits show is
    /// off (a threshold's edges, a curvature that is wired on), what comes after may turn all of a
    /// pixel by that, and the look is held by its mean.
    pub fn of_look(look: &Look, library: &Library, tier: Tier) -> Self {
        let inner = look.definitions.values().map(|definition| &definition.graph);
        let nodes =
            std::iter::once(&look.graph).chain(inner).flat_map(|graph| graph.nodes.values());
        let errors =
            nodes.filter_map(|node| library.nodes.get(&node.kind)).flat_map(|def| &def.errors);
        let stated =
            errors.filter(|error| error.tier == tier).map(|error| error.bound).fold(0.0, f64::max);
        match tier {
            Tier::Balanced if stated > VISIBLE => Self { max: None, rms: 0.05, edge_share: None },
            _ => Self::of(tier),
        }
    }
}

/// By how much f32 rounds a place in a picture of so many pixels a side, in pixels: 2^-24 of the
/// picture.
pub fn place_rounding(side: u32) -> f64 {
    f64::from(side) * 2f64.powi(-24)
}

/// Of the pixels at edges, this share of a look may be off by more than 1/255. f32 leaves a vertex
/// about 1e-7 of the picture's side beside where it is, and one that lies that near to the middle
/// between two steps of the grid is rounded to the other: at 4096 pixels every tenth. A step then
/// gives or takes one in 256 of the pixels along the outline, and the curvature's stencil hands
/// that on to the seven around it: 1e-3 together. In small pictures of meshes that are mirrored,
/// vertices lie just on such a middle, and fewer pixels count.
pub const EDGE_SHARE: f64 = 2e-3;

/// Of the largest pictures so many rows are compared, a million pixels: a truth of all of them
/// takes a minute.
pub const LARGE_ROWS: u32 = 256;

/// This share of the pixels inside may be off by up to four times as much.
pub const RARE_INSIDE: f64 = 1e-5;

/// Which pictures of a look are compared.
#[derive(Clone, Debug, PartialEq)]
pub struct LookEffort {
    /// What wears it.
    pub meshes: Vec<&'static str>,
    /// In which tiers.
    pub tiers: Vec<Tier>,
    /// Views with their lights.
    pub stations: usize,
    /// From where, times as far as the camera stands; stations take turns with them.
    pub distances: Vec<f64>,
    /// Sides of the pictures, in pixels; stations take turns with them, but the first station has
    /// all.
    pub sides: Vec<u32>,
    /// Of each picture only so many rows in the middle are compared; all without it.
    pub rows: Option<u32>,
}

impl LookEffort {
    /// Seconds a look.
    pub fn quick() -> Self {
        Self::of(4, &[1, 2, 7, 48])
    }

    /// Ten seconds a look.
    pub fn full() -> Self {
        Self::of(12, &[1, 2, 3, 16, 61, 160])
    }

    /// Minutes a look.
    pub fn soak() -> Self {
        Self::of(64, &[1, 2, 3, 5, 16, 61, 128, 333, 1024])
    }

    /// The largest pictures, near and far, in the exact tier, and of those some rows in the middle;
    /// half a minute a look.
    pub fn large() -> Self {
        let [near, _, far] = DISTANCES;
        let meshes = vec!["shape:creature"];
        let (tiers, distances) = (vec![Tier::Exact], vec![near, far]);
        Self { meshes, tiers, distances, rows: Some(LARGE_ROWS), ..Self::of(2, &[4096]) }
    }

    fn of(stations: usize, sides: &[u32]) -> Self {
        let tiers = vec![Tier::Exact, Tier::Balanced, Tier::Fast];
        let distances = DISTANCES.to_vec();
        Self {
            meshes: MESHES.to_vec(),
            tiers,
            stations,
            distances,
            sides: sides.to_vec(),
            rows: None,
        }
    }

    /// The largest side, in pixels.
    pub fn side(&self) -> u32 {
        self.sides.iter().copied().max().unwrap_or(1)
    }

    /// How many truths a look takes.
    pub fn truths(&self) -> usize {
        self.meshes.len() * (self.stations + self.sides.len()).saturating_sub(1)
    }
}

/// What a look came to in a tier.
#[derive(Clone, Debug, Serialize)]
pub struct LookFigures {
    /// The file's stem.
    pub look: String,
    /// The tier of all of its nodes.
    pub tier: Tier,
    /// How many pictures were compared.
    pub pictures: usize,
    /// How many pixels count as on edges only because a camera a step aside sees what was drawn.
    pub settled: usize,
    /// All pictures together.
    pub error: ErrorFigures,
    /// The worst picture in words.
    pub worst_words: String,
    /// What it is held to.
    pub bound: LookBound,
}

impl LookFigures {
    /// Whether it keeps what it is held to.
    pub fn holds(&self) -> bool {
        let (error, bound) = (&self.error, &self.bound);
        let is_seldom = |share: f64| error.edge_visible as f64 <= share * error.edges as f64;
        error.broken == 0
            && error.rms <= bound.rms
            && bound.max.is_none_or(|max| error.max <= max || is_rare(error, max))
            && bound.edge_share.is_none_or(is_seldom)
    }
}

/// Whether so few pixels are off by more than 1/255, and none by more than four times the bound,
/// that only cartoon edges which are a few pixels wide can be: their width is a difference of
/// normals over a pixel, and of that f32 leaves three digits at 4096 pixels.
fn is_rare(error: &ErrorFigures, max: f64) -> bool {
    error.max <= 4.0 * max && error.visible as f64 <= RARE_INSIDE * error.pixels as f64
}

/// The looks of a folder, sorted.
///
/// # Errors
/// A folder that cannot be read.
pub fn looks_in(folder: &Path) -> Result<Vec<PathBuf>, Vec<Diagnostic>> {
    let told = |error: std::io::Error| {
        vec![Diagnostic::error("unreadable", format!("{}: {error}", folder.display()))]
    };
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).map_err(told)?.flatten().map(|entry| entry.path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    files.sort();
    Ok(files)
}

/// Hands over what decides on a look's pictures, but for the engines that judge them, always in the
/// same order: for each mesh the plans of the truth and of each tier, as the camera stands in the
/// file. The other stations follow from these.
///
/// # Errors
/// What is wrong with the look.
pub fn content(
    path: &Path,
    meshes: &[&str],
    tiers: &[Tier],
    library: &Library,
    sink: &mut dyn FnMut(&[u8]),
) -> Result<(), Vec<Diagnostic>> {
    let mut assets = Assets::default();
    let options = PlanOptions { size: [16; 2], samples: 1, time: 0.0 };
    for mesh in meshes {
        let setup = open(path, Some(mesh), &mut assets)?.value;
        setup.looks.iter().for_each(|worn| sink(worn.look.to_text().as_bytes()));
        let exact = Variant::Looks(Tier::Exact).of(&setup);
        Planner::for_truth(Assets::default())
            .plan(&exact, library, &Live::Keyed, &options)?
            .content(sink);
        let mut planner = Planner::default();
        for &tier in tiers {
            planner
                .plan(&Variant::Looks(tier).of(&setup), library, &Live::Keyed, &options)?
                .content(sink);
        }
    }
    Ok(())
}

/// Compares a look's pictures in each tier with the truth. `precise` draws
/// [precisely](crate::render::Gpu::precise).
///
/// # Errors
/// What is wrong with the look, what the GPU refuses, or that `progress` stopped it.
pub async fn measure_look(
    path: &Path,
    library: &Library,
    precise: &mut Renderer,
    effort: &LookEffort,
    progress: &Progress,
) -> Result<Vec<LookFigures>, MeasureError> {
    let look = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let mut assets = Assets::default();
    let mut figures = vec![Vec::new(); effort.tiers.len()];
    let mut settled = vec![0; effort.tiers.len()];
    let mut worst = vec![(0.0, String::new()); effort.tiers.len()];
    let side = effort.side();
    let mut bounds: Vec<LookBound> =
        effort.tiers.iter().map(|tier| LookBound::of(*tier).at(side)).collect();
    for mesh in &effort.meshes {
        let setup = open(path, Some(mesh), &mut assets)?.value;
        if let [worn, ..] = setup.looks.as_slice() {
            let of = |tier: &Tier| LookBound::of_look(&worn.look, library, *tier).at(side);
            bounds = effort.tiers.iter().map(of).collect();
        }
        let mut truths = Planner::for_truth(Assets::default());
        let mut planners: Vec<Planner> = effort.tiers.iter().map(|_| Planner::default()).collect();
        for (index, station) in viewpoints(&setup, effort.stations).iter().enumerate() {
            let sides = if index == 0 {
                effort.sides.clone()
            } else {
                vec![effort.sides[index % effort.sides.len()]]
            };
            let distance = effort.distances[index % effort.distances.len()];
            let seen = at_distance(station.of(&setup), distance);
            for side in sides {
                let options = PlanOptions { size: [side; 2], samples: 1, time: station.time };
                let exact = Variant::Looks(Tier::Exact).of(&seen);
                let rows = effort.rows.unwrap_or(side).min(side);
                let rows = (side - rows) / 2..(side + rows) / 2;
                let mut truth = Truth::in_rows(
                    &exact,
                    library,
                    &mut truths,
                    &options,
                    rows,
                    &progress.part(1),
                )?;
                for (number, &tier) in effort.tiers.iter().enumerate() {
                    let drawn = Variant::Looks(tier).of(&seen);
                    let plan = planners[number].plan(&drawn, library, &Live::Keyed, &options)?;
                    let got = Colors::from(&precise.picture(&plan).await?);
                    if bounds[number].max.is_some() {
                        settled[number] += truth.settle(
                            &got,
                            |_| VISIBLE,
                            &exact,
                            library,
                            &mut truths,
                            &options,
                        )?;
                    }
                    let error = truth.figures(&got);
                    if error.max > worst[number].0 {
                        let [x, y] = error.worst;
                        let name = mesh.trim_start_matches("shape:");
                        let words = format!(
                            "{name}, {side} px, station {index}, distance {distance}, pixel {x},{y}"
                        );
                        worst[number] = (error.max, words);
                    }
                    figures[number].push(error);
                }
            }
        }
    }
    let measured = effort.tiers.iter().zip(bounds).zip(figures).zip(settled).zip(worst);
    let measured = measured.map(|((((&tier, bound), figures), settled), (_, worst_words))| {
        let error = ErrorFigures::join(&figures);
        LookFigures {
            look: look.clone(),
            tier,
            pictures: figures.len(),
            settled,
            error,
            worst_words,
            bound,
        }
    });
    Ok(measured.collect())
}

/// The same from so many times as far.
fn at_distance(mut setup: Setup, times: f64) -> Setup {
    let camera = &mut setup.scene.camera;
    let target = DVec3::from(camera.target);
    camera.eye = (target + times * (DVec3::from(camera.eye) - target)).to_array();
    camera.height *= times;
    setup
}
