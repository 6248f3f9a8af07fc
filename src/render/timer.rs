//! Times of passes: timestamps of the GPU's own clock if it has one, else wall-clock time.

use std::time::Duration;

use super::{RenderError, Renderer};
use crate::clock::Clock;
use crate::frame::{Effect, FramePlan, PassId};
use crate::gpu::Gpu;

/// Largest number of passes that can be timed in one frame.
const MOST_PASSES: u32 = 16;
const STAMP_BYTES: u64 = 8;

/// Time of a pass.
#[derive(Clone, Debug, PartialEq)]
pub struct PassTime {
    /// The pass.
    pub id: PassId,
    /// Time from the begin of the pass to its end.
    pub duration: Duration,
}

/// Query set and buffers of the passes' timestamps.
#[derive(Debug)]
pub(super) struct Timer {
    stamps: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readback: wgpu::Buffer,
    next: u32,
}

impl Timer {
    fn new(gpu: &Gpu) -> Option<Self> {
        if !gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY) {
            return None;
        }
        let stamps = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("timestamps"),
            ty: wgpu::QueryType::Timestamp,
            count: 2 * MOST_PASSES,
        });
        let buffer = |usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: u64::from(2 * MOST_PASSES) * STAMP_BYTES,
                usage: usage | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        let resolved = buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC);
        let readback = buffer(wgpu::BufferUsages::MAP_READ);
        Some(Self { stamps, resolved, readback, next: 0 })
    }

    fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        let count = self.next.min(2 * MOST_PASSES);
        if count > 0 {
            encoder.resolve_query_set(&self.stamps, 0..count, &self.resolved, 0);
            encoder.copy_buffer_to_buffer(
                &self.resolved,
                0,
                &self.readback,
                0,
                u64::from(count) * STAMP_BYTES,
            );
        }
    }
}

impl Renderer {
    /// Timestamps for the next pass to write; `None` while nothing is measured.
    pub(super) fn stamps(timer: &mut Option<Timer>) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        let timer = timer.as_mut()?;
        let first = timer.next;
        if first + 2 > 2 * MOST_PASSES {
            return None;
        }
        timer.next += 2;
        Some(wgpu::RenderPassTimestampWrites {
            query_set: &timer.stamps,
            beginning_of_pass_write_index: Some(first),
            end_of_pass_write_index: Some(first + 1),
        })
    }

    /// Runs every pass of `plan`, whether its inputs changed or not, and returns the time of each.
    /// On an adapter without timestamps the wall-clock time of the whole frame is reported as that
    /// of its last pass.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub async fn measure(&mut self, plan: &FramePlan) -> Result<Vec<PassTime>, RenderError> {
        self.done.clear();
        self.lights.forget();
        self.timer = Timer::new(&self.gpu);
        let clock = Clock::start();
        let drawn = self.draw(plan).await;
        let timer = self.timer.take();
        let ran = drawn?;
        let Some(timer) = timer else {
            self.gpu.wait()?;
            let whole = Duration::from_secs_f64(clock.seconds());
            let last = ran.last().copied();
            return Ok(last.map(|id| PassTime { id, duration: whole }).into_iter().collect());
        };
        let mut encoder =
            self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        timer.resolve(&mut encoder);
        self.gpu.queue.submit([encoder.finish()]);
        let bytes = super::readback::read_buffer(&self.gpu, &timer.readback)?;
        let period = f64::from(self.gpu.queue.get_timestamp_period());
        let stamp = |index: usize| {
            let at = index * STAMP_BYTES as usize;
            bytes
                .get(at..at + 8)
                .and_then(|bytes| bytes.try_into().ok())
                .map_or(0, u64::from_le_bytes)
        };
        let times = ran.into_iter().enumerate().map(|(index, id)| {
            let ticks = stamp(2 * index + 1).saturating_sub(stamp(2 * index));
            PassTime { id, duration: Duration::from_nanos((ticks as f64 * period) as u64) }
        });
        Ok(times.collect())
    }
}

/// Writes the times of passes into their effects; leaves the effects alone if no clock told the
/// passes apart.
pub fn set_times(effects: &mut [Effect], times: &[PassTime]) {
    let passes = effects.iter().filter(|effect| effect.pass.is_some()).count();
    if times.len() < passes {
        return;
    }
    for effect in effects {
        let time = times.iter().find(|time| effect.pass == Some(time.id));
        if let Some(time) = time {
            effect.cost.milliseconds = Some(time.duration.as_secs_f64() * 1e3);
        }
    }
}
