// Color code of angles: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1).
// figure2-code.json says what to put there and how to draw.
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
struct Surface {
    metal::float2 uv;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
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
struct VectorParts {
    float x;
    float y;
    float z;
};
struct Vertex {
    metal::float3 position;
    metal::float2 uv;
    char _pad2[8];
};
struct Varyings {
    metal::float4 clip;
    metal::float2 uv;
    char _pad2[8];
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant Ramp color_code = Ramp {type_5 {{metal::float4(1.0, 0.9686, 0.8392, 1.0), metal::float4(1.0, 0.8196, 0.4, 1.0), metal::float4(0.9529, 0.4471, 0.1725, 1.0), metal::float4(0.7843, 0.1961, 0.3529, 1.0), metal::float4(0.4157, 0.1725, 0.549, 1.0), metal::float4(0.1529, 0.2039, 0.4353, 1.0), metal::float4(0.0431, 0.0627, 0.149, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_6 {{metal::float4(0.0, 0.1, 0.22, 0.36), metal::float4(0.52, 0.72, 1.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 7u, 1u};

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

float bounded(
    float x
) {
    uint bits = as_type<uint>(x);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0);
}

metal::float4 bounded_vec4_(
    metal::float4 v_1
) {
    metal::uint4 bits_1 = as_type<metal::uint4>(v_1);
    metal::uint4 magnitude_1 = bits_1 & metal::uint4(2147483647u);
    metal::float4 largest_1 = as_type<metal::float4>((bits_1 & metal::uint4(2147483648u)) | metal::uint4(2139095039u));
    metal::float4 numbers = metal::select(metal::float4(0.0), largest_1, magnitude_1 == metal::uint4(2139095040u));
    return metal::select(numbers, v_1, magnitude_1 < metal::uint4(2139095040u));
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
    float x_1
) {
    float _e1 = metal::dfdx(x_1);
    float _e2 = metal::dfdy(x_1);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

metal::float4 hermite(
    metal::float4 a_1,
    metal::float4 b_1,
    metal::float4 from_a,
    metal::float4 to_b,
    float t
) {
    metal::float4 d_1 = b_1 - a_1;
    return a_1 + (t * (from_a + (t * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t * ((from_a + to_b) - (2.0 * d_1)))))));
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
    float x_2,
    float w
) {
    type_5 colors = {};
    type_6 places = {};
    uint i_2_ = 1u;
    uint at = 0u;
    metal::float4 from_a_1 = metal::float4(0.0);
    metal::float4 to_b_1 = metal::float4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e28 = i_2_;
            i_2_ = _e28 + 1u;
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 7u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e17 = i_2_;
        uint _e21 = i_2_;
        float _e25 = places.inner[naga_div(_e17, 4u)][naga_mod(_e21, 4u)];
        at = (_e25 <= x_2) ? _e16 : _e15;
    }
    uint _e31 = at;
    uint _e35 = at;
    float place = places.inner[naga_div(_e31, 4u)][naga_mod(_e35, 4u)];
    uint _e40 = at;
    if (((_e40 + 1u) >= 7u) | (x_2 <= place)) {
        uint _e47 = at;
        metal::float4 _e49 = colors.inner[_e47];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = _e50 + 1u;
    float _e59 = places.inner[naga_div(after_1, 4u)][naga_mod(after_1, 4u)];
    float span = _e59 - place;
    float _e62 = divided(x_2 - place, span);
    float t_1 = metal::clamp(_e62, 0.0, 1.0);
    uint _e69 = at;
    if (_e69 > 0u) {
        uint _e72 = at;
        uint _e78 = at;
        float before_1 = places.inner[naga_div(_e72 - 1u, 4u)][naga_mod(_e78 - 1u, 4u)];
        uint _e85 = at;
        metal::float4 _e87 = colors.inner[_e85];
        uint _e88 = at;
        metal::float4 _e92 = colors.inner[_e88 - 1u];
        metal::float4 _e96 = colors.inner[after_1];
        uint _e97 = at;
        metal::float4 _e99 = colors.inner[_e97];
        metal::float4 _e101 = ramp_slope(_e87 - _e92, place - before_1, _e96 - _e99, span);
        from_a_1 = _e101;
    }
    if ((after_1 + 1u) < 7u) {
        float _e119 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e119 - (place + span);
        metal::float4 _e123 = colors.inner[after_1];
        uint _e124 = at;
        metal::float4 _e126 = colors.inner[_e124];
        metal::float4 _e131 = colors.inner[after_1 + 1u];
        metal::float4 _e133 = colors.inner[after_1];
        metal::float4 _e135 = ramp_slope(_e123 - _e126, span, _e131 - _e133, next);
        to_b_1 = _e135;
    }
    uint _e136 = at;
    metal::float4 _e138 = colors.inner[_e136];
    metal::float4 _e140 = colors.inner[after_1];
    metal::float4 _e141 = from_a_1;
    metal::float4 _e143 = to_b_1;
    metal::float4 _e145 = hermite(_e138, _e140, span * _e141, span * _e143, t_1);
    metal::float4 _e146 = bounded_vec4_(_e145);
    return _e146;
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

Color output(
    Composite color_1
) {
    Color _e1 = straight(color_1);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

VectorParts separate_vector(
    metal::float3 vector
) {
    return VectorParts {vector.x, vector.y, 0.0};
}

metal::float4 shade(
    Surface surface
) {
    VectorParts _e4 = separate_vector(metal::float3(surface.uv, 0.0));
    float _e8 = footprint_of(_e4.y);
    Color _e9 = ramp_at(color_code, _e4.y, _e8);
    metal::float4 output_alpha = metal::float4(_e9.xyz, metal::clamp(_e9.w, 0.0, 1.0));
    Composite _e16 = premultiplied(output_alpha);
    Color _e17 = output(_e16);
    return _e17;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float2 uv [[attribute(3)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float2 uv [[user(loc0), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.uv };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    const auto _tmp = Varyings {_e10 * world, vertex_.uv};
    return vs_mainOutput { _tmp.clip, _tmp.uv };
}


struct fs_mainInput {
    metal::float2 uv [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
) {
    const Varyings in = { clip, varyings_1.uv };
    Surface surface_1 = Surface {in.uv};
    metal::float4 _e3 = shade(surface_1);
    metal::float4 _e4 = finite_vec4_(_e3);
    return fs_mainOutput { _e4 };
}
