#version 330 core
// Clay relief: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0, u_curvature_tensor_map 1.
// clay-relief.json says what to put there and how to draw.
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
    Light sky;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    float kappa;
    vec3 curvature_tensor;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
};
struct RampPlace {
    vec4 before;
    vec4 after;
    float t;
};
struct Relief {
    float shape;
    float strength;
    float greatest;
    float least;
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
const uint INTERPOLATION_SMOOTH = 1u;
const uint INTERPOLATION_STEPPED = 2u;
const Ramp terracotta = Ramp(vec4[16](vec4(0.2353, 0.102, 0.1098, 1.0), vec4(0.5412, 0.251, 0.1882, 1.0), vec4(0.8118, 0.498, 0.3412, 1.0), vec4(0.949, 0.7412, 0.5725, 1.0), vec4(0.9843, 0.8627, 0.7333, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.3, 0.62, 0.9), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 0u);
const Ramp pits_to_bumps = Ramp(vec4[16](vec4(0.2941, 0.2275, 0.3216, 1.0), vec4(0.4784, 0.2902, 0.2902, 1.0), vec4(0.7529, 0.502, 0.3765, 1.0), vec4(0.9412, 0.7529, 0.5804, 1.0), vec4(1.0, 0.9412, 0.8471, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.3, 0.5, 0.75), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

uniform sampler2D u_curvature_tensor_map;

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
    float clamped_1 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_1);
    float f = ((clamped_1 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift >= 256) ? (shift - 512) : shift);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float atan2_positive(float y, float x_4) {
    float small = min(y, x_4);
    float large = max(y, x_4);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_6 = (small / large);
    bool is_wide = (t_6 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_6);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_11 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y > x_4) ? (HALF_PI - a_11) : a_11);
}

float bounded(float x_5) {
    uint bits_1 = floatBitsToUint(x_5);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_5 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
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

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float powered(float base, float exponent) {
    bool local_1 = false;
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
        local_1 = !(is_even);
    } else {
        local_1 = false;
    }
    bool _e36 = local_1;
    return (_e36 ? -(_e22) : _e22);
}

float exponential_of(float x_6) {
    float _e3 = bounded((x_6 * LOG2_E));
    float _e4 = exp2_stable(_e3);
    return _e4;
}

float mixed(float a_1, float b_1, float t) {
    float _e4 = bounded((b_1 - a_1));
    float _e14 = bounded(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

vec3 mixed_vec3_(vec3 a_2, vec3 b_2, float t_1) {
    float _e5 = mixed(a_2.x, b_2.x, t_1);
    float _e8 = mixed(a_2.y, b_2.y, t_1);
    float _e11 = mixed(a_2.z, b_2.z, t_1);
    return vec3(_e5, _e8, _e11);
}

vec4 mixed_vec4_(vec4 a_3, vec4 b_3, float t_2) {
    vec3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_2);
    float _e8 = mixed(a_3.w, b_3.w, t_2);
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

float eased(float x_8, float low_1, float high_1) {
    float _e3 = bounded(x_8);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_7 = clamp(_e6, 0.0, 1.0);
    return ((t_7 * t_7) * (3.0 - (2.0 * t_7)));
}

float factor_of(float x_9, bool clamped) {
    float _e2 = bounded(x_9);
    float _e3 = bounded(x_9);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float angle_of_point(float y_1, float x_10) {
    vec2 _e3 = bounded_vec2_(vec2(x_10, y_1));
    vec2 p_1 = abs(_e3);
    vec2 scaled_1 = ((max(p_1.x, p_1.y) > 1.0) ? (0.5 * p_1) : p_1);
    float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned = ((x_10 < 0.0) ? (PI - _e15) : _e15);
    return ((y_1 < 0.0) ? -(turned) : turned);
}

float footprint_of(float x_11) {
    float _e1 = dFdx(x_11);
    float _e2 = dFdy(x_11);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float step_filtered(float x_12, float edge, float w) {
    float _e4 = bounded((x_12 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
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

float soft_light(float a_4, float b_4) {
    if ((b_4 <= 0.5)) {
        return (a_4 - (((1.0 - (2.0 * b_4)) * a_4) * (1.0 - a_4)));
    }
    float curved_1 = ((a_4 <= 0.25) ? (((((16.0 * a_4) - 12.0) * a_4) + 4.0) * a_4) : sqrt(max(a_4, 0.0)));
    return (a_4 + (((2.0 * b_4) - 1.0) * (curved_1 - a_4)));
}

vec4 color_mixed(vec4 a_5, vec3 blended, float factor) {
    vec3 _e4 = bounded_vec3_(a_5.xyz);
    vec3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    vec3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_5.w);
    return vec4(_e8, _e10);
}

float cube_root(float x_13) {
    float _e3 = powered(abs(x_13), 0.33333334);
    return ((x_13 < 0.0) ? -(_e3) : _e3);
}

vec3 oklab_of_linear(vec3 rgb) {
    vec3 _e1 = bounded_vec3_(rgb);
    vec3 c = clamp(_e1, vec3(-1000000000.0), vec3(1000000000.0));
    float _e12 = cube_root(dot(c, vec3(0.41222146, 0.53633255, 0.051445995)));
    float _e18 = cube_root(dot(c, vec3(0.2119035, 0.6806995, 0.10739696)));
    float _e24 = cube_root(dot(c, vec3(0.08830246, 0.28171885, 0.6299787)));
    return vec3((((0.21045426 * _e12) + (0.7936178 * _e18)) - (0.004072047 * _e24)), (((1.9779985 * _e12) - (2.4285922 * _e18)) + (0.4505937 * _e24)), (((0.025904037 * _e12) + (0.78277177 * _e18)) - (0.80867577 * _e24)));
}

vec3 linear_of_oklab(vec3 lab) {
    vec3 _e1 = bounded_vec3_(lab);
    vec3 c_1 = clamp(_e1, vec3(-1000000.0), vec3(1000000.0));
    float l = ((c_1.x + (0.39633778 * c_1.y)) + (0.21580376 * c_1.z));
    float m = ((c_1.x - (0.105561346 * c_1.y)) - (0.06385417 * c_1.z));
    float s = ((c_1.x - (0.08948418 * c_1.y)) - (1.2914855 * c_1.z));
    vec3 cubes = vec3(((l * l) * l), ((m * m) * m), ((s * s) * s));
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

vec4 ends_kept(vec4 a_6, vec4 b_5, float t_3, vec3 rgb_1) {
    vec3 _e4 = bounded_vec3_(rgb_1);
    float _e7 = mixed(a_6.w, b_5.w, t_3);
    vec4 mixed_color = vec4(_e4, _e7);
    vec4 _e9 = bounded_vec4_(b_5);
    vec4 _e13 = bounded_vec4_(a_6);
    return ((t_3 <= 0.0) ? _e13 : ((t_3 >= 1.0) ? _e9 : mixed_color));
}

vec4 mixed_in_oklab(vec4 a_7, vec4 b_6, float t_4) {
    vec3 _e4 = oklab_of_srgb(a_7.xyz);
    vec3 _e6 = oklab_of_srgb(b_6.xyz);
    vec3 _e7 = mixed_vec3_(_e4, _e6, t_4);
    vec3 _e8 = srgb_of_oklab(_e7);
    vec4 _e9 = ends_kept(a_7, b_6, t_4, _e8);
    return _e9;
}

vec4 hermite(vec4 a_8, vec4 b_7, vec4 from_a, vec4 to_b, float t_5) {
    vec4 d_1 = (b_7 - a_8);
    return (a_8 + (t_5 * (from_a + (t_5 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_5 * ((from_a + to_b) - (2.0 * d_1))))))));
}

float harmonic_slope(float before, float span_before, float after, float span_after) {
    if (((before * after) <= 0.0)) {
        return 0.0;
    }
    float weight_before = ((2.0 * span_after) + span_before);
    float weight_after = (span_after + (2.0 * span_before));
    float _e18 = divided((weight_before + weight_after), ((weight_before / before) + (weight_after / after)));
    return _e18;
}

vec4 ramp_slope(vec4 rise_before, float span_before_1, vec4 rise_after, float span_after_1) {
    float _e5 = divided(rise_before.x, span_before_1);
    float _e7 = divided(rise_after.x, span_after_1);
    float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    float _e10 = divided(rise_before.y, span_before_1);
    float _e12 = divided(rise_after.y, span_after_1);
    float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    float _e15 = divided(rise_before.z, span_before_1);
    float _e17 = divided(rise_after.z, span_after_1);
    float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    float _e20 = divided(rise_before.w, span_before_1);
    float _e22 = divided(rise_after.w, span_after_1);
    float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return vec4(_e8, _e13, _e18, _e23);
}

vec4 ramp_at(Ramp ramp, float x_14, float w_1) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 color = vec4(0.0);
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_2 = false;
    vec4 from_a_1 = vec4(0.0);
    vec4 to_b_1 = vec4(0.0);
    uint count = min(ramp.count, 16u);
    if ((count == 0u)) {
        return vec4(0.0);
    }
    colors = ramp.colors;
    places = ramp.places;
    if ((ramp.interpolation == INTERPOLATION_STEPPED)) {
        vec4 _e18 = colors[0];
        color = _e18;
        bool loop_init = true;
        while(true) {
            if (!loop_init) {
                uint _e47 = i;
                i = (_e47 + 1u);
            }
            loop_init = false;
            uint _e22 = i;
            if ((_e22 < count)) {
            } else {
                break;
            }
            {
                vec4 _e24 = color;
                uint _e25 = i;
                vec4 _e27 = colors[_e25];
                uint _e28 = i;
                vec4 _e32 = colors[(_e28 - 1u)];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places[(_e34 / 4u)][(_e38 % 4u)];
                float _e43 = step_filtered(x_14, _e42, w_1);
                color = (_e24 + ((_e27 - _e32) * _e43));
            }
        }
        vec4 _e49 = color;
        vec4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e71 = i_1;
            i_1 = (_e71 + 1u);
        }
        loop_init_1 = false;
        uint _e55 = i_1;
        if ((_e55 < count)) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places[(_e59 / 4u)][(_e63 % 4u)];
            at = ((_e67 <= x_14) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place = places[(_e73 / 4u)][(_e77 % 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_2 = (x_14 <= place);
    } else {
        local_2 = true;
    }
    bool _e91 = local_2;
    if (_e91) {
        uint _e92 = at;
        vec4 _e94 = colors[_e92];
        vec4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = (_e96 + 1u);
    float _e105 = places[(after_1 / 4u)][(after_1 % 4u)];
    float span_1 = (_e105 - place);
    float _e108 = divided((x_14 - place), span_1);
    float t_8 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        vec4 _e117 = colors[_e115];
        vec4 _e119 = colors[after_1];
        vec4 _e120 = mixed_vec4_(_e117, _e119, t_8);
        return _e120;
    }
    uint _e127 = at;
    if ((_e127 > 0u)) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places[((_e130 - 1u) / 4u)][((_e136 - 1u) % 4u)];
        uint _e143 = at;
        vec4 _e145 = colors[_e143];
        uint _e146 = at;
        vec4 _e150 = colors[(_e146 - 1u)];
        vec4 _e154 = colors[after_1];
        uint _e155 = at;
        vec4 _e157 = colors[_e155];
        vec4 _e159 = ramp_slope((_e145 - _e150), (place - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count)) {
        float _e173 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e173 - (place + span_1));
        vec4 _e177 = colors[after_1];
        uint _e178 = at;
        vec4 _e180 = colors[_e178];
        vec4 _e185 = colors[(after_1 + 1u)];
        vec4 _e187 = colors[after_1];
        vec4 _e189 = ramp_slope((_e177 - _e180), span_1, (_e185 - _e187), next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    vec4 _e192 = colors[_e190];
    vec4 _e194 = colors[after_1];
    vec4 _e195 = from_a_1;
    vec4 _e197 = to_b_1;
    vec4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_8);
    vec4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

RampPlace ramp_place(Ramp ramp_1, float x_15) {
    vec4 colors_1[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places_1[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint at_1 = 0u;
    uint i_2 = 1u;
    uint count_1 = min(ramp_1.count, 16u);
    if ((count_1 == 0u)) {
        return RampPlace(vec4(0.0), vec4(0.0), 0.0);
    }
    colors_1 = ramp_1.colors;
    places_1 = ramp_1.places;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e37 = i_2;
            i_2 = (_e37 + 1u);
        }
        loop_init_2 = false;
        uint _e21 = i_2;
        if ((_e21 < count_1)) {
        } else {
            break;
        }
        {
            uint _e23 = at_1;
            uint _e24 = i_2;
            uint _e25 = i_2;
            uint _e29 = i_2;
            float _e33 = places_1[(_e25 / 4u)][(_e29 % 4u)];
            at_1 = ((_e33 <= x_15) ? _e24 : _e23);
        }
    }
    uint _e39 = at_1;
    uint after_2 = min((_e39 + 1u), (count_1 - 1u));
    uint _e45 = at_1;
    uint _e49 = at_1;
    float place_1 = places_1[(_e45 / 4u)][(_e49 % 4u)];
    float _e61 = places_1[(after_2 / 4u)][(after_2 % 4u)];
    float _e63 = divided((x_15 - place_1), (_e61 - place_1));
    float t_9 = clamp(_e63, 0.0, 1.0);
    uint _e67 = at_1;
    vec4 _e69 = colors_1[_e67];
    vec4 _e71 = colors_1[after_2];
    float _e74 = eased(t_9, 0.0, 1.0);
    return RampPlace(_e69, _e71, ((ramp_1.interpolation == INTERPOLATION_SMOOTH) ? _e74 : t_9));
}

vec4 premultiplied(vec4 color_1) {
    return vec4((color_1.xyz * color_1.w), color_1.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 mix_colors_screen(vec4 a_9, vec4 b_8, float factor_1) {
    vec4 _e10 = color_mixed(a_9, ((a_9.xyz + b_8.xyz) - (a_9.xyz * b_8.xyz)), factor_1);
    return _e10;
}

vec4 mix_colors_soft_light(vec4 a_10, vec4 b_9, float factor_2) {
    float _e5 = soft_light(a_10.x, b_9.x);
    float _e8 = soft_light(a_10.y, b_9.y);
    float _e11 = soft_light(a_10.z, b_9.z);
    vec4 _e13 = color_mixed(a_10, vec3(_e5, _e8, _e11), factor_2);
    return _e13;
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_12 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_2 = min(abs(a_12), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_12 * a_12);
        return (a_12 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude_2));
    float t_10 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_12 >= 0.0) ? t_10 : -(t_10));
}

vec3 tensor_safe(vec3 tensor) {
    float _e2 = kappa_safe(tensor.x);
    float _e4 = kappa_safe(tensor.y);
    float _e6 = kappa_safe(tensor.z);
    return vec3(_e2, _e4, _e6);
}

vec2 principal_curvatures(vec3 tensor_1) {
    float mean = (0.5 * (tensor_1.x + tensor_1.z));
    float spread = length(vec2((0.5 * (tensor_1.x - tensor_1.z)), tensor_1.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    float _e26 = divided(((tensor_1.x * tensor_1.z) - (tensor_1.y * tensor_1.y)), far);
    return ((mean >= 0.0) ? vec2(far, _e26) : vec2(_e26, far));
}

vec4 output_(vec4 color_2) {
    vec4 _e1 = straight(color_2);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec4 ramp_oklab(float value, Ramp ramp_2) {
    float _e2 = footprint_of(value);
    if ((ramp_2.interpolation == INTERPOLATION_STEPPED)) {
        float _e6 = bounded(value);
        vec4 _e7 = ramp_at(ramp_2, _e6, _e2);
        return _e7;
    }
    float _e8 = bounded(value);
    RampPlace _e9 = ramp_place(ramp_2, _e8);
    vec4 _e13 = mixed_in_oklab(_e9.before, _e9.after, _e9.t);
    return _e13;
}

float reflectance_half_lambert(Light light_1, vec3 normal) {
    vec3 _e6 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    float half_ = (0.5 + (0.5 * dot(_e6, light_1.direction)));
    return clamp((half_ * half_), 0.0, 1.0);
}

float rim(Light light_2, vec3 normal_1, vec3 view, float width, float softness, float follow) {
    vec3 _e10 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    float facing = clamp(dot(_e10, view), 0.0, 1.0);
    float _e16 = factor_of(width, true);
    float _e18 = factor_of(softness, true);
    float _e20 = footprint_of(facing);
    float edge_1 = max((_e16 * _e18), min(_e20, 1.0));
    vec3 aside = (_e10 - view);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing));
    float within = ((further / max(edge_1, 1e-6)) + ((softness > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    vec3 across = (light_2.direction - (dot(light_2.direction, view) * view));
    vec3 _e61 = normalize_or(across, vec3(0.0));
    float side = dot((_e10 - (dot(_e10, view) * view)), _e61);
    float _e66 = eased(side, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float radiance_scaled(float tone, float curved, float turning) {
    float _e3 = exponential_of(curved);
    float dark = (turning * (1.0 - tone));
    float light_3 = (tone * (1.0 - turning));
    return ((tone * ((_e3 * dark) + light_3)) / max((dark + (_e3 * light_3)), 1e-20));
}

float radiance_scaling(float tone_1, float kappa_2, float amount, float slope_1, float turning_1) {
    float _e5 = bounded(amount);
    float _e9 = curvature_signed(kappa_2, slope_1);
    float curved_2 = (clamp(_e5, -16.0, 16.0) * _e9);
    float _e11 = bounded(turning_1);
    float at_2 = clamp(_e11, 0.001, 0.999);
    float _e15 = bounded(tone_1);
    float before_2 = clamp(_e15, 0.0, 1.0);
    float _e19 = radiance_scaled(before_2, curved_2, at_2);
    return clamp(((curved_2 == 0.0) ? before_2 : _e19), 0.0, 1.0);
}

Relief relief(vec3 tensor_2, float slope_2) {
    vec3 _e2 = tensor_safe(tensor_2);
    vec2 _e3 = principal_curvatures(_e2);
    float _e10 = angle_of_point((_e3.x + _e3.y), (_e3.x - _e3.y));
    float curvedness = sqrt((0.5 * dot(_e3, _e3)));
    float _e15 = bounded(slope_2);
    float _e18 = curvature_signed(curvedness, max(_e15, 0.0));
    return Relief((0.5 + (_e10 / PI)), _e18, _e3.x, _e3.y);
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    float _e5 = reflectance_half_lambert(_e3, surface_1.normal);
    float _e10 = radiance_scaling(_e5, surface_1.kappa, 1.3, 0.03, 0.9);
    vec4 _e12 = ramp_oklab(_e10, terracotta);
    Relief _e15 = relief(surface_1.curvature_tensor, 0.025);
    vec4 _e18 = ramp_oklab(_e15.shape, pits_to_bumps);
    vec4 _e20 = mix_colors_soft_light(_e12, _e18, _e15.strength);
    Light _e23 = u_look.sky;
    float _e29 = rim(_e23, surface_1.normal, surface_1.view, 0.4, 0.9, 1.0);
    vec4 _e35 = mix_colors_screen(_e20, vec4(0.3725, 0.498, 0.6588, 1.0), _e29);
    vec4 _e36 = premultiplied(_e35);
    vec4 _e37 = output_(_e36);
    return _e37;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), 0.0, vec3(0.0));
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
    vec4 _e48 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    surface.curvature_tensor = _e48.xyz;
    Surface _e50 = surface;
    vec4 _e51 = shade(_e50);
    vec4 _e52 = finite_vec4_(_e51);
    out_color = _e52;
    return;
}

