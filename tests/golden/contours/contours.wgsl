// Contours: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_tensor_map 3, smooth_normal_4_map 4.
// contours.json says what to put there and how to draw.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
}

struct Object {
    world_from_object: mat4x4f,
    /// The inverse transpose, for normals.
    world_from_normal: mat3x3f,
    id: f32,
}

/// What is known before the fragment.
struct Look {
    viewport: vec2f,
    camera_from_world: mat3x3f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_camera: vec3f,
    curvature_tensor: vec3f,
    smooth_normal_4: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_tensor_map: texture_2d<f32>;
@group(0) @binding(4) var smooth_normal_4_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    direction: vec3f,
    /// Unit, toward the light, in the light's own frame.
    own_direction: vec3f,
    /// Straight RGB.
    color: vec3f,
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    intensity: f32,
}

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    colors: array<vec4f, 16>,
    /// Places of the stops, in increasing order, four to a vector.
    places: array<vec4f, 4>,
    /// Number of stops that count.
    count: u32,
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    interpolation: u32,
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

const SMALLEST_NORMAL: f32 = 1.17549435e-38;
/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of_2(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = x - edge;
    return select(clamp(0.5 + d / w, 0.0, 1.0), select(0.0, 1.0, d >= 0.0), w < 1e-30);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    var colors = ramp.colors;
    var places = ramp.places;
    var color = colors[0];
    var i = 1u;
    loop {
        if !(i < 3u) {
            break;
        }
        color = color + (colors[i] - colors[i - 1u]) * step_filtered(x, places[0u][i % 4u], w);
        continuing {
            i = i + 1u;
        }
    }
    return color;
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
fn principal_curvatures(tensor: vec3f) -> vec2f {
    let mean = 0.5 * (tensor.x + tensor.z);
    let spread = length(vec2f(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    let far = mean + select(-spread, spread, mean >= 0.0);
    let near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return select(vec2f(near, far), vec2f(far, near), mean >= 0.0);
}

fn reflectance_half_lambert(light: Light, normal: vec3f) -> f32 {
    let half = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half * half, 1.0);
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
fn inner_contour_suggestive(width: f32, limit: f32, softness: f32, tensor: vec3f, normal: vec3f,
    view: vec3f, camera_from_world: mat3x3f, place: vec3f, viewport: vec2f) -> f32 {
    let n = camera_from_world * normal;
    let square = dot(n.xy, n.xy);
    let radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / max(square, 1e-6);
    let change = vec2f(dpdx(radial), dpdy(radial));
    let v = camera_from_world * view;
    let row = dpdy(place);
    let up = select(-1.0, 1.0, (row - dot(row, v) * v).y >= 0.0);
    let height = clamp(viewport.y, 1.0, 1e5);
    let toward_eye = -(change.x * n.x + up * change.y * n.y) * inverseSqrt(max(square, 1e-6));
    let pixels = 1.5 * height / 1000.0;
    let distance = abs(radial) / max(length(change), 1e-6);
    let x = toward_eye * height * 0.05;
    let strength = clamp(0.5 + (x - limit) / length(vec2f(min(footprint_of(x), 1e15), 22.0)), 0.0,
        1.0);
    return clamp(pixels + 0.5 - distance, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
fn faded_in(x: f32, limit: f32, softness: f32) -> f32 {
    let width = length(vec2f(min(footprint_of(x), 1e15), 45.0));
    return clamp(0.5 + bounded(bounded(x) - limit) / width, 0.0, 1.0);
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
fn outer_contour(width: f32, normal: vec3f, view: vec3f, viewport: vec2f) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let pixels = width * clamp(viewport.y, 1.0, 1e5) / 1000.0;
    let distance = facing / max(2.0 * footprint_of_2(facing), 1e-6);
    let near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance, 0.0, min(pixels, 1.0)) * near;
}

const three_washes = Ramp(array(vec4f(0.7255, 0.7686, 0.8118, 1.0),
    vec4f(0.8627, 0.8627, 0.8235, 1.0), vec4f(0.9725, 0.949, 0.8863, 1.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.16, 0.42, 0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 3u, 2u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let broad_forms = normalize_moderate(surface.smooth_normal_4, surface.normal);
    let light_and_dark = reflectance_half_lambert(look.key, broad_forms);
    let three_washes_2 = ramp_at(three_washes, light_and_dark, footprint_of_2(light_and_dark));
    // Inner contour
    let hollows = faded_in(-principal_curvatures(surface.curvature_tensor).y, 45.0, 1.0)
        * smoothstep(0.05, 0.3, dot(surface.normal, surface.view));
    let hollows_in_sepia = mix(three_washes_2, vec4f(0.6588, 0.5294, 0.4235, 1.0), hollows);
    let inner_lines = inner_contour_suggestive(3.0, 22.0, 1.0, surface.curvature_tensor,
        surface.normal, surface.view, look.camera_from_world, surface.position_camera,
        look.viewport);
    let outline = outer_contour(5.0, surface.normal, surface.view, look.viewport);
    let all_lines = max(inner_lines, outline);
    let ink = mix(hollows_in_sepia, vec4f(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    return ink;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        (view.camera_from_world * vec4f(in.position, 1.0)).xyz,
        textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz,
        (vec4f(textureLoad(smooth_normal_4_map, vec2i(in.clip.xy), 0).xyz, 0.0)
        * view.camera_from_world).xyz);
    return shade(surface);
}
