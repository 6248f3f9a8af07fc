#version 450 core
// Woodcut: made by Chiaro 0.1.0, GLSL 4.50.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// woodcut.json says what to put there and how to draw.
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
struct Vertex {
    vec3 position;
    vec3 normal;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 0) smooth out vec3 v_position;
layout(location = 1) smooth out vec3 v_position_object;
layout(location = 2) smooth out vec3 v_normal;

void main() {
    Vertex vertex = Vertex(a_position, a_normal);
    Varyings out_ = Varyings(vec4(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    mat4x4 _e3 = u_object.world_from_object;
    vec4 world = (_e3 * vec4(vertex.position, 1.0));
    mat4x4 _e12 = u_view.clip_from_world;
    out_.clip = (_e12 * world);
    out_.position = world.xyz;
    out_.position_object = vertex.position;
    mat3x3 _e21 = u_object.world_from_normal;
    out_.normal = (_e21 * vertex.normal);
    Varyings _e24 = out_;
    gl_Position = _e24.clip;
    v_position = _e24.position;
    v_position_object = _e24.position_object;
    v_normal = _e24.normal;
    return;
}

