#version 330 core
// Bone, subdued: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure7-bone.json says what to put there and how to draw.
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
    Light eye;
    mat3x3 camera_from_world;
    Light key;
    Light side;
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
const ProfileShape tone_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.1528398, 1.361735, 0.1, 1.1474836, 0.4845149, 0u);
const ProfileShape shade_tone_shape = ProfileShape(0.9950042, 0.099833414, 1.4670527, 1.847488, 0.2, 0.7777539, 0.33241227, 0u);
const ProfileShape light_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.9163208, 3.0838382, 0.1, 0.3121117, 0.13987324, 0u);
const ProfileShape edge_tone_shape = ProfileShape(0.8525245, 0.52268726, 5.0334897, 2.4651666, 1.1, 0.19658314, 0.08474467, 0u);

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

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_4 = (u_2.half_sin - 0.0);
    vec2 upper_1 = ((u_2.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_4, u_2.half_cos));
    vec2 turned_1 = (((s_4 <= 0.0) && (s_4 < u_2.half_cos)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_alpha_2_(vec4 below_1, vec4 color_1, float tone_1, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_shade(vec4 below_2, vec4 color_2, float tone_2, float opacity_2, bool clamped_2) {
    return clamp(vec4((below_2.xyz + (opacity_2 * ((below_2.xyz * mix(vec3(1.0), color_2.xyz, tone_2)) - below_2.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_3, float tone_3) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_3.xyz * light.color) * split.y), 1.0), (tone_3 * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
}

Angle parametrization_screen_aligned_balanced(Light light_2, vec3 normal_1, mat3x3 camera_from_world) {
    vec3 d_1 = (camera_from_world * normal_1);
    return Angle((0.5 * length((d_1 - light_2.own_direction))), (0.5 * length((d_1 + light_2.own_direction))));
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

float profile_filtered_quick(Angle u_3, float w_1, ProfileShape shape_2) {
    vec2 place = vec2(((u_3.half_sin * shape_2.half_cos_offset) - (u_3.half_cos * shape_2.half_sin_offset)), ((u_3.half_cos * shape_2.half_cos_offset) + (u_3.half_sin * shape_2.half_sin_offset)));
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

float profile_filtered_quick_2_(Angle u_4, float w_2, ProfileShape shape_3) {
    vec2 place_1 = vec2(((u_4.half_sin * shape_3.half_cos_offset) - (u_4.half_cos * shape_3.half_sin_offset)), ((u_4.half_cos * shape_3.half_cos_offset) + (u_4.half_sin * shape_3.half_sin_offset)));
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
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_6) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_6);
    return _e8;
}

vec4 shade(Surface surface) {
    float light_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.2), -20.0, 20.0))))))));
    vec4 _e30 = curvature_color(light_convexity, vec4(0.9373, 0.9137, 0.8627, 1.0), vec4(0.7216, 0.6706, 0.5882, 1.0));
    vec3 _e35 = u_look.key.direction;
    vec3 _e44 = u_look.key.direction;
    Angle tone_angle = Angle((0.5 * length((surface.normal - _e35))), (0.5 * length((surface.normal + _e44))));
    float tone_warp = (((2.0 * light_convexity) - 1.0) * 0.3);
    float _e57 = profile_balanced(tone_angle, tone_warp, tone_tone_shape);
    Light _e60 = u_look.key;
    LitLayer _e61 = light_apply(_e60, _e30, _e57);
    vec4 _e71 = blend_alpha(vec4(0.7255, 0.698, 0.6431, 1.0), _e61.color, _e61.tone, 1.0, true);
    vec4 _e82 = curvature_color(light_convexity, vec4(0.8118, 0.7765, 0.7137, 1.0), vec4(0.5608, 0.5098, 0.4392, 1.0));
    vec3 _e87 = u_look.side.direction;
    vec3 _e96 = u_look.side.direction;
    Angle shade_angle = Angle((0.5 * length((surface.normal - _e87))), (0.5 * length((surface.normal + _e96))));
    float shade_warp = (((2.0 * light_convexity) - 1.0) * -0.2);
    float _e109 = profile_balanced(shade_angle, shade_warp, shade_tone_shape);
    Light _e112 = u_look.side;
    LitLayer _e113 = light_apply(_e112, _e82, _e109);
    vec4 _e118 = blend_shade(_e71, _e113.color, _e113.tone, 0.8, true);
    Light _e121 = u_look.key;
    Angle _e124 = parametrization_specular_balanced(_e121, surface.normal, surface.view);
    float _e127 = profile_balanced_2_(_e124, 0.0, light_tone_shape);
    Light _e130 = u_look.key;
    LitLayer _e133 = light_apply(_e130, vec4(1.0), _e127);
    vec4 _e138 = blend_alpha_2_(_e118, _e133.color, _e133.tone, 0.6, true);
    Light _e141 = u_look.eye;
    mat3x3 _e145 = u_look.camera_from_world;
    Angle _e146 = parametrization_screen_aligned_balanced(_e141, surface.normal, _e145);
    float edge_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.1), -20.0, 20.0))))))));
    float edge_warp = (((2.0 * edge_convexity) - 1.0) * 0.2);
    float _e173 = profile_balanced_3_(_e146, edge_warp, edge_tone_shape);
    Light _e176 = u_look.eye;
    LitLayer _e179 = light_apply(_e176, vec4(1.0), _e173);
    vec4 edge_blend = clamp(vec4((_e138.xyz + (0.55 * ((_e138.xyz * (_e179.tone * _e179.color.xyz)) - _e138.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return edge_blend;
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

