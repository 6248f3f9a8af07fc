#version 330 core
// Profile curves: made by Chiaro 0.1.0, GLSL 3.30.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// figure3-curves.json says what to put there and how to draw.
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
    vec2 uv;
};
struct Varyings {
    vec4 clip;
    vec2 uv;
};
const float PI = 3.1415927;
const ProfileShape lambert_shape = ProfileShape(1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u);
const ProfileShape half_lambert_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);
const ProfileShape custom_shape = ProfileShape(0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928, 0.2351043, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 3) in vec2 a_uv;
smooth out vec2 v_uv;

void main() {
    Vertex vertex = Vertex(a_position, a_uv);
    mat4x4 _e3 = u_object.world_from_object;
    vec4 world = (_e3 * vec4(vertex.position, 1.0));
    mat4x4 _e10 = u_view.clip_from_world;
    Varyings _tmp_return = Varyings((_e10 * world), vertex.uv);
    gl_Position = _tmp_return.clip;
    v_uv = _tmp_return.uv;
    return;
}

