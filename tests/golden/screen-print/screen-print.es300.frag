#version 300 es
// Screen print: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// screen-print.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
    vec4 screen;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light side;
    vec2 viewport;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    float kappa;
    vec2 pixel;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape yellow_s_share_shape = ProfileShape(0.9887711, 0.14943813, 2.0858297, 1.7378688, 0.3, 0.54759663, 0.22553022, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
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
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
    float p_1 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p_1 * _e33) * _e37);
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

vec2 sin_cos(float x_5) {
    float turns = roundEven((x_5 * 0.31830987));
    float r_1 = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    vec2 _e27 = sin_cos_quarter(clamp(r_1, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

Angle angle_between(vec3 d, vec3 l) {
    float p_2 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_2 * p_2) + (s_1 * s_1)), 1e-30)));
    return Angle((p_2 * k), (s_1 * k));
}

float atan2_positive(float y_1, float x_6) {
    float small = min(y_1, x_6);
    float large = max(y_1, x_6);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_4 = (small / large);
    bool is_wide = (t_4 > 0.41421357);
    float r_2 = (is_wide ? ((small - large) / (small + large)) : t_4);
    float r2_ = (r_2 * r_2);
    float series_1 = (r_2 * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_8 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_6) ? (HALF_PI - a_8) : a_8);
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
    float w_6 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_6, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_7) {
    uint bits_1 = floatBitsToUint(x_7);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_7 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec2 bounded_vec2_(vec2 v_3) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return vec2(_e2, _e4);
}

vec3 bounded_vec3_(vec3 v_4) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    return vec3(_e2, _e4, _e6);
}

vec4 bounded_vec4_(vec4 v_5) {
    float _e2 = bounded(v_5.x);
    float _e4 = bounded(v_5.y);
    float _e6 = bounded(v_5.z);
    float _e8 = bounded(v_5.w);
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

float place_between(float x_8, float low, float high) {
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_8 >= high) ? 1.0 : 0.0);
    }
    float _e12 = bounded(span);
    float _e14 = bounded(((x_8 - low) / _e12));
    return _e14;
}

float remapped(float x_9, float from_low, float from_high, float to_low, float to_high, bool clamped) {
    float _e6 = bounded(x_9);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_10, float low_1, float high_1) {
    float _e3 = bounded(x_10);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float factor_of(float x_11, bool clamped_1) {
    float _e2 = bounded(x_11);
    float _e3 = bounded(x_11);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

vec2 sin_cos_of(float x_12) {
    float _e1 = bounded(x_12);
    vec2 _e2 = sin_cos(_e1);
    return clamp(_e2, vec2(-1.0), vec2(1.0));
}

float footprint_of(float x_13) {
    float _e1 = dFdx(x_13);
    float _e2 = dFdy(x_13);
    vec2 d_2 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_2, d_2)));
    return _e6;
}

vec2 footprint_of_vec2_(vec2 v_6) {
    vec2 dx_1 = dFdx(v_6);
    vec2 dy_1 = dFdy(v_6);
    vec2 _e7 = bounded_vec2_(sqrt(((dx_1 * dx_1) + (dy_1 * dy_1))));
    return _e7;
}

float edge_width(float w, float softness) {
    float _e4 = bounded(softness);
    return length(vec2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_14, float edge, float w_1) {
    float _e4 = bounded((x_14 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

vec4 color_mixed(vec4 a_3, vec3 blended, float factor) {
    vec3 _e4 = bounded_vec3_(a_3.xyz);
    vec3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    vec3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_3.w);
    return vec4(_e8, _e10);
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

vec4 mix_colors_normal(vec4 a_4, vec4 b_3, float factor_1) {
    vec4 _e3 = bounded_vec4_(a_4);
    vec4 _e4 = bounded_vec4_(b_3);
    float _e6 = factor_of(factor_1, true);
    vec4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

vec4 mix_colors_multiply(vec4 a_5, vec4 b_4, float factor_2) {
    vec4 _e6 = color_mixed(a_5, (a_5.xyz * b_4.xyz), factor_2);
    return _e6;
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_9 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_9), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_9 * a_9);
        return (a_9 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_6 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_9 >= 0.0) ? t_6 : -(t_6));
}

float transition(float kappa_2, float slope_1) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float facing(vec3 normal, vec3 view) {
    vec3 _e4 = normalize_or(normal, vec3(0.0));
    return clamp(dot(_e4, view), 0.0, 1.0);
}

float kappa_surface(float kappa_3) {
    float _e1 = kappa_safe(kappa_3);
    return _e1;
}

vec4 output_(vec4 color_1) {
    vec4 _e1 = straight(color_1);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(Light light, vec3 normal_1) {
    vec3 _e6 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light.direction);
    return _e8;
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

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1) {
    bool local_3 = false;
    bool local_4 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w_2 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
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

vec2 turned_by(vec2 p, float angle_1) {
    vec2 _e2 = sin_cos_of(angle_1);
    return vec2(((_e2.y * p.x) - (_e2.x * p.y)), ((_e2.x * p.x) + (_e2.y * p.y)));
}

vec2 screen_cells(vec2 place, vec2 viewport, float lines, float angle_2) {
    vec2 most = vec2(4194304.0);
    vec2 _e6 = bounded_vec2_(place);
    float _e7 = bounded(lines);
    vec2 _e15 = bounded_vec2_((_e6 * (max(_e7, 0.0) / max(viewport.y, 1.0))));
    vec2 _e18 = turned_by(clamp(_e15, -(most), most), angle_2);
    return clamp(_e18, -(most), most);
}

float lines_integral(float x_15, float share) {
    float whole_1 = roundEven(x_15);
    return ((whole_1 * share) + clamp((x_15 - whole_1), (-0.5 * share), (0.5 * share)));
}

float lines_filtered(float x_16, float share_1, float w_3) {
    bool local_5 = false;
    float t_7 = (x_16 - roundEven(x_16));
    if ((w_3 < 1e-30)) {
        if ((abs(t_7) <= (0.5 * share_1))) {
            local_5 = (share_1 > 0.0);
        } else {
            local_5 = false;
        }
        bool _e16 = local_5;
        return (_e16 ? 1.0 : 0.0);
    }
    float half_1 = (0.5 * min(w_3, 1000.0));
    float _e25 = lines_integral((t_7 + half_1), share_1);
    float _e27 = lines_integral((t_7 - half_1), share_1);
    return clamp(((_e25 - _e27) / (2.0 * half_1)), 0.0, 1.0);
}

float dot_radius(float share_2) {
    float a_6 = 0.0;
    int i = 0;
    float t_8 = clamp(share_2, 0.0, 1.0);
    if ((t_8 <= 0.7853982)) {
        return sqrt((t_8 * 0.31830987));
    }
    float s_4 = min(((t_8 - 0.7853982) / (1.0 - 0.7853982)), 1.0);
    a_6 = mix((0.5227232 * sqrt(s_4)), (0.7853982 - (0.3275682 * sqrt((1.0 - s_4)))), s_4);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e63 = i;
            i = (_e63 + 1);
        }
        loop_init = false;
        int _e28 = i;
        if ((_e28 < 2)) {
        } else {
            break;
        }
        {
            float _e31 = a_6;
            vec2 _e34 = sin_cos_quarter(clamp(_e31, 0.0, 0.7853982));
            float tangent = (_e34.x / _e34.y);
            float square_1 = (1.0 / (_e34.y * _e34.y));
            float _e44 = a_6;
            float sector = (0.7853982 - _e44);
            float slope_2 = (((2.0 * sector) * square_1) * tangent);
            float _e50 = a_6;
            a_6 = clamp((_e50 - ((slope_2 > 0.001) ? ((((sector * square_1) + tangent) - t_8) / slope_2) : 0.0)), 0.0, 0.7853982);
        }
    }
    float _e65 = a_6;
    vec2 _e66 = sin_cos_quarter(_e65);
    return (0.5 / _e66.y);
}

float disk_filtered(float d_1, float r, float w_4) {
    bool local_6 = false;
    if ((w_4 < 1e-30)) {
        if ((d_1 <= r)) {
            local_6 = (r > 0.0);
        } else {
            local_6 = false;
        }
        bool _e11 = local_6;
        return (_e11 ? 1.0 : 0.0);
    }
    float square_2 = (r * r);
    float least = ((w_4 * w_4) / 3.0);
    float inner = sqrt((max(square_2, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d_1) / w_4)), 0.0, 1.0) * min((square_2 / least), 1.0));
}

float ink_of_dots(vec2 cell, float share_3, float w_5) {
    float ink = 0.0;
    bool local_7 = false;
    float width_1 = min(w_5, 1.0);
    float _e8 = dot_radius(share_3);
    float _e9 = disk_filtered(length((cell - roundEven(cell))), _e8, width_1);
    ink = _e9;
    float hole = sqrt((max((1.0 - share_3), 0.0) * 0.31830987));
    float _e22 = eased(width_1, (0.3 * hole), (0.9 * hole));
    float _e25 = eased(share_3, 0.5, 0.7);
    float is_star = (_e22 * _e25);
    if ((is_star > 0.0)) {
        float _e29 = ink;
        float _e36 = disk_filtered(length(((cell - floor(cell)) - vec2(0.5))), hole, width_1);
        ink = mix(_e29, (1.0 - _e36), is_star);
    }
    float _e40 = ink;
    float _e43 = eased(w_5, 0.4, 1.0);
    float mean = mix(_e40, share_3, _e43);
    if (!((share_3 <= 0.0))) {
        local_7 = (share_3 >= 1.0);
    } else {
        local_7 = true;
    }
    bool _e53 = local_7;
    return (_e53 ? share_3 : mean);
}

float reflectance_wrap(Light light_1, vec3 normal_2, float wrap) {
    float _e3 = bounded(wrap);
    float w_7 = clamp(_e3, 0.0, 1.0);
    vec3 _e11 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light_1.direction);
    return max(((cosine + w_7) / (1.0 + w_7)), 0.0);
}

float map_range(float value_1, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2) {
    float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(float a_7, float b_5) {
    float _e3 = bounded((a_7 * b_5));
    return _e3;
}

float halftone_dots(float value_2, vec2 place_1, float lines_1, float angle_3, vec2 viewport_1) {
    vec2 _e5 = screen_cells(place_1, viewport_1, lines_1, angle_3);
    vec2 _e6 = footprint_of_vec2_(_e5);
    float _e8 = factor_of(value_2, true);
    float _e14 = ink_of_dots(_e5, (1.0 - _e8), max(_e6.x, _e6.y));
    return (1.0 - _e14);
}

float halftone_lines(float value_3, vec2 place_2, float lines_2, float angle_4, vec2 viewport_2) {
    vec2 _e5 = screen_cells(place_2, viewport_2, lines_2, angle_4);
    float _e8 = factor_of(value_3, true);
    float _e12 = footprint_of(_e5.y);
    float _e13 = lines_filtered(_e5.y, (1.0 - _e8), _e12);
    return (1.0 - _e13);
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.side;
    Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    float _e8 = profile(_e5, 0.0, yellow_s_share_shape);
    float _e14 = map_range(_e8, 0.0, 1.0, 1.0, 0.25, true);
    vec2 _e20 = u_look.viewport;
    float _e21 = halftone_lines(_e14, surface_1.pixel, 56.0, 0.0, _e20);
    vec4 _e29 = mix_colors_normal(vec4(0.9647, 0.8118, 0.2902, 1.0), vec4(1.0), _e21);
    vec4 _e36 = mix_colors_multiply(vec4(0.9686, 0.9373, 0.8784, 1.0), _e29, 1.0);
    Light _e39 = u_look.key;
    float _e42 = reflectance_wrap(_e39, surface_1.normal, 0.3);
    float _e48 = map_range(_e42, 0.0, 0.8, 0.0, 1.0, true);
    float _e54 = map_range(_e48, 0.25, 0.95, 0.12, 1.0, true);
    vec2 _e60 = u_look.viewport;
    float _e61 = halftone_dots(_e54, surface_1.pixel, 56.0, 0.2618, _e60);
    vec4 _e69 = mix_colors_normal(vec4(0.9333, 0.3529, 0.2902, 1.0), vec4(1.0), _e61);
    vec4 _e71 = mix_colors_multiply(_e36, _e69, 1.0);
    float _e77 = map_range(_e48, 0.0, 0.5, 0.05, 1.0, true);
    vec2 _e83 = u_look.viewport;
    float _e84 = halftone_dots(_e77, surface_1.pixel, 56.0, 1.309, _e83);
    vec4 _e92 = mix_colors_normal(vec4(0.1216, 0.5608, 0.5922, 1.0), vec4(1.0), _e84);
    vec4 _e94 = mix_colors_multiply(_e71, _e92, 1.0);
    float _e96 = kappa_surface(surface_1.kappa);
    float _e98 = transition(_e96, 0.25);
    float _e101 = threshold(_e98, 0.22, 0.0);
    float _e104 = facing(surface_1.normal, surface_1.view);
    float _e107 = threshold(_e104, 0.28, 0.0);
    float _e108 = multiply(_e101, _e107);
    vec4 _e116 = mix_colors_normal(vec4(0.0902, 0.0745, 0.1216, 1.0), vec4(1.0), _e108);
    vec4 _e118 = mix_colors_multiply(_e94, _e116, 1.0);
    vec4 _e119 = premultiplied(_e118);
    vec4 _e120 = output_(_e119);
    return _e120;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), 0.0, vec2(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_3 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_3;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    vec4 _e40 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e40.x;
    vec4 _e47 = u_view.screen;
    vec4 _e52 = u_view.screen;
    surface.pixel = ((in_.clip.xy * _e47.xy) + _e52.zw);
    Surface _e55 = surface;
    vec4 _e56 = shade(_e55);
    vec4 _e57 = finite_vec4_(_e56);
    out_color = _e57;
    return;
}

