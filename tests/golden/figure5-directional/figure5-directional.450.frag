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

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise) {
    bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

vec2 sin_cos_quick(float x_2) {
    float y_1 = (x_2 * x_2);
    float s_4 = (x_2 * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return vec2(s_4, c);
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
    float _e13 = finite_or(w_5, 0.5);
    return min(_e13, 0.5);
}

float angle_footprint_2_(Angle u_1) {
    vec2 half_1 = vec2(u_1.half_sin, u_1.half_cos);
    vec2 dx_1 = dFdx(half_1);
    vec2 dy_1 = dFdy(half_1);
    float w_6 = (2.0 * sqrt((dot(dx_1, dx_1) + dot(dy_1, dy_1))));
    return min(w_6, 0.5);
}

Angle angle_turned(Angle u_2, vec2 t) {
    float s_5 = ((u_2.half_sin * t.y) - (u_2.half_cos * t.x));
    float c_1 = ((u_2.half_cos * t.y) + (u_2.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_5, c_1));
    vec2 turned = (((s_5 <= 0.0) && (s_5 < c_1)) ? vec2(0.0, 1.0) : upper);
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

vec2 profile_place(Angle u_3, ProfileShape shape) {
    return vec2(((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset)), ((u_3.half_cos * shape.half_cos_offset) + (u_3.half_sin * shape.half_sin_offset)));
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

float profile_ramp_quick(float s_2, float w, ProfileShape shape_3) {
    float width = sqrt(((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
    float from_offset = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_3.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_3, float w_1, ProfileShape shape_4) {
    float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
    float from_offset_1 = (s_3 * (2.0 + ((s_3 * s_3) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((shape_4.edge_mean - from_offset_1) / width_1)), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_3 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_4, float w_2, ProfileShape shape_5) {
    if ((shape_5.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    vec2 _e7 = profile_place(u_4, shape_5);
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_5.edge_deviation)));
    if (((shape_5.kind == PROFILE_STEP) || is_narrow)) {
        float _e20 = profile_ramp_quick(_e7.x, w_2, shape_5);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_5);
    if ((w_2 < (0.1 * shape_5.edge_deviation))) {
        return _e22;
    }
    float r = (0.19364917 * w_2);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_5);
    float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_5);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_5, float w_3, ProfileShape shape_6) {
    vec2 place = vec2(((u_5.half_sin * shape_6.half_cos_offset) - (u_5.half_cos * shape_6.half_sin_offset)), ((u_5.half_cos * shape_6.half_cos_offset) + (u_5.half_sin * shape_6.half_sin_offset)));
    bool is_narrow_1 = ((w_3 > 0.0) && (w_3 >= (3.4641016 * shape_6.edge_deviation)));
    if (((shape_6.kind == PROFILE_STEP) || is_narrow_1)) {
        float _e30 = profile_ramp_quick(place.x, w_3, shape_6);
        return _e30;
    }
    float _e32 = profile_soft_quick(place.x, shape_6);
    if ((w_3 < (0.1 * shape_6.edge_deviation))) {
        return _e32;
    }
    float r_1 = (0.19364917 * w_3);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e58 = profile_soft_quick(((place.x * turn_1.y) - (place.y * turn_1.x)), shape_6);
    float _e66 = profile_soft_quick(((place.x * turn_1.y) + (place.y * turn_1.x)), shape_6);
    return ((((5.0 * _e58) + (8.0 * _e32)) + (5.0 * _e66)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_6, float w_4, ProfileShape shape_7) {
    vec2 place_1 = vec2(((u_6.half_sin * shape_7.half_cos_offset) - (u_6.half_cos * shape_7.half_sin_offset)), ((u_6.half_cos * shape_7.half_cos_offset) + (u_6.half_sin * shape_7.half_sin_offset)));
    bool is_narrow_2 = ((w_4 > 0.0) && (w_4 >= (3.4641016 * shape_7.edge_deviation)));
    if ((false || is_narrow_2)) {
        float _e28 = profile_ramp_quick_2_(place_1.x, w_4, shape_7);
        return _e28;
    }
    float _e30 = profile_soft_quick_2_(place_1.x, shape_7);
    if ((w_4 < (0.1 * shape_7.edge_deviation))) {
        return _e30;
    }
    float r_2 = (0.19364917 * w_4);
    vec2 turn_2 = vec2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    float _e56 = profile_soft_quick_2_(((place_1.x * turn_2.y) - (place_1.y * turn_2.x)), shape_7);
    float _e64 = profile_soft_quick_2_(((place_1.x * turn_2.y) + (place_1.y * turn_2.x)), shape_7);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_8) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint_2_(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_8);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_9) {
    vec2 _e8 = sin_cos_quick((0.5 * clamp(shift_1, -3.1415927, PI)));
    Angle _e9 = angle_turned(angle_1, _e8);
    float _e10 = angle_footprint(_e9);
    float _e11 = profile_filtered_quick_2_(_e9, _e10, shape_9);
    return _e11;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_10) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint_2_(_e6);
    float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_10);
    return _e8;
}

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed_balanced(surface_1.kappa, 0.25);
    float back_light_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(back_light_convexity, vec4(0.1647, 0.1843, 0.2392, 1.0), vec4(0.0706, 0.0784, 0.1098, 1.0));
    Light _e21 = u_look.key;
    LitLayer _e23 = light_apply_2_(_e21, _e18, 1.0);
    vec4 fill_blend = clamp(vec4((vec3(0.0784, 0.0863, 0.1137) + (_e23.tone * _e23.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e50 = curvature_color(back_light_convexity, vec4(0.498, 0.6039, 0.3216, 1.0), vec4(0.2471, 0.4, 0.251, 1.0));
    vec3 _e55 = u_look.key.direction;
    vec3 _e64 = u_look.key.direction;
    Angle diffuse_angle = Angle((0.5 * length((surface_1.normal - _e55))), (0.5 * length((surface_1.normal + _e64))));
    float diffuse_warp = (((2.0 * back_light_convexity) - 1.0) * 0.3);
    ProfileShape _e78 = u_look.diffuse_tone_shape;
    float _e79 = profile_balanced(diffuse_angle, diffuse_warp, _e78);
    Light _e82 = u_look.key;
    LitLayer _e83 = light_apply_3_(_e82, _e50, _e79);
    vec4 diffuse_blend = clamp(vec4((fill_blend.xyz + (_e83.tone * _e83.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e99 = u_look.back_light_color_concave;
    vec4 _e102 = u_look.back_light_color_convex;
    vec4 _e105 = u_look.back_light_color_concave;
    vec4 back_light_color = (_e99 + (back_light_convexity * (_e102 - _e105)));
    vec3 _e113 = u_look.back.direction;
    vec3 _e122 = u_look.back.direction;
    Angle back_light_angle = Angle((0.5 * length((surface_1.normal - _e113))), (0.5 * length((surface_1.normal + _e122))));
    float _e134 = u_look.back_light_warp_amount;
    float back_light_warp = (((2.0 * back_light_convexity) - 1.0) * clamp(_e134, -3.1415927, 3.1415927));
    ProfileShape _e141 = u_look.back_light_tone_shape;
    float _e142 = profile_balanced_2_(back_light_angle, back_light_warp, _e141);
    Light _e145 = u_look.back;
    LitLayer _e146 = light_apply(_e145, back_light_color, _e142);
    vec4 _e157 = blend_finish(diffuse_blend, (diffuse_blend.xyz + (_e146.tone * _e146.color.xyz)), 1.0, _e146.color.w, true);
    float _e160 = curvature_signed_balanced_2_(surface_1.kappa, 0.2);
    float highlight_convexity = (0.5 + (0.5 * _e160));
    vec4 _e167 = u_look.highlight_color_concave;
    vec4 _e170 = u_look.highlight_color_convex;
    vec4 _e173 = u_look.highlight_color_concave;
    vec4 highlight_color = (_e167 + (highlight_convexity * (_e170 - _e173)));
    Light _e179 = u_look.key;
    Angle _e182 = parametrization_specular_balanced(_e179, surface_1.normal, surface_1.view);
    float highlight_warp = (((2.0 * highlight_convexity) - 1.0) * 0.05);
    float _e190 = profile_balanced_3_(_e182, highlight_warp, highlight_tone_shape);
    Light _e193 = u_look.key;
    LitLayer _e194 = light_apply(_e193, highlight_color, _e190);
    vec4 _e205 = blend_finish(_e157, (_e157.xyz + (_e194.tone * _e194.color.xyz)), 1.0, _e194.color.w, true);
    return _e205;
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

