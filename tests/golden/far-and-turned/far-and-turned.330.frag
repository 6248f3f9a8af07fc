#version 330 core
// Far and turned: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// far-and-turned.json says what to put there and how to draw.
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
    vec4 back_light_color_convex;
    Light back;
    ProfileShape back_light_tone_shape;
    vec4 highlight_color_convex;
    Light key;
    vec4 body_color_convex;
    ProfileShape body_tone_shape;
    vec4 shadow;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape highlight_tone_shape = ProfileShape(0.9971888, 0.07492971, 5.743557, 3.1871848, 0.15, 0.1556229, 0.06963291, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent_2 = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent_2), exponent_2));
}

float exp2_stable(float x) {
    float clamped_2 = clamp(x, -126.0, 127.99999);
    float whole = roundEven(clamped_2);
    float f = (clamped_2 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_1) {
    float clamped_3 = max(x_1, -126.0);
    float whole_1 = roundEven(clamped_3);
    float f_1 = (clamped_3 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float log2_stable(float x_2) {
    uint bits = floatBitsToUint(x_2);
    int exponent_3 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_3) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_3) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
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

vec3 normalize_moderate(vec3 v_1, vec3 otherwise) {
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
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
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
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

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
}

vec4 blend_alpha(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_1) {
    float a_1 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_1) * (1.0 - below_1.w)));
    vec4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_1, clamped_1);
    return _e20;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color_1.xyz * light.color) * _e4.y), color_1.w), (tone_1 * _e4.x));
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
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape) {
    float s_3 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
    if (((s_3 <= 0.0) || (shape.kind == PROFILE_AMBIENT))) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_3 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_2 = (s_3 * shape.scale);
    float _e27 = profile_power(q_2, shape.exponent);
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
    if (((is_wide_1 || (w <= 0.0)) || (shape_2.kind == PROFILE_AMBIENT))) {
        return _e3;
    }
    if (((shape_2.edge_deviation < 0.145) && (w >= (3.4641016 * shape_2.edge_deviation)))) {
        float width = sqrt(((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
        float _e36 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return clamp((0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e36)) / width)), 0.0, 1.0);
    }
    vec2 _e48 = sin_cos_tiny((0.19364917 * w));
    Angle _e49 = angle_turned(u_5, _e48);
    float _e50 = profile_point(_e49, shape_2);
    Angle _e55 = angle_turned(u_5, vec2(-(_e48.x), _e48.y));
    float _e56 = profile_point(_e55, shape_2);
    return ((((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0);
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

float profile(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned_2_(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_4);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_5);
    return _e8;
}

vec4 shade(Surface surface_1) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle body_angle = Angle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    ProfileShape _e23 = u_look.body_tone_shape;
    float _e24 = profile(body_angle, 0.0, _e23);
    Light _e27 = u_look.key;
    vec4 _e30 = u_look.body_color_convex;
    LitLayer _e31 = light_apply(_e27, _e30, _e24);
    vec4 _e34 = u_look.shadow;
    vec4 _e37 = u_look.shadow;
    vec4 _e44 = u_look.shadow;
    float _e52 = u_look.shadow.w;
    float _e60 = u_look.shadow.w;
    vec4 _e68 = blend_finish(_e34, (_e37.xyz + (_e31.tone * (_e31.color.xyz - _e44.xyz))), (_e52 + ((_e31.tone * _e31.color.w) * (1.0 - _e60))), _e31.color.w, true);
    Light _e71 = u_look.key;
    Angle _e74 = parametrization_specular(_e71, surface_1.normal, surface_1.view);
    float _e77 = profile_2_(_e74, 0.0, highlight_tone_shape);
    Light _e80 = u_look.key;
    vec4 _e83 = u_look.highlight_color_convex;
    LitLayer _e84 = light_apply(_e80, _e83, _e77);
    vec4 _e89 = blend_alpha(_e68, _e84.color, _e84.tone, 0.8, true);
    vec3 _e94 = u_look.back.direction;
    vec3 _e103 = u_look.back.direction;
    Angle back_light_angle = Angle((0.5 * length((surface_1.normal - _e94))), (0.5 * length((surface_1.normal + _e103))));
    ProfileShape _e112 = u_look.back_light_tone_shape;
    float _e113 = profile(back_light_angle, 0.0, _e112);
    Light _e116 = u_look.back;
    vec4 _e119 = u_look.back_light_color_convex;
    LitLayer _e120 = light_apply(_e116, _e119, _e113);
    vec4 _e131 = blend_finish(_e89, (_e89.xyz + (_e120.tone * _e120.color.xyz)), _e89.w, _e120.color.w, true);
    vec4 _e142 = finite_vec4_(((_e131.w <= 0.0) ? _e131 : vec4((_e131.xyz / vec3(_e131.w)), _e131.w)));
    return _e142;
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
    vec4 _e23 = finite_vec4_(_e22);
    out_color = _e23;
    return;
}

