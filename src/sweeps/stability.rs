//! Flicker: change of a pixel from frame to frame beyond the change of its truth, while light and
//! camera turn slowly.

use std::path::Path;

use serde::Serialize;

use super::looks::EDGE_SHARE;
use crate::accuracy::error::VISIBLE;
use crate::accuracy::{MeasureError, PremultipliedPicture, Variant, truth::Truth};
use crate::compile::Live;
use crate::document::Tier;
use crate::frame::{Assets, Executor, PlanOptions, Planner, Setup, open};
use crate::library::Library;
use crate::progress::Progress;

/// Own shapes that turn.
pub const MESHES: [&str; 2] = ["shape:sphere", "shape:creature"];
/// Angle that the camera turns by from frame to frame; the light turns by twice as much the other
/// way, in radians.
pub const STEP: f64 = 0.004;
/// Largest change of a channel beyond the truth's where the truth is smooth: rounding alone, a
/// tenth of the difference that eight bits can show.
pub const ON_SMOOTH: f64 = 0.1 * VISIBLE;
/// Largest change of a channel beyond the truth's on terminators and cartoon edges, whose steepness
/// multiplies a normal's last digit: the difference that eight bits can show. On silhouettes a
/// share of the changes may be larger.
pub const ON_EDGES: f64 = VISIBLE;
/// Share of the changes on edges that may be up to four times as large.
pub const RARE_ON_EDGES: f64 = 1e-4;

/// Smallest change of the truth across a pixel that makes the pixel count as on a terminator or a
/// cartoon edge.
const STEEP: f64 = 0.04;

/// Extent of the measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StabilityEffort {
    /// Number of frames.
    pub frames: usize,
    /// Side of the pictures, in pixels.
    pub side: u32,
}

/// Flicker of one class of pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Flicker {
    /// Number of changes that were compared.
    pub count: u64,
    /// The largest change beyond the truth's.
    pub max: f64,
    /// The mean change beyond the truth's.
    pub mean: f64,
    /// The largest change of the truth itself.
    pub truth: f64,
    /// Number of changes beyond the truth's that were more than 1/255.
    pub visible: u64,
}

impl Flicker {
    fn note(&mut self, beside: f64, truth: f64) {
        self.count += 1;
        self.max = self.max.max(beside);
        self.mean += (beside - self.mean) / self.count as f64;
        self.truth = self.truth.max(truth);
        self.visible += u64::from(beside > VISIBLE);
    }
}

/// Flicker of a look on a mesh.
#[derive(Clone, Debug, Serialize)]
pub struct StabilityFigures {
    /// Stem of the look's file name.
    pub look: String,
    /// Name of the mesh.
    pub mesh: String,
    /// True if direction keys turn with the light or the view.
    pub has_direction_keys: bool,
    /// Flicker of pixels where the truth is smooth.
    pub smooth: Flicker,
    /// Flicker of pixels on terminators and cartoon edges.
    pub edges: Flicker,
    /// Flicker of pixels on silhouettes, where one part hides another, and as far from there as the
    /// curvature pass looks: coverage of a pixel decides their color.
    pub silhouettes: Flicker,
}

impl StabilityFigures {
    /// True if the flicker is within the bounds.
    pub fn holds(&self) -> bool {
        // The pixel may be off in either of the two frames.
        let is_seldom =
            self.silhouettes.visible as f64 <= 2.0 * EDGE_SHARE * self.silhouettes.count as f64;
        // A stroke or a dot is narrower than the movement from frame to frame: now and then its
        // edge lies where rounding decides.
        let is_rare = self.edges.max <= 4.0 * ON_EDGES
            && self.edges.visible as f64 <= RARE_ON_EDGES * self.edges.count as f64;
        self.smooth.max <= ON_SMOOTH && (self.edges.max <= ON_EDGES || is_rare) && is_seldom
    }
}

/// One frame: the GPU's picture and the truth, premultiplied, and the pixels on outlines.
struct ComparedFrame {
    got: Vec<[f64; 4]>,
    truth: Vec<[f64; 4]>,
    outlines: Vec<bool>,
}

/// Turns a look in its exact tier on a mesh, and compares each frame's change with the truth's: a
/// cheaper tier flickers by twice its error at most. `precise` draws
/// [precisely](crate::render::Gpu::precise).
///
/// # Errors
/// Problems of the look, errors of the GPU, or `Interruption` if `progress` was stopped.
pub async fn measure_stability(
    path: &Path,
    mesh: &str,
    library: &Library,
    precise: &mut dyn Executor,
    effort: &StabilityEffort,
    progress: &Progress,
) -> Result<StabilityFigures, MeasureError> {
    let setup = open(path, Some(mesh), &mut Assets::default())?.value;
    let setup = Variant::Looks(Tier::Exact).of(&setup);
    let (mut planner, mut truths) = (Planner::default(), Planner::for_truth(Assets::default()));
    let mut measured = StabilityFigures {
        look: path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default(),
        mesh: mesh.trim_start_matches("shape:").to_owned(),
        has_direction_keys: setup.looks.iter().any(|look| !look.look.direction_keys.is_empty()),
        smooth: Flicker::default(),
        edges: Flicker::default(),
        silhouettes: Flicker::default(),
    };
    let mut before: Option<ComparedFrame> = None;
    for index in 0..effort.frames {
        let turn = STEP * index as f64;
        let mut seen = setup.clone();
        seen.turn_camera([turn, 0.4 * turn]);
        seen.turn_lights([-2.0 * turn, turn]);
        let frame =
            frame(&seen, library, precise, (&mut planner, &mut truths), effort.side, progress)
                .await?;
        if let Some(before) = &before {
            compare(before, &frame, effort.side as usize, &mut measured);
        }
        before = Some(frame);
    }
    Ok(measured)
}

async fn frame(
    setup: &Setup,
    library: &Library,
    precise: &mut dyn Executor,
    (planner, truths): (&mut Planner, &mut Planner),
    side: u32,
    progress: &Progress,
) -> Result<ComparedFrame, MeasureError> {
    let options = PlanOptions { size: [side; 2], samples: 1, time: 0.0 };
    let mut truth = Truth::of(setup, library, truths, &options, &progress.part(1))?;
    let plan = planner.plan(setup, library, &Live::Keyed, &options)?.value;
    let got = PremultipliedPicture::from(&precise.picture(&plan, &Progress::new()).await?);
    let colors = truth.colors().rgba.into_owned();
    // Each of the two frames contributes half of a change.
    let above =
        |index| 0.5 * if is_steep(&colors, index, side as usize) { ON_EDGES } else { ON_SMOOTH };
    truth.settle(&got, above, setup, library, truths, &options)?;
    let outlines = (0..colors.len()).map(|index| truth.is_edge(index)).collect();
    Ok(ComparedFrame { got: got.rgba.into_owned(), truth: colors, outlines })
}

fn compare(
    before: &ComparedFrame,
    after: &ComparedFrame,
    width: usize,
    measured: &mut StabilityFigures,
) {
    for index in 0..after.got.len() {
        let change = |pixels: [&[[f64; 4]]; 2], channel: usize| {
            pixels[1][index][channel] - pixels[0][index][channel]
        };
        // A pixel without anything drawn in either frame cannot flicker.
        let is_empty =
            |frame: &ComparedFrame| frame.truth[index] == [0.0; 4] && frame.got[index] == [0.0; 4];
        if is_empty(before) && is_empty(after) {
            continue;
        }
        let (mut beside, mut truth) = (0.0_f64, 0.0_f64);
        for channel in 0..4 {
            let real = change([&before.truth, &after.truth], channel);
            let drawn = change([&before.got, &after.got], channel);
            beside = beside.max((drawn - real).abs());
            truth = truth.max(real.abs());
        }
        let kind = if before.outlines[index] || after.outlines[index] {
            &mut measured.silhouettes
        } else if is_steep(&after.truth, index, width) || is_steep(&before.truth, index, width) {
            &mut measured.edges
        } else {
            &mut measured.smooth
        };
        kind.note(beside, truth);
    }
}

/// True if the truth changes much from this pixel to the next ones.
fn is_steep(pixels: &[[f64; 4]], index: usize, width: usize) -> bool {
    let differs = |other: usize| {
        pixels.get(other).is_some_and(|other| {
            other.iter().zip(&pixels[index]).any(|(a, b)| (a - b).abs() > STEEP)
        })
    };
    let column = index % width;
    (column > 0 && differs(index - 1))
        || (column + 1 < width && differs(index + 1))
        || index.checked_sub(width).is_some_and(differs)
        || differs(index + width)
}
