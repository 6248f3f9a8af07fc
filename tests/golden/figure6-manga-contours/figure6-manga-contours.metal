// Manga, contours: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure6-manga-contours.json says what to put there and how to draw.
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
    Light eye;
    metal::float3x3 camera_from_world;
    Light key;
};
struct Surface {
    metal::packed_float3 normal;
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
    metal::float3 normal;
};
constant ProfileShape shadow_tone_shape = ProfileShape {0.78070694, 0.6248973, 0.0, 1.0, 1.35, 0.0, 0.0, 1u};
constant ProfileShape contour_tone_shape = ProfileShape {0.8337121, 0.55219936, 0.0, 1.0, 1.17, 0.0, 0.0, 1u};

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

metal::float2 sin_cos_quick(
    float x
) {
    float y = x * x;
    float s_1 = x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 0.0000026347564))))))));
    float c = 1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (0.00002477458 - (y * 0.00000026297516)))))))));
    return metal::float2(s_1, c);
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_1 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_1, 0.5);
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

Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + (convexity * (convex - concave));
}

float transition_balanced(
    float kappa,
    float slope
) {
    return 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(kappa * slope, -20.0, 20.0))))));
}

Composite blend_multiply(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (0.5 * ((below.xyz * (tone * color.xyz)) - below.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_1,
    float tone_1
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_1.xyz * light.color) * split.y, 1.0), tone_1 * split.x};
}

Angle parametrization_screen_aligned_balanced(
    Light light_1,
    metal::float3 normal,
    metal::float3x3 camera_from_world
) {
    metal::float3 d = camera_from_world * normal;
    return Angle {0.5 * metal::length(d - light_1.own_direction), 0.5 * metal::length(d + light_1.own_direction)};
}

float profile_ramp_quick(
    float s,
    float w,
    ProfileShape shape
) {
    float width = metal::sqrt(w * w);
    float from_offset = s * (2.0 + ((s * s) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((0.0 - from_offset) / metal::max(width, 0.000001)), 0.0, 1.0);
    return (w <= 0.0) ? ((s <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_1
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset), _e14, shape_1);
    return _e15;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle inked_hollows_angle = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    float _e22 = transition_balanced(surface.kappa, 0.3);
    float shadow_warp = ((2.0 * _e22) - 1.0) * 0.35;
    float _e30 = profile_balanced(inked_hollows_angle, shadow_warp, shadow_tone_shape);
    Light _e33 = look.key;
    LitLayer _e39 = light_apply(_e33, metal::float4(0.9843, 0.9765, 0.9569, 1.0), _e30);
    Composite _e49 = blend_multiply(metal::float4(0.9843, 0.9765, 0.9569, 1.0), _e39.color, _e39.tone, 0.5, true);
    float _e52 = transition_balanced(surface.kappa, 0.5);
    Color _e60 = curvature_color(_e52, metal::float4(1.0), metal::float4(0.1647, 0.1451, 0.1882, 1.0));
    Light _e63 = look.key;
    LitLayer _e65 = light_apply(_e63, _e60, 1.0);
    metal::float4 inked_hollows_blend = metal::clamp(metal::float4(_e49.xyz * (_e65.tone * _e65.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    Light _e81 = look.eye;
    metal::float3x3 _e85 = look.camera_from_world;
    Angle _e86 = parametrization_screen_aligned_balanced(_e81, surface.normal, _e85);
    float _e89 = transition_balanced(surface.kappa, 0.12);
    float contour_warp = ((2.0 * _e89) - 1.0) * 0.3;
    float _e97 = profile_balanced(_e86, contour_warp, contour_tone_shape);
    Light _e100 = look.eye;
    LitLayer _e103 = light_apply(_e100, metal::float4(1.0), _e97);
    metal::float4 contour_blend = metal::clamp(metal::float4(inked_hollows_blend.xyz * (_e103.tone * _e103.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return contour_blend;
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

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
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
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e11 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_1, _e11.x};
    metal::float4 _e14 = shade(surface_1, look);
    return fs_mainOutput { _e14 };
}
