#version 450 core
// Anisotropic Ward: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-ward.json says what to put there and how to draw.
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
    vec3 tangent;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
    vec4 tangent;
};

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 2) smooth in vec4 v_tangent;
layout(location = 0) out vec4 out_color;

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(float x) {
    return (floatBitsToUint(x) & 2139095040u) != 2139095040u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest > 1e-30 && largest < 1e30)) {
        return otherwise;
    }
    vec3 scaled = v * (1.0 / largest);
    float square = dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
}

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

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
vec3 any_orthogonal(vec3 n) {
    float sign_ = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign_ + n.z);
    return vec3(1.0 + sign_ * n.x * n.x * a, sign_ * n.x * n.y * a, -sign_ * n.x);
}

/// Unit tangent, bitangent and normal as columns: a mesh's tangent and bitangent stood upright on a
/// normal (Gram and Schmidt), with the handedness of the mesh. Where the tangent is missing or lies
/// along the normal, another one takes its place.
mat3x3 world_from_tangent(vec3 tangent, vec3 bitangent, vec3 normal) {
    vec3 t = tangent * inversesqrt(max(dot(tangent, tangent), 1e-30));
    vec3 leaning = t - dot(t, normal) * normal;
    bool is_usable = dot(leaning, leaning) > 1e-8;
    vec3 any_orthogonal_value = any_orthogonal(normal);
    vec3 rough = normalize_or(is_usable ? leaning : any_orthogonal_value, vec3(1.0, 0.0, 0.0));
    vec3 upright = normalize_moderate(rough - dot(rough, normal) * normal, vec3(1.0, 0.0, 0.0));
    vec3 b = cross(normal, upright);
    return mat3x3(upright, b, normal);
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
vec3 half_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = light + view;
    return normalize_moderate(dot(half_, half_) > 1e-12 ? half_ : normal, normal);
}

/// Ward's anisotropic highlight (1992, in the form of Walter 2005) with a width along each of two
/// axes.
float ward(vec3 light, vec3 normal, vec3 view, vec3 x_axis, vec3 y_axis, vec2 widths) {
    float n_l = dot(normal, light);
    float n_v = dot(normal, view);
    if (n_l <= 0.0 || n_v <= 0.0) {
        return 0.0;
    }
    vec3 half_ = half_of(light, normal, view);
    float n_h = max(dot(normal, half_), 1e-6);
    vec2 slope = vec2(dot(half_, x_axis), dot(half_, y_axis)) / (widths * n_h);
    float lobe = exp2_stable(-1.442695 * min(dot(slope, slope), 200.0));
    return n_l * lobe / (widths.y * sqrt(max(n_l * n_v, 1e-6)));
}

float reflectance_ward(Light light, vec3 normal, vec3 view, vec3 tangent, float roughness,
    float across) {
    mat3x3 frame = world_from_tangent(tangent, vec3(0.0), normal);
    vec2 widths = vec2(0.25, across * across);
    return ward(light.direction, frame[2], view, frame[0], frame[1], widths);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Reflectance
    float lambert = max(dot(surface.normal, u_look.key.direction), 0.0);
    // Blend
    vec4 body = vec4(vec3(0.098, 0.1059, 0.1333) + lambert * vec3(0.3529, 0.3961, 0.4392), 1.0);
    float ward_2 = reflectance_ward(u_look.key, surface.normal, surface.view, surface.tangent, 0.5,
        0.2);
    // Blend
    vec4 highlight = clamp(vec4(body.xyz + 0.55
        * (body.xyz + ward_2 * vec3(0.9569, 0.9412, 0.902) - body.xyz), 1.0), vec4(0.0), vec4(1.0));
    return highlight;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal, v_tangent);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec3 normalize_moderate_value = normalize_moderate(in_.tangent.xyz - normal
        * dot(normal, in_.tangent.xyz), vec3(0.0));
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        normalize_moderate_value);
    out_color = shade(surface);
}
