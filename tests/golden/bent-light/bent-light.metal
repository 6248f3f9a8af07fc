// Light that wavers: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// bent-light.json says what to put there and how to draw.
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
    metal::float2 viewport;
    char _pad1[8];
    Light eye;
    Light key;
    metal::float3 parts_direction;
    metal::float3 axes_of_the_light_x_axis;
    metal::float3 axes_of_the_light_y_axis;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Angle {
    float half_sin;
    float half_cos;
};
struct DirectionParts {
    metal::float3 direction;
    metal::float3 x_axis;
    metal::float3 y_axis;
    metal::float2 place;
    char _pad4[8];
};
struct AxesAround {
    metal::float3 x_axis;
    metal::float3 y_axis;
};
struct ProfileShape {
    float half_cos_offset;
    float half_sin_offset;
    float scale;
    float exponent;
    float offset;
    float edge_mean;
    float edge_deviation;
    uint kind;
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
constant uint NOISE_PERLIN = 1u;
constant ProfileShape lit_shape = ProfileShape {0.8253356, 0.5646425, 25.006668, 1.7790966, 1.2, 0.04446849, 0.018017149, 0u};
constant ProfileShape brightest_shape = ProfileShape {0.9358968, 0.35227424, 40.004166, 3.6241908, 0.72, 0.021168118, 0.009611014, 0u};
constant ProfileShape window_shape = ProfileShape {0.9963897, 0.08489768, 0.0, 1.0, 0.17, 0.0, 0.0, 1u};

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

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_5 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_5, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_3 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, u_1.half_cos);
    metal::float2 turned = ((s_3 <= 0.0) & (s_3 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float bounded(
    float x
) {
    uint bits = as_type<uint>(x);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0);
}

float eased(
    float x_1,
    float low,
    float high
) {
    float _e3 = bounded(x_1);
    float _e7 = bounded((_e3 - low) / 0.5);
    float t_2 = metal::clamp(_e7, 0.0, 1.0);
    return (t_2 * t_2) * (3.0 - (2.0 * t_2));
}

float footprint_of(
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_1, d_1));
}

float footprint_of_vec3_(
    metal::float3 v_2
) {
    metal::float3 dx_1 = metal::dfdx(v_2);
    metal::float3 dy_1 = metal::dfdy(v_2);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx_1, dx_1), metal::dot(dy_1, dy_1))));
    return _e7;
}

DirectionParts direction_within(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis
) {
    metal::float3 y = y_axis * metal::rsqrt(metal::max(metal::dot(y_axis, y_axis), 0.000000000000000000000000000001));
    return DirectionParts {direction, x_axis, y, metal::float2(metal::dot(direction, x_axis), metal::dot(direction, y))};
}

metal::float3 direction_moved(
    DirectionParts parts,
    metal::float2 by
) {
    metal::float3 moved = (parts.direction + (by.x * parts.x_axis)) + (by.y * parts.y_axis);
    metal::float3 _e13 = normalize_moderate(moved, parts.direction);
    return (metal::dot(moved, moved) > 0.000001) ? _e13 : parts.direction;
}

metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 leaning = metal::cross(up, toward);
    float square_1 = metal::dot(leaning, leaning);
    metal::float3 aside = (metal::abs(toward.x) > 0.7) ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = (square_1 > 0.00000001) ? leaning : metal::cross(aside, toward);
    metal::float3 _e28 = normalize_moderate(across - (metal::dot(across, toward) * toward), metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(_e28, metal::cross(toward, _e28), toward);
}

AxesAround axes(
    metal::float3 direction_1,
    metal::float3 up_1
) {
    metal::float3x3 _e2 = axes_around(direction_1, up_1);
    return AxesAround {_e2[0], _e2[1]};
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::float4(below.xyz + (tone * (color.xyz - below.xyz)), 1.0);
}

float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return (s <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q * q), 0.0), shape.exponent);
}

float profile_ramp_quick(
    float s_1,
    float w,
    ProfileShape shape_1
) {
    float width_1 = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_1.edge_mean - from_offset) / width_1), 0.0, 1.0);
    return (w <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_ramp_quick_2_(
    float s_2,
    float w_1,
    ProfileShape shape_2
) {
    float width_2 = metal::sqrt(w_1 * w_1);
    float from_offset_1 = s_2 * (2.0 + ((s_2 * s_2) * 0.33333334));
    float ramp_1 = metal::clamp(0.5 + ((0.0 - from_offset_1) / metal::max(width_2, 0.000001)), 0.0, 1.0);
    return (w_1 <= 0.0) ? ((s_2 <= 0.0000004) ? 1.0 : 0.0) : ramp_1;
}

float profile_filtered_quick(
    Angle u_2,
    float w_2,
    ProfileShape shape_3
) {
    metal::float2 place = metal::float2((u_2.half_sin * shape_3.half_cos_offset) - (u_2.half_cos * shape_3.half_sin_offset), (u_2.half_cos * shape_3.half_cos_offset) + (u_2.half_sin * shape_3.half_sin_offset));
    bool is_narrow = (w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_3);
    if (w_2 < (0.1 * shape_3.edge_deviation)) {
        return _e30;
    }
    float r = 0.19364917 * w_2;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e56 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_3);
    float _e64 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_3);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    Angle _e6 = angle_turned(angle_1, metal::float2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset), _e14, shape_5);
    return _e15;
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
    float a = (axis == 0u) ? d.y : d.x;
    float b = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b));
}

metal::float3 fade_quintic(
    metal::float3 t_1
) {
    return ((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
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
    metal::float3 d_2 = p - corner;
    metal::float3 _e4 = fade_quintic(d_2);
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
            float _e42 = gradient_dot(_e39, d_2 - static_cast<metal::float3>(at));
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
    float w_3
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
        float _e25 = eased(w_3 * _e21, 0.5, 1.0);
        float visible = 1.0 - _e25;
        octave = 0.5;
        if (visible > 0.0) {
            float _e31 = frequency;
            int _e33 = i_1;
            metal::float3 place_1 = metal::clamp((p_1 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place_1, 1u + static_cast<uint>(_e47));
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

float fractal_noise_2_(
    uint kind_1,
    metal::float3 p_2,
    int octaves_1,
    float roughness_1,
    int seed_4,
    float w_4
) {
    float octave_1 = {};
    int i_2 = 0;
    float frequency_1 = 1.0;
    float strength_1 = 1.0;
    float total_1 = 0.0;
    float sum_2 = 0.0;
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e66 = i_2;
            i_2 = as_type<int>(as_type<uint>(_e66) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e17 = i_2;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency_1;
        float _e25 = eased(w_4 * _e21, 0.5, 1.0);
        float visible_1 = 1.0 - _e25;
        octave_1 = 0.5;
        if (visible_1 > 0.0) {
            float _e31 = frequency_1;
            int _e33 = i_2;
            metal::float3 place_2 = metal::clamp((p_2 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_2;
            float _e50 = perlin_noise(place_2, 5u + static_cast<uint>(_e47));
            octave_1 = metal::mix(0.5, _e50, visible_1);
        }
        float _e53 = sum_2;
        float _e54 = strength_1;
        float _e55 = octave_1;
        sum_2 = _e53 + (_e54 * _e55);
        float _e58 = total_1;
        float _e59 = strength_1;
        total_1 = _e58 + _e59;
        float _e61 = strength_1;
        strength_1 = _e61 * roughness_1;
        float _e63 = frequency_1;
        frequency_1 = _e63 * 2.0;
    }
    float _e69 = sum_2;
    return metal::min(_e69 / 1.5, 1.0);
}

float outer_contour(
    float width,
    metal::float3 normal,
    metal::float3 view,
    metal::float2 viewport
) {
    float facing = metal::clamp(metal::dot(normal, view), 0.0, 1.0);
    float pixels = (width * metal::clamp(viewport.y, 1.0, 100000.0)) / 1000.0;
    float _e15 = footprint_of(facing);
    float distance = facing / metal::max(2.0 * _e15, 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp((pixels + 0.5) - distance, 0.0, metal::min(pixels, 1.0)) * near;
}

float noise_perlin(
    metal::float3 position,
    float scale,
    int octaves_2,
    float roughness_2,
    int seed_5
) {
    metal::float3 p_3 = position * scale;
    float _e7 = footprint_of_vec3_(p_3);
    float _e8 = fractal_noise(NOISE_PERLIN, p_3, octaves_2, roughness_2, seed_5, _e7);
    return _e8;
}

float noise_perlin_2_(
    metal::float3 position_1,
    float scale_1,
    int octaves_3,
    float roughness_3,
    int seed_6
) {
    metal::float3 p_4 = position_1 * scale_1;
    float _e7 = footprint_of_vec3_(p_4);
    float _e8 = fractal_noise_2_(NOISE_PERLIN, p_4, octaves_3, roughness_3, seed_6, _e7);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 place_3 = surface.position_object;
    float _e6 = noise_perlin(place_3, 3.5, 2, 0.5, 1);
    float across_1 = metal::mix(-0.22, 0.22, _e6 - 0.0);
    float _e16 = noise_perlin_2_(place_3, 3.5, 2, 0.5, 5);
    float upright = metal::mix(-0.22, 0.22, _e16 - 0.0);
    metal::float3 _e24 = look.parts_direction;
    metal::float3 _e27 = look.axes_of_the_light_x_axis;
    metal::float3 _e30 = look.axes_of_the_light_y_axis;
    DirectionParts _e31 = direction_within(_e24, _e27, _e30);
    metal::float3 _e33 = direction_moved(_e31, metal::float2(across_1, upright));
    metal::float3 _e37 = look.key.own_direction;
    metal::float3 _e41 = look.key.color;
    float _e45 = look.key.intensity;
    Light bent_light = Light {_e33, _e37, _e41, _e45};
    Angle turned_from_it = Angle {0.5 * metal::length(surface.normal - bent_light.direction), 0.5 * metal::length(surface.normal + bent_light.direction)};
    float _e62 = profile_balanced(turned_from_it, 0.0, lit_shape);
    Composite _e75 = blend_alpha(metal::float4(0.1529, 0.251, 0.3765, 1.0), metal::float4(0.3098, 0.5608, 0.6118, 1.0), _e62, 1.0, true);
    float _e78 = profile_balanced(turned_from_it, 0.0, brightest_shape);
    metal::float4 brightest_light = metal::min(metal::float4(_e75.xyz + (_e78 * (metal::float3(0.6627, 0.8392, 0.7569) - _e75.xyz)), 1.0), metal::float4(1.0));
    metal::float3 view_2_ = surface.view;
    AxesAround _e98 = axes(view_2_, metal::float3(0.0, 1.0, 0.0));
    DirectionParts _e101 = direction_within(view_2_, _e98.x_axis, _e98.y_axis);
    metal::float3 _e105 = direction_moved(_e101, metal::float2(-0.32, 0.36));
    metal::float3 _e109 = look.eye.own_direction;
    metal::float3 _e113 = look.eye.color;
    float _e117 = look.eye.intensity;
    Light locked_to_the_eye = Light {_e105, _e109, _e113, _e117};
    Angle turned_from_the_eye = Angle {0.5 * metal::length(surface.normal - locked_to_the_eye.direction), 0.5 * metal::length(surface.normal + locked_to_the_eye.direction)};
    float _e134 = profile_balanced_2_(turned_from_the_eye, 0.0, window_shape);
    metal::float4 window_on_top = metal::clamp(metal::float4(brightest_light.xyz + (_e134 * (metal::float3(0.9922, 0.9647, 0.8902) - brightest_light.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float2 _e156 = look.viewport;
    float _e157 = outer_contour(3.0, surface.normal, surface.view, _e156);
    metal::float4 outline = metal::clamp(metal::float4(window_on_top.xyz + (_e157 * (metal::float3(0.0784, 0.1294, 0.2275) - window_on_top.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return outline;
}

struct vs_mainInput {
    metal::float3 position_2 [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_2, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_2 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_1 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_1 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_2, varyings_1.position_object, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object};
    metal::float4 _e20 = shade(surface_1, look);
    return fs_mainOutput { _e20 };
}
