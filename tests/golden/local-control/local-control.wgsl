// Light where it is wanted: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_tensor_map 3.
// local-control.json says what to put there and how to draw.

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
    camera_from_world: mat3x3f,
    viewport: vec2f,
    @align(16) back: Light,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    position_camera: vec3f,
    curvature_tensor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_tensor_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    half_sin: f32,
    /// cos(u/2), 0 or more.
    half_cos: f32,
}

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

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
fn normalize_seen(v: vec3f) -> vec3f {
    return normalize_moderate(v, vec3f(0.0, 0.0, 1.0));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
fn angle_footprint(u: Angle) -> f32 {
    let half = vec2f(u.half_sin, u.half_cos);
    let dx = dpdx(half);
    let dy = dpdy(half);
    let w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin - 0.0;
    let upper = select(vec2f(s, u.half_cos), vec2f(1.0, 0.0), u.half_cos <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < u.half_cos));
    return Angle(turned.x, turned.y);
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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(bounded((bounded(x) - low) / (high - low)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The length of v, also where its square would over- or underflow.
fn length_of(v: vec3f) -> f32 {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if largest < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(largest * length(v / largest));
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

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return vec4f(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

fn blend_alpha_2(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
}

/// Local light
///
/// Bends a light and changes its strength around a place on the surface, and leaves it as it is
/// elsewhere: light as an artist wants it to fall, where the real one would not.
fn local_light(light: Light, bend: vec3f, strength: f32, center: vec3f, radius: f32, hardness: f32,
    position: vec3f) -> Light {
    let weight = 1.0 - eased(length_of(position - center), radius * hardness, radius);
    let bent = light.direction + weight * bend;
    let direction = select(light.direction, normalize_moderate(bent, light.direction),
        (dot(bent, bent) > 1e-6) & (weight > 0.0));
    return Light(direction, light.own_direction, light.color, min(light.intensity, 1e30));
}

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    half_cos_offset: f32,
    half_sin_offset: f32,
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    scale: f32,
    /// gamma of BADF eq. 11.
    exponent: f32,
    /// tau, the step's place, in radians.
    offset: f32,
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    edge_mean: f32,
    edge_deviation: f32,
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    kind: u32,
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick(s: f32, shape: ProfileShape) -> f32 {
    let q = s * shape.scale;
    return select(pow(max(1.0 - q * q, 0.0), shape.exponent), 1.0, s <= 0.0);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin - 0.0, u.half_cos);
    let point = profile_soft_quick(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
fn rim(light: Light, normal: vec3f, view: vec3f, width: f32, softness: f32, follow: f32) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let edge = max(width * softness, min(footprint_of_2(facing), 1.0));
    let aside = normal - view;
    let further = select(width - facing, 0.5 * dot(aside, aside) - (1.0 - width), facing > 0.5);
    let within = further / edge + 0.0;
    let inside = clamp(within, 0.0, 1.0);
    let across = light.direction - dot(light.direction, view) * view;
    let side = dot(normal - dot(normal, view) * view, across
        * inverseSqrt(max(dot(across, across), 1e-30)));
    return inside * mix(1.0, smoothstep(0.0, 0.5, side), follow);
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
    let pixels = height / 1000.0;
    let distance = abs(radial) / max(length(change), 1e-6);
    let x = toward_eye * height * 0.05;
    let strength = clamp(0.5 + (x - limit)
        / length(vec2f(min(footprint_of(x), 1e15), limit * softness)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
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

const soft_tone_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let turned_to_the_face = local_light(look.key, vec3f(0.9, 0.25, 0.5), 1.0,
        vec3f(0.12, 0.42, 0.5), 0.5, 0.4, surface.position_object);
    let around_the_belly = local_light(turned_to_the_face, vec3f(0.4, 0.1, 0.35), 1.0,
        vec3f(-0.05, -0.35, 0.5), 0.4, 0.2, surface.position_object);
    // Parametrization
    let turned_from_the_light = Angle(0.5 * length(surface.normal - around_the_belly.direction),
        0.5 * length(surface.normal + around_the_belly.direction));
    let soft_tone = profile_balanced(turned_from_the_light, 0.0, soft_tone_shape);
    // Local tone
    let shadow_under_the_chin = clamp(soft_tone
        + (1.0 - eased(length_of(surface.position_object - vec3f(0.0, 0.02, 0.45)), 0.3 * 0.1,
        0.3)) * -0.45, 0.0, 1.0);
    // Local tone
    let glint_on_the_brow = clamp(shadow_under_the_chin
        + (1.0 - eased(length_of(surface.position_object - vec3f(-0.2, 0.72, 0.4)), 0.17 * 0.5,
        0.17)) * 0.5, 0.0, 1.0);
    // Threshold
    let lit = step_filtered(glint_on_the_brow, 0.55,
        length(vec2f(footprint_of_2(glint_on_the_brow), 0.0)));
    let light = blend_alpha(vec4f(0.36, 0.36, 0.6, 1.0), vec4f(0.96, 0.72, 0.47, 1.0), lit, 1.0,
        true);
    // Threshold
    let brightest = step_filtered(glint_on_the_brow, 0.97,
        length(vec2f(footprint_of_2(glint_on_the_brow), 0.0)));
    // Blend
    let brightest_light = min(vec4f(light.xyz + brightest
        * (vec4f(1.0, 0.93, 0.76, 1.0).xyz - light.xyz), 1.0), vec4f(1.0));
    let rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.1, 1.0);
    let rim_s_light = blend_alpha_2(brightest_light, vec4f(0.72, 0.86, 1.0, 1.0), rim_2, 0.7, true);
    let folds = inner_contour_suggestive(2.0, 20.0, 0.3, surface.curvature_tensor, surface.normal,
        surface.view, look.camera_from_world, surface.position_camera, look.viewport);
    // Combine tones
    let all_lines = max(outer_contour(3.0, surface.normal, surface.view, look.viewport), folds);
    let lines = blend_alpha_2(rim_s_light, vec4f(0.17, 0.13, 0.28, 1.0), all_lines, 0.85, true);
    return lines;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) position_object: vec3f,
    @location(2) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, vertex.position,
        object.world_from_normal * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, (view.camera_from_world * vec4f(in.position, 1.0)).xyz,
        textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz);
    return shade(surface);
}
