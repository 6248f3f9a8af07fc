#version 450 core
// Oren-Nayar: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-oren-nayar.json says what to put there and how to draw.
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

/// Oren and Nayar's rough matt surface (1994, their qualitative model), for a deviation of slopes
/// in radians.
float oren_nayar(vec3 light, vec3 normal, vec3 view, float sigma) {
    float n_l = dot(normal, light);
    float n_v = dot(normal, view);
    if (n_l <= 0.0) {
        return 0.0;
    }
    float s2 = sigma * sigma;
    float a = 1.0 - 0.5 * s2 / (s2 + 0.33);
    float b = 0.45 * s2 / (s2 + 0.09);
    // `across` is the cosine of the angle between light and eye around the normal, times the sines
    // of both. The model's sin of the larger angle times tan of the smaller one is both sines over
    // the larger cosine, so that no angle is needed.
    float across = dot(light, view) - n_l * n_v;
    float larger = max(max(n_l, n_v), 0.001);
    return n_l * (a + b * max(across, 0.0) / larger);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Reflectance
    float oren_nayar_2 = oren_nayar(u_look.key.direction, surface.normal, surface.view, 0.9);
    // Blend
    vec4 body = min(vec4(vec3(0.1725, 0.1647, 0.2) + oren_nayar_2 * vec3(0.851, 0.7961, 0.698),
        1.0), vec4(1.0));
    return body;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position));
    out_color = shade(surface);
}
