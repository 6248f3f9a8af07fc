// Technical cutaway: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws normals and depth, for the curvature pass.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
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
    metal::float3 value;
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
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant ProfileShape metal_tone_shape = ProfileShape {0.99820054, 0.059964005, 7.166244, 3.1997643, 0.12, 0.124456726, 0.0556771, 0u};
constant ProfileShape contour_tone_shape = ProfileShape {0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0, 1u};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent_1 = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent_1) != exponent_1);
}

metal::float3 normalize_or(
    metal::float3 v_1,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v_1.x), metal::abs(v_1.y)), metal::abs(v_1.z));
    if (!(((largest > 0.000000000000000000000000000001) & (largest < 1000000000000000000000000000000.0)))) {
        return otherwise;
    }
    metal::float3 scaled = v_1 * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x_1
) {
    float clamped_1 = metal::clamp(x_1, -126.0, 127.99999);
    float whole = metal::rint(clamped_1);
    float f = clamped_1 - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_2
) {
    float clamped_2 = metal::max(x_2, -126.0);
    float whole_1 = metal::rint(clamped_2);
    float f_1 = clamped_2 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    int exponent_2 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_2) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_2) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

metal::float2 sin_cos_eighth(
    float x_4
) {
    float y_2 = x_4 * x_4;
    float s = x_4 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 0.0000027557319))))))));
    float c = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-0.000024801588 + (y_2 * 0.0000002755732)))))))));
    return metal::float2(s, c);
}

metal::float2 sin_cos_tiny(
    float x_5
) {
    float y_3 = x_5 * x_5;
    float s_1 = x_5 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334))));
    float c_1 = 1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889)))));
    return metal::float2(s_1, c_1);
}

metal::float3 normalize_moderate(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    float square_1 = metal::dot(v_2, v_2);
    return (square_1 > 0.000000000000000000000000000001) ? (v_2 * metal::rsqrt(metal::max(square_1, 0.000000000000000000000000000001))) : otherwise_1;
}

metal::float3 normalize_seen(
    metal::float3 v_3
) {
    metal::float3 _e5 = normalize_moderate(v_3, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(
    float y_1,
    float x_6
) {
    float small = metal::min(y_1, x_6);
    float large = metal::max(y_1, x_6);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_1 = small / large;
    bool is_wide = t_1 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_1;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y_1 > x_6) ? (HALF_PI - a) : a;
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_3 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_3, 0.5);
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

float bounded(
    float x_7
) {
    uint bits_1 = as_type<uint>(x_7);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_7 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

float footprint_of(
    float x_8
) {
    float _e1 = metal::dfdx(x_8);
    float _e2 = metal::dfdy(x_8);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float step_filtered(
    float x_9,
    float edge,
    float w
) {
    float d_1 = x_9 - edge;
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

metal::float2 slope_of(
    metal::float3 normal
) {
    return normal.xy / metal::float2(metal::max(normal.z, 0.2));
}

metal::float4 surface_texel(
    metal::float3 normal_1,
    float depth,
    float number
) {
    metal::float2 _e3 = slope_of(normal_1);
    return metal::float4(_e3, depth, (normal_1.z < 0.0) ? -(number) : number);
}

float curvature_signed(
    float kappa,
    float slope
) {
    float a_1 = (((as_type<uint>(kappa) & 2147483647u) > 2139095040u) ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0)) * 0.25;
    float magnitude_1 = metal::min(metal::abs(a_1), 50.0);
    if (magnitude_1 < 0.0625) {
        float a2_ = a_1 * a_1;
        return a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e33 = exp2_stable(-2.88539 * magnitude_1);
    float t_2 = (1.0 - _e33) / (1.0 + _e33);
    return (a_1 >= 0.0) ? t_2 : -(t_2);
}

float curvature_signed_2_(
    float kappa_1,
    float slope_1
) {
    float a_2 = (((as_type<uint>(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : metal::clamp(kappa_1, -10000.0, 10000.0)) * slope_1;
    float magnitude_2 = metal::min(metal::abs(a_2), 50.0);
    if (magnitude_2 < 0.0625) {
        float a2_1 = a_2 * a_2;
        return a_2 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254))))));
    }
    float _e32 = exp2_stable(-2.88539 * magnitude_2);
    float t_3 = (1.0 - _e32) / (1.0 + _e32);
    return (a_2 >= 0.0) ? t_3 : -(t_3);
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

Angle parametrization_specular(
    Light light_2,
    metal::float3 normal_2,
    metal::float3 view
) {
    metal::float3 mirrored = ((2.0 * metal::dot(normal_2, view)) * normal_2) - view;
    metal::float3 _e8 = normalize_moderate(mirrored, normal_2);
    return Angle {0.5 * metal::length(_e8 - light_2.direction), 0.5 * metal::length(_e8 + light_2.direction)};
}

Angle parametrization_screen_aligned(
    Light light_3,
    metal::float3 normal_3,
    metal::float3x3 camera_from_world
) {
    metal::float3 n = camera_from_world * normal_3;
    metal::float3 _e8 = normalize_moderate(n, metal::float3(0.0, 0.0, 1.0));
    return Angle {0.5 * metal::length(_e8 - light_3.own_direction), 0.5 * metal::length(_e8 + light_3.own_direction)};
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
    Angle u_2,
    ProfileShape shape
) {
    float s_3 = (u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset);
    if ((s_3 <= 0.0) | false) {
        return 1.0;
    }
    float q_1 = s_3 * shape.scale;
    float _e17 = profile_power(q_1, shape.exponent);
    return _e17;
}

float profile_point_2_(
    Angle u_3,
    ProfileShape shape_1
) {
    float s_4 = (u_3.half_sin * shape_1.half_cos_offset) - (u_3.half_cos * shape_1.half_sin_offset);
    return ((s_4 <= 0.0) | false) ? 1.0 : ((s_4 <= 0.0000004) ? 1.0 : 0.0);
}

float profile_filtered(
    Angle u_4,
    float w_1,
    ProfileShape shape_2
) {
    float _e3 = profile_point(u_4, shape_2);
    bool is_wide_1 = w_1 < (0.1 * shape_2.edge_deviation);
    if ((is_wide_1 | (w_1 <= 0.0)) | false) {
        return _e3;
    }
    if (true & (w_1 >= (3.4641016 * shape_2.edge_deviation))) {
        float width = metal::sqrt((w_1 * w_1) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation));
        float _e32 = atan2_positive(u_4.half_sin, u_4.half_cos);
        return metal::clamp(0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e32)) / width), 0.0, 1.0);
    }
    metal::float2 _e44 = sin_cos_tiny(0.19364917 * w_1);
    Angle _e45 = angle_turned(u_4, _e44);
    float _e46 = profile_point(_e45, shape_2);
    Angle _e51 = angle_turned(u_4, metal::float2(-(_e44.x), _e44.y));
    float _e52 = profile_point(_e51, shape_2);
    return (((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0;
}

float profile_filtered_2_(
    Angle u_5,
    float w_2,
    ProfileShape shape_3
) {
    float _e3 = profile_point_2_(u_5, shape_3);
    if ((false | (w_2 <= 0.0)) | false) {
        return _e3;
    }
    float width_1 = metal::sqrt(w_2 * w_2);
    float _e15 = atan2_positive(u_5.half_sin, u_5.half_cos);
    return metal::clamp(0.5 + ((shape_3.offset - (2.0 * _e15)) / width_1), 0.0, 1.0);
}

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    metal::float2 _e5 = sin_cos_tiny(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_4);
    return _e8;
}

float profile_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    metal::float2 _e5 = sin_cos_eighth(0.5 * shift_1);
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_5);
    return _e8;
}

Color gooch(
    Light light_4,
    metal::float3 normal_4,
    Color color_5,
    Color cool,
    Color warm,
    float cool_amount,
    float warm_amount
) {
    float t_4 = 0.5 + (0.5 * metal::dot(normal_4, light_4.direction));
    metal::float3 far = cool.xyz + (cool_amount * color_5.xyz);
    metal::float3 near = warm.xyz + (warm_amount * color_5.xyz);
    return metal::float4(metal::mix(far, near, metal::clamp(t_4, 0.0, 1.0)), 1.0);
}

Shaded shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    Color _e22 = gooch(_e3, surface_1.normal, metal::float4(0.8314, 0.8392, 0.8549, 1.0), metal::float4(0.1725, 0.2902, 0.4863, 1.0), metal::float4(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    metal::float4 cool_to_warm_2_ = metal::float4(metal::float3(1.0) + (_e22.xyz - metal::float3(1.0)), 1.0);
    float _e34 = curvature_signed(surface_1.kappa, 0.25);
    float hollows_convexity = 0.5 + (0.5 * _e34);
    Color _e46 = curvature_color(hollows_convexity, metal::float4(1.0), metal::float4(0.5412, 0.5804, 0.6588, 1.0));
    Light _e49 = look.key;
    LitLayer _e51 = light_apply(_e49, _e46, 1.0);
    metal::float4 hollows_blend = metal::clamp(metal::float4(cool_to_warm_2_.xyz + (0.8 * ((cool_to_warm_2_.xyz * (_e51.tone * _e51.color.xyz)) - cool_to_warm_2_.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Light _e73 = look.key;
    Angle _e76 = parametrization_specular(_e73, surface_1.normal, surface_1.view);
    float _e79 = curvature_signed_2_(surface_1.kappa, 0.2);
    float metal_convexity = 0.5 + (0.5 * _e79);
    float metal_warp = ((2.0 * metal_convexity) - 1.0) * 0.05;
    float _e91 = profile(_e76, metal_warp, metal_tone_shape);
    Light _e94 = look.key;
    LitLayer _e97 = light_apply_2_(_e94, metal::float4(1.0), _e91);
    Composite _e102 = blend_alpha(hollows_blend, _e97.color, _e97.tone, 0.8, true);
    Light _e105 = look.eye;
    metal::float3x3 _e109 = look.camera_from_world;
    Angle _e110 = parametrization_screen_aligned(_e105, surface_1.normal, _e109);
    float _e113 = curvature_signed_2_(surface_1.kappa, 0.12);
    float contour_convexity = 0.5 + (0.5 * _e113);
    float contour_warp = ((2.0 * contour_convexity) - 1.0) * 0.25;
    float _e125 = profile_2_(_e110, contour_warp, contour_tone_shape);
    Light _e128 = look.eye;
    LitLayer _e131 = light_apply_2_(_e128, metal::float4(1.0), _e125);
    metal::float4 contour_blend = metal::clamp(metal::float4(_e102.xyz * (_e131.tone * _e131.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float3 place = surface_1.position_object;
    VectorParts parts = VectorParts {surface_1.position_object[0], surface_1.position_object[1], surface_1.position_object[2]};
    float into_the_corner = metal::min(parts.x, parts.z);
    float _e154 = footprint_of(into_the_corner);
    float _e160 = step_filtered(into_the_corner, -0.012, metal::length(metal::float2(metal::min(_e154, 1000000000000000.0), 0.0)));
    metal::float4 section_line = metal::clamp(metal::float4(contour_blend.xyz + (_e160 * (metal::float3(0.8471, 0.1569, 0.1098) - contour_blend.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float _e178 = footprint_of(into_the_corner);
    float _e184 = step_filtered(into_the_corner, 0.02, metal::length(metal::float2(metal::min(_e178, 1000000000000000.0), 0.0)));
    float kept = 1.0 - _e184;
    metal::float4 cut = metal::float4(section_line.xyz, kept);
    Composite _e189 = premultiplied(cut);
    Color _e190 = output(_e189);
    return Shaded {surface_1.normal, _e190, 0.5};
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_5 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_5 };
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


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_5 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.position_object, varyings_1.normal_5 };
    bool local = {};
    Surface surface = {};
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float4 _e6 = view_1.eye;
    float _e11 = view_1.eye.w;
    metal::float3 _e15 = normalize_or(_e6.xyz - (_e11 * in.position), _e3);
    if (!(is_front)) {
        local = metal::dot(_e3, _e15) < -0.1;
    } else {
        local = false;
    }
    bool is_behind = local;
    metal::float3 normal_5 = is_behind ? -(_e3) : _e3;
    surface.normal = normal_5;
    metal::float4 _e31 = view_1.eye;
    float _e36 = view_1.eye.w;
    surface.view = metal::normalize(_e31.xyz - (_e36 * in.position));
    surface.position_object = in.position_object;
    surface.kappa = 0.0;
    Surface _e45 = surface;
    Shaded _e46 = shade(_e45, look);
    if (_e46.color.w < _e46.cutoff) {
        metal::discard_fragment();
    }
    metal::float4x4 _e53 = view_1.camera_from_world;
    metal::float3 seen = (_e53 * metal::float4(_e46.value, 0.0)).xyz;
    metal::float4x4 _e61 = view_1.camera_from_world;
    float depth_1 = -((_e61 * metal::float4(in.position, 1.0)).z);
    float _e70 = object.id;
    metal::float4 _e73 = surface_texel(seen, depth_1, _e70 + 1.0);
    return fs_mainOutput { _e73 };
}
