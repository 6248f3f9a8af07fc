//! Time from the handing over of a picture to the end of the GPU's work on it, found on a thread of
//! its own, so that neither the window nor the next picture waits.

use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use crate::clock::Clock;
use crate::render::Gpu;
use crate::state::revision::RequestNumber;
use crate::state::worker::Worker;

/// Time between two questions whether the GPU is done, and the greatest number of them.
const STEP: Duration = Duration::from_millis(1);
const MOST_STEPS: u32 = 20_000;

/// Work of the GPU that is being timed.
pub(super) struct TimedWork(Receiver<f64>);

impl TimedWork {
    /// All work that was handed to the GPU so far, from the start of a clock.
    pub(super) fn since(clock: Clock, gpu: &Gpu) -> Self {
        let (sender, receiver) = channel();
        gpu.queue.on_submitted_work_done(move || {
            // Nobody may be waiting any more.
            let _ = sender.send(clock.seconds());
        });
        Self(receiver)
    }

    /// Waits until the work is done. Gives its time in seconds; `None` where the device is lost.
    fn seconds(&self, device: &wgpu::Device) -> Option<f64> {
        for _ in 0..MOST_STEPS {
            let _ = device.poll(wgpu::PollType::Poll);
            match self.0.recv_timeout(STEP) {
                Ok(seconds) => return Some(seconds),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return None,
            }
        }
        None
    }
}

/// Thread that waits for the GPU's work on pictures.
pub(super) struct Stopwatch {
    worker: Worker<(RequestNumber, TimedWork), (RequestNumber, Option<f64>)>,
}

impl Stopwatch {
    /// `wake` is called from another thread when a time is known.
    pub(super) fn new(device: wgpu::Device, wake: impl Fn() + Send + 'static) -> Self {
        let work =
            move |(number, work): (RequestNumber, TimedWork)| (number, work.seconds(&device));
        Self { worker: Worker::new("stopwatch", wake, work) }
    }

    /// Times the work on a picture, in place of one that still waits to be timed.
    pub(super) fn time(&self, picture: RequestNumber, work: TimedWork) {
        self.worker.request(|_| (picture, work));
    }

    /// Times in seconds that were found since the last call, each with its picture's number.
    pub(super) fn times(&self) -> impl Iterator<Item = (RequestNumber, f64)> + use<> {
        let answers = self.worker.answers().into_iter();
        answers.filter_map(|(number, seconds)| Some((number, seconds?)))
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}
