// Iridescent film: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_4 buffer(0), object buffer(1), look buffer(2).
// material-film.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    metal::float4 eye;
};
struct Object {
    metal::float4x4 world_from_object;
    metal::float3x3 world_from_normal;
    float id;
    float cutoff;
    char _pad4[8];
};
struct Light {
    metal::float3 direction;
    metal::float3 own_direction;
    metal::packed_float3 color;
    float intensity;
};
struct Look {
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
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
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant uint NOISE_PERLIN = 1u;

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float clamped_1 = metal::max(x, -126.0);
    float whole = metal::rint(clamped_1);
    float f = clamped_1 - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    int exponent_1 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

float log1p_negative(
    float y_1
) {
    if (y_1 < 0.25) {
        float _e3 = log1p_negative_small(y_1);
        return _e3;
    }
    float _e7 = log2_stable(1.0 - y_1);
    return LN_2_ * _e7;
}

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_1
) {
    return v_1 * metal::rsqrt(metal::max(metal::dot(v_1, v_1), 0.000000000000000000000000000001));
}

float footprint_of_vec3_(
    metal::float3 v_2
) {
    metal::float3 dx = metal::dfdx(v_2);
    metal::float3 dy = metal::dfdy(v_2);
    return metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy)));
}

Composite blend_add(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (opacity * ((below.xyz + (tone * metal::float3(1.0))) - below.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

metal::float3 half_of(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = light + view;
    metal::float3 _e8 = normalize_moderate((metal::dot(half_, half_) > 0.000000000001) ? half_ : normal, normal);
    return _e8;
}

float sine_squared(
    metal::float3 a,
    metal::float3 b
) {
    metal::float3 across = metal::cross(a, b);
    return metal::min(metal::dot(across, across), 1.0);
}

Reflection reflection_of(
    metal::float3 light_1,
    metal::float3 normal_1,
    metal::float3 view_1
) {
    metal::float3 _e3 = half_of(light_1, normal_1, view_1);
    float n_h = metal::clamp(metal::dot(normal_1, _e3), 0.0, 1.0);
    float v_h = metal::clamp(metal::dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection {metal::dot(normal_1, light_1), metal::dot(normal_1, view_1), n_h, v_h, _e14};
}

float cosine_power(
    float cosine,
    float sine2_,
    float exponent
) {
    if (cosine < 0.7) {
        return 0.0;
    }
    float _e12 = log1p_negative(metal::min(sine2_, 0.6));
    float _e14 = exp2_stable(((0.5 * exponent) * LOG2_E) * _e12);
    return _e14;
}

float schlick(
    float at_normal,
    float cosine_1
) {
    float m = 1.0 - cosine_1;
    float m2_ = m * m;
    return at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m));
}

float interference(
    float path,
    float wavelength
) {
    float x_2 = (PI * path) / wavelength;
    metal::float2 half_1 = metal::float2(metal::sin(x_2), metal::cos(x_2));
    return half_1.x * half_1.x;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_3 = {};
    v_3 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_3.x;
    uint _e10 = v_3.y;
    uint _e12 = v_3.z;
    v_3.x = _e8 + (_e10 * _e12);
    uint _e16 = v_3.y;
    uint _e18 = v_3.z;
    uint _e20 = v_3.x;
    v_3.y = _e16 + (_e18 * _e20);
    uint _e24 = v_3.z;
    uint _e26 = v_3.x;
    uint _e28 = v_3.y;
    v_3.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_3;
    metal::uint3 _e32 = v_3;
    v_3 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_3.x;
    uint _e40 = v_3.y;
    uint _e42 = v_3.z;
    v_3.x = _e38 + (_e40 * _e42);
    uint _e46 = v_3.y;
    uint _e48 = v_3.z;
    uint _e50 = v_3.x;
    v_3.y = _e46 + (_e48 * _e50);
    uint _e54 = v_3.z;
    uint _e56 = v_3.x;
    uint _e58 = v_3.y;
    v_3.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_3;
    return _e61;
}

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a_1 = (axis == 0u) ? d.y : d.x;
    float b_1 = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a_1 : -(a_1)) + (((hash.z >> 31u) == 0u) ? b_1 : -(b_1));
}

metal::float3 fade_quintic(
    metal::float3 t
) {
    return ((t * t) * t) * ((t * ((t * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(
    metal::float3 p,
    uint seed_2
) {
    float sum = 0.0;
    int i = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_1 = p - corner;
    metal::float3 _e4 = fade_quintic(d_1);
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e46 = i;
            i = as_type<int>(as_type<uint>(_e46) + as_type<uint>(1));
        }
        loop_init = false;
        int _e10 = i;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            metal::int3 at = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at)), seed_2);
            float _e42 = gradient_dot(_e39, d_1 - static_cast<metal::float3>(at));
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e42);
        }
    }
    float _e48 = sum;
    return metal::clamp(0.5 + (0.48244 * _e48), 0.0, 1.0);
}

float fractal_noise(
    uint kind,
    metal::float3 p_1,
    int octaves,
    float roughness,
    int seed_3,
    float w
) {
    float octave = {};
    int i_1 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e66 = i_1;
            i_1 = as_type<int>(as_type<uint>(_e66) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e17 = i_1;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float visible = 1.0 - metal::smoothstep(0.5, 1.0, w * _e21);
        octave = 0.5;
        if (visible > 0.0) {
            float _e31 = frequency;
            int _e33 = i_1;
            metal::float3 place = metal::clamp((p_1 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place, 0u + static_cast<uint>(_e47));
            octave = metal::mix(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = _e53 + (_e54 * _e55);
        float _e58 = total;
        float _e59 = strength;
        total = _e58 + _e59;
        float _e61 = strength;
        strength = _e61 * roughness;
        float _e63 = frequency;
        frequency = _e63 * 2.0;
    }
    float _e69 = sum_1;
    return metal::min(_e69 / 1.5, 1.0);
}

float reflectance_blinn_phong(
    Light light_2,
    metal::float3 normal_2,
    metal::float3 view_2,
    float roughness_1
) {
    Reflection _e5 = reflection_of(light_2.direction, normal_2, view_2);
    float width = roughness_1 * roughness_1;
    float e = (2.0 / (width * width)) - 2.0;
    float _e14 = cosine_power(_e5.n_h, _e5.sine2_, e);
    return ((0.125 * (e + 8.0)) * _e14) * metal::max(_e5.n_l, 0.0);
}

Color thin_film(
    float thickness,
    float index,
    metal::float3 normal_3,
    metal::float3 view_3
) {
    float cosine_2 = metal::clamp(metal::dot(normal_3, view_3), 0.0, 1.0);
    float inside = metal::sqrt(((index - 1.0) * (index + 1.0)) + (cosine_2 * cosine_2));
    float path_1 = (2.0 * thickness) * inside;
    float _e20 = interference(path_1, 650.0);
    float _e22 = interference(path_1, 532.0);
    float _e24 = interference(path_1, 450.0);
    return metal::float4(_e20, _e22, _e24, 1.0);
}

float noise_perlin(
    metal::float3 position,
    float scale,
    int octaves_1,
    float roughness_2,
    int seed_4
) {
    metal::float3 p_2 = position * scale;
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_2, seed_4, _e7);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float _e6 = noise_perlin(surface.position_object, 1.3, 2, 0.5, 0);
    float thickness_1 = metal::mix(180.0, 420.0, _e6 - 0.0);
    Color _e15 = thin_film(thickness_1, 1.33, surface.normal, surface.view);
    float _e23 = schlick(0.45, metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0));
    metal::float4 film_2_ = metal::min(metal::float4(metal::float3(0.0784, 0.0863, 0.1216) + (_e23 * _e15.xyz), 1.0), metal::float4(1.0));
    Light _e38 = look.key;
    float _e42 = reflectance_blinn_phong(_e38, surface.normal, surface.view, 0.22);
    Composite _e47 = blend_add(film_2_, metal::float4(1.0), _e42, 0.2, true);
    return _e47;
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
, constant View& view_4 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_4 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_4.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
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
, constant View& view_4 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object, varyings_1.normal_4 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_4 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_4.eye;
    float _e13 = view_4.eye.w;
    Surface surface_1 = Surface {normal_4, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object};
    metal::float4 _e20 = shade(surface_1, look);
    return fs_mainOutput { _e20 };
}
