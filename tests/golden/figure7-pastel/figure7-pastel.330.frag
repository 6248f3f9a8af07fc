#version 330 core
// Pastel: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure7-pastel.json says what to put there and how to draw.
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
struct Look {
    Light back;
    Light key;
    float light_warp_amount;
    ProfileShape light_tone_shape;
    float shade_warp_amount;
    Light cool;
    ProfileShape shade_tone_shape;
    float shade_blend_opacity;
    float light_blend_opacity;
    float reddish_rim_blend_opacity;
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
struct LitLayer {
    vec4 color;
    float tone;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape white_chalk_tone_shape = ProfileShape(0.99875027, 0.04997917, 3.1317647, 2.7420828, 0.1, 0.3043368, 0.13399889, 0u);
const ProfileShape reddish_rim_tone_shape = ProfileShape(0.9887711, 0.14943813, 2.5679324, 1.9696738, 0.3, 0.42241916, 0.17683415, 0u);

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

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent_3 = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent_3), exponent_3));
}

float exp2_stable(float x_2) {
    float clamped_3 = clamp(x_2, -126.0, 127.99999);
    float whole = roundEven(clamped_3);
    float f = (clamped_3 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_3) {
    float clamped_4 = max(x_3, -126.0);
    float whole_1 = roundEven(clamped_4);
    float f_1 = (clamped_4 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float exp2_stable_3_(float x_4) {
    float whole_2 = roundEven(x_4);
    float f_2 = (x_4 - whole_2);
    float twice_2 = (2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724))))))))))));
    return (twice_2 * uintBitsToFloat((uint((int(whole_2) + 126)) << 23u)));
}

float log2_stable(float x_5) {
    uint bits = floatBitsToUint(x_5);
    int exponent_4 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_4) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_4) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_quarter(float x_6) {
    float h = (0.5 * x_6);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

vec2 sin_cos_eighth(float x_7) {
    float y_2 = (x_7 * x_7);
    float s_1 = (x_7 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c_1 = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return vec2(s_1, c_1);
}

vec2 sin_cos_tiny(float x_8) {
    float y_3 = (x_8 * x_8);
    float s_2 = (x_8 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334)))));
    float c_2 = (1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889))))));
    return vec2(s_2, c_2);
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * inversesqrt(max(square, 1e-30))) : otherwise_1);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y_1, float x_9) {
    float small = min(y_1, x_9);
    float large = max(y_1, x_9);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_9) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_3, 0.5);
    return min(_e13, 0.5);
}

float angle_footprint_2_(Angle u_1) {
    vec2 half_1 = vec2(u_1.half_sin, u_1.half_cos);
    vec2 dx_1 = dFdx(half_1);
    vec2 dy_1 = dFdy(half_1);
    float w_4 = (2.0 * sqrt((dot(dx_1, dx_1) + dot(dy_1, dy_1))));
    return min(w_4, 0.5);
}

Angle angle_turned(Angle u_2, vec2 t) {
    float s_3 = ((u_2.half_sin * t.y) - (u_2.half_cos * t.x));
    float c_3 = ((u_2.half_cos * t.y) + (u_2.half_sin * t.x));
    vec2 upper = ((c_3 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_3));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < c_3)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float curvature_signed(float kappa, float slope) {
    float a_1 = ((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope);
    float magnitude = min(abs(a_1), 50.0);
    if ((magnitude < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e32 = exp2_stable((-2.88539 * magnitude));
    float t_2 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
}

vec4 blend_alpha(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_1) {
    float alpha_1 = (below_1.w + ((tone * opacity_1) * (1.0 - below_1.w)));
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone * (color.xyz - below_1.xyz))) - below_1.xyz))), alpha_1), vec4(0.0), vec4(1.0));
}

vec4 blend_shade(vec4 below_2, vec4 color_1, float tone_1, float opacity_2, bool clamped_2) {
    return clamp(vec4((below_2.xyz + (opacity_2 * ((below_2.xyz * mix(vec3(1.0), color_1.xyz, tone_1)) - below_2.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_2, float tone_2) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light.color) * split.y), 1.0), split.x);
}

LitLayer light_apply_2_(Light light_1, vec4 color_3, float tone_3) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_3.xyz * light_1.color) * split_1.y), 1.0), (tone_3 * split_1.x));
}

Angle parametrization_specular(Light light_2, vec3 normal, vec3 view) {
    vec3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    vec3 _e8 = normalize_moderate(mirrored, normal);
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
    float _e21 = exp2_stable((exponent * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape) {
    float s_4 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
    if (((s_4 <= 0.0) || (shape.kind == PROFILE_AMBIENT))) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_4 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_3 = (s_4 * shape.scale);
    float _e27 = profile_power(q_3, shape.exponent);
    return _e27;
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
    float _e21 = exp2_stable_2_((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_2_(Angle u_4, ProfileShape shape_1) {
    float s_5 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
    if (((s_5 <= 0.0) || false)) {
        return 1.0;
    }
    float q_4 = (s_5 * shape_1.scale);
    float _e17 = profile_power_2_(q_4, shape_1.exponent);
    return _e17;
}

float profile_power_3_(float q_2, float exponent_2) {
    float log_base_2 = 0.0;
    if ((q_2 >= 1.0)) {
        return 0.0;
    }
    if ((q_2 < 0.5)) {
        float _e11 = log1p_negative_small((q_2 * q_2));
        log_base_2 = (LOG2_E * _e11);
    } else {
        float _e18 = log2_stable(((1.0 - q_2) * (1.0 + q_2)));
        log_base_2 = _e18;
    }
    float _e19 = log_base_2;
    float _e21 = exp2_stable_3_((exponent_2 * _e19));
    return min(_e21, 1.0);
}

float profile_point_3_(Angle u_5, ProfileShape shape_2) {
    float s_6 = ((u_5.half_sin * shape_2.half_cos_offset) - (u_5.half_cos * shape_2.half_sin_offset));
    if (((s_6 <= 0.0) || false)) {
        return 1.0;
    }
    float q_5 = (s_6 * shape_2.scale);
    float _e17 = profile_power_3_(q_5, shape_2.exponent);
    return _e17;
}

float profile_filtered(Angle u_6, float w, ProfileShape shape_3) {
    float _e3 = profile_point(u_6, shape_3);
    bool is_wide_1 = (w < (0.1 * shape_3.edge_deviation));
    if (((is_wide_1 || (w <= 0.0)) || (shape_3.kind == PROFILE_AMBIENT))) {
        return _e3;
    }
    if (((shape_3.edge_deviation < 0.145) && (w >= (3.4641016 * shape_3.edge_deviation)))) {
        float width = sqrt(((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
        float _e36 = atan2_positive(u_6.half_sin, u_6.half_cos);
        return clamp((0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e36)) / width)), 0.0, 1.0);
    }
    vec2 _e48 = sin_cos_tiny((0.19364917 * w));
    Angle _e49 = angle_turned(u_6, _e48);
    float _e50 = profile_point(_e49, shape_3);
    Angle _e55 = angle_turned(u_6, vec2(-(_e48.x), _e48.y));
    float _e56 = profile_point(_e55, shape_3);
    return ((((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_2_(Angle u_7, float w_1, ProfileShape shape_4) {
    float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_2 = (w_1 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_2 || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w_1 >= (3.4641016 * shape_4.edge_deviation)))) {
        float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
        float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return clamp((0.5 + (((shape_4.offset + shape_4.edge_mean) - (2.0 * _e32)) / width_1)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e45 = angle_turned(u_7, _e44);
    float _e46 = profile_point_2_(_e45, shape_4);
    Angle _e51 = angle_turned(u_7, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point_2_(_e51, shape_4);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile_filtered_3_(Angle u_8, float w_2, ProfileShape shape_5) {
    float _e3 = profile_point_3_(u_8, shape_5);
    bool is_wide_3 = (w_2 < (0.1 * shape_5.edge_deviation));
    if (((is_wide_3 || (w_2 <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w_2));
    Angle _e16 = angle_turned(u_8, _e15);
    float _e17 = profile_point_3_(_e16, shape_5);
    Angle _e22 = angle_turned(u_8, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point_3_(_e22, shape_5);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_6) {
    vec2 _e8 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    Angle _e9 = angle_turned(angle, _e8);
    float _e10 = angle_footprint(_e9);
    float _e11 = profile_filtered(_e9, _e10, shape_6);
    return _e11;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_7) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint_2_(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_8) {
    vec2 _e5 = sin_cos_tiny((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint_2_(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed(surface_1.kappa, 0.14);
    float light_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(light_convexity, vec4(0.9647, 0.9059, 0.8157, 1.0), vec4(0.6118, 0.2902, 0.1961, 1.0));
    Light _e21 = u_look.key;
    LitLayer _e23 = light_apply(_e21, _e18, 1.0);
    vec4 _e33 = blend_shade(vec4(0.9137, 0.8627, 0.7765, 1.0), _e23.color, _e23.tone, 0.9, true);
    vec4 _e44 = curvature_color(light_convexity, vec4(0.7686, 0.4157, 0.2824, 1.0), vec4(0.4863, 0.1765, 0.1216, 1.0));
    vec3 _e49 = u_look.cool.direction;
    vec3 _e58 = u_look.cool.direction;
    Angle shade_angle = Angle((0.5 * length((surface_1.normal - _e49))), (0.5 * length((surface_1.normal + _e58))));
    float _e70 = u_look.shade_warp_amount;
    float shade_warp = (((2.0 * light_convexity) - 1.0) * clamp(_e70, -3.1415927, 3.1415927));
    ProfileShape _e77 = u_look.shade_tone_shape;
    float _e78 = profile(shade_angle, shade_warp, _e77);
    Light _e81 = u_look.cool;
    LitLayer _e82 = light_apply_2_(_e81, _e44, _e78);
    float _e94 = u_look.shade_blend_opacity;
    vec4 _e96 = blend_finish(_e33, (_e33.xyz * mix(vec3(1.0), _e82.color.xyz, _e82.tone)), 1.0, _e94, true);
    vec4 _e107 = curvature_color(light_convexity, vec4(1.0, 0.9725, 0.9176, 1.0), vec4(0.9098, 0.7059, 0.5686, 1.0));
    vec3 _e112 = u_look.key.direction;
    vec3 _e121 = u_look.key.direction;
    Angle light_angle = Angle((0.5 * length((surface_1.normal - _e112))), (0.5 * length((surface_1.normal + _e121))));
    float _e133 = u_look.light_warp_amount;
    float light_warp = (((2.0 * light_convexity) - 1.0) * clamp(_e133, -3.1415927, 3.1415927));
    ProfileShape _e140 = u_look.light_tone_shape;
    float _e141 = profile(light_angle, light_warp, _e140);
    Light _e144 = u_look.key;
    LitLayer _e145 = light_apply_2_(_e144, _e107, _e141);
    float _e157 = u_look.light_blend_opacity;
    float _e165 = u_look.light_blend_opacity;
    vec4 _e167 = blend_finish(_e96, (_e96.xyz + (_e145.tone * (_e145.color.xyz - _e96.xyz))), (1.0 + ((_e145.tone * _e157) * 0.0)), _e165, true);
    float _e170 = curvature_signed(surface_1.kappa, 0.3);
    float white_chalk_convexity = (0.5 + (0.5 * _e170));
    vec4 _e182 = curvature_color(white_chalk_convexity, vec4(1.0), vec4(1.0, 0.9412, 0.8627, 1.0));
    Light _e185 = u_look.key;
    Angle _e188 = parametrization_specular(_e185, surface_1.normal, surface_1.view);
    float white_chalk_warp = (((2.0 * white_chalk_convexity) - 1.0) * 0.3);
    float _e196 = profile_2_(_e188, white_chalk_warp, white_chalk_tone_shape);
    Light _e199 = u_look.key;
    LitLayer _e200 = light_apply_2_(_e199, _e182, _e196);
    vec4 _e205 = blend_alpha(_e167, _e200.color, _e200.tone, 0.85, true);
    float _e208 = curvature_signed(surface_1.kappa, 0.2);
    float reddish_rim_convexity = (0.5 + (0.5 * _e208));
    vec4 _e223 = curvature_color(reddish_rim_convexity, vec4(0.7059, 0.3294, 0.2275, 1.0), vec4(0.4784, 0.1647, 0.1098, 1.0));
    vec3 _e228 = u_look.back.direction;
    vec3 _e237 = u_look.back.direction;
    Angle reddish_rim_angle = Angle((0.5 * length((surface_1.normal - _e228))), (0.5 * length((surface_1.normal + _e237))));
    float reddish_rim_warp = (((2.0 * reddish_rim_convexity) - 1.0) * 0.1);
    float _e250 = profile_3_(reddish_rim_angle, reddish_rim_warp, reddish_rim_tone_shape);
    Light _e253 = u_look.back;
    LitLayer _e254 = light_apply_2_(_e253, _e223, _e250);
    float _e266 = u_look.reddish_rim_blend_opacity;
    vec4 _e268 = blend_finish(_e205, (_e205.xyz * mix(vec3(1.0), _e254.color.xyz, _e254.tone)), _e205.w, _e266, true);
    vec4 _e279 = finite_vec4_(((_e268.w <= 0.0) ? _e268 : vec4((_e268.xyz / vec3(_e268.w)), _e268.w)));
    return _e279;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_1;
    vec4 _e11 = u_view.eye;
    float _e16 = u_view.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    vec4 _e27 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e27.x;
    Surface _e29 = surface;
    vec4 _e30 = shade(_e29);
    vec4 _e31 = finite_vec4_(_e30);
    out_color = _e31;
    return;
}

