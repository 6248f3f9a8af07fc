#version 300 es
// Dual lighting, hard: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-dual-hard.json says what to put there and how to draw.

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
struct Look {
    Light cool;
    Light warm;
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
const ProfileShape warm_side_tone_shape = ProfileShape(0.9305076, 0.36627254, 5.4363623, 1.7744379, 0.75, 0.20524569, 0.083345205, 0u);
const ProfileShape cool_side_tone_shape = ProfileShape(0.9393727, 0.3428978, 5.743557, 1.7484518, 0.7, 0.19521655, 0.07901356, 0u);
const ProfileShape cool_edge_tone_shape = ProfileShape(0.9887711, 0.14943813, 10.016686, 1.8827307, 0.3, 0.108895466, 0.044647813, 0u);

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
    float y = (x * x);
    float s_2 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return vec2(s_2, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
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
    bool is_narrow = ((w_1 > 0.0) && (w_1 >= (3.4641016 * shape_2.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_1, shape_2);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_3) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

vec4 shade(Surface surface) {
    float cool_side_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.3), -20.0, 20.0))))))));
    vec4 _e30 = curvature_color(cool_side_convexity, vec4(0.9412, 0.6588, 0.3765, 1.0), vec4(0.6039, 0.2275, 0.1412, 1.0));
    vec3 _e35 = u_look.warm.direction;
    vec3 _e44 = u_look.warm.direction;
    Angle warm_side_angle = Angle((0.5 * length((surface.normal - _e35))), (0.5 * length((surface.normal + _e44))));
    float warm_side_warp = (((2.0 * cool_side_convexity) - 1.0) * 0.45);
    float _e57 = profile_balanced(warm_side_angle, warm_side_warp, warm_side_tone_shape);
    Light _e60 = u_look.warm;
    LitLayer _e61 = light_apply(_e60, _e30, _e57);
    vec4 _e71 = blend_add(vec4(0.0314, 0.0275, 0.0392, 1.0), _e61.color, _e61.tone, 1.0, true);
    vec4 _e82 = curvature_color(cool_side_convexity, vec4(0.4353, 0.698, 0.9412, 1.0), vec4(0.1451, 0.251, 0.4353, 1.0));
    vec3 _e87 = u_look.cool.direction;
    vec3 _e96 = u_look.cool.direction;
    Angle cool_side_angle = Angle((0.5 * length((surface.normal - _e87))), (0.5 * length((surface.normal + _e96))));
    float cool_side_warp = (((2.0 * cool_side_convexity) - 1.0) * 0.4);
    float _e109 = profile_balanced(cool_side_angle, cool_side_warp, cool_side_tone_shape);
    Light _e112 = u_look.cool;
    LitLayer _e113 = light_apply(_e112, _e82, _e109);
    vec4 _e118 = blend_add(_e71, _e113.color, _e113.tone, 1.0, true);
    float cool_edge_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.25), -20.0, 20.0))))))));
    vec4 _e148 = curvature_color(cool_edge_convexity, vec4(0.3529, 0.3725, 0.4, 1.0), vec4(0.1255, 0.1412, 0.1569, 1.0));
    Light _e151 = u_look.cool;
    Angle _e154 = parametrization_specular_balanced(_e151, surface.normal, surface.view);
    float cool_edge_warp = (((2.0 * cool_edge_convexity) - 1.0) * 0.2);
    float _e162 = profile_balanced(_e154, cool_edge_warp, cool_edge_tone_shape);
    Light _e165 = u_look.cool;
    LitLayer _e166 = light_apply(_e165, _e148, _e162);
    vec4 _e171 = blend_add(_e118, _e166.color, _e166.tone, 1.0, true);
    return _e171;
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

