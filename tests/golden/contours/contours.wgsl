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
    /// The alpha cutoff of the material, 0 for none.
    cutoff: f32,
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

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

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

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// x, or `otherwise` where x is NaN or infinite.
fn finite_or(x: f32, otherwise: f32) -> f32 {
    return select(otherwise, x, is_finite(x));
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec3(v: vec3f) -> vec3f {
    return vec3f(finite_or(v.x, 0.0), finite_or(v.y, 0.0), finite_or(v.z, 0.0));
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    return vec4f(finite_vec3(v.xyz), finite_or(v.w, 0.0));
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !(largest > 1e-30 && largest < 1e30) {
        return otherwise;
    }
    let scaled = v * (1.0 / largest);
    let square = dot(scaled, scaled);
    // max() passes over a NaN.
    if !is_finite(square) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
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

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    return vec4f(bounded(v.x), bounded(v.y), bounded(v.z), bounded(v.w));
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// Mix from a (where t is 0) to b (where t is 1): exact at both ends, and where a is b.
fn mixed(a: f32, b: f32, t: f32) -> f32 {
    let d = bounded(b - a);
    return bounded(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
fn mixed_vec3(a: vec3f, b: vec3f, t: f32) -> vec3f {
    return vec3f(mixed(a.x, b.x, t), mixed(a.y, b.y, t), mixed(a.z, b.z, t));
}

/// [`mixed`], component by component.
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    return vec4f(mixed_vec3(a.xyz, b.xyz, t), mixed(a.w, b.w, t));
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
fn place_between(x: f32, low: f32, high: f32) -> f32 {
    let span = high - low;
    if abs(span) < SMALLEST_NORMAL {
        return select(0.0, 1.0, x >= high);
    }
    return bounded((x - low) / bounded(span));
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(place_between(bounded(x), bounded(low), bounded(high)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A factor as it is, or kept within 0 and 1 when `clamped`.
fn factor_of(x: f32, clamped: bool) -> f32 {
    return select(bounded(x), clamp(bounded(x), 0.0, 1.0), clamped);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// The width of an edge whose own width is `softness`, seen through a footprint of `w`.
fn edge_width(w: f32, softness: f32) -> f32 {
    return length(vec2f(min(w, 1e15), clamp(bounded(softness), 0.0, 1e15)));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = bounded(x - edge);
    if w < 1e-30 {
        return select(0.0, 1.0, d >= 0.0);
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

const INTERPOLATION_SMOOTH: u32 = 1u;
const INTERPOLATION_STEPPED: u32 = 2u;
/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
fn hermite(a: vec4f, b: vec4f, from_a: vec4f, to_b: vec4f, t: f32) -> vec4f {
    let d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    let count = min(ramp.count, 16u);
    if count == 0u {
        return vec4f(0.0);
    }
    var colors = ramp.colors;
    var places = ramp.places;
    if ramp.interpolation == INTERPOLATION_STEPPED {
        var color = colors[0];
        for (var i = 1u; i < count; i++) {
            color += (colors[i] - colors[i - 1u]) * step_filtered(x, places[i / 4u][i % 4u], w);
        }
        return bounded_vec4(color);
    }
    var at = 0u;
    for (var i = 1u; i < count; i++) {
        at = select(at, i, places[i / 4u][i % 4u] <= x);
    }
    let place = places[at / 4u][at % 4u];
    if at + 1u >= count || x <= place {
        return bounded_vec4(colors[at]);
    }
    let after = at + 1u;
    let span = places[after / 4u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    if ramp.interpolation != INTERPOLATION_SMOOTH {
        return mixed_vec4(colors[at], colors[after], t);
    }
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    var from_a = vec4f(0.0);
    var to_b = vec4f(0.0);
    if at > 0u {
        let before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    if after + 1u < count {
        let next = places[(after + 1u) / 4u][(after + 1u) % 4u] - (place + span);
        to_b = ramp_slope(colors[after] - colors[at], span, colors[after + 1u] - colors[after],
            next);
    }
    return bounded_vec4(hermite(colors[at], colors[after], span * from_a, span * to_b, t));
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
fn ramp_slope(rise_before: vec4f, span_before: f32, rise_after: vec4f, span_after: f32) -> vec4f {
    return vec4f(
        harmonic_slope(divided(rise_before.x, span_before), span_before,
            divided(rise_after.x, span_after), span_after),
        harmonic_slope(divided(rise_before.y, span_before), span_before,
            divided(rise_after.y, span_after), span_after),
        harmonic_slope(divided(rise_before.z, span_before), span_before,
            divided(rise_after.z, span_after), span_after),
        harmonic_slope(divided(rise_before.w, span_before), span_before,
            divided(rise_after.w, span_after), span_after),
    );
}

/// [`ramp_slope`] of one component.
fn harmonic_slope(before: f32, span_before: f32, after: f32, span_after: f32) -> f32 {
    if before * after <= 0.0 {
        return 0.0;
    }
    let weight_before = 2.0 * span_after + span_before;
    let weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// Premultiplied RGBA of a straight color.
fn premultiplied(color: Color) -> Composite {
    return vec4f(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// Mix colors
///
/// Lays one color on another as paint programs do. For a stack of shading layers take Blend, which
/// knows tones and transparency.
fn mix_colors_normal(a: Color, b: Color, factor: f32) -> Color {
    return mixed_vec4(bounded_vec4(a), bounded_vec4(b), factor_of(factor, true));
}

/// kappa fit for use: 0 where it is NaN, within +-1e4.
fn kappa_safe(kappa: f32) -> f32 {
    // An infinite curvature keeps its sign; only NaN has none.
    let is_nan = (bitcast<u32>(kappa) & 0x7fffffffu) > 0x7f800000u;
    return select(clamp(kappa, -1e4, 1e4), 0.0, is_nan);
}

/// Tensor fit for use: [`kappa_safe`] of each number.
fn tensor_safe(tensor: vec3f) -> vec3f {
    return vec3f(kappa_safe(tensor.x), kappa_safe(tensor.y), kappa_safe(tensor.z));
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

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// Color ramp
///
/// Turns a number into a color along a ramp: a tone into paint. Before the first stop and after
/// the last one the color stays; the edges of a stepped ramp are antialiased.
fn ramp_plain(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    return ramp_at(ramp, bounded(value), w);
}

fn reflectance_half_lambert(light: Light, normal: vec3f) -> f32 {
    let half = 0.5 + 0.5 * dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
    return clamp(half * half, 0.0, 1.0);
}

/// Maximum
///
/// The larger of two numbers, component by component. A color keeps the alpha of A.
fn maximum(a: f32, b: f32) -> f32 {
    return max(bounded(a), bounded(b));
}

/// Share of a pixel that a line covers which is `width` pixels wide and `distance` pixels away.
fn line_covers(distance: f32, width: f32) -> f32 {
    return clamp(width + 0.5 - distance, 0.0, min(width, 1.0));
}

/// Trust in curvature on the screen: 0 at the outline, where curvature has no bound and no digits,
/// 1 where the surface is seen well.
fn seen_well(facing: f32) -> f32 {
    return eased(facing, 0.05, 0.3);
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
fn inner_contour_suggestive(
    width: f32,
    limit: f32,
    softness: f32,
    tensor: vec3f,
    normal: vec3f,
    view: vec3f,
    camera_from_world: mat3x3f,
    place: vec3f,
    viewport: vec2f,
) -> f32 {
    let n = camera_from_world * normal;
    let h = tensor_safe(tensor);
    let square = dot(n.xy, n.xy);
    // The curvature in the direction in which the surface leaves the line of sight; it is 0 along
    // these lines.
    let radial = (h.x * n.x * n.x + 2.0 * h.y * n.x * n.y + h.z * n.y * n.y) / max(square, 1e-6);
    let change = vec2f(dpdx(radial), dpdy(radial));
    // `up` is 1 where the next row of pixels is farther up in the picture, -1 where it is farther
    // down.
    let v = camera_from_world * view;
    let row = dpdy(place);
    let up = select(-1.0, 1.0, (row - dot(row, v) * v).y >= 0.0);
    let height = clamp(viewport.y, 1.0, 1e5);
    let toward_eye = -(change.x * n.x + up * change.y * n.y) * inverseSqrt(max(square, 1e-6));
    let pixels = 0.5 * clamp(bounded(width), 0.0, 1e4) * height / 1000.0;
    let distance = abs(radial) / max(length(change), 1e-6);
    // Over a twentieth of the picture's height the surface is to become as curved as the limit.
    let strength = faded_in(toward_eye * height * 0.05, limit, softness);
    return line_covers(distance, pixels) * strength * seen_well(dot(normal, view));
}

fn inner_contour_valleys(limit: f32, softness: f32, tensor: vec3f, normal: vec3f,
    view: vec3f) -> f32 {
    let least = principal_curvatures(tensor_safe(tensor)).y;
    return faded_in(-least, limit, softness) * seen_well(dot(normal, view));
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
fn faded_in(x: f32, limit: f32, softness: f32) -> f32 {
    let at = max(bounded(limit), 0.0);
    let width = edge_width(footprint_of(x), min(at, 1e9) * factor_of(softness, true));
    return step_filtered(bounded(x), at, width);
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
fn outer_contour(width: f32, normal: vec3f, view: vec3f, viewport: vec2f) -> f32 {
    let facing = clamp(dot(normalize_or(normal, vec3f(0.0)), view), 0.0, 1.0);
    let pixels = clamp(bounded(width), 0.0, 1e4) * clamp(viewport.y, 1.0, 1e5) / 1000.0;
    // Near an outline of anything round n . v goes like the square root of the distance.
    let distance = facing / max(2.0 * footprint_of(facing), 1e-6);
    // A crease changes as fast, but far from the outline.
    let near = 1.0 - eased(facing, 0.45, 0.75);
    return line_covers(distance, pixels) * near;
}

fn smooth_normal_large(normal: vec3f, smooth_4: vec3f) -> vec3f {
    return normalize_or(smooth_4, normal);
}

const three_washes = Ramp(array(vec4f(0.7255, 0.7686, 0.8118, 1.0), vec4f(0.8627, 0.8627, 0.8235, 1.0), vec4f(0.9725, 0.949, 0.8863, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), array(vec4f(0.0, 0.16, 0.42, 0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 3u, 2u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let broad_forms = smooth_normal_large(surface.normal, surface.smooth_normal_4);
    let light_and_dark = reflectance_half_lambert(look.key, broad_forms);
    let three_washes_2 = ramp_plain(light_and_dark, three_washes);
    let hollows = inner_contour_valleys(45.0, 1.0, surface.curvature_tensor, surface.normal, surface.view);
    let hollows_in_sepia = mix_colors_normal(three_washes_2, vec4f(0.6588, 0.5294, 0.4235, 1.0), hollows);
    let inner_lines = inner_contour_suggestive(3.0, 22.0, 1.0, surface.curvature_tensor, surface.normal, surface.view, look.camera_from_world, surface.position_camera, look.viewport);
    let outline = outer_contour(5.0, surface.normal, surface.view, look.viewport);
    let all_lines = maximum(inner_lines, outline);
    let ink = mix_colors_normal(hollows_in_sepia, vec4f(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    let output_2 = output(premultiplied(ink));
    return output_2;
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
    var out: Varyings;
    out.clip = view.clip_from_world * world;
    out.position = world.xyz;
    out.normal = object.world_from_normal * vertex.normal;
    return out;
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_or(in.normal, vec3f(0.0, 0.0, 1.0));
    let normal = select(-facing, facing, is_front);
    var surface: Surface;
    surface.normal = normal;
    surface.view = normalize_or(view.eye.xyz - view.eye.w * in.position, normalize_or(view.eye.xyz, vec3f(0.0, 0.0, 1.0)));
    surface.position_camera = (view.camera_from_world * vec4f(in.position, 1.0)).xyz;
    surface.curvature_tensor = textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz;
    surface.smooth_normal_4 = (vec4f(textureLoad(smooth_normal_4_map, vec2i(in.clip.xy), 0).xyz, 0.0) * view.camera_from_world).xyz;
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
