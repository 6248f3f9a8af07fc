#version 330 core
// Dual lighting, soft: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-dual-soft.json says what to put there and how to draw.
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
    Light warm;
    Light cool;
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
const ProfileShape warm_side_tone_shape = ProfileShape(0.9971888, 0.07492971, 1.3940078, 1.4345639, 0.15, 0.90231395, 0.36981526, 0u);
const ProfileShape cool_side_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.5079876, 1.4054453, 0.1, 0.83293223, 0.33645248, 0u);
const ProfileShape sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u);

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
    float y_1 = (x * x);
    float s_2 = (x * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return vec2(s_2, c);
}

float log2_one_minus(float y) {
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
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

float curvature_signed_balanced(float kappa, float slope) {
    return (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp(((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * 0.25), -20.0, 20.0))))));
}

float curvature_signed_balanced_2_(float kappa_1, float slope_1) {
    return (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp(((((floatBitsToUint(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa_1, -10000.0, 10000.0)) * slope_1), -20.0, 20.0))))));
}

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color.xyz * light.color) * split.y), 1.0), split.x);
}

LitLayer light_apply_2_(Light light_1, vec4 color_1, float tone_1) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light_1.color) * split_1.y), 1.0), (tone_1 * split_1.x));
}

Angle parametrization_specular_balanced(Light light_2, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_2.direction))), (0.5 * length((d + light_2.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    float _e8 = log2_one_minus(min((q * q), 1.0));
    return ((s <= 0.0) ? 1.0 : ((q >= 1.0) ? 0.0 : min(exp2(max((shape.exponent * _e8), -126.0)), 1.0)));
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

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed_balanced(surface_1.kappa, 0.25);
    float fill_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(fill_convexity, vec4(0.1137, 0.0941, 0.1333, 1.0), vec4(0.0392, 0.0314, 0.0549, 1.0));
    Light _e21 = u_look.warm;
    LitLayer _e23 = light_apply(_e21, _e18, 1.0);
    vec4 fill_blend = clamp(vec4((vec3(0.051, 0.0431, 0.0706) + (_e23.tone * _e23.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    float _e42 = curvature_signed_balanced_2_(surface_1.kappa, 0.22);
    float cool_side_convexity = (0.5 + (0.5 * _e42));
    vec4 _e57 = curvature_color(cool_side_convexity, vec4(0.851, 0.5451, 0.3059, 1.0), vec4(0.4784, 0.1843, 0.1333, 1.0));
    vec3 _e62 = u_look.warm.direction;
    vec3 _e71 = u_look.warm.direction;
    Angle warm_side_angle = Angle((0.5 * length((surface_1.normal - _e62))), (0.5 * length((surface_1.normal + _e71))));
    float warm_side_warp = (((2.0 * cool_side_convexity) - 1.0) * 0.3);
    float _e84 = profile_balanced(warm_side_angle, warm_side_warp, warm_side_tone_shape);
    Light _e87 = u_look.warm;
    LitLayer _e88 = light_apply_2_(_e87, _e57, _e84);
    vec4 warm_side_blend = clamp(vec4((fill_blend.xyz + (_e88.tone * _e88.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e112 = curvature_color(cool_side_convexity, vec4(0.3098, 0.498, 0.7216, 1.0), vec4(0.1098, 0.1922, 0.3412, 1.0));
    vec3 _e117 = u_look.cool.direction;
    vec3 _e126 = u_look.cool.direction;
    Angle cool_side_angle = Angle((0.5 * length((surface_1.normal - _e117))), (0.5 * length((surface_1.normal + _e126))));
    float cool_side_warp = (((2.0 * cool_side_convexity) - 1.0) * 0.25);
    float _e139 = profile_balanced(cool_side_angle, cool_side_warp, cool_side_tone_shape);
    Light _e142 = u_look.cool;
    LitLayer _e143 = light_apply_2_(_e142, _e112, _e139);
    vec4 cool_side_blend = clamp(vec4((warm_side_blend.xyz + (_e143.tone * _e143.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    float _e159 = curvature_signed_balanced_2_(surface_1.kappa, 0.2);
    float sheen_convexity = (0.5 + (0.5 * _e159));
    vec4 _e174 = curvature_color(sheen_convexity, vec4(0.4196, 0.3176, 0.2196, 1.0), vec4(0.2, 0.1373, 0.1098, 1.0));
    Light _e177 = u_look.warm;
    Angle _e180 = parametrization_specular_balanced(_e177, surface_1.normal, surface_1.view);
    float sheen_warp = (((2.0 * sheen_convexity) - 1.0) * 0.1);
    float _e188 = profile_balanced_2_(_e180, sheen_warp, sheen_tone_shape);
    Light _e191 = u_look.warm;
    LitLayer _e192 = light_apply_2_(_e191, _e174, _e188);
    vec4 output_ = clamp(vec4((cool_side_blend.xyz + (_e192.tone * _e192.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
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

