// Ten lights, one edge after the sum: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// lights-summed.json says what to put there and how to draw.
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
    Light moon;
    float moon_intensity;
    char _pad2[12];
    Light violet;
    float violet_intensity;
    char _pad4[12];
    Light rose;
    float rose_intensity;
    char _pad6[12];
    Light amber;
    float amber_intensity;
    char _pad8[12];
    Light gold;
    float gold_intensity;
    char _pad10[12];
    Light coral;
    float coral_intensity;
    char _pad12[12];
    Light magenta;
    float magenta_intensity;
    char _pad14[12];
    Light cobalt;
    float cobalt_intensity;
    char _pad16[12];
    Light turquoise;
    float turquoise_intensity;
    char _pad18[12];
    Light azure;
    float azure_intensity;
    char _pad20[12];
    metal::float4 lamps_moon_strength;
    metal::float4 lamps_violet_strength;
    metal::float4 lamps_rose_strength;
    metal::float4 lamps_amber_strength;
    metal::float4 lamps_gold_strength;
    metal::float4 lamps_coral_strength;
    metal::float4 lamps_magenta_strength;
    metal::float4 lamps_cobalt_strength;
    metal::float4 lamps_turquoise_strength;
    metal::float4 lamps_azure_strength;
};
struct Surface {
    metal::float3 normal;
};
typedef metal::float4 Color;
struct Angle {
    float half_sin;
    float half_cos;
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
    metal::float3 normal;
};
constant ProfileShape lamps_moon_tone_shape = ProfileShape {1.0, 0.0, 1.6002629, 1.8073579, 0.0, 0.71386534, 0.30130044, 0u};

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
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
    float s_1 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_1, u_1.half_cos);
    metal::float2 turned = ((s_1 <= 0.0) & (s_1 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float footprint_of(
    float x
) {
    float _e1 = metal::dfdx(x);
    float _e2 = metal::dfdy(x);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float stairs_integral(
    float x_1,
    float count
) {
    float inside = metal::min(x_1, count);
    float stair = metal::min(metal::floor(inside), 5.0);
    float beyond = metal::max(x_1 - count, 0.0);
    return (stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * 5.0);
}

float stairs_integral_2_(
    float x_2,
    float count_1
) {
    float inside_1 = metal::max(x_2, 0.0);
    float stair_1 = metal::floor(inside_1);
    return (stair_1 * (((0.5 * (stair_1 - 1.0)) + inside_1) - stair_1)) + 0.0;
}

float stairs_filtered(
    float x_3,
    float count_2,
    float w
) {
    if (w <= 1.0) {
        float edge = metal::clamp(metal::rint(x_3), 1.0, 5.0);
        return (edge - 1.0) + metal::clamp(0.5 + ((x_3 - edge) / w), 0.0, 1.0);
    }
    float half_1 = 0.5 * w;
    float _e22 = stairs_integral(x_3 + half_1, count_2);
    float _e24 = stairs_integral_2_(x_3 - half_1, count_2);
    return (_e22 - _e24) / (2.0 * half_1);
}

float linear_of_srgb(
    float coded
) {
    float size = metal::abs(coded);
    float value_1 = (size <= 0.04045) ? (size / 12.92) : metal::pow((size + 0.055) / 1.055, 2.4);
    return value_1;
}

float srgb_of_linear(
    float light
) {
    float size_1 = metal::abs(light);
    float value_2 = (size_1 <= 0.0031308) ? (size_1 * 12.92) : ((1.055 * metal::pow(size_1, 0.41666666)) - 0.055);
    return (light < 0.0) ? -(value_2) : value_2;
}

metal::float3 oklab_of_linear(
    metal::float3 rgb
) {
    float l = metal::pow(metal::abs(metal::dot(rgb, metal::float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    float m = metal::pow(metal::abs(metal::dot(rgb, metal::float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    float s_2 = metal::pow(metal::abs(metal::dot(rgb, metal::float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return metal::float3(((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s_2), ((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s_2), ((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s_2));
}

metal::float3 linear_of_oklab(
    metal::float3 lab
) {
    float l_1 = (lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z);
    float m_1 = (lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z);
    float s_3 = (lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z);
    metal::float3 cubes = metal::float3((l_1 * l_1) * l_1, (m_1 * m_1) * m_1, (s_3 * s_3) * s_3);
    return metal::float3(metal::dot(cubes, metal::float3(4.0767417, -3.3077116, 0.23096994)), metal::dot(cubes, metal::float3(-1.268438, 2.6097574, -0.34131938)), metal::dot(cubes, metal::float3(-0.0041960864, -0.7034186, 1.7076147)));
}

metal::float3 srgb_of_oklab(
    metal::float3 lab_1
) {
    metal::float3 _e1 = linear_of_oklab(lab_1);
    float _e3 = srgb_of_linear(_e1.x);
    float _e5 = srgb_of_linear(_e1.y);
    float _e7 = srgb_of_linear(_e1.z);
    return metal::float3(_e3, _e5, _e7);
}

Color limit_color(
    Color color,
    float limit,
    float softness
) {
    float knee = 1.0 - softness;
    float brightest = metal::max(metal::max(color.x, color.y), color.z);
    if (brightest <= knee) {
        return metal::float4(color.xyz, 2.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + (metal::min(above, room) * (metal::max(above, room) / (above + room)));
    return metal::float4(color.xyz * metal::min(pressed / brightest, 1.0), 2.0);
}

Color posterize_lightness(
    Color color_1,
    int steps,
    float softness_1
) {
    metal::float3 coded_1 = metal::clamp(color_1.xyz, metal::float3(0.0), metal::float3(1.0));
    float _e10 = linear_of_srgb(coded_1.x);
    float _e12 = linear_of_srgb(coded_1.y);
    float _e14 = linear_of_srgb(coded_1.z);
    metal::float3 _e16 = oklab_of_linear(metal::float3(_e10, _e12, _e14));
    float _e25 = footprint_of(_e16.x);
    float _e30 = stairs_filtered(6.0 * metal::clamp(_e16.x, 0.0, 1.0), 6.0, metal::length(metal::float2(6.0 * _e25, softness_1)));
    float stepped = metal::clamp(_e30 / 5.0, 0.0, 1.0);
    float kept = (_e16.x > 0.0001) ? (stepped / metal::max(_e16.x, 0.0001)) : 0.0;
    metal::float3 _e50 = srgb_of_oklab(metal::float3(stepped, _e16.yz * metal::min(kept, 1.0)));
    return metal::float4(metal::clamp(_e50, metal::float3(0.0), metal::float3(1.0)), 2.0);
}

Angle parametrization_diffuse_balanced(
    Light light_1,
    metal::float3 normal
) {
    return Angle {0.5 * metal::length(normal - light_1.direction), 0.5 * metal::length(normal + light_1.direction)};
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
    float w_1,
    ProfileShape shape_1
) {
    metal::float2 place = metal::float2(u_2.half_sin - 0.0, u_2.half_cos);
    float _e9 = profile_soft_quick(place.x, shape_1);
    if (w_1 < (0.1 * shape_1.edge_deviation)) {
        return _e9;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e35 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_1);
    float _e43 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_1);
    return (((5.0 * _e35) + (8.0 * _e9)) + (5.0 * _e43)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_2
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

Color sum_of_lights_color(
    Color value,
    Color before_sum,
    float reach
) {
    return (reach > 0.0) ? metal::float4(before_sum.xyz + value.xyz, 1.0) : before_sum;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light _e3 = look.moon;
    Angle _e5 = parametrization_diffuse_balanced(_e3, surface.normal);
    float _e8 = profile_balanced(_e5, 0.0, lamps_moon_tone_shape);
    metal::float4 _e11 = look.lamps_moon_strength;
    metal::float4 lamps_moon_lit = _e11 * metal::float4(metal::float3(_e8), 1.0);
    Light _e18 = look.violet;
    Angle _e20 = parametrization_diffuse_balanced(_e18, surface.normal);
    float _e23 = profile_balanced(_e20, 0.0, lamps_moon_tone_shape);
    metal::float4 _e26 = look.lamps_violet_strength;
    metal::float4 lamps_violet_lit = _e26 * metal::float4(metal::float3(_e23), 1.0);
    Light _e33 = look.rose;
    Angle _e35 = parametrization_diffuse_balanced(_e33, surface.normal);
    float _e38 = profile_balanced(_e35, 0.0, lamps_moon_tone_shape);
    metal::float4 _e41 = look.lamps_rose_strength;
    metal::float4 lamps_rose_lit = _e41 * metal::float4(metal::float3(_e38), 1.0);
    Light _e48 = look.amber;
    Angle _e50 = parametrization_diffuse_balanced(_e48, surface.normal);
    float _e53 = profile_balanced(_e50, 0.0, lamps_moon_tone_shape);
    metal::float4 _e56 = look.lamps_amber_strength;
    metal::float4 lamps_amber_lit = _e56 * metal::float4(metal::float3(_e53), 1.0);
    Light _e63 = look.gold;
    Angle _e65 = parametrization_diffuse_balanced(_e63, surface.normal);
    float _e68 = profile_balanced(_e65, 0.0, lamps_moon_tone_shape);
    metal::float4 _e71 = look.lamps_gold_strength;
    metal::float4 lamps_gold_lit = _e71 * metal::float4(metal::float3(_e68), 1.0);
    Light _e78 = look.coral;
    Angle _e80 = parametrization_diffuse_balanced(_e78, surface.normal);
    float _e83 = profile_balanced(_e80, 0.0, lamps_moon_tone_shape);
    metal::float4 _e86 = look.lamps_coral_strength;
    metal::float4 lamps_coral_lit = _e86 * metal::float4(metal::float3(_e83), 1.0);
    Light _e93 = look.magenta;
    Angle _e95 = parametrization_diffuse_balanced(_e93, surface.normal);
    float _e98 = profile_balanced(_e95, 0.0, lamps_moon_tone_shape);
    metal::float4 _e101 = look.lamps_magenta_strength;
    metal::float4 lamps_magenta_lit = _e101 * metal::float4(metal::float3(_e98), 1.0);
    Light _e108 = look.cobalt;
    Angle _e110 = parametrization_diffuse_balanced(_e108, surface.normal);
    float _e113 = profile_balanced(_e110, 0.0, lamps_moon_tone_shape);
    metal::float4 _e116 = look.lamps_cobalt_strength;
    metal::float4 lamps_cobalt_lit = _e116 * metal::float4(metal::float3(_e113), 1.0);
    Light _e123 = look.turquoise;
    Angle _e125 = parametrization_diffuse_balanced(_e123, surface.normal);
    float _e128 = profile_balanced(_e125, 0.0, lamps_moon_tone_shape);
    metal::float4 _e131 = look.lamps_turquoise_strength;
    metal::float4 lamps_turquoise_lit = _e131 * metal::float4(metal::float3(_e128), 1.0);
    Light _e138 = look.azure;
    Angle _e140 = parametrization_diffuse_balanced(_e138, surface.normal);
    float _e143 = profile_balanced(_e140, 0.0, lamps_moon_tone_shape);
    metal::float4 _e146 = look.lamps_azure_strength;
    metal::float4 lamps_azure_lit = _e146 * metal::float4(metal::float3(_e143), 1.0);
    float _e164 = look.azure_intensity;
    metal::float4 lamps_azure_sum = (_e164 > 0.0) ? metal::float4(metal::float3(0.0) + lamps_azure_lit.xyz, 1.0) : metal::float4(0.0, 0.0, 0.0, 1.0);
    float _e170 = look.turquoise_intensity;
    Color _e171 = sum_of_lights_color(lamps_turquoise_lit, lamps_azure_sum, _e170);
    float _e174 = look.cobalt_intensity;
    Color _e175 = sum_of_lights_color(lamps_cobalt_lit, _e171, _e174);
    float _e178 = look.magenta_intensity;
    Color _e179 = sum_of_lights_color(lamps_magenta_lit, _e175, _e178);
    float _e182 = look.coral_intensity;
    Color _e183 = sum_of_lights_color(lamps_coral_lit, _e179, _e182);
    float _e186 = look.gold_intensity;
    Color _e187 = sum_of_lights_color(lamps_gold_lit, _e183, _e186);
    float _e190 = look.amber_intensity;
    Color _e191 = sum_of_lights_color(lamps_amber_lit, _e187, _e190);
    float _e194 = look.rose_intensity;
    Color _e195 = sum_of_lights_color(lamps_rose_lit, _e191, _e194);
    float _e198 = look.violet_intensity;
    Color _e199 = sum_of_lights_color(lamps_violet_lit, _e195, _e198);
    float _e202 = look.moon_intensity;
    Color _e203 = sum_of_lights_color(lamps_moon_lit, _e199, _e202);
    Color dark = (_e203 * metal::float4(0.44, 0.44, 0.44, 1.0)) + metal::float4(0.07, 0.05, 0.1, 1.0);
    Color _e218 = posterize_lightness(dark, 6, 0.04);
    Color _e221 = limit_color(_e218, 1.0, 0.4);
    return metal::float4(_e221.xyz, 1.0);
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 normal [[user(loc0), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e14 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, _e14 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 normal_1 [[user(loc0), center_perspective]];
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
    const Varyings in = { clip, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    Surface surface_1 = Surface {normal_1};
    metal::float4 _e7 = shade(surface_1, look);
    return fs_mainOutput { _e7 };
}
