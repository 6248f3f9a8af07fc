#version 450 core
// Oren-Nayar: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-oren-nayar.json says what to put there and how to draw.
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
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

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

float bounded(float x_2) {
    uint bits = floatBitsToUint(x_2);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
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

float oren_nayar(vec3 light, vec3 normal, vec3 view, float sigma) {
    float n_l = dot(normal, light);
    float n_v = dot(normal, view);
    if ((n_l <= 0.0)) {
        return 0.0;
    }
    float s2_ = (sigma * sigma);
    float a = (1.0 - ((0.5 * s2_) / (s2_ + 0.33)));
    float b = ((0.45 * s2_) / (s2_ + 0.09));
    float across = (dot(light, view) - (n_l * n_v));
    float larger = max(max(n_l, n_v), 0.001);
    return (n_l * (a + ((b * max(across, 0.0)) / larger)));
}

float reflectance_oren_nayar(Light light_1, vec3 normal_1, vec3 view_1, float roughness) {
    float _e4 = bounded(roughness);
    float sigma_1 = clamp(_e4, 0.0, 1.0);
    vec3 _e13 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    float _e14 = oren_nayar(light_1.direction, _e13, view_1, sigma_1);
    return _e14;
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    float _e7 = reflectance_oren_nayar(_e3, surface_1.normal, surface_1.view, 0.9);
    vec4 _e20 = blend_add(vec4(0.1725, 0.1647, 0.2, 1.0), vec4(0.851, 0.7961, 0.698, 1.0), _e7, 1.0, true);
    vec4 _e21 = output_(_e20);
    return _e21;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_2 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_2;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    Surface _e34 = surface;
    vec4 _e35 = shade(_e34);
    vec4 _e36 = finite_vec4_(_e35);
    out_color = _e36;
    return;
}

