// Iridescent film: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// material-film.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    metal::float4 eye;
};

struct Object {
    metal::float4x4 world_from_object;
    /// The inverse transpose, for normals.
    metal::float3x3 world_from_normal;
    float id;
    char _pad3[12];
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    metal::float3 direction;
    /// Unit, toward the light, in the light's own frame.
    metal::float3 own_direction;
    /// Straight RGB.
    metal::packed_float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
};

typedef metal::float4 Color;
typedef metal::float4 Composite;
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

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};

constant float PI = 3.1415927;
constant float LN_2 = 0.6931472;
constant float LOG2_E = 1.442695;
constant uint NOISE_PERLIN = 1u;

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(
    float x
) {
    float clamped = metal::max(x, -126.0);
    float whole = metal::rint(clamped);
    float f = clamped - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole))
        + as_type<uint>(126))) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(
    float x
) {
    uint bits = as_type<uint>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return static_cast<float>(exponent) + z
        * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(
    float y
) {
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(
    float y
) {
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return LN_2 * log2_stable(1.0 - y);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return square > 0.000000000000000000000000000001 ? v
        * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001)) : otherwise;
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(
    metal::float3 v
) {
    metal::float3 dx = metal::dfdx(v);
    metal::float3 dy = metal::dfdy(v);
    return metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy)));
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
Composite blend_add(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + opacity
        * (below.xyz + tone * metal::float3(1.0) - below.xyz), 1.0), metal::float4(0.0),
        metal::float4(1.0));
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
metal::float3 half_of(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = light + view;
    return normalize_moderate(metal::dot(half_, half_) > 0.000000000001 ? half_ : normal, normal);
}

/// The square of the sine between two unit vectors.
float sine_squared(
    metal::float3 a,
    metal::float3 b
) {
    metal::float3 across = metal::cross(a, b);
    return metal::min(metal::dot(across, across), 1.0);
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
Reflection reflection_of(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = half_of(light, normal, view);
    float n_h = metal::clamp(metal::dot(normal, half_), 0.0, 1.0);
    float v_h = metal::clamp(metal::dot(view, half_), 0.0, 1.0);
    return Reflection {metal::dot(normal, light), metal::dot(normal, view), n_h, v_h,
        sine_squared(normal, half_)};
}

/// A cosine to a power, 0 where it is negative; by the square of its sine where that has more
/// digits.
float cosine_power(
    float cosine,
    float sine2,
    float exponent
) {
    if (cosine < 0.7) {
        return 0.0;
    }
    return exp2_stable(0.5 * exponent * LOG2_E * log1p_negative(metal::min(sine2, 0.6)));
}

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
float schlick(
    float at_normal,
    float cosine
) {
    float m = 1.0 - cosine;
    float m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Share of one wavelength that a thin film reflects: 0 where the waves from both its faces cancel,
/// 1 where they add up. `path` is the difference of both ways, in the wavelength's unit.
float interference(
    float path,
    float wavelength
) {
    float x = PI * path / wavelength;
    metal::float2 half_ = metal::float2(metal::sin(x), metal::cos(x));
    return half_.x * half_.x;
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v = {};
    v = seed * 1664525u + metal::uint3(1013904223u);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> metal::uint3(16u));
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

/// The hash of a lattice point.
metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed
) {
    return hash_pcg3d(as_type<metal::uint3>(cell) + seed
        * metal::uint3(2654435769u, 2246822507u, 3266489909u));
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
metal::float3 fade_quintic(
    metal::float3 t
) {
    return t * t * t * (t * (t * 6.0 - metal::float3(15.0)) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(
    metal::float3 p,
    uint seed
) {
    float sum = 0.0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d = p - corner;
    metal::float3 f = fade_quintic(d);
    metal::int3 cell = naga_f2i32(corner);
    for (int i = 0; i < 8; i++) {
        metal::int3 at = metal::int3(i & 1, (i >> 1u) & 1, i >> 2u);
        metal::float3 weight = metal::select(metal::float3(1.0) - f, f, at == metal::int3(1));
        metal::uint3 lattice_hash_value = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at)),
            seed);
        sum = sum + weight.x * weight.y * weight.z
            * gradient_dot(lattice_hash_value, d - static_cast<metal::float3>(at));
    }
    // The twelve gradients reach 1.0364 at most.
    return metal::clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
float fractal_noise(
    uint kind,
    metal::float3 p,
    int octaves,
    float roughness,
    int seed,
    float w
) {
    float octave = {};
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum = 0.0;
    for (int i = 0; i < 2; i++) {
        float visible = 1.0 - metal::smoothstep(0.5, 1.0, w * frequency);
        octave = 0.5;
        if (visible > 0.0) {
            metal::float3 place = metal::clamp(p * frequency + static_cast<float>(i)
                * metal::float3(17.31, 5.17, 11.73), metal::float3(-4194304.0),
                metal::float3(4194304.0));
            octave = metal::mix(0.5, perlin_noise(place, 0u + static_cast<uint>(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return metal::min(sum / 1.5, 1.0);
}

float reflectance_blinn_phong(
    Light light,
    metal::float3 normal,
    metal::float3 view,
    float roughness
) {
    Reflection r = reflection_of(light.direction, normal, view);
    float width = roughness * roughness;
    float e = 2.0 / (width * width) - 2.0;
    float shine = cosine_power(r.n_h, r.sine2_, e);
    return 0.125 * (e + 8.0) * shine * metal::max(r.n_l, 0.0);
}

/// Thin film
///
/// The colors of soap bubbles, beetles and oil on water: a film that is as thin as light's waves
/// are long reflects some and cancels others, changing with the angle.
Color thin_film(
    float thickness,
    float index,
    metal::float3 normal,
    metal::float3 view
) {
    float cosine = metal::clamp(metal::dot(normal, view), 0.0, 1.0);
    float inside = metal::sqrt((index - 1.0) * (index + 1.0) + cosine * cosine);
    float path = 2.0 * thickness * inside;
    return metal::float4(interference(path, 650.0), interference(path, 532.0),
        interference(path, 450.0), 1.0);
}

float noise_perlin(
    metal::float3 position,
    float scale,
    int octaves,
    float roughness,
    int seed
) {
    metal::float3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float swirl = noise_perlin(surface.position_object, 1.3, 2, 0.5, 0);
    float thickness = metal::mix(180.0, 420.0, swirl - 0.0);
    Color film = thin_film(thickness, 1.33, surface.normal, surface.view);
    // Fresnel
    float glow = schlick(0.45, metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0));
    // Blend
    metal::float4 film_2 = metal::min(metal::float4(metal::float3(0.0784, 0.0863, 0.1216) + glow
        * film.xyz, 1.0), metal::float4(1.0));
    float highlight = reflectance_blinn_phong(look.key, surface.normal, surface.view, 0.22);
    Composite highlight_on_top = blend_add(film_2, metal::float4(1.0), highlight, 0.2, true);
    return highlight_on_top;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_4 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, vertex_.position,
        object.world_from_normal * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_4 [[user(loc2), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object,
        varyings_1.normal_4 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object};
    return fs_mainOutput { shade(surface, look) };
}
