//! Simulation of a farm: many frames on many machines that fail, event by event, without a clock.
//!
//! The same settings give the same figures on every machine. What is simulated is what tasks of
//! Chiaro do: a machine begins a chunk, compiles shaders where its adapter has none cached, draws
//! frame after frame, and may be lost at any time; the chunk then goes back to the queue, and whole
//! frames of it are kept. For comparison, a renderer that writes a chunk as one result loses all of
//! it.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

/// A farm and its work. Times in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FarmSettings {
    /// Frames to draw.
    pub frames: usize,
    /// Frames of a task.
    pub chunk: usize,
    /// Machines.
    pub workers: usize,
    /// Mean time of a frame; frames take from half of it to one and a half.
    pub frame: f64,
    /// Time to begin a task: the program, the scene and its assets.
    pub start: f64,
    /// Time to compile shaders, where a machine has none cached.
    pub shaders: f64,
    /// Time to find that a whole frame is whole.
    pub check: f64,
    /// Mean time from one loss of a machine to the next.
    pub between_failures: f64,
    /// Time until a lost machine is back, with its cache.
    pub repair: f64,
    /// Time until the scheduler knows that a machine is lost.
    pub notice: f64,
    /// Tasks that the scheduler begins in a second.
    pub dispatched: f64,
    /// True if whole frames of a lost task are kept.
    pub keeps_frames: bool,
}

impl Default for FarmSettings {
    fn default() -> Self {
        Self {
            frames: 10_000,
            chunk: 10,
            workers: 1000,
            frame: 60.0,
            start: 5.0,
            shaders: 20.0,
            check: 0.05,
            between_failures: 8.0 * 3600.0,
            repair: 600.0,
            notice: 60.0,
            dispatched: 20.0,
            keeps_frames: true,
        }
    }
}

/// Figures of a simulated farm. Times in seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FarmFigures {
    /// Time from the first task to the last frame.
    pub duration: f64,
    /// Share of all machines' time that went into frames that counted.
    pub useful: f64,
    /// Tasks that were begun.
    pub tasks: usize,
    /// Machines that were lost in the middle of a task.
    pub losses: usize,
    /// Time of machines that was lost with them, in frames that had to be drawn again.
    pub lost: f64,
    /// Most times that one chunk was begun.
    pub most_attempts: usize,
}

/// Event of the farm, at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Event {
    /// A machine is free.
    Free { worker: usize },
    /// The scheduler knows that a chunk's machine is lost.
    Returned { chunk: usize },
}

/// Work that is left of a chunk.
#[derive(Clone, Copy, Debug)]
struct Chunk {
    first: usize,
    count: usize,
    /// Frames that are whole.
    whole: usize,
    attempts: usize,
}

/// Runs the farm until every frame is whole.
pub fn simulate(settings: FarmSettings) -> FarmFigures {
    let mut figures = FarmFigures::default();
    let (frames, length) = (settings.frames, settings.chunk.max(1));
    let mut chunks: Vec<Chunk> = (0..frames)
        .step_by(length)
        .map(|first| {
            let count = length.min(frames - first);
            Chunk { first, count, whole: 0, attempts: 0 }
        })
        .collect();
    let mut waiting: VecDeque<usize> = (0..chunks.len()).collect();
    let mut idle: VecDeque<usize> = (0..settings.workers.max(1)).collect();
    let mut has_shaders = vec![false; settings.workers.max(1)];
    let mut events: BinaryHeap<Reverse<(u64, Event)>> = BinaryHeap::new();
    let mut numbers = Numbers(1);
    let (mut now, mut scheduler_free, mut useful) = (0.0_f64, 0.0_f64, 0.0);
    loop {
        while !waiting.is_empty() && !idle.is_empty() {
            let (Some(at), Some(worker)) = (waiting.pop_front(), idle.pop_front()) else { break };
            // The scheduler begins one task after another.
            scheduler_free = scheduler_free.max(now) + 1.0 / settings.dispatched.max(1e-9);
            let begun = scheduler_free;
            let chunk = &mut chunks[at];
            (figures.tasks, chunk.attempts) = (figures.tasks + 1, chunk.attempts + 1);
            figures.most_attempts = figures.most_attempts.max(chunk.attempts);
            let lost_at = begun - settings.between_failures * numbers.share().ln();
            let mut time = begun + settings.start + settings.check * chunk.whole as f64;
            if !has_shaders[worker] {
                time += settings.shaders;
                has_shaders[worker] = time <= lost_at;
            }
            let ready = time;
            let mut drawn = 0;
            for frame in chunk.first + chunk.whole..chunk.first + chunk.count {
                let next = time + duration_of(frame, settings.frame);
                if next > lost_at {
                    break;
                }
                (time, drawn) = (next, drawn + 1);
            }
            if chunk.whole + drawn == chunk.count {
                chunk.whole = chunk.count;
                useful += time - ready;
                figures.duration = figures.duration.max(time);
                events.push(Reverse((ticks(time), Event::Free { worker })));
                continue;
            }
            figures.losses += 1;
            if settings.keeps_frames {
                chunk.whole += drawn;
                useful += time - ready;
                figures.lost += (lost_at - time.max(ready)).max(0.0);
            } else {
                figures.lost += (lost_at - ready).max(0.0);
            }
            events.push(Reverse((ticks(lost_at + settings.notice), Event::Returned { chunk: at })));
            events.push(Reverse((ticks(lost_at + settings.repair), Event::Free { worker })));
        }
        let Some(Reverse((ticks, event))) = events.pop() else { break };
        now = ticks as f64 / TICKS;
        match event {
            Event::Free { worker } => idle.push_back(worker),
            Event::Returned { chunk } => waiting.push_back(chunk),
        }
    }
    let machines = settings.workers.max(1) as f64 * figures.duration;
    figures.useful = if machines > 0.0 { useful / machines } else { 0.0 };
    figures
}

/// Steps of time in a second: events are sorted by whole numbers.
const TICKS: f64 = 1e6;

fn ticks(seconds: f64) -> u64 {
    (seconds * TICKS) as u64
}

/// Time of a frame, the same in every attempt: from half of the mean to one and a half.
fn duration_of(frame: usize, mean: f64) -> f64 {
    mean * (0.5 + Numbers(frame as u64 + 0x5eed).share())
}

/// Random numbers by their place alone (SplitMix64).
struct Numbers(u64);

impl Numbers {
    /// A number above 0 and at most 1.
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^= x >> 31;
        ((x >> 11) + 1) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_farm_without_failures_takes_as_long_as_its_chunks() {
        let settings = FarmSettings {
            between_failures: f64::INFINITY,
            dispatched: 1e9,
            shaders: 0.0,
            start: 0.0,
            ..FarmSettings::default()
        };
        let figures = simulate(settings);
        assert_eq!((figures.tasks, figures.losses, figures.most_attempts), (1000, 0, 1));
        // A chunk of 10 frames takes 600 s in the mean; the longest one bounds the farm.
        assert!((600.0..900.0).contains(&figures.duration), "{figures:?}");
        let alone = simulate(FarmSettings { workers: 1, ..settings });
        assert!((alone.duration / 600_000.0 - 1.0).abs() < 0.02, "{alone:?}");
        assert!(alone.useful > 0.99 && alone.useful < 1.0001, "{alone:?}");
    }

    #[test]
    fn every_frame_becomes_whole_on_machines_that_fail_and_less_is_lost_where_frames_are_kept() {
        let hard = FarmSettings { between_failures: 900.0, ..FarmSettings::default() };
        let kept = simulate(hard);
        let whole = simulate(FarmSettings { keeps_frames: false, ..hard });
        assert!(kept.losses > 100 && kept.tasks == 1000 + kept.losses, "{kept:?}");
        assert!(kept.lost < whole.lost / 3.0, "{kept:?} {whole:?}");
        assert!(kept.duration < whole.duration, "{kept:?} {whole:?}");
        assert_eq!(simulate(hard), kept, "the same settings, the same figures");
        let nothing = simulate(FarmSettings { frames: 0, ..hard });
        assert_eq!((nothing.tasks, nothing.duration), (0, 0.0));
    }
}
