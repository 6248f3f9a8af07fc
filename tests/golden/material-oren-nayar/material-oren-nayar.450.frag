#version 450 core
// Oren-Nayar: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-oren-nayar.json says what to put there and how to draw.
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
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

float oren_nayar(vec3 light, vec3 normal, vec3 view, float sigma) {
    float n_l = dot(normal, light);
    float n_v = dot(normal, view);
    if ((n_l <= 0.0)) {
        return 0.0;
    }
    float s2_ = (sigma * sigma);
    float a = (1.0 - ((0.5 * s2_) / (s2_ + 0.33)));
    float b = ((0.45 * s2_) / (s2_ + 0.09));
    float across = (dot(light, view) - (n_l * n_v));
    float larger = max(max(n_l, n_v), 0.001);
    return (n_l * (a + ((b * max(across, 0.0)) / larger)));
}

vec4 shade(Surface surface) {
    vec3 _e4 = u_look.key.direction;
    float _e8 = oren_nayar(_e4, surface.normal, surface.view, 0.9);
    vec4 body = min(vec4((vec3(0.1725, 0.1647, 0.2) + (_e8 * vec3(0.851, 0.7961, 0.698))), 1.0), vec4(1.0));
    return body;
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

