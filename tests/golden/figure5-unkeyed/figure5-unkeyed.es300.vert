#version 300 es
// Without directional control: made by Chiaro 0.1.0, GLSL ES 3.00.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure5-unkeyed.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

struct Object {
    mat4x4 world_from_object;
    /// The inverse transpose, for normals.
    mat3x3 world_from_normal;
    float id;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
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

const ProfileShape diffuse_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.3613818, 1.3042344,
    0.1, 0.957938, 0.38615924, 0u);
const ProfileShape back_light_tone_shape = ProfileShape(0.9624252, 0.27154693, 3.3838634, 1.9110762,
    0.55, 0.32249987, 0.13348491, 0u);
const ProfileShape highlight_tone_shape = ProfileShape(0.9959527, 0.08987855, 11.126125, 3.022525,
    0.18, 0.08196669, 0.036355104, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
smooth out vec3 v_position;
smooth out vec3 v_normal;

void main() {
    Vertex vertex = Vertex(a_position, a_normal);
    vec4 world = u_object.world_from_object * vec4(vertex.position, 1.0);
    Varyings varyings = Varyings(u_view.clip_from_world * world, world.xyz,
        u_object.world_from_normal * vertex.normal);
    gl_Position = varyings.clip;
    v_position = varyings.position;
    v_normal = varyings.normal;
}
