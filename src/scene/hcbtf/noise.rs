//! Pseudorandom numbers that are the same on every machine, and noise that repeats with the tile.

/// A well mixed number from another: a step of splitmix64 (Steele, Lea and Flood 2014).
pub(super) fn mixed(number: u64) -> u64 {
    let mut mixed = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
}

/// A well mixed number from a seed and two coordinates.
pub(super) fn hash(seed: u32, x: i64, y: i64) -> u64 {
    let seed = u64::from(seed).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    [x as u64, y as u64].into_iter().fold(seed, |hash, part| mixed(hash ^ part))
}

/// A number in [0, 1) from a seed and two coordinates.
pub(super) fn chance(seed: u32, x: i64, y: i64) -> f32 {
    (hash(seed, x, y) >> 40) as f32 / (1 << 24) as f32
}

/// Three more numbers in [0, 1) from one hash.
pub(super) fn chances(hash: u64) -> [f32; 3] {
    [0, 21, 42].map(|shift| ((hash >> shift) & 0x1f_ffff) as f32 / (1 << 21) as f32)
}

/// Smooth noise in [0, 1] with `cells` bumps along the tile's sides, at a position on the tile in
/// [0, 1).
pub(super) fn smooth(seed: u32, cells: [u32; 2], place: [f32; 2]) -> f32 {
    let [(x, fx), (y, fy)] = [0, 1].map(|axis| {
        let at = place[axis] * cells[axis] as f32;
        let f = at - at.floor();
        (at.floor() as i64, f * f * (3.0 - 2.0 * f))
    });
    let [wide, high] = cells.map(i64::from);
    let corner =
        |dx: i64, dy: i64| chance(seed, (x + dx).rem_euclid(wide), (y + dy).rem_euclid(high));
    let row = |dy| corner(0, dy) + (corner(1, dy) - corner(0, dy)) * fx;
    row(0) + (row(1) - row(0)) * fy
}

/// Noise in [0, 1] of several octaves, the first with `cells` bumps along the tile's sides.
pub(super) fn rough(seed: u32, cells: [u32; 2], octaves: u32, place: [f32; 2]) -> f32 {
    let (mut sum, mut weight, mut all) = (0.0, 1.0, 0.0);
    for octave in 0..octaves {
        let finer = cells.map(|count| count << octave);
        sum += weight * smooth(seed.wrapping_add(octave), finer, place);
        all += weight;
        weight *= 0.5;
    }
    if all > 0.0 { sum / all } else { 0.5 }
}

/// A smooth ramp: 0 below `low`, 1 above `high`, smooth between.
pub(super) fn ramp(low: f32, high: f32, x: f32) -> f32 {
    let at = ((x - low) / (high - low).max(1e-6)).clamp(0.0, 1.0);
    at * at * (3.0 - 2.0 * at)
}

pub(super) fn mix(a: f32, b: f32, share: f32) -> f32 {
    a + (b - a) * share
}

pub(super) fn mix3(a: [f32; 3], b: [f32; 3], share: f32) -> [f32; 3] {
    std::array::from_fn(|i| mix(a[i], b[i], share))
}
