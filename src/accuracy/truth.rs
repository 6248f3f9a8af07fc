//! The reference's picture of a setup, to hold others against.

use super::{Colors, ErrorFigures, Progress, Stopped, compare};
use crate::compile::Live;
use crate::frame::{FramePlan, PlanOptions, Planner, Setup, View};
use crate::interp::Precision;
use crate::library::Library;
use crate::reference::{self, Control, Modules, ReferencePicture, Snap};
use crate::render::{Renderer, block_on};

/// GPUs and software Vulkan decide coverage where they have rounded vertices to, to 2^-8 of a pixel; it agrees where the
/// truth does the same. What is interpolated lies between vertices as they are: a GPU that rounds it too is off by that.
const GRID: Snap = Snap::Subpixel(8);

/// A picture in f64: nothing folded, every value at f64, one sample a pixel.
#[derive(Debug)]
pub struct Truth {
    picture: ReferencePicture,
    /// Pixels on edges: next to one where something else is on top.
    edges: Vec<bool>,
}

impl Truth {
    /// Renders `setup` as it is, with what `planner` (one [for the truth](Planner::for_truth)) has read.
    ///
    /// # Errors
    /// What is wrong with the setup, what the interpreter cannot run, or that `progress` stopped it.
    pub fn of(
        setup: &Setup,
        library: &Library,
        planner: &mut Planner,
        options: &PlanOptions,
        progress: &mut Progress<'_>,
    ) -> Result<Self, Stopped> {
        Self::watched(setup, library, planner, options, progress, &Control::none())
    }

    /// The same, with somebody who watches the picture being made and may stop it.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn watched(
        setup: &Setup,
        library: &Library,
        planner: &mut Planner,
        options: &PlanOptions,
        progress: &mut Progress<'_>,
        control: &Control<'_>,
    ) -> Result<Self, Stopped> {
        let options = PlanOptions { samples: 1, ..options.clone() };
        let plan = planner.plan(setup, library, &Live::All, &options)?;
        progress.step()?;
        let one = |problem| vec![problem];
        let modules = Modules::new(&plan, Precision::F64).map_err(one)?;
        let options = reference::Options { snap: GRID, ..reference::Options::default() };
        let picture = reference::execute(&plan, &modules, &options, control).map_err(one)?;
        let edges = edges(&picture, &plan.view, reach(&plan));
        Ok(Self { picture, edges })
    }

    /// The picture.
    pub fn picture(&self) -> &ReferencePicture {
        &self.picture
    }

    /// Whether a pixel, rows from the top, lies on an edge, where coverage may differ.
    pub fn is_edge(&self, index: usize) -> bool {
        self.edges.get(index).copied().unwrap_or(true)
    }

    /// How far the GPU's picture of `plan` is from this one. `renderer` should be [precise](crate::render::Gpu::precise),
    /// and the plan have one sample a pixel.
    ///
    /// # Errors
    /// What the GPU refuses.
    pub fn compare(&self, renderer: &mut Renderer, plan: &FramePlan) -> Result<ErrorFigures, Stopped> {
        let got = Colors::from(&block_on(renderer.picture(plan))?);
        Ok(compare(&got, &self.colors(), |index| self.is_edge(index)))
    }

    /// Its colours, premultiplied.
    pub fn colors(&self) -> Colors<'_> {
        let pixels = self.picture.color.values.chunks_exact(4);
        Colors { size: self.picture.size, rgba: pixels.map(|p| [p[0], p[1], p[2], p[3]]).collect() }
    }
}

/// A depth bends more than this from pixel to pixel where one part of a surface hides another: in pixels.
const BEND: f64 = 3.0;

/// How far an edge is felt, in pixels: beyond its neighbours as far as passes over normals look.
fn reach(plan: &FramePlan) -> usize {
    1 + plan.reach()
}

/// Pixels that have a neighbour with another draw on top, or nothing, or another part of the same surface: there a GPU
/// may see the one where the truth sees the other.
fn edges(picture: &ReferencePicture, view: &View, reach: usize) -> Vec<bool> {
    let [width, height] = picture.size.map(|side| side as usize);
    let distances: Vec<f64> = picture.depths.iter().map(|&depth| view.distance(depth)).collect();
    let draw = |x: usize, y: usize| picture.coverage[y * width + x].draw;
    let bends = |center: usize, before: usize, after: usize| {
        let pixel = view.pixel_size() * if view.is_perspective { distances[center].abs() } else { 1.0 };
        (distances[before] - 2.0 * distances[center] + distances[after]).abs() > BEND * pixel
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
    let rows: Vec<bool> =
        (0..set.len()).map(|index| near(index % width, width).any(|x| set[index / width * width + x])).collect();
    (0..set.len()).map(|index| near(index / width, height).any(|y| rows[y * width + index % width])).collect()
}
