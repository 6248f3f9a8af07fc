#version 450 core
// Working drawing: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws what lies behind the first surface, for the passes of hidden lines.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// Textures: u_facet_map 0.
// working-drawing.json says what to put there and how to draw.
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
    /// The number of the material, from 0 on, for the borders of materials.
    float material;
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

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(binding = 0) uniform sampler2D u_facet_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
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

/// The number of an object in texels, from 1 on.
float object_number(float object) {
    return object - 4096.0 * floor(object / 4096.0) + 1.0;
}

/// The number of a facet for [`surface_texel`]: the object's, from 1 on, and what materials and
/// ids add, less than 1. `id` is rounded to a whole number; what is none, or beyond a million, is
/// 0.
float facet_number(float object, float material, float id) {
    float whole = roundEven(abs(id) <= 1000000.0 ? id : 0.0);
    float parts = 128.0 * (material - 32.0 * floor(material / 32.0)) + whole - 128.0
        * floor(whole / 128.0);
    return object_number(object) + parts / 4096.0;
}

/// The normal that the passes of hidden lines see.
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
    // No nearer than the first surface, but for rounding.
    float first = texelFetch(u_facet_map, ivec2(in_.clip.xy), 0).z;
    if (depth <= first + 1e-5 * abs(first)) {
        discard;
    }
    out_color = surface_texel(seen, depth, facet_number(u_object.id, u_object.material, 0.0));
}
