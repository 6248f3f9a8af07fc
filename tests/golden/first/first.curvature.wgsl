// First look: made by Chiaro 0.1.0, WGSL.
// Finds curvature from normals and depth.
// Bindings of group 0: normals 0, depths 1, curvature 2.
// first.json says what to put there and how to draw.

struct Curvature {
    /// The size of a pixel in scene units: at depth 1 for perspective, at every depth for parallel projection.
    pixel: f32,
    /// 1 for perspective, 0 for parallel projection.
    perspective: f32,
    /// In pixels.
    viewport_height: f32,
    /// 1 where the first row of an image is at the bottom of the picture (OpenGL), 0 where it is at the top.
    rows_up: f32,
}

/// Camera axes in xyz, the object's number plus 1 in w; 0 where nothing is.
@group(0) @binding(0) var normals: texture_2d<f32>;
/// Distance in front of the eye.
@group(0) @binding(1) var depths: texture_2d<f32>;
@group(0) @binding(2) var<uniform> curvature: Curvature;

/// The least n.z that divides: beyond it every rim would saturate to convex.
const LEAST_NZ = 0.2;
/// How many times the slope's own change of depth a neighbour may differ.
const DEPTH_TOLERANCE = 2.0;
/// Curvature beyond this says no more.
const MOST = 1e4;

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

/// The slope at a neighbour in xy, and whether it counts in z. `step` is in pixels, y up.
fn neighbour(center: Texel, at: vec2i, step: vec2f) -> vec3f {
    let other = texel(at);
    if other.object != center.object {
        return vec3f(0.0);
    }
    let pixel = curvature.pixel * mix(1.0, center.depth, curvature.perspective);
    let gradient = -center.normal.xy / max(center.normal.z, 0.02);
    let expected = dot(gradient, step) * pixel;
    let error = abs((center.depth - other.depth) - expected);
    let is_near = error <= DEPTH_TOLERANCE * pixel * (1.0 + length(gradient));
    return select(vec3f(0.0), vec3f(slope(other.normal), 1.0), is_near);
}

/// The derivative along one axis from what counts of the two sides.
fn derivative(here: f32, before: vec2f, after: vec2f) -> f32 {
    let total = before.y + after.y;
    if total == 0.0 {
        return 0.0;
    }
    let forward = (after.x - here) * after.y;
    let backward = (here - before.x) * before.y;
    return (forward + backward) / total;
}

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) f32 {
    let at = vec2i(position.xy);
    let center = texel(at);
    if center.object == 0.0 {
        return 0.0;
    }
    let here = slope(center.normal);
    let left = neighbour(center, at + vec2i(-1, 0), vec2f(-1.0, 0.0));
    let right = neighbour(center, at + vec2i(1, 0), vec2f(1.0, 0.0));
    let up = select(-1, 1, curvature.rows_up > 0.5);
    let above = neighbour(center, at + vec2i(0, up), vec2f(0.0, 1.0));
    let below = neighbour(center, at - vec2i(0, up), vec2f(0.0, -1.0));
    let along_x = derivative(here.x, left.xz, right.xz);
    let along_y = derivative(here.y, below.yz, above.yz);
    let kappa = 0.5 * (along_x + along_y) * curvature.viewport_height;
    return clamp(kappa, -MOST, MOST);
}
