#version 300 es
// Curvature in the extent: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure4-extent.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light key;
    vec4 fill_blend;
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
const float LOG2_E = 1.442695;
const ProfileShape diffuse_tone_shape = ProfileShape(0.9921977, 0.12467473, 1.6002629, 1.3188459, 0.25, 0.79761744, 0.31569642, 0u);

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

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
    float y_1 = (x_3 * x_3);
    float s = (x_3 * (1.0 + (y_1 * (-0.16666667 + (y_1 * (0.008333334 + (y_1 * (-0.0001984127 + (y_1 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * (0.0013888889 + (y_1 * (-2.4801588e-5 + (y_1 * 2.755732e-7))))))))));
    return vec2(s, c);
}

vec2 sin_cos_tiny(float x_4) {
    float y_2 = (x_4 * x_4);
    float s_1 = (x_4 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334)))));
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

float curvature_signed(float kappa, float slope) {
    float a = ((((floatBitsToUint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope);
    float magnitude = min(abs(a), 50.0);
    if ((magnitude < 0.0625)) {
        float a2_ = (a * a);
        return (a * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e32 = exp2_stable((-2.88539 * magnitude));
    float t_1 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a >= 0.0) ? t_1 : -(t_1));
}

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
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
    bool is_wide = (w < (0.1 * shape_1.edge_deviation));
    if (((is_wide || (w <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w));
    Angle _e16 = angle_turned(u_3, _e15);
    float _e17 = profile_point(_e16, shape_1);
    Angle _e22 = angle_turned(u_3, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point(_e22, shape_1);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
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
    Angle diffuse_angle = Angle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    float _e22 = curvature_signed(surface_1.kappa, 0.3);
    float diffuse_convexity = (0.5 + (0.5 * _e22));
    float diffuse_warp = (((2.0 * diffuse_convexity) - 1.0) * 0.75);
    float _e34 = profile(diffuse_angle, diffuse_warp, diffuse_tone_shape);
    Light _e37 = u_look.key;
    LitLayer _e43 = light_apply(_e37, vec4(0.6275, 0.4157, 0.2902, 1.0), _e34);
    vec4 _e46 = u_look.fill_blend;
    vec4 output_ = clamp(vec4((_e46.xyz + (_e43.tone * _e43.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), 0.0);
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    surface.normal = normal;
    vec4 _e14 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e14.x;
    Surface _e16 = surface;
    vec4 _e17 = shade(_e16);
    out_color = _e17;
    return;
}

