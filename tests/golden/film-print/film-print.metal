// Film print: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// film-print.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    metal::float4 eye;
};
struct Object {
    metal::float4x4 world_from_object;
    metal::float3x3 world_from_normal;
    float id;
    float cutoff;
    char _pad4[8];
};
struct Light {
    metal::float3 direction;
    metal::float3 own_direction;
    metal::packed_float3 color;
    float intensity;
};
struct Look {
    Light back;
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Angle {
    float half_sin;
    float half_cos;
};
struct type_5 {
    metal::float4 inner[16];
};
struct Curve {
    type_5 points;
    uint count;
    uint interpolation;
    char _pad3[8];
};
struct LitLayer {
    Color color;
    float tone;
    char _pad2[12];
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
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant ProfileShape tone_shape = ProfileShape {1.0, 0.0, 1.0248806, 0.99999666, 0.0, 1.5064107, 0.63535863, 0u};
constant Curve response_of_the_film = Curve {type_5 {{metal::float4(0.0, 0.0, 0.2, 0.0), metal::float4(0.3, 0.06, 0.36, 0.0), metal::float4(0.5, 0.42, 0.972973, 0.0), metal::float4(0.62, 0.5, 1.0256411, 0.0), metal::float4(0.8, 0.9, 0.81632656, 0.0), metal::float4(1.0, 1.0, 0.5, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 6u, 1u};
constant ProfileShape sheen_tone_shape = ProfileShape {0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u};
constant ProfileShape back_light_tone_shape = ProfileShape {0.9689124, 0.24740396, 4.0419726, 1.8505588, 0.5, 0.27256957, 0.11186968, 0u};
constant Curve film_print = Curve {type_5 {{metal::float4(0.0, 0.04, 0.64, 0.0), metal::float4(0.25, 0.2, 0.8608187, 0.0), metal::float4(0.6, 0.66, 0.97504276, 0.0), metal::float4(1.0, 0.97, 0.775, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 4u, 1u};
constant Curve film_print_2_ = Curve {type_5 {{metal::float4(0.0, 0.0, 0.73333335, 0.0), metal::float4(0.3, 0.22, 0.99215686, 0.0), metal::float4(0.6, 0.68, 1.0514286, 0.0), metal::float4(1.0, 1.0, 0.8, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 4u, 1u};
constant Curve film_print_3_ = Curve {type_5 {{metal::float4(0.0, 0.06, 0.8333333, 0.0), metal::float4(0.3, 0.31, 0.8805031, 0.0), metal::float4(0.6, 0.59, 0.91636366, 0.0), metal::float4(1.0, 0.95, 0.9, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 4u, 1u};
constant Curve film_print_4_ = Curve {type_5 {{metal::float4(0.0, 0.13, 0.8, 0.0), metal::float4(0.3, 0.37, 0.53333336, 0.0), metal::float4(0.6, 0.49, 0.51555556, 0.0), metal::float4(1.0, 0.78, 0.725, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 4u, 1u};

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float whole = metal::rint(x);
    float f = x - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    int exponent_1 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

metal::float2 sin_cos_tiny(
    float x_2
) {
    float y_1 = x_2 * x_2;
    float s_2 = x_2 * (1.0 + (y_1 * (-0.16666667 + (y_1 * 0.008333334))));
    float c = 1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * 0.0013888889)))));
    return metal::float2(s_2, c);
}

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen(
    metal::float3 v_1
) {
    metal::float3 _e5 = normalize_moderate(v_1, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_5 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_5, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_3 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, c_1);
    metal::float2 turned = ((s_3 <= 0.0) & (s_3 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_4 = u_2.half_sin - (u_2.half_cos * 0.0);
    float c_2 = u_2.half_cos + (u_2.half_sin * 0.0);
    metal::float2 upper_1 = (c_2 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_4, c_2);
    metal::float2 turned_1 = ((s_4 <= 0.0) & (s_4 < c_2)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

Angle angle_turned_3_(
    Angle u_3,
    metal::float2 t_2
) {
    float s_5 = u_3.half_sin - 0.0;
    metal::float2 upper_2 = (u_3.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_5, u_3.half_cos);
    metal::float2 turned_2 = ((s_5 <= 0.0) & (s_5 < u_3.half_cos)) ? metal::float2(0.0, 1.0) : upper_2;
    return Angle {turned_2.x, turned_2.y};
}

float bounded(
    float x_3
) {
    uint bits_1 = as_type<uint>(x_3);
    uint magnitude = bits_1 & 2147483647u;
    float largest = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest : 0.0);
}

float divided(
    float a,
    float b
) {
    if (metal::abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e7 = bounded(a / b);
    return _e7;
}

float footprint_of(
    float x_4
) {
    float _e1 = metal::dfdx(x_4);
    float _e2 = metal::dfdy(x_4);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

metal::float4 hermite(
    metal::float4 a_1,
    metal::float4 b_1,
    metal::float4 from_a,
    metal::float4 to_b,
    float t_3
) {
    metal::float4 d_1 = b_1 - a_1;
    return a_1 + (t_3 * (from_a + (t_3 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_1)))))));
}

float curve_at(
    Curve curve,
    float x_5,
    float w
) {
    type_5 points = {};
    uint i_2_ = 1u;
    uint at = 0u;
    points = curve.points;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e21 = i_2_;
            i_2_ = _e21 + 1u;
        }
        loop_init = false;
        uint _e9 = i_2_;
        if (!((_e9 < 6u))) {
            break;
        }
        uint _e13 = at;
        uint _e14 = i_2_;
        uint _e15 = i_2_;
        float _e18 = points.inner[_e15].x;
        at = (_e18 <= x_5) ? _e14 : _e13;
    }
    uint _e24 = at;
    metal::float4 a_2 = points.inner[_e24];
    uint _e27 = at;
    if (((_e27 + 1u) >= 6u) | (x_5 <= a_2.x)) {
        return a_2.y;
    }
    uint _e36 = at;
    metal::float4 b_2 = points.inner[_e36 + 1u];
    float _e46 = divided(x_5 - a_2.x, b_2.x - a_2.x);
    float t_4 = metal::clamp(_e46, 0.0, 1.0);
    metal::float4 _e66 = hermite(metal::float4(a_2.y), metal::float4(b_2.y), (b_2.x - a_2.x) * metal::float4(a_2.z), (b_2.x - a_2.x) * metal::float4(b_2.z), t_4);
    return _e66.x;
}

float curve_at_2_(
    Curve curve_1,
    float x_6,
    float w_1
) {
    type_5 points_1 = {};
    uint i_2_1 = 1u;
    uint at_1 = 0u;
    points_1 = curve_1.points;
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e21 = i_2_1;
            i_2_1 = _e21 + 1u;
        }
        loop_init_1 = false;
        uint _e9 = i_2_1;
        if (!((_e9 < 4u))) {
            break;
        }
        uint _e13 = at_1;
        uint _e14 = i_2_1;
        uint _e15 = i_2_1;
        float _e18 = points_1.inner[_e15].x;
        at_1 = (_e18 <= x_6) ? _e14 : _e13;
    }
    uint _e24 = at_1;
    metal::float4 a_3 = points_1.inner[_e24];
    uint _e27 = at_1;
    if (((_e27 + 1u) >= 4u) | (x_6 <= a_3.x)) {
        return a_3.y;
    }
    uint _e36 = at_1;
    metal::float4 b_3 = points_1.inner[_e36 + 1u];
    float _e46 = divided(x_6 - a_3.x, b_3.x - a_3.x);
    float t_5 = metal::clamp(_e46, 0.0, 1.0);
    metal::float4 _e66 = hermite(metal::float4(a_3.y), metal::float4(b_3.y), (b_3.x - a_3.x) * metal::float4(a_3.z), (b_3.x - a_3.x) * metal::float4(b_3.z), t_5);
    return _e66.x;
}

Color color_curves(
    Color color,
    Curve all,
    Curve red,
    Curve green,
    Curve blue
) {
    float _e6 = footprint_of(color.x);
    float _e8 = footprint_of(color.y);
    float _e10 = footprint_of(color.z);
    metal::float3 w_6 = metal::float3(_e6, _e8, _e10);
    float _e14 = curve_at_2_(all, color.x, w_6.x);
    float _e17 = curve_at_2_(all, color.y, w_6.y);
    float _e20 = curve_at_2_(all, color.z, w_6.z);
    float _e22 = curve_at_2_(red, _e14, w_6.x);
    float _e24 = curve_at_2_(green, _e17, w_6.y);
    float _e26 = curve_at_2_(blue, _e20, w_6.z);
    return metal::float4(_e22, _e24, _e26, 1.0);
}

Composite blend_alpha(
    Composite below,
    Color color_1,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::float4(below.xyz + (tone * (color_1.xyz - below.xyz)), 1.0);
}

LitLayer light_apply(
    Light light,
    Color color_2,
    float tone_1
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_2.xyz * light.color) * split.y, 1.0), tone_1 * split.x};
}

Angle parametrization_specular_balanced(
    Light light_1,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d_2 = ((2.0 * metal::dot(normal, view)) * normal) - view;
    return Angle {0.5 * metal::length(d_2 - light_1.direction), 0.5 * metal::length(d_2 + light_1.direction)};
}

float profile_power(
    float q,
    float exponent
) {
    float log_base = 0.0;
    if (q >= 1.0) {
        return 0.0;
    }
    if (q < 0.5) {
        float _e11 = log1p_negative_small(q * q);
        log_base = LOG2_E * _e11;
    } else {
        float _e18 = log2_stable((1.0 - q) * (1.0 + q));
        log_base = _e18;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable(exponent * _e19);
    return metal::min(_e21, 1.0);
}

float profile_point(
    Angle u_4,
    ProfileShape shape
) {
    float s_6 = u_4.half_sin - (u_4.half_cos * 0.0);
    if ((s_6 <= 0.0) | false) {
        return 1.0;
    }
    float q_1 = s_6 * shape.scale;
    float _e15 = profile_power(q_1, shape.exponent);
    return _e15;
}

float profile_filtered(
    Angle u_5,
    float w_2,
    ProfileShape shape_1
) {
    float _e3 = profile_point(u_5, shape_1);
    bool is_wide = w_2 < (0.1 * shape_1.edge_deviation);
    if ((is_wide | (w_2 <= 0.0)) | false) {
        return _e3;
    }
    metal::float2 _e15 = sin_cos_tiny(0.19364917 * w_2);
    Angle _e16 = angle_turned(u_5, _e15);
    float _e17 = profile_point(_e16, shape_1);
    Angle _e22 = angle_turned(u_5, metal::float2(-(_e15.x), _e15.y));
    float _e23 = profile_point(_e22, shape_1);
    return (((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0;
}

float profile_soft_quick(
    float s,
    ProfileShape shape_2
) {
    float q_2 = s * shape_2.scale;
    return (s <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q_2 * q_2), 0.0), shape_2.exponent);
}

float profile_ramp_quick(
    float s_1,
    float w_3,
    ProfileShape shape_3
) {
    float width = metal::sqrt((w_3 * w_3) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_3.edge_mean - from_offset) / width), 0.0, 1.0);
    return (w_3 <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_filtered_quick(
    Angle u_6,
    float w_4,
    ProfileShape shape_4
) {
    metal::float2 place = metal::float2((u_6.half_sin * shape_4.half_cos_offset) - (u_6.half_cos * shape_4.half_sin_offset), (u_6.half_cos * shape_4.half_cos_offset) + (u_6.half_sin * shape_4.half_sin_offset));
    bool is_narrow = (w_4 > 0.0) & (w_4 >= (3.4641016 * shape_4.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place.x, w_4, shape_4);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_4);
    if (w_4 < (0.1 * shape_4.edge_deviation)) {
        return _e30;
    }
    float r = 0.19364917 * w_4;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e56 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_4);
    float _e64 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_4);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_5
) {
    Angle _e6 = angle_turned_2_(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_5);
    return _e8;
}

float profile_balanced(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_6
) {
    Angle _e6 = angle_turned_3_(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_6);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle turned_from_the_key = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    float _e22 = profile(turned_from_the_key, 0.0, tone_shape);
    float _e24 = footprint_of(_e22);
    float _e25 = curve_at(response_of_the_film, _e22, _e24);
    float body_tone = metal::clamp(_e25, 0.0, 1.0);
    Composite _e41 = blend_alpha(metal::float4(0.1216, 0.1137, 0.1333, 1.0), metal::float4(0.7765, 0.7137, 0.6392, 1.0), body_tone, 1.0, true);
    Light _e44 = look.key;
    Angle _e47 = parametrization_specular_balanced(_e44, surface.normal, surface.view);
    float _e50 = profile_balanced(_e47, 0.0, sheen_tone_shape);
    Light _e53 = look.key;
    LitLayer _e59 = light_apply(_e53, metal::float4(0.3725, 0.3451, 0.298, 1.0), _e50);
    metal::float4 sheen_blend = metal::clamp(metal::float4(_e41.xyz + (_e59.tone * _e59.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float3 _e77 = look.back.direction;
    metal::float3 _e86 = look.back.direction;
    Angle back_light_angle = Angle {0.5 * metal::length(surface.normal - _e77), 0.5 * metal::length(surface.normal + _e86)};
    float _e94 = profile_balanced(back_light_angle, 0.0, back_light_tone_shape);
    Light _e97 = look.back;
    LitLayer _e103 = light_apply(_e97, metal::float4(0.498, 0.5255, 0.549, 1.0), _e94);
    metal::float4 back_light_blend = metal::clamp(metal::float4(sheen_blend.xyz + (_e103.tone * _e103.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    Color _e121 = color_curves(back_light_blend, film_print, film_print_2_, film_print_3_, film_print_4_);
    return _e121;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_1 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_1 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position))};
    metal::float4 _e19 = shade(surface_1, look);
    return fs_mainOutput { _e19 };
}
