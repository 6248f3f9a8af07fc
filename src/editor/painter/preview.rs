//! Preview of a look baked to a tile: a sample under two lights, baked on a thread before all
//! samples are, and an estimate of the time that all will take, by the time of these two.

use std::sync::Arc;

use chiaro_locale::tr;

use super::textures::TileTexture;
use crate::clock::Clock;
use crate::diag::Diagnostic;
use crate::document::{Address, Directions, Grid, Tile};
use crate::frame::{AssetStore, Assets, Overlay, SetupLook, tile_assets};
use crate::ids::LightId;
use crate::library::Library;
use crate::progress::Progress;
use crate::reference::bake_look;
use crate::state::revision::{DocumentNumber, MeaningRevision, PaintingRevision};
use crate::state::worker::Worker;

/// Largest side of a preview, in texels: it should be there at once.
const MOST_SIDE: u32 = 96;

/// Lights of the preview: straight above, halfway down and at the horizon.
const LIGHTS: Directions = Directions { theta: 3, phi: 1 };

/// Inputs of a preview: any change makes another picture.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PreviewInputs {
    /// Look's document, the revision of its meaning, and that of the painting.
    pub(super) look: (DocumentNumber, MeaningRevision, Option<PaintingRevision>),
    pub(super) size: [u32; 2],
    pub(super) light: LightId,
}

/// Look to bake.
pub(super) struct PreviewRequest {
    pub(super) setup: SetupLook,
    pub(super) library: Arc<Library>,
    pub(super) painting: Option<Overlay>,
    /// Assets that all pictures of the window share.
    pub(super) assets: AssetStore,
}

/// Samples seen from straight above, under a light straight above and one halfway down.
pub(super) struct PreviewTiles {
    pub(super) tiles: [Arc<Tile>; 2],
    /// Time per texel of a sample on one core, in seconds.
    seconds: f64,
}

struct PreviewResult {
    of: PreviewInputs,
    made: Result<PreviewTiles, Diagnostic>,
}

/// Thread that makes previews, and its last result.
pub(super) struct Preview {
    worker: Worker<(PreviewInputs, PreviewRequest, Progress), PreviewResult>,
    asked: Option<PreviewInputs>,
    progress: Progress,
    done: Option<PreviewResult>,
    pub(super) shown: [TileTexture; 2],
}

impl Preview {
    /// `wake` is called from another thread when there is a new preview.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let work = |(of, job, progress): (PreviewInputs, PreviewRequest, Progress)| PreviewResult {
            made: job.done(&of, &progress),
            of,
        };
        Self {
            worker: Worker::new("preview of a bake", wake, work),
            asked: None,
            progress: Progress::new(),
            done: None,
            shown: Default::default(),
        }
    }

    /// Preview for the inputs `of`, once it is made; requests the preview where it is missing.
    pub(super) fn of(
        &mut self,
        of: &PreviewInputs,
        job: impl FnOnce() -> PreviewRequest,
    ) -> Option<&Result<PreviewTiles, Diagnostic>> {
        self.done = self.worker.answers().pop().or(self.done.take());
        if self.asked.as_ref() != Some(of) {
            self.progress.stop();
            self.progress = Progress::new();
            self.asked = Some(of.clone());
            let request = (of.clone(), job(), self.progress.clone());
            self.worker.request(|_| request);
        }
        self.done.as_ref().filter(|done| done.of == *of).map(|done| &done.made)
    }

    /// Stops the preview and drops its result, as no dialog asks for it any more.
    pub(super) fn stop(&mut self) {
        self.progress.stop();
        (self.asked, self.done) = (None, None);
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

impl Drop for Preview {
    fn drop(&mut self) {
        self.progress.stop();
    }
}

impl PreviewTiles {
    /// Seconds that all samples of a grid will take, with as many views at a time as there are
    /// cores.
    pub(super) fn seconds_of(&self, grid: &Grid, cores: usize) -> f64 {
        let views = grid.view.distinct_count() as f64;
        let turns = (views / cores.max(1) as f64).ceil();
        self.seconds * turns * grid.light.distinct_count() as f64 * grid.texels() as f64
    }
}

impl PreviewRequest {
    fn done(self, of: &PreviewInputs, progress: &Progress) -> Result<PreviewTiles, Diagnostic> {
        let first = |problems: Vec<Diagnostic>| {
            problems
                .into_iter()
                .next()
                .unwrap_or_else(|| Diagnostic::error("stopped", tr!("it was stopped")))
        };
        let Self { setup, library, painting, assets } = self;
        let mut assets = Assets::of(&assets);
        assets.overlay(painting);
        let assets = tile_assets(&setup, &library, &of.light, assets, progress).map_err(first)?;
        let grid =
            Grid { size: reduced(of.size), light: LIGHTS, view: Directions { theta: 1, phi: 1 } };
        let clock = Clock::start();
        let hcbtf =
            bake_look(&setup, &library, grid, &of.light, &assets, progress).map_err(first)?;
        let samples = (grid.texels() as u64 * grid.sample_count()) as f64;
        let tile = |ring| hcbtf.painted(Address::new([ring, 0], [0, 0])).cloned();
        let none = || Arc::new(Tile::filled(grid.size, [0; 4]));
        let tiles = [0, 1].map(|ring| tile(ring).unwrap_or_else(none));
        Ok(PreviewTiles { tiles, seconds: clock.seconds() / samples })
    }
}

/// Size of a tile, reduced in the same proportions to at most `MOST_SIDE`.
fn reduced(size: [u32; 2]) -> [u32; 2] {
    let longer = size[0].max(size[1]);
    match longer > MOST_SIDE {
        true => size
            .map(|side| (u64::from(side) * u64::from(MOST_SIDE) / u64::from(longer)).max(1) as u32),
        false => size,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_tiles_keep_their_shape_and_time_grows_with_samples() {
        assert_eq!(reduced([32, 48]), [32, 48]);
        assert_eq!(reduced([1024, 512]), [96, 48]);
        assert_eq!(reduced([4000, 1]), [96, 1]);
        let tile = Arc::new(Tile::filled([1, 1], [0; 4]));
        let seen = PreviewTiles { tiles: [tile.clone(), tile], seconds: 1e-6 };
        // The grid has 51 views of 51 lights of 32 x 32 texels: 51 turns on one core, 13 on four.
        let one = seen.seconds_of(&Grid::THESIS, 1);
        assert!((one - 51.0 * 51.0 * 1024.0 * 1e-6).abs() < 1e-9, "{one}");
        assert!((seen.seconds_of(&Grid::THESIS, 4) / one - 13.0 / 51.0).abs() < 1e-9);
    }
}
