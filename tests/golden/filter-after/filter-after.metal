// A filter after the profile: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// filter-after.json says what to put there and how to draw.
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
struct Look {
    metal::float3 lamp_position;
    metal::float3 lamp_aim;
    metal::float3x3 lamp_own_from_world;
    metal::packed_float3 lamp_color;
    float lamp_intensity;
    metal::float2 lamp_cone;
    metal::float2 lamp_fading;
};
struct Surface {
    metal::float3 normal;
    metal::float3 position;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Angle {
    float half_sin;
    float half_cos;
};
struct Light {
    metal::float3 direction;
    metal::float3 own_direction;
    metal::packed_float3 color;
    float intensity;
};
struct LitLayer {
    Color color;
    float tone;
    char _pad2[12];
};
struct FilteredLight {
    Light light;
    Angle angle;
    char _pad2[8];
};
struct PlaceInLight {
    metal::float2 uv;
    float inside;
    char _pad2[4];
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
    metal::float3 normal;
};
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant float FAR_FROM_SHAPE = 1000.0;
constant float CELL_REACH = 1.25;
constant ProfileShape tone_shape = ProfileShape {0.87758255, 0.47942555, 20.008335, 2.4978132, 1.0, 0.04909103, 0.021148764, 0u};

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

metal::float2 sin_cos_eighth(
    float x_1
) {
    float y_2 = x_1 * x_1;
    float s_2 = x_1 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 0.0000027557319))))))));
    float c = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-0.000024801588 + (y_2 * 0.0000002755732)))))))));
    return metal::float2(s_2, c);
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

float atan2_positive(
    float y,
    float x_2
) {
    float small = metal::min(y, x_2);
    float large = metal::max(y, x_2);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_1 = small / large;
    bool is_wide = t_1 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_1;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y > x_2) ? (HALF_PI - a) : a;
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_2 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_2, 0.5);
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
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float3 bounded_vec3_(
    metal::float3 v_3
) {
    metal::uint3 bits_1 = as_type<metal::uint3>(v_3);
    metal::uint3 magnitude_1 = bits_1 & metal::uint3(2147483647u);
    metal::float3 largest_2 = as_type<metal::float3>((bits_1 & metal::uint3(2147483648u)) | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest_2, magnitude_1 == metal::uint3(2139095040u));
    return metal::select(numbers, v_3, magnitude_1 < metal::uint3(2139095040u));
}

float place_between(
    float x_4,
    float low,
    float high
) {
    float span = high - low;
    if (span < SMALLEST_NORMAL) {
        return (x_4 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded((x_4 - low) / span);
    return _e12;
}

float eased(
    float x_5,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_5);
    float _e4 = place_between(_e3, low_1, high_1);
    float t_2 = metal::clamp(_e4, 0.0, 1.0);
    return (t_2 * t_2) * (3.0 - (2.0 * t_2));
}

float angle_of_point(
    float y_1,
    float x_6
) {
    metal::float2 p_1 = metal::abs(metal::float2(x_6, y_1));
    metal::float2 scaled_1 = (metal::max(p_1.x, p_1.y) > 1.0) ? (0.5 * p_1) : p_1;
    float _e14 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_1 = (x_6 < 0.0) ? (PI - _e14) : _e14;
    return (y_1 < 0.0) ? -(turned_1) : turned_1;
}

float footprint_of(
    float x_7
) {
    float _e1 = metal::dfdx(x_7);
    float _e2 = metal::dfdy(x_7);
    metal::float2 d = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
    return _e6;
}

metal::float2 footprint_of_vec2_(
    metal::float2 v_4
) {
    metal::float2 dx_1 = metal::dfdx(v_4);
    metal::float2 dy_1 = metal::dfdy(v_4);
    return metal::sqrt((dx_1 * dx_1) + (dy_1 * dy_1));
}

float footprint_of_vec3_(
    metal::float3 v_5
) {
    metal::float3 dx_2 = metal::dfdx(v_5);
    metal::float3 dy_2 = metal::dfdy(v_5);
    return metal::sqrt(metal::max(metal::dot(dx_2, dx_2), metal::dot(dy_2, dy_2)));
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

Composite blend_add(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + ((below.xyz + (tone * color.xyz)) - below.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
}

metal::float3x3 axes_turned(
    metal::float3 toward_1,
    float spin
) {
    metal::float3x3 _e6 = axes_around(toward_1, metal::float3(0.0, 1.0, 0.0));
    metal::float2 turn = metal::float2(0.0, 1.0);
    return metal::float3x3((turn.y * _e6[0]) + (turn.x * _e6[1]), (turn.y * _e6[1]) - (turn.x * _e6[0]), _e6[2]);
}

metal::float3x3 axes_turned_2_(
    metal::float3 toward_2,
    float spin_1
) {
    metal::float3x3 _e6 = axes_around(toward_2, metal::float3(0.0, 1.0, 0.0));
    metal::float2 _e13 = sin_cos_eighth(((spin_1 - 0.0) - 0.0) - 0.0);
    metal::float2 turn_1 = metal::clamp(_e13, metal::float2(-1.0), metal::float2(1.0));
    return metal::float3x3((turn_1.y * _e6[0]) + (turn_1.x * _e6[1]), (turn_1.y * _e6[1]) - (turn_1.x * _e6[0]), _e6[2]);
}

metal::float3 place_along(
    metal::float3 place,
    metal::float3 center,
    metal::float3x3 axes
) {
    metal::float3 away = metal::clamp(place - center, metal::float3(-1000000.0), metal::float3(1000000.0));
    return metal::float3(metal::dot(away, axes[0]), metal::dot(away, axes[1]), metal::dot(away, axes[2]));
}

float share_beside(
    float m,
    float softness,
    float density,
    bool inverted
) {
    float near = metal::min(m, FAR_FROM_SHAPE);
    float _e6 = footprint_of(near);
    float half_1 = 0.5 * metal::min(_e6, 0.25);
    float _e15 = eased(near, 1.0 - half_1, 1.0 + half_1);
    return 1.0 - _e15;
}

float share_of_doors(
    metal::float3 seen,
    metal::float4 flaps,
    float softness_1
) {
    float _e5 = angle_of_point(seen.x, seen.z);
    float _e8 = angle_of_point(seen.y, seen.z);
    metal::float2 angles = metal::float2(_e5, _e8);
    metal::float2 _e10 = footprint_of_vec2_(angles);
    metal::float2 half_2 = 0.5 * metal::min(_e10, metal::float2(0.1));
    float aside_1 = (1.0 - metal::smoothstep(flaps.x - half_2.x, flaps.x + metal::max(softness_1, half_2.x), angles.x)) * (1.0 - metal::smoothstep(flaps.y - half_2.x, flaps.y + metal::max(softness_1, half_2.x), -(angles.x)));
    return (aside_1 * (1.0 - metal::smoothstep(flaps.z - half_2.y, flaps.z + metal::max(softness_1, half_2.y), angles.y))) * (1.0 - metal::smoothstep(flaps.w - half_2.y, flaps.w + metal::max(softness_1, half_2.y), -(angles.y)));
}

float light_fading(
    float distance,
    metal::float2 fading
) {
    float left = 1.0;
    if (fading.x > 0.0) {
        float d_1 = metal::min(distance / fading.x, 1000000000000000.0);
        left = 1.0 / (1.0 + (d_1 * d_1));
    }
    if (fading.y > 0.0) {
        float d_2 = metal::min(distance / fading.y, 1.0);
        float window = metal::max(1.0 - (((d_2 * d_2) * d_2) * d_2), 0.0);
        float _e30 = left;
        left = _e30 * (window * window);
    }
    float _e33 = left;
    return _e33;
}

Light light_at(
    metal::float3 light_position,
    metal::float3x3 own_from_world,
    metal::float3 color_1,
    float intensity,
    metal::float2 fading_1,
    metal::float3 position
) {
    metal::float3 offset = light_position - position;
    metal::float3 _e11 = normalize_or(offset, metal::float3(0.0, 0.0, 1.0));
    float _e13 = light_fading(metal::length(offset), fading_1);
    float faded = intensity * _e13;
    return Light {_e11, own_from_world * _e11, color_1, faded};
}

float light_cone(
    float cos_angle,
    metal::float2 cone
) {
    if (cone.x <= cone.y) {
        return (cos_angle >= cone.y) ? 1.0 : 0.0;
    }
    float t_3 = metal::clamp((cos_angle - cone.y) / (cone.x - cone.y), 0.0, 1.0);
    return (t_3 * t_3) * (3.0 - (2.0 * t_3));
}

Light light_spot(
    metal::float3 light_position_1,
    metal::float3 aim,
    metal::float3x3 own_from_world_1,
    metal::float3 color_2,
    float intensity_1,
    metal::float2 cone_1,
    metal::float2 fading_2,
    metal::float3 position_1
) {
    Light light = {};
    Light _e8 = light_at(light_position_1, own_from_world_1, color_2, intensity_1, fading_2, position_1);
    light = _e8;
    float _e11 = light.intensity;
    metal::float3 _e13 = light.direction;
    float _e16 = light_cone(metal::dot(-(_e13), aim), cone_1);
    light.intensity = _e11 * _e16;
    Light _e18 = light;
    return _e18;
}

LitLayer light_apply(
    Light light_1,
    Color color_3,
    float tone_1
) {
    metal::float2 split = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4((color_3.xyz * light_1.color) * split.y, 1.0), tone_1 * split.x};
}

PlaceInLight place_in_light(
    metal::float2 at
) {
    metal::float2 near_1 = metal::clamp(at, metal::float2(-1000.0), metal::float2(1000.0));
    float _e14 = share_beside(metal::max(metal::abs(near_1.x), metal::abs(near_1.y)), 0.0, 1.0, true);
    return PlaceInLight {metal::float2(0.5) + (0.5 * metal::float2(-(near_1.x), near_1.y)), _e14};
}

PlaceInLight light_place_point(
    metal::float3 light_position_2,
    float angle,
    float spin_2,
    metal::float3 toward_3,
    metal::float3 position_2
) {
    metal::float3x3 _e5 = axes_turned_2_(toward_3, spin_2);
    metal::float3 _e6 = place_along(position_2, light_position_2, _e5);
    metal::float2 _e13 = sin_cos_eighth(((angle - 0.0) - 0.0) - 0.0);
    metal::float2 turn_2 = metal::clamp(_e13, metal::float2(-1.0), metal::float2(1.0));
    metal::float2 at_1 = (_e6.xy * (turn_2.y / turn_2.x)) / metal::float2(metal::max(_e6.z, 0.001));
    PlaceInLight _e35 = place_in_light((_e6.z > 0.001) ? at_1 : metal::float2(1000.0));
    return _e35;
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
    Angle u_2,
    float w_1,
    ProfileShape shape_2
) {
    metal::float2 place_1 = metal::float2((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset), (u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset));
    bool is_narrow = (w_1 > 0.0) & (w_1 >= (3.4641016 * shape_2.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place_1.x, w_1, shape_2);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_2);
    if (w_1 < (0.1 * shape_2.edge_deviation)) {
        return _e30;
    }
    float r_1 = 0.19364917 * w_1;
    metal::float2 turn_3 = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
    float _e56 = profile_soft_quick((place_1.x * turn_3.y) - (place_1.y * turn_3.x), shape_2);
    float _e64 = profile_soft_quick((place_1.x * turn_3.y) + (place_1.y * turn_3.x), shape_2);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle_1,
    float shift,
    ProfileShape shape_3
) {
    Angle _e6 = angle_turned(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
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

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

Cell nearest_cell(
    metal::float3 p,
    uint seed_2
) {
    metal::float3 nearest = metal::float3(4.0);
    metal::uint3 hash_1 = metal::uint3(0u);
    int i = 0;
    float border = {};
    int i_1 = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_3 = p - corner;
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e51 = i;
            i = as_type<int>(as_type<uint>(_e51) + as_type<uint>(1));
        }
        loop_init = false;
        int _e13 = i;
        if (_e13 < 27) {
        } else {
            break;
        }
        {
            int _e16 = i;
            int _e21 = i;
            int _e28 = i;
            metal::int3 at_2 = metal::int3(as_type<int>(as_type<uint>(naga_mod(_e16, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_mod(naga_div(_e21, 3), 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e28, 9)) - as_type<uint>(1)));
            metal::uint3 _e35 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at_2)), seed_2);
            metal::float3 _e40 = unit_of_hash(_e35);
            metal::float3 offset_1 = ((static_cast<metal::float3>(at_2) + metal::float3(0.25)) + (0.5 * _e40)) - d_3;
            metal::float3 _e46 = nearest;
            metal::float3 _e47 = nearest;
            if (metal::dot(offset_1, offset_1) < metal::dot(_e46, _e47)) {
                nearest = offset_1;
                hash_1 = _e35;
            }
        }
    }
    metal::float3 _e53 = nearest;
    float distance_1 = metal::length(_e53);
    border = metal::max(0.5 * (CELL_REACH - distance_1), 0.0);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e110 = i_1;
            i_1 = as_type<int>(as_type<uint>(_e110) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e64 = i_1;
        if (_e64 < 27) {
        } else {
            break;
        }
        {
            int _e67 = i_1;
            int _e72 = i_1;
            int _e79 = i_1;
            metal::int3 at_3 = metal::int3(as_type<int>(as_type<uint>(naga_mod(_e67, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_mod(naga_div(_e72, 3), 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e79, 9)) - as_type<uint>(1)));
            metal::uint3 _e90 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at_3)), seed_2);
            metal::float3 _e91 = unit_of_hash(_e90);
            metal::float3 _e96 = nearest;
            metal::float3 apart = (((static_cast<metal::float3>(at_3) + metal::float3(0.25)) + (0.5 * _e91)) - d_3) - _e96;
            float between = metal::length(apart);
            if (between > 0.25) {
                float _e101 = border;
                metal::float3 _e102 = nearest;
                border = metal::min(_e101, metal::dot(_e102 + (0.5 * apart), apart) / between);
            }
        }
    }
    float _e112 = border;
    metal::uint3 _e115 = hash_1;
    metal::uint3 _e116 = hash_pcg3d(_e115);
    metal::float3 _e117 = unit_of_hash(_e116);
    return Cell {metal::max(_e112, 0.0), _e117.x, distance_1};
}

Cells cells(
    metal::float3 position_3,
    float scale,
    int seed_3
) {
    metal::float3 _e4 = bounded_vec3_(position_3 * scale);
    Cell _e6 = nearest_cell(_e4, 0u);
    float _e7 = footprint_of_vec3_(_e4);
    float visible = 1.0 - metal::smoothstep(0.5, 1.0, _e7);
    metal::float3 average = metal::float3(0.1301, 0.5, 0.491);
    metal::float3 seen_1 = metal::mix(average, metal::float3(_e6.border, _e6.random, _e6.distance), visible);
    return Cells {seen_1.x, seen_1.y, seen_1.z};
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e3 = look.lamp_position;
    metal::float3 _e6 = look.lamp_aim;
    metal::float3x3 _e9 = look.lamp_own_from_world;
    metal::float3 _e12 = look.lamp_color;
    float _e15 = look.lamp_intensity;
    metal::float2 _e18 = look.lamp_cone;
    metal::float2 _e21 = look.lamp_fading;
    Light _e23 = light_spot(_e3, _e6, _e9, _e12, _e15, _e18, _e21, surface.position);
    Angle angle_2 = Angle {0.5 * metal::length(surface.normal - _e23.direction), 0.5 * metal::length(surface.normal + _e23.direction)};
    metal::float3 _e40 = look.lamp_position;
    metal::float3 _e43 = look.lamp_aim;
    metal::float3x3 _e45 = axes_turned(_e43, 0.0);
    metal::float3 _e46 = place_along(surface.position, _e40, _e45);
    float _e53 = share_of_doors(_e46, metal::float4(0.3, 0.36, 0.3, 0.2), 0.02);
    metal::float3 _e56 = look.lamp_position;
    metal::float3 _e61 = look.lamp_aim;
    PlaceInLight _e63 = light_place_point(_e56, 0.4, 0.6, _e61, surface.position);
    Cells _e69 = cells(metal::float3(_e63.uv, 0.0), 13.0, 0);
    float both = _e53 * metal::smoothstep(0.12, 0.62, _e69.distance);
    FilteredLight filter_2_ = FilteredLight {Light {_e23.direction, _e23.own_direction, _e23.color, _e23.intensity * both}, angle_2};
    float _e85 = profile_balanced(filter_2_.angle, 0.0, tone_shape);
    LitLayer _e92 = light_apply(filter_2_.light, metal::float4(0.93, 0.62, 0.36, 1.0), _e85);
    Composite _e102 = blend_add(metal::float4(0.13, 0.14, 0.27, 1.0), _e92.color, _e92.tone, 1.0, true);
    return _e102;
}

struct vs_mainInput {
    metal::float3 position_4 [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_4, varyings.normal };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_4 [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_4, varyings_1.normal };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    Surface surface_1 = Surface {normal, in.position};
    metal::float4 _e8 = shade(surface_1, look);
    return fs_mainOutput { _e8 };
}
