#version 300 es
// Cook-Torrance, GGX: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-ggx.json says what to put there and how to draw.

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
};
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
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

vec3 half_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = (light + view);
    vec3 _e8 = normalize_or(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(vec3 a, vec3 b) {
    vec3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

Reflection reflection_of(vec3 light_1, vec3 normal_1, vec3 view_1) {
    vec3 _e3 = half_of(light_1, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection(dot(normal_1, light_1), dot(normal_1, view_1), n_h, v_h, _e14);
}

float width_of_roughness(float roughness) {
    float _e1 = bounded(roughness);
    float r_1 = clamp(_e1, 0.0, 1.0);
    return max((r_1 * r_1), 0.001);
}

float schlick(float at_normal, float cosine) {
    float m = clamp((1.0 - cosine), 0.0, 1.0);
    float m2_ = (m * m);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m)));
}

float ggx(Reflection r, float width, float at_normal_1) {
    bool local_1 = false;
    if (!((r.n_l <= 0.0))) {
        local_1 = (r.n_v <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e13 = local_1;
    if (_e13) {
        return 0.0;
    }
    float a2_ = (width * width);
    float bottom = max((r.sine2_ + ((a2_ * r.n_h) * r.n_h)), 1e-12);
    float distribution = (a2_ / (bottom * bottom));
    float toward_light = (r.n_v * sqrt((((r.n_l * r.n_l) * (1.0 - a2_)) + a2_)));
    float toward_eye = (r.n_l * sqrt((((r.n_v * r.n_v) * (1.0 - a2_)) + a2_)));
    float visibility = (0.5 / max((toward_light + toward_eye), 1e-9));
    float _e53 = schlick(at_normal_1, r.v_h);
    return min((((distribution * visibility) * _e53) * r.n_l), 1000000.0);
}

float reflectance_lambert(Light light_2, vec3 normal_2) {
    vec3 _e6 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    return max(dot(_e6, light_2.direction), 0.0);
}

float reflectance_ggx(Light light_3, vec3 normal_3, vec3 view_2, float roughness_1, float at_normal_2) {
    vec3 _e10 = normalize_or(normal_3, vec3(0.0, 0.0, 1.0));
    Reflection _e11 = reflection_of(light_3.direction, _e10, view_2);
    float _e12 = width_of_roughness(roughness_1);
    float _e13 = bounded(at_normal_2);
    float _e17 = ggx(_e11, _e12, clamp(_e13, 0.0, 1.0));
    return _e17;
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    float _e5 = reflectance_lambert(_e3, surface_1.normal);
    vec4 _e18 = blend_add(vec4(0.0784, 0.0863, 0.1098, 1.0), vec4(0.2353, 0.2667, 0.3137, 1.0), _e5, 1.0, true);
    Light _e21 = u_look.key;
    float _e26 = reflectance_ggx(_e21, surface_1.normal, surface_1.view, 0.42, 0.85);
    vec4 _e34 = blend_add(_e18, vec4(0.9098, 0.9333, 0.9647, 1.0), _e26, 0.5, true);
    vec4 _e35 = output_(_e34);
    return _e35;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
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

