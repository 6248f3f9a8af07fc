#version 330 core
// Travel poster: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// travel-poster.json says what to put there and how to draw.
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
    Light sky;
};
struct Surface {
    vec3 normal;
    vec3 view;
    float kappa;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
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
const ProfileShape evening_sun_tone_shape = ProfileShape(1.0, 0.0, 1.0955735, 1.6395584, 0.0, 1.1385497, 0.5052584, 0u);
const ProfileShape sky_tone_shape = ProfileShape(1.0, 0.0, 1.229384, 1.2860026, 0.0, 1.0836705, 0.44442755, 0u);
const ProfileShape glow_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.425296, 2.5857167, 0.1, 0.4039123, 0.17722374, 0u);
const Ramp seven_inks = Ramp(vec4[16](vec4(0.0863, 0.1333, 0.2471, 1.0), vec4(0.1725, 0.3176, 0.3882, 1.0), vec4(0.4863, 0.2275, 0.2706, 1.0), vec4(0.7686, 0.3294, 0.2471, 1.0), vec4(0.8784, 0.5412, 0.298, 1.0), vec4(0.9412, 0.7608, 0.4824, 1.0), vec4(0.9843, 0.9333, 0.7961, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.15, 0.3, 0.45), vec4(0.6, 0.8, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

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
    float clamped_2 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_2);
    float f = ((clamped_2 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_2 = ((shift_2 >= 256) ? (shift_2 - 512) : shift_2);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_2) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_2) * LN_2_) + series);
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
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a) : a);
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
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_5, 0.5);
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

float powered(float base, float exponent) {
    bool local_2 = false;
    float _e2 = bounded(base);
    float _e3 = bounded(exponent);
    if ((_e3 == 1.0)) {
        return _e2;
    }
    if ((_e3 == 0.0)) {
        return 1.0;
    }
    if ((_e3 == 2.0)) {
        float _e12 = bounded((_e2 * _e2));
        return _e12;
    }
    float magnitude_1 = abs(_e2);
    if ((magnitude_1 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e18 = log_stable(magnitude_1);
    float _e21 = bounded((_e3 * (LOG2_E * _e18)));
    float _e22 = exp2_stable(_e21);
    bool is_even = (floor((_e3 * 0.5)) == (_e3 * 0.5));
    if ((_e2 < 0.0)) {
        local_2 = !(is_even);
    } else {
        local_2 = false;
    }
    bool _e36 = local_2;
    return (_e36 ? -(_e22) : _e22);
}

float length_of(vec3 v_4) {
    vec3 _e1 = bounded_vec3_(v_4);
    float largest_2 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e17 = bounded((largest_2 * length((_e1 / vec3(largest_2)))));
    return _e17;
}

float footprint_of(float x_7) {
    float _e1 = dFdx(x_7);
    float _e2 = dFdy(x_7);
    vec2 d_1 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float edge_width(float w, float softness) {
    float _e4 = bounded(softness);
    return length(vec2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_8, float edge, float w_1) {
    float _e4 = bounded((x_8 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float stairs_integral(float x_9, float count) {
    float inside = clamp(x_9, 0.0, count);
    float stair = min(floor(inside), (count - 1.0));
    float beyond = max((x_9 - count), 0.0);
    return ((stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * (count - 1.0)));
}

float stairs_filtered(float x_10, float count_1, float w_2) {
    if ((w_2 <= 1.0)) {
        float edge_1 = clamp(roundEven(x_10), 1.0, (count_1 - 1.0));
        float _e12 = step_filtered(x_10, edge_1, w_2);
        return ((edge_1 - 1.0) + _e12);
    }
    float half_1 = (0.5 * min(w_2, (1000.0 * count_1)));
    float _e20 = stairs_integral((x_10 + half_1), count_1);
    float _e22 = stairs_integral((x_10 - half_1), count_1);
    return ((_e20 - _e22) / (2.0 * half_1));
}

float stepped_tone(float value, float w_3, int count_2, float softness_1) {
    float n_1 = float(min(max(count_2, 2), 1024));
    float _e11 = edge_width((n_1 * w_3), min(softness_1, 1.0));
    float _e12 = bounded(value);
    float _e17 = stairs_filtered((n_1 * clamp(_e12, 0.0, 1.0)), n_1, _e11);
    return clamp((_e17 / (n_1 - 1.0)), 0.0, 1.0);
}

float linear_of_srgb(float coded) {
    float _e1 = bounded(coded);
    float size = abs(_e1);
    float _e8 = powered(((size + 0.055) / 1.055), 2.4);
    float value_1 = ((size <= 0.04045) ? (size / 12.92) : _e8);
    return ((coded < 0.0) ? -(value_1) : value_1);
}

float srgb_of_linear(float light) {
    float _e1 = bounded(light);
    float size_1 = abs(_e1);
    float _e4 = powered(size_1, 0.41666666);
    float value_2 = ((size_1 <= 0.0031308) ? (size_1 * 12.92) : ((1.055 * _e4) - 0.055));
    float _e18 = bounded(((light < 0.0) ? -(value_2) : value_2));
    return _e18;
}

vec3 within_unit(vec3 rgb) {
    vec3 _e1 = bounded_vec3_(rgb);
    return clamp(_e1, vec3(0.0), vec3(1.0));
}

float cube_root(float x_11) {
    float _e3 = powered(abs(x_11), 0.33333334);
    return ((x_11 < 0.0) ? -(_e3) : _e3);
}

vec3 oklab_of_linear(vec3 rgb_1) {
    vec3 _e1 = bounded_vec3_(rgb_1);
    vec3 c_2 = clamp(_e1, vec3(-1000000000.0), vec3(1000000000.0));
    float _e12 = cube_root(dot(c_2, vec3(0.41222146, 0.53633255, 0.051445995)));
    float _e18 = cube_root(dot(c_2, vec3(0.2119035, 0.6806995, 0.10739696)));
    float _e24 = cube_root(dot(c_2, vec3(0.08830246, 0.28171885, 0.6299787)));
    return vec3((((0.21045426 * _e12) + (0.7936178 * _e18)) - (0.004072047 * _e24)), (((1.9779985 * _e12) - (2.4285922 * _e18)) + (0.4505937 * _e24)), (((0.025904037 * _e12) + (0.78277177 * _e18)) - (0.80867577 * _e24)));
}

vec3 linear_of_oklab(vec3 lab) {
    vec3 _e1 = bounded_vec3_(lab);
    vec3 c_3 = clamp(_e1, vec3(-1000000.0), vec3(1000000.0));
    float l_1 = ((c_3.x + (0.39633778 * c_3.y)) + (0.21580376 * c_3.z));
    float m = ((c_3.x - (0.105561346 * c_3.y)) - (0.06385417 * c_3.z));
    float s_3 = ((c_3.x - (0.08948418 * c_3.y)) - (1.2914855 * c_3.z));
    vec3 cubes = vec3(((l_1 * l_1) * l_1), ((m * m) * m), ((s_3 * s_3) * s_3));
    return vec3(dot(cubes, vec3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, vec3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, vec3(-0.0041960864, -0.7034186, 1.7076147)));
}

vec3 oklab_of_srgb(vec3 coded_1) {
    float _e2 = linear_of_srgb(coded_1.x);
    float _e4 = linear_of_srgb(coded_1.y);
    float _e6 = linear_of_srgb(coded_1.z);
    vec3 _e8 = oklab_of_linear(vec3(_e2, _e4, _e6));
    return _e8;
}

vec3 srgb_of_oklab(vec3 lab_1) {
    vec3 _e1 = linear_of_oklab(lab_1);
    float _e3 = srgb_of_linear(_e1.x);
    float _e5 = srgb_of_linear(_e1.y);
    float _e7 = srgb_of_linear(_e1.z);
    return vec3(_e3, _e5, _e7);
}

vec3 palette_blend(Ramp palette, vec3 rgb_2, float softness_2) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    float nearest = 1e30;
    vec3 found = vec3(0.0);
    uint i = 0u;
    bool local_3 = false;
    vec3 sum = vec3(0.0);
    float total = 0.0;
    uint i_1 = 0u;
    uint count_3 = min(palette.count, 16u);
    colors = palette.colors;
    vec3 _e8 = oklab_of_srgb(rgb_2);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e39 = i;
            i = (_e39 + 1u);
        }
        loop_init = false;
        uint _e16 = i;
        if ((_e16 < count_3)) {
        } else {
            break;
        }
        {
            uint _e18 = i;
            vec4 _e20 = colors[_e18];
            vec3 _e22 = oklab_of_srgb(_e20.xyz);
            float _e24 = length_of((_e22 - _e8));
            float far = min(_e24, 1e29);
            vec3 _e27 = found;
            uint _e28 = i;
            vec4 _e30 = colors[_e28];
            vec3 _e32 = bounded_vec3_(_e30.xyz);
            float _e33 = nearest;
            found = ((far < _e33) ? _e32 : _e27);
            float _e36 = nearest;
            nearest = min(_e36, far);
        }
    }
    if (!((softness_2 <= 0.0))) {
        local_3 = (count_3 == 0u);
    } else {
        local_3 = true;
    }
    bool _e49 = local_3;
    if (_e49) {
        vec3 _e50 = found;
        return _e50;
    }
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e83 = i_1;
            i_1 = (_e83 + 1u);
        }
        loop_init_1 = false;
        uint _e58 = i_1;
        if ((_e58 < count_3)) {
        } else {
            break;
        }
        {
            uint _e60 = i_1;
            vec4 _e62 = colors[_e60];
            vec3 _e64 = oklab_of_srgb(_e62.xyz);
            float _e66 = length_of((_e64 - _e8));
            float _e67 = nearest;
            float near = clamp((1.0 - ((_e66 - _e67) / softness_2)), 0.0, 1.0);
            vec3 _e75 = sum;
            sum = (_e75 + ((near * near) * _e64));
            float _e79 = total;
            total = (_e79 + (near * near));
        }
    }
    vec3 _e85 = sum;
    float _e86 = total;
    vec3 _e91 = srgb_of_oklab((_e85 / vec3(max(_e86, 1e-6))));
    vec3 _e92 = bounded_vec3_(_e91);
    return _e92;
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

vec4 palette_nearest(vec4 color_1, Ramp palette_1) {
    vec3 _e3 = bounded_vec3_(color_1.xyz);
    vec3 _e5 = palette_blend(palette_1, _e3, 0.0);
    float _e7 = bounded(color_1.w);
    return vec4(_e5, _e7);
}

vec4 posterize_lightness(vec4 color_2, int steps, float softness_3) {
    vec3 _e4 = within_unit(color_2.xyz);
    vec3 _e5 = oklab_of_srgb(_e4);
    float _e8 = footprint_of(_e5.x);
    float _e9 = stepped_tone(_e5.x, _e8, steps, softness_3);
    float kept = ((_e5.x > 0.0001) ? (_e9 / max(_e5.x, 0.0001)) : 0.0);
    vec3 _e24 = srgb_of_oklab(vec3(_e9, (_e5.yz * min(kept, 1.0))));
    vec3 _e25 = within_unit(_e24);
    float _e27 = bounded(color_2.w);
    return vec4(_e25, _e27);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_1 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_2 = min(abs(a_1), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude_2));
    float t_2 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float transition(float kappa_2, float slope_1) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float warp(float convexity_1, float amount) {
    return (((2.0 * convexity_1) - 1.0) * clamp(amount, -3.1415927, 3.1415927));
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped ? clamp(mixed, vec4(0.0), vec4(1.0)) : mixed);
}

vec4 blend_add(vec4 below_1, vec4 color_3, float tone, float opacity_1, bool clamped_1) {
    vec4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color_3.xyz)), below_1.w, (opacity_1 * color_3.w), clamped_1);
    return _e12;
}

vec4 output_(vec4 color_4) {
    vec4 _e1 = straight(color_4);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light_1, vec4 color_5, float tone_1) {
    vec2 _e4 = light_split(light_1.intensity);
    return LitLayer(vec4(((color_5.xyz * light_1.color) * _e4.y), color_5.w), (tone_1 * _e4.x));
}

Angle parametrization_diffuse(Light light_2, vec3 normal) {
    vec3 _e6 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light_2.direction);
    return _e8;
}

Angle parametrization_specular(Light light_3, vec3 normal_1, vec3 view) {
    vec3 _e7 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    vec3 mirrored = (((2.0 * dot(_e7, view)) * _e7) - view);
    vec3 _e13 = normalize_or(mirrored, _e7);
    Angle _e15 = angle_between(_e13, light_3.direction);
    return _e15;
}

float profile_power(float q, float exponent_1) {
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
    float _e21 = exp2_stable(((exponent_1 * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape) {
    bool local_4 = false;
    float s_4 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_4 <= 0.0))) {
        local_4 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_4 = true;
    }
    bool _e18 = local_4;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_4 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_4 * shape.scale);
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_4, ProfileShape shape_1) {
    bool local_5 = false;
    bool local_6 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_4 <= 0.0))) {
        local_5 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_5 = true;
    }
    bool _e13 = local_5;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_6 = (w_4 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_6 = false;
    }
    bool _e24 = local_6;
    if (_e24) {
        float width = sqrt(((w_4 * w_4) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w_4 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    vec2 _e50 = sin_cos_quarter((0.19364917 * w_4));
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

vec4 shade(Surface surface_1) {
    float _e3 = transition(surface_1.kappa, 0.12);
    vec4 _e14 = curvature_color(_e3, vec4(0.93, 0.62, 0.36, 1.0), vec4(0.66, 0.24, 0.24, 1.0));
    Light _e17 = u_look.key;
    Angle _e19 = parametrization_diffuse(_e17, surface_1.normal);
    float _e21 = warp(_e3, 0.1);
    float _e23 = profile(_e19, _e21, evening_sun_tone_shape);
    Light _e26 = u_look.key;
    LitLayer _e27 = light_apply(_e26, _e14, _e23);
    vec4 _e37 = blend_add(vec4(0.07, 0.1, 0.22, 1.0), _e27.color, _e27.tone, 1.0, true);
    Light _e40 = u_look.sky;
    Angle _e42 = parametrization_diffuse(_e40, surface_1.normal);
    float _e45 = profile(_e42, 0.0, sky_tone_shape);
    Light _e48 = u_look.sky;
    LitLayer _e54 = light_apply(_e48, vec4(0.02, 0.24, 0.3, 1.0), _e45);
    vec4 _e59 = blend_add(_e37, _e54.color, _e54.tone, 1.0, true);
    Light _e62 = u_look.key;
    Angle _e65 = parametrization_specular(_e62, surface_1.normal, surface_1.view);
    float _e68 = profile(_e65, 0.0, glow_tone_shape);
    Light _e71 = u_look.key;
    LitLayer _e77 = light_apply(_e71, vec4(0.42, 0.38, 0.24, 1.0), _e68);
    vec4 _e82 = blend_add(_e59, _e77.color, _e77.tone, 1.0, true);
    vec4 _e83 = straight(_e82);
    vec4 _e86 = posterize_lightness(_e83, 7, 0.02);
    vec4 _e88 = palette_nearest(_e86, seven_inks);
    vec4 _e89 = premultiplied(_e88);
    vec4 _e90 = output_(_e89);
    return _e90;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), 0.0);
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_2 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_2;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    vec4 _e40 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e40.x;
    Surface _e42 = surface;
    vec4 _e43 = shade(_e42);
    vec4 _e44 = finite_vec4_(_e43);
    out_color = _e44;
    return;
}

