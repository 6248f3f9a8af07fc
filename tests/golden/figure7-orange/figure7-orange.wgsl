// Orange peel: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// figure7-orange.json says what to put there and how to draw.

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
    @align(16) key: Light,
    @align(16) fill: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position: vec3f,
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

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !((largest > 1e-30) & (largest < 1e30)) {
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned_2(u: Angle, t: vec2f) -> Angle {
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
    let t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
fn footprint_of_vec3(v: vec3f) -> f32 {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
fn curvature_color(convexity: f32, convex: Color, concave: Color) -> Color {
    return concave + convexity * (convex - concave);
}

/// The normal of a surface that is raised by a height (Mikkelsen 2010): `along_x` and `along_y`
/// hold how position (xyz) and height (w) change from pixel to pixel. Where position does not
/// change, or the surface is seen edge-on, the normal stays as it is. Slopes end at 10, which is 84
/// degrees, so that silhouettes do not sparkle.
fn bumped_normal(along_x: vec4f, along_y: vec4f, normal: vec3f) -> vec3f {
    let largest = max(length_of(along_x.xyz), length_of(along_y.xyz));
    if (largest < 1e-18) | (largest > 1e18) {
        return normal;
    }
    let s = along_x.xyz / largest;
    let t = along_y.xyz / largest;
    let rise = clamp(vec2f(along_x.w, along_y.w) / largest, vec2f(-1000000.0), vec2f(1000000.0));
    let right = cross(t, normal);
    let up = cross(normal, s);
    let area = dot(s, right);
    if abs(area) < 1e-6 {
        return normal;
    }
    let slope = (rise.x * right + rise.y * up) / area;
    let steepness = length(slope);
    let limited = slope * (min(steepness, 10.0) / max(steepness, 1e-20));
    return normalize_or(normal - limited, normal);
}

/// Bump map
///
/// Bends the normal as if the surface were raised by a height: from a picture, a noise or anything
/// else. It needs no texture coordinates.
fn bump_map(height: f32, scale: f32, normal: vec3f, position: vec3f) -> vec3f {
    let raised = height * scale;
    let along_x = vec4f(dpdx(position), dpdx(raised));
    let along_y = vec4f(dpdy(position), dpdy(raised));
    return bumped_normal(along_x, along_y, normal);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + tone * (color.xyz - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
}

fn blend_alpha_2(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
}

fn blend_shade(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + 0.75
        * (below.xyz * mix(vec3f(1.0), color.xyz, tone) - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
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
    let warped = angle_turned_2(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

fn profile_balanced_3(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned_2(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

const NOISE_PERLIN: u32 = 1u;
/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
fn hash_pcg3d(seed: vec3u) -> vec3u {
    var v = seed * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// The hash of a lattice point.
fn lattice_hash(cell: vec3i, seed: u32) -> vec3u {
    return hash_pcg3d(bitcast<vec3u>(cell) + seed * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
fn gradient_dot(hash: vec3u, d: vec3f) -> f32 {
    let axis = (hash.x >> 8u) % 3u;
    let a = select(d.x, d.y, axis == 0u);
    let b = select(d.z, d.y, axis == 2u);
    return select(-a, a, (hash.y >> 31u) == 0u) + select(-b, b, (hash.z >> 31u) == 0u);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
fn fade_quintic(t: vec3f) -> vec3f {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
fn perlin_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let f = fade_quintic(d);
    let cell = vec3i(corner);
    var sum = 0.0;
    for (var i = 0; i < 8; i++) {
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum += weight.x * weight.y * weight.z * gradient_dot(lattice_hash(cell + at, seed), d
            - vec3f(at));
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
fn fractal_noise(kind: u32, p: vec3f, octaves: i32, roughness: f32, seed: i32, w: f32) -> f32 {
    var octave: f32;
    var i = 0;
    var frequency = 1.0;
    var strength = 1.0;
    var total = 0.0;
    var sum = 0.0;
    loop {
        if !(i < 2i) {
            break;
        }
        let visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        octave = 0.5;
        if visible > 0.0 {
            let place = clamp(p * frequency + f32(i) * vec3f(17.31, 5.17, 11.73), vec3f(-4194304.0),
                vec3f(4194304.0));
            octave = mix(0.5, perlin_noise(place, 0u + u32(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
        continuing {
            i = i + 1;
        }
    }
    return min(sum / 1.5, 1.0);
}

fn noise_perlin(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

const flesh_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.1220733, 1.2466265, 0.1, 1.2259196,
    0.51338285, 0u);
const shade_tone_shape = ProfileShape(0.9950042, 0.099833414, 1.6523834, 1.9165641, 0.2, 0.67495763,
    0.28714308, 0u);
const waxy_sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 2.2990327, 2.8187852, 0.05,
    0.41226318, 0.18345885, 0u);
const glint_tone_shape = ProfileShape(0.9992001, 0.039989334, 14.297388, 3.2165964, 0.08,
    0.062200632, 0.027819062, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Flesh (Light layer)
    let shade_convexity = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.8853900817779268 * clamp(surface.kappa * 0.1, -20.0, 20.0))));
    let flesh_color = curvature_color(shade_convexity, vec4f(0.9686, 0.6039, 0.1176, 1.0),
        vec4f(0.8471, 0.4118, 0.0392, 1.0));

    let pores = noise_perlin(surface.position_object, 14.0, 2i, 0.5, 0i);
    let rind = bump_map(pores, 0.035, surface.normal, surface.position);

    // Flesh
    let flesh_angle = Angle(0.5 * length(rind - look.key.direction), 0.5
        * length(rind + look.key.direction));
    let flesh_warp = (2.0 * shade_convexity - 1.0) * 0.2;
    let flesh_tone = profile_balanced(flesh_angle, flesh_warp, flesh_tone_shape);
    let flesh_lit = light_apply(look.key, flesh_color, flesh_tone);
    let flesh_blend = blend_alpha(vec4f(0.4314, 0.1647, 0.0235, 1.0), flesh_lit.color,
        flesh_lit.tone, 1.0, true);

    // Shade (Light layer)
    let shade_color = curvature_color(shade_convexity, vec4f(0.7216, 0.2824, 0.0471, 1.0),
        vec4f(0.5412, 0.1843, 0.0392, 1.0));
    let shade_angle = Angle(0.5 * length(rind - look.fill.direction), 0.5
        * length(rind + look.fill.direction));
    let shade_warp = (2.0 * shade_convexity - 1.0) * 0.1;
    let shade_tone = profile_balanced(shade_angle, shade_warp, shade_tone_shape);
    let shade_lit = light_apply(look.fill, shade_color, shade_tone);
    let shade_blend = blend_shade(flesh_blend, shade_lit.color, shade_lit.tone, 0.75, true);

    // Waxy sheen (Light layer)
    let glint_angle = parametrization_specular_balanced(look.key, rind, surface.view);
    let waxy_sheen_tone = profile_balanced_2(glint_angle, 0.0, waxy_sheen_tone_shape);
    let waxy_sheen_lit = light_apply(look.key, vec4f(0.4157, 0.2902, 0.1333, 1.0), waxy_sheen_tone);
    let waxy_sheen_blend = clamp(vec4f(shade_blend.xyz + 0.55
        * (shade_blend.xyz + waxy_sheen_lit.tone * waxy_sheen_lit.color.xyz - shade_blend.xyz),
        1.0), vec4f(0.0), vec4f(1.0));

    // Glint (Light layer)
    let glint_tone = profile_balanced_3(glint_angle, 0.0, glint_tone_shape);
    let glint_lit = light_apply(look.key, vec4f(1.0), glint_tone);
    let glint_blend = blend_alpha_2(waxy_sheen_blend, glint_lit.color, glint_lit.tone, 0.85, true);

    return glint_blend;
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
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position), in.position,
        in.position_object, textureLoad(curvature_map, vec2i(in.clip.xy), 0).x);
    return shade(surface);
}
