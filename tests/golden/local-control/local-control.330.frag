#version 330 core
// Light where it is wanted: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// local-control.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    mat3x3 camera_from_world;
    vec2 viewport;
    Light back;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    vec3 position_camera;
    vec3 curvature_tensor;
};
struct Angle {
    float half_sin;
    float half_cos;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const ProfileShape soft_tone_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_tensor_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_1 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, u_1.half_cos));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float eased(float x_1, float low, float high) {
    float _e3 = bounded(x_1);
    float _e7 = bounded(((_e3 - low) / (high - low)));
    float t_1 = clamp(_e7, 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float length_of(vec3 v_2) {
    float largest_1 = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest_1 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e16 = bounded((largest_1 * length((v_2 / vec3(largest_1)))));
    return _e16;
}

float footprint_of(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float footprint_of_2_(float x_3) {
    float _e1 = dFdx(x_3);
    float _e2 = dFdy(x_3);
    vec2 d_1 = vec2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float step_filtered(float x_4, float edge, float w) {
    float d_2 = (x_4 - edge);
    return ((w < 1e-30) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_2 / w)), 0.0, 1.0));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

vec4 blend_alpha_2_(vec4 below_1, vec4 color_1, float tone_1, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

Light local_light(Light light, vec3 bend, float strength, vec3 center, float radius, float hardness, vec3 position) {
    float _e8 = length_of((position - center));
    float _e10 = eased(_e8, (radius * hardness), radius);
    float weight = (1.0 - _e10);
    vec3 bent = (light.direction + (weight * bend));
    vec3 _e18 = normalize_moderate(bent, light.direction);
    vec3 direction = (((dot(bent, bent) > 1e-6) && (weight > 0.0)) ? _e18 : light.direction);
    return Light(direction, light.own_direction, light.color, min(light.intensity, 1e30));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_1) {
    vec2 place_1 = vec2((u_2.half_sin - 0.0), u_2.half_cos);
    float _e9 = profile_soft_quick(place_1.x, shape_1);
    if ((w_1 < (0.1 * shape_1.edge_deviation))) {
        return _e9;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e35 = profile_soft_quick(((place_1.x * turn.y) - (place_1.y * turn.x)), shape_1);
    float _e43 = profile_soft_quick(((place_1.x * turn.y) + (place_1.y * turn.x)), shape_1);
    return ((((5.0 * _e35) + (8.0 * _e9)) + (5.0 * _e43)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

float rim(Light light_1, vec3 normal, vec3 view, float width, float softness, float follow) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float _e11 = footprint_of_2_(facing);
    float edge_1 = max((width * softness), min(_e11, 1.0));
    vec3 aside = (normal - view);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge_1) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    vec3 across = (light_1.direction - (dot(light_1.direction, view) * view));
    float side = dot((normal - (dot(normal, view) * view)), (across * inversesqrt(max(dot(across, across), 1e-30))));
    return (inside * mix(1.0, smoothstep(0.0, 0.5, side), follow));
}

float inner_contour_suggestive(float width_1, float limit, float softness_1, vec3 tensor, vec3 normal_1, vec3 view_1, mat3x3 camera_from_world, vec3 place, vec2 viewport) {
    vec3 n = (camera_from_world * normal_1);
    float square_1 = dot(n.xy, n.xy);
    float radial = (((((tensor.x * n.x) * n.x) + (((2.0 * tensor.y) * n.x) * n.y)) + ((tensor.z * n.y) * n.y)) / max(square_1, 1e-6));
    float _e35 = dFdx(radial);
    float _e36 = dFdy(radial);
    vec2 change = vec2(_e35, _e36);
    vec3 v_3 = (camera_from_world * view_1);
    vec3 row = dFdy(place);
    float up = (((row - (dot(row, v_3) * v_3)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * inversesqrt(max(square_1, 1e-6)));
    float pixels = (height / 1000.0);
    float distance_ = (abs(radial) / max(length(change), 1e-6));
    float x_5 = ((toward_eye * height) * 0.05);
    float _e77 = footprint_of(x_5);
    float strength_1 = clamp((0.5 + ((x_5 - limit) / length(vec2(min(_e77, 1000000000000000.0), (limit * softness_1))))), 0.0, 1.0);
    return ((clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * strength_1) * smoothstep(0.05, 0.3, dot(normal_1, view_1)));
}

float outer_contour(float width_2, vec3 normal_2, vec3 view_2, vec2 viewport_1) {
    float facing_1 = clamp(dot(normal_2, view_2), 0.0, 1.0);
    float pixels_1 = ((width_2 * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    float _e15 = footprint_of_2_(facing_1);
    float distance_1 = (facing_1 / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing_1));
    return (clamp(((pixels_1 + 0.5) - distance_1), 0.0, min(pixels_1, 1.0)) * near);
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.key;
    Light _e16 = local_light(_e3, vec3(0.9, 0.25, 0.5), 1.0, vec3(0.12, 0.42, 0.5), 0.5, 0.4, surface.position_object);
    Light _e29 = local_light(_e16, vec3(0.4, 0.1, 0.35), 1.0, vec3(-0.05, -0.35, 0.5), 0.4, 0.2, surface.position_object);
    Angle turned_from_the_light = Angle((0.5 * length((surface.normal - _e29.direction))), (0.5 * length((surface.normal + _e29.direction))));
    float _e45 = profile_balanced(turned_from_the_light, 0.0, soft_tone_shape);
    float _e52 = length_of((surface.position_object - vec3(0.0, 0.02, 0.45)));
    float _e55 = eased(_e52, 0.03, 0.3);
    float shadow_under_the_chin = clamp((_e45 + ((1.0 - _e55) * -0.45)), 0.0, 1.0);
    float _e70 = length_of((surface.position_object - vec3(-0.2, 0.72, 0.4)));
    float _e73 = eased(_e70, 0.085, 0.17);
    float glint_on_the_brow = clamp((shadow_under_the_chin + ((1.0 - _e73) * 0.5)), 0.0, 1.0);
    float _e83 = footprint_of_2_(glint_on_the_brow);
    float _e87 = step_filtered(glint_on_the_brow, 0.55, length(vec2(_e83, 0.0)));
    vec4 _e100 = blend_alpha(vec4(0.36, 0.36, 0.6, 1.0), vec4(0.96, 0.72, 0.47, 1.0), _e87, 1.0, true);
    float _e102 = footprint_of_2_(glint_on_the_brow);
    float _e106 = step_filtered(glint_on_the_brow, 0.97, length(vec2(_e102, 0.0)));
    vec4 brightest_light = min(vec4((_e100.xyz + (_e106 * (vec3(1.0, 0.93, 0.76) - _e100.xyz))), 1.0), vec4(1.0));
    Light _e123 = u_look.back;
    float _e129 = rim(_e123, surface.normal, surface.view, 0.3, 0.1, 1.0);
    vec4 _e137 = blend_alpha_2_(brightest_light, vec4(0.72, 0.86, 1.0, 1.0), _e129, 0.7, true);
    mat3x3 _e146 = u_look.camera_from_world;
    vec2 _e150 = u_look.viewport;
    float _e151 = inner_contour_suggestive(2.0, 20.0, 0.3, surface.curvature_tensor, surface.normal, surface.view, _e146, surface.position_camera, _e150);
    vec2 _e157 = u_look.viewport;
    float _e158 = outer_contour(3.0, surface.normal, surface.view, _e157);
    float all_lines = max(_e158, _e151);
    vec4 _e167 = blend_alpha_2_(_e137, vec4(0.17, 0.13, 0.28, 1.0), all_lines, 0.85, true);
    return _e167;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_3 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    mat4x4 _e21 = u_view.camera_from_world;
    vec4 _e32 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, (_e21 * vec4(in_.position, 1.0)).xyz, _e32.xyz);
    vec4 _e35 = shade(surface_1);
    out_color = _e35;
    return;
}

