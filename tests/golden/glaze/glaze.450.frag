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
const float LOG2_E = 1.442695;
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
    uvec4 exponent_2 = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent_2), exponent_2));
}

float exp2_stable(float x) {
    float clamped_1 = clamp(x, -126.0, 127.99999);
    float whole = roundEven(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_1) {
    float whole_1 = roundEven(x_1);
    float f_1 = (x_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float exp2_stable_3_(float x_2) {
    float clamped_2 = max(x_2, -126.0);
    float whole_2 = roundEven(clamped_2);
    float f_2 = (clamped_2 - whole_2);
    float twice_2 = (2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724))))))))))));
    return (twice_2 * uintBitsToFloat((uint((int(whole_2) + 126)) << 23u)));
}

float log2_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int exponent_3 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_3) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_3) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_tiny(float x_4) {
    float y_1 = (x_4 * x_4);
    float s = (x_4 * (1.0 + (y_1 * (-0.16666667 + (y_1 * 0.008333334)))));
    float c = (1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * 0.0013888889))))));
    return vec2(s, c);
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
    float s_1 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, c_1));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_2 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_2 = (u_2.half_cos + (u_2.half_sin * 0.0));
    vec2 upper_1 = ((c_2 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_2));
    vec2 turned_1 = (((s_2 <= 0.0) && (s_2 < c_2)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

vec3 bounded_vec3_(vec3 v_3) {
    uvec3 bits_1 = floatBitsToUint(v_3);
    uvec3 magnitude = (bits_1 & uvec3(2147483647u));
    vec3 largest = uintBitsToFloat(((bits_1 & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest, equal(magnitude, uvec3(2139095040u)));
    return mix(numbers, v_3, lessThan(magnitude, uvec3(2139095040u)));
}

vec3 mixed_vec3_(vec3 a, vec3 b, float t_2) {
    vec3 _e4 = bounded_vec3_((b - a));
    vec3 _e14 = bounded_vec3_(((t_2 < 0.5) ? (a + (t_2 * _e4)) : (b - ((1.0 - t_2) * _e4))));
    return _e14;
}

float footprint_of(float x_5) {
    float _e1 = dFdx(x_5);
    float _e2 = dFdy(x_5);
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

float curvature_signed(float kappa, float slope) {
    float a_6 = ((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope);
    float magnitude_1 = min(abs(a_6), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_6 * a_6);
        return (a_6 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e32 = exp2_stable((-2.88539 * magnitude_1));
    float t_3 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_6 >= 0.0) ? t_3 : -(t_3));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_specular(Light light_1, vec3 normal, vec3 view) {
    vec3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    vec3 _e8 = normalize_moderate(mirrored, normal);
    return Angle((0.5 * length((_e8 - light_1.direction))), (0.5 * length((_e8 + light_1.direction))));
}

float profile_power(float q, float exponent) {
    float log_base = 0.0;
    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        float _e11 = log1p_negative_small((q * q));
        log_base = (LOG2_E * _e11);
    } else {
        float _e18 = log2_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e18;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable_2_((exponent * _e19));
    return min(_e21, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape) {
    float s_3 = (u_3.half_sin - (u_3.half_cos * 0.0));
    if (((s_3 <= 0.0) || false)) {
        return 1.0;
    }
    float q_2 = (s_3 * shape.scale);
    float _e15 = profile_power(q_2, shape.exponent);
    return _e15;
}

float profile_power_2_(float q_1, float exponent_1) {
    float log_base_1 = 0.0;
    if ((q_1 >= 1.0)) {
        return 0.0;
    }
    if ((q_1 < 0.5)) {
        float _e11 = log1p_negative_small((q_1 * q_1));
        log_base_1 = (LOG2_E * _e11);
    } else {
        float _e18 = log2_stable(((1.0 - q_1) * (1.0 + q_1)));
        log_base_1 = _e18;
    }
    float _e19 = log_base_1;
    float _e21 = exp2_stable_3_((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_2_(Angle u_4, ProfileShape shape_1) {
    float s_4 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
    if (((s_4 <= 0.0) || false)) {
        return 1.0;
    }
    float q_3 = (s_4 * shape_1.scale);
    float _e17 = profile_power_2_(q_3, shape_1.exponent);
    return _e17;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_2) {
    float _e3 = profile_point(u_5, shape_2);
    bool is_wide = (w < (0.1 * shape_2.edge_deviation));
    if (((is_wide || (w <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w));
    Angle _e16 = angle_turned(u_5, _e15);
    float _e17 = profile_point(_e16, shape_2);
    Angle _e22 = angle_turned(u_5, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point(_e22, shape_2);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_2_(Angle u_6, float w_1, ProfileShape shape_3) {
    float _e3 = profile_point_2_(u_6, shape_3);
    bool is_wide_1 = (w_1 < (0.1 * shape_3.edge_deviation));
    if (((is_wide_1 || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e16 = angle_turned(u_6, _e15);
    float _e17 = profile_point_2_(_e16, shape_3);
    Angle _e22 = angle_turned(u_6, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point_2_(_e22, shape_3);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned_2_(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_4);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_5);
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
    vec3 _e42 = normalize_moderate(across, vec3(0.0));
    float side = dot((normal_1 - (dot(normal_1, view_1) * view_1)), _e42);
    return (inside * mix(1.0, smoothstep(0.0, 0.5, side), 1.0));
}

vec4 shade(Surface surface_1) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle gray_modeling_angle = Angle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    float _e22 = profile(gray_modeling_angle, 0.0, gray_modeling_tone_shape);
    Light _e25 = u_look.key;
    LitLayer _e31 = light_apply(_e25, vec4(0.7059, 0.7059, 0.7059, 1.0), _e22);
    vec4 _e41 = blend_alpha(vec4(0.1216, 0.1216, 0.1216, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = u_look.key;
    Angle _e47 = parametrization_specular(_e44, surface_1.normal, surface_1.view);
    float _e50 = profile_2_(_e47, 0.0, gray_lights_tone_shape);
    Light _e53 = u_look.key;
    LitLayer _e59 = light_apply(_e53, vec4(0.2902, 0.2902, 0.2902, 1.0), _e50);
    vec4 gray_lights_blend = clamp(vec4((_e41.xyz + (_e59.tone * _e59.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 grisaille = vec4(gray_lights_blend.xyz, 1.0);
    vec3 _e82 = lit_as(vec3(0.4275, 0.5412, 0.4471), grisaille.xyz);
    vec4 glaze_of_green_earth = vec4(mix(grisaille.xyz, _e82, 0.75), 1.0);
    vec3 _e93 = lit_as(vec3(0.7098, 0.4667, 0.3098), grisaille.xyz);
    vec4 glaze_of_sienna = vec4(mix(grisaille.xyz, _e93, 0.7), 1.0);
    vec3 place = surface_1.position_object;
    VectorParts height = VectorParts(place.x, place.y, place.z);
    float toward_the_head = smoothstep(-0.5, 0.5, height.y);
    vec4 from_green_to_sienna = mix(glaze_of_green_earth, glaze_of_sienna, toward_the_head);
    vec4 _e114 = mix_colors_soft_light(from_green_to_sienna, vec4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    float curvature = (((floatBitsToUint(surface_1.kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(surface_1.kappa, -10000.0, 10000.0));
    float _e128 = curvature_signed(curvature, 0.06);
    float bulge = (0.5 + (0.5 * _e128));
    float hollows = mix(0.6, 0.0, min(((bulge - 0.0) / 0.55), 1.0));
    vec4 _e147 = mix_colors_hue(_e114, vec4(0.4902, 0.2471, 0.3608, 1.0), hollows);
    Light _e150 = u_look.back;
    float _e156 = rim(_e150, surface_1.normal, surface_1.view, 0.3, 0.6, 1.0);
    vec4 _e162 = mix_colors_screen(_e147, vec4(0.4353, 0.5294, 0.6588, 1.0), _e156);
    vec4 _e163 = finite_vec4_(_e162);
    return _e163;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_2;
    vec4 _e11 = u_view.eye;
    float _e16 = u_view.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    surface.position_object = in_.position_object;
    vec4 _e29 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e29.x;
    Surface _e31 = surface;
    vec4 _e32 = shade(_e31);
    vec4 _e33 = finite_vec4_(_e32);
    out_color = _e33;
    return;
}

