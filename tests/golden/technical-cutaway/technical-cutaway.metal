// Technical cutaway: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// technical-cutaway.json says what to put there and how to draw.
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
struct Shaded {
    metal::float4 value;
    metal::float4 color;
    float cutoff;
    char _pad3[12];
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
constant ProfileShape metal_tone_shape = ProfileShape {0.99820054, 0.059964005, 7.166244, 3.1997643, 0.12, 0.124456726, 0.0556771, 0u};
constant ProfileShape contour_tone_shape = ProfileShape {0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0, 1u};

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

metal::float2 sin_cos_quick(
    float x
) {
    float y = x * x;
    float s_3 = x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 0.0000026347564))))))));
    float c = 1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (0.00002477458 - (y * 0.00000026297516)))))))));
    return metal::float2(s_3, c);
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_4 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_4, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_4 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_4, c_1);
    metal::float2 turned = ((s_4 <= 0.0) & (s_4 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float bounded(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0);
}

float footprint_of(
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float step_filtered(
    float x_3,
    float edge,
    float w
) {
    float d_1 = x_3 - edge;
    if (w < 0.000000000000000000000000000001) {
        return (d_1 >= 0.0) ? 1.0 : 0.0;
    }
    float _e12 = bounded(d_1 / w);
    return metal::clamp(0.5 + _e12, 0.0, 1.0);
}

Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
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
    Color color_1,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (opacity * ((below.xyz + (tone * (color_1.xyz - below.xyz))) - below.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

Color output(
    Composite color_2
) {
    Color _e1 = straight(color_2);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

LitLayer light_apply(
    Light light,
    Color color_3,
    float tone_1
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_3.xyz * light.color) * split.y, 1.0), split.x};
}

LitLayer light_apply_2_(
    Light light_1,
    Color color_4,
    float tone_2
) {
    metal::float2 split_1 = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4(light_1.color * split_1.y, 1.0), tone_2 * split_1.x};
}

Angle parametrization_specular_balanced(
    Light light_2,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d_2 = ((2.0 * metal::dot(normal, view)) * normal) - view;
    return Angle {0.5 * metal::length(d_2 - light_2.direction), 0.5 * metal::length(d_2 + light_2.direction)};
}

Angle parametrization_screen_aligned_balanced(
    Light light_3,
    metal::float3 normal_1,
    metal::float3x3 camera_from_world
) {
    metal::float3 d_3 = camera_from_world * normal_1;
    return Angle {0.5 * metal::length(d_3 - light_3.own_direction), 0.5 * metal::length(d_3 + light_3.own_direction)};
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
    float w_1,
    ProfileShape shape_1
) {
    float width = metal::sqrt((w_1 * w_1) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_1.edge_mean - from_offset) / width), 0.0, 1.0);
    return (w_1 <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_ramp_quick_2_(
    float s_2,
    float w_2,
    ProfileShape shape_2
) {
    float width_1 = metal::sqrt(w_2 * w_2);
    float from_offset_1 = s_2 * (2.0 + ((s_2 * s_2) * 0.33333334));
    float ramp_1 = metal::clamp(0.5 + ((0.0 - from_offset_1) / metal::max(width_1, 0.000001)), 0.0, 1.0);
    return (w_2 <= 0.0) ? ((s_2 <= 0.0000004) ? 1.0 : 0.0) : ramp_1;
}

float profile_filtered_quick(
    Angle u_2,
    float w_3,
    ProfileShape shape_3
) {
    metal::float2 place = metal::float2((u_2.half_sin * shape_3.half_cos_offset) - (u_2.half_cos * shape_3.half_sin_offset), (u_2.half_cos * shape_3.half_cos_offset) + (u_2.half_sin * shape_3.half_sin_offset));
    bool is_narrow = (w_3 > 0.0) & (w_3 >= (3.4641016 * shape_3.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place.x, w_3, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_3);
    if (w_3 < (0.1 * shape_3.edge_deviation)) {
        return _e30;
    }
    float r = 0.19364917 * w_3;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e56 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_3);
    float _e64 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_3);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift_1);
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset), _e14, shape_5);
    return _e15;
}

Color gooch(
    Light light_4,
    metal::float3 normal_2,
    Color color_5,
    Color cool,
    Color warm,
    float cool_amount,
    float warm_amount
) {
    float t_1 = 0.5 + (0.5 * metal::dot(normal_2, light_4.direction));
    metal::float3 far = cool.xyz + (cool_amount * color_5.xyz);
    metal::float3 near = warm.xyz + (warm_amount * color_5.xyz);
    return metal::float4(metal::mix(far, near, metal::clamp(t_1, 0.0, 1.0)), 1.0);
}

Shaded shade(
    Surface surface,
    constant Look& look
) {
    Light _e3 = look.key;
    Color _e22 = gooch(_e3, surface.normal, metal::float4(0.8314, 0.8392, 0.8549, 1.0), metal::float4(0.1725, 0.2902, 0.4863, 1.0), metal::float4(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    metal::float4 cool_to_warm_2_ = metal::float4(metal::float3(1.0) + (_e22.xyz - metal::float3(1.0)), 1.0);
    float _e34 = transition_balanced(surface.kappa, 0.25);
    Color _e42 = curvature_color(_e34, metal::float4(1.0), metal::float4(0.5412, 0.5804, 0.6588, 1.0));
    Light _e45 = look.key;
    LitLayer _e47 = light_apply(_e45, _e42, 1.0);
    metal::float4 hollows_blend = metal::clamp(metal::float4(cool_to_warm_2_.xyz + (0.8 * ((cool_to_warm_2_.xyz * (_e47.tone * _e47.color.xyz)) - cool_to_warm_2_.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Light _e69 = look.key;
    Angle _e72 = parametrization_specular_balanced(_e69, surface.normal, surface.view);
    float _e75 = transition_balanced(surface.kappa, 0.2);
    float metal_warp = ((2.0 * _e75) - 1.0) * 0.05;
    float _e83 = profile_balanced(_e72, metal_warp, metal_tone_shape);
    Light _e86 = look.key;
    LitLayer _e89 = light_apply_2_(_e86, metal::float4(1.0), _e83);
    Composite _e94 = blend_alpha(hollows_blend, _e89.color, _e89.tone, 0.8, true);
    Light _e97 = look.eye;
    metal::float3x3 _e101 = look.camera_from_world;
    Angle _e102 = parametrization_screen_aligned_balanced(_e97, surface.normal, _e101);
    float _e105 = transition_balanced(surface.kappa, 0.12);
    float contour_warp = ((2.0 * _e105) - 1.0) * 0.25;
    float _e113 = profile_balanced_2_(_e102, contour_warp, contour_tone_shape);
    Light _e116 = look.eye;
    LitLayer _e119 = light_apply_2_(_e116, metal::float4(1.0), _e113);
    metal::float4 contour_blend = metal::clamp(metal::float4(_e94.xyz * (_e119.tone * _e119.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float3 place_1 = surface.position_object;
    VectorParts parts = VectorParts {surface.position_object[0], surface.position_object[1], surface.position_object[2]};
    float into_the_corner = metal::min(parts.x, parts.z);
    float _e142 = footprint_of(into_the_corner);
    float _e148 = step_filtered(into_the_corner, -0.012, metal::length(metal::float2(metal::min(_e142, 1000000000000000.0), 0.0)));
    metal::float4 section_line = metal::clamp(metal::float4(contour_blend.xyz + (_e148 * (metal::float3(0.8471, 0.1569, 0.1098) - contour_blend.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float _e166 = footprint_of(into_the_corner);
    float _e172 = step_filtered(into_the_corner, 0.02, metal::length(metal::float2(metal::min(_e166, 1000000000000000.0), 0.0)));
    float kept = 1.0 - _e172;
    metal::float4 cut = metal::float4(section_line.xyz, kept);
    Composite _e177 = premultiplied(cut);
    Color _e178 = output(_e177);
    return Shaded {_e178, _e178, 0.5};
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
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
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_3 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
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
    metal::float3 normal_3 [[user(loc2), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.position_object, varyings_1.normal_3 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_3 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e24 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_3, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, _e24.x};
    Shaded _e27 = shade(surface_1, look);
    if (_e27.color.w < _e27.cutoff) {
        metal::discard_fragment();
    }
    metal::float4 _e33 = finite_vec4_(_e27.value);
    return fs_mainOutput { _e33 };
}
