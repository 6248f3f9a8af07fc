#version 300 es
// Vessel, symbolic red: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure7-vessel.json says what to put there and how to draw.

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
    Light key;
    Light side;
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
const float HALF_PI = 1.5707964;
const float LOG2_E = 1.442695;
const ProfileShape tone_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.1528398, 1.361735, 0.1, 1.1474836, 0.4845149, 0u);
const ProfileShape shade_tone_shape = ProfileShape(0.9950042, 0.099833414, 1.4670527, 1.847488, 0.2, 0.7777539, 0.33241227, 0u);
const ProfileShape light_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.9163208, 3.0838382, 0.1, 0.3121117, 0.13987324, 0u);
const ProfileShape edge_tone_shape = ProfileShape(0.8525245, 0.52268726, 5.0334897, 2.4651666, 1.1, 0.19658314, 0.08474467, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float clamped_3 = clamp(x, -126.0, 127.99999);
    float whole = roundEven(clamped_3);
    float f = (clamped_3 - whole);
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
    float clamped_4 = max(x_2, -126.0);
    float whole_2 = roundEven(clamped_4);
    float f_2 = (clamped_4 - whole_2);
    float twice_2 = (2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724))))))))))));
    return (twice_2 * uintBitsToFloat((uint((int(whole_2) + 126)) << 23u)));
}

float log2_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int exponent_2 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_2) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_2) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_eighth(float x_4) {
    float y_2 = (x_4 * x_4);
    float s = (x_4 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return vec2(s, c);
}

vec2 sin_cos_tiny(float x_5) {
    float y_3 = (x_5 * x_5);
    float s_1 = (x_5 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334)))));
    float c_1 = (1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889))))));
    return vec2(s_1, c_1);
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y_1, float x_6) {
    float small = min(y_1, x_6);
    float large = max(y_1, x_6);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_6) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_2 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_2 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_2));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < c_2)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_3 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_3 = (u_2.half_cos + (u_2.half_sin * 0.0));
    vec2 upper_1 = ((c_3 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_3));
    vec2 turned_1 = (((s_3 <= 0.0) && (s_3 < c_3)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float curvature_signed(float kappa, float slope) {
    float a_1 = ((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope);
    float magnitude = min(abs(a_1), 50.0);
    if ((magnitude < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e32 = exp2_stable((-2.88539 * magnitude));
    float t_3 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_1 >= 0.0) ? t_3 : -(t_3));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_alpha_2_(vec4 below_1, vec4 color_1, float tone_1, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_shade(vec4 below_2, vec4 color_2, float tone_2, float opacity_2, bool clamped_2) {
    return clamp(vec4((below_2.xyz + (opacity_2 * ((below_2.xyz * mix(vec3(1.0), color_2.xyz, tone_2)) - below_2.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_3, float tone_3) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_3.xyz * light.color) * split.y), 1.0), (tone_3 * split.x));
}

LitLayer light_apply_2_(Light light_1, vec4 color_4, float tone_4) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4((light_1.color * split_1.y), 1.0), (tone_4 * split_1.x));
}

Angle parametrization_specular(Light light_2, vec3 normal, vec3 view) {
    vec3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    vec3 _e8 = normalize_moderate(mirrored, normal);
    return Angle((0.5 * length((_e8 - light_2.direction))), (0.5 * length((_e8 + light_2.direction))));
}

Angle parametrization_screen_aligned(Light light_3, vec3 normal_1, mat3x3 camera_from_world) {
    vec3 n = (camera_from_world * normal_1);
    vec3 _e8 = normalize_moderate(n, vec3(0.0, 0.0, 1.0));
    return Angle((0.5 * length((_e8 - light_3.own_direction))), (0.5 * length((_e8 + light_3.own_direction))));
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
    float s_4 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
    if (((s_4 <= 0.0) || false)) {
        return 1.0;
    }
    float q_2 = (s_4 * shape.scale);
    float _e17 = profile_power(q_2, shape.exponent);
    return _e17;
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
    float s_5 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
    if (((s_5 <= 0.0) || false)) {
        return 1.0;
    }
    float q_3 = (s_5 * shape_1.scale);
    float _e17 = profile_power_2_(q_3, shape_1.exponent);
    return _e17;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_2) {
    float _e3 = profile_point(u_5, shape_2);
    bool is_wide_1 = (w < (0.1 * shape_2.edge_deviation));
    if (((is_wide_1 || (w <= 0.0)) || false)) {
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
    bool is_wide_2 = (w_1 < (0.1 * shape_3.edge_deviation));
    if (((is_wide_2 || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w_1 >= (3.4641016 * shape_3.edge_deviation)))) {
        float width = sqrt(((w_1 * w_1) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
        float _e32 = atan2_positive(u_6.half_sin, u_6.half_cos);
        return clamp((0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e32)) / width)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e45 = angle_turned(u_6, _e44);
    float _e46 = profile_point_2_(_e45, shape_3);
    Angle _e51 = angle_turned(u_6, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point_2_(_e51, shape_3);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_4) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
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

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_6) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_6);
    return _e8;
}

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed(surface_1.kappa, 0.2);
    float light_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(light_convexity, vec4(0.8471, 0.2588, 0.2353, 1.0), vec4(0.5412, 0.1098, 0.1647, 1.0));
    vec3 _e23 = u_look.key.direction;
    vec3 _e32 = u_look.key.direction;
    Angle tone_angle = Angle((0.5 * length((surface_1.normal - _e23))), (0.5 * length((surface_1.normal + _e32))));
    float tone_warp = (((2.0 * light_convexity) - 1.0) * 0.3);
    float _e45 = profile(tone_angle, tone_warp, tone_tone_shape);
    Light _e48 = u_look.key;
    LitLayer _e49 = light_apply(_e48, _e18, _e45);
    vec4 _e59 = blend_alpha(vec4(0.4784, 0.0784, 0.1255, 1.0), _e49.color, _e49.tone, 1.0, true);
    vec4 _e70 = curvature_color(light_convexity, vec4(0.6902, 0.1882, 0.2196, 1.0), vec4(0.3529, 0.0627, 0.1255, 1.0));
    vec3 _e75 = u_look.side.direction;
    vec3 _e84 = u_look.side.direction;
    Angle shade_angle = Angle((0.5 * length((surface_1.normal - _e75))), (0.5 * length((surface_1.normal + _e84))));
    float shade_warp = (((2.0 * light_convexity) - 1.0) * -0.2);
    float _e97 = profile(shade_angle, shade_warp, shade_tone_shape);
    Light _e100 = u_look.side;
    LitLayer _e101 = light_apply(_e100, _e70, _e97);
    vec4 _e106 = blend_shade(_e59, _e101.color, _e101.tone, 0.8, true);
    Light _e109 = u_look.key;
    Angle _e112 = parametrization_specular(_e109, surface_1.normal, surface_1.view);
    float _e115 = profile_2_(_e112, 0.0, light_tone_shape);
    Light _e118 = u_look.key;
    LitLayer _e124 = light_apply(_e118, vec4(1.0, 0.8471, 0.8, 1.0), _e115);
    vec4 _e129 = blend_alpha_2_(_e106, _e124.color, _e124.tone, 0.6, true);
    Light _e132 = u_look.eye;
    mat3x3 _e136 = u_look.camera_from_world;
    Angle _e137 = parametrization_screen_aligned(_e132, surface_1.normal, _e136);
    float _e140 = curvature_signed(surface_1.kappa, 0.1);
    float edge_convexity = (0.5 + (0.5 * _e140));
    float edge_warp = (((2.0 * edge_convexity) - 1.0) * 0.2);
    float _e152 = profile_3_(_e137, edge_warp, edge_tone_shape);
    Light _e155 = u_look.eye;
    LitLayer _e158 = light_apply_2_(_e155, vec4(1.0), _e152);
    vec4 output_ = clamp(vec4((_e129.xyz + (0.55 * ((_e129.xyz * (_e158.tone * _e158.color.xyz)) - _e129.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_2;
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

