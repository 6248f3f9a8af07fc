#version 450 core
// Comics: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-comics.json says what to put there and how to draw.
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
    Light rim;
    Light fill;
};
struct Surface {
    vec3 normal;
    vec3 view;
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
    vec3 position;
    vec3 normal;
};
const ProfileShape key_tone_shape = ProfileShape(0.8472551, 0.5311862, 0.0, 1.0, 1.12, 0.0, 0.0, 1u);
const ProfileShape bounce_tone_shape = ProfileShape(0.9358968, 0.35227424, 0.0, 1.0, 0.72, 0.0, 0.0, 1u);
const ProfileShape light_tone_shape = ProfileShape(0.96638995, 0.25708055, 0.0, 1.0, 0.52, 0.0, 0.0, 1u);
const ProfileShape rim_tone_shape = ProfileShape(0.9130889, 0.40776044, 0.0, 1.0, 0.84, 0.0, 0.0, 1u);
const ProfileShape highlight_tone_shape = ProfileShape(0.99280864, 0.119712204, 0.0, 1.0, 0.24, 0.0, 0.0, 1u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
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

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_diffuse_balanced(Light light_1, vec3 normal) {
    return Angle((0.5 * length((normal - light_1.direction))), (0.5 * length((normal + light_1.direction))));
}

Angle parametrization_specular_balanced(Light light_2, vec3 normal_1, vec3 view) {
    vec3 d = (((2.0 * dot(normal_1, view)) * normal_1) - view);
    return Angle((0.5 * length((d - light_2.direction))), (0.5 * length((d + light_2.direction))));
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
    float _e3 = transition_balanced(surface.kappa, 0.35);
    vec4 _e14 = curvature_color(_e3, vec4(0.7059, 0.3412, 0.2902, 1.0), vec4(0.2941, 0.1098, 0.2, 1.0));
    Light _e17 = u_look.key;
    LitLayer _e19 = light_apply(_e17, _e14, 1.0);
    vec4 _e29 = blend_alpha(vec4(0.8863, 0.6275, 0.4353, 1.0), _e19.color, _e19.tone, 1.0, true);
    vec4 _e40 = curvature_color(_e3, vec4(0.9529, 0.6902, 0.4392, 1.0), vec4(0.7686, 0.3451, 0.2902, 1.0));
    Light _e43 = u_look.key;
    Angle _e45 = parametrization_diffuse_balanced(_e43, surface.normal);
    float key_warp = (((2.0 * _e3) - 1.0) * 0.45);
    float _e53 = profile_balanced(_e45, key_warp, key_tone_shape);
    Light _e56 = u_look.key;
    LitLayer _e57 = light_apply(_e56, _e40, _e53);
    vec4 _e62 = blend_alpha(_e29, _e57.color, _e57.tone, 1.0, true);
    float _e65 = transition_balanced(surface.kappa, 0.3);
    vec4 _e76 = curvature_color(_e65, vec4(0.8157, 0.4863, 0.3686, 1.0), vec4(0.549, 0.2275, 0.298, 1.0));
    Light _e79 = u_look.fill;
    Angle _e81 = parametrization_diffuse_balanced(_e79, surface.normal);
    float bounce_warp = (((2.0 * _e65) - 1.0) * 0.35);
    float _e89 = profile_balanced(_e81, bounce_warp, bounce_tone_shape);
    Light _e92 = u_look.fill;
    LitLayer _e93 = light_apply(_e92, _e76, _e89);
    vec4 _e98 = blend_alpha(_e62, _e93.color, _e93.tone, 1.0, true);
    vec4 _e109 = curvature_color(_e65, vec4(1.0, 0.851, 0.6275, 1.0), vec4(0.9412, 0.6431, 0.4078, 1.0));
    float light_warp = (((2.0 * _e65) - 1.0) * 0.3);
    float _e117 = profile_balanced(_e45, light_warp, light_tone_shape);
    Light _e120 = u_look.key;
    LitLayer _e121 = light_apply(_e120, _e109, _e117);
    vec4 _e126 = blend_alpha(_e98, _e121.color, _e121.tone, 1.0, true);
    float _e129 = transition_balanced(surface.kappa, 0.25);
    vec4 _e140 = curvature_color(_e129, vec4(1.0, 0.9569, 0.8627, 1.0), vec4(0.949, 0.6588, 0.4196, 1.0));
    Light _e143 = u_look.rim;
    Angle _e145 = parametrization_diffuse_balanced(_e143, surface.normal);
    float rim_warp = (((2.0 * _e129) - 1.0) * 0.2);
    float _e153 = profile_balanced(_e145, rim_warp, rim_tone_shape);
    Light _e156 = u_look.rim;
    LitLayer _e157 = light_apply(_e156, _e140, _e153);
    vec4 _e162 = blend_alpha(_e126, _e157.color, _e157.tone, 1.0, true);
    vec4 _e173 = curvature_color(_e129, vec4(1.0, 0.9804, 0.9412, 1.0), vec4(1.0, 0.8863, 0.7216, 1.0));
    Light _e176 = u_look.key;
    Angle _e179 = parametrization_specular_balanced(_e176, surface.normal, surface.view);
    float highlight_warp = (((2.0 * _e129) - 1.0) * 0.1);
    float _e187 = profile_balanced(_e179, highlight_warp, highlight_tone_shape);
    Light _e190 = u_look.key;
    LitLayer _e191 = light_apply(_e190, _e173, _e187);
    vec4 _e196 = blend_alpha(_e162, _e191.color, _e191.tone, 1.0, true);
    return _e196;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e23 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x);
    vec4 _e26 = shade(surface_1);
    out_color = _e26;
    return;
}

