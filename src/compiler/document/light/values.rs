//! Lights as shaders take them: in world space, and within bounds that an f32 holds.

use std::sync::Arc;

use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};
use indexmap::IndexMap;

use super::{Light, LightField, LightKind, LightQuantity, LightSpace};
use crate::ids::ObjectId;

/// The greatest intensity: finite in f32, whatever a file says.
pub const MAX_INTENSITY: f64 = 1e30;

/// The greatest number of a light's color, of either sign: whatever a file says, shaders need not
/// ask whether a color is a number.
pub const MAX_LIGHT_COLOR: f64 = 1e6;

/// The least half distance and range above 0, in scene units. An f32 has a lesser one as 0 or as a
/// denormal, which a GPU may take for 0; and 0 means no fading and no end, the opposite of what was
/// written.
pub const MIN_LIGHT_DISTANCE: f64 = 1e-30;

/// A light in world space, ready for the shader.
#[derive(Clone, Debug, PartialEq)]
pub struct LightValues {
    /// The fields of the light as shaders take them: directions of length 1 and places in world
    /// space, intensities up to [`MAX_INTENSITY`], distances 0 or [`MIN_LIGHT_DISTANCE`] and more.
    pub(super) world: Light,
    /// Direction toward a directional light; unit, in the light's own frame.
    pub own_direction: DVec3,
    /// Rotation from world space to the light's own frame.
    pub own_from_world: DMat3,
    /// Origin of the light's own frame, in world space.
    pub own_origin: DVec3,
    /// Cosines of the inner and outer half-angles of a spot light's cone.
    pub cone: [f64; 2],
    /// The kind of light.
    pub kind: LightKind,
    /// Casters of this light's shadows onto the object that is lit: [`Self::NO_CASTERS`], or a
    /// number that the scene's casters give.
    pub casters: f64,
    /// Place of what casts these shadows in the scene's shadow maps: middle, half of a side, and
    /// the first layer, or [`Self::NO_SHADOW_MAP`].
    pub shadow_map: [f64; 4],
}

/// Place and turn of an object that is lit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ObjectFrame {
    /// Middle of the object's box, in world space.
    pub center: DVec3,
    /// Rotation from the object's axes to world space.
    pub turn: DQuat,
}

impl ObjectFrame {
    /// The frame of an object by its matrix, which may scale, skew and mirror; its axes are then
    /// the nearest at right angles.
    pub fn new(center: DVec3, world_from_object: DMat4) -> Self {
        let axis = |column: DVec3| column.try_normalize();
        let [x, y] = [world_from_object.x_axis, world_from_object.y_axis].map(DVec4::truncate);
        let turn = axis(x).and_then(|x| {
            let y = axis(y - x * x.dot(y))?;
            Some(DQuat::from_mat3(&DMat3::from_cols(x, y, x.cross(y))).normalize())
        });
        Self { center, turn: turn.unwrap_or_default() }
    }
}

/// Places of objects that lights are aimed at, in world space.
pub type AimPlaces = IndexMap<ObjectId, DVec3>;

/// Frames that lights are given in, and the places that they are aimed at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LightFrames {
    /// Rotation from the illumination frame to world space.
    pub illumination: DQuat,
    /// Rotation from world space to camera axes.
    pub camera_from_world: DMat3,
    /// The object that is lit.
    pub object: ObjectFrame,
    /// Places of objects that lights are aimed at.
    pub aims: Arc<AimPlaces>,
}

impl LightFrames {
    /// Rotation from a light's own frame to world space, and the place of that frame's origin.
    fn world_from(&self, space: LightSpace) -> (DMat3, DVec3) {
        match space {
            LightSpace::Illumination => (DMat3::from_quat(self.illumination), DVec3::ZERO),
            LightSpace::World => (DMat3::IDENTITY, DVec3::ZERO),
            LightSpace::Camera => (self.camera_from_world.transpose(), DVec3::ZERO),
            LightSpace::Object => (DMat3::from_quat(self.object.turn), self.object.center),
        }
    }
}

impl LightValues {
    /// [`Self::casters`] where nothing casts shadows.
    pub const NO_CASTERS: f64 = -2.0;
    /// [`Self::shadow_map`] where nothing casts shadows.
    pub const NO_SHADOW_MAP: [f64; 4] = [0.0, 0.0, 1.0, -1.0];

    /// Resolves `light` in its frame.
    pub fn new(light: &Light, frames: &LightFrames) -> Self {
        let (world_from_own, origin) = frames.world_from(light.space);
        let mut world = light.clone();
        for field in LightField::ALL {
            resolve(field.quantity(), field.numbers_mut(&mut world), (world_from_own, origin));
        }
        let mut values = Self {
            own_direction: unit(&light.direction),
            own_from_world: world_from_own.transpose(),
            own_origin: origin,
            cone: [world.inner.clamp(0.0, world.outer).cos(), world.outer.cos()],
            kind: light.kind,
            world,
            casters: Self::NO_CASTERS,
            shadow_map: Self::NO_SHADOW_MAP,
        };
        if let Some(place) = light.aimed_at.as_ref().and_then(|id| frames.aims.get(id)) {
            values.aim_at(*place);
        }
        values
    }

    /// Turns the light from its position toward `place`, in world space. A point light shines
    /// everywhere; a light at the place itself stays as it is.
    fn aim_at(&mut self, place: DVec3) {
        let Some(aim) = (place - self.position()).try_normalize() else { return };
        match self.kind {
            LightKind::Directional => self.shine_from(-aim),
            LightKind::Spot => self.world.aim = aim.into(),
            LightKind::Point => {}
        }
    }

    /// Direction toward a directional light; unit, in world space.
    pub fn direction(&self) -> DVec3 {
        self.world.direction.into()
    }

    /// Position of a point or spot light, in scene units, in world space.
    pub fn position(&self) -> DVec3 {
        self.world.position.into()
    }

    /// Direction in which a spot light shines, from the light outward; unit, in world space.
    pub fn aim(&self) -> DVec3 {
        self.world.aim.into()
    }

    /// Color of the light, straight RGB in the look's color space.
    pub fn color(&self) -> DVec3 {
        self.world.color.into()
    }

    /// Intensity, a factor on the color, 0 to [`MAX_INTENSITY`].
    pub fn intensity(&self) -> f64 {
        self.world.intensity
    }

    /// Distance beyond which nothing of the light is left, in scene units: [`MIN_LIGHT_DISTANCE`]
    /// and more, or 0 for no end.
    pub fn range(&self) -> f64 {
        self.world.range
    }

    /// Makes the light shine on nothing.
    pub fn darken(&mut self) {
        self.world.intensity = 0.0;
    }

    /// Multiplies intensity and color, as the master of a group does.
    pub fn multiply(&mut self, factor: f64, tint: [f64; 3]) {
        self.world.intensity *= factor;
        for (channel, tint) in self.world.color.iter_mut().zip(tint) {
            *channel *= tint;
        }
        for field in [LightField::Color, LightField::Intensity] {
            resolve(field.quantity(), field.numbers_mut(&mut self.world), Default::default());
        }
    }

    /// Makes a directional light shine from `direction`; unit, in world space.
    pub fn shine_from(&mut self, direction: DVec3) {
        self.world.direction = direction.into();
        self.own_direction = self.own_from_world * direction;
    }

    /// Moves the light to `position`, in scene units, and turns a spot light to shine along `aim`,
    /// unit; both in world space.
    pub fn stand_at(&mut self, position: DVec3, aim: DVec3) {
        self.world.position = position.into();
        if self.kind == LightKind::Spot {
            self.world.aim = aim.into();
        }
    }
}

impl Default for LightValues {
    fn default() -> Self {
        Self::new(&Light::default(), &LightFrames::default())
    }
}

fn unit(direction: &[f64]) -> DVec3 {
    DVec3::from_slice(direction).try_normalize().unwrap_or(DVec3::Z)
}

/// Converts the numbers of a light's field to world space and to the bounds of shaders. A factor,
/// an angle or a distance that is NaN counts as 0.
fn resolve(quantity: LightQuantity, numbers: &mut [f64], (world_from_own, origin): (DMat3, DVec3)) {
    match quantity {
        LightQuantity::Direction => {
            (world_from_own * unit(numbers)).write_to_slice(numbers);
        }
        LightQuantity::Position => {
            (origin + world_from_own * DVec3::from_slice(numbers)).write_to_slice(numbers);
        }
        LightQuantity::Color => numbers.iter_mut().for_each(|x| {
            *x = if x.is_nan() { 0.0 } else { x.clamp(-MAX_LIGHT_COLOR, MAX_LIGHT_COLOR) };
        }),
        LightQuantity::Factor => numbers.iter_mut().for_each(|x| {
            *x = if x.is_nan() { 0.0 } else { x.clamp(0.0, MAX_INTENSITY) };
        }),
        LightQuantity::Angle => numbers.iter_mut().for_each(|x| {
            *x = if x.is_nan() { 0.0 } else { x.clamp(0.0, std::f64::consts::PI) };
        }),
        LightQuantity::Distance => numbers.iter_mut().for_each(|x| *x = light_distance(*x)),
    }
}

/// A distance of a light as the f32 of a shader and the f64 of the reference both hold it; NaN
/// counts as 0.
fn light_distance(distance: f64) -> f64 {
    if distance > 0.0 { distance.clamp(MIN_LIGHT_DISTANCE, f64::from(f32::MAX)) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_of_lights_mean_the_same_in_f32_and_f64() {
        let fading = |half_distance, range| {
            let light = Light { half_distance, range, ..Light::default() };
            let world = LightValues::new(&light, &LightFrames::default()).world;
            [world.half_distance, world.range]
        };
        for tiny in [1e-300, f64::MIN_POSITIVE, 5e-324, 1e-40, f64::from(f32::MIN_POSITIVE)] {
            for distance in [fading(tiny, 0.0)[0], fading(0.0, tiny)[1]] {
                assert!(
                    (distance as f32).is_normal() && distance == MIN_LIGHT_DISTANCE,
                    "{tiny}: {distance}"
                );
                // The quotient in `light_fading` stays a number in f32, across all distances that a
                // scene may hold.
                assert!((4e6_f32 / distance as f32).is_finite());
            }
        }
        assert_eq!(fading(0.0, -1.0), [0.0; 2], "no fading and no end");
        assert_eq!(fading(f64::NAN, 2.5), [0.0, 2.5]);
        assert_eq!(fading(f64::INFINITY, 1e-30), [f64::from(f32::MAX), 1e-30]);
    }
}
