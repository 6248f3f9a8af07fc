// Ink outlines: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object_2 buffer(1), look buffer(2), curvature_tensor_map texture(0), line_nearness_map texture(1), facet_map texture(2).
// ink-outlines.json says what to put there and how to draw.
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
    metal::float3x3 camera_from_world;
    metal::float2 viewport;
    char _pad2[8];
    Light key;
    float object_id;
    char _pad4[12];
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
    metal::packed_float3 position_camera;
    float depth;
    metal::float3 curvature_tensor;
    metal::float4 line_nearness;
    metal::float2 middle_surface;
    float magnification;
    char _pad9[4];
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
struct Outline {
    float line;
    float kind;
    float distance;
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
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint INTERPOLATION_SMOOTH = 1u;
constant uint INTERPOLATION_STEPPED = 2u;
constant uint NOISE_PERLIN = 1u;
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant Ramp three_washes = Ramp {type_7 {{metal::float4(0.4353, 0.5255, 0.6588, 1.0), metal::float4(0.7882, 0.6471, 0.549, 1.0), metal::float4(0.949, 0.851, 0.6941, 1.0), metal::float4(1.0, 0.9647, 0.8784, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_8 {{metal::float4(0.0, 0.36, 0.54, 0.93), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 4u, 2u};
constant Ramp ink = Ramp {type_7 {{metal::float4(0.0784, 0.102, 0.2, 1.0), metal::float4(0.3529, 0.1647, 0.1098, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_8 {{metal::float4(0.1, 0.85, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 2u, 1u};

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_1
) {
    return v_1 * metal::rsqrt(metal::max(metal::dot(v_1, v_1), 0.000000000000000000000000000001));
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
    metal::float4 v_2
) {
    metal::uint4 bits_1 = as_type<metal::uint4>(v_2);
    metal::uint4 magnitude_1 = bits_1 & metal::uint4(2147483647u);
    metal::float4 largest_1 = as_type<metal::float4>((bits_1 & metal::uint4(2147483648u)) | metal::uint4(2139095039u));
    metal::float4 numbers = metal::select(metal::float4(0.0), largest_1, magnitude_1 == metal::uint4(2139095040u));
    return metal::select(numbers, v_2, magnitude_1 < metal::uint4(2139095040u));
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

metal::float4 mixed_vec4_(
    metal::float4 a_1,
    metal::float4 b_1,
    float t
) {
    metal::float4 _e4 = bounded_vec4_(b_1 - a_1);
    metal::float4 _e14 = bounded_vec4_((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4)));
    return _e14;
}

float eased(
    float x_1,
    float low,
    float high
) {
    float _e3 = bounded(x_1);
    float _e7 = bounded((_e3 - low) / 0.5);
    float t_3 = metal::clamp(_e7, 0.0, 1.0);
    return (t_3 * t_3) * (3.0 - (2.0 * t_3));
}

float footprint_of(
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d_1, d_1)));
    return _e6;
}

float footprint_of_2_(
    float x_3
) {
    float _e1 = metal::dfdx(x_3);
    float _e2 = metal::dfdy(x_3);
    metal::float2 d_2 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_2, d_2));
}

float footprint_of_vec3_(
    metal::float3 v_3
) {
    metal::float3 dx = metal::dfdx(v_3);
    metal::float3 dy = metal::dfdy(v_3);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy))));
    return _e7;
}

float step_filtered(
    float x_4,
    float edge,
    float w
) {
    float _e4 = bounded(x_4 - edge);
    if (w < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

float step_filtered_2_(
    float x_5,
    float edge_1,
    float w_1
) {
    float d_3 = x_5 - edge_1;
    return (w_1 < 0.000000000000000000000000000001) ? ((d_3 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_3 / w_1), 0.0, 1.0);
}

metal::float4 hermite(
    metal::float4 a_2,
    metal::float4 b_2,
    metal::float4 from_a,
    metal::float4 to_b,
    float t_1
) {
    metal::float4 d_4 = b_2 - a_2;
    return a_2 + (t_1 * (from_a + (t_1 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_1 * ((from_a + to_b) - (2.0 * d_4)))))));
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
    float w_2
) {
    type_7 colors = {};
    type_8 places = {};
    metal::float4 color = {};
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
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
                float _e43 = step_filtered(x_6, _e42, w_2);
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
    float place_1 = places.inner[naga_div(_e73, 4u)][naga_mod(_e77, 4u)];
    uint _e82 = at;
    if (((_e82 + 1u) >= count) | (x_6 <= place_1)) {
        uint _e88 = at;
        metal::float4 _e90 = colors.inner[_e88];
        metal::float4 _e91 = bounded_vec4_(_e90);
        return _e91;
    }
    uint _e92 = at;
    uint after_1 = _e92 + 1u;
    float _e101 = places.inner[naga_div(after_1, 4u)][naga_mod(after_1, 4u)];
    float span = _e101 - place_1;
    float _e104 = divided(x_6 - place_1, span);
    float t_4 = metal::clamp(_e104, 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        uint _e111 = at;
        metal::float4 _e113 = colors.inner[_e111];
        metal::float4 _e115 = colors.inner[after_1];
        metal::float4 _e116 = mixed_vec4_(_e113, _e115, t_4);
        return _e116;
    }
    uint _e123 = at;
    if (_e123 > 0u) {
        uint _e126 = at;
        uint _e132 = at;
        float before_1 = places.inner[naga_div(_e126 - 1u, 4u)][naga_mod(_e132 - 1u, 4u)];
        uint _e139 = at;
        metal::float4 _e141 = colors.inner[_e139];
        uint _e142 = at;
        metal::float4 _e146 = colors.inner[_e142 - 1u];
        metal::float4 _e150 = colors.inner[after_1];
        uint _e151 = at;
        metal::float4 _e153 = colors.inner[_e151];
        metal::float4 _e155 = ramp_slope(_e141 - _e146, place_1 - before_1, _e150 - _e153, span);
        from_a_1 = _e155;
    }
    if ((after_1 + 1u) < count) {
        float _e169 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e169 - (place_1 + span);
        metal::float4 _e173 = colors.inner[after_1];
        uint _e174 = at;
        metal::float4 _e176 = colors.inner[_e174];
        metal::float4 _e181 = colors.inner[after_1 + 1u];
        metal::float4 _e183 = colors.inner[after_1];
        metal::float4 _e185 = ramp_slope(_e173 - _e176, span, _e181 - _e183, next);
        to_b_1 = _e185;
    }
    uint _e186 = at;
    metal::float4 _e188 = colors.inner[_e186];
    metal::float4 _e190 = colors.inner[after_1];
    metal::float4 _e191 = from_a_1;
    metal::float4 _e193 = to_b_1;
    metal::float4 _e195 = hermite(_e188, _e190, span * _e191, span * _e193, t_4);
    metal::float4 _e196 = bounded_vec4_(_e195);
    return _e196;
}

Color ramp_at_2_(
    Ramp ramp_1,
    float x_7,
    float w_3
) {
    type_7 colors_1 = {};
    type_8 places_1 = {};
    metal::float4 color_1 = {};
    uint i_2 = 1u;
    colors_1 = ramp_1.colors;
    places_1 = ramp_1.places;
    metal::float4 _e8 = colors_1.inner[0];
    color_1 = _e8;
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            uint _e35 = i_2;
            i_2 = _e35 + 1u;
        }
        loop_init_2 = false;
        uint _e12 = i_2;
        if (!((_e12 < 4u))) {
            break;
        }
        metal::float4 _e16 = color_1;
        uint _e17 = i_2;
        metal::float4 _e19 = colors_1.inner[_e17];
        uint _e20 = i_2;
        metal::float4 _e24 = colors_1.inner[_e20 - 1u];
        uint _e27 = i_2;
        float _e31 = places_1.inner[0][naga_mod(_e27, 4u)];
        float _e32 = step_filtered_2_(x_7, _e31, w_3);
        color_1 = _e16 + ((_e19 - _e24) * _e32);
    }
    metal::float4 _e38 = color_1;
    return _e38;
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

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_4 = {};
    v_4 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_4.x;
    uint _e10 = v_4.y;
    uint _e12 = v_4.z;
    v_4.x = _e8 + (_e10 * _e12);
    uint _e16 = v_4.y;
    uint _e18 = v_4.z;
    uint _e20 = v_4.x;
    v_4.y = _e16 + (_e18 * _e20);
    uint _e24 = v_4.z;
    uint _e26 = v_4.x;
    uint _e28 = v_4.y;
    v_4.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_4;
    metal::uint3 _e32 = v_4;
    v_4 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_4.x;
    uint _e40 = v_4.y;
    uint _e42 = v_4.z;
    v_4.x = _e38 + (_e40 * _e42);
    uint _e46 = v_4.y;
    uint _e48 = v_4.z;
    uint _e50 = v_4.x;
    v_4.y = _e46 + (_e48 * _e50);
    uint _e54 = v_4.z;
    uint _e56 = v_4.x;
    uint _e58 = v_4.y;
    v_4.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_4;
    return _e61;
}

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a_3 = (axis == 0u) ? d.y : d.x;
    float b_3 = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a_3 : -(a_3)) + (((hash.z >> 31u) == 0u) ? b_3 : -(b_3));
}

metal::float3 fade_quintic(
    metal::float3 t_2
) {
    return ((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(
    metal::float3 p,
    uint seed_2
) {
    float sum = 0.0;
    int i_3 = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_5 = p - corner;
    metal::float3 _e4 = fade_quintic(d_5);
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound_3 = uint2(4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (metal::all(loop_bound_3 == uint2(0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e46 = i_3;
            i_3 = as_type<int>(as_type<uint>(_e46) + as_type<uint>(1));
        }
        loop_init_3 = false;
        int _e10 = i_3;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i_3;
            int _e16 = i_3;
            int _e21 = i_3;
            metal::int3 at_1 = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at_1 == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at_1)), seed_2);
            float _e42 = gradient_dot(_e39, d_5 - static_cast<metal::float3>(at_1));
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e42);
        }
    }
    float _e48 = sum;
    return metal::clamp(0.5 + (0.48244 * _e48), 0.0, 1.0);
}

float fractal_noise(
    uint kind,
    metal::float3 p_1,
    int octaves,
    float roughness,
    int seed_3,
    float w_4
) {
    float octave = {};
    int i_4 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    uint2 loop_bound_4 = uint2(4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (metal::all(loop_bound_4 == uint2(0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e66 = i_4;
            i_4 = as_type<int>(as_type<uint>(_e66) + as_type<uint>(1));
        }
        loop_init_4 = false;
        int _e17 = i_4;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased(w_4 * _e21, 0.5, 1.0);
        float visible = 1.0 - _e25;
        octave = 0.5;
        if (visible > 0.0) {
            float _e31 = frequency;
            int _e33 = i_4;
            metal::float3 place_2 = metal::clamp((p_1 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_4;
            float _e50 = perlin_noise(place_2, 0u + static_cast<uint>(_e47));
            octave = metal::mix(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = _e53 + (_e54 * _e55);
        float _e58 = total;
        float _e59 = strength;
        total = _e58 + _e59;
        float _e61 = strength;
        strength = _e61 * roughness;
        float _e63 = frequency;
        frequency = _e63 * 2.0;
    }
    float _e69 = sum_1;
    return metal::min(_e69 / 1.5, 1.0);
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    return metal::min((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective), MOST_ON_SCREEN);
}

float reflectance_half_lambert(
    Light light,
    metal::float3 normal
) {
    float half_ = 0.5 + (0.5 * metal::dot(normal, light.direction));
    return metal::min(half_ * half_, 1.0);
}

float inner_contour_suggestive(
    float width,
    float limit,
    float softness,
    metal::float3 tensor,
    metal::float3 normal_1,
    metal::float3 view,
    metal::float3x3 camera_from_world,
    metal::float3 place,
    metal::float2 viewport
) {
    metal::float3 n = camera_from_world * normal_1;
    float square = metal::dot(n.xy, n.xy);
    float radial = ((((tensor.x * n.x) * n.x) + (((2.0 * tensor.y) * n.x) * n.y)) + ((tensor.z * n.y) * n.y)) / metal::max(square, 0.000001);
    float _e35 = metal::dfdx(radial);
    float _e36 = metal::dfdy(radial);
    metal::float2 change = metal::float2(_e35, _e36);
    metal::float3 v_5 = camera_from_world * view;
    metal::float3 row = metal::dfdy(place);
    float up = ((row - (metal::dot(row, v_5) * v_5)).y >= 0.0) ? 1.0 : -1.0;
    float height = metal::clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(((change.x * n.x) + ((up * change.y) * n.y))) * metal::rsqrt(metal::max(square, 0.000001));
    float pixels_1 = ((0.5 * width) * height) / 1000.0;
    float distance_2 = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float x_8 = (toward_eye * height) * 0.05;
    float _e80 = footprint_of(x_8);
    float strength_1 = metal::clamp(0.5 + ((x_8 - limit) / metal::length(metal::float2(metal::min(_e80, 1000000000000000.0), 24.0))), 0.0, 1.0);
    return (metal::clamp((pixels_1 + 0.5) - distance_2, 0.0, metal::min(pixels_1, 1.0)) * strength_1) * metal::smoothstep(0.05, 0.3, metal::dot(normal_1, view));
}

metal::float4 own_nearness(
    metal::float4 nearness,
    metal::float2 middle,
    float depth_1,
    float object,
    float pixels,
    float reach
) {
    bool local = {};
    bool local_1 = {};
    bool is_same_object = middle.y == (object + 1.0);
    float behind = (depth_1 - middle.x) * pixels;
    if (!((middle.y == 0.0))) {
        if (is_same_object) {
            local_1 = metal::abs(behind) <= 8.0;
        } else {
            local_1 = false;
        }
        bool _e25 = local_1;
        local = _e25;
    } else {
        local = true;
    }
    bool is_own = local;
    bool is_in_front = behind < (is_same_object ? -8.0 : -2.0);
    metal::float4 other = metal::float4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

metal::float4 line_widths(
    float width_1,
    metal::float4 shares
) {
    metal::float4 widths_2 = metal::min(width_1, 10000.0) * shares;
    return metal::select(metal::float4(0.0), widths_2, widths_2 > metal::float4(0.000001));
}

float inner_line_covers(
    float distance,
    float width_2
) {
    return metal::clamp((width_2 + 0.5) - distance, 0.0, metal::min(width_2, 1.0));
}

metal::float3 middle_line_covers(
    metal::float3 distance_1,
    metal::float3 width_3
) {
    metal::float3 half_1 = 0.5 * width_3;
    return metal::clamp(metal::min(distance_1 + metal::float3(0.5), half_1) - metal::max(distance_1 - metal::float3(0.5), -(half_1)), metal::float3(0.0), metal::float3(1.0));
}

metal::float4 lines_cover(
    metal::float4 nearness_1,
    metal::float4 widths,
    float reach_1
) {
    metal::float4 distance_3 = metal::float4(reach_1) - nearness_1;
    float _e7 = inner_line_covers(distance_3.x, widths.x);
    metal::float3 _e10 = middle_line_covers(distance_3.yzw, widths.yzw);
    metal::float4 covers = metal::float4(_e7, _e10);
    return metal::select(metal::float4(0.0), covers, nearness_1 > metal::float4(0.0));
}

Outline drawn_outline(
    metal::float4 widths_1,
    metal::float4 of_edges,
    float reach_2
) {
    float kind_1 = {};
    metal::float4 nearness_3 = metal::clamp(of_edges, metal::float4(0.0), metal::float4(reach_2));
    metal::float4 _e7 = lines_cover(nearness_3, widths_1, reach_2);
    float line = metal::max(metal::max(_e7.x, _e7.y), metal::max(_e7.z, _e7.w));
    kind_1 = (_e7.z == line) ? 3.0 : 4.0;
    float _e21 = kind_1;
    kind_1 = (_e7.y == line) ? 2.0 : _e21;
    float _e26 = kind_1;
    kind_1 = (_e7.x == line) ? 1.0 : _e26;
    metal::float4 near = metal::select(metal::float4(0.0), nearness_3, widths_1 > metal::float4(0.0));
    float nearest = metal::max(metal::max(near.x, near.y), metal::max(near.z, near.w));
    float _e44 = kind_1;
    return Outline {line, (line > 0.001) ? _e44 : 0.0, reach_2 - nearest};
}

Outline outline_height(
    float width_4,
    float silhouettes,
    float creases,
    float borders,
    float look_borders,
    metal::float4 nearness_2,
    metal::float2 middle_1,
    float depth_2,
    float object_1,
    metal::float2 viewport_1,
    float magnification
) {
    float pixels_2 = magnification * viewport_1.y;
    float reach_3 = metal::min(16.0 * metal::max(metal::rint(viewport_1.y / 800.0), 1.0), 31.0);
    metal::float4 _e23 = own_nearness(nearness_2, middle_1, depth_2, object_1, pixels_2, reach_3);
    metal::float4 shares_1 = metal::float4(silhouettes, creases, borders, look_borders);
    metal::float4 _e29 = line_widths(width_4 * (0.001 * viewport_1.y), shares_1);
    Outline _e30 = drawn_outline(_e29, _e23, reach_3);
    return _e30;
}

float noise_perlin(
    metal::float3 position,
    float scale_1,
    int octaves_1,
    float roughness_1,
    int seed_4
) {
    metal::float3 p_2 = position * scale_1;
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e5 = reflectance_half_lambert(_e3, surface.normal);
    float _e7 = footprint_of_2_(_e5);
    Color _e8 = ramp_at_2_(three_washes, _e5, _e7);
    float _e10 = footprint_of_2_(_e5);
    Color _e11 = ramp_at(ink, _e5, _e10);
    float heavy_in_the_shade = metal::mix(1.6, 8.0, metal::clamp((_e5 - 0.75) / -0.6, 0.0, 1.0));
    float _e27 = noise_perlin(surface.position_object, 3.5, 2, 0.5, 0);
    float pressure = metal::mix(0.7, 1.3, _e27 - 0.0);
    float width_5 = heavy_in_the_shade * pressure;
    float _e43 = look.object_id;
    metal::float2 _e46 = look.viewport;
    Outline _e48 = outline_height(width_5, 1.0, 0.6, 1.0, 0.6, surface.line_nearness, surface.middle_surface, surface.depth, _e43, _e46, surface.magnification);
    metal::float3x3 _e57 = look.camera_from_world;
    metal::float2 _e61 = look.viewport;
    float _e62 = inner_contour_suggestive(2.2, 24.0, 1.0, surface.curvature_tensor, surface.normal, surface.view, _e57, surface.position_camera, _e61);
    float all_strokes = metal::max(_e48.line, _e62);
    metal::float4 _e65 = bounded_vec4_(_e11);
    metal::float4 _e66 = mixed_vec4_(_e8, _e65, all_strokes);
    metal::float4 output_alpha = metal::float4(_e66.xyz, metal::clamp(_e66.w, 0.0, 1.0));
    Composite _e73 = premultiplied(output_alpha);
    Color _e74 = output(_e73);
    return _e74;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object_2 [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_2 };
    metal::float4x4 _e3 = object_2.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e16 = object_2.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_2 [[user(loc2), center_perspective]];
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
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> line_nearness_map [[texture(1)]]
, metal::texture2d<float, metal::access::sample> facet_map [[texture(2)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object, varyings_1.normal_2 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_2 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4x4 _e21 = view_1.camera_from_world;
    metal::float4x4 _e29 = view_1.camera_from_world;
    metal::float4 _e41 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e48 = line_nearness_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e54 = facet_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e61 = facet_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e68 = view_1.camera_from_world;
    float _e78 = view_1.eye.w;
    float _e83 = view_1.clip_from_world[0].y;
    float _e88 = view_1.clip_from_world[1].y;
    float _e93 = view_1.clip_from_world[2].y;
    float _e96 = size_on_screen(-((_e68 * metal::float4(in.position, 1.0)).z), _e78, metal::length(metal::float3(_e83, _e88, _e93)));
    Surface surface_1 = Surface {normal_2, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, (_e21 * metal::float4(in.position, 1.0)).xyz, -((_e29 * metal::float4(in.position, 1.0)).z), _e41.xyz, _e48, metal::float2(_e54.z, metal::floor(metal::abs(_e61.w))), _e96};
    metal::float4 _e98 = shade(surface_1, look);
    metal::float4 _e99 = finite_vec4_(_e98);
    return fs_mainOutput { _e99 };
}
