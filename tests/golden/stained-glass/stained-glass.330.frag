#version 330 core
// Stained glass: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// stained-glass.json says what to put there and how to draw.
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
    Light room;
    Light sun;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position;
    vec3 position_object;
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
struct Cell {
    float border;
    float random;
    float distance_;
};
struct Cells {
    float border;
    float random;
    float distance_;
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
const uint INTERPOLATION_SMOOTH = 1u;
const uint INTERPOLATION_STEPPED = 2u;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const uint NOISE_PERLIN = 1u;
const uint NOISE_SIMPLEX = 2u;
const uint NOISE_WORLEY = 3u;
const float SIMPLEX_SCALE = 38.4553;
const float WORLEY_MEAN = 0.5205;
const float CELL_REACH = 1.25;
const float CELL_BORDER_MEAN = 0.1301;
const float CELL_DISTANCE_MEAN = 0.491;
const Ramp colors_1 = Ramp(vec4[16](vec4(0.0706, 0.1882, 0.4784, 1.0), vec4(0.1216, 0.4784, 0.6902, 1.0), vec4(0.1137, 0.5412, 0.3529, 1.0), vec4(0.9098, 0.6902, 0.1255, 1.0), vec4(0.8471, 0.3255, 0.1098, 1.0), vec4(0.6902, 0.0706, 0.2196, 1.0), vec4(0.3529, 0.102, 0.4784, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.22, 0.4, 0.58), vec4(0.75, 0.9, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 2u);
const ProfileShape through_the_glass_shape = ProfileShape(0.9950042, 0.099833414, 1.1883951, 1.4967098, 0.2, 1.0679889, 0.45520553, 0u);
const ProfileShape on_the_glass_shape = ProfileShape(0.99875027, 0.04997917, 1.2766062, 1.3888036, 0.1, 1.0089166, 0.41697913, 0u);
const ProfileShape gleam_tone_shape = ProfileShape(0.99820054, 0.059964005, 11.126125, 3.022525, 0.12, 0.08196669, 0.036355104, 0u);
const ProfileShape edge_of_the_lead_tone_shape = ProfileShape(0.9887711, 0.14943813, 3.3838634, 2.4220939, 0.3, 0.29531473, 0.1274162, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

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
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
    float p_7 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p_7 * _e33) * _e37);
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
    float p_8 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_8 * p_8) + (s_1 * s_1)), 1e-30)));
    return Angle((p_8 * k), (s_1 * k));
}

float atan2_positive(float y_1, float x_5) {
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_6 = (small / large);
    bool is_wide = (t_6 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_6);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_5 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_5) : a_5);
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

float mixed(float a_1, float b_1, float t_1) {
    float _e4 = bounded((b_1 - a_1));
    float _e14 = bounded(((t_1 < 0.5) ? (a_1 + (t_1 * _e4)) : (b_1 - ((1.0 - t_1) * _e4))));
    return _e14;
}

vec3 mixed_vec3_(vec3 a_2, vec3 b_2, float t_2) {
    float _e5 = mixed(a_2.x, b_2.x, t_2);
    float _e8 = mixed(a_2.y, b_2.y, t_2);
    float _e11 = mixed(a_2.z, b_2.z, t_2);
    return vec3(_e5, _e8, _e11);
}

vec4 mixed_vec4_(vec4 a_3, vec4 b_3, float t_3) {
    vec3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_3);
    float _e8 = mixed(a_3.w, b_3.w, t_3);
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

float length_of(vec3 v_5) {
    vec3 _e1 = bounded_vec3_(v_5);
    float largest_2 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e17 = bounded((largest_2 * length((_e1 / vec3(largest_2)))));
    return _e17;
}

float footprint_of(float x_9) {
    float _e1 = dFdx(x_9);
    float _e2 = dFdy(x_9);
    vec2 d_3 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_3, d_3)));
    return _e6;
}

float footprint_of_vec3_(vec3 v_6) {
    vec3 dx_1 = dFdx(v_6);
    vec3 dy_1 = dFdy(v_6);
    float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
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

vec4 hermite(vec4 a_4, vec4 b_4, vec4 from_a, vec4 to_b, float t_4) {
    vec4 d_4 = (b_4 - a_4);
    return (a_4 + (t_4 * (from_a + (t_4 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_4 * ((from_a + to_b) - (2.0 * d_4))))))));
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

vec4 ramp_at(Ramp ramp, float x_11, float w_2) {
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
                float _e43 = step_filtered(x_11, _e42, w_2);
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
    float place = places[(_e73 / 4u)][(_e77 % 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_2 = (x_11 <= place);
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
    float _e108 = divided((x_11 - place), span_1);
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

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec3 bumped_normal(vec4 along_x, vec4 along_y, vec3 normal) {
    bool local_3 = false;
    vec3 _e7 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    vec4 _e8 = bounded_vec4_(along_x);
    vec4 _e9 = bounded_vec4_(along_y);
    float _e11 = length_of(_e8.xyz);
    float _e13 = length_of(_e9.xyz);
    float largest_3 = max(_e11, _e13);
    if (!((largest_3 < 1e-18))) {
        local_3 = (largest_3 > 1e18);
    } else {
        local_3 = true;
    }
    bool _e23 = local_3;
    if (_e23) {
        return _e7;
    }
    vec3 s_3 = (_e8.xyz / vec3(largest_3));
    vec3 t_9 = (_e9.xyz / vec3(largest_3));
    vec2 rise = clamp((vec2(_e8.w, _e9.w) / vec2(largest_3)), vec2(-1000000.0), vec2(1000000.0));
    vec3 right = cross(t_9, _e7);
    vec3 up = cross(_e7, s_3);
    float area = dot(s_3, right);
    if ((abs(area) < 1e-6)) {
        return _e7;
    }
    vec3 slope = (((rise.x * right) + (rise.y * up)) / vec3(area));
    float steepness = length(slope);
    vec3 limited = (slope * (min(steepness, 10.0) / max(steepness, 1e-20)));
    vec3 _e61 = normalize_or((_e7 - limited), _e7);
    return _e61;
}

vec3 bump_map(float height, float scale, vec3 normal_1, vec3 position) {
    float _e5 = bounded((height * scale));
    vec3 _e6 = dFdx(position);
    float _e7 = dFdx(_e5);
    vec4 along_x_1 = vec4(_e6, _e7);
    vec3 _e9 = dFdy(position);
    float _e10 = dFdy(_e5);
    vec4 along_y_1 = vec4(_e9, _e10);
    vec3 _e12 = bumped_normal(along_x_1, along_y_1, normal_1);
    vec3 _e13 = bounded_vec3_(normal_1);
    return ((scale == 0.0) ? _e13 : _e12);
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed_1 = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped ? clamp(mixed_1, vec4(0.0), vec4(1.0)) : mixed_1);
}

vec4 blend_add(vec4 below_1, vec4 color_1, float tone, float opacity_1, bool clamped_1) {
    vec4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color_1.xyz)), below_1.w, (opacity_1 * color_1.w), clamped_1);
    return _e12;
}

vec4 blend_alpha(vec4 below_2, vec4 color_2, float tone_1, float opacity_2, bool clamped_2) {
    float a_6 = (opacity_2 * color_2.w);
    float alpha_1 = (below_2.w + ((tone_1 * a_6) * (1.0 - below_2.w)));
    vec4 _e20 = blend_finish(below_2, (below_2.xyz + (tone_1 * (color_2.xyz - below_2.xyz))), alpha_1, a_6, clamped_2);
    return _e20;
}

vec4 output_(vec4 color_3) {
    vec4 _e1 = straight(color_3);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color_4, float tone_2) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color_4.xyz * light.color) * _e4.y), color_4.w), (tone_2 * _e4.x));
}

Angle parametrization_diffuse(Light light_1, vec3 normal_2) {
    vec3 _e6 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light_1.direction);
    return _e8;
}

Angle parametrization_specular(Light light_2, vec3 normal_3, vec3 view) {
    vec3 _e7 = normalize_or(normal_3, vec3(0.0, 0.0, 1.0));
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

float profile_filtered(Angle u_5, float w_3, ProfileShape shape_1) {
    bool local_5 = false;
    bool local_6 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_3 <= 0.0))) {
        local_5 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_5 = true;
    }
    bool _e13 = local_5;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_6 = (w_3 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_6 = false;
    }
    bool _e24 = local_6;
    if (_e24) {
        float width = sqrt(((w_3 * w_3) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w_3 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    vec2 _e50 = sin_cos_quarter((0.19364917 * w_3));
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

vec4 ramp_plain(float value, Ramp ramp_1) {
    float _e2 = footprint_of(value);
    float _e3 = bounded(value);
    vec4 _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
}

float threshold(float value_1, float edge_1, float softness_1) {
    float _e3 = footprint_of(value_1);
    float _e4 = bounded(value_1);
    float _e5 = bounded(edge_1);
    float _e6 = edge_width(_e3, softness_1);
    float _e7 = step_filtered(_e4, _e5, _e6);
    return _e7;
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_7 = uvec3(0u);
    v_7 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_7.x;
    uint _e10 = v_7.y;
    uint _e12 = v_7.z;
    v_7.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_7.y;
    uint _e18 = v_7.z;
    uint _e20 = v_7.x;
    v_7.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_7.z;
    uint _e26 = v_7.x;
    uint _e28 = v_7.y;
    v_7.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_7;
    uvec3 _e32 = v_7;
    v_7 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_7.x;
    uint _e40 = v_7.y;
    uint _e42 = v_7.z;
    v_7.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_7.y;
    uint _e48 = v_7.z;
    uint _e50 = v_7.x;
    v_7.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_7.z;
    uint _e56 = v_7.x;
    uint _e58 = v_7.y;
    v_7.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_7;
    return _e61;
}

vec3 unit_of_hash(uvec3 hash) {
    return (vec3((hash >> uvec3(8u))) * 5.9604645e-8);
}

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash_1, vec3 d_1) {
    uint axis = ((hash_1.x >> 8u) % 3u);
    float a_7 = ((axis == 0u) ? d_1.y : d_1.x);
    float b_5 = ((axis == 2u) ? d_1.y : d_1.z);
    return ((((hash_1.y >> 31u) == 0u) ? a_7 : -(a_7)) + (((hash_1.z >> 31u) == 0u) ? b_5 : -(b_5)));
}

vec3 fade_quintic(vec3 t_5) {
    return (((t_5 * t_5) * t_5) * ((t_5 * ((t_5 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float value_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i_2 = 0;
    vec3 corner = floor(p);
    vec3 _e4 = fade_quintic((p - corner));
    ivec3 cell_1 = ivec3(corner);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e45 = i_2;
            i_2 = (_e45 + 1);
        }
        loop_init_2 = false;
        int _e10 = i_2;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i_2;
            int _e16 = i_2;
            int _e21 = i_2;
            ivec3 at_1 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at_1, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at_1), seed_2);
            vec3 _e40 = unit_of_hash(_e39);
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e40.x));
        }
    }
    float _e47 = sum;
    return _e47;
}

float perlin_noise(vec3 p_1, uint seed_3) {
    float sum_1 = 0.0;
    int i_3 = 0;
    vec3 corner_1 = floor(p_1);
    vec3 d_5 = (p_1 - corner_1);
    vec3 _e4 = fade_quintic(d_5);
    ivec3 cell_2 = ivec3(corner_1);
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            int _e46 = i_3;
            i_3 = (_e46 + 1);
        }
        loop_init_3 = false;
        int _e10 = i_3;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i_3;
            int _e16 = i_3;
            int _e21 = i_3;
            ivec3 at_2 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight_1 = mix((vec3(1.0) - _e4), _e4, equal(at_2, ivec3(1)));
            float _e32 = sum_1;
            uvec3 _e39 = lattice_hash((cell_2 + at_2), seed_3);
            float _e42 = gradient_dot(_e39, (d_5 - vec3(at_2)));
            sum_1 = (_e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42));
        }
    }
    float _e48 = sum_1;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float simplex_corner(vec3 d_2, uvec3 hash_2) {
    float t_10 = max((0.5 - dot(d_2, d_2)), 0.0);
    float _e10 = gradient_dot(hash_2, d_2);
    return ((((t_10 * t_10) * t_10) * t_10) * _e10);
}

float simplex_noise(vec3 p_2, uint seed_4) {
    float sum_2 = 0.0;
    vec3 corner_2 = floor((p_2 + vec3((((p_2.x + p_2.y) + p_2.z) / 3.0))));
    vec3 d_6 = ((p_2 - corner_2) + vec3((((corner_2.x + corner_2.y) + corner_2.z) / 6.0)));
    bvec3 is_first = bvec3((d_6.x >= d_6.y), (d_6.y >= d_6.z), (d_6.z > d_6.x));
    vec3 g = mix(vec3(0.0), vec3(1.0), is_first);
    vec3 l_1 = (vec3(1.0) - g);
    vec3 second = min(g, l_1.zxy);
    vec3 third = max(g, l_1.zxy);
    ivec3 cell_3 = ivec3(corner_2);
    uvec3 _e45 = lattice_hash(cell_3, seed_4);
    float _e46 = simplex_corner(d_6, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    uvec3 _e55 = lattice_hash((cell_3 + ivec3(second)), seed_4);
    float _e56 = simplex_corner(((d_6 - second) + vec3(0.16666667)), _e55);
    sum_2 = (_e48 + _e56);
    float _e58 = sum_2;
    uvec3 _e65 = lattice_hash((cell_3 + ivec3(third)), seed_4);
    float _e66 = simplex_corner(((d_6 - third) + vec3(0.33333334)), _e65);
    sum_2 = (_e58 + _e66);
    float _e68 = sum_2;
    uvec3 _e75 = lattice_hash((cell_3 + ivec3(1)), seed_4);
    float _e76 = simplex_corner((d_6 - vec3(0.5)), _e75);
    sum_2 = (_e68 + _e76);
    float _e79 = sum_2;
    return clamp((0.5 + (SIMPLEX_SCALE * _e79)), 0.0, 1.0);
}

float worley_noise(vec3 p_3, uint seed_5) {
    float nearest = 1.0;
    int i_4 = 0;
    vec3 corner_3 = floor(p_3);
    vec3 d_7 = (p_3 - corner_3);
    ivec3 cell_4 = ivec3(corner_3);
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            int _e40 = i_4;
            i_4 = (_e40 + 1);
        }
        loop_init_4 = false;
        int _e9 = i_4;
        if ((_e9 < 27)) {
        } else {
            break;
        }
        {
            int _e12 = i_4;
            int _e17 = i_4;
            int _e24 = i_4;
            ivec3 at_3 = ivec3(((_e12 % 3) - 1), (((_e17 / 3) % 3) - 1), ((_e24 / 9) - 1));
            uvec3 _e32 = lattice_hash((cell_4 + at_3), seed_5);
            vec3 _e33 = unit_of_hash(_e32);
            vec3 offset = ((vec3(at_3) + _e33) - d_7);
            float _e36 = nearest;
            nearest = min(_e36, dot(offset, offset));
        }
    }
    float _e42 = nearest;
    return sqrt(_e42);
}

Cell nearest_cell(vec3 p_4, uint seed_6) {
    vec3 nearest_1 = vec3(4.0);
    uvec3 hash_3 = uvec3(0u);
    int i_5 = 0;
    float border = 0.0;
    int i_6 = 0;
    vec3 corner_4 = floor(p_4);
    vec3 d_8 = (p_4 - corner_4);
    ivec3 cell_5 = ivec3(corner_4);
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            int _e51 = i_5;
            i_5 = (_e51 + 1);
        }
        loop_init_5 = false;
        int _e13 = i_5;
        if ((_e13 < 27)) {
        } else {
            break;
        }
        {
            int _e16 = i_5;
            int _e21 = i_5;
            int _e28 = i_5;
            ivec3 at_4 = ivec3(((_e16 % 3) - 1), (((_e21 / 3) % 3) - 1), ((_e28 / 9) - 1));
            uvec3 _e35 = lattice_hash((cell_5 + at_4), seed_6);
            vec3 _e40 = unit_of_hash(_e35);
            vec3 offset_1 = (((vec3(at_4) + vec3(0.25)) + (0.5 * _e40)) - d_8);
            vec3 _e46 = nearest_1;
            vec3 _e47 = nearest_1;
            if ((dot(offset_1, offset_1) < dot(_e46, _e47))) {
                nearest_1 = offset_1;
                hash_3 = _e35;
            }
        }
    }
    vec3 _e53 = nearest_1;
    float distance_ = length(_e53);
    border = max((0.5 * (CELL_REACH - distance_)), 0.0);
    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            int _e110 = i_6;
            i_6 = (_e110 + 1);
        }
        loop_init_6 = false;
        int _e64 = i_6;
        if ((_e64 < 27)) {
        } else {
            break;
        }
        {
            int _e67 = i_6;
            int _e72 = i_6;
            int _e79 = i_6;
            ivec3 at_5 = ivec3(((_e67 % 3) - 1), (((_e72 / 3) % 3) - 1), ((_e79 / 9) - 1));
            uvec3 _e90 = lattice_hash((cell_5 + at_5), seed_6);
            vec3 _e91 = unit_of_hash(_e90);
            vec3 _e96 = nearest_1;
            vec3 apart = ((((vec3(at_5) + vec3(0.25)) + (0.5 * _e91)) - d_8) - _e96);
            float between = length(apart);
            if ((between > 0.25)) {
                float _e101 = border;
                vec3 _e102 = nearest_1;
                border = min(_e101, (dot((_e102 + (0.5 * apart)), apart) / between));
            }
        }
    }
    float _e112 = border;
    uvec3 _e115 = hash_3;
    uvec3 _e116 = hash_pcg3d(_e115);
    vec3 _e117 = unit_of_hash(_e116);
    return Cell(max(_e112, 0.0), _e117.x, distance_);
}

float noise_octave(uint kind, vec3 p_5, uint seed_7) {
    switch(kind) {
        case 1u: {
            float _e3 = perlin_noise(p_5, seed_7);
            return _e3;
        }
        case 2u: {
            float _e4 = simplex_noise(p_5, seed_7);
            return _e4;
        }
        case 3u: {
            float _e5 = worley_noise(p_5, seed_7);
            return _e5;
        }
        default: {
            float _e6 = value_noise(p_5, seed_7);
            return _e6;
        }
    }
}

float fractal_noise(uint kind_1, vec3 p_6, int octaves, float roughness, int seed_8, float w_4) {
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_7 = 0;
    float octave = 0.0;
    float mean = ((kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5);
    float _e11 = bounded(roughness);
    float gain = clamp(_e11, 0.0, 1.0);
    bool loop_init_7 = true;
    while(true) {
        if (!loop_init_7) {
            int _e75 = i_7;
            i_7 = (_e75 + 1);
        }
        loop_init_7 = false;
        int _e25 = i_7;
        if ((_e25 < min(max(octaves, 1), 8))) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            float _e34 = eased((w_4 * _e30), 0.5, 1.0);
            float visible = (1.0 - _e34);
            octave = mean;
            if ((visible > 0.0)) {
                float _e40 = frequency;
                int _e42 = i_7;
                vec3 place_1 = clamp(((p_6 * _e40) + (float(_e42) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
                int _e56 = i_7;
                float _e59 = noise_octave(kind_1, place_1, (uint(seed_8) + uint(_e56)));
                octave = mix(mean, _e59, visible);
            }
            float _e61 = sum_3;
            float _e62 = strength;
            float _e63 = octave;
            sum_3 = (_e61 + (_e62 * _e63));
            float _e66 = total;
            float _e67 = strength;
            total = (_e66 + _e67);
            float _e69 = strength;
            strength = (_e69 * gain);
            float _e71 = frequency;
            frequency = (_e71 * 2.0);
        }
    }
    float _e77 = sum_3;
    float _e78 = total;
    return clamp((_e77 / _e78), 0.0, 1.0);
}

float invert(float value_2) {
    float _e3 = bounded((1.0 - value_2));
    return _e3;
}

Cells cells(vec3 position_1, float scale_1, int seed_9) {
    vec3 _e4 = bounded_vec3_((position_1 * scale_1));
    vec3 p_9 = clamp(_e4, vec3(-4194304.0), vec3(4194304.0));
    Cell _e11 = nearest_cell(p_9, uint(seed_9));
    float _e12 = footprint_of_vec3_(p_9);
    float _e15 = eased(_e12, 0.5, 1.0);
    float visible_1 = (1.0 - _e15);
    vec3 average = vec3(0.1301, 0.5, 0.491);
    vec3 seen = mix(average, vec3(_e11.border, _e11.random, _e11.distance_), visible_1);
    return Cells(seen.x, seen.y, seen.z);
}

float noise_perlin(vec3 position_2, float scale_2, int octaves_1, float roughness_1, int seed_10) {
    vec3 _e6 = bounded_vec3_((position_2 * scale_2));
    float _e8 = footprint_of_vec3_(_e6);
    float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_1, seed_10, _e8);
    return _e9;
}

vec4 shade(Surface surface_1) {
    Cells _e4 = cells(surface_1.position_object, 3.4, 4);
    vec4 _e7 = ramp_plain(_e4.random, colors_1);
    vec4 _e16 = blend_add(vec4(0.0275, 0.0235, 0.0471, 1.0), _e7, 1.0, 0.3, true);
    float _e22 = noise_perlin(surface_1.position_object, 5.0, 2, 0.5, 0);
    vec3 _e26 = bump_map(_e22, 0.03, surface_1.normal, surface_1.position);
    Light _e29 = u_look.sun;
    Angle _e30 = parametrization_diffuse(_e29, _e26);
    float _e33 = profile(_e30, 0.0, through_the_glass_shape);
    vec4 _e36 = blend_add(_e16, _e7, _e33, 0.95, true);
    Light _e39 = u_look.room;
    Angle _e40 = parametrization_diffuse(_e39, _e26);
    float _e43 = profile(_e40, 0.0, on_the_glass_shape);
    vec4 _e46 = blend_add(_e36, _e7, _e43, 0.45, true);
    float _e50 = threshold(_e4.border, 0.035, 0.0);
    float _e51 = invert(_e50);
    vec4 _e59 = blend_alpha(_e46, vec4(0.0824, 0.0863, 0.102, 1.0), _e51, 1.0, true);
    Light _e62 = u_look.room;
    Angle _e64 = parametrization_specular(_e62, _e26, surface_1.view);
    float _e67 = profile(_e64, 0.0, gleam_tone_shape);
    Light _e70 = u_look.room;
    LitLayer _e76 = light_apply(_e70, vec4(1.0, 0.9647, 0.8941, 1.0), _e67);
    vec4 _e81 = blend_alpha(_e59, _e76.color, _e76.tone, 0.7, true);
    Light _e84 = u_look.room;
    Angle _e87 = parametrization_specular(_e84, surface_1.normal, surface_1.view);
    float _e90 = profile(_e87, 0.0, edge_of_the_lead_tone_shape);
    Light _e93 = u_look.room;
    LitLayer _e99 = light_apply(_e93, vec4(0.1725, 0.1843, 0.2196, 1.0), _e90);
    vec4 _e104 = blend_add(_e81, _e99.color, _e99.tone, 0.35, true);
    vec4 _e105 = output_(_e104);
    return _e105;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position = in_.position;
    surface.position_object = in_.position_object;
    Surface _e38 = surface;
    vec4 _e39 = shade(_e38);
    vec4 _e40 = finite_vec4_(_e39);
    out_color = _e40;
    return;
}

