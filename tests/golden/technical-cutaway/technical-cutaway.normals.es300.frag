#version 300 es
// Technical cutaway: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws normals and depth, for the curvature pass.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// technical-cutaway.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
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
    Light eye;
    mat3x3 camera_from_world;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
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
struct VectorParts {
    float x;
    float y;
    float z;
};
struct Shaded {
    vec3 value;
    vec4 color;
    float cutoff;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
struct Fragment {
    vec4 normal;
    float depth;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape metal_tone_shape = ProfileShape(0.99820054, 0.059964005, 7.166244, 3.1997643, 0.12, 0.124456726, 0.0556771, 0u);
const ProfileShape contour_tone_shape = ProfileShape(0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_normal;
layout(location = 1) out float out_depth;

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
    bool local_1 = false;
    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local_1 = (largest < 1e30);
    } else {
        local_1 = false;
    }
    bool _e17 = local_1;
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
    float t_3 = (small / large);
    bool is_wide = (t_3 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_3);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_3 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_3) : a_3);
}

float angle_radians(Angle u) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_turned(Angle u_1, vec2 t) {
    bool local_2 = false;
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_1));
    if ((s_2 <= 0.0)) {
        local_2 = (s_2 < c_1);
    } else {
        local_2 = false;
    }
    bool _e32 = local_2;
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

vec3 mixed_vec3_(vec3 a_1, vec3 b_1, float t_2) {
    float _e5 = mixed(a_1.x, b_1.x, t_2);
    float _e8 = mixed(a_1.y, b_1.y, t_2);
    float _e11 = mixed(a_1.z, b_1.z, t_2);
    return vec3(_e5, _e8, _e11);
}

float factor_of(float x_7, bool clamped) {
    float _e2 = bounded(x_7);
    float _e3 = bounded(x_7);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_8) {
    float _e1 = dFdx(x_8);
    float _e2 = dFdy(x_8);
    vec2 d_1 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float edge_width(float w, float softness) {
    float _e4 = bounded(softness);
    return length(vec2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_9, float edge, float w_1) {
    float _e4 = bounded((x_9 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
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

vec4 set_alpha(vec4 color_1, float alpha) {
    return vec4(color_1.xyz, alpha);
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
    float a_4 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_4), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_4 * a_4);
        return (a_4 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_4 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_4 >= 0.0) ? t_4 : -(t_4));
}

float transition(float kappa_2, float slope_1) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float warp(float convexity_1, float amount) {
    return (((2.0 * convexity_1) - 1.0) * clamp(amount, -3.1415927, 3.1415927));
}

vec3 position_object(vec3 position_object_1) {
    return position_object_1;
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha_1, float opacity, bool clamped_1) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed_1 = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha_1);
    return (clamped_1 ? clamp(mixed_1, vec4(0.0), vec4(1.0)) : mixed_1);
}

vec4 blend_multiply(vec4 below_1, vec4 color_2, float tone, float opacity_1, bool clamped_2) {
    vec4 _e12 = blend_finish(below_1, (below_1.xyz * (tone * color_2.xyz)), below_1.w, (opacity_1 * color_2.w), clamped_2);
    return _e12;
}

vec4 blend_alpha(vec4 below_2, vec4 color_3, float tone_1, float opacity_2, bool clamped_3) {
    float a_5 = (opacity_2 * color_3.w);
    float alpha_2 = (below_2.w + ((tone_1 * a_5) * (1.0 - below_2.w)));
    vec4 _e20 = blend_finish(below_2, (below_2.xyz + (tone_1 * (color_3.xyz - below_2.xyz))), alpha_2, a_5, clamped_3);
    return _e20;
}

vec4 output_(vec4 color_4) {
    vec4 _e1 = straight(color_4);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color_5, float tone_2) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color_5.xyz * light.color) * _e4.y), color_5.w), (tone_2 * _e4.x));
}

Angle parametrization_specular(Light light_1, vec3 normal, vec3 view) {
    vec3 _e7 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    vec3 mirrored = (((2.0 * dot(_e7, view)) * _e7) - view);
    vec3 _e13 = normalize_or(mirrored, _e7);
    Angle _e15 = angle_between(_e13, light_1.direction);
    return _e15;
}

Angle parametrization_screen_aligned(Light light_2, vec3 normal_1, mat3x3 camera_from_world) {
    vec3 _e7 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    vec3 n_1 = (camera_from_world * _e7);
    vec3 _e13 = normalize_or(n_1, vec3(0.0, 0.0, 1.0));
    Angle _e15 = angle_between(_e13, light_2.own_direction);
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

vec4 gooch(Light light_3, vec3 normal_2, vec4 color_6, vec4 cool, vec4 warm, float cool_amount, float warm_amount) {
    vec3 _e11 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    float t_5 = (0.5 + (0.5 * dot(_e11, light_3.direction)));
    vec3 _e19 = bounded_vec3_(color_6.xyz);
    float _e22 = factor_of(cool_amount, true);
    vec3 _e25 = bounded_vec3_((cool.xyz + (_e22 * _e19)));
    float _e28 = factor_of(warm_amount, true);
    vec3 _e31 = bounded_vec3_((warm.xyz + (_e28 * _e19)));
    vec3 _e35 = mixed_vec3_(_e25, _e31, clamp(t_5, 0.0, 1.0));
    float _e37 = bounded(color_6.w);
    return vec4(_e35, _e37);
}

float invert(float value_1) {
    float _e3 = bounded((1.0 - value_1));
    return _e3;
}

float minimum(float a_2, float b_2) {
    float _e2 = bounded(a_2);
    float _e3 = bounded(b_2);
    return min(_e2, _e3);
}

VectorParts separate_vector(vec3 vector) {
    return VectorParts(vector.x, vector.y, vector.z);
}

Shaded shade(Surface surface_1) {
    Light _e3 = u_look.key;
    vec4 _e22 = gooch(_e3, surface_1.normal, vec4(0.8314, 0.8392, 0.8549, 1.0), vec4(0.1725, 0.2902, 0.4863, 1.0), vec4(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    vec4 _e28 = blend_alpha(vec4(1.0), _e22, 1.0, 1.0, true);
    float _e31 = transition(surface_1.kappa, 0.25);
    vec4 _e39 = curvature_color(_e31, vec4(1.0), vec4(0.5412, 0.5804, 0.6588, 1.0));
    Light _e42 = u_look.key;
    LitLayer _e44 = light_apply(_e42, _e39, 1.0);
    vec4 _e49 = blend_multiply(_e28, _e44.color, _e44.tone, 0.8, true);
    Light _e52 = u_look.key;
    Angle _e55 = parametrization_specular(_e52, surface_1.normal, surface_1.view);
    float _e58 = transition(surface_1.kappa, 0.2);
    float _e60 = warp(_e58, 0.05);
    float _e62 = profile(_e55, _e60, metal_tone_shape);
    Light _e65 = u_look.key;
    LitLayer _e68 = light_apply(_e65, vec4(1.0), _e62);
    vec4 _e73 = blend_alpha(_e49, _e68.color, _e68.tone, 0.8, true);
    Light _e76 = u_look.eye;
    mat3x3 _e80 = u_look.camera_from_world;
    Angle _e81 = parametrization_screen_aligned(_e76, surface_1.normal, _e80);
    float _e84 = transition(surface_1.kappa, 0.12);
    float _e86 = warp(_e84, 0.25);
    float _e88 = profile(_e81, _e86, contour_tone_shape);
    Light _e91 = u_look.eye;
    LitLayer _e94 = light_apply(_e91, vec4(1.0), _e88);
    vec4 _e99 = blend_multiply(_e73, _e94.color, _e94.tone, 1.0, true);
    vec3 _e101 = position_object(surface_1.position_object);
    VectorParts _e102 = separate_vector(_e101);
    float _e105 = minimum(_e102.x, _e102.z);
    float _e108 = threshold(_e105, -0.012, 0.0);
    vec4 _e116 = blend_alpha(_e99, vec4(0.8471, 0.1569, 0.1098, 1.0), _e108, 1.0, true);
    float _e119 = threshold(_e105, 0.02, 0.0);
    float _e120 = invert(_e119);
    vec4 _e121 = straight(_e116);
    vec4 _e122 = set_alpha(_e121, _e120);
    vec4 _e123 = premultiplied(_e122);
    vec4 _e124 = output_(_e123);
    return Shaded(surface_1.normal, _e124, 0.5);
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    bool local = false;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec4 _e10 = u_view.eye;
    float _e15 = u_view.eye.w;
    vec3 _e19 = normalize_or((_e10.xyz - (_e15 * in_.position)), _e7);
    if (!(is_front)) {
        local = (dot(_e7, _e19) < -0.1);
    } else {
        local = false;
    }
    bool is_behind = local;
    vec3 normal_3 = (is_behind ? -(_e7) : _e7);
    surface.normal = normal_3;
    vec4 _e35 = u_view.eye;
    float _e40 = u_view.eye.w;
    vec4 _e46 = u_view.eye;
    vec3 _e52 = normalize_or(_e46.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e53 = normalize_or((_e35.xyz - (_e40 * in_.position)), _e52);
    surface.view = _e53;
    surface.position_object = in_.position_object;
    surface.kappa = 0.0;
    Surface _e58 = surface;
    Shaded _e59 = shade(_e58);
    if ((_e59.color.w < _e59.cutoff)) {
        discard;
    }
    mat4x4 _e66 = u_view.camera_from_world;
    vec3 seen = (_e66 * vec4(_e59.value, 0.0)).xyz;
    mat4x4 _e74 = u_view.camera_from_world;
    float depth = -((_e74 * vec4(in_.position, 1.0)).z);
    float _e83 = u_object.id;
    Fragment _tmp_return = Fragment(vec4(seen, (_e83 + 1.0)), depth);
    out_normal = _tmp_return.normal;
    out_depth = _tmp_return.depth;
    return;
}

