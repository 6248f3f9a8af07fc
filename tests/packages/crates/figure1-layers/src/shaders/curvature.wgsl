// Layers: made by Chiaro 0.1.0, WGSL.
// Finds curvature from normals and depth.
// Bindings of group 0: surface 0, curvature 1.
// look.rs says what to put there.

// Slopes of a surface over the picture, and the texels by which passes over the picture know it
// (docs/math.md 3.3).

/// The least n.z that divides: beyond it every rim would saturate to convex.
const LEAST_NZ = 0.2;

/// The slope n.xy / n.z of a normal in camera axes.
fn slope_of(normal: vec3f) -> vec2f {
    return normal.xy / max(normal.z, LEAST_NZ);
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
fn surface_texel(normal: vec3f, depth: f32, number: f32) -> vec4f {
    return vec4f(slope_of(normal), depth, select(number, -number, normal.z < 0.0));
}

/// Materials of an object, ids and objects that the numbers of texels tell apart; beyond that many
/// they repeat.
const MATERIALS = 32.0;
const IDS = 128.0;
const OBJECTS = 4096.0;

/// The number of an object in texels, from 1 on.
fn object_number(object: f32) -> f32 {
    return object - OBJECTS * floor(object / OBJECTS) + 1.0;
}

/// The number of a facet for [`surface_texel`]: the object's, from 1 on, and what materials and
/// ids add, less than 1. `id` is rounded to a whole number; what is none, or beyond a million, is
/// 0.
fn facet_number(object: f32, material: f32, id: f32) -> f32 {
    let whole = round(select(0.0, id, abs(id) <= 1e6));
    let parts = IDS * (material - MATERIALS * floor(material / MATERIALS))
        + whole - IDS * floor(whole / IDS);
    return object_number(object) + parts / (MATERIALS * IDS);
}

/// The normal that a texel was made from.
fn normal_of(texel: vec4f) -> vec3f {
    // Below LEAST_NZ the slope is n.xy by a constant, and n.z is what is left of the length 1;
    // elsewhere that is no less than LEAST_NZ, and the normal points along the slope and 1.
    let aside = LEAST_NZ * texel.xy;
    let rest = sqrt(max(1.0 - dot(aside, aside), 0.0));
    let nz = select(rest, -rest, texel.w < 0.0);
    let facing = vec3f(texel.xy, 1.0) / sqrt(1.0 + dot(texel.xy, texel.xy));
    return select(vec3f(aside, nz), facing, nz >= LEAST_NZ);
}
// View-centered mean curvature from screen-space slopes (docs/math.md 3), for the curvature passes:
// half the divergence of n.xy / n.z, in camera axes.
//
// Convex is positive. The result is in 1/viewport-height, so that a picture at twice the resolution
// shows the same. A neighbor counts only where it lies on the same surface: on the same object,
// and no farther in depth than the normal's slope explains; otherwise the difference is one-sided,
// and 0 where no neighbor is left.
//
// Fetches are most of what this costs: each neighbor is read once, and brings its slope ready made.
                     

struct Curvature {
    /// The size of a pixel in scene units: at depth 1 for perspective, at every depth for parallel
    /// projection.
    pixel: f32,
    /// 1 for perspective, 0 for parallel projection.
    perspective: f32,
    /// Height of the picture, in pixels.
    viewport_height: f32,
    /// 1 where the first row of an image is at the bottom of the picture (OpenGL), 0 where it is at
    /// the top.
    rows_up: f32,
    /// Samples per pixel of the picture.
    samples: f32,
}

/// The surface that each pixel shows, packed by [`surface_texel`]; 0 where nothing is.
@group(0) @binding(0) var surface: texture_2d<f32>;
@group(0) @binding(1) var<uniform> curvature: Curvature;

/// The least n.z that divides where depths are compared.
const LEAST_DEPTH_NZ = 0.02;
/// Tolerated difference in depth to a neighbor, in multiples of the change that the slope
/// explains.
const DEPTH_TOLERANCE = 2.0;
/// Largest curvature, in 1/viewport-height: beyond, it says no more.
const MOST = 1e4;
/// Weights of the neighbors one, two and three steps away: a derivative of a Gaussian, which does
/// not see the noise of single normals.
const WEIGHT_1 = 1.0;
const WEIGHT_2 = 0.85;
const WEIGHT_3 = 0.5;

/// A triangle over the whole picture.
fn whole_picture(index: u32) -> vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

/// A step in pixels: a share of the picture's height, so that a larger picture measures the same
/// curvature, not a finer one.
fn step_pixels() -> i32 {
    return max(i32(round(curvature.viewport_height / 800.0)), 1);
}

/// 1 where a row of the image lies above the row before it, -1 where it lies below.
fn row_direction() -> f32 {
    return select(-1.0, 1.0, curvature.rows_up > 0.5);
}

/// Offset to one of the eight pixels around a pixel, by an index from 0 to 7; the nearest first.
fn around(index: i32) -> vec2i {
    let side = 1 - 2 * (index & 1);
    let straight = select(vec2i(0, side), vec2i(side, 0), index < 2);
    return select(straight, vec2i(side, 1 - (index & 2)), index > 3);
}

/// A pixel and its texel of the surface.
struct SeenPixel {
    at: vec2i,
    texel: vec4f,
}

/// The pixel whose surface a pixel has: its own, or that of a neighbor.
///
/// With several samples a pixel, a look also shades pixels whose middle the object just misses:
/// they have the surface of the nearest of the eight pixels around that shows one.
fn seen_pixel(pixel: vec2i) -> SeenPixel {
    var seen = SeenPixel(pixel, textureLoad(surface, pixel, 0));
    let last = vec2i(textureDimensions(surface)) - 1;
    let may_be_missed = curvature.samples >= 2.0 && seen.texel.w == 0.0;
    // The nearest comes last and stays: leaving the loop early costs more than it saves. Mostly it
    // has no round at all; a compiler that knew of eight would unroll them for every pixel.
    for (var index = select(-1, 7, may_be_missed); index >= 0; index--) {
        let near = clamp(pixel + around(index), vec2i(0), last);
        let texel = textureLoad(surface, near, 0);
        if texel.w != 0.0 {
            seen = SeenPixel(near, texel);
        }
    }
    return seen;
}

/// The plane of the surface at a pixel: it tells which neighbors lie on the same surface. Changes
/// of depth are along columns and rows of the image.
struct Plane {
    object: f32,
    depth: f32,
    /// Change of depth from a pixel to the next.
    rise: vec2f,
    /// Tolerated difference of a neighbor's depth, for each pixel that the neighbor is away.
    tolerance: f32,
}

fn plane_of(object: f32, depth: f32, normal: vec3f) -> Plane {
    let pixel = curvature.pixel * mix(1.0, depth, curvature.perspective);
    let gradient = normal.xy / max(normal.z, LEAST_DEPTH_NZ);
    return Plane(object, depth, pixel * gradient * vec2f(1.0, row_direction()),
        DEPTH_TOLERANCE * pixel * (1.0 + length(gradient)));
}

/// Weights of four neighbors that are `distance` pixels away, 0 to 1, by their objects, their
/// depths, and the rises of depth to them on the plane.
fn neighbor_weights(plane: Plane, objects: vec4f, depths: vec4f, rises: vec4f,
    distance: f32) -> vec4f {
    let error = abs(depths - plane.depth - rises);
    let scale = 1.0 / max(plane.tolerance * distance, 1e-30);
    // The weight fades, so that the last bit of a depth does not decide between all and nothing.
    let weights = clamp(2.0 - error * scale, vec4f(0.0), vec4f(1.0));
    return select(vec4f(0.0), weights, objects == vec4f(plane.object));
}

/// A pixel whose curvature is measured.
struct Center {
    at: vec2i,
    slope: vec2f,
    plane: Plane,
}

/// The center for a pixel; its object is 0 where there is none.
fn center_at(pixel: vec2i) -> Center {
    let seen = seen_pixel(pixel);
    let texel = seen.texel;
    return Center(seen.at, texel.xy, plane_of(abs(texel.w), texel.z, normal_of(texel)));
}

/// Neighbors on the four sides of a center: in the column after it, in the column before it, in the
/// row after it, and in the row before it.
struct Ring {
    /// Weighted changes of slope.x from the center.
    x: vec4f,
    /// Weighted changes of slope.y from the center.
    y: vec4f,
    weights: vec4f,
}

/// The ring that is so many steps away, with its weight.
fn ring_at(center: Center, steps: i32, weight: f32) -> Ring {
    let reach = steps * step_pixels();
    let distance = f32(reach);
    let at = center.at;
    let last = vec2i(textureDimensions(surface)) - 1;
    let a = textureLoad(surface, vec2i(min(at.x + reach, last.x), at.y), 0);
    let b = textureLoad(surface, vec2i(max(at.x - reach, 0), at.y), 0);
    let c = textureLoad(surface, vec2i(at.x, min(at.y + reach, last.y)), 0);
    let d = textureLoad(surface, vec2i(at.x, max(at.y - reach, 0)), 0);
    // Beyond the image nothing is.
    let is_inside = vec4i(last.x - at.x, at.x, last.y - at.y, at.y) >= vec4i(reach);
    let objects = select(vec4f(0.0), abs(vec4f(a.w, b.w, c.w, d.w)), is_inside);
    let rise = distance * center.plane.rise;
    let rises = vec4f(rise.x, -rise.x, rise.y, -rise.y);
    let shares = weight * distance
        * neighbor_weights(center.plane, objects, vec4f(a.z, b.z, c.z, d.z), rises, distance);
    return Ring(
        shares * (vec4f(a.x, b.x, c.x, d.x) - center.slope.x),
        shares * (vec4f(a.y, b.y, c.y, d.y) - center.slope.y),
        shares * distance,
    );
}

/// Two rings as one.
fn joined(a: Ring, b: Ring) -> Ring {
    return Ring(a.x + b.x, a.y + b.y, a.weights + b.weights);
}

/// The twelve neighbors one, two and three steps away.
fn rings_at(center: Center) -> Ring {
    let near = joined(ring_at(center, 1, WEIGHT_1), ring_at(center, 2, WEIGHT_2));
    return joined(near, ring_at(center, 3, WEIGHT_3));
}

/// The derivatives along x and y, camera axes, from weighted changes to the four sides, as far as
/// each side counts; 0 where none does.
fn derivatives(changes: vec4f, weights: vec4f) -> vec2f {
    // A side that hardly counts any more is left to the other one, gradually.
    let trust = smoothstep(vec4f(0.0), vec4f(0.5), weights);
    let sides = changes / max(weights, vec4f(1e-6)) * trust;
    let along = (sides.xz - sides.yw) / max(trust.xz + trust.yw, vec2f(1e-6));
    return along * vec2f(1.0, row_direction());
}

/// Mean curvature from the neighbors.
fn mean_curvature(ring: Ring) -> f32 {
    let along = derivatives(vec4f(ring.x.xy, ring.y.zw), ring.weights);
    return clamp(0.5 * (along.x + along.y) * curvature.viewport_height, -MOST, MOST);
}
// Curvature in every detail: from the neighbors one, two and three steps away, by a derivative of
// a Gaussian.
                             

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) f32 {
    let center = center_at(vec2i(position.xy));
    if center.plane.object == 0.0 {
        return 0.0;
    }
    return mean_curvature(rings_at(center));
}
