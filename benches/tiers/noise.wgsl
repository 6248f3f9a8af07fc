import chiaro::noise;
import chiaro::antialias;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

fn place(n: vec3f, s: f32) -> vec3f {
    return bounded_vec3(vec3f(n.xy, s) * (5.0 + f32(repeats.y)));
}

/// Perlin noise of 4 octaves.
fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let p = place(n, s);
    return fractal_noise(NOISE_PERLIN, p, 4 + i32(repeats.y), 0.5, 1, footprint_of_vec3(p));
}

fn three_octaves(n: vec3f, l: vec3f, s: f32) -> f32 {
    let p = place(n, s);
    return fractal_noise(NOISE_PERLIN, p, 3 + i32(repeats.y), 0.5, 1, footprint_of_vec3(p));
}

fn two_octaves(n: vec3f, l: vec3f, s: f32) -> f32 {
    let p = place(n, s);
    return fractal_noise(NOISE_PERLIN, p, 2 + i32(repeats.y), 0.5, 1, footprint_of_vec3(p));
}

fn not_filtered(n: vec3f, l: vec3f, s: f32) -> f32 {
    let p = place(n, s);
    return fractal_noise(NOISE_PERLIN, p, 4 + i32(repeats.y), 0.5, 1, 0.0);
}

fn value_noise_4(n: vec3f, l: vec3f, s: f32) -> f32 {
    let p = place(n, s);
    return fractal_noise(NOISE_VALUE, p, 4 + i32(repeats.y), 0.5, 1, footprint_of_vec3(p));
}

/// Hash by one multiplication and two shifts a lattice point, in place of PCG3D.
fn small_hash(cell: vec3i, seed: u32) -> vec3u {
    let c = bitcast<vec3u>(cell) * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u);
    var h = c.x ^ c.y ^ c.z ^ seed;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h ^= h >> 12u;
    return vec3u(h, h << 8u, h << 16u);
}

fn small_perlin(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let f = fade_quintic(d);
    let cell = vec3i(corner);
    var sum = 0.0;
    for (var i = 0; i < 8; i++) {
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum += weight.x * weight.y * weight.z *
            gradient_dot(small_hash(cell + at, seed), d - vec3f(at));
    }
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

fn cheaper_hash(n: vec3f, l: vec3f, s: f32) -> f32 {
    let p = place(n, s);
    let w = footprint_of_vec3(p);
    var sum = 0.0;
    var strength = 1.0;
    var frequency = 1.0;
    for (var i = 0; i < 4 + i32(repeats.y); i++) {
        let visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        let at = clamp(p * frequency + f32(i) * vec3f(17.31, 5.17, 11.73), vec3f(-4194304.0),
            vec3f(4194304.0));
        sum += strength * mix(0.5, small_perlin(at, 1u + u32(i)), visible);
        strength *= 0.5;
        frequency *= 2.0;
    }
    return sum / 1.875;
}

fn kept_fast(n: vec3f, l: vec3f, s: f32) -> f32 {
    let p = place(n, s);
    return fractal_noise_short(NOISE_PERLIN, p, 4 + i32(repeats.y), 0.5, 1, footprint_of_vec3(p));
}
