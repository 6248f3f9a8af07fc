#version 450 core
// Dual lighting, soft: made by Chiaro 0.1.0, GLSL 4.50.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-dual-soft.json says what to put there and how to draw.
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
struct Vertex {
    vec3 position;
    vec3 normal;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const ProfileShape warm_side_tone_shape = ProfileShape(0.9971888, 0.07492971, 1.3940078, 1.4345639, 0.15, 0.90231395, 0.36981526, 0u);
const ProfileShape cool_side_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.5079876, 1.4054453, 0.1, 0.83293223, 0.33645248, 0u);
const ProfileShape sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 0) smooth out vec3 v_position;
layout(location = 1) smooth out vec3 v_normal;

void main() {
    Vertex vertex = Vertex(a_position, a_normal);
    mat4x4 _e3 = u_object.world_from_object;
    vec4 world = (_e3 * vec4(vertex.position, 1.0));
    mat4x4 _e10 = u_view.clip_from_world;
    mat3x3 _e15 = u_object.world_from_normal;
    Varyings _tmp_return = Varyings((_e10 * world), world.xyz, (_e15 * vertex.normal));
    gl_Position = _tmp_return.clip;
    v_position = _tmp_return.position;
    v_normal = _tmp_return.normal;
    return;
}

