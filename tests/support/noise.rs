//! Hashes and noise in f64, written anew from the published integer formulas.

use glam::DVec3;

/// PCG3D of Jarzynski and Olano 2020.
pub fn pcg3d(v: [u32; 3]) -> [u32; 3] {
    let mut v = v.map(|x| x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    let mix = |v: &mut [u32; 3]| {
        v[0] = v[0].wrapping_add(v[1].wrapping_mul(v[2]));
        v[1] = v[1].wrapping_add(v[2].wrapping_mul(v[0]));
        v[2] = v[2].wrapping_add(v[0].wrapping_mul(v[1]));
    };
    mix(&mut v);
    v = v.map(|x| x ^ (x >> 16));
    mix(&mut v);
    v
}

/// The hash of a lattice point.
pub fn lattice(cell: [i64; 3], seed: u32) -> [u32; 3] {
    let salt = [0x9e37_79b9_u32, 0x85eb_ca6b, 0xc2b2_ae35];
    pcg3d(std::array::from_fn(|i| (cell[i] as u32).wrapping_add(seed.wrapping_mul(salt[i]))))
}

/// Upper 24 bits of each word of a hash as a number in [0, 1).
pub fn unit3(hash: [u32; 3]) -> DVec3 {
    DVec3::from_array(hash.map(|h| f64::from(h >> 8) / f64::from(1 << 24)))
}

/// The gradient of a hash: one of the twelve edges of a cube.
fn gradient(hash: [u32; 3]) -> DVec3 {
    let s = |h: u32| if h >> 31 == 0 { 1.0 } else { -1.0 };
    let (a, b) = (s(hash[1]), s(hash[2]));
    match (hash[0] >> 8) % 3 {
        0 => DVec3::new(0.0, a, b),
        1 => DVec3::new(a, 0.0, b),
        _ => DVec3::new(a, b, 0.0),
    }
}

/// One octave of a kind of noise.
pub fn noise(kind: &str, p: DVec3, seed: u32) -> f64 {
    let corner = p.floor();
    let cell = corner.to_array().map(|x| x as i64);
    let d = p - corner;
    let fade = |t: f64| t.powi(3) * (6.0 * t * t - 15.0 * t + 10.0);
    let corners = (0..8).map(|i| [i & 1, (i >> 1) & 1, i >> 2]);
    let weight = |at: [i64; 3]| -> f64 {
        (0..3).map(|i| if at[i] == 1 { fade(d[i]) } else { 1.0 - fade(d[i]) }).product()
    };
    let hash = |at: [i64; 3]| lattice(std::array::from_fn(|i| cell[i] + at[i]), seed);
    match kind {
        "value" => corners.map(|at| weight(at) * unit3(hash(at)).x).sum(),
        "perlin" => {
            let reach =
                |at: [i64; 3]| gradient(hash(at)).dot(d - DVec3::from_array(at.map(|x| x as f64)));
            0.5 + 0.48244 * corners.map(|at| weight(at) * reach(at)).sum::<f64>()
        }
        "worley" => {
            let mut nearest = 1.0_f64;
            for i in -1..2 {
                for j in -1..2 {
                    for k in -1..2 {
                        let point =
                            DVec3::new(i as f64, j as f64, k as f64) + unit3(hash([i, j, k]));
                        nearest = nearest.min(point.distance(d));
                    }
                }
            }
            nearest
        }
        _ => simplex(p, seed),
    }
}

/// Simplex noise. The tetrahedron's corners come from sorting the offsets: the largest component
/// steps first.
fn simplex(p: DVec3, seed: u32) -> f64 {
    let corner = (p + (p.x + p.y + p.z) / 3.0).floor();
    let origin = corner - (corner.x + corner.y + corner.z) / 6.0;
    let d = p - origin;
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| d[*b].total_cmp(&d[*a]));
    let mut at = [0_i64; 3];
    let mut sum = 0.0;
    for step in 0..4 {
        let offset = DVec3::from_array(at.map(|x| x as f64));
        let reach = d - offset + f64::from(step) / 6.0;
        let cell = std::array::from_fn(|i| corner[i] as i64 + at[i]);
        sum += (0.5 - reach.length_squared()).max(0.0).powi(4)
            * gradient(lattice(cell, seed)).dot(reach);
        if step < 3 {
            at[order[step as usize]] += 1;
        }
    }
    (0.5 + 38.4553 * sum).clamp(0.0, 1.0)
}
