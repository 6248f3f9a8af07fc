#version 330 core
// Ink outlines: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws normals and depth, for the curvature pass.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// ink-outlines.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
};
struct Object {
    mat4x4 world_from_object;
    mat3x3 world_from_normal;
    float id;
    float cutoff;
};
struct Surface {
    vec3 normal;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

vec2 slope_of(vec3 normal) {
    return (normal.xy / vec2(max(normal.z, 0.2)));
}

vec4 surface_texel(vec3 normal_1, float depth, float number) {
    vec2 _e3 = slope_of(normal_1);
    return vec4(_e3, depth, ((normal_1.z < 0.0) ? -(number) : number));
}

vec3 shade(Surface surface) {
    return surface.normal;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    bool local = false;
    vec3 _e3 = normalize_seen(in_.normal);
    vec4 _e6 = u_view.eye;
    float _e11 = u_view.eye.w;
    vec3 toward = normalize((_e6.xyz - (_e11 * in_.position)));
    if (!(is_front)) {
        local = (dot(_e3, toward) < -0.1);
    } else {
        local = false;
    }
    bool is_behind = local;
    vec3 normal_2 = (is_behind ? -(_e3) : _e3);
    Surface surface_1 = Surface(normal_2);
    mat4x4 _e29 = u_view.camera_from_world;
    vec3 _e30 = shade(surface_1);
    vec3 seen = (_e29 * vec4(_e30, 0.0)).xyz;
    mat4x4 _e37 = u_view.camera_from_world;
    float depth_1 = -((_e37 * vec4(in_.position, 1.0)).z);
    float _e46 = u_object.id;
    vec4 _e49 = surface_texel(seen, depth_1, (_e46 + 1.0));
    out_color = _e49;
    return;
}

