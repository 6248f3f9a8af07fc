#version 450 core
// Orange peel: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure7-orange.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

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
    Light key;
    Light fill;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position;
    vec3 position_object;
    float kappa;
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
    vec3 position_object;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const uint NOISE_PERLIN = 1u;
const ProfileShape flesh_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.1220733, 1.2466265,
    0.1, 1.2259196, 0.51338285, 0u);
const ProfileShape shade_tone_shape = ProfileShape(0.9950042, 0.099833414, 1.6523834, 1.9165641,
    0.2, 0.67495763, 0.28714308, 0u);
const ProfileShape waxy_sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 2.2990327,
    2.8187852, 0.05, 0.41226318, 0.18345885, 0u);
const ProfileShape glint_tone_shape = ProfileShape(0.9992001, 0.039989334, 14.297388, 3.2165964,
    0.08, 0.062200632, 0.027819062, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
vec2 sin_cos_quick(float x) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666666 + y
        * (0.0083332425 + y * (-0.0001982274 + y * 2.6347564e-6))));
    float c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (2.477458e-5 - y * 2.6297516e-7))));
    return vec2(s, c);
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
    float s = u.half_sin * t.y - u.half_cos * t.x;
    float c = u.half_cos * t.y + u.half_sin * t.x;
    vec2 upper = c <= 0.0 ? vec2(1.0, 0.0) : vec2(s, c);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    vec2 turned = (s <= 0.0 && s < c) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(Angle u, vec2 t) {
    float s = u.half_sin - 0.0;
    vec2 upper = u.half_cos <= 0.0 ? vec2(1.0, 0.0) : vec2(s, u.half_cos);
    vec2 turned = (s <= 0.0 && s < u.half_cos) ? vec2(0.0, 1.0) : upper;
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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high) {
    float t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The length of v, also where its square would over- or underflow.
float length_of(vec3 v) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (largest < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(largest * length(v / vec3(largest)));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(vec3 v) {
    vec3 dx = dFdx(v);
    vec3 dy = dFdy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return concave + convexity * (convex - concave);
}

/// The normal of a surface that is raised by a height (Mikkelsen 2010): `along_x` and `along_y`
/// hold how position (xyz) and height (w) change from pixel to pixel. Where position does not
/// change, or the surface is seen edge-on, the normal stays as it is. Slopes end at 10, which is 84
/// degrees, so that silhouettes do not sparkle.
vec3 bumped_normal(vec4 along_x, vec4 along_y, vec3 normal) {
    float largest = max(length_of(along_x.xyz), length_of(along_y.xyz));
    if (largest < 1e-18 || largest > 1e18) {
        return normal;
    }
    vec3 s = along_x.xyz / vec3(largest);
    vec3 t = along_y.xyz / vec3(largest);
    vec2 rise = clamp(vec2(along_x.w, along_y.w) / vec2(largest), vec2(-1000000.0),
        vec2(1000000.0));
    vec3 right = cross(t, normal);
    vec3 up = cross(normal, s);
    float area = dot(s, right);
    if (abs(area) < 1e-6) {
        return normal;
    }
    vec3 slope = (rise.x * right + rise.y * up) / vec3(area);
    float steepness = length(slope);
    vec3 limited = slope * (min(steepness, 10.0) / max(steepness, 1e-20));
    return normalize_or(normal - limited, normal);
}

/// Bump map
///
/// Bends the normal as if the surface were raised by a height: from a picture, a noise or anything
/// else. It needs no texture coordinates.
vec3 bump_map(float height, float scale, vec3 normal, vec3 position) {
    float raised = height * scale;
    vec4 along_x = vec4(dFdx(position), dFdx(raised));
    vec4 along_y = vec4(dFdy(position), dFdy(raised));
    return bumped_normal(along_x, along_y, normal);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + tone * (color.xyz - below.xyz), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_alpha_2(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_shade(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + 0.75 * (below.xyz * mix(vec3(1.0), color.xyz, tone) - below.xyz),
        1.0), vec4(0.0), vec4(1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

Angle parametrization_specular_balanced(Light light, vec3 normal, vec3 view) {
    vec3 d = 2.0 * dot(normal, view) * normal - view;
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(Angle u, float w, ProfileShape shape) {
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
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned_2(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_3(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned_2(angle, vec2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v = uvec3(0u);
    v = seed * 1664525u + uvec3(1013904223u);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> uvec3(16u));
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

/// The hash of a lattice point.
uvec3 lattice_hash(ivec3 cell, uint seed) {
    return hash_pcg3d(uvec3(cell) + seed * uvec3(2654435769u, 2246822507u, 3266489909u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = (hash.x >> 8u) % 3u;
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
vec3 fade_quintic(vec3 t) {
    return t * t * t * (t * (t * 6.0 - vec3(15.0)) + vec3(10.0));
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(vec3 p, uint seed) {
    float sum = 0.0;
    vec3 corner = floor(p);
    vec3 d = p - corner;
    vec3 f = fade_quintic(d);
    ivec3 cell = ivec3(corner);
    for (int i = 0; i < 8; i++) {
        ivec3 at = ivec3(i & 1, (i >> 1u) & 1, i >> 2u);
        vec3 weight = mix(vec3(1.0) - f, f, equal(at, ivec3(1)));
        sum = sum + weight.x * weight.y * weight.z
            * gradient_dot(lattice_hash(cell + at, seed), d - vec3(at));
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
float fractal_noise(uint kind, vec3 p, int octaves, float roughness, int seed, float w) {
    float octave = 0.0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum = 0.0;
    for (int i = 0; i < 2; i++) {
        float visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        octave = 0.5;
        if (visible > 0.0) {
            vec3 place = clamp(p * frequency + float(i) * vec3(17.31, 5.17, 11.73),
                vec3(-4194304.0), vec3(4194304.0));
            octave = mix(0.5, perlin_noise(place, 0u + uint(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return min(sum / 1.5, 1.0);
}

float noise_perlin(vec3 position, float scale, int octaves, float roughness, int seed) {
    vec3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Flesh (Light layer)
    float shade_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(surface.kappa * 0.1, -20.0, 20.0))));
    vec4 flesh_color = curvature_color(shade_convexity, vec4(0.9686, 0.6039, 0.1176, 1.0),
        vec4(0.8471, 0.4118, 0.0392, 1.0));

    float pores = noise_perlin(surface.position_object, 14.0, 2, 0.5, 0);
    vec3 rind = bump_map(pores, 0.035, surface.normal, surface.position);

    // Flesh
    Angle flesh_angle = Angle(0.5 * length(rind - u_look.key.direction), 0.5
        * length(rind + u_look.key.direction));
    float flesh_warp = (2.0 * shade_convexity - 1.0) * 0.2;
    float flesh_tone = profile_balanced(flesh_angle, flesh_warp, flesh_tone_shape);
    LitLayer flesh_lit = light_apply(u_look.key, flesh_color, flesh_tone);
    vec4 flesh_blend = blend_alpha(vec4(0.4314, 0.1647, 0.0235, 1.0), flesh_lit.color,
        flesh_lit.tone, 1.0, true);

    // Shade (Light layer)
    vec4 shade_color = curvature_color(shade_convexity, vec4(0.7216, 0.2824, 0.0471, 1.0),
        vec4(0.5412, 0.1843, 0.0392, 1.0));
    Angle shade_angle = Angle(0.5 * length(rind - u_look.fill.direction), 0.5
        * length(rind + u_look.fill.direction));
    float shade_warp = (2.0 * shade_convexity - 1.0) * 0.1;
    float shade_tone = profile_balanced(shade_angle, shade_warp, shade_tone_shape);
    LitLayer shade_lit = light_apply(u_look.fill, shade_color, shade_tone);
    vec4 shade_blend = blend_shade(flesh_blend, shade_lit.color, shade_lit.tone, 0.75, true);

    // Waxy sheen (Light layer)
    Angle glint_angle = parametrization_specular_balanced(u_look.key, rind, surface.view);
    float waxy_sheen_tone = profile_balanced_2(glint_angle, 0.0, waxy_sheen_tone_shape);
    LitLayer waxy_sheen_lit = light_apply(u_look.key, vec4(0.4157, 0.2902, 0.1333, 1.0),
        waxy_sheen_tone);
    vec4 waxy_sheen_blend = clamp(vec4(shade_blend.xyz + 0.55
        * (shade_blend.xyz + waxy_sheen_lit.tone * waxy_sheen_lit.color.xyz - shade_blend.xyz),
        1.0), vec4(0.0), vec4(1.0));

    // Glint (Light layer)
    float glint_tone = profile_balanced_3(glint_angle, 0.0, glint_tone_shape);
    LitLayer glint_lit = light_apply(u_look.key, vec4(1.0), glint_tone);
    vec4 glint_blend = blend_alpha_2(waxy_sheen_blend, glint_lit.color, glint_lit.tone, 0.85, true);

    return glint_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        in_.position, in_.position_object, texel.x);
    out_color = shade(surface);
}
