// Ten lights, one edge after the sum: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// lights-summed.json says what to put there and how to draw.

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
    @align(16) moon: Light,
    @align(16) moon_intensity: f32,
    @align(16) violet: Light,
    @align(16) violet_intensity: f32,
    @align(16) rose: Light,
    @align(16) rose_intensity: f32,
    @align(16) amber: Light,
    @align(16) amber_intensity: f32,
    @align(16) gold: Light,
    @align(16) gold_intensity: f32,
    @align(16) coral: Light,
    @align(16) coral_intensity: f32,
    @align(16) magenta: Light,
    @align(16) magenta_intensity: f32,
    @align(16) cobalt: Light,
    @align(16) cobalt_intensity: f32,
    @align(16) turquoise: Light,
    @align(16) turquoise_intensity: f32,
    @align(16) azure: Light,
    @align(16) azure_intensity: f32,
    lamps_moon_strength: vec4f,
    lamps_violet_strength: vec4f,
    lamps_rose_strength: vec4f,
    lamps_amber_strength: vec4f,
    lamps_gold_strength: vec4f,
    lamps_coral_strength: vec4f,
    lamps_magenta_strength: vec4f,
    lamps_cobalt_strength: vec4f,
    lamps_turquoise_strength: vec4f,
    lamps_azure_strength: vec4f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

/// Straight RGBA.
alias Color = vec4f;

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

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// The stairs floor(x) from 0 to `count` - 1, averaged over a footprint of `w`; x in [0, count],
/// count at least 2.
fn stairs_filtered(x: f32, count: f32, w: f32) -> f32 {
    if w <= 1.0 {
        let edge = clamp(round(x), 1.0, 5.0);
        return edge - 1.0 + clamp(0.5 + (x - edge) / w, 0.0, 1.0);
    }
    let half = 0.5 * w;
    return (stairs_integral(x + half, count) - stairs_integral_2(x - half, count)) / (2.0 * half);
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
fn stairs_integral(x: f32, count: f32) -> f32 {
    let inside = min(x, count);
    let stair = min(floor(inside), 5.0);
    let beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * 5.0;
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
fn stairs_integral_2(x: f32, count: f32) -> f32 {
    let inside = max(x, 0.0);
    let stair = floor(inside);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + 0.0;
}

/// sRGB-coded to linear light (IEC 61966-2-1, the exact curve); a negative number is decoded by its
/// size.
fn linear_of_srgb(coded: f32) -> f32 {
    let size = abs(coded);
    let value = select(pow((size + 0.055) / 1.055, 2.4), size / 12.92, size <= 0.04045);
    return value;
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
fn srgb_of_linear(light: f32) -> f32 {
    let size = abs(light);
    let value = select(1.055 * pow(size, 0.4166666666666667) - 0.055, size * 12.92, size
        <= 0.0031308);
    return select(value, -value, light < 0.0);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
fn oklab_of_linear(rgb: vec3f) -> vec3f {
    let l = pow(abs(dot(rgb, vec3f(0.4122214708, 0.5363325363, 0.0514459929))), 0.3333333333333333);
    let m = pow(abs(dot(rgb, vec3f(0.2119034982, 0.6806995451, 0.1073969566))), 0.3333333333333333);
    let s = pow(abs(dot(rgb, vec3f(0.0883024619, 0.2817188376, 0.6299787005))), 0.3333333333333333);
    return vec3f(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l
        - 2.4285922050 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.8086757660
        * s);
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
fn linear_of_oklab(lab: vec3f) -> vec3f {
    let l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
    let m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
    let s = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
    let cubes = vec3f(l * l * l, m * m * m, s * s * s);
    return vec3f(dot(cubes, vec3f(4.0767416621, -3.3077115913, 0.2309699292)),
        dot(cubes, vec3f(-1.2684380046, 2.6097574011, -0.3413193965)),
        dot(cubes, vec3f(-0.0041960863, -0.7034186147, 1.7076147010)));
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
fn srgb_of_oklab(lab: vec3f) -> vec3f {
    let light = linear_of_oklab(lab);
    return vec3f(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
fn limit_color(color: Color, limit: f32, softness: f32) -> Color {
    let knee = 1.0 - softness;
    let brightest = max(max(color.x, color.y), color.z);
    if brightest <= knee {
        return vec4f(color.xyz, 2.0);
    }
    let room = limit - knee;
    let above = brightest - knee;
    let pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return vec4f(color.xyz * min(pressed / brightest, 1.0), 2.0);
}

/// Posterize
///
/// Reduces a color to a few steps, as screen prints and old posters do. By lightness the hue stays
/// and only light and dark are cut, in steps that look even; by channel the hue shifts too, which
/// is the look of early computers.
fn posterize_lightness(color: Color, steps: i32, softness: f32) -> Color {
    let coded = clamp(color.xyz, vec3f(0.0), vec3f(1.0));
    let lab = oklab_of_linear(vec3f(linear_of_srgb(coded.x), linear_of_srgb(coded.y),
        linear_of_srgb(coded.z)));
    let stepped = clamp(stairs_filtered(6.0 * clamp(lab.x, 0.0, 1.0), 6.0,
        length(vec2f(6.0 * footprint_of(lab.x), softness))) / 5.0, 0.0, 1.0);
    let kept = select(0.0, stepped / max(lab.x, 1e-4), lab.x > 1e-4);
    return vec4f(clamp(srgb_of_oklab(vec3f(stepped, lab.yz * min(kept, 1.0))), vec3f(0.0),
        vec3f(1.0)), 2.0);
}

fn parametrization_diffuse_balanced(light: Light, normal: vec3f) -> Angle {
    return Angle(0.5 * length(normal - light.direction), 0.5 * length(normal + light.direction));
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

fn sum_of_lights_color(value: Color, before_sum: Color, reach: f32) -> Color {
    return select(before_sum, vec4f(before_sum.xyz + value.xyz, 1.0), reach > 0.0);
}

const lamps_moon_tone_shape = ProfileShape(1.0, 0.0, 1.6002629, 1.8073579, 0.0, 0.71386534,
    0.30130044, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Lamps moon (Each lamp)
    let lamps_moon_angle = parametrization_diffuse_balanced(look.moon, surface.normal);
    let lamps_moon_tone = profile_balanced(lamps_moon_angle, 0.0, lamps_moon_tone_shape);
    let lamps_moon_lit = look.lamps_moon_strength * vec4f(vec3f(lamps_moon_tone), 1.0);

    // Lamps violet (Each lamp)
    let lamps_violet_angle = parametrization_diffuse_balanced(look.violet, surface.normal);
    let lamps_violet_tone = profile_balanced(lamps_violet_angle, 0.0, lamps_moon_tone_shape);
    let lamps_violet_lit = look.lamps_violet_strength * vec4f(vec3f(lamps_violet_tone), 1.0);

    // Lamps rose (Each lamp)
    let lamps_rose_angle = parametrization_diffuse_balanced(look.rose, surface.normal);
    let lamps_rose_tone = profile_balanced(lamps_rose_angle, 0.0, lamps_moon_tone_shape);
    let lamps_rose_lit = look.lamps_rose_strength * vec4f(vec3f(lamps_rose_tone), 1.0);

    // Lamps amber (Each lamp)
    let lamps_amber_angle = parametrization_diffuse_balanced(look.amber, surface.normal);
    let lamps_amber_tone = profile_balanced(lamps_amber_angle, 0.0, lamps_moon_tone_shape);
    let lamps_amber_lit = look.lamps_amber_strength * vec4f(vec3f(lamps_amber_tone), 1.0);

    // Lamps gold (Each lamp)
    let lamps_gold_angle = parametrization_diffuse_balanced(look.gold, surface.normal);
    let lamps_gold_tone = profile_balanced(lamps_gold_angle, 0.0, lamps_moon_tone_shape);
    let lamps_gold_lit = look.lamps_gold_strength * vec4f(vec3f(lamps_gold_tone), 1.0);

    // Lamps coral (Each lamp)
    let lamps_coral_angle = parametrization_diffuse_balanced(look.coral, surface.normal);
    let lamps_coral_tone = profile_balanced(lamps_coral_angle, 0.0, lamps_moon_tone_shape);
    let lamps_coral_lit = look.lamps_coral_strength * vec4f(vec3f(lamps_coral_tone), 1.0);

    // Lamps magenta (Each lamp)
    let lamps_magenta_angle = parametrization_diffuse_balanced(look.magenta, surface.normal);
    let lamps_magenta_tone = profile_balanced(lamps_magenta_angle, 0.0, lamps_moon_tone_shape);
    let lamps_magenta_lit = look.lamps_magenta_strength * vec4f(vec3f(lamps_magenta_tone), 1.0);

    // Lamps cobalt (Each lamp)
    let lamps_cobalt_angle = parametrization_diffuse_balanced(look.cobalt, surface.normal);
    let lamps_cobalt_tone = profile_balanced(lamps_cobalt_angle, 0.0, lamps_moon_tone_shape);
    let lamps_cobalt_lit = look.lamps_cobalt_strength * vec4f(vec3f(lamps_cobalt_tone), 1.0);

    // Lamps turquoise (Each lamp)
    let lamps_turquoise_angle = parametrization_diffuse_balanced(look.turquoise, surface.normal);
    let lamps_turquoise_tone = profile_balanced(lamps_turquoise_angle, 0.0, lamps_moon_tone_shape);
    let lamps_turquoise_lit = look.lamps_turquoise_strength
        * vec4f(vec3f(lamps_turquoise_tone), 1.0);

    // Lamps azure (Each lamp)
    let lamps_azure_angle = parametrization_diffuse_balanced(look.azure, surface.normal);
    let lamps_azure_tone = profile_balanced(lamps_azure_angle, 0.0, lamps_moon_tone_shape);
    let lamps_azure_lit = look.lamps_azure_strength * vec4f(vec3f(lamps_azure_tone), 1.0);
    let lamps_azure_sum = select(vec4f(0.0, 0.0, 0.0, 1.0), vec4f(0.0 + lamps_azure_lit.xyz, 1.0),
        look.azure_intensity > 0.0);

    // Lamps turquoise
    let lamps_turquoise_sum = sum_of_lights_color(lamps_turquoise_lit, lamps_azure_sum,
        look.turquoise_intensity);

    // Lamps cobalt
    let lamps_cobalt_sum = sum_of_lights_color(lamps_cobalt_lit, lamps_turquoise_sum,
        look.cobalt_intensity);

    // Lamps magenta
    let lamps_magenta_sum = sum_of_lights_color(lamps_magenta_lit, lamps_cobalt_sum,
        look.magenta_intensity);

    // Lamps coral
    let lamps_coral_sum = sum_of_lights_color(lamps_coral_lit, lamps_magenta_sum,
        look.coral_intensity);

    // Lamps gold
    let lamps_gold_sum = sum_of_lights_color(lamps_gold_lit, lamps_coral_sum, look.gold_intensity);

    // Lamps amber
    let lamps_amber_sum = sum_of_lights_color(lamps_amber_lit, lamps_gold_sum,
        look.amber_intensity);

    // Lamps rose
    let lamps_rose_sum = sum_of_lights_color(lamps_rose_lit, lamps_amber_sum, look.rose_intensity);

    // Lamps violet
    let lamps_violet_sum = sum_of_lights_color(lamps_violet_lit, lamps_rose_sum,
        look.violet_intensity);

    // Lamps moon
    let lamps_moon_sum = sum_of_lights_color(lamps_moon_lit, lamps_violet_sum, look.moon_intensity);

    let dark = lamps_moon_sum * vec4f(0.44, 0.44, 0.44, 1.0) + vec4f(0.07, 0.05, 0.1, 1.0);
    let limit = limit_color(posterize_lightness(dark, 6i, 0.04), 1.0, 0.4);
    return vec4f(limit.xyz, 1.0);
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, object.world_from_normal * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal);
    return shade(surface);
}
