//! Normals for files that have none.
//!
//! The normal of a corner is the mean of the normals of the triangles around its point, each
//! weighted by its angle there (so that how a polygon was cut into triangles makes no difference),
//! over the *sector* that the corner lies in: triangles are in one sector when one gets from one to
//! the other through edges that bend by at most [`CREASE_ANGLE`]. So one threshold serves both
//! kinds of mesh. A machine's edge is a chain of sharp edges; at every point on it two of them end,
//! the sectors on either side are apart, and the crease stays. A scan's noise makes single sharp
//! edges that end nowhere; one gets around them through their neighbors, and the surface stays
//! smooth.
//!
//! Points are welded where their coordinates are equal, so a file that repeats points (STL always
//! does, others along UV seams) is shaded as smoothly as one that does not. Edges may join any
//! number of triangles.

use glam::DVec3;

use super::soup::{NONE, TriangleSoup};

/// Greatest angle by which an edge may bend within a smooth region where normals are made, in
/// radians. 60 degrees lies above what a sphere of 8 segments (45) or an icosahedron (41.8) has,
/// and below a box's edges (90). Measured: at 60 degrees at most 1.8% of a scan's points are split
/// (a bust with all its damage; a hare 0.2%), at 45 degrees 4.2%, at 35 degrees 8%.
pub const CREASE_ANGLE: f64 = std::f64::consts::FRAC_PI_3;

/// Greatest number of triangles at an edge that are all compared with one another; at an edge of
/// more only neighbors in the list are, so that a fan of a million triangles around one edge takes
/// no quadratic time.
const MAX_COMPARED: usize = 16;

/// The position of a point in f64.
pub(super) fn place(points: &[[f32; 3]], index: u32) -> DVec3 {
    DVec3::from(points[index as usize].map(f64::from))
}

/// The angle of a triangle at its point `at`; 0 where two of the points are equal. In radians.
pub(super) fn corner_angle(at: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (u, v) = (b - at, c - at);
    f64::atan2(u.cross(v).length(), u.dot(v))
}

/// Gives a made normal to every corner that names none, or one of length 0, and appends these
/// normals to `soup.normals`. `welded` are the [first points](super::map::weld) at each position;
/// triangles must not be degenerate. Returns the number of corners that were given a normal.
pub(super) fn make_missing(soup: &mut TriangleSoup, welded: &[u32], crease_angle: f64) -> usize {
    let lacks_normal = |soup: &TriangleSoup, normal: u32| {
        normal == NONE || soup.normals[normal as usize] == [0.0; 3]
    };
    let corners = soup.triangles.iter().flatten();
    let missing = corners.filter(|corner| lacks_normal(soup, corner.normal)).count();
    if missing == 0 {
        return 0;
    }
    let triangles = soup.triangles.points();
    let faces: Vec<DVec3> = triangles.iter().map(|t| face_normal(&soup.points, *t)).collect();
    let mut sectors = Sectors::new(triangles.len() * 3);
    join_over_edges(triangles, welded, &faces, crease_angle, &mut sectors);

    let mut sums = vec![DVec3::ZERO; triangles.len() * 3];
    for (t, points) in triangles.iter().enumerate() {
        let at = points.map(|point| place(&soup.points, point));
        for k in 0..3 {
            let angle = corner_angle(at[k], at[(k + 1) % 3], at[(k + 2) % 3]);
            sums[sectors.root(t * 3 + k)] += faces[t] * angle;
        }
    }
    let mut made = vec![NONE; sums.len()];
    let (of_file, mut normals) = (soup.normals.len(), std::mem::take(&mut soup.normals));
    for ((t, &face), of_corners) in faces.iter().enumerate().zip(soup.triangles.normals_mut()) {
        for (k, normal) in of_corners.iter_mut().enumerate() {
            let given = normals[..of_file].get(*normal as usize);
            if given.is_some_and(|given| *given != [0.0; 3]) {
                continue;
            }
            let root = sectors.root(t * 3 + k);
            if made[root] == NONE {
                made[root] = normals.len() as u32;
                // Faces that cancel out exactly leave no direction but their own.
                normals.push(sums[root].try_normalize().unwrap_or(face).as_vec3().into());
            }
            *normal = made[root];
        }
    }
    soup.normals = normals;
    missing
}

/// The unit normal of a triangle that is not degenerate; seen from its tip the triangle runs
/// counter-clockwise.
fn face_normal(points: &[[f32; 3]], [a, b, c]: [u32; 3]) -> DVec3 {
    let [a, b, c] = [a, b, c].map(|p| place(points, p));
    (b - a).cross(c - a).normalize_or_zero()
}

/// Joins the corners on either side of every edge that bends by at most `crease_angle`.
fn join_over_edges(
    triangles: &[[u32; 3]],
    welded: &[u32],
    faces: &[DVec3],
    crease_angle: f64,
    sectors: &mut Sectors,
) {
    // (lower point, upper point, corner at the lower point, corner at the upper point)
    let mut edges: Vec<[u32; 4]> = Vec::with_capacity(triangles.len() * 3);
    for (t, points) in triangles.iter().enumerate() {
        for k in 0..3 {
            let next = (k + 1) % 3;
            let (a, b) = (welded[points[k] as usize], welded[points[next] as usize]);
            let (at_a, at_b) = ((t * 3 + k) as u32, (t * 3 + next) as u32);
            edges.push(if a < b { [a, b, at_a, at_b] } else { [b, a, at_b, at_a] });
        }
    }
    edges.sort_unstable();
    // The margin keeps edges of exactly the crease angle smooth in spite of rounding.
    let smooth = crease_angle.cos() - 1e-9;
    for run in edges.chunk_by(|a, b| a[..2] == b[..2]) {
        let reach = if run.len() <= MAX_COMPARED { run.len() } else { 2 };
        for (i, one) in run.iter().enumerate() {
            for other in &run[i + 1..run.len().min(i + reach)] {
                if faces[one[2] as usize / 3].dot(faces[other[2] as usize / 3]) >= smooth {
                    sectors.join(one[2] as usize, other[2] as usize);
                    sectors.join(one[3] as usize, other[3] as usize);
                }
            }
        }
    }
}

/// Disjoint sets of corners (union-find).
struct Sectors(Vec<u32>);

impl Sectors {
    fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    fn root(&mut self, mut corner: usize) -> usize {
        while self.0[corner] as usize != corner {
            // Path halving: the way to the root is half as long for the next search.
            self.0[corner] = self.0[self.0[corner] as usize];
            corner = self.0[corner] as usize;
        }
        corner
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        // The lower index leads, so that the result does not depend on the order of joins.
        self.0[a.max(b)] = a.min(b) as u32;
    }
}
