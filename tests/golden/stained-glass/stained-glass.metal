// Stained glass: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// stained-glass.json says what to put there and how to draw.
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
    Light room;
    Light sun;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position;
    metal::float3 position_object;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Angle {
    float half_sin;
    float half_cos;
};
struct type_5 {
    metal::float4 inner[16];
};
struct type_6 {
    metal::float4 inner[4];
};
struct Ramp {
    type_5 colors;
    type_6 places;
    uint count;
    uint interpolation;
    char _pad4[8];
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
struct Cell {
    float border;
    float random;
    float distance;
};
struct Cells {
    float border;
    float random;
    float distance;
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
constant float CELL_REACH = 1.25;
constant Ramp colors_1 = Ramp {type_5 {{metal::float4(0.0706, 0.1882, 0.4784, 1.0), metal::float4(0.1216, 0.4784, 0.6902, 1.0), metal::float4(0.1137, 0.5412, 0.3529, 1.0), metal::float4(0.9098, 0.6902, 0.1255, 1.0), metal::float4(0.8471, 0.3255, 0.1098, 1.0), metal::float4(0.6902, 0.0706, 0.2196, 1.0), metal::float4(0.3529, 0.102, 0.4784, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_6 {{metal::float4(0.0, 0.22, 0.4, 0.58), metal::float4(0.75, 0.9, 1.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 7u, 2u};
constant ProfileShape through_the_glass_shape = ProfileShape {0.9950042, 0.099833414, 1.1883951, 1.4967098, 0.2, 1.0679889, 0.45520553, 0u};
constant ProfileShape on_the_glass_shape = ProfileShape {0.99875027, 0.04997917, 1.2766062, 1.3888036, 0.1, 1.0089166, 0.41697913, 0u};
constant ProfileShape gleam_tone_shape = ProfileShape {0.99820054, 0.059964005, 11.126125, 3.022525, 0.12, 0.08196669, 0.036355104, 0u};
constant ProfileShape edge_of_the_lead_tone_shape = ProfileShape {0.9887711, 0.14943813, 3.3838634, 2.4220939, 0.3, 0.29531473, 0.1274162, 0u};

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

metal::float3 normalize_seen(
    metal::float3 v_2
) {
    metal::float3 _e5 = normalize_moderate(v_2, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_6 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_6, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_2 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, u_1.half_cos);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float bounded(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

float eased(
    float x_2,
    float low,
    float high
) {
    float _e3 = bounded(x_2);
    float _e7 = bounded((_e3 - low) / 0.5);
    float t_2 = metal::clamp(_e7, 0.0, 1.0);
    return (t_2 * t_2) * (3.0 - (2.0 * t_2));
}

float length_of(
    metal::float3 v_3
) {
    float largest_2 = metal::max(metal::max(metal::abs(v_3.x), metal::abs(v_3.y)), metal::abs(v_3.z));
    if (largest_2 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e16 = bounded(largest_2 * metal::length(v_3 / metal::float3(largest_2)));
    return _e16;
}

float footprint_of(
    float x_3
) {
    float _e1 = metal::dfdx(x_3);
    float _e2 = metal::dfdy(x_3);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_1, d_1));
}

float footprint_of_vec3_(
    metal::float3 v_4
) {
    metal::float3 dx_1 = metal::dfdx(v_4);
    metal::float3 dy_1 = metal::dfdy(v_4);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx_1, dx_1), metal::dot(dy_1, dy_1))));
    return _e7;
}

float footprint_of_vec3_2_(
    metal::float3 v_5
) {
    metal::float3 dx_2 = metal::dfdx(v_5);
    metal::float3 dy_2 = metal::dfdy(v_5);
    return metal::sqrt(metal::max(metal::dot(dx_2, dx_2), metal::dot(dy_2, dy_2)));
}

float step_filtered(
    float x_4,
    float edge,
    float w
) {
    float d_2 = x_4 - edge;
    return (w < 0.000000000000000000000000000001) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_2 / w), 0.0, 1.0);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

Color ramp_at(
    Ramp ramp,
    float x_5,
    float w_1
) {
    type_5 colors = {};
    type_6 places = {};
    metal::float4 color = {};
    uint i = 1u;
    colors = ramp.colors;
    places = ramp.places;
    metal::float4 _e8 = colors.inner[0];
    color = _e8;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e38 = i;
            i = _e38 + 1u;
        }
        loop_init = false;
        uint _e12 = i;
        if (!((_e12 < 7u))) {
            break;
        }
        metal::float4 _e16 = color;
        uint _e17 = i;
        metal::float4 _e19 = colors.inner[_e17];
        uint _e20 = i;
        metal::float4 _e24 = colors.inner[_e20 - 1u];
        uint _e26 = i;
        uint _e30 = i;
        float _e34 = places.inner[naga_div(_e26, 4u)][naga_mod(_e30, 4u)];
        float _e35 = step_filtered(x_5, _e34, w_1);
        color = _e16 + ((_e19 - _e24) * _e35);
    }
    metal::float4 _e41 = color;
    return _e41;
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
    metal::float3 s_3 = along_x.xyz / metal::float3(largest_3);
    metal::float3 t_3 = along_y.xyz / metal::float3(largest_3);
    metal::float2 rise = metal::clamp(metal::float2(along_x.w, along_y.w) / metal::float2(largest_3), metal::float2(-1000000.0), metal::float2(1000000.0));
    metal::float3 right = metal::cross(t_3, normal);
    metal::float3 up = metal::cross(normal, s_3);
    float area = metal::dot(s_3, right);
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

Composite blend_add(
    Composite below,
    Color color_1,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::max(metal::float4(below.xyz + (opacity * ((below.xyz + color_1.xyz) - below.xyz)), 1.0), metal::float4(0.0));
}

Composite blend_add_2_(
    Composite below_1,
    Color color_2,
    float tone_1,
    float opacity_1,
    bool clamped_1
) {
    return metal::clamp(metal::float4(below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * color_2.xyz)) - below_1.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

Composite blend_alpha(
    Composite below_2,
    Color color_3,
    float tone_2,
    float opacity_2,
    bool clamped_2
) {
    return metal::clamp(metal::float4(below_2.xyz + (opacity_2 * ((below_2.xyz + (tone_2 * (color_3.xyz - below_2.xyz))) - below_2.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_4,
    float tone_3
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_4.xyz * light.color) * split.y, 1.0), tone_3 * split.x};
}

Angle parametrization_specular_balanced(
    Light light_1,
    metal::float3 normal_2,
    metal::float3 view
) {
    metal::float3 d_3 = ((2.0 * metal::dot(normal_2, view)) * normal_2) - view;
    return Angle {0.5 * metal::length(d_3 - light_1.direction), 0.5 * metal::length(d_3 + light_1.direction)};
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
    float w_2,
    ProfileShape shape_1
) {
    float width = metal::sqrt((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp_1 = metal::clamp(0.5 + ((shape_1.edge_mean - from_offset) / width), 0.0, 1.0);
    return (w_2 <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp_1;
}

float profile_filtered_quick(
    Angle u_2,
    float w_3,
    ProfileShape shape_2
) {
    metal::float2 place = metal::float2((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset), (u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset));
    float _e19 = profile_soft_quick(place.x, shape_2);
    if (w_3 < (0.1 * shape_2.edge_deviation)) {
        return _e19;
    }
    float r = 0.19364917 * w_3;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e45 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_2);
    float _e53 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_2);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_filtered_quick_2_(
    Angle u_3,
    float w_4,
    ProfileShape shape_3
) {
    metal::float2 place_1 = metal::float2((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset), (u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset));
    bool is_narrow = (w_4 > 0.0) & (w_4 >= (3.4641016 * shape_3.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place_1.x, w_4, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_3);
    if (w_4 < (0.1 * shape_3.edge_deviation)) {
        return _e30;
    }
    float r_1 = 0.19364917 * w_4;
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
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_6 = {};
    v_6 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = _e8 + (_e10 * _e12);
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = _e16 + (_e18 * _e20);
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_6;
    metal::uint3 _e32 = v_6;
    v_6 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = _e38 + (_e40 * _e42);
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = _e46 + (_e48 * _e50);
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_6;
    return _e61;
}

metal::float3 unit_of_hash(
    metal::uint3 hash
) {
    return static_cast<metal::float3>(hash >> metal::uint3(8u)) * 0.000000059604645;
}

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

float gradient_dot(
    metal::uint3 hash_1,
    metal::float3 d
) {
    uint axis = naga_mod(hash_1.x >> 8u, 3u);
    float a = (axis == 0u) ? d.y : d.x;
    float b = (axis == 2u) ? d.y : d.z;
    return (((hash_1.y >> 31u) == 0u) ? a : -(a)) + (((hash_1.z >> 31u) == 0u) ? b : -(b));
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
    int i_1 = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_4 = p - corner;
    metal::float3 _e4 = fade_quintic(d_4);
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e46 = i_1;
            i_1 = as_type<int>(as_type<uint>(_e46) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e10 = i_1;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i_1;
            int _e16 = i_1;
            int _e21 = i_1;
            metal::int3 at = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at)), seed_2);
            float _e42 = gradient_dot(_e39, d_4 - static_cast<metal::float3>(at));
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e42);
        }
    }
    float _e48 = sum;
    return metal::clamp(0.5 + (0.48244 * _e48), 0.0, 1.0);
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

Cell nearest_cell(
    metal::float3 p_1,
    uint seed_3
) {
    metal::float3 nearest = metal::float3(4.0);
    metal::uint3 hash_2 = metal::uint3(0u);
    int i_2 = 0;
    float border = {};
    int i_3 = 0;
    metal::float3 corner_1 = metal::floor(p_1);
    metal::float3 d_5 = p_1 - corner_1;
    metal::int3 cell_2 = naga_f2i32(corner_1);
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e51 = i_2;
            i_2 = as_type<int>(as_type<uint>(_e51) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e13 = i_2;
        if (_e13 < 27) {
        } else {
            break;
        }
        {
            int _e16 = i_2;
            int _e21 = i_2;
            int _e28 = i_2;
            metal::int3 at_1 = metal::int3(as_type<int>(as_type<uint>(naga_mod(_e16, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_mod(naga_div(_e21, 3), 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e28, 9)) - as_type<uint>(1)));
            metal::uint3 _e35 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_2) + as_type<metal::uint3>(at_1)), seed_3);
            metal::float3 _e40 = unit_of_hash(_e35);
            metal::float3 offset = ((static_cast<metal::float3>(at_1) + metal::float3(0.25)) + (0.5 * _e40)) - d_5;
            metal::float3 _e46 = nearest;
            metal::float3 _e47 = nearest;
            if (metal::dot(offset, offset) < metal::dot(_e46, _e47)) {
                nearest = offset;
                hash_2 = _e35;
            }
        }
    }
    metal::float3 _e53 = nearest;
    float distance = metal::length(_e53);
    border = metal::max(0.5 * (CELL_REACH - distance), 0.0);
    uint2 loop_bound_3 = uint2(4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (metal::all(loop_bound_3 == uint2(0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e110 = i_3;
            i_3 = as_type<int>(as_type<uint>(_e110) + as_type<uint>(1));
        }
        loop_init_3 = false;
        int _e64 = i_3;
        if (_e64 < 27) {
        } else {
            break;
        }
        {
            int _e67 = i_3;
            int _e72 = i_3;
            int _e79 = i_3;
            metal::int3 at_2 = metal::int3(as_type<int>(as_type<uint>(naga_mod(_e67, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_mod(naga_div(_e72, 3), 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e79, 9)) - as_type<uint>(1)));
            metal::uint3 _e90 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_2) + as_type<metal::uint3>(at_2)), seed_3);
            metal::float3 _e91 = unit_of_hash(_e90);
            metal::float3 _e96 = nearest;
            metal::float3 apart = (((static_cast<metal::float3>(at_2) + metal::float3(0.25)) + (0.5 * _e91)) - d_5) - _e96;
            float between = metal::length(apart);
            if (between > 0.25) {
                float _e101 = border;
                metal::float3 _e102 = nearest;
                border = metal::min(_e101, metal::dot(_e102 + (0.5 * apart), apart) / between);
            }
        }
    }
    float _e112 = border;
    metal::uint3 _e115 = hash_2;
    metal::uint3 _e116 = hash_pcg3d(_e115);
    metal::float3 _e117 = unit_of_hash(_e116);
    return Cell {metal::max(_e112, 0.0), _e117.x, distance};
}

float fractal_noise(
    uint kind,
    metal::float3 p_2,
    int octaves,
    float roughness,
    int seed_4,
    float w_5
) {
    float octave = {};
    int i_4 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    uint2 loop_bound_4 = uint2(4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (metal::all(loop_bound_4 == uint2(0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e66 = i_4;
            i_4 = as_type<int>(as_type<uint>(_e66) + as_type<uint>(1));
        }
        loop_init_4 = false;
        int _e17 = i_4;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased(w_5 * _e21, 0.5, 1.0);
        float visible = 1.0 - _e25;
        octave = 0.5;
        if (visible > 0.0) {
            float _e31 = frequency;
            int _e33 = i_4;
            metal::float3 place_2 = metal::clamp((p_2 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_4;
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

Cells cells(
    metal::float3 position_1,
    float scale_1,
    int seed_5
) {
    metal::float3 p_3 = metal::clamp(position_1 * scale_1, metal::float3(-4194304.0), metal::float3(4194304.0));
    Cell _e10 = nearest_cell(p_3, 4u);
    float _e11 = footprint_of_vec3_2_(p_3);
    float visible_1 = 1.0 - metal::smoothstep(0.5, 1.0, _e11);
    metal::float3 average = metal::float3(0.1301, 0.5, 0.491);
    metal::float3 seen = metal::mix(average, metal::float3(_e10.border, _e10.random, _e10.distance), visible_1);
    return Cells {seen.x, seen.y, seen.z};
}

float noise_perlin(
    metal::float3 position_2,
    float scale_2,
    int octaves_1,
    float roughness_1,
    int seed_6
) {
    metal::float3 p_4 = position_2 * scale_2;
    float _e7 = footprint_of_vec3_(p_4);
    float _e8 = fractal_noise(NOISE_PERLIN, p_4, octaves_1, roughness_1, seed_6, _e7);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Cells _e4 = cells(surface.position_object, 3.4, 4);
    float _e8 = footprint_of(_e4.random);
    Color _e9 = ramp_at(colors_1, _e4.random, _e8);
    Composite _e18 = blend_add(metal::float4(0.0275, 0.0235, 0.0471, 1.0), _e9, 1.0, 0.3, true);
    float _e24 = noise_perlin(surface.position_object, 5.0, 2, 0.5, 0);
    metal::float3 _e28 = bump_map(_e24, 0.03, surface.normal, surface.position);
    metal::float3 _e32 = look.sun.direction;
    metal::float3 _e40 = look.sun.direction;
    Angle sun_turn = Angle {0.5 * metal::length(_e28 - _e32), 0.5 * metal::length(_e28 + _e40)};
    float _e48 = profile_balanced(sun_turn, 0.0, through_the_glass_shape);
    Composite _e51 = blend_add_2_(_e18, _e9, _e48, 0.95, true);
    metal::float3 _e55 = look.room.direction;
    metal::float3 _e63 = look.room.direction;
    Angle room_turn = Angle {0.5 * metal::length(_e28 - _e55), 0.5 * metal::length(_e28 + _e63)};
    float _e71 = profile_balanced(room_turn, 0.0, on_the_glass_shape);
    Composite _e74 = blend_add_2_(_e51, _e9, _e71, 0.45, true);
    float _e78 = footprint_of(_e4.border);
    float _e82 = step_filtered(_e4.border, 0.035, metal::length(metal::float2(_e78, 0.0)));
    float leading = 1.0 - _e82;
    metal::float4 leading_2_ = metal::clamp(metal::float4(_e74.xyz + (leading * (metal::float3(0.0824, 0.0863, 0.102) - _e74.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Light _e103 = look.room;
    Angle _e105 = parametrization_specular_balanced(_e103, _e28, surface.view);
    float _e108 = profile_balanced_2_(_e105, 0.0, gleam_tone_shape);
    Light _e111 = look.room;
    LitLayer _e117 = light_apply(_e111, metal::float4(1.0, 0.9647, 0.8941, 1.0), _e108);
    Composite _e122 = blend_alpha(leading_2_, _e117.color, _e117.tone, 0.7, true);
    Light _e125 = look.room;
    Angle _e128 = parametrization_specular_balanced(_e125, surface.normal, surface.view);
    float _e131 = profile_balanced_2_(_e128, 0.0, edge_of_the_lead_tone_shape);
    Light _e134 = look.room;
    LitLayer _e140 = light_apply(_e134, metal::float4(0.1725, 0.1843, 0.2196, 1.0), _e131);
    Composite _e145 = blend_add_2_(_e122, _e140.color, _e140.tone, 0.35, true);
    return _e145;
}

struct vs_mainInput {
    metal::float3 position_3 [[attribute(0)]];
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
    const Vertex vertex_ = { varyings.position_3, varyings.normal_3 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_3 [[user(loc0), center_perspective]];
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
) {
    const Varyings in = { clip, varyings_1.position_3, varyings_1.position_object, varyings_1.normal_3 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_3 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = Surface {normal_3, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position, in.position_object};
    metal::float4 _e21 = shade(surface_1, look);
    return fs_mainOutput { _e21 };
}
