#version 450 core
// Guest: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// room-guest.json says what to put there and how to draw.
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
    vec3 eye_position;
    mat3x3 eye_own_from_world;
    vec3 eye_color;
    float eye_intensity;
    vec2 eye_fading;
    vec3 rim_position;
    vec3 rim_aim;
    mat3x3 rim_own_from_world;
    vec3 rim_color;
    float rim_intensity;
    vec2 rim_cone;
    vec2 rim_fading;
    vec3 fill_position;
    mat3x3 fill_own_from_world;
    vec3 fill_color;
    float fill_intensity;
    vec2 fill_fading;
    vec3 sun_direction;
    Light sun;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 position;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

struct LitLayer {
    /// The color under this light.
    vec4 color;
    /// The tone under this light.
    float tone;
};

struct FilteredLight {
    /// The light behind the filter.
    Light light;
    /// The angle for the profile.
    Angle angle;
};

struct LightParts {
    /// Unit, toward the light, world space.
    vec3 direction;
    /// The light's color, opaque.
    vec4 color;
    /// With the light's distance and cone attenuation; 0 or more.
    float intensity;
};

struct PlaceInLight {
    /// From 0,0 at the picture's lower left corner to 1,1 at its upper right one, as the light sees
    /// it.
    vec2 uv;
    /// 1 within the picture, 0 outside of it.
    float inside;
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
    vec3 position;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const ProfileShape lamps_eye_tone_shape = ProfileShape(0.87758255, 0.47942555, 8.353367, 2.4874215,
    1.0, 0.117860116, 0.05078552, 0u);

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(float x) {
    return (floatBitsToUint(x) & 2139095040u) != 2139095040u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest > 1e-30 && largest < 1e30)) {
        return otherwise;
    }
    vec3 scaled = v * (1.0 / largest);
    float square = dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(max(square, 1e-30)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
vec3 normalize_seen(vec3 v) {
    return normalize_moderate(v, vec3(0.0, 0.0, 1.0));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(Angle u, vec2 t) {
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + 0.0;
    vec2 upper = c <= 0.0 ? vec2(1.0, 0.0) : vec2(s, c);
    vec2 turned = (s <= 0.0 && s < c) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = bits & 2147483647u;
    float largest = uintBitsToFloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// [`bounded`], component by component.
vec3 bounded_vec3(vec3 v) {
    uvec3 bits = floatBitsToUint(v);
    uvec3 magnitude = bits & uvec3(2147483647u);
    vec3 largest = uintBitsToFloat((bits & uvec3(2147483648u)) | uvec3(2139095039u));
    vec3 numbers = mix(vec3(0.0), largest, equal(magnitude, uvec3(2139095040u)));
    return mix(numbers, v, lessThan(magnitude, uvec3(2139095040u)));
}

/// [`bounded`], component by component.
vec4 bounded_vec4(vec4 v) {
    uvec4 bits = floatBitsToUint(v);
    uvec4 magnitude = bits & uvec4(2147483647u);
    vec4 largest = uintBitsToFloat((bits & uvec4(2147483648u)) | uvec4(2139095039u));
    vec4 numbers = mix(vec4(0.0), largest, equal(magnitude, uvec4(2139095040u)));
    return mix(numbers, v, lessThan(magnitude, uvec4(2139095040u)));
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(float x, float low, float high) {
    float span = high - low;
    if (span < SMALLEST_NORMAL) {
        return x >= high ? 1.0 : 0.0;
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high) {
    float t = clamp(place_between(x, low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// Relative luminance by the Rec. 709 weights, of the numbers as they stand.
float luminance(vec4 color) {
    return dot(color.xyz, vec3(0.2126, 0.7152, 0.0722));
}

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
vec4 limit_color(vec4 color, float limit, float softness) {
    float knee = 1.0 - softness;
    float brightest = max(max(color.x, color.y), color.z);
    if (brightest <= knee) {
        return vec4(color.xyz, 1.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return vec4(color.xyz * min(pressed / brightest, 1.0), 1.0);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 leaning = cross(up, toward);
    float square = dot(leaning, leaning);
    vec3 aside = abs(toward.x) > 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 across = square > 1e-8 ? leaning : cross(aside, toward);
    vec3 x = normalize_moderate(across - dot(across, toward) * toward, vec3(1.0, 0.0, 0.0));
    return mat3x3(x, cross(toward, x), toward);
}

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
mat3x3 axes_turned(vec3 toward, float spin) {
    mat3x3 axes = axes_around(toward, vec3(0.0, 1.0, 0.0));
    vec2 turn = vec2(0.0, 1.0);
    return mat3x3(turn.y * axes[0] + turn.x * axes[1], turn.y * axes[1] - turn.x * axes[0],
        axes[2]);
}

/// A place as seen from a center along axes, within a million of it.
vec3 place_along(vec3 place, vec3 center, mat3x3 axes) {
    vec3 away = clamp(place - center, vec3(-1000000.0), vec3(1000000.0));
    return vec3(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

/// The share of a light that passes a shape at distance m, 1 on its surface, in sizes of the shape:
/// its edge is `softness` wide outward, and never narrower than a pixel. Call it in uniform control
/// flow.
float share_beside(float m, float softness, float density, bool inverted) {
    float half_ = 0.5 * min(footprint_of(m), 0.25);
    float beside = eased(m, 1.0 - half_, 1.0 + half_);
    return 1.0 - beside;
}

/// An angle as a filter before the profile leaves it: tan(u/2) over the share that passes, so that
/// the dark side grows from its edge as less passes, and everything is dark where nothing does.
Angle angle_filtered(Angle u, float share) {
    float cosine = u.half_cos * share;
    float square = u.half_sin * u.half_sin + cosine * cosine;
    float scale = inversesqrt(max(square, 1e-30));
    bool is_dark = square < 1e-30;
    return Angle(is_dark ? 1.0 : u.half_sin * scale, is_dark ? 0.0 : cosine * scale);
}

/// Attenuation at `distance`: 1 / (1 + (d / half)^2), ended smoothly at the range by (1 - (d /
/// range)^4)^2. A half distance or range of 0 leaves its factor out.
float light_fading(float distance_, vec2 fading) {
    float left = 1.0;
    if (fading.x > 0.0) {
        float d = min(distance_ / fading.x, 1000000000000000.0);
        left = 1.0 / (1.0 + d * d);
    }
    if (fading.y > 0.0) {
        float d_1 = min(distance_ / fading.y, 1.0);
        float window = max(1.0 - d_1 * d_1 * d_1 * d_1, 0.0);
        left = left * (window * window);
    }
    return left;
}

/// A light at `light_position` seen from `position`, both in world space; `fading` is half distance
/// and range.
Light light_at(vec3 light_position, mat3x3 own_from_world, vec3 color, float intensity, vec2 fading,
    vec3 position) {
    vec3 offset = light_position - position;
    vec3 direction = normalize_or(offset, vec3(0.0, 0.0, 1.0));
    float faded = intensity * light_fading(length(offset), fading);
    return Light(direction, own_from_world * direction, color, faded);
}

/// Attenuation at an angle from a spot light's aim: smoothstep between the cosines `cone.y` (outer)
/// and `cone.x` (inner); a hard, inclusive edge where they are equal.
float light_cone(float cos_angle, vec2 cone) {
    if (cone.x <= cone.y) {
        return cos_angle >= cone.y ? 1.0 : 0.0;
    }
    float t = clamp((cos_angle - cone.y) / (cone.x - cone.y), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Light light_spot(vec3 light_position, vec3 aim, mat3x3 own_from_world, vec3 color, float intensity,
    vec2 cone, vec2 fading, vec3 position) {
    Light light = Light(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    light = light_at(light_position, own_from_world, color, intensity, fading, position);
    light.intensity = light.intensity * light_cone(dot(-light.direction, aim), cone);
    return light;
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

/// Light parts
///
/// Takes a light apart, for shading that the other nodes do not know.
LightParts light_parts(Light light) {
    return LightParts(light.direction, vec4(light.color, 1.0), light.intensity);
}

PlaceInLight place_in_light(vec2 at) {
    vec2 near = clamp(at, vec2(-1000.0), vec2(1000.0));
    float inside = share_beside(max(abs(near.x), abs(near.y)), 0.0, 1.0, true);
    return PlaceInLight(vec2(0.5) + 0.5 * vec2(-near.x, near.y), inside);
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

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned_2(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// Window
///
/// Four panes of a window: 1 through the glass, 0 at its bars and beyond.
float window(vec2 uv, float bars, float softness) {
    vec2 from_edge = vec2(0.5) - abs(uv - vec2(0.5));
    vec2 from_cross = abs(uv - vec2(0.5));
    vec2 within = smoothstep(vec2(bars), vec2(bars + softness), from_edge);
    vec2 beside = smoothstep(vec2(0.5 * bars), vec2(0.5 * bars + softness), from_cross);
    return within.x * within.y * beside.x * beside.y;
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Lamps eye (Lamps)
    Light eye = light_at(u_look.eye_position, u_look.eye_own_from_world, u_look.eye_color,
        u_look.eye_intensity, u_look.eye_fading, surface.position);
    LightParts eye_2 = light_parts(eye);
    vec4 lamps_eye_strength = bounded_vec4(eye_2.color * vec4(vec3(eye_2.intensity), 1.0));
    Angle lamps_eye_angle = parametrization_diffuse_balanced(eye, surface.normal);
    float lamps_eye_tone = profile_balanced(lamps_eye_angle, 0.0, lamps_eye_tone_shape);
    vec4 lamps_eye_lit = bounded_vec4(lamps_eye_strength * vec4(vec3(lamps_eye_tone), 1.0));

    // Lamps rim (Lamps)
    Light rim = light_spot(u_look.rim_position, u_look.rim_aim, u_look.rim_own_from_world,
        u_look.rim_color, u_look.rim_intensity, u_look.rim_cone, u_look.rim_fading,
        surface.position);
    LightParts rim_2 = light_parts(rim);
    vec4 lamps_rim_strength = bounded_vec4(rim_2.color * vec4(vec3(rim_2.intensity), 1.0));
    Angle lamps_rim_angle = parametrization_diffuse_balanced(rim, surface.normal);
    float lamps_rim_tone = profile_balanced(lamps_rim_angle, 0.0, lamps_eye_tone_shape);
    vec4 lamps_rim_lit = bounded_vec4(lamps_rim_strength * vec4(vec3(lamps_rim_tone), 1.0));

    // Lamps fill (Lamps)
    Light fill = light_at(u_look.fill_position, u_look.fill_own_from_world, u_look.fill_color,
        u_look.fill_intensity, u_look.fill_fading, surface.position);
    LightParts fill_2 = light_parts(fill);
    vec4 lamps_fill_strength = bounded_vec4(fill_2.color * vec4(vec3(fill_2.intensity), 1.0));
    Angle lamps_fill_angle = parametrization_diffuse_balanced(fill, surface.normal);
    float lamps_fill_tone = profile_balanced(lamps_fill_angle, 0.0, lamps_eye_tone_shape);
    vec4 lamps_fill_lit = bounded_vec4(lamps_fill_strength * vec4(vec3(lamps_fill_tone), 1.0));
    vec3 bounded_vec3_value = bounded_vec3(vec3(0.0) + lamps_fill_lit.xyz);
    vec4 lamps_fill_sum = fill_2.intensity
        > 0.0 ? vec4(bounded_vec3_value, 1.0) : vec4(0.0, 0.0, 0.0, 1.0);
    vec3 bounded_vec3_value_1 = bounded_vec3(lamps_fill_sum.xyz + lamps_rim_lit.xyz);

    // Lamps rim
    vec4 lamps_rim_sum = rim_2.intensity > 0.0 ? vec4(bounded_vec3_value_1, 1.0) : lamps_fill_sum;
    vec3 bounded_vec3_value_2 = bounded_vec3(lamps_rim_sum.xyz + lamps_eye_lit.xyz);

    // Lamps eye
    vec4 lamps_eye_sum = eye_2.intensity > 0.0 ? vec4(bounded_vec3_value_2, 1.0) : lamps_rim_sum;

    vec4 lamplit = lamps_eye_sum * vec4(0.86, 0.62, 0.44, 1.0);
    vec4 night = lamplit + vec4(0.1, 0.07, 0.15, 1.0);
    // Base
    vec4 ground = vec4(night.xyz, 1.0);
    Angle sun_angle = parametrization_diffuse_balanced(u_look.sun, surface.normal);
    vec3 place_along_value = place_along(surface.position, vec3(0.1, -0.05, 0.0),
        axes_turned(-u_look.sun_direction, 0.0));
    PlaceInLight thrown = place_in_light(place_along_value.xy / vec2(0.95));
    float window_2 = window(thrown.uv, 0.05, 0.02);
    // Light filter
    FilteredLight filter_2 = FilteredLight(u_look.sun,
        angle_filtered(sun_angle, min(window_2, 1.0) * min(luminance(vec4(1.0)), 1.0)));
    float sun_tone = profile_balanced_2(filter_2.angle, 0.0, lamps_eye_tone_shape);
    LitLayer sun_lit = light_apply(filter_2.light, vec4(0.86, 0.62, 0.44, 1.0), sun_tone);
    // Blend
    vec4 stack = clamp(vec4(ground.xyz + sun_lit.tone * sun_lit.color.xyz, 1.0), vec4(0.0),
        vec4(1.0));
    return limit_color(stack, 1.0, 0.3);
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, in_.position);
    out_color = shade(surface);
}
