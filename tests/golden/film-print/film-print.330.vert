#version 330 core
// Film print: made by Chiaro 0.1.0, GLSL 3.30.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// film-print.json says what to put there and how to draw.
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
struct Curve {
    vec4 points[16];
    uint count;
    uint interpolation;
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
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const ProfileShape tone_shape = ProfileShape(1.0, 0.0, 1.0248806, 0.99999666, 0.0, 1.5064107, 0.63535863, 0u);
const Curve response_of_the_film = Curve(vec4[16](vec4(0.0, 0.0, 0.2, 0.0), vec4(0.3, 0.06, 0.36, 0.0), vec4(0.5, 0.42, 0.972973, 0.0), vec4(0.62, 0.5, 1.0256411, 0.0), vec4(0.8, 0.9, 0.81632656, 0.0), vec4(1.0, 1.0, 0.5, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 6u, 1u);
const ProfileShape sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u);
const ProfileShape back_light_tone_shape = ProfileShape(0.9689124, 0.24740396, 4.0419726, 1.8505588, 0.5, 0.27256957, 0.11186968, 0u);
const Curve film_print = Curve(vec4[16](vec4(0.0, 0.04, 0.64, 0.0), vec4(0.25, 0.2, 0.8608187, 0.0), vec4(0.6, 0.66, 0.97504276, 0.0), vec4(1.0, 0.97, 0.775, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);
const Curve film_print_2_ = Curve(vec4[16](vec4(0.0, 0.0, 0.73333335, 0.0), vec4(0.3, 0.22, 0.99215686, 0.0), vec4(0.6, 0.68, 1.0514286, 0.0), vec4(1.0, 1.0, 0.8, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);
const Curve film_print_3_ = Curve(vec4[16](vec4(0.0, 0.06, 0.8333333, 0.0), vec4(0.3, 0.31, 0.8805031, 0.0), vec4(0.6, 0.59, 0.91636366, 0.0), vec4(1.0, 0.95, 0.9, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);
const Curve film_print_4_ = Curve(vec4[16](vec4(0.0, 0.13, 0.8, 0.0), vec4(0.3, 0.37, 0.53333336, 0.0), vec4(0.6, 0.49, 0.51555556, 0.0), vec4(1.0, 0.78, 0.725, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
smooth out vec3 v_position;
smooth out vec3 v_normal;

void main() {
    Vertex vertex = Vertex(a_position, a_normal);
    mat4x4 _e3 = u_object.world_from_object;
    vec4 world = (_e3 * vec4(vertex.position, 1.0));
    mat4x4 _e10 = u_view.clip_from_world;
    mat3x3 _e15 = u_object.world_from_normal;
    Varyings _tmp_return = Varyings((_e10 * world), world.xyz, (_e15 * vertex.normal));
    gl_Position = _tmp_return.clip;
    v_position = _tmp_return.position;
    v_normal = _tmp_return.normal;
    return;
}

