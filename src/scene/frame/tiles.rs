//! A look on a flat tile, as every eye of a grid sees it under every light: the samples to evaluate
//! for an HCBTF of it.

use chiaro_locale::tr;
use glam::{DMat3, DQuat, DVec2, DVec3};
use indexmap::IndexMap;

use super::assets::Assets;
use super::samples::{EvalSample, Evaluable, LightOverride};
use super::setup::SetupLook;
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, LightKind, LightSpace};
use crate::ids::LightId;
use crate::library::Library;
use crate::progress::Progress;

/// The light that moves around the tile: the light with this name, or the first directional one.
///
/// # Errors
/// Where no such light shines along one direction: the grid knows directions only.
pub fn moving_light(setup: &SetupLook, name: Option<&str>) -> Result<LightId, Diagnostic> {
    let lights = &setup.look.lights;
    let is_moving = |kind: LightKind| kind == LightKind::Directional;
    match name {
        None => lights
            .iter()
            .find(|(_, light)| is_moving(light.kind))
            .map(|(id, _)| id.clone())
            .ok_or_else(|| {
                let problem = Diagnostic::error(
                    "no-light",
                    tr!("the look has no directional light that could go around the tile"),
                );
                problem.hint(tr!("add one to its lights"))
            }),
        Some(name) => match lights.iter().find(|(id, _)| id.as_str() == name) {
            Some((id, light)) if is_moving(light.kind) => Ok(id.clone()),
            Some(_) => {
                let problem =
                    Diagnostic::error("bad-argument", tr!("the light `{name}` is not directional"));
                Err(problem.hint(tr!("the grid knows directions alone")))
            }
            None => {
                let problem =
                    Diagnostic::error("bad-argument", tr!("the look has no light `{name}`"));
                Err(problem.suggest(name, lights.keys().map(AsRef::as_ref)))
            }
        },
    }
}

/// Reads and fills everything that a look names, once for all views of a tile. `progress` counts
/// the filling of its HCBTFs, one after the other.
///
/// # Errors
/// All errors of the look, and where the work is stopped.
pub fn tile_assets(
    setup: &SetupLook,
    library: &Library,
    light: &LightId,
    mut assets: Assets,
    progress: &Progress,
) -> Result<Assets, Vec<Diagnostic>> {
    if !setup.look.lights.contains_key(light) {
        return Err(vec![Diagnostic::error(
            "unknown-light",
            tr!("the look has no light `{light}`"),
        )]);
    }
    assets.watch(progress.clone());
    Evaluable::new(setup, library, &mut assets)?;
    assets.watch(Progress::new());
    Ok(assets)
}

/// Greatest number of samples of a texel.
pub const MAX_TILE_SAMPLES: u32 = 64;

/// A tile as one eye sees it under one light. The tile lies at z = 0 with its middle at the origin,
/// as wide as 1, u along x and v along y; the camera is far away, its right and up turned from u
/// and v as the view is from the normal. All other lights stay where they are.
#[derive(Clone, Debug)]
pub struct TileView {
    size: [u32; 2],
    /// Values that all samples of the tile have in common.
    common: EvalSample,
}

impl TileView {
    /// The tile of a look under the direction of `light` at `address`.
    pub fn new(setup: &SetupLook, grid: &Grid, light: &LightId, address: Address) -> Self {
        let toward_eye = grid.view.vector(address.view);
        let turn = DQuat::from_rotation_arc(DVec3::Z, toward_eye);
        let camera = DMat3::from_cols(turn * DVec3::X, turn * DVec3::Y, toward_eye).transpose();
        let space = setup.look.lights.get(light).map(|light| light.space).unwrap_or_default();
        let toward_light = grid.light.vector(address.light);
        let direction =
            if space == LightSpace::Camera { camera * toward_light } else { toward_light };
        let moved = LightOverride { direction: Some(direction), ..LightOverride::default() };
        let common = EvalSample {
            normal: DVec3::Z,
            tangent: Some(DVec3::X),
            view: toward_eye,
            camera,
            lights: IndexMap::from([(light.clone(), moved)]),
            ..EvalSample::default()
        };
        Self { size: grid.size, common }
    }

    /// Sample `index` of the `count` samples of a texel, both counted from 0, texels by rows from
    /// the top. `count` is a power of 2, up to [`MAX_TILE_SAMPLES`]: each column and each row of
    /// the `count` that a texel is cut into has one sample, in its middle; 1 is the middle of the
    /// texel, 4 are the samples of a pixel on GPUs.
    pub fn sample(&self, texel: usize, index: u32, count: u32) -> EvalSample {
        let [width, height] = self.size;
        let [x, y] = [texel as u32 % width, texel as u32 / width];
        let [right, down] = within(index, count);
        let u = (f64::from(x) + right) / f64::from(width);
        let uv = DVec2::new(u, 1.0 - (f64::from(y) + down) / f64::from(height));
        let aspect = f64::from(height) / f64::from(width);
        EvalSample {
            position: DVec3::new(uv.x - 0.5, (uv.y - 0.5) * aspect, 0.0),
            uv,
            ..self.common.clone()
        }
    }
}

/// The position of a sample within a texel, 0 to 1 from the upper left: Hammersley's points, their
/// rows exchanged by halves so that four of them are turned and not on a diagonal.
fn within(index: u32, count: u32) -> [f64; 2] {
    let bits = count.trailing_zeros();
    let reversed = if bits == 0 { 0 } else { index.reverse_bits() >> (u32::BITS - bits) };
    [index, reversed ^ (count >> 1)].map(|place| (f64::from(place) + 0.5) / f64::from(count))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_lie_in_rows_and_columns_of_their_own() {
        assert_eq!(within(0, 1), [0.5; 2]);
        // Positions in sixteenths of a texel, as in Direct3D and Vulkan.
        let four: Vec<[f64; 2]> =
            (0..4).map(|index| within(index, 4).map(|at| 16.0 * at)).collect();
        assert_eq!(four, [[2.0, 10.0], [6.0, 2.0], [10.0, 14.0], [14.0, 6.0]]);
        for count in [2, 8, 16, 32, MAX_TILE_SAMPLES] {
            for axis in 0..2 {
                let place = |index| (within(index, count)[axis] * f64::from(count)) as u32;
                let mut places: Vec<u32> = (0..count).map(place).collect();
                places.sort_unstable();
                assert_eq!(places, (0..count).collect::<Vec<_>>(), "{count}");
            }
        }
    }
}
