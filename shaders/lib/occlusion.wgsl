// How much of what surrounds a surface stands close by, by rays in all directions.
import chiaro::types;
import chiaro::numeric;
import chiaro::casters;
import chiaro::shadows;

/// Rays from a pixel: a power of 2.
const OPEN_RAYS = 64;

/// How near things count: in full up to `near`, and less and less up to `far`.
struct OccludingRange {
    near: f32,
    far: f32,
}

/// A range that an artist gives, in scene units.
fn occluding_range(near: f32, far: f32) -> OccludingRange {
    let first = clamp(finite_or(near, 0.0), 0.0, 1e9);
    return OccludingRange(first, max(first, clamp(finite_or(far, 0.0), 0.0, 1e9)));
}

/// A direction about a normal: a place of a disk of radius 1, lifted to the half sphere above.
fn direction_above(normal: vec3f, disk: vec2f) -> vec3f {
    // Two directions across the normal, which turn steadily but where it points down.
    let down = -normal.y > 0.9999;
    let share = 1.0 / select(1.0 + normal.y, 1.0, down);
    let between = -normal.x * normal.z * share;
    let side = select(vec3f(1.0 - normal.x * normal.x * share, -normal.x, between),
        vec3f(1.0, 0.0, 0.0), down);
    let ahead = select(vec3f(between, -normal.z, 1.0 - normal.z * normal.z * share),
        vec3f(0.0, 0.0, 1.0), down);
    let height = sqrt(max(1.0 - dot(disk, disk), 0.0));
    return disk.x * side + disk.y * ahead + height * normal;
}

/// What a ray from a place of a pixel counts: 1 where something stands near in a direction, 0 where
/// nothing does.
fn occlusion_of_ray(
    casters: Casters,
    receiver: Receiver,
    range: OccludingRange,
    at: vec2f,
    direction: vec3f,
) -> f32 {
    let moved = at.x * receiver.across + at.y * receiver.down;
    let under = sqrt(dot(moved, moved));
    let ray = Ray(receiver.position + moved, direction, inverse_of(direction), range.far, 0.0,
        under, 2.0 * under);
    let distance = nearest_blocker(casters, receiver, ray).x;
    let width = range.far - range.near;
    let share = clamp((range.far - distance) / max(width, 1e-30), 0.0, 1.0);
    return select(0.0, select(1.0, share, width > 0.0), distance >= 0.0);
}

/// The share of all that is seen from a pixel, weighted by the cosine from the normal, which stands
/// near, by `count` rays.
fn occlusion_of_pixel(
    casters: Casters,
    receiver: Receiver,
    normal: vec3f,
    range: OccludingRange,
    count: i32,
) -> f32 {
    let has_others = caster_root(receiver.casters) >= 0;
    let far = told_at(range.far, receiver.position);
    if !(far > 0.0) || !(has_others || casts_on_itself(receiver.casters)) {
        return 0.0;
    }
    var sum = 0.0;
    for (var ray = 0; ray < count; ray++) {
        let direction = direction_above(normal, even_in_disk(ray, count));
        let at = even_in_square(ray) - 0.5;
        sum += occlusion_of_ray(casters, receiver, range, at, direction);
    }
    return sum / f32(count);
}
