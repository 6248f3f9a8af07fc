#version 450 core
// Painted light, before: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// painted-before.json says what to put there and how to draw.
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
const float LOG2_E = 1.442695;
const ProfileShape body_tone_shape = ProfileShape(0.9921977, 0.12467473, 1.2081645, 1.573837, 0.25, 1.0277877, 0.44035247, 0u);
const ProfileShape light_tone_shape = ProfileShape(0.9950042, 0.099833414, 2.0858297, 2.2877648, 0.2, 0.49455804, 0.21395217, 0u);
const ProfileShape behind_tone_shape = ProfileShape(0.9921977, 0.12467473, 2.425296, 2.1444545, 0.25, 0.43399706, 0.1847509, 0u);

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_normal;
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
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_1 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, u_1.half_cos));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    float _e8 = log2_one_minus(min((q * q), 1.0));
    return ((s <= 0.0) ? 1.0 : ((q >= 1.0) ? 0.0 : min(exp2(max((shape.exponent * _e8), -126.0)), 1.0)));
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

vec4 shade(Surface surface_1) {
    vec3 _e5 = u_look.window.direction;
    vec3 _e14 = u_look.window.direction;
    Angle body_angle = Angle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    float _e22 = profile_balanced(body_angle, 0.0, body_tone_shape);
    Light _e25 = u_look.window;
    LitLayer _e31 = light_apply(_e25, vec4(0.42, 0.38, 0.38, 1.0), _e22);
    vec4 body_blend = clamp(vec4((vec3(0.2, 0.18, 0.22) + (_e31.tone * _e31.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec3 _e52 = u_look.lamp.direction;
    vec3 _e61 = u_look.lamp.direction;
    Angle light_angle = Angle((0.5 * length((surface_1.normal - _e52))), (0.5 * length((surface_1.normal + _e61))));
    float _e69 = profile_balanced(light_angle, 0.0, light_tone_shape);
    Light _e72 = u_look.lamp;
    LitLayer _e78 = light_apply(_e72, vec4(0.14, 0.13, 0.12, 1.0), _e69);
    vec4 light_blend = clamp(vec4((body_blend.xyz + (_e78.tone * _e78.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec3 _e96 = u_look.back.direction;
    vec3 _e105 = u_look.back.direction;
    Angle behind_angle = Angle((0.5 * length((surface_1.normal - _e96))), (0.5 * length((surface_1.normal + _e105))));
    float _e113 = profile_balanced(behind_angle, 0.0, behind_tone_shape);
    Light _e116 = u_look.back;
    LitLayer _e122 = light_apply(_e116, vec4(0.08, 0.09, 0.1, 1.0), _e113);
    vec4 output_ = clamp(vec4((light_blend.xyz + (_e122.tone * _e122.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0));
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    surface.normal = normal;
    Surface _e8 = surface;
    vec4 _e9 = shade(_e8);
    out_color = _e9;
    return;
}

