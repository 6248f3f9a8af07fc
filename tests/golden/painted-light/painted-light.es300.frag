#version 300 es
// Painted light: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// painted-light.json says what to put there and how to draw.

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
const ProfileShape body_tone_shape = ProfileShape(0.60240144, 0.7981933, 21.601328, 1.0, 1.84858, 0.06173407, 0.021818977, 0u);
const ProfileShape light_tone_shape = ProfileShape(0.9976349, 0.06873576, 2.5909312, 1.0, 0.13758, 0.5226457, 0.18761672, 0u);
const ProfileShape behind_tone_shape = ProfileShape(0.9921977, 0.12467473, 2.425296, 1.7791567, 0.25, 0.46467006, 0.1911372, 0u);

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
    float w_4 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_4, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, u_1.half_cos));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
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
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), 1.0));
}

float profile_soft_quick_2_(float s_1, ProfileShape shape_1) {
    float q_1 = (s_1 * shape_1.scale);
    return ((s_1 <= 0.0) ? 1.0 : pow(max((1.0 - (q_1 * q_1)), 0.0), shape_1.exponent));
}

float profile_ramp_quick(float s_2, float w, ProfileShape shape_2) {
    float width = sqrt(((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
    float from_offset = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_2.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_3) {
    vec2 place = vec2(((u_2.half_sin * shape_3.half_cos_offset) - (u_2.half_cos * shape_3.half_sin_offset)), ((u_2.half_cos * shape_3.half_cos_offset) + (u_2.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_1 > 0.0) && (w_1 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_1, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_3);
    if ((w_1 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_2, ProfileShape shape_4) {
    vec2 place_1 = vec2(((u_3.half_sin * shape_4.half_cos_offset) - (u_3.half_cos * shape_4.half_sin_offset)), ((u_3.half_cos * shape_4.half_cos_offset) + (u_3.half_sin * shape_4.half_sin_offset)));
    float _e19 = profile_soft_quick(place_1.x, shape_4);
    if ((w_2 < (0.1 * shape_4.edge_deviation))) {
        return _e19;
    }
    float r_1 = (0.19364917 * w_2);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e45 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_4);
    float _e53 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_4);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_4, float w_3, ProfileShape shape_5) {
    vec2 place_2 = vec2(((u_4.half_sin * shape_5.half_cos_offset) - (u_4.half_cos * shape_5.half_sin_offset)), ((u_4.half_cos * shape_5.half_cos_offset) + (u_4.half_sin * shape_5.half_sin_offset)));
    float _e19 = profile_soft_quick_2_(place_2.x, shape_5);
    if ((w_3 < (0.1 * shape_5.edge_deviation))) {
        return _e19;
    }
    float r_2 = (0.19364917 * w_3);
    vec2 turn_2 = vec2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    float _e45 = profile_soft_quick_2_(((place_2.x * turn_2.y) - (place_2.y * turn_2.x)), shape_5);
    float _e53 = profile_soft_quick_2_(((place_2.x * turn_2.y) + (place_2.y * turn_2.x)), shape_5);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_6) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_6);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_7) {
    Angle _e6 = angle_turned(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_8) {
    Angle _e6 = angle_turned(angle_2, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_8);
    return _e8;
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.window;
    Angle _e5 = parametrization_diffuse_balanced(_e3, surface.normal);
    float _e8 = profile_balanced(_e5, 0.0, body_tone_shape);
    Light _e11 = u_look.window;
    LitLayer _e17 = light_apply(_e11, vec4(0.18708, 0.62392, 0.48886, 1.0), _e8);
    vec4 _e27 = blend_add(vec4(0.14678, 0.1201, 0.28662, 1.0), _e17.color, _e17.tone, 1.0, true);
    Light _e30 = u_look.lamp;
    Angle _e32 = parametrization_diffuse_balanced(_e30, surface.normal);
    float _e35 = profile_balanced_2_(_e32, 0.0, light_tone_shape);
    Light _e38 = u_look.lamp;
    LitLayer _e44 = light_apply(_e38, vec4(0.81701, 0.67278, 0.30725, 1.0), _e35);
    vec4 _e49 = blend_add(_e27, _e44.color, _e44.tone, 1.0, true);
    Light _e52 = u_look.back;
    Angle _e54 = parametrization_diffuse_balanced(_e52, surface.normal);
    float _e57 = profile_balanced_3_(_e54, 0.0, behind_tone_shape);
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

