//! Surface under a pixel, and the light that is placed by it; runs on the tool's thread.

use chiaro_locale::tr;
use glam::DVec3;

use crate::diag::Diagnostic;
use crate::document::Light;
use crate::placing::{Parametrization, PlacedLight, PlacingGoal, place_light};
use crate::progress::Progress;
use crate::state::problem_text::sentence;
use crate::state::snapshot::{CachedPlanner, RenderSnapshot};
use crate::tools::surface::{ReadSurface, read_surface};

/// Mark of a light as it is asked for at a point.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum WantedMark {
    /// An angle of a parametrization, in radians, before a warp of this slope and amount.
    Angle { parametrization: Parametrization, angle: f64, warp: Option<(f64, f64)> },
    /// The shadow of this point, in world space.
    Shadow(DVec3),
}

/// Work at a pixel.
#[derive(Clone, Debug)]
pub(super) enum PlacingTask {
    /// Reads the point that is to cast a shadow.
    Caster,
    /// Places a light.
    Place(Box<Light>, WantedMark),
}

pub(super) struct PlacingRequest {
    /// Number of the press that asks.
    pub(super) number: u64,
    pub(super) pixel: [u32; 2],
    /// Size of the picture, in pixels.
    pub(super) size: [u32; 2],
    pub(super) snapshot: RenderSnapshot,
    pub(super) task: PlacingTask,
    pub(super) progress: Progress,
}

/// Result of a task.
pub(super) enum SurfaceAnswer {
    Caster(DVec3),
    Placed(Box<PlacedLight>),
}

pub(super) struct PlacingAnswer {
    pub(super) number: u64,
    /// The result, or the reason why there is none, as a sentence without its end.
    pub(super) found: Result<SurfaceAnswer, String>,
}

/// Carries out a request.
pub(super) fn place(planner: &mut CachedPlanner, request: &PlacingRequest) -> PlacingAnswer {
    let number = request.number;
    let found = match read(planner, request) {
        Err(problems) => Err(problems.first().map_or_else(String::new, sentence)),
        Ok(None) => Err(tr!("Nothing is there: click on the model").to_owned()),
        Ok(Some(surface)) => match &request.task {
            PlacingTask::Caster => Ok(SurfaceAnswer::Caster(surface.seen.point.position)),
            PlacingTask::Place(light, wanted) => placed(&surface, light, wanted),
        },
    };
    PlacingAnswer { number, found }
}

fn placed(
    ReadSurface { seen, frames }: &ReadSurface,
    light: &Light,
    wanted: &WantedMark,
) -> Result<SurfaceAnswer, String> {
    let goal = match *wanted {
        WantedMark::Shadow(caster) => PlacingGoal::Shadow(caster),
        WantedMark::Angle { parametrization, angle, warp } => {
            // The profile sees the angle less the warp (docs/math.md 1.3 and 3.1).
            let warp = warp.map_or(0.0, |(slope, amount)| (seen.kappa * slope).tanh() * amount);
            let angle = angle + warp;
            if !(0.0..=std::f64::consts::PI).contains(&angle) {
                return Err(tr!("Curvature moves that place out of the profile's reach").to_owned());
            }
            PlacingGoal::Angle(parametrization, angle)
        }
    };
    let placed = place_light(light, frames, &seen.point, &goal);
    placed.map(|placed| SurfaceAnswer::Placed(Box::new(placed))).map_err(|why| why.words().into())
}

/// Reads the surface at the pixel of a request.
fn read(
    planner: &mut CachedPlanner,
    PlacingRequest { pixel, size, snapshot, task, progress, .. }: &PlacingRequest,
) -> Result<Option<ReadSurface>, Vec<Diagnostic>> {
    let with_kappa = matches!(task, PlacingTask::Place(_, WantedMark::Angle { warp: Some(_), .. }));
    read_surface(planner, snapshot, (*pixel, *size), with_kappa, progress)
}
