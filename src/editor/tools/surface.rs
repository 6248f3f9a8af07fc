//! Surface under a pixel of the picture, with the frames that lights there are given in; read by
//! the reference, on the threads of tools.

use std::sync::{Arc, LazyLock};

use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::{LightFrames, Look};
use crate::frame::{PlanOptions, SetupObject};
use crate::progress::Progress;
use crate::reference::{ProbedSurface, probe_surface, surface_look, surface_setup};
use crate::state::snapshot::{CachedPlanner, RenderSnapshot};

/// Looks that hand on what a surface is, without curvature and with it.
static LOOKS: LazyLock<[Arc<Look>; 2]> =
    LazyLock::new(|| [false, true].map(|with_kappa| Arc::new(surface_look(with_kappa).clone())));

/// Surface that was read at a pixel.
pub(super) struct ReadSurface {
    pub(super) seen: ProbedSurface,
    /// Frames that lights of the object there are given in.
    pub(super) frames: LightFrames,
}

/// Reads the surface at a pixel of a picture of a size; `None` where nothing is drawn.
pub(super) fn read_surface(
    planner: &mut CachedPlanner,
    snapshot: &RenderSnapshot,
    (pixel, size): ([u32; 2], [u32; 2]),
    with_kappa: bool,
    progress: &Progress,
) -> Result<Option<ReadSurface>, Vec<Diagnostic>> {
    let planner = planner.of(&LOOKS[usize::from(with_kappa)], &snapshot.library);
    let setup = snapshot.setup(&mut planner.assets)?.value;
    let bare = surface_setup(&setup, with_kappa);
    let options = PlanOptions { size, samples: 1, time: snapshot.time };
    let plan = planner.plan(&bare, &snapshot.library, &Live::All, &options)?.value;
    let seen = probe_surface(&plan, pixel, progress).map_err(|problem| vec![problem])?;
    let Some(seen) = seen else { return Ok(None) };
    let own = plan.draws.get(seen.draw).map(|draw| &draw.object);
    let object = setup.objects.iter().find(|object| Some(&object.id) == own);
    let own = object.map(SetupObject::frame).unwrap_or_default();
    // The lights, and what they are aimed at, are those of the setup with its own looks.
    let frames = setup.light_frames(&plan.view, own, &setup.aims());
    Ok(Some(ReadSurface { seen, frames }))
}
