#version 300 es
// Pencil: made by Chiaro 0.1.0, GLSL ES 3.00.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_image_1 0.
// hcbtf-pencil.json says what to put there and how to draw.

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
    vec4 tangent;
    vec2 uv;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
    vec4 tangent;
    vec2 uv;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape tone_shape = ProfileShape(1.0, 0.0, 1.1220733, 1.5951413, 0.0, 1.1173698, 0.4896476, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;
smooth out vec3 v_position;
smooth out vec3 v_normal;
smooth out vec4 v_tangent;
smooth out vec2 v_uv;

void main() {
    Vertex vertex = Vertex(a_position, a_normal, a_tangent, a_uv);
    Varyings out_ = Varyings(vec4(0.0), vec3(0.0), vec3(0.0), vec4(0.0), vec2(0.0));
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
    out_.uv = vertex.uv;
    Varyings _e47 = out_;
    gl_Position = _e47.clip;
    v_position = _e47.position;
    v_normal = _e47.normal;
    v_tangent = _e47.tangent;
    v_uv = _e47.uv;
    return;
}

