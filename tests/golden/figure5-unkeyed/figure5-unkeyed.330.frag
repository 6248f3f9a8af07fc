#version 330 core
// Without directional control: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure5-unkeyed.json says what to put there and how to draw.
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
    Light back;
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
const ProfileShape diffuse_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.3613818, 1.3042344, 0.1, 0.957938, 0.38615924, 0u);
const ProfileShape back_light_tone_shape = ProfileShape(0.9624252, 0.27154693, 3.3838634, 1.9110762, 0.55, 0.32249987, 0.13348491, 0u);
const ProfileShape highlight_tone_shape = ProfileShape(0.9959527, 0.08987855, 11.126125, 3.022525, 0.18, 0.08196669, 0.036355104, 0u);

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

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * color.xyz)), 1.0), vec4(0.0), vec4(1.0));
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
    float back_light_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.25), -20.0, 20.0))))))));
    vec4 _e30 = curvature_color(back_light_convexity, vec4(0.1647, 0.1843, 0.2392, 1.0), vec4(0.0706, 0.0784, 0.1098, 1.0));
    Light _e33 = u_look.key;
    LitLayer _e35 = light_apply(_e33, _e30, 1.0);
    vec4 _e45 = blend_add(vec4(0.0784, 0.0863, 0.1137, 1.0), _e35.color, _e35.tone, 1.0, true);
    vec4 _e56 = curvature_color(back_light_convexity, vec4(0.498, 0.6039, 0.3216, 1.0), vec4(0.2471, 0.4, 0.251, 1.0));
    vec3 _e61 = u_look.key.direction;
    vec3 _e70 = u_look.key.direction;
    Angle diffuse_angle = Angle((0.5 * length((surface.normal - _e61))), (0.5 * length((surface.normal + _e70))));
    float diffuse_warp = (((2.0 * back_light_convexity) - 1.0) * 0.3);
    float _e83 = profile_balanced(diffuse_angle, diffuse_warp, diffuse_tone_shape);
    Light _e86 = u_look.key;
    LitLayer _e87 = light_apply(_e86, _e56, _e83);
    vec4 _e92 = blend_add(_e45, _e87.color, _e87.tone, 1.0, true);
    vec4 _e103 = curvature_color(back_light_convexity, vec4(0.7882, 0.8471, 1.0, 1.0), vec4(0.4784, 0.5608, 0.8157, 1.0));
    vec3 _e108 = u_look.back.direction;
    vec3 _e117 = u_look.back.direction;
    Angle back_light_angle = Angle((0.5 * length((surface.normal - _e108))), (0.5 * length((surface.normal + _e117))));
    float back_light_warp = (((2.0 * back_light_convexity) - 1.0) * 0.1);
    float _e130 = profile_balanced_2_(back_light_angle, back_light_warp, back_light_tone_shape);
    Light _e133 = u_look.back;
    LitLayer _e134 = light_apply(_e133, _e103, _e130);
    vec4 _e139 = blend_add(_e92, _e134.color, _e134.tone, 1.0, true);
    float highlight_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.2), -20.0, 20.0))))))));
    vec4 _e166 = curvature_color(highlight_convexity, vec4(1.0), vec4(0.8745, 0.9098, 0.7529, 1.0));
    Light _e169 = u_look.key;
    Angle _e172 = parametrization_specular_balanced(_e169, surface.normal, surface.view);
    float highlight_warp = (((2.0 * highlight_convexity) - 1.0) * 0.05);
    float _e180 = profile_balanced_2_(_e172, highlight_warp, highlight_tone_shape);
    Light _e183 = u_look.key;
    LitLayer _e184 = light_apply(_e183, _e166, _e180);
    vec4 _e189 = blend_add(_e139, _e184.color, _e184.tone, 1.0, true);
    return _e189;
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

