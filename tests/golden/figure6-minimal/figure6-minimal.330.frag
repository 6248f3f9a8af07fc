#version 330 core
// Minimal: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-minimal.json says what to put there and how to draw.
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
    Light key;
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
const ProfileShape white_specular_tone_shape = ProfileShape(0.98472655, 0.17410813, 3.6826046, 2.506993, 0.35, 0.26755187, 0.1159523, 0u);

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

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4((light.color * split.y), 1.0), (tone * split.x));
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
    Light _e3 = u_look.key;
    Angle _e6 = parametrization_specular_balanced(_e3, surface.normal, surface.view);
    float white_specular_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.35), -20.0, 20.0))))))));
    float white_specular_warp = (((2.0 * white_specular_convexity) - 1.0) * 0.7);
    float _e33 = profile_balanced(_e6, white_specular_warp, white_specular_tone_shape);
    Light _e36 = u_look.key;
    LitLayer _e39 = light_apply(_e36, vec4(1.0), _e33);
    vec4 white_specular_blend = clamp(vec4((vec3(0.0) + (_e39.tone * (_e39.color.xyz - vec3(0.0)))), 1.0), vec4(0.0), vec4(1.0));
    return white_specular_blend;
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

