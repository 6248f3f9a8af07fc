//! Surface under a pixel: where it is, its normal and its curvature, as shaders see them.
//!
//! The probe reads them from a look that does nothing but hand them on. So they agree to the last
//! digit with what any other look computes at that pixel, passes of curvature included.

use std::sync::LazyLock;

use glam::DVec3;

use super::options::ReferenceOptions;
use super::probe::probe;
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::frame::{FramePlan, Setup};
use crate::interp::Precision;
use crate::placing::SurfacePoint;
use crate::progress::Progress;

/// Look whose wires are the surface's position and normal.
const PLAIN: &str = r#"{
    "nodes": [{"id": "position", "kind": "position"}, {"id": "normal", "kind": "normal"},
        {"id": "along", "kind": "dot_product"}, {"id": "output", "kind": "output"}],
    "wires": [{"from": "position", "to": "along.a"}, {"from": "normal", "to": "along.b"},
        {"from": "along", "to": "output.color"}]}"#;

/// The same with the surface's curvature.
const CURVED: &str = r#"{
    "nodes": [{"id": "position", "kind": "position"}, {"id": "normal", "kind": "normal"},
        {"id": "along", "kind": "dot_product"}, {"id": "kappa", "kind": "kappa"},
        {"id": "scaled", "kind": "multiply"}, {"id": "output", "kind": "output"}],
    "wires": [{"from": "position", "to": "along.a"}, {"from": "normal", "to": "along.b"},
        {"from": "along", "to": "scaled.a"}, {"from": "kappa", "to": "scaled.b"},
        {"from": "scaled", "to": "output.color"}]}"#;

static LOOKS: LazyLock<[Look; 2]> = LazyLock::new(|| {
    [PLAIN, CURVED].map(|text| Look::read(text, "surface").value.unwrap_or_default())
});

/// Surface that was read at a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbedSurface {
    /// Index, in the plan, of the draw that the pixel shows.
    pub draw: usize,
    /// The point of the surface.
    pub point: SurfacePoint,
    /// Curvature in 1/viewport-height, convex positive; 0 where it was not asked for.
    pub kappa: f64,
}

/// Look that hands on what a surface is, with its curvature or without.
pub fn surface_look(with_kappa: bool) -> &'static Look {
    &LOOKS[usize::from(with_kappa)]
}

/// The scene with every look replaced by [`surface_look`]; plans of it are for [`probe_surface`].
#[must_use]
pub fn surface_setup(setup: &Setup, with_kappa: bool) -> Setup {
    let mut setup = setup.clone();
    setup.looks.iter_mut().for_each(|worn| worn.look = surface_look(with_kappa).clone());
    setup.objects.iter_mut().for_each(|object| object.values.clear());
    setup.scene.lights.clear();
    setup.scene.light_groups.clear();
    setup.edited = None;
    setup
}

/// The surface at a pixel, by a plan of [`surface_setup`]; `None` where nothing is drawn.
///
/// # Errors
/// As [`probe`].
pub fn probe_surface(
    plan: &FramePlan,
    pixel: [u32; 2],
    progress: &Progress,
) -> Result<Option<ProbedSurface>, Diagnostic> {
    let fragment = probe(plan, pixel, Precision::F64, &ReferenceOptions::default(), progress)?;
    let Some(fragment) = fragment else { return Ok(None) };
    let Some(draw) = plan.draws.get(fragment.draw) else { return Ok(None) };
    let numbers = |node: &str| {
        let mut of_node = fragment.values.iter().rev().filter(|value| {
            let path = draw.look.spans.node_at(value.span.start);
            path.is_some_and(|path| path.to_string() == node)
        });
        of_node.next().map(|value| value.numbers.as_slice())
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
    Ok(Some(ProbedSurface { draw: fragment.draw, point, kappa }))
}
