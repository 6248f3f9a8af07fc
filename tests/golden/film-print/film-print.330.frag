#version 330 core
// Film print: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// film-print.json says what to put there and how to draw.
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
    Light back;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct Curve {
    vec4 points[16];
    uint count;
    uint interpolation;
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
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const ProfileShape tone_shape = ProfileShape(1.0, 0.0, 1.0248806, 0.99999666, 0.0, 1.5064107, 0.63535863, 0u);
const Curve response_of_the_film = Curve(vec4[16](vec4(0.0, 0.0, 0.2, 0.0), vec4(0.3, 0.06, 0.36, 0.0), vec4(0.5, 0.42, 0.972973, 0.0), vec4(0.62, 0.5, 1.0256411, 0.0), vec4(0.8, 0.9, 0.81632656, 0.0), vec4(1.0, 1.0, 0.5, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 6u, 1u);
const ProfileShape sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u);
const ProfileShape back_light_tone_shape = ProfileShape(0.9689124, 0.24740396, 4.0419726, 1.8505588, 0.5, 0.27256957, 0.11186968, 0u);
const Curve film_print = Curve(vec4[16](vec4(0.0, 0.04, 0.64, 0.0), vec4(0.25, 0.2, 0.8608187, 0.0), vec4(0.6, 0.66, 0.97504276, 0.0), vec4(1.0, 0.97, 0.775, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);
const Curve film_print_2_ = Curve(vec4[16](vec4(0.0, 0.0, 0.73333335, 0.0), vec4(0.3, 0.22, 0.99215686, 0.0), vec4(0.6, 0.68, 1.0514286, 0.0), vec4(1.0, 1.0, 0.8, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);
const Curve film_print_3_ = Curve(vec4[16](vec4(0.0, 0.06, 0.8333333, 0.0), vec4(0.3, 0.31, 0.8805031, 0.0), vec4(0.6, 0.59, 0.91636366, 0.0), vec4(1.0, 0.95, 0.9, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);
const Curve film_print_4_ = Curve(vec4[16](vec4(0.0, 0.13, 0.8, 0.0), vec4(0.3, 0.37, 0.53333336, 0.0), vec4(0.6, 0.49, 0.51555556, 0.0), vec4(1.0, 0.78, 0.725, 0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float whole = roundEven(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float log2_stable(float x_1) {
    uint bits = floatBitsToUint(x_1);
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

vec2 sin_cos_tiny(float x_2) {
    float y_1 = (x_2 * x_2);
    float s_2 = (x_2 * (1.0 + (y_1 * (-0.16666667 + (y_1 * 0.008333334)))));
    float c = (1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * 0.0013888889))))));
    return vec2(s_2, c);
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
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_1));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_4 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_2 = (u_2.half_cos + (u_2.half_sin * 0.0));
    vec2 upper_1 = ((c_2 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_4, c_2));
    vec2 turned_1 = (((s_4 <= 0.0) && (s_4 < c_2)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

Angle angle_turned_3_(Angle u_3, vec2 t_2) {
    float s_5 = (u_3.half_sin - 0.0);
    vec2 upper_2 = ((u_3.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_5, u_3.half_cos));
    vec2 turned_2 = (((s_5 <= 0.0) && (s_5 < u_3.half_cos)) ? vec2(0.0, 1.0) : upper_2);
    return Angle(turned_2.x, turned_2.y);
}

float bounded(float x_3) {
    uint bits_1 = floatBitsToUint(x_3);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_4) {
    float _e1 = dFdx(x_4);
    float _e2 = dFdy(x_4);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

vec4 hermite(vec4 a_1, vec4 b_1, vec4 from_a, vec4 to_b, float t_3) {
    vec4 d_1 = (b_1 - a_1);
    return (a_1 + (t_3 * (from_a + (t_3 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_1))))))));
}

float curve_at(Curve curve, float x_5, float w) {
    vec4 points[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint i_2_ = 1u;
    uint at = 0u;
    points = curve.points;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e21 = i_2_;
            i_2_ = (_e21 + 1u);
        }
        loop_init = false;
        uint _e9 = i_2_;
        if (!((_e9 < 6u))) {
            break;
        }
        uint _e13 = at;
        uint _e14 = i_2_;
        uint _e15 = i_2_;
        float _e18 = points[_e15].x;
        at = ((_e18 <= x_5) ? _e14 : _e13);
    }
    uint _e24 = at;
    vec4 a_2 = points[_e24];
    uint _e27 = at;
    if ((((_e27 + 1u) >= 6u) || (x_5 <= a_2.x))) {
        return a_2.y;
    }
    uint _e36 = at;
    vec4 b_2 = points[(_e36 + 1u)];
    float _e46 = divided((x_5 - a_2.x), (b_2.x - a_2.x));
    float t_4 = clamp(_e46, 0.0, 1.0);
    vec4 _e66 = hermite(vec4(a_2.y), vec4(b_2.y), ((b_2.x - a_2.x) * vec4(a_2.z)), ((b_2.x - a_2.x) * vec4(b_2.z)), t_4);
    return _e66.x;
}

float curve_at_2_(Curve curve_1, float x_6, float w_1) {
    vec4 points_1[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint i_2_1 = 1u;
    uint at_1 = 0u;
    points_1 = curve_1.points;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e21 = i_2_1;
            i_2_1 = (_e21 + 1u);
        }
        loop_init_1 = false;
        uint _e9 = i_2_1;
        if (!((_e9 < 4u))) {
            break;
        }
        uint _e13 = at_1;
        uint _e14 = i_2_1;
        uint _e15 = i_2_1;
        float _e18 = points_1[_e15].x;
        at_1 = ((_e18 <= x_6) ? _e14 : _e13);
    }
    uint _e24 = at_1;
    vec4 a_3 = points_1[_e24];
    uint _e27 = at_1;
    if ((((_e27 + 1u) >= 4u) || (x_6 <= a_3.x))) {
        return a_3.y;
    }
    uint _e36 = at_1;
    vec4 b_3 = points_1[(_e36 + 1u)];
    float _e46 = divided((x_6 - a_3.x), (b_3.x - a_3.x));
    float t_5 = clamp(_e46, 0.0, 1.0);
    vec4 _e66 = hermite(vec4(a_3.y), vec4(b_3.y), ((b_3.x - a_3.x) * vec4(a_3.z)), ((b_3.x - a_3.x) * vec4(b_3.z)), t_5);
    return _e66.x;
}

vec4 color_curves(vec4 color, Curve all_, Curve red, Curve green, Curve blue) {
    float _e6 = footprint_of(color.x);
    float _e8 = footprint_of(color.y);
    float _e10 = footprint_of(color.z);
    vec3 w_6 = vec3(_e6, _e8, _e10);
    float _e14 = curve_at_2_(all_, color.x, w_6.x);
    float _e17 = curve_at_2_(all_, color.y, w_6.y);
    float _e20 = curve_at_2_(all_, color.z, w_6.z);
    float _e22 = curve_at_2_(red, _e14, w_6.x);
    float _e24 = curve_at_2_(green, _e17, w_6.y);
    float _e26 = curve_at_2_(blue, _e20, w_6.z);
    return vec4(_e22, _e24, _e26, 1.0);
}

vec4 blend_alpha(vec4 below, vec4 color_1, float tone, float opacity, bool clamped) {
    return vec4((below.xyz + (tone * (color_1.xyz - below.xyz))), 1.0);
}

LitLayer light_apply(Light light, vec4 color_2, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_2.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal, vec3 view) {
    vec3 d_2 = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d_2 - light_1.direction))), (0.5 * length((d_2 + light_1.direction))));
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
    return min(_e21, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape) {
    float s_6 = (u_4.half_sin - (u_4.half_cos * 0.0));
    if (((s_6 <= 0.0) || false)) {
        return 1.0;
    }
    float q_1 = (s_6 * shape.scale);
    float _e15 = profile_power(q_1, shape.exponent);
    return _e15;
}

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1) {
    float _e3 = profile_point(u_5, shape_1);
    bool is_wide = (w_2 < (0.1 * shape_1.edge_deviation));
    if (((is_wide || (w_2 <= 0.0)) || false)) {
        return _e3;
    }
    vec2 _e15 = sin_cos_tiny((0.19364917 * w_2));
    Angle _e16 = angle_turned(u_5, _e15);
    float _e17 = profile_point(_e16, shape_1);
    Angle _e22 = angle_turned(u_5, vec2(-(_e15.x), _e15.y));
    float _e23 = profile_point(_e22, shape_1);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_soft_quick(float s, ProfileShape shape_2) {
    float q_2 = (s * shape_2.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q_2 * q_2)), 0.0), shape_2.exponent));
}

float profile_ramp_quick(float s_1, float w_3, ProfileShape shape_3) {
    float width = sqrt(((w_3 * w_3) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_3.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w_3 <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_6, float w_4, ProfileShape shape_4) {
    vec2 place = vec2(((u_6.half_sin * shape_4.half_cos_offset) - (u_6.half_cos * shape_4.half_sin_offset)), ((u_6.half_cos * shape_4.half_cos_offset) + (u_6.half_sin * shape_4.half_sin_offset)));
    bool is_narrow = ((w_4 > 0.0) && (w_4 >= (3.4641016 * shape_4.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_4, shape_4);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_4);
    if ((w_4 < (0.1 * shape_4.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_4);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_4);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_4);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_5) {
    Angle _e6 = angle_turned_2_(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_5);
    return _e8;
}

float profile_balanced(Angle angle_1, float shift_1, ProfileShape shape_6) {
    Angle _e6 = angle_turned_3_(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_6);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle turned_from_the_key = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e22 = profile(turned_from_the_key, 0.0, tone_shape);
    float _e24 = footprint_of(_e22);
    float _e25 = curve_at(response_of_the_film, _e22, _e24);
    float body_tone = clamp(_e25, 0.0, 1.0);
    vec4 _e41 = blend_alpha(vec4(0.1216, 0.1137, 0.1333, 1.0), vec4(0.7765, 0.7137, 0.6392, 1.0), body_tone, 1.0, true);
    Light _e44 = u_look.key;
    Angle _e47 = parametrization_specular_balanced(_e44, surface.normal, surface.view);
    float _e50 = profile_balanced(_e47, 0.0, sheen_tone_shape);
    Light _e53 = u_look.key;
    LitLayer _e59 = light_apply(_e53, vec4(0.3725, 0.3451, 0.298, 1.0), _e50);
    vec4 sheen_blend = clamp(vec4((_e41.xyz + (_e59.tone * _e59.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec3 _e77 = u_look.back.direction;
    vec3 _e86 = u_look.back.direction;
    Angle back_light_angle = Angle((0.5 * length((surface.normal - _e77))), (0.5 * length((surface.normal + _e86))));
    float _e94 = profile_balanced(back_light_angle, 0.0, back_light_tone_shape);
    Light _e97 = u_look.back;
    LitLayer _e103 = light_apply(_e97, vec4(0.498, 0.5255, 0.549, 1.0), _e94);
    vec4 back_light_blend = clamp(vec4((sheen_blend.xyz + (_e103.tone * _e103.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e121 = color_curves(back_light_blend, film_print, film_print_2_, film_print_3_, film_print_4_);
    return _e121;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))));
    vec4 _e19 = shade(surface_1);
    out_color = _e19;
    return;
}

