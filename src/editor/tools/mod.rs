//! Tools of the picture: the probe, the comparison and painted light.

pub(crate) mod fitting;
pub(crate) mod probe;
pub(crate) mod wipe;

use crate::render::Gpu;
use crate::state::worker::BackgroundJobs;
use fitting::Fitting;
use probe::Probe;
use wipe::Wipe;

/// The tools of the picture, and what they remember.
pub(crate) struct PictureTools {
    pub(crate) probe: Probe,
    pub(crate) wipe: Wipe,
    pub(crate) fitting: Fitting,
}

impl PictureTools {
    /// `wake` is called from other threads when there is news.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Clone + Send + Sync + 'static) -> Self {
        Self {
            probe: Probe::new(wake.clone()),
            wipe: Wipe::new(gpu, wake.clone()),
            fitting: Fitting::new(wake),
        }
    }

    fn all(&self) -> [&dyn BackgroundJobs; 3] {
        [&self.probe, &self.wipe, &self.fitting]
    }
}

impl BackgroundJobs for PictureTools {
    fn is_busy(&self) -> bool {
        self.all().iter().any(|tool| tool.is_busy())
    }

    fn wait(&self) {
        self.all().iter().for_each(|tool| tool.wait());
    }
}
