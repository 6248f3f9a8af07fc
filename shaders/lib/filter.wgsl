// Filters of lights: shares of a light that pass what an artist puts in its way (docs/math.md 6.7).
import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::angle;
import chiaro::direction;
import chiaro::antialias;

/// The farthest that anything counts as from a shape, in sizes of the shape.
const FAR_FROM_SHAPE: f32 = 1000.0;

/// A share of a light, within [0, 1].
fn share_kept(share: f32) -> f32 {
    return clamp(bounded(share), 0.0, 1.0);
}

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
fn axes_turned(toward: vec3f, spin: f32) -> mat3x3f {
    let axes = axes_around(toward, vec3f(0.0, 1.0, 0.0));
    let turn = sin_cos_of(spin);
    return mat3x3f(turn.y * axes[0] + turn.x * axes[1], turn.y * axes[1] - turn.x * axes[0],
        axes[2]);
}

/// Half sizes of a shape, none of them 0.
fn half_size(size: vec3f) -> vec3f {
    return clamp(abs(bounded_vec3(size)), vec3f(1e-4), vec3f(1e6));
}

/// A place as seen from a center along axes, within a million of it.
fn place_along(place: vec3f, center: vec3f, axes: mat3x3f) -> vec3f {
    let away = clamp(bounded_vec3(place) - bounded_vec3(center), vec3f(-1e6), vec3f(1e6));
    return vec3f(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

/// The share of a light that passes a shape at distance m, 1 on its surface, in sizes of the shape:
/// its edge is `softness` wide outward, and never narrower than a pixel. Call it in uniform control
/// flow.
fn share_beside(m: f32, softness: f32, density: f32, inverted: bool) -> f32 {
    let near = min(m, FAR_FROM_SHAPE);
    // Where the nearest part is another one the distance leaps, and no edge is there.
    let half = 0.5 * min(footprint_of(near), 0.25);
    let beside = eased(near, 1.0 - half, 1.0 + max(clamp(bounded(softness), 0.0, 100.0), half));
    let covered = select(1.0 - beside, beside, inverted);
    return 1.0 - share_kept(density) * covered;
}

/// The way from a place toward a light, in a shape's axes: where it starts, and the whole of it,
/// very long where the light is infinitely far.
struct LightWay {
    start: vec3f,
    whole: vec3f,
}

/// The least distance from the middle of a round shape of radius 1 along a way.
fn way_past_ball(way: LightWay) -> f32 {
    let square = max(dot(way.whole, way.whole), 1e-20);
    let t = clamp(-dot(way.start, way.whole) / square, 0.0, 1.0);
    return length(way.start + t * way.whole);
}

/// The size of a place's largest coordinate.
fn largest_of(v: vec3f) -> f32 {
    return max(max(abs(v.x), abs(v.y)), abs(v.z));
}

/// The lesser of `least` and the largest coordinate at the place of the way where a + slope t is 0.
fn turn_past_box(way: LightWay, a: f32, slope: f32, least: f32) -> f32 {
    let t = clamp(divided(-a, slope), 0.0, 1.0);
    return min(least, largest_of(way.start + t * way.whole));
}

/// The least of the largest coordinate along a way: below 1 where the way passes through the cube
/// from -1 to 1. It is the largest of six lines over the way, so that its minimum lies at an end or
/// where two of them cross.
fn way_past_box(way: LightWay) -> f32 {
    let s = way.start;
    let w = way.whole;
    var least = min(largest_of(s), largest_of(s + w));
    least = turn_past_box(way, s.x, w.x, least);
    least = turn_past_box(way, s.y, w.y, least);
    least = turn_past_box(way, s.z, w.z, least);
    least = turn_past_box(way, s.x - s.y, w.x - w.y, least);
    least = turn_past_box(way, s.x + s.y, w.x + w.y, least);
    least = turn_past_box(way, s.x - s.z, w.x - w.z, least);
    least = turn_past_box(way, s.x + s.z, w.x + w.z, least);
    least = turn_past_box(way, s.y - s.z, w.y - w.z, least);
    return turn_past_box(way, s.y + s.z, w.y + w.z, least);
}

/// The least distance between a way and the line of length 2 `reach` along z through the middle.
fn way_past_line(way: LightWay, reach: f32) -> f32 {
    // Where the way is nearest to the whole axis; kept to the line, then the way's nearest to that
    // place, and the line's nearest to that one.
    let w = way.whole;
    let flat_square = dot(w.xy, w.xy);
    let whole_square = max(dot(w, w), 1e-20);
    let t = clamp(divided(-dot(way.start.xy, w.xy), flat_square), 0.0, 1.0);
    let along = clamp(way.start.z + t * w.z, -reach, reach);
    let end = vec3f(0.0, 0.0, along);
    let u = clamp(-dot(way.start - end, w) / whole_square, 0.0, 1.0);
    let second = vec3f(0.0, 0.0, clamp(way.start.z + u * w.z, -reach, reach));
    return min(length(way.start + u * w - end), length(way.start + u * w - second));
}

/// The largest of x and y where a way passes z = 0; far where it does not.
fn way_past_card(way: LightWay) -> f32 {
    let t = divided(-way.start.z, way.whole.z);
    let at = way.start.xy + clamp(t, 0.0, 1.0) * way.whole.xy;
    let passes = (t > 0.0) & (t <= 1.0) & (way.whole.z != 0.0);
    return select(FAR_FROM_SHAPE, max(abs(at.x), abs(at.y)), passes);
}

/// The distance that a light's way passes a shape at, in sizes of the shape: 0 a ball, 1 a box, 2 a
/// capsule, 3 a card.
fn way_past_shape(way: LightWay, shape: i32, size: vec3f) -> f32 {
    if shape == 2 {
        return way_past_line(LightWay(way.start / size.x, way.whole / size.x), size.z / size.x);
    }
    let scaled = LightWay(way.start / size, way.whole / size);
    if shape == 1 {
        return way_past_box(scaled);
    }
    if shape == 3 {
        return way_past_card(scaled);
    }
    return way_past_ball(scaled);
}

/// The share of a lamp's light that passes between four flaps, for a place as the lamp sees it and
/// the angles to the left, right, top and bottom flap.
fn share_of_doors(seen: vec3f, flaps: vec4f, softness: f32) -> f32 {
    let angles = vec2f(angle_of_point(seen.x, seen.z), angle_of_point(seen.y, seen.z));
    // Behind the lamp angles leap, and no edge is there.
    let half = 0.5 * min(footprint_of_vec2(angles), vec2f(0.1));
    let width = clamp(bounded(softness), 0.0, 1.6);
    let edges = clamp(bounded_vec4(flaps), vec4f(0.0), vec4f(1.58));
    // For who looks along z, x is to the left.
    let aside = beside_flap(angles.x, edges.x, half.x, width)
        * beside_flap(-angles.x, edges.y, half.x, width);
    return aside * beside_flap(angles.y, edges.z, half.y, width)
        * beside_flap(-angles.y, edges.w, half.y, width);
}

/// 1 up to a flap and 0 beyond its edge.
fn beside_flap(angle: f32, flap: f32, half: f32, width: f32) -> f32 {
    return 1.0 - eased(angle, flap - half, flap + max(width, half));
}

/// From a lamp to a place, in scene units.
fn lamp_distance(light_position: vec3f, position: vec3f) -> f32 {
    return length_of(bounded_vec3(position) - bounded_vec3(light_position));
}

/// An angle as a filter before the profile leaves it: tan(u/2) over the share that passes, so that
/// the dark side grows from its edge as less passes, and everything is dark where nothing does.
fn angle_filtered(u: Angle, share: f32) -> Angle {
    let cosine = u.half_cos * share;
    let square = u.half_sin * u.half_sin + cosine * cosine;
    let scale = inverseSqrt(max(square, 1e-30));
    let is_dark = square < 1e-30;
    return Angle(select(u.half_sin * scale, 1.0, is_dark), select(cosine * scale, 0.0, is_dark));
}
