#version 300 es
// Painted light, before: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// painted-before.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light back;
    Light lamp;
    Light window;
};
struct Surface {
    vec3 normal;
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
    vec3 normal;
};
const ProfileShape body_tone_shape = ProfileShape(0.9921977, 0.12467473, 1.2081645, 1.573837, 0.25, 1.0277877, 0.44035247, 0u);
const ProfileShape light_tone_shape = ProfileShape(0.9950042, 0.099833414, 2.0858297, 2.2877648, 0.2, 0.49455804, 0.21395217, 0u);
const ProfileShape behind_tone_shape = ProfileShape(0.9921977, 0.12467473, 2.425296, 2.1444545, 0.25, 0.43399706, 0.1847509, 0u);

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_1 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, u_1.half_cos));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * color.xyz)), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_diffuse_balanced(Light light_1, vec3 normal) {
    return Angle((0.5 * length((normal - light_1.direction))), (0.5 * length((normal + light_1.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1) {
    vec2 place = vec2(((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset)), ((u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset)));
    float _e19 = profile_soft_quick(place.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_1);
    float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_1);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.window;
    Angle _e5 = parametrization_diffuse_balanced(_e3, surface.normal);
    float _e8 = profile_balanced(_e5, 0.0, body_tone_shape);
    Light _e11 = u_look.window;
    LitLayer _e17 = light_apply(_e11, vec4(0.42, 0.38, 0.38, 1.0), _e8);
    vec4 _e27 = blend_add(vec4(0.2, 0.18, 0.22, 1.0), _e17.color, _e17.tone, 1.0, true);
    Light _e30 = u_look.lamp;
    Angle _e32 = parametrization_diffuse_balanced(_e30, surface.normal);
    float _e35 = profile_balanced(_e32, 0.0, light_tone_shape);
    Light _e38 = u_look.lamp;
    LitLayer _e44 = light_apply(_e38, vec4(0.14, 0.13, 0.12, 1.0), _e35);
    vec4 _e49 = blend_add(_e27, _e44.color, _e44.tone, 1.0, true);
    Light _e52 = u_look.back;
    Angle _e54 = parametrization_diffuse_balanced(_e52, surface.normal);
    float _e57 = profile_balanced(_e54, 0.0, behind_tone_shape);
    Light _e60 = u_look.back;
    LitLayer _e66 = light_apply(_e60, vec4(0.08, 0.09, 0.1, 1.0), _e57);
    vec4 _e71 = blend_add(_e49, _e66.color, _e66.tone, 1.0, true);
    return _e71;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = Surface(normal_1);
    vec4 _e7 = shade(surface_1);
    out_color = _e7;
    return;
}

