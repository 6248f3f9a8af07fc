// Neon noir: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// neon-noir.json says what to put there and how to draw.

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
    @align(16) magenta: Light,
    @align(16) cyan: Light,
    @align(16) street: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
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

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
fn curvature_color(convexity: f32, convex: Color, concave: Color) -> Color {
    return concave + convexity * (convex - concave);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
fn blend_add(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool) -> Composite {
    return clamp(vec4f(below.xyz + tone * color.xyz, 1.0), vec4f(0.0), vec4f(1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

struct LitLayer {
    /// The color under this light.
    color: Color,
    /// The tone under this light.
    tone: f32,
}

fn parametrization_diffuse_balanced(light: Light, normal: vec3f) -> Angle {
    return Angle(0.5 * length(normal - light.direction), 0.5 * length(normal + light.direction));
}

fn parametrization_specular_balanced(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let d = 2.0 * dot(normal, view) * normal - view;
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick_2(u: Angle, w: f32, shape: ProfileShape) -> f32 {
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
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

const the_room_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.4670527, 1.5580629, 0.1,
    0.827969, 0.34274614, 0u);
const magenta_haze_tone_shape = ProfileShape(0.9887711, 0.14943813, 2.0858297, 1.974287, 0.3,
    0.5228124, 0.22054322, 0u);
const magenta_tube_tone_shape = ProfileShape(0.95233357, 0.30505863, 8.353367, 2.4874215, 0.62,
    0.117860116, 0.05078552, 0u);
const wet_magenta_tone_shape = ProfileShape(0.9887711, 0.14943813, 5.0334897, 2.4651666, 0.3,
    0.19658314, 0.08474467, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // The room (Light layer)
    let wet_magenta_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.8853900817779268 * clamp(surface.kappa * 0.2, -20.0, 20.0))));
    let the_room_color = curvature_color(wet_magenta_convexity, vec4f(0.0706, 0.0627, 0.1647, 1.0),
        vec4f(0.0196, 0.0157, 0.0627, 1.0));
    let the_room_angle = parametrization_diffuse_balanced(look.street, surface.normal);
    let the_room_warp = (2.0 * wet_magenta_convexity - 1.0) * 0.2;
    let the_room_tone = profile_balanced(the_room_angle, the_room_warp, the_room_tone_shape);
    let the_room_lit = light_apply(look.street, the_room_color, the_room_tone);
    let the_room_blend = blend_add(vec4f(0.0157, 0.0118, 0.0353, 1.0), the_room_lit.color,
        the_room_lit.tone, 1.0, true);

    // Cyan haze (Light layer)
    let cyan_haze_color = curvature_color(wet_magenta_convexity, vec4f(0.0471, 0.2275, 0.3373, 1.0),
        vec4f(0.0235, 0.0941, 0.1804, 1.0));
    let cyan_tube_angle = parametrization_diffuse_balanced(look.cyan, surface.normal);
    let magenta_haze_warp = (2.0 * wet_magenta_convexity - 1.0) * 0.15;
    let cyan_haze_tone = profile_balanced(cyan_tube_angle, magenta_haze_warp,
        magenta_haze_tone_shape);
    let cyan_haze_lit = light_apply(look.cyan, cyan_haze_color, cyan_haze_tone);
    let cyan_haze_blend = blend_add(the_room_blend, cyan_haze_lit.color, cyan_haze_lit.tone, 1.0,
        true);

    // Magenta haze (Light layer)
    let magenta_haze_color = curvature_color(wet_magenta_convexity,
        vec4f(0.2902, 0.0471, 0.2667, 1.0), vec4f(0.1098, 0.0235, 0.149, 1.0));
    let magenta_tube_angle = parametrization_diffuse_balanced(look.magenta, surface.normal);
    let magenta_haze_tone = profile_balanced(magenta_tube_angle, magenta_haze_warp,
        magenta_haze_tone_shape);
    let magenta_haze_lit = light_apply(look.magenta, magenta_haze_color, magenta_haze_tone);
    let magenta_haze_blend = blend_add(cyan_haze_blend, magenta_haze_lit.color,
        magenta_haze_lit.tone, 1.0, true);

    // Cyan tube (Light layer)
    let magenta_tube_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.8853900817779268 * clamp(surface.kappa * 0.25, -20.0, 20.0))));
    let cyan_tube_color = curvature_color(magenta_tube_convexity, vec4f(0.1333, 0.902, 1.0, 1.0),
        vec4f(0.0392, 0.4157, 0.6039, 1.0));
    let magenta_tube_warp = (2.0 * magenta_tube_convexity - 1.0) * 0.25;
    let cyan_tube_tone = profile_balanced_2(cyan_tube_angle, magenta_tube_warp,
        magenta_tube_tone_shape);
    let cyan_tube_lit = light_apply(look.cyan, cyan_tube_color, cyan_tube_tone);
    let cyan_tube_blend = blend_add(magenta_haze_blend, cyan_tube_lit.color, cyan_tube_lit.tone,
        1.0, true);

    // Magenta tube (Light layer)
    let magenta_tube_color = curvature_color(magenta_tube_convexity,
        vec4f(1.0, 0.1725, 0.6588, 1.0), vec4f(0.5255, 0.0627, 0.4784, 1.0));
    let magenta_tube_tone = profile_balanced_2(magenta_tube_angle, magenta_tube_warp,
        magenta_tube_tone_shape);
    let magenta_tube_lit = light_apply(look.magenta, magenta_tube_color, magenta_tube_tone);
    let magenta_tube_blend = blend_add(cyan_tube_blend, magenta_tube_lit.color,
        magenta_tube_lit.tone, 1.0, true);

    // Wet, cyan (Light layer)
    let wet_cyan_color = curvature_color(wet_magenta_convexity, vec4f(0.2275, 0.6588, 0.7843, 1.0),
        vec4f(0.0627, 0.2902, 0.4157, 1.0));
    let wet_cyan_angle = parametrization_specular_balanced(look.cyan, surface.normal, surface.view);
    let wet_magenta_warp = (2.0 * wet_magenta_convexity - 1.0) * 0.1;
    let wet_cyan_tone = profile_balanced_2(wet_cyan_angle, wet_magenta_warp,
        wet_magenta_tone_shape);
    let wet_cyan_lit = light_apply(look.cyan, wet_cyan_color, wet_cyan_tone);
    let wet_cyan_blend = blend_add(magenta_tube_blend, wet_cyan_lit.color, wet_cyan_lit.tone, 1.0,
        true);

    // Wet, magenta (Light layer)
    let wet_magenta_color = curvature_color(wet_magenta_convexity,
        vec4f(0.7843, 0.2275, 0.6039, 1.0), vec4f(0.3529, 0.0627, 0.3765, 1.0));
    let wet_magenta_angle = parametrization_specular_balanced(look.magenta, surface.normal,
        surface.view);
    let wet_magenta_tone = profile_balanced_2(wet_magenta_angle, wet_magenta_warp,
        wet_magenta_tone_shape);
    let wet_magenta_lit = light_apply(look.magenta, wet_magenta_color, wet_magenta_tone);
    let wet_magenta_blend = blend_add(wet_cyan_blend, wet_magenta_lit.color, wet_magenta_lit.tone,
        1.0, true);

    return wet_magenta_blend;
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
        textureLoad(curvature_map, vec2i(in.clip.xy), 0).x);
    return shade(surface);
}
