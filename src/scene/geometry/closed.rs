//! Test for solids: triangles that enclose a volume, so that nobody outside ever sees their backs.

use glam::DVec3;
use rayon::slice::ParallelSliceMut as _;

use super::map::{MeshMap, vertex_ranges};

/// True if the triangles form solids: every edge joins exactly two triangles that run along the
/// edge in opposite directions, and every connected piece has its front outside. `triangles` index
/// `points`, of which `welded` gives the first at each position.
pub(super) fn is_solid(
    triangles: &[[u32; 3]],
    welded: &[u32],
    point: impl Fn(u32) -> DVec3,
) -> bool {
    let corners = |triangle: usize| triangles[triangle].map(|corner| welded[corner as usize]);
    let mut pieces: Vec<u32> = (0..triangles.len() as u32).collect();
    // Lower and upper point, and the corner that the edge begins at.
    let mut edges: Vec<[u32; 3]> = Vec::new();
    for range in vertex_ranges(welded.len(), 3 * triangles.len()) {
        edges.clear();
        for triangle in 0..triangles.len() {
            let corners = corners(triangle);
            for (k, from) in corners.into_iter().enumerate() {
                let to = corners[(k + 1) % 3];
                let lower = from.min(to);
                if range.contains(&lower) {
                    edges.push([lower, from.max(to), (3 * triangle + k) as u32]);
                }
            }
        }
        edges.par_sort_unstable();
        for run in edges.chunk_by(|a, b| a[..2] == b[..2]) {
            let &[[lower, _, one], [_, _, other]] = run else { return false };
            let is_upward = |edge: u32| corners(edge as usize / 3)[edge as usize % 3] == lower;
            if is_upward(one) == is_upward(other) {
                return false;
            }
            let (a, b) = (root(&mut pieces, one / 3), root(&mut pieces, other / 3));
            pieces[a as usize] = b;
        }
    }
    let mut volumes: MeshMap<u32, f64> = MeshMap::default();
    for triangle in 0..triangles.len() {
        let [a, b, c] = corners(triangle).map(&point);
        let piece = root(&mut pieces, triangle as u32);
        *volumes.entry(piece).or_default() += a.dot(b.cross(c));
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

    fn is_solid(triangles: &[[u32; 3]]) -> bool {
        super::is_solid(triangles, &[0, 1, 2, 3, 4, 5, 6, 7], point)
    }

    #[test]
    fn a_tetrahedron_is_solid_until_something_is_wrong_with_it() {
        assert!(is_solid(&TETRAHEDRON));
        assert!(!is_solid(&TETRAHEDRON[..3]), "open");
        assert!(!is_solid(&TETRAHEDRON.map(|[a, b, c]| [a, c, b])), "inside out");
        let mut one_turned = TETRAHEDRON;
        one_turned[2].swap(0, 1);
        assert!(!is_solid(&one_turned), "not all the same way around");
        assert!(!is_solid(&[]));
    }

    #[test]
    fn each_piece_counts() {
        let second = TETRAHEDRON.map(|corners| corners.map(|corner| corner + 4));
        assert!(is_solid(&[TETRAHEDRON, second].concat()));
        let turned = second.map(|[a, b, c]| [a, c, b]);
        assert!(!is_solid(&[TETRAHEDRON, turned].concat()));
        // A fin on an edge belongs to three triangles.
        assert!(!is_solid(&[&TETRAHEDRON[..], &[[0, 1, 6]]].concat()));
    }
}
