#version 330 core
// Drawn, for contrast: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-drawn.json says what to put there and how to draw.
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
};
struct Surface {
    vec3 normal;
    vec3 view;
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
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const float LOG2_E = 1.442695;
const ProfileShape body_tone_shape = ProfileShape(0.86532396, 0.501213, 5.743557, 2.0104687, 1.05, 0.18576889, 0.077249795, 0u);
const ProfileShape window_tone_shape = ProfileShape(0.9887711, 0.14943813, 50.003334, 8.498813, 0.3, 0.011653547, 0.0057055796, 0u);
const ProfileShape rim_tone_shape = ProfileShape(0.9305076, 0.36627254, 10.016686, 2.4912605, 0.75, 0.09820393, 0.042312488, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float whole = roundEven(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_1) {
    float clamped_1 = max(x_1, -126.0);
    float whole_1 = roundEven(clamped_1);
    float f_1 = (clamped_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float log2_stable(float x_2) {
    uint bits = floatBitsToUint(x_2);
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

vec2 sin_cos_tiny(float x_3) {
    float y_2 = (x_3 * x_3);
    float s = (x_3 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334)))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * 0.0013888889))))));
    return vec2(s, c);
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y_1, float x_4) {
    float small = min(y_1, x_4);
    float large = max(y_1, x_4);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_4) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_1 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, c_1));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_2 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_2 = (u_2.half_cos + (u_2.half_sin * 0.0));
    vec2 upper_1 = ((c_2 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_2));
    vec2 turned_1 = (((s_2 <= 0.0) && (s_2 < c_2)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_specular(Light light_1, vec3 normal, vec3 view) {
    vec3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    vec3 _e8 = normalize_moderate(mirrored, normal);
    return Angle((0.5 * length((_e8 - light_1.direction))), (0.5 * length((_e8 + light_1.direction))));
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
    return min(_e21, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape) {
    float s_3 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
    if (((s_3 <= 0.0) || false)) {
        return 1.0;
    }
    float q_2 = (s_3 * shape.scale);
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
    float _e21 = exp2_stable_2_((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_2_(Angle u_4, ProfileShape shape_1) {
    float s_4 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
    if (((s_4 <= 0.0) || false)) {
        return 1.0;
    }
    float q_3 = (s_4 * shape_1.scale);
    float _e17 = profile_power_2_(q_3, shape_1.exponent);
    return _e17;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_2) {
    float _e3 = profile_point(u_5, shape_2);
    bool is_wide_1 = (w < (0.1 * shape_2.edge_deviation));
    if (((is_wide_1 || (w <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w >= (3.4641016 * shape_2.edge_deviation)))) {
        float width = sqrt(((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
        float _e32 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return clamp((0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e32)) / width)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w));
    Angle _e45 = angle_turned(u_5, _e44);
    float _e46 = profile_point(_e45, shape_2);
    Angle _e51 = angle_turned(u_5, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point(_e51, shape_2);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile_filtered_2_(Angle u_6, float w_1, ProfileShape shape_3) {
    float _e3 = profile_point_2_(u_6, shape_3);
    bool is_wide_2 = (w_1 < (0.1 * shape_3.edge_deviation));
    if (((is_wide_2 || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w_1 >= (3.4641016 * shape_3.edge_deviation)))) {
        float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
        float _e32 = atan2_positive(u_6.half_sin, u_6.half_cos);
        return clamp((0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e32)) / width_1)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e45 = angle_turned(u_6, _e44);
    float _e46 = profile_point_2_(_e45, shape_3);
    Angle _e51 = angle_turned(u_6, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point_2_(_e51, shape_3);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile_filtered_3_(Angle u_7, float w_2, ProfileShape shape_4) {
    float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_3 = (w_2 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_3 || (w_2 <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w_2 >= (3.4641016 * shape_4.edge_deviation)))) {
        float width_2 = sqrt(((w_2 * w_2) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
        float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return clamp((0.5 + (((0.75 + shape_4.edge_mean) - (2.0 * _e32)) / width_2)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w_2));
    Angle _e45 = angle_turned(u_7, _e44);
    float _e46 = profile_point_2_(_e45, shape_4);
    Angle _e51 = angle_turned(u_7, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point_2_(_e51, shape_4);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_5) {
    Angle _e6 = angle_turned_2_(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_5);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_6) {
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_6);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_7) {
    Angle _e6 = angle_turned_2_(angle_2, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_7);
    return _e8;
}

vec4 shade(Surface surface_1) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle body_angle = Angle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    float _e22 = profile(body_angle, 0.0, body_tone_shape);
    Light _e25 = u_look.key;
    LitLayer _e31 = light_apply(_e25, vec4(0.2471, 0.4863, 0.7686, 1.0), _e22);
    vec4 _e41 = blend_alpha(vec4(0.1333, 0.1882, 0.3098, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = u_look.key;
    Angle _e47 = parametrization_specular(_e44, surface_1.normal, surface_1.view);
    float _e50 = profile_2_(_e47, 0.0, window_tone_shape);
    Light _e53 = u_look.key;
    LitLayer _e59 = light_apply(_e53, vec4(0.9686, 0.9843, 1.0, 1.0), _e50);
    vec4 window_blend = clamp(vec4((_e41.xyz + (_e59.tone * (_e59.color.xyz - _e41.xyz))), 1.0), vec4(0.0), vec4(1.0));
    vec3 _e79 = u_look.back.direction;
    vec3 _e88 = u_look.back.direction;
    Angle rim_angle = Angle((0.5 * length((surface_1.normal - _e79))), (0.5 * length((surface_1.normal + _e88))));
    float _e96 = profile_3_(rim_angle, 0.0, rim_tone_shape);
    Light _e99 = u_look.back;
    LitLayer _e105 = light_apply(_e99, vec4(0.2314, 0.3725, 0.5255, 1.0), _e96);
    vec4 output_ = clamp(vec4((window_blend.xyz + (_e105.tone * _e105.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0));
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_1;
    vec4 _e11 = u_view.eye;
    float _e16 = u_view.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    Surface _e21 = surface;
    vec4 _e22 = shade(_e21);
    out_color = _e22;
    return;
}

