//! The reference's picture of a setup, to hold others against.

use std::ops::Range;

use glam::DVec3;

use super::error::difference;
use super::{Colors, ErrorFigures, MeasureError, compare};
use crate::compile::Live;
use crate::frame::{FramePlan, PlanOptions, Planner, Setup, View};
use crate::interp::Precision;
use crate::library::Library;
use crate::progress::Progress;
use crate::reference::{self, Modules, ReferencePicture, Snap};
use crate::render::Renderer;

/// GPUs and software Vulkan decide coverage where they have rounded vertices to, to 2^-8 of a
/// pixel; it agrees where the truth does the same. What is interpolated lies between vertices as
/// they are: a GPU that rounds it too is off by that.
const GRID: Snap = Snap::Subpixel(8);

/// A picture in f64: nothing folded, every value at f64, one sample a pixel.
#[derive(Debug)]
pub struct Truth {
    picture: ReferencePicture,
    /// From where it is seen.
    view: View,
    /// Pixels on edges: next to one where something else is on top.
    edges: Vec<bool>,
    /// The rows that others are held against, from the top.
    rows: Range<usize>,
}

impl Truth {
    /// Renders `setup` as it is, with what `planner` (one [for the truth](Planner::for_truth)) has
    /// read. `progress` counts the picture's passes.
    ///
    /// # Errors
    /// What is wrong with the setup, what the interpreter cannot run, or that `progress` was
    /// stopped.
    pub fn of(
        setup: &Setup,
        library: &Library,
        planner: &mut Planner,
        options: &PlanOptions,
        progress: &Progress,
    ) -> Result<Self, MeasureError> {
        Self::in_rows(setup, library, planner, options, 0..options.size[1], progress)
    }

    /// The same of some rows alone, from the top; others are held against these.
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
        let plan = planner.plan(setup, library, &Live::All, &options)?;
        let one = |problem| vec![problem];
        let modules = Modules::new(&plan, Precision::F64).map_err(one)?;
        let [width, height] = options.size;
        let reach = reach(&plan);
        // What is around the rows says where their edges are.
        let around = 1 + reach as u32;
        let region = [0, rows.start.saturating_sub(around), width, (rows.end + around).min(height)];
        let region = (rows != (0..height)).then_some(region);
        let options = reference::Options { snap: GRID, region, ..reference::Options::default() };
        let picture = reference::execute(&plan, &modules, &options, progress).map_err(one)?;
        let edges = edges(&picture, &plan.view, reach);
        Ok(Self { picture, edges, view: plan.view, rows: rows.start as usize..rows.end as usize })
    }

    /// The picture.
    pub fn picture(&self) -> &ReferencePicture {
        &self.picture
    }

    /// Whether a pixel, rows from the top, lies on an edge, where coverage may differ.
    pub fn is_edge(&self, index: usize) -> bool {
        self.edges.get(index).copied().unwrap_or(true)
    }

    /// Counts pixels as on edges where rounding decides which of two triangles they show, and so
    /// what is drawn leaps: those that differ from `got` by more than `above` says, and that a
    /// camera which stands one step of the grid aside sees as they were drawn. `setup`, `planner`
    /// and `options` are those that this was rendered with. Returns how many they are.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn settle(
        &mut self,
        got: &Colors<'_>,
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
        // So many are no chance.
        if all > MOST_BESIDE {
            return Ok(0);
        }
        let options = PlanOptions { samples: 1, ..options.clone() };
        for step in BESIDE {
            if open.is_empty() {
                break;
            }
            let plan =
                planner.plan(&aside(setup, &self.view, step), library, &Live::All, &options)?;
            let one = |problem| vec![problem];
            let modules = Modules::new(&plan, Precision::F64).map_err(one)?;
            let mut left = Vec::new();
            for index in open {
                let [x, y] =
                    [index as u32 % self.picture.size[0], index as u32 / self.picture.size[0]];
                let region = Some([x, y, x + 1, y + 1]);
                let options =
                    reference::Options { snap: GRID, region, ..reference::Options::default() };
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

    /// How far the GPU's picture of `plan` is from this one. `renderer` should be
    /// [precise](crate::render::Gpu::precise), and the plan have one sample a pixel.
    ///
    /// # Errors
    /// What the GPU refuses.
    pub async fn compare(
        &self,
        renderer: &mut Renderer,
        plan: &FramePlan,
    ) -> Result<ErrorFigures, MeasureError> {
        Ok(self.figures(&Colors::from(&renderer.picture(plan).await?)))
    }

    /// How far a picture that was drawn is from this one.
    pub fn figures(&self, got: &Colors<'_>) -> ErrorFigures {
        let indices = self.indices();
        let Some(got_here) = got.rgba.get(indices.clone()) else { return ErrorFigures::default() };
        let colors = self.colors();
        let size = [got.size[0], self.rows.len() as u32];
        let first = indices.start;
        let got = Colors { size, rgba: got_here.into() };
        let colors = Colors { size, rgba: colors.rgba[indices].into() };
        let mut figures = compare(&got, &colors, |index| self.is_edge(first + index));
        figures.worst[1] += self.rows.start as u32;
        figures
    }

    /// The pixels of the rows that others are held against.
    fn indices(&self) -> Range<usize> {
        let width = self.picture.size[0] as usize;
        self.rows.start * width..self.rows.end * width
    }

    /// Its colors, premultiplied.
    pub fn colors(&self) -> Colors<'_> {
        let pixels = self.picture.color.values.chunks_exact(4);
        Colors { size: self.picture.size, rgba: pixels.map(|p| [p[0], p[1], p[2], p[3]]).collect() }
    }
}

/// Steps of the grid to all sides, in pixels.
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
/// Of a picture in which more pixels differ none is looked at again.
const MOST_BESIDE: usize = 200;

/// The same seen by a camera that stands so many pixels to the right and up, as pixels are where it
/// looks at.
fn aside(setup: &Setup, view: &View, [x, y]: [f64; 2]) -> Setup {
    let mut setup = setup.clone();
    let camera = &mut setup.scene.camera;
    let (eye, target) = (DVec3::from(camera.eye), DVec3::from(camera.target));
    let (right, up) = (view.rotation().row(0), view.rotation().row(1));
    let by = view.pixel_size_at(eye.distance(target)) * (x * right + y * up);
    (camera.eye, camera.target) = ((eye + by).to_array(), (target + by).to_array());
    setup
}

/// A depth bends more than this from pixel to pixel where one part of a surface hides another: in
/// pixels.
const BEND: f64 = 3.0;

/// How far an edge is felt, in pixels: beyond its neighbours as far as passes over normals look.
fn reach(plan: &FramePlan) -> usize {
    1 + plan.reach()
}

/// Pixels that have a neighbour with another draw on top, or nothing, or another part of the same
/// surface: there a GPU may see the one where the truth sees the other.
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

/// Whether anything within `reach` to either side, above or below, or both, is set.
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
