#version 300 es
// Beetle: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure7-beetle.json says what to put there and how to draw.

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
    vec4 hollows_color_concave;
    Light key;
    vec4 green_sheen_color_convex;
    vec4 gold_color_convex;
    Light side;
    vec4 wing_case_color_convex;
    vec4 wing_case_color_concave;
    ProfileShape wing_case_tone_shape;
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
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape violet_tone_shape = ProfileShape(0.98472655, 0.17410813, 2.425296, 2.1444545, 0.35, 0.43399706, 0.1847509, 0u);
const ProfileShape gold_tone_shape = ProfileShape(0.9887711, 0.14943813, 3.6826046, 2.8423793, 0.3, 0.2547288, 0.11251208, 0u);
const ProfileShape green_sheen_tone_shape = ProfileShape(0.99820054, 0.059964005, 5.2949586, 2.6937559, 0.12, 0.1805348, 0.07889118, 0u);
const ProfileShape glint_tone_shape = ProfileShape(0.99955004, 0.029995501, 25.006668, 2.4986002, 0.06, 0.039271776, 0.016918294, 0u);

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

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
}

vec4 blend_add(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_1) {
    vec4 _e11 = blend_finish(below_1, (below_1.xyz + (tone * color.xyz)), 1.0, color.w, clamped_1);
    return _e11;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color_1.xyz * light.color) * _e4.y), color_1.w), (tone_1 * _e4.x));
}

LitLayer light_apply_2_(Light light_1, vec4 color_2, float tone_2) {
    vec2 split = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light_1.color) * split.y), 1.0), (tone_2 * split.x));
}

LitLayer light_apply_3_(Light light_2, vec4 color_3, float tone_3) {
    vec2 split_1 = vec2(min(light_2.intensity, 1.0), max(light_2.intensity, 1.0));
    return LitLayer(vec4(((color_3.xyz * light_2.color) * split_1.y), color_3.w), split_1.x);
}

Angle parametrization_specular_balanced(Light light_3, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_3.direction))), (0.5 * length((d + light_3.direction))));
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
    float _e19 = profile_soft_quick_2_(place.x, shape_6);
    if ((w_3 < (0.1 * shape_6.edge_deviation))) {
        return _e19;
    }
    float r_1 = (0.19364917 * w_3);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e45 = profile_soft_quick_2_(((place.x * turn_1.y) - (place.y * turn_1.x)), shape_6);
    float _e53 = profile_soft_quick_2_(((place.x * turn_1.y) + (place.y * turn_1.x)), shape_6);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_5, float w_4, ProfileShape shape_7) {
    vec2 place_1 = vec2(((u_5.half_sin * shape_7.half_cos_offset) - (u_5.half_cos * shape_7.half_sin_offset)), ((u_5.half_cos * shape_7.half_cos_offset) + (u_5.half_sin * shape_7.half_sin_offset)));
    bool is_narrow_1 = ((w_4 > 0.0) && (w_4 >= (3.4641016 * shape_7.edge_deviation)));
    if ((false || is_narrow_1)) {
        float _e28 = profile_ramp_quick_2_(place_1.x, w_4, shape_7);
        return _e28;
    }
    float _e30 = profile_soft_quick_2_(place_1.x, shape_7);
    if ((w_4 < (0.1 * shape_7.edge_deviation))) {
        return _e30;
    }
    float r_2 = (0.19364917 * w_4);
    vec2 turn_2 = vec2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    float _e56 = profile_soft_quick_2_(((place_1.x * turn_2.y) - (place_1.y * turn_2.x)), shape_7);
    float _e64 = profile_soft_quick_2_(((place_1.x * turn_2.y) + (place_1.y * turn_2.x)), shape_7);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_8) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_8);
    return _e8;
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
    float glint_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.2), -20.0, 20.0))))))));
    vec4 _e22 = u_look.wing_case_color_concave;
    vec4 _e25 = u_look.wing_case_color_convex;
    vec4 _e28 = u_look.wing_case_color_concave;
    vec4 wing_case_color = (_e22 + (glint_convexity * (_e25 - _e28)));
    vec3 _e36 = u_look.key.direction;
    vec3 _e45 = u_look.key.direction;
    Angle hollows_angle = Angle((0.5 * length((surface.normal - _e36))), (0.5 * length((surface.normal + _e45))));
    float wing_case_warp = (((2.0 * glint_convexity) - 1.0) * 0.2);
    ProfileShape _e59 = u_look.wing_case_tone_shape;
    float _e60 = profile_balanced(hollows_angle, wing_case_warp, _e59);
    Light _e63 = u_look.key;
    LitLayer _e64 = light_apply(_e63, wing_case_color, _e60);
    vec4 _e74 = blend_add(vec4(0.0157, 0.0627, 0.0392, 1.0), _e64.color, _e64.tone, 1.0, true);
    vec4 _e85 = curvature_color(glint_convexity, vec4(0.3529, 0.1647, 0.4314, 1.0), vec4(0.1098, 0.0627, 0.251, 1.0));
    Light _e88 = u_look.side;
    Angle _e91 = parametrization_specular_balanced(_e88, surface.normal, surface.view);
    float gold_warp = (((2.0 * glint_convexity) - 1.0) * 0.15);
    float _e99 = profile_balanced_2_(_e91, gold_warp, violet_tone_shape);
    Light _e102 = u_look.side;
    LitLayer _e103 = light_apply_2_(_e102, _e85, _e99);
    vec4 violet_blend = clamp(vec4((_e74.xyz + (_e103.tone * _e103.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e119 = u_look.gold_color_convex;
    vec4 _e125 = curvature_color(glint_convexity, _e119, vec4(0.2902, 0.3529, 0.0627, 1.0));
    Light _e128 = u_look.key;
    Angle _e131 = parametrization_specular_balanced(_e128, surface.normal, surface.view);
    float _e133 = profile_balanced_3_(_e131, gold_warp, gold_tone_shape);
    Light _e136 = u_look.key;
    LitLayer _e137 = light_apply(_e136, _e125, _e133);
    vec4 _e148 = blend_finish(violet_blend, (violet_blend.xyz + (_e137.tone * _e137.color.xyz)), 1.0, _e137.color.w, true);
    vec4 _e151 = u_look.green_sheen_color_convex;
    vec4 _e157 = curvature_color(glint_convexity, _e151, vec4(0.1647, 0.5412, 0.3529, 1.0));
    float green_sheen_warp = (((2.0 * glint_convexity) - 1.0) * 0.1);
    float _e165 = profile_balanced_3_(_e131, green_sheen_warp, green_sheen_tone_shape);
    Light _e168 = u_look.key;
    LitLayer _e169 = light_apply(_e168, _e157, _e165);
    vec4 _e180 = blend_finish(_e148, (_e148.xyz + (_e169.tone * _e169.color.xyz)), 1.0, _e169.color.w, true);
    vec4 _e188 = curvature_color(glint_convexity, vec4(1.0), vec4(0.8471, 1.0, 0.8784, 1.0));
    float glint_warp = (((2.0 * glint_convexity) - 1.0) * 0.05);
    float _e196 = profile_balanced_3_(_e131, glint_warp, glint_tone_shape);
    Light _e199 = u_look.key;
    LitLayer _e200 = light_apply_2_(_e199, _e188, _e196);
    vec4 glint_blend = clamp(vec4((_e180.xyz + (_e200.tone * (_e200.color.xyz - _e180.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float hollows_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.3), -20.0, 20.0))))))));
    vec4 _e237 = u_look.hollows_color_concave;
    vec4 _e242 = u_look.hollows_color_concave;
    vec4 hollows_color = (_e237 + (hollows_convexity * (vec4(1.0) - _e242)));
    Light _e248 = u_look.key;
    LitLayer _e250 = light_apply_3_(_e248, hollows_color, 1.0);
    vec4 _e261 = blend_finish(glint_blend, (glint_blend.xyz * (_e250.tone * _e250.color.xyz)), 1.0, _e250.color.w, true);
    return _e261;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e23 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x);
    vec4 _e26 = shade(surface_1);
    out_color = _e26;
    return;
}

