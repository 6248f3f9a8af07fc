//! Surface under a pixel, and the light that is placed by it; runs on the tool's thread.
//!
//! The surface is read by the probe itself, from a look that does nothing but hand on where the
//! surface is, its normal and its curvature: what the probe then reads of the placed light agrees
//! to the last digits, curvature passes included.

use std::sync::{Arc, LazyLock};

use glam::{DQuat, DVec3};

use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::{Light, LightFrames, Look, ObjectFrame};
use crate::frame::{PlanOptions, Setup};
use crate::interp::Precision;
use crate::placing::{Parametrization, PlacedLight, PlacingGoal, SurfacePoint, place_light};
use crate::progress::Progress;
use crate::reference::{ReferenceOptions, probe};
use crate::state::problem_text::sentence;
use crate::state::snapshot::{CachedPlanner, RenderSnapshot};

/// Look whose wires are the surface's position and normal; the second one has curvature too.
static SURFACE_LOOKS: LazyLock<[Arc<Look>; 2]> = LazyLock::new(|| {
    let look = |scaled_by: &str| {
        let text = format!(
            r#"{{"nodes": [
                {{"id": "position", "kind": "position"}}, {{"id": "normal", "kind": "normal"}},
                {{"id": "along", "kind": "dot_product"}}, {scaled_by}
                {{"id": "output", "kind": "output"}}],
            "wires": [{{"from": "position", "to": "along.a"}},
                {{"from": "normal", "to": "along.b"}}, {}]}}"#,
            if scaled_by.is_empty() {
                r#"{"from": "along", "to": "output.color"}"#
            } else {
                r#"{"from": "along", "to": "scaled.a"}, {"from": "kappa", "to": "scaled.b"},
                {"from": "scaled", "to": "output.color"}"#
            }
        );
        Arc::new(Look::read(&text, "surface").value.unwrap_or_default())
    };
    let kappa = r#"{"id": "kappa", "kind": "kappa"}, {"id": "scaled", "kind": "multiply"},"#;
    [look(""), look(kappa)]
});

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

/// Surface that was read at a pixel.
struct ReadSurface {
    point: SurfacePoint,
    /// Curvature in 1/viewport-height; 0 where it was not asked for.
    kappa: f64,
    frames: LightFrames,
}

/// Carries out a request.
pub(super) fn place(planner: &mut CachedPlanner, request: PlacingRequest) -> PlacingAnswer {
    let number = request.number;
    let found = match read(planner, &request) {
        Err(problems) => Err(problems.first().map_or_else(String::new, sentence)),
        Ok(None) => Err("Nothing is there: click on the model".to_owned()),
        Ok(Some(surface)) => match &request.task {
            PlacingTask::Caster => Ok(SurfaceAnswer::Caster(surface.point.position)),
            PlacingTask::Place(light, wanted) => placed(&surface, light, wanted),
        },
    };
    PlacingAnswer { number, found }
}

fn placed(
    ReadSurface { point, kappa, frames }: &ReadSurface,
    light: &Light,
    wanted: &WantedMark,
) -> Result<SurfaceAnswer, String> {
    let goal = match *wanted {
        WantedMark::Shadow(caster) => PlacingGoal::Shadow(caster),
        WantedMark::Angle { parametrization, angle, warp } => {
            // The profile sees the angle less the warp (docs/math.md 1.3 and 3.1).
            let warp = warp.map_or(0.0, |(slope, amount)| (kappa * slope).tanh() * amount);
            let angle = angle + warp;
            if !(0.0..=std::f64::consts::PI).contains(&angle) {
                return Err("Curvature moves that place out of the profile's reach".to_owned());
            }
            PlacingGoal::Angle(parametrization, angle)
        }
    };
    let placed = place_light(light, frames, point, &goal);
    placed.map(|placed| SurfaceAnswer::Placed(Box::new(placed))).map_err(|why| why.words().into())
}

/// Reads the surface at the pixel; `None` where nothing is drawn.
fn read(
    planner: &mut CachedPlanner,
    PlacingRequest { pixel, size, snapshot, task, progress, .. }: &PlacingRequest,
) -> Result<Option<ReadSurface>, Vec<Diagnostic>> {
    let wants_kappa =
        matches!(task, PlacingTask::Place(_, WantedMark::Angle { warp: Some(_), .. }));
    let look = &SURFACE_LOOKS[usize::from(wants_kappa)];
    let planner = planner.of(look, &snapshot.library);
    let mut setup = snapshot.setup(&mut planner.assets)?.value;
    setup.looks.iter_mut().for_each(|worn| worn.look = (**look).clone());
    setup.objects.iter_mut().for_each(|object| object.values.clear());
    setup.scene.lights.clear();
    let options = PlanOptions { size: *size, samples: 1, time: snapshot.time };
    let plan = planner.plan(&setup, &snapshot.library, &Live::All, &options)?.value;
    let reference = ReferenceOptions::default();
    let fragment = probe(&plan, *pixel, Precision::F64, &reference, progress);
    let Some(fragment) = fragment.map_err(|problem| vec![problem])? else { return Ok(None) };
    let Some(draw) = plan.draws.get(fragment.draw) else { return Ok(None) };
    let numbers = |node: &str| {
        let of_node = fragment.values.iter().filter(|value| {
            let path = draw.look.spans.node_at(value.span.start);
            path.is_some_and(|path| path.to_string() == node)
        });
        of_node.last().map(|value| value.numbers.as_slice())
    };
    let vector = |node: &str| numbers(node).and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
    let (Some(position), Some(normal)) = (vector("position"), vector("normal")) else {
        return Ok(None);
    };
    let position = DVec3::from(position);
    let point = SurfacePoint {
        position,
        normal: DVec3::from(normal).try_normalize().unwrap_or(DVec3::Z),
        toward_eye: plan.view.toward_viewer(position),
        camera_from_world: plan.view.rotation(),
    };
    let kappa = numbers("kappa").and_then(|numbers| numbers.first().copied()).unwrap_or(0.0);
    let object = setup.objects.iter().find(|object| object.id == draw.object);
    let object = object.map_or_else(ObjectFrame::default, |object| {
        ObjectFrame::new(object.center(), object.world_from_object)
    });
    let frames = LightFrames {
        illumination: illumination(&setup),
        camera_from_world: point.camera_from_world,
        object,
    };
    Ok(Some(ReadSurface { point, kappa, frames }))
}

/// Rotation from the illumination frame to world space.
fn illumination(setup: &Setup) -> DQuat {
    DQuat::from_array(setup.scene.illumination).normalize()
}
