import chiaro::antialias;
import chiaro::noise;
import chiaro::total;

/// Noise
///
/// Natural irregularity in space: clouds, grain, brush marks, blotches of paint. It sticks to the
/// object, is the same on every machine, and loses detail that the screen cannot show instead of
/// flickering.
///
/// @choice kind "Kind" default=perlin value="Value" perlin="Perlin" simplex="Simplex"
///   worley="Cells" : Value is blotchy, Perlin cloudy, Simplex cloudy without the cube's
///   directions; Cells (Worley) has round cells, dark in their middle.
/// @param position "Position" from=position_object : Where in the noise.
/// @param scale "Scale" default=5 : How many features there are in one unit of the position.
/// @param octaves "Octaves" default=1 min=1 max=8 : How often finer noise is added.
/// @param roughness "Roughness" default=0.5 min=0 max=1 : How strong each finer octave is beside
///   the one before.
/// @param seed "Seed" default=0 : Another number, another noise.
/// @return value "Value" : From 0 to 1, around 1/2.
/// @unit
/// @error fast 0.08 : fine octaves that are weak beside the coarse ones are left out; none of up to
///   three octaves, with the usual roughness
/// @source Perlin 2002, Worley 1996, Jarzynski and Olano 2020
fn noise_value(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise(NOISE_VALUE, p, octaves, roughness, seed, footprint_of_vec3(p));
}

fn noise_perlin(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

fn noise_simplex(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise(NOISE_SIMPLEX, p, octaves, roughness, seed, footprint_of_vec3(p));
}

fn noise_worley(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise(NOISE_WORLEY, p, octaves, roughness, seed, footprint_of_vec3(p));
}

fn noise_value_fast(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise_short(NOISE_VALUE, p, octaves, roughness, seed, footprint_of_vec3(p));
}

fn noise_perlin_fast(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise_short(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

fn noise_simplex_fast(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise_short(NOISE_SIMPLEX, p, octaves, roughness, seed, footprint_of_vec3(p));
}

fn noise_worley_fast(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise_short(NOISE_WORLEY, p, octaves, roughness, seed, footprint_of_vec3(p));
}
