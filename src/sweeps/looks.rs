//! Comparison of whole looks with their truth: over the sphere of lights and views, at picture
//! sizes from one pixel up, near and far.

use std::path::{Path, PathBuf};

use glam::DVec3;
use serde::Serialize;

use crate::accuracy::error::VISIBLE;
use crate::accuracy::viewpoint::viewpoints;
use crate::accuracy::{ErrorFigures, MeasureError, PremultipliedPicture, Variant, truth::Truth};
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::{Look, Tier};
use crate::files::{Files, WalkBounds};
use crate::frame::{Assets, Executor, PlanOptions, Planner, Setup, open};
use crate::library::Library;
use crate::progress::Progress;

/// Bounds of listing a folder of looks.
const BOUNDS: WalkBounds = WalkBounds { depth: 0, entries: 10_000 };
/// Own shapes that looks are compared on.
pub const MESHES: [&str; 3] = ["shape:sphere", "shape:creature", "shape:plane"];
/// Distances of the camera from its target, as factors of the document's: near, unchanged, and far.
pub const DISTANCES: [f64; 3] = [0.45, 1.0, 20.0];

/// Error bound of whole looks in a tier.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LookBound {
    /// The largest difference of a channel away from edges; `None` for a tier that is bound by its
    /// mean error alone.
    pub max: Option<f64>,
    /// The root of the mean square away from edges.
    pub rms: f64,
    /// Share of the pixels at edges that may be off by more than 1/255; `None`, for any share, in a
    /// tier that is bound by its mean error alone.
    pub edge_share: Option<f64>,
}

impl LookBound {
    /// The bound of a tier.
    ///
    /// - *exact* errs by f32's rounding. A normal is off by a few 1e-7, and curvature multiplies
    ///   that error: curvature is a difference of normals, divided by some pixels and given per
    ///   height of the picture, which makes a factor of up to 270 (from 800 pixels on), and warps
    ///   and cartoon edges are steep besides. The error comes to 1e-3 in single pixels, and to 1e-6
    ///   as a mean.
    /// - *balanced* errs by less than anyone sees, by definition.
    /// - *fast* may leave out the curvature pass, and take curvature from each triangle's own
    ///   normals: constant over the triangle, 0 on a flat one, and a warp by another curvature is
    ///   another picture there.
    pub const fn of(tier: Tier) -> Self {
        match tier {
            Tier::Exact => Self { max: Some(VISIBLE), rms: 1e-5, edge_share: Some(EDGE_SHARE) },
            Tier::Balanced => Self { max: Some(VISIBLE), rms: 1e-4, edge_share: Some(EDGE_SHARE) },
            Tier::Fast => Self { max: None, rms: 0.1, edge_share: None },
        }
    }

    /// The bound in pictures of `side` pixels a side: the coverage of a pattern's edge is off by as
    /// much as its [place](place_rounding), and one pixel in a hundred lies on such an edge.
    pub fn at(self, side: u32) -> Self {
        Self { rms: self.rms.max(0.1 * place_rounding(side)), ..self }
    }

    /// The bound of a look in a tier. If one of its nodes states an error that eight bits can show
    /// (a threshold's edges, a curvature that is wired on), later nodes may change a pixel entirely
    /// because of the error, and the look is bound by its mean error.
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

/// Rounding error of a place in f32, 2^-24 of the picture, for a picture of `side` pixels a side,
/// in pixels.
pub fn place_rounding(side: u32) -> f64 {
    f64::from(side) * 2f64.powi(-24)
}

/// Share of the pixels at edges of a look that may be off by more than 1/255. f32 leaves a vertex
/// about 1e-7 of the picture's side beside its true place, and a vertex that lies that near to the
/// middle between two steps of the grid is rounded to the other step: at 4096 pixels every tenth
/// vertex. A step then gives or takes one in 256 of the pixels along the outline, and the
/// curvature's stencil passes that on to the seven pixels around: 1e-3 together. In small pictures
/// of mirrored meshes, vertices lie just on such a middle, and fewer pixels count.
pub const EDGE_SHARE: f64 = 2e-3;

/// Number of rows of the largest pictures that are compared, a million pixels: a truth of all rows
/// takes a minute.
pub const LARGE_ROWS: u32 = 256;

/// Share of the pixels inside that may be off by up to four times the bound.
pub const RARE_INSIDE: f64 = 1e-5;

/// Selection of the pictures of a look that are compared.
#[derive(Clone, Debug, PartialEq)]
pub struct LookEffort {
    /// Meshes that wear the look.
    pub meshes: Vec<&'static str>,
    /// Tiers that are compared.
    pub tiers: Vec<Tier>,
    /// Number of viewpoints: views, each with its lights and time.
    pub viewpoints: usize,
    /// Distances of the camera, as factors of the document's; viewpoints take turns with the
    /// distances.
    pub distances: Vec<f64>,
    /// Sides of the pictures, in pixels; viewpoints take turns with the sides, but the first
    /// viewpoint has all of them.
    pub sides: Vec<u32>,
    /// Number of rows in the middle of each picture that are compared; all rows if `None`.
    pub rows: Option<u32>,
}

impl LookEffort {
    /// Selection that takes seconds a look.
    pub fn quick() -> Self {
        Self::of(4, &[1, 2, 7, 48])
    }

    /// Selection that takes ten seconds a look.
    pub fn full() -> Self {
        Self::of(12, &[1, 2, 3, 16, 61, 160])
    }

    /// Selection that takes minutes a look.
    pub fn soak() -> Self {
        Self::of(64, &[1, 2, 3, 5, 16, 61, 128, 333, 1024])
    }

    /// Selection of the largest pictures, near and far, in the exact tier, with some rows in the
    /// middle of each; takes half a minute a look.
    pub fn large() -> Self {
        let [near, _, far] = DISTANCES;
        let meshes = vec!["shape:creature"];
        let (tiers, distances) = (vec![Tier::Exact], vec![near, far]);
        Self { meshes, tiers, distances, rows: Some(LARGE_ROWS), ..Self::of(2, &[4096]) }
    }

    fn of(viewpoints: usize, sides: &[u32]) -> Self {
        let tiers = vec![Tier::Exact, Tier::Balanced, Tier::Fast];
        let distances = DISTANCES.to_vec();
        Self {
            meshes: MESHES.to_vec(),
            tiers,
            viewpoints,
            distances,
            sides: sides.to_vec(),
            rows: None,
        }
    }

    /// The largest side of the pictures, in pixels.
    pub fn side(&self) -> u32 {
        self.sides.iter().copied().max().unwrap_or(1)
    }

    /// Number of truths that are rendered for a look.
    pub fn truths(&self) -> usize {
        self.meshes.len() * (self.viewpoints + self.sides.len()).saturating_sub(1)
    }
}

/// Errors of a look in a tier.
#[derive(Clone, Debug, Serialize)]
pub struct LookFigures {
    /// Stem of the look's file name.
    pub look: String,
    /// Tier of all nodes of the look.
    pub tier: Tier,
    /// Number of pictures that were compared.
    pub pictures: usize,
    /// Number of pixels that count as on edges only because a camera one step aside sees what was
    /// drawn.
    pub settled: usize,
    /// Figures over all pictures.
    pub error: ErrorFigures,
    /// Description of the worst picture.
    pub worst_words: String,
    /// Bound of the look in this tier.
    pub bound: LookBound,
}

impl LookFigures {
    /// True if the errors are within the bound.
    pub fn holds(&self) -> bool {
        let (error, bound) = (&self.error, &self.bound);
        let is_seldom = |share: f64| error.edge_visible as f64 <= share * error.edges as f64;
        error.broken == 0
            && error.rms <= bound.rms
            && bound.max.is_none_or(|max| error.max <= max || is_rare(error, max))
            && bound.edge_share.is_none_or(is_seldom)
    }
}

/// True if so few pixels are off by more than 1/255, and none by more than four times the bound,
/// that only cartoon edges a few pixels wide can be the cause: their width is a difference of
/// normals over a pixel, and f32 leaves three digits of that difference at 4096 pixels.
fn is_rare(error: &ErrorFigures, max: f64) -> bool {
    error.max <= 4.0 * max && error.visible as f64 <= RARE_INSIDE * error.pixels as f64
}

/// The looks of a folder, sorted.
///
/// # Errors
/// A folder that cannot be read.
pub fn looks_in(files: &dyn Files, folder: &Path) -> Result<Vec<PathBuf>, Vec<Diagnostic>> {
    let mut found = files.walk(folder, BOUNDS, &|_| false);
    if let Some((path, error)) = found.unreadable.first() {
        return Err(vec![Diagnostic::error("unreadable", format!("{}: {error}", path.display()))]);
    }
    found.files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    Ok(found.files)
}

/// Passes to `sink` everything that decides on a look's pictures, except the engines that judge
/// them, always in the same order: for each mesh the plans of the truth and of each tier, with the
/// camera as in the file. The other viewpoints follow from these.
///
/// # Errors
/// Problems of the look.
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
            .value
            .content(sink);
        let mut planner = Planner::default();
        for &tier in tiers {
            planner
                .plan(&Variant::Looks(tier).of(&setup), library, &Live::Keyed, &options)?
                .value
                .content(sink);
        }
    }
    Ok(())
}

/// Compares a look's pictures in each tier with the truth. `precise` draws
/// [precisely](crate::render::Gpu::precise).
///
/// # Errors
/// Problems of the look, errors of the GPU, or `Interruption` if `progress` was stopped.
pub async fn measure_look(
    path: &Path,
    library: &Library,
    precise: &mut dyn Executor,
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
        for (index, viewpoint) in viewpoints(&setup, effort.viewpoints).iter().enumerate() {
            let sides = if index == 0 {
                effort.sides.clone()
            } else {
                vec![effort.sides[index % effort.sides.len()]]
            };
            let distance = effort.distances[index % effort.distances.len()];
            let seen = at_distance(viewpoint.of(&setup), distance);
            for side in sides {
                let options = PlanOptions { size: [side; 2], samples: 1, time: viewpoint.time };
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
                    let plan =
                        planners[number].plan(&drawn, library, &Live::Keyed, &options)?.value;
                    let got = PremultipliedPicture::from(
                        &precise.picture(&plan, &Progress::new()).await?,
                    );
                    // Settling renders further truths, which only a bound on single pixels calls
                    // for.
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

/// The setup with its camera's distance from the target multiplied by `times`.
fn at_distance(mut setup: Setup, times: f64) -> Setup {
    let camera = &mut setup.scene.camera;
    let target = DVec3::from(camera.target);
    camera.eye = (target + times * (DVec3::from(camera.eye) - target)).to_array();
    camera.height *= times;
    setup
}
