#version 330 core
// Highlight shapes: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// highlight-shapes.json says what to put there and how to draw.
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
    Light spark;
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
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const ProfileShape shadow_side_shape = ProfileShape(0.7484994, 0.66313547, 0.0, 1.0, 1.45, 0.0, 0.0, 1u);
const ProfileShape window_shape = ProfileShape(0.99804753, 0.062459316, 0.0, 1.0, 0.125, 0.0, 0.0, 1u);
const ProfileShape spark_shape = ProfileShape(0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
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

float exp2_stable(float x_1) {
    float clamped_1 = max(x_1, -126.0);
    float whole = roundEven(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float log2_stable(float x_2) {
    uint bits = floatBitsToUint(x_2);
    int exponent = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
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
    float s_1 = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s_1) * c), (1.0 - ((2.0 * s_1) * s_1)));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen_balanced(vec3 v_2) {
    return (v_2 * inversesqrt(max(dot(v_2, v_2), 1e-30)));
}

Angle angle_of(float radians_) {
    float half_angle = (0.5 * min(radians_, PI));
    vec2 _e5 = sin_cos_quarter(half_angle);
    return Angle(max(_e5.x, 0.0), max(_e5.y, 0.0));
}

float atan2_positive(float y_2, float x_5) {
    float small = min(y_2, x_5);
    float large = max(y_2, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_2 > x_5) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, u_1.half_cos));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_3 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_1 = (u_2.half_cos + (u_2.half_sin * 0.0));
    vec2 upper_1 = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_1));
    vec2 turned_1 = (((s_3 <= 0.0) && (s_3 < c_1)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

float angle_of_point(float y_3, float x_6) {
    vec2 p = abs(vec2(x_6, y_3));
    vec2 scaled_1 = ((max(p.x, p.y) > 1.0) ? (0.5 * p) : p);
    float _e14 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_2 = ((x_6 < 0.0) ? (PI - _e14) : _e14);
    return ((y_3 < 0.0) ? -(turned_2) : turned_2);
}

float footprint_of(float x_7) {
    float _e1 = dFdx(x_7);
    float _e2 = dFdy(x_7);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

vec3 any_orthogonal(vec3 n) {
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a_1 = (-1.0 / (sign_ + n.z));
    return vec3((1.0 + (((sign_ * n.x) * n.x) * a_1)), (((sign_ * n.x) * n.y) * a_1), (-(sign_) * n.x));
}

DirectionParts direction_within(vec3 direction, vec3 x_axis, vec3 y_axis) {
    vec3 y_5 = (y_axis * inversesqrt(max(dot(y_axis, y_axis), 1e-30)));
    return DirectionParts(direction, x_axis, y_5, vec2(dot(direction, x_axis), dot(direction, y_5)));
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

float star_reach(float turn, float rays, float inner, float round_) {
    float half_sector = (PI / rays);
    float sector = abs(((turn * rays) - floor(((turn * rays) + 0.5))));
    vec2 _e18 = sin_cos_quarter(min(((2.0 * sector) * half_sector), HALF_PI));
    vec2 _e26 = sin_cos_quarter(max(((1.0 - (2.0 * sector)) * half_sector), 0.0));
    vec2 _e27 = sin_cos_quarter(half_sector);
    float corner = _e27.x;
    float straight = ((inner * corner) / max(((inner * _e26.x) + _e18.x), 1e-6));
    return mix(straight, 1.0, round_);
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

vec3 split_direction(vec3 direction_2, vec3 x_axis_1, vec3 y_axis_1, float x_8, float y_4) {
    DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    vec2 side = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(_e5.place, vec2(0.0)));
    vec3 _e18 = direction_moved(_e5, (-(vec2(x_8, y_4)) * side));
    return _e18;
}

vec3 square_direction(vec3 direction_3, vec3 x_axis_2, vec3 y_axis_2, float amount, float sharpness) {
    DirectionParts _e5 = direction_within(direction_3, x_axis_2, y_axis_2);
    float square_3 = dot(_e5.place, _e5.place);
    float apart = (abs(_e5.place.x) - abs(_e5.place.y));
    float aside_1 = min(((apart * apart) / max(square_3, 1e-20)), 1.0);
    float _e24 = log1p_negative(aside_1);
    float _e26 = exp2_stable(((sharpness * LOG2_E) * _e24));
    float corner_1 = (((square_3 > 1e-20) && (aside_1 < 1.0)) ? _e26 : 0.0);
    vec3 _e38 = direction_moved(_e5, ((-(amount) * corner_1) * _e5.place));
    return _e38;
}

Angle star_angle(vec3 direction_4, vec3 middle, vec3 x_axis_3, vec3 y_axis_3, int rays_1, float inner_1, float round_1, float turn_1) {
    DirectionParts _e8 = direction_within(direction_4, x_axis_3, y_axis_3);
    Angle u_3 = Angle((0.5 * length((_e8.direction - middle))), (0.5 * length((_e8.direction + middle))));
    float _e24 = angle_of_point(_e8.place.y, _e8.place.x);
    float around = ((_e24 - turn_1) / 6.2831855);
    float _e29 = star_reach(around, 4.0, inner_1, round_1);
    float _e32 = atan2_positive(u_3.half_sin, u_3.half_cos);
    Angle _e36 = angle_of(((2.0 * _e32) / _e29));
    return _e36;
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width_1 = sqrt((w * w));
    float from_offset = (s * (2.0 + ((s * s) * 0.33333334)));
    float ramp = clamp((0.5 + ((0.0 - from_offset) / max(width_1, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_1) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick(((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset)), _e14, shape_1);
    return _e15;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_2) {
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick(((_e6.half_sin * shape_2.half_cos_offset) - (_e6.half_cos * shape_2.half_sin_offset)), _e14, shape_2);
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

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle turned_from_the_key = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e22 = profile_balanced(turned_from_the_key, 0.0, shadow_side_shape);
    float in_the_dark = (1.0 - _e22);
    vec4 shadow = min(vec4((vec3(0.83, 0.19, 0.18) * mix(vec3(1.0), vec3(0.52, 0.25, 0.46), in_the_dark)), 1.0), vec4(1.0));
    Light _e44 = u_look.key;
    vec3 _e46 = half_vector(_e44, surface.view);
    AxesAround _e51 = axes(_e46, vec3(0.0, 1.0, 0.0));
    vec3 _e57 = split_direction(surface.normal, _e51.x_axis, _e51.y_axis, 0.15, 0.15);
    vec3 _e62 = square_direction(_e57, _e51.x_axis, _e51.y_axis, 0.3, 4.0);
    Angle window_angle = Angle((0.5 * length((_e62 - _e46))), (0.5 * length((_e62 + _e46))));
    float _e74 = profile_balanced_2_(window_angle, 0.0, window_shape);
    vec4 _e82 = blend_alpha(shadow, vec4(1.0, 0.97, 0.9, 1.0), _e74, 0.95, true);
    Light _e85 = u_look.spark;
    vec3 _e87 = half_vector(_e85, surface.view);
    AxesAround _e92 = axes(_e87, vec3(0.0, 1.0, 0.0));
    Angle _e100 = star_angle(surface.normal, _e87, _e92.x_axis, _e92.y_axis, 4, 0.28, 0.0, 0.3);
    float _e103 = profile_balanced_2_(_e100, 0.0, spark_shape);
    vec4 spark_s_light = clamp(vec4((_e82.xyz + (_e103 * (vec3(1.0, 0.83, 0.42) - _e82.xyz))), 1.0), vec4(0.0), vec4(1.0));
    Light _e122 = u_look.back;
    float _e128 = rim(_e122, surface.normal, surface.view, 0.38, 0.15, 1.0);
    vec4 rim_s_light = clamp(vec4((spark_s_light.xyz + (0.75 * ((spark_s_light.xyz + (_e128 * vec3(0.55, 0.72, 1.0))) - spark_s_light.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return rim_s_light;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))));
    vec4 _e19 = shade(surface_1);
    out_color = _e19;
    return;
}

