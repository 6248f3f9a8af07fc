//! Handle of a filter, and the value that its port gets where it is dragged.

use chiaro_locale::Text;
use glam::{DMat3, DVec3};

use crate::document::Value;
use crate::viewport::place::{PictureRay, nearest_along, on_plane};

/// Least length and angle that a drag sets.
const LEAST: f64 = 1e-3;

/// Effect of dragging a handle.
#[derive(Clone, Debug)]
pub(super) enum GripDrag {
    /// Moves a place across the picture, at its depth.
    Place,
    /// Points from a center to the handle, which goes across the picture at its depth.
    Toward { center: DVec3 },
    /// Sets one of several half sizes along an axis from a center.
    Size { center: DVec3, axis: DVec3, sizes: Vec<f64>, index: usize },
    /// Turns around the last of the axes: these are the axes without a turn.
    Spin { center: DVec3, axes: DMat3 },
    /// Opens an angle at a lamp, between an axis and a side of it, both unit.
    Angle { center: DVec3, axis: DVec3, side: DVec3, most: f64 },
    /// Sets the distance from a center.
    Distance { center: DVec3 },
}

/// Handle of a filter.
#[derive(Clone, Debug)]
pub(super) struct Grip {
    /// Name, with a capital.
    pub(super) name: Text,
    pub(super) port: &'static str,
    pub(super) help: &'static str,
    /// Place in the world.
    pub(super) at: DVec3,
    /// Number for who cannot see it.
    pub(super) value: f64,
    pub(super) drag: GripDrag,
}

impl Grip {
    /// The value of the port when the handle is dragged to where a ray of the picture goes;
    /// `backward` points to the eye. `None` where that says nothing.
    pub(super) fn dragged(&self, backward: DVec3, ray: PictureRay) -> Option<Value> {
        let faces = |normal: DVec3| ray.direction.dot(normal).abs() > 0.1;
        let beside = |point: DVec3| on_plane(point, backward, ray);
        match &self.drag {
            GripDrag::Place => Some(Value::Vector(short(beside(self.at)?))),
            GripDrag::Toward { center } => {
                let toward = (beside(self.at)? - *center).try_normalize()?;
                Some(Value::Vector(short(toward)))
            }
            GripDrag::Size { center, axis, sizes, index } => {
                let along = nearest_along(*center, *axis, ray)?;
                let mut sizes = sizes.clone();
                *sizes.get_mut(*index)? = rounded(along.abs()).max(LEAST);
                match sizes.as_slice() {
                    [size] => Some(Value::Number(*size)),
                    _ => Some(Value::Vector(sizes)),
                }
            }
            GripDrag::Spin { center, axes } => {
                let [x, y, z] = [axes.x_axis, axes.y_axis, axes.z_axis];
                // Seen from the side, the plane of the turn is no place to point at.
                let at = if faces(z) { on_plane(*center, z, ray)? } else { beside(self.at)? };
                let away = at - *center;
                let (side, up) = (away.dot(x), away.dot(y));
                (side.hypot(up) > 1e-9).then(|| Value::Number(rounded(up.atan2(side))))
            }
            GripDrag::Angle { center, axis, side, most } => {
                let normal = axis.cross(*side);
                let at =
                    if faces(normal) { on_plane(*center, normal, ray)? } else { beside(self.at)? };
                let away = at - *center;
                let angle = away.dot(*side).atan2(away.dot(*axis));
                Some(Value::Number(rounded(angle).clamp(0.0, *most)))
            }
            GripDrag::Distance { center } => {
                let distance = beside(*center)?.distance(*center);
                Some(Value::Number(rounded(distance).max(LEAST)))
            }
        }
    }
}

fn rounded(x: f64) -> f64 {
    (x * 1e4).round() / 1e4
}

fn short(v: DVec3) -> Vec<f64> {
    v.to_array().map(|x| rounded(x) + 0.0).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    const EYE: DVec3 = DVec3::new(0.0, 0.0, 10.0);

    /// The ray from the eye through a point.
    fn through(point: DVec3) -> PictureRay {
        PictureRay { origin: EYE, direction: (point - EYE).normalize() }
    }

    fn dragged(at: DVec3, drag: GripDrag, to: DVec3) -> Value {
        let grip = Grip { name: Text::new(""), port: "", help: "", at, value: 0.0, drag };
        grip.dragged(DVec3::Z, through(to)).unwrap()
    }

    #[test]
    fn handles_go_where_the_pointer_is() {
        let to = DVec3::new(0.5, -0.25, 1.0);
        let place = dragged(DVec3::new(0.0, 0.0, 1.0), GripDrag::Place, to);
        assert_eq!(place, Value::Vector(vec![0.5, -0.25, 1.0]));
        let center = DVec3::new(0.0, 0.0, 1.0);
        let toward = dragged(DVec3::new(1.0, 0.0, 1.0), GripDrag::Toward { center }, to);
        let wanted = (to - center).normalize();
        let Value::Vector(found) = toward else { panic!("{toward:?}") };
        assert!(DVec3::from_slice(&found).distance(wanted) < 2e-4);
        let axis = DVec3::new(1.0, 0.0, 1.0).normalize();
        let sizes = vec![0.1, 0.2, 0.3];
        let size = GripDrag::Size { center, axis, sizes, index: 1 };
        let size = dragged(center, size, center + axis * 0.7);
        assert_eq!(size, Value::Vector(vec![0.1, 0.7, 0.3]));
        let round = dragged(center, GripDrag::Distance { center }, center + DVec3::X * 1.5);
        assert_eq!(round, Value::Number(1.5));
    }

    #[test]
    fn turns_and_angles_are_those_of_the_axes() {
        let center = DVec3::new(0.2, 0.1, 0.0);
        let axes = DMat3::from_cols(DVec3::Y, -DVec3::X, DVec3::Z);
        let turned = center + 0.4 * (axes * DVec3::new(0.7_f64.cos(), 0.7_f64.sin(), 0.0));
        let spin = dragged(center, GripDrag::Spin { center, axes }, turned);
        assert_eq!(spin, Value::Number(0.7));
        let (axis, side) = (DVec3::X, DVec3::Y);
        let open = center + 2.0 * (axis * 0.5_f64.cos() + side * 0.5_f64.sin());
        let drag = GripDrag::Angle { center, axis, side, most: 1.5 };
        assert_eq!(dragged(center, drag.clone(), open), Value::Number(0.5));
        let beyond = center - axis + side * 0.1;
        assert_eq!(dragged(center, drag, beyond), Value::Number(1.5), "as far as it goes");
    }
}
