// One bit: made by Chiaro 0.1.0, WGSL.
// Finds curvature by direction from normals and depth.
// Bindings of group 0: normals 0, depths 1, curvature 2.
// one-bit.json says what to put there and how to draw.

// View-centered mean curvature from screen-space normals (docs/math.md 3), for the curvature
// passes: half the divergence of n.xy / n.z, in camera axes.
//
// Convex is positive. The result is in 1/viewport-height, so that a picture at twice the resolution
// shows the same. A neighbor counts only where it lies on the same surface: on the same object,
// and no farther in depth than the normal's slope explains; otherwise the difference is one-sided,
// and 0 where no neighbor is left.

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

/// Normals in camera axes in xyz, the object's number plus 1 in w; 0 where nothing is.
@group(0) @binding(0) var normals: texture_2d<f32>;
/// Depths: distances in front of the eye.
@group(0) @binding(1) var depths: texture_2d<f32>;
@group(0) @binding(2) var<uniform> curvature: Curvature;

/// The least n.z that divides: beyond it every rim would saturate to convex.
const LEAST_NZ = 0.2;
/// Tolerated difference in depth to a neighbor, in multiples of the change that the slope
/// explains.
const DEPTH_TOLERANCE = 2.0;
/// Largest curvature, in 1/viewport-height: beyond, it says no more.
const MOST = 1e4;

/// The pixels around a pixel, nearest first.
const RING = array<vec2i, 8>(
    vec2i(1, 0), vec2i(-1, 0), vec2i(0, 1), vec2i(0, -1), vec2i(1, 1), vec2i(-1, 1), vec2i(1, -1),
        vec2i(-1, -1),
);

struct Texel {
    normal: vec3f,
    object: f32,
    depth: f32,
}

fn texel(at: vec2i) -> Texel {
    let size = vec2i(textureDimensions(normals));
    if any(at < vec2i(0)) || any(at >= size) {
        return Texel(vec3f(0.0), 0.0, 0.0);
    }
    let normal = textureLoad(normals, at, 0);
    return Texel(normal.xyz, normal.w, textureLoad(depths, at, 0).x);
}

fn slope(normal: vec3f) -> vec2f {
    return normal.xy / max(normal.z, LEAST_NZ);
}

/// The slope at a neighbor in xy and the neighbor's weight in z, 0 to 1. `offset` is in pixels, y
/// up.
fn neighbor(center: Texel, at: vec2i, offset: vec2f) -> vec3f {
    let other = texel(at);
    if other.object != center.object {
        return vec3f(0.0);
    }
    let pixel = curvature.pixel * mix(1.0, center.depth, curvature.perspective);
    let gradient = -center.normal.xy / max(center.normal.z, 0.02);
    let expected = dot(gradient, offset) * pixel;
    let error = abs((center.depth - other.depth) - expected);
    let tolerance = DEPTH_TOLERANCE * pixel * length(offset) * (1.0 + length(gradient));
    // The weight fades, so that the last bit of a depth does not decide between all and nothing.
    let weight = clamp(2.0 - error / max(tolerance, 1e-30), 0.0, 1.0);
    return vec3f(slope(other.normal), weight);
}

/// Sums for a derivative: the differences to both sides, each with its weight.
struct SideDifferences {
    forward: f32,
    forward_weight: f32,
    backward: f32,
    backward_weight: f32,
}

/// Weights of the differences at one, two and three steps: a derivative of a Gaussian, which does
/// not see the noise of single normals.
const WEIGHTS = array<f32, 3>(1.0, 0.85, 0.5);

/// The derivative from the two sides as far as each counts; 0 where neither does.
fn derivative(sides: SideDifferences) -> f32 {
    let forward = sides.forward / max(sides.forward_weight, 1e-6);
    let backward = sides.backward / max(sides.backward_weight, 1e-6);
    // A side that hardly counts any more is left to the other one, gradually.
    let trust = vec2f(smoothstep(0.0, 0.5, sides.forward_weight),
        smoothstep(0.0, 0.5, sides.backward_weight));
    return (forward * trust.x + backward * trust.y) / max(trust.x + trust.y, 1e-6);
}

/// A triangle over the whole picture.
fn whole_picture(index: u32) -> vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

/// The nearest pixel around that shows an object, or `pixel` itself where there is none.
fn covered_near(pixel: vec2i) -> vec2i {
    let most = vec2i(textureDimensions(normals)) - 1;
    var found = pixel;
    // The loop visits all pixels, the nearest last: leaving it early costs more than it saves.
    for (var k = 7; k >= 0; k--) {
        let near = clamp(pixel + RING[k], vec2i(0), most);
        if textureLoad(normals, near, 0).w != 0.0 {
            found = near;
        }
    }
    return found;
}

/// Curvature at a pixel, from the neighbors on the four sides that are `first` to `last` steps
/// away, within 1 to 3.
fn curvature_at(pixel: vec2i, first: i32, last: i32) -> f32 {
    var at = pixel;
    var center = texel(at);
    if center.object == 0.0 {
        // With several samples a pixel, a look also shades pixels whose middle the object just
        // misses: they have the curvature of a neighbor.
        if curvature.samples < 2.0 {
            return 0.0;
        }
        at = covered_near(pixel);
        center = texel(at);
        if center.object == 0.0 {
            return 0.0;
        }
    }
    let here = slope(center.normal);
    var along_x = SideDifferences(0.0, 0.0, 0.0, 0.0);
    var along_y = SideDifferences(0.0, 0.0, 0.0, 0.0);
    // A step is a share of the picture's height, so that a larger picture measures the same
    // curvature, not a finer one.
    let up = select(-1, 1, curvature.rows_up > 0.5);
    let stride = max(i32(round(curvature.viewport_height / 800.0)), 1);
    for (var k = first; k <= last; k++) {
        let reach = k * stride;
        let distance = f32(reach);
        let weight = WEIGHTS[k - 1] * distance * distance;
        let left = neighbor(center, at + vec2i(-reach, 0), vec2f(-distance, 0.0));
        let right = neighbor(center, at + vec2i(reach, 0), vec2f(distance, 0.0));
        let above = neighbor(center, at + vec2i(0, up * reach), vec2f(0.0, distance));
        let below = neighbor(center, at - vec2i(0, up * reach), vec2f(0.0, -distance));
        along_x.forward += weight * right.z * (right.x - here.x) / distance;
        along_x.forward_weight += weight * right.z;
        along_x.backward += weight * left.z * (here.x - left.x) / distance;
        along_x.backward_weight += weight * left.z;
        along_y.forward += weight * above.z * (above.y - here.y) / distance;
        along_y.forward_weight += weight * above.z;
        along_y.backward += weight * below.z * (here.y - below.y) / distance;
        along_y.backward_weight += weight * below.z;
    }
    let kappa = 0.5 * (derivative(along_x) + derivative(along_y)) * curvature.viewport_height;
    return clamp(kappa, -MOST, MOST);
}
// View-centered curvature tensor (Vergne et al. 2008): how the slope n.xy / n.z changes along both
// axes of the picture. The curvature pass finds half of its trace; neighbors count as in that
// pass.
                             

/// Weighted difference of slopes to a neighbor for each step in xy, and the weight in z.
fn slope_change(center: Texel, here: vec2f, at: vec2i, offset: vec2f, weight: f32) -> vec3f {
    let other = neighbor(center, at, offset);
    let sign = select(-1.0, 1.0, offset.x + offset.y > 0.0);
    return weight * other.z * vec3f(sign * (other.xy - here) / length(offset), 1.0);
}

/// The derivative of the slope from what counts of the two sides, as [`derivative`] joins them.
fn slope_derivative(forward: vec3f, backward: vec3f) -> vec2f {
    return vec2f(
        derivative(SideDifferences(forward.x, forward.z, backward.x, backward.z)),
        derivative(SideDifferences(forward.y, forward.z, backward.y, backward.z)),
    );
}

/// The tensor at a pixel in 1/viewport-height, camera axes, convex positive: xx, xy, yy.
fn tensor_at(pixel: vec2i) -> vec3f {
    var at = pixel;
    var center = texel(at);
    if center.object == 0.0 {
        // With several samples per pixel, pixels at an outline take the values of a neighbor, as
        // for curvature.
        if curvature.samples < 2.0 {
            return vec3f(0.0);
        }
        at = covered_near(pixel);
        center = texel(at);
        if center.object == 0.0 {
            return vec3f(0.0);
        }
    }
    let here = slope(center.normal);
    let up = select(-1, 1, curvature.rows_up > 0.5);
    let stride = max(i32(round(curvature.viewport_height / 800.0)), 1);
    var right = vec3f(0.0);
    var left = vec3f(0.0);
    var above = vec3f(0.0);
    var below = vec3f(0.0);
    for (var k = 1; k <= 3; k++) {
        let reach = k * stride;
        let distance = f32(reach);
        let weight = WEIGHTS[k - 1] * distance * distance;
        right += slope_change(center, here, at + vec2i(reach, 0), vec2f(distance, 0.0), weight);
        left += slope_change(center, here, at - vec2i(reach, 0), vec2f(-distance, 0.0), weight);
        above += slope_change(center, here, at + vec2i(0, up * reach), vec2f(0.0, distance),
            weight);
        below += slope_change(center, here, at - vec2i(0, up * reach), vec2f(0.0, -distance),
            weight);
    }
    let along_x = slope_derivative(right, left);
    let along_y = slope_derivative(above, below);
    // A surface's own tensor is symmetric; that of interpolated normals is not quite.
    let tensor = vec3f(along_x.x, 0.5 * (along_x.y + along_y.x), along_y.y)
        * curvature.viewport_height;
    return clamp(tensor, vec3f(-MOST), vec3f(MOST));
}
// Curvature by direction: its own number along, across and between the axes of the picture, from
// twelve neighbors.
                          

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return vec4f(tensor_at(vec2i(position.xy)), 1.0);
}
