// Ink outlines: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds the nearest edges in each pixel's column.
// Arguments of both functions: surface texture(0), curvature buffer(0), edges_2 texture(1).
// ink-outlines.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
    float samples;
};
struct SeenPixel {
    metal::int2 at;
    char _pad1[8];
    metal::float4 texel;
};
struct Plane {
    float object;
    float depth;
    metal::float2 rise;
    float tolerance;
    char _pad4[4];
};
struct Center {
    metal::int2 at;
    metal::float2 slope;
    Plane plane;
};
struct Ring {
    metal::float4 x;
    metal::float4 y;
    metal::float4 weights;
};
struct EdgeLines {
    metal::float4 x;
    metal::float4 y;
    metal::float4 offset;
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
struct type_10 {
    metal::float4 inner[16];
};
struct Curve {
    type_10 points;
    uint count;
    uint interpolation;
    char _pad3[8];
};
struct type_11 {
    metal::float4 inner[4];
};
struct Ramp {
    type_10 colors;
    type_11 places;
    uint count;
    uint interpolation;
    char _pad4[8];
};
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;

metal::float2 slope_of(
    metal::float3 normal
) {
    return normal.xy / metal::float2(metal::max(normal.z, 0.2));
}

metal::float4 surface_texel(
    metal::float3 normal_1,
    float depth,
    float number
) {
    metal::float2 _e3 = slope_of(normal_1);
    return metal::float4(_e3, depth, (normal_1.z < 0.0) ? -(number) : number);
}

metal::float3 normal_of(
    metal::float4 texel
) {
    metal::float2 aside = 0.2 * texel.xy;
    float rest = metal::sqrt(metal::max(1.0 - metal::dot(aside, aside), 0.0));
    float nz = (texel.w < 0.0) ? -(rest) : rest;
    metal::float3 facing = metal::float3(texel.xy, 1.0) / metal::float3(metal::sqrt(1.0 + metal::dot(texel.xy, texel.xy)));
    return (nz >= 0.2) ? facing : metal::float3(aside, nz);
}

metal::float4 whole_picture(
    uint index_1
) {
    return metal::float4((static_cast<float>(index_1 & 1u) * 4.0) - 1.0, (static_cast<float>(index_1 >> 1u) * 4.0) - 1.0, 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int step_pixels(
    constant Curvature& curvature
) {
    float _e2 = curvature.viewport_height;
    return metal::max(naga_f2i32(metal::rint(_e2 / 800.0)), 1);
}

float row_direction(
    constant Curvature& curvature
) {
    float _e2 = curvature.rows_up;
    return (_e2 > 0.5) ? 1.0 : -1.0;
}

metal::int2 around(
    int index_2
) {
    int side = as_type<int>(as_type<uint>(1) - as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(index_2 & 1))));
    metal::int2 straight = (index_2 < 2) ? metal::int2(side, 0) : metal::int2(0, side);
    return (index_2 > 3) ? metal::int2(side, as_type<int>(as_type<uint>(1) - as_type<uint>(index_2 & 2))) : straight;
}

SeenPixel seen_pixel(
    metal::int2 pixel,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    SeenPixel seen = {};
    bool local = {};
    int index_3 = {};
    metal::float4 _e3 = surface.read(metal::uint2(pixel), 0);
    seen = SeenPixel {pixel, {}, _e3};
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    float _e14 = curvature.samples;
    if (_e14 >= 2.0) {
        float _e21 = seen.texel.w;
        local = _e21 == 0.0;
    } else {
        local = false;
    }
    bool may_be_missed = local;
    index_3 = may_be_missed ? 7 : -1;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e47 = index_3;
            index_3 = as_type<int>(as_type<uint>(_e47) - as_type<uint>(1));
        }
        loop_init = false;
        int _e30 = index_3;
        if (_e30 >= 0) {
        } else {
            break;
        }
        {
            int _e33 = index_3;
            metal::int2 _e34 = around(_e33);
            metal::int2 near = metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel) + as_type<metal::uint2>(_e34)), metal::int2(0), last);
            metal::float4 texel_2 = surface.read(metal::uint2(near), 0);
            if (texel_2.w != 0.0) {
                seen = SeenPixel {near, {}, texel_2};
            }
        }
    }
    SeenPixel _e49 = seen;
    return _e49;
}

Plane plane_of(
    float object,
    float depth_1,
    metal::float3 normal_2,
    constant Curvature& curvature
) {
    float _e5 = curvature.pixel;
    float _e8 = curvature.perspective;
    float pixel_3 = _e5 * metal::mix(1.0, depth_1, _e8);
    metal::float2 gradient = normal_2.xy / metal::float2(metal::max(normal_2.z, 0.02));
    float _e19 = row_direction(curvature);
    return Plane {object, depth_1, (pixel_3 * gradient) * metal::float2(1.0, _e19), (2.0 * pixel_3) * (1.0 + metal::length(gradient))};
}

metal::float4 neighbor_weights(
    Plane plane,
    metal::float4 objects,
    metal::float4 depths,
    metal::float4 rises,
    float distance
) {
    metal::float4 error = metal::abs((depths - metal::float4(plane.depth)) - rises);
    float scale = 1.0 / metal::max(plane.tolerance * distance, 0.000000000000000000000000000001);
    metal::float4 weights_1 = metal::clamp(metal::float4(2.0) - (error * scale), metal::float4(0.0), metal::float4(1.0));
    return metal::select(metal::float4(0.0), weights_1, objects == metal::float4(plane.object));
}

Center center_at(
    metal::int2 pixel_1,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    SeenPixel _e1 = seen_pixel(pixel_1, surface, curvature);
    metal::float4 texel_3 = _e1.texel;
    metal::float3 _e8 = normal_of(texel_3);
    Plane _e9 = plane_of(metal::abs(_e1.texel.w), _e1.texel.z, _e8, curvature);
    return Center {_e1.at, texel_3.xy, _e9};
}

Ring ring_at(
    Center center,
    int steps,
    float weight,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    int _e3 = step_pixels(curvature);
    int reach_3 = as_type<int>(as_type<uint>(steps) * as_type<uint>(_e3));
    float distance_3 = static_cast<float>(reach_3);
    metal::int2 at = center.at;
    metal::int2 last_1 = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 a_6 = surface.read(metal::uint2(metal::int2(metal::min(as_type<int>(as_type<uint>(center.at.x) + as_type<uint>(reach_3)), last_1.x), center.at.y)), 0);
    metal::float4 b_6 = surface.read(metal::uint2(metal::int2(metal::max(as_type<int>(as_type<uint>(center.at.x) - as_type<uint>(reach_3)), 0), center.at.y)), 0);
    metal::float4 c = surface.read(metal::uint2(metal::int2(center.at.x, metal::min(as_type<int>(as_type<uint>(center.at.y) + as_type<uint>(reach_3)), last_1.y))), 0);
    metal::float4 d_2 = surface.read(metal::uint2(metal::int2(center.at.x, metal::max(as_type<int>(as_type<uint>(center.at.y) - as_type<uint>(reach_3)), 0))), 0);
    metal::bool4 is_inside = metal::int4(as_type<int>(as_type<uint>(last_1.x) - as_type<uint>(center.at.x)), center.at.x, as_type<int>(as_type<uint>(last_1.y) - as_type<uint>(center.at.y)), center.at.y) >= metal::int4(reach_3);
    metal::float4 objects_1 = metal::select(metal::float4(0.0), metal::abs(metal::float4(a_6.w, b_6.w, c.w, d_2.w)), is_inside);
    metal::float2 rise = distance_3 * center.plane.rise;
    metal::float4 rises_1 = metal::float4(rise.x, -(rise.x), rise.y, -(rise.y));
    metal::float4 _e86 = neighbor_weights(center.plane, objects_1, metal::float4(a_6.z, b_6.z, c.z, d_2.z), rises_1, distance_3);
    metal::float4 shares_1 = (weight * distance_3) * _e86;
    return Ring {shares_1 * (metal::float4(a_6.x, b_6.x, c.x, d_2.x) - metal::float4(center.slope.x)), shares_1 * (metal::float4(a_6.y, b_6.y, c.y, d_2.y) - metal::float4(center.slope.y)), shares_1 * distance_3};
}

Ring joined(
    Ring a,
    Ring b
) {
    return Ring {a.x + b.x, a.y + b.y, a.weights + b.weights};
}

Ring rings_at(
    Center center_1,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    Ring _e3 = ring_at(center_1, 1, 1.0, surface, curvature);
    Ring _e6 = ring_at(center_1, 2, 0.85, surface, curvature);
    Ring _e7 = joined(_e3, _e6);
    Ring _e10 = ring_at(center_1, 3, 0.5, surface, curvature);
    Ring _e11 = joined(_e7, _e10);
    return _e11;
}

metal::float2 derivatives(
    metal::float4 changes,
    metal::float4 weights,
    constant Curvature& curvature
) {
    metal::float4 trust = metal::smoothstep(metal::float4(0.0), metal::float4(0.5), weights);
    metal::float4 sides = (changes / metal::max(weights, metal::float4(0.000001))) * trust;
    metal::float2 along = (sides.xz - sides.yw) / metal::max(trust.xz + trust.yw, metal::float2(0.000001));
    float _e22 = row_direction(curvature);
    return along * metal::float2(1.0, _e22);
}

float mean_curvature(
    Ring ring,
    constant Curvature& curvature
) {
    metal::float2 _e7 = derivatives(metal::float4(ring.x.xy, ring.y.zw), ring.weights, curvature);
    float _e15 = curvature.viewport_height;
    return metal::clamp((0.5 * (_e7.x + _e7.y)) * _e15, -10000.0, 10000.0);
}

float object_in(
    float number_1
) {
    return metal::floor(metal::abs(number_1));
}

float edge_code(
    metal::float2 normal_3,
    float offset
) {
    float share = normal_3.x / metal::max(metal::abs(normal_3.x) + metal::abs(normal_3.y), 0.00000000000000000001);
    float turn = (normal_3.y >= 0.0) ? (1.0 - share) : (3.0 + share);
    float direction = metal::min(metal::floor(turn * 1024.0), 4095.0);
    float place = metal::floor((metal::clamp(offset, -1.99, 1.99) + 2.0) * 1024.0);
    return (place * 4096.0) + direction;
}

metal::float4 coarse_codes(
    metal::float4 codes
) {
    metal::float4 place_1 = metal::floor(codes / metal::float4(4096.0));
    metal::float4 direction_1 = codes - (4096.0 * place_1);
    return (metal::floor(place_1 * 0.125) * 512.0) + metal::floor(direction_1 * 0.125);
}

EdgeLines edges_of(
    metal::float4 codes_1,
    float levels
) {
    metal::float4 place_2 = metal::floor(codes_1 / metal::float4(levels));
    metal::float4 turn_1 = ((codes_1 - (levels * place_2)) + metal::float4(0.5)) * (4.0 / levels);
    metal::bool4 is_back = turn_1 >= metal::float4(2.0);
    metal::float4 x_28 = metal::select(metal::float4(1.0) - turn_1, turn_1 - metal::float4(3.0), is_back);
    metal::float4 rest_1 = metal::float4(1.0) - metal::abs(x_28);
    metal::float4 y_6 = metal::select(rest_1, -(rest_1), is_back);
    metal::float4 size = metal::sqrt((x_28 * x_28) + (y_6 * y_6));
    return EdgeLines {x_28 / size, y_6 / size, ((place_2 + metal::float4(0.5)) * (4.0 / levels)) - metal::float4(2.0)};
}

metal::float4 middle_distances(
    EdgeLines edges,
    metal::float4 columns,
    metal::float4 rows
) {
    metal::float4 x_29 = columns + (edges.x * edges.offset);
    metal::float4 y_7 = rows + (edges.y * edges.offset);
    float inward = (x_29.x * edges.x.x) + (y_7.x * edges.y.x);
    metal::float4 distances = metal::sqrt((x_29 * x_29) + (y_7 * y_7));
    return metal::float4((inward < -1.0) ? 1000000000.0 : distances.x, distances.yzw);
}

metal::float4 edge_distances(
    EdgeLines edges_1,
    metal::float4 columns_1,
    metal::float4 rows_1
) {
    metal::float4 across = (edges_1.offset + (edges_1.x * columns_1)) + (edges_1.y * rows_1);
    metal::float4 along_1 = metal::abs((edges_1.y * columns_1) - (edges_1.x * rows_1));
    metal::float4 beyond = metal::max(along_1 - metal::float4(1.0), metal::float4(0.0));
    metal::float4 side_1 = metal::float4(metal::max(across.x, 0.0), metal::abs(across.yzw));
    return metal::sqrt((side_1 * side_1) + (beyond * beyond));
}

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

float finite_or(
    float x_1,
    float otherwise
) {
    bool _e2 = is_finite(x_1);
    return _e2 ? x_1 : otherwise;
}

metal::float3 finite_vec3_(
    metal::float3 v
) {
    metal::uint3 exponent_2 = metal::uint3(2139095040u);
    return metal::select(metal::float3(0.0), v, (as_type<metal::uint3>(v) & exponent_2) != exponent_2);
}

metal::float4 finite_vec4_(
    metal::float4 v_1
) {
    metal::uint4 exponent_3 = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v_1, (as_type<metal::uint4>(v_1) & exponent_3) != exponent_3);
}

metal::float3 normalize_or(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    float largest = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (!(((largest > 0.000000000000000000000000000001) & (largest < 1000000000000000000000000000000.0)))) {
        return otherwise_1;
    }
    metal::float3 scaled = v_2 * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

float exp2_stable(
    float x_2
) {
    float clamped_2 = metal::clamp(x_2, -126.0, 127.99999);
    float whole = metal::rint(clamped_2);
    float f = clamped_2 - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float power_of_two(
    int n
) {
    return as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(n) + as_type<uint>(127))) << 23u);
}

float log2_stable(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    int exponent_4 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_4) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_4) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

float log_stable(
    float x_4
) {
    float _e2 = log2_stable(x_4);
    return LN_2_ * _e2;
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
    float _e8 = log_stable(metal::max(1.0 - y_1, 0.000000000000000000000000000000000000011754944));
    return _e8;
}

metal::float2 sin_cos_quarter(
    float x_5
) {
    float h = 0.5 * x_5;
    float h2_ = h * h;
    float s = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c_1 = 1.0 - one_minus_c;
    return metal::float2((2.0 * s) * c_1, 1.0 - ((2.0 * s) * s));
}

metal::float2 sin_cos_eighth(
    float x_6
) {
    float y_8 = x_6 * x_6;
    float s_1 = x_6 * (1.0 + (y_8 * (-0.16666667 + (y_8 * (0.008333334 + (y_8 * (-0.0001984127 + (y_8 * 0.0000027557319))))))));
    float c_2 = 1.0 - (y_8 * (0.5 + (y_8 * (-0.041666668 + (y_8 * (0.0013888889 + (y_8 * (-0.000024801588 + (y_8 * 0.0000002755732)))))))));
    return metal::float2(s_1, c_2);
}

metal::float2 sin_cos_tiny(
    float x_7
) {
    float y_9 = x_7 * x_7;
    float s_2 = x_7 * (1.0 + (y_9 * (-0.16666667 + (y_9 * 0.008333334))));
    float c_3 = 1.0 - (y_9 * (0.5 + (y_9 * (-0.041666668 + (y_9 * 0.0013888889)))));
    return metal::float2(s_2, c_3);
}

metal::float2 sin_cos_half(
    float x_8,
    float left
) {
    metal::float2 _e5 = sin_cos_quarter(0.5 * metal::min(x_8, left));
    return (x_8 <= left) ? _e5 : _e5.yx;
}

float left_to_pi(
    float x_9
) {
    float coarse = metal::max(3.1415927 - x_9, 0.0);
    return metal::max(coarse - 0.00000008742278, 0.0);
}

metal::float2 sin_cos(
    float x_10
) {
    float turns_1 = metal::rint(x_10 * 0.31830987);
    float r_3 = ((x_10 - (turns_1 * 3.140625)) - (turns_1 * 0.00096702576)) - (turns_1 * 0.00000062783295);
    float sign = 1.0 - (2.0 * metal::abs(turns_1 - (2.0 * metal::trunc(turns_1 * 0.5))));
    metal::float2 _e27 = sin_cos_quarter(metal::clamp(r_3, -1.5707964, HALF_PI));
    return sign * _e27;
}

metal::float3 normalize_quick(
    metal::float3 v_3,
    metal::float3 otherwise_2
) {
    float square_1 = metal::dot(v_3, v_3);
    bool is_usable = (square_1 > 0.000000000000000000000000000001) & (square_1 < 1000000000000000000000000000000000000.0);
    return is_usable ? (v_3 * metal::rsqrt(is_usable ? square_1 : 1.0)) : otherwise_2;
}

metal::float3 normalize_moderate(
    metal::float3 v_4,
    metal::float3 otherwise_3
) {
    float square_2 = metal::dot(v_4, v_4);
    return (square_2 > 0.000000000000000000000000000001) ? (v_4 * metal::rsqrt(metal::max(square_2, 0.000000000000000000000000000001))) : otherwise_3;
}

metal::float3 normalize_seen(
    metal::float3 v_5
) {
    metal::float3 _e5 = normalize_moderate(v_5, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_6
) {
    return v_6 * metal::rsqrt(metal::max(metal::dot(v_6, v_6), 0.000000000000000000000000000001));
}

metal::float2 sin_cos_quick(
    float x_11
) {
    float y_10 = x_11 * x_11;
    float s_3 = x_11 * (1.0 + (y_10 * (-0.16666666 + (y_10 * (0.0083332425 + (y_10 * (-0.0001982274 + (y_10 * 0.0000026347564))))))));
    float c_4 = 1.0 + (y_10 * (-0.5 + (y_10 * (0.04166666 + (y_10 * (-0.0013888652 + (y_10 * (0.00002477458 - (y_10 * 0.00000026297516)))))))));
    return metal::float2(s_3, c_4);
}

metal::float2 sin_cos_short(
    float x_12
) {
    float y_11 = x_12 * x_12;
    float s_4 = x_12 * (1.0 + (y_11 * (-0.16666542 + (y_11 * (0.008324197 - (y_11 * 0.00018846673))))));
    float c_5 = 1.0 + (y_11 * (-0.4999999 + (y_11 * (0.04166567 + (y_11 * (-0.0013868611 + (y_11 * 0.000023476086)))))));
    return metal::float2(s_4, c_5);
}

float log2_one_minus(
    float y_2
) {
    float series = (-(y_2) * LOG2_E) * (1.0 + (y_2 * (0.5 + (y_2 * (0.33333334 + (y_2 * (0.25 + (y_2 * 0.2))))))));
    return (y_2 < 0.0625) ? series : metal::log2(metal::max(1.0 - y_2, 0.0000000000000000000000000000007888609));
}

Angle angle_between(
    metal::float3 d,
    metal::float3 l
) {
    float p = metal::length(d - l);
    float s_5 = metal::length(d + l);
    float k = 1.0 / metal::sqrt(metal::max((p * p) + (s_5 * s_5), 0.000000000000000000000000000001));
    return Angle {p * k, s_5 * k};
}

float atan2_positive(
    float y_3,
    float x_13
) {
    float small = metal::min(y_3, x_13);
    float large = metal::max(y_3, x_13);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_5 = small / large;
    bool is_wide = t_5 > 0.41421357;
    float r_4 = is_wide ? ((small - large) / (small + large)) : t_5;
    float r2_ = r_4 * r_4;
    float series_1 = r_4 * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_7 = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_3 > x_13) ? (HALF_PI - a_7) : a_7;
}

float angle_radians(
    Angle u
) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return 2.0 * _e3;
}

Angle angle_of(
    float radians
) {
    float _e2 = finite_or(radians, 0.0);
    float half_angle = 0.5 * metal::clamp(_e2, 0.0, PI);
    metal::float2 _e8 = sin_cos_quarter(half_angle);
    return Angle {metal::max(_e8.x, 0.0), metal::max(_e8.y, 0.0)};
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_6 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_6 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_6 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_6, c_6);
    metal::float2 turned = ((s_6 <= 0.0) & (s_6 < c_6)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_shifted(
    Angle u_2,
    float shift
) {
    metal::float2 _e7 = sin_cos_quarter(0.5 * metal::clamp(shift, -3.1415927, PI));
    Angle _e8 = angle_turned(u_2, _e7);
    return _e8;
}

float angle_footprint(
    Angle u_3
) {
    metal::float2 half_ = metal::float2(u_3.half_sin, u_3.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    float _e13 = finite_or(w, 0.5);
    return metal::min(_e13, 0.5);
}

Angle angle_of_units(
    metal::float3 d_1,
    metal::float3 l_1
) {
    return Angle {0.5 * metal::length(d_1 - l_1), 0.5 * metal::length(d_1 + l_1)};
}

float bounded(
    float x_14
) {
    uint bits_1 = as_type<uint>(x_14);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_14 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float2 bounded_vec2_(
    metal::float2 v_7
) {
    metal::uint2 bits_2 = as_type<metal::uint2>(v_7);
    metal::uint2 magnitude_1 = bits_2 & metal::uint2(2147483647u);
    metal::float2 largest_2 = as_type<metal::float2>((bits_2 & metal::uint2(2147483648u)) | metal::uint2(2139095039u));
    metal::float2 numbers = metal::select(metal::float2(0.0), largest_2, magnitude_1 == metal::uint2(2139095040u));
    return metal::select(numbers, v_7, magnitude_1 < metal::uint2(2139095040u));
}

metal::float3 bounded_vec3_(
    metal::float3 v_8
) {
    metal::uint3 bits_3 = as_type<metal::uint3>(v_8);
    metal::uint3 magnitude_2 = bits_3 & metal::uint3(2147483647u);
    metal::float3 largest_3 = as_type<metal::float3>((bits_3 & metal::uint3(2147483648u)) | metal::uint3(2139095039u));
    metal::float3 numbers_1 = metal::select(metal::float3(0.0), largest_3, magnitude_2 == metal::uint3(2139095040u));
    return metal::select(numbers_1, v_8, magnitude_2 < metal::uint3(2139095040u));
}

metal::float4 bounded_vec4_(
    metal::float4 v_9
) {
    metal::uint4 bits_4 = as_type<metal::uint4>(v_9);
    metal::uint4 magnitude_3 = bits_4 & metal::uint4(2147483647u);
    metal::float4 largest_4 = as_type<metal::float4>((bits_4 & metal::uint4(2147483648u)) | metal::uint4(2139095039u));
    metal::float4 numbers_2 = metal::select(metal::float4(0.0), largest_4, magnitude_3 == metal::uint4(2139095040u));
    return metal::select(numbers_2, v_9, magnitude_3 < metal::uint4(2139095040u));
}

float divided(
    float a_1,
    float b_1
) {
    if (metal::abs(b_1) < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e7 = bounded(a_1 / b_1);
    return _e7;
}

float modulo_floored(
    float x_15,
    float y_4
) {
    float size_1 = metal::abs(y_4);
    if (size_1 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float turned_1 = (y_4 > 0.0) ? x_15 : -(x_15);
    float _e11 = bounded(turned_1 / size_1);
    float _e15 = bounded(turned_1 - (size_1 * metal::floor(_e11)));
    float wrapped = (_e15 < 0.0) ? (_e15 + size_1) : _e15;
    float inside = ((wrapped >= 0.0) & (wrapped < size_1)) ? wrapped : 0.0;
    return (y_4 > 0.0) ? inside : -(inside);
}

float powered(
    float base,
    float exponent
) {
    float _e2 = bounded(base);
    float _e3 = bounded(exponent);
    if (_e3 == 1.0) {
        return _e2;
    }
    if (_e3 == 0.0) {
        return 1.0;
    }
    if (_e3 == 2.0) {
        float _e12 = bounded(_e2 * _e2);
        return _e12;
    }
    float magnitude_4 = metal::abs(_e2);
    float _e16 = log2_stable(metal::max(magnitude_4, SMALLEST_NORMAL));
    float _e18 = bounded(_e3 * _e16);
    float _e19 = exp2_stable(_e18);
    bool is_even = metal::floor(_e3 * 0.5) == (_e3 * 0.5);
    float signed_ = ((_e2 < 0.0) & !(is_even)) ? -(_e19) : _e19;
    return (magnitude_4 < SMALLEST_NORMAL) ? 0.0 : signed_;
}

metal::float3 powered_vec3_(
    metal::float3 base_1,
    float exponent_1
) {
    float _e3 = powered(base_1.x, exponent_1);
    float _e5 = powered(base_1.y, exponent_1);
    float _e7 = powered(base_1.z, exponent_1);
    return metal::float3(_e3, _e5, _e7);
}

float exponential_of(
    float x_16
) {
    float _e3 = bounded(x_16 * LOG2_E);
    float _e4 = exp2_stable(_e3);
    return _e4;
}

float logarithm_of(
    float x_17
) {
    float _e1 = bounded(x_17);
    float _e4 = log_stable(metal::max(_e1, SMALLEST_NORMAL));
    return _e4;
}

float mixed(
    float a_2,
    float b_2,
    float t_1
) {
    float _e4 = bounded(b_2 - a_2);
    float _e14 = bounded((t_1 < 0.5) ? (a_2 + (t_1 * _e4)) : (b_2 - ((1.0 - t_1) * _e4)));
    return _e14;
}

metal::float2 mixed_vec2_(
    metal::float2 a_3,
    metal::float2 b_3,
    float t_2
) {
    metal::float2 _e4 = bounded_vec2_(b_3 - a_3);
    metal::float2 _e14 = bounded_vec2_((t_2 < 0.5) ? (a_3 + (t_2 * _e4)) : (b_3 - ((1.0 - t_2) * _e4)));
    return _e14;
}

metal::float3 mixed_vec3_(
    metal::float3 a_4,
    metal::float3 b_4,
    float t_3
) {
    metal::float3 _e4 = bounded_vec3_(b_4 - a_4);
    metal::float3 _e14 = bounded_vec3_((t_3 < 0.5) ? (a_4 + (t_3 * _e4)) : (b_4 - ((1.0 - t_3) * _e4)));
    return _e14;
}

metal::float4 mixed_vec4_(
    metal::float4 a_5,
    metal::float4 b_5,
    float t_4
) {
    metal::float4 _e4 = bounded_vec4_(b_5 - a_5);
    metal::float4 _e14 = bounded_vec4_((t_4 < 0.5) ? (a_5 + (t_4 * _e4)) : (b_5 - ((1.0 - t_4) * _e4)));
    return _e14;
}

float place_between(
    float x_18,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_18 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_18 - low) / _e12);
    return _e14;
}

float remapped(
    float x_19,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    float _e6 = bounded(x_19);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, clamped ? metal::clamp(_e9, 0.0, 1.0) : _e9);
    return _e16;
}

float eased(
    float x_20,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_20);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_6 = metal::clamp(_e6, 0.0, 1.0);
    return (t_6 * t_6) * (3.0 - (2.0 * t_6));
}

float factor_of(
    float x_21,
    bool clamped_1
) {
    float _e2 = bounded(x_21);
    float _e3 = bounded(x_21);
    return clamped_1 ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

float length_of(
    metal::float3 v_10
) {
    metal::float3 _e1 = bounded_vec3_(v_10);
    float largest_5 = metal::max(metal::max(metal::abs(_e1.x), metal::abs(_e1.y)), metal::abs(_e1.z));
    if (largest_5 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e17 = bounded(largest_5 * metal::length(_e1 / metal::float3(largest_5)));
    return _e17;
}

float sine_low(
    float r
) {
    float y_12 = r * r;
    float high_2 = metal::fma(y_12, 0.0000025930888, -0.00019803418);
    float s_7 = metal::fma(r * y_12, metal::fma(y_12, metal::fma(y_12, high_2, 0.008332972), -0.16666655), r);
    return metal::clamp(s_7, -1.0, 1.0);
}

float sine_turned(
    float r_1,
    float turns
) {
    float _e2 = sine_low(r_1);
    return _e2 * metal::fma(metal::fract(turns * 0.5), -4.0, 1.0);
}

float sine_of(
    float x_22
) {
    float _e1 = bounded(x_22);
    float turns_2 = metal::rint(_e1 * 0.31830987);
    float coarse_1 = metal::fma(turns_2, -0.00096702576, metal::fma(turns_2, -3.140625, _e1));
    float r_5 = metal::fma(turns_2, -0.00000062783295, coarse_1);
    float _e14 = sine_turned(metal::clamp(r_5, -1.6, 1.6), turns_2);
    return _e14;
}

float sine_near(
    float x_23
) {
    float turns_3 = metal::rint(x_23 * 0.31830987);
    float r_6 = metal::fma(turns_3, -0.0009676536, metal::fma(turns_3, -3.140625, x_23));
    float _e8 = sine_turned(r_6, turns_3);
    return _e8;
}

float cosine_of(
    float x_24
) {
    float _e1 = bounded(x_24);
    float turns_4 = metal::rint((_e1 * 0.31830987) - 0.5);
    float middle_1 = turns_4 + 0.5;
    float coarse_2 = metal::fma(middle_1, -0.00096702576, metal::fma(middle_1, -3.140625, _e1));
    float r_7 = metal::fma(middle_1, -0.00000062783295, coarse_2);
    float _e19 = sine_turned(-(metal::clamp(r_7, -1.6, 1.6)), turns_4);
    return _e19;
}

float cosine_near(
    float x_25
) {
    float turns_5 = metal::rint((x_25 * 0.31830987) - 0.5);
    float middle_2 = turns_5 + 0.5;
    float r_8 = metal::fma(middle_2, 0.0009676536, metal::fma(middle_2, 3.140625, -(x_25)));
    float _e13 = sine_turned(r_8, turns_5);
    return _e13;
}

float cosine_low(
    float r_2
) {
    float y_13 = r_2 * r_2;
    float high_3 = metal::fma(y_13, metal::fma(y_13, 0.0000000018474174, -0.00000027357322), 0.000024793637);
    return metal::fma(y_13, metal::fma(y_13, metal::fma(y_13, metal::fma(y_13, high_3, -0.0013888741), 0.041666657), -0.5), 1.0);
}

metal::float2 sin_cos_of(
    float x_26
) {
    float _e1 = bounded(x_26);
    metal::float2 _e2 = sin_cos(_e1);
    return metal::clamp(_e2, metal::float2(-1.0), metal::float2(1.0));
}

float angle_of_point(
    float y_5,
    float x_27
) {
    metal::float2 _e3 = bounded_vec2_(metal::float2(x_27, y_5));
    metal::float2 p_1 = metal::abs(_e3);
    metal::float2 scaled_1 = (metal::max(p_1.x, p_1.y) > 1.0) ? (0.5 * p_1) : p_1;
    float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_2 = (x_27 < 0.0) ? (PI - _e15) : _e15;
    return (y_5 < 0.0) ? -(turned_2) : turned_2;
}

float line_reach(
    float viewport_height,
    float steps_1
) {
    return metal::min(steps_1 * metal::max(metal::rint(viewport_height / 800.0), 1.0), 31.0);
}

metal::float4 own_nearness(
    metal::float4 nearness,
    metal::float2 middle,
    float depth_2,
    float object_1,
    float pixels,
    float reach
) {
    bool local_1 = {};
    bool local_2 = {};
    bool is_same_object = middle.y == (object_1 + 1.0);
    float behind = (depth_2 - middle.x) * pixels;
    if (!((middle.y == 0.0))) {
        if (is_same_object) {
            local_2 = metal::abs(behind) <= 8.0;
        } else {
            local_2 = false;
        }
        bool _e25 = local_2;
        local_1 = _e25;
    } else {
        local_1 = true;
    }
    bool is_own = local_1;
    bool is_in_front = behind < (is_same_object ? -8.0 : -2.0);
    metal::float4 other = metal::float4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

float line_pixels(
    float width,
    float pixels_1
) {
    float _e2 = bounded(width);
    float _e6 = bounded(pixels_1);
    return metal::clamp(_e2, 0.0, 1000000.0) * metal::clamp(_e6, 0.0, 1000000.0);
}

metal::float4 line_widths(
    float width_1,
    metal::float4 shares
) {
    metal::float4 _e4 = bounded_vec4_(shares);
    metal::float4 widths_1 = metal::min(width_1, 10000.0) * metal::clamp(_e4, metal::float4(0.0), metal::float4(100.0));
    return metal::select(metal::float4(0.0), widths_1, widths_1 > metal::float4(0.000001));
}

float inner_line_covers(
    float distance_1,
    float width_2
) {
    return metal::clamp((width_2 + 0.5) - distance_1, 0.0, metal::min(width_2, 1.0));
}

metal::float3 middle_line_covers(
    metal::float3 distance_2,
    metal::float3 width_3
) {
    metal::float3 half_1 = 0.5 * width_3;
    return metal::clamp(metal::min(distance_2 + metal::float3(0.5), half_1) - metal::max(distance_2 - metal::float3(0.5), -(half_1)), metal::float3(0.0), metal::float3(1.0));
}

metal::float4 lines_cover(
    metal::float4 nearness_1,
    metal::float4 widths,
    float reach_1
) {
    metal::float4 distance_4 = metal::float4(reach_1) - nearness_1;
    float _e7 = inner_line_covers(distance_4.x, widths.x);
    metal::float3 _e10 = middle_line_covers(distance_4.yzw, widths.yzw);
    metal::float4 covers = metal::float4(_e7, _e10);
    return metal::select(metal::float4(0.0), covers, nearness_1 > metal::float4(0.0));
}

bool is_same_surface(
    Plane own,
    metal::float4 texel_1,
    metal::float2 offset_1
) {
    bool local_3 = {};
    float error_1 = metal::abs((texel_1.z - own.depth) - metal::dot(own.rise, offset_1));
    float _e11 = object_in(texel_1.w);
    float _e13 = object_in(own.object);
    if (_e11 == _e13) {
        local_3 = error_1 <= ((3.0 * own.tolerance) * metal::max(metal::length(offset_1), 1.0));
    } else {
        local_3 = false;
    }
    bool _e26 = local_3;
    return _e26;
}

int naga_neg(int val) {
    return as_type<int>(-as_type<uint>(val));
}

metal::float4 nearest_in_column(
    metal::int2 pixel_2,
    Plane own_1,
    int reach_2,
    metal::texture2d<float, metal::access::sample> surface,
    metal::texture2d<float, metal::access::sample> edges_2
) {
    metal::float4 nearest = metal::float4(1000000000.0);
    metal::float4 codes_2 = metal::float4(0.0);
    int row = {};
    metal::int2 last_2 = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    row = metal::max(naga_neg(reach_2), naga_neg(pixel_2.y));
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e76 = row;
            row = as_type<int>(as_type<uint>(_e76) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e20 = row;
        if (_e20 <= metal::min(reach_2, as_type<int>(as_type<uint>(last_2.y) - as_type<uint>(pixel_2.y)))) {
        } else {
            break;
        }
        {
            int _e26 = row;
            metal::int2 at_1 = as_type<metal::int2>(as_type<metal::uint2>(pixel_2) + as_type<metal::uint2>(metal::int2(0, _e26)));
            metal::float4 found = edges_2.read(metal::uint2(at_1), 0);
            if (metal::all(found == metal::float4(0.0))) {
                continue;
            }
            metal::float4 _e39 = surface.read(metal::uint2(at_1), 0);
            int _e40 = row;
            bool _e44 = is_same_surface(own_1, _e39, metal::float2(0.0, static_cast<float>(_e40)));
            if (!(_e44)) {
                continue;
            }
            EdgeLines _e49 = edges_of(found, 4096.0);
            int _e52 = row;
            metal::float4 _e55 = middle_distances(_e49, metal::float4(0.0), metal::float4(static_cast<float>(_e52)));
            metal::float4 distances_1 = metal::select(metal::float4(1000000000.0), _e55, found > metal::float4(0.0));
            metal::float4 _e60 = nearest;
            metal::bool4 is_nearer = distances_1 < _e60;
            metal::float4 _e62 = nearest;
            nearest = metal::select(_e62, distances_1, is_nearer);
            metal::float4 _e64 = codes_2;
            metal::float4 _e65 = coarse_codes(found);
            int _e66 = row;
            codes_2 = metal::select(_e64, _e65 + metal::float4(262144.0 * (static_cast<float>(_e66) + 31.0)), is_nearer);
        }
    }
    metal::float4 _e78 = codes_2;
    return _e78;
}

struct vs_mainInput {
};
struct vs_mainOutput {
    metal::float4 member [[position]];
};
vertex vs_mainOutput vs_main(
  uint index [[vertex_id]]
) {
    metal::float4 _e1 = whole_picture(index);
    return vs_mainOutput { _e1 };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  metal::float4 position [[position]]
, metal::texture2d<float, metal::access::sample> surface [[texture(0)]]
, constant Curvature& curvature [[buffer(0)]]
, metal::texture2d<float, metal::access::sample> edges_2 [[texture(1)]]
) {
    metal::int2 pixel_4 = naga_f2i32(position.xy);
    SeenPixel _e3 = seen_pixel(pixel_4, surface, curvature);
    metal::float4 seen_1 = _e3.texel;
    if (_e3.texel.w == 0.0) {
        return fs_mainOutput { metal::float4(0.0) };
    }
    float _e12 = curvature.viewport_height;
    float _e14 = line_reach(_e12, 16.0);
    metal::float3 _e18 = normal_of(seen_1);
    Plane _e19 = plane_of(metal::abs(_e3.texel.w), _e3.texel.z, _e18, curvature);
    metal::float4 _e21 = nearest_in_column(pixel_4, _e19, naga_f2i32(_e14), surface, edges_2);
    return fs_mainOutput { _e21 };
}
