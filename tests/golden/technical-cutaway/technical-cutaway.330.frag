#version 330 core
// Technical cutaway: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// technical-cutaway.json says what to put there and how to draw.
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
struct Shaded {
    vec4 value;
    vec4 color;
    float cutoff;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const ProfileShape metal_tone_shape = ProfileShape(0.99820054, 0.059964005, 7.166244, 3.1997643, 0.12, 0.124456726, 0.0556771, 0u);
const ProfileShape contour_tone_shape = ProfileShape(0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent), exponent));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise) {
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
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

float bounded(float x_1) {
    uint bits = floatBitsToUint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float footprint_of(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

float step_filtered(float x_3, float edge, float w) {
    float d_1 = (x_3 - edge);
    if ((w < 1e-30)) {
        return ((d_1 >= 0.0) ? 1.0 : 0.0);
    }
    float _e12 = bounded((d_1 / w));
    return clamp((0.5 + _e12), 0.0, 1.0);
}

vec4 premultiplied(vec4 color) {
    return vec4((color.xyz * color.w), color.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope) {
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
}

vec4 blend_alpha(vec4 below, vec4 color_1, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (opacity * ((below.xyz + (tone * (color_1.xyz - below.xyz))) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 output_(vec4 color_2) {
    vec4 _e1 = straight(color_2);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

LitLayer light_apply(Light light, vec4 color_3, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_3.xyz * light.color) * split.y), 1.0), split.x);
}

LitLayer light_apply_2_(Light light_1, vec4 color_4, float tone_2) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4((light_1.color * split_1.y), 1.0), (tone_2 * split_1.x));
}

Angle parametrization_specular_balanced(Light light_2, vec3 normal, vec3 view) {
    vec3 d_2 = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d_2 - light_2.direction))), (0.5 * length((d_2 + light_2.direction))));
}

Angle parametrization_screen_aligned_balanced(Light light_3, vec3 normal_1, mat3x3 camera_from_world) {
    vec3 d_3 = (camera_from_world * normal_1);
    return Angle((0.5 * length((d_3 - light_3.own_direction))), (0.5 * length((d_3 + light_3.own_direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w_1, ProfileShape shape_1) {
    float width = sqrt(((w_1 * w_1) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_2, float w_2, ProfileShape shape_2) {
    float width_1 = sqrt((w_2 * w_2));
    float from_offset_1 = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((0.0 - from_offset_1) / max(width_1, 1e-6))), 0.0, 1.0);
    return ((w_2 <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_2, float w_3, ProfileShape shape_3) {
    vec2 place = vec2(((u_2.half_sin * shape_3.half_cos_offset) - (u_2.half_cos * shape_3.half_sin_offset)), ((u_2.half_cos * shape_3.half_cos_offset) + (u_2.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_3 > 0.0) && (w_3 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_3, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_3);
    if ((w_3 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_3);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
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
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset)), _e14, shape_5);
    return _e15;
}

vec4 gooch(Light light_4, vec3 normal_2, vec4 color_5, vec4 cool, vec4 warm, float cool_amount, float warm_amount) {
    float t_1 = (0.5 + (0.5 * dot(normal_2, light_4.direction)));
    vec3 far = (cool.xyz + (cool_amount * color_5.xyz));
    vec3 near = (warm.xyz + (warm_amount * color_5.xyz));
    return vec4(mix(far, near, clamp(t_1, 0.0, 1.0)), 1.0);
}

Shaded shade(Surface surface) {
    Light _e3 = u_look.key;
    vec4 _e22 = gooch(_e3, surface.normal, vec4(0.8314, 0.8392, 0.8549, 1.0), vec4(0.1725, 0.2902, 0.4863, 1.0), vec4(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    vec4 cool_to_warm_2_ = vec4((vec3(1.0) + (_e22.xyz - vec3(1.0))), 1.0);
    float _e34 = transition_balanced(surface.kappa, 0.25);
    vec4 _e42 = curvature_color(_e34, vec4(1.0), vec4(0.5412, 0.5804, 0.6588, 1.0));
    Light _e45 = u_look.key;
    LitLayer _e47 = light_apply(_e45, _e42, 1.0);
    vec4 hollows_blend = clamp(vec4((cool_to_warm_2_.xyz + (0.8 * ((cool_to_warm_2_.xyz * (_e47.tone * _e47.color.xyz)) - cool_to_warm_2_.xyz))), 1.0), vec4(0.0), vec4(1.0));
    Light _e69 = u_look.key;
    Angle _e72 = parametrization_specular_balanced(_e69, surface.normal, surface.view);
    float _e75 = transition_balanced(surface.kappa, 0.2);
    float metal_warp = (((2.0 * _e75) - 1.0) * 0.05);
    float _e83 = profile_balanced(_e72, metal_warp, metal_tone_shape);
    Light _e86 = u_look.key;
    LitLayer _e89 = light_apply_2_(_e86, vec4(1.0), _e83);
    vec4 _e94 = blend_alpha(hollows_blend, _e89.color, _e89.tone, 0.8, true);
    Light _e97 = u_look.eye;
    mat3x3 _e101 = u_look.camera_from_world;
    Angle _e102 = parametrization_screen_aligned_balanced(_e97, surface.normal, _e101);
    float _e105 = transition_balanced(surface.kappa, 0.12);
    float contour_warp = (((2.0 * _e105) - 1.0) * 0.25);
    float _e113 = profile_balanced_2_(_e102, contour_warp, contour_tone_shape);
    Light _e116 = u_look.eye;
    LitLayer _e119 = light_apply_2_(_e116, vec4(1.0), _e113);
    vec4 contour_blend = clamp(vec4((_e94.xyz * (_e119.tone * _e119.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec3 place_1 = surface.position_object;
    VectorParts parts = VectorParts(place_1.x, place_1.y, place_1.z);
    float into_the_corner = min(parts.x, parts.z);
    float _e142 = footprint_of(into_the_corner);
    float _e148 = step_filtered(into_the_corner, -0.012, length(vec2(min(_e142, 1000000000000000.0), 0.0)));
    vec4 section_line = clamp(vec4((contour_blend.xyz + (_e148 * (vec3(0.8471, 0.1569, 0.1098) - contour_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float _e166 = footprint_of(into_the_corner);
    float _e172 = step_filtered(into_the_corner, 0.02, length(vec2(min(_e166, 1000000000000000.0), 0.0)));
    float kept = (1.0 - _e172);
    vec4 cut = vec4(section_line.xyz, kept);
    vec4 _e177 = premultiplied(cut);
    vec4 _e178 = output_(_e177);
    return Shaded(_e178, _e178, 0.5);
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_3 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e24 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x);
    Shaded _e27 = shade(surface_1);
    if ((_e27.color.w < _e27.cutoff)) {
        discard;
    }
    vec4 _e33 = finite_vec4_(_e27.value);
    out_color = _e33;
    return;
}

