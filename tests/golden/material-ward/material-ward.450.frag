#version 450 core
// Anisotropic Ward: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-ward.json says what to put there and how to draw.
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

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) && (largest < 1e30)))) {
        return otherwise;
    }
    vec3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float exp2_stable(float x_1) {
    float clamped = max(x_1, -126.0);
    float whole = roundEven(clamped);
    float f = (clamped - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen_balanced(vec3 v_2) {
    return (v_2 * inversesqrt(max(dot(v_2, v_2), 1e-30)));
}

vec3 any_orthogonal(vec3 n) {
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a = (-1.0 / (sign_ + n.z));
    return vec3((1.0 + (((sign_ * n.x) * n.x) * a)), (((sign_ * n.x) * n.y) * a), (-(sign_) * n.x));
}

mat3x3 world_from_tangent(vec3 tangent, vec3 bitangent, vec3 normal) {
    vec3 t = (tangent * inversesqrt(max(dot(tangent, tangent), 1e-30)));
    vec3 leaning = (t - (dot(t, normal) * normal));
    bool is_usable = (dot(leaning, leaning) > 1e-8);
    vec3 _e14 = any_orthogonal(normal);
    vec3 _e20 = normalize_or((is_usable ? leaning : _e14), vec3(1.0, 0.0, 0.0));
    vec3 _e28 = normalize_moderate((_e20 - (dot(_e20, normal) * normal)), vec3(1.0, 0.0, 0.0));
    vec3 b = cross(normal, _e28);
    return mat3x3(_e28, b, normal);
}

vec3 half_of(vec3 light, vec3 normal_1, vec3 view) {
    vec3 half_ = (light + view);
    vec3 _e8 = normalize_moderate(((dot(half_, half_) > 1e-12) ? half_ : normal_1), normal_1);
    return _e8;
}

float ward(vec3 light_1, vec3 normal_2, vec3 view_1, vec3 x_axis, vec3 y_axis, vec2 widths) {
    float n_l = dot(normal_2, light_1);
    float n_v = dot(normal_2, view_1);
    if (((n_l <= 0.0) || (n_v <= 0.0))) {
        return 0.0;
    }
    vec3 _e14 = half_of(light_1, normal_2, view_1);
    float n_h = max(dot(normal_2, _e14), 1e-6);
    vec2 slope = (vec2(dot(_e14, x_axis), dot(_e14, y_axis)) / (widths * n_h));
    float _e28 = exp2_stable((-1.442695 * min(dot(slope, slope), 200.0)));
    return ((n_l * _e28) / (widths.y * sqrt(max((n_l * n_v), 1e-6))));
}

float reflectance_ward(Light light_2, vec3 normal_3, vec3 view_2, vec3 tangent_1, float roughness, float across) {
    mat3x3 _e8 = world_from_tangent(tangent_1, vec3(0.0), normal_3);
    vec2 widths_1 = vec2(0.25, (across * across));
    float _e16 = ward(light_2.direction, _e8[2], view_2, _e8[0], _e8[1], widths_1);
    return _e16;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float lambert = max(dot(surface.normal, _e5), 0.0);
    vec4 body = vec4((vec3(0.098, 0.1059, 0.1333) + (lambert * vec3(0.3529, 0.3961, 0.4392))), 1.0);
    Light _e23 = u_look.key;
    float _e29 = reflectance_ward(_e23, surface.normal, surface.view, surface.tangent, 0.5, 0.2);
    vec4 highlight = clamp(vec4((body.xyz + (0.55 * ((body.xyz + (_e29 * vec3(0.9569, 0.9412, 0.902))) - body.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return highlight;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal, v_tangent);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_4 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec3 _e27 = normalize_moderate((in_.tangent.xyz - (normal_4 * dot(normal_4, in_.tangent.xyz))), vec3(0.0));
    Surface surface_1 = Surface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), _e27);
    vec4 _e29 = shade(surface_1);
    out_color = _e29;
    return;
}

