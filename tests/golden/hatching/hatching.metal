// Hatching: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_6 buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0).
// hatching.json says what to put there and how to draw.
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
    Light key;
    metal::float2 viewport;
    char _pad2[8];
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
    metal::packed_float3 curvature_tensor;
    float magnification;
    metal::float3x3 world_from_normal;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct StretchedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct SpacedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct Strokes {
    float width;
    float length;
    float taper;
    float wobble;
    float pressure;
    float variation;
    uint seed;
};
struct Stroke {
    float turn;
    float profile;
};
struct MarkPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

float finite_or(
    float x_1,
    float otherwise
) {
    bool _e2 = is_finite(x_1);
    return _e2 ? x_1 : otherwise;
}

metal::float3 finite_vec3_(
    metal::float3 v
) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return metal::float3(_e3, _e6, _e9);
}

metal::float4 finite_vec4_(
    metal::float4 v_1
) {
    metal::float3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return metal::float4(_e2, _e5);
}

metal::float3 normalize_or(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    bool local = {};
    float largest = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest > 0.000000000000000000000000000001) {
        local = largest < 1000000000000000000000000000000.0;
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    metal::float3 scaled = v_2 * (1.0 / largest);
    float square_1 = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square_1));
}

float power_of_two(
    int n
) {
    return as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(n) + as_type<uint>(127))) << 23u);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

float exp2_stable(
    float x_2
) {
    float clamped_3 = metal::clamp(x_2, -150.0, 127.99999);
    float whole_1 = metal::rint(clamped_3);
    float f = (clamped_3 - whole_1) * LN_2_;
    float p_1 = 1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127)))))))))))));
    int half_whole = naga_div(naga_f2i32(whole_1), 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) - as_type<uint>(half_whole)));
    return (p_1 * _e33) * _e37;
}

float log_stable(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    int shift = static_cast<int>((bits - 1060439283u) >> 23u);
    int exponent_1 = (shift >= 256) ? as_type<int>(as_type<uint>(shift) - as_type<uint>(512)) : shift;
    float mantissa = as_type<float>(bits - (static_cast<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    float series = (2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111))))))));
    return (static_cast<float>(exponent_1) * LN_2_) + series;
}

metal::float2 sin_cos_quarter(
    float x_4
) {
    float h = 0.5 * x_4;
    float h2_ = h * h;
    float s = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s) * c, 1.0 - ((2.0 * s) * s));
}

metal::float2 sin_cos(
    float x_5
) {
    float turns = metal::rint(x_5 * 0.31830987);
    float r = ((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 0.00000062783295);
    float sign = 1.0 - (2.0 * metal::abs(turns - (2.0 * metal::trunc(turns * 0.5))));
    metal::float2 _e27 = sin_cos_quarter(metal::clamp(r, -1.5707964, HALF_PI));
    return sign * _e27;
}

float bounded(
    float x_6
) {
    uint bits_1 = as_type<uint>(x_6);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float2 bounded_vec2_(
    metal::float2 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return metal::float2(_e2, _e4);
}

metal::float3 bounded_vec3_(
    metal::float3 v_4
) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float4 bounded_vec4_(
    metal::float4 v_5
) {
    float _e2 = bounded(v_5.x);
    float _e4 = bounded(v_5.y);
    float _e6 = bounded(v_5.z);
    float _e8 = bounded(v_5.w);
    return metal::float4(_e2, _e4, _e6, _e8);
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

float powered(
    float base,
    float exponent
) {
    bool local_1 = {};
    float _e2 = bounded(base);
    float _e3 = bounded(exponent);
    if (_e3 == 1.0) {
        return _e2;
    }
    if (_e3 == 0.0) {
        return 1.0;
    }
    if (_e3 == 2.0) {
        float _e12 = bounded(_e2 * _e2);
        return _e12;
    }
    float magnitude_1 = metal::abs(_e2);
    if (magnitude_1 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e18 = log_stable(magnitude_1);
    float _e21 = bounded(_e3 * (LOG2_E * _e18));
    float _e22 = exp2_stable(_e21);
    bool is_even = metal::floor(_e3 * 0.5) == (_e3 * 0.5);
    if (_e2 < 0.0) {
        local_1 = !(is_even);
    } else {
        local_1 = false;
    }
    bool _e36 = local_1;
    return _e36 ? -(_e22) : _e22;
}

float mixed(
    float a_1,
    float b_1,
    float t
) {
    float _e4 = bounded(b_1 - a_1);
    float _e14 = bounded((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4)));
    return _e14;
}

metal::float3 mixed_vec3_(
    metal::float3 a_2,
    metal::float3 b_2,
    float t_1
) {
    float _e5 = mixed(a_2.x, b_2.x, t_1);
    float _e8 = mixed(a_2.y, b_2.y, t_1);
    float _e11 = mixed(a_2.z, b_2.z, t_1);
    return metal::float3(_e5, _e8, _e11);
}

metal::float4 mixed_vec4_(
    metal::float4 a_3,
    metal::float4 b_3,
    float t_2
) {
    metal::float3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_2);
    float _e8 = mixed(a_3.w, b_3.w, t_2);
    return metal::float4(_e5, _e8);
}

float place_between(
    float x_7,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_7 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_7 - low) / _e12);
    return _e14;
}

float remapped(
    float x_8,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    float _e6 = bounded(x_8);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, clamped ? metal::clamp(_e9, 0.0, 1.0) : _e9);
    return _e16;
}

float eased(
    float x_9,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_9);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = metal::clamp(_e6, 0.0, 1.0);
    return (t_5 * t_5) * (3.0 - (2.0 * t_5));
}

float factor_of(
    float x_10,
    bool clamped_1
) {
    float _e2 = bounded(x_10);
    float _e3 = bounded(x_10);
    return clamped_1 ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

metal::float2 sin_cos_of(
    float x_11
) {
    float _e1 = bounded(x_11);
    metal::float2 _e2 = sin_cos(_e1);
    return metal::clamp(_e2, metal::float2(-1.0), metal::float2(1.0));
}

float footprint_of(
    float x_12
) {
    float _e1 = metal::dfdx(x_12);
    float _e2 = metal::dfdy(x_12);
    metal::float2 d = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
    return _e6;
}

float edge_width(
    float w,
    float softness
) {
    float _e4 = bounded(softness);
    return metal::length(metal::float2(metal::min(w, 1000000000000000.0), metal::clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(
    float x_13,
    float edge,
    float w_1
) {
    float _e4 = bounded(x_13 - edge);
    if (w_1 < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w_1);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

Color mix_colors_normal(
    Color a_4,
    Color b_4,
    float factor
) {
    metal::float4 _e3 = bounded_vec4_(a_4);
    metal::float4 _e4 = bounded_vec4_(b_4);
    float _e6 = factor_of(factor, true);
    metal::float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float kappa_safe(
    float kappa
) {
    bool is_nan = (as_type<uint>(kappa) & 2147483647u) > 2139095040u;
    return is_nan ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0);
}

metal::float3 tensor_safe(
    metal::float3 tensor
) {
    float _e2 = kappa_safe(tensor.x);
    float _e4 = kappa_safe(tensor.y);
    float _e6 = kappa_safe(tensor.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float2 principal_curvatures(
    metal::float3 tensor_1
) {
    float mean = 0.5 * (tensor_1.x + tensor_1.z);
    float spread = metal::length(metal::float2(0.5 * (tensor_1.x - tensor_1.z), tensor_1.y));
    float far = mean + ((mean >= 0.0) ? spread : -(spread));
    float _e26 = divided((tensor_1.x * tensor_1.z) - (tensor_1.y * tensor_1.y), far);
    return (mean >= 0.0) ? metal::float2(far, _e26) : metal::float2(_e26, far);
}

float facing(
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 _e4 = normalize_or(normal, metal::float3(0.0));
    return metal::clamp(metal::dot(_e4, view), 0.0, 1.0);
}

metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 _e6 = normalize_or(toward, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e11 = normalize_or(up, metal::float3(0.0, 1.0, 0.0));
    metal::float3 leaning = metal::cross(_e11, _e6);
    float square_2 = metal::dot(leaning, leaning);
    metal::float3 aside = (metal::abs(_e6.x) > 0.7) ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across_2 = (square_2 > 0.00000001) ? leaning : metal::cross(aside, _e6);
    metal::float3 _e38 = normalize_or(across_2 - (metal::dot(across_2, _e6) * _e6), metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(_e38, metal::cross(_e6, _e38), _e6);
}

float combine_tones_union(
    float a_5,
    float b_5
) {
    float _e3 = factor_of(a_5, true);
    float _e5 = factor_of(b_5, true);
    return metal::max(_e3, _e5);
}

Color output(
    Composite color_1
) {
    Color _e1 = straight(color_1);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_6 = {};
    v_6 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = _e8 + (_e10 * _e12);
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = _e16 + (_e18 * _e20);
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_6;
    metal::uint3 _e32 = v_6;
    v_6 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = _e38 + (_e40 * _e42);
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = _e46 + (_e48 * _e50);
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_6;
    return _e61;
}

metal::float3 unit_of_hash(
    metal::uint3 hash
) {
    return static_cast<metal::float3>(hash >> metal::uint3(8u)) * 0.000000059604645;
}

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

metal::float3 fade_quintic(
    metal::float3 t_3
) {
    return ((t_3 * t_3) * t_3) * ((t_3 * ((t_3 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(
    metal::float3 p,
    uint seed_2
) {
    float sum = 0.0;
    int i = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 _e4 = fade_quintic(p - corner);
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e45 = i;
            i = as_type<int>(as_type<uint>(_e45) + as_type<uint>(1));
        }
        loop_init = false;
        int _e10 = i;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            metal::int3 at_1 = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at_1 == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at_1)), seed_2);
            metal::float3 _e40 = unit_of_hash(_e39);
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e40.x);
        }
    }
    float _e47 = sum;
    return _e47;
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    float _e10 = bounded((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective));
    return _e10;
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 _e4 = sin_cos_of(angle);
    metal::float3 _e10 = bounded_vec3_((_e4.y * along) + (_e4.x * across));
    metal::float3 _e16 = bounded_vec3_((_e4.y * across) - (_e4.x * along));
    metal::float2 _e17 = bounded_vec2_(place);
    metal::float2 turned = metal::float2((_e4.y * _e17.x) + (_e4.x * _e17.y), (_e4.y * _e17.y) - (_e4.x * _e17.x));
    metal::float3 most = metal::float3(1000000000000000.0);
    metal::float3 stretch_2 = metal::clamp(metal::float3(metal::dot(_e10, _e10), metal::dot(_e10, _e16), metal::dot(_e16, _e16)), -(most), most);
    metal::float2 _e41 = bounded_vec2_(turned);
    return StretchedPlace {_e41, {}, stretch_2};
}

metal::float3 gradient_on_picture(
    metal::float3 g,
    metal::float3 normal_1,
    metal::float3 view_1
) {
    float facing_2 = metal::dot(normal_1, view_1);
    return g - (normal_1 * (metal::dot(g, view_1) / ((facing_2 >= 0.0) ? metal::max(facing_2, 0.125) : metal::min(facing_2, -0.125))));
}

StretchedPlace place_on_surface(
    metal::float2 place_1,
    metal::float3 along_1,
    metal::float3 across_1,
    metal::float3 normal_2,
    metal::float3 view_2,
    float magnification,
    float angle_1
) {
    metal::float3 _e11 = normalize_or(normal_2, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e16 = normalize_or(view_2, metal::float3(0.0, 0.0, 1.0));
    float _e17 = bounded(magnification);
    float height = 1.0 / metal::clamp(_e17, 0.000000000000001, 1000000000000000.0);
    metal::float3 _e23 = gradient_on_picture(along_1, _e11, _e16);
    metal::float3 _e25 = bounded_vec3_(_e23 * height);
    metal::float3 _e26 = gradient_on_picture(across_1, _e11, _e16);
    metal::float3 _e28 = bounded_vec3_(_e26 * height);
    metal::float2 _e29 = bounded_vec2_(place_1);
    StretchedPlace _e30 = mark_place_of(_e29, _e25, _e28, angle_1);
    return _e30;
}

StretchedPlace place_across(
    metal::float3 axis,
    metal::float3 position,
    metal::float3x3 world_from_normal,
    metal::float3 normal_3,
    metal::float3 view_3,
    float magnification_1,
    float angle_2
) {
    metal::float3x3 _e11 = axes_around(axis, metal::float3(0.0, 1.0, 0.0));
    metal::float3 _e12 = bounded_vec3_(position);
    metal::float2 place_6 = metal::float2(metal::dot(_e12, _e11[0]), metal::dot(_e12, _e11[2]));
    metal::float3 _e20 = bounded_vec3_(world_from_normal * _e11[0]);
    metal::float3 _e23 = bounded_vec3_(world_from_normal * _e11[2]);
    StretchedPlace _e24 = place_on_surface(place_6, _e20, _e23, normal_3, view_3, magnification_1, angle_2);
    return _e24;
}

SpacedPlace spaced(
    metal::float2 place_2,
    metal::float3 stretch,
    metal::float2 viewport,
    float count
) {
    float _e4 = bounded(count);
    float number = metal::clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_1 = is_pixel ? (number / metal::max(viewport.y, 1.0)) : number;
    metal::float2 _e19 = bounded_vec2_(place_2);
    metal::float2 _e21 = bounded_vec2_(_e19 * scale_1);
    metal::float2 p_2 = metal::clamp(_e21, metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float3 _e27 = bounded_vec3_(stretch);
    metal::float3 s_1 = metal::clamp(_e27, metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
    return SpacedPlace {p_2, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : s_1};
}

float octave_of(
    float square
) {
    float _e5 = log_stable(metal::clamp(square, 0.000000000000000000000000000001, 1000000000000000000000000000000.0));
    return metal::clamp(-0.7213475 * _e5, -16.0, 16.0);
}

Stroke stroke_at(
    metal::int2 line,
    float x_14,
    int zoom,
    Strokes style
) {
    metal::uint3 _e7 = lattice_hash(metal::int3(line, 1048576), style.seed);
    metal::float3 _e8 = unit_of_hash(_e7);
    if (style.length <= 0.0) {
        return Stroke {_e8.y, 1.0};
    }
    float _e15 = power_of_two(zoom);
    float along_2 = metal::clamp((x_14 * _e15) / style.length, -1000000.0, 1000000.0) + _e8.x;
    float index = metal::floor(along_2);
    metal::uint3 _e30 = lattice_hash(metal::int3(line, naga_f2i32(index)), style.seed + as_type<uint>(zoom));
    metal::float3 _e31 = unit_of_hash(_e30);
    float from_end = metal::min(along_2 - index, 1.0 - (along_2 - index));
    float slope = metal::clamp(from_end / metal::max(0.5 * style.taper, 0.000001), 0.0, 1.0);
    return Stroke {_e31.x, slope * (2.0 - slope)};
}

Stroke stroke_between(
    metal::int2 line_1,
    float x_15,
    float level,
    Strokes style_1
) {
    float zoom_2 = metal::floor(level);
    Stroke _e6 = stroke_at(line_1, x_15, naga_f2i32(zoom_2), style_1);
    Stroke _e10 = stroke_at(line_1, x_15, as_type<int>(as_type<uint>(naga_f2i32(zoom_2)) + as_type<uint>(1)), style_1);
    float f_1 = level - zoom_2;
    return Stroke {metal::mix(_e6.turn, _e10.turn, f_1), metal::mix(_e6.profile, _e10.profile, f_1)};
}

int naga_neg(int val) {
    return as_type<int>(-as_type<uint>(val));
}

float stray_at(
    metal::float2 place_3,
    int zoom_1,
    uint seed_3
) {
    float _e3 = power_of_two(zoom_1);
    metal::float2 p_3 = place_3 * _e3;
    float _e13 = value_noise(metal::float3(0.11 * p_3.x, 0.45 * p_3.y, 0.5), seed_3);
    float _e19 = power_of_two(naga_neg(zoom_1));
    return ((_e13 - 0.5) * 2.0) * _e19;
}

float band_filtered(
    float t_4,
    float half_,
    float w_2
) {
    bool local_2 = {};
    if (w_2 < 0.000000000000000000000000000001) {
        if (metal::abs(t_4) <= half_) {
            local_2 = half_ > 0.0;
        } else {
            local_2 = false;
        }
        bool _e12 = local_2;
        return _e12 ? 1.0 : 0.0;
    }
    return metal::clamp((metal::clamp(t_4 + (0.5 * w_2), -(half_), half_) - metal::clamp(t_4 - (0.5 * w_2), -(half_), half_)) / w_2, 0.0, 1.0);
}

metal::int2 line_of(
    int whole,
    int octave
) {
    int power = (whole == 0) ? 1 : (whole & naga_neg(whole));
    int octaves = as_type<int>(as_type<uint>(static_cast<int>(as_type<uint>(static_cast<float>(power)) >> 23u)) - as_type<uint>(127));
    return (whole == 0) ? metal::int2(0) : metal::int2(naga_div(whole, power), as_type<int>(as_type<uint>(octave) - as_type<uint>(octaves)));
}

float hatched(
    metal::float2 place_4,
    float w_3,
    float level_1,
    float ink,
    Strokes style_2
) {
    if (!((ink > 0.0))) {
        return 0.0;
    }
    float _e12 = powered(ink, 1.0 - style_2.pressure);
    float _e15 = powered(ink, style_2.pressure);
    float width_1 = style_2.width * _e15;
    float zoom_3 = metal::floor(level_1);
    float _e20 = stray_at(place_4, naga_f2i32(zoom_3), style_2.seed);
    float _e25 = stray_at(place_4, as_type<int>(as_type<uint>(naga_f2i32(zoom_3)) + as_type<uint>(1)), style_2.seed);
    float stray = metal::mix(_e20, _e25, level_1 - zoom_3);
    float across_3 = place_4.y + (style_2.wobble * stray);
    float _e35 = log_stable(metal::max(_e12, 0.000000001));
    float density = metal::clamp(level_1 + (LOG2_E * _e35), -40.0, 17.0);
    float octave_1 = metal::floor(density);
    float _e43 = exp2_stable(density - octave_1);
    float growth = _e43 - 1.0;
    float _e47 = power_of_two(naga_f2i32(octave_1));
    float q = metal::clamp(across_3 * _e47, -4194304.0, 4194304.0);
    float _e55 = exp2_stable(octave_1 - level_1);
    float half_1 = (0.5 * width_1) * _e55;
    float footprint = w_3 * _e47;
    int whole_2 = naga_f2i32(metal::rint(q));
    metal::int2 _e61 = line_of(whole_2, naga_f2i32(octave_1));
    Stroke _e63 = stroke_between(_e61, place_4.x, level_1, style_2);
    float middle = metal::floor(q);
    Stroke _e75 = stroke_between(metal::int2(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(naga_f2i32(middle)))) + as_type<uint>(1)), as_type<int>(as_type<uint>(naga_f2i32(octave_1)) + as_type<uint>(1))), place_4.x, level_1, style_2);
    float late = 0.75 * style_2.variation;
    float grown = metal::clamp((growth - (late * _e75.turn)) / (1.0 - late), 0.0, 1.0);
    float _e92 = band_filtered(q - static_cast<float>(whole_2), half_1 * _e63.profile, footprint);
    float _e99 = band_filtered((q - middle) - 0.5, (half_1 * grown) * _e75.profile, footprint);
    float mean_1 = metal::min((2.0 * half_1) * (1.0 + growth), 1.0);
    float _e110 = eased(footprint, 0.75, 1.5);
    return metal::mix(metal::max(_e92, _e99), mean_1, _e110);
}

float cross_hatched(
    SpacedPlace at,
    float ink_1,
    int layers,
    float cross,
    Strokes style_3
) {
    float free = 1.0;
    int i_1 = 0;
    Strokes own = {};
    metal::float2 x_17 = metal::dfdx(at.place);
    metal::float2 y = metal::dfdy(at.place);
    int count_2 = metal::clamp(layers, 1, 4);
    float _e12 = bounded(ink_1);
    float amount = metal::clamp(_e12, 0.0, 1.0) * static_cast<float>(count_2);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e90 = i_1;
            i_1 = as_type<int>(as_type<uint>(_e90) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e22 = i_1;
        if (_e22 < 4) {
        } else {
            break;
        }
        {
            int _e25 = i_1;
            if (_e25 < count_2) {
                int _e27 = i_1;
                metal::float2 _e30 = sin_cos_of(static_cast<float>(_e27) * cross);
                metal::float2 along_3 = metal::float2(_e30.y, _e30.x);
                metal::float2 across_4 = metal::float2(-(_e30.x), _e30.y);
                float _e42 = bounded(metal::length(metal::float2(metal::dot(across_4, x_17), metal::dot(across_4, y))));
                metal::float3 s_2 = at.stretch;
                float square_3 = metal::dot(metal::float3(across_4.x * across_4.x, (2.0 * across_4.x) * across_4.y, across_4.y * across_4.y), s_2);
                float _e63 = octave_of(metal::max(square_3, (at.stretch.x + at.stretch.z) / 65.0));
                metal::float2 place_7 = metal::float2(metal::dot(along_3, at.place), metal::dot(across_4, at.place));
                own = style_3;
                int _e73 = i_1;
                own.seed = style_3.seed + (101u * static_cast<uint>(_e73));
                float _e77 = free;
                int _e78 = i_1;
                Strokes _e84 = own;
                float _e85 = hatched(place_7, _e42, _e63, metal::clamp(amount - static_cast<float>(_e78), 0.0, 1.0), _e84);
                free = _e77 * (1.0 - _e85);
            }
        }
    }
    float _e92 = free;
    return 1.0 - _e92;
}

float hatching(
    float value,
    metal::float2 place_5,
    metal::float3 stretch_1,
    float count_1,
    float width,
    int layers_1,
    float cross_1,
    float length,
    float taper,
    float wobble,
    float pressure,
    float variation,
    int seed_4,
    metal::float2 viewport_1
) {
    float _e14 = bounded(width);
    float _e18 = bounded(length);
    float _e22 = bounded(taper);
    float _e26 = bounded(wobble);
    float _e30 = bounded(pressure);
    float _e34 = bounded(variation);
    Strokes style_4 = Strokes {metal::clamp(_e14, 0.0, 1.0), metal::clamp(_e18, 0.0, 10000.0), metal::clamp(_e22, 0.0, 1.0), metal::clamp(_e26, 0.0, 100.0), metal::clamp(_e30, 0.0, 1.0), metal::clamp(_e34, 0.0, 1.0), as_type<uint>(seed_4)};
    SpacedPlace _e40 = spaced(place_5, stretch_1, viewport_1, count_1);
    float _e42 = factor_of(value, true);
    float _e45 = cross_hatched(_e40, 1.0 - _e42, layers_1, cross_1, style_4);
    return _e45;
}

MarkPlace mark_place_light(
    Light light,
    metal::float3 normal_4,
    float angle_3,
    metal::float3 view_4,
    metal::float3 position_object,
    metal::float3x3 world_from_normal_1,
    float magnification_2
) {
    metal::float3 toward_1 = light.direction * world_from_normal_1;
    StretchedPlace _e9 = place_across(toward_1, position_object, world_from_normal_1, normal_4, view_4, magnification_2, angle_3);
    return MarkPlace {_e9.place, {}, _e9.stretch};
}

float reflectance_wrap(
    Light light_1,
    metal::float3 normal_5,
    float wrap
) {
    float _e3 = bounded(wrap);
    float w_4 = metal::clamp(_e3, 0.0, 1.0);
    metal::float3 _e11 = normalize_or(normal_5, metal::float3(0.0, 0.0, 1.0));
    float cosine = metal::dot(_e11, light_1.direction);
    return metal::max((cosine + w_4) / (1.0 + w_4), 0.0);
}

float map_range(
    float value_1,
    float from_low_1,
    float from_high_1,
    float to_low_1,
    float to_high_1,
    bool clamped_2
) {
    float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float smooth_step_value(
    float value_2,
    float low_2,
    float high_2
) {
    float _e3 = eased(value_2, low_2, high_2);
    return _e3;
}

float seen_well(
    float facing_1
) {
    float _e3 = eased(facing_1, 0.05, 0.3);
    return _e3;
}

float faded_in(
    float x_16,
    float limit,
    float softness_1
) {
    float _e3 = bounded(limit);
    float at_2 = metal::max(_e3, 0.0);
    float _e6 = footprint_of(x_16);
    float _e10 = factor_of(softness_1, true);
    float _e12 = edge_width(_e6, metal::min(at_2, 1000000000.0) * _e10);
    float _e13 = bounded(x_16);
    float _e14 = step_filtered(_e13, at_2, _e12);
    return _e14;
}

float inner_contour_valleys(
    float limit_1,
    float softness_2,
    metal::float3 tensor_2,
    metal::float3 normal_6,
    metal::float3 view_5
) {
    metal::float3 _e5 = tensor_safe(tensor_2);
    metal::float2 _e6 = principal_curvatures(_e5);
    float least = _e6.y;
    float _e9 = faded_in(-(least), limit_1, softness_2);
    float _e11 = seen_well(metal::dot(normal_6, view_5));
    return _e9 * _e11;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.35);
    float _e12 = map_range(_e6, 0.0, 0.85, 0.04, 1.0, true);
    Light _e15 = look.key;
    MarkPlace _e22 = mark_place_light(_e15, surface_1.normal, 0.0, surface_1.view, surface_1.position_object, surface_1.world_from_normal, surface_1.magnification);
    metal::float2 _e37 = look.viewport;
    float _e38 = hatching(_e12, _e22.place, _e22.stretch, 120.0, 0.42, 3, 0.8, 24.0, 0.6, 0.45, 0.25, 1.0, 4, _e37);
    float _e41 = facing(surface_1.normal, surface_1.view);
    float _e44 = smooth_step_value(_e41, 0.34, 0.2);
    float _e45 = combine_tones_union(_e38, _e44);
    float _e51 = inner_contour_valleys(75.0, 0.3, surface_1.curvature_tensor, surface_1.normal, surface_1.view);
    float _e52 = combine_tones_union(_e45, _e51);
    Color _e63 = mix_colors_normal(metal::float4(0.965, 0.937, 0.875, 1.0), metal::float4(0.12, 0.105, 0.16, 1.0), _e52);
    Composite _e64 = premultiplied(_e63);
    Color _e65 = output(_e64);
    return _e65;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_7 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_6 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_7 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_6.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    out.position_object = vertex_.position;
    metal::float3x3 _e21 = object.world_from_normal;
    out.normal = _e21 * vertex_.normal;
    Varyings _e24 = out;
    const auto _tmp = _e24;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object_1 [[user(loc1), center_perspective]];
    metal::float3 normal_7 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_6 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object_1, varyings_1.normal_7 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_7 = is_front ? _e7 : -(_e7);
    surface.normal = normal_7;
    metal::float4 _e15 = view_6.eye;
    float _e20 = view_6.eye.w;
    metal::float4 _e26 = view_6.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    surface.position_object = in.position_object;
    metal::float4 _e42 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.curvature_tensor = _e42.xyz;
    metal::float4x4 _e47 = view_6.camera_from_world;
    float _e57 = view_6.eye.w;
    float _e62 = view_6.clip_from_world[0].y;
    float _e67 = view_6.clip_from_world[1].y;
    float _e72 = view_6.clip_from_world[2].y;
    float _e75 = size_on_screen(-((_e47 * metal::float4(in.position, 1.0)).z), _e57, metal::length(metal::float3(_e62, _e67, _e72)));
    surface.magnification = _e75;
    metal::float3x3 _e79 = object.world_from_normal;
    surface.world_from_normal = _e79;
    Surface _e80 = surface;
    metal::float4 _e81 = shade(_e80, look);
    metal::float4 _e82 = finite_vec4_(_e81);
    return fs_mainOutput { _e82 };
}
