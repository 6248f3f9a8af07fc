// Diffuse parametrization: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// figure2-diffuse.json says what to put there and how to draw.
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
};
struct Surface {
    metal::float3 normal;
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
struct type_6 {
    metal::float4 inner[4];
};
struct Ramp {
    type_5 colors;
    type_6 places;
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
    metal::float3 normal;
};
constant float HALF_PI = 1.5707964;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint INTERPOLATION_SMOOTH = 1u;
constant uint INTERPOLATION_STEPPED = 2u;
constant Ramp color_code = Ramp {type_5 {{metal::float4(1.0, 0.9686, 0.8392, 1.0), metal::float4(1.0, 0.8196, 0.4, 1.0), metal::float4(0.9529, 0.4471, 0.1725, 1.0), metal::float4(0.7843, 0.1961, 0.3529, 1.0), metal::float4(0.4157, 0.1725, 0.549, 1.0), metal::float4(0.1529, 0.2039, 0.4353, 1.0), metal::float4(0.0431, 0.0627, 0.149, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_6 {{metal::float4(0.0, 0.1, 0.22, 0.36), metal::float4(0.52, 0.72, 1.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 7u, 1u};

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

Angle angle_between(
    metal::float3 d,
    metal::float3 l
) {
    float p = metal::length(d - l);
    float s = metal::length(d + l);
    float k = 1.0 / metal::sqrt(metal::max((p * p) + (s * s), 0.000000000000000000000000000001));
    return Angle {p * k, s * k};
}

float atan2_positive(
    float y,
    float x_2
) {
    float small = metal::min(y, x_2);
    float large = metal::max(y, x_2);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_4 = small / large;
    bool is_wide = t_4 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_4;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_6 = is_wide ? (series + 0.7853982) : series;
    return (y > x_2) ? (HALF_PI - a_6) : a_6;
}

float angle_radians(
    Angle u
) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return 2.0 * _e3;
}

float bounded(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
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

float footprint_of(
    float x_4
) {
    float _e1 = metal::dfdx(x_4);
    float _e2 = metal::dfdy(x_4);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d_1, d_1)));
    return _e6;
}

float step_filtered(
    float x_5,
    float edge,
    float w
) {
    float _e4 = bounded(x_5 - edge);
    if (w < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

metal::float4 hermite(
    metal::float4 a_4,
    metal::float4 b_4,
    metal::float4 from_a,
    metal::float4 to_b,
    float t_3
) {
    metal::float4 d_2 = b_4 - a_4;
    return a_4 + (t_3 * (from_a + (t_3 * ((((3.0 * d_2) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_2)))))));
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
    float x_6,
    float w_1
) {
    type_5 colors = {};
    type_6 places = {};
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
                float _e43 = step_filtered(x_6, _e42, w_1);
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
            at = (_e67 <= x_6) ? _e58 : _e57;
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place = places.inner[naga_div(_e73, 4u)][naga_mod(_e77, 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_1 = x_6 <= place;
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
    float span = _e105 - place;
    float _e108 = divided(x_6 - place, span);
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
        metal::float4 _e159 = ramp_slope(_e145 - _e150, place - before_1, _e154 - _e157, span);
        from_a_1 = _e159;
    }
    if ((after_1 + 1u) < count) {
        float _e173 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e173 - (place + span);
        metal::float4 _e177 = colors.inner[after_1];
        uint _e178 = at;
        metal::float4 _e180 = colors.inner[_e178];
        metal::float4 _e185 = colors.inner[after_1 + 1u];
        metal::float4 _e187 = colors.inner[after_1];
        metal::float4 _e189 = ramp_slope(_e177 - _e180, span, _e185 - _e187, next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    metal::float4 _e192 = colors.inner[_e190];
    metal::float4 _e194 = colors.inner[after_1];
    metal::float4 _e195 = from_a_1;
    metal::float4 _e197 = to_b_1;
    metal::float4 _e199 = hermite(_e192, _e194, span * _e195, span * _e197, t_5);
    metal::float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

float unit_share(
    float share
) {
    return metal::clamp(share, 0.0, 1.0);
}

Color with_unit_alpha(
    Color color_1
) {
    float _e3 = unit_share(color_1.w);
    return metal::float4(color_1.xyz, _e3);
}

Composite premultiplied(
    Color color_2
) {
    return metal::float4(color_2.xyz * color_2.w, color_2.w);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

Color output(
    Composite color_3
) {
    Color _e1 = straight(color_3);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(
    Light light,
    metal::float3 normal
) {
    metal::float3 _e6 = normalize_or(normal, metal::float3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light.direction);
    return _e8;
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

float divide(
    float a_5,
    float b_5
) {
    float _e2 = divided(a_5, b_5);
    return _e2;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    float _e6 = angle_radians(_e5);
    float _e8 = divide(_e6, 3.1415927);
    Color _e10 = ramp_plain(_e8, color_code);
    Color _e11 = with_unit_alpha(_e10);
    Composite _e12 = premultiplied(_e11);
    Color _e13 = output(_e12);
    return _e13;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 normal [[user(loc0), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view.clip_from_world;
    out.clip = _e12 * world;
    metal::float3x3 _e17 = object.world_from_normal;
    out.normal = _e17 * vertex_.normal;
    Varyings _e20 = out;
    const auto _tmp = _e20;
    return vs_mainOutput { _tmp.clip, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 normal_1 [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.normal_1 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_1 = is_front ? _e7 : -(_e7);
    surface.normal = normal_1;
    Surface _e12 = surface;
    metal::float4 _e13 = shade(_e12, look);
    metal::float4 _e14 = finite_vec4_(_e13);
    return fs_mainOutput { _e14 };
}
