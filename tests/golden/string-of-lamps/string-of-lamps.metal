// A string of lamps: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// string-of-lamps.json says what to put there and how to draw.
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
struct EachLight {
    metal::float3x3 own_from_world;
    metal::packed_float3 color;
    float intensity;
    metal::float3 position;
    metal::float2 fading;
    char _pad5[8];
};
struct Light {
    metal::float3 direction;
    metal::float3 own_direction;
    metal::packed_float3 color;
    float intensity;
};
struct type_6 {
    EachLight inner[36];
};
struct Look {
    Light moon;
    type_6 lights;
};
struct Surface {
    metal::float3 normal;
    metal::float3 position;
};
typedef metal::float4 Color;
struct Angle {
    float half_sin;
    float half_cos;
};
struct LightParts {
    metal::float3 direction;
    Color color;
    float intensity;
    char _pad3[12];
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
    metal::float3 normal;
};
constant ProfileShape lamps_tone_shape = ProfileShape {0.90044713, 0.43496552, 10.016686, 2.4912605, 0.9, 0.09820393, 0.042312488, 0u};
constant ProfileShape moon_tone_shape = ProfileShape {0.90044713, 0.43496552, 2.9163208, 3.0838382, 0.9, 0.3121117, 0.13987324, 0u};

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
    float _e7 = bounded((_e3 - low) / (high - low));
    float t_1 = metal::clamp(_e7, 0.0, 1.0);
    return (t_1 * t_1) * (3.0 - (2.0 * t_1));
}

float srgb_of_linear(
    float light
) {
    float size = metal::abs(light);
    float value = (size <= 0.0031308) ? (size * 12.92) : ((1.055 * metal::pow(size, 0.41666666)) - 0.055);
    return (light < 0.0) ? -(value) : value;
}

metal::float3 oklab_of_linear(
    metal::float3 rgb
) {
    float l = metal::pow(metal::dot(rgb, metal::float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = metal::pow(metal::dot(rgb, metal::float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s_3 = metal::pow(metal::dot(rgb, metal::float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return metal::float3(((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s_3), ((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s_3), ((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s_3));
}

metal::float3 linear_of_oklab(
    metal::float3 lab
) {
    float l_1 = (lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z);
    float m_1 = (lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z);
    float s_4 = (lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z);
    metal::float3 cubes = metal::float3((l_1 * l_1) * l_1, (m_1 * m_1) * m_1, (s_4 * s_4) * s_4);
    return metal::float3(metal::dot(cubes, metal::float3(4.0767417, -3.3077116, 0.23096994)), metal::dot(cubes, metal::float3(-1.268438, 2.6097574, -0.34131938)), metal::dot(cubes, metal::float3(-0.0041960864, -0.7034186, 1.7076147)));
}

metal::float3 oklab_of_srgb(
    metal::float3 coded
) {
    metal::float3 _e23 = oklab_of_linear(metal::float3(metal::pow((coded.x + 0.055) / 1.055, 2.4), metal::pow((coded.y + 0.055) / 1.055, 2.4), metal::pow((coded.z + 0.055) / 1.055, 2.4)));
    return _e23;
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
        return metal::float4(color.xyz, 1.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + (metal::min(above, room) * (metal::max(above, room) / (above + room)));
    return metal::float4(color.xyz * metal::min(pressed / brightest, 1.0), 1.0);
}

Color mix_evenly_oklab(
    Color a,
    Color b,
    float factor
) {
    metal::float3 _e4 = oklab_of_srgb(a.xyz);
    metal::float3 _e6 = oklab_of_srgb(b.xyz);
    metal::float3 _e8 = srgb_of_oklab(metal::mix(_e4, _e6, factor));
    return (factor <= 0.0) ? a : ((factor >= 1.0) ? b : metal::float4(_e8, 1.0));
}

float light_fading(
    float distance,
    metal::float2 fading
) {
    float left = 1.0;
    if (fading.x > 0.0) {
        float d = metal::min(distance / fading.x, 1000000000000000.0);
        left = 1.0 / (1.0 + (d * d));
    }
    if (fading.y > 0.0) {
        float d_1 = metal::min(distance / fading.y, 1.0);
        float window = metal::max(1.0 - (((d_1 * d_1) * d_1) * d_1), 0.0);
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

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float4 lamps_brightest = metal::float4(0.0, 0.0, 0.0, 1.0);
    uint each = 0u;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e96 = each;
            each = _e96 + 1u;
        }
        loop_init = false;
        uint _e9 = each;
        if (_e9 < 36u) {
        } else {
            break;
        }
        {
            uint _e14 = each;
            metal::float3 _e17 = look.lights.inner[_e14].position;
            uint _e20 = each;
            metal::float3x3 _e23 = look.lights.inner[_e20].own_from_world;
            uint _e26 = each;
            metal::float3 _e29 = look.lights.inner[_e26].color;
            uint _e32 = each;
            float _e35 = look.lights.inner[_e32].intensity;
            uint _e38 = each;
            metal::float2 _e41 = look.lights.inner[_e38].fading;
            Light _e43 = light_at(_e17, _e23, _e29, _e35, _e41, surface.position);
            LightParts light_2_ = LightParts {_e43.direction, metal::float4(_e43.color, 1.0), _e43.intensity};
            Angle lamps_angle = Angle {0.5 * metal::length(surface.normal - _e43.direction), 0.5 * metal::length(surface.normal + _e43.direction)};
            float _e65 = profile_balanced(lamps_angle, 0.0, lamps_tone_shape);
            float _e69 = eased(light_2_.intensity, 0.5, 0.55);
            float lamps_bands = metal::mix(0.55, 1.0, _e69);
            float _e76 = eased(light_2_.intensity, 0.2, 0.24);
            float lamps_reach = _e65 * (lamps_bands * _e76);
            Color lamps_lit = light_2_.color * metal::float4(metal::float3(lamps_reach), 1.0);
            metal::float4 _e84 = lamps_brightest;
            metal::float4 _e85 = lamps_brightest;
            lamps_brightest = (light_2_.intensity > 0.0) ? metal::float4(metal::max(_e85.xyz, lamps_lit.xyz), 1.0) : _e84;
        }
    }
    metal::float3 _e102 = look.moon.direction;
    metal::float3 _e111 = look.moon.direction;
    Angle moon_angle = Angle {0.5 * metal::length(surface.normal - _e102), 0.5 * metal::length(surface.normal + _e111)};
    float _e119 = profile_balanced(moon_angle, 0.0, moon_tone_shape);
    Color _e130 = mix_evenly_oklab(metal::float4(0.07, 0.08, 0.16, 1.0), metal::float4(0.2, 0.24, 0.4, 1.0), _e119);
    metal::float4 _e131 = lamps_brightest;
    Color _e139 = limit_color(metal::float4(_e131.xyz + _e130.xyz, 1.0), 1.0, 0.3);
    return _e139;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
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
    const Vertex vertex_ = { varyings.position_1, varyings.normal };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position_1, varyings_1.normal };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    Surface surface_1 = Surface {normal, in.position};
    metal::float4 _e8 = shade(surface_1, look);
    return fs_mainOutput { _e8 };
}
