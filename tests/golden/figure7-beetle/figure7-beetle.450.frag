#version 450 core
// Beetle: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure7-beetle.json says what to put there and how to draw.
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
    vec4 hollows_color_concave;
    Light key;
    vec4 green_sheen_color_convex;
    vec4 gold_color_convex;
    Light side;
    vec4 wing_case_color_convex;
    vec4 wing_case_color_concave;
    ProfileShape wing_case_tone_shape;
};
struct Surface {
    vec3 normal;
    vec3 view;
    float kappa;
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
    vec3 position;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape violet_tone_shape = ProfileShape(0.98472655, 0.17410813, 2.425296, 2.1444545, 0.35, 0.43399706, 0.1847509, 0u);
const ProfileShape gold_tone_shape = ProfileShape(0.9887711, 0.14943813, 3.6826046, 2.8423793, 0.3, 0.2547288, 0.11251208, 0u);
const ProfileShape green_sheen_tone_shape = ProfileShape(0.99820054, 0.059964005, 5.2949586, 2.6937559, 0.12, 0.1805348, 0.07889118, 0u);
const ProfileShape glint_tone_shape = ProfileShape(0.99955004, 0.029995501, 25.006668, 2.4986002, 0.06, 0.039271776, 0.016918294, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise) {
    bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

vec3 finite_vec3_(vec3 v) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return vec3(_e3, _e6, _e9);
}

vec4 finite_vec4_(vec4 v_1) {
    vec3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return vec4(_e2, _e5);
}

vec3 normalize_or(vec3 v_2, vec3 otherwise_1) {
    bool local = false;
    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local = (largest < 1e30);
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    vec3 scaled = (v_2 * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float power_of_two(int n) {
    return uintBitsToFloat((uint((n + 127)) << 23u));
}

float exp2_stable(float x_2) {
    float clamped_4 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_4);
    float f = ((clamped_4 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift_2 >= 256) ? (shift_2 - 512) : shift_2);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_quarter(float x_4) {
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

Angle angle_between(vec3 d, vec3 l) {
    float p_1 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_1 * p_1) + (s_1 * s_1)), 1e-30)));
    return Angle((p_1 * k), (s_1 * k));
}

float atan2_positive(float y_1, float x_5) {
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a) : a);
}

float angle_radians(Angle u) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_turned(Angle u_1, vec2 t) {
    bool local_1 = false;
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_1));
    if ((s_2 <= 0.0)) {
        local_1 = (s_2 < c_1);
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    vec2 turned = (_e32 ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_shifted(Angle u_2, float shift) {
    vec2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    Angle _e8 = angle_turned(u_2, _e7);
    return _e8;
}

float angle_footprint(Angle u_3) {
    vec2 half_ = vec2(u_3.half_sin, u_3.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_1, 0.5);
    return min(_e13, 0.5);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_1 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude = min(abs(a_1), 50.0);
    if ((magnitude < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude));
    float t_2 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float transition(float kappa_2, float slope_1) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float warp(float convexity_1, float amount) {
    return (((2.0 * convexity_1) - 1.0) * clamp(amount, -3.1415927, 3.1415927));
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped ? clamp(mixed, vec4(0.0), vec4(1.0)) : mixed);
}

vec4 blend_add(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_1) {
    vec4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color.xyz)), below_1.w, (opacity_1 * color.w), clamped_1);
    return _e12;
}

vec4 blend_multiply(vec4 below_2, vec4 color_1, float tone_1, float opacity_2, bool clamped_2) {
    vec4 _e12 = blend_finish(below_2, (below_2.xyz * (tone_1 * color_1.xyz)), below_2.w, (opacity_2 * color_1.w), clamped_2);
    return _e12;
}

vec4 blend_alpha(vec4 below_3, vec4 color_2, float tone_2, float opacity_3, bool clamped_3) {
    float a_2 = (opacity_3 * color_2.w);
    float alpha_1 = (below_3.w + ((tone_2 * a_2) * (1.0 - below_3.w)));
    vec4 _e20 = blend_finish(below_3, (below_3.xyz + (tone_2 * (color_2.xyz - below_3.xyz))), alpha_1, a_2, clamped_3);
    return _e20;
}

vec4 output_(vec4 color_3) {
    vec4 _e1 = straight(color_3);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color_4, float tone_3) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color_4.xyz * light.color) * _e4.y), color_4.w), (tone_3 * _e4.x));
}

Angle parametrization_diffuse(Light light_1, vec3 normal) {
    vec3 _e6 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light_1.direction);
    return _e8;
}

Angle parametrization_specular(Light light_2, vec3 normal_1, vec3 view) {
    vec3 _e7 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    vec3 mirrored = (((2.0 * dot(_e7, view)) * _e7) - view);
    vec3 _e13 = normalize_or(mirrored, _e7);
    Angle _e15 = angle_between(_e13, light_2.direction);
    return _e15;
}

float profile_power(float q, float exponent) {
    float log_base = 0.0;
    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        float _e10 = log1p_negative_small((q * q));
        log_base = _e10;
    } else {
        float _e16 = log_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e16;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable(((exponent * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape) {
    bool local_2 = false;
    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_2 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_3 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_3 * shape.scale);
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_1) {
    bool local_3 = false;
    bool local_4 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    vec2 _e50 = sin_cos_quarter((0.19364917 * w));
    Angle _e51 = angle_turned(u_5, _e50);
    float _e52 = profile_point(_e51, shape_1);
    Angle _e57 = angle_turned(u_5, vec2(-(_e50.x), _e50.y));
    float _e58 = profile_point(_e57, shape_1);
    return ((((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0);
}

float profile(Angle angle, float shift_1, ProfileShape shape_2) {
    Angle _e3 = angle_shifted(angle, shift_1);
    float _e4 = angle_footprint(_e3);
    float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
}

vec4 shade(Surface surface_1) {
    float _e3 = transition(surface_1.kappa, 0.2);
    vec4 _e6 = u_look.wing_case_color_convex;
    vec4 _e9 = u_look.wing_case_color_concave;
    vec4 _e10 = curvature_color(_e3, _e6, _e9);
    Light _e13 = u_look.key;
    Angle _e15 = parametrization_diffuse(_e13, surface_1.normal);
    float _e17 = warp(_e3, 0.2);
    ProfileShape _e20 = u_look.wing_case_tone_shape;
    float _e21 = profile(_e15, _e17, _e20);
    Light _e24 = u_look.key;
    LitLayer _e25 = light_apply(_e24, _e10, _e21);
    vec4 _e35 = blend_add(vec4(0.0157, 0.0627, 0.0392, 1.0), _e25.color, _e25.tone, 1.0, true);
    vec4 _e46 = curvature_color(_e3, vec4(0.3529, 0.1647, 0.4314, 1.0), vec4(0.1098, 0.0627, 0.251, 1.0));
    Light _e49 = u_look.side;
    Angle _e52 = parametrization_specular(_e49, surface_1.normal, surface_1.view);
    float _e54 = warp(_e3, 0.15);
    float _e56 = profile(_e52, _e54, violet_tone_shape);
    Light _e59 = u_look.side;
    LitLayer _e60 = light_apply(_e59, _e46, _e56);
    vec4 _e65 = blend_add(_e35, _e60.color, _e60.tone, 1.0, true);
    vec4 _e68 = u_look.gold_color_convex;
    vec4 _e74 = curvature_color(_e3, _e68, vec4(0.2902, 0.3529, 0.0627, 1.0));
    Light _e77 = u_look.key;
    Angle _e80 = parametrization_specular(_e77, surface_1.normal, surface_1.view);
    float _e82 = profile(_e80, _e54, gold_tone_shape);
    Light _e85 = u_look.key;
    LitLayer _e86 = light_apply(_e85, _e74, _e82);
    vec4 _e91 = blend_add(_e65, _e86.color, _e86.tone, 1.0, true);
    vec4 _e94 = u_look.green_sheen_color_convex;
    vec4 _e100 = curvature_color(_e3, _e94, vec4(0.1647, 0.5412, 0.3529, 1.0));
    float _e102 = warp(_e3, 0.1);
    float _e104 = profile(_e80, _e102, green_sheen_tone_shape);
    Light _e107 = u_look.key;
    LitLayer _e108 = light_apply(_e107, _e100, _e104);
    vec4 _e113 = blend_add(_e91, _e108.color, _e108.tone, 1.0, true);
    vec4 _e121 = curvature_color(_e3, vec4(1.0), vec4(0.8471, 1.0, 0.8784, 1.0));
    float _e123 = warp(_e3, 0.05);
    float _e125 = profile(_e80, _e123, glint_tone_shape);
    Light _e128 = u_look.key;
    LitLayer _e129 = light_apply(_e128, _e121, _e125);
    vec4 _e134 = blend_alpha(_e113, _e129.color, _e129.tone, 1.0, true);
    float _e137 = transition(surface_1.kappa, 0.3);
    vec4 _e142 = u_look.hollows_color_concave;
    vec4 _e143 = curvature_color(_e137, vec4(1.0), _e142);
    Light _e146 = u_look.key;
    LitLayer _e148 = light_apply(_e146, _e143, 1.0);
    vec4 _e153 = blend_multiply(_e134, _e148.color, _e148.tone, 1.0, true);
    vec4 _e154 = output_(_e153);
    return _e154;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), 0.0);
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_2 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_2;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    vec4 _e40 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e40.x;
    Surface _e42 = surface;
    vec4 _e43 = shade(_e42);
    vec4 _e44 = finite_vec4_(_e43);
    out_color = _e44;
    return;
}

