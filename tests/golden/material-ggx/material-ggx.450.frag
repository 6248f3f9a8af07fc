#version 450 core
// Cook-Torrance, GGX: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-ggx.json says what to put there and how to draw.
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

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

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

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
float schlick(float at_normal, float cosine) {
    float m = 1.0 - cosine;
    float m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Cook and Torrance's model with the GGX distribution and Smith's height-correlated shadowing
/// (Walter et al. 2007, Heitz 2014).
float ggx(Reflection r, float width, float at_normal) {
    if (r.n_l <= 0.0 || r.n_v <= 0.0) {
        return 0.0;
    }
    float a2 = width * width;
    float bottom = max(r.sine2_ + a2 * r.n_h * r.n_h, 1e-12);
    float distribution = a2 / (bottom * bottom);
    float toward_light = r.n_v * sqrt(r.n_l * r.n_l * (1.0 - a2) + a2);
    float toward_eye = r.n_l * sqrt(r.n_v * r.n_v * (1.0 - a2) + a2);
    float visibility = 0.5 / max(toward_light + toward_eye, 1e-9);
    return min(distribution * visibility * schlick(at_normal, r.v_h) * r.n_l, 1000000.0);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Reflectance
    float lambert = max(dot(surface.normal, u_look.key.direction), 0.0);
    // Blend
    vec4 body = vec4(vec3(0.0784, 0.0863, 0.1098) + lambert * vec3(0.2353, 0.2667, 0.3137), 1.0);
    // Reflectance
    float ggx_2 = ggx(reflection_of(u_look.key.direction, surface.normal, surface.view), 0.1764,
        0.85);
    // Blend
    vec4 highlight = clamp(vec4(body.xyz + 0.5
        * (body.xyz + ggx_2 * vec3(0.9098, 0.9333, 0.9647) - body.xyz), 1.0), vec4(0.0), vec4(1.0));
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
