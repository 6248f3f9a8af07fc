// Profile curves: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1).
// figure3-curves.json says what to put there and how to draw.
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
struct Surface {
    metal::float2 uv;
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
struct VectorParts {
    float x;
    float y;
    float z;
};
struct Vertex {
    metal::float3 position;
    metal::float2 uv;
    char _pad2[8];
};
struct Varyings {
    metal::float4 clip;
    metal::float2 uv;
    char _pad2[8];
};
constant float PI = 3.1415927;
constant ProfileShape lambert_shape = ProfileShape {1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u};
constant ProfileShape half_lambert_shape = ProfileShape {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u};
constant ProfileShape custom_shape = ProfileShape {0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928, 0.2351043, 0u};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

float finite_or(
    float x_1,
    float otherwise
) {
    bool _e2 = is_finite(x_1);
    return _e2 ? x_1 : otherwise;
}

metal::float2 sin_cos_quarter(
    float x_2
) {
    float h = 0.5 * x_2;
    float h2_ = h * h;
    float s_3 = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s_3) * c, 1.0 - ((2.0 * s_3) * s_3));
}

Angle angle_of(
    float radians
) {
    float _e2 = finite_or(radians, 0.0);
    float half_angle = 0.5 * metal::clamp(_e2, 0.0, PI);
    metal::float2 _e8 = sin_cos_quarter(half_angle);
    return Angle {metal::max(_e8.x, 0.0), metal::max(_e8.y, 0.0)};
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
    float s_4 = u_1.half_sin - (u_1.half_cos * 0.0);
    float c_1 = u_1.half_cos + (u_1.half_sin * 0.0);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_4, c_1);
    metal::float2 turned = ((s_4 <= 0.0) & (s_4 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float footprint_of(
    float x_3
) {
    float _e1 = metal::dfdx(x_3);
    float _e2 = metal::dfdy(x_3);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float step_filtered(
    float x_4,
    float edge,
    float w
) {
    float d_1 = x_4 - edge;
    return (w < 0.000000000000000000000000000001) ? ((d_1 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_1 / w), 0.0, 1.0);
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

Composite blend_alpha_3_(
    Composite below_2,
    Color color_2,
    float tone_2,
    float opacity_2,
    bool clamped_2
) {
    return metal::clamp(metal::float4(below_2.xyz + (tone_2 * (color_2.xyz - below_2.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return (s <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q * q), 0.0), 1.0);
}

float profile_soft_quick_2_(
    float s_1,
    ProfileShape shape_1
) {
    float q_1 = s_1 * shape_1.scale;
    return (s_1 <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q_1 * q_1), 0.0), shape_1.exponent);
}

float profile_soft_quick_3_(
    float s_2,
    ProfileShape shape_2
) {
    float q_2 = s_2 * shape_2.scale;
    return (s_2 <= 0.0) ? 1.0 : metal::pow(1.0 - (q_2 * q_2), shape_2.exponent);
}

float profile_filtered_quick(
    Angle u_2,
    float w_1,
    ProfileShape shape_3
) {
    metal::float2 place = metal::float2(u_2.half_sin - (u_2.half_cos * 0.0), u_2.half_cos + (u_2.half_sin * 0.0));
    float _e15 = profile_soft_quick(place.x, shape_3);
    if (w_1 < (0.1 * shape_3.edge_deviation)) {
        return _e15;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e41 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_3);
    float _e49 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_3);
    return (((5.0 * _e41) + (8.0 * _e15)) + (5.0 * _e49)) / 18.0;
}

float profile_filtered_quick_2_(
    Angle u_3,
    float w_2,
    ProfileShape shape_4
) {
    metal::float2 place_1 = metal::float2(u_3.half_sin - (u_3.half_cos * 0.0), u_3.half_cos + (u_3.half_sin * 0.0));
    float _e15 = profile_soft_quick_2_(place_1.x, shape_4);
    if (w_2 < (0.1 * shape_4.edge_deviation)) {
        return _e15;
    }
    float r_1 = 0.19364917 * w_2;
    metal::float2 turn_1 = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
    float _e41 = profile_soft_quick_3_((place_1.x * turn_1.y) - (place_1.y * turn_1.x), shape_4);
    float _e49 = profile_soft_quick_2_((place_1.x * turn_1.y) + (place_1.y * turn_1.x), shape_4);
    return (((5.0 * _e41) + (8.0 * _e15)) + (5.0 * _e49)) / 18.0;
}

float profile_filtered_quick_3_(
    Angle u_4,
    float w_3,
    ProfileShape shape_5
) {
    metal::float2 place_2 = metal::float2((u_4.half_sin * shape_5.half_cos_offset) - (u_4.half_cos * shape_5.half_sin_offset), (u_4.half_cos * shape_5.half_cos_offset) + (u_4.half_sin * shape_5.half_sin_offset));
    float _e19 = profile_soft_quick_2_(place_2.x, shape_5);
    if (w_3 < (0.1 * shape_5.edge_deviation)) {
        return _e19;
    }
    float r_2 = 0.19364917 * w_3;
    metal::float2 turn_2 = metal::float2(r_2 * (1.0 - ((0.16666667 * r_2) * r_2)), 1.0 - ((0.5 * r_2) * r_2));
    float _e45 = profile_soft_quick_2_((place_2.x * turn_2.y) - (place_2.y * turn_2.x), shape_5);
    float _e53 = profile_soft_quick_2_((place_2.x * turn_2.y) + (place_2.y * turn_2.x), shape_5);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_6
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_6);
    return _e8;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_7
) {
    Angle _e6 = angle_turned(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_balanced_3_(
    Angle angle_2,
    float shift_2,
    ProfileShape shape_8
) {
    Angle _e6 = angle_turned(angle_2, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_8);
    return _e8;
}

float threshold(
    float value,
    float edge_1,
    float softness
) {
    float _e3 = footprint_of(value);
    float _e6 = step_filtered(value, edge_1, metal::length(metal::float2(_e3, softness)));
    return _e6;
}

VectorParts separate_vector(
    metal::float3 vector
) {
    return VectorParts {vector.x, vector.y, 0.0};
}

metal::float4 shade(
    Surface surface
) {
    VectorParts _e4 = separate_vector(metal::float3(surface.uv, 0.0));
    float tone_3 = (_e4.y - 0.14) / 0.72;
    float _e12 = threshold(tone_3, -0.006, 0.0);
    float _e15 = threshold(tone_3, 0.006, 0.0);
    float angles_tone = metal::max(_e12 - _e15, 0.0);
    Composite _e31 = blend_alpha(metal::float4(0.98, 0.965, 0.925, 1.0), metal::float4(0.24, 0.26, 0.3, 1.0), angles_tone, 1.0, true);
    float angle_3 = metal::mix(0.0, 3.1415927, (_e4.x - 0.08) / 0.84);
    float _e42 = threshold(angle_3, -0.012, 0.0);
    float _e45 = threshold(angle_3, 0.012, 0.0);
    float tones_tone = metal::max(_e42 - _e45, 0.0);
    metal::float4 tones = metal::max(metal::float4(_e31.xyz + (tones_tone * (metal::float3(0.24, 0.26, 0.3) - _e31.xyz)), 1.0), metal::float4(0.0));
    float _e65 = threshold(angle_3, 0.492, 0.0);
    float _e68 = threshold(angle_3, 0.508, 0.0);
    float offset_tone = metal::max(_e65 - _e68, 0.0);
    Composite _e79 = blend_alpha_2_(tones, metal::float4(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55, true);
    float _e82 = threshold(angle_3, 0.942, 0.0);
    float _e85 = threshold(angle_3, 0.958, 0.0);
    float falloff_tone = metal::max(_e82 - _e85, 0.0);
    Composite _e96 = blend_alpha_2_(_e79, metal::float4(0.2, 0.38, 0.78, 1.0), falloff_tone, 0.55, true);
    float _e99 = threshold(angle_3, 1.792, 0.0);
    float _e102 = threshold(angle_3, 1.808, 0.0);
    float cutoff_tone = metal::max(_e99 - _e102, 0.0);
    Composite _e113 = blend_alpha_2_(_e96, metal::float4(0.2, 0.38, 0.78, 1.0), cutoff_tone, 0.55, true);
    Angle _e114 = angle_of(angle_3);
    float _e117 = profile_balanced(_e114, 0.0, lambert_shape);
    float lambert_off = tone_3 - _e117;
    float _e121 = threshold(lambert_off, -0.012, 0.0);
    float _e124 = threshold(lambert_off, 0.012, 0.0);
    float lambert_line = _e121 - _e124;
    float lambert_tone = metal::max(lambert_line, 0.0);
    Composite _e135 = blend_alpha_3_(_e113, metal::float4(0.8, 0.2, 0.17, 1.0), lambert_tone, 1.0, true);
    Angle _e136 = angle_of(angle_3);
    float _e139 = profile_balanced_2_(_e136, 0.0, half_lambert_shape);
    float half_lambert_off = tone_3 - _e139;
    float _e143 = threshold(half_lambert_off, 0.012, 0.0);
    float _e146 = threshold(half_lambert_off, -0.012, 0.0);
    float half_lambert_line = _e146 - _e143;
    float half_lambert_tone = metal::max(half_lambert_line, 0.0);
    Composite _e157 = blend_alpha_3_(_e135, metal::float4(0.18, 0.55, 0.27, 1.0), half_lambert_tone, 1.0, true);
    Angle _e158 = angle_of(angle_3);
    float _e161 = profile_balanced_3_(_e158, 0.0, custom_shape);
    float custom_off = tone_3 - _e161;
    float _e165 = threshold(custom_off, -0.012, 0.0);
    float _e168 = threshold(custom_off, 0.012, 0.0);
    float custom_line = _e165 - _e168;
    float custom_tone = metal::max(custom_line, 0.0);
    Composite _e179 = blend_alpha_3_(_e157, metal::float4(0.5, 0.31, 0.14, 1.0), custom_tone, 1.0, true);
    return _e179;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float2 uv [[attribute(3)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float2 uv [[user(loc0), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.uv };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    const auto _tmp = Varyings {_e10 * world, vertex_.uv};
    return vs_mainOutput { _tmp.clip, _tmp.uv };
}


struct fs_mainInput {
    metal::float2 uv [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
) {
    const Varyings in = { clip, varyings_1.uv };
    Surface surface_1 = Surface {in.uv};
    metal::float4 _e3 = shade(surface_1);
    return fs_mainOutput { _e3 };
}
