// Woodcut: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_4 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// woodcut.json says what to put there and how to draw.
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
    metal::packed_float3 position_object;
    float kappa;
    float magnification;
    char _pad5[12];
    metal::float3x3 world_from_normal;
};
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
constant float MOST_ON_SCREEN = 1000000000000000.0;

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float whole_1 = metal::rint(x);
    float f = x - whole_1;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    int exponent = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
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

metal::float3 bounded_vec3_(
    metal::float3 v_2
) {
    metal::uint3 bits_1 = as_type<metal::uint3>(v_2);
    metal::uint3 magnitude = bits_1 & metal::uint3(2147483647u);
    metal::float3 largest = as_type<metal::float3>((bits_1 & metal::uint3(2147483648u)) | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest, magnitude == metal::uint3(2139095040u));
    return metal::select(numbers, v_2, magnitude < metal::uint3(2139095040u));
}

float footprint_of(
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float step_filtered(
    float x_3,
    float edge,
    float w
) {
    float d_1 = x_3 - edge;
    return (w < 0.000000000000000000000000000001) ? ((d_1 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_1 / w), 0.0, 1.0);
}

metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 _e6 = normalize_moderate(toward, metal::float3(0.0, 0.0, 1.0));
    metal::float3 leaning = metal::cross(up, _e6);
    float square_1 = metal::dot(leaning, leaning);
    metal::float3 aside = (metal::abs(_e6.x) > 0.7) ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across_2 = (square_1 > 0.00000001) ? leaning : metal::cross(aside, _e6);
    metal::float3 _e33 = normalize_moderate(across_2 - (metal::dot(across_2, _e6) * _e6), metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(_e33, metal::cross(_e6, _e33), _e6);
}

float threshold(
    float value,
    float edge_1,
    float softness
) {
    float _e3 = footprint_of(value);
    float _e6 = step_filtered(value, edge_1, metal::length(metal::float2(_e3, softness)));
    return _e6;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_3 = {};
    v_3 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_3.x;
    uint _e10 = v_3.y;
    uint _e12 = v_3.z;
    v_3.x = _e8 + (_e10 * _e12);
    uint _e16 = v_3.y;
    uint _e18 = v_3.z;
    uint _e20 = v_3.x;
    v_3.y = _e16 + (_e18 * _e20);
    uint _e24 = v_3.z;
    uint _e26 = v_3.x;
    uint _e28 = v_3.y;
    v_3.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_3;
    metal::uint3 _e32 = v_3;
    v_3 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_3.x;
    uint _e40 = v_3.y;
    uint _e42 = v_3.z;
    v_3.x = _e38 + (_e40 * _e42);
    uint _e46 = v_3.y;
    uint _e48 = v_3.z;
    uint _e50 = v_3.x;
    v_3.y = _e46 + (_e48 * _e50);
    uint _e54 = v_3.z;
    uint _e56 = v_3.x;
    uint _e58 = v_3.y;
    v_3.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_3;
    return _e61;
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(
    metal::float3 p,
    uint seed_1
) {
    int i = 0;
    float sum = 0.0;
    metal::float3 corner = metal::floor(p);
    metal::float3 t_1 = p - corner;
    metal::float3 f_1 = ((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
    metal::int3 cell = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e68 = i;
            i = as_type<int>(as_type<uint>(_e68) + as_type<uint>(1));
        }
        loop_init = false;
        int _e21 = i;
        if (!((_e21 < 8))) {
            break;
        }
        int _e25 = i;
        int _e28 = i;
        int _e33 = i;
        metal::int3 at_1 = metal::int3(_e25 & 1, (_e28 >> 1u) & 1, _e33 >> 2u);
        metal::float3 weight = metal::select(metal::float3(1.0) - f_1, f_1, at_1 == metal::int3(1));
        float _e44 = sum;
        metal::uint3 _e58 = hash_pcg3d(as_type<metal::uint3>(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at_1))) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
        sum = _e44 + (((weight.x * weight.y) * 0.5) * (static_cast<metal::float3>(_e58 >> metal::uint3(8u)) * 0.000000059604645).x);
    }
    float _e71 = sum;
    return _e71;
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    return metal::min((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective), MOST_ON_SCREEN);
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 turn = metal::float2(metal::sin(angle), metal::cos(angle));
    metal::float3 _e12 = bounded_vec3_((turn.y * along) + (turn.x * across));
    metal::float3 _e18 = bounded_vec3_((turn.y * across) - (turn.x * along));
    metal::float2 turned = metal::float2((turn.y * place.x) + (turn.x * place.y), (turn.y * place.y) - (turn.x * place.x));
    metal::float3 most = metal::float3(1000000000000000.0);
    metal::float3 stretch_1 = metal::clamp(metal::float3(metal::dot(_e12, _e12), metal::dot(_e12, _e18), metal::dot(_e18, _e18)), -(most), most);
    return StretchedPlace {turned, {}, stretch_1};
}

metal::float3 gradient_on_picture(
    metal::float3 g,
    metal::float3 normal,
    metal::float3 view
) {
    float facing = metal::dot(normal, view);
    return g - (normal * (metal::dot(g, view) / ((facing >= 0.0) ? metal::max(facing, 0.125) : metal::min(facing, -0.125))));
}

StretchedPlace place_on_surface(
    metal::float2 place_1,
    metal::float3 along_1,
    metal::float3 across_1,
    metal::float3 normal_1,
    metal::float3 view_1,
    float magnification,
    float angle_1
) {
    float height = 1.0 / metal::clamp(magnification, 0.000000000000001, 1000000000000000.0);
    metal::float3 _e12 = gradient_on_picture(along_1, normal_1, view_1);
    metal::float3 _e14 = bounded_vec3_(_e12 * height);
    metal::float3 _e15 = gradient_on_picture(across_1, normal_1, view_1);
    metal::float3 _e17 = bounded_vec3_(_e15 * height);
    StretchedPlace _e18 = mark_place_of(place_1, _e14, _e17, angle_1);
    return _e18;
}

StretchedPlace place_across(
    metal::float3 axis,
    metal::float3 position,
    metal::float3x3 world_from_normal,
    metal::float3 normal_2,
    metal::float3 view_2,
    float magnification_1,
    float angle_2
) {
    metal::float3x3 _e11 = axes_around(axis, metal::float3(0.0, 1.0, 0.0));
    metal::float2 place_5 = metal::float2(metal::dot(position, _e11[0]), metal::dot(position, _e11[2]));
    metal::float3 along_2 = world_from_normal * _e11[0];
    metal::float3 across_3 = world_from_normal * _e11[2];
    StretchedPlace _e21 = place_on_surface(place_5, along_2, across_3, normal_2, view_2, magnification_1, angle_2);
    return _e21;
}

SpacedPlace spaced(
    metal::float2 place_2,
    metal::float3 stretch,
    metal::float2 viewport,
    float count
) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_1 = is_pixel ? (count / metal::max(viewport.y, 1.0)) : count;
    metal::float2 p_1 = metal::clamp(place_2 * scale_1, metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float3 _e21 = bounded_vec3_(stretch);
    metal::float3 s = metal::clamp(_e21, metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
    return SpacedPlace {p_1, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : s};
}

Stroke stroke_at(
    metal::int2 line,
    float x_4,
    int zoom,
    Strokes style
) {
    metal::uint3 _e12 = hash_pcg3d(as_type<metal::uint3>(metal::int3(line, 1048576)) + metal::uint3(1401181199u, 2842855661u, 1390592883u));
    metal::float3 own_1 = static_cast<metal::float3>(_e12 >> metal::uint3(8u)) * 0.000000059604645;
    return Stroke {own_1.y, 1.0};
}

Stroke stroke_between(
    metal::int2 line_1,
    float x_5,
    float level,
    Strokes style_1
) {
    float zoom_2 = metal::floor(level);
    Stroke _e6 = stroke_at(line_1, x_5, naga_f2i32(zoom_2), style_1);
    Stroke _e10 = stroke_at(line_1, x_5, as_type<int>(as_type<uint>(naga_f2i32(zoom_2)) + as_type<uint>(1)), style_1);
    float f_2 = level - zoom_2;
    return Stroke {metal::mix(_e6.turn, _e10.turn, f_2), metal::mix(1.0, 1.0, f_2)};
}

int naga_neg(int val) {
    return as_type<int>(-as_type<uint>(val));
}

float stray_at(
    metal::float2 place_3,
    int zoom_1,
    uint seed_2
) {
    metal::float2 p_2 = place_3 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom_1) + as_type<uint>(127))) << 23u);
    float _e18 = value_noise(metal::float3(0.11 * p_2.x, 0.45 * p_2.y, 0.5), seed_2);
    return ((_e18 - 0.5) * 2.0) * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_neg(zoom_1)) + as_type<uint>(127))) << 23u);
}

float band_filtered(
    float t,
    float half_,
    float w_1
) {
    if (w_1 < 0.000000000000000000000000000001) {
        return ((metal::abs(t) <= half_) & (half_ > 0.0)) ? 1.0 : 0.0;
    }
    return metal::clamp((metal::clamp(t + (0.5 * w_1), -(half_), half_) - metal::clamp(t - (0.5 * w_1), -(half_), half_)) / w_1, 0.0, 1.0);
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
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
    float w_2,
    float level_1,
    float ink,
    Strokes style_2
) {
    if (!((ink > 0.0))) {
        return 0.0;
    }
    float number = metal::pow(ink, 1.0 - style_2.pressure);
    float width = style_2.width * metal::pow(ink, style_2.pressure);
    float zoom_3 = metal::floor(level_1);
    float _e20 = stray_at(place_4, naga_f2i32(zoom_3), 7u);
    float _e25 = stray_at(place_4, as_type<int>(as_type<uint>(naga_f2i32(zoom_3)) + as_type<uint>(1)), 7u);
    float stray = metal::mix(_e20, _e25, level_1 - zoom_3);
    float across_4 = place_4.y + (style_2.wobble * stray);
    float _e34 = log2_stable(metal::max(number, 0.000000001));
    float density = metal::max(level_1 + _e34, -40.0);
    float octave_1 = metal::floor(density);
    float _e40 = exp2_stable(density - octave_1);
    float growth = _e40 - 1.0;
    float scale_2 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(octave_1)) + as_type<uint>(127))) << 23u);
    float q = metal::clamp(across_4 * scale_2, -4194304.0, 4194304.0);
    float _e57 = exp2_stable(octave_1 - level_1);
    float half_1 = (0.5 * width) * _e57;
    float footprint = w_2 * scale_2;
    int whole_2 = naga_f2i32(metal::rint(q));
    metal::int2 _e63 = line_of(whole_2, naga_f2i32(octave_1));
    Stroke _e65 = stroke_between(_e63, place_4.x, level_1, style_2);
    float middle = metal::floor(q);
    Stroke _e77 = stroke_between(metal::int2(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(naga_f2i32(middle)))) + as_type<uint>(1)), as_type<int>(as_type<uint>(naga_f2i32(octave_1)) + as_type<uint>(1))), place_4.x, level_1, style_2);
    float grown = metal::clamp((growth - (0.75 * _e77.turn)) / 0.25, 0.0, 1.0);
    float _e91 = band_filtered(q - static_cast<float>(whole_2), half_1 * _e65.profile, footprint);
    float _e98 = band_filtered((q - middle) - 0.5, (half_1 * grown) * _e77.profile, footprint);
    float mean = metal::min((2.0 * half_1) * (1.0 + growth), 1.0);
    return metal::mix(metal::max(_e91, _e98), mean, metal::smoothstep(0.75, 1.5, footprint));
}

float cross_hatched(
    SpacedPlace at,
    float ink_1,
    int layers,
    float cross,
    Strokes style_3
) {
    Strokes own = {};
    int i_1 = 0;
    float free = 1.0;
    metal::float2 x_6 = metal::dfdx(at.place);
    metal::float2 y = metal::dfdy(at.place);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e78 = i_1;
            i_1 = as_type<int>(as_type<uint>(_e78) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e14 = i_1;
        if (!((_e14 < 4))) {
            break;
        }
        int _e18 = i_1;
        if (_e18 < 1) {
            metal::float2 turn_1 = metal::float2(0.0, 1.0);
            metal::float2 along_3 = metal::float2(turn_1.y, turn_1.x);
            metal::float2 across_5 = metal::float2(-(turn_1.x), turn_1.y);
            float w_3 = metal::length(metal::float2(metal::dot(across_5, x_6), metal::dot(across_5, y)));
            float square_2 = metal::dot(metal::float3(across_5.x * across_5.x, (2.0 * across_5.x) * across_5.y, across_5.y * across_5.y), at.stretch);
            float _e59 = log2_stable(metal::max(metal::max(square_2, (at.stretch.x + at.stretch.z) / 65.0), 0.000000000000000000000000000001));
            float level_2 = metal::clamp(-0.5 * _e59, -16.0, 16.0);
            metal::float2 place_6 = metal::float2(metal::dot(along_3, at.place), metal::dot(across_5, at.place));
            own = style_3;
            own.seed = 7u;
            Strokes _e74 = own;
            float _e75 = hatched(place_6, w_3, level_2, ink_1 - 0.0, _e74);
            free = 1.0 - _e75;
        }
    }
    float _e81 = free;
    return 1.0 - _e81;
}

MarkPlace mark_place_light(
    Light light,
    metal::float3 normal_3,
    float angle_3,
    metal::float3 view_3,
    metal::float3 position_object,
    metal::float3x3 world_from_normal_1,
    float magnification_2
) {
    metal::float3 toward_1 = light.direction * world_from_normal_1;
    StretchedPlace _e9 = place_across(toward_1, position_object, world_from_normal_1, normal_3, view_3, magnification_2, angle_3);
    return MarkPlace {_e9.place, {}, _e9.stretch};
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    float shade_2_ = metal::max((metal::dot(surface.normal, _e5) + 0.3) / 1.3, 0.0);
    float tone = metal::mix(0.02, 1.0, metal::min((shade_2_ - 0.0) / 0.8, 1.0));
    float _e24 = threshold(tone, 0.72, 0.0);
    metal::float4 ochre_block = metal::mix(metal::float4(0.8392, 0.6039, 0.2902, 1.0), metal::float4(0.9529, 0.902, 0.7843, 1.0), _e24);
    Light _e38 = look.key;
    MarkPlace _e45 = mark_place_light(_e38, surface.normal, 0.0, surface.view, surface.position_object, surface.world_from_normal, surface.magnification);
    metal::float2 _e50 = look.viewport;
    SpacedPlace _e52 = spaced(_e45.place, _e45.stretch, _e50, 78.0);
    float _e67 = cross_hatched(_e52, 1.0 - metal::min(tone, 1.0), 1, 1.0471976, Strokes {0.62, 0.0, 0.8, 0.35, 0.85, 1.0, 7u});
    float _e70 = threshold(tone, 0.2, 0.0);
    float curvature = surface.kappa;
    float hollow_to_bulge = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.22, -20.0, 20.0))))));
    float _e92 = threshold(hollow_to_bulge, 0.2, 0.0);
    float _e101 = threshold(metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0), 0.3, 0.0);
    float black_block = metal::max(metal::max(_e67, 1.0 - _e70), metal::max(1.0 - _e92, 1.0 - _e101));
    metal::float4 print = metal::mix(ochre_block, metal::float4(0.1137, 0.0824, 0.0706, 1.0), black_block);
    return print;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_4 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_4 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_4.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object_1 [[user(loc1), center_perspective]];
    metal::float3 normal_4 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_4 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object_1, varyings_1.normal_4 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_4 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_4.eye;
    float _e13 = view_4.eye.w;
    metal::float4 _e24 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e28 = view_4.camera_from_world;
    float _e38 = view_4.eye.w;
    float _e43 = view_4.clip_from_world[0].y;
    float _e48 = view_4.clip_from_world[1].y;
    float _e53 = view_4.clip_from_world[2].y;
    float _e56 = size_on_screen(-((_e28 * metal::float4(in.position, 1.0)).z), _e38, metal::length(metal::float3(_e43, _e48, _e53)));
    metal::float3x3 _e59 = object.world_from_normal;
    Surface surface_1 = Surface {normal_4, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, _e24.x, _e56, {}, _e59};
    metal::float4 _e61 = shade(surface_1, look);
    return fs_mainOutput { _e61 };
}
