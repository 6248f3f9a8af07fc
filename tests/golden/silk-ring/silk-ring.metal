// Silk: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// silk-ring.json says what to put there and how to draw.
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
    Light low;
    Light key;
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
constant ProfileShape lit_side_shape = ProfileShape {0.9950042, 0.099833414, 1.1883951, 1.7298278, 0.2, 1.0107075, 0.4419037, 0u};
constant ProfileShape band_shape = ProfileShape {0.9998875, 0.014999437, 9.541332, 4.980432, 0.03, 0.07759806, 0.03648918, 0u};
constant ProfileShape second_band_shape = ProfileShape {1.0, 0.0, 6.6917324, 12.899528, 0.0, 0.07171497, 0.035865854, 0u};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!(((largest > 0.000000000000000000000000000001) & (largest < 1000000000000000000000000000000.0)))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

metal::float3 normalize_moderate(
    metal::float3 v_1,
    metal::float3 otherwise_1
) {
    float square_1 = metal::dot(v_1, v_1);
    return (square_1 > 0.000000000000000000000000000001) ? (v_1 * metal::rsqrt(metal::max(square_1, 0.000000000000000000000000000001))) : otherwise_1;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_2
) {
    return v_2 * metal::rsqrt(metal::max(metal::dot(v_2, v_2), 0.000000000000000000000000000001));
}

metal::float2 sin_cos_quick(
    float x_1
) {
    float y_1 = x_1 * x_1;
    float s_2 = x_1 * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 0.0000026347564))))))));
    float c = 1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (0.00002477458 - (y_1 * 0.00000026297516)))))))));
    return metal::float2(s_2, c);
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_4 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_4, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_3 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, c_1);
    metal::float2 turned = ((s_3 <= 0.0) & (s_3 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_4 = u_2.half_sin - 0.0;
    metal::float2 upper_1 = (u_2.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_4, u_2.half_cos);
    metal::float2 turned_1 = ((s_4 <= 0.0) & (s_4 < u_2.half_cos)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

float bounded(
    float x_2
) {
    uint bits = as_type<uint>(x_2);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

float eased(
    float x_3,
    float low,
    float high
) {
    float _e3 = bounded(x_3);
    float _e7 = bounded((_e3 - low) / 0.5);
    float t_3 = metal::clamp(_e7, 0.0, 1.0);
    return (t_3 * t_3) * (3.0 - (2.0 * t_3));
}

float footprint_of_vec3_(
    metal::float3 v_3
) {
    metal::float3 dx_1 = metal::dfdx(v_3);
    metal::float3 dy_1 = metal::dfdy(v_3);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx_1, dx_1), metal::dot(dy_1, dy_1))));
    return _e7;
}

metal::float3 any_orthogonal(
    metal::float3 n
) {
    float sign = (n.z >= 0.0) ? 1.0 : -1.0;
    float a = -1.0 / (sign + n.z);
    return metal::float3(1.0 + (((sign * n.x) * n.x) * a), ((sign * n.x) * n.y) * a, -(sign) * n.x);
}

DirectionParts direction_within(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis
) {
    metal::float3 y_2 = y_axis * metal::rsqrt(metal::max(metal::dot(y_axis, y_axis), 0.000000000000000000000000000001));
    return DirectionParts {direction, x_axis, y_2, metal::float2(metal::dot(direction, x_axis), metal::dot(direction, y_2))};
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
    float square_2 = metal::dot(leaning, leaning);
    metal::float3 aside = (metal::abs(toward.x) > 0.7) ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = (square_2 > 0.00000001) ? leaning : metal::cross(aside, toward);
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

metal::float3 half_vector(
    Light light,
    metal::float3 view
) {
    metal::float3 half_1 = light.direction + view;
    metal::float3 _e4 = any_orthogonal(view);
    metal::float3 _e9 = normalize_or((metal::dot(half_1, half_1) > 0.000000000001) ? half_1 : _e4, view);
    return _e9;
}

metal::float3 stretch_direction(
    metal::float3 direction_2,
    metal::float3 x_axis_1,
    metal::float3 y_axis_1,
    float x_4,
    float y
) {
    DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    metal::float3 _e10 = direction_moved(_e5, -(metal::float2(x_4, y)) * _e5.place);
    return _e10;
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

Composite blend_alpha_2_(
    Composite below_1,
    Color color_1,
    float tone_1,
    float opacity_1,
    bool clamped_1
) {
    return metal::clamp(metal::float4(below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
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
    float width = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_1.edge_mean - from_offset) / width), 0.0, 1.0);
    return (w <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_filtered_quick(
    Angle u_3,
    float w_1,
    ProfileShape shape_2
) {
    metal::float2 place = metal::float2((u_3.half_sin * shape_2.half_cos_offset) - (u_3.half_cos * shape_2.half_sin_offset), (u_3.half_cos * shape_2.half_cos_offset) + (u_3.half_sin * shape_2.half_sin_offset));
    float _e19 = profile_soft_quick(place.x, shape_2);
    if (w_1 < (0.1 * shape_2.edge_deviation)) {
        return _e19;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e45 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_2);
    float _e53 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_2);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_filtered_quick_2_(
    Angle u_4,
    float w_2,
    ProfileShape shape_3
) {
    metal::float2 place_1 = metal::float2((u_4.half_sin * shape_3.half_cos_offset) - (u_4.half_cos * shape_3.half_sin_offset), (u_4.half_cos * shape_3.half_cos_offset) + (u_4.half_sin * shape_3.half_sin_offset));
    bool is_narrow = (w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place_1.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_3);
    if (w_2 < (0.1 * shape_3.edge_deviation)) {
        return _e30;
    }
    float r_1 = 0.19364917 * w_2;
    metal::float2 turn_1 = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
    float _e56 = profile_soft_quick((place_1.x * turn_1.y) - (place_1.y * turn_1.x), shape_3);
    float _e64 = profile_soft_quick((place_1.x * turn_1.y) + (place_1.y * turn_1.x), shape_3);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    Angle _e6 = angle_turned_2_(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift_1);
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_4 = {};
    v_4 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_4.x;
    uint _e10 = v_4.y;
    uint _e12 = v_4.z;
    v_4.x = _e8 + (_e10 * _e12);
    uint _e16 = v_4.y;
    uint _e18 = v_4.z;
    uint _e20 = v_4.x;
    v_4.y = _e16 + (_e18 * _e20);
    uint _e24 = v_4.z;
    uint _e26 = v_4.x;
    uint _e28 = v_4.y;
    v_4.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_4;
    metal::uint3 _e32 = v_4;
    v_4 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_4.x;
    uint _e40 = v_4.y;
    uint _e42 = v_4.z;
    v_4.x = _e38 + (_e40 * _e42);
    uint _e46 = v_4.y;
    uint _e48 = v_4.z;
    uint _e50 = v_4.x;
    v_4.y = _e46 + (_e48 * _e50);
    uint _e54 = v_4.z;
    uint _e56 = v_4.x;
    uint _e58 = v_4.y;
    v_4.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_4;
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
    float b = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a_1 : -(a_1)) + (((hash.z >> 31u) == 0u) ? b : -(b));
}

metal::float3 fade_quintic(
    metal::float3 t_2
) {
    return ((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
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
            metal::float3 place_2 = metal::clamp((p_1 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place_2, 0u + static_cast<uint>(_e47));
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

float noise_perlin(
    metal::float3 position,
    float scale,
    int octaves_1,
    float roughness_1,
    int seed_4
) {
    metal::float3 p_2 = position * scale;
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle turned_from_the_key = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    float _e22 = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    Composite _e35 = blend_alpha(metal::float4(0.2275, 0.102, 0.2431, 1.0), metal::float4(0.4824, 0.1843, 0.3882, 1.0), _e22, 1.0, true);
    metal::float3 normal = surface.normal;
    Light _e39 = look.key;
    metal::float3 _e41 = half_vector(_e39, surface.view);
    AxesAround _e46 = axes(_e41, metal::float3(0.0, 1.0, 0.0));
    metal::float3 _e51 = stretch_direction(normal, _e46.x_axis, _e46.y_axis, 0.985, 0.0);
    Angle from_the_band = Angle {0.5 * metal::length(_e51 - _e41), 0.5 * metal::length(_e51 + _e41)};
    float _e66 = noise_perlin(surface.position_object, 14.0, 2, 0.5, 0);
    float waver = metal::mix(-0.05, 0.05, _e66 - 0.0);
    float _e73 = profile_balanced_2_(from_the_band, waver, band_shape);
    Composite _e81 = blend_alpha_2_(_e35, metal::float4(0.9529, 0.6627, 0.7059, 1.0), _e73, 0.95, true);
    Light _e84 = look.low;
    metal::float3 _e86 = half_vector(_e84, surface.view);
    AxesAround _e91 = axes(_e86, metal::float3(0.0, 1.0, 0.0));
    metal::float3 _e96 = stretch_direction(normal, _e91.x_axis, _e91.y_axis, 0.985, 0.0);
    Angle from_the_second = Angle {0.5 * metal::length(_e96 - _e86), 0.5 * metal::length(_e96 + _e86)};
    float _e107 = profile_balanced_2_(from_the_second, waver, second_band_shape);
    metal::float4 second_band_on_top = metal::clamp(metal::float4(_e81.xyz + (0.8 * ((_e81.xyz + (_e107 * metal::float3(0.3529, 0.2471, 0.549))) - _e81.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return second_band_on_top;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position_1, varyings.normal };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object, varyings_1.normal };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object};
    metal::float4 _e20 = shade(surface_1, look);
    return fs_mainOutput { _e20 };
}
