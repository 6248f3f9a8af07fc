// Curvature in the color: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure4-color.json says what to put there and how to draw.
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
constant ProfileShape diffuse_tone_shape = ProfileShape {0.9921977, 0.12467473, 1.6002629, 1.3188459, 0.25, 0.79761744, 0.31569642, 0u};

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
    float w_1 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_1, 0.5);
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
    return LitLayer {metal::float4((color.xyz * light.color) * split.y, 1.0), split.x};
}

LitLayer light_apply_2_(
    Light light_1,
    Color color_1,
    float tone_1
) {
    metal::float2 split_1 = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4((color_1.xyz * light_1.color) * split_1.y, 1.0), tone_1 * split_1.x};
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
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float diffuse_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.3, -20.0, 20.0))))));
    Color _e30 = curvature_color(diffuse_convexity, metal::float4(0.2275, 0.1569, 0.1882, 1.0), metal::float4(0.0863, 0.0431, 0.0667, 1.0));
    Light _e33 = look.key;
    LitLayer _e35 = light_apply(_e33, _e30, 1.0);
    metal::float4 fill_blend = metal::clamp(metal::float4(metal::float3(0.1373, 0.0941, 0.1255) + (_e35.tone * _e35.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    Color _e62 = curvature_color(diffuse_convexity, metal::float4(0.7255, 0.5137, 0.3529, 1.0), metal::float4(0.3608, 0.1216, 0.1725, 1.0));
    metal::float3 _e67 = look.key.direction;
    metal::float3 _e76 = look.key.direction;
    Angle diffuse_angle = Angle {0.5 * metal::length(surface.normal - _e67), 0.5 * metal::length(surface.normal + _e76)};
    float _e84 = profile_balanced(diffuse_angle, 0.0, diffuse_tone_shape);
    Light _e87 = look.key;
    LitLayer _e88 = light_apply_2_(_e87, _e62, _e84);
    metal::float4 diffuse_blend = metal::clamp(metal::float4(fill_blend.xyz + (_e88.tone * _e88.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return diffuse_blend;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal };
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
    metal::float3 normal [[user(loc0), center_perspective]];
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
    const Varyings in = { clip, varyings_1.normal };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    metal::float4 _e11 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal, _e11.x};
    metal::float4 _e14 = shade(surface_1, look);
    return fs_mainOutput { _e14 };
}
