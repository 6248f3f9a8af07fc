//! Rasterizer: vertices, then lists of triangles by tile, then the tiles, each on one thread from
//! back to front.
//!
//! Within a tile all draws happen in the order of the plan, and a fragment's inputs depend on its
//! triangle alone; so the picture is the same for any number of threads and any size of tiles.
//!
//! # Memory
//! The picture takes 8 bytes a channel and 20 for coverage and depth of each pixel; a thread takes
//! one tile of samples. Shaded vertices and lists of triangles grow until
//! [`ReferenceOptions::budget`]; then they are drawn, and the samples of all tiles are kept (16
//! bytes, and 8 a channel) until the rest has come. Thus at most the vertices of one draw and one
//! list for each thread exceed the budget.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use chiaro_locale::tr;

use super::batches::{Batcher, Quad};
use super::coverage::Edges;
use super::geometry::{Geometry, TRIANGLES, TileGrid, Triangles};
use super::interpolate::TrianglePlane;
use super::options::ReferenceOptions;
use super::pool;
use super::texels::{Coverage, Texels};
use super::tile::{PassTarget, TileSamples};
use crate::diag::Diagnostic;
use crate::progress::Progress;

/// Largest number of samples of a picture: 8192x8192 pixels, or 4096x4096 of 4 samples.
pub const MAX_SAMPLES: u64 = 1 << 26;
/// Largest side of a picture, in pixels: the grid that coverage is decided on ends there.
pub const MAX_SIDE: u32 = 1 << 15;

/// Largest number of draws that have a batch in one thread at a time.
const BATCHES: usize = 16;

/// An image with the coverage of each of its pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Raster {
    /// Colors or numbers that were drawn.
    pub texels: Texels,
    /// Coverage of each pixel, rows from the top.
    pub coverage: Vec<Coverage>,
    /// Depth of the nearest sample of each pixel, 0 (near) to 1 (far).
    pub depths: Vec<f64>,
}

/// Some triangles of a draw, sorted into tiles.
struct BinnedTriangles<'a> {
    geometry: Arc<Geometry<'a>>,
    /// Pairs of tile and triangle, in order.
    bins: Vec<[u32; 2]>,
}

/// A pass that is being drawn.
struct RasterPass<'a> {
    grid: TileGrid,
    samples: u32,
    target: &'a PassTarget,
    options: &'a ReferenceOptions,
    progress: &'a Progress,
    pieces: Vec<BinnedTriangles<'a>>,
    /// Samples of tiles that were drawn in part.
    kept: Vec<Mutex<Option<TileSamples>>>,
    raster: Mutex<Raster>,
}

/// Draws `draws` in order into an image of `size` pixels with 1 or 4 `samples` each.
///
/// # Errors
/// - `reference-too-large`: there are more than [`MAX_SAMPLES`] samples, or a side is longer than
///   [`MAX_SIDE`].
/// - `reference-samples`: a pixel has neither 1 nor 4 samples.
/// - `stopped`: `progress` was stopped.
/// - Errors of the shaders.
pub fn rasterize(
    size: [u32; 2],
    samples: u32,
    target: &PassTarget,
    draws: &[Triangles<'_>],
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<Raster, Diagnostic> {
    check_size(size, samples)?;
    let grid = TileGrid::new(size, options);
    let count = size[0] as usize * size[1] as usize;
    let raster = Raster {
        texels: Texels::new(size, target.channels()),
        coverage: vec![Coverage::default(); count],
        depths: vec![1.0; count],
    };
    let kept = (0..grid.tiles()).map(|_| Mutex::new(None)).collect();
    let raster = Mutex::new(raster);
    let mut work =
        RasterPass { grid, samples, target, options, progress, pieces: Vec::new(), kept, raster };
    let mut bytes = 0;
    for (number, triangles) in (0..).zip(draws) {
        work.gather(number, *triangles, &mut bytes)?;
    }
    work.draw(true)?;
    Ok(work.raster.into_inner().unwrap_or_else(PoisonError::into_inner))
}

/// Refuses pictures that would take too much memory, and numbers of samples that do not exist.
pub(super) fn check_size(size: [u32; 2], samples: u32) -> Result<(), Diagnostic> {
    if !matches!(samples, 1 | 4) {
        let message = tr!("a pixel has 1 or 4 samples, not {samples}");
        return Err(Diagnostic::error("reference-samples", message));
    }
    let count = u64::from(size[0]) * u64::from(size[1]) * u64::from(samples);
    if count <= MAX_SAMPLES && size[0].max(size[1]) <= MAX_SIDE {
        return Ok(());
    }
    let [width, height] = size;
    let message =
        tr!("{width}x{height} pixels of {samples} samples are too many for the reference");
    Err(Diagnostic::error("reference-too-large", message)
        .hint(tr!("use a smaller picture, or one sample a pixel")))
}

impl<'a> RasterPass<'a> {
    /// Shades a draw's vertices and sorts its triangles; draws whenever the lists have grown to the
    /// budget.
    fn gather(
        &mut self,
        draw: u32,
        triangles: Triangles<'a>,
        bytes: &mut usize,
    ) -> Result<(), Diagnostic> {
        let geometry = Arc::new(Geometry::new(draw, triangles, self.options, self.progress)?);
        *bytes += geometry.bytes();
        let pieces = geometry.count().div_ceil(TRIANGLES);
        // The wave gives work to all threads, and no more than one wave is ever beyond the budget.
        let wave = self.options.threads.max(1);
        for begin in (0..pieces).step_by(wave) {
            let bin = |(): &mut (), number: usize| {
                let first = (begin + number) * TRIANGLES;
                let end = (first + TRIANGLES).min(geometry.count());
                Ok(geometry.bin(first as u32..end as u32, &self.grid))
            };
            let lists = pool::run(wave, wave.min(pieces - begin), self.progress, || (), bin)?;
            *bytes += lists.iter().map(|bins| bins.len() * 8).sum::<usize>();
            self.pieces.extend(
                lists.into_iter().map(|bins| BinnedTriangles { geometry: geometry.clone(), bins }),
            );
            if *bytes > self.options.budget {
                self.draw(false)?;
                // The vertices stay in memory as long as the draw has more triangles.
                *bytes = if begin + wave < pieces { geometry.bytes() } else { 0 };
            }
        }
        Ok(())
    }

    /// Draws the gathered triangles; the last time, the samples become the picture.
    fn draw(&mut self, is_last: bool) -> Result<(), Diagnostic> {
        let tiles = self.grid.tiles();
        if is_last {
            self.progress.begin(tiles as u64);
        }
        let state = || Worker { spare: None, batches: HashMap::new() };
        pool::run(self.options.threads, tiles, self.progress, state, |worker, tile| {
            self.draw_tile(worker, tile, is_last)?;
            if is_last {
                self.progress.add(1);
            }
            Ok(())
        })?;
        self.pieces.clear();
        Ok(())
    }

    fn draw_tile<'w>(
        &'w self,
        worker: &mut Worker<'w>,
        tile: usize,
        is_last: bool,
    ) -> Result<(), Diagnostic> {
        let held = || self.kept[tile].lock().unwrap_or_else(PoisonError::into_inner);
        let mine = |piece: &'w BinnedTriangles<'a>| {
            let begin = piece.bins.partition_point(|bin| (bin[0] as usize) < tile);
            let end = piece.bins.partition_point(|bin| (bin[0] as usize) <= tile);
            (&piece.geometry, &piece.bins[begin..end])
        };
        let mut lists =
            self.pieces.iter().map(mine).filter(|(_, bins)| !bins.is_empty()).peekable();
        if !is_last && lists.peek().is_none() {
            return Ok(());
        }
        let kept = held().take();
        let is_kept = kept.is_some();
        let fresh = || TileSamples::new(self.grid.side, self.samples, self.target);
        let mut samples = kept.or_else(|| worker.spare.take()).unwrap_or_else(fresh);
        if !is_kept {
            samples.clear(self.grid.pixels(tile), self.target);
        }
        while let Some((geometry, bins)) = lists.next() {
            let batch = worker.batch(geometry, self.target);
            for [_, number] in bins {
                self.draw_triangle(geometry, *number, batch, &mut samples)?;
            }
            if lists.peek().is_none_or(|(next, _)| next.draw != geometry.draw) {
                batch.flush(&mut samples, self.target, self.progress)?;
            }
        }
        if is_last {
            let mut raster = self.raster.lock().unwrap_or_else(PoisonError::into_inner);
            samples.resolve(&mut raster);
            worker.spare = Some(samples);
        } else {
            *held() = Some(samples);
        }
        Ok(())
    }

    fn draw_triangle(
        &self,
        geometry: &Geometry<'_>,
        number: u32,
        batch: &mut Batcher<'_>,
        tile: &mut TileSamples,
    ) -> Result<(), Diagnostic> {
        let bits = self.grid.screen.bits;
        let (clip, varyings) = geometry.triangle(number);
        let fan = self.grid.screen.triangles(clip, geometry.triangles.sides);
        let Some([least, most]) = fan.pixels(bits) else { return Ok(()) };
        let pixels = tile.pixels().and(least, most).and_then(|pixels| self.options.wanted(pixels));
        let Some(pixels) = pixels else { return Ok(()) };
        for triangle in fan.triangles() {
            let surface = TrianglePlane::new(&triangle, bits);
            Edges::new(&triangle, bits, self.samples).quads(pixels, |x, y, covered| {
                let owner = [geometry.draw, number];
                let is_front = triangle.is_front;
                let quad =
                    Quad { at: [x, y], covered, is_front, owner, surface: &surface, varyings };
                batch.push(&quad, tile, self.samples, self.target, self.progress)
            })?;
        }
        Ok(())
    }
}

/// State that a thread keeps from tile to tile.
struct Worker<'a> {
    spare: Option<TileSamples>,
    batches: HashMap<u32, Batcher<'a>>,
}

impl<'a> Worker<'a> {
    fn batch(&mut self, geometry: &'a Geometry<'_>, target: &PassTarget) -> &mut Batcher<'a> {
        // All batches are empty here, as a tile flushes the batch of a draw before the next draw.
        if self.batches.len() >= BATCHES && !self.batches.contains_key(&geometry.draw) {
            self.batches.clear();
        }
        let shader = geometry.triangles.shader;
        let made = || Batcher::new(shader.fragments(), shader.varyings(), target.channels());
        self.batches.entry(geometry.draw).or_insert_with(made)
    }
}
