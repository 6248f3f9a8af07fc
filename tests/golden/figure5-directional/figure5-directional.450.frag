#version 450 core
// Directional control: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure5-directional.json says what to put there and how to draw.
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
struct Look {
    vec4 highlight_color_convex;
    vec4 highlight_color_concave;
    Light key;
    vec4 back_light_color_convex;
    vec4 back_light_color_concave;
    float back_light_warp_amount;
    Light back;
    ProfileShape back_light_tone_shape;
    ProfileShape diffuse_tone_shape;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float PI = 3.1415927;
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape highlight_tone_shape = ProfileShape(0.9959527, 0.08987855, 11.126125, 3.022525, 0.18, 0.08196669, 0.036355104, 0u);

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
    float y_1 = (x * x);
    float s_5 = (x * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return vec2(s_5, c);
}

float log2_one_minus(float y) {
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_6 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_6, c_1));
    vec2 turned = (((s_6 <= 0.0) && (s_6 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color.xyz * light.color) * _e4.y), color.w), (tone * _e4.x));
}

LitLayer light_apply_2_(Light light_1, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light_1.color) * split.y), 1.0), split.x);
}

LitLayer light_apply_3_(Light light_2, vec4 color_2, float tone_2) {
    vec2 split_1 = vec2(min(light_2.intensity, 1.0), max(light_2.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light_2.color) * split_1.y), 1.0), (tone_2 * split_1.x));
}

Angle parametrization_specular_balanced(Light light_3, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_3.direction))), (0.5 * length((d + light_3.direction))));
}

float profile_power_quick(float q, float exponent) {
    float y_2 = min((q * q), 1.0);
    float _e5 = log2_one_minus(y_2);
    float power = exp2(max((exponent * _e5), -126.0));
    return ((q >= 1.0) ? 0.0 : clamp(power, 0.0, 1.0));
}

vec2 profile_place(Angle u_2, ProfileShape shape) {
    return vec2(((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset)), ((u_2.half_cos * shape.half_cos_offset) + (u_2.half_sin * shape.half_sin_offset)));
}

float profile_soft_quick(float s, ProfileShape shape_1) {
    float _e5 = profile_power_quick((s * shape_1.scale), shape_1.exponent);
    return ((s <= 0.0) ? 1.0 : _e5);
}

float profile_soft_quick_2_(float s_1, ProfileShape shape_2) {
    float q_1 = (s_1 * shape_2.scale);
    float _e8 = log2_one_minus(min((q_1 * q_1), 1.0));
    return ((s_1 <= 0.0) ? 1.0 : ((q_1 >= 1.0) ? 0.0 : min(exp2(max((shape_2.exponent * _e8), -126.0)), 1.0)));
}

float profile_soft_quick_3_(float s_2, ProfileShape shape_3) {
    float q_2 = (s_2 * shape_3.scale);
    return ((s_2 <= 0.0) ? 1.0 : pow(max((1.0 - (q_2 * q_2)), 0.0), shape_3.exponent));
}

float profile_ramp_quick(float s_3, float w, ProfileShape shape_4) {
    float width = sqrt(((w * w) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
    float from_offset = (s_3 * (2.0 + ((s_3 * s_3) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_4.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_3 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_4, float w_1, ProfileShape shape_5) {
    float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_5.edge_deviation) * shape_5.edge_deviation)));
    float from_offset_1 = (s_4 * (2.0 + ((s_4 * s_4) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((shape_5.edge_mean - from_offset_1) / width_1)), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_4 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_3, float w_2, ProfileShape shape_6) {
    if ((shape_6.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    vec2 _e7 = profile_place(u_3, shape_6);
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_6.edge_deviation)));
    if (((shape_6.kind == PROFILE_STEP) || is_narrow)) {
        float _e20 = profile_ramp_quick(_e7.x, w_2, shape_6);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_6);
    if ((w_2 < (0.1 * shape_6.edge_deviation))) {
        return _e22;
    }
    float r = (0.19364917 * w_2);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_6);
    float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_6);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_4, float w_3, ProfileShape shape_7) {
    vec2 place = vec2(((u_4.half_sin * shape_7.half_cos_offset) - (u_4.half_cos * shape_7.half_sin_offset)), ((u_4.half_cos * shape_7.half_cos_offset) + (u_4.half_sin * shape_7.half_sin_offset)));
    bool is_narrow_1 = ((w_3 > 0.0) && (w_3 >= (3.4641016 * shape_7.edge_deviation)));
    if (((shape_7.kind == PROFILE_STEP) || is_narrow_1)) {
        float _e30 = profile_ramp_quick(place.x, w_3, shape_7);
        return _e30;
    }
    float _e32 = profile_soft_quick_2_(place.x, shape_7);
    if ((w_3 < (0.1 * shape_7.edge_deviation))) {
        return _e32;
    }
    float r_1 = (0.19364917 * w_3);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e58 = profile_soft_quick_2_(((place.x * turn_1.y) - (place.y * turn_1.x)), shape_7);
    float _e66 = profile_soft_quick_2_(((place.x * turn_1.y) + (place.y * turn_1.x)), shape_7);
    return ((((5.0 * _e58) + (8.0 * _e32)) + (5.0 * _e66)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_5, float w_4, ProfileShape shape_8) {
    vec2 place_1 = vec2(((u_5.half_sin * shape_8.half_cos_offset) - (u_5.half_cos * shape_8.half_sin_offset)), ((u_5.half_cos * shape_8.half_cos_offset) + (u_5.half_sin * shape_8.half_sin_offset)));
    bool is_narrow_2 = ((w_4 > 0.0) && (w_4 >= (3.4641016 * shape_8.edge_deviation)));
    if ((false || is_narrow_2)) {
        float _e28 = profile_ramp_quick_2_(place_1.x, w_4, shape_8);
        return _e28;
    }
    float _e30 = profile_soft_quick_3_(place_1.x, shape_8);
    if ((w_4 < (0.1 * shape_8.edge_deviation))) {
        return _e30;
    }
    float r_2 = (0.19364917 * w_4);
    vec2 turn_2 = vec2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    float _e56 = profile_soft_quick_3_(((place_1.x * turn_2.y) - (place_1.y * turn_2.x)), shape_8);
    float _e64 = profile_soft_quick_3_(((place_1.x * turn_2.y) + (place_1.y * turn_2.x)), shape_8);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_9) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_9);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_10) {
    vec2 _e8 = sin_cos_quick((0.5 * clamp(shift_1, -3.1415927, PI)));
    Angle _e9 = angle_turned(angle_1, _e8);
    float _e10 = angle_footprint(_e9);
    float _e11 = profile_filtered_quick_2_(_e9, _e10, shape_10);
    return _e11;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_11) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_11);
    return _e8;
}

vec4 shade(Surface surface) {
    float back_light_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.25), -20.0, 20.0))))))));
    vec4 _e30 = curvature_color(back_light_convexity, vec4(0.1647, 0.1843, 0.2392, 1.0), vec4(0.0706, 0.0784, 0.1098, 1.0));
    Light _e33 = u_look.key;
    LitLayer _e35 = light_apply_2_(_e33, _e30, 1.0);
    vec4 fill_blend = clamp(vec4((vec3(0.0784, 0.0863, 0.1137) + (_e35.tone * _e35.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e62 = curvature_color(back_light_convexity, vec4(0.498, 0.6039, 0.3216, 1.0), vec4(0.2471, 0.4, 0.251, 1.0));
    vec3 _e67 = u_look.key.direction;
    vec3 _e76 = u_look.key.direction;
    Angle diffuse_angle = Angle((0.5 * length((surface.normal - _e67))), (0.5 * length((surface.normal + _e76))));
    float diffuse_warp = (((2.0 * back_light_convexity) - 1.0) * 0.3);
    ProfileShape _e90 = u_look.diffuse_tone_shape;
    float _e91 = profile_balanced(diffuse_angle, diffuse_warp, _e90);
    Light _e94 = u_look.key;
    LitLayer _e95 = light_apply_3_(_e94, _e62, _e91);
    vec4 diffuse_blend = clamp(vec4((fill_blend.xyz + (_e95.tone * _e95.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e111 = u_look.back_light_color_concave;
    vec4 _e114 = u_look.back_light_color_convex;
    vec4 _e117 = u_look.back_light_color_concave;
    vec4 back_light_color = (_e111 + (back_light_convexity * (_e114 - _e117)));
    vec3 _e125 = u_look.back.direction;
    vec3 _e134 = u_look.back.direction;
    Angle back_light_angle = Angle((0.5 * length((surface.normal - _e125))), (0.5 * length((surface.normal + _e134))));
    float _e146 = u_look.back_light_warp_amount;
    float back_light_warp = (((2.0 * back_light_convexity) - 1.0) * clamp(_e146, -3.1415927, 3.1415927));
    ProfileShape _e153 = u_look.back_light_tone_shape;
    float _e154 = profile_balanced_2_(back_light_angle, back_light_warp, _e153);
    Light _e157 = u_look.back;
    LitLayer _e158 = light_apply(_e157, back_light_color, _e154);
    vec4 _e169 = blend_finish(diffuse_blend, (diffuse_blend.xyz + (_e158.tone * _e158.color.xyz)), 1.0, _e158.color.w, true);
    float highlight_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.2), -20.0, 20.0))))))));
    vec4 _e191 = u_look.highlight_color_concave;
    vec4 _e194 = u_look.highlight_color_convex;
    vec4 _e197 = u_look.highlight_color_concave;
    vec4 highlight_color = (_e191 + (highlight_convexity * (_e194 - _e197)));
    Light _e203 = u_look.key;
    Angle _e206 = parametrization_specular_balanced(_e203, surface.normal, surface.view);
    float highlight_warp = (((2.0 * highlight_convexity) - 1.0) * 0.05);
    float _e214 = profile_balanced_3_(_e206, highlight_warp, highlight_tone_shape);
    Light _e217 = u_look.key;
    LitLayer _e218 = light_apply(_e217, highlight_color, _e214);
    vec4 _e229 = blend_finish(_e169, (_e169.xyz + (_e218.tone * _e218.color.xyz)), 1.0, _e218.color.w, true);
    return _e229;
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

