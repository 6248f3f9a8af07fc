//! A look on a flat tile, as every eye of a grid sees it under every light: the samples to evaluate for an HCBTF of it.

use std::sync::Arc;

use glam::{DMat3, DQuat, DVec2, DVec3};
use indexmap::IndexMap;

use super::assets::Assets;
use super::samples::{EvalBatch, EvalSample, LightOverride, eval_batches};
use super::setup::SetupLook;
use crate::compile::Options;
use crate::diag::Diagnostic;
use crate::document::{Address, ColorSpace, Direction, Directions, Grid, LightKind, LightSpace, Tile, linear_to_srgb};
use crate::hcbtf::Progress;
use crate::ids::LightId;
use crate::library::Library;

/// The light that goes around the tile: the one of this name, or the first directional one.
///
/// # Errors
/// Where there is none that shines along one direction: the grid knows directions alone.
pub fn moving_light(setup: &SetupLook, name: Option<&str>) -> Result<LightId, Diagnostic> {
    let lights = &setup.look.lights;
    let is_moving = |kind: LightKind| kind == LightKind::Directional;
    match name {
        None => lights.iter().find(|(_, light)| is_moving(light.kind)).map(|(id, _)| id.clone()).ok_or_else(|| {
            let problem =
                Diagnostic::error("no-light", "the look has no directional light that could go around the tile");
            problem.hint("add one to its lights")
        }),
        Some(name) => match lights.iter().find(|(id, _)| id.as_str() == name) {
            Some((id, light)) if is_moving(light.kind) => Ok(id.clone()),
            Some(_) => {
                let problem = Diagnostic::error("bad-argument", format!("the light `{name}` is not directional"));
                Err(problem.hint("the grid knows directions alone"))
            }
            None => {
                let problem = Diagnostic::error("bad-argument", format!("the look has no light `{name}`"));
                Err(problem.suggest(name, lights.keys().map(AsRef::as_ref)))
            }
        },
    }
}

/// Reads and fills whatever a look names, once for all views of a tile. `progress` counts how far its HCBTFs are filled, one
/// after the other.
///
/// # Errors
/// Everything that is wrong with the look, and where it is stopped.
pub fn tile_assets(
    setup: &SetupLook,
    library: &Library,
    light: &LightId,
    mut assets: Assets,
    progress: &Arc<Progress>,
) -> Result<Assets, Vec<Diagnostic>> {
    let one = Directions { theta: 1, phi: 1 };
    let grid = Grid { size: [1, 1], light: one, view: one };
    assets.watch(Some(progress.clone()));
    tile_batches(setup, library, &grid, light, Direction::default(), &mut assets)?;
    assets.watch(None);
    Ok(assets)
}

/// What is to be evaluated for all lights of a view: for each light in the grid's order the texels of a tile, rows from the
/// top. The tile lies at z = 0 with its middle at the origin, as wide as 1, u along x and v along y; the camera is far away,
/// its right and up turned from u and v as the view is from the normal. Other lights than `light` stay where they are.
///
/// # Errors
/// Everything that is wrong with the look.
pub fn tile_batches(
    setup: &SetupLook,
    library: &Library,
    grid: &Grid,
    light: &LightId,
    view: Direction,
    assets: &mut Assets,
) -> Result<Vec<EvalBatch>, Vec<Diagnostic>> {
    let toward_eye = grid.view.vector(view);
    let turn = DQuat::from_rotation_arc(DVec3::Z, toward_eye);
    let camera = DMat3::from_cols(turn * DVec3::X, turn * DVec3::Y, toward_eye).transpose();
    let space = setup.look.lights.get(light).map(|light| light.space).unwrap_or_default();
    let [width, height] = grid.size;
    let mut samples = Vec::with_capacity(grid.texels() * grid.light.distinct().count());
    for direction in grid.light.distinct() {
        let toward_light = grid.light.vector(direction);
        let direction = if space == LightSpace::Camera { camera * toward_light } else { toward_light };
        let moved = LightOverride { direction: Some(direction), ..LightOverride::default() };
        let lights = IndexMap::from([(light.clone(), moved)]);
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let uv =
                DVec2::new((f64::from(x) + 0.5) / f64::from(width), 1.0 - (f64::from(y) + 0.5) / f64::from(height));
            let aspect = f64::from(height) / f64::from(width);
            samples.push(EvalSample {
                normal: DVec3::Z,
                tangent: Some(DVec3::X),
                view: toward_eye,
                position: DVec3::new(uv.x - 0.5, (uv.y - 0.5) * aspect, 0.0),
                camera,
                uv,
                lights: lights.clone(),
                ..EvalSample::default()
            });
        }
    }
    eval_batches(setup, library, &samples, &Options::default(), assets)
}

/// The tiles of a view by their lights, from what [`tile_batches`] evaluates to, in its order.
pub fn tiles_of(setup: &SetupLook, grid: &Grid, view: Direction, values: &[[f64; 4]]) -> Vec<(Address, Tile)> {
    let is_linear = setup.look.color_space == ColorSpace::Linear;
    let byte = |(channel, value): (usize, f64)| {
        let shown = if is_linear && channel < 3 { linear_to_srgb(value) } else { value };
        (255.0 * shown.clamp(0.0, 1.0)).round() as u8
    };
    let tile = |(light, texels): (Direction, &[[f64; 4]])| {
        let rgba = texels.iter().flat_map(|texel| texel.iter().copied().enumerate().map(byte)).collect();
        Some((Address { view, light }.canonical(), Tile::new(grid.size, rgba)?))
    };
    grid.light.distinct().zip(values.chunks_exact(grid.texels().max(1))).filter_map(tile).collect()
}
