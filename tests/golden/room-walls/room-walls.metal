// Walls: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// room-walls.json says what to put there and how to draw.
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
    metal::float3 rim_position;
    metal::float3 rim_aim;
    metal::float3x3 rim_own_from_world;
    metal::packed_float3 rim_color;
    float rim_intensity;
    metal::float2 rim_cone;
    metal::float2 rim_fading;
    metal::float3 fill_position;
    metal::float3x3 fill_own_from_world;
    metal::packed_float3 fill_color;
    float fill_intensity;
    metal::float2 fill_fading;
    char _pad12[8];
    metal::float3 sun_direction;
    Light sun;
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
struct LightParts {
    metal::float3 direction;
    Color color;
    float intensity;
    char _pad3[12];
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
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant ProfileShape lamps_rim_tone_shape = ProfileShape {0.9950042, 0.099833414, 1.5805954, 1.2600908, 0.2, 0.82074726, 0.32190663, 0u};
constant ProfileShape sun_tone_shape = ProfileShape {0.7960838, 0.6051864, 7.4299555, 2.1069195, 1.3, 0.14104924, 0.05909888, 0u};

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
    float w_3 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_3, 0.5);
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

metal::float3 bounded_vec3_(
    metal::float3 v_3
) {
    metal::uint3 bits_1 = as_type<metal::uint3>(v_3);
    metal::uint3 magnitude_1 = bits_1 & metal::uint3(2147483647u);
    metal::float3 largest_2 = as_type<metal::float3>((bits_1 & metal::uint3(2147483648u)) | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest_2, magnitude_1 == metal::uint3(2139095040u));
    return metal::select(numbers, v_3, magnitude_1 < metal::uint3(2139095040u));
}

metal::float4 bounded_vec4_(
    metal::float4 v_4
) {
    metal::uint4 bits_2 = as_type<metal::uint4>(v_4);
    metal::uint4 magnitude_2 = bits_2 & metal::uint4(2147483647u);
    metal::float4 largest_3 = as_type<metal::float4>((bits_2 & metal::uint4(2147483648u)) | metal::uint4(2139095039u));
    metal::float4 numbers_1 = metal::select(metal::float4(0.0), largest_3, magnitude_2 == metal::uint4(2139095040u));
    return metal::select(numbers_1, v_4, magnitude_2 < metal::uint4(2139095040u));
}

float place_between(
    float x_2,
    float low,
    float high
) {
    float span = high - low;
    if (span < SMALLEST_NORMAL) {
        return (x_2 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded((x_2 - low) / span);
    return _e12;
}

float eased(
    float x_3,
    float low_1,
    float high_1
) {
    float _e3 = place_between(x_3, low_1, high_1);
    float t_1 = metal::clamp(_e3, 0.0, 1.0);
    return (t_1 * t_1) * (3.0 - (2.0 * t_1));
}

float footprint_of(
    float x_4
) {
    float _e1 = metal::dfdx(x_4);
    float _e2 = metal::dfdy(x_4);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
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

metal::float3x3 axes_turned(
    metal::float3 toward_1,
    float spin
) {
    metal::float3x3 _e6 = axes_around(toward_1, metal::float3(0.0, 1.0, 0.0));
    metal::float2 turn = metal::float2(0.0, 1.0);
    return metal::float3x3((turn.y * _e6[0]) + (turn.x * _e6[1]), (turn.y * _e6[1]) - (turn.x * _e6[0]), _e6[2]);
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
    float softness_1,
    float density,
    bool inverted
) {
    float _e4 = footprint_of(m);
    float half_1 = 0.5 * metal::min(_e4, 0.25);
    float _e13 = eased(m, 1.0 - half_1, 1.0 + half_1);
    return 1.0 - _e13;
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
        float window_1 = metal::max(1.0 - (((d_2 * d_2) * d_2) * d_2), 0.0);
        float _e30 = left;
        left = _e30 * (window_1 * window_1);
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
    float t_2 = metal::clamp((cos_angle - cone.y) / (cone.x - cone.y), 0.0, 1.0);
    return (t_2 * t_2) * (3.0 - (2.0 * t_2));
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
    float tone
) {
    metal::float2 split = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4((color_3.xyz * light_1.color) * split.y, 1.0), tone * split.x};
}

PlaceInLight place_in_light(
    metal::float2 at
) {
    metal::float2 near = metal::clamp(at, metal::float2(-1000.0), metal::float2(1000.0));
    float _e14 = share_beside(metal::max(metal::abs(near.x), metal::abs(near.y)), 0.0, 1.0, true);
    return PlaceInLight {metal::float2(0.5) + (0.5 * metal::float2(-(near.x), near.y)), _e14};
}

Angle parametrization_diffuse_balanced(
    Light light_2,
    metal::float3 normal
) {
    return Angle {0.5 * metal::length(normal - light_2.direction), 0.5 * metal::length(normal + light_2.direction)};
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
    float _e19 = profile_soft_quick(place_1.x, shape_2);
    if (w_1 < (0.1 * shape_2.edge_deviation)) {
        return _e19;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn_1 = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e45 = profile_soft_quick((place_1.x * turn_1.y) - (place_1.y * turn_1.x), shape_2);
    float _e53 = profile_soft_quick((place_1.x * turn_1.y) + (place_1.y * turn_1.x), shape_2);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_filtered_quick_2_(
    Angle u_3,
    float w_2,
    ProfileShape shape_3
) {
    metal::float2 place_2 = metal::float2((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset), (u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset));
    bool is_narrow = (w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place_2.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_2.x, shape_3);
    if (w_2 < (0.1 * shape_3.edge_deviation)) {
        return _e30;
    }
    float r_1 = 0.19364917 * w_2;
    metal::float2 turn_2 = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
    float _e56 = profile_soft_quick((place_2.x * turn_2.y) - (place_2.y * turn_2.x), shape_3);
    float _e64 = profile_soft_quick((place_2.x * turn_2.y) + (place_2.y * turn_2.x), shape_3);
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

float window(
    metal::float2 uv,
    float bars,
    float softness_2
) {
    metal::float2 from_edge = metal::float2(0.5) - metal::abs(uv - metal::float2(0.5));
    metal::float2 from_cross = metal::abs(uv - metal::float2(0.5));
    metal::float2 within = metal::smoothstep(metal::float2(bars), metal::float2(bars + softness_2), from_edge);
    metal::float2 beside = metal::smoothstep(metal::float2(0.5 * bars), metal::float2((0.5 * bars) + softness_2), from_cross);
    return ((within.x * within.y) * beside.x) * beside.y;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e3 = look.rim_position;
    metal::float3 _e6 = look.rim_aim;
    metal::float3x3 _e9 = look.rim_own_from_world;
    metal::float3 _e12 = look.rim_color;
    float _e15 = look.rim_intensity;
    metal::float2 _e18 = look.rim_cone;
    metal::float2 _e21 = look.rim_fading;
    Light _e23 = light_spot(_e3, _e6, _e9, _e12, _e15, _e18, _e21, surface.position);
    LightParts rim_2_ = LightParts {_e23.direction, metal::float4(_e23.color, 1.0), _e23.intensity};
    metal::float4 _e36 = bounded_vec4_(rim_2_.color * metal::float4(metal::float3(rim_2_.intensity), 1.0));
    Angle _e38 = parametrization_diffuse_balanced(_e23, surface.normal);
    float _e41 = profile_balanced(_e38, 0.0, lamps_rim_tone_shape);
    metal::float4 _e46 = bounded_vec4_(_e36 * metal::float4(metal::float3(_e41), 1.0));
    metal::float3 _e49 = look.fill_position;
    metal::float3x3 _e52 = look.fill_own_from_world;
    metal::float3 _e55 = look.fill_color;
    float _e58 = look.fill_intensity;
    metal::float2 _e61 = look.fill_fading;
    Light _e63 = light_at(_e49, _e52, _e55, _e58, _e61, surface.position);
    LightParts fill_2_ = LightParts {_e63.direction, metal::float4(_e63.color, 1.0), _e63.intensity};
    metal::float4 _e76 = bounded_vec4_(fill_2_.color * metal::float4(metal::float3(fill_2_.intensity), 1.0));
    Angle _e78 = parametrization_diffuse_balanced(_e63, surface.normal);
    float _e81 = profile_balanced(_e78, 0.0, lamps_rim_tone_shape);
    metal::float4 _e86 = bounded_vec4_(_e76 * metal::float4(metal::float3(_e81), 1.0));
    metal::float3 _e96 = bounded_vec3_(metal::float3(0.0) + _e86.xyz);
    metal::float4 lamps_fill_sum = (fill_2_.intensity > 0.0) ? metal::float4(_e96, 1.0) : metal::float4(0.0, 0.0, 0.0, 1.0);
    metal::float3 _e106 = bounded_vec3_(lamps_fill_sum.xyz + _e46.xyz);
    metal::float4 lamps_rim_sum = (rim_2_.intensity > 0.0) ? metal::float4(_e106, 1.0) : lamps_fill_sum;
    metal::float4 lamplit = lamps_rim_sum * metal::float4(0.62, 0.55, 0.6, 1.0);
    metal::float4 night = lamplit + metal::float4(0.07, 0.055, 0.11, 1.0);
    metal::float4 ground = metal::float4(night.xyz, 1.0);
    Light _e130 = look.sun;
    Angle _e132 = parametrization_diffuse_balanced(_e130, surface.normal);
    metal::float3 _e140 = look.sun_direction;
    metal::float3x3 _e143 = axes_turned(-(_e140), 0.0);
    metal::float3 _e144 = place_along(surface.position, metal::float3(0.1, -0.05, 0.0), _e143);
    PlaceInLight _e149 = place_in_light(_e144.xy / metal::float2(0.95));
    float _e153 = window(_e149.uv, 0.05, 0.02);
    metal::float3 _e157 = look.sun.direction;
    metal::float3 _e161 = look.sun.own_direction;
    metal::float3 _e165 = look.sun.color;
    float _e169 = look.sun.intensity;
    FilteredLight filter_2_ = FilteredLight {Light {_e157, _e161, _e165, _e169 * metal::min(_e153, 1.0)}, _e132};
    float _e178 = profile_balanced_2_(filter_2_.angle, 0.0, sun_tone_shape);
    LitLayer _e185 = light_apply(filter_2_.light, metal::float4(0.62, 0.55, 0.6, 1.0), _e178);
    metal::float4 stack = metal::clamp(metal::float4(ground.xyz + (_e185.tone * _e185.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    Color _e201 = limit_color(stack, 1.0, 0.3);
    return _e201;
}

struct vs_mainInput {
    metal::float3 position_2 [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position_2, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_2 [[user(loc0), center_perspective]];
    metal::float3 normal_1 [[user(loc1), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position_2, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    Surface surface_1 = Surface {normal_1, in.position};
    metal::float4 _e8 = shade(surface_1, look);
    return fs_mainOutput { _e8 };
}
