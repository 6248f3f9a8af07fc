#version 300 es
// Grisaille and glaze: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// glaze.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light key;
    Light back;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    float kappa;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct LitLayer {
    vec4 color;
    float tone;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape gray_modeling_tone_shape = ProfileShape(1.0, 0.0, 1.0537579, 1.3909147, 0.0, 1.2772532, 0.561292, 0u);
const ProfileShape gray_lights_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.0858297, 3.3126261, 0.1, 0.42646712, 0.19445144, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise) {
    bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

vec3 finite_vec3_(vec3 v) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return vec3(_e3, _e6, _e9);
}

vec4 finite_vec4_(vec4 v_1) {
    vec3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return vec4(_e2, _e5);
}

vec3 normalize_or(vec3 v_2, vec3 otherwise_1) {
    bool local = false;
    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local = (largest < 1e30);
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    vec3 scaled = (v_2 * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float power_of_two(int n) {
    return uintBitsToFloat((uint((n + 127)) << 23u));
}

float exp2_stable(float x_2) {
    float clamped_6 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_6);
    float f = ((clamped_6 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift_2 >= 256) ? (shift_2 - 512) : shift_2);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_quarter(float x_4) {
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

Angle angle_between(vec3 d, vec3 l) {
    float p_1 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_1 * p_1) + (s_1 * s_1)), 1e-30)));
    return Angle((p_1 * k), (s_1 * k));
}

float atan2_positive(float y_1, float x_5) {
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_4 = (small / large);
    bool is_wide = (t_4 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_4);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_10 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_10) : a_10);
}

float angle_radians(Angle u) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_turned(Angle u_1, vec2 t) {
    bool local_1 = false;
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_1));
    if ((s_2 <= 0.0)) {
        local_1 = (s_2 < c_1);
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    vec2 turned = (_e32 ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_shifted(Angle u_2, float shift) {
    vec2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    Angle _e8 = angle_turned(u_2, _e7);
    return _e8;
}

float angle_footprint(Angle u_3) {
    vec2 half_ = vec2(u_3.half_sin, u_3.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_1, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_6) {
    uint bits_1 = floatBitsToUint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec3 bounded_vec3_(vec3 v_3) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    float _e6 = bounded(v_3.z);
    return vec3(_e2, _e4, _e6);
}

vec4 bounded_vec4_(vec4 v_4) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    float _e8 = bounded(v_4.w);
    return vec4(_e2, _e4, _e6, _e8);
}

float mixed(float a, float b, float t_1) {
    float _e4 = bounded((b - a));
    float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
}

vec3 mixed_vec3_(vec3 a_1, vec3 b_1, float t_2) {
    float _e5 = mixed(a_1.x, b_1.x, t_2);
    float _e8 = mixed(a_1.y, b_1.y, t_2);
    float _e11 = mixed(a_1.z, b_1.z, t_2);
    return vec3(_e5, _e8, _e11);
}

vec4 mixed_vec4_(vec4 a_2, vec4 b_2, float t_3) {
    vec3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_3);
    float _e8 = mixed(a_2.w, b_2.w, t_3);
    return vec4(_e5, _e8);
}

float place_between(float x_7, float low, float high) {
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_7 >= high) ? 1.0 : 0.0);
    }
    float _e12 = bounded(span);
    float _e14 = bounded(((x_7 - low) / _e12));
    return _e14;
}

float remapped(float x_8, float from_low, float from_high, float to_low, float to_high, bool clamped) {
    float _e6 = bounded(x_8);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_9, float low_1, float high_1) {
    float _e3 = bounded(x_9);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float factor_of(float x_10, bool clamped_1) {
    float _e2 = bounded(x_10);
    float _e3 = bounded(x_10);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_11) {
    float _e1 = dFdx(x_11);
    float _e2 = dFdy(x_11);
    vec2 d_1 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float soft_light(float a_3, float b_3) {
    if ((b_3 <= 0.5)) {
        return (a_3 - (((1.0 - (2.0 * b_3)) * a_3) * (1.0 - a_3)));
    }
    float curved = ((a_3 <= 0.25) ? (((((16.0 * a_3) - 12.0) * a_3) + 4.0) * a_3) : sqrt(max(a_3, 0.0)));
    return (a_3 + (((2.0 * b_3) - 1.0) * (curved - a_3)));
}

vec4 color_mixed(vec4 a_4, vec3 blended, float factor) {
    vec3 _e4 = bounded_vec3_(a_4.xyz);
    vec3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    vec3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_4.w);
    return vec4(_e8, _e10);
}

vec3 within_unit(vec3 rgb) {
    vec3 _e1 = bounded_vec3_(rgb);
    return clamp(_e1, vec3(0.0), vec3(1.0));
}

float lightness_of(vec3 rgb_1) {
    return dot(rgb_1, vec3(0.3, 0.59, 0.11));
}

vec3 lit_as(vec3 rgb_2, vec3 other) {
    float _e2 = lightness_of(other);
    float _e3 = lightness_of(rgb_2);
    vec3 moved = (rgb_2 + vec3((_e2 - _e3)));
    float least = min(min(moved.x, moved.y), moved.z);
    float largest_2 = max(max(moved.x, moved.y), moved.z);
    float raised = ((least < 0.0) ? (_e2 / max((_e2 - least), 1e-6)) : 1.0);
    vec3 clipped = (vec3(_e2) + ((moved - vec3(_e2)) * raised));
    float top = (_e2 + ((largest_2 - _e2) * raised));
    float lowered = ((top > 1.0) ? ((1.0 - _e2) / max((top - _e2), 1e-6)) : 1.0);
    return (vec3(_e2) + ((clipped - vec3(_e2)) * lowered));
}

vec3 saturated_as(vec3 rgb_3, vec3 other_1) {
    float least_1 = min(min(rgb_3.x, rgb_3.y), rgb_3.z);
    float spread = (max(max(rgb_3.x, rgb_3.y), rgb_3.z) - least_1);
    float wanted = (max(max(other_1.x, other_1.y), other_1.z) - min(min(other_1.x, other_1.y), other_1.z));
    return ((spread > 0.0) ? ((rgb_3 - vec3(least_1)) * (wanted / max(spread, SMALLEST_NORMAL))) : vec3(0.0));
}

vec4 premultiplied(vec4 color) {
    return vec4((color.xyz * color.w), color.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 mix_colors_normal(vec4 a_5, vec4 b_4, float factor_1) {
    vec4 _e3 = bounded_vec4_(a_5);
    vec4 _e4 = bounded_vec4_(b_4);
    float _e6 = factor_of(factor_1, true);
    vec4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

vec4 mix_colors_screen(vec4 a_6, vec4 b_5, float factor_2) {
    vec4 _e10 = color_mixed(a_6, ((a_6.xyz + b_5.xyz) - (a_6.xyz * b_5.xyz)), factor_2);
    return _e10;
}

vec4 mix_colors_soft_light(vec4 a_7, vec4 b_6, float factor_3) {
    float _e5 = soft_light(a_7.x, b_6.x);
    float _e8 = soft_light(a_7.y, b_6.y);
    float _e11 = soft_light(a_7.z, b_6.z);
    vec4 _e13 = color_mixed(a_7, vec3(_e5, _e8, _e11), factor_3);
    return _e13;
}

vec4 mix_colors_hue(vec4 a_8, vec4 b_7, float factor_4) {
    vec3 _e4 = within_unit(a_8.xyz);
    vec3 _e6 = within_unit(b_7.xyz);
    vec3 _e7 = saturated_as(_e6, _e4);
    vec3 _e8 = lit_as(_e7, _e4);
    vec4 _e9 = color_mixed(a_8, _e8, factor_4);
    return _e9;
}

vec4 mix_colors_color(vec4 a_9, vec4 b_8, float factor_5) {
    vec3 _e4 = within_unit(b_8.xyz);
    vec3 _e6 = within_unit(a_9.xyz);
    vec3 _e7 = lit_as(_e4, _e6);
    vec4 _e8 = color_mixed(a_9, _e7, factor_5);
    return _e8;
}

vec4 set_alpha(vec4 color_1, float alpha) {
    return vec4(color_1.xyz, alpha);
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_11 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_11), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_11 * a_11);
        return (a_11 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_6 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_11 >= 0.0) ? t_6 : -(t_6));
}

float transition(float kappa_2, float slope_1) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float kappa_surface(float kappa_3) {
    float _e1 = kappa_safe(kappa_3);
    return _e1;
}

vec3 position_object(vec3 position_object_1) {
    return position_object_1;
}

vec4 blend_finish(vec4 below, vec3 blended_1, float alpha_1, float opacity, bool clamped_2) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed_1 = vec4((below.xyz + (opacity * (blended_1 - below.xyz))), alpha_1);
    return (clamped_2 ? clamp(mixed_1, vec4(0.0), vec4(1.0)) : mixed_1);
}

vec4 blend_add(vec4 below_1, vec4 color_2, float tone, float opacity_1, bool clamped_3) {
    vec4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color_2.xyz)), below_1.w, (opacity_1 * color_2.w), clamped_3);
    return _e12;
}

vec4 blend_alpha(vec4 below_2, vec4 color_3, float tone_1, float opacity_2, bool clamped_4) {
    float a_12 = (opacity_2 * color_3.w);
    float alpha_2 = (below_2.w + ((tone_1 * a_12) * (1.0 - below_2.w)));
    vec4 _e20 = blend_finish(below_2, (below_2.xyz + (tone_1 * (color_3.xyz - below_2.xyz))), alpha_2, a_12, clamped_4);
    return _e20;
}

vec4 output_(vec4 color_4) {
    vec4 _e1 = straight(color_4);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color_5, float tone_2) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color_5.xyz * light.color) * _e4.y), color_5.w), (tone_2 * _e4.x));
}

Angle parametrization_diffuse(Light light_1, vec3 normal) {
    vec3 _e6 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light_1.direction);
    return _e8;
}

Angle parametrization_specular(Light light_2, vec3 normal_1, vec3 view) {
    vec3 _e7 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    vec3 mirrored = (((2.0 * dot(_e7, view)) * _e7) - view);
    vec3 _e13 = normalize_or(mirrored, _e7);
    Angle _e15 = angle_between(_e13, light_2.direction);
    return _e15;
}

float profile_power(float q, float exponent) {
    float log_base = 0.0;
    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        float _e10 = log1p_negative_small((q * q));
        log_base = _e10;
    } else {
        float _e16 = log_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e16;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable(((exponent * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape) {
    bool local_2 = false;
    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_2 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_3 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_3 * shape.scale);
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_1) {
    bool local_3 = false;
    bool local_4 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width_1 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_1)), 0.0, 1.0);
    }
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    vec2 _e50 = sin_cos_quarter((0.19364917 * w));
    Angle _e51 = angle_turned(u_5, _e50);
    float _e52 = profile_point(_e51, shape_1);
    Angle _e57 = angle_turned(u_5, vec2(-(_e50.x), _e50.y));
    float _e58 = profile_point(_e57, shape_1);
    return ((((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0);
}

float profile(Angle angle, float shift_1, ProfileShape shape_2) {
    Angle _e3 = angle_shifted(angle, shift_1);
    float _e4 = angle_footprint(_e3);
    float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
}

float rim(Light light_3, vec3 normal_2, vec3 view_1, float width, float softness, float follow) {
    vec3 _e10 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    float facing = clamp(dot(_e10, view_1), 0.0, 1.0);
    float _e16 = factor_of(width, true);
    float _e18 = factor_of(softness, true);
    float _e20 = footprint_of(facing);
    float edge = max((_e16 * _e18), min(_e20, 1.0));
    vec3 aside = (_e10 - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing));
    float within = ((further / max(edge, 1e-6)) + ((softness > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    vec3 across = (light_3.direction - (dot(light_3.direction, view_1) * view_1));
    vec3 _e61 = normalize_or(across, vec3(0.0));
    float side = dot((_e10 - (dot(_e10, view_1) * view_1)), _e61);
    float _e66 = eased(side, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float map_range(float value, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_5) {
    float _e6 = remapped(value, from_low_1, from_high_1, to_low_1, to_high_1, clamped_5);
    return _e6;
}

float smooth_step_value(float value_1, float low_2, float high_2) {
    float _e3 = eased(value_1, low_2, high_2);
    return _e3;
}

VectorParts separate_vector(vec3 vector) {
    return VectorParts(vector.x, vector.y, vector.z);
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    float _e8 = profile(_e5, 0.0, gray_modeling_tone_shape);
    Light _e11 = u_look.key;
    LitLayer _e17 = light_apply(_e11, vec4(0.7059, 0.7059, 0.7059, 1.0), _e8);
    vec4 _e27 = blend_alpha(vec4(0.1216, 0.1216, 0.1216, 1.0), _e17.color, _e17.tone, 1.0, true);
    Light _e30 = u_look.key;
    Angle _e33 = parametrization_specular(_e30, surface_1.normal, surface_1.view);
    float _e36 = profile(_e33, 0.0, gray_lights_tone_shape);
    Light _e39 = u_look.key;
    LitLayer _e45 = light_apply(_e39, vec4(0.2902, 0.2902, 0.2902, 1.0), _e36);
    vec4 _e50 = blend_add(_e27, _e45.color, _e45.tone, 1.0, true);
    vec4 _e51 = straight(_e50);
    vec4 _e53 = set_alpha(_e51, 1.0);
    vec4 _e60 = mix_colors_color(_e53, vec4(0.4275, 0.5412, 0.4471, 1.0), 0.75);
    vec4 _e67 = mix_colors_color(_e53, vec4(0.7098, 0.4667, 0.3098, 1.0), 0.7);
    vec3 _e69 = position_object(surface_1.position_object);
    VectorParts _e70 = separate_vector(_e69);
    float _e74 = smooth_step_value(_e70.y, -0.5, 0.5);
    vec4 _e75 = mix_colors_normal(_e60, _e67, _e74);
    vec4 _e82 = mix_colors_soft_light(_e75, vec4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    float _e84 = kappa_surface(surface_1.kappa);
    float _e86 = transition(_e84, 0.06);
    float _e92 = map_range(_e86, 0.0, 0.55, 0.6, 0.0, true);
    vec4 _e98 = mix_colors_hue(_e82, vec4(0.4902, 0.2471, 0.3608, 1.0), _e92);
    Light _e101 = u_look.back;
    float _e107 = rim(_e101, surface_1.normal, surface_1.view, 0.3, 0.6, 1.0);
    vec4 _e113 = mix_colors_screen(_e98, vec4(0.4353, 0.5294, 0.6588, 1.0), _e107);
    vec4 _e114 = premultiplied(_e113);
    vec4 _e115 = output_(_e114);
    return _e115;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_3 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_3;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    vec4 _e42 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e42.x;
    Surface _e44 = surface;
    vec4 _e45 = shade(_e44);
    vec4 _e46 = finite_vec4_(_e45);
    out_color = _e46;
    return;
}

