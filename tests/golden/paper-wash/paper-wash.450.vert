#version 450 core
// Paper wash: made by Chiaro 0.1.0, GLSL 4.50.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// paper-wash.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    vec4 screen;
};

struct Object {
    mat4x4 world_from_object;
    /// The inverse transpose, for normals.
    mat3x3 world_from_normal;
    float id;
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    vec4 colors[16];
    /// Places of the stops, in increasing order, four to a vector.
    vec4 places[4];
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
};

struct Vertex {
    vec3 position;
    vec3 normal;
};

struct Varyings {
    vec4 clip;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const float MOST_ON_SCREEN = 1000000000000000.0;
const Ramp indigo_to_warm_paper = Ramp(vec4[16](vec4(0.13, 0.14, 0.33, 1.0),
    vec4(0.24, 0.36, 0.56, 1.0), vec4(0.53, 0.66, 0.72, 1.0), vec4(0.9, 0.8, 0.68, 1.0),
    vec4(0.975, 0.95, 0.9, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.35, 0.62, 0.82), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 1u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 0) smooth out vec3 v_normal;

void main() {
    Vertex vertex = Vertex(a_position, a_normal);
    vec4 world = u_object.world_from_object * vec4(vertex.position, 1.0);
    Varyings varyings = Varyings(u_view.clip_from_world * world, u_object.world_from_normal
        * vertex.normal);
    gl_Position = varyings.clip;
    v_normal = varyings.normal;
}
