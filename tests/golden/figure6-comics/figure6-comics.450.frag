#version 450 core
// Comics: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-comics.json says what to put there and how to draw.
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
    Light rim;
    Light fill;
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
const ProfileShape key_tone_shape = ProfileShape(0.8472551, 0.5311862, 0.0, 1.0, 1.12, 0.0, 0.0, 1u);
const ProfileShape bounce_tone_shape = ProfileShape(0.9358968, 0.35227424, 0.0, 1.0, 0.72, 0.0, 0.0, 1u);
const ProfileShape light_tone_shape = ProfileShape(0.96638995, 0.25708055, 0.0, 1.0, 0.52, 0.0, 0.0, 1u);
const ProfileShape rim_tone_shape = ProfileShape(0.9130889, 0.40776044, 0.0, 1.0, 0.84, 0.0, 0.0, 1u);
const ProfileShape highlight_tone_shape = ProfileShape(0.99280864, 0.119712204, 0.0, 1.0, 0.24, 0.0, 0.0, 1u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
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

vec2 sin_cos_tiny(float x_2) {
    float y_2 = (x_2 * x_2);
    float s_1 = (x_2 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334)))));
    float c_1 = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * 0.0013888889))))));
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

float atan2_positive(float y, float x_3) {
    float small = min(y, x_3);
    float large = max(y, x_3);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y > x_3) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
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

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), split.x);
}

LitLayer light_apply_2_(Light light_1, vec4 color_2, float tone_2) {
    vec2 split_1 = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light_1.color) * split_1.y), 1.0), (tone_2 * split_1.x));
}

Angle parametrization_specular(Light light_2, vec3 normal, vec3 view) {
    vec3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    vec3 _e8 = normalize_moderate(mirrored, normal);
    return Angle((0.5 * length((_e8 - light_2.direction))), (0.5 * length((_e8 + light_2.direction))));
}

float profile_point(Angle u_2, ProfileShape shape) {
    float s_3 = ((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset));
    return (((s_3 <= 0.0) || false) ? 1.0 : ((s_3 <= 4e-7) ? 1.0 : 0.0));
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

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_3) {
    vec2 _e5 = sin_cos_tiny((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_3);
    return _e8;
}

vec4 shade(Surface surface_1) {
    float _e3 = curvature_signed(surface_1.kappa, 0.35);
    float key_convexity = (0.5 + (0.5 * _e3));
    vec4 _e18 = curvature_color(key_convexity, vec4(0.7059, 0.3412, 0.2902, 1.0), vec4(0.2941, 0.1098, 0.2, 1.0));
    Light _e21 = u_look.key;
    LitLayer _e23 = light_apply(_e21, _e18, 1.0);
    vec4 _e33 = blend_alpha(vec4(0.8863, 0.6275, 0.4353, 1.0), _e23.color, _e23.tone, 1.0, true);
    vec4 _e44 = curvature_color(key_convexity, vec4(0.9529, 0.6902, 0.4392, 1.0), vec4(0.7686, 0.3451, 0.2902, 1.0));
    vec3 _e49 = u_look.key.direction;
    vec3 _e58 = u_look.key.direction;
    Angle light_angle = Angle((0.5 * length((surface_1.normal - _e49))), (0.5 * length((surface_1.normal + _e58))));
    float key_warp = (((2.0 * key_convexity) - 1.0) * 0.45);
    float _e71 = profile(light_angle, key_warp, key_tone_shape);
    Light _e74 = u_look.key;
    LitLayer _e75 = light_apply_2_(_e74, _e44, _e71);
    vec4 key_blend = clamp(vec4((_e33.xyz + (_e75.tone * (_e75.color.xyz - _e33.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float _e93 = curvature_signed(surface_1.kappa, 0.3);
    float light_convexity = (0.5 + (0.5 * _e93));
    vec4 _e108 = curvature_color(light_convexity, vec4(0.8157, 0.4863, 0.3686, 1.0), vec4(0.549, 0.2275, 0.298, 1.0));
    vec3 _e113 = u_look.fill.direction;
    vec3 _e122 = u_look.fill.direction;
    Angle bounce_angle = Angle((0.5 * length((surface_1.normal - _e113))), (0.5 * length((surface_1.normal + _e122))));
    float bounce_warp = (((2.0 * light_convexity) - 1.0) * 0.35);
    float _e135 = profile(bounce_angle, bounce_warp, bounce_tone_shape);
    Light _e138 = u_look.fill;
    LitLayer _e139 = light_apply_2_(_e138, _e108, _e135);
    vec4 bounce_blend = clamp(vec4((key_blend.xyz + (_e139.tone * (_e139.color.xyz - key_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e165 = curvature_color(light_convexity, vec4(1.0, 0.851, 0.6275, 1.0), vec4(0.9412, 0.6431, 0.4078, 1.0));
    float light_warp = (((2.0 * light_convexity) - 1.0) * 0.3);
    float _e173 = profile(light_angle, light_warp, light_tone_shape);
    Light _e176 = u_look.key;
    LitLayer _e177 = light_apply_2_(_e176, _e165, _e173);
    vec4 light_blend = clamp(vec4((bounce_blend.xyz + (_e177.tone * (_e177.color.xyz - bounce_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float _e195 = curvature_signed_2_(surface_1.kappa, 0.25);
    float highlight_convexity = (0.5 + (0.5 * _e195));
    vec4 _e210 = curvature_color(highlight_convexity, vec4(1.0, 0.9569, 0.8627, 1.0), vec4(0.949, 0.6588, 0.4196, 1.0));
    vec3 _e215 = u_look.rim.direction;
    vec3 _e224 = u_look.rim.direction;
    Angle rim_angle = Angle((0.5 * length((surface_1.normal - _e215))), (0.5 * length((surface_1.normal + _e224))));
    float rim_warp = (((2.0 * highlight_convexity) - 1.0) * 0.2);
    float _e237 = profile(rim_angle, rim_warp, rim_tone_shape);
    Light _e240 = u_look.rim;
    LitLayer _e241 = light_apply_2_(_e240, _e210, _e237);
    vec4 rim_blend = clamp(vec4((light_blend.xyz + (_e241.tone * (_e241.color.xyz - light_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e267 = curvature_color(highlight_convexity, vec4(1.0, 0.9804, 0.9412, 1.0), vec4(1.0, 0.8863, 0.7216, 1.0));
    Light _e270 = u_look.key;
    Angle _e273 = parametrization_specular(_e270, surface_1.normal, surface_1.view);
    float highlight_warp = (((2.0 * highlight_convexity) - 1.0) * 0.1);
    float _e281 = profile_2_(_e273, highlight_warp, highlight_tone_shape);
    Light _e284 = u_look.key;
    LitLayer _e285 = light_apply_2_(_e284, _e267, _e281);
    vec4 output_ = clamp(vec4((rim_blend.xyz + (_e285.tone * (_e285.color.xyz - rim_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
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

