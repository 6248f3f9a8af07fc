// Light where it is wanted: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_3 buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0).
// local-control.json says what to put there and how to draw.
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
    metal::float3x3 camera_from_world;
    metal::float2 viewport;
    char _pad2[8];
    Light back;
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
    metal::float3 position_camera;
    metal::float3 curvature_tensor;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
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
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant ProfileShape soft_tone_shape = ProfileShape {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u};

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen(
    metal::float3 v_1
) {
    metal::float3 _e5 = normalize_moderate(v_1, metal::float3(0.0, 0.0, 1.0));
    return _e5;
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

float bounded(
    float x
) {
    uint bits = as_type<uint>(x);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0);
}

float eased(
    float x_1,
    float low,
    float high
) {
    float _e3 = bounded(x_1);
    float _e7 = bounded((_e3 - low) / (high - low));
    float t_1 = metal::clamp(_e7, 0.0, 1.0);
    return (t_1 * t_1) * (3.0 - (2.0 * t_1));
}

float length_of(
    metal::float3 v_2
) {
    float largest_1 = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest_1 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e16 = bounded(largest_1 * metal::length(v_2 / metal::float3(largest_1)));
    return _e16;
}

float footprint_of(
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
    metal::float2 d = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
    return _e6;
}

float footprint_of_2_(
    float x_3
) {
    float _e1 = metal::dfdx(x_3);
    float _e2 = metal::dfdy(x_3);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_1, d_1));
}

float step_filtered(
    float x_4,
    float edge,
    float w
) {
    float d_2 = x_4 - edge;
    return (w < 0.000000000000000000000000000001) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_2 / w), 0.0, 1.0);
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::float4(below.xyz + (tone * (color.xyz - below.xyz)), 1.0);
}

Composite blend_alpha_2_(
    Composite below_1,
    Color color_1,
    float tone_1,
    float opacity_1,
    bool clamped_1
) {
    return metal::clamp(metal::float4(below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

Light local_light(
    Light light,
    metal::float3 bend,
    float strength,
    metal::float3 center,
    float radius,
    float hardness,
    metal::float3 position
) {
    float _e8 = length_of(position - center);
    float _e10 = eased(_e8, radius * hardness, radius);
    float weight = 1.0 - _e10;
    metal::float3 bent = light.direction + (weight * bend);
    metal::float3 _e18 = normalize_moderate(bent, light.direction);
    metal::float3 direction = ((metal::dot(bent, bent) > 0.000001) & (weight > 0.0)) ? _e18 : light.direction;
    return Light {direction, light.own_direction, light.color, metal::min(light.intensity, 1000000000000000000000000000000.0)};
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
    metal::float2 place_1 = metal::float2(u_2.half_sin - 0.0, u_2.half_cos);
    float _e9 = profile_soft_quick(place_1.x, shape_1);
    if (w_1 < (0.1 * shape_1.edge_deviation)) {
        return _e9;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e35 = profile_soft_quick((place_1.x * turn.y) - (place_1.y * turn.x), shape_1);
    float _e43 = profile_soft_quick((place_1.x * turn.y) + (place_1.y * turn.x), shape_1);
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

float rim(
    Light light_1,
    metal::float3 normal,
    metal::float3 view,
    float width,
    float softness,
    float follow
) {
    float facing = metal::clamp(metal::dot(normal, view), 0.0, 1.0);
    float _e11 = footprint_of_2_(facing);
    float edge_1 = metal::max(width * softness, metal::min(_e11, 1.0));
    metal::float3 aside = normal - view;
    float further = (facing > 0.5) ? ((0.5 * metal::dot(aside, aside)) - (1.0 - width)) : (width - facing);
    float within = (further / edge_1) + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across = light_1.direction - (metal::dot(light_1.direction, view) * view);
    float side = metal::dot(normal - (metal::dot(normal, view) * view), across * metal::rsqrt(metal::max(metal::dot(across, across), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side), follow);
}

float inner_contour_suggestive(
    float width_1,
    float limit,
    float softness_1,
    metal::float3 tensor,
    metal::float3 normal_1,
    metal::float3 view_1,
    metal::float3x3 camera_from_world,
    metal::float3 place,
    metal::float2 viewport
) {
    metal::float3 n = camera_from_world * normal_1;
    float square_1 = metal::dot(n.xy, n.xy);
    float radial = ((((tensor.x * n.x) * n.x) + (((2.0 * tensor.y) * n.x) * n.y)) + ((tensor.z * n.y) * n.y)) / metal::max(square_1, 0.000001);
    float _e35 = metal::dfdx(radial);
    float _e36 = metal::dfdy(radial);
    metal::float2 change = metal::float2(_e35, _e36);
    metal::float3 v_3 = camera_from_world * view_1;
    metal::float3 row = metal::dfdy(place);
    float up = ((row - (metal::dot(row, v_3) * v_3)).y >= 0.0) ? 1.0 : -1.0;
    float height = metal::clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(((change.x * n.x) + ((up * change.y) * n.y))) * metal::rsqrt(metal::max(square_1, 0.000001));
    float pixels = height / 1000.0;
    float distance = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float x_5 = (toward_eye * height) * 0.05;
    float _e77 = footprint_of(x_5);
    float strength_1 = metal::clamp(0.5 + ((x_5 - limit) / metal::length(metal::float2(metal::min(_e77, 1000000000000000.0), limit * softness_1))), 0.0, 1.0);
    return (metal::clamp((pixels + 0.5) - distance, 0.0, metal::min(pixels, 1.0)) * strength_1) * metal::smoothstep(0.05, 0.3, metal::dot(normal_1, view_1));
}

float outer_contour(
    float width_2,
    metal::float3 normal_2,
    metal::float3 view_2,
    metal::float2 viewport_1
) {
    float facing_1 = metal::clamp(metal::dot(normal_2, view_2), 0.0, 1.0);
    float pixels_1 = (width_2 * metal::clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0;
    float _e15 = footprint_of_2_(facing_1);
    float distance_1 = facing_1 / metal::max(2.0 * _e15, 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing_1);
    return metal::clamp((pixels_1 + 0.5) - distance_1, 0.0, metal::min(pixels_1, 1.0)) * near;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light _e3 = look.key;
    Light _e16 = local_light(_e3, metal::float3(0.9, 0.25, 0.5), 1.0, metal::float3(0.12, 0.42, 0.5), 0.5, 0.4, surface.position_object);
    Light _e29 = local_light(_e16, metal::float3(0.4, 0.1, 0.35), 1.0, metal::float3(-0.05, -0.35, 0.5), 0.4, 0.2, surface.position_object);
    Angle turned_from_the_light = Angle {0.5 * metal::length(surface.normal - _e29.direction), 0.5 * metal::length(surface.normal + _e29.direction)};
    float _e45 = profile_balanced(turned_from_the_light, 0.0, soft_tone_shape);
    float _e52 = length_of(surface.position_object - metal::float3(0.0, 0.02, 0.45));
    float _e55 = eased(_e52, 0.03, 0.3);
    float shadow_under_the_chin = metal::clamp(_e45 + ((1.0 - _e55) * -0.45), 0.0, 1.0);
    float _e70 = length_of(surface.position_object - metal::float3(-0.2, 0.72, 0.4));
    float _e73 = eased(_e70, 0.085, 0.17);
    float glint_on_the_brow = metal::clamp(shadow_under_the_chin + ((1.0 - _e73) * 0.5), 0.0, 1.0);
    float _e83 = footprint_of_2_(glint_on_the_brow);
    float _e87 = step_filtered(glint_on_the_brow, 0.55, metal::length(metal::float2(_e83, 0.0)));
    Composite _e100 = blend_alpha(metal::float4(0.36, 0.36, 0.6, 1.0), metal::float4(0.96, 0.72, 0.47, 1.0), _e87, 1.0, true);
    float _e102 = footprint_of_2_(glint_on_the_brow);
    float _e106 = step_filtered(glint_on_the_brow, 0.97, metal::length(metal::float2(_e102, 0.0)));
    metal::float4 brightest_light = metal::min(metal::float4(_e100.xyz + (_e106 * (metal::float3(1.0, 0.93, 0.76) - _e100.xyz)), 1.0), metal::float4(1.0));
    Light _e123 = look.back;
    float _e129 = rim(_e123, surface.normal, surface.view, 0.3, 0.1, 1.0);
    Composite _e137 = blend_alpha_2_(brightest_light, metal::float4(0.72, 0.86, 1.0, 1.0), _e129, 0.7, true);
    metal::float3x3 _e146 = look.camera_from_world;
    metal::float2 _e150 = look.viewport;
    float _e151 = inner_contour_suggestive(2.0, 20.0, 0.3, surface.curvature_tensor, surface.normal, surface.view, _e146, surface.position_camera, _e150);
    metal::float2 _e157 = look.viewport;
    float _e158 = outer_contour(3.0, surface.normal, surface.view, _e157);
    float all_lines = metal::max(_e158, _e151);
    Composite _e167 = blend_alpha_2_(_e137, metal::float4(0.17, 0.13, 0.28, 1.0), all_lines, 0.85, true);
    return _e167;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
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
, constant View& view_3 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_3 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_3.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
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
, constant View& view_3 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object, varyings_1.normal_3 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_3 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_3.eye;
    float _e13 = view_3.eye.w;
    metal::float4x4 _e21 = view_3.camera_from_world;
    metal::float4 _e32 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_3, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, (_e21 * metal::float4(in.position, 1.0)).xyz, _e32.xyz};
    metal::float4 _e35 = shade(surface_1, look);
    return fs_mainOutput { _e35 };
}
