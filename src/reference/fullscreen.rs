//! Fullscreen passes: a fragment shader run for every pixel of an image, as a triangle over all of
//! it would.

use std::sync::{Mutex, PoisonError};

use super::geometry::TileGrid;
use super::options::ReferenceOptions;
use super::pool;
use super::raster::check_size;
use super::shader::{FragmentStage, QuadBatch, Shader, ShaderOutputs};
use super::texels::Texels;
use crate::diag::Diagnostic;
use crate::progress::Progress;

/// An image of `size` pixels with `channels` numbers each, the outputs of `shader`'s fragments; its
/// vertex stage is not run. Discarded pixels stay 0.
///
/// # Errors
/// As [`rasterize`](super::rasterize).
pub fn shade_all(
    size: [u32; 2],
    channels: usize,
    shader: &dyn Shader,
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<Texels, Diagnostic> {
    check_size(size, 1)?;
    let grid = TileGrid::new(size, options);
    let image = Mutex::new(Texels::new(size, channels));
    progress.begin(grid.tiles() as u64);
    let state = || Band {
        stage: shader.fragments(),
        batch: QuadBatch::new(0),
        shaded: ShaderOutputs::new(channels),
        quads: Vec::new(),
        pixels: Vec::new(),
    };
    pool::run(options.threads, grid.tiles(), progress, state, |band, tile| {
        let Some(pixels) = options.wanted(grid.pixels(tile)) else { return Ok(()) };
        for y in (pixels.begin[1]..pixels.end[1]).step_by(2) {
            for x in (pixels.begin[0]..pixels.end[0]).step_by(2) {
                band.push([x, y], size, progress)?;
            }
        }
        band.flush(progress)?;
        let mut image = image.lock().unwrap_or_else(PoisonError::into_inner);
        for ([x, y], numbers) in band.pixels.drain(..) {
            image.pixel_mut(x, y).copy_from_slice(&numbers);
        }
        progress.add(1);
        Ok(())
    })?;
    Ok(image.into_inner().unwrap_or_else(PoisonError::into_inner))
}

/// One thread's state.
struct Band<'a> {
    stage: Box<dyn FragmentStage + 'a>,
    batch: QuadBatch,
    shaded: ShaderOutputs,
    /// Upper left pixel of each quad of the batch.
    quads: Vec<[u32; 2]>,
    /// Finished pixels of a tile.
    pixels: Vec<([u32; 2], Vec<f64>)>,
}

impl Band<'_> {
    fn push(
        &mut self,
        at: [u32; 2],
        size: [u32; 2],
        progress: &Progress,
    ) -> Result<(), Diagnostic> {
        let live =
            (0..4).filter(|lane| at[0] + (lane & 1) < size[0] && at[1] + (lane >> 1) < size[1]);
        let first = self.batch.begin(live.fold(0, |live, lane| live | 1 << lane), true);
        for lane in 0..4 {
            let [x, y] =
                [at[0] + (lane & 1), at[1] + (lane >> 1)].map(|pixel| f64::from(pixel) + 0.5);
            self.batch.set_position(first + lane as usize, [x, y, 0.0, 1.0]);
        }
        self.quads.push(at);
        if self.batch.is_full() { self.flush(progress) } else { Ok(()) }
    }

    fn flush(&mut self, progress: &Progress) -> Result<(), Diagnostic> {
        progress.check()?;
        self.shaded.discarded = 0;
        self.stage.shade(&self.batch, &mut self.shaded)?;
        let counts = self.batch.live() & !self.shaded.discarded;
        for (quad, [x, y]) in self.quads.drain(..).enumerate() {
            for lane in (0..4).filter(|lane| counts >> (4 * quad + lane) & 1 == 1) {
                let numbers = (0..self.shaded.channels())
                    .map(|channel| self.shaded.get(channel, 4 * quad + lane));
                self.pixels
                    .push(([x + (lane as u32 & 1), y + (lane as u32 >> 1)], numbers.collect()));
            }
        }
        self.batch.clear();
        Ok(())
    }
}
