#version 330 core
// Exaggerated shape: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws normals and depth, for the curvature pass.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// shape-exaggerated.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

struct Object {
    mat4x4 world_from_object;
    /// The inverse transpose, for normals.
    mat3x3 world_from_normal;
    float id;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(max(square, 1e-30)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
vec3 normalize_seen(vec3 v) {
    return normalize_moderate(v, vec3(0.0, 0.0, 1.0));
}

/// The slope n.xy / n.z of a normal in camera axes.
vec2 slope_of(vec3 normal) {
    return normal.xy / vec2(max(normal.z, 0.2));
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
vec4 surface_texel(vec3 normal, float depth, float number) {
    vec2 slope_of_value = slope_of(normal);
    return vec4(slope_of_value, depth, normal.z < 0.0 ? -number : number);
}

/// The normal that the curvature pass sees.
vec3 shade(Surface surface) {
    return surface.normal;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    bool local = false;
    vec3 facing = normalize_seen(in_.normal);
    vec3 toward = normalize(u_view.eye.xyz - u_view.eye.w * in_.position);
    if (!is_front) {
        local = dot(facing, toward) < -0.1;
    } else {
        local = false;
    }
    bool is_behind = local;
    vec3 normal = is_behind ? -facing : facing;
    Surface surface = Surface(normal);
    vec3 seen = (u_view.camera_from_world * vec4(shade(surface), 0.0)).xyz;
    float depth = -(u_view.camera_from_world * vec4(in_.position, 1.0)).z;
    out_color = surface_texel(seen, depth, u_object.id + 1.0);
}
