// How much of a light is kept from a pixel, as a tone: by one ray, by a beam as wide as the pixel,
// and by rays to all of a light that has a size.
import chiaro::types;
import chiaro::numeric;
import chiaro::casters;
import chiaro::beams;

/// Rays toward a light with a size: all, but where the first of them are all blocked.
const FIRST_LIGHT_RAYS = 32;
const LIGHT_RAYS = 64;

/// A surface as its shadows see it.
struct Receiver {
    position: vec3f,
    /// From a pixel's place to those of its neighbors on the right and below.
    across: vec3f,
    down: vec3f,
    /// The light's place and 1, or the direction toward it and 0.
    source: vec4f,
    /// Radius of the light: in scene units, or of a directional one at a distance of 1.
    size: f32,
    /// The light's `casters`.
    casters: f32,
    /// Number of the object.
    object: f32,
    facet: Facet,
}

/// The receiver at a place. `caster_set` is the light's `casters`, and `size` its radius.
fn receiver_at(
    position: vec3f,
    across: vec3f,
    down: vec3f,
    source: vec4f,
    size: f32,
    caster_set: f32,
    object: f32,
    facet: Facet,
) -> Receiver {
    return Receiver(position, across, down, source, told_at(radius_of(size), position),
        told_at(caster_set, position), object, facet);
}

/// A number that is -2 or more, as it is. Branches on what is the same for a whole draw are for
/// software Vulkan (lavapipe) a reason to compile the shader anew, for every draw, with that value
/// in it, and to keep what it compiled; so branches here seem to depend on the place, too.
fn told_at(number: f32, position: vec3f) -> f32 {
    return max(number, -3.0 - abs(position.x));
}

/// The way to the light from a place: to all of it, or for a directional one of length 1.
fn way_to_light(source: vec4f, place: vec3f) -> vec3f {
    let toward = source.xyz - source.w * place;
    let unit = normalize_or(toward, vec3f(0.0, 0.0, 1.0));
    return select(unit, toward, source.w > 0.5);
}

/// The ray from a place of a pixel, 0,0 its middle and 0.5,0.5 its lower right corner, toward a
/// place of the light within a disk of radius 1.
fn ray_from(receiver: Receiver, at: vec2f, of_light: vec2f) -> Ray {
    let moved = at.x * receiver.across + at.y * receiver.down;
    let origin = receiver.position + moved;
    let source = receiver.source;
    let toward = source.xyz - source.w * origin;
    let length = sqrt(dot(toward, toward));
    // Two directions across the way to the light, on the axis that is farthest from it.
    let axis = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), abs(toward.x) > 0.6 * length);
    let side = normalize_or(cross(toward, axis), vec3f(0.0, 0.0, 1.0));
    let up = normalize_or(cross(side, toward), vec3f(0.0, 1.0, 0.0));
    let aimed = toward + receiver.size * (of_light.x * side + of_light.y * up);
    let direction = normalize_or(aimed, vec3f(0.0, 0.0, 1.0));
    // A directional light has no end; a lamp is no blocker of itself.
    let end = select(1e30, 0.99999 * sqrt(dot(aimed, aimed)), source.w > 0.5);
    let under = sqrt(dot(moved, moved));
    return Ray(origin, direction, inverse_of(direction), end, 0.0, under, 2.0 * under);
}

/// 1 where a ray is blocked, else 0: by the object itself, or by others.
fn is_blocked(
    casters: Casters,
    receiver: Receiver,
    at: vec2f,
    of_light: vec2f,
    by_itself: bool,
) -> f32 {
    let ray = ray_from(receiver, at, of_light);
    var distance = -1.0;
    if by_itself {
        let row = object_row(receiver.object);
        distance = meets_object(casters, row, ray, receiver.facet, true);
    } else {
        let root = caster_root(receiver.casters);
        distance = meets_others(casters, root, ray, receiver.object, true).x;
    }
    return select(0.0, 1.0, distance > 0.0);
}

/// True if anything casts the light's shadow onto the surface: the object itself, or others.
fn can_be_blocked(receiver: Receiver, by_itself: bool) -> bool {
    let has_others = caster_root(receiver.casters) >= 0;
    return select(has_others, casts_on_itself(receiver.casters), by_itself);
}

/// The share of a light that is kept from a pixel, by one ray from its middle: 0 or 1.
fn shadow_of_ray(casters: Casters, receiver: Receiver, by_itself: bool) -> f32 {
    if !can_be_blocked(receiver, by_itself) {
        return 0.0;
    }
    return is_blocked(casters, receiver, vec2f(0.0), vec2f(0.0), by_itself);
}

/// All rays from a pixel to its light, or for a `size` of 0 to the middle of its light.
fn beam_from(receiver: Receiver, size: f32) -> Beam {
    return beam_of(receiver.position, receiver.across, receiver.down,
        way_to_light(receiver.source, receiver.position), receiver.source.w, size);
}

/// The corners and the middle of a pixel that are kept from the light; if `is_rough`, all if any
/// ray from the pixel to any place of the light may be.
fn points_blocked(casters: Casters, receiver: Receiver, by_itself: bool, is_rough: bool) -> u32 {
    let beam = beam_from(receiver, select(0.0, receiver.size, is_rough));
    if by_itself {
        let row = object_row(receiver.object);
        return points_among(casters, row, beam, receiver.facet, is_rough);
    }
    let root = caster_root(receiver.casters);
    return points_among_others(casters, root, beam, receiver.object, is_rough);
}

/// The share of a light that is kept from a pixel, from 0 to 1. Where the pixel's corners and its
/// middle agree, the pixel does; else lines across it measure the share.
fn shadow_of_pixel(casters: Casters, receiver: Receiver, by_itself: bool) -> f32 {
    if !can_be_blocked(receiver, by_itself) {
        return 0.0;
    }
    if receiver.size > 0.0 {
        return shadow_of_size(casters, receiver, by_itself);
    }
    let points = points_blocked(casters, receiver, by_itself, false);
    if points == 0u || points == ALL_POINTS {
        return select(0.0, 1.0, points != 0u);
    }
    let beam = beam_from(receiver, 0.0);
    if by_itself {
        let row = object_row(receiver.object);
        return share_of_samples(samples_among(casters, row, beam, receiver.facet));
    }
    let root = caster_root(receiver.casters);
    return share_of_samples(samples_among_others(casters, root, beam, receiver.object));
}

/// True if no triangle stands between any place of a pixel and any place of its light.
fn is_free(casters: Casters, receiver: Receiver, by_itself: bool) -> bool {
    return points_blocked(casters, receiver, by_itself, true) == 0u;
}

/// One of places that fill a square of side 1 evenly: the R sequence of two dimensions (Roberts
/// 2018), by powers of 1/1.32471795724474603.
fn even_in_square(number: i32) -> vec2f {
    return fract(0.5 + f32(number + 1) * vec2f(0.7548776662466927, 0.5698402909980533));
}

/// One of `count` places that fill a disk of radius 1 evenly, a power of 2: Vogel's spiral (1979),
/// in an order whose first places are spread as well.
fn even_in_disk(number: i32, count: i32) -> vec2f {
    let ring = f32((21 * number) % count);
    // The golden angle.
    let turn = 2.399963229728653 * ring;
    return sqrt((ring + 0.5) / f32(count)) * vec2f(cos(turn), sin(turn));
}

/// The share of a light with a size that is kept from a pixel, by rays from all over the pixel to
/// all over the light.
fn shadow_of_size(casters: Casters, receiver: Receiver, by_itself: bool) -> f32 {
    if is_free(casters, receiver, by_itself) {
        return 0.0;
    }
    var sum = 0.0;
    var count = 0;
    while count < LIGHT_RAYS {
        let at = even_in_square(count) - 0.5;
        let of_light = even_in_disk(count, LIGHT_RAYS);
        sum += is_blocked(casters, receiver, at, of_light, by_itself);
        count += 1;
        if count == FIRST_LIGHT_RAYS && sum == f32(count) {
            return 1.0;
        }
    }
    return sum / f32(LIGHT_RAYS);
}

/// The share of a pixel whose smooth normal turns away from the light; `normal_across` and
/// `normal_down` are how it changes to the pixel's neighbors.
fn turned_away(
    receiver: Receiver,
    normal: vec3f,
    normal_across: vec3f,
    normal_down: vec3f,
) -> f32 {
    let toward = ray_from(receiver, vec2f(0.0), vec2f(0.0)).direction;
    let facing = dot(normal, toward);
    let width = abs(dot(normal_across, toward)) + abs(dot(normal_down, toward));
    return clamp(0.5 - facing / max(width, 1e-6), 0.0, 1.0);
}

/// The share of a light that an object keeps from a pixel of its own. `away` is the share of the
/// pixel that is turned away from the light.
fn own_shadow(casters: Casters, receiver: Receiver, away: f32) -> f32 {
    if !casts_on_itself(receiver.casters) {
        return 0.0;
    }
    if away >= 1.0 {
        return 1.0;
    }
    return max(away, shadow_of_pixel(casters, receiver, true));
}

/// The receiver whose rays start on its facet where it is turned away from the light: they lead
/// through the body, and start above it only where they leave it.
fn seen_by(receiver: Receiver, normal: vec3f) -> Receiver {
    let toward = ray_from(receiver, vec2f(0.0), vec2f(0.0)).direction;
    var seen = receiver;
    if dot(normal, toward) <= 0.0 {
        seen.facet.lift = vec3f(0.0);
    }
    return seen;
}

/// What first blocks a ray from a surface: how far away it is, in lengths of the ray's direction,
/// and the number of its object; both below 0 where nothing does.
fn nearest_blocker(casters: Casters, receiver: Receiver, ray: Ray) -> vec2f {
    let root = caster_root(receiver.casters);
    let other = meets_others(casters, root, ray, receiver.object, false);
    if !casts_on_itself(receiver.casters) {
        return other;
    }
    let row = object_row(receiver.object);
    let own = meets_object(casters, row, ray, receiver.facet, false);
    let is_own = own > 0.0 && (other.x < 0.0 || own < other.x);
    return select(other, vec2f(own, receiver.object), is_own);
}

/// What first blocks the light from a place of a pixel, as `nearest_blocker` tells it.
fn blocker_of_ray(casters: Casters, receiver: Receiver, at: vec2f) -> vec2f {
    return nearest_blocker(casters, receiver, ray_from(receiver, at, vec2f(0.0)));
}

/// What first blocks the light from the middle of a pixel, and where that is free from one of its
/// corners, so that a shadow is one up to its edge.
fn blocker_of_pixel(casters: Casters, receiver: Receiver) -> vec2f {
    let by_others = caster_root(receiver.casters) >= 0 && !is_free(casters, receiver, false);
    let by_itself = casts_on_itself(receiver.casters) && !is_free(casters, receiver, true);
    if !by_others && !by_itself {
        return vec2f(-1.0);
    }
    var found = blocker_of_ray(casters, receiver, vec2f(0.0));
    for (var corner = 0; corner < 4; corner++) {
        if found.x >= 0.0 {
            return found;
        }
        let at = vec2f(f32(corner & 1), f32(corner >> 1u)) - 0.5;
        found = blocker_of_ray(casters, receiver, at);
    }
    return found;
}

/// A radius that an artist gives, within what rays can tell.
fn radius_of(size: f32) -> f32 {
    return clamp(finite_or(size, 0.0), 0.0, 1e6);
}
