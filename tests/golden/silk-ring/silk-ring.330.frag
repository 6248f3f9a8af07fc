#version 330 core
// Silk: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// silk-ring.json says what to put there and how to draw.
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
    Light low;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    vec3 direction;
    vec3 x_axis;
    vec3 y_axis;
    /// The direction's cosines with the two axes.
    vec2 place;
};

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    vec3 x_axis;
    /// Unit, upright.
    vec3 y_axis;
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

const uint NOISE_PERLIN = 1u;
const ProfileShape lit_side_shape = ProfileShape(0.9950042, 0.099833414, 1.1883951, 1.7298278, 0.2,
    1.0107075, 0.4419037, 0u);
const ProfileShape band_shape = ProfileShape(0.9998875, 0.014999437, 9.541332, 4.980432, 0.03,
    0.07759806, 0.03648918, 0u);
const ProfileShape second_band_shape = ProfileShape(1.0, 0.0, 6.6917324, 12.899528, 0.0, 0.07171497,
    0.035865854, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(vec3 v) {
    vec3 dx = dFdx(v);
    vec3 dy = dFdy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
vec3 any_orthogonal(vec3 n) {
    float sign_ = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign_ + n.z);
    return vec3(1.0 + sign_ * n.x * n.x * a, sign_ * n.x * n.y * a, -sign_ * n.x);
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
DirectionParts direction_within(vec3 direction, vec3 x_axis, vec3 y_axis) {
    vec3 y = y_axis * inversesqrt(max(dot(y_axis, y_axis), 1e-30));
    return DirectionParts(direction, x_axis, y, vec2(dot(direction, x_axis), dot(direction, y)));
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
vec3 direction_moved(DirectionParts parts, vec2 by) {
    vec3 moved = parts.direction + by.x * parts.x_axis + by.y * parts.y_axis;
    vec3 normalize_moderate_value = normalize_moderate(moved, parts.direction);
    return dot(moved, moved) > 1e-6 ? normalize_moderate_value : parts.direction;
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

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
AxesAround axes(vec3 direction, vec3 up) {
    mat3x3 axes_2 = axes_around(direction, up);
    return AxesAround(axes_2[0], axes_2[1]);
}

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
vec3 half_vector(Light light, vec3 view) {
    vec3 half_ = light.direction + view;
    vec3 any_orthogonal_value = any_orthogonal(view);
    return normalize_or(dot(half_, half_) > 1e-12 ? half_ : any_orthogonal_value, view);
}

/// Stretch direction
///
/// Makes a highlight longer along an axis (above 0) or shorter (below 0): streaks of silk, hair and
/// brushed metal.
vec3 stretch_direction(vec3 direction, vec3 x_axis, vec3 y_axis, float x, float y) {
    DirectionParts bent = direction_within(direction, x_axis, y_axis);
    return direction_moved(bent, -vec2(x, y) * bent.place);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return vec4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

vec4 blend_alpha_2(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4(0.0), vec4(1.0));
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
    Angle warped = angle_turned_2(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
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
    // Parametrization
    Angle turned_from_the_key = Angle(0.5 * length(surface.normal - u_look.key.direction), 0.5
        * length(surface.normal + u_look.key.direction));
    float lit_side = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    vec4 body = blend_alpha(vec4(0.2275, 0.102, 0.2431, 1.0), vec4(0.4824, 0.1843, 0.3882, 1.0),
        lit_side, 1.0, true);
    vec3 normal = surface.normal;
    vec3 half_ = half_vector(u_look.key, surface.view);
    AxesAround upright = axes(half_, vec3(0.0, 1.0, 0.0));
    vec3 band_without_end = stretch_direction(normal, upright.x_axis, upright.y_axis, 0.985, 0.0);
    // Angle between directions
    Angle from_the_band = Angle(0.5 * length(band_without_end - half_), 0.5
        * length(band_without_end + half_));
    float strands = noise_perlin(surface.position_object, 14.0, 2, 0.5, 0);
    float waver = mix(-0.05, 0.05, strands - 0.0);
    float band = profile_balanced_2(from_the_band, waver, band_shape);
    vec4 band_on_top = blend_alpha_2(body, vec4(0.9529, 0.6627, 0.7059, 1.0), band, 0.95, true);
    vec3 low_half = half_vector(u_look.low, surface.view);
    AxesAround upright_2 = axes(low_half, vec3(0.0, 1.0, 0.0));
    vec3 second_band = stretch_direction(normal, upright_2.x_axis, upright_2.y_axis, 0.985, 0.0);
    // Angle between directions
    Angle from_the_second = Angle(0.5 * length(second_band - low_half), 0.5
        * length(second_band + low_half));
    float second_band_2 = profile_balanced_2(from_the_second, waver, second_band_shape);
    // Blend
    vec4 second_band_on_top = clamp(vec4(band_on_top.xyz + 0.8
        * (band_on_top.xyz + second_band_2 * vec3(0.3529, 0.2471, 0.549) - band_on_top.xyz), 1.0),
        vec4(0.0), vec4(1.0));
    return second_band_on_top;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        in_.position_object);
    out_color = shade(surface);
}
