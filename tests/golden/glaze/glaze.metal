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
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape gray_modeling_tone_shape = ProfileShape {1.0, 0.0, 1.0537579, 1.3909147, 0.0, 1.2772532, 0.561292, 0u};
constant ProfileShape gray_lights_tone_shape = ProfileShape {0.99875027, 0.04997917, 2.0858297, 3.3126261, 0.1, 0.42646712, 0.19445144, 0u};

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

metal::float3 finite_vec3_(
    metal::float3 v
) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return metal::float3(_e3, _e6, _e9);
}

metal::float4 finite_vec4_(
    metal::float4 v_1
) {
    metal::float3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return metal::float4(_e2, _e5);
}

metal::float3 normalize_or(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    bool local = {};
    float largest = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest > 0.000000000000000000000000000001) {
        local = largest < 1000000000000000000000000000000.0;
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    metal::float3 scaled = v_2 * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

float power_of_two(
    int n
) {
    return as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(n) + as_type<uint>(127))) << 23u);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

float exp2_stable(
    float x_2
) {
    float clamped_6 = metal::clamp(x_2, -150.0, 127.99999);
    float whole = metal::rint(clamped_6);
    float f = (clamped_6 - whole) * LN_2_;
    float p = 1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127)))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two(as_type<int>(as_type<uint>(naga_f2i32(whole)) - as_type<uint>(half_whole)));
    return (p * _e33) * _e37;
}

float log_stable(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    int shift_2 = static_cast<int>((bits - 1060439283u) >> 23u);
    int exponent_1 = (shift_2 >= 256) ? as_type<int>(as_type<uint>(shift_2) - as_type<uint>(512)) : shift_2;
    float mantissa = as_type<float>(bits - (static_cast<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    float series = (2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111))))))));
    return (static_cast<float>(exponent_1) * LN_2_) + series;
}

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

metal::float2 sin_cos_quarter(
    float x_4
) {
    float h = 0.5 * x_4;
    float h2_ = h * h;
    float s = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s) * c, 1.0 - ((2.0 * s) * s));
}

Angle angle_between(
    metal::float3 d,
    metal::float3 l
) {
    float p_1 = metal::length(d - l);
    float s_1 = metal::length(d + l);
    float k = 1.0 / metal::sqrt(metal::max((p_1 * p_1) + (s_1 * s_1), 0.000000000000000000000000000001));
    return Angle {p_1 * k, s_1 * k};
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
    float t_4 = small / large;
    bool is_wide = t_4 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_4;
    float r2_ = r * r;
    float series_1 = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_10 = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_1 > x_5) ? (HALF_PI - a_10) : a_10;
}

float angle_radians(
    Angle u
) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return 2.0 * _e3;
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    bool local_1 = {};
    float s_2 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_1);
    if (s_2 <= 0.0) {
        local_1 = s_2 < c_1;
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    metal::float2 turned = _e32 ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_shifted(
    Angle u_2,
    float shift
) {
    metal::float2 _e7 = sin_cos_quarter(0.5 * metal::clamp(shift, -3.1415927, PI));
    Angle _e8 = angle_turned(u_2, _e7);
    return _e8;
}

float angle_footprint(
    Angle u_3
) {
    metal::float2 half_ = metal::float2(u_3.half_sin, u_3.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_1 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    float _e13 = finite_or(w_1, 0.5);
    return metal::min(_e13, 0.5);
}

float bounded(
    float x_6
) {
    uint bits_1 = as_type<uint>(x_6);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float3 bounded_vec3_(
    metal::float3 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    float _e6 = bounded(v_3.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float4 bounded_vec4_(
    metal::float4 v_4
) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    float _e8 = bounded(v_4.w);
    return metal::float4(_e2, _e4, _e6, _e8);
}

float mixed(
    float a,
    float b,
    float t_1
) {
    float _e4 = bounded(b - a);
    float _e14 = bounded((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4)));
    return _e14;
}

metal::float3 mixed_vec3_(
    metal::float3 a_1,
    metal::float3 b_1,
    float t_2
) {
    float _e5 = mixed(a_1.x, b_1.x, t_2);
    float _e8 = mixed(a_1.y, b_1.y, t_2);
    float _e11 = mixed(a_1.z, b_1.z, t_2);
    return metal::float3(_e5, _e8, _e11);
}

metal::float4 mixed_vec4_(
    metal::float4 a_2,
    metal::float4 b_2,
    float t_3
) {
    metal::float3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_3);
    float _e8 = mixed(a_2.w, b_2.w, t_3);
    return metal::float4(_e5, _e8);
}

float place_between(
    float x_7,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_7 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_7 - low) / _e12);
    return _e14;
}

float remapped(
    float x_8,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    float _e6 = bounded(x_8);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, clamped ? metal::clamp(_e9, 0.0, 1.0) : _e9);
    return _e16;
}

float eased(
    float x_9,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_9);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = metal::clamp(_e6, 0.0, 1.0);
    return (t_5 * t_5) * (3.0 - (2.0 * t_5));
}

float factor_of(
    float x_10,
    bool clamped_1
) {
    float _e2 = bounded(x_10);
    float _e3 = bounded(x_10);
    return clamped_1 ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

float footprint_of(
    float x_11
) {
    float _e1 = metal::dfdx(x_11);
    float _e2 = metal::dfdy(x_11);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d_1, d_1)));
    return _e6;
}

float soft_light(
    float a_3,
    float b_3
) {
    if (b_3 <= 0.5) {
        return a_3 - (((1.0 - (2.0 * b_3)) * a_3) * (1.0 - a_3));
    }
    float curved = (a_3 <= 0.25) ? (((((16.0 * a_3) - 12.0) * a_3) + 4.0) * a_3) : metal::sqrt(metal::max(a_3, 0.0));
    return a_3 + (((2.0 * b_3) - 1.0) * (curved - a_3));
}

metal::float4 color_mixed(
    metal::float4 a_4,
    metal::float3 blended,
    float factor
) {
    metal::float3 _e4 = bounded_vec3_(a_4.xyz);
    metal::float3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    metal::float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_4.w);
    return metal::float4(_e8, _e10);
}

metal::float3 within_unit(
    metal::float3 rgb
) {
    metal::float3 _e1 = bounded_vec3_(rgb);
    return metal::clamp(_e1, metal::float3(0.0), metal::float3(1.0));
}

float lightness_of(
    metal::float3 rgb_1
) {
    return metal::dot(rgb_1, metal::float3(0.3, 0.59, 0.11));
}

metal::float3 lit_as(
    metal::float3 rgb_2,
    metal::float3 other
) {
    float _e2 = lightness_of(other);
    float _e3 = lightness_of(rgb_2);
    metal::float3 moved = rgb_2 + metal::float3(_e2 - _e3);
    float least = metal::min(metal::min(moved.x, moved.y), moved.z);
    float largest_2 = metal::max(metal::max(moved.x, moved.y), moved.z);
    float raised = (least < 0.0) ? (_e2 / metal::max(_e2 - least, 0.000001)) : 1.0;
    metal::float3 clipped = metal::float3(_e2) + ((moved - metal::float3(_e2)) * raised);
    float top = _e2 + ((largest_2 - _e2) * raised);
    float lowered = (top > 1.0) ? ((1.0 - _e2) / metal::max(top - _e2, 0.000001)) : 1.0;
    return metal::float3(_e2) + ((clipped - metal::float3(_e2)) * lowered);
}

metal::float3 saturated_as(
    metal::float3 rgb_3,
    metal::float3 other_1
) {
    float least_1 = metal::min(metal::min(rgb_3.x, rgb_3.y), rgb_3.z);
    float spread = metal::max(metal::max(rgb_3.x, rgb_3.y), rgb_3.z) - least_1;
    float wanted = metal::max(metal::max(other_1.x, other_1.y), other_1.z) - metal::min(metal::min(other_1.x, other_1.y), other_1.z);
    return (spread > 0.0) ? ((rgb_3 - metal::float3(least_1)) * (wanted / metal::max(spread, SMALLEST_NORMAL))) : metal::float3(0.0);
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

Color mix_colors_normal(
    Color a_5,
    Color b_4,
    float factor_1
) {
    metal::float4 _e3 = bounded_vec4_(a_5);
    metal::float4 _e4 = bounded_vec4_(b_4);
    float _e6 = factor_of(factor_1, true);
    metal::float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

Color mix_colors_screen(
    Color a_6,
    Color b_5,
    float factor_2
) {
    metal::float4 _e10 = color_mixed(a_6, (a_6.xyz + b_5.xyz) - (a_6.xyz * b_5.xyz), factor_2);
    return _e10;
}

Color mix_colors_soft_light(
    Color a_7,
    Color b_6,
    float factor_3
) {
    float _e5 = soft_light(a_7.x, b_6.x);
    float _e8 = soft_light(a_7.y, b_6.y);
    float _e11 = soft_light(a_7.z, b_6.z);
    metal::float4 _e13 = color_mixed(a_7, metal::float3(_e5, _e8, _e11), factor_3);
    return _e13;
}

Color mix_colors_hue(
    Color a_8,
    Color b_7,
    float factor_4
) {
    metal::float3 _e4 = within_unit(a_8.xyz);
    metal::float3 _e6 = within_unit(b_7.xyz);
    metal::float3 _e7 = saturated_as(_e6, _e4);
    metal::float3 _e8 = lit_as(_e7, _e4);
    metal::float4 _e9 = color_mixed(a_8, _e8, factor_4);
    return _e9;
}

Color mix_colors_color(
    Color a_9,
    Color b_8,
    float factor_5
) {
    metal::float3 _e4 = within_unit(b_8.xyz);
    metal::float3 _e6 = within_unit(a_9.xyz);
    metal::float3 _e7 = lit_as(_e4, _e6);
    metal::float4 _e8 = color_mixed(a_9, _e7, factor_5);
    return _e8;
}

Color set_alpha(
    Color color_1,
    float alpha
) {
    return metal::float4(color_1.xyz, alpha);
}

float kappa_safe(
    float kappa
) {
    bool is_nan = (as_type<uint>(kappa) & 2147483647u) > 2139095040u;
    return is_nan ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0);
}

float curvature_signed(
    float kappa_1,
    float slope
) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_11 = _e2 * metal::clamp(_e4, -1000000000000000000000000000000.0, 1000000000000000000000000000000.0);
    float magnitude_1 = metal::min(metal::abs(a_11), 50.0);
    if (magnitude_1 < 0.0625) {
        float a2_ = a_11 * a_11;
        return a_11 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e28 = exp2_stable(-2.88539 * magnitude_1);
    float t_6 = (1.0 - _e28) / (1.0 + _e28);
    return (a_11 >= 0.0) ? t_6 : -(t_6);
}

float transition(
    float kappa_2,
    float slope_1
) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return 0.5 + (0.5 * _e2);
}

float kappa_surface(
    float kappa_3
) {
    float _e1 = kappa_safe(kappa_3);
    return _e1;
}

metal::float3 position_object(
    metal::float3 position_object_1
) {
    return position_object_1;
}

Composite blend_finish(
    Composite below,
    metal::float3 blended_1,
    float alpha_1,
    float opacity,
    bool clamped_2
) {
    if (opacity <= 0.0) {
        return below;
    }
    metal::float4 mixed_1 = metal::float4(below.xyz + (opacity * (blended_1 - below.xyz)), alpha_1);
    return clamped_2 ? metal::clamp(mixed_1, metal::float4(0.0), metal::float4(1.0)) : mixed_1;
}

Composite blend_add(
    Composite below_1,
    Color color_2,
    float tone,
    float opacity_1,
    bool clamped_3
) {
    Composite _e12 = blend_finish(below_1, below_1.xyz + (tone * color_2.xyz), below_1.w, opacity_1 * color_2.w, clamped_3);
    return _e12;
}

Composite blend_alpha(
    Composite below_2,
    Color color_3,
    float tone_1,
    float opacity_2,
    bool clamped_4
) {
    float a_12 = opacity_2 * color_3.w;
    float alpha_2 = below_2.w + ((tone_1 * a_12) * (1.0 - below_2.w));
    Composite _e20 = blend_finish(below_2, below_2.xyz + (tone_1 * (color_3.xyz - below_2.xyz)), alpha_2, a_12, clamped_4);
    return _e20;
}

Color output(
    Composite color_4
) {
    Color _e1 = straight(color_4);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

metal::float2 light_split(
    float intensity
) {
    return metal::float2(metal::min(intensity, 1.0), metal::max(intensity, 1.0));
}

LitLayer light_apply(
    Light light,
    Color color_5,
    float tone_2
) {
    metal::float2 _e4 = light_split(light.intensity);
    return LitLayer {metal::float4((color_5.xyz * light.color) * _e4.y, color_5.w), tone_2 * _e4.x};
}

Angle parametrization_diffuse(
    Light light_1,
    metal::float3 normal
) {
    metal::float3 _e6 = normalize_or(normal, metal::float3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light_1.direction);
    return _e8;
}

Angle parametrization_specular(
    Light light_2,
    metal::float3 normal_1,
    metal::float3 view
) {
    metal::float3 _e7 = normalize_or(normal_1, metal::float3(0.0, 0.0, 1.0));
    metal::float3 mirrored = ((2.0 * metal::dot(_e7, view)) * _e7) - view;
    metal::float3 _e13 = normalize_or(mirrored, _e7);
    Angle _e15 = angle_between(_e13, light_2.direction);
    return _e15;
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
        float _e10 = log1p_negative_small(q * q);
        log_base = _e10;
    } else {
        float _e16 = log_stable((1.0 - q) * (1.0 + q));
        log_base = _e16;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable((exponent * LOG2_E) * _e19);
    return metal::clamp(_e21, 0.0, 1.0);
}

float profile_point(
    Angle u_4,
    ProfileShape shape
) {
    bool local_2 = {};
    float s_3 = (u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset);
    if (!((s_3 <= 0.0))) {
        local_2 = shape.kind == PROFILE_AMBIENT;
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
    if (_e18) {
        return 1.0;
    }
    if (shape.kind == PROFILE_STEP) {
        return (s_3 <= 0.0000004) ? 1.0 : 0.0;
    }
    float q_1 = s_3 * shape.scale;
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(
    Angle u_5,
    float w,
    ProfileShape shape_1
) {
    bool local_3 = {};
    bool local_4 = {};
    float _e3 = profile_point(u_5, shape_1);
    if (!((w <= 0.0))) {
        local_3 = shape_1.kind == PROFILE_AMBIENT;
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if (shape_1.edge_deviation < 0.145) {
        local_4 = w >= (3.4641016 * shape_1.edge_deviation);
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width_1 = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
        float _e36 = angle_radians(u_5);
        return metal::clamp(0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_1), 0.0, 1.0);
    }
    if (w < (0.1 * shape_1.edge_deviation)) {
        return _e3;
    }
    metal::float2 _e50 = sin_cos_quarter(0.19364917 * w);
    Angle _e51 = angle_turned(u_5, _e50);
    float _e52 = profile_point(_e51, shape_1);
    Angle _e57 = angle_turned(u_5, metal::float2(-(_e50.x), _e50.y));
    float _e58 = profile_point(_e57, shape_1);
    return (((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0;
}

float profile(
    Angle angle,
    float shift_1,
    ProfileShape shape_2
) {
    Angle _e3 = angle_shifted(angle, shift_1);
    float _e4 = angle_footprint(_e3);
    float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
}

float rim(
    Light light_3,
    metal::float3 normal_2,
    metal::float3 view_1,
    float width,
    float softness,
    float follow
) {
    metal::float3 _e10 = normalize_or(normal_2, metal::float3(0.0, 0.0, 1.0));
    float facing = metal::clamp(metal::dot(_e10, view_1), 0.0, 1.0);
    float _e16 = factor_of(width, true);
    float _e18 = factor_of(softness, true);
    float _e20 = footprint_of(facing);
    float edge = metal::max(_e16 * _e18, metal::min(_e20, 1.0));
    metal::float3 aside = _e10 - view_1;
    float further = (facing > 0.5) ? ((0.5 * metal::dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing);
    float within = (further / metal::max(edge, 0.000001)) + ((softness > 0.0) ? 0.0 : 0.5);
    float inside = (_e16 <= 0.0) ? 0.0 : metal::clamp(within, 0.0, 1.0);
    metal::float3 across = light_3.direction - (metal::dot(light_3.direction, view_1) * view_1);
    metal::float3 _e61 = normalize_or(across, metal::float3(0.0));
    float side = metal::dot(_e10 - (metal::dot(_e10, view_1) * view_1), _e61);
    float _e66 = eased(side, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return inside * _e69;
}

float map_range(
    float value,
    float from_low_1,
    float from_high_1,
    float to_low_1,
    float to_high_1,
    bool clamped_5
) {
    float _e6 = remapped(value, from_low_1, from_high_1, to_low_1, to_high_1, clamped_5);
    return _e6;
}

float smooth_step_value(
    float value_1,
    float low_2,
    float high_2
) {
    float _e3 = eased(value_1, low_2, high_2);
    return _e3;
}

VectorParts separate_vector(
    metal::float3 vector
) {
    return VectorParts {vector.x, vector.y, vector.z};
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    float _e8 = profile(_e5, 0.0, gray_modeling_tone_shape);
    Light _e11 = look.key;
    LitLayer _e17 = light_apply(_e11, metal::float4(0.7059, 0.7059, 0.7059, 1.0), _e8);
    Composite _e27 = blend_alpha(metal::float4(0.1216, 0.1216, 0.1216, 1.0), _e17.color, _e17.tone, 1.0, true);
    Light _e30 = look.key;
    Angle _e33 = parametrization_specular(_e30, surface_1.normal, surface_1.view);
    float _e36 = profile(_e33, 0.0, gray_lights_tone_shape);
    Light _e39 = look.key;
    LitLayer _e45 = light_apply(_e39, metal::float4(0.2902, 0.2902, 0.2902, 1.0), _e36);
    Composite _e50 = blend_add(_e27, _e45.color, _e45.tone, 1.0, true);
    Color _e51 = straight(_e50);
    Color _e53 = set_alpha(_e51, 1.0);
    Color _e60 = mix_colors_color(_e53, metal::float4(0.4275, 0.5412, 0.4471, 1.0), 0.75);
    Color _e67 = mix_colors_color(_e53, metal::float4(0.7098, 0.4667, 0.3098, 1.0), 0.7);
    metal::float3 _e69 = position_object(surface_1.position_object);
    VectorParts _e70 = separate_vector(_e69);
    float _e74 = smooth_step_value(_e70.y, -0.5, 0.5);
    Color _e75 = mix_colors_normal(_e60, _e67, _e74);
    Color _e82 = mix_colors_soft_light(_e75, metal::float4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    float _e84 = kappa_surface(surface_1.kappa);
    float _e86 = transition(_e84, 0.06);
    float _e92 = map_range(_e86, 0.0, 0.55, 0.6, 0.0, true);
    Color _e98 = mix_colors_hue(_e82, metal::float4(0.4902, 0.2471, 0.3608, 1.0), _e92);
    Light _e101 = look.back;
    float _e107 = rim(_e101, surface_1.normal, surface_1.view, 0.3, 0.6, 1.0);
    Color _e113 = mix_colors_screen(_e98, metal::float4(0.4353, 0.5294, 0.6588, 1.0), _e107);
    Composite _e114 = premultiplied(_e113);
    Color _e115 = output(_e114);
    return _e115;
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
, constant View& view_2 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_3 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_2.clip_from_world;
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
    metal::float3 position_object_2 [[user(loc1), center_perspective]];
    metal::float3 normal_3 [[user(loc2), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.position_object_2, varyings_1.normal_3 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_3 = is_front ? _e7 : -(_e7);
    surface.normal = normal_3;
    metal::float4 _e15 = view_2.eye;
    float _e20 = view_2.eye.w;
    metal::float4 _e26 = view_2.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    surface.position_object = in.position_object;
    metal::float4 _e42 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.kappa = _e42.x;
    Surface _e44 = surface;
    metal::float4 _e45 = shade(_e44, look);
    metal::float4 _e46 = finite_vec4_(_e45);
    return fs_mainOutput { _e46 };
}
