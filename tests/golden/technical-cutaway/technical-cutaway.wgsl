// Technical cutaway: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// technical-cutaway.json says what to put there and how to draw.

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
    @align(16) eye: Light,
    @align(16) camera_from_world: mat3x3f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    kappa: f32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

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

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
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

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
fn sin_cos_quick(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.16666666 + y * (0.0083332425
        + y * (-0.0001982274 + y * 2.6347564e-6))));
    let c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (2.4774579e-5 - y * 2.6297516e-7))));
    return vec2f(s, c);
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
    let s = u.half_sin * t.y - u.half_cos * t.x;
    let c = u.half_cos * t.y + u.half_sin * t.x;
    let upper = select(vec2f(s, c), vec2f(1.0, 0.0), c <= 0.0);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < c));
    return Angle(turned.x, turned.y);
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = x - edge;
    if w < 1e-30 {
        return select(0.0, 1.0, d >= 0.0);
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
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

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
fn curvature_color(convexity: f32, convex: Color, concave: Color) -> Color {
    return concave + convexity * (convex - concave);
}

fn transition_balanced(kappa: f32, slope: f32) -> f32 {
    return 0.5 + 0.5 * (1.0 - 2.0 / (1.0
        + exp2(2.8853900817779268 * clamp(kappa * slope, -20.0, 20.0))));
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(color.xyz * light.color * split.y, 1.0), split.x);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply_2(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(light.color * split.y, 1.0), tone * split.x);
}

struct LitLayer {
    /// The color under this light.
    color: Color,
    /// The tone under this light.
    tone: f32,
}

fn parametrization_specular_balanced(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let d = 2.0 * dot(normal, view) * normal - view;
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

fn parametrization_screen_aligned_balanced(light: Light, normal: vec3f,
    camera_from_world: mat3x3f) -> Angle {
    let d = camera_from_world * normal;
    return Angle(0.5 * length(d - light.own_direction), 0.5 * length(d + light.own_direction));
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

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return select(ramp, select(0.0, 1.0, s <= 4e-7), w <= 0.0);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick_2(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w);
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return select(ramp, select(0.0, 1.0, s <= 4e-7), w <= 0.0);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    let is_narrow = (w > 0.0) & (w >= 3.46410161513775459 * shape.edge_deviation);
    if is_narrow {
        return profile_ramp_quick(place.x, w, shape);
    }
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
    let warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

fn profile_balanced_2(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint(warped), shape);
}

/// Cool to warm
///
/// Technical illustration's shading: from a cool color on the far side to a warm one toward the
/// light, so that outlines and highlights, which are darker and lighter, stay readable everywhere.
fn gooch(light: Light, normal: vec3f, color: Color, cool: Color, warm: Color, cool_amount: f32,
    warm_amount: f32) -> Color {
    let t = 0.5 + 0.5 * dot(normal, light.direction);
    let far = cool.xyz + cool_amount * color.xyz;
    let near = warm.xyz + warm_amount * color.xyz;
    return vec4f(mix(far, near, clamp(t, 0.0, 1.0)), 1.0);
}

struct VectorParts {
    /// The first number.
    x: f32,
    /// The second number.
    y: f32,
    /// The third number.
    z: f32,
}

const metal_tone_shape = ProfileShape(0.99820054, 0.059964005, 7.166244, 3.1997643, 0.12,
    0.124456726, 0.0556771, 0u);
const contour_tone_shape = ProfileShape(0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0, 1u);

struct Shaded {
    value: vec4f,
    color: vec4f,
    cutoff: f32,
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> Shaded {
    let cool_to_warm = gooch(look.key, surface.normal, vec4f(0.8314, 0.8392, 0.8549, 1.0),
        vec4f(0.1725, 0.2902, 0.4863, 1.0), vec4f(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    // Blend
    let cool_to_warm_2 = vec4f(1.0 + (cool_to_warm.xyz - 1.0), 1.0);

    // Hollows (Light layer)
    let hollows_convexity = transition_balanced(surface.kappa, 0.25);
    let hollows_color = curvature_color(hollows_convexity, vec4f(1.0),
        vec4f(0.5412, 0.5804, 0.6588, 1.0));
    let hollows_lit = light_apply(look.key, hollows_color, 1.0);
    let hollows_blend = clamp(vec4f(cool_to_warm_2.xyz + 0.8
        * (cool_to_warm_2.xyz * (hollows_lit.tone * hollows_lit.color.xyz) - cool_to_warm_2.xyz),
        1.0), vec4f(0.0), vec4f(1.0));

    // Metal (Light layer)
    let metal_angle = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    let metal_warp = (2.0 * transition_balanced(surface.kappa, 0.2) - 1.0) * 0.05;
    let metal_tone = profile_balanced(metal_angle, metal_warp, metal_tone_shape);
    let metal_lit = light_apply_2(look.key, vec4f(1.0), metal_tone);
    let metal_blend = blend_alpha(hollows_blend, metal_lit.color, metal_lit.tone, 0.8, true);

    // Contour (Light layer)
    let contour_angle = parametrization_screen_aligned_balanced(look.eye, surface.normal,
        look.camera_from_world);
    let contour_warp = (2.0 * transition_balanced(surface.kappa, 0.12) - 1.0) * 0.25;
    let contour_tone = profile_balanced_2(contour_angle, contour_warp, contour_tone_shape);
    let contour_lit = light_apply_2(look.eye, vec4f(1.0), contour_tone);
    let contour_blend = clamp(vec4f(metal_blend.xyz * (contour_lit.tone * contour_lit.color.xyz),
        1.0), vec4f(0.0), vec4f(1.0));

    let place = surface.position_object;
    let parts = VectorParts(place.x, place.y, place.z);
    let into_the_corner = min(parts.x, parts.z);
    // Threshold
    let section = step_filtered(into_the_corner, -0.012,
        length(vec2f(min(footprint_of(into_the_corner), 1e15), 0.0)));
    let section_line = clamp(vec4f(contour_blend.xyz + section
        * (vec4f(0.8471, 0.1569, 0.1098, 1.0).xyz - contour_blend.xyz), 1.0), vec4f(0.0),
        vec4f(1.0));
    // Threshold
    let taken_out = step_filtered(into_the_corner, 0.02,
        length(vec2f(min(footprint_of(into_the_corner), 1e15), 0.0)));
    let kept = 1.0 - taken_out;
    // Set alpha
    let cut = vec4f(section_line.xyz, kept);
    let output_2 = output(premultiplied(cut));
    return Shaded(output_2, output_2, 0.5);
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
        in.position_object, textureLoad(curvature_map, vec2i(in.clip.xy), 0).x);
    let shaded = shade(surface);
    if shaded.color.w < shaded.cutoff {
        discard;
    }
    return finite_vec4(shaded.value);
}
