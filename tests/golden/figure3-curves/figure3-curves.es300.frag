#version 300 es
// Profile curves: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// figure3-curves.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct Surface {
    vec2 uv;
};
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
struct Varyings {
    vec4 clip;
    vec2 uv;
};
const float PI = 3.1415927;
const float LOG2_E = 1.442695;
const ProfileShape lambert_shape = ProfileShape(1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u);
const ProfileShape half_lambert_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);
const ProfileShape custom_shape = ProfileShape(0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928, 0.2351043, 0u);

smooth in vec2 v_uv;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise) {
    bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

float exp2_stable(float x_2) {
    float whole = roundEven(x_2);
    float f = (x_2 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_3) {
    float clamped_2 = max(x_3, -126.0);
    float whole_1 = roundEven(clamped_2);
    float f_1 = (clamped_2 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float log2_stable(float x_4) {
    uint bits = floatBitsToUint(x_4);
    int exponent_3 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_3) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_3) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_quarter(float x_5) {
    float h = (0.5 * x_5);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

vec2 sin_cos_tiny(float x_6) {
    float y_1 = (x_6 * x_6);
    float s_1 = (x_6 * (1.0 + (y_1 * (-0.16666667 + (y_1 * 0.008333334)))));
    float c_1 = (1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * 0.0013888889))))));
    return vec2(s_1, c_1);
}

Angle angle_of(float radians_) {
    float _e2 = finite_or(radians_, 0.0);
    float half_angle = (0.5 * clamp(_e2, 0.0, PI));
    vec2 _e8 = sin_cos_quarter(half_angle);
    return Angle(max(_e8.x, 0.0), max(_e8.y, 0.0));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_4 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_4, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_2 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_2 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_2));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < c_2)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_3 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_3 = (u_2.half_cos + (u_2.half_sin * 0.0));
    vec2 upper_1 = ((c_3 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_3));
    vec2 turned_1 = (((s_3 <= 0.0) && (s_3 < c_3)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

float footprint_of(float x_7) {
    float _e1 = dFdx(x_7);
    float _e2 = dFdy(x_7);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

float step_filtered(float x_8, float edge, float w) {
    float d_1 = (x_8 - edge);
    return ((w < 1e-30) ? ((d_1 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_1 / w)), 0.0, 1.0));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

vec4 blend_alpha_2_(vec4 below_1, vec4 color_1, float tone_1, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

float profile_power(float q, float exponent) {
    float log_base = 0.0;
    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        float _e11 = log1p_negative_small((q * q));
        log_base = (LOG2_E * _e11);
    } else {
        float _e18 = log2_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e18;
    }
    float _e19 = log_base;
    float _e20 = exp2_stable(_e19);
    return min(_e20, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape) {
    float s_4 = (u_3.half_sin - (u_3.half_cos * 0.0));
    if (((s_4 <= 0.0) || false)) {
        return 1.0;
    }
    float q_3 = (s_4 * shape.scale);
    float _e15 = profile_power(q_3, 1.0);
    return _e15;
}

float profile_power_2_(float q_1, float exponent_1) {
    float log_base_1 = 0.0;
    if ((q_1 >= 1.0)) {
        return 0.0;
    }
    if ((q_1 < 0.5)) {
        float _e11 = log1p_negative_small((q_1 * q_1));
        log_base_1 = (LOG2_E * _e11);
    } else {
        float _e18 = log2_stable(((1.0 - q_1) * (1.0 + q_1)));
        log_base_1 = _e18;
    }
    float _e19 = log_base_1;
    float _e21 = exp2_stable((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_2_(Angle u_4, ProfileShape shape_1) {
    float s_5 = (u_4.half_sin - (u_4.half_cos * 0.0));
    if (((s_5 <= 0.0) || false)) {
        return 1.0;
    }
    float q_4 = (s_5 * shape_1.scale);
    float _e15 = profile_power_2_(q_4, shape_1.exponent);
    return _e15;
}

float profile_power_3_(float q_2, float exponent_2) {
    float log_base_2 = 0.0;
    if ((q_2 >= 1.0)) {
        return 0.0;
    }
    if ((q_2 < 0.5)) {
        float _e11 = log1p_negative_small((q_2 * q_2));
        log_base_2 = (LOG2_E * _e11);
    } else {
        float _e18 = log2_stable(((1.0 - q_2) * (1.0 + q_2)));
        log_base_2 = _e18;
    }
    float _e19 = log_base_2;
    float _e21 = exp2_stable_2_((exponent_2 * _e19));
    return min(_e21, 1.0);
}

float profile_point_3_(Angle u_5, ProfileShape shape_2) {
    float s_6 = ((u_5.half_sin * shape_2.half_cos_offset) - (u_5.half_cos * shape_2.half_sin_offset));
    if (((s_6 <= 0.0) || false)) {
        return 1.0;
    }
    float q_5 = (s_6 * shape_2.scale);
    float _e17 = profile_power_3_(q_5, shape_2.exponent);
    return _e17;
}

float profile_filtered(Angle u_6, float w_1, ProfileShape shape_3) {
    float _e3 = profile_point(u_6, shape_3);
    bool is_wide = (w_1 < (0.1 * shape_3.edge_deviation));
    if (((is_wide || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e16 = angle_turned(u_6, _e15);
    float _e17 = profile_point(_e16, shape_3);
    Angle _e22 = angle_turned(u_6, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point(_e22, shape_3);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_2_(Angle u_7, float w_2, ProfileShape shape_4) {
    float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_1 = (w_2 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_1 || (w_2 <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w_2));
    Angle _e16 = angle_turned(u_7, _e15);
    float _e17 = profile_point_2_(_e16, shape_4);
    Angle _e22 = angle_turned(u_7, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point_2_(_e22, shape_4);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_3_(Angle u_8, float w_3, ProfileShape shape_5) {
    float _e3 = profile_point_3_(u_8, shape_5);
    bool is_wide_2 = (w_3 < (0.1 * shape_5.edge_deviation));
    if (((is_wide_2 || (w_3 <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w_3));
    Angle _e16 = angle_turned(u_8, _e15);
    float _e17 = profile_point_3_(_e16, shape_5);
    Angle _e22 = angle_turned(u_8, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point_3_(_e22, shape_5);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_6) {
    Angle _e6 = angle_turned_2_(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_6);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_7) {
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_8) {
    Angle _e6 = angle_turned_2_(angle_2, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

VectorParts separate_vector(vec3 vector) {
    return VectorParts(vector.x, vector.y, 0.0);
}

vec4 shade(Surface surface_1) {
    vec2 uv = surface_1.uv;
    VectorParts _e4 = separate_vector(vec3(uv, 0.0));
    float tone_2 = ((_e4.y - 0.14) / 0.72);
    float _e11 = footprint_of(tone_2);
    float _e15 = step_filtered(tone_2, -0.006, length(vec2(_e11, 0.0)));
    float _e17 = footprint_of(tone_2);
    float _e21 = step_filtered(tone_2, 0.006, length(vec2(_e17, 0.0)));
    float angles_line = (_e15 - _e21);
    float angles_tone = max(angles_line, 0.0);
    vec4 _e37 = blend_alpha(vec4(0.98, 0.965, 0.925, 1.0), vec4(0.24, 0.26, 0.3, 1.0), angles_tone, 1.0, true);
    float angle_3 = mix(0.0, 3.1415927, ((_e4.x - 0.08) / 0.84));
    float _e47 = footprint_of(angle_3);
    float _e51 = step_filtered(angle_3, -0.012, length(vec2(_e47, 0.0)));
    float _e53 = footprint_of(angle_3);
    float _e57 = step_filtered(angle_3, 0.012, length(vec2(_e53, 0.0)));
    float tones_line = (_e51 - _e57);
    float tones_tone = max(tones_line, 0.0);
    vec4 tones = max(vec4((_e37.xyz + (tones_tone * (vec3(0.24, 0.26, 0.3) - _e37.xyz))), 1.0), vec4(0.0));
    float _e76 = footprint_of(angle_3);
    float _e80 = step_filtered(angle_3, 0.492, length(vec2(_e76, 0.0)));
    float _e82 = footprint_of(angle_3);
    float _e86 = step_filtered(angle_3, 0.508, length(vec2(_e82, 0.0)));
    float offset_line = (_e80 - _e86);
    float offset_tone = max(offset_line, 0.0);
    vec4 _e97 = blend_alpha_2_(tones, vec4(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55, true);
    float _e99 = footprint_of(angle_3);
    float _e103 = step_filtered(angle_3, 0.942, length(vec2(_e99, 0.0)));
    float _e105 = footprint_of(angle_3);
    float _e109 = step_filtered(angle_3, 0.958, length(vec2(_e105, 0.0)));
    float falloff_line = (_e103 - _e109);
    float falloff_tone = max(falloff_line, 0.0);
    vec4 _e120 = blend_alpha_2_(_e97, vec4(0.2, 0.38, 0.78, 1.0), falloff_tone, 0.55, true);
    float _e122 = footprint_of(angle_3);
    float _e126 = step_filtered(angle_3, 1.792, length(vec2(_e122, 0.0)));
    float _e128 = footprint_of(angle_3);
    float _e132 = step_filtered(angle_3, 1.808, length(vec2(_e128, 0.0)));
    float cutoff_line = (_e126 - _e132);
    float cutoff_tone = max(cutoff_line, 0.0);
    vec4 _e143 = blend_alpha_2_(_e120, vec4(0.2, 0.38, 0.78, 1.0), cutoff_tone, 0.55, true);
    Angle _e144 = angle_of(angle_3);
    float _e147 = profile(_e144, 0.0, lambert_shape);
    float lambert_off = (tone_2 - _e147);
    float _e150 = footprint_of(lambert_off);
    float _e154 = step_filtered(lambert_off, -0.012, length(vec2(_e150, 0.0)));
    float _e156 = footprint_of(lambert_off);
    float _e160 = step_filtered(lambert_off, 0.012, length(vec2(_e156, 0.0)));
    float lambert_line = (_e154 - _e160);
    float lambert_tone = max(lambert_line, 0.0);
    vec4 lambert_2_ = clamp(vec4((_e143.xyz + (lambert_tone * (vec3(0.8, 0.2, 0.17) - _e143.xyz))), 1.0), vec4(0.0), vec4(1.0));
    Angle _e180 = angle_of(angle_3);
    float _e183 = profile_2_(_e180, 0.0, half_lambert_shape);
    float half_lambert_off = (tone_2 - _e183);
    float _e186 = footprint_of(half_lambert_off);
    float _e190 = step_filtered(half_lambert_off, -0.012, length(vec2(_e186, 0.0)));
    float _e192 = footprint_of(half_lambert_off);
    float _e196 = step_filtered(half_lambert_off, 0.012, length(vec2(_e192, 0.0)));
    float half_lambert_line = (_e190 - _e196);
    float half_lambert_tone = max(half_lambert_line, 0.0);
    vec4 half_lambert_2_ = clamp(vec4((lambert_2_.xyz + (half_lambert_tone * (vec3(0.18, 0.55, 0.27) - lambert_2_.xyz))), 1.0), vec4(0.0), vec4(1.0));
    Angle _e216 = angle_of(angle_3);
    float _e219 = profile_3_(_e216, 0.0, custom_shape);
    float custom_off = (tone_2 - _e219);
    float _e222 = footprint_of(custom_off);
    float _e226 = step_filtered(custom_off, -0.012, length(vec2(_e222, 0.0)));
    float _e228 = footprint_of(custom_off);
    float _e232 = step_filtered(custom_off, 0.012, length(vec2(_e228, 0.0)));
    float custom_line = (_e226 - _e232);
    float custom_tone = max(custom_line, 0.0);
    vec4 output_ = clamp(vec4((half_lambert_2_.xyz + (custom_tone * (vec3(0.5, 0.31, 0.14) - half_lambert_2_.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_uv);
    Surface surface = Surface(vec2(0.0));
    surface.uv = in_.uv;
    Surface _e4 = surface;
    vec4 _e5 = shade(_e4);
    out_color = _e5;
    return;
}

