// Occlusion by horizons (docs/math.md 6.8): how far what a pixel's surroundings show rises above
// its surface, to both sides of slices through the line of sight. A slice is an integral that needs
// no rays (Jimenez et al. 2016).
//
// Each pixel looks along two slices of 32, at distances of its own: another for each of four by
// four pixels, so that the mean over as many holds all of them, and nothing is left to chance.
import chiaro::curvature_map;
import chiaro::near_shares;

/// Half a turn, in radians.
const HALF_TURN = 3.14159265358979323846;
/// Slices through a pixel, pixels of the pattern along a side, and samples along half a slice.
const SLICES = 2;
const PATTERN = 4;
const SAMPLES = 16;
/// Octaves of distance, from one step to the farthest.
const OCTAVES = 8.0;
/// Heights over the plane of a surface, as sines, from which what stands there begins to count and
/// counts in full: below are folds that normals smooth.
const LEAST_HEIGHT = 0.02;
const FULL_HEIGHT = 0.07;
/// Difference of neighbors' normals from which they are of other surfaces, by their cosine.
const LEAST_ALIKE = 0.7;
const ALIKE = 0.9;

/// A pixel's surface as what surrounds it is seen from there, in camera axes.
struct Outlook {
    /// The pixel's middle, in pixels of the image.
    place: vec2f,
    position: vec3f,
    /// Unit.
    normal: vec3f,
    /// Unit, toward the eye.
    toward: vec3f,
    /// Change of depth from a pixel to the next.
    rise: vec2f,
    /// Size in scene units of a step of 1/800 of the picture's height.
    step: f32,
}

/// The place in camera axes of what is seen at a place of the image, at a depth.
fn place_seen(place: vec2f, depth: f32) -> vec3f {
    let from_middle = place - 0.5 * vec2f(textureDimensions(surface));
    let size = curvature.pixel * mix(1.0, depth, curvature.perspective);
    return vec3f(size * from_middle * vec2f(1.0, row_direction()), -depth);
}

fn outlook_from(pixel: vec2i, texel: vec4f) -> Outlook {
    let place = vec2f(pixel) + 0.5;
    let position = place_seen(place, texel.z);
    let normal = normal_of(texel);
    let toward = mix(vec3f(0.0, 0.0, 1.0), -position, curvature.perspective);
    let size = curvature.pixel * mix(1.0, texel.z, curvature.perspective);
    // The eye along the line of sight, 1 deep: by it depth changes with places.
    let facing = dot(normal, vec3f(toward.xy / max(toward.z, 1e-30), 1.0));
    let rise = size * normal.xy * vec2f(1.0, row_direction()) / max(facing, LEAST_NZ);
    return Outlook(place, position, normal, normalize(toward), rise,
        size * f32(step_pixels()));
}

/// Cosines between the line of sight and the horizon, of what stands within each of the distances
/// of [`NearShares`].
struct Horizons {
    near: vec4f,
    far: vec4f,
}

/// The horizons along one way, a unit vector in pixels of the image. `level` is that of the
/// surface's own plane; `shift` moves all distances, by a share of that between two.
fn horizons_along(own: Outlook, way: vec2f, level: f32, shift: f32) -> Horizons {
    let size = vec2i(textureDimensions(surface));
    var horizons = Horizons(vec4f(level), vec4f(level));
    for (var index = 0; index < SAMPLES; index++) {
        let steps = exp2((f32(index) + shift) * (OCTAVES / f32(SAMPLES)));
        let place = own.place + f32(step_pixels()) * steps * way;
        let at = vec2i(floor(place));
        if any(at < vec2i(0)) || any(at >= size) {
            break;
        }
        let texel = textureLoad(surface, at, 0);
        if texel.w == 0.0 {
            continue;
        }
        // What the pixel's middle shows, moved to the place along the own plane: a plane stays one.
        let moved = place - (vec2f(at) + 0.5);
        let there = place_seen(place, texel.z + dot(own.rise, moved));
        let way_there = there - own.position;
        let distance = max(length(way_there), 1e-30);
        let direction = way_there / distance;
        let height = dot(direction, own.normal);
        let share = clamp((height - LEAST_HEIGHT) / (FULL_HEIGHT - LEAST_HEIGHT), 0.0, 1.0);
        let horizon = dot(direction, own.toward);
        // Beside each distance the horizon goes over from all to nothing.
        let ratio = 2.0 * distance / max(own.step, 1e-30);
        let near = share * clamp(2.5 - ratio / NEAR_ENDS, vec4f(0.0), vec4f(1.0));
        let far = share * clamp(2.5 - ratio / FAR_ENDS, vec4f(0.0), vec4f(1.0));
        horizons.near = max(horizons.near, mix(vec4f(level), vec4f(horizon), near));
        horizons.far = max(horizons.far, mix(vec4f(level), vec4f(horizon), far));
    }
    return horizons;
}

/// What a slice leaves free between two horizons, by their cosines: the integral of the cosine from
/// the normal, whose angle from the line of sight has this sine and cosine, times the sine from the
/// line of sight.
fn free_between(ahead: vec4f, behind: vec4f, tilt: vec2f) -> vec4f {
    let a = clamp(ahead, vec4f(-1.0), vec4f(1.0));
    let b = clamp(behind, vec4f(-1.0), vec4f(1.0));
    // Angles a and -b: cos 2h and sin 2h of both.
    let cosines = 2.0 * (a * a + b * b) - 2.0;
    let sines = 2.0 * (a * sqrt(max(1.0 - a * a, vec4f(0.0))) - b * sqrt(max(1.0 - b * b,
        vec4f(0.0))));
    return 0.25 * (tilt.y * (2.0 - cosines) + tilt.x * (2.0 * (acos(a) - acos(b)) - sines));
}

/// Shares of what is seen from a pixel that stand near, along its own slices.
fn shares_at(pixel: vec2i, texel: vec4f) -> NearShares {
    let own = outlook_from(pixel, texel);
    let cell = vec2i(pixel.x & (PATTERN - 1), pixel.y & (PATTERN - 1));
    // Neighbors have slices far apart, and each slice is shifted by another quarter.
    let turn = f32((4 * cell.x + 9 * cell.y) & 15) / 16.0;
    let shift = f32((cell.x + 2 * cell.y) & 3) / 4.0 + 0.125;
    var free = NearShares(vec4f(0.0), vec4f(0.0));
    var all = 0.0;
    for (var slice = 0; slice < SLICES; slice++) {
        let angle = (f32(slice) + turn) * (HALF_TURN / f32(SLICES));
        let way = vec2f(cos(angle), sin(angle));
        // The slice's own axes: the line of sight, and a direction across it.
        let ahead = vec3f(way * vec2f(1.0, row_direction()), 0.0);
        let across = normalize(ahead - dot(ahead, own.toward) * own.toward);
        let tilt = vec2f(dot(own.normal, across), dot(own.normal, own.toward));
        let weight = length(tilt);
        let unit = tilt / max(weight, 1e-6);
        let front = horizons_along(own, way, -unit.x, shift);
        let back = horizons_along(own, -way, unit.x, shift);
        let level = free_between(vec4f(-unit.x), vec4f(unit.x), unit).x;
        free.near += weight * free_between(front.near, back.near, unit);
        free.far += weight * free_between(front.far, back.far, unit);
        all += weight * level;
    }
    let share = 1.0 / max(all, 1e-6);
    return NearShares(1.0 - share * free.near, 1.0 - share * free.far);
}
