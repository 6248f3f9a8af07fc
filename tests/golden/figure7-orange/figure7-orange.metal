// Orange peel: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure7-orange.json says what to put there and how to draw.
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
    Light fill;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position;
    metal::packed_float3 position_object;
    float kappa;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Angle {
    float half_sin;
    float half_cos;
};
struct LitLayer {
    Color color;
    float tone;
    char _pad2[12];
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
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint NOISE_PERLIN = 1u;
constant ProfileShape flesh_tone_shape = ProfileShape {0.99875027, 0.04997917, 1.1220733, 1.2466265, 0.1, 1.2259196, 0.51338285, 0u};
constant ProfileShape shade_tone_shape = ProfileShape {0.9950042, 0.099833414, 1.6523834, 1.9165641, 0.2, 0.67495763, 0.28714308, 0u};
constant ProfileShape waxy_sheen_tone_shape = ProfileShape {0.9996875, 0.024997396, 2.2990327, 2.8187852, 0.05, 0.41226318, 0.18345885, 0u};
constant ProfileShape glint_tone_shape = ProfileShape {0.9992001, 0.039989334, 14.297388, 3.2165964, 0.08, 0.062200632, 0.027819062, 0u};

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

metal::float3 normalize_seen_balanced(
    metal::float3 v_1
) {
    return v_1 * metal::rsqrt(metal::max(metal::dot(v_1, v_1), 0.000000000000000000000000000001));
}

metal::float2 sin_cos_quick(
    float x_1
) {
    float y = x_1 * x_1;
    float s_2 = x_1 * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 0.0000026347564))))))));
    float c = 1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (0.00002477458 - (y * 0.00000026297516)))))))));
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

float length_of(
    metal::float3 v_2
) {
    float largest_2 = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest_2 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e16 = bounded(largest_2 * metal::length(v_2 / metal::float3(largest_2)));
    return _e16;
}

float footprint_of_vec3_(
    metal::float3 v_3
) {
    metal::float3 dx_1 = metal::dfdx(v_3);
    metal::float3 dy_1 = metal::dfdy(v_3);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx_1, dx_1), metal::dot(dy_1, dy_1))));
    return _e7;
}

Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + (convexity * (convex - concave));
}

metal::float3 bumped_normal(
    metal::float4 along_x,
    metal::float4 along_y,
    metal::float3 normal
) {
    float _e4 = length_of(along_x.xyz);
    float _e6 = length_of(along_y.xyz);
    float largest_3 = metal::max(_e4, _e6);
    if ((largest_3 < 0.000000000000000001) | (largest_3 > 1000000000000000000.0)) {
        return normal;
    }
    metal::float3 s_5 = along_x.xyz / metal::float3(largest_3);
    metal::float3 t_4 = along_y.xyz / metal::float3(largest_3);
    metal::float2 rise = metal::clamp(metal::float2(along_x.w, along_y.w) / metal::float2(largest_3), metal::float2(-1000000.0), metal::float2(1000000.0));
    metal::float3 right = metal::cross(t_4, normal);
    metal::float3 up = metal::cross(normal, s_5);
    float area = metal::dot(s_5, right);
    if (metal::abs(area) < 0.000001) {
        return normal;
    }
    metal::float3 slope = ((rise.x * right) + (rise.y * up)) / metal::float3(area);
    float steepness = metal::length(slope);
    metal::float3 limited = slope * (metal::min(steepness, 10.0) / metal::max(steepness, 0.00000000000000000001));
    metal::float3 _e50 = normalize_or(normal - limited, normal);
    return _e50;
}

metal::float3 bump_map(
    float height,
    float scale,
    metal::float3 normal_1,
    metal::float3 position
) {
    float raised = height * scale;
    metal::float3 _e5 = metal::dfdx(position);
    float _e6 = metal::dfdx(raised);
    metal::float4 along_x_1 = metal::float4(_e5, _e6);
    metal::float3 _e8 = metal::dfdy(position);
    float _e9 = metal::dfdy(raised);
    metal::float4 along_y_1 = metal::float4(_e8, _e9);
    metal::float3 _e11 = bumped_normal(along_x_1, along_y_1, normal_1);
    return _e11;
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (tone * (color.xyz - below.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
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

Composite blend_shade(
    Composite below_2,
    Color color_2,
    float tone_2,
    float opacity_2,
    bool clamped_2
) {
    return metal::clamp(metal::float4(below_2.xyz + (0.75 * ((below_2.xyz * metal::mix(metal::float3(1.0), color_2.xyz, tone_2)) - below_2.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_3,
    float tone_3
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_3.xyz * light.color) * split.y, 1.0), tone_3 * split.x};
}

Angle parametrization_specular_balanced(
    Light light_1,
    metal::float3 normal_2,
    metal::float3 view
) {
    metal::float3 d_1 = ((2.0 * metal::dot(normal_2, view)) * normal_2) - view;
    return Angle {0.5 * metal::length(d_1 - light_1.direction), 0.5 * metal::length(d_1 + light_1.direction)};
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
    metal::float2 _e5 = sin_cos_quick(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    Angle _e6 = angle_turned_2_(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_5);
    return _e8;
}

float profile_balanced_3_(
    Angle angle_2,
    float shift_2,
    ProfileShape shape_6
) {
    Angle _e6 = angle_turned_2_(angle_2, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_6);
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
    float a = (axis == 0u) ? d.y : d.x;
    float b = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b));
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
    metal::float3 position_1,
    float scale_1,
    int octaves_1,
    float roughness_1,
    int seed_4
) {
    metal::float3 p_2 = position_1 * scale_1;
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float shade_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.1, -20.0, 20.0))))));
    Color _e30 = curvature_color(shade_convexity, metal::float4(0.9686, 0.6039, 0.1176, 1.0), metal::float4(0.8471, 0.4118, 0.0392, 1.0));
    float _e36 = noise_perlin(surface.position_object, 14.0, 2, 0.5, 0);
    metal::float3 _e40 = bump_map(_e36, 0.035, surface.normal, surface.position);
    metal::float3 _e44 = look.key.direction;
    metal::float3 _e52 = look.key.direction;
    Angle flesh_angle = Angle {0.5 * metal::length(_e40 - _e44), 0.5 * metal::length(_e40 + _e52)};
    float flesh_warp = ((2.0 * shade_convexity) - 1.0) * 0.2;
    float _e65 = profile_balanced(flesh_angle, flesh_warp, flesh_tone_shape);
    Light _e68 = look.key;
    LitLayer _e69 = light_apply(_e68, _e30, _e65);
    Composite _e79 = blend_alpha(metal::float4(0.4314, 0.1647, 0.0235, 1.0), _e69.color, _e69.tone, 1.0, true);
    Color _e90 = curvature_color(shade_convexity, metal::float4(0.7216, 0.2824, 0.0471, 1.0), metal::float4(0.5412, 0.1843, 0.0392, 1.0));
    metal::float3 _e94 = look.fill.direction;
    metal::float3 _e102 = look.fill.direction;
    Angle shade_angle = Angle {0.5 * metal::length(_e40 - _e94), 0.5 * metal::length(_e40 + _e102)};
    float shade_warp = ((2.0 * shade_convexity) - 1.0) * 0.1;
    float _e115 = profile_balanced(shade_angle, shade_warp, shade_tone_shape);
    Light _e118 = look.fill;
    LitLayer _e119 = light_apply(_e118, _e90, _e115);
    Composite _e124 = blend_shade(_e79, _e119.color, _e119.tone, 0.75, true);
    Light _e127 = look.key;
    Angle _e129 = parametrization_specular_balanced(_e127, _e40, surface.view);
    float _e132 = profile_balanced_2_(_e129, 0.0, waxy_sheen_tone_shape);
    Light _e135 = look.key;
    LitLayer _e141 = light_apply(_e135, metal::float4(0.4157, 0.2902, 0.1333, 1.0), _e132);
    metal::float4 waxy_sheen_blend = metal::clamp(metal::float4(_e124.xyz + (0.55 * ((_e124.xyz + (_e141.tone * _e141.color.xyz)) - _e124.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float _e163 = profile_balanced_3_(_e129, 0.0, glint_tone_shape);
    Light _e166 = look.key;
    LitLayer _e169 = light_apply(_e166, metal::float4(1.0), _e163);
    Composite _e174 = blend_alpha_2_(waxy_sheen_blend, _e169.color, _e169.tone, 0.85, true);
    return _e174;
}

struct vs_mainInput {
    metal::float3 position_2 [[attribute(0)]];
    metal::float3 normal_3 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position_2, varyings.normal_3 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_2 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_3 [[user(loc2), center_perspective]];
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
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position_2, varyings_1.position_object, varyings_1.normal_3 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_3 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e25 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_3, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position, in.position_object, _e25.x};
    metal::float4 _e28 = shade(surface_1, look);
    return fs_mainOutput { _e28 };
}
