#version 300 es
// Far and turned: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// far-and-turned.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
    uvec4 exponent_1 = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent_1), exponent_1));
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

float log2_one_minus(float y) {
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_4 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_4, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_4 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_4, u_1.half_cos));
    vec2 turned = (((s_4 <= 0.0) && (s_4 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
}

vec4 blend_alpha(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_1) {
    float a = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a) * (1.0 - below_1.w)));
    vec4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a, clamped_1);
    return _e20;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color_1.xyz * light.color) * _e4.y), color_1.w), (tone_1 * _e4.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
}

float profile_power_quick(float q, float exponent) {
    float y_1 = min((q * q), 1.0);
    float _e5 = log2_one_minus(y_1);
    float power = exp2(max((exponent * _e5), -126.0));
    return ((q >= 1.0) ? 0.0 : clamp(power, 0.0, 1.0));
}

vec2 profile_place(Angle u_2, ProfileShape shape) {
    return vec2(((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset)), ((u_2.half_cos * shape.half_cos_offset) + (u_2.half_sin * shape.half_sin_offset)));
}

float profile_soft_quick(float s, ProfileShape shape_1) {
    float _e5 = profile_power_quick((s * shape_1.scale), shape_1.exponent);
    return ((s <= 0.0) ? 1.0 : _e5);
}

float profile_soft_quick_2_(float s_1, ProfileShape shape_2) {
    float q_1 = (s_1 * shape_2.scale);
    return ((s_1 <= 0.0) ? 1.0 : pow(max((1.0 - (q_1 * q_1)), 0.0), shape_2.exponent));
}

float profile_ramp_quick(float s_2, float w, ProfileShape shape_3) {
    float width = sqrt(((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
    float from_offset = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_3.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_3, float w_1, ProfileShape shape_4) {
    float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
    float from_offset_1 = (s_3 * (2.0 + ((s_3 * s_3) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((shape_4.edge_mean - from_offset_1) / width_1)), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_3 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_3, float w_2, ProfileShape shape_5) {
    if ((shape_5.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    vec2 _e7 = profile_place(u_3, shape_5);
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_5.edge_deviation)));
    if (((shape_5.kind == PROFILE_STEP) || is_narrow)) {
        float _e20 = profile_ramp_quick(_e7.x, w_2, shape_5);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_5);
    if ((w_2 < (0.1 * shape_5.edge_deviation))) {
        return _e22;
    }
    float r = (0.19364917 * w_2);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_5);
    float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_5);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_4, float w_3, ProfileShape shape_6) {
    vec2 place = vec2(((u_4.half_sin * shape_6.half_cos_offset) - (u_4.half_cos * shape_6.half_sin_offset)), ((u_4.half_cos * shape_6.half_cos_offset) + (u_4.half_sin * shape_6.half_sin_offset)));
    bool is_narrow_1 = ((w_3 > 0.0) && (w_3 >= (3.4641016 * shape_6.edge_deviation)));
    if ((false || is_narrow_1)) {
        float _e28 = profile_ramp_quick_2_(place.x, w_3, shape_6);
        return _e28;
    }
    float _e30 = profile_soft_quick_2_(place.x, shape_6);
    if ((w_3 < (0.1 * shape_6.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_3);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e56 = profile_soft_quick_2_(((place.x * turn_1.y) - (place.y * turn_1.x)), shape_6);
    float _e64 = profile_soft_quick_2_(((place.x * turn_1.y) + (place.y * turn_1.x)), shape_6);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_7) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_7);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_8) {
    Angle _e6 = angle_turned(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_8);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle body_angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    ProfileShape _e23 = u_look.body_tone_shape;
    float _e24 = profile_balanced(body_angle, 0.0, _e23);
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
    Angle _e74 = parametrization_specular_balanced(_e71, surface.normal, surface.view);
    float _e77 = profile_balanced_2_(_e74, 0.0, highlight_tone_shape);
    Light _e80 = u_look.key;
    vec4 _e83 = u_look.highlight_color_convex;
    LitLayer _e84 = light_apply(_e80, _e83, _e77);
    vec4 _e89 = blend_alpha(_e68, _e84.color, _e84.tone, 0.8, true);
    vec3 _e94 = u_look.back.direction;
    vec3 _e103 = u_look.back.direction;
    Angle back_light_angle = Angle((0.5 * length((surface.normal - _e94))), (0.5 * length((surface.normal + _e103))));
    ProfileShape _e112 = u_look.back_light_tone_shape;
    float _e113 = profile_balanced(back_light_angle, 0.0, _e112);
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
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))));
    vec4 _e19 = shade(surface_1);
    vec4 _e20 = finite_vec4_(_e19);
    out_color = _e20;
    return;
}

