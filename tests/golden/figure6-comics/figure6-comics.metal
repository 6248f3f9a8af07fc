// Comics: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure6-comics.json says what to put there and how to draw.
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
    Light rim;
    Light fill;
};
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
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
    metal::float3 normal;
};
constant ProfileShape key_tone_shape = ProfileShape {0.8472551, 0.5311862, 0.0, 1.0, 1.12, 0.0, 0.0, 1u};
constant ProfileShape bounce_tone_shape = ProfileShape {0.9358968, 0.35227424, 0.0, 1.0, 0.72, 0.0, 0.0, 1u};
constant ProfileShape light_tone_shape = ProfileShape {0.96638995, 0.25708055, 0.0, 1.0, 0.52, 0.0, 0.0, 1u};
constant ProfileShape rim_tone_shape = ProfileShape {0.9130889, 0.40776044, 0.0, 1.0, 0.84, 0.0, 0.0, 1u};
constant ProfileShape highlight_tone_shape = ProfileShape {0.99280864, 0.119712204, 0.0, 1.0, 0.24, 0.0, 0.0, 1u};

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

Angle parametrization_diffuse_balanced(
    Light light_1,
    metal::float3 normal
) {
    return Angle {0.5 * metal::length(normal - light_1.direction), 0.5 * metal::length(normal + light_1.direction)};
}

Angle parametrization_specular_balanced(
    Light light_2,
    metal::float3 normal_1,
    metal::float3 view
) {
    metal::float3 d = ((2.0 * metal::dot(normal_1, view)) * normal_1) - view;
    return Angle {0.5 * metal::length(d - light_2.direction), 0.5 * metal::length(d + light_2.direction)};
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
    float _e3 = transition_balanced(surface.kappa, 0.35);
    Color _e14 = curvature_color(_e3, metal::float4(0.7059, 0.3412, 0.2902, 1.0), metal::float4(0.2941, 0.1098, 0.2, 1.0));
    Light _e17 = look.key;
    LitLayer _e19 = light_apply(_e17, _e14, 1.0);
    Composite _e29 = blend_alpha(metal::float4(0.8863, 0.6275, 0.4353, 1.0), _e19.color, _e19.tone, 1.0, true);
    Color _e40 = curvature_color(_e3, metal::float4(0.9529, 0.6902, 0.4392, 1.0), metal::float4(0.7686, 0.3451, 0.2902, 1.0));
    Light _e43 = look.key;
    Angle _e45 = parametrization_diffuse_balanced(_e43, surface.normal);
    float key_warp = ((2.0 * _e3) - 1.0) * 0.45;
    float _e53 = profile_balanced(_e45, key_warp, key_tone_shape);
    Light _e56 = look.key;
    LitLayer _e57 = light_apply(_e56, _e40, _e53);
    Composite _e62 = blend_alpha(_e29, _e57.color, _e57.tone, 1.0, true);
    float _e65 = transition_balanced(surface.kappa, 0.3);
    Color _e76 = curvature_color(_e65, metal::float4(0.8157, 0.4863, 0.3686, 1.0), metal::float4(0.549, 0.2275, 0.298, 1.0));
    Light _e79 = look.fill;
    Angle _e81 = parametrization_diffuse_balanced(_e79, surface.normal);
    float bounce_warp = ((2.0 * _e65) - 1.0) * 0.35;
    float _e89 = profile_balanced(_e81, bounce_warp, bounce_tone_shape);
    Light _e92 = look.fill;
    LitLayer _e93 = light_apply(_e92, _e76, _e89);
    Composite _e98 = blend_alpha(_e62, _e93.color, _e93.tone, 1.0, true);
    Color _e109 = curvature_color(_e65, metal::float4(1.0, 0.851, 0.6275, 1.0), metal::float4(0.9412, 0.6431, 0.4078, 1.0));
    float light_warp = ((2.0 * _e65) - 1.0) * 0.3;
    float _e117 = profile_balanced(_e45, light_warp, light_tone_shape);
    Light _e120 = look.key;
    LitLayer _e121 = light_apply(_e120, _e109, _e117);
    Composite _e126 = blend_alpha(_e98, _e121.color, _e121.tone, 1.0, true);
    float _e129 = transition_balanced(surface.kappa, 0.25);
    Color _e140 = curvature_color(_e129, metal::float4(1.0, 0.9569, 0.8627, 1.0), metal::float4(0.949, 0.6588, 0.4196, 1.0));
    Light _e143 = look.rim;
    Angle _e145 = parametrization_diffuse_balanced(_e143, surface.normal);
    float rim_warp = ((2.0 * _e129) - 1.0) * 0.2;
    float _e153 = profile_balanced(_e145, rim_warp, rim_tone_shape);
    Light _e156 = look.rim;
    LitLayer _e157 = light_apply(_e156, _e140, _e153);
    Composite _e162 = blend_alpha(_e126, _e157.color, _e157.tone, 1.0, true);
    Color _e173 = curvature_color(_e129, metal::float4(1.0, 0.9804, 0.9412, 1.0), metal::float4(1.0, 0.8863, 0.7216, 1.0));
    Light _e176 = look.key;
    Angle _e179 = parametrization_specular_balanced(_e176, surface.normal, surface.view);
    float highlight_warp = ((2.0 * _e129) - 1.0) * 0.1;
    float _e187 = profile_balanced(_e179, highlight_warp, highlight_tone_shape);
    Light _e190 = look.key;
    LitLayer _e191 = light_apply(_e190, _e173, _e187);
    Composite _e196 = blend_alpha(_e162, _e191.color, _e191.tone, 1.0, true);
    return _e196;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_2 [[user(loc1), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_2 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e23 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_2, metal::normalize(_e8.xyz - (_e13 * in.position)), _e23.x};
    metal::float4 _e26 = shade(surface_1, look);
    return fs_mainOutput { _e26 };
}
