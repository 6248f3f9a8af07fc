#version 300 es
// Anime face: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// anime-face.json says what to put there and how to draw.

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
    Light eye;
    mat3x3 camera_from_world;
    Light back;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
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
struct VectorParts {
    float x;
    float y;
    float z;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const ProfileShape edge_of_the_shadow_shape = ProfileShape(0.7960838, 0.6051864, 15.395454, 2.8429606, 1.3, 0.060679536, 0.026670605, 0u);
const ProfileShape lit_shape = ProfileShape(0.7775727, 0.628793, 0.0, 1.0, 1.36, 0.0, 0.0, 1u);
const ProfileShape shine_tone_shape = ProfileShape(0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0, 1u);
const ProfileShape rim_light_tone_shape = ProfileShape(0.90896577, 0.4168708, 0.0, 1.0, 0.86, 0.0, 0.0, 1u);
const ProfileShape contour_tone_shape = ProfileShape(0.819648, 0.57286745, 0.0, 1.0, 1.22, 0.0, 0.0, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) && true))) {
        return otherwise;
    }
    vec3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    return (((floatBitsToUint(square) & 2139095040u) == 2139095040u) ? otherwise : (scaled * (1.0 / sqrt(square))));
}

vec3 normalize_quick(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    bool is_usable = ((square_1 > 1e-30) && true);
    return (is_usable ? (v_1 * inversesqrt((is_usable ? square_1 : 1.0))) : otherwise_1);
}

vec3 normalize_seen_balanced(vec3 v_2) {
    return (v_2 * inversesqrt(max(dot(v_2, v_2), 1e-30)));
}

vec2 sin_cos_quick(float x) {
    float y = (x * x);
    float s_3 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return vec2(s_3, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_4 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_4, c_1));
    vec2 turned = (((s_4 <= 0.0) && (s_4 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_5 = (u_2.half_sin - 0.0);
    vec2 upper_1 = ((u_2.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_5, u_2.half_cos));
    vec2 turned_1 = (((s_5 <= 0.0) && (s_5 < u_2.half_cos)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope) {
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_shade(vec4 below_1, vec4 color_1, float tone_1, float opacity_1, bool clamped_1) {
    return min(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz * mix(vec3(1.0), color_1.xyz, tone_1)) - below_1.xyz))), 1.0), vec4(1.0));
}

vec4 blend_shade_2_(vec4 below_2, vec4 color_2, float tone_2, float opacity_2, bool clamped_2) {
    return clamp(vec4((below_2.xyz + (opacity_2 * ((below_2.xyz * mix(vec3(1.0), color_2.xyz, tone_2)) - below_2.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_3, float tone_3) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_3.xyz * light.color) * split.y), 1.0), split.x);
}

LitLayer light_apply_2_(Light light_1, vec4 color_4, float tone_4) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4((light_1.color * split_1.y), 1.0), (tone_4 * split_1.x));
}

LitLayer light_apply_3_(Light light_2, vec4 color_5, float tone_5) {
    vec2 split_2 = vec2(min(light_2.intensity, 1.0), max(light_2.intensity, 1.0));
    return LitLayer(vec4(((color_5.xyz * light_2.color) * split_2.y), 1.0), (tone_5 * split_2.x));
}

Angle parametrization_diffuse_balanced(Light light_3, vec3 normal) {
    vec3 _e6 = normalize_quick(normal, vec3(0.0, 0.0, 1.0));
    return Angle((0.5 * length((_e6 - light_3.direction))), (0.5 * length((_e6 + light_3.direction))));
}

Angle parametrization_specular_balanced(Light light_4, vec3 normal_1, vec3 view) {
    vec3 d = (((2.0 * dot(normal_1, view)) * normal_1) - view);
    return Angle((0.5 * length((d - light_4.direction))), (0.5 * length((d + light_4.direction))));
}

Angle parametrization_screen_aligned_balanced(Light light_5, vec3 normal_2, mat3x3 camera_from_world) {
    vec3 d_1 = (camera_from_world * normal_2);
    return Angle((0.5 * length((d_1 - light_5.own_direction))), (0.5 * length((d_1 + light_5.own_direction))));
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

float profile_ramp_quick_2_(float s_2, float w_1, ProfileShape shape_2) {
    float width_1 = sqrt((w_1 * w_1));
    float from_offset_1 = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((0.0 - from_offset_1) / max(width_1, 1e-6))), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_3, float w_2, ProfileShape shape_3) {
    vec2 place = vec2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_2);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned_2_(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset)), _e14, shape_5);
    return _e15;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_6) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_6.half_cos_offset) - (_e6.half_cos * shape_6.half_sin_offset)), _e14, shape_6);
    return _e15;
}

vec4 shade(Surface surface) {
    vec3 place_1 = surface.position_object;
    vec3 from_the_face_s_middle = (place_1 - vec3(0.0, 0.52, -0.18));
    vec3 flattened = (from_the_face_s_middle * vec3(1.0, 0.35, 1.0));
    vec3 _e14 = normalize_or(flattened, vec3(0.0));
    VectorParts high = VectorParts(place_1.x, place_1.y, place_1.z);
    float is_face = smoothstep(0.02, 0.16, high.y);
    vec3 face_or_body = mix(surface.normal, _e14, is_face);
    vec3 shading_direction = (face_or_body * inversesqrt(max(dot(face_or_body, face_or_body), 1e-30)));
    Light _e32 = u_look.key;
    Angle _e33 = parametrization_diffuse_balanced(_e32, shading_direction);
    float _e36 = profile_balanced(_e33, 0.0, edge_of_the_shadow_shape);
    float soft_dark = (1.0 - _e36);
    vec4 _e51 = blend_shade(vec4(0.9843, 0.8902, 0.8118, 1.0), vec4(0.9412, 0.5412, 0.4157, 1.0), soft_dark, 0.55, true);
    float _e54 = profile_balanced_2_(_e33, 0.0, lit_shape);
    float in_shadow = (1.0 - _e54);
    vec4 _e64 = blend_shade_2_(_e51, vec4(0.698, 0.4784, 0.6588, 1.0), in_shadow, 0.85, true);
    float _e67 = transition_balanced(surface.kappa, 0.55);
    vec4 _e75 = curvature_color(_e67, vec4(1.0), vec4(0.2902, 0.1412, 0.251, 1.0));
    Light _e78 = u_look.eye;
    LitLayer _e80 = light_apply(_e78, _e75, 1.0);
    vec4 inked_hollows_blend = clamp(vec4((_e64.xyz + (0.9 * ((_e64.xyz * (_e80.tone * _e80.color.xyz)) - _e64.xyz))), 1.0), vec4(0.0), vec4(1.0));
    Light _e102 = u_look.key;
    Angle _e105 = parametrization_specular_balanced(_e102, surface.normal, surface.view);
    float _e108 = transition_balanced(surface.kappa, 0.2);
    float shine_warp = (((2.0 * _e108) - 1.0) * 0.05);
    float _e116 = profile_balanced_3_(_e105, shine_warp, shine_tone_shape);
    Light _e119 = u_look.key;
    LitLayer _e122 = light_apply_2_(_e119, vec4(1.0), _e116);
    vec4 _e127 = blend_alpha(inked_hollows_blend, _e122.color, _e122.tone, 0.85, true);
    vec3 _e132 = u_look.back.direction;
    vec3 _e141 = u_look.back.direction;
    Angle rim_light_angle = Angle((0.5 * length((surface.normal - _e132))), (0.5 * length((surface.normal + _e141))));
    float rim_light_warp = (((2.0 * _e108) - 1.0) * 0.15);
    float _e154 = profile_balanced_3_(rim_light_angle, rim_light_warp, rim_light_tone_shape);
    Light _e157 = u_look.back;
    LitLayer _e163 = light_apply_3_(_e157, vec4(1.0, 0.9647, 0.9176, 1.0), _e154);
    vec4 _e168 = blend_alpha(_e127, _e163.color, _e163.tone, 0.9, true);
    Light _e171 = u_look.eye;
    mat3x3 _e175 = u_look.camera_from_world;
    Angle _e176 = parametrization_screen_aligned_balanced(_e171, surface.normal, _e175);
    float _e179 = transition_balanced(surface.kappa, 0.12);
    float contour_warp = (((2.0 * _e179) - 1.0) * 0.28);
    float _e187 = profile_balanced_3_(_e176, contour_warp, contour_tone_shape);
    Light _e190 = u_look.eye;
    LitLayer _e193 = light_apply_2_(_e190, vec4(1.0), _e187);
    vec4 contour_blend = clamp(vec4((_e168.xyz * (_e193.tone * _e193.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return contour_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_3 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e24 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x);
    vec4 _e27 = shade(surface_1);
    out_color = _e27;
    return;
}

