#version 330 core
// Dual lighting, soft: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-dual-soft.json says what to put there and how to draw.
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
    Light warm;
    Light cool;
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
const ProfileShape warm_side_tone_shape = ProfileShape(0.9971888, 0.07492971, 1.3940078, 1.4345639, 0.15, 0.90231395, 0.36981526, 0u);
const ProfileShape cool_side_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.5079876, 1.4054453, 0.1, 0.83293223, 0.33645248, 0u);
const ProfileShape sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

vec2 sin_cos_quick(float x) {
    float y = (x * x);
    float s_2 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return vec2(s_2, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_1));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope) {
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
}

vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * color.xyz)), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1) {
    float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_2) {
    vec2 place = vec2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
    float _e19 = profile_soft_quick(place.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_2, ProfileShape shape_3) {
    vec2 place_1 = vec2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place_1.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_2);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e56 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_3);
    float _e64 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

vec4 shade(Surface surface) {
    float _e3 = transition_balanced(surface.kappa, 0.25);
    vec4 _e14 = curvature_color(_e3, vec4(0.1137, 0.0941, 0.1333, 1.0), vec4(0.0392, 0.0314, 0.0549, 1.0));
    Light _e17 = u_look.warm;
    LitLayer _e19 = light_apply(_e17, _e14, 1.0);
    vec4 _e29 = blend_add(vec4(0.051, 0.0431, 0.0706, 1.0), _e19.color, _e19.tone, 1.0, true);
    float _e32 = transition_balanced(surface.kappa, 0.22);
    vec4 _e43 = curvature_color(_e32, vec4(0.851, 0.5451, 0.3059, 1.0), vec4(0.4784, 0.1843, 0.1333, 1.0));
    vec3 _e48 = u_look.warm.direction;
    vec3 _e57 = u_look.warm.direction;
    Angle warm_side_angle = Angle((0.5 * length((surface.normal - _e48))), (0.5 * length((surface.normal + _e57))));
    float warm_side_warp = (((2.0 * _e32) - 1.0) * 0.3);
    float _e70 = profile_balanced(warm_side_angle, warm_side_warp, warm_side_tone_shape);
    Light _e73 = u_look.warm;
    LitLayer _e74 = light_apply(_e73, _e43, _e70);
    vec4 _e79 = blend_add(_e29, _e74.color, _e74.tone, 1.0, true);
    vec4 _e90 = curvature_color(_e32, vec4(0.3098, 0.498, 0.7216, 1.0), vec4(0.1098, 0.1922, 0.3412, 1.0));
    vec3 _e95 = u_look.cool.direction;
    vec3 _e104 = u_look.cool.direction;
    Angle cool_side_angle = Angle((0.5 * length((surface.normal - _e95))), (0.5 * length((surface.normal + _e104))));
    float cool_side_warp = (((2.0 * _e32) - 1.0) * 0.25);
    float _e117 = profile_balanced(cool_side_angle, cool_side_warp, cool_side_tone_shape);
    Light _e120 = u_look.cool;
    LitLayer _e121 = light_apply(_e120, _e90, _e117);
    vec4 _e126 = blend_add(_e79, _e121.color, _e121.tone, 1.0, true);
    float _e129 = transition_balanced(surface.kappa, 0.2);
    vec4 _e140 = curvature_color(_e129, vec4(0.4196, 0.3176, 0.2196, 1.0), vec4(0.2, 0.1373, 0.1098, 1.0));
    Light _e143 = u_look.warm;
    Angle _e146 = parametrization_specular_balanced(_e143, surface.normal, surface.view);
    float sheen_warp = (((2.0 * _e129) - 1.0) * 0.1);
    float _e154 = profile_balanced_2_(_e146, sheen_warp, sheen_tone_shape);
    Light _e157 = u_look.warm;
    LitLayer _e158 = light_apply(_e157, _e140, _e154);
    vec4 _e163 = blend_add(_e126, _e158.color, _e158.tone, 1.0, true);
    return _e163;
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

