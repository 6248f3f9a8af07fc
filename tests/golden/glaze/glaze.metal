// Grisaille and glaze: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_2 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// glaze.json says what to put there and how to draw.
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
    Light back;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::packed_float3 position_object;
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
struct VectorParts {
    float x;
    float y;
    float z;
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
constant ProfileShape gray_modeling_tone_shape = ProfileShape {1.0, 0.0, 1.0537579, 1.3909147, 0.0, 1.2772532, 0.561292, 0u};
constant ProfileShape gray_lights_tone_shape = ProfileShape {0.99875027, 0.04997917, 2.0858297, 3.3126261, 0.1, 0.42646712, 0.19445144, 0u};

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

metal::float3 normalize_moderate(
    metal::float3 v_1,
    metal::float3 otherwise
) {
    float square = metal::dot(v_1, v_1);
    return (square > 0.000000000000000000000000000001) ? (v_1 * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
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

metal::float3 bounded_vec3_(
    metal::float3 v_3
) {
    metal::uint3 bits = as_type<metal::uint3>(v_3);
    metal::uint3 magnitude = bits & metal::uint3(2147483647u);
    metal::float3 largest = as_type<metal::float3>((bits & metal::uint3(2147483648u)) | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest, magnitude == metal::uint3(2139095040u));
    return metal::select(numbers, v_3, magnitude < metal::uint3(2139095040u));
}

metal::float3 mixed_vec3_(
    metal::float3 a,
    metal::float3 b,
    float t_1
) {
    metal::float3 _e4 = bounded_vec3_(b - a);
    metal::float3 _e14 = bounded_vec3_((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4)));
    return _e14;
}

float footprint_of(
    float x
) {
    float _e1 = metal::dfdx(x);
    float _e2 = metal::dfdy(x);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float soft_light(
    float a_1,
    float b_1
) {
    float curved = (a_1 <= 0.25) ? (((((16.0 * a_1) - 12.0) * a_1) + 4.0) * a_1) : metal::sqrt(metal::max(a_1, 0.0));
    return a_1 + (((2.0 * b_1) - 1.0) * (curved - a_1));
}

metal::float4 color_mixed(
    metal::float4 a_2,
    metal::float3 blended,
    float factor
) {
    metal::float3 _e3 = bounded_vec3_(blended);
    metal::float3 _e8 = bounded_vec3_(_e3 - a_2.xyz);
    metal::float3 _e11 = bounded_vec3_(_e3 - ((1.0 - factor) * _e8));
    return metal::float4(_e11, 1.0);
}

float lightness_of(
    metal::float3 rgb
) {
    return metal::dot(rgb, metal::float3(0.3, 0.59, 0.11));
}

metal::float3 lit_as(
    metal::float3 rgb_1,
    metal::float3 other
) {
    float _e2 = lightness_of(other);
    float _e3 = lightness_of(rgb_1);
    metal::float3 moved = rgb_1 + metal::float3(_e2 - _e3);
    float least = metal::min(metal::min(moved.x, moved.y), moved.z);
    float largest_1 = metal::max(metal::max(moved.x, moved.y), moved.z);
    float raised = (least < 0.0) ? (_e2 / metal::max(_e2 - least, 0.000001)) : 1.0;
    metal::float3 clipped = metal::float3(_e2) + ((moved - metal::float3(_e2)) * raised);
    float top = _e2 + ((largest_1 - _e2) * raised);
    float lowered = (top > 1.0) ? ((1.0 - _e2) / metal::max(top - _e2, 0.000001)) : 1.0;
    return metal::float3(_e2) + ((clipped - metal::float3(_e2)) * lowered);
}

Color mix_colors_screen(
    Color a_3,
    Color b_2,
    float factor_1
) {
    metal::float3 _e4 = bounded_vec3_(a_3.xyz);
    metal::float3 _e12 = bounded_vec3_((a_3.xyz + b_2.xyz) - (a_3.xyz * b_2.xyz));
    metal::float3 _e13 = mixed_vec3_(_e4, _e12, factor_1);
    return metal::float4(_e13, 1.0);
}

Color mix_colors_soft_light(
    Color a_4,
    Color b_3,
    float factor_2
) {
    float _e5 = soft_light(a_4.x, b_3.x);
    float _e8 = soft_light(a_4.y, b_3.y);
    metal::float4 _e23 = color_mixed(a_4, metal::float3(_e5, _e8, a_4.z - (((1.0 - (2.0 * b_3.z)) * a_4.z) * (1.0 - a_4.z))), factor_2);
    return _e23;
}

Color mix_colors_hue(
    Color a_5,
    Color b_4,
    float factor_3
) {
    metal::float3 _e4 = bounded_vec3_(a_5.xyz);
    metal::float3 below_1 = metal::clamp(_e4, metal::float3(0.0), metal::float3(1.0));
    metal::float3 _e11 = bounded_vec3_(a_5.xyz);
    metal::float3 _e32 = lit_as((b_4.xyz - metal::float3(b_4.y)) * ((metal::max(metal::max(below_1.x, below_1.y), below_1.z) - metal::min(metal::min(below_1.x, below_1.y), below_1.z)) / (b_4.x - b_4.y)), below_1);
    metal::float3 _e35 = mixed_vec3_(_e11, _e32, metal::max(factor_3, 0.0));
    return metal::float4(_e35, 1.0);
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

Angle parametrization_specular_balanced(
    Light light_1,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d_1 = ((2.0 * metal::dot(normal, view)) * normal) - view;
    return Angle {0.5 * metal::length(d_1 - light_1.direction), 0.5 * metal::length(d_1 + light_1.direction)};
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
    metal::float2 place = metal::float2(u_2.half_sin - 0.0, u_2.half_cos);
    float _e9 = profile_soft_quick(place.x, shape_1);
    if (w < (0.1 * shape_1.edge_deviation)) {
        return _e9;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e35 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_1);
    float _e43 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_1);
    return (((5.0 * _e35) + (8.0 * _e9)) + (5.0 * _e43)) / 18.0;
}

float profile_filtered_quick_2_(
    Angle u_3,
    float w_1,
    ProfileShape shape_2
) {
    metal::float2 place_1 = metal::float2((u_3.half_sin * shape_2.half_cos_offset) - (u_3.half_cos * shape_2.half_sin_offset), (u_3.half_cos * shape_2.half_cos_offset) + (u_3.half_sin * shape_2.half_sin_offset));
    float _e19 = profile_soft_quick(place_1.x, shape_2);
    if (w_1 < (0.1 * shape_2.edge_deviation)) {
        return _e19;
    }
    float r_1 = 0.19364917 * w_1;
    metal::float2 turn_1 = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
    float _e45 = profile_soft_quick((place_1.x * turn_1.y) - (place_1.y * turn_1.x), shape_2);
    float _e53 = profile_soft_quick((place_1.x * turn_1.y) + (place_1.y * turn_1.x), shape_2);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
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

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_4
) {
    Angle _e6 = angle_turned(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_4);
    return _e8;
}

float rim(
    Light light_2,
    metal::float3 normal_1,
    metal::float3 view_1,
    float width,
    float softness,
    float follow
) {
    float facing = metal::clamp(metal::dot(normal_1, view_1), 0.0, 1.0);
    float _e11 = footprint_of(facing);
    float edge = metal::max(width * softness, metal::min(_e11, 1.0));
    metal::float3 aside = normal_1 - view_1;
    float further = (facing > 0.5) ? ((0.5 * metal::dot(aside, aside)) - (1.0 - width)) : (width - facing);
    float within = (further / edge) + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across = light_2.direction - (metal::dot(light_2.direction, view_1) * view_1);
    float side = metal::dot(normal_1 - (metal::dot(normal_1, view_1) * view_1), across * metal::rsqrt(metal::max(metal::dot(across, across), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side), follow);
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle gray_modeling_angle = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    float _e22 = profile_balanced(gray_modeling_angle, 0.0, gray_modeling_tone_shape);
    Light _e25 = look.key;
    LitLayer _e31 = light_apply(_e25, metal::float4(0.7059, 0.7059, 0.7059, 1.0), _e22);
    Composite _e41 = blend_alpha(metal::float4(0.1216, 0.1216, 0.1216, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = look.key;
    Angle _e47 = parametrization_specular_balanced(_e44, surface.normal, surface.view);
    float _e50 = profile_balanced_2_(_e47, 0.0, gray_lights_tone_shape);
    Light _e53 = look.key;
    LitLayer _e59 = light_apply(_e53, metal::float4(0.2902, 0.2902, 0.2902, 1.0), _e50);
    metal::float4 gray_lights_blend = metal::clamp(metal::float4(_e41.xyz + (_e59.tone * _e59.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float4 grisaille = metal::float4(gray_lights_blend.xyz, 1.0);
    metal::float3 _e82 = lit_as(metal::float3(0.4275, 0.5412, 0.4471), grisaille.xyz);
    metal::float4 glaze_of_green_earth = metal::float4(metal::mix(grisaille.xyz, _e82, 0.75), 1.0);
    metal::float3 _e93 = lit_as(metal::float3(0.7098, 0.4667, 0.3098), grisaille.xyz);
    metal::float4 glaze_of_sienna = metal::float4(metal::mix(grisaille.xyz, _e93, 0.7), 1.0);
    metal::float3 place_2 = surface.position_object;
    VectorParts height = VectorParts {surface.position_object[0], surface.position_object[1], surface.position_object[2]};
    float toward_the_head = metal::smoothstep(-0.5, 0.5, height.y);
    metal::float4 from_green_to_sienna = metal::mix(glaze_of_green_earth, glaze_of_sienna, toward_the_head);
    Color _e114 = mix_colors_soft_light(from_green_to_sienna, metal::float4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    float curvature = surface.kappa;
    float bulge = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.06, -20.0, 20.0))))));
    float hollows = metal::mix(0.6, 0.0, metal::min((bulge - 0.0) / 0.55, 1.0));
    Color _e148 = mix_colors_hue(_e114, metal::float4(0.4902, 0.2471, 0.3608, 1.0), hollows);
    Light _e151 = look.back;
    float _e157 = rim(_e151, surface.normal, surface.view, 0.3, 0.6, 1.0);
    Color _e163 = mix_colors_screen(_e148, metal::float4(0.4353, 0.5294, 0.6588, 1.0), _e157);
    metal::float4 _e164 = finite_vec4_(_e163);
    return _e164;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_2 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_2.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_2 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_2 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.position_object, varyings_1.normal_2 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_2 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    metal::float4 _e24 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_2, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, _e24.x};
    metal::float4 _e27 = shade(surface_1, look);
    metal::float4 _e28 = finite_vec4_(_e27);
    return fs_mainOutput { _e28 };
}
