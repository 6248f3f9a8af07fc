#version 300 es
// Profile isocurves: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// figure3-isocurves.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
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
struct Look {
    Light key;
    float cut_off;
    float fall_off;
    float offset;
    ProfileShape profile_tone_shape;
};
struct Surface {
    vec3 normal;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct LitLayer {
    vec4 color;
    float tone;
};
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;

layout(std140) uniform LookBlock { Look u_look; };

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

float log2_one_minus(float y) {
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float atan2_positive(float y_1, float x) {
    float small = min(y_1, x);
    float large = max(y_1, x);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x) ? (HALF_PI - a) : a);
}

float angle_radians(Angle u) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

float angle_footprint(Angle u_1) {
    vec2 half_ = vec2(u_1.half_sin, u_1.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle angle_turned(Angle u_2, vec2 t) {
    float s_2 = (u_2.half_sin - 0.0);
    vec2 upper = ((u_2.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, u_2.half_cos));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < u_2.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float bounded(float x_1) {
    uint bits = floatBitsToUint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float footprint_of(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float step_filtered(float x_3, float edge, float w) {
    float _e4 = bounded((x_3 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

float profile_power_quick(float q, float exponent) {
    float y_2 = min((q * q), 1.0);
    float _e5 = log2_one_minus(y_2);
    float power = exp2(max((exponent * _e5), -126.0));
    return ((q >= 1.0) ? 0.0 : clamp(power, 0.0, 1.0));
}

vec2 profile_place(Angle u_3, ProfileShape shape) {
    return vec2(((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset)), ((u_3.half_cos * shape.half_cos_offset) + (u_3.half_sin * shape.half_sin_offset)));
}

float profile_soft_quick(float s, ProfileShape shape_1) {
    float _e5 = profile_power_quick((s * shape_1.scale), shape_1.exponent);
    return ((s <= 0.0) ? 1.0 : _e5);
}

float profile_ramp_quick(float s_1, float w_1, ProfileShape shape_2) {
    float width = sqrt(((w_1 * w_1) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_2.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_4, float w_2, ProfileShape shape_3) {
    if ((shape_3.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    vec2 _e7 = profile_place(u_4, shape_3);
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if (((shape_3.kind == PROFILE_STEP) || is_narrow)) {
        float _e20 = profile_ramp_quick(_e7.x, w_2, shape_3);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e22;
    }
    float r_1 = (0.19364917 * w_2);
    vec2 turn = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_3);
    float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_3);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float threshold(float value, float edge_1, float softness) {
    float _e3 = bounded(value);
    float _e4 = footprint_of(value);
    float _e9 = step_filtered(_e3, edge_1, length(vec2(min(_e4, 1000000000000000.0), softness)));
    return _e9;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle profile_angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    ProfileShape _e23 = u_look.profile_tone_shape;
    float _e24 = profile_balanced(profile_angle, 0.0, _e23);
    Light _e27 = u_look.key;
    LitLayer _e33 = light_apply(_e27, vec4(0.86, 0.8, 0.7, 1.0), _e24);
    vec4 profile_blend = clamp(vec4((vec3(0.11, 0.13, 0.19) + (_e33.tone * _e33.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    float _e50 = angle_radians(profile_angle);
    float _e53 = u_look.offset;
    float _e55 = bounded((_e50 - _e53));
    float _e58 = threshold(_e55, 0.012, 0.0);
    float _e61 = threshold(_e55, -0.012, 0.0);
    float offset_isocurve_line = (_e61 - _e58);
    float offset_isocurve_tone = max(offset_isocurve_line, 0.0);
    vec4 _e72 = blend_alpha(profile_blend, vec4(0.16, 0.36, 0.85, 1.0), offset_isocurve_tone, 1.0, true);
    float _e73 = angle_radians(profile_angle);
    float _e76 = u_look.fall_off;
    float _e78 = bounded((_e73 - _e76));
    float _e81 = threshold(_e78, 0.012, 0.0);
    float _e84 = threshold(_e78, -0.012, 0.0);
    float falloff_isocurve_line = (_e84 - _e81);
    float falloff_isocurve_tone = max(falloff_isocurve_line, 0.0);
    vec4 _e95 = blend_alpha(_e72, vec4(0.16, 0.36, 0.85, 1.0), falloff_isocurve_tone, 1.0, true);
    float _e96 = angle_radians(profile_angle);
    float _e99 = u_look.cut_off;
    float _e101 = bounded((_e96 - _e99));
    float _e104 = threshold(_e101, 0.012, 0.0);
    float _e107 = threshold(_e101, -0.012, 0.0);
    float cutoff_isocurve_line = (_e107 - _e104);
    float cutoff_isocurve_tone = max(cutoff_isocurve_line, 0.0);
    vec4 _e118 = blend_alpha(_e95, vec4(0.16, 0.36, 0.85, 1.0), cutoff_isocurve_tone, 1.0, true);
    return _e118;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    Surface surface_1 = Surface(normal);
    vec4 _e7 = shade(surface_1);
    out_color = _e7;
    return;
}

