//! Geometry of a draw: its vertices, shaded once each, and the tiles that its triangles touch.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use super::coverage::Pixels;
use super::options::ReferenceOptions;
use super::pool;
use super::setup::{Screen, Sides};
use super::shader::Shader;
use crate::diag::Diagnostic;
use crate::progress::Progress;

/// Triangles of a draw, with their shader.
#[derive(Clone, Copy)]
pub struct Triangles<'a> {
    /// Indices of vertices, three for each triangle.
    pub indices: &'a [u32],
    /// Shader of the triangles.
    pub shader: &'a dyn Shader,
    /// Sides that are drawn.
    pub sides: Sides,
}

/// Number of vertices that are shaded in one go.
const VERTICES: usize = 4096;
/// Number of triangles that are sorted into tiles in one go.
pub(super) const TRIANGLES: usize = 4096;

/// A draw whose vertices are shaded.
pub(super) struct Geometry<'a> {
    /// Index of the draw in the pass.
    pub(super) draw: u32,
    pub(super) triangles: Triangles<'a>,
    /// The least of the vertex indices, and the place of each vertex from there on among the shaded
    /// ones.
    first: u32,
    places: Vec<u32>,
    /// Clip position and varyings of each vertex, `stride` numbers.
    numbers: Vec<f64>,
    stride: usize,
}

impl<'a> Geometry<'a> {
    /// Shades the vertices that `triangles` use.
    pub(super) fn new(
        draw: u32,
        triangles: Triangles<'a>,
        options: &ReferenceOptions,
        progress: &Progress,
    ) -> Result<Self, Diagnostic> {
        let indices = triangles.indices;
        let first = indices.iter().copied().min().unwrap_or(0);
        let count = indices.iter().copied().max().map_or(0, |last| (last - first) as usize + 1);
        // Vertices that no triangle uses are not shaded.
        let mut places = vec![u32::MAX; count];
        indices.iter().for_each(|&index| places[(index - first) as usize] = 0);
        let mut used = Vec::new();
        for (index, place) in (first..).zip(&mut places).filter(|(_, place)| **place == 0) {
            *place = used.len() as u32;
            used.push(index);
        }
        let shader = triangles.shader;
        let stride = 4 + shader.varyings().iter().map(|varying| varying.components).sum::<usize>();
        // One list for all, as large as a mesh is, which the system gets back: of many lists of a
        // few hundred KiB the allocator keeps the memory.
        let mut numbers = vec![0.0; used.len() * stride];
        let parts: Vec<Mutex<&mut [f64]>> =
            numbers.chunks_mut(VERTICES * stride).map(Mutex::new).collect();
        let shade = |stage: &mut Box<dyn super::shader::VertexStage + '_>, number: usize| {
            let some = used.chunks(VERTICES).nth(number).unwrap_or_default();
            let mut part = parts[number].lock().unwrap_or_else(PoisonError::into_inner);
            stage.shade(some, &mut part)
        };
        pool::run(options.threads, parts.len(), progress, || shader.vertices(), shade)?;
        drop(parts);
        Ok(Self { draw, triangles, first, places, numbers, stride })
    }

    /// Size in memory, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.numbers.len() * 8 + self.places.len() * 4
    }

    /// Number of triangles.
    pub(super) fn count(&self) -> usize {
        self.triangles.indices.len() / 3
    }

    fn vertex(&self, index: u32) -> &[f64] {
        &self.numbers[self.places[(index - self.first) as usize] as usize * self.stride..]
            [..self.stride]
    }

    /// The clip positions and the numbers of the varyings at a triangle's corners.
    pub(super) fn triangle(&self, number: u32) -> ([[f64; 4]; 3], [&[f64]; 3]) {
        let corner = |i: usize| self.vertex(self.triangles.indices[3 * number as usize + i]);
        let corners = [corner(0), corner(1), corner(2)];
        (
            corners.map(|corner| [corner[0], corner[1], corner[2], corner[3]]),
            corners.map(|corner| &corner[4..]),
        )
    }

    /// Sorts a range of triangles into tiles.
    pub(super) fn bin(&self, numbers: Range<u32>, grid: &TileGrid) -> Vec<[u32; 2]> {
        let mut bins = Vec::new();
        for number in numbers {
            let fan = grid.screen.triangles(self.triangle(number).0, self.triangles.sides);
            let Some([least, most]) = fan.pixels(grid.screen.bits) else { continue };
            let Some(Pixels { begin, end }) = grid.all().and(least, most) else { continue };
            let tiles = |i: usize| begin[i] / grid.side..=(end[i] - 1) / grid.side;
            for row in tiles(1) {
                bins.extend(tiles(0).map(|column| [row * grid.count[0] + column, number]));
            }
        }
        bins.sort_unstable();
        bins
    }
}

/// The tiles of the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct TileGrid {
    pub(super) screen: Screen,
    /// Side of a tile, in pixels.
    pub(super) side: u32,
    /// Numbers of columns and rows.
    pub(super) count: [u32; 2],
}

impl TileGrid {
    pub(super) fn new(size: [u32; 2], options: &ReferenceOptions) -> Self {
        let side = options.tile();
        let screen = Screen { size, bits: options.snap.bits() };
        Self { screen, side, count: size.map(|pixels| pixels.div_ceil(side)) }
    }

    /// The rectangle of all pixels.
    fn all(&self) -> Pixels {
        Pixels { begin: [0; 2], end: self.screen.size }
    }

    /// Number of tiles.
    pub(super) fn tiles(&self) -> usize {
        self.count[0] as usize * self.count[1] as usize
    }

    /// The pixels of a tile.
    pub(super) fn pixels(&self, tile: usize) -> Pixels {
        let tile = tile as u32;
        let begin = [tile % self.count[0] * self.side, tile / self.count[0] * self.side];
        Pixels { begin, end: [0, 1].map(|i| (begin[i] + self.side).min(self.screen.size[i])) }
    }
}
