#version 300 es
// Film print: made by Chiaro 0.1.0, GLSL ES 3.00.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// film-print.json says what to put there and how to draw.

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

/// A free function of one number, drawn through points; flat outside of them. The layout is one for
/// uniform buffers.
struct Curve {
    /// x, y and slope (dy/dx, used by the smooth interpolation) of each point, in increasing x.
    vec4 points[16];
    /// Number of points that count.
    uint count;
    /// 0 straight, 1 smooth (cubic, with the slopes), 2 stepped: each point's y holds until the
    /// next point.
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
const ProfileShape tone_shape = ProfileShape(1.0, 0.0, 1.0248806, 0.99999666, 0.0, 1.5064107,
    0.63535863, 0u);
const Curve response_of_the_film = Curve(vec4[16](vec4(0.0, 0.0, 0.2, 0.0),
    vec4(0.3, 0.06, 0.36, 0.0), vec4(0.5, 0.42, 0.972973, 0.0), vec4(0.62, 0.5, 1.0256411, 0.0),
    vec4(0.8, 0.9, 0.81632656, 0.0), vec4(1.0, 1.0, 0.5, 0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 6u, 1u);
const ProfileShape sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828,
    0.05, 0.3043368, 0.13399889, 0u);
const ProfileShape back_light_tone_shape = ProfileShape(0.9689124, 0.24740396, 4.0419726, 1.8505588,
    0.5, 0.27256957, 0.11186968, 0u);
const Curve film_print = Curve(vec4[16](vec4(0.0, 0.04, 0.64, 0.0), vec4(0.25, 0.2, 0.8608187, 0.0),
    vec4(0.6, 0.66, 0.97504276, 0.0), vec4(1.0, 0.97, 0.775, 0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0)), 4u, 1u);
const Curve film_print_2 = Curve(vec4[16](vec4(0.0, 0.0, 0.73333335, 0.0),
    vec4(0.3, 0.22, 0.99215686, 0.0), vec4(0.6, 0.68, 1.0514286, 0.0), vec4(1.0, 1.0, 0.8, 0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);
const Curve film_print_3 = Curve(vec4[16](vec4(0.0, 0.06, 0.8333333, 0.0),
    vec4(0.3, 0.31, 0.8805031, 0.0), vec4(0.6, 0.59, 0.91636366, 0.0), vec4(1.0, 0.95, 0.9, 0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);
const Curve film_print_4 = Curve(vec4[16](vec4(0.0, 0.13, 0.8, 0.0),
    vec4(0.3, 0.37, 0.53333336, 0.0), vec4(0.6, 0.49, 0.51555556, 0.0), vec4(1.0, 0.78, 0.725, 0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);

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
