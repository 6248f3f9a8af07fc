#version 450 core
// Half-tone metal: made by Chiaro 0.1.0, GLSL 4.50.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0, u_image_1 1.
// hcbtf-halftone.json says what to put there and how to draw.
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
const ProfileShape key_tone_shape = ProfileShape(0.9887711, 0.14943813, 1.7710322, 2.1985157, 0.3, 0.5954344, 0.25804672, 0u);
const ProfileShape band_tone_shape = ProfileShape(0.95233357, 0.30505863, 25.006668, 8.495251, 0.62, 0.023307618, 0.011411604, 0u);
const ProfileShape tone_shape = ProfileShape(1.0, 0.0, 1.0729164, 1.4587371, 0.0, 1.2242194, 0.53754854, 0u);
const ProfileShape spark_tone_shape = ProfileShape(0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0, 1u);
const ProfileShape rim_tone_shape = ProfileShape(0.921061, 0.38941833, 0.0, 1.0, 0.8, 0.0, 0.0, 1u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;
layout(location = 0) smooth out vec3 v_position;
layout(location = 1) smooth out vec3 v_normal;
layout(location = 2) smooth out vec4 v_tangent;
layout(location = 3) smooth out vec2 v_uv;

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

