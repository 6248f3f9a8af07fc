//! Distance of the eye from the nearest surface, so that the near plane cuts nothing that would be
//! seen.
//!
//! Only an eye within the box of an object, or next to the box, has a surface before the plane; for
//! all other objects the boxes show that, and no triangle is tested.

use glam::{DMat4, DVec3, Vec3};
use rayon::prelude::*;

use super::setup::SetupObject;
use super::visibility::ObjectPlacement;
use crate::geometry::{Bounds, Mesh};

/// The distance from `eye` to the nearest triangle that wears a look, in scene units; `None` where
/// the distance is `reach` or more.
pub(super) fn nearest_surface(
    objects: &[SetupObject],
    placed: &[ObjectPlacement],
    eye: DVec3,
    reach: f64,
) -> Option<f64> {
    if reach <= 0.0 {
        return None;
    }
    let is_near = |(object, placed): &(&SetupObject, &ObjectPlacement)| {
        reaches(object.world_from_object, &placed.bounds, eye, reach)
    };
    let near = objects.iter().zip(placed).filter(is_near);
    let distances = near.flat_map(|(object, _)| {
        let worn = object.mesh.parts.iter().zip(&object.looks).filter(|(_, look)| look.is_some());
        worn.map(|(part, _)| {
            let indices =
                &object.mesh.indices[part.indices.start as usize..part.indices.end as usize];
            nearest_triangle(&object.mesh, indices, object.world_from_object, eye)
        })
    });
    distances.min_by(f64::total_cmp).filter(|distance| *distance < reach)
}

/// True if the box around an object's box, along the axes of the world, comes within `reach` of the
/// eye.
fn reaches(world_from_object: DMat4, bounds: &Bounds, eye: DVec3, reach: f64) -> bool {
    let half = 0.5 * bounds.size();
    let center = world_from_object.transform_point3(bounds.center());
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z]
        .map(|axis| world_from_object.transform_vector3(axis * half).abs());
    ((eye - center).abs() - (x + y + z)).max_element() < reach
}

fn nearest_triangle(mesh: &Mesh, indices: &[u32], world_from_object: DMat4, eye: DVec3) -> f64 {
    let corner = |index: u32| {
        let place = mesh.positions.get(index as usize).copied().unwrap_or_default();
        world_from_object.transform_point3(Vec3::from(place).as_dvec3())
    };
    let distance = |triangle: &[u32]| match triangle {
        &[a, b, c] => squared_distance(eye, [a, b, c].map(corner)),
        _ => f64::INFINITY,
    };
    // The minimum is the same in any order, so the picture does not depend on the number of
    // threads.
    indices.par_chunks(3).map(distance).reduce(|| f64::INFINITY, f64::min).sqrt()
}

/// The squared distance from a point to a triangle; infinite where a coordinate is not a number.
fn squared_distance(point: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    let offset = point - a;
    // The signs of the areas at each side of the point's foot on the plane tell whether the foot is
    // inside.
    let is_inside = [(a, b), (b, c), (c, a)]
        .into_iter()
        .all(|(from, to)| (to - from).cross(point - from).dot(normal) >= 0.0);
    let squared = if is_inside && normal.length_squared() > 0.0 {
        offset.dot(normal).powi(2) / normal.length_squared()
    } else {
        let edges = [(a, b), (b, c), (c, a)].map(|(from, to)| {
            let along = to - from;
            let share = (point - from).dot(along) / along.length_squared();
            let share = if share > 0.0 { share.min(1.0) } else { 0.0 };
            point.distance_squared(from + share * along)
        });
        edges.into_iter().fold(f64::INFINITY, f64::min)
    };
    if squared.is_nan() { f64::INFINITY } else { squared }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_near_by_its_face_its_edges_and_its_corners() {
        let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
        for (point, distance) in [
            ([0.2, 0.3, 0.5], 0.5),
            ([0.2, 0.3, -0.25], 0.25),
            ([0.5, -2.0, 0.0], 2.0),
            ([1.0, 1.0, 0.0], 0.5_f64.sqrt()),
            ([-3.0, -4.0, 0.0], 5.0),
            ([4.0, 0.0, 4.0], 5.0),
        ] {
            let found = squared_distance(point.into(), triangle).sqrt();
            assert!((found - distance).abs() < 1e-12, "{point:?}: {found}, not {distance}");
        }
        let line = [DVec3::ZERO, DVec3::X, 2.0 * DVec3::X];
        assert_eq!(squared_distance(DVec3::new(1.5, 2.0, 0.0), line), 4.0);
        assert_eq!(squared_distance(DVec3::new(3.0, 4.0, 0.0), [DVec3::ZERO; 3]), 25.0);
        assert_eq!(squared_distance(DVec3::ONE, [DVec3::NAN; 3]), f64::INFINITY);
    }
}
