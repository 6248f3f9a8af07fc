#version 330 core
// Orange peel: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure7-orange.json says what to put there and how to draw.
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
    Light fill;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint NOISE_PERLIN = 1u;
const ProfileShape flesh_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.1220733, 1.2466265, 0.1, 1.2259196, 0.51338285, 0u);
const ProfileShape shade_tone_shape = ProfileShape(0.9950042, 0.099833414, 1.6523834, 1.9165641, 0.2, 0.67495763, 0.28714308, 0u);
const ProfileShape waxy_sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 2.2990327, 2.8187852, 0.05, 0.41226318, 0.18345885, 0u);
const ProfileShape glint_tone_shape = ProfileShape(0.9992001, 0.039989334, 14.297388, 3.2165964, 0.08, 0.062200632, 0.027819062, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) && (largest < 1e30)))) {
        return otherwise;
    }
    vec3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float exp2_stable(float x_1) {
    float clamped_3 = clamp(x_1, -126.0, 127.99999);
    float whole = roundEven(clamped_3);
    float f = (clamped_3 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_2) {
    float whole_1 = roundEven(x_2);
    float f_1 = (x_2 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float exp2_stable_3_(float x_3) {
    float clamped_4 = max(x_3, -126.0);
    float whole_2 = roundEven(clamped_4);
    float f_2 = (clamped_4 - whole_2);
    float twice_2 = (2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724))))))))))));
    return (twice_2 * uintBitsToFloat((uint((int(whole_2) + 126)) << 23u)));
}

float log2_stable(float x_4) {
    uint bits = floatBitsToUint(x_4);
    int exponent_2 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_2) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_2) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_eighth(float x_5) {
    float y_2 = (x_5 * x_5);
    float s = (x_5 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return vec2(s, c);
}

vec2 sin_cos_tiny(float x_6) {
    float y_3 = (x_6 * x_6);
    float s_1 = (x_6 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334)))));
    float c_1 = (1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889))))));
    return vec2(s_1, c_1);
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y_1, float x_7) {
    float small = min(y_1, x_7);
    float large = max(y_1, x_7);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_3 = (small / large);
    bool is_wide = (t_3 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_3);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_7) ? (HALF_PI - a) : a);
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

float bounded(float x_8) {
    uint bits_1 = floatBitsToUint(x_8);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_8 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_9, float low, float high) {
    float _e3 = bounded(x_9);
    float _e8 = bounded(((_e3 - 0.5) / 0.5));
    float t_4 = clamp(_e8, 0.0, 1.0);
    return ((t_4 * t_4) * (3.0 - (2.0 * t_4)));
}

float length_of(vec3 v_3) {
    float largest_2 = max(max(abs(v_3.x), abs(v_3.y)), abs(v_3.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e16 = bounded((largest_2 * length((v_3 / vec3(largest_2)))));
    return _e16;
}

float footprint_of_vec3_(vec3 v_4) {
    vec3 dx_1 = dFdx(v_4);
    vec3 dy_1 = dFdy(v_4);
    float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float curvature_signed(float kappa, float slope) {
    float a_1 = ((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope);
    float magnitude_1 = min(abs(a_1), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e32 = exp2_stable((-2.88539 * magnitude_1));
    float t_5 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_1 >= 0.0) ? t_5 : -(t_5));
}

vec3 bumped_normal(vec4 along_x, vec4 along_y, vec3 normal) {
    float _e4 = length_of(along_x.xyz);
    float _e6 = length_of(along_y.xyz);
    float largest_3 = max(_e4, _e6);
    if (((largest_3 < 1e-18) || (largest_3 > 1e18))) {
        return normal;
    }
    vec3 s_4 = (along_x.xyz / vec3(largest_3));
    vec3 t_6 = (along_y.xyz / vec3(largest_3));
    vec2 rise = clamp((vec2(along_x.w, along_y.w) / vec2(largest_3)), vec2(-1000000.0), vec2(1000000.0));
    vec3 right = cross(t_6, normal);
    vec3 up = cross(normal, s_4);
    float area = dot(s_4, right);
    if ((abs(area) < 1e-6)) {
        return normal;
    }
    vec3 slope_1 = (((rise.x * right) + (rise.y * up)) / vec3(area));
    float steepness = length(slope_1);
    vec3 limited = (slope_1 * (min(steepness, 10.0) / max(steepness, 1e-20)));
    vec3 _e50 = normalize_or((normal - limited), normal);
    return _e50;
}

vec3 bump_map(float height, float scale, vec3 normal_1, vec3 position) {
    float raised = (height * scale);
    vec3 _e5 = dFdx(position);
    float _e6 = dFdx(raised);
    vec4 along_x_1 = vec4(_e5, _e6);
    vec3 _e8 = dFdy(position);
    float _e9 = dFdy(raised);
    vec4 along_y_1 = vec4(_e8, _e9);
    vec3 _e11 = bumped_normal(along_x_1, along_y_1, normal_1);
    return _e11;
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_alpha_2_(vec4 below_1, vec4 color_1, float tone_1, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_shade(vec4 below_2, vec4 color_2, float tone_2, float opacity_2, bool clamped_2) {
    return clamp(vec4((below_2.xyz + (0.75 * ((below_2.xyz * mix(vec3(1.0), color_2.xyz, tone_2)) - below_2.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_3, float tone_3) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_3.xyz * light.color) * split.y), 1.0), (tone_3 * split.x));
}

LitLayer light_apply_2_(Light light_1, vec4 color_4, float tone_4) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4((light_1.color * split_1.y), 1.0), (tone_4 * split_1.x));
}

Angle parametrization_specular(Light light_2, vec3 normal_2, vec3 view) {
    vec3 mirrored = (((2.0 * dot(normal_2, view)) * normal_2) - view);
    vec3 _e8 = normalize_moderate(mirrored, normal_2);
    return Angle((0.5 * length((_e8 - light_2.direction))), (0.5 * length((_e8 + light_2.direction))));
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
    float _e21 = exp2_stable_2_((exponent * _e19));
    return min(_e21, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape) {
    float s_5 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
    if (((s_5 <= 0.0) || false)) {
        return 1.0;
    }
    float q_2 = (s_5 * shape.scale);
    float _e17 = profile_power(q_2, shape.exponent);
    return _e17;
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
    float _e21 = exp2_stable_3_((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_2_(Angle u_4, ProfileShape shape_1) {
    float s_6 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
    if (((s_6 <= 0.0) || false)) {
        return 1.0;
    }
    float q_3 = (s_6 * shape_1.scale);
    float _e17 = profile_power_2_(q_3, shape_1.exponent);
    return _e17;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_2) {
    float _e3 = profile_point(u_5, shape_2);
    bool is_wide_1 = (w < (0.1 * shape_2.edge_deviation));
    if (((is_wide_1 || (w <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w));
    Angle _e16 = angle_turned(u_5, _e15);
    float _e17 = profile_point(_e16, shape_2);
    Angle _e22 = angle_turned(u_5, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point(_e22, shape_2);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_2_(Angle u_6, float w_1, ProfileShape shape_3) {
    float _e3 = profile_point_2_(u_6, shape_3);
    bool is_wide_2 = (w_1 < (0.1 * shape_3.edge_deviation));
    if (((is_wide_2 || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e16 = angle_turned(u_6, _e15);
    float _e17 = profile_point_2_(_e16, shape_3);
    Angle _e22 = angle_turned(u_6, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point_2_(_e22, shape_3);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_3_(Angle u_7, float w_2, ProfileShape shape_4) {
    float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_3 = (w_2 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_3 || (w_2 <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w_2 >= (3.4641016 * shape_4.edge_deviation)))) {
        float width = sqrt(((w_2 * w_2) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
        float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return clamp((0.5 + (((shape_4.offset + shape_4.edge_mean) - (2.0 * _e32)) / width)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w_2));
    Angle _e45 = angle_turned(u_7, _e44);
    float _e46 = profile_point_2_(_e45, shape_4);
    Angle _e51 = angle_turned(u_7, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point_2_(_e51, shape_4);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_5) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_5);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_6) {
    vec2 _e5 = sin_cos_tiny((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_6);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_7) {
    Angle _e6 = angle_turned_2_(angle_2, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_4_(Angle angle_3, float shift_3, ProfileShape shape_8) {
    Angle _e6 = angle_turned_2_(angle_3, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
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

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a_2 = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_2 : -(a_2)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
}

vec3 fade_quintic(vec3 t_2) {
    return (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 d_1 = (p - corner);
    vec3 _e4 = fade_quintic(d_1);
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
            ivec3 at = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at), seed_2);
            float _e42 = gradient_dot(_e39, (d_1 - vec3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, vec3 p_1, int octaves, float roughness, int seed_3, float w_3) {
    float octave = 0.0;
    int i_1 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e67 = i_1;
            i_1 = (_e67 + 1);
        }
        loop_init_1 = false;
        int _e17 = i_1;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased((w_3 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            vec3 place = clamp(((p_1 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place, (0u + uint(_e47)));
            octave = mix(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = (_e53 + (_e54 * _e55));
        float _e58 = total;
        float _e59 = strength;
        total = (_e58 + _e59);
        float _e61 = strength;
        strength = (_e61 * 0.5);
        float _e64 = frequency;
        frequency = (_e64 * 2.0);
    }
    float _e70 = sum_1;
    return min((_e70 / 1.5), 1.0);
}

float noise_perlin(vec3 position_1, float scale_1, int octaves_1, float roughness_1, int seed_4) {
    vec3 p_2 = (position_1 * scale_1);
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed(surface_1.kappa, 0.1);
    float shade_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(shade_convexity, vec4(0.9686, 0.6039, 0.1176, 1.0), vec4(0.8471, 0.4118, 0.0392, 1.0));
    vec3 place_1 = surface_1.position_object;
    float _e24 = noise_perlin(place_1, 14.0, 2, 0.5, 0);
    vec3 _e28 = bump_map(_e24, 0.035, surface_1.normal, surface_1.position);
    vec3 _e32 = u_look.key.direction;
    vec3 _e40 = u_look.key.direction;
    Angle flesh_angle = Angle((0.5 * length((_e28 - _e32))), (0.5 * length((_e28 + _e40))));
    float flesh_warp = (((2.0 * shade_convexity) - 1.0) * 0.2);
    float _e53 = profile(flesh_angle, flesh_warp, flesh_tone_shape);
    Light _e56 = u_look.key;
    LitLayer _e57 = light_apply(_e56, _e18, _e53);
    vec4 _e67 = blend_alpha(vec4(0.4314, 0.1647, 0.0235, 1.0), _e57.color, _e57.tone, 1.0, true);
    vec4 _e78 = curvature_color(shade_convexity, vec4(0.7216, 0.2824, 0.0471, 1.0), vec4(0.5412, 0.1843, 0.0392, 1.0));
    vec3 _e82 = u_look.fill.direction;
    vec3 _e90 = u_look.fill.direction;
    Angle shade_angle = Angle((0.5 * length((_e28 - _e82))), (0.5 * length((_e28 + _e90))));
    float shade_warp = (((2.0 * shade_convexity) - 1.0) * 0.1);
    float _e103 = profile_2_(shade_angle, shade_warp, shade_tone_shape);
    Light _e106 = u_look.fill;
    LitLayer _e107 = light_apply(_e106, _e78, _e103);
    vec4 _e112 = blend_shade(_e67, _e107.color, _e107.tone, 0.75, true);
    Light _e115 = u_look.key;
    Angle _e117 = parametrization_specular(_e115, _e28, surface_1.view);
    float _e120 = profile_3_(_e117, 0.0, waxy_sheen_tone_shape);
    Light _e123 = u_look.key;
    LitLayer _e129 = light_apply(_e123, vec4(0.4157, 0.2902, 0.1333, 1.0), _e120);
    vec4 waxy_sheen_blend = clamp(vec4((_e112.xyz + (0.55 * ((_e112.xyz + (_e129.tone * _e129.color.xyz)) - _e112.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float _e151 = profile_4_(_e117, 0.0, glint_tone_shape);
    Light _e154 = u_look.key;
    LitLayer _e157 = light_apply_2_(_e154, vec4(1.0), _e151);
    vec4 _e162 = blend_alpha_2_(waxy_sheen_blend, _e157.color, _e157.tone, 0.85, true);
    return _e162;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_3 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_3;
    vec4 _e11 = u_view.eye;
    float _e16 = u_view.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    surface.position = in_.position;
    surface.position_object = in_.position_object;
    vec4 _e31 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e31.x;
    Surface _e33 = surface;
    vec4 _e34 = shade(_e33);
    out_color = _e34;
    return;
}

