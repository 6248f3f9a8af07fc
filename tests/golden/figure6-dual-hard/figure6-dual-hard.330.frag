#version 330 core
// Dual lighting, hard: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-dual-hard.json says what to put there and how to draw.
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
    Light cool;
    Light warm;
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
const ProfileShape warm_side_tone_shape = ProfileShape(0.9305076, 0.36627254, 5.4363623, 1.7744379, 0.75, 0.20524569, 0.083345205, 0u);
const ProfileShape cool_side_tone_shape = ProfileShape(0.9393727, 0.3428978, 5.743557, 1.7484518, 0.7, 0.19521655, 0.07901356, 0u);
const ProfileShape cool_edge_tone_shape = ProfileShape(0.9887711, 0.14943813, 10.016686, 1.8827307, 0.3, 0.108895466, 0.044647813, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float clamped = clamp(x, -126.0, 127.99999);
    float whole = roundEven(clamped);
    float f = (clamped - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_1) {
    float whole_1 = roundEven(x_1);
    float f_1 = (x_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float log2_stable(float x_2) {
    uint bits = floatBitsToUint(x_2);
    int exponent_1 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_eighth(float x_3) {
    float y_2 = (x_3 * x_3);
    float s = (x_3 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return vec2(s, c);
}

vec2 sin_cos_tiny(float x_4) {
    float y_3 = (x_4 * x_4);
    float s_1 = (x_4 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334)))));
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

float atan2_positive(float y_1, float x_5) {
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_5) ? (HALF_PI - a) : a);
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
    float t_2 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float curvature_signed_2_(float kappa_1, float slope_1) {
    float a_2 = ((((floatBitsToUint(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa_1, -10000.0, 10000.0)) * 0.25);
    float magnitude_1 = min(abs(a_2), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_1 = (a_2 * a_2);
        return (a_2 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254)))))));
    }
    float _e33 = exp2_stable((-2.88539 * magnitude_1));
    float t_3 = ((1.0 - _e33) / (1.0 + _e33));
    return ((a_2 >= 0.0) ? t_3 : -(t_3));
}

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
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

float profile_point(Angle u_2, ProfileShape shape) {
    float s_3 = ((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset));
    if (((s_3 <= 0.0) || false)) {
        return 1.0;
    }
    float q_1 = (s_3 * shape.scale);
    float _e17 = profile_power(q_1, shape.exponent);
    return _e17;
}

float profile_filtered(Angle u_3, float w, ProfileShape shape_1) {
    float _e3 = profile_point(u_3, shape_1);
    bool is_wide_1 = (w < (0.1 * shape_1.edge_deviation));
    if (((is_wide_1 || (w <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w >= (3.4641016 * shape_1.edge_deviation)))) {
        float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e32 = atan2_positive(u_3.half_sin, u_3.half_cos);
        return clamp((0.5 + (((0.75 + shape_1.edge_mean) - (2.0 * _e32)) / width)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w));
    Angle _e45 = angle_turned(u_3, _e44);
    float _e46 = profile_point(_e45, shape_1);
    Angle _e51 = angle_turned(u_3, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point(_e51, shape_1);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile_filtered_2_(Angle u_4, float w_1, ProfileShape shape_2) {
    float _e3 = profile_point(u_4, shape_2);
    bool is_wide_2 = (w_1 < (0.1 * shape_2.edge_deviation));
    if (((is_wide_2 || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w_1 >= (3.4641016 * shape_2.edge_deviation)))) {
        float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
        float _e32 = atan2_positive(u_4.half_sin, u_4.half_cos);
        return clamp((0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e32)) / width_1)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e45 = angle_turned(u_4, _e44);
    float _e46 = profile_point(_e45, shape_2);
    Angle _e51 = angle_turned(u_4, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point(_e51, shape_2);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_3) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_3);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_4) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_4);
    return _e8;
}

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed(surface_1.kappa, 0.3);
    float cool_side_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(cool_side_convexity, vec4(0.9412, 0.6588, 0.3765, 1.0), vec4(0.6039, 0.2275, 0.1412, 1.0));
    vec3 _e23 = u_look.warm.direction;
    vec3 _e32 = u_look.warm.direction;
    Angle warm_side_angle = Angle((0.5 * length((surface_1.normal - _e23))), (0.5 * length((surface_1.normal + _e32))));
    float warm_side_warp = (((2.0 * cool_side_convexity) - 1.0) * 0.45);
    float _e45 = profile(warm_side_angle, warm_side_warp, warm_side_tone_shape);
    Light _e48 = u_look.warm;
    LitLayer _e49 = light_apply(_e48, _e18, _e45);
    vec4 warm_side_blend = clamp(vec4((vec3(0.0314, 0.0275, 0.0392) + (_e49.tone * _e49.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e76 = curvature_color(cool_side_convexity, vec4(0.4353, 0.698, 0.9412, 1.0), vec4(0.1451, 0.251, 0.4353, 1.0));
    vec3 _e81 = u_look.cool.direction;
    vec3 _e90 = u_look.cool.direction;
    Angle cool_side_angle = Angle((0.5 * length((surface_1.normal - _e81))), (0.5 * length((surface_1.normal + _e90))));
    float cool_side_warp = (((2.0 * cool_side_convexity) - 1.0) * 0.4);
    float _e103 = profile_2_(cool_side_angle, cool_side_warp, cool_side_tone_shape);
    Light _e106 = u_look.cool;
    LitLayer _e107 = light_apply(_e106, _e76, _e103);
    vec4 cool_side_blend = clamp(vec4((warm_side_blend.xyz + (_e107.tone * _e107.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    float _e123 = curvature_signed_2_(surface_1.kappa, 0.25);
    float cool_edge_convexity = (0.5 + (0.5 * _e123));
    vec4 _e138 = curvature_color(cool_edge_convexity, vec4(0.3529, 0.3725, 0.4, 1.0), vec4(0.1255, 0.1412, 0.1569, 1.0));
    Light _e141 = u_look.cool;
    Angle _e144 = parametrization_specular(_e141, surface_1.normal, surface_1.view);
    float cool_edge_warp = (((2.0 * cool_edge_convexity) - 1.0) * 0.2);
    float _e152 = profile_2_(_e144, cool_edge_warp, cool_edge_tone_shape);
    Light _e155 = u_look.cool;
    LitLayer _e156 = light_apply(_e155, _e138, _e152);
    vec4 output_ = clamp(vec4((cool_side_blend.xyz + (_e156.tone * _e156.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen(in_.normal);
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

