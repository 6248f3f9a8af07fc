#version 330 core
// Ten lights, each with its own edge: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// lights-apart.json says what to put there and how to draw.
/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    vec3 direction;
    /// Unit, toward the light, in the light's own frame.
    vec3 own_direction;
    /// Straight RGB.
    vec3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    Light moon;
    float moon_intensity;
    Light violet;
    float violet_intensity;
    Light rose;
    float rose_intensity;
    Light amber;
    float amber_intensity;
    Light gold;
    float gold_intensity;
    Light coral;
    float coral_intensity;
    Light magenta;
    float magenta_intensity;
    Light cobalt;
    float cobalt_intensity;
    Light turquoise;
    float turquoise_intensity;
    Light azure;
    float azure_intensity;
    vec4 lamps_moon_strength;
    vec4 lamps_violet_strength;
    vec4 lamps_rose_strength;
    vec4 lamps_amber_strength;
    vec4 lamps_gold_strength;
    vec4 lamps_coral_strength;
    vec4 lamps_magenta_strength;
    vec4 lamps_cobalt_strength;
    vec4 lamps_turquoise_strength;
    vec4 lamps_azure_strength;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    uint kind;
};

struct Varyings {
    vec4 clip;
    vec3 normal;
};

const ProfileShape lamps_moon_tone_shape = ProfileShape(0.9358968, 0.35227424, 66.66917, 2.499803,
    0.72, 0.014726315, 0.0063439487, 0u);

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, vec2 t) {
    float s = u.half_sin - 0.0;
    vec2 upper = u.half_cos <= 0.0 ? vec2(1.0, 0.0) : vec2(s, u.half_cos);
    vec2 turned = (s <= 0.0 && s < u.half_cos) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
vec4 limit_color(vec4 color, float limit, float softness) {
    vec3 c = clamp(color.xyz, vec3(-1e18), vec3(1e18));
    float knee = 1.0 - softness;
    float brightest = max(max(c.x, c.y), c.z);
    if (brightest <= knee) {
        return vec4(c, 2.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return vec4(c * min(pressed / brightest, 1.0), 2.0);
}

Angle parametrization_diffuse_balanced(Light light, vec3 normal) {
    return Angle(0.5 * length(normal - light.direction), 0.5 * length(normal + light.direction));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    bool is_narrow = w > 0.0 && w >= 3.4641016 * shape.edge_deviation;
    if (is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

vec4 sum_of_lights_color(vec4 value, vec4 before_sum, float reach) {
    return reach > 0.0 ? vec4(before_sum.xyz + value.xyz, 1.0) : before_sum;
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Lamps moon (Each lamp)
    Angle lamps_moon_angle = parametrization_diffuse_balanced(u_look.moon, surface.normal);
    float lamps_moon_tone = profile_balanced(lamps_moon_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_moon_lit = u_look.lamps_moon_strength * vec4(vec3(lamps_moon_tone), 1.0);

    // Lamps violet (Each lamp)
    Angle lamps_violet_angle = parametrization_diffuse_balanced(u_look.violet, surface.normal);
    float lamps_violet_tone = profile_balanced(lamps_violet_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_violet_lit = u_look.lamps_violet_strength * vec4(vec3(lamps_violet_tone), 1.0);

    // Lamps rose (Each lamp)
    Angle lamps_rose_angle = parametrization_diffuse_balanced(u_look.rose, surface.normal);
    float lamps_rose_tone = profile_balanced(lamps_rose_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_rose_lit = u_look.lamps_rose_strength * vec4(vec3(lamps_rose_tone), 1.0);

    // Lamps amber (Each lamp)
    Angle lamps_amber_angle = parametrization_diffuse_balanced(u_look.amber, surface.normal);
    float lamps_amber_tone = profile_balanced(lamps_amber_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_amber_lit = u_look.lamps_amber_strength * vec4(vec3(lamps_amber_tone), 1.0);

    // Lamps gold (Each lamp)
    Angle lamps_gold_angle = parametrization_diffuse_balanced(u_look.gold, surface.normal);
    float lamps_gold_tone = profile_balanced(lamps_gold_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_gold_lit = u_look.lamps_gold_strength * vec4(vec3(lamps_gold_tone), 1.0);

    // Lamps coral (Each lamp)
    Angle lamps_coral_angle = parametrization_diffuse_balanced(u_look.coral, surface.normal);
    float lamps_coral_tone = profile_balanced(lamps_coral_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_coral_lit = u_look.lamps_coral_strength * vec4(vec3(lamps_coral_tone), 1.0);

    // Lamps magenta (Each lamp)
    Angle lamps_magenta_angle = parametrization_diffuse_balanced(u_look.magenta, surface.normal);
    float lamps_magenta_tone = profile_balanced(lamps_magenta_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_magenta_lit = u_look.lamps_magenta_strength * vec4(vec3(lamps_magenta_tone), 1.0);

    // Lamps cobalt (Each lamp)
    Angle lamps_cobalt_angle = parametrization_diffuse_balanced(u_look.cobalt, surface.normal);
    float lamps_cobalt_tone = profile_balanced(lamps_cobalt_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_cobalt_lit = u_look.lamps_cobalt_strength * vec4(vec3(lamps_cobalt_tone), 1.0);

    // Lamps turquoise (Each lamp)
    Angle lamps_turquoise_angle = parametrization_diffuse_balanced(u_look.turquoise,
        surface.normal);
    float lamps_turquoise_tone = profile_balanced(lamps_turquoise_angle, 0.0,
        lamps_moon_tone_shape);
    vec4 lamps_turquoise_lit = u_look.lamps_turquoise_strength
        * vec4(vec3(lamps_turquoise_tone), 1.0);

    // Lamps azure (Each lamp)
    Angle lamps_azure_angle = parametrization_diffuse_balanced(u_look.azure, surface.normal);
    float lamps_azure_tone = profile_balanced(lamps_azure_angle, 0.0, lamps_moon_tone_shape);
    vec4 lamps_azure_lit = u_look.lamps_azure_strength * vec4(vec3(lamps_azure_tone), 1.0);
    vec4 lamps_azure_sum = u_look.azure_intensity
        > 0.0 ? vec4(vec3(0.0) + lamps_azure_lit.xyz, 1.0) : vec4(0.0, 0.0, 0.0, 1.0);

    // Lamps turquoise
    vec4 lamps_turquoise_sum = sum_of_lights_color(lamps_turquoise_lit, lamps_azure_sum,
        u_look.turquoise_intensity);

    // Lamps cobalt
    vec4 lamps_cobalt_sum = sum_of_lights_color(lamps_cobalt_lit, lamps_turquoise_sum,
        u_look.cobalt_intensity);

    // Lamps magenta
    vec4 lamps_magenta_sum = sum_of_lights_color(lamps_magenta_lit, lamps_cobalt_sum,
        u_look.magenta_intensity);

    // Lamps coral
    vec4 lamps_coral_sum = sum_of_lights_color(lamps_coral_lit, lamps_magenta_sum,
        u_look.coral_intensity);

    // Lamps gold
    vec4 lamps_gold_sum = sum_of_lights_color(lamps_gold_lit, lamps_coral_sum,
        u_look.gold_intensity);

    // Lamps amber
    vec4 lamps_amber_sum = sum_of_lights_color(lamps_amber_lit, lamps_gold_sum,
        u_look.amber_intensity);

    // Lamps rose
    vec4 lamps_rose_sum = sum_of_lights_color(lamps_rose_lit, lamps_amber_sum,
        u_look.rose_intensity);

    // Lamps violet
    vec4 lamps_violet_sum = sum_of_lights_color(lamps_violet_lit, lamps_rose_sum,
        u_look.violet_intensity);

    // Lamps moon
    vec4 lamps_moon_sum = sum_of_lights_color(lamps_moon_lit, lamps_violet_sum,
        u_look.moon_intensity);

    vec4 dark = lamps_moon_sum + vec4(0.07, 0.05, 0.1, 1.0);
    return vec4(limit_color(dark, 1.0, 0.4).xyz, 1.0);
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal);
    out_color = shade(surface);
}
