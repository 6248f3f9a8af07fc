#version 300 es
// Shading profile: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// figure3-profile.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
    Light key;
    ProfileShape profile_tone_shape;
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
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

float log2_one_minus(float y) {
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
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

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
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

float profile_ramp_quick(float s_1, float w, ProfileShape shape_2) {
    float width = sqrt(((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_2.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_3, float w_1, ProfileShape shape_3) {
    if ((shape_3.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    vec2 _e7 = profile_place(u_3, shape_3);
    bool is_narrow = ((w_1 > 0.0) && (w_1 >= (3.4641016 * shape_3.edge_deviation)));
    if (((shape_3.kind == PROFILE_STEP) || is_narrow)) {
        float _e20 = profile_ramp_quick(_e7.x, w_1, shape_3);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_3);
    if ((w_1 < (0.1 * shape_3.edge_deviation))) {
        return _e22;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_3);
    float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_3);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle profile_angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    ProfileShape _e23 = u_look.profile_tone_shape;
    float _e24 = profile_balanced(profile_angle, 0.0, _e23);
    Light _e27 = u_look.key;
    LitLayer _e33 = light_apply(_e27, vec4(0.949, 0.8941, 0.7843, 1.0), _e24);
    vec4 profile_blend = clamp(vec4((vec3(0.1098, 0.1333, 0.1882) + (_e33.tone * _e33.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return profile_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    Surface surface_1 = Surface(normal);
    vec4 _e7 = shade(surface_1);
    out_color = _e7;
    return;
}

