// Manga, embossed: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure6-manga-embossed.json says what to put there and how to draw.
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
    Light above;
    metal::float3x3 camera_from_world;
    Light below;
};
struct Surface {
    metal::packed_float3 normal;
    float kappa;
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
constant ProfileShape dark_side_tone_shape = ProfileShape {0.9624252, 0.27154693, 5.0334897, 2.4651666, 0.55, 0.19658314, 0.08474467, 0u};
constant ProfileShape light_side_tone_shape = ProfileShape {0.9689124, 0.24740396, 5.743557, 2.3650649, 0.5, 0.17491564, 0.07484149, 0u};

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

metal::float2 sin_cos_quick(
    float x
) {
    float y = x * x;
    float s_2 = x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 0.0000026347564))))))));
    float c = 1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (0.00002477458 - (y * 0.00000026297516)))))))));
    return metal::float2(s_2, c);
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
    float s_3 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, c_1);
    metal::float2 turned = ((s_3 <= 0.0) & (s_3 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + (convexity * (convex - concave));
}

LitLayer light_apply(
    Light light,
    Color color,
    float tone
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color.xyz * light.color) * split.y, 1.0), tone * split.x};
}

Angle parametrization_screen_aligned_balanced(
    Light light_1,
    metal::float3 normal,
    metal::float3x3 camera_from_world
) {
    metal::float3 d = camera_from_world * normal;
    return Angle {0.5 * metal::length(d - light_1.own_direction), 0.5 * metal::length(d + light_1.own_direction)};
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
    metal::float2 _e5 = sin_cos_quick(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float light_side_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.3, -20.0, 20.0))))));
    Color _e30 = curvature_color(light_side_convexity, metal::float4(0.4275, 0.4078, 0.4745, 1.0), metal::float4(0.2275, 0.2078, 0.2784, 1.0));
    Light _e33 = look.below;
    metal::float3x3 _e37 = look.camera_from_world;
    Angle _e38 = parametrization_screen_aligned_balanced(_e33, surface.normal, _e37);
    float light_side_warp = ((2.0 * light_side_convexity) - 1.0) * 0.35;
    float _e46 = profile_balanced(_e38, light_side_warp, dark_side_tone_shape);
    Light _e49 = look.below;
    LitLayer _e50 = light_apply(_e49, _e30, _e46);
    metal::float4 dark_side_blend = metal::clamp(metal::float4(metal::float3(0.851, 0.8314, 0.7804) * metal::mix(metal::float3(1.0), _e50.color.xyz, _e50.tone), 1.0), metal::float4(0.0), metal::float4(1.0));
    Color _e76 = curvature_color(light_side_convexity, metal::float4(1.0), metal::float4(0.9529, 0.9176, 0.8471, 1.0));
    Light _e79 = look.above;
    metal::float3x3 _e83 = look.camera_from_world;
    Angle _e84 = parametrization_screen_aligned_balanced(_e79, surface.normal, _e83);
    float _e86 = profile_balanced(_e84, light_side_warp, light_side_tone_shape);
    Light _e89 = look.above;
    LitLayer _e90 = light_apply(_e89, _e76, _e86);
    metal::float4 light_side_blend = metal::clamp(metal::float4(dark_side_blend.xyz + (_e90.tone * (_e90.color.xyz - dark_side_blend.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float hollows_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.4, -20.0, 20.0))))));
    Color _e132 = curvature_color(hollows_convexity, metal::float4(1.0), metal::float4(0.4667, 0.4392, 0.5412, 1.0));
    Light _e135 = look.above;
    LitLayer _e137 = light_apply(_e135, _e132, 1.0);
    metal::float4 hollows_blend = metal::clamp(metal::float4(light_side_blend.xyz + (0.8 * ((light_side_blend.xyz * (_e137.tone * _e137.color.xyz)) - light_side_blend.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return hollows_blend;
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
