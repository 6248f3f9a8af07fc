// Clay: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// clay.json says what to put there and how to draw.
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
    Light window;
    Light table;
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
constant ProfileShape body_tone_shape = ProfileShape {0.9996875, 0.024997396, 1.0955735, 1.3436927, 0.05, 1.2296002, 0.5273893, 0u};
constant ProfileShape bounce_tone_shape = ProfileShape {0.99875027, 0.04997917, 1.7091175, 1.516349, 0.1, 0.70851815, 0.28734237, 0u};
constant ProfileShape soft_sheen_tone_shape = ProfileShape {0.9996875, 0.024997396, 2.1865644, 2.5171125, 0.05, 0.45394465, 0.19900247, 0u};

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
    float s_1 = x_1 * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 0.0000026347564))))))));
    float c = 1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (0.00002477458 - (y * 0.00000026297516)))))))));
    return metal::float2(s_1, c);
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
    float s_2 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_1);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
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
    float t_2 = metal::clamp(_e7, 0.0, 1.0);
    return (t_2 * t_2) * (3.0 - (2.0 * t_2));
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

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (tone * (color.xyz - below.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_1,
    float tone_1
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_1.xyz * light.color) * split.y, 1.0), tone_1 * split.x};
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

float profile_filtered_quick(
    Angle u_2,
    float w,
    ProfileShape shape_1
) {
    metal::float2 place = metal::float2((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset), (u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset));
    float _e19 = profile_soft_quick(place.x, shape_1);
    if (w < (0.1 * shape_1.edge_deviation)) {
        return _e19;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e45 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_1);
    float _e53 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_1);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_2
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
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
    float w_1
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
        float _e25 = eased(w_1 * _e21, 0.5, 1.0);
        float visible = 1.0 - _e25;
        octave = 0.5;
        if (visible > 0.0) {
            float _e31 = frequency;
            int _e33 = i_1;
            metal::float3 place_1 = metal::clamp((p_1 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place_1, 0u + static_cast<uint>(_e47));
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
    float _e70 = total;
    return metal::min(_e69 / _e70, 1.0);
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
    float shade_in_hollows_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.09, -20.0, 20.0))))));
    Color _e30 = curvature_color(shade_in_hollows_convexity, metal::float4(0.851, 0.5412, 0.4, 1.0), metal::float4(0.6902, 0.3765, 0.2902, 1.0));
    float _e36 = noise_perlin(surface.position_object, 2.6, 2, 0.4, 0);
    metal::float3 _e40 = bump_map(_e36, 0.05, surface.normal, surface.position);
    metal::float3 _e44 = look.window.direction;
    metal::float3 _e52 = look.window.direction;
    Angle body_angle = Angle {0.5 * metal::length(_e40 - _e44), 0.5 * metal::length(_e40 + _e52)};
    float body_warp = ((2.0 * shade_in_hollows_convexity) - 1.0) * 0.2;
    float _e65 = profile_balanced(body_angle, body_warp, body_tone_shape);
    Light _e68 = look.window;
    LitLayer _e69 = light_apply(_e68, _e30, _e65);
    Composite _e79 = blend_alpha(metal::float4(0.3529, 0.2, 0.1529, 1.0), _e69.color, _e69.tone, 1.0, true);
    Color _e87 = curvature_color(shade_in_hollows_convexity, metal::float4(1.0), metal::float4(0.7216, 0.4706, 0.4235, 1.0));
    Light _e90 = look.window;
    LitLayer _e92 = light_apply(_e90, _e87, 1.0);
    metal::float4 shade_in_hollows_blend = metal::clamp(metal::float4(_e79.xyz + (0.8 * ((_e79.xyz * (_e92.tone * _e92.color.xyz)) - _e79.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float soft_sheen_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.15, -20.0, 20.0))))));
    Color _e141 = curvature_color(soft_sheen_convexity, metal::float4(0.4157, 0.2353, 0.1804, 1.0), metal::float4(0.2902, 0.1412, 0.1216, 1.0));
    metal::float3 _e145 = look.table.direction;
    metal::float3 _e153 = look.table.direction;
    Angle bounce_angle = Angle {0.5 * metal::length(_e40 - _e145), 0.5 * metal::length(_e40 + _e153)};
    float bounce_warp = ((2.0 * soft_sheen_convexity) - 1.0) * 0.15;
    float _e166 = profile_balanced(bounce_angle, bounce_warp, bounce_tone_shape);
    Light _e169 = look.table;
    LitLayer _e170 = light_apply(_e169, _e141, _e166);
    metal::float4 bounce_blend = metal::clamp(metal::float4(shade_in_hollows_blend.xyz + (_e170.tone * _e170.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    Color _e194 = curvature_color(soft_sheen_convexity, metal::float4(0.302, 0.2039, 0.1686, 1.0), metal::float4(0.1647, 0.102, 0.0863, 1.0));
    Light _e197 = look.window;
    Angle _e199 = parametrization_specular_balanced(_e197, _e40, surface.view);
    float soft_sheen_warp = ((2.0 * soft_sheen_convexity) - 1.0) * 0.1;
    float _e207 = profile_balanced(_e199, soft_sheen_warp, soft_sheen_tone_shape);
    Light _e210 = look.window;
    LitLayer _e211 = light_apply(_e210, _e194, _e207);
    metal::float4 soft_sheen_blend = metal::clamp(metal::float4(bounce_blend.xyz + (_e211.tone * _e211.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return soft_sheen_blend;
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
