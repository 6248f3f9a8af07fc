#version 450 core
// Phong: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-phong.json says what to put there and how to draw.
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
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float clamped_1 = max(x, -126.0);
    float whole = roundEven(clamped_1);
    float f = (clamped_1 - whole);
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

vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (opacity * ((below.xyz + (tone * vec3(1.0))) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

float sine_squared(vec3 a, vec3 b) {
    vec3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

float cosine_power(float cosine, float sine2_, float exponent) {
    if ((cosine < 0.7)) {
        return pow(max(cosine, 0.0), exponent);
    }
    float _e14 = log1p_negative(min(sine2_, 0.6));
    float _e16 = exp2_stable((((0.5 * exponent) * LOG2_E) * _e14));
    return _e16;
}

float reflectance_phong(Light light, vec3 normal, vec3 view, float roughness) {
    float width = (roughness * roughness);
    float e = ((2.0 / (width * width)) - 2.0);
    float n_l = max(dot(normal, light.direction), 0.0);
    vec3 _e19 = normalize_moderate((((2.0 * dot(normal, view)) * normal) - view), normal);
    float _e23 = sine_squared(_e19, light.direction);
    float _e24 = cosine_power(dot(_e19, light.direction), _e23, e);
    return (((0.5 * (e + 2.0)) * _e24) * n_l);
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float lambert = max(dot(surface.normal, _e5), 0.0);
    vec4 body = vec4((vec3(0.1647, 0.0706, 0.1255) + (lambert * vec3(0.7608, 0.2314, 0.2275))), 1.0);
    Light _e23 = u_look.key;
    float _e27 = reflectance_phong(_e23, surface.normal, surface.view, 0.42);
    vec4 _e32 = blend_add(body, vec4(1.0), _e27, 0.32, true);
    return _e32;
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

