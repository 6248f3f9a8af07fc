#version 300 es
// Glossy, jade: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-glossy-jade.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
    Light back;
    Light key;
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
const float LOG2_E = 1.442695;
const ProfileShape body_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.0729164, 1.2200106, 0.1, 1.3103802, 0.55718035, 0u);
const ProfileShape wet_sheen_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.2990327, 1.9773253, 0.1, 0.47253436, 0.19863184, 0u);
const ProfileShape window_tone_shape = ProfileShape(0.997551, 0.06994285, 16.67667, 2.4968514, 0.14, 0.05891116, 0.025379833, 0u);
const ProfileShape through_light_tone_shape = ProfileShape(0.9800666, 0.19866933, 1.91319, 1.9623259, 0.4, 0.5732887, 0.24258775, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

vec2 sin_cos_quick(float x) {
    float y_1 = (x * x);
    float s_3 = (x * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return vec2(s_3, c);
}

float log2_one_minus(float y) {
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_4 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_4, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_4 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_4, c_1));
    vec2 turned = (((s_4 <= 0.0) && (s_4 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float curvature_signed_balanced(float kappa, float slope) {
    return (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp(((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope), -20.0, 20.0))))));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    float _e8 = log2_one_minus(min((q * q), 1.0));
    return ((s <= 0.0) ? 1.0 : ((q >= 1.0) ? 0.0 : min(exp2((shape.exponent * _e8)), 1.0)));
}

float profile_soft_quick_2_(float s_1, ProfileShape shape_1) {
    float q_1 = (s_1 * shape_1.scale);
    float _e8 = log2_one_minus(min((q_1 * q_1), 1.0));
    return ((s_1 <= 0.0) ? 1.0 : ((q_1 >= 1.0) ? 0.0 : min(exp2(max((shape_1.exponent * _e8), -126.0)), 1.0)));
}

float profile_ramp_quick(float s_2, float w, ProfileShape shape_2) {
    float width = sqrt(((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
    float from_offset = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_2.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_3) {
    vec2 place = vec2(((u_2.half_sin * shape_3.half_cos_offset) - (u_2.half_cos * shape_3.half_sin_offset)), ((u_2.half_cos * shape_3.half_cos_offset) + (u_2.half_sin * shape_3.half_sin_offset)));
    float _e19 = profile_soft_quick(place.x, shape_3);
    if ((w_1 < (0.1 * shape_3.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_2, ProfileShape shape_4) {
    vec2 place_1 = vec2(((u_3.half_sin * shape_4.half_cos_offset) - (u_3.half_cos * shape_4.half_sin_offset)), ((u_3.half_cos * shape_4.half_cos_offset) + (u_3.half_sin * shape_4.half_sin_offset)));
    float _e19 = profile_soft_quick_2_(place_1.x, shape_4);
    if ((w_2 < (0.1 * shape_4.edge_deviation))) {
        return _e19;
    }
    float r_1 = (0.19364917 * w_2);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e45 = profile_soft_quick_2_(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_4);
    float _e53 = profile_soft_quick_2_(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_4);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_4, float w_3, ProfileShape shape_5) {
    vec2 place_2 = vec2(((u_4.half_sin * shape_5.half_cos_offset) - (u_4.half_cos * shape_5.half_sin_offset)), ((u_4.half_cos * shape_5.half_cos_offset) + (u_4.half_sin * shape_5.half_sin_offset)));
    bool is_narrow = ((w_3 > 0.0) && (w_3 >= (3.4641016 * shape_5.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place_2.x, w_3, shape_5);
        return _e28;
    }
    float _e30 = profile_soft_quick_2_(place_2.x, shape_5);
    if ((w_3 < (0.1 * shape_5.edge_deviation))) {
        return _e30;
    }
    float r_2 = (0.19364917 * w_3);
    vec2 turn_2 = vec2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    float _e56 = profile_soft_quick_2_(((place_2.x * turn_2.y) - (place_2.y * turn_2.x)), shape_5);
    float _e64 = profile_soft_quick_2_(((place_2.x * turn_2.y) + (place_2.y * turn_2.x)), shape_5);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_6) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_6);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_7) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_8) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_8);
    return _e8;
}

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed_balanced(surface_1.kappa, 0.18);
    float body_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(body_convexity, vec4(0.3725, 0.6824, 0.5255, 1.0), vec4(0.1137, 0.3529, 0.2824, 1.0));
    vec3 _e23 = u_look.key.direction;
    vec3 _e32 = u_look.key.direction;
    Angle body_angle = Angle((0.5 * length((surface_1.normal - _e23))), (0.5 * length((surface_1.normal + _e32))));
    float body_warp = (((2.0 * body_convexity) - 1.0) * 0.35);
    float _e45 = profile_balanced(body_angle, body_warp, body_tone_shape);
    Light _e48 = u_look.key;
    LitLayer _e49 = light_apply(_e48, _e18, _e45);
    vec4 body_blend = clamp(vec4((vec3(0.0471, 0.1647, 0.1255) + (_e49.tone * _e49.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    float _e68 = curvature_signed_balanced(surface_1.kappa, 0.15);
    float window_convexity = (0.5 + (0.5 * _e68));
    vec4 _e83 = curvature_color(window_convexity, vec4(0.2941, 0.4157, 0.3451, 1.0), vec4(0.1098, 0.2275, 0.1882, 1.0));
    Light _e86 = u_look.key;
    Angle _e89 = parametrization_specular_balanced(_e86, surface_1.normal, surface_1.view);
    float wet_sheen_warp = (((2.0 * window_convexity) - 1.0) * 0.15);
    float _e97 = profile_balanced_2_(_e89, wet_sheen_warp, wet_sheen_tone_shape);
    Light _e100 = u_look.key;
    LitLayer _e101 = light_apply(_e100, _e83, _e97);
    vec4 wet_sheen_blend = clamp(vec4((body_blend.xyz + (_e101.tone * _e101.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e125 = curvature_color(window_convexity, vec4(0.9647, 1.0, 0.9569, 1.0), vec4(0.7216, 0.8784, 0.7843, 1.0));
    float window_warp = (((2.0 * window_convexity) - 1.0) * 0.05);
    float _e133 = profile_balanced_3_(_e89, window_warp, window_tone_shape);
    Light _e136 = u_look.key;
    LitLayer _e137 = light_apply(_e136, _e125, _e133);
    vec4 _e142 = blend_alpha(wet_sheen_blend, _e137.color, _e137.tone, 0.9, true);
    float _e145 = curvature_signed_balanced(surface_1.kappa, 0.2);
    float through_light_convexity = (0.5 + (0.5 * _e145));
    vec4 _e160 = curvature_color(through_light_convexity, vec4(0.4784, 0.549, 0.2353, 1.0), vec4(0.2902, 0.4157, 0.1725, 1.0));
    vec3 _e165 = u_look.back.direction;
    vec3 _e174 = u_look.back.direction;
    Angle through_light_angle = Angle((0.5 * length((surface_1.normal - _e165))), (0.5 * length((surface_1.normal + _e174))));
    float through_light_warp = (((2.0 * through_light_convexity) - 1.0) * -0.2);
    float _e187 = profile_balanced_2_(through_light_angle, through_light_warp, through_light_tone_shape);
    Light _e190 = u_look.back;
    LitLayer _e191 = light_apply(_e190, _e160, _e187);
    vec4 output_ = clamp(vec4((_e142.xyz + (_e191.tone * _e191.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
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

