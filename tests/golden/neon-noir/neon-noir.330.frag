#version 330 core
// Neon noir: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// neon-noir.json says what to put there and how to draw.
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
    Light magenta;
    Light cyan;
    Light street;
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
const ProfileShape the_room_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.4670527, 1.5580629, 0.1, 0.827969, 0.34274614, 0u);
const ProfileShape magenta_haze_tone_shape = ProfileShape(0.9887711, 0.14943813, 2.0858297, 1.974287, 0.3, 0.5228124, 0.22054322, 0u);
const ProfileShape magenta_tube_tone_shape = ProfileShape(0.95233357, 0.30505863, 8.353367, 2.4874215, 0.62, 0.117860116, 0.05078552, 0u);
const ProfileShape wet_magenta_tone_shape = ProfileShape(0.9887711, 0.14943813, 5.0334897, 2.4651666, 0.3, 0.19658314, 0.08474467, 0u);

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
    return (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp(((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope), -20.0, 20.0))))));
}

float curvature_signed_balanced_2_(float kappa_1, float slope_1) {
    return (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp(((((floatBitsToUint(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa_1, -10000.0, 10000.0)) * 0.25), -20.0, 20.0))))));
}

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
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
    float _e3 = curvature_signed_balanced(surface_1.kappa, 0.2);
    float wet_magenta_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(wet_magenta_convexity, vec4(0.0706, 0.0627, 0.1647, 1.0), vec4(0.0196, 0.0157, 0.0627, 1.0));
    vec3 _e23 = u_look.street.direction;
    vec3 _e32 = u_look.street.direction;
    Angle the_room_angle = Angle((0.5 * length((surface_1.normal - _e23))), (0.5 * length((surface_1.normal + _e32))));
    float the_room_warp = (((2.0 * wet_magenta_convexity) - 1.0) * 0.2);
    float _e45 = profile_balanced(the_room_angle, the_room_warp, the_room_tone_shape);
    Light _e48 = u_look.street;
    LitLayer _e49 = light_apply(_e48, _e18, _e45);
    vec4 the_room_blend = clamp(vec4((vec3(0.0157, 0.0118, 0.0353) + (_e49.tone * _e49.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e76 = curvature_color(wet_magenta_convexity, vec4(0.0471, 0.2275, 0.3373, 1.0), vec4(0.0235, 0.0941, 0.1804, 1.0));
    vec3 _e81 = u_look.cyan.direction;
    vec3 _e90 = u_look.cyan.direction;
    Angle cyan_tube_angle = Angle((0.5 * length((surface_1.normal - _e81))), (0.5 * length((surface_1.normal + _e90))));
    float magenta_haze_warp = (((2.0 * wet_magenta_convexity) - 1.0) * 0.15);
    float _e103 = profile_balanced(cyan_tube_angle, magenta_haze_warp, magenta_haze_tone_shape);
    Light _e106 = u_look.cyan;
    LitLayer _e107 = light_apply(_e106, _e76, _e103);
    vec4 cyan_haze_blend = clamp(vec4((the_room_blend.xyz + (_e107.tone * _e107.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e131 = curvature_color(wet_magenta_convexity, vec4(0.2902, 0.0471, 0.2667, 1.0), vec4(0.1098, 0.0235, 0.149, 1.0));
    vec3 _e136 = u_look.magenta.direction;
    vec3 _e145 = u_look.magenta.direction;
    Angle magenta_tube_angle = Angle((0.5 * length((surface_1.normal - _e136))), (0.5 * length((surface_1.normal + _e145))));
    float _e152 = profile_balanced(magenta_tube_angle, magenta_haze_warp, magenta_haze_tone_shape);
    Light _e155 = u_look.magenta;
    LitLayer _e156 = light_apply(_e155, _e131, _e152);
    vec4 magenta_haze_blend = clamp(vec4((cyan_haze_blend.xyz + (_e156.tone * _e156.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    float _e172 = curvature_signed_balanced_2_(surface_1.kappa, 0.25);
    float magenta_tube_convexity = (0.5 + (0.5 * _e172));
    vec4 _e187 = curvature_color(magenta_tube_convexity, vec4(0.1333, 0.902, 1.0, 1.0), vec4(0.0392, 0.4157, 0.6039, 1.0));
    float magenta_tube_warp = (((2.0 * magenta_tube_convexity) - 1.0) * 0.25);
    float _e195 = profile_balanced_2_(cyan_tube_angle, magenta_tube_warp, magenta_tube_tone_shape);
    Light _e198 = u_look.cyan;
    LitLayer _e199 = light_apply(_e198, _e187, _e195);
    vec4 cyan_tube_blend = clamp(vec4((magenta_haze_blend.xyz + (_e199.tone * _e199.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e223 = curvature_color(magenta_tube_convexity, vec4(1.0, 0.1725, 0.6588, 1.0), vec4(0.5255, 0.0627, 0.4784, 1.0));
    float _e225 = profile_balanced_2_(magenta_tube_angle, magenta_tube_warp, magenta_tube_tone_shape);
    Light _e228 = u_look.magenta;
    LitLayer _e229 = light_apply(_e228, _e223, _e225);
    vec4 magenta_tube_blend = clamp(vec4((cyan_tube_blend.xyz + (_e229.tone * _e229.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e253 = curvature_color(wet_magenta_convexity, vec4(0.2275, 0.6588, 0.7843, 1.0), vec4(0.0627, 0.2902, 0.4157, 1.0));
    Light _e256 = u_look.cyan;
    Angle _e259 = parametrization_specular_balanced(_e256, surface_1.normal, surface_1.view);
    float wet_magenta_warp = (((2.0 * wet_magenta_convexity) - 1.0) * 0.1);
    float _e267 = profile_balanced_2_(_e259, wet_magenta_warp, wet_magenta_tone_shape);
    Light _e270 = u_look.cyan;
    LitLayer _e271 = light_apply(_e270, _e253, _e267);
    vec4 wet_cyan_blend = clamp(vec4((magenta_tube_blend.xyz + (_e271.tone * _e271.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e295 = curvature_color(wet_magenta_convexity, vec4(0.7843, 0.2275, 0.6039, 1.0), vec4(0.3529, 0.0627, 0.3765, 1.0));
    Light _e298 = u_look.magenta;
    Angle _e301 = parametrization_specular_balanced(_e298, surface_1.normal, surface_1.view);
    float _e303 = profile_balanced_2_(_e301, wet_magenta_warp, wet_magenta_tone_shape);
    Light _e306 = u_look.magenta;
    LitLayer _e307 = light_apply(_e306, _e295, _e303);
    vec4 output_ = clamp(vec4((wet_cyan_blend.xyz + (_e307.tone * _e307.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
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

