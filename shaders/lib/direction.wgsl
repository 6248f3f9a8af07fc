// Directions bent within two axes, as highlights are shaped by hand (Anjyo and Hiramitsu 2003):
// translation, directional scaling, splitting and squaring, and places around a direction in polar
// coordinates (Pacanowski et al. 2008).
import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::angle;

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    direction: vec3f,
    x_axis: vec3f,
    y_axis: vec3f,
    /// The direction's cosines with the two axes.
    place: vec2f,
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
fn direction_within(direction: vec3f, x_axis: vec3f, y_axis: vec3f) -> DirectionParts {
    let d = normalize_or(direction, vec3f(0.0, 0.0, 1.0));
    let x = normalize_or(x_axis, vec3f(0.0));
    let y = normalize_or(y_axis, vec3f(0.0));
    return DirectionParts(d, x, y, vec2f(dot(d, x), dot(d, y)));
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
fn direction_moved(parts: DirectionParts, by: vec2f) -> vec3f {
    // Farther than a million the direction lies along the axis.
    let step = clamp(by, vec2f(-1e6), vec2f(1e6));
    let moved = parts.direction + step.x * parts.x_axis + step.y * parts.y_axis;
    // The direction of a sum of nearly 0 would be rounding's.
    return select(parts.direction, normalize_or(moved, parts.direction), dot(moved, moved) > 1e-6);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
fn axes_around(toward: vec3f, up: vec3f) -> mat3x3f {
    let z = normalize_or(toward, vec3f(0.0, 0.0, 1.0));
    let y = normalize_or(up, vec3f(0.0, 1.0, 0.0));
    let leaning = cross(y, z);
    let square = dot(leaning, leaning);
    // Where `toward` is nearly along `up` no direction is upright; a fixed one is better than
    // rounding's.
    let aside = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), abs(z.x) > 0.7);
    let across = select(cross(aside, z), leaning, square > 1e-8);
    // The part along z that rounding left in `across`, short as that may be, would tilt x.
    let x = normalize_or(across - dot(across, z) * z, vec3f(1.0, 0.0, 0.0));
    return mat3x3f(x, cross(z, x), z);
}

/// Radius of a star at `turn`, in turns from its first ray: 1 at its rays, `inner` between them,
/// along straight lines; `round` from 0 to 1 goes from there to a circle.
fn star_reach(turn: f32, rays: f32, inner: f32, round: f32) -> f32 {
    let half_sector = PI / rays;
    let sector = abs(turn * rays - floor(turn * rays + 0.5));
    let from_ray = sin_cos_quarter(min(2.0 * sector * half_sector, HALF_PI));
    let between = sin_cos_quarter(clamp((1.0 - 2.0 * sector) * half_sector, 0.0, HALF_PI));
    let corner = sin_cos_quarter(min(half_sector, HALF_PI)).x;
    let straight = inner * corner / max(inner * between.x + from_ray.x, 1e-6);
    return mix(straight, 1.0, round);
}
