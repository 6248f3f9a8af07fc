#version 330 core
// Glossy, lacquer: made by Chiaro 0.1.0, GLSL 3.30.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-glossy-lacquer.json says what to put there and how to draw.
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
const ProfileShape body_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.2766062, 1.3888036, 0.1, 1.0089166, 0.41697913, 0u);
const ProfileShape soft_reflection_tone_shape = ProfileShape(0.9971888, 0.07492971, 2.0858297, 1.974287, 0.15, 0.5228124, 0.22054322, 0u);
const ProfileShape window_tone_shape = ProfileShape(0.99280864, 0.119712204, 25.006668, 2.4986002, 0.24, 0.039271776, 0.016918294, 0u);
const ProfileShape back_light_tone_shape = ProfileShape(0.9747941, 0.22310637, 3.6826046, 2.1246715, 0.45, 0.28481507, 0.12005855, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
smooth out vec3 v_position;
smooth out vec3 v_normal;

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

