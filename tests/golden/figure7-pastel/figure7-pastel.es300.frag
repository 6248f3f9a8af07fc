#version 300 es
// Pastel: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure7-pastel.json says what to put there and how to draw.

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
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape white_chalk_tone_shape = ProfileShape(0.99875027, 0.04997917, 3.1317647, 2.7420828, 0.1, 0.3043368, 0.13399889, 0u);
const ProfileShape reddish_rim_tone_shape = ProfileShape(0.9887711, 0.14943813, 2.5679324, 1.9696738, 0.3, 0.42241916, 0.17683415, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

vec2 sin_cos_quick(float x) {
    float y_1 = (x * x);
    float s_4 = (x * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return vec2(s_4, c);
}

float log2_one_minus(float y) {
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_5 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_5, c_1));
    vec2 turned = (((s_5 <= 0.0) && (s_5 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope) {
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
}

vec4 blend_alpha(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone * (color.xyz - below_1.xyz))) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_shade(vec4 below_2, vec4 color_1, float tone_1, float opacity_2, bool clamped_2) {
    return clamp(vec4((below_2.xyz + (opacity_2 * ((below_2.xyz * mix(vec3(1.0), color_1.xyz, tone_1)) - below_2.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_2, float tone_2) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light.color) * split.y), 1.0), (tone_2 * split.x));
}

Angle parametrization_diffuse_balanced(Light light_1, vec3 normal) {
    return Angle((0.5 * length((normal - light_1.direction))), (0.5 * length((normal + light_1.direction))));
}

Angle parametrization_specular_balanced(Light light_2, vec3 normal_1, vec3 view) {
    vec3 d = (((2.0 * dot(normal_1, view)) * normal_1) - view);
    return Angle((0.5 * length((d - light_2.direction))), (0.5 * length((d + light_2.direction))));
}

float profile_power_quick(float q, float exponent) {
    float y_2 = min((q * q), 1.0);
    float _e5 = log2_one_minus(y_2);
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

float profile_filtered_quick_3_(Angle u_5, float w_4, ProfileShape shape_7) {
    vec2 place_1 = vec2(((u_5.half_sin * shape_7.half_cos_offset) - (u_5.half_cos * shape_7.half_sin_offset)), ((u_5.half_cos * shape_7.half_cos_offset) + (u_5.half_sin * shape_7.half_sin_offset)));
    float _e19 = profile_soft_quick_2_(place_1.x, shape_7);
    if ((w_4 < (0.1 * shape_7.edge_deviation))) {
        return _e19;
    }
    float r_2 = (0.19364917 * w_4);
    vec2 turn_2 = vec2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    float _e45 = profile_soft_quick_2_(((place_1.x * turn_2.y) - (place_1.y * turn_2.x)), shape_7);
    float _e53 = profile_soft_quick_2_(((place_1.x * turn_2.y) + (place_1.y * turn_2.x)), shape_7);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_8) {
    vec2 _e8 = sin_cos_quick((0.5 * clamp(shift, -3.1415927, PI)));
    Angle _e9 = angle_turned(angle, _e8);
    float _e10 = angle_footprint(_e9);
    float _e11 = profile_filtered_quick(_e9, _e10, shape_8);
    return _e11;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_9) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_9);
    return _e8;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_10) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_10);
    return _e8;
}

vec4 shade(Surface surface) {
    float _e3 = transition_balanced(surface.kappa, 0.14);
    vec4 _e14 = curvature_color(_e3, vec4(0.9647, 0.9059, 0.8157, 1.0), vec4(0.6118, 0.2902, 0.1961, 1.0));
    Light _e17 = u_look.key;
    LitLayer _e19 = light_apply(_e17, _e14, 1.0);
    vec4 _e29 = blend_shade(vec4(0.9137, 0.8627, 0.7765, 1.0), _e19.color, _e19.tone, 0.9, true);
    vec4 _e40 = curvature_color(_e3, vec4(0.7686, 0.4157, 0.2824, 1.0), vec4(0.4863, 0.1765, 0.1216, 1.0));
    Light _e43 = u_look.cool;
    Angle _e45 = parametrization_diffuse_balanced(_e43, surface.normal);
    float _e52 = u_look.shade_warp_amount;
    float shade_warp = (((2.0 * _e3) - 1.0) * clamp(_e52, -3.1415927, 3.1415927));
    ProfileShape _e59 = u_look.shade_tone_shape;
    float _e60 = profile_balanced(_e45, shade_warp, _e59);
    Light _e63 = u_look.cool;
    LitLayer _e64 = light_apply(_e63, _e40, _e60);
    float _e76 = u_look.shade_blend_opacity;
    vec4 _e78 = blend_finish(_e29, (_e29.xyz * mix(vec3(1.0), _e64.color.xyz, _e64.tone)), 1.0, _e76, true);
    vec4 _e89 = curvature_color(_e3, vec4(1.0, 0.9725, 0.9176, 1.0), vec4(0.9098, 0.7059, 0.5686, 1.0));
    Light _e92 = u_look.key;
    Angle _e94 = parametrization_diffuse_balanced(_e92, surface.normal);
    float _e101 = u_look.light_warp_amount;
    float light_warp = (((2.0 * _e3) - 1.0) * clamp(_e101, -3.1415927, 3.1415927));
    ProfileShape _e108 = u_look.light_tone_shape;
    float _e109 = profile_balanced(_e94, light_warp, _e108);
    Light _e112 = u_look.key;
    LitLayer _e113 = light_apply(_e112, _e89, _e109);
    float _e125 = u_look.light_blend_opacity;
    vec4 _e127 = blend_finish(_e78, (_e78.xyz + (_e113.tone * (_e113.color.xyz - _e78.xyz))), 1.0, _e125, true);
    float _e130 = transition_balanced(surface.kappa, 0.3);
    vec4 _e138 = curvature_color(_e130, vec4(1.0), vec4(1.0, 0.9412, 0.8627, 1.0));
    Light _e141 = u_look.key;
    Angle _e144 = parametrization_specular_balanced(_e141, surface.normal, surface.view);
    float white_chalk_warp = (((2.0 * _e130) - 1.0) * 0.3);
    float _e152 = profile_balanced_2_(_e144, white_chalk_warp, white_chalk_tone_shape);
    Light _e155 = u_look.key;
    LitLayer _e156 = light_apply(_e155, _e138, _e152);
    vec4 _e161 = blend_alpha(_e127, _e156.color, _e156.tone, 0.85, true);
    float _e164 = transition_balanced(surface.kappa, 0.2);
    vec4 _e175 = curvature_color(_e164, vec4(0.7059, 0.3294, 0.2275, 1.0), vec4(0.4784, 0.1647, 0.1098, 1.0));
    Light _e178 = u_look.back;
    Angle _e180 = parametrization_diffuse_balanced(_e178, surface.normal);
    float reddish_rim_warp = (((2.0 * _e164) - 1.0) * 0.1);
    float _e188 = profile_balanced_3_(_e180, reddish_rim_warp, reddish_rim_tone_shape);
    Light _e191 = u_look.back;
    LitLayer _e192 = light_apply(_e191, _e175, _e188);
    float _e204 = u_look.reddish_rim_blend_opacity;
    vec4 _e206 = blend_finish(_e161, (_e161.xyz * mix(vec3(1.0), _e192.color.xyz, _e192.tone)), 1.0, _e204, true);
    return _e206;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e23 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x);
    vec4 _e26 = shade(surface_1);
    out_color = _e26;
    return;
}

