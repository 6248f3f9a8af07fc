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

float curvature_signed_balanced(
    float kappa,
    float slope
) {
    return 1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp((((as_type<uint>(kappa) & 2147483647u) > 2139095040u) ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0)) * slope, -20.0, 20.0))));
}

float curvature_signed_balanced_2_(
    float kappa_1,
    float slope_1
) {
    return 1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp((((as_type<uint>(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : metal::clamp(kappa_1, -10000.0, 10000.0)) * 0.25, -20.0, 20.0))));
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
    return LitLayer {metal::float4((color_1.xyz * light.color) * split.y, 1.0), split.x};
}

LitLayer light_apply_2_(
    Light light_1,
    Color color_2,
    float tone_2
) {
    metal::float2 split_1 = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4((color_2.xyz * light_1.color) * split_1.y, 1.0), tone_2 * split_1.x};
}

Angle parametrization_specular_balanced(
    Light light_2,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d = ((2.0 * metal::dot(normal, view)) * normal) - view;
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
    Surface surface_1,
    constant Look& look
) {
    float _e3 = curvature_signed_balanced(surface_1.kappa, 0.35);
    float key_convexity = 0.5 + (0.5 * _e3);
    Color _e18 = curvature_color(key_convexity, metal::float4(0.7059, 0.3412, 0.2902, 1.0), metal::float4(0.2941, 0.1098, 0.2, 1.0));
    Light _e21 = look.key;
    LitLayer _e23 = light_apply(_e21, _e18, 1.0);
    Composite _e33 = blend_alpha(metal::float4(0.8863, 0.6275, 0.4353, 1.0), _e23.color, _e23.tone, 1.0, true);
    Color _e44 = curvature_color(key_convexity, metal::float4(0.9529, 0.6902, 0.4392, 1.0), metal::float4(0.7686, 0.3451, 0.2902, 1.0));
    metal::float3 _e49 = look.key.direction;
    metal::float3 _e58 = look.key.direction;
    Angle light_angle = Angle {0.5 * metal::length(surface_1.normal - _e49), 0.5 * metal::length(surface_1.normal + _e58)};
    float key_warp = ((2.0 * key_convexity) - 1.0) * 0.45;
    float _e71 = profile_balanced(light_angle, key_warp, key_tone_shape);
    Light _e74 = look.key;
    LitLayer _e75 = light_apply_2_(_e74, _e44, _e71);
    metal::float4 key_blend = metal::clamp(metal::float4(_e33.xyz + (_e75.tone * (_e75.color.xyz - _e33.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float _e93 = curvature_signed_balanced(surface_1.kappa, 0.3);
    float light_convexity = 0.5 + (0.5 * _e93);
    Color _e108 = curvature_color(light_convexity, metal::float4(0.8157, 0.4863, 0.3686, 1.0), metal::float4(0.549, 0.2275, 0.298, 1.0));
    metal::float3 _e113 = look.fill.direction;
    metal::float3 _e122 = look.fill.direction;
    Angle bounce_angle = Angle {0.5 * metal::length(surface_1.normal - _e113), 0.5 * metal::length(surface_1.normal + _e122)};
    float bounce_warp = ((2.0 * light_convexity) - 1.0) * 0.35;
    float _e135 = profile_balanced(bounce_angle, bounce_warp, bounce_tone_shape);
    Light _e138 = look.fill;
    LitLayer _e139 = light_apply_2_(_e138, _e108, _e135);
    metal::float4 bounce_blend = metal::clamp(metal::float4(key_blend.xyz + (_e139.tone * (_e139.color.xyz - key_blend.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Color _e165 = curvature_color(light_convexity, metal::float4(1.0, 0.851, 0.6275, 1.0), metal::float4(0.9412, 0.6431, 0.4078, 1.0));
    float light_warp = ((2.0 * light_convexity) - 1.0) * 0.3;
    float _e173 = profile_balanced(light_angle, light_warp, light_tone_shape);
    Light _e176 = look.key;
    LitLayer _e177 = light_apply_2_(_e176, _e165, _e173);
    metal::float4 light_blend = metal::clamp(metal::float4(bounce_blend.xyz + (_e177.tone * (_e177.color.xyz - bounce_blend.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float _e195 = curvature_signed_balanced_2_(surface_1.kappa, 0.25);
    float highlight_convexity = 0.5 + (0.5 * _e195);
    Color _e210 = curvature_color(highlight_convexity, metal::float4(1.0, 0.9569, 0.8627, 1.0), metal::float4(0.949, 0.6588, 0.4196, 1.0));
    metal::float3 _e215 = look.rim.direction;
    metal::float3 _e224 = look.rim.direction;
    Angle rim_angle = Angle {0.5 * metal::length(surface_1.normal - _e215), 0.5 * metal::length(surface_1.normal + _e224)};
    float rim_warp = ((2.0 * highlight_convexity) - 1.0) * 0.2;
    float _e237 = profile_balanced(rim_angle, rim_warp, rim_tone_shape);
    Light _e240 = look.rim;
    LitLayer _e241 = light_apply_2_(_e240, _e210, _e237);
    metal::float4 rim_blend = metal::clamp(metal::float4(light_blend.xyz + (_e241.tone * (_e241.color.xyz - light_blend.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Color _e267 = curvature_color(highlight_convexity, metal::float4(1.0, 0.9804, 0.9412, 1.0), metal::float4(1.0, 0.8863, 0.7216, 1.0));
    Light _e270 = look.key;
    Angle _e273 = parametrization_specular_balanced(_e270, surface_1.normal, surface_1.view);
    float highlight_warp = ((2.0 * highlight_convexity) - 1.0) * 0.1;
    float _e281 = profile_balanced(_e273, highlight_warp, highlight_tone_shape);
    Light _e284 = look.key;
    LitLayer _e285 = light_apply_2_(_e284, _e267, _e281);
    metal::float4 output = metal::clamp(metal::float4(rim_blend.xyz + (_e285.tone * (_e285.color.xyz - rim_blend.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return output;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_1.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    Varyings _e22 = out;
    const auto _tmp = _e22;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_1 [[user(loc1), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    Surface surface = {};
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    surface.normal = normal_1;
    metal::float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = metal::normalize(_e11.xyz - (_e16 * in.position));
    metal::float4 _e27 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.kappa = _e27.x;
    Surface _e29 = surface;
    metal::float4 _e30 = shade(_e29, look);
    return fs_mainOutput { _e30 };
}
