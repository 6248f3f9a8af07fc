#version 450 core
// Technical cutaway: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws normals and depth, for the curvature pass.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// technical-cutaway.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
};
struct Object {
    mat4x4 world_from_object;
    mat3x3 world_from_normal;
    float id;
    float cutoff;
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
    vec3 value;
    vec4 color;
    float cutoff;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const float LOG2_E = 1.442695;
const ProfileShape metal_tone_shape = ProfileShape(0.99820054, 0.059964005, 7.166244, 3.1997643, 0.12, 0.124456726, 0.0556771, 0u);
const ProfileShape contour_tone_shape = ProfileShape(0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0, 1u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent_1 = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent_1), exponent_1));
}

vec3 normalize_or(vec3 v_1, vec3 otherwise) {
    float largest = max(max(abs(v_1.x), abs(v_1.y)), abs(v_1.z));
    if (!(((largest > 1e-30) && (largest < 1e30)))) {
        return otherwise;
    }
    vec3 scaled = (v_1 * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float exp2_stable(float x_1) {
    float clamped_1 = clamp(x_1, -126.0, 127.99999);
    float whole = roundEven(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_2) {
    float clamped_2 = max(x_2, -126.0);
    float whole_1 = roundEven(clamped_2);
    float f_1 = (clamped_2 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
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

vec3 normalize_moderate(vec3 v_2, vec3 otherwise_1) {
    float square_1 = dot(v_2, v_2);
    return ((square_1 > 1e-30) ? (v_2 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen(vec3 v_3) {
    vec3 _e5 = normalize_moderate(v_3, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y_1, float x_6) {
    float small = min(y_1, x_6);
    float large = max(y_1, x_6);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_6) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_2 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_2 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_2));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < c_2)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float bounded(float x_7) {
    uint bits_1 = floatBitsToUint(x_7);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_7 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float footprint_of(float x_8) {
    float _e1 = dFdx(x_8);
    float _e2 = dFdy(x_8);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

float step_filtered(float x_9, float edge, float w) {
    float d_1 = (x_9 - edge);
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

vec2 slope_of(vec3 normal) {
    return (normal.xy / vec2(max(normal.z, 0.2)));
}

vec4 surface_texel(vec3 normal_1, float depth, float number) {
    vec2 _e3 = slope_of(normal_1);
    return vec4(_e3, depth, ((normal_1.z < 0.0) ? -(number) : number));
}

float curvature_signed(float kappa, float slope) {
    float a_1 = ((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * 0.25);
    float magnitude_1 = min(abs(a_1), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e33 = exp2_stable((-2.88539 * magnitude_1));
    float t_2 = ((1.0 - _e33) / (1.0 + _e33));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float curvature_signed_2_(float kappa_1, float slope_1) {
    float a_2 = ((((floatBitsToUint(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa_1, -10000.0, 10000.0)) * slope_1);
    float magnitude_2 = min(abs(a_2), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_1 = (a_2 * a_2);
        return (a_2 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254)))))));
    }
    float _e32 = exp2_stable((-2.88539 * magnitude_2));
    float t_3 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_2 >= 0.0) ? t_3 : -(t_3));
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

Angle parametrization_specular(Light light_2, vec3 normal_2, vec3 view) {
    vec3 mirrored = (((2.0 * dot(normal_2, view)) * normal_2) - view);
    vec3 _e8 = normalize_moderate(mirrored, normal_2);
    return Angle((0.5 * length((_e8 - light_2.direction))), (0.5 * length((_e8 + light_2.direction))));
}

Angle parametrization_screen_aligned(Light light_3, vec3 normal_3, mat3x3 camera_from_world) {
    vec3 n = (camera_from_world * normal_3);
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

float profile_point(Angle u_2, ProfileShape shape) {
    float s_3 = ((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset));
    if (((s_3 <= 0.0) || false)) {
        return 1.0;
    }
    float q_1 = (s_3 * shape.scale);
    float _e17 = profile_power(q_1, shape.exponent);
    return _e17;
}

float profile_point_2_(Angle u_3, ProfileShape shape_1) {
    float s_4 = ((u_3.half_sin * shape_1.half_cos_offset) - (u_3.half_cos * shape_1.half_sin_offset));
    return (((s_4 <= 0.0) || false) ? 1.0 : ((s_4 <= 4e-7) ? 1.0 : 0.0));
}

float profile_filtered(Angle u_4, float w_1, ProfileShape shape_2) {
    float _e3 = profile_point(u_4, shape_2);
    bool is_wide_1 = (w_1 < (0.1 * shape_2.edge_deviation));
    if (((is_wide_1 || (w_1 <= 0.0)) || false)) {
        return _e3;
    }
    if ((true && (w_1 >= (3.4641016 * shape_2.edge_deviation)))) {
        float width = sqrt(((w_1 * w_1) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
        float _e32 = atan2_positive(u_4.half_sin, u_4.half_cos);
        return clamp((0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e32)) / width)), 0.0, 1.0);
    }
    vec2 _e44 = sin_cos_tiny((0.19364917 * w_1));
    Angle _e45 = angle_turned(u_4, _e44);
    float _e46 = profile_point(_e45, shape_2);
    Angle _e51 = angle_turned(u_4, vec2(-(_e44.x), _e44.y));
    float _e52 = profile_point(_e51, shape_2);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile_filtered_2_(Angle u_5, float w_2, ProfileShape shape_3) {
    float _e3 = profile_point_2_(u_5, shape_3);
    if (((false || (w_2 <= 0.0)) || false)) {
        return _e3;
    }
    float width_1 = sqrt((w_2 * w_2));
    float _e15 = atan2_positive(u_5.half_sin, u_5.half_cos);
    return clamp((0.5 + ((shape_3.offset - (2.0 * _e15)) / width_1)), 0.0, 1.0);
}

float profile(Angle angle, float shift, ProfileShape shape_4) {
    vec2 _e5 = sin_cos_tiny((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_4);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_5);
    return _e8;
}

vec4 gooch(Light light_4, vec3 normal_4, vec4 color_5, vec4 cool, vec4 warm, float cool_amount, float warm_amount) {
    float t_4 = (0.5 + (0.5 * dot(normal_4, light_4.direction)));
    vec3 far = (cool.xyz + (cool_amount * color_5.xyz));
    vec3 near = (warm.xyz + (warm_amount * color_5.xyz));
    return vec4(mix(far, near, clamp(t_4, 0.0, 1.0)), 1.0);
}

Shaded shade(Surface surface_1) {
    Light _e3 = u_look.key;
    vec4 _e22 = gooch(_e3, surface_1.normal, vec4(0.8314, 0.8392, 0.8549, 1.0), vec4(0.1725, 0.2902, 0.4863, 1.0), vec4(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    vec4 cool_to_warm_2_ = vec4((vec3(1.0) + (_e22.xyz - vec3(1.0))), 1.0);
    float _e34 = curvature_signed(surface_1.kappa, 0.25);
    float hollows_convexity = (0.5 + (0.5 * _e34));
    vec4 _e46 = curvature_color(hollows_convexity, vec4(1.0), vec4(0.5412, 0.5804, 0.6588, 1.0));
    Light _e49 = u_look.key;
    LitLayer _e51 = light_apply(_e49, _e46, 1.0);
    vec4 hollows_blend = clamp(vec4((cool_to_warm_2_.xyz + (0.8 * ((cool_to_warm_2_.xyz * (_e51.tone * _e51.color.xyz)) - cool_to_warm_2_.xyz))), 1.0), vec4(0.0), vec4(1.0));
    Light _e73 = u_look.key;
    Angle _e76 = parametrization_specular(_e73, surface_1.normal, surface_1.view);
    float _e79 = curvature_signed_2_(surface_1.kappa, 0.2);
    float metal_convexity = (0.5 + (0.5 * _e79));
    float metal_warp = (((2.0 * metal_convexity) - 1.0) * 0.05);
    float _e91 = profile(_e76, metal_warp, metal_tone_shape);
    Light _e94 = u_look.key;
    LitLayer _e97 = light_apply_2_(_e94, vec4(1.0), _e91);
    vec4 _e102 = blend_alpha(hollows_blend, _e97.color, _e97.tone, 0.8, true);
    Light _e105 = u_look.eye;
    mat3x3 _e109 = u_look.camera_from_world;
    Angle _e110 = parametrization_screen_aligned(_e105, surface_1.normal, _e109);
    float _e113 = curvature_signed_2_(surface_1.kappa, 0.12);
    float contour_convexity = (0.5 + (0.5 * _e113));
    float contour_warp = (((2.0 * contour_convexity) - 1.0) * 0.25);
    float _e125 = profile_2_(_e110, contour_warp, contour_tone_shape);
    Light _e128 = u_look.eye;
    LitLayer _e131 = light_apply_2_(_e128, vec4(1.0), _e125);
    vec4 contour_blend = clamp(vec4((_e102.xyz * (_e131.tone * _e131.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec3 place = surface_1.position_object;
    VectorParts parts = VectorParts(place.x, place.y, place.z);
    float into_the_corner = min(parts.x, parts.z);
    float _e154 = footprint_of(into_the_corner);
    float _e160 = step_filtered(into_the_corner, -0.012, length(vec2(min(_e154, 1000000000000000.0), 0.0)));
    vec4 section_line = clamp(vec4((contour_blend.xyz + (_e160 * (vec3(0.8471, 0.1569, 0.1098) - contour_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float _e178 = footprint_of(into_the_corner);
    float _e184 = step_filtered(into_the_corner, 0.02, length(vec2(min(_e178, 1000000000000000.0), 0.0)));
    float kept = (1.0 - _e184);
    vec4 cut = vec4(section_line.xyz, kept);
    vec4 _e189 = premultiplied(cut);
    vec4 _e190 = output_(_e189);
    return Shaded(surface_1.normal, _e190, 0.5);
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    bool local = false;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen(in_.normal);
    vec4 _e6 = u_view.eye;
    float _e11 = u_view.eye.w;
    vec3 _e15 = normalize_or((_e6.xyz - (_e11 * in_.position)), _e3);
    if (!(is_front)) {
        local = (dot(_e3, _e15) < -0.1);
    } else {
        local = false;
    }
    bool is_behind = local;
    vec3 normal_5 = (is_behind ? -(_e3) : _e3);
    surface.normal = normal_5;
    vec4 _e31 = u_view.eye;
    float _e36 = u_view.eye.w;
    surface.view = normalize((_e31.xyz - (_e36 * in_.position)));
    surface.position_object = in_.position_object;
    surface.kappa = 0.0;
    Surface _e45 = surface;
    Shaded _e46 = shade(_e45);
    if ((_e46.color.w < _e46.cutoff)) {
        discard;
    }
    mat4x4 _e53 = u_view.camera_from_world;
    vec3 seen = (_e53 * vec4(_e46.value, 0.0)).xyz;
    mat4x4 _e61 = u_view.camera_from_world;
    float depth_1 = -((_e61 * vec4(in_.position, 1.0)).z);
    float _e70 = u_object.id;
    vec4 _e73 = surface_texel(seen, depth_1, (_e70 + 1.0));
    out_color = _e73;
    return;
}

