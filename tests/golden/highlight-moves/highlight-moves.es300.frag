#version 300 es
// A highlight, moved: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// highlight-moves.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
    float turn_angle;
    float move_x;
    float move_y;
    float stretch_x;
    float stretch_y;
    float split_x;
    float split_y;
    float square_amount;
    vec4 body;
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
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const ProfileShape lit_side_shape = ProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733, 0.08138281, 0u);
const ProfileShape highlight_shape = ProfileShape(0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0, 0.0, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent), exponent));
}

vec3 normalize_or(vec3 v_1, vec3 otherwise) {
    float largest = max(max(abs(v_1.x), abs(v_1.y)), abs(v_1.z));
    if (!(((largest > 1e-30) && (largest < 1e30)))) {
        return otherwise;
    }
    vec3 scaled = (v_1 * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float exp2_stable(float x_1) {
    float clamped_1 = max(x_1, -126.0);
    float whole = roundEven(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float log2_stable(float x_2) {
    uint bits = floatBitsToUint(x_2);
    int exponent_1 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log_stable(float x_3) {
    float _e2 = log2_stable(x_3);
    return (LN_2_ * _e2);
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

float log1p_negative(float y_1) {
    if ((y_1 < 0.25)) {
        float _e3 = log1p_negative_small(y_1);
        return _e3;
    }
    float _e8 = log_stable(max((1.0 - y_1), 1.1754944e-38));
    return _e8;
}

vec2 sin_cos_quarter(float x_4) {
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s_3 = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s_3) * c), (1.0 - ((2.0 * s_3) * s_3)));
}

vec2 sin_cos(float x_5) {
    float turns = roundEven((x_5 * 0.31830987));
    float r = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    vec2 _e27 = sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

vec3 normalize_moderate(vec3 v_2, vec3 otherwise_1) {
    float square_1 = dot(v_2, v_2);
    return ((square_1 > 1e-30) ? (v_2 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen_balanced(vec3 v_3) {
    return (v_3 * inversesqrt(max(dot(v_3, v_3), 1e-30)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_4 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_4, u_1.half_cos));
    vec2 turned = (((s_4 <= 0.0) && (s_4 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_5 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_1 = (u_2.half_cos + (u_2.half_sin * 0.0));
    vec2 upper_1 = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_5, c_1));
    vec2 turned_1 = (((s_5 <= 0.0) && (s_5 < c_1)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

vec3 bounded_vec3_(vec3 v_4) {
    uvec3 bits_1 = floatBitsToUint(v_4);
    uvec3 magnitude = (bits_1 & uvec3(2147483647u));
    vec3 largest_1 = uintBitsToFloat(((bits_1 & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest_1, equal(magnitude, uvec3(2139095040u)));
    return mix(numbers, v_4, lessThan(magnitude, uvec3(2139095040u)));
}

float footprint_of(float x_6) {
    float _e1 = dFdx(x_6);
    float _e2 = dFdy(x_6);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

vec3 any_orthogonal(vec3 n) {
    float sign_1 = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a = (-1.0 / (sign_1 + n.z));
    return vec3((1.0 + (((sign_1 * n.x) * n.x) * a)), (((sign_1 * n.x) * n.y) * a), (-(sign_1) * n.x));
}

DirectionParts direction_within(vec3 direction, vec3 x_axis, vec3 y_axis) {
    vec3 y_4 = (y_axis * inversesqrt(max(dot(y_axis, y_axis), 1e-30)));
    return DirectionParts(direction, x_axis, y_4, vec2(dot(direction, x_axis), dot(direction, y_4)));
}

vec3 direction_moved(DirectionParts parts, vec2 by) {
    vec2 step_ = clamp(by, vec2(-1000000.0), vec2(1000000.0));
    vec3 moved = ((parts.direction + (step_.x * parts.x_axis)) + (step_.y * parts.y_axis));
    vec3 _e18 = normalize_moderate(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e18 : parts.direction);
}

vec3 direction_moved_2_(DirectionParts parts_1, vec2 by_1) {
    vec3 moved_1 = ((parts_1.direction + (by_1.x * parts_1.x_axis)) + (by_1.y * parts_1.y_axis));
    vec3 _e13 = normalize_moderate(moved_1, parts_1.direction);
    return ((dot(moved_1, moved_1) > 1e-6) ? _e13 : parts_1.direction);
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 _e6 = normalize_moderate(up, vec3(0.0, 1.0, 0.0));
    vec3 leaning = cross(_e6, toward);
    float square_2 = dot(leaning, leaning);
    vec3 aside = ((abs(toward.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    vec3 _e33 = normalize_moderate((across - (dot(across, toward) * toward)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e33, cross(toward, _e33), toward);
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

vec3 split_direction(vec3 direction_2, vec3 x_axis_1, vec3 y_axis_1, float x_7, float y_2) {
    DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    vec2 side = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(_e5.place, vec2(0.0)));
    vec3 _e21 = direction_moved(_e5, (-(max(vec2(x_7, y_2), vec2(0.0))) * side));
    return _e21;
}

vec3 square_direction(vec3 direction_3, vec3 x_axis_2, vec3 y_axis_2, float amount, float sharpness) {
    DirectionParts _e5 = direction_within(direction_3, x_axis_2, y_axis_2);
    float square_3 = dot(_e5.place, _e5.place);
    float apart = (abs(_e5.place.x) - abs(_e5.place.y));
    float aside_1 = min(((apart * apart) / max(square_3, 1e-20)), 1.0);
    float _e24 = log1p_negative(aside_1);
    float _e26 = exp2_stable(((sharpness * LOG2_E) * _e24));
    float corner = (((square_3 > 1e-20) && (aside_1 < 1.0)) ? _e26 : 0.0);
    vec3 _e41 = direction_moved_2_(_e5, ((-(clamp(amount, 0.0, 1.0)) * corner) * _e5.place));
    return _e41;
}

vec3 stretch_direction(vec3 direction_4, vec3 x_axis_3, vec3 y_axis_3, float x_8, float y_3) {
    DirectionParts _e5 = direction_within(direction_4, x_axis_3, y_axis_3);
    vec3 _e13 = direction_moved(_e5, (-(min(vec2(x_8, y_3), vec2(1.0))) * _e5.place));
    return _e13;
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    float alpha = (below.w + ((tone * opacity) * (1.0 - below.w)));
    return clamp(vec4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), alpha), vec4(0.0), vec4(1.0));
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
    float r_1 = (0.19364917 * w_2);
    vec2 turn = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
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
    vec3 aside_2 = (normal - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside_2, aside_2)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    vec3 across_1 = (light_1.direction - (dot(light_1.direction, view_1) * view_1));
    float side_1 = dot((normal - (dot(normal, view_1) * view_1)), (across_1 * inversesqrt(max(dot(across_1, across_1), 1e-30))));
    return (inside * mix(1.0, smoothstep(0.0, 0.5, side_1), follow));
}

vec3 rotate_vector(vec3 vector, vec3 axis, float angle_2) {
    vec2 _e5 = sin_cos((0.5 * angle_2));
    vec2 half_2 = clamp(_e5, vec2(-1.0), vec2(1.0));
    vec3 aside_3 = cross(axis, vector);
    vec3 _e23 = bounded_vec3_((vector + ((2.0 * half_2.x) * ((half_2.y * aside_3) + (half_2.x * cross(axis, aside_3))))));
    return _e23;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle turned_from_the_key = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e22 = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    float in_the_dark = (1.0 - _e22);
    vec4 _e27 = u_look.body;
    vec4 _e31 = u_look.body;
    vec4 _e43 = u_look.body;
    float _e50 = u_look.body.w;
    vec4 shadow = clamp(vec4((_e27.xyz + ((_e31.xyz * mix(vec3(1.0), vec3(0.45, 0.36, 0.62), in_the_dark)) - _e43.xyz)), _e50), vec4(0.0), vec4(1.0));
    vec3 normal_1 = surface.normal;
    Light _e60 = u_look.key;
    vec3 _e62 = half_vector(_e60, surface.view);
    float _e69 = u_look.turn_angle;
    vec3 _e70 = rotate_vector(vec3(0.0, 1.0, 0.0), _e62, _e69);
    AxesAround _e71 = axes(_e62, _e70);
    DirectionParts _e74 = direction_within(normal_1, _e71.x_axis, _e71.y_axis);
    float _e77 = u_look.move_x;
    float _e80 = u_look.move_y;
    vec3 _e82 = direction_moved(_e74, vec2(_e77, _e80));
    float _e87 = u_look.stretch_x;
    float _e90 = u_look.stretch_y;
    vec3 _e91 = stretch_direction(_e82, _e71.x_axis, _e71.y_axis, _e87, _e90);
    float _e96 = u_look.split_x;
    float _e99 = u_look.split_y;
    vec3 _e100 = split_direction(_e91, _e71.x_axis, _e71.y_axis, _e96, _e99);
    float _e105 = u_look.square_amount;
    vec3 _e107 = square_direction(_e100, _e71.x_axis, _e71.y_axis, _e105, 4.0);
    Angle from_the_highlight = Angle((0.5 * length((_e107 - _e62))), (0.5 * length((_e107 + _e62))));
    float _e119 = profile_balanced_2_(from_the_highlight, 0.0, highlight_shape);
    vec4 _e127 = blend_alpha(shadow, vec4(1.0, 0.98, 0.92, 1.0), _e119, 0.96, true);
    Light _e130 = u_look.back;
    float _e136 = rim(_e130, surface.normal, surface.view, 0.3, 0.2, 1.0);
    vec4 rim_s_light = clamp(vec4((_e127.xyz + (0.5 * ((_e127.xyz + (_e136 * vec3(0.55, 0.75, 1.0))) - _e127.xyz))), _e127.w), vec4(0.0), vec4(1.0));
    vec4 _e167 = finite_vec4_(((rim_s_light.w <= 0.0) ? rim_s_light : vec4((rim_s_light.xyz / vec3(rim_s_light.w)), rim_s_light.w)));
    return _e167;
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
    vec4 _e20 = finite_vec4_(_e19);
    out_color = _e20;
    return;
}

