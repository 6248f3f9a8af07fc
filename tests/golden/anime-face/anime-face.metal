// Anime face: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// anime-face.json says what to put there and how to draw.
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
    Light back;
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
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant ProfileShape edge_of_the_shadow_shape = ProfileShape {0.7960838, 0.6051864, 15.395454, 2.8429606, 1.3, 0.060679536, 0.026670605, 0u};
constant ProfileShape lit_shape = ProfileShape {0.7775727, 0.628793, 0.0, 1.0, 1.36, 0.0, 0.0, 1u};
constant ProfileShape shine_tone_shape = ProfileShape {0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0, 1u};
constant ProfileShape rim_light_tone_shape = ProfileShape {0.90896577, 0.4168708, 0.0, 1.0, 0.86, 0.0, 0.0, 1u};
constant ProfileShape contour_tone_shape = ProfileShape {0.819648, 0.57286745, 0.0, 1.0, 1.22, 0.0, 0.0, 1u};

metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!(((largest > 0.000000000000000000000000000001) & true))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    return ((as_type<uint>(square) & 2139095040u) == 2139095040u) ? otherwise : (scaled * (1.0 / metal::sqrt(square)));
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float clamped_3 = metal::clamp(x, -126.0, 127.99999);
    float whole = metal::rint(clamped_3);
    float f = clamped_3 - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_1
) {
    float clamped_4 = metal::max(x_1, -126.0);
    float whole_1 = metal::rint(clamped_4);
    float f_1 = clamped_4 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_2
) {
    uint bits = as_type<uint>(x_2);
    int exponent_1 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

metal::float2 sin_cos_eighth(
    float x_3
) {
    float y_2 = x_3 * x_3;
    float s = x_3 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 0.0000027557319))))))));
    float c = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-0.000024801588 + (y_2 * 0.0000002755732)))))))));
    return metal::float2(s, c);
}

metal::float2 sin_cos_tiny(
    float x_4
) {
    float y_3 = x_4 * x_4;
    float s_1 = x_4 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334))));
    float c_1 = 1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889)))));
    return metal::float2(s_1, c_1);
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

float atan2_positive(
    float y_1,
    float x_5
) {
    float small = metal::min(y_1, x_5);
    float large = metal::max(y_1, x_5);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_2 = small / large;
    bool is_wide = t_2 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_2;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y_1 > x_5) ? (HALF_PI - a) : a;
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
    float s_2 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_2 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_2 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_2);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < c_2)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_3 = u_2.half_sin - (u_2.half_cos * 0.0);
    float c_3 = u_2.half_cos + (u_2.half_sin * 0.0);
    metal::float2 upper_1 = (c_3 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, c_3);
    metal::float2 turned_1 = ((s_3 <= 0.0) & (s_3 < c_3)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + (convexity * (convex - concave));
}

float curvature_signed(
    float kappa,
    float slope
) {
    float a_1 = (((as_type<uint>(kappa) & 2147483647u) > 2139095040u) ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0)) * slope;
    float magnitude = metal::min(metal::abs(a_1), 50.0);
    if (magnitude < 0.0625) {
        float a2_ = a_1 * a_1;
        return a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e32 = exp2_stable(-2.88539 * magnitude);
    float t_3 = (1.0 - _e32) / (1.0 + _e32);
    return (a_1 >= 0.0) ? t_3 : -(t_3);
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

Composite blend_shade(
    Composite below_1,
    Color color_1,
    float tone_1,
    float opacity_1,
    bool clamped_1
) {
    return metal::min(metal::float4(below_1.xyz + (opacity_1 * ((below_1.xyz * metal::mix(metal::float3(1.0), color_1.xyz, tone_1)) - below_1.xyz)), 1.0), metal::float4(1.0));
}

Composite blend_shade_2_(
    Composite below_2,
    Color color_2,
    float tone_2,
    float opacity_2,
    bool clamped_2
) {
    return metal::clamp(metal::float4(below_2.xyz + (opacity_2 * ((below_2.xyz * metal::mix(metal::float3(1.0), color_2.xyz, tone_2)) - below_2.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_3,
    float tone_3
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_3.xyz * light.color) * split.y, 1.0), split.x};
}

LitLayer light_apply_2_(
    Light light_1,
    Color color_4,
    float tone_4
) {
    metal::float2 split_1 = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4(light_1.color * split_1.y, 1.0), tone_4 * split_1.x};
}

LitLayer light_apply_3_(
    Light light_2,
    Color color_5,
    float tone_5
) {
    metal::float2 split_2 = metal::float2(metal::min(light_2.intensity, 1.0), metal::max(light_2.intensity, 1.0));
    return LitLayer {metal::float4((color_5.xyz * light_2.color) * split_2.y, 1.0), tone_5 * split_2.x};
}

Angle parametrization_diffuse(
    Light light_3,
    metal::float3 normal
) {
    metal::float3 _e6 = normalize_moderate(normal, metal::float3(0.0, 0.0, 1.0));
    return Angle {0.5 * metal::length(_e6 - light_3.direction), 0.5 * metal::length(_e6 + light_3.direction)};
}

Angle parametrization_specular(
    Light light_4,
    metal::float3 normal_1,
    metal::float3 view
) {
    metal::float3 mirrored = ((2.0 * metal::dot(normal_1, view)) * normal_1) - view;
    metal::float3 _e8 = normalize_moderate(mirrored, normal_1);
    return Angle {0.5 * metal::length(_e8 - light_4.direction), 0.5 * metal::length(_e8 + light_4.direction)};
}

Angle parametrization_screen_aligned(
    Light light_5,
    metal::float3 normal_2,
    metal::float3x3 camera_from_world
) {
    metal::float3 n = camera_from_world * normal_2;
    metal::float3 _e8 = normalize_moderate(n, metal::float3(0.0, 0.0, 1.0));
    return Angle {0.5 * metal::length(_e8 - light_5.own_direction), 0.5 * metal::length(_e8 + light_5.own_direction)};
}

float profile_power(
    float q,
    float exponent
) {
    float log_base = 0.0;
    if (q >= 1.0) {
        return 0.0;
    }
    if (q < 0.5) {
        float _e11 = log1p_negative_small(q * q);
        log_base = LOG2_E * _e11;
    } else {
        float _e18 = log2_stable((1.0 - q) * (1.0 + q));
        log_base = _e18;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable_2_(exponent * _e19);
    return metal::min(_e21, 1.0);
}

float profile_point(
    Angle u_3,
    ProfileShape shape
) {
    float s_4 = (u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset);
    if ((s_4 <= 0.0) | false) {
        return 1.0;
    }
    float q_1 = s_4 * shape.scale;
    float _e17 = profile_power(q_1, shape.exponent);
    return _e17;
}

float profile_point_2_(
    Angle u_4,
    ProfileShape shape_1
) {
    float s_5 = (u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset);
    return ((s_5 <= 0.0) | false) ? 1.0 : ((s_5 <= 0.0000004) ? 1.0 : 0.0);
}

float profile_filtered(
    Angle u_5,
    float w,
    ProfileShape shape_2
) {
    float _e3 = profile_point(u_5, shape_2);
    bool is_wide_1 = w < (0.1 * shape_2.edge_deviation);
    if ((is_wide_1 | (w <= 0.0)) | false) {
        return _e3;
    }
    if (true & (w >= (3.4641016 * shape_2.edge_deviation))) {
        float width = metal::sqrt((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation));
        float _e32 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return metal::clamp(0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e32)) / width), 0.0, 1.0);
    }
    metal::float2 _e44 = sin_cos_tiny(0.19364917 * w);
    Angle _e45 = angle_turned(u_5, _e44);
    float _e46 = profile_point(_e45, shape_2);
    Angle _e51 = angle_turned(u_5, metal::float2(-(_e44.x), _e44.y));
    float _e52 = profile_point(_e51, shape_2);
    return (((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0;
}

float profile_filtered_2_(
    Angle u_6,
    float w_1,
    ProfileShape shape_3
) {
    float _e3 = profile_point_2_(u_6, shape_3);
    if ((false | (w_1 <= 0.0)) | false) {
        return _e3;
    }
    float width_1 = metal::sqrt(w_1 * w_1);
    float _e15 = atan2_positive(u_6.half_sin, u_6.half_cos);
    return metal::clamp(0.5 + ((shape_3.offset - (2.0 * _e15)) / width_1), 0.0, 1.0);
}

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    Angle _e6 = angle_turned_2_(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_4);
    return _e8;
}

float profile_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    Angle _e6 = angle_turned_2_(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_5);
    return _e8;
}

float profile_3_(
    Angle angle_2,
    float shift_2,
    ProfileShape shape_6
) {
    metal::float2 _e5 = sin_cos_tiny(0.5 * shift_2);
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_6);
    return _e8;
}

float profile_4_(
    Angle angle_3,
    float shift_3,
    ProfileShape shape_7
) {
    metal::float2 _e5 = sin_cos_eighth(0.5 * shift_3);
    Angle _e6 = angle_turned(angle_3, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    metal::float3 normal_3 = surface_1.normal;
    metal::float3 place = surface_1.position_object;
    metal::float3 from_the_face_s_middle = place - metal::float3(0.0, 0.52, -0.18);
    metal::float3 flattened = from_the_face_s_middle * metal::float3(1.0, 0.35, 1.0);
    metal::float3 _e15 = normalize_or(flattened, metal::float3(0.0));
    VectorParts high = VectorParts {surface_1.position_object[0], surface_1.position_object[1], surface_1.position_object[2]};
    float is_face = metal::smoothstep(0.02, 0.16, high.y);
    metal::float3 face_or_body = metal::mix(normal_3, _e15, is_face);
    metal::float3 _e27 = normalize_moderate(face_or_body, metal::float3(0.0));
    Light _e30 = look.key;
    Angle _e31 = parametrization_diffuse(_e30, _e27);
    float _e34 = profile(_e31, 0.0, edge_of_the_shadow_shape);
    float soft_dark = 1.0 - _e34;
    Composite _e49 = blend_shade(metal::float4(0.9843, 0.8902, 0.8118, 1.0), metal::float4(0.9412, 0.5412, 0.4157, 1.0), soft_dark, 0.55, true);
    float _e52 = profile_2_(_e31, 0.0, lit_shape);
    float in_shadow = 1.0 - _e52;
    Composite _e62 = blend_shade_2_(_e49, metal::float4(0.698, 0.4784, 0.6588, 1.0), in_shadow, 0.85, true);
    float _e65 = curvature_signed(surface_1.kappa, 0.55);
    float inked_hollows_convexity = 0.5 + (0.5 * _e65);
    Color _e77 = curvature_color(inked_hollows_convexity, metal::float4(1.0), metal::float4(0.2902, 0.1412, 0.251, 1.0));
    Light _e80 = look.eye;
    LitLayer _e82 = light_apply(_e80, _e77, 1.0);
    metal::float4 inked_hollows_blend = metal::clamp(metal::float4(_e62.xyz + (0.9 * ((_e62.xyz * (_e82.tone * _e82.color.xyz)) - _e62.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Light _e104 = look.key;
    Angle _e107 = parametrization_specular(_e104, surface_1.normal, surface_1.view);
    float _e110 = curvature_signed(surface_1.kappa, 0.2);
    float rim_light_convexity = 0.5 + (0.5 * _e110);
    float shine_warp = ((2.0 * rim_light_convexity) - 1.0) * 0.05;
    float _e122 = profile_3_(_e107, shine_warp, shine_tone_shape);
    Light _e125 = look.key;
    LitLayer _e128 = light_apply_2_(_e125, metal::float4(1.0), _e122);
    Composite _e133 = blend_alpha(inked_hollows_blend, _e128.color, _e128.tone, 0.85, true);
    metal::float3 _e138 = look.back.direction;
    metal::float3 _e147 = look.back.direction;
    Angle rim_light_angle = Angle {0.5 * metal::length(surface_1.normal - _e138), 0.5 * metal::length(surface_1.normal + _e147)};
    float rim_light_warp = ((2.0 * rim_light_convexity) - 1.0) * 0.15;
    float _e160 = profile_3_(rim_light_angle, rim_light_warp, rim_light_tone_shape);
    Light _e163 = look.back;
    LitLayer _e169 = light_apply_3_(_e163, metal::float4(1.0, 0.9647, 0.9176, 1.0), _e160);
    Composite _e174 = blend_alpha(_e133, _e169.color, _e169.tone, 0.9, true);
    Light _e177 = look.eye;
    metal::float3x3 _e181 = look.camera_from_world;
    Angle _e182 = parametrization_screen_aligned(_e177, surface_1.normal, _e181);
    float _e185 = curvature_signed(surface_1.kappa, 0.12);
    float contour_convexity = 0.5 + (0.5 * _e185);
    float contour_warp = ((2.0 * contour_convexity) - 1.0) * 0.28;
    float _e197 = profile_4_(_e182, contour_warp, contour_tone_shape);
    Light _e200 = look.eye;
    LitLayer _e203 = light_apply_2_(_e200, metal::float4(1.0), _e197);
    metal::float4 output = metal::clamp(metal::float4(_e174.xyz * (_e203.tone * _e203.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return output;
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
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_1.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    out.position_object = vertex_.position;
    metal::float3x3 _e21 = object.world_from_normal;
    out.normal = _e21 * vertex_.normal;
    Varyings _e24 = out;
    const auto _tmp = _e24;
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
    Surface surface = {};
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_4 = is_front ? _e3 : -(_e3);
    surface.normal = normal_4;
    metal::float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = metal::normalize(_e11.xyz - (_e16 * in.position));
    surface.position_object = in.position_object;
    metal::float4 _e29 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.kappa = _e29.x;
    Surface _e31 = surface;
    metal::float4 _e32 = shade(_e31, look);
    return fs_mainOutput { _e32 };
}
