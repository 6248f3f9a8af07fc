#version 300 es
// Anisotropic Ward: made by Chiaro 0.1.0, GLSL ES 3.00.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-ward.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
    vec4 tangent;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
    vec4 tangent;
};
layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
smooth out vec3 v_position;
smooth out vec3 v_normal;
smooth out vec4 v_tangent;

void main() {
    Vertex vertex = Vertex(a_position, a_normal, a_tangent);
    Varyings out_ = Varyings(vec4(0.0), vec3(0.0), vec3(0.0), vec4(0.0));
    mat4x4 _e3 = u_object.world_from_object;
    vec4 world = (_e3 * vec4(vertex.position, 1.0));
    mat4x4 _e12 = u_view.clip_from_world;
    out_.clip = (_e12 * world);
    out_.position = world.xyz;
    mat3x3 _e19 = u_object.world_from_normal;
    out_.normal = (_e19 * vertex.normal);
    mat4x4 _e25 = u_object.world_from_object;
    mat3x3 _e39 = u_object.world_from_normal;
    out_.tangent = vec4((_e25 * vec4(vertex.tangent.xyz, 0.0)).xyz, ((determinant(_e39) < 0.0) ? -(vertex.tangent.w) : vertex.tangent.w));
    Varyings _e45 = out_;
    gl_Position = _e45.clip;
    v_position = _e45.position;
    v_normal = _e45.normal;
    v_tangent = _e45.tangent;
    return;
}

