//! Triangulation of polygons: by the better diagonal for quads, a fan for convex polygons, ear
//! clipping for the others.

use glam::{DVec2, DVec3};

/// Greatest number of points that ear clipping tests for each corner; a polygon that needs more
/// (thousands of corners, most of them reflex) gets a fan for the rest, so that no file takes
/// quadratic time.
const TESTS_PER_CORNER: usize = 256;

/// Cuts a polygon into `n - 2` triangles, given as indices into `points`, wound as the polygon is.
/// Never fails: a polygon that crosses itself still gives that many triangles. Fewer than 3 points
/// give none.
pub(super) fn triangulate(points: &[DVec3], triangles: &mut Vec<[u32; 3]>) {
    match points.len() {
        0..=2 => {}
        3 => triangles.push([0, 1, 2]),
        _ => {
            let flat = flatten(points);
            if points.len() == 4 {
                quad(points, &flat, triangles);
            } else {
                polygon(&flat, triangles);
            }
        }
    }
}

/// Projects a polygon along its mean normal (Newell's method), so that it runs counter-clockwise.
fn flatten(points: &[DVec3]) -> Vec<DVec2> {
    let origin = points[0];
    let normal = (0..points.len())
        .map(|i| (points[i] - origin).cross(points[(i + 1) % points.len()] - origin))
        .sum::<DVec3>();
    let normal = normal.try_normalize().unwrap_or(DVec3::Z);
    let (x, y) = normal.any_orthonormal_pair();
    points.iter().map(|&p| DVec2::new((p - origin).dot(x), (p - origin).dot(y))).collect()
}

/// Twice the signed area of a triangle: positive where a, b, c run counter-clockwise.
fn area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

fn quad(points: &[DVec3], flat: &[DVec2], triangles: &mut Vec<[u32; 3]>) {
    let least = |a: [usize; 3], b: [usize; 3]| {
        area(flat[a[0]], flat[a[1]], flat[a[2]]).min(area(flat[b[0]], flat[b[1]], flat[b[2]]))
    };
    let (first, second) = (least([0, 1, 2], [0, 2, 3]), least([0, 1, 3], [1, 2, 3]));
    // Both diagonals lie inside a convex quad: the shorter one bends less. Otherwise only one does.
    let shorter = points[0].distance_squared(points[2]) <= points[1].distance_squared(points[3]);
    let first_is_better = if first > 0.0 && second > 0.0 { shorter } else { first >= second };
    triangles.extend(if first_is_better { [[0, 1, 2], [0, 2, 3]] } else { [[0, 1, 3], [1, 2, 3]] });
}

fn polygon(flat: &[DVec2], triangles: &mut Vec<[u32; 3]>) {
    let count = flat.len();
    let mut ring: Vec<usize> = (0..count).collect();
    let corner = |ring: &[usize], i: usize| {
        let n = ring.len();
        [ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]]
    };
    let turn = |[a, b, c]: [usize; 3]| area(flat[a], flat[b], flat[c]);
    let mut reflex: Vec<usize> = (0..count).filter(|&i| turn(corner(&ring, i)) <= 0.0).collect();
    let mut tests_left = TESTS_PER_CORNER * count;
    let mut at = 0;
    let mut refused = 0;
    while ring.len() > 3 && !reflex.is_empty() {
        let n = ring.len();
        let ear = corner(&ring, at % n);
        tests_left = tests_left.saturating_sub(1 + reflex.len());
        if tests_left == 0 {
            break;
        }
        // After a whole round without an ear the polygon crosses itself: clip the next corner
        // anyway.
        if refused < n && !is_ear(flat, ear, &reflex) {
            (at, refused) = ((at + 1) % n, refused + 1);
            continue;
        }
        triangles.push(ear.map(|i| i as u32));
        ring.remove(at % n);
        refused = 0;
        let n = ring.len();
        // Only the neighbors' angles have changed. The search goes on behind the ear, which spreads
        // the triangles around.
        for i in [(at + n - 1) % n, at % n] {
            let now_reflex = turn(corner(&ring, i)) <= 0.0;
            reflex.retain(|&r| r != ring[i]);
            if now_reflex {
                reflex.push(ring[i]);
            }
        }
        reflex.retain(|&r| r != ear[1]);
        at = (at + 1) % n;
    }
    triangles
        .extend((1..ring.len() - 1).map(|i| [ring[0], ring[i], ring[i + 1]].map(|i| i as u32)));
}

/// True if the corner turns left and no reflex corner lies in its triangle.
fn is_ear(flat: &[DVec2], [a, b, c]: [usize; 3], reflex: &[usize]) -> bool {
    let (pa, pb, pc) = (flat[a], flat[b], flat[c]);
    area(pa, pb, pc) > 0.0
        && reflex.iter().filter(|r| ![a, b, c].contains(r)).all(|&r| {
            let p = flat[r];
            // A point that coincides with a corner (a bridge to a hole) does not block.
            p == pa
                || p == pb
                || p == pc
                || area(pa, pb, p) < 0.0
                || area(pb, pc, p) < 0.0
                || area(pc, pa, p) < 0.0
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cut(points: &[[f64; 2]]) -> (Vec<[u32; 3]>, Vec<f64>) {
        // Tilted, so that the projection matters.
        let place = |p: &[f64; 2]| DVec3::new(p[0], p[1], 0.5 * p[0] - 0.25 * p[1]);
        let points3: Vec<DVec3> = points.iter().map(place).collect();
        let mut triangles = Vec::new();
        triangulate(&points3, &mut triangles);
        let flat = |i: u32| DVec2::from(points[i as usize]);
        let areas =
            triangles.iter().map(|t| area(flat(t[0]), flat(t[1]), flat(t[2])) / 2.0).collect();
        (triangles, areas)
    }

    fn shoelace(points: &[[f64; 2]]) -> f64 {
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>() / 2.0
    }

    #[test]
    fn concave_polygons_are_covered_once() {
        let comb = [
            [0., 0.],
            [6., 0.],
            [6., 4.],
            [5., 4.],
            [5., 1.],
            [4., 1.],
            [4., 4.],
            [3., 4.],
            [3., 1.],
            [0., 1.],
        ];
        let arrow = [[0., 0.], [2., 1.], [0., 2.], [1., 1.]];
        let dart = [[2., 1.], [0., 2.], [1., 1.], [0., 0.]];
        for polygon in [&comb[..], &arrow, &dart] {
            let (triangles, areas) = cut(polygon);
            assert_eq!(triangles.len(), polygon.len() - 2);
            assert!(areas.iter().all(|&a| a > -1e-12), "{polygon:?}: {areas:?}");
            assert!((areas.iter().sum::<f64>() - shoelace(polygon)).abs() < 1e-9, "{polygon:?}");
        }
    }

    #[test]
    fn a_quad_takes_the_shorter_diagonal() {
        assert_eq!(cut(&[[0., 0.], [3., 1.], [4., 4.], [1., 3.]]).0, [[0, 1, 3], [1, 2, 3]]);
    }

    #[test]
    fn crossing_and_flat_polygons_still_give_triangles() {
        assert_eq!(cut(&[[0., 0.], [1., 1.], [1., 0.], [0., 1.], [0.5, 2.]]).0.len(), 3);
        assert_eq!(cut(&[[0., 0.]; 7]).0.len(), 5);
        assert_eq!(cut(&[[0., 0.], [1., 0.]]).0.len(), 0);
    }

    #[test]
    fn a_big_zigzag_ends() {
        let zigzag: Vec<[f64; 2]> =
            (0..20_000).map(|i| [f64::from(i), f64::from(i % 2) * 1e4]).collect();
        assert_eq!(cut(&zigzag).0.len(), zigzag.len() - 2);
    }

    proptest! {
        #[test]
        fn stars_are_covered_once(radii in prop::collection::vec(0.2f64..2.0, 5..40)) {
            let step = std::f64::consts::TAU / radii.len() as f64;
            let star: Vec<[f64; 2]> = radii
                .iter()
                .enumerate()
                .map(|(i, r)| [r * (i as f64 * step).cos(), r * (i as f64 * step).sin()])
                .collect();
            let (triangles, areas) = cut(&star);
            prop_assert_eq!(triangles.len(), star.len() - 2);
            prop_assert!(areas.iter().all(|&a| a > -1e-9));
            prop_assert!((areas.iter().sum::<f64>() - shoelace(&star)).abs() < 1e-9);
        }
    }
}
