#version 450 core
// Profile curves: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// figure3-curves.json says what to put there and how to draw.
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
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape lambert_shape = ProfileShape(1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u);
const ProfileShape half_lambert_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);
const ProfileShape custom_shape = ProfileShape(0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928, 0.2351043, 0u);

layout(location = 0) smooth in vec2 v_uv;
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

float power_of_two(int n) {
    return uintBitsToFloat((uint((n + 127)) << 23u));
}

float exp2_stable(float x_2) {
    float clamped_4 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_4);
    float f = ((clamped_4 - whole) * LN_2_);
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

float atan2_positive(float y_1, float x_5) {
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_2 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_2) : a_2);
}

float angle_radians(Angle u) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_of(float radians_) {
    float _e2 = finite_or(radians_, 0.0);
    float half_angle = (0.5 * clamp(_e2, 0.0, PI));
    vec2 _e8 = sin_cos_quarter(half_angle);
    return Angle(max(_e8.x, 0.0), max(_e8.y, 0.0));
}

Angle angle_turned(Angle u_1, vec2 t) {
    bool local = false;
    float s_1 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, c_1));
    if ((s_1 <= 0.0)) {
        local = (s_1 < c_1);
    } else {
        local = false;
    }
    bool _e32 = local;
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
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_3, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_6) {
    uint bits_1 = floatBitsToUint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float mixed(float a, float b, float t_1) {
    float _e4 = bounded((b - a));
    float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
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

float footprint_of(float x_9) {
    float _e1 = dFdx(x_9);
    float _e2 = dFdy(x_9);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float edge_width(float w, float softness) {
    float _e4 = bounded(softness);
    return length(vec2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_10, float edge, float w_1) {
    float _e4 = bounded((x_10 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float unit_share(float share) {
    return clamp(share, 0.0, 1.0);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec2 uv(vec2 uv_1) {
    return uv_1;
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped_1) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed_1 = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped_1 ? clamp(mixed_1, vec4(0.0), vec4(1.0)) : mixed_1);
}

vec4 blend_alpha(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_2) {
    float a_3 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_3) * (1.0 - below_1.w)));
    vec4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_3, clamped_2);
    return _e20;
}

vec4 output_(vec4 color_1) {
    vec4 _e1 = straight(color_1);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
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
    bool local_1 = false;
    float s_2 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_2 <= 0.0))) {
        local_1 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_1 = true;
    }
    bool _e18 = local_1;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_2 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_2 * shape.scale);
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1) {
    bool local_2 = false;
    bool local_3 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_2 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_2 = true;
    }
    bool _e13 = local_2;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_3 = (w_2 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_3 = false;
    }
    bool _e24 = local_3;
    if (_e24) {
        float width = sqrt(((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w_2 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    vec2 _e50 = sin_cos_quarter((0.19364917 * w_2));
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

float threshold(float value, float edge_1, float softness_1) {
    float _e3 = footprint_of(value);
    float _e4 = bounded(value);
    float _e5 = bounded(edge_1);
    float _e6 = edge_width(_e3, softness_1);
    float _e7 = step_filtered(_e4, _e5, _e6);
    return _e7;
}

float map_range(float value_1, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_3) {
    float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_3);
    return _e6;
}

float subtract(float a_1, float b_1) {
    float _e3 = bounded((a_1 - b_1));
    return _e3;
}

VectorParts separate_vector(vec3 vector) {
    return VectorParts(vector.x, vector.y, vector.z);
}

vec4 shade(Surface surface_1) {
    vec2 _e2 = uv(surface_1.uv);
    VectorParts _e5 = separate_vector(vec3(_e2, 0.0));
    float _e12 = map_range(_e5.y, 0.14, 0.86, 0.0, 1.0, false);
    float _e15 = threshold(_e12, -0.006, 0.0);
    float _e18 = threshold(_e12, 0.006, 0.0);
    float _e19 = subtract(_e15, _e18);
    float _e20 = unit_share(_e19);
    vec4 _e33 = blend_alpha(vec4(0.98, 0.965, 0.925, 1.0), vec4(0.24, 0.26, 0.3, 1.0), _e20, 1.0, true);
    float _e40 = map_range(_e5.x, 0.08, 0.92, 0.0, 3.1415927, false);
    float _e43 = threshold(_e40, -0.012, 0.0);
    float _e46 = threshold(_e40, 0.012, 0.0);
    float _e47 = subtract(_e43, _e46);
    float _e48 = unit_share(_e47);
    vec4 _e56 = blend_alpha(_e33, vec4(0.24, 0.26, 0.3, 1.0), _e48, 1.0, true);
    float _e59 = threshold(_e40, 0.492, 0.0);
    float _e62 = threshold(_e40, 0.508, 0.0);
    float _e63 = subtract(_e59, _e62);
    float _e64 = unit_share(_e63);
    vec4 _e72 = blend_alpha(_e56, vec4(0.2, 0.38, 0.78, 1.0), _e64, 0.55, true);
    float _e75 = threshold(_e40, 0.942, 0.0);
    float _e78 = threshold(_e40, 0.958, 0.0);
    float _e79 = subtract(_e75, _e78);
    float _e80 = unit_share(_e79);
    vec4 _e88 = blend_alpha(_e72, vec4(0.2, 0.38, 0.78, 1.0), _e80, 0.55, true);
    float _e91 = threshold(_e40, 1.792, 0.0);
    float _e94 = threshold(_e40, 1.808, 0.0);
    float _e95 = subtract(_e91, _e94);
    float _e96 = unit_share(_e95);
    vec4 _e104 = blend_alpha(_e88, vec4(0.2, 0.38, 0.78, 1.0), _e96, 0.55, true);
    Angle _e105 = angle_of(_e40);
    float _e108 = profile(_e105, 0.0, lambert_shape);
    float _e109 = subtract(_e12, _e108);
    float _e112 = threshold(_e109, -0.012, 0.0);
    float _e115 = threshold(_e109, 0.012, 0.0);
    float _e116 = subtract(_e112, _e115);
    float _e117 = unit_share(_e116);
    vec4 _e125 = blend_alpha(_e104, vec4(0.8, 0.2, 0.17, 1.0), _e117, 1.0, true);
    Angle _e126 = angle_of(_e40);
    float _e129 = profile(_e126, 0.0, half_lambert_shape);
    float _e130 = subtract(_e12, _e129);
    float _e133 = threshold(_e130, -0.012, 0.0);
    float _e136 = threshold(_e130, 0.012, 0.0);
    float _e137 = subtract(_e133, _e136);
    float _e138 = unit_share(_e137);
    vec4 _e146 = blend_alpha(_e125, vec4(0.18, 0.55, 0.27, 1.0), _e138, 1.0, true);
    Angle _e147 = angle_of(_e40);
    float _e150 = profile(_e147, 0.0, custom_shape);
    float _e151 = subtract(_e12, _e150);
    float _e154 = threshold(_e151, -0.012, 0.0);
    float _e157 = threshold(_e151, 0.012, 0.0);
    float _e158 = subtract(_e154, _e157);
    float _e159 = unit_share(_e158);
    vec4 _e167 = blend_alpha(_e146, vec4(0.5, 0.31, 0.14, 1.0), _e159, 1.0, true);
    vec4 _e168 = output_(_e167);
    return _e168;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_uv);
    Surface surface = Surface(vec2(0.0));
    surface.uv = in_.uv;
    Surface _e4 = surface;
    vec4 _e5 = shade(_e4);
    vec4 _e6 = finite_vec4_(_e5);
    out_color = _e6;
    return;
}

