// Noise over three-dimensional points, from integer hashes: the same on every machine, without the
// sine that graphics cards round each in their own way. All of it lies in [0, 1].
import chiaro::numeric;
import chiaro::total;

const NOISE_VALUE: u32 = 0u;
const NOISE_PERLIN: u32 = 1u;
const NOISE_SIMPLEX: u32 = 2u;
const NOISE_WORLEY: u32 = 3u;

// Half of what brings simplex noise to [-1, 1], from the greatest sum that any choice of gradients
// gives; and the average of Worley noise. Both measured in f64.
const SIMPLEX_SCALE: f32 = 38.4553;
const WORLEY_MEAN: f32 = 0.5205;

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
fn hash_pcg3d(seed: vec3u) -> vec3u {
    var v = seed * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// A random number in [0, 1) from the upper 24 bits of a hash, exactly.
fn unit_of_hash(hash: vec3u) -> vec3f {
    return vec3f(hash >> vec3u(8u)) * 5.9604644775390625e-8;
}

/// The hash of a lattice point.
fn lattice_hash(cell: vec3i, seed: u32) -> vec3u {
    return hash_pcg3d(bitcast<vec3u>(cell) + seed * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
fn gradient_dot(hash: vec3u, d: vec3f) -> f32 {
    let axis = (hash.x >> 8u) % 3u;
    let a = select(d.x, d.y, axis == 0u);
    let b = select(d.z, d.y, axis == 2u);
    return select(-a, a, (hash.y >> 31u) == 0u) + select(-b, b, (hash.z >> 31u) == 0u);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
fn fade_quintic(t: vec3f) -> vec3f {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// Value noise: random numbers at lattice points, smooth between them.
fn value_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let f = fade_quintic(p - corner);
    let cell = vec3i(corner);
    var sum = 0.0;
    for (var i = 0; i < 8; i++) {
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum += weight.x * weight.y * weight.z * unit_of_hash(lattice_hash(cell + at, seed)).x;
    }
    return sum;
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
fn perlin_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let f = fade_quintic(d);
    let cell = vec3i(corner);
    var sum = 0.0;
    for (var i = 0; i < 8; i++) {
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum += weight.x * weight.y * weight.z * gradient_dot(lattice_hash(cell + at, seed), d
            - vec3f(at));
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Gradient noise on a lattice of tetrahedra (Perlin 2001), with fewer visible axes than the
/// cube's.
fn simplex_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p + (p.x + p.y + p.z) / 3.0);
    let d = p - corner + (corner.x + corner.y + corner.z) / 6.0;
    // The tetrahedron's corners follow the order of the components.
    let is_first = vec3<bool>(d.x >= d.y, d.y >= d.z, d.z > d.x);
    let g = select(vec3f(0.0), vec3f(1.0), is_first);
    let l = 1.0 - g;
    let second = min(g, l.zxy);
    let third = max(g, l.zxy);
    let cell = vec3i(corner);
    var sum = simplex_corner(d, lattice_hash(cell, seed));
    sum += simplex_corner(d - second + 1.0 / 6.0, lattice_hash(cell + vec3i(second), seed));
    sum += simplex_corner(d - third + 1.0 / 3.0, lattice_hash(cell + vec3i(third), seed));
    sum += simplex_corner(d - 0.5, lattice_hash(cell + vec3i(1), seed));
    return clamp(0.5 + SIMPLEX_SCALE * sum, 0.0, 1.0);
}

/// Contribution of one corner of a tetrahedron at the offset d from it.
fn simplex_corner(d: vec3f, hash: vec3u) -> f32 {
    let t = max(0.5 - dot(d, d), 0.0);
    return t * t * t * t * gradient_dot(hash, d);
}

/// The distance to the nearest of one random point per cell (Worley 1996), at most 1.
fn worley_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let cell = vec3i(corner);
    // Beyond the neighbors every point is at least 1 away.
    var nearest = 1.0;
    for (var i = 0; i < 27; i++) {
        let at = vec3i(i % 3 - 1, (i / 3) % 3 - 1, i / 9 - 1);
        let offset = vec3f(at) + unit_of_hash(lattice_hash(cell + at, seed)) - d;
        nearest = min(nearest, dot(offset, offset));
    }
    return sqrt(nearest);
}

struct Cell {
    /// The distance to the nearest border, in cells.
    border: f32,
    /// A random number of the cell, in [0, 1).
    random: f32,
    /// The distance to the cell's point.
    distance: f32,
}

/// Least distance of the point of a cell that is no neighbor, in cells: points keep a quarter of a
/// cell from their cell's sides.
const CELL_REACH: f32 = 1.25;
/// Averages of border and distance, measured in f64.
const CELL_BORDER_MEAN: f32 = 0.1301;
const CELL_DISTANCE_MEAN: f32 = 0.491;

/// The cell around the nearest of one point per lattice cell, each in the middle half of its own.
///
/// The distance to the border, which lies midway between the two nearest points, ends at (1.25 -
/// distance) / 2: a point that was not looked at is at least 1.25 away, so no border of its is
/// nearer, and a farther border counts as that far.
fn nearest_cell(p: vec3f, seed: u32) -> Cell {
    let corner = floor(p);
    let d = p - corner;
    let cell = vec3i(corner);
    var nearest = vec3f(4.0);
    var hash = vec3u(0u);
    for (var i = 0; i < 27; i++) {
        let at = vec3i(i % 3 - 1, (i / 3) % 3 - 1, i / 9 - 1);
        let own = lattice_hash(cell + at, seed);
        let offset = vec3f(at) + 0.25 + 0.5 * unit_of_hash(own) - d;
        if dot(offset, offset) < dot(nearest, nearest) {
            nearest = offset;
            hash = own;
        }
    }
    let distance = length(nearest);
    var border = max(0.5 * (CELL_REACH - distance), 0.0);
    for (var i = 0; i < 27; i++) {
        let at = vec3i(i % 3 - 1, (i / 3) % 3 - 1, i / 9 - 1);
        let apart = vec3f(at) + 0.25 + 0.5 * unit_of_hash(lattice_hash(cell + at, seed)) - d
            - nearest;
        let between = length(apart);
        // Points are half a cell apart at least; a nearer one is the cell's own.
        if between > 0.25 {
            border = min(border, dot(nearest + 0.5 * apart, apart) / between);
        }
    }
    // The number has a hash other than that of the point's place, or it would tell where in its
    // cell the point lies.
    return Cell(max(border, 0.0), unit_of_hash(hash_pcg3d(hash)).x, distance);
}

/// One octave of the noise of a kind, `NOISE_VALUE` to `NOISE_WORLEY`.
fn noise_octave(kind: u32, p: vec3f, seed: u32) -> f32 {
    switch kind {
        case NOISE_PERLIN: {
            return perlin_noise(p, seed);
        }
        case NOISE_SIMPLEX: {
            return simplex_noise(p, seed);
        }
        case NOISE_WORLEY: {
            return worley_noise(p, seed);
        }
        default: {
            return value_noise(p, seed);
        }
    }
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
fn fractal_noise(kind: u32, p: vec3f, octaves: i32, roughness: f32, seed: i32, w: f32) -> f32 {
    let mean = select(0.5, WORLEY_MEAN, kind == NOISE_WORLEY);
    let gain = clamp(bounded(roughness), 0.0, 1.0);
    var sum = 0.0;
    var total = 0.0;
    var strength = 1.0;
    var frequency = 1.0;
    for (var i = 0; i < clamp(octaves, 1, 8); i++) {
        let visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        var octave = mean;
        if visible > 0.0 {
            // Octaves are taken from different places, so that their lattices do not meet at the
            // origin. Beyond 2^22 a float has no digits left for what lies between lattice points.
            let place = clamp(p * frequency + f32(i) * vec3f(17.31, 5.17, 11.73), vec3f(-4194304.0),
                vec3f(4194304.0));
            octave = mix(mean, noise_octave(kind, place, bitcast<u32>(seed) + u32(i)), visible);
        }
        sum += strength * octave;
        total += strength;
        strength *= gain;
        frequency *= 2.0;
    }
    return clamp(sum / total, 0.0, 1.0);
}

/// Strength below which [`fractal_noise_short`] leaves an octave out, over that of all octaves
/// before it.
const LEAST_OCTAVE: f32 = 0.075;

/// [`fractal_noise`] without the octaves from the first one on that has less than 0.075 of the
/// strength of all before it; they count as their average. With the usual roughness of 1/2 three
/// octaves are left.
fn fractal_noise_short(kind: u32, p: vec3f, octaves: i32, roughness: f32, seed: i32,
    w: f32) -> f32 {
    let mean = select(0.5, WORLEY_MEAN, kind == NOISE_WORLEY);
    let gain = clamp(bounded(roughness), 0.0, 1.0);
    // The number of octaves is known before the first runs, because not every GPU skips what a
    // branch leaves out.
    var kept = 0;
    var kept_total = 0.0;
    var total = 0.0;
    var strength = 1.0;
    for (var i = 0; i < clamp(octaves, 1, 8); i++) {
        let is_kept = strength >= LEAST_OCTAVE * total;
        kept += select(0, 1, is_kept);
        kept_total += select(0.0, strength, is_kept);
        total += strength;
        strength *= gain;
    }
    return clamp(mix(mean, fractal_noise(kind, p, kept, roughness, seed, w), kept_total / total),
        0.0, 1.0);
}
