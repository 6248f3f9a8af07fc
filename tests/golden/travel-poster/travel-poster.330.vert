#version 330 core
// Travel poster: made by Chiaro 0.1.0, GLSL 3.30.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// travel-poster.json says what to put there and how to draw.
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

const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const ProfileShape evening_sun_tone_shape = ProfileShape(1.0, 0.0, 1.0955735, 1.6395584, 0.0,
    1.1385497, 0.5052584, 0u);
const ProfileShape sky_tone_shape = ProfileShape(1.0, 0.0, 1.229384, 1.2860026, 0.0, 1.0836705,
    0.44442755, 0u);
const ProfileShape glow_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.425296, 2.5857167, 0.1,
    0.4039123, 0.17722374, 0u);
const Ramp seven_inks = Ramp(vec4[16](vec4(0.0863, 0.1333, 0.2471, 1.0),
    vec4(0.1725, 0.3176, 0.3882, 1.0), vec4(0.4863, 0.2275, 0.2706, 1.0),
    vec4(0.7686, 0.3294, 0.2471, 1.0), vec4(0.8784, 0.5412, 0.298, 1.0),
    vec4(0.9412, 0.7608, 0.4824, 1.0), vec4(0.9843, 0.9333, 0.7961, 1.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.15, 0.3, 0.45), vec4(0.6, 0.8, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 0u);

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
