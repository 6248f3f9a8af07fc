// Layers: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// look.rs says what to put there.

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
    back_light_convexity_slope: f32,
    back_light_color_convex: vec4f,
    back_light_color_concave: vec4f,
    back_light_warp_amount: f32,
    @align(16) back: Light,
    @align(16) back_light_tone_shape: ProfileShape,
    @align(16) specular_convexity_slope: f32,
    specular_color_convex: vec4f,
    specular_color_concave: vec4f,
    specular_warp_amount: f32,
    @align(16) key: Light,
    @align(16) specular_tone_shape: ProfileShape,
    @align(16) diffuse_convexity_slope: f32,
    diffuse_color_convex: vec4f,
    diffuse_color_concave: vec4f,
    diffuse_warp_amount: f32,
    @align(16) diffuse_tone_shape: ProfileShape,
    @align(16) fill_convexity_slope: f32,
    fill_color_convex: vec4f,
    fill_color_concave: vec4f,
    fill_warp_amount: f32,
    @align(16) fill_tone_shape: ProfileShape,
    @align(16) base: vec4f,
    fill_blend_clamped: u32,
    fill_blend_opacity: f32,
    diffuse_blend_clamped: u32,
    diffuse_blend_opacity: f32,
    specular_blend_clamped: u32,
    specular_blend_opacity: f32,
    back_light_blend_clamped: u32,
    back_light_blend_opacity: f32,
    output: f32,
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

const PI: f32 = 3.14159265358979323846;
const LOG2_E: f32 = 1.44269504088896340736;
/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
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

/// log2(1 - y) for y in [0, 1): a series near 0, where 1 - y would round y away, else the
/// hardware's; -100 at 1.
fn log2_one_minus(y: f32) -> f32 {
    let series = -y * LOG2_E * (1.0 + y * (0.5
        + y * (0.333333333333333333 + y * (0.25 + y * 0.2))));
    return select(log2(max(1.0 - y, 7.8886091e-31)), series, y < 0.0625);
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

fn transition_balanced(kappa: f32, slope: f32) -> f32 {
    return 0.5 + 0.5 * (1.0 - 2.0 / (1.0
        + exp2(2.8853900817779268 * clamp(kappa * clamp(slope, -1e30, 1e30), -20.0, 20.0))));
}

/// Curvature warp
///
/// How far curvature moves the angle that a profile sees: convex parts by plus, concave parts by
/// minus the amount.
fn warp(convexity: f32, amount: f32) -> f32 {
    return (2.0 * convexity - 1.0) * clamp(amount, -3.14159265358979324, 3.14159265358979324);
}

/// Mix from `below` to `blended` by `opacity`, with `alpha` as its alpha; clamped to [0, 1] if
/// `clamped`. At opacity 0 the result is exactly `below`, whatever that is.
fn blend_finish(below: Composite, blended: vec3f, alpha: f32, opacity: f32,
    clamped: bool) -> Composite {
    if opacity <= 0.0 {
        return below;
    }
    let mixed = vec4f(below.xyz + opacity * (blended - below.xyz), alpha);
    return select(mixed, clamp(mixed, vec4f(0.0), vec4f(1.0)), clamped);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
fn blend_add(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool) -> Composite {
    return blend_finish(below, below.xyz + tone * color.xyz, below.w, opacity * color.w, clamped);
}

/// A light's intensity as two factors: x dims the layer (at most 1), y brightens the color (at
/// least 1).
fn light_split(intensity: f32) -> vec2f {
    return vec2f(min(intensity, 1.0), max(intensity, 1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = light_split(light.intensity);
    return LitLayer(vec4f(color.xyz * light.color * split.y, color.w), tone * split.x);
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

const PROFILE_STEP: u32 = 1u;
const PROFILE_AMBIENT: u32 = 2u;
/// [`profile_power`] by the hardware's logarithm and exponential, but for a series where the
/// exponent would amplify their errors.
fn profile_power_quick(q: f32, exponent: f32) -> f32 {
    let y = min(q * q, 1.0);
    let power = exp2(max(exponent * log2_one_minus(y), -126.0));
    return select(clamp(power, 0.0, 1.0), 0.0, q >= 1.0);
}

/// Sine and cosine of half the angle from tau to u.
fn profile_place(u: Angle, shape: ProfileShape) -> vec2f {
    return vec2f(
        u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset,
    );
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick(s: f32, shape: ProfileShape) -> f32 {
    return select(profile_power_quick(s * shape.scale, shape.exponent), 1.0, s <= 0.0);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    // 2 asin(s) by its series: the ramp is narrow.
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (shape.edge_mean - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return select(ramp, select(0.0, 1.0, s <= 4e-7), w <= 0.0);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    if shape.kind == PROFILE_AMBIENT {
        return 1.0;
    }
    let place = profile_place(u, shape);
    let is_narrow = (w > 0.0) & (w >= 3.46410161513775459 * shape.edge_deviation);
    if (shape.kind == PROFILE_STEP) | is_narrow {
        return profile_ramp_quick(place.x, w, shape);
    }
    let point = profile_soft_quick(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    // Half of the quadrature's reach is below 0.1.
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, sin_cos_quick(0.5 * clamp(shift, -3.141592653589793, PI)));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

struct Shaded {
    value: vec4f,
    color: vec4f,
    cutoff: f32,
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> Shaded {
    // Fill (Light layer)
    let fill_convexity = transition_balanced(surface.kappa, look.fill_convexity_slope);
    let fill_color = look.fill_color_concave + fill_convexity
        * (look.fill_color_convex - look.fill_color_concave);
    let diffuse_angle = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let fill_warp = warp(fill_convexity, look.fill_warp_amount);
    let fill_tone = profile_balanced(diffuse_angle, fill_warp, look.fill_tone_shape);
    let fill_lit = light_apply(look.key, fill_color, fill_tone);
    let fill_blend = blend_add(look.base, fill_lit.color, fill_lit.tone, look.fill_blend_opacity,
        (look.fill_blend_clamped != 0u));

    // Diffuse (Light layer)
    let diffuse_convexity = transition_balanced(surface.kappa, look.diffuse_convexity_slope);
    let diffuse_color = look.diffuse_color_concave + diffuse_convexity
        * (look.diffuse_color_convex - look.diffuse_color_concave);
    let diffuse_warp = warp(diffuse_convexity, look.diffuse_warp_amount);
    let diffuse_tone = profile_balanced(diffuse_angle, diffuse_warp, look.diffuse_tone_shape);
    let diffuse_lit = light_apply(look.key, diffuse_color, diffuse_tone);
    let diffuse_blend = blend_add(fill_blend, diffuse_lit.color, diffuse_lit.tone,
        look.diffuse_blend_opacity, (look.diffuse_blend_clamped != 0u));

    // Specular (Light layer)
    let specular_convexity = transition_balanced(surface.kappa, look.specular_convexity_slope);
    let specular_color = look.specular_color_concave + specular_convexity
        * (look.specular_color_convex - look.specular_color_concave);
    let specular_angle = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    let specular_warp = warp(specular_convexity, look.specular_warp_amount);
    let specular_tone = profile_balanced(specular_angle, specular_warp, look.specular_tone_shape);
    let specular_lit = light_apply(look.key, specular_color, specular_tone);
    let specular_blend = blend_add(diffuse_blend, specular_lit.color, specular_lit.tone,
        look.specular_blend_opacity, (look.specular_blend_clamped != 0u));

    // Back-light (Light layer)
    let back_light_convexity = transition_balanced(surface.kappa, look.back_light_convexity_slope);
    let back_light_color = look.back_light_color_concave + back_light_convexity
        * (look.back_light_color_convex - look.back_light_color_concave);
    let back_light_angle = Angle(0.5 * length(surface.normal - look.back.direction), 0.5
        * length(surface.normal + look.back.direction));
    let back_light_warp = warp(back_light_convexity, look.back_light_warp_amount);
    let back_light_tone = profile_balanced(back_light_angle, back_light_warp,
        look.back_light_tone_shape);
    let back_light_lit = light_apply(look.back, back_light_color, back_light_tone);
    let back_light_blend = blend_add(specular_blend, back_light_lit.color, back_light_lit.tone,
        look.back_light_blend_opacity, (look.back_light_blend_clamped != 0u));

    let output = finite_vec4(select(vec4f(back_light_blend.xyz / back_light_blend.w,
        back_light_blend.w), back_light_blend, back_light_blend.w <= 0.0));
    return Shaded(output, output, look.output);
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

/// The look's color: straight RGBA.
fn look_color(in: Varyings, is_front: bool) -> vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        textureLoad(curvature_map, vec2i(in.clip.xy), 0).x);
    let shaded = shade(surface);
    if shaded.color.w < shaded.cutoff {
        discard;
    }
    return finite_vec4(shaded.value);
}

/// For targets of colors as shown.
@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    return look_color(in, is_front);
}

/// Linear light of a color as shown.
fn linear_of_shown(color: vec3f) -> vec3f {
    let high = pow((color + 0.055) / 1.055, vec3f(2.4));
    return select(high, color / 12.92, color <= vec3f(0.04045));
}

/// For targets of linear light.
@fragment
fn fs_linear(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let shown = look_color(in, is_front);
    return vec4f(linear_of_shown(shown.rgb), shown.a);
}
