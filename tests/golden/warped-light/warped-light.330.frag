#version 330 core
// Warped light: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// warped-light.json says what to put there and how to draw.
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
    Light back;
    Light key;
    mat3x3 camera_from_world;
};
struct Surface {
    vec3 normal;
    vec3 view;
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
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint INTERPOLATION_SMOOTH = 1u;
const uint INTERPOLATION_STEPPED = 2u;
const Ramp jade = Ramp(vec4[16](vec4(0.0157, 0.1294, 0.1216, 1.0), vec4(0.0588, 0.3529, 0.298, 1.0), vec4(0.2471, 0.6275, 0.4784, 1.0), vec4(0.7137, 0.8784, 0.6902, 1.0), vec4(0.9333, 0.9725, 0.8471, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.35, 0.65, 0.9), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

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

float bounded(float x_4) {
    uint bits_1 = floatBitsToUint(x_4);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_4 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
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

float place_between(float x_5, float low, float high) {
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_5 >= high) ? 1.0 : 0.0);
    }
    float _e12 = bounded(span);
    float _e14 = bounded(((x_5 - low) / _e12));
    return _e14;
}

float eased(float x_6, float low_1, float high_1) {
    float _e3 = bounded(x_6);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_6 = clamp(_e6, 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
}

float factor_of(float x_7, bool clamped) {
    float _e2 = bounded(x_7);
    float _e3 = bounded(x_7);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_8) {
    float _e1 = dFdx(x_8);
    float _e2 = dFdy(x_8);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float step_filtered(float x_9, float edge, float w) {
    float _e4 = bounded((x_9 - edge));
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

vec4 color_mixed(vec4 a_4, vec3 blended, float factor) {
    vec3 _e4 = bounded_vec3_(a_4.xyz);
    vec3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    vec3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_4.w);
    return vec4(_e8, _e10);
}

float cube_root(float x_10) {
    float _e3 = powered(abs(x_10), 0.33333334);
    return ((x_10 < 0.0) ? -(_e3) : _e3);
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

vec4 ends_kept(vec4 a_5, vec4 b_4, float t_3, vec3 rgb_1) {
    vec3 _e4 = bounded_vec3_(rgb_1);
    float _e7 = mixed(a_5.w, b_4.w, t_3);
    vec4 mixed_color = vec4(_e4, _e7);
    vec4 _e9 = bounded_vec4_(b_4);
    vec4 _e13 = bounded_vec4_(a_5);
    return ((t_3 <= 0.0) ? _e13 : ((t_3 >= 1.0) ? _e9 : mixed_color));
}

vec4 mixed_in_oklab(vec4 a_6, vec4 b_5, float t_4) {
    vec3 _e4 = oklab_of_srgb(a_6.xyz);
    vec3 _e6 = oklab_of_srgb(b_5.xyz);
    vec3 _e7 = mixed_vec3_(_e4, _e6, t_4);
    vec3 _e8 = srgb_of_oklab(_e7);
    vec4 _e9 = ends_kept(a_6, b_5, t_4, _e8);
    return _e9;
}

vec4 hermite(vec4 a_7, vec4 b_6, vec4 from_a, vec4 to_b, float t_5) {
    vec4 d_1 = (b_6 - a_7);
    return (a_7 + (t_5 * (from_a + (t_5 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_5 * ((from_a + to_b) - (2.0 * d_1))))))));
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

vec4 ramp_at(Ramp ramp, float x_11, float w_1) {
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
                float _e43 = step_filtered(x_11, _e42, w_1);
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
            at = ((_e67 <= x_11) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_1 = places[(_e73 / 4u)][(_e77 % 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_2 = (x_11 <= place_1);
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
    float span_1 = (_e105 - place_1);
    float _e108 = divided((x_11 - place_1), span_1);
    float t_7 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        vec4 _e117 = colors[_e115];
        vec4 _e119 = colors[after_1];
        vec4 _e120 = mixed_vec4_(_e117, _e119, t_7);
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
        vec4 _e159 = ramp_slope((_e145 - _e150), (place_1 - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count)) {
        float _e173 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e173 - (place_1 + span_1));
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
    vec4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_7);
    vec4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

RampPlace ramp_place(Ramp ramp_1, float x_12) {
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
            at_1 = ((_e33 <= x_12) ? _e24 : _e23);
        }
    }
    uint _e39 = at_1;
    uint after_2 = min((_e39 + 1u), (count_1 - 1u));
    uint _e45 = at_1;
    uint _e49 = at_1;
    float place_2 = places_1[(_e45 / 4u)][(_e49 % 4u)];
    float _e61 = places_1[(after_2 / 4u)][(after_2 % 4u)];
    float _e63 = divided((x_12 - place_2), (_e61 - place_2));
    float t_8 = clamp(_e63, 0.0, 1.0);
    uint _e67 = at_1;
    vec4 _e69 = colors_1[_e67];
    vec4 _e71 = colors_1[after_2];
    float _e74 = eased(t_8, 0.0, 1.0);
    return RampPlace(_e69, _e71, ((ramp_1.interpolation == INTERPOLATION_SMOOTH) ? _e74 : t_8));
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

vec4 mix_colors_screen(vec4 a_8, vec4 b_7, float factor_1) {
    vec4 _e10 = color_mixed(a_8, ((a_8.xyz + b_7.xyz) - (a_8.xyz * b_7.xyz)), factor_1);
    return _e10;
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_10 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_2 = min(abs(a_10), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_10 * a_10);
        return (a_10 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude_2));
    float t_9 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_10 >= 0.0) ? t_9 : -(t_9));
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

vec3 half_of(vec3 light_1, vec3 normal, vec3 view) {
    vec3 half_ = (light_1 + view);
    vec3 _e8 = normalize_or(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(vec3 a_9, vec3 b_8) {
    vec3 across = cross(a_9, b_8);
    return min(dot(across, across), 1.0);
}

Reflection reflection_of(vec3 light_2, vec3 normal_1, vec3 view_1) {
    vec3 _e3 = half_of(light_2, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection(dot(normal_1, light_2), dot(normal_1, view_1), n_h, v_h, _e14);
}

float width_of_roughness(float roughness) {
    float _e1 = bounded(roughness);
    float r_1 = clamp(_e1, 0.0, 1.0);
    return max((r_1 * r_1), 0.001);
}

float schlick(float at_normal, float cosine) {
    float m_1 = clamp((1.0 - cosine), 0.0, 1.0);
    float m2_ = (m_1 * m_1);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m_1)));
}

float ggx(Reflection r, float width, float at_normal_1) {
    bool local_3 = false;
    if (!((r.n_l <= 0.0))) {
        local_3 = (r.n_v <= 0.0);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return 0.0;
    }
    float a2_1 = (width * width);
    float bottom = max((r.sine2_ + ((a2_1 * r.n_h) * r.n_h)), 1e-12);
    float distribution = (a2_1 / (bottom * bottom));
    float toward_light = (r.n_v * sqrt((((r.n_l * r.n_l) * (1.0 - a2_1)) + a2_1)));
    float toward_eye = (r.n_l * sqrt((((r.n_v * r.n_v) * (1.0 - a2_1)) + a2_1)));
    float visibility = (0.5 / max((toward_light + toward_eye), 1e-9));
    float _e53 = schlick(at_normal_1, r.v_h);
    return min((((distribution * visibility) * _e53) * r.n_l), 1000000.0);
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

float reflectance_wrap(Light light_3, vec3 normal_2, float wrap) {
    float _e3 = bounded(wrap);
    float w_2 = clamp(_e3, 0.0, 1.0);
    vec3 _e11 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    float cosine_1 = dot(_e11, light_3.direction);
    return max(((cosine_1 + w_2) / (1.0 + w_2)), 0.0);
}

float reflectance_ggx(Light light_4, vec3 normal_3, vec3 view_2, float roughness_1, float at_normal_2) {
    vec3 _e10 = normalize_or(normal_3, vec3(0.0, 0.0, 1.0));
    Reflection _e11 = reflection_of(light_4.direction, _e10, view_2);
    float _e12 = width_of_roughness(roughness_1);
    float _e13 = bounded(at_normal_2);
    float _e17 = ggx(_e11, _e12, clamp(_e13, 0.0, 1.0));
    return _e17;
}

float rim(Light light_5, vec3 normal_4, vec3 view_3, float width_1, float softness, float follow) {
    vec3 _e10 = normalize_or(normal_4, vec3(0.0, 0.0, 1.0));
    float facing_1 = clamp(dot(_e10, view_3), 0.0, 1.0);
    float _e16 = factor_of(width_1, true);
    float _e18 = factor_of(softness, true);
    float _e20 = footprint_of(facing_1);
    float edge_1 = max((_e16 * _e18), min(_e20, 1.0));
    vec3 aside = (_e10 - view_3);
    float further = ((facing_1 > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing_1));
    float within = ((further / max(edge_1, 1e-6)) + ((softness > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    vec3 across_1 = (light_5.direction - (dot(light_5.direction, view_3) * view_3));
    vec3 _e61 = normalize_or(across_1, vec3(0.0));
    float side = dot((_e10 - (dot(_e10, view_3) * view_3)), _e61);
    float _e66 = eased(side, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

vec2 warped_place(vec3 tensor_2, vec2 place, float amount, float slope_1) {
    vec2 _e4 = principal_curvatures(tensor_2);
    float _e7 = curvature_signed(_e4.x, slope_1);
    float _e9 = exp2_stable((-(amount) * _e7));
    float _e12 = curvature_signed(_e4.y, slope_1);
    float _e14 = exp2_stable((-(amount) * _e12));
    vec2 half_apart = vec2((0.5 * (tensor_2.x - tensor_2.z)), tensor_2.y);
    vec2 axes = (half_apart / vec2(max(length(half_apart), 1e-20)));
    vec2 turned = vec2(((axes.x * place.x) + (axes.y * place.y)), ((axes.y * place.x) - (axes.x * place.y)));
    return (((0.5 * (_e9 + _e14)) * place) + ((0.5 * (_e9 - _e14)) * turned));
}

vec3 warped_light(vec3 light_6, vec3 n_1, vec3 view_4, mat3x3 camera_from_world, vec3 tensor_3, float amount_1, float slope_2) {
    vec3 right = (vec3(1.0, 0.0, 0.0) * camera_from_world);
    vec3 _e19 = normalize_or((right - (dot(right, view_4) * view_4)), vec3(1.0, 0.0, 0.0));
    vec3 y = cross(view_4, _e19);
    vec3 between = ((view_4 + n_1) / vec3(max((1.0 + dot(view_4, n_1)), 0.01)));
    vec3 along_x = (_e19 - (dot(n_1, _e19) * between));
    vec3 along_y = (y - (dot(n_1, y) * between));
    vec2 place_3 = (vec2(dot(light_6, along_x), dot(light_6, along_y)) / vec2(max((1.0 + dot(light_6, n_1)), 0.0001)));
    vec2 _e45 = warped_place(tensor_3, place_3, amount_1, slope_2);
    float square_1 = dot(_e45, _e45);
    vec3 _e60 = normalize_or(((((2.0 * _e45.x) * along_x) + ((2.0 * _e45.y) * along_y)) + ((1.0 - square_1) * n_1)), light_6);
    return _e60;
}

float seen_well(float facing) {
    float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

Light light_warp(Light light_7, vec3 normal_5, float amount_2, float slope_3, vec3 tensor_4, vec3 view_5, mat3x3 camera_from_world_1) {
    bool local_4 = false;
    vec3 _e7 = normalize_or(normal_5, view_5);
    float _e8 = bounded(amount_2);
    float _e13 = seen_well(dot(_e7, view_5));
    float most = (clamp(_e8, -8.0, 8.0) * _e13);
    vec3 _e16 = tensor_safe(tensor_4);
    vec3 _e17 = warped_light(light_7.direction, _e7, view_5, camera_from_world_1, _e16, most, slope_3);
    if (!((most == 0.0))) {
        local_4 = (slope_3 == 0.0);
    } else {
        local_4 = true;
    }
    bool is_flat = local_4;
    return Light((is_flat ? light_7.direction : _e17), light_7.own_direction, light_7.color, light_7.intensity);
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    mat3x3 _e11 = u_look.camera_from_world;
    Light _e12 = light_warp(_e3, surface_1.normal, 1.4, 0.03, surface_1.curvature_tensor, surface_1.view, _e11);
    float _e15 = reflectance_wrap(_e12, surface_1.normal, 0.6);
    vec4 _e17 = ramp_oklab(_e15, jade);
    float _e22 = reflectance_ggx(_e12, surface_1.normal, surface_1.view, 0.42, 0.09);
    vec4 _e28 = mix_colors_screen(_e17, vec4(1.0, 0.9569, 0.8627, 1.0), _e22);
    Light _e31 = u_look.back;
    float _e37 = rim(_e31, surface_1.normal, surface_1.view, 0.5, 0.8, 1.0);
    vec4 _e43 = mix_colors_screen(_e28, vec4(0.1843, 0.5608, 0.7216, 1.0), _e37);
    vec4 _e44 = premultiplied(_e43);
    vec4 _e45 = output_(_e44);
    return _e45;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_6 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_6;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    vec4 _e40 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    surface.curvature_tensor = _e40.xyz;
    Surface _e42 = surface;
    vec4 _e43 = shade(_e42);
    vec4 _e44 = finite_vec4_(_e43);
    out_color = _e44;
    return;
}

