//! Truth: the reference's picture of a setup, that other pictures are compared with.

use std::ops::Range;

use glam::DVec3;

use super::error::difference;
use super::{ErrorFigures, MeasureError, PremultipliedPicture, compare};
use crate::compile::Live;
use crate::frame::{Executor, FramePlan, PlanOptions, Planner, Setup, View};
use crate::interp::Precision;
use crate::library::Library;
use crate::progress::Progress;
use crate::reference::{self, Modules, ReferencePicture, SnapGrid};

/// Grid that vertices are snapped to. GPUs and software Vulkan decide coverage after rounding
/// vertices to 2^-8 of a pixel; coverage agrees if the truth rounds them alike. Interpolated values
/// lie between the unrounded vertices: a GPU that rounds for interpolation too is off by the
/// difference.
const GRID: SnapGrid = SnapGrid::Subpixel(8);

/// A picture in f64: not specialized, every value in f64, one sample a pixel.
#[derive(Debug)]
pub struct Truth {
    picture: ReferencePicture,
    /// View that the picture is taken from.
    view: View,
    /// Pixels on edges, by index: those next to a pixel with something else on top.
    edges: Vec<bool>,
    /// Rows, from the top, that other pictures are compared in.
    rows: Range<usize>,
}

impl Truth {
    /// Renders `setup` as it is, with the assets that `planner` (one [for the
    /// truth](Planner::for_truth)) has read. `progress` counts the picture's passes.
    ///
    /// # Errors
    /// Problems of the setup, constructs that the interpreter cannot run, or `Interruption` if
    /// `progress` was stopped.
    pub fn of(
        setup: &Setup,
        library: &Library,
        planner: &mut Planner,
        options: &PlanOptions,
        progress: &Progress,
    ) -> Result<Self, MeasureError> {
        Self::in_rows(setup, library, planner, options, 0..options.size[1], progress)
    }

    /// Renders `rows` alone, counted from the top; other pictures are compared in these rows.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn in_rows(
        setup: &Setup,
        library: &Library,
        planner: &mut Planner,
        options: &PlanOptions,
        rows: Range<u32>,
        progress: &Progress,
    ) -> Result<Self, MeasureError> {
        let options = PlanOptions { samples: 1, ..options.clone() };
        let plan = planner.plan(setup, library, &Live::All, &options)?.value;
        let one = |problem| vec![problem];
        let modules = Modules::new(&plan, Precision::F64).map_err(one)?;
        let [width, height] = options.size;
        let reach = reach(&plan);
        // Rows around the wanted ones are rendered too, to find the edges of the wanted ones.
        let around = 1 + reach as u32;
        let region = [0, rows.start.saturating_sub(around), width, (rows.end + around).min(height)];
        let region = (rows != (0..height)).then_some(region);
        let options = reference::ReferenceOptions {
            snap: GRID,
            region,
            ..reference::ReferenceOptions::default()
        };
        let picture = reference::execute(&plan, &modules, &options, progress).map_err(one)?;
        let edges = edges(&picture, &plan.view, reach);
        Ok(Self { picture, edges, view: plan.view, rows: rows.start as usize..rows.end as usize })
    }

    /// The reference's picture.
    pub fn picture(&self) -> &ReferencePicture {
        &self.picture
    }

    /// True if a pixel, rows from the top, lies on an edge, where coverage may differ.
    pub fn is_edge(&self, index: usize) -> bool {
        self.edges.get(index).copied().unwrap_or(true)
    }

    /// Counts pixels as on edges if rounding decides which of two triangles they show, so that
    /// their color leaps: pixels that differ from `got` by more than `above` of their index, and
    /// that a camera one step of the grid aside sees as they were drawn. `setup`, `planner` and
    /// `options` are those that this truth was rendered with. Returns the number of such pixels.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn settle(
        &mut self,
        got: &PremultipliedPicture<'_>,
        above: impl Fn(usize) -> f64,
        setup: &Setup,
        library: &Library,
        planner: &mut Planner,
        options: &PlanOptions,
    ) -> Result<usize, MeasureError> {
        let colors = self.colors();
        let is_off = |&index: &usize| {
            !self.is_edge(index) && difference(&got.rgba[index], &colors.rgba[index]) > above(index)
        };
        let mut open: Vec<usize> =
            self.indices().filter(|&index| index < got.rgba.len()).filter(is_off).collect();
        drop(colors);
        let all = open.len();
        // Differences in so many pixels are no accident of rounding.
        if all > MOST_BESIDE {
            return Ok(0);
        }
        let options = PlanOptions { samples: 1, ..options.clone() };
        for step in BESIDE {
            if open.is_empty() {
                break;
            }
            let seen = aside(setup, &self.view, step);
            let plan = planner.plan(&seen, library, &Live::All, &options)?.value;
            let one = |problem| vec![problem];
            let modules = Modules::new(&plan, Precision::F64).map_err(one)?;
            let mut left = Vec::new();
            for index in open {
                let [x, y] =
                    [index as u32 % self.picture.size[0], index as u32 / self.picture.size[0]];
                let region = Some([x, y, x + 1, y + 1]);
                let options = reference::ReferenceOptions {
                    snap: GRID,
                    region,
                    ..reference::ReferenceOptions::default()
                };
                let picture =
                    reference::execute(&plan, &modules, &options, &Progress::new()).map_err(one)?;
                let seen = std::array::from_fn(|channel| picture.color.values[4 * index + channel]);
                if difference(&got.rgba[index], &seen) > above(index) {
                    left.push(index);
                } else {
                    self.edges[index] = true;
                }
            }
            open = left;
        }
        Ok(all - open.len())
    }

    /// Error figures of a picture of `plan` against this truth. `executor` should be
    /// [precise](crate::render::Gpu::precise), and the plan have one sample a pixel.
    ///
    /// # Errors
    /// Errors of the executor.
    pub async fn compare(
        &self,
        executor: &mut dyn Executor,
        plan: &FramePlan,
    ) -> Result<ErrorFigures, MeasureError> {
        Ok(self
            .figures(&PremultipliedPicture::from(&executor.picture(plan, &Progress::new()).await?)))
    }

    /// Error figures of a drawn picture against this truth.
    pub fn figures(&self, got: &PremultipliedPicture<'_>) -> ErrorFigures {
        let indices = self.indices();
        let Some(got_here) = got.rgba.get(indices.clone()) else { return ErrorFigures::default() };
        let colors = self.colors();
        let size = [got.size[0], self.rows.len() as u32];
        let first = indices.start;
        let got = PremultipliedPicture { size, rgba: got_here.into() };
        let colors = PremultipliedPicture { size, rgba: colors.rgba[indices].into() };
        let mut figures = compare(&got, &colors, |index| self.is_edge(first + index));
        figures.worst[1] += self.rows.start as u32;
        figures
    }

    /// Indices of the pixels in the rows that other pictures are compared in.
    fn indices(&self) -> Range<usize> {
        let width = self.picture.size[0] as usize;
        self.rows.start * width..self.rows.end * width
    }

    /// The colors of the picture, premultiplied.
    pub fn colors(&self) -> PremultipliedPicture<'_> {
        let pixels = self.picture.color.values.chunks_exact(4);
        PremultipliedPicture {
            size: self.picture.size,
            rgba: pixels.map(|p| [p[0], p[1], p[2], p[3]]).collect(),
        }
    }
}

/// One step of the grid in each of eight directions, in pixels.
const BESIDE: [[f64; 2]; 8] = {
    const STEP: f64 = 1.0 / 256.0;
    [
        [STEP, 0.0],
        [-STEP, 0.0],
        [0.0, STEP],
        [0.0, -STEP],
        [STEP, STEP],
        [-STEP, -STEP],
        [STEP, -STEP],
        [-STEP, STEP],
    ]
};
/// Largest number of differing pixels that are settled; of a picture with more none is looked at
/// again.
const MOST_BESIDE: usize = 200;

/// The setup with its camera moved `x` pixels to the right and `y` up; the size of a pixel is taken
/// at the camera's target.
fn aside(setup: &Setup, view: &View, [x, y]: [f64; 2]) -> Setup {
    let mut setup = setup.clone();
    let camera = &mut setup.scene.camera;
    let (eye, target) = (DVec3::from(camera.eye), DVec3::from(camera.target));
    let (right, up) = (view.rotation().row(0), view.rotation().row(1));
    let by = view.pixel_size_at(eye.distance(target)) * (x * right + y * up);
    (camera.eye, camera.target) = ((eye + by).to_array(), (target + by).to_array());
    setup
}

/// Smallest second difference of depth from pixel to pixel that counts as an edge, where one part
/// of a surface hides another, in pixels.
const BEND: f64 = 3.0;

/// Distance from an edge up to which pixels count as on it, in pixels: neighbors, and beyond them
/// as far as passes over normals look.
fn reach(plan: &FramePlan) -> usize {
    1 + plan.reach()
}

/// Pixels that have a neighbor with another draw on top, or nothing, or another part of the same
/// surface: a GPU may see one of them where the truth sees the other.
fn edges(picture: &ReferencePicture, view: &View, reach: usize) -> Vec<bool> {
    let [width, height] = picture.size.map(|side| side as usize);
    let distances: Vec<f64> = picture.depths.iter().map(|&depth| view.distance(depth)).collect();
    let draw = |x: usize, y: usize| picture.coverage[y * width + x].draw;
    let bends = |center: usize, before: usize, after: usize| {
        let bend = distances[before] - 2.0 * distances[center] + distances[after];
        bend.abs() > BEND * view.pixel_size_at(distances[center])
    };
    let parts: Vec<bool> = (0..width * height)
        .map(|index| {
            let (x, y) = (index % width, index / width);
            let along_x = x > 0 && x + 1 < width && bends(index, index - 1, index + 1);
            along_x || (y > 0 && y + 1 < height && bends(index, index - width, index + width))
        })
        .collect();
    let is_border = |index: usize| {
        let (x, y) = (index % width, index / width);
        let right = x + 1 < width && draw(x + 1, y) != draw(x, y);
        let below = y + 1 < height && draw(x, y + 1) != draw(x, y);
        parts[index] || right || below
    };
    let borders: Vec<bool> = (0..width * height).map(is_border).collect();
    widened(&borders, width, reach)
}

/// The set widened by `reach` pixels to all sides, diagonals included.
fn widened(set: &[bool], width: usize, reach: usize) -> Vec<bool> {
    let height = set.len() / width.max(1);
    let near = |at: usize, size: usize| at.saturating_sub(reach)..(at + reach + 1).min(size);
    let rows: Vec<bool> = (0..set.len())
        .map(|index| near(index % width, width).any(|x| set[index / width * width + x]))
        .collect();
    (0..set.len())
        .map(|index| near(index / width, height).any(|y| rows[y * width + index % width]))
        .collect()
}
