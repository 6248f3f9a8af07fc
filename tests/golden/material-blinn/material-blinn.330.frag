#version 330 core
// Blinn-Phong: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-blinn.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    vec3 direction;
    /// Unit, toward the light, in the light's own frame.
    vec3 own_direction;
    /// Straight RGB.
    vec3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
};

/// Cosines between normal (n), light (l), view (v) and half-vector (h), of which all models are
/// made; every cosine is at least a little above 0 where it divides.
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    /// The square of the sine between the normal and the half-vector: near a highlight's middle a
    /// cosine has no digits left to tell how far it is.
    float sine2_;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

const float LN_2 = 0.6931472;
const float LOG2_E = 1.442695;

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x) {
    float clamped = max(x, -126.0);
    float whole = roundEven(clamped);
    float f = clamped - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * uintBitsToFloat(uint(int(whole) + 126) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(float x) {
    uint bits = floatBitsToUint(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = int(bits - 1060439283u) >> 23u;
    float mantissa = uintBitsToFloat(bits - (uint(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return float(exponent) + z * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(float y) {
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(float y) {
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return LN_2 * log2_stable(1.0 - y);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(max(square, 1e-30)) : otherwise;
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
vec3 half_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = light + view;
    return normalize_moderate(dot(half_, half_) > 1e-12 ? half_ : normal, normal);
}

/// The square of the sine between two unit vectors.
float sine_squared(vec3 a, vec3 b) {
    vec3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
Reflection reflection_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = half_of(light, normal, view);
    float n_h = clamp(dot(normal, half_), 0.0, 1.0);
    float v_h = clamp(dot(view, half_), 0.0, 1.0);
    return Reflection(dot(normal, light), dot(normal, view), n_h, v_h, sine_squared(normal, half_));
}

/// A cosine to a power, 0 where it is negative; by the square of its sine where that has more
/// digits.
float cosine_power(float cosine, float sine2, float exponent) {
    if (cosine < 0.7) {
        return pow(cosine, exponent);
    }
    return exp2_stable(0.5 * exponent * LOG2_E * log1p_negative(min(sine2, 0.6)));
}

float reflectance_half_lambert(Light light, vec3 normal) {
    float half_ = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half_ * half_, 1.0);
}

float reflectance_blinn_phong(Light light, vec3 normal, vec3 view, float roughness) {
    Reflection r = reflection_of(light.direction, normal, view);
    float width = roughness * roughness;
    float e = 2.0 / (width * width) - 2.0;
    float shine = cosine_power(r.n_h, r.sine2_, e);
    return 0.125 * (e + 8.0) * shine * max(r.n_l, 0.0);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    float half_lambert = reflectance_half_lambert(u_look.key, surface.normal);
    // Blend
    vec4 body = min(vec4(vec3(0.1647, 0.102, 0.0706) + half_lambert * vec3(0.851, 0.5412, 0.1686),
        1.0), vec4(1.0));
    float blinn_phong = reflectance_blinn_phong(u_look.key, surface.normal, surface.view, 0.38);
    // Blend
    vec4 highlight = clamp(vec4(body.xyz + 0.3
        * (body.xyz + blinn_phong * vec3(1.0, 0.9529, 0.8627) - body.xyz), 1.0), vec4(0.0),
        vec4(1.0));
    return highlight;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position));
    out_color = shade(surface);
}
