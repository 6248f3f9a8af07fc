#version 300 es
// Anisotropic Ward: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-ward.json says what to put there and how to draw.

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
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 tangent;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
    vec4 tangent;
};
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
smooth in vec4 v_tangent;
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
    float clamped_2 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_2);
    float f = ((clamped_2 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p * _e33) * _e37);
}

float bounded(float x_3) {
    uint bits = floatBitsToUint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec3 any_orthogonal(vec3 n_1) {
    float sign_ = ((n_1.z >= 0.0) ? 1.0 : -1.0);
    float a = (-1.0 / (sign_ + n_1.z));
    return vec3((1.0 + (((sign_ * n_1.x) * n_1.x) * a)), (((sign_ * n_1.x) * n_1.y) * a), (-(sign_) * n_1.x));
}

mat3x3 world_from_tangent(vec3 tangent, vec3 bitangent, vec3 normal) {
    vec3 _e7 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    vec3 _e10 = normalize_or(tangent, vec3(0.0));
    vec3 leaning = (_e10 - (dot(_e10, _e7) * _e7));
    bool is_usable = (dot(leaning, leaning) > 1e-8);
    vec3 _e17 = any_orthogonal(_e7);
    vec3 _e23 = normalize_or((is_usable ? leaning : _e17), vec3(1.0, 0.0, 0.0));
    vec3 _e31 = normalize_or((_e23 - (dot(_e23, _e7) * _e7)), vec3(1.0, 0.0, 0.0));
    vec3 b = cross(_e7, _e31);
    return mat3x3(_e31, ((dot(b, bitangent) < 0.0) ? -(b) : b), _e7);
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

vec4 output_(vec4 color_1) {
    vec4 _e1 = straight(color_1);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec3 half_of(vec3 light, vec3 normal_1, vec3 view) {
    vec3 half_ = (light + view);
    vec3 _e8 = normalize_or(((dot(half_, half_) > 1e-12) ? half_ : normal_1), normal_1);
    return _e8;
}

float width_of_roughness(float roughness) {
    float _e1 = bounded(roughness);
    float r = clamp(_e1, 0.0, 1.0);
    return max((r * r), 0.001);
}

float ward(vec3 light_1, vec3 normal_2, vec3 view_1, vec3 x_axis, vec3 y_axis, vec2 widths) {
    bool local_1 = false;
    float n_l = dot(normal_2, light_1);
    float n_v = dot(normal_2, view_1);
    if (!((n_l <= 0.0))) {
        local_1 = (n_v <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e16 = local_1;
    if (_e16) {
        return 0.0;
    }
    vec3 _e18 = half_of(light_1, normal_2, view_1);
    float n_h = max(dot(normal_2, _e18), 1e-6);
    vec2 slope = (vec2(dot(_e18, x_axis), dot(_e18, y_axis)) / (widths * n_h));
    float _e32 = exp2_stable((-1.442695 * min(dot(slope, slope), 200.0)));
    return min(((n_l * _e32) / (((4.0 * widths.x) * widths.y) * sqrt(max((n_l * n_v), 1e-6)))), 1000000.0);
}

float reflectance_lambert(Light light_2, vec3 normal_3) {
    vec3 _e6 = normalize_or(normal_3, vec3(0.0, 0.0, 1.0));
    return max(dot(_e6, light_2.direction), 0.0);
}

float reflectance_ward(Light light_3, vec3 normal_4, vec3 view_2, vec3 tangent_1, float roughness_1, float across) {
    mat3x3 _e8 = world_from_tangent(tangent_1, vec3(0.0), normal_4);
    float _e9 = width_of_roughness(roughness_1);
    float _e10 = width_of_roughness(across);
    vec2 widths_1 = max(vec2(_e9, _e10), vec2(0.0025));
    float _e19 = ward(light_3.direction, _e8[2], view_2, _e8[0], _e8[1], widths_1);
    return _e19;
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    float _e5 = reflectance_lambert(_e3, surface_1.normal);
    vec4 _e18 = blend_add(vec4(0.098, 0.1059, 0.1333, 1.0), vec4(0.3529, 0.3961, 0.4392, 1.0), _e5, 1.0, true);
    Light _e21 = u_look.key;
    float _e27 = reflectance_ward(_e21, surface_1.normal, surface_1.view, surface_1.tangent, 0.5, 0.2);
    vec4 _e35 = blend_add(_e18, vec4(0.9569, 0.9412, 0.902, 1.0), _e27, 0.55, true);
    vec4 _e36 = output_(_e35);
    return _e36;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal, v_tangent);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_5 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_5;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    vec3 _e44 = normalize_or((in_.tangent.xyz - (normal_5 * dot(normal_5, in_.tangent.xyz))), in_.tangent.xyz);
    surface.tangent = _e44;
    Surface _e45 = surface;
    vec4 _e46 = shade(_e45);
    vec4 _e47 = finite_vec4_(_e46);
    out_color = _e47;
    return;
}

