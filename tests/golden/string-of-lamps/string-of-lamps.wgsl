// A string of lamps: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// string-of-lamps.json says what to put there and how to draw.

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

/// What differs from light to light.
struct EachLight {
    @align(16) own_from_world: mat3x3f,
    color: vec3f,
    intensity: f32,
    position: vec3f,
    fading: vec2f,
}

/// What is known before the fragment.
struct Look {
    @align(16) moon: Light,
    @align(16) lights: array<EachLight, 36>,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    position: vec3f,
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
    let l = pow(dot(rgb, vec3f(0.4122214708, 0.5363325363, 0.0514459929)), 0.3333333333333333);
    let m = pow(dot(rgb, vec3f(0.2119034982, 0.6806995451, 0.1073969566)), 0.3333333333333333);
    let s = pow(dot(rgb, vec3f(0.0883024619, 0.2817188376, 0.6299787005)), 0.3333333333333333);
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

/// [`oklab_of_linear`] of an sRGB-coded color.
fn oklab_of_srgb(coded: vec3f) -> vec3f {
    return oklab_of_linear(vec3f(pow((coded.x + 0.055) / 1.055, 2.4),
        pow((coded.y + 0.055) / 1.055, 2.4), pow((coded.z + 0.055) / 1.055, 2.4)));
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
        return vec4f(color.xyz, 1.0);
    }
    let room = limit - knee;
    let above = brightest - knee;
    let pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return vec4f(color.xyz * min(pressed / brightest, 1.0), 1.0);
}

/// Mix evenly
///
/// Goes from one color to another in steps that look even, without the gray or the dark that a
/// plain mix passes through.
fn mix_evenly_oklab(a: Color, b: Color, factor: f32) -> Color {
    return select(select(vec4f(srgb_of_oklab(mix(oklab_of_srgb(a.xyz), oklab_of_srgb(b.xyz),
        factor)), 1.0), b, factor >= 1.0), a, factor <= 0.0);
}

/// A light at `light_position` seen from `position`, both in world space; `fading` is half distance
/// and range.
fn light_at(
    light_position: vec3f,
    own_from_world: mat3x3f,
    color: vec3f,
    intensity: f32,
    fading: vec2f,
    position: vec3f,
) -> Light {
    let offset = light_position - position;
    let direction = normalize_or(offset, vec3f(0.0, 0.0, 1.0));
    let faded = intensity * light_fading(length(offset), fading);
    return Light(direction, own_from_world * direction, color, faded);
}

/// Attenuation at `distance`: 1 / (1 + (d / half)^2), ended smoothly at the range by (1 - (d /
/// range)^4)^2. A half distance or range of 0 leaves its factor out.
fn light_fading(distance: f32, fading: vec2f) -> f32 {
    var left = 1.0;
    if fading.x > 0.0 {
        let d = min(distance / fading.x, 1e15);
        left = 1.0 / (1.0 + d * d);
    }
    if fading.y > 0.0 {
        let d = min(distance / fading.y, 1.0);
        let window = max(1.0 - d * d * d * d, 0.0);
        left *= window * window;
    }
    return left;
}

struct LightParts {
    /// Unit, toward the light, world space.
    direction: vec3f,
    /// The light's color, opaque.
    color: Color,
    /// With the light's distance and cone attenuation; 0 or more.
    intensity: f32,
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
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

const lamps_tone_shape = ProfileShape(0.90044713, 0.43496552, 10.016686, 2.4912605, 0.9, 0.09820393,
    0.042312488, 0u);
const moon_tone_shape = ProfileShape(0.90044713, 0.43496552, 2.9163208, 3.0838382, 0.9, 0.3121117,
    0.13987324, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    var lamps_brightest = vec4f(0.0, 0.0, 0.0, 1.0);
    // For each light: lamp_1, lamp_2, lamp_3, lamp_4, lamp_5, lamp_6 and 30 more.
    for (var each = 0u; each < 36u; each++) {
        // Lamps (Each lamp)
        let light = light_at(look.lights[each].position, look.lights[each].own_from_world,
            look.lights[each].color, look.lights[each].intensity, look.lights[each].fading,
            surface.position);
        let light_2 = LightParts(light.direction, vec4f(light.color, 1.0), light.intensity);
        let lamps_angle = Angle(0.5 * length(surface.normal - light.direction), 0.5
            * length(surface.normal + light.direction));
        let lamps_tone = profile_balanced(lamps_angle, 0.0, lamps_tone_shape);
        let lamps_bands = mix(0.55, 1.0, eased(light_2.intensity, 0.5, 0.55));
        let lamps_reach = lamps_tone * (lamps_bands * eased(light_2.intensity, 0.2, 0.24));
        let lamps_lit = light_2.color * vec4f(vec3f(lamps_reach), 1.0);
        lamps_brightest = select(lamps_brightest,
            vec4f(max(lamps_brightest.xyz, lamps_lit.xyz), 1.0), light_2.intensity > 0.0);
    }

    // Parametrization
    let moon_angle = Angle(0.5 * length(surface.normal - look.moon.direction), 0.5
        * length(surface.normal + look.moon.direction));
    let moon_tone = profile_balanced(moon_angle, 0.0, moon_tone_shape);
    let dusk = mix_evenly_oklab(vec4f(0.07, 0.08, 0.16, 1.0), vec4f(0.2, 0.24, 0.4, 1.0),
        moon_tone);
    return limit_color(vec4f(lamps_brightest.xyz + dusk.xyz, 1.0), 1.0, 0.3);
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
    let surface = Surface(normal, in.position);
    return shade(surface);
}
