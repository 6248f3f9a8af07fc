#version 450 core
// Glossy, jade: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-glossy-jade.json says what to put there and how to draw.
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
const ProfileShape body_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.0729164, 1.2200106, 0.1, 1.3103802, 0.55718035, 0u);
const ProfileShape wet_sheen_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.2990327, 1.9773253, 0.1, 0.47253436, 0.19863184, 0u);
const ProfileShape window_tone_shape = ProfileShape(0.997551, 0.06994285, 16.67667, 2.4968514, 0.14, 0.05891116, 0.025379833, 0u);
const ProfileShape through_light_tone_shape = ProfileShape(0.9800666, 0.19866933, 1.91319, 1.9623259, 0.4, 0.5732887, 0.24258775, 0u);

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
    float s_2 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return vec2(s_2, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_1));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope) {
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
}

vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * color.xyz)), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_alpha(vec4 below_1, vec4 color_1, float tone_1, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_2, float tone_2) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light.color) * split.y), 1.0), (tone_2 * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1) {
    float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_2) {
    vec2 place = vec2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
    float _e19 = profile_soft_quick(place.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_2, ProfileShape shape_3) {
    vec2 place_1 = vec2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place_1.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_2);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e56 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_3);
    float _e64 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

vec4 shade(Surface surface) {
    float _e3 = transition_balanced(surface.kappa, 0.18);
    vec4 _e14 = curvature_color(_e3, vec4(0.3725, 0.6824, 0.5255, 1.0), vec4(0.1137, 0.3529, 0.2824, 1.0));
    vec3 _e19 = u_look.key.direction;
    vec3 _e28 = u_look.key.direction;
    Angle body_angle = Angle((0.5 * length((surface.normal - _e19))), (0.5 * length((surface.normal + _e28))));
    float body_warp = (((2.0 * _e3) - 1.0) * 0.35);
    float _e41 = profile_balanced(body_angle, body_warp, body_tone_shape);
    Light _e44 = u_look.key;
    LitLayer _e45 = light_apply(_e44, _e14, _e41);
    vec4 _e55 = blend_add(vec4(0.0471, 0.1647, 0.1255, 1.0), _e45.color, _e45.tone, 1.0, true);
    float _e58 = transition_balanced(surface.kappa, 0.15);
    vec4 _e69 = curvature_color(_e58, vec4(0.2941, 0.4157, 0.3451, 1.0), vec4(0.1098, 0.2275, 0.1882, 1.0));
    Light _e72 = u_look.key;
    Angle _e75 = parametrization_specular_balanced(_e72, surface.normal, surface.view);
    float wet_sheen_warp = (((2.0 * _e58) - 1.0) * 0.15);
    float _e83 = profile_balanced(_e75, wet_sheen_warp, wet_sheen_tone_shape);
    Light _e86 = u_look.key;
    LitLayer _e87 = light_apply(_e86, _e69, _e83);
    vec4 _e92 = blend_add(_e55, _e87.color, _e87.tone, 1.0, true);
    vec4 _e103 = curvature_color(_e58, vec4(0.9647, 1.0, 0.9569, 1.0), vec4(0.7216, 0.8784, 0.7843, 1.0));
    float window_warp = (((2.0 * _e58) - 1.0) * 0.05);
    float _e111 = profile_balanced_2_(_e75, window_warp, window_tone_shape);
    Light _e114 = u_look.key;
    LitLayer _e115 = light_apply(_e114, _e103, _e111);
    vec4 _e120 = blend_alpha(_e92, _e115.color, _e115.tone, 0.9, true);
    float _e123 = transition_balanced(surface.kappa, 0.2);
    vec4 _e134 = curvature_color(_e123, vec4(0.4784, 0.549, 0.2353, 1.0), vec4(0.2902, 0.4157, 0.1725, 1.0));
    vec3 _e139 = u_look.back.direction;
    vec3 _e148 = u_look.back.direction;
    Angle through_light_angle = Angle((0.5 * length((surface.normal - _e139))), (0.5 * length((surface.normal + _e148))));
    float through_light_warp = (((2.0 * _e123) - 1.0) * -0.2);
    float _e161 = profile_balanced(through_light_angle, through_light_warp, through_light_tone_shape);
    Light _e164 = u_look.back;
    LitLayer _e165 = light_apply(_e164, _e134, _e161);
    vec4 _e170 = blend_add(_e120, _e165.color, _e165.tone, 1.0, true);
    return _e170;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e23 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x);
    vec4 _e26 = shade(surface_1);
    out_color = _e26;
    return;
}

