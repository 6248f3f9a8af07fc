#version 300 es
// Iridescent film: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-film.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
};

/// Cosines between normal (n), light (l), view (v) and half-vector (h), of which all models are
/// made; every cosine is at least a little above 0 where it divides.
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    /// The square of the sine between the normal and the half-vector: near a highlight's middle a
    /// cosine has no digits left to tell how far it is.
    float sine2_;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};

const float PI = 3.1415927;
const float LN_2 = 0.6931472;
const float LOG2_E = 1.442695;
const uint NOISE_PERLIN = 1u;

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x) {
    float clamped = max(x, -126.0);
    float whole = roundEven(clamped);
    float f = clamped - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * uintBitsToFloat(uint(int(whole) + 126) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(float x) {
    uint bits = floatBitsToUint(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = int(bits - 1060439283u) >> 23u;
    float mantissa = uintBitsToFloat(bits - (uint(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return float(exponent) + z * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(float y) {
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(float y) {
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return LN_2 * log2_stable(1.0 - y);
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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(vec3 v) {
    vec3 dx = dFdx(v);
    vec3 dy = dFdy(v);
    return sqrt(max(dot(dx, dx), dot(dy, dy)));
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + opacity * (below.xyz + tone * vec3(1.0) - below.xyz), 1.0),
        vec4(0.0), vec4(1.0));
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
vec3 half_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = light + view;
    return normalize_moderate(dot(half_, half_) > 1e-12 ? half_ : normal, normal);
}

/// The square of the sine between two unit vectors.
float sine_squared(vec3 a, vec3 b) {
    vec3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
Reflection reflection_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = half_of(light, normal, view);
    float n_h = clamp(dot(normal, half_), 0.0, 1.0);
    float v_h = clamp(dot(view, half_), 0.0, 1.0);
    return Reflection(dot(normal, light), dot(normal, view), n_h, v_h, sine_squared(normal, half_));
}

/// A cosine to a power, 0 where it is negative; by the square of its sine where that has more
/// digits.
float cosine_power(float cosine, float sine2, float exponent) {
    if (cosine < 0.7) {
        return 0.0;
    }
    return exp2_stable(0.5 * exponent * LOG2_E * log1p_negative(min(sine2, 0.6)));
}

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
float schlick(float at_normal, float cosine) {
    float m = 1.0 - cosine;
    float m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Share of one wavelength that a thin film reflects: 0 where the waves from both its faces cancel,
/// 1 where they add up. `path` is the difference of both ways, in the wavelength's unit.
float interference(float path, float wavelength) {
    float x = PI * path / wavelength;
    vec2 half_ = vec2(sin(x), cos(x));
    return half_.x * half_.x;
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
        float visible = 1.0 - smoothstep(0.5, 1.0, w * frequency);
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

float reflectance_blinn_phong(Light light, vec3 normal, vec3 view, float roughness) {
    Reflection r = reflection_of(light.direction, normal, view);
    float width = roughness * roughness;
    float e = 2.0 / (width * width) - 2.0;
    float shine = cosine_power(r.n_h, r.sine2_, e);
    return 0.125 * (e + 8.0) * shine * max(r.n_l, 0.0);
}

/// Thin film
///
/// The colors of soap bubbles, beetles and oil on water: a film that is as thin as light's waves
/// are long reflects some and cancels others, changing with the angle.
vec4 thin_film(float thickness, float index, vec3 normal, vec3 view) {
    float cosine = clamp(dot(normal, view), 0.0, 1.0);
    float inside = sqrt((index - 1.0) * (index + 1.0) + cosine * cosine);
    float path = 2.0 * thickness * inside;
    return vec4(interference(path, 650.0), interference(path, 532.0), interference(path, 450.0),
        1.0);
}

float noise_perlin(vec3 position, float scale, int octaves, float roughness, int seed) {
    vec3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    float swirl = noise_perlin(surface.position_object, 1.3, 2, 0.5, 0);
    float thickness = mix(180.0, 420.0, swirl - 0.0);
    vec4 film = thin_film(thickness, 1.33, surface.normal, surface.view);
    // Fresnel
    float glow = schlick(0.45, clamp(dot(surface.normal, surface.view), 0.0, 1.0));
    // Blend
    vec4 film_2 = min(vec4(vec3(0.0784, 0.0863, 0.1216) + glow * film.xyz, 1.0), vec4(1.0));
    float highlight = reflectance_blinn_phong(u_look.key, surface.normal, surface.view, 0.22);
    vec4 highlight_on_top = blend_add(film_2, vec4(1.0), highlight, 0.2, true);
    return highlight_on_top;
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
