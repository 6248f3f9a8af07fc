#version 450 core
// Manga, contours: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-manga-contours.json says what to put there and how to draw.
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light eye;
    mat3x3 camera_from_world;
    Light key;
};
struct Surface {
    vec3 normal;
    float kappa;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct LitLayer {
    vec4 color;
    float tone;
};
struct ProfileShape {
    float half_cos_offset;
    float half_sin_offset;
    float scale;
    float exponent;
    float offset;
    float edge_mean;
    float edge_deviation;
    uint kind;
};
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const ProfileShape shadow_tone_shape = ProfileShape(0.78070694, 0.6248973, 0.0, 1.0, 1.35, 0.0, 0.0, 1u);
const ProfileShape contour_tone_shape = ProfileShape(0.8337121, 0.55219936, 0.0, 1.0, 1.17, 0.0, 0.0, 1u);

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

vec2 sin_cos_quick(float x) {
    float y = (x * x);
    float s_1 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return vec2(s_1, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_1));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope) {
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
}

vec4 blend_multiply(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (0.5 * ((below.xyz * (tone * color.xyz)) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_screen_aligned_balanced(Light light_1, vec3 normal, mat3x3 camera_from_world) {
    vec3 d = (camera_from_world * normal);
    return Angle((0.5 * length((d - light_1.own_direction))), (0.5 * length((d + light_1.own_direction))));
}

float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt((w * w));
    float from_offset = (s * (2.0 + ((s * s) * 0.33333334)));
    float ramp = clamp((0.5 + ((0.0 - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_1) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick(((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset)), _e14, shape_1);
    return _e15;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle inked_hollows_angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e22 = transition_balanced(surface.kappa, 0.3);
    float shadow_warp = (((2.0 * _e22) - 1.0) * 0.35);
    float _e30 = profile_balanced(inked_hollows_angle, shadow_warp, shadow_tone_shape);
    Light _e33 = u_look.key;
    LitLayer _e39 = light_apply(_e33, vec4(0.9843, 0.9765, 0.9569, 1.0), _e30);
    vec4 _e49 = blend_multiply(vec4(0.9843, 0.9765, 0.9569, 1.0), _e39.color, _e39.tone, 0.5, true);
    float _e52 = transition_balanced(surface.kappa, 0.5);
    vec4 _e60 = curvature_color(_e52, vec4(1.0), vec4(0.1647, 0.1451, 0.1882, 1.0));
    Light _e63 = u_look.key;
    LitLayer _e65 = light_apply(_e63, _e60, 1.0);
    vec4 inked_hollows_blend = clamp(vec4((_e49.xyz * (_e65.tone * _e65.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    Light _e81 = u_look.eye;
    mat3x3 _e85 = u_look.camera_from_world;
    Angle _e86 = parametrization_screen_aligned_balanced(_e81, surface.normal, _e85);
    float _e89 = transition_balanced(surface.kappa, 0.12);
    float contour_warp = (((2.0 * _e89) - 1.0) * 0.3);
    float _e97 = profile_balanced(_e86, contour_warp, contour_tone_shape);
    Light _e100 = u_look.eye;
    LitLayer _e103 = light_apply(_e100, vec4(1.0), _e97);
    vec4 contour_blend = clamp(vec4((inked_hollows_blend.xyz * (_e103.tone * _e103.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return contour_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e11 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_1, _e11.x);
    vec4 _e14 = shade(surface_1);
    out_color = _e14;
    return;
}

