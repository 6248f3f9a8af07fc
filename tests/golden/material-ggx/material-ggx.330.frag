#version 330 core
// Cook-Torrance, GGX: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-ggx.json says what to put there and how to draw.
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
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

vec3 half_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = (light + view);
    vec3 _e8 = normalize_moderate(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(vec3 a, vec3 b) {
    vec3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

Reflection reflection_of(vec3 light_1, vec3 normal_1, vec3 view_1) {
    vec3 _e3 = half_of(light_1, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection(dot(normal_1, light_1), dot(normal_1, view_1), n_h, v_h, _e14);
}

float schlick(float at_normal, float cosine) {
    float m = (1.0 - cosine);
    float m2_ = (m * m);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m)));
}

float ggx(Reflection r, float width, float at_normal_1) {
    if (((r.n_l <= 0.0) || (r.n_v <= 0.0))) {
        return 0.0;
    }
    float a2_ = (width * width);
    float bottom = max((r.sine2_ + ((a2_ * r.n_h) * r.n_h)), 1e-12);
    float distribution = (a2_ / (bottom * bottom));
    float toward_light = (r.n_v * sqrt((((r.n_l * r.n_l) * (1.0 - a2_)) + a2_)));
    float toward_eye = (r.n_l * sqrt((((r.n_v * r.n_v) * (1.0 - a2_)) + a2_)));
    float visibility = (0.5 / max((toward_light + toward_eye), 1e-9));
    float _e49 = schlick(at_normal_1, r.v_h);
    return min((((distribution * visibility) * _e49) * r.n_l), 1000000.0);
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float lambert = max(dot(surface.normal, _e5), 0.0);
    vec4 body = vec4((vec3(0.0784, 0.0863, 0.1098) + (lambert * vec3(0.2353, 0.2667, 0.3137))), 1.0);
    vec3 _e24 = u_look.key.direction;
    Reflection _e27 = reflection_of(_e24, surface.normal, surface.view);
    float _e30 = ggx(_e27, 0.1764, 0.85);
    vec4 highlight = clamp(vec4((body.xyz + (0.5 * ((body.xyz + (_e30 * vec3(0.9098, 0.9333, 0.9647))) - body.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return highlight;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))));
    vec4 _e19 = shade(surface_1);
    out_color = _e19;
    return;
}

