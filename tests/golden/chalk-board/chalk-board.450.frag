#version 450 core
// Chalk: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// chalk-board.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
    vec4 screen;
};
struct Object {
    mat4x4 world_from_object;
    mat3x3 world_from_normal;
    float id;
    float cutoff;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light back;
    vec2 viewport;
    Light key;
};
struct Surface {
    vec3 normal;
    float kappa;
    vec2 pixel;
    vec3 anchor;
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
struct StretchedPlace {
    vec2 place;
    vec3 stretch;
};
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};
struct MarkPlace {
    vec2 place;
    vec3 stretch;
};
struct PaperGrain {
    float tone;
    float height;
};
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape orange_chalk_shape = ProfileShape(0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5, 0.43399706, 0.1847509, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_normal;
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
    float square_1 = dot(scaled, scaled);
    bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square_1)));
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
    float r = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    vec2 _e27 = sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
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
    float t_5 = (small / large);
    bool is_wide = (t_5 > 0.41421357);
    float r_1 = (is_wide ? ((small - large) / (small + large)) : t_5);
    float r2_ = (r_1 * r_1);
    float series_1 = (r_1 * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_5 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_6) ? (HALF_PI - a_5) : a_5);
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
    float t_6 = clamp(_e6, 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
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

vec4 premultiplied(vec4 color) {
    return vec4((color.xyz * color.w), color.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 mix_colors_normal(vec4 a_3, vec4 b_3, float factor) {
    vec4 _e3 = bounded_vec4_(a_3);
    vec4 _e4 = bounded_vec4_(b_3);
    float _e6 = factor_of(factor, true);
    vec4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_6 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_6), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_6 * a_6);
        return (a_6 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_7 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_6 >= 0.0) ? t_7 : -(t_7));
}

float transition(float kappa_2, float slope_1) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
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

Angle parametrization_diffuse(Light light, vec3 normal) {
    vec3 _e6 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
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
        float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
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
    uvec3 v_6 = uvec3(0u);
    v_6 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_6;
    uvec3 _e32 = v_6;
    v_6 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_6;
    return _e61;
}

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash, vec3 d_1) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a_7 = ((axis == 0u) ? d_1.y : d_1.x);
    float b_5 = ((axis == 2u) ? d_1.y : d_1.z);
    return ((((hash.y >> 31u) == 0u) ? a_7 : -(a_7)) + (((hash.z >> 31u) == 0u) ? b_5 : -(b_5)));
}

vec3 fade_quintic(vec3 t_4) {
    return (((t_4 * t_4) * t_4) * ((t_4 * ((t_4 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 d_2 = (p - corner);
    vec3 _e4 = fade_quintic(d_2);
    ivec3 cell_1 = ivec3(corner);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e46 = i;
            i = (_e46 + 1);
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
            ivec3 at_1 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at_1, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at_1), seed_2);
            float _e42 = gradient_dot(_e39, (d_2 - vec3(at_1)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float size_on_screen(float depth, float perspective, float scale) {
    float _e10 = bounded(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)));
    return _e10;
}

vec3 anchor_on_screen(vec3 origin, float perspective_1, float scale_1) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    vec3 _e12 = bounded_vec3_(vec3((origin.x * _e5), (-(origin.y) * _e5), _e5));
    return _e12;
}

vec2 place_in_picture(vec2 pixel, vec2 viewport) {
    vec2 _e2 = bounded_vec2_(pixel);
    vec2 from_middle = (_e2 - (0.5 * viewport));
    return (vec2(from_middle.x, -(from_middle.y)) / vec2(max(viewport.y, 1.0)));
}

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle_1) {
    vec2 _e4 = sin_cos_of(angle_1);
    vec3 _e10 = bounded_vec3_(((_e4.y * along) + (_e4.x * across)));
    vec3 _e16 = bounded_vec3_(((_e4.y * across) - (_e4.x * along)));
    vec2 _e17 = bounded_vec2_(place);
    vec2 turned_1 = vec2(((_e4.y * _e17.x) + (_e4.x * _e17.y)), ((_e4.y * _e17.y) - (_e4.x * _e17.x)));
    vec3 most = vec3(1000000000000000.0);
    vec3 stretch_3 = clamp(vec3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    vec2 _e41 = bounded_vec2_(turned_1);
    return StretchedPlace(_e41, stretch_3);
}

SpacedPlace spaced(vec2 place_1, vec3 stretch, vec2 viewport_1, float count) {
    float _e4 = bounded(count);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (number / max(viewport_1.y, 1.0)) : number);
    vec2 _e19 = bounded_vec2_(place_1);
    vec2 _e21 = bounded_vec2_((_e19 * scale_2));
    vec2 p_3 = clamp(_e21, vec2(-4194304.0), vec2(4194304.0));
    vec3 _e27 = bounded_vec3_(stretch);
    vec3 s_4 = clamp(_e27, vec3(-1000000000000000.0), vec3(1000000000000000.0));
    return SpacedPlace(p_3, (is_pixel ? vec3(1.0, 0.0, 1.0) : s_4));
}

float area_square(vec3 stretch_1) {
    float sum_1 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_1 * sum_1) / 66.0));
}

float octave_of(float square) {
    float _e5 = log_stable(clamp(square, 1e-30, 1e30));
    return clamp((-0.7213475 * _e5), -16.0, 16.0);
}

MarkPlace mark_place_object(float angle_2, vec3 anchor, vec2 pixel_1, vec2 viewport_2) {
    float _e5 = bounded(anchor.z);
    float size = clamp(_e5, 1e-6, 1000000.0);
    vec2 _e9 = place_in_picture(pixel_1, viewport_2);
    vec2 _e15 = bounded_vec2_((_e9 - vec2(anchor.x, -(anchor.y))));
    vec2 place_4 = (_e15 / vec2(size));
    StretchedPlace _e28 = mark_place_of(place_4, vec3((1.0 / size), 0.0, 0.0), vec3(0.0, (1.0 / size), 0.0), angle_2);
    return MarkPlace(_e28.place, _e28.stretch);
}

float caught_ink(float ink, float height, float tooth) {
    float _e3 = bounded(ink);
    float amount = clamp(_e3, 0.0, 1.0);
    float _e7 = bounded(tooth);
    float rough = clamp(_e7, 0.0, 1.0);
    return clamp((amount + ((((8.0 * rough) * (height - 0.5)) * amount) * (1.0 - amount))), 0.0, 1.0);
}

float paper_octave(vec2 place_2, int zoom, float w_1, float fiber, uint seed_3) {
    float _e5 = power_of_two(zoom);
    vec2 p_4 = clamp((place_2 * _e5), vec2(-4194304.0), vec2(4194304.0));
    uint own = (seed_3 + (7u * uint(zoom)));
    float _e18 = perlin_noise(vec3(p_4, 0.5), own);
    float grain = (_e18 - 0.5);
    vec2 q_2 = clamp((2.7 * vec2(((0.8 * p_4.x) - (0.6 * p_4.y)), ((0.6 * p_4.x) + (0.8 * p_4.y)))), vec2(-4194304.0), vec2(4194304.0));
    float _e47 = perlin_noise(vec3(q_2, 0.5), (own + 1u));
    float felt = (_e47 - 0.5);
    float _e53 = eased((w_1 * _e5), 0.5, 1.0);
    float coarse_seen = (1.0 - _e53);
    float _e61 = eased(((2.7 * w_1) * _e5), 0.5, 1.0);
    float felt_seen = (1.0 - _e61);
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

float paper_height(SpacedPlace at, float fiber_1, uint seed_4) {
    float height_1 = 0.0;
    vec2 x_13 = dFdx(at.place);
    vec2 y_2 = dFdy(at.place);
    float _e11 = bounded(sqrt(max(dot(x_13, x_13), dot(y_2, y_2))));
    float _e13 = area_square(at.stretch);
    float _e15 = octave_of(sqrt(_e13));
    float zoom_1 = floor(_e15);
    float f_1 = (_e15 - zoom_1);
    float _e18 = bounded(fiber_1);
    float fine = clamp(_e18, 0.0, 1.0);
    float _e24 = paper_octave(at.place, int(zoom_1), _e11, fine, seed_4);
    height_1 = _e24;
    if ((f_1 > 0.0)) {
        float _e28 = height_1;
        float _e33 = paper_octave(at.place, (int(zoom_1) + 1), _e11, fine, seed_4);
        float both = mix(_e28, _e33, f_1);
        height_1 = clamp((0.5 + ((both - 0.5) / sqrt(((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))))), 0.0, 1.0);
    }
    float _e51 = height_1;
    return _e51;
}

PaperGrain paper_grain(float value, vec2 place_3, vec3 stretch_2, float count_1, float tooth_1, float fiber_2, int seed_5, vec2 viewport_3) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    float _e10 = paper_height(_e8, fiber_2, uint(seed_5));
    float _e12 = factor_of(value, true);
    float _e15 = caught_ink((1.0 - _e12), _e10, tooth_1);
    return PaperGrain((1.0 - _e15), _e10);
}

float reflectance_wrap(Light light_1, vec3 normal_1, float wrap) {
    float _e3 = bounded(wrap);
    float w_3 = clamp(_e3, 0.0, 1.0);
    vec3 _e11 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light_1.direction);
    return max(((cosine + w_3) / (1.0 + w_3)), 0.0);
}

float invert(float value_1) {
    float _e3 = bounded((1.0 - value_1));
    return _e3;
}

float map_range(float value_2, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2) {
    float _e6 = remapped(value_2, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(float a_4, float b_4) {
    float _e3 = bounded((a_4 * b_4));
    return _e3;
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.15);
    float _e12 = map_range(_e6, 0.0, 0.9, 0.0, 1.0, true);
    float _e18 = map_range(_e12, 0.0, 0.6, 0.05, 0.5, true);
    float _e19 = invert(_e18);
    vec2 _e25 = u_look.viewport;
    MarkPlace _e26 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e25);
    vec2 _e35 = u_look.viewport;
    PaperGrain _e36 = paper_grain(_e19, _e26.place, _e26.stretch, 120.0, 0.6, 0.5, 5, _e35);
    float _e38 = invert(_e36.tone);
    vec4 _e49 = mix_colors_normal(vec4(0.1216, 0.1647, 0.1686, 1.0), vec4(0.4275, 0.5098, 0.5647, 1.0), _e38);
    Light _e52 = u_look.back;
    Angle _e54 = parametrization_diffuse(_e52, surface_1.normal);
    float _e57 = profile(_e54, 0.0, orange_chalk_shape);
    float _e58 = invert(_e57);
    vec2 _e67 = u_look.viewport;
    PaperGrain _e68 = paper_grain(_e58, _e26.place, _e26.stretch, 220.0, 0.8, 0.5, 9, _e67);
    float _e70 = invert(_e68.tone);
    vec4 _e76 = mix_colors_normal(_e49, vec4(0.9412, 0.6353, 0.3608, 1.0), _e70);
    float _e78 = kappa_surface(surface_1.kappa);
    float _e80 = transition(_e78, 0.16);
    float _e86 = map_range(_e80, 0.15, 0.5, 0.1, 1.0, true);
    float _e87 = multiply(_e12, _e86);
    float _e88 = invert(_e87);
    vec2 _e97 = u_look.viewport;
    PaperGrain _e98 = paper_grain(_e88, _e26.place, _e26.stretch, 260.0, 0.62, 0.5, 3, _e97);
    float _e100 = invert(_e98.tone);
    vec4 _e106 = mix_colors_normal(_e76, vec4(0.9686, 0.9529, 0.9098, 1.0), _e100);
    vec4 _e107 = premultiplied(_e106);
    vec4 _e108 = output_(_e107);
    return _e108;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), 0.0, vec2(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_2 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_2;
    vec4 _e18 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e18.x;
    vec4 _e25 = u_view.screen;
    vec4 _e30 = u_view.screen;
    surface.pixel = ((in_.clip.xy * _e25.xy) + _e30.zw);
    mat4x4 _e36 = u_view.camera_from_world;
    vec4 _e40 = u_object.world_from_object[3];
    float _e49 = u_view.eye.w;
    float _e54 = u_view.clip_from_world[0][1];
    float _e59 = u_view.clip_from_world[1][1];
    float _e64 = u_view.clip_from_world[2][1];
    vec3 _e67 = anchor_on_screen((_e36 * vec4(_e40.xyz, 1.0)).xyz, _e49, length(vec3(_e54, _e59, _e64)));
    surface.anchor = _e67;
    Surface _e68 = surface;
    vec4 _e69 = shade(_e68);
    vec4 _e70 = finite_vec4_(_e69);
    out_color = _e70;
    return;
}

