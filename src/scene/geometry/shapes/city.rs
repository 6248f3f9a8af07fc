//! A city of plain houses, of as many triangles as the thesis's (27,860): for paint that is laid on
//! walls in repeats.

use glam::DVec3;

use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, TriangleSoup};

/// Number of lots along each side.
const LOTS: u32 = 53;
/// Number of lots between two streets.
const BLOCK: u32 = 4;
/// Width of a street, in lots.
const STREET: f64 = 1.0;
/// Number of lots that stay empty, as squares and yards.
const EMPTY: usize = 24;
/// Number of repeats of the paint along the side of a lot; a repeat is a window wide and a floor
/// high.
const BAYS: f64 = 2.0;

/// The city: a square of houses on the ground, from -1 to 1 along x and z, y up. Walls have whole
/// repeats of the paint, u to the right and v up; roofs and ground have repeats of the same size.
pub(super) fn city() -> TriangleSoup {
    let whole = along(LOTS);
    let scale = 2.0 / whole;
    let mut builder = Builder { soup: TriangleSoup::default(), bay: scale / BAYS };
    builder.ground();
    let empty = empty();
    for index in (0..LOTS * LOTS).filter(|index| !empty.contains(index)) {
        let (i, j) = (index % LOTS, index / LOTS);
        let [first, second, third, fourth] = [0, 1, 2, 3].map(|n| chance(index, n));
        let corner = DVec3::new(along(i), 0.0, along(j)) * scale - DVec3::new(1.0, 0.0, 1.0);
        // Houses keep a small distance from their neighbors, or fill the lot.
        let inset = scale * (0.04 + 0.16 * first * second);
        let size = scale - 2.0 * inset;
        let middle = corner + DVec3::new(scale, 0.0, scale) / 2.0;
        // Houses are taller toward the middle, with a tower here and there.
        let center = (-4.0 * middle.length_squared()).exp();
        let floors =
            2.0 + (5.0 * third).floor() + (center * (8.0 * fourth + 26.0 * fourth.powi(6))).floor();
        let from = corner + DVec3::new(inset, 0.0, inset);
        builder.house(from, DVec3::new(size, floors * builder.bay, size));
    }
    let mut soup = builder.soup;
    let material = soup.material(DEFAULT_MATERIAL);
    soup.wear(material);
    soup
}

/// The distance from the city's edge to a lot, in lots, with the streets before it.
fn along(lot: u32) -> f64 {
    f64::from(lot) + STREET * f64::from(lot / BLOCK)
}

/// The indices of the lots without a house.
fn empty() -> Vec<u32> {
    let mut lots = Vec::with_capacity(EMPTY);
    for n in 0.. {
        let lot = (chance(n, 9) * f64::from(LOTS * LOTS)) as u32;
        if !lots.contains(&lot) {
            lots.push(lot);
        }
        if lots.len() == EMPTY {
            break;
        }
    }
    lots
}

/// A pseudorandom number in [0, 1), always the same for the same arguments (the finisher of
/// MurmurHash3, Appleby).
fn chance(of: u32, which: u32) -> f64 {
    let mut h = of.wrapping_mul(0x9e37_79b1) ^ which.wrapping_add(1).wrapping_mul(0x85eb_ca77);
    h = (h ^ (h >> 16)).wrapping_mul(0x85eb_ca6b);
    h = (h ^ (h >> 13)).wrapping_mul(0xc2b2_ae35);
    f64::from(h ^ (h >> 16)) / 4_294_967_296.0
}

struct Builder {
    soup: TriangleSoup,
    /// Length of a repeat of the paint.
    bay: f64,
}

impl Builder {
    /// Appends four walls and a flat roof.
    fn house(&mut self, from: DVec3, size: DVec3) {
        let (x, y, z) = (DVec3::X * size.x, DVec3::Y * size.y, DVec3::Z * size.z);
        for (corner, right) in [(from + z, x), (from + x + z, -z), (from + x, -x), (from, z)] {
            // Walls have whole windows only.
            let bays = (right.length() / self.bay).round().max(1.0);
            self.quad(corner, right, y, [bays, (size.y / self.bay).round()]);
        }
        self.quad(from + y + z, x, -z, [size.x / self.bay, size.z / self.bay]);
    }

    /// Appends the ground in five strips, which with the houses make as many triangles as the
    /// thesis's city has.
    fn ground(&mut self) {
        const STRIPS: u32 = 5;
        let depth = 2.0 / f64::from(STRIPS);
        for strip in 0..STRIPS {
            let corner = DVec3::new(-1.0, 0.0, -1.0 + depth * f64::from(strip + 1));
            self.quad(
                corner,
                DVec3::X * 2.0,
                DVec3::NEG_Z * depth,
                [2.0 / self.bay, depth / self.bay],
            );
        }
    }

    /// Appends a quad of two triangles, whose front is on the side from which `up` stands left of
    /// `right`.
    fn quad(&mut self, corner: DVec3, right: DVec3, up: DVec3, repeats: [f64; 2]) {
        let normal = right.cross(up).normalize_or(DVec3::Y).as_vec3().to_array();
        let base = self.soup.points.len() as u32;
        for (u, v) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            self.soup.points.push((corner + right * u + up * v).as_vec3().to_array());
            self.soup.normals.push(normal);
            self.soup.uvs.push([u * repeats[0], v * repeats[1]].map(|x| x as f32));
        }
        let corner = |k: u32| Corner { point: base + k, normal: base + k, uv: base + k };
        let [a, b, c, d] = [0, 1, 2, 3].map(corner);
        self.soup.triangles.extend([[a, b, c], [a, c, d]]);
    }
}
