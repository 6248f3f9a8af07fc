#version 330 core
// Light that wavers: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// bent-light.json says what to put there and how to draw.
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
    vec2 viewport;
    Light eye;
    Light key;
    vec3 parts_direction;
    vec3 axes_of_the_light_x_axis;
    vec3 axes_of_the_light_y_axis;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct DirectionParts {
    vec3 direction;
    vec3 x_axis;
    vec3 y_axis;
    vec2 place;
};
struct AxesAround {
    vec3 x_axis;
    vec3 y_axis;
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
const uint NOISE_PERLIN = 1u;
const uint NOISE_SIMPLEX = 2u;
const uint NOISE_WORLEY = 3u;
const float SIMPLEX_SCALE = 38.4553;
const float WORLEY_MEAN = 0.5205;
const ProfileShape lit_shape = ProfileShape(0.8253356, 0.5646425, 25.006668, 1.7790966, 1.2, 0.04446849, 0.018017149, 0u);
const ProfileShape brightest_shape = ProfileShape(0.9358968, 0.35227424, 40.004166, 3.6241908, 0.72, 0.021168118, 0.009611014, 0u);
const ProfileShape window_shape = ProfileShape(0.9963897, 0.08489768, 0.0, 1.0, 0.17, 0.0, 0.0, 1u);

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
    float clamped_4 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_4);
    float f = ((clamped_4 - whole) * LN_2_);
    float p_6 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p_6 * _e33) * _e37);
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
    float p_7 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_7 * p_7) + (s_1 * s_1)), 1e-30)));
    return Angle((p_7 * k), (s_1 * k));
}

float atan2_positive(float y_1, float x_5) {
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_3 = (small / large);
    bool is_wide = (t_3 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_3);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_1 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_1) : a_1);
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
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_2, 0.5);
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

float eased(float x_9, float low_1, float high_1) {
    float _e3 = bounded(x_9);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_4 = clamp(_e6, 0.0, 1.0);
    return ((t_4 * t_4) * (3.0 - (2.0 * t_4)));
}

float footprint_of(float x_10) {
    float _e1 = dFdx(x_10);
    float _e2 = dFdy(x_10);
    vec2 d_3 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_3, d_3)));
    return _e6;
}

float footprint_of_vec3_(vec3 v_4) {
    vec3 dx_1 = dFdx(v_4);
    vec3 dy_1 = dFdy(v_4);
    float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec3 position_object(vec3 position_object_1) {
    return position_object_1;
}

vec3 view_2_(vec3 view_2_1) {
    return view_2_1;
}

DirectionParts direction_within(vec3 direction, vec3 x_axis, vec3 y_axis) {
    vec3 _e7 = normalize_or(direction, vec3(0.0, 0.0, 1.0));
    vec3 _e10 = normalize_or(x_axis, vec3(0.0));
    vec3 _e13 = normalize_or(y_axis, vec3(0.0));
    return DirectionParts(_e7, _e10, _e13, vec2(dot(_e7, _e10), dot(_e7, _e13)));
}

vec3 direction_moved(DirectionParts parts, vec2 by) {
    vec2 step_ = clamp(by, vec2(-1000000.0), vec2(1000000.0));
    vec3 moved = ((parts.direction + (step_.x * parts.x_axis)) + (step_.y * parts.y_axis));
    vec3 _e18 = normalize_or(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e18 : parts.direction);
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 _e6 = normalize_or(toward, vec3(0.0, 0.0, 1.0));
    vec3 _e11 = normalize_or(up, vec3(0.0, 1.0, 0.0));
    vec3 leaning = cross(_e11, _e6);
    float square_1 = dot(leaning, leaning);
    vec3 aside = ((abs(_e6.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across = ((square_1 > 1e-8) ? leaning : cross(aside, _e6));
    vec3 _e38 = normalize_or((across - (dot(across, _e6) * _e6)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e38, cross(_e6, _e38), _e6);
}

AxesAround axes(vec3 direction_1, vec3 up_1) {
    mat3x3 _e2 = axes_around(direction_1, up_1);
    return AxesAround(_e2[0], _e2[1]);
}

Light light_toward(Light light, vec3 direction_2) {
    vec3 _e3 = normalize_or(direction_2, light.direction);
    return Light(_e3, light.own_direction, light.color, light.intensity);
}

vec3 shift_direction(vec3 direction_3, vec3 x_axis_1, vec3 y_axis_1, float x_11, float y_2) {
    DirectionParts _e5 = direction_within(direction_3, x_axis_1, y_axis_1);
    vec3 _e7 = direction_moved(_e5, vec2(x_11, y_2));
    return _e7;
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped_1) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed_1 = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped_1 ? clamp(mixed_1, vec4(0.0), vec4(1.0)) : mixed_1);
}

vec4 blend_alpha(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_2) {
    float a_2 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_2) * (1.0 - below_1.w)));
    vec4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_2, clamped_2);
    return _e20;
}

vec4 output_(vec4 color_1) {
    vec4 _e1 = straight(color_1);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(Light light_1, vec3 normal) {
    vec3 _e6 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light_1.direction);
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
        float width_2 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_2)), 0.0, 1.0);
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

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_5 = uvec3(0u);
    v_5 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_5.x;
    uint _e10 = v_5.y;
    uint _e12 = v_5.z;
    v_5.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_5.y;
    uint _e18 = v_5.z;
    uint _e20 = v_5.x;
    v_5.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_5.z;
    uint _e26 = v_5.x;
    uint _e28 = v_5.y;
    v_5.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_5;
    uvec3 _e32 = v_5;
    v_5 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_5.x;
    uint _e40 = v_5.y;
    uint _e42 = v_5.z;
    v_5.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_5.y;
    uint _e48 = v_5.z;
    uint _e50 = v_5.x;
    v_5.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_5.z;
    uint _e56 = v_5.x;
    uint _e58 = v_5.y;
    v_5.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_5;
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
    float a_3 = ((axis == 0u) ? d_1.y : d_1.x);
    float b_1 = ((axis == 2u) ? d_1.y : d_1.z);
    return ((((hash_1.y >> 31u) == 0u) ? a_3 : -(a_3)) + (((hash_1.z >> 31u) == 0u) ? b_1 : -(b_1)));
}

vec3 fade_quintic(vec3 t_2) {
    return (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float value_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 _e4 = fade_quintic((p - corner));
    ivec3 cell_1 = ivec3(corner);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e45 = i;
            i = (_e45 + 1);
        }
        loop_init = false;
        int _e10 = i;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            ivec3 at = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at), seed_2);
            vec3 _e40 = unit_of_hash(_e39);
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e40.x));
        }
    }
    float _e47 = sum;
    return _e47;
}

float perlin_noise(vec3 p_1, uint seed_3) {
    float sum_1 = 0.0;
    int i_1 = 0;
    vec3 corner_1 = floor(p_1);
    vec3 d_4 = (p_1 - corner_1);
    vec3 _e4 = fade_quintic(d_4);
    ivec3 cell_2 = ivec3(corner_1);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e46 = i_1;
            i_1 = (_e46 + 1);
        }
        loop_init_1 = false;
        int _e10 = i_1;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i_1;
            int _e16 = i_1;
            int _e21 = i_1;
            ivec3 at_1 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight_1 = mix((vec3(1.0) - _e4), _e4, equal(at_1, ivec3(1)));
            float _e32 = sum_1;
            uvec3 _e39 = lattice_hash((cell_2 + at_1), seed_3);
            float _e42 = gradient_dot(_e39, (d_4 - vec3(at_1)));
            sum_1 = (_e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42));
        }
    }
    float _e48 = sum_1;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float simplex_corner(vec3 d_2, uvec3 hash_2) {
    float t_5 = max((0.5 - dot(d_2, d_2)), 0.0);
    float _e10 = gradient_dot(hash_2, d_2);
    return ((((t_5 * t_5) * t_5) * t_5) * _e10);
}

float simplex_noise(vec3 p_2, uint seed_4) {
    float sum_2 = 0.0;
    vec3 corner_2 = floor((p_2 + vec3((((p_2.x + p_2.y) + p_2.z) / 3.0))));
    vec3 d_5 = ((p_2 - corner_2) + vec3((((corner_2.x + corner_2.y) + corner_2.z) / 6.0)));
    bvec3 is_first = bvec3((d_5.x >= d_5.y), (d_5.y >= d_5.z), (d_5.z > d_5.x));
    vec3 g = mix(vec3(0.0), vec3(1.0), is_first);
    vec3 l_1 = (vec3(1.0) - g);
    vec3 second = min(g, l_1.zxy);
    vec3 third = max(g, l_1.zxy);
    ivec3 cell_3 = ivec3(corner_2);
    uvec3 _e45 = lattice_hash(cell_3, seed_4);
    float _e46 = simplex_corner(d_5, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    uvec3 _e55 = lattice_hash((cell_3 + ivec3(second)), seed_4);
    float _e56 = simplex_corner(((d_5 - second) + vec3(0.16666667)), _e55);
    sum_2 = (_e48 + _e56);
    float _e58 = sum_2;
    uvec3 _e65 = lattice_hash((cell_3 + ivec3(third)), seed_4);
    float _e66 = simplex_corner(((d_5 - third) + vec3(0.33333334)), _e65);
    sum_2 = (_e58 + _e66);
    float _e68 = sum_2;
    uvec3 _e75 = lattice_hash((cell_3 + ivec3(1)), seed_4);
    float _e76 = simplex_corner((d_5 - vec3(0.5)), _e75);
    sum_2 = (_e68 + _e76);
    float _e79 = sum_2;
    return clamp((0.5 + (SIMPLEX_SCALE * _e79)), 0.0, 1.0);
}

float worley_noise(vec3 p_3, uint seed_5) {
    float nearest = 1.0;
    int i_2 = 0;
    vec3 corner_3 = floor(p_3);
    vec3 d_6 = (p_3 - corner_3);
    ivec3 cell_4 = ivec3(corner_3);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e40 = i_2;
            i_2 = (_e40 + 1);
        }
        loop_init_2 = false;
        int _e9 = i_2;
        if ((_e9 < 27)) {
        } else {
            break;
        }
        {
            int _e12 = i_2;
            int _e17 = i_2;
            int _e24 = i_2;
            ivec3 at_2 = ivec3(((_e12 % 3) - 1), (((_e17 / 3) % 3) - 1), ((_e24 / 9) - 1));
            uvec3 _e32 = lattice_hash((cell_4 + at_2), seed_5);
            vec3 _e33 = unit_of_hash(_e32);
            vec3 offset = ((vec3(at_2) + _e33) - d_6);
            float _e36 = nearest;
            nearest = min(_e36, dot(offset, offset));
        }
    }
    float _e42 = nearest;
    return sqrt(_e42);
}

float noise_octave(uint kind, vec3 p_4, uint seed_6) {
    switch(kind) {
        case 1u: {
            float _e3 = perlin_noise(p_4, seed_6);
            return _e3;
        }
        case 2u: {
            float _e4 = simplex_noise(p_4, seed_6);
            return _e4;
        }
        case 3u: {
            float _e5 = worley_noise(p_4, seed_6);
            return _e5;
        }
        default: {
            float _e6 = value_noise(p_4, seed_6);
            return _e6;
        }
    }
}

float fractal_noise(uint kind_1, vec3 p_5, int octaves, float roughness, int seed_7, float w_1) {
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_3 = 0;
    float octave = 0.0;
    float mean = ((kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5);
    float _e11 = bounded(roughness);
    float gain = clamp(_e11, 0.0, 1.0);
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            int _e75 = i_3;
            i_3 = (_e75 + 1);
        }
        loop_init_3 = false;
        int _e25 = i_3;
        if ((_e25 < min(max(octaves, 1), 8))) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            float _e34 = eased((w_1 * _e30), 0.5, 1.0);
            float visible = (1.0 - _e34);
            octave = mean;
            if ((visible > 0.0)) {
                float _e40 = frequency;
                int _e42 = i_3;
                vec3 place = clamp(((p_5 * _e40) + (float(_e42) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
                int _e56 = i_3;
                float _e59 = noise_octave(kind_1, place, (uint(seed_7) + uint(_e56)));
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

float map_range(float value, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_3) {
    float _e6 = remapped(value, from_low_1, from_high_1, to_low_1, to_high_1, clamped_3);
    return _e6;
}

float line_covers(float distance_, float width) {
    return clamp(((width + 0.5) - distance_), 0.0, min(width, 1.0));
}

float outer_contour(float width_1, vec3 normal_1, vec3 view_2_2, vec2 viewport) {
    vec3 _e6 = normalize_or(normal_1, vec3(0.0));
    float facing = clamp(dot(_e6, view_2_2), 0.0, 1.0);
    float _e11 = bounded(width_1);
    float pixels = ((clamp(_e11, 0.0, 10000.0) * clamp(viewport.y, 1.0, 100000.0)) / 1000.0);
    float _e22 = footprint_of(facing);
    float distance_1 = (facing / max((2.0 * _e22), 1e-6));
    float _e30 = eased(facing, 0.45, 0.75);
    float near = (1.0 - _e30);
    float _e33 = line_covers(distance_1, pixels);
    return (_e33 * near);
}

float noise_perlin(vec3 position, float scale, int octaves_1, float roughness_1, int seed_8) {
    vec3 _e6 = bounded_vec3_((position * scale));
    float _e8 = footprint_of_vec3_(_e6);
    float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_1, seed_8, _e8);
    return _e9;
}

vec4 shade(Surface surface_1) {
    vec3 _e2 = position_object(surface_1.position_object);
    float _e7 = noise_perlin(_e2, 3.5, 2, 0.5, 1);
    float _e13 = map_range(_e7, 0.0, 1.0, -0.22, 0.22, true);
    float _e18 = noise_perlin(_e2, 3.5, 2, 0.5, 5);
    float _e24 = map_range(_e18, 0.0, 1.0, -0.22, 0.22, true);
    vec3 _e27 = u_look.parts_direction;
    vec3 _e30 = u_look.axes_of_the_light_x_axis;
    vec3 _e33 = u_look.axes_of_the_light_y_axis;
    vec3 _e34 = shift_direction(_e27, _e30, _e33, _e13, _e24);
    Light _e37 = u_look.key;
    Light _e38 = light_toward(_e37, _e34);
    Angle _e40 = parametrization_diffuse(_e38, surface_1.normal);
    float _e43 = profile(_e40, 0.0, lit_shape);
    vec4 _e56 = blend_alpha(vec4(0.1529, 0.251, 0.3765, 1.0), vec4(0.3098, 0.5608, 0.6118, 1.0), _e43, 1.0, true);
    float _e59 = profile(_e40, 0.0, brightest_shape);
    vec4 _e67 = blend_alpha(_e56, vec4(0.6627, 0.8392, 0.7569, 1.0), _e59, 1.0, true);
    vec3 _e69 = view_2_(surface_1.view);
    AxesAround _e74 = axes(_e69, vec3(0.0, 1.0, 0.0));
    vec3 _e79 = shift_direction(_e69, _e74.x_axis, _e74.y_axis, -0.32, 0.36);
    Light _e82 = u_look.eye;
    Light _e83 = light_toward(_e82, _e79);
    Angle _e85 = parametrization_diffuse(_e83, surface_1.normal);
    float _e88 = profile(_e85, 0.0, window_shape);
    vec4 _e96 = blend_alpha(_e67, vec4(0.9922, 0.9647, 0.8902, 1.0), _e88, 1.0, true);
    vec2 _e102 = u_look.viewport;
    float _e103 = outer_contour(3.0, surface_1.normal, surface_1.view, _e102);
    vec4 _e111 = blend_alpha(_e96, vec4(0.0784, 0.1294, 0.2275, 1.0), _e103, 1.0, true);
    vec4 _e112 = output_(_e111);
    return _e112;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_2 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_2;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    Surface _e36 = surface;
    vec4 _e37 = shade(_e36);
    vec4 _e38 = finite_vec4_(_e37);
    out_color = _e38;
    return;
}

