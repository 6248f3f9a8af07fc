#version 450 core
// Grisaille and glaze: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// glaze.json says what to put there and how to draw.
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
const ProfileShape gray_modeling_tone_shape = ProfileShape(1.0, 0.0, 1.0537579, 1.3909147, 0.0, 1.2772532, 0.561292, 0u);
const ProfileShape gray_lights_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.0858297, 3.3126261, 0.1, 0.42646712, 0.19445144, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
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

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_1 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, u_1.half_cos));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec3 bounded_vec3_(vec3 v_3) {
    uvec3 bits = floatBitsToUint(v_3);
    uvec3 magnitude = (bits & uvec3(2147483647u));
    vec3 largest = uintBitsToFloat(((bits & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest, equal(magnitude, uvec3(2139095040u)));
    return mix(numbers, v_3, lessThan(magnitude, uvec3(2139095040u)));
}

vec3 mixed_vec3_(vec3 a, vec3 b, float t_1) {
    vec3 _e4 = bounded_vec3_((b - a));
    vec3 _e14 = bounded_vec3_(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
}

float footprint_of(float x) {
    float _e1 = dFdx(x);
    float _e2 = dFdy(x);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

float soft_light(float a_1, float b_1) {
    float curved = ((a_1 <= 0.25) ? (((((16.0 * a_1) - 12.0) * a_1) + 4.0) * a_1) : sqrt(max(a_1, 0.0)));
    return (a_1 + (((2.0 * b_1) - 1.0) * (curved - a_1)));
}

vec4 color_mixed(vec4 a_2, vec3 blended, float factor) {
    vec3 _e3 = bounded_vec3_(blended);
    vec3 _e8 = bounded_vec3_((_e3 - a_2.xyz));
    vec3 _e11 = bounded_vec3_((_e3 - ((1.0 - factor) * _e8)));
    return vec4(_e11, 1.0);
}

float lightness_of(vec3 rgb) {
    return dot(rgb, vec3(0.3, 0.59, 0.11));
}

vec3 lit_as(vec3 rgb_1, vec3 other) {
    float _e2 = lightness_of(other);
    float _e3 = lightness_of(rgb_1);
    vec3 moved = (rgb_1 + vec3((_e2 - _e3)));
    float least = min(min(moved.x, moved.y), moved.z);
    float largest_1 = max(max(moved.x, moved.y), moved.z);
    float raised = ((least < 0.0) ? (_e2 / max((_e2 - least), 1e-6)) : 1.0);
    vec3 clipped = (vec3(_e2) + ((moved - vec3(_e2)) * raised));
    float top = (_e2 + ((largest_1 - _e2) * raised));
    float lowered = ((top > 1.0) ? ((1.0 - _e2) / max((top - _e2), 1e-6)) : 1.0);
    return (vec3(_e2) + ((clipped - vec3(_e2)) * lowered));
}

vec4 mix_colors_screen(vec4 a_3, vec4 b_2, float factor_1) {
    vec3 _e4 = bounded_vec3_(a_3.xyz);
    vec3 _e12 = bounded_vec3_(((a_3.xyz + b_2.xyz) - (a_3.xyz * b_2.xyz)));
    vec3 _e13 = mixed_vec3_(_e4, _e12, factor_1);
    return vec4(_e13, 1.0);
}

vec4 mix_colors_soft_light(vec4 a_4, vec4 b_3, float factor_2) {
    float _e5 = soft_light(a_4.x, b_3.x);
    float _e8 = soft_light(a_4.y, b_3.y);
    vec4 _e23 = color_mixed(a_4, vec3(_e5, _e8, (a_4.z - (((1.0 - (2.0 * b_3.z)) * a_4.z) * (1.0 - a_4.z)))), factor_2);
    return _e23;
}

vec4 mix_colors_hue(vec4 a_5, vec4 b_4, float factor_3) {
    vec3 _e4 = bounded_vec3_(a_5.xyz);
    vec3 below_1 = clamp(_e4, vec3(0.0), vec3(1.0));
    vec3 _e11 = bounded_vec3_(a_5.xyz);
    vec3 _e32 = lit_as(((b_4.xyz - vec3(b_4.y)) * ((max(max(below_1.x, below_1.y), below_1.z) - min(min(below_1.x, below_1.y), below_1.z)) / (b_4.x - b_4.y))), below_1);
    vec3 _e35 = mixed_vec3_(_e11, _e32, max(factor_3, 0.0));
    return vec4(_e35, 1.0);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d_1 = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d_1 - light_1.direction))), (0.5 * length((d_1 + light_1.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1) {
    vec2 place = vec2((u_2.half_sin - 0.0), u_2.half_cos);
    float _e9 = profile_soft_quick(place.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e9;
    }
    float r = (0.19364917 * w);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e35 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_1);
    float _e43 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_1);
    return ((((5.0 * _e35) + (8.0 * _e9)) + (5.0 * _e43)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_1, ProfileShape shape_2) {
    vec2 place_1 = vec2(((u_3.half_sin * shape_2.half_cos_offset) - (u_3.half_cos * shape_2.half_sin_offset)), ((u_3.half_cos * shape_2.half_cos_offset) + (u_3.half_sin * shape_2.half_sin_offset)));
    float _e19 = profile_soft_quick(place_1.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e19;
    }
    float r_1 = (0.19364917 * w_1);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e45 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_2);
    float _e53 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_2);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_3) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_4) {
    Angle _e6 = angle_turned(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_4);
    return _e8;
}

float rim(Light light_2, vec3 normal_1, vec3 view_1, float width, float softness, float follow) {
    float facing = clamp(dot(normal_1, view_1), 0.0, 1.0);
    float _e11 = footprint_of(facing);
    float edge = max((width * softness), min(_e11, 1.0));
    vec3 aside = (normal_1 - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    vec3 across = (light_2.direction - (dot(light_2.direction, view_1) * view_1));
    float side = dot((normal_1 - (dot(normal_1, view_1) * view_1)), (across * inversesqrt(max(dot(across, across), 1e-30))));
    return (inside * mix(1.0, smoothstep(0.0, 0.5, side), follow));
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle gray_modeling_angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e22 = profile_balanced(gray_modeling_angle, 0.0, gray_modeling_tone_shape);
    Light _e25 = u_look.key;
    LitLayer _e31 = light_apply(_e25, vec4(0.7059, 0.7059, 0.7059, 1.0), _e22);
    vec4 _e41 = blend_alpha(vec4(0.1216, 0.1216, 0.1216, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = u_look.key;
    Angle _e47 = parametrization_specular_balanced(_e44, surface.normal, surface.view);
    float _e50 = profile_balanced_2_(_e47, 0.0, gray_lights_tone_shape);
    Light _e53 = u_look.key;
    LitLayer _e59 = light_apply(_e53, vec4(0.2902, 0.2902, 0.2902, 1.0), _e50);
    vec4 gray_lights_blend = clamp(vec4((_e41.xyz + (_e59.tone * _e59.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 grisaille = vec4(gray_lights_blend.xyz, 1.0);
    vec3 _e82 = lit_as(vec3(0.4275, 0.5412, 0.4471), grisaille.xyz);
    vec4 glaze_of_green_earth = vec4(mix(grisaille.xyz, _e82, 0.75), 1.0);
    vec3 _e93 = lit_as(vec3(0.7098, 0.4667, 0.3098), grisaille.xyz);
    vec4 glaze_of_sienna = vec4(mix(grisaille.xyz, _e93, 0.7), 1.0);
    vec3 place_2 = surface.position_object;
    VectorParts height = VectorParts(place_2.x, place_2.y, place_2.z);
    float toward_the_head = smoothstep(-0.5, 0.5, height.y);
    vec4 from_green_to_sienna = mix(glaze_of_green_earth, glaze_of_sienna, toward_the_head);
    vec4 _e114 = mix_colors_soft_light(from_green_to_sienna, vec4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    float curvature = surface.kappa;
    float bulge = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.06), -20.0, 20.0))))))));
    float hollows = mix(0.6, 0.0, min(((bulge - 0.0) / 0.55), 1.0));
    vec4 _e148 = mix_colors_hue(_e114, vec4(0.4902, 0.2471, 0.3608, 1.0), hollows);
    Light _e151 = u_look.back;
    float _e157 = rim(_e151, surface.normal, surface.view, 0.3, 0.6, 1.0);
    vec4 _e163 = mix_colors_screen(_e148, vec4(0.4353, 0.5294, 0.6588, 1.0), _e157);
    vec4 _e164 = finite_vec4_(_e163);
    return _e164;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e24 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x);
    vec4 _e27 = shade(surface_1);
    vec4 _e28 = finite_vec4_(_e27);
    out_color = _e28;
    return;
}

