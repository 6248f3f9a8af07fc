#version 330 core
// Blinn-Phong: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-blinn.json says what to put there and how to draw.
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
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float clamped = max(x, -126.0);
    float whole = roundEven(clamped);
    float f = (clamped - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float log2_stable(float x_1) {
    uint bits = floatBitsToUint(x_1);
    int exponent_1 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
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
    float _e7 = log2_stable((1.0 - y_1));
    return (LN_2_ * _e7);
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

vec3 half_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = (light + view);
    vec3 _e8 = normalize_moderate(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
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

float cosine_power(float cosine, float sine2_, float exponent) {
    if ((cosine < 0.7)) {
        return pow(cosine, exponent);
    }
    float _e12 = log1p_negative(min(sine2_, 0.6));
    float _e14 = exp2_stable((((0.5 * exponent) * LOG2_E) * _e12));
    return _e14;
}

float reflectance_half_lambert(Light light_2, vec3 normal_2) {
    float half_1 = (0.5 + (0.5 * dot(normal_2, light_2.direction)));
    return min((half_1 * half_1), 1.0);
}

float reflectance_blinn_phong(Light light_3, vec3 normal_3, vec3 view_2, float roughness) {
    Reflection _e5 = reflection_of(light_3.direction, normal_3, view_2);
    float width = (roughness * roughness);
    float e = ((2.0 / (width * width)) - 2.0);
    float _e14 = cosine_power(_e5.n_h, _e5.sine2_, e);
    return (((0.125 * (e + 8.0)) * _e14) * max(_e5.n_l, 0.0));
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.key;
    float _e5 = reflectance_half_lambert(_e3, surface.normal);
    vec4 body = min(vec4((vec3(0.1647, 0.102, 0.0706) + (_e5 * vec3(0.851, 0.5412, 0.1686))), 1.0), vec4(1.0));
    Light _e23 = u_look.key;
    float _e27 = reflectance_blinn_phong(_e23, surface.normal, surface.view, 0.38);
    vec4 highlight = clamp(vec4((body.xyz + (0.3 * ((body.xyz + (_e27 * vec3(1.0, 0.9529, 0.8627))) - body.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return highlight;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_4 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))));
    vec4 _e19 = shade(surface_1);
    out_color = _e19;
    return;
}

