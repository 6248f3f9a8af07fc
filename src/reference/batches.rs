//! Shading in batches: quads of a draw are gathered until a batch is full, shaded together, and
//! drawn in their order.

use super::coverage::sample_positions;
use super::interpolate::{TrianglePlane, TrianglePoint};
use super::shader::{
    FragmentStage, QUADS, QuadBatch, ShaderOutputs, Varying, VaryingInterpolation,
};
use super::tile::{PassTarget, PendingQuad, TileSamples};
use crate::diag::Diagnostic;
use crate::progress::Progress;

/// One thread's batch of one draw.
pub(super) struct Batcher<'a> {
    stage: Box<dyn FragmentStage + 'a>,
    /// Interpolation of each number of the varyings.
    interpolation: Vec<VaryingInterpolation>,
    batch: QuadBatch,
    shaded: ShaderOutputs,
    pending: Vec<PendingQuad>,
}

/// A covered quad of a triangle.
pub(super) struct Quad<'a> {
    pub(super) at: [u32; 2],
    pub(super) covered: u16,
    pub(super) is_front: bool,
    pub(super) owner: [u32; 2],
    pub(super) surface: &'a TrianglePlane,
    /// All numbers of the varyings, at each corner of the whole triangle.
    pub(super) varyings: [&'a [f64]; 3],
}

impl<'a> Batcher<'a> {
    pub(super) fn new(
        stage: Box<dyn FragmentStage + 'a>,
        varyings: &[Varying],
        channels: usize,
    ) -> Self {
        let numbers =
            |varying: &Varying| std::iter::repeat_n(varying.interpolation, varying.components);
        let interpolation: Vec<_> = varyings.iter().flat_map(numbers).collect();
        let batch = QuadBatch::new(interpolation.len());
        Self {
            stage,
            interpolation,
            batch,
            shaded: ShaderOutputs::new(channels),
            pending: Vec::with_capacity(QUADS),
        }
    }

    /// Takes a quad, unless it is hidden; shades and draws the batch once it is full.
    pub(super) fn push(
        &mut self,
        quad: &Quad<'_>,
        tile: &mut TileSamples,
        samples: u32,
        target: &PassTarget,
        progress: &Progress,
    ) -> Result<(), Diagnostic> {
        let mut pending = PendingQuad {
            at: quad.at,
            covered: quad.covered,
            depths: [1.0; 16],
            owner: quad.owner,
        };
        let [left, top] = quad.at.map(f64::from);
        for lane in 0..4 {
            if quad.covered >> (4 * lane) & 0xF == 0 {
                continue;
            }
            for (sample, [x, y]) in sample_positions(samples).iter().enumerate() {
                let x = left + (lane & 1) as f64 + *x as f64 / 16.0;
                let y = top + (lane >> 1) as f64 + *y as f64 / 16.0;
                pending.depths[4 * lane + sample] = quad.surface.depth(x, y);
            }
        }
        pending.covered = tile.in_front(&pending);
        if pending.covered == 0 {
            return Ok(());
        }
        self.fill(quad, pending.covered);
        self.pending.push(pending);
        if self.batch.is_full() { self.flush(tile, target, progress) } else { Ok(()) }
    }

    fn fill(&mut self, quad: &Quad<'_>, covered: u16) {
        let live = (0..4)
            .filter(|lane| covered >> (4 * lane) & 0xF != 0)
            .fold(0, |live, lane| live | 1 << lane);
        let first = self.batch.begin(live, quad.is_front);
        let points: [TrianglePoint; 4] = std::array::from_fn(|lane| {
            let x = f64::from(quad.at[0] + (lane as u32 & 1)) + 0.5;
            let y = f64::from(quad.at[1] + (lane as u32 >> 1)) + 0.5;
            let point = quad.surface.point(x, y);
            self.batch.set_position(first + lane, [x, y, point.depth, point.inverse_w]);
            point
        });
        for (component, interpolation) in self.interpolation.iter().enumerate() {
            let corners = quad.varyings.map(|numbers| numbers[component]);
            for (lane, point) in points.iter().enumerate() {
                let number = match interpolation {
                    VaryingInterpolation::Perspective => point.mix(corners),
                    VaryingInterpolation::Flat => corners[0],
                };
                self.batch.set_varying(component, first + lane, number);
            }
        }
    }

    /// Shades and draws the pending quads.
    pub(super) fn flush(
        &mut self,
        tile: &mut TileSamples,
        target: &PassTarget,
        progress: &Progress,
    ) -> Result<(), Diagnostic> {
        if self.pending.is_empty() {
            return Ok(());
        }
        progress.check()?;
        self.shaded.discarded = 0;
        let result = self.stage.shade(&self.batch, &mut self.shaded);
        self.batch.clear();
        let pending = self.pending.drain(..);
        result?;
        for (quad, pending) in pending.enumerate() {
            tile.draw(&pending, 4 * quad, &self.shaded, target);
        }
        Ok(())
    }
}
