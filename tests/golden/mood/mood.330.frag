#version 330 core
// A mood, by one handle: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// mood.json says what to put there and how to draw.
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
    vec4 back_light_color_convex;
    Light back;
    ProfileShape back_light_tone_shape;
    vec4 highlight_color_convex;
    Light key;
    ProfileShape highlight_tone_shape;
    vec4 body_color_convex;
    ProfileShape body_tone_shape;
    vec4 shadow;
};
struct Surface {
    vec3 normal;
    vec3 view;
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
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent_1 = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent_1), exponent_1));
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

float log2_one_minus(float y) {
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, u_1.half_cos));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
}

vec4 blend_alpha(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_1) {
    float a = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a) * (1.0 - below_1.w)));
    vec4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a, clamped_1);
    return _e20;
}

vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 _e4 = light_split(light.intensity);
    return LitLayer(vec4(((color_1.xyz * light.color) * _e4.y), color_1.w), (tone_1 * _e4.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
}

float profile_power_quick(float q, float exponent) {
    float y_1 = min((q * q), 1.0);
    float _e5 = log2_one_minus(y_1);
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

float profile_ramp_quick(float s_1, float w, ProfileShape shape_2) {
    float width = sqrt(((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_2.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_3, float w_1, ProfileShape shape_3) {
    if ((shape_3.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    vec2 _e7 = profile_place(u_3, shape_3);
    bool is_narrow = ((w_1 > 0.0) && (w_1 >= (3.4641016 * shape_3.edge_deviation)));
    if (((shape_3.kind == PROFILE_STEP) || is_narrow)) {
        float _e20 = profile_ramp_quick(_e7.x, w_1, shape_3);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_3);
    if ((w_1 < (0.1 * shape_3.edge_deviation))) {
        return _e22;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_3);
    float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_3);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle body_angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    ProfileShape _e23 = u_look.body_tone_shape;
    float _e24 = profile_balanced(body_angle, 0.0, _e23);
    Light _e27 = u_look.key;
    vec4 _e30 = u_look.body_color_convex;
    LitLayer _e31 = light_apply(_e27, _e30, _e24);
    vec4 _e34 = u_look.shadow;
    vec4 _e37 = u_look.shadow;
    vec4 _e44 = u_look.shadow;
    float _e52 = u_look.shadow.w;
    float _e60 = u_look.shadow.w;
    vec4 _e68 = blend_finish(_e34, (_e37.xyz + (_e31.tone * (_e31.color.xyz - _e44.xyz))), (_e52 + ((_e31.tone * _e31.color.w) * (1.0 - _e60))), _e31.color.w, true);
    Light _e71 = u_look.key;
    Angle _e74 = parametrization_specular_balanced(_e71, surface.normal, surface.view);
    ProfileShape _e78 = u_look.highlight_tone_shape;
    float _e79 = profile_balanced(_e74, 0.0, _e78);
    Light _e82 = u_look.key;
    vec4 _e85 = u_look.highlight_color_convex;
    LitLayer _e86 = light_apply(_e82, _e85, _e79);
    vec4 _e91 = blend_alpha(_e68, _e86.color, _e86.tone, 0.7, true);
    vec3 _e96 = u_look.back.direction;
    vec3 _e105 = u_look.back.direction;
    Angle back_light_angle = Angle((0.5 * length((surface.normal - _e96))), (0.5 * length((surface.normal + _e105))));
    ProfileShape _e114 = u_look.back_light_tone_shape;
    float _e115 = profile_balanced(back_light_angle, 0.0, _e114);
    Light _e118 = u_look.back;
    vec4 _e121 = u_look.back_light_color_convex;
    LitLayer _e122 = light_apply(_e118, _e121, _e115);
    vec4 _e133 = blend_finish(_e91, (_e91.xyz + (_e122.tone * _e122.color.xyz)), _e91.w, _e122.color.w, true);
    vec4 _e144 = finite_vec4_(((_e133.w <= 0.0) ? _e133 : vec4((_e133.xyz / vec3(_e133.w)), _e133.w)));
    return _e144;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))));
    vec4 _e19 = shade(surface_1);
    vec4 _e20 = finite_vec4_(_e19);
    out_color = _e20;
    return;
}

