#version 450 core
// Light that wraps: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-wrap.json says what to put there and how to draw.
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
const float SMALLEST_NORMAL = 1.1754944e-38;

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

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent_2 = ((shift >= 256) ? (shift - 512) : shift);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_2) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_2) * LN_2_) + series);
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

float bounded(float x_4) {
    uint bits_1 = floatBitsToUint(x_4);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_4 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float powered(float base, float exponent) {
    bool local_1 = false;
    float _e2 = bounded(base);
    float _e3 = bounded(exponent);
    if ((_e3 == 1.0)) {
        return _e2;
    }
    if ((_e3 == 0.0)) {
        return 1.0;
    }
    if ((_e3 == 2.0)) {
        float _e12 = bounded((_e2 * _e2));
        return _e12;
    }
    float magnitude_1 = abs(_e2);
    if ((magnitude_1 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e18 = log_stable(magnitude_1);
    float _e21 = bounded((_e3 * (LOG2_E * _e18)));
    float _e22 = exp2_stable(_e21);
    bool is_even = (floor((_e3 * 0.5)) == (_e3 * 0.5));
    if ((_e2 < 0.0)) {
        local_1 = !(is_even);
    } else {
        local_1 = false;
    }
    bool _e36 = local_1;
    return (_e36 ? -(_e22) : _e22);
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

float cosine_power(float cosine, float sine2_, float exponent_1) {
    if ((cosine < 0.7)) {
        float _e7 = powered(max(cosine, 0.0), exponent_1);
        return _e7;
    }
    float _e14 = log1p_negative(min(sine2_, 0.6));
    float _e16 = exp2_stable((((0.5 * exponent_1) * LOG2_E) * _e14));
    return _e16;
}

float width_of_roughness(float roughness) {
    float _e1 = bounded(roughness);
    float r = clamp(_e1, 0.0, 1.0);
    return max((r * r), 0.001);
}

float exponent_of_width(float width) {
    return max(((2.0 / (width * width)) - 2.0), 0.0);
}

float reflectance_wrap(Light light_2, vec3 normal_2, float wrap) {
    float _e3 = bounded(wrap);
    float w = clamp(_e3, 0.0, 1.0);
    vec3 _e11 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    float cosine_1 = dot(_e11, light_2.direction);
    return max(((cosine_1 + w) / (1.0 + w)), 0.0);
}

float reflectance_blinn_phong(Light light_3, vec3 normal_3, vec3 view_2, float roughness_1) {
    vec3 _e9 = normalize_or(normal_3, vec3(0.0, 0.0, 1.0));
    Reflection _e10 = reflection_of(light_3.direction, _e9, view_2);
    float _e11 = width_of_roughness(roughness_1);
    float _e12 = exponent_of_width(_e11);
    float _e15 = cosine_power(_e10.n_h, _e10.sine2_, _e12);
    return min((((0.125 * (_e12 + 8.0)) * _e15) * max(_e10.n_l, 0.0)), 1000000.0);
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.7);
    vec4 _e19 = blend_add(vec4(0.2902, 0.1137, 0.1333, 1.0), vec4(0.851, 0.4706, 0.3725, 1.0), _e6, 1.0, true);
    Light _e22 = u_look.key;
    float _e26 = reflectance_blinn_phong(_e22, surface_1.normal, surface_1.view, 0.6);
    vec4 _e34 = blend_add(_e19, vec4(1.0, 0.8902, 0.8, 1.0), _e26, 0.25, true);
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

