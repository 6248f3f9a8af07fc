#version 450 core
// Highlights, cut and joined: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// highlight-cut.json says what to put there and how to draw.
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
    Light back;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct DirectionParts {
    vec3 direction;
    vec3 x_axis;
    vec3 y_axis;
    vec2 place;
};
struct AxesAround {
    vec3 x_axis;
    vec3 y_axis;
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
    vec3 normal;
};
const ProfileShape lit_side_shape = ProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733, 0.08138281, 0u);
const ProfileShape disc_shape = ProfileShape(0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u);
const ProfileShape bite_shape = ProfileShape(0.9887711, 0.14943813, 0.0, 1.0, 0.3, 0.0, 0.0, 1u);
const ProfileShape dot_shape = ProfileShape(0.99875027, 0.04997917, 0.0, 1.0, 0.1, 0.0, 0.0, 1u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) && (largest < 1e30)))) {
        return otherwise;
    }
    vec3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen_balanced(vec3 v_2) {
    return (v_2 * inversesqrt(max(dot(v_2, v_2), 1e-30)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, u_1.half_cos));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_4 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c = (u_2.half_cos + (u_2.half_sin * 0.0));
    vec2 upper_1 = ((c <= 0.0) ? vec2(1.0, 0.0) : vec2(s_4, c));
    vec2 turned_1 = (((s_4 <= 0.0) && (s_4 < c)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

float footprint_of(float x_1) {
    float _e1 = dFdx(x_1);
    float _e2 = dFdy(x_1);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

vec3 any_orthogonal(vec3 n) {
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a_1 = (-1.0 / (sign_ + n.z));
    return vec3((1.0 + (((sign_ * n.x) * n.x) * a_1)), (((sign_ * n.x) * n.y) * a_1), (-(sign_) * n.x));
}

Angle angle_between_directions(vec3 a, vec3 b) {
    return Angle((0.5 * length((a - b))), (0.5 * length((a + b))));
}

DirectionParts direction_within(vec3 direction, vec3 x_axis, vec3 y_axis) {
    vec3 y = (y_axis * inversesqrt(max(dot(y_axis, y_axis), 1e-30)));
    return DirectionParts(direction, x_axis, y, vec2(dot(direction, x_axis), dot(direction, y)));
}

vec3 direction_moved(DirectionParts parts, vec2 by) {
    vec3 moved = ((parts.direction + (by.x * parts.x_axis)) + (by.y * parts.y_axis));
    vec3 _e13 = normalize_moderate(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e13 : parts.direction);
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 leaning = cross(up, toward);
    float square_2 = dot(leaning, leaning);
    vec3 aside = ((abs(toward.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    vec3 _e28 = normalize_moderate((across - (dot(across, toward) * toward)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e28, cross(toward, _e28), toward);
}

AxesAround axes(vec3 direction_1, vec3 up_1) {
    mat3x3 _e2 = axes_around(direction_1, up_1);
    return AxesAround(_e2[0], _e2[1]);
}

vec3 half_vector(Light light, vec3 view) {
    vec3 half_1 = (light.direction + view);
    vec3 _e4 = any_orthogonal(view);
    vec3 _e9 = normalize_or(((dot(half_1, half_1) > 1e-12) ? half_1 : _e4), view);
    return _e9;
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1) {
    float width_1 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width_1)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_2, float w_1, ProfileShape shape_2) {
    float width_2 = sqrt((w_1 * w_1));
    float from_offset_1 = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((0.0 - from_offset_1) / max(width_2, 1e-6))), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_3, float w_2, ProfileShape shape_3) {
    vec2 place = vec2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_2);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset)), _e14, shape_5);
    return _e15;
}

float rim(Light light_1, vec3 normal, vec3 view_1, float width, float softness, float follow) {
    float facing = clamp(dot(normal, view_1), 0.0, 1.0);
    float _e11 = footprint_of(facing);
    float edge = max((width * softness), min(_e11, 1.0));
    vec3 aside_1 = (normal - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside_1, aside_1)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    vec3 across_1 = (light_1.direction - (dot(light_1.direction, view_1) * view_1));
    float side = dot((normal - (dot(normal, view_1) * view_1)), (across_1 * inversesqrt(max(dot(across_1, across_1), 1e-30))));
    return (inside * mix(1.0, smoothstep(0.0, 0.5, side), follow));
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle turned_from_the_key = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e22 = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    float in_the_dark = (1.0 - _e22);
    vec4 shadow = vec4((vec3(0.62, 0.16, 0.26) * mix(vec3(1.0), vec3(0.5, 0.33, 0.56), in_the_dark)), 1.0);
    vec3 normal_1 = surface.normal;
    Light _e42 = u_look.key;
    vec3 _e44 = half_vector(_e42, surface.view);
    Angle _e45 = angle_between_directions(normal_1, _e44);
    float _e48 = profile_balanced_2_(_e45, 0.0, disc_shape);
    AxesAround _e53 = axes(_e44, vec3(0.0, 1.0, 0.0));
    DirectionParts _e56 = direction_within(normal_1, _e53.x_axis, _e53.y_axis);
    vec3 _e60 = direction_moved(_e56, vec2(-0.13, 0.13));
    Angle _e61 = angle_between_directions(_e60, _e44);
    float _e64 = profile_balanced_2_(_e61, 0.0, bite_shape);
    float crescent = min(_e48, (1.0 - _e64));
    DirectionParts _e70 = direction_within(normal_1, _e53.x_axis, _e53.y_axis);
    vec3 _e74 = direction_moved(_e70, vec2(-0.06, 0.06));
    Angle _e75 = angle_between_directions(_e74, _e44);
    float _e78 = profile_balanced_2_(_e75, 0.0, dot_shape);
    float crescent_and_dot = max(crescent, _e78);
    vec4 _e87 = blend_alpha(shadow, vec4(1.0, 0.97, 0.9, 1.0), crescent_and_dot, 0.96, true);
    Light _e90 = u_look.back;
    float _e96 = rim(_e90, surface.normal, surface.view, 0.42, 0.08, 1.0);
    float rim_in_the_dark_only = min(_e96, in_the_dark);
    vec4 rim_s_light = clamp(vec4((_e87.xyz + (0.6 * ((_e87.xyz + (rim_in_the_dark_only * vec3(1.0, 0.62, 0.5))) - _e87.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return rim_s_light;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))));
    vec4 _e19 = shade(surface_1);
    out_color = _e19;
    return;
}

