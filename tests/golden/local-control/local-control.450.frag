#version 450 core
// Light where it is wanted: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// local-control.json says what to put there and how to draw.
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
    mat3x3 camera_from_world;
    vec2 viewport;
    Light back;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    vec3 position_camera;
    vec3 curvature_tensor;
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
const ProfileShape soft_tone_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_tensor_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
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
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_3, 0.5);
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

float eased(float x_8, float low_1, float high_1) {
    float _e3 = bounded(x_8);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_3 = clamp(_e6, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float factor_of(float x_9, bool clamped) {
    float _e2 = bounded(x_9);
    float _e3 = bounded(x_9);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
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

float footprint_of(float x_10) {
    float _e1 = dFdx(x_10);
    float _e2 = dFdy(x_10);
    vec2 d_1 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float edge_width(float w, float softness) {
    float _e4 = bounded(softness);
    return length(vec2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_11, float edge, float w_1) {
    float _e4 = bounded((x_11 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

vec3 tensor_safe(vec3 tensor) {
    float _e2 = kappa_safe(tensor.x);
    float _e4 = kappa_safe(tensor.y);
    float _e6 = kappa_safe(tensor.z);
    return vec3(_e2, _e4, _e6);
}

float combine_tones_union(float a_1, float b_1) {
    float _e3 = factor_of(a_1, true);
    float _e5 = factor_of(b_1, true);
    return max(_e3, _e5);
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

float near_place(vec3 position, vec3 center, float radius, float hardness) {
    vec3 _e4 = bounded_vec3_(position);
    vec3 _e5 = bounded_vec3_(center);
    float _e7 = length_of((_e4 - _e5));
    float _e8 = bounded(radius);
    float reach = max(_e8, 0.0);
    float _e12 = factor_of(hardness, true);
    float _e14 = eased(_e7, (reach * _e12), reach);
    return (1.0 - _e14);
}

Light local_light(Light light, vec3 bend, float strength, vec3 center_1, float radius_1, float hardness_1, vec3 position_1) {
    bool local_2 = false;
    float _e7 = near_place(position_1, center_1, radius_1, hardness_1);
    vec3 _e9 = bounded_vec3_(bend);
    vec3 bent = (light.direction + (_e7 * clamp(_e9, vec3(-1000000.0), vec3(1000000.0))));
    vec3 _e19 = normalize_or(bent, light.direction);
    if ((dot(bent, bent) > 1e-6)) {
        local_2 = (_e7 > 0.0);
    } else {
        local_2 = false;
    }
    bool _e28 = local_2;
    vec3 direction = (_e28 ? _e19 : light.direction);
    float _e32 = bounded(strength);
    float _e36 = mixed(1.0, clamp(_e32, 0.0, 1000000.0), _e7);
    float intensity = (light.intensity * _e36);
    return Light(direction, light.own_direction, light.color, min(intensity, 1e30));
}

float local_tone(float tone_1, float amount, vec3 center_2, float radius_2, float hardness_2, vec3 position_2) {
    float _e6 = near_place(position_2, center_2, radius_2, hardness_2);
    float _e7 = bounded(tone_1);
    float _e11 = bounded(amount);
    return clamp((clamp(_e7, 0.0, 1.0) + (_e6 * clamp(_e11, -1.0, 1.0))), 0.0, 1.0);
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
    bool local_3 = false;
    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_3 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e18 = local_3;
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
    bool local_4 = false;
    bool local_5 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_4 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_4 = true;
    }
    bool _e13 = local_4;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_5 = (w_2 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_5 = false;
    }
    bool _e24 = local_5;
    if (_e24) {
        float width_4 = sqrt(((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_4)), 0.0, 1.0);
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

float rim(Light light_2, vec3 normal_1, vec3 view, float width, float softness_2, float follow) {
    vec3 _e10 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    float facing_1 = clamp(dot(_e10, view), 0.0, 1.0);
    float _e16 = factor_of(width, true);
    float _e18 = factor_of(softness_2, true);
    float _e20 = footprint_of(facing_1);
    float edge_2 = max((_e16 * _e18), min(_e20, 1.0));
    vec3 aside = (_e10 - view);
    float further = ((facing_1 > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing_1));
    float within = ((further / max(edge_2, 1e-6)) + ((softness_2 > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    vec3 across = (light_2.direction - (dot(light_2.direction, view) * view));
    vec3 _e61 = normalize_or(across, vec3(0.0));
    float side = dot((_e10 - (dot(_e10, view) * view)), _e61);
    float _e66 = eased(side, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float line_covers(float distance_, float width_1) {
    return clamp(((width_1 + 0.5) - distance_), 0.0, min(width_1, 1.0));
}

float seen_well(float facing) {
    float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

float faded_in(float x_12, float limit, float softness_3) {
    float _e3 = bounded(limit);
    float at = max(_e3, 0.0);
    float _e6 = footprint_of(x_12);
    float _e10 = factor_of(softness_3, true);
    float _e12 = edge_width(_e6, (min(at, 1000000000.0) * _e10));
    float _e13 = bounded(x_12);
    float _e14 = step_filtered(_e13, at, _e12);
    return _e14;
}

float inner_contour_suggestive(float width_2, float limit_1, float softness_4, vec3 tensor_1, vec3 normal_2, vec3 view_1, mat3x3 camera_from_world, vec3 place, vec2 viewport) {
    vec3 n_1 = (camera_from_world * normal_2);
    vec3 _e10 = tensor_safe(tensor_1);
    float square_1 = dot(n_1.xy, n_1.xy);
    float radial = (((((_e10.x * n_1.x) * n_1.x) + (((2.0 * _e10.y) * n_1.x) * n_1.y)) + ((_e10.z * n_1.y) * n_1.y)) / max(square_1, 1e-6));
    float _e36 = dFdx(radial);
    float _e37 = dFdy(radial);
    vec2 change = vec2(_e36, _e37);
    vec3 v_5 = (camera_from_world * view_1);
    vec3 row = dFdy(place);
    float up = (((row - (dot(row, v_5) * v_5)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n_1.x) + ((up * change.y) * n_1.y))) * inversesqrt(max(square_1, 1e-6)));
    float _e67 = bounded(width_2);
    float pixels = (((0.5 * clamp(_e67, 0.0, 10000.0)) * height) / 1000.0);
    float distance_1 = (abs(radial) / max(length(change), 1e-6));
    float _e84 = faded_in(((toward_eye * height) * 0.05), limit_1, softness_4);
    float _e85 = line_covers(distance_1, pixels);
    float _e88 = seen_well(dot(normal_2, view_1));
    return ((_e85 * _e84) * _e88);
}

float outer_contour(float width_3, vec3 normal_3, vec3 view_2, vec2 viewport_1) {
    vec3 _e6 = normalize_or(normal_3, vec3(0.0));
    float facing_2 = clamp(dot(_e6, view_2), 0.0, 1.0);
    float _e11 = bounded(width_3);
    float pixels_1 = ((clamp(_e11, 0.0, 10000.0) * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    float _e22 = footprint_of(facing_2);
    float distance_2 = (facing_2 / max((2.0 * _e22), 1e-6));
    float _e30 = eased(facing_2, 0.45, 0.75);
    float near = (1.0 - _e30);
    float _e33 = line_covers(distance_2, pixels_1);
    return (_e33 * near);
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    Light _e16 = local_light(_e3, vec3(0.9, 0.25, 0.5), 1.0, vec3(0.12, 0.42, 0.5), 0.5, 0.4, surface_1.position_object);
    Light _e29 = local_light(_e16, vec3(0.4, 0.1, 0.35), 1.0, vec3(-0.05, -0.35, 0.5), 0.4, 0.2, surface_1.position_object);
    Angle _e31 = parametrization_diffuse(_e29, surface_1.normal);
    float _e34 = profile(_e31, 0.0, soft_tone_shape);
    float _e43 = local_tone(_e34, -0.45, vec3(0.0, 0.02, 0.45), 0.3, 0.1, surface_1.position_object);
    float _e52 = local_tone(_e43, 0.5, vec3(-0.2, 0.72, 0.4), 0.17, 0.5, surface_1.position_object);
    float _e55 = threshold(_e52, 0.55, 0.0);
    vec4 _e68 = blend_alpha(vec4(0.36, 0.36, 0.6, 1.0), vec4(0.96, 0.72, 0.47, 1.0), _e55, 1.0, true);
    float _e71 = threshold(_e52, 0.97, 0.0);
    vec4 _e79 = blend_alpha(_e68, vec4(1.0, 0.93, 0.76, 1.0), _e71, 1.0, true);
    Light _e82 = u_look.back;
    float _e88 = rim(_e82, surface_1.normal, surface_1.view, 0.3, 0.1, 1.0);
    vec4 _e96 = blend_alpha(_e79, vec4(0.72, 0.86, 1.0, 1.0), _e88, 0.7, true);
    vec2 _e102 = u_look.viewport;
    float _e103 = outer_contour(3.0, surface_1.normal, surface_1.view, _e102);
    mat3x3 _e112 = u_look.camera_from_world;
    vec2 _e116 = u_look.viewport;
    float _e117 = inner_contour_suggestive(2.0, 20.0, 0.3, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e112, surface_1.position_camera, _e116);
    float _e118 = combine_tones_union(_e103, _e117);
    vec4 _e126 = blend_alpha(_e96, vec4(0.17, 0.13, 0.28, 1.0), _e118, 0.85, true);
    vec4 _e127 = output_(_e126);
    return _e127;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    mat4x4 _e39 = u_view.camera_from_world;
    surface.position_camera = (_e39 * vec4(in_.position, 1.0)).xyz;
    vec4 _e51 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    surface.curvature_tensor = _e51.xyz;
    Surface _e53 = surface;
    vec4 _e54 = shade(_e53);
    vec4 _e55 = finite_vec4_(_e54);
    out_color = _e55;
    return;
}

