// Contours: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_3 buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0), smooth_normal_4_map texture(1).
// contours.json says what to put there and how to draw.
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
    metal::float2 viewport;
    char _pad1[8];
    metal::float3x3 camera_from_world;
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_camera;
    metal::float3 curvature_tensor;
    metal::float3 smooth_normal_4_;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct type_7 {
    metal::float4 inner[16];
};
struct type_8 {
    metal::float4 inner[4];
};
struct Ramp {
    type_7 colors;
    type_8 places;
    uint count;
    uint interpolation;
    char _pad4[8];
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
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint INTERPOLATION_SMOOTH = 1u;
constant uint INTERPOLATION_STEPPED = 2u;
constant Ramp three_washes = Ramp {type_7 {{metal::float4(0.7255, 0.7686, 0.8118, 1.0), metal::float4(0.8627, 0.8627, 0.8235, 1.0), metal::float4(0.9725, 0.949, 0.8863, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_8 {{metal::float4(0.0, 0.16, 0.42, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 3u, 2u};

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
    float square = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

float bounded(
    float x_2
) {
    uint bits = as_type<uint>(x_2);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float4 bounded_vec4_(
    metal::float4 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    float _e6 = bounded(v_3.z);
    float _e8 = bounded(v_3.w);
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
    float x_3,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_3 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_3 - low) / _e12);
    return _e14;
}

float eased(
    float x_4,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_4);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_4 = metal::clamp(_e6, 0.0, 1.0);
    return (t_4 * t_4) * (3.0 - (2.0 * t_4));
}

float factor_of(
    float x_5,
    bool clamped
) {
    float _e2 = bounded(x_5);
    float _e3 = bounded(x_5);
    return clamped ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

float footprint_of(
    float x_6
) {
    float _e1 = metal::dfdx(x_6);
    float _e2 = metal::dfdy(x_6);
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
    float x_7,
    float edge,
    float w_1
) {
    float _e4 = bounded(x_7 - edge);
    if (w_1 < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w_1);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

metal::float4 hermite(
    metal::float4 a_4,
    metal::float4 b_4,
    metal::float4 from_a,
    metal::float4 to_b,
    float t_3
) {
    metal::float4 d_1 = b_4 - a_4;
    return a_4 + (t_3 * (from_a + (t_3 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_1)))))));
}

float harmonic_slope(
    float before,
    float span_before,
    float after,
    float span_after
) {
    if ((before * after) <= 0.0) {
        return 0.0;
    }
    float weight_before = (2.0 * span_after) + span_before;
    float weight_after = span_after + (2.0 * span_before);
    float _e18 = divided(weight_before + weight_after, (weight_before / before) + (weight_after / after));
    return _e18;
}

metal::float4 ramp_slope(
    metal::float4 rise_before,
    float span_before_1,
    metal::float4 rise_after,
    float span_after_1
) {
    float _e5 = divided(rise_before.x, span_before_1);
    float _e7 = divided(rise_after.x, span_after_1);
    float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    float _e10 = divided(rise_before.y, span_before_1);
    float _e12 = divided(rise_after.y, span_after_1);
    float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    float _e15 = divided(rise_before.z, span_before_1);
    float _e17 = divided(rise_after.z, span_after_1);
    float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    float _e20 = divided(rise_before.w, span_before_1);
    float _e22 = divided(rise_after.w, span_after_1);
    float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return metal::float4(_e8, _e13, _e18, _e23);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

Color ramp_at(
    Ramp ramp,
    float x_8,
    float w_2
) {
    type_7 colors = {};
    type_8 places = {};
    metal::float4 color = {};
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_1 = {};
    metal::float4 from_a_1 = metal::float4(0.0);
    metal::float4 to_b_1 = metal::float4(0.0);
    uint count = metal::min(ramp.count, 16u);
    if (count == 0u) {
        return metal::float4(0.0);
    }
    colors = ramp.colors;
    places = ramp.places;
    if (ramp.interpolation == INTERPOLATION_STEPPED) {
        metal::float4 _e18 = colors.inner[0];
        color = _e18;
        uint2 loop_bound = uint2(4294967295u);
        bool loop_init = true;
        while(true) {
            if (metal::all(loop_bound == uint2(0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                uint _e47 = i;
                i = _e47 + 1u;
            }
            loop_init = false;
            uint _e22 = i;
            if (_e22 < count) {
            } else {
                break;
            }
            {
                metal::float4 _e24 = color;
                uint _e25 = i;
                metal::float4 _e27 = colors.inner[_e25];
                uint _e28 = i;
                metal::float4 _e32 = colors.inner[_e28 - 1u];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places.inner[naga_div(_e34, 4u)][naga_mod(_e38, 4u)];
                float _e43 = step_filtered(x_8, _e42, w_2);
                color = _e24 + ((_e27 - _e32) * _e43);
            }
        }
        metal::float4 _e49 = color;
        metal::float4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e71 = i_1;
            i_1 = _e71 + 1u;
        }
        loop_init_1 = false;
        uint _e55 = i_1;
        if (_e55 < count) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places.inner[naga_div(_e59, 4u)][naga_mod(_e63, 4u)];
            at = (_e67 <= x_8) ? _e58 : _e57;
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_1 = places.inner[naga_div(_e73, 4u)][naga_mod(_e77, 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_1 = x_8 <= place_1;
    } else {
        local_1 = true;
    }
    bool _e91 = local_1;
    if (_e91) {
        uint _e92 = at;
        metal::float4 _e94 = colors.inner[_e92];
        metal::float4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = _e96 + 1u;
    float _e105 = places.inner[naga_div(after_1, 4u)][naga_mod(after_1, 4u)];
    float span_1 = _e105 - place_1;
    float _e108 = divided(x_8 - place_1, span_1);
    float t_5 = metal::clamp(_e108, 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        uint _e115 = at;
        metal::float4 _e117 = colors.inner[_e115];
        metal::float4 _e119 = colors.inner[after_1];
        metal::float4 _e120 = mixed_vec4_(_e117, _e119, t_5);
        return _e120;
    }
    uint _e127 = at;
    if (_e127 > 0u) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places.inner[naga_div(_e130 - 1u, 4u)][naga_mod(_e136 - 1u, 4u)];
        uint _e143 = at;
        metal::float4 _e145 = colors.inner[_e143];
        uint _e146 = at;
        metal::float4 _e150 = colors.inner[_e146 - 1u];
        metal::float4 _e154 = colors.inner[after_1];
        uint _e155 = at;
        metal::float4 _e157 = colors.inner[_e155];
        metal::float4 _e159 = ramp_slope(_e145 - _e150, place_1 - before_1, _e154 - _e157, span_1);
        from_a_1 = _e159;
    }
    if ((after_1 + 1u) < count) {
        float _e173 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e173 - (place_1 + span_1);
        metal::float4 _e177 = colors.inner[after_1];
        uint _e178 = at;
        metal::float4 _e180 = colors.inner[_e178];
        metal::float4 _e185 = colors.inner[after_1 + 1u];
        metal::float4 _e187 = colors.inner[after_1];
        metal::float4 _e189 = ramp_slope(_e177 - _e180, span_1, _e185 - _e187, next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    metal::float4 _e192 = colors.inner[_e190];
    metal::float4 _e194 = colors.inner[after_1];
    metal::float4 _e195 = from_a_1;
    metal::float4 _e197 = to_b_1;
    metal::float4 _e199 = hermite(_e192, _e194, span_1 * _e195, span_1 * _e197, t_5);
    metal::float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

Composite premultiplied(
    Color color_1
) {
    return metal::float4(color_1.xyz * color_1.w, color_1.w);
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
    Color a_5,
    Color b_5,
    float factor
) {
    metal::float4 _e3 = bounded_vec4_(a_5);
    metal::float4 _e4 = bounded_vec4_(b_5);
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

Color output(
    Composite color_2
) {
    Color _e1 = straight(color_2);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Color ramp_plain(
    float value,
    Ramp ramp_1
) {
    float _e2 = footprint_of(value);
    float _e3 = bounded(value);
    Color _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
}

float reflectance_half_lambert(
    Light light,
    metal::float3 normal
) {
    metal::float3 _e6 = normalize_or(normal, metal::float3(0.0, 0.0, 1.0));
    float half_ = 0.5 + (0.5 * metal::dot(_e6, light.direction));
    return metal::clamp(half_ * half_, 0.0, 1.0);
}

float maximum(
    float a_6,
    float b_6
) {
    float _e2 = bounded(a_6);
    float _e3 = bounded(b_6);
    return metal::max(_e2, _e3);
}

float line_covers(
    float distance,
    float width
) {
    return metal::clamp((width + 0.5) - distance, 0.0, metal::min(width, 1.0));
}

float seen_well(
    float facing
) {
    float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

float faded_in(
    float x_9,
    float limit,
    float softness_1
) {
    float _e3 = bounded(limit);
    float at_1 = metal::max(_e3, 0.0);
    float _e6 = footprint_of(x_9);
    float _e10 = factor_of(softness_1, true);
    float _e12 = edge_width(_e6, metal::min(at_1, 1000000000.0) * _e10);
    float _e13 = bounded(x_9);
    float _e14 = step_filtered(_e13, at_1, _e12);
    return _e14;
}

float inner_contour_suggestive(
    float width_1,
    float limit_1,
    float softness_2,
    metal::float3 tensor_2,
    metal::float3 normal_1,
    metal::float3 view,
    metal::float3x3 camera_from_world,
    metal::float3 place,
    metal::float2 viewport
) {
    metal::float3 n = camera_from_world * normal_1;
    metal::float3 _e10 = tensor_safe(tensor_2);
    float square_1 = metal::dot(n.xy, n.xy);
    float radial = ((((_e10.x * n.x) * n.x) + (((2.0 * _e10.y) * n.x) * n.y)) + ((_e10.z * n.y) * n.y)) / metal::max(square_1, 0.000001);
    float _e36 = metal::dfdx(radial);
    float _e37 = metal::dfdy(radial);
    metal::float2 change = metal::float2(_e36, _e37);
    metal::float3 v_4 = camera_from_world * view;
    metal::float3 row = metal::dfdy(place);
    float up = ((row - (metal::dot(row, v_4) * v_4)).y >= 0.0) ? 1.0 : -1.0;
    float height = metal::clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(((change.x * n.x) + ((up * change.y) * n.y))) * metal::rsqrt(metal::max(square_1, 0.000001));
    float _e67 = bounded(width_1);
    float pixels = ((0.5 * metal::clamp(_e67, 0.0, 10000.0)) * height) / 1000.0;
    float distance_1 = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float _e84 = faded_in((toward_eye * height) * 0.05, limit_1, softness_2);
    float _e85 = line_covers(distance_1, pixels);
    float _e88 = seen_well(metal::dot(normal_1, view));
    return (_e85 * _e84) * _e88;
}

float inner_contour_valleys(
    float limit_2,
    float softness_3,
    metal::float3 tensor_3,
    metal::float3 normal_2,
    metal::float3 view_1
) {
    metal::float3 _e5 = tensor_safe(tensor_3);
    metal::float2 _e6 = principal_curvatures(_e5);
    float least = _e6.y;
    float _e9 = faded_in(-(least), limit_2, softness_3);
    float _e11 = seen_well(metal::dot(normal_2, view_1));
    return _e9 * _e11;
}

float outer_contour(
    float width_2,
    metal::float3 normal_3,
    metal::float3 view_2,
    metal::float2 viewport_1
) {
    metal::float3 _e6 = normalize_or(normal_3, metal::float3(0.0));
    float facing_1 = metal::clamp(metal::dot(_e6, view_2), 0.0, 1.0);
    float _e11 = bounded(width_2);
    float pixels_1 = (metal::clamp(_e11, 0.0, 10000.0) * metal::clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0;
    float _e22 = footprint_of(facing_1);
    float distance_2 = facing_1 / metal::max(2.0 * _e22, 0.000001);
    float _e30 = eased(facing_1, 0.45, 0.75);
    float near = 1.0 - _e30;
    float _e33 = line_covers(distance_2, pixels_1);
    return _e33 * near;
}

metal::float3 smooth_normal_large(
    metal::float3 normal_4,
    metal::float3 smooth_4_
) {
    metal::float3 _e2 = normalize_or(smooth_4_, normal_4);
    return _e2;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    metal::float3 _e3 = smooth_normal_large(surface_1.normal, surface_1.smooth_normal_4_);
    Light _e6 = look.key;
    float _e7 = reflectance_half_lambert(_e6, _e3);
    Color _e9 = ramp_plain(_e7, three_washes);
    float _e15 = inner_contour_valleys(45.0, 1.0, surface_1.curvature_tensor, surface_1.normal, surface_1.view);
    Color _e21 = mix_colors_normal(_e9, metal::float4(0.6588, 0.5294, 0.4235, 1.0), _e15);
    metal::float3x3 _e30 = look.camera_from_world;
    metal::float2 _e34 = look.viewport;
    float _e35 = inner_contour_suggestive(3.0, 22.0, 1.0, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e30, surface_1.position_camera, _e34);
    metal::float2 _e41 = look.viewport;
    float _e42 = outer_contour(5.0, surface_1.normal, surface_1.view, _e41);
    float _e43 = maximum(_e35, _e42);
    Color _e49 = mix_colors_normal(_e21, metal::float4(0.1647, 0.1412, 0.1882, 1.0), _e43);
    Composite _e50 = premultiplied(_e49);
    Color _e51 = output(_e50);
    return _e51;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_5 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_3 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_5 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_3.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    Varyings _e22 = out;
    const auto _tmp = _e22;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_5 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_3 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_4_map [[texture(1)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_5 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_5 = is_front ? _e7 : -(_e7);
    surface.normal = normal_5;
    metal::float4 _e15 = view_3.eye;
    float _e20 = view_3.eye.w;
    metal::float4 _e26 = view_3.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    metal::float4x4 _e37 = view_3.camera_from_world;
    surface.position_camera = (_e37 * metal::float4(in.position, 1.0)).xyz;
    metal::float4 _e49 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.curvature_tensor = _e49.xyz;
    metal::float4 _e57 = smooth_normal_4_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e63 = view_3.camera_from_world;
    surface.smooth_normal_4_ = (metal::float4(_e57.xyz, 0.0) * _e63).xyz;
    Surface _e66 = surface;
    metal::float4 _e67 = shade(_e66, look);
    metal::float4 _e68 = finite_vec4_(_e67);
    return fs_mainOutput { _e68 };
}
