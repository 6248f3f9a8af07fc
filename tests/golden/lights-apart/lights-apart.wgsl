// Ten lights, each with its own edge: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// lights-apart.json says what to put there and how to draw.

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

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
fn limit_color(color: Color, limit: f32, softness: f32) -> Color {
    let c = clamp(color.xyz, vec3f(-1e18), vec3f(1e18));
    let knee = 1.0 - softness;
    let brightest = max(max(c.x, c.y), c.z);
    if brightest <= knee {
        return vec4f(c, 2.0);
    }
    let room = limit - knee;
    let above = brightest - knee;
    let pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return vec4f(c * min(pressed / brightest, 1.0), 2.0);
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

fn sum_of_lights_color(value: Color, before_sum: Color, reach: f32) -> Color {
    return select(before_sum, vec4f(before_sum.xyz + value.xyz, 1.0), reach > 0.0);
}

const lamps_moon_tone_shape = ProfileShape(0.9358968, 0.35227424, 66.66917, 2.499803, 0.72,
    0.014726315, 0.0063439487, 0u);

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

    let dark = lamps_moon_sum + vec4f(0.07, 0.05, 0.1, 1.0);
    return vec4f(limit_color(dark, 1.0, 0.4).xyz, 1.0);
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
