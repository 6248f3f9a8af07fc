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
const ProfileShape body_tone_shape = ProfileShape(0.86532396, 0.501213, 5.743557, 2.0104687, 1.05, 0.18576889, 0.077249795, 0u);
const ProfileShape window_tone_shape = ProfileShape(0.9887711, 0.14943813, 50.003334, 8.498813, 0.3, 0.011653547, 0.0057055796, 0u);
const ProfileShape rim_tone_shape = ProfileShape(0.9305076, 0.36627254, 10.016686, 2.4912605, 0.75, 0.09820393, 0.042312488, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, u_1.half_cos));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
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
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle body_angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e22 = profile_balanced(body_angle, 0.0, body_tone_shape);
    Light _e25 = u_look.key;
    LitLayer _e31 = light_apply(_e25, vec4(0.2471, 0.4863, 0.7686, 1.0), _e22);
    vec4 _e41 = blend_alpha(vec4(0.1333, 0.1882, 0.3098, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = u_look.key;
    Angle _e47 = parametrization_specular_balanced(_e44, surface.normal, surface.view);
    float _e50 = profile_balanced(_e47, 0.0, window_tone_shape);
    Light _e53 = u_look.key;
    LitLayer _e59 = light_apply(_e53, vec4(0.9686, 0.9843, 1.0, 1.0), _e50);
    vec4 window_blend = clamp(vec4((_e41.xyz + (_e59.tone * (_e59.color.xyz - _e41.xyz))), 1.0), vec4(0.0), vec4(1.0));
    vec3 _e79 = u_look.back.direction;
    vec3 _e88 = u_look.back.direction;
    Angle rim_angle = Angle((0.5 * length((surface.normal - _e79))), (0.5 * length((surface.normal + _e88))));
    float _e96 = profile_balanced(rim_angle, 0.0, rim_tone_shape);
    Light _e99 = u_look.back;
    LitLayer _e105 = light_apply(_e99, vec4(0.2314, 0.3725, 0.5255, 1.0), _e96);
    vec4 rim_blend = clamp(vec4((window_blend.xyz + (_e105.tone * _e105.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return rim_blend;
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
    out_color = _e19;
    return;
}

