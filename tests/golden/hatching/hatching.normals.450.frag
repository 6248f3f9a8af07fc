#version 450 core
// Hatching: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws normals and depth, for the curvature pass.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// hatching.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
};
struct Object {
    mat4x4 world_from_object;
    mat3x3 world_from_normal;
    float id;
    float cutoff;
};
struct Surface {
    vec3 normal;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
struct Fragment {
    vec4 normal;
    float depth;
};
layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_normal;
layout(location = 1) out float out_depth;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

vec3 normalize_or(vec3 v, vec3 otherwise) {
    bool local_1 = false;
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if ((largest > 1e-30)) {
        local_1 = (largest < 1e30);
    } else {
        local_1 = false;
    }
    bool _e17 = local_1;
    if (!(_e17)) {
        return otherwise;
    }
    vec3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

vec3 shade(Surface surface_1) {
    return surface_1.normal;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    bool local = false;
    Surface surface = Surface(vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec4 _e10 = u_view.eye;
    float _e15 = u_view.eye.w;
    vec3 _e19 = normalize_or((_e10.xyz - (_e15 * in_.position)), _e7);
    if (!(is_front)) {
        local = (dot(_e7, _e19) < -0.1);
    } else {
        local = false;
    }
    bool is_behind = local;
    vec3 normal = (is_behind ? -(_e7) : _e7);
    surface.normal = normal;
    Surface _e32 = surface;
    vec3 _e33 = shade(_e32);
    mat4x4 _e36 = u_view.camera_from_world;
    vec3 seen = (_e36 * vec4(_e33, 0.0)).xyz;
    mat4x4 _e43 = u_view.camera_from_world;
    float depth = -((_e43 * vec4(in_.position, 1.0)).z);
    float _e52 = u_object.id;
    Fragment _tmp_return = Fragment(vec4(seen, (_e52 + 1.0)), depth);
    out_normal = _tmp_return.normal;
    out_depth = _tmp_return.depth;
    return;
}

