#version 330 core
// Manga, contours: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-manga-contours.json says what to put there and how to draw.
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
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const ProfileShape shadow_tone_shape = ProfileShape(0.78070694, 0.6248973, 0.0, 1.0, 1.35, 0.0, 0.0, 1u);
const ProfileShape contour_tone_shape = ProfileShape(0.8337121, 0.55219936, 0.0, 1.0, 1.17, 0.0, 0.0, 1u);

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float clamped_1 = clamp(x, -126.0, 127.99999);
    float whole = roundEven(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

vec2 sin_cos_eighth(float x_1) {
    float y_1 = (x_1 * x_1);
    float s = (x_1 * (1.0 + (y_1 * (-0.16666667 + (y_1 * (0.008333334 + (y_1 * (-0.0001984127 + (y_1 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * (0.0013888889 + (y_1 * (-2.4801588e-5 + (y_1 * 2.755732e-7))))))))));
    return vec2(s, c);
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y, float x_2) {
    float small = min(y, x_2);
    float large = max(y, x_2);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y > x_2) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_1 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, c_1));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < c_1)) ? vec2(0.0, 1.0) : upper);
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
    float a_2 = ((((floatBitsToUint(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa_1, -10000.0, 10000.0)) * 0.5);
    float magnitude_1 = min(abs(a_2), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_1 = (a_2 * a_2);
        return (a_2 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254)))))));
    }
    float _e33 = exp2_stable((-2.88539 * magnitude_1));
    float t_3 = ((1.0 - _e33) / (1.0 + _e33));
    return ((a_2 >= 0.0) ? t_3 : -(t_3));
}

vec4 blend_multiply(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (0.5 * ((below.xyz * (tone * color.xyz)) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

LitLayer light_apply_2_(Light light_1, vec4 color_2, float tone_2) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light_1.color) * split_1.y), 1.0), split_1.x);
}

LitLayer light_apply_3_(Light light_2, vec4 color_3, float tone_3) {
    vec2 split_2 = vec2(min(light_2.intensity, 1.0), max(light_2.intensity, 1.0));
    return LitLayer(vec4((light_2.color * split_2.y), 1.0), (tone_3 * split_2.x));
}

Angle parametrization_screen_aligned(Light light_3, vec3 normal, mat3x3 camera_from_world) {
    vec3 n = (camera_from_world * normal);
    vec3 _e8 = normalize_moderate(n, vec3(0.0, 0.0, 1.0));
    return Angle((0.5 * length((_e8 - light_3.own_direction))), (0.5 * length((_e8 + light_3.own_direction))));
}

float profile_point(Angle u_2, ProfileShape shape) {
    float s_2 = ((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset));
    return (((s_2 <= 0.0) || false) ? 1.0 : ((s_2 <= 4e-7) ? 1.0 : 0.0));
}

float profile_filtered(Angle u_3, float w, ProfileShape shape_1) {
    float _e3 = profile_point(u_3, shape_1);
    if (((false || (w <= 0.0)) || false)) {
        return _e3;
    }
    float width = sqrt((w * w));
    float _e15 = atan2_positive(u_3.half_sin, u_3.half_cos);
    return clamp((0.5 + ((shape_1.offset - (2.0 * _e15)) / width)), 0.0, 1.0);
}

float profile(Angle angle, float shift, ProfileShape shape_2) {
    vec2 _e5 = sin_cos_eighth((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_2);
    return _e8;
}

vec4 shade(Surface surface_1) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle inked_hollows_angle = Angle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    float _e22 = curvature_signed(surface_1.kappa, 0.3);
    float shadow_convexity = (0.5 + (0.5 * _e22));
    float shadow_warp = (((2.0 * shadow_convexity) - 1.0) * 0.35);
    float _e34 = profile(inked_hollows_angle, shadow_warp, shadow_tone_shape);
    Light _e37 = u_look.key;
    LitLayer _e43 = light_apply(_e37, vec4(0.9843, 0.9765, 0.9569, 1.0), _e34);
    vec4 _e53 = blend_multiply(vec4(0.9843, 0.9765, 0.9569, 1.0), _e43.color, _e43.tone, 0.5, true);
    float _e56 = curvature_signed_2_(surface_1.kappa, 0.5);
    float inked_hollows_convexity = (0.5 + (0.5 * _e56));
    vec4 _e68 = curvature_color(inked_hollows_convexity, vec4(1.0), vec4(0.1647, 0.1451, 0.1882, 1.0));
    Light _e71 = u_look.key;
    LitLayer _e73 = light_apply_2_(_e71, _e68, 1.0);
    vec4 inked_hollows_blend = clamp(vec4((_e53.xyz * (_e73.tone * _e73.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    Light _e89 = u_look.eye;
    mat3x3 _e93 = u_look.camera_from_world;
    Angle _e94 = parametrization_screen_aligned(_e89, surface_1.normal, _e93);
    float _e97 = curvature_signed(surface_1.kappa, 0.12);
    float contour_convexity = (0.5 + (0.5 * _e97));
    float contour_warp = (((2.0 * contour_convexity) - 1.0) * 0.3);
    float _e109 = profile(_e94, contour_warp, contour_tone_shape);
    Light _e112 = u_look.eye;
    LitLayer _e115 = light_apply_3_(_e112, vec4(1.0), _e109);
    vec4 output_ = clamp(vec4((inked_hollows_blend.xyz * (_e115.tone * _e115.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_1;
    vec4 _e14 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e14.x;
    Surface _e16 = surface;
    vec4 _e17 = shade(_e16);
    out_color = _e17;
    return;
}

