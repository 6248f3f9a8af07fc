//! Test for solids: triangles that enclose a volume, so that nobody outside ever sees their backs.

use glam::DVec3;

use super::map::{MeshMap, with_room};

/// True if the triangles form solids: every edge joins exactly two triangles that run along the
/// edge in opposite directions, and every connected piece has its front outside. `triangles` index
/// `point`s that are welded where they are equal.
pub(super) fn is_solid(triangles: &[[u32; 3]], point: impl Fn(u32) -> DVec3) -> bool {
    // The two triangles at each edge, by the direction in which they run along it.
    let mut edges: MeshMap<(u32, u32), [Option<u32>; 2]> = with_room(triangles.len() * 3 / 2);
    for (index, corners) in triangles.iter().enumerate() {
        for corner in 0..3 {
            let (from, to) = (corners[corner], corners[(corner + 1) % 3]);
            let sides = edges.entry((from.min(to), from.max(to))).or_default();
            let side = &mut sides[usize::from(from > to)];
            if side.replace(index as u32).is_some() {
                return false;
            }
        }
    }
    let mut pieces: Vec<u32> = (0..triangles.len() as u32).collect();
    for sides in edges.values() {
        let [Some(a), Some(b)] = sides else { return false };
        let (a, b) = (root(&mut pieces, *a), root(&mut pieces, *b));
        pieces[a as usize] = b;
    }
    let mut volumes: MeshMap<u32, f64> = MeshMap::default();
    for (index, corners) in triangles.iter().enumerate() {
        let [a, b, c] = corners.map(&point);
        *volumes.entry(root(&mut pieces, index as u32)).or_default() += a.dot(b.cross(c));
    }
    !volumes.is_empty() && volumes.values().all(|volume| *volume > 0.0)
}

/// The representative of a connected piece; paths are halved on the way, which keeps them short.
fn root(pieces: &mut [u32], mut at: u32) -> u32 {
    while pieces[at as usize] != at {
        pieces[at as usize] = pieces[pieces[at as usize] as usize];
        at = pieces[at as usize];
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [[f64; 3]; 4] =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

    /// The points repeated without end, each repeat farther along x.
    fn point(index: u32) -> DVec3 {
        DVec3::from(POINTS[index as usize % 4]) + DVec3::X * 5.0 * f64::from(index / 4)
    }

    #[test]
    fn a_tetrahedron_is_solid_until_something_is_wrong_with_it() {
        assert!(is_solid(&TETRAHEDRON, point));
        assert!(!is_solid(&TETRAHEDRON[..3], point), "open");
        assert!(!is_solid(&TETRAHEDRON.map(|[a, b, c]| [a, c, b]), point), "inside out");
        let mut one_turned = TETRAHEDRON;
        one_turned[2].swap(0, 1);
        assert!(!is_solid(&one_turned, point), "not all the same way around");
        assert!(!is_solid(&[], point));
    }

    #[test]
    fn each_piece_counts() {
        let second = TETRAHEDRON.map(|corners| corners.map(|corner| corner + 4));
        assert!(is_solid(&[TETRAHEDRON, second].concat(), point));
        let turned = second.map(|[a, b, c]| [a, c, b]);
        assert!(!is_solid(&[TETRAHEDRON, turned].concat(), point));
        // A fin on an edge belongs to three triangles.
        assert!(!is_solid(&[&TETRAHEDRON[..], &[[0, 1, 6]]].concat(), point));
    }
}
