// Ten lights, each with its own edge: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// lights-apart.json says what to put there and how to draw.
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
constant ProfileShape lamps_moon_tone_shape = ProfileShape {0.9358968, 0.35227424, 66.66917, 2.499803, 0.72, 0.014726315, 0.0063439487, 0u};

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
    float s_2 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, u_1.half_cos);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Color limit_color(
    Color color,
    float limit,
    float softness
) {
    metal::float3 c = metal::clamp(color.xyz, metal::float3(-1000000000000000000.0), metal::float3(1000000000000000000.0));
    float knee = 1.0 - softness;
    float brightest = metal::max(metal::max(c.x, c.y), c.z);
    if (brightest <= knee) {
        return metal::float4(c, 2.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + (metal::min(above, room) * (metal::max(above, room) / (above + room)));
    return metal::float4(c * metal::min(pressed / brightest, 1.0), 2.0);
}

Angle parametrization_diffuse_balanced(
    Light light,
    metal::float3 normal
) {
    return Angle {0.5 * metal::length(normal - light.direction), 0.5 * metal::length(normal + light.direction)};
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
    metal::float2 place = metal::float2((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset), (u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset));
    bool is_narrow = (w_1 > 0.0) & (w_1 >= (3.4641016 * shape_2.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place.x, w_1, shape_2);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_2);
    if (w_1 < (0.1 * shape_2.edge_deviation)) {
        return _e30;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e56 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_2);
    float _e64 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_2);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_3
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
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
    Color dark = _e203 + metal::float4(0.07, 0.05, 0.1, 1.0);
    Color _e212 = limit_color(dark, 1.0, 0.4);
    return metal::float4(_e212.xyz, 1.0);
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
