//! Faces of cubes (Vulkan 1.3, "Cube map face selection"), and texels across their edges.

use super::Vec3;
use crate::interp::resources::TextureLevel;

/// Number of the face that a direction meets: +x, -x, +y, -y, +z, -z; of equal axes z goes before y
/// before x.
pub(super) fn face([x, y, z]: Vec3) -> usize {
    let [ax, ay, az] = [x.abs(), y.abs(), z.abs()];
    if az >= ax && az >= ay {
        4 + usize::from(z < 0.0)
    } else if ay >= ax {
        2 + usize::from(y < 0.0)
    } else {
        usize::from(x < 0.0)
    }
}

/// Direction in the axes of a face: to the right, down, and through it.
fn axes(face: usize, [x, y, z]: Vec3) -> Vec3 {
    match face {
        0 => [-z, -y, x],
        1 => [z, -y, -x],
        2 => [x, z, y],
        3 => [x, -z, -y],
        4 => [x, -y, z],
        _ => [-x, -y, -z],
    }
}

/// Inverse of [`axes`].
fn direction(face: usize, [right, down, through]: Vec3) -> Vec3 {
    match face {
        0 => [through, -down, -right],
        1 => [-through, -down, right],
        2 => [right, through, down],
        3 => [right, -through, -down],
        4 => [right, -down, through],
        _ => [-right, -down, -through],
    }
}

/// Point where a direction meets a face, as coordinates from 0 to 1.
pub(super) fn on_face(face: usize, place: Vec3) -> Vec3 {
    let [right, down, through] = axes(face, place);
    [0.5 * (right / through + 1.0), 0.5 * (down / through + 1.0), 0.0]
}

/// Change of the coordinates on a face for a change of the direction.
pub(super) fn gradient(face: usize, place: Vec3, gradient: Vec3) -> Vec3 {
    let [right, down, through] = axes(face, place);
    let [d_right, d_down, d_through] = axes(face, gradient);
    let slope = |x: f64, dx: f64| 0.5 * (dx * through - x * d_through) / (through * through);
    [slope(right, d_right), slope(down, d_down), 0.0]
}

/// Texel of a face; beyond an edge one of the neighboring face, beyond a corner the mean of the
/// three that meet there.
pub(super) fn texel(level: &TextureLevel, [x, y, _]: [i64; 3], layer: u32) -> [f64; 4] {
    let size = i64::from(level.size()[0]);
    // A linear filter reaches one texel beyond the edge. The texel for a direction that is NaN does
    // not matter.
    let (x, y) = (x.clamp(-1, size), y.clamp(-1, size));
    let is_inside = |i: i64| (0..size).contains(&i);
    match (is_inside(x), is_inside(y)) {
        (true, true) => level.texel([x as u32, y as u32, layer]),
        (false, false) => {
            let (cx, cy) = (x.clamp(0, size - 1), y.clamp(0, size - 1));
            let own = level.texel([cx as u32, cy as u32, layer]);
            let [beside, above] = [[x, cy], [cx, y]].map(|place| across(level, place, layer));
            std::array::from_fn(|i| (own[i] + beside[i] + above[i]) / 3.0)
        }
        _ => across(level, [x, y], layer),
    }
}

/// Texel of the neighboring face that lies next to the edge. The plane of a face, extended by half
/// a texel, leads to a direction within that texel: along the edge it shrinks by N / (N + 1), less
/// than half a texel.
fn across(level: &TextureLevel, place: [i64; 2], layer: u32) -> [f64; 4] {
    let size = level.size()[0];
    let [right, down] = place.map(|i| (2 * i + 1) as f64 / f64::from(size) - 1.0);
    let outward = direction((layer % 6) as usize, [right, down, 1.0]);
    let neighbor = face(outward);
    let [u, v, _] = on_face(neighbor, outward);
    let index = |x: f64| ((x * f64::from(size)).floor().max(0.0) as u32).min(size - 1);
    level.texel([index(u), index(v), layer - layer % 6 + neighbor as u32])
}
