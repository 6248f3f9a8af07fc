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
const float HALF_PI = 1.5707964;
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

float exp2_stable(float x_2) {
    float clamped_1 = clamp(x_2, -126.0, 127.99999);
    float whole = roundEven(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_3) {
    float clamped_2 = max(x_3, -126.0);
    float whole_1 = roundEven(clamped_2);
    float f_1 = (clamped_2 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float log2_stable(float x_4) {
    uint bits = floatBitsToUint(x_4);
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

vec2 sin_cos_quarter(float x_5) {
    float h = (0.5 * x_5);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

vec2 sin_cos_eighth(float x_6) {
    float y_2 = (x_6 * x_6);
    float s_1 = (x_6 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c_1 = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return vec2(s_1, c_1);
}

vec2 sin_cos_tiny(float x_7) {
    float y_3 = (x_7 * x_7);
    float s_2 = (x_7 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334)))));
    float c_2 = (1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889))))));
    return vec2(s_2, c_2);
}

vec3 normalize_moderate(vec3 v, vec3 otherwise_1) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise_1);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y_1, float x_8) {
    float small = min(y_1, x_8);
    float large = max(y_1, x_8);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_8) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_3, 0.5);
    return min(_e13, 0.5);
}

float angle_footprint_2_(Angle u_1) {
    vec2 half_1 = vec2(u_1.half_sin, u_1.half_cos);
    vec2 dx_1 = dFdx(half_1);
    vec2 dy_1 = dFdy(half_1);
    float w_4 = (2.0 * sqrt((dot(dx_1, dx_1) + dot(dy_1, dy_1))));
    return min(w_4, 0.5);
}

Angle angle_turned(Angle u_2, vec2 t) {
    float s_3 = ((u_2.half_sin * t.y) - (u_2.half_cos * t.x));
    float c_3 = ((u_2.half_cos * t.y) + (u_2.half_sin * t.x));
    vec2 upper = ((c_3 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_3));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < c_3)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

float curvature_signed(float kappa, float slope) {
    float a_1 = ((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * 0.25);
    float magnitude = min(abs(a_1), 50.0);
    if ((magnitude < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e33 = exp2_stable((-2.88539 * magnitude));
    float t_2 = ((1.0 - _e33) / (1.0 + _e33));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float curvature_signed_2_(float kappa_1, float slope_1) {
    float a_2 = ((((floatBitsToUint(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa_1, -10000.0, 10000.0)) * slope_1);
    float magnitude_1 = min(abs(a_2), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_1 = (a_2 * a_2);
        return (a_2 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254)))))));
    }
    float _e32 = exp2_stable((-2.88539 * magnitude_1));
    float t_3 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_2 >= 0.0) ? t_3 : -(t_3));
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

Angle parametrization_specular(Light light_3, vec3 normal, vec3 view) {
    vec3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    vec3 _e8 = normalize_moderate(mirrored, normal);
    return Angle((0.5 * length((_e8 - light_3.direction))), (0.5 * length((_e8 + light_3.direction))));
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
    float _e21 = exp2_stable((exponent * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape) {
    float s_4 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
    if (((s_4 <= 0.0) || (shape.kind == PROFILE_AMBIENT))) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_4 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_2 = (s_4 * shape.scale);
    float _e27 = profile_power(q_2, shape.exponent);
    return _e27;
}

float profile_point_2_(Angle u_4, ProfileShape shape_1) {
    float s_5 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
    if (((s_5 <= 0.0) || false)) {
        return 1.0;
    }
    if ((shape_1.kind == PROFILE_STEP)) {
        return ((s_5 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_3 = (s_5 * shape_1.scale);
    float _e25 = profile_power(q_3, shape_1.exponent);
    return _e25;
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
    float _e21 = exp2_stable_2_((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_3_(Angle u_5, ProfileShape shape_2) {
    float s_6 = ((u_5.half_sin * shape_2.half_cos_offset) - (u_5.half_cos * shape_2.half_sin_offset));
    if (((s_6 <= 0.0) || false)) {
        return 1.0;
    }
    float q_4 = (s_6 * shape_2.scale);
    float _e17 = profile_power_2_(q_4, shape_2.exponent);
    return _e17;
}

float profile_filtered(Angle u_6, float w, ProfileShape shape_3) {
    float _e3 = profile_point(u_6, shape_3);
    bool is_wide_1 = (w < (0.1 * shape_3.edge_deviation));
    if (((is_wide_1 || (w <= 0.0)) || (shape_3.kind == PROFILE_AMBIENT))) {
        return _e3;
    }
    if (((shape_3.edge_deviation < 0.145) && (w >= (3.4641016 * shape_3.edge_deviation)))) {
        float width = sqrt(((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
        float _e36 = atan2_positive(u_6.half_sin, u_6.half_cos);
        return clamp((0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e36)) / width)), 0.0, 1.0);
    }
    vec2 _e48 = sin_cos_tiny((0.19364917 * w));
    Angle _e49 = angle_turned(u_6, _e48);
    float _e50 = profile_point(_e49, shape_3);
    Angle _e55 = angle_turned(u_6, vec2(-(_e48.x), _e48.y));
    float _e56 = profile_point(_e55, shape_3);
    return ((((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_2_(Angle u_7, float w_1, ProfileShape shape_4) {
    float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_2 = (w_1 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_2 || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    if (((shape_4.edge_deviation < 0.145) && (w_1 >= (3.4641016 * shape_4.edge_deviation)))) {
        float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
        float _e34 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return clamp((0.5 + (((shape_4.offset + shape_4.edge_mean) - (2.0 * _e34)) / width_1)), 0.0, 1.0);
    }
    vec2 _e46 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e47 = angle_turned(u_7, _e46);
    float _e48 = profile_point_2_(_e47, shape_4);
    Angle _e53 = angle_turned(u_7, vec2(-(_e46.x), _e46.y));
    float _e54 = profile_point_2_(_e53, shape_4);
    return ((((5.0 * _e48) + (8.0 * _e3)) + (5.0 * _e54)) / 18.0);
}

float profile_filtered_3_(Angle u_8, float w_2, ProfileShape shape_5) {
    float _e3 = profile_point_3_(u_8, shape_5);
    bool is_wide_3 = (w_2 < (0.1 * shape_5.edge_deviation));
    if (((is_wide_3 || (w_2 <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w_2 >= (3.4641016 * shape_5.edge_deviation)))) {
        float width_2 = sqrt(((w_2 * w_2) + ((12.0 * shape_5.edge_deviation) * shape_5.edge_deviation)));
        float _e32 = atan2_positive(u_8.half_sin, u_8.half_cos);
        return clamp((0.5 + (((shape_5.offset + shape_5.edge_mean) - (2.0 * _e32)) / width_2)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w_2));
    Angle _e45 = angle_turned(u_8, _e44);
    float _e46 = profile_point_3_(_e45, shape_5);
    Angle _e51 = angle_turned(u_8, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point_3_(_e51, shape_5);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_6) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint_2_(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_6);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_7) {
    vec2 _e8 = sin_cos_quarter((0.5 * clamp(shift_1, -3.1415927, PI)));
    Angle _e9 = angle_turned(angle_1, _e8);
    float _e10 = angle_footprint(_e9);
    float _e11 = profile_filtered_2_(_e9, _e10, shape_7);
    return _e11;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_8) {
    vec2 _e5 = sin_cos_tiny((0.5 * shift_2));
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint_2_(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed(surface_1.kappa, 0.25);
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
    float _e79 = profile(diffuse_angle, diffuse_warp, _e78);
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
    float _e142 = profile_2_(back_light_angle, back_light_warp, _e141);
    Light _e145 = u_look.back;
    LitLayer _e146 = light_apply(_e145, back_light_color, _e142);
    vec4 _e157 = blend_finish(diffuse_blend, (diffuse_blend.xyz + (_e146.tone * _e146.color.xyz)), 1.0, _e146.color.w, true);
    float _e160 = curvature_signed_2_(surface_1.kappa, 0.2);
    float highlight_convexity = (0.5 + (0.5 * _e160));
    vec4 _e167 = u_look.highlight_color_concave;
    vec4 _e170 = u_look.highlight_color_convex;
    vec4 _e173 = u_look.highlight_color_concave;
    vec4 highlight_color = (_e167 + (highlight_convexity * (_e170 - _e173)));
    Light _e179 = u_look.key;
    Angle _e182 = parametrization_specular(_e179, surface_1.normal, surface_1.view);
    float highlight_warp = (((2.0 * highlight_convexity) - 1.0) * 0.05);
    float _e190 = profile_3_(_e182, highlight_warp, highlight_tone_shape);
    Light _e193 = u_look.key;
    LitLayer _e194 = light_apply(_e193, highlight_color, _e190);
    vec4 _e205 = blend_finish(_e157, (_e157.xyz + (_e194.tone * _e194.color.xyz)), 1.0, _e194.color.w, true);
    return _e205;
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

