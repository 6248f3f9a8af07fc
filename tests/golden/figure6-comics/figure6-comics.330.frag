#version 330 core
// Comics: made by Chiaro 0.1.0, GLSL 3.30.
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

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
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

float curvature_signed_balanced(float kappa, float slope) {
    return (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp(((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope), -20.0, 20.0))))));
}

float curvature_signed_balanced_2_(float kappa_1, float slope_1) {
    return (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp(((((floatBitsToUint(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa_1, -10000.0, 10000.0)) * 0.25), -20.0, 20.0))))));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), split.x);
}

LitLayer light_apply_2_(Light light_1, vec4 color_2, float tone_2) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light_1.color) * split_1.y), 1.0), (tone_2 * split_1.x));
}

Angle parametrization_specular_balanced(Light light_2, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
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

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed_balanced(surface_1.kappa, 0.35);
    float key_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(key_convexity, vec4(0.7059, 0.3412, 0.2902, 1.0), vec4(0.2941, 0.1098, 0.2, 1.0));
    Light _e21 = u_look.key;
    LitLayer _e23 = light_apply(_e21, _e18, 1.0);
    vec4 _e33 = blend_alpha(vec4(0.8863, 0.6275, 0.4353, 1.0), _e23.color, _e23.tone, 1.0, true);
    vec4 _e44 = curvature_color(key_convexity, vec4(0.9529, 0.6902, 0.4392, 1.0), vec4(0.7686, 0.3451, 0.2902, 1.0));
    vec3 _e49 = u_look.key.direction;
    vec3 _e58 = u_look.key.direction;
    Angle light_angle = Angle((0.5 * length((surface_1.normal - _e49))), (0.5 * length((surface_1.normal + _e58))));
    float key_warp = (((2.0 * key_convexity) - 1.0) * 0.45);
    float _e71 = profile_balanced(light_angle, key_warp, key_tone_shape);
    Light _e74 = u_look.key;
    LitLayer _e75 = light_apply_2_(_e74, _e44, _e71);
    vec4 key_blend = clamp(vec4((_e33.xyz + (_e75.tone * (_e75.color.xyz - _e33.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float _e93 = curvature_signed_balanced(surface_1.kappa, 0.3);
    float light_convexity = (0.5 + (0.5 * _e93));
    vec4 _e108 = curvature_color(light_convexity, vec4(0.8157, 0.4863, 0.3686, 1.0), vec4(0.549, 0.2275, 0.298, 1.0));
    vec3 _e113 = u_look.fill.direction;
    vec3 _e122 = u_look.fill.direction;
    Angle bounce_angle = Angle((0.5 * length((surface_1.normal - _e113))), (0.5 * length((surface_1.normal + _e122))));
    float bounce_warp = (((2.0 * light_convexity) - 1.0) * 0.35);
    float _e135 = profile_balanced(bounce_angle, bounce_warp, bounce_tone_shape);
    Light _e138 = u_look.fill;
    LitLayer _e139 = light_apply_2_(_e138, _e108, _e135);
    vec4 bounce_blend = clamp(vec4((key_blend.xyz + (_e139.tone * (_e139.color.xyz - key_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e165 = curvature_color(light_convexity, vec4(1.0, 0.851, 0.6275, 1.0), vec4(0.9412, 0.6431, 0.4078, 1.0));
    float light_warp = (((2.0 * light_convexity) - 1.0) * 0.3);
    float _e173 = profile_balanced(light_angle, light_warp, light_tone_shape);
    Light _e176 = u_look.key;
    LitLayer _e177 = light_apply_2_(_e176, _e165, _e173);
    vec4 light_blend = clamp(vec4((bounce_blend.xyz + (_e177.tone * (_e177.color.xyz - bounce_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float _e195 = curvature_signed_balanced_2_(surface_1.kappa, 0.25);
    float highlight_convexity = (0.5 + (0.5 * _e195));
    vec4 _e210 = curvature_color(highlight_convexity, vec4(1.0, 0.9569, 0.8627, 1.0), vec4(0.949, 0.6588, 0.4196, 1.0));
    vec3 _e215 = u_look.rim.direction;
    vec3 _e224 = u_look.rim.direction;
    Angle rim_angle = Angle((0.5 * length((surface_1.normal - _e215))), (0.5 * length((surface_1.normal + _e224))));
    float rim_warp = (((2.0 * highlight_convexity) - 1.0) * 0.2);
    float _e237 = profile_balanced(rim_angle, rim_warp, rim_tone_shape);
    Light _e240 = u_look.rim;
    LitLayer _e241 = light_apply_2_(_e240, _e210, _e237);
    vec4 rim_blend = clamp(vec4((light_blend.xyz + (_e241.tone * (_e241.color.xyz - light_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e267 = curvature_color(highlight_convexity, vec4(1.0, 0.9804, 0.9412, 1.0), vec4(1.0, 0.8863, 0.7216, 1.0));
    Light _e270 = u_look.key;
    Angle _e273 = parametrization_specular_balanced(_e270, surface_1.normal, surface_1.view);
    float highlight_warp = (((2.0 * highlight_convexity) - 1.0) * 0.1);
    float _e281 = profile_balanced(_e273, highlight_warp, highlight_tone_shape);
    Light _e284 = u_look.key;
    LitLayer _e285 = light_apply_2_(_e284, _e267, _e281);
    vec4 output_ = clamp(vec4((rim_blend.xyz + (_e285.tone * (_e285.color.xyz - rim_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_1;
    vec4 _e11 = u_view.eye;
    float _e16 = u_view.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    vec4 _e27 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e27.x;
    Surface _e29 = surface;
    vec4 _e30 = shade(_e29);
    out_color = _e30;
    return;
}

