#version 330 core
// Stained glass: made by Chiaro 0.1.0, GLSL 3.30.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// stained-glass.json says what to put there and how to draw.
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
    vec3 position_object;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const uint NOISE_PERLIN = 1u;
/// Least distance of the point of a cell that is no neighbor, in cells: points keep a quarter of a
/// cell from their cell's sides.
const float CELL_REACH = 1.25;
const Ramp colors = Ramp(vec4[16](vec4(0.0706, 0.1882, 0.4784, 1.0),
    vec4(0.1216, 0.4784, 0.6902, 1.0), vec4(0.1137, 0.5412, 0.3529, 1.0),
    vec4(0.9098, 0.6902, 0.1255, 1.0), vec4(0.8471, 0.3255, 0.1098, 1.0),
    vec4(0.6902, 0.0706, 0.2196, 1.0), vec4(0.3529, 0.102, 0.4784, 1.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.22, 0.4, 0.58), vec4(0.75, 0.9, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 2u);
const ProfileShape through_the_glass_shape = ProfileShape(0.9950042, 0.099833414, 1.1883951,
    1.4967098, 0.2, 1.0679889, 0.45520553, 0u);
const ProfileShape on_the_glass_shape = ProfileShape(0.99875027, 0.04997917, 1.2766062, 1.3888036,
    0.1, 1.0089166, 0.41697913, 0u);
const ProfileShape gleam_tone_shape = ProfileShape(0.99820054, 0.059964005, 11.126125, 3.022525,
    0.12, 0.08196669, 0.036355104, 0u);
const ProfileShape edge_of_the_lead_tone_shape = ProfileShape(0.9887711, 0.14943813, 3.3838634,
    2.4220939, 0.3, 0.29531473, 0.1274162, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
smooth out vec3 v_position;
smooth out vec3 v_position_object;
smooth out vec3 v_normal;

void main() {
    Vertex vertex = Vertex(a_position, a_normal);
    vec4 world = u_object.world_from_object * vec4(vertex.position, 1.0);
    Varyings varyings = Varyings(u_view.clip_from_world * world, world.xyz, vertex.position,
        u_object.world_from_normal * vertex.normal);
    gl_Position = varyings.clip;
    v_position = varyings.position;
    v_position_object = varyings.position_object;
    v_normal = varyings.normal;
}
