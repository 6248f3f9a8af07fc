// Stripes: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), image_1_ texture(0), image_1_sampler sampler(0).
// hcbtf-stripes.json says what to put there and how to draw.
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
    metal::float2 uv;
    char _pad3[8];
    metal::float3 tangent;
    metal::float3 bitangent;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct HcbtfGrid {
    metal::int2 size;
    metal::int2 light;
    metal::int2 view;
    bool has_levels;
    bool is_decoded;
    char _pad5[6];
};
struct HcbtfPlace {
    metal::int2 theta;
    metal::int2 phi;
    metal::float2 weight;
};
struct HcbtfViews {
    metal::int4 layer;
    metal::float4 weight;
};
struct HcbtfTexels {
    metal::int4 at;
    metal::float2 weight;
    metal::int2 origin;
};
struct HcbtfBlocks {
    metal::int2 left_top;
    metal::int2 right_top;
    metal::int2 left_bottom;
    metal::int2 right_bottom;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
    metal::float4 tangent;
    metal::float2 uv;
    char _pad4[8];
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
    metal::float4 tangent;
    metal::float2 uv;
    char _pad5[8];
};
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;

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
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return metal::float3(_e3, _e6, _e9);
}

metal::float4 finite_vec4_(
    metal::float4 v_1
) {
    metal::float3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return metal::float4(_e2, _e5);
}

metal::float3 normalize_or(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    bool local = {};
    float largest = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest > 0.000000000000000000000000000001) {
        local = largest < 1000000000000000000000000000000.0;
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    metal::float3 scaled = v_2 * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square));
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
    float t = small / large;
    bool is_wide = t > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y > x_2) ? (HALF_PI - a) : a;
}

float bounded(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float2 bounded_vec2_(
    metal::float2 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return metal::float2(_e2, _e4);
}

metal::float3 bounded_vec3_(
    metal::float3 v_4
) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float4 bounded_vec4_(
    metal::float4 v_5
) {
    float _e2 = bounded(v_5.x);
    float _e4 = bounded(v_5.y);
    float _e6 = bounded(v_5.z);
    float _e8 = bounded(v_5.w);
    return metal::float4(_e2, _e4, _e6, _e8);
}

float length_of(
    metal::float3 v_6
) {
    metal::float3 _e1 = bounded_vec3_(v_6);
    float largest_2 = metal::max(metal::max(metal::abs(_e1.x), metal::abs(_e1.y)), metal::abs(_e1.z));
    if (largest_2 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e17 = bounded(largest_2 * metal::length(_e1 / metal::float3(largest_2)));
    return _e17;
}

float angle_of_point(
    float y_1,
    float x_4
) {
    metal::float2 _e3 = bounded_vec2_(metal::float2(x_4, y_1));
    metal::float2 p = metal::abs(_e3);
    metal::float2 scaled_1 = (metal::max(p.x, p.y) > 1.0) ? (0.5 * p) : p;
    float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned = (x_4 < 0.0) ? (PI - _e15) : _e15;
    return (y_1 < 0.0) ? -(turned) : turned;
}

Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

Color linear_from_display(
    Color color_1
) {
    metal::float3 c = metal::max(color_1.xyz, metal::float3(0.0));
    metal::float3 low = c / metal::float3(12.92);
    metal::float3 high = metal::pow((c + metal::float3(0.055)) / metal::float3(1.055), metal::float3(2.4));
    return metal::float4(metal::select(high, low, c <= metal::float3(0.04045)), color_1.w);
}

metal::float3 any_orthogonal(
    metal::float3 n
) {
    float sign = (n.z >= 0.0) ? 1.0 : -1.0;
    float a_1 = -1.0 / (sign + n.z);
    return metal::float3(1.0 + (((sign * n.x) * n.x) * a_1), ((sign * n.x) * n.y) * a_1, -(sign) * n.x);
}

metal::float3x3 world_from_tangent(
    metal::float3 tangent,
    metal::float3 bitangent,
    metal::float3 normal
) {
    metal::float3 _e7 = normalize_or(normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e10 = normalize_or(tangent, metal::float3(0.0));
    metal::float3 leaning = _e10 - (metal::dot(_e10, _e7) * _e7);
    bool is_usable = metal::dot(leaning, leaning) > 0.00000001;
    metal::float3 _e17 = any_orthogonal(_e7);
    metal::float3 _e23 = normalize_or(is_usable ? leaning : _e17, metal::float3(1.0, 0.0, 0.0));
    metal::float3 _e31 = normalize_or(_e23 - (metal::dot(_e23, _e7) * _e7), metal::float3(1.0, 0.0, 0.0));
    metal::float3 b = metal::cross(_e7, _e31);
    return metal::float3x3(_e31, (metal::dot(b, bitangent) < 0.0) ? -(b) : b, _e7);
}

Color output(
    Composite color_2
) {
    Color _e1 = straight(color_2);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float footprint_of(
    float x_5
) {
    float _e1 = metal::dfdx(x_5);
    float _e2 = metal::dfdy(x_5);
    metal::float2 d = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
    return _e6;
}

float step_filtered(
    float x_6,
    float edge,
    float w
) {
    float _e4 = bounded(x_6 - edge);
    if (w < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

metal::int4 naga_f2i32(metal::float4 value) {
    return static_cast<metal::int4>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

HcbtfGrid hcbtf_grid(
    metal::texture2d_array<float, metal::access::sample> sheet
) {
    int last = as_type<int>(as_type<uint>(static_cast<int>(sheet.get_array_size())) - as_type<uint>(1));
    metal::float4 _e9 = sheet.read(metal::uint2(metal::int2(0, 0)), last, 0);
    metal::int4 first = naga_f2i32(metal::rint(255.0 * _e9));
    metal::float4 _e18 = sheet.read(metal::uint2(metal::int2(1, 0)), last, 0);
    metal::int4 second = naga_f2i32(metal::rint(255.0 * _e18));
    metal::int2 size_1 = metal::int2(as_type<int>(as_type<uint>(first.x) + as_type<uint>(as_type<int>(as_type<uint>(256) * as_type<uint>(naga_mod(first.z, 16))))), as_type<int>(as_type<uint>(first.y) + as_type<uint>(as_type<int>(as_type<uint>(256) * as_type<uint>(naga_div(first.z, 16))))));
    return HcbtfGrid {size_1, second.xy, second.zw, naga_mod(first.w, 2) == 1, naga_mod(naga_div(first.w, 2), 2) == 1};
}

metal::float3 hcbtf_local(
    metal::float3 direction,
    metal::float3x3 frame
) {
    metal::float3 _e3 = normalize_or(direction, frame[2]);
    metal::float3 _e9 = normalize_or(_e3 * frame, metal::float3(0.0, 0.0, 1.0));
    return _e9;
}

metal::float2 hcbtf_place(
    metal::float3 local_1,
    metal::int2 directions
) {
    float _e5 = length_of(metal::float3(local_1.xy, 0.0));
    float _e9 = angle_of_point(_e5, metal::max(local_1.z, 0.0));
    float _e12 = angle_of_point(local_1.x, local_1.y);
    float around = (_e5 > 0.000000000001) ? _e12 : 0.0;
    float steps = static_cast<float>(directions.y);
    float phi = around * (0.15915494 * steps);
    float turned_1 = (phi < 0.0) ? (phi + steps) : phi;
    float rings = static_cast<float>(as_type<int>(as_type<uint>(directions.x) - as_type<uint>(1)));
    return metal::float2(metal::clamp((_e9 * 0.63661975) * rings, 0.0, rings), (turned_1 >= steps) ? 0.0 : turned_1);
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

HcbtfPlace hcbtf_around(
    metal::float2 place,
    metal::int2 directions_1
) {
    metal::int2 low_1 = naga_f2i32(metal::floor(place));
    metal::int2 theta = metal::int2(low_1.x, metal::min(as_type<int>(as_type<uint>(low_1.x) + as_type<uint>(1)), as_type<int>(as_type<uint>(directions_1.x) - as_type<uint>(1))));
    metal::int2 phi_1 = metal::int2(low_1.y, naga_mod(as_type<int>(as_type<uint>(low_1.y) + as_type<uint>(1)), directions_1.y));
    return HcbtfPlace {theta, phi_1, place - metal::floor(place)};
}

HcbtfViews hcbtf_views(
    metal::float2 place_1,
    metal::int2 directions_2
) {
    HcbtfPlace _e2 = hcbtf_around(place_1, directions_2);
    metal::int4 layer_1 = as_type<metal::int4>(as_type<metal::uint4>(as_type<metal::int4>(as_type<metal::uint4>(metal::int4(_e2.theta.x, _e2.theta.y, _e2.theta.x, _e2.theta.y)) * as_type<uint>(directions_2.y))) + as_type<metal::uint4>(metal::int4(_e2.phi.x, _e2.phi.x, _e2.phi.y, _e2.phi.y)));
    metal::float2 w_1 = _e2.weight;
    metal::float4 weight_1 = metal::float4((1.0 - _e2.weight.x) * (1.0 - _e2.weight.y), _e2.weight.x * (1.0 - _e2.weight.y), (1.0 - _e2.weight.x) * _e2.weight.y, _e2.weight.x * _e2.weight.y);
    return HcbtfViews {layer_1, weight_1};
}

metal::int2 hcbtf_block(
    metal::int2 texel,
    metal::int2 light,
    metal::int2 origin
) {
    return as_type<metal::int2>(as_type<metal::uint2>(origin) + as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(texel) * as_type<metal::uint2>(metal::int2(light.x, as_type<int>(as_type<uint>(light.y) + as_type<uint>(2)))))));
}

metal::float4 hcbtf_add(
    metal::float4 sum,
    metal::float4 color_3,
    float weight
) {
    return sum + (metal::float4(color_3.xyz * color_3.w, color_3.w) * weight);
}

metal::float4 hcbtf_straight(
    metal::float4 sum_1
) {
    return (sum_1.w > 0.0) ? metal::float4(metal::clamp(sum_1.xyz / metal::float3(metal::max(sum_1.w, 0.00000000000000000001)), metal::float3(0.0), metal::float3(1.0)), metal::min(sum_1.w, 1.0)) : metal::float4(0.0);
}

metal::float4 hcbtf_lights(
    metal::texture2d_array<float, metal::access::sample> sheet_1,
    metal::int2 block,
    int layer,
    HcbtfPlace light_1
) {
    metal::float4 sum_2 = metal::float4(0.0);
    metal::float2 w_2 = light_1.weight;
    metal::float4 _e8 = sum_2;
    metal::float4 _e18 = sheet_1.read(metal::uint2(as_type<metal::int2>(as_type<metal::uint2>(block) + as_type<metal::uint2>(metal::int2(light_1.theta.x, as_type<int>(as_type<uint>(light_1.phi.x) + as_type<uint>(1)))))), layer, 0);
    metal::float4 _e26 = hcbtf_add(_e8, _e18, (1.0 - light_1.weight.x) * (1.0 - light_1.weight.y));
    sum_2 = _e26;
    metal::float4 _e27 = sum_2;
    metal::float4 _e37 = sheet_1.read(metal::uint2(as_type<metal::int2>(as_type<metal::uint2>(block) + as_type<metal::uint2>(metal::int2(light_1.theta.y, as_type<int>(as_type<uint>(light_1.phi.x) + as_type<uint>(1)))))), layer, 0);
    metal::float4 _e43 = hcbtf_add(_e27, _e37, light_1.weight.x * (1.0 - light_1.weight.y));
    sum_2 = _e43;
    metal::float4 _e44 = sum_2;
    metal::float4 _e54 = sheet_1.read(metal::uint2(as_type<metal::int2>(as_type<metal::uint2>(block) + as_type<metal::uint2>(metal::int2(light_1.theta.x, as_type<int>(as_type<uint>(light_1.phi.y) + as_type<uint>(1)))))), layer, 0);
    metal::float4 _e60 = hcbtf_add(_e44, _e54, (1.0 - light_1.weight.x) * light_1.weight.y);
    sum_2 = _e60;
    metal::float4 _e61 = sum_2;
    metal::float4 _e71 = sheet_1.read(metal::uint2(as_type<metal::int2>(as_type<metal::uint2>(block) + as_type<metal::uint2>(metal::int2(light_1.theta.y, as_type<int>(as_type<uint>(light_1.phi.y) + as_type<uint>(1)))))), layer, 0);
    metal::float4 _e75 = hcbtf_add(_e61, _e71, light_1.weight.x * light_1.weight.y);
    return _e75;
}

metal::float4 hcbtf_sixteen(
    metal::texture2d_array<float, metal::access::sample> sheet_2,
    metal::int2 block_1,
    HcbtfPlace light_2,
    HcbtfViews views
) {
    metal::float4 _e8 = hcbtf_lights(sheet_2, block_1, views.layer.x, light_2);
    metal::float4 _e14 = hcbtf_lights(sheet_2, block_1, views.layer.y, light_2);
    metal::float4 _e21 = hcbtf_lights(sheet_2, block_1, views.layer.z, light_2);
    metal::float4 _e28 = hcbtf_lights(sheet_2, block_1, views.layer.w, light_2);
    return (((views.weight.x * _e8) + (views.weight.y * _e14)) + (views.weight.z * _e21)) + (views.weight.w * _e28);
}

HcbtfBlocks hcbtf_blocks(
    HcbtfTexels texels,
    metal::int2 light_3
) {
    metal::int4 at = texels.at;
    metal::int2 _e5 = hcbtf_block(at.xy, light_3, texels.origin);
    metal::int2 _e8 = hcbtf_block(at.zy, light_3, texels.origin);
    metal::int2 _e11 = hcbtf_block(at.xw, light_3, texels.origin);
    metal::int2 _e14 = hcbtf_block(at.zw, light_3, texels.origin);
    return HcbtfBlocks {_e5, _e8, _e11, _e14};
}

metal::int2 naga_div(metal::int2 lhs, metal::int2 rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

metal::int2 naga_mod(metal::int2 lhs, metal::int2 rhs) {
    metal::int2 divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

HcbtfTexels hcbtf_texels(
    metal::float2 uv,
    HcbtfGrid grid,
    int level
) {
    metal::int2 size = {};
    metal::int2 origin_1 = metal::int2(0);
    int i = 0;
    size = grid.size;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e41 = i;
            i = as_type<int>(as_type<uint>(_e41) + as_type<uint>(1));
        }
        loop_init = false;
        int _e10 = i;
        if (_e10 < level) {
        } else {
            break;
        }
        {
            int _e18 = origin_1.y;
            int _e20 = size.y;
            int _e27 = i;
            origin_1 = metal::int2(as_type<int>(as_type<uint>(grid.size.x) * as_type<uint>(grid.light.x)), (_e27 == 0) ? 0 : as_type<int>(as_type<uint>(_e18) + as_type<uint>(as_type<int>(as_type<uint>(_e20) * as_type<uint>(as_type<int>(as_type<uint>(grid.light.y) + as_type<uint>(2)))))));
            metal::int2 _e33 = size;
            size = metal::max(naga_div(_e33, metal::int2(2)), metal::int2(1));
        }
    }
    metal::float2 _e47 = bounded_vec2_(metal::float2(uv.x, -(uv.y)));
    metal::int2 _e50 = size;
    metal::float2 place_2 = ((_e47 - metal::floor(_e47)) * static_cast<metal::float2>(_e50)) - metal::float2(0.5);
    metal::int2 low_2 = naga_f2i32(metal::floor(place_2));
    metal::int2 _e58 = size;
    metal::int2 _e60 = size;
    metal::int2 first_1 = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(low_2) + as_type<metal::uint2>(_e58)), _e60);
    metal::int2 _e65 = size;
    metal::int2 _e70 = origin_1;
    return HcbtfTexels {metal::int4(first_1, naga_mod(as_type<metal::int2>(as_type<metal::uint2>(first_1) + as_type<metal::uint2>(metal::int2(1))), _e65)), place_2 - metal::floor(place_2), _e70};
}

metal::float4 hcbtf_sixteen_at(
    metal::texture2d_array<float, metal::access::sample> sheet_3,
    metal::float2 uv_1,
    HcbtfGrid grid_1,
    int level_1,
    HcbtfPlace light_4,
    HcbtfViews views_1
) {
    HcbtfTexels _e6 = hcbtf_texels(uv_1, grid_1, level_1);
    metal::float2 w_3 = _e6.weight;
    HcbtfBlocks _e9 = hcbtf_blocks(_e6, grid_1.light);
    metal::float4 _e18 = hcbtf_sixteen(sheet_3, _e9.left_top, light_4, views_1);
    metal::float4 _e26 = hcbtf_sixteen(sheet_3, _e9.right_top, light_4, views_1);
    metal::float4 _e35 = hcbtf_sixteen(sheet_3, _e9.left_bottom, light_4, views_1);
    metal::float4 _e42 = hcbtf_sixteen(sheet_3, _e9.right_bottom, light_4, views_1);
    return (((((1.0 - _e6.weight.x) * (1.0 - _e6.weight.y)) * _e18) + ((_e6.weight.x * (1.0 - _e6.weight.y)) * _e26)) + (((1.0 - _e6.weight.x) * _e6.weight.y) * _e35)) + ((_e6.weight.x * _e6.weight.y) * _e42);
}

float hcbtf_level(
    metal::float2 uv_2,
    HcbtfGrid grid_2
) {
    metal::float2 _e2 = metal::dfdx(uv_2);
    metal::float2 _e6 = bounded_vec2_(_e2 * static_cast<metal::float2>(grid_2.size));
    metal::float2 _e7 = metal::dfdy(uv_2);
    metal::float2 _e11 = bounded_vec2_(_e7 * static_cast<metal::float2>(grid_2.size));
    float widest = metal::clamp(metal::max(metal::dot(_e6, _e6), metal::dot(_e11, _e11)), 1.0, 1000000000.0);
    int side = metal::max(grid_2.size.x, grid_2.size.y);
    float last_1 = metal::floor(metal::log2(static_cast<float>(side)) + 0.0001);
    return grid_2.has_levels ? metal::min(0.5 * metal::log2(widest), last_1) : 0.0;
}

float hcbtf_horizon(
    metal::float3 light_5,
    metal::float3x3 frame_1
) {
    metal::float3 _e3 = normalize_or(light_5, frame_1[2]);
    float height = metal::dot(_e3, frame_1[2]);
    float _e7 = footprint_of(height);
    float _e8 = step_filtered(height, 0.0, _e7);
    return _e8;
}

metal::float4 hcbtf_finished(
    metal::float4 lit,
    float above,
    metal::float4 unlit,
    HcbtfGrid grid_3
) {
    Color _e4 = linear_from_display(lit);
    Color painted = grid_3.is_decoded ? _e4 : lit;
    metal::float4 _e7 = bounded_vec4_(unlit);
    return metal::mix(_e7, painted, above);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

Color hcbtf_lookup_smooth(
    metal::texture2d_array<float, metal::access::sample> sheet_4,
    metal::sampler sheet_sampler,
    Light light_6,
    metal::float2 uv_3,
    metal::float2 scale,
    Color unlit_1,
    metal::float3 normal_1,
    metal::float3 view,
    metal::float3 tangent_1,
    metal::float3 bitangent_1
) {
    metal::float4 sum_3 = {};
    HcbtfGrid _e10 = hcbtf_grid(sheet_4);
    metal::float3x3 _e11 = world_from_tangent(tangent_1, bitangent_1, normal_1);
    metal::float2 _e13 = bounded_vec2_(uv_3 * scale);
    float _e14 = hcbtf_level(_e13, _e10);
    float _e16 = hcbtf_horizon(light_6.direction, _e11);
    metal::float3 _e18 = hcbtf_local(light_6.direction, _e11);
    metal::float2 _e20 = hcbtf_place(_e18, _e10.light);
    HcbtfPlace _e22 = hcbtf_around(_e20, _e10.light);
    metal::float3 _e23 = hcbtf_local(view, _e11);
    metal::float2 _e25 = hcbtf_place(_e23, _e10.view);
    HcbtfViews _e27 = hcbtf_views(_e25, _e10.view);
    int finer = naga_f2i32(_e14);
    metal::float4 _e29 = hcbtf_sixteen_at(sheet_4, _e13, _e10, finer, _e22, _e27);
    sum_3 = _e29;
    if (_e14 > static_cast<float>(finer)) {
        metal::float4 _e33 = sum_3;
        metal::float4 _e36 = hcbtf_sixteen_at(sheet_4, _e13, _e10, as_type<int>(as_type<uint>(finer) + as_type<uint>(1)), _e22, _e27);
        sum_3 = metal::mix(_e33, _e36, _e14 - static_cast<float>(finer));
    }
    metal::float4 _e40 = sum_3;
    metal::float4 _e41 = hcbtf_straight(_e40);
    metal::float4 _e42 = hcbtf_finished(_e41, _e16, unlit_1, _e10);
    return _e42;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look,
    metal::texture2d_array<float, metal::access::sample> image_1_,
    metal::sampler image_1_sampler
) {
    Light _e5 = look.key;
    Color _e18 = hcbtf_lookup_smooth(image_1_, image_1_sampler, _e5, surface_1.uv, metal::float2(6.0), metal::float4(0.07, 0.04, 0.11, 1.0), surface_1.normal, surface_1.view, surface_1.tangent, surface_1.bitangent);
    Composite _e19 = premultiplied(_e18);
    Color _e20 = output(_e19);
    return _e20;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
    metal::float4 tangent_2 [[attribute(2)]];
    metal::float2 uv_4 [[attribute(3)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
    metal::float4 tangent [[user(loc2), center_perspective]];
    metal::float2 uv [[user(loc3), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_2, varyings.tangent_2, varyings.uv_4 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_1.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    metal::float4x4 _e25 = object.world_from_object;
    metal::float3x3 _e39 = object.world_from_normal;
    out.tangent = metal::float4((_e25 * metal::float4(vertex_.tangent.xyz, 0.0)).xyz, (metal::determinant(_e39) < 0.0) ? -(vertex_.tangent.w) : vertex_.tangent.w);
    out.uv = vertex_.uv;
    Varyings _e47 = out;
    const auto _tmp = _e47;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal, _tmp.tangent, _tmp.uv };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_2 [[user(loc1), center_perspective]];
    metal::float4 tangent_2 [[user(loc2), center_perspective]];
    metal::float2 uv_4 [[user(loc3), center_perspective]];
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
, metal::texture2d_array<float, metal::access::sample> image_1_ [[texture(0)]]
, metal::sampler image_1_sampler [[sampler(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2, varyings_1.tangent_2, varyings_1.uv_4 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_2 = is_front ? _e7 : -(_e7);
    surface.normal = normal_2;
    metal::float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    metal::float4 _e26 = view_1.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    surface.uv = in.uv;
    metal::float3 _e46 = normalize_or(in.tangent.xyz - (normal_2 * metal::dot(normal_2, in.tangent.xyz)), in.tangent.xyz);
    surface.tangent = _e46;
    metal::float3 _e57 = normalize_or(in.tangent.xyz - (normal_2 * metal::dot(normal_2, in.tangent.xyz)), in.tangent.xyz);
    surface.bitangent = metal::cross(normal_2, _e57) * in.tangent.w;
    Surface _e62 = surface;
    metal::float4 _e63 = shade(_e62, look, image_1_, image_1_sampler);
    metal::float4 _e64 = finite_vec4_(_e63);
    return fs_mainOutput { _e64 };
}
