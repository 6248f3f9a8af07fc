// Chalk: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// chalk-board.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    metal::float4 eye;
    metal::float4 screen;
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
    metal::float2 viewport;
    char _pad2[8];
    Light key;
};
struct Surface {
    metal::packed_float3 normal;
    float kappa;
    metal::float2 pixel;
    char _pad3[8];
    metal::float3 anchor;
};
struct Angle {
    float half_sin;
    float half_cos;
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
struct MarkPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct PaperGrain {
    float tone;
    float height;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 normal;
};
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant ProfileShape orange_chalk_shape = ProfileShape {0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5, 0.43399706, 0.1847509, 0u};

float log2_stable(
    float x
) {
    uint bits = as_type<uint>(x);
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

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_2 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_2, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_1 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_1, u_1.half_cos);
    metal::float2 turned = ((s_1 <= 0.0) & (s_1 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float bounded(
    float x_1
) {
    uint bits_1 = as_type<uint>(x_1);
    uint magnitude = bits_1 & 2147483647u;
    float largest = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0);
}

float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return (s <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q * q), 0.0), shape.exponent);
}

float profile_filtered_quick(
    Angle u_2,
    float w,
    ProfileShape shape_1
) {
    metal::float2 place_6 = metal::float2((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset), (u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset));
    float _e19 = profile_soft_quick(place_6.x, shape_1);
    if (w < (0.1 * shape_1.edge_deviation)) {
        return _e19;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e45 = profile_soft_quick((place_6.x * turn.y) - (place_6.y * turn.x), shape_1);
    float _e53 = profile_soft_quick((place_6.x * turn.y) + (place_6.y * turn.x), shape_1);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_2
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_2 = {};
    v_2 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_2.x;
    uint _e10 = v_2.y;
    uint _e12 = v_2.z;
    v_2.x = _e8 + (_e10 * _e12);
    uint _e16 = v_2.y;
    uint _e18 = v_2.z;
    uint _e20 = v_2.x;
    v_2.y = _e16 + (_e18 * _e20);
    uint _e24 = v_2.z;
    uint _e26 = v_2.x;
    uint _e28 = v_2.y;
    v_2.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_2;
    metal::uint3 _e32 = v_2;
    v_2 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_2.x;
    uint _e40 = v_2.y;
    uint _e42 = v_2.z;
    v_2.x = _e38 + (_e40 * _e42);
    uint _e46 = v_2.y;
    uint _e48 = v_2.z;
    uint _e50 = v_2.x;
    v_2.y = _e46 + (_e48 * _e50);
    uint _e54 = v_2.z;
    uint _e56 = v_2.x;
    uint _e58 = v_2.y;
    v_2.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_2;
    return _e61;
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a = (axis == 0u) ? d.y : d.x;
    float b = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(
    metal::float3 p,
    uint seed_1
) {
    int i = 0;
    float sum = 0.0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_1 = p - corner;
    metal::float3 f = ((d_1 * d_1) * d_1) * ((d_1 * ((d_1 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
    metal::int3 cell = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e64 = i;
            i = as_type<int>(as_type<uint>(_e64) + as_type<uint>(1));
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
        metal::float3 weight = metal::select(metal::float3(1.0) - f, f, at_1 == metal::int3(1));
        float _e44 = sum;
        metal::uint3 _e58 = hash_pcg3d(as_type<metal::uint3>(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at_1))) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
        float _e61 = gradient_dot(_e58, d_1 - static_cast<metal::float3>(at_1));
        sum = _e44 + (((weight.x * weight.y) * 0.5) * _e61);
    }
    float _e67 = sum;
    return metal::clamp(0.5 + (0.48244 * _e67), 0.0, 1.0);
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    return metal::min((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective), MOST_ON_SCREEN);
}

metal::float3 anchor_on_screen(
    metal::float3 origin,
    float perspective_1,
    float scale_1
) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return metal::clamp(metal::float3(origin.x * _e5, -(origin.y) * _e5, _e5), metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
}

metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 from_middle = pixel - (0.5 * viewport);
    return metal::float2(from_middle.x, -(from_middle.y)) / metal::float2(metal::max(viewport.y, 1.0));
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle_1
) {
    metal::float2 turn_1 = metal::float2(0.0, 1.0);
    metal::float3 x_2 = (turn_1.y * along) + (turn_1.x * across);
    metal::float3 y = (turn_1.y * across) - (turn_1.x * along);
    metal::float2 turned_1 = metal::float2((turn_1.y * place.x) + (turn_1.x * place.y), (turn_1.y * place.y) - (turn_1.x * place.x));
    metal::float3 stretch_5 = metal::float3(metal::dot(x_2, x_2), metal::dot(x_2, y), metal::dot(y, y));
    return StretchedPlace {turned_1, {}, stretch_5};
}

SpacedPlace spaced(
    metal::float2 place_1,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count
) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = is_pixel ? (count / metal::max(viewport_1.y, 1.0)) : count;
    metal::float2 p_1 = metal::clamp(place_1 * scale_2, metal::float2(-4194304.0), metal::float2(4194304.0));
    return SpacedPlace {p_1, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : stretch};
}

float area_square(
    metal::float3 stretch_1
) {
    float sum_1 = stretch_1.x + stretch_1.z;
    return metal::max((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y), (sum_1 * sum_1) / 66.0);
}

MarkPlace mark_place_object(
    float angle_2,
    metal::float3 anchor,
    metal::float2 pixel_1,
    metal::float2 viewport_2
) {
    float size = metal::clamp(anchor.z, 0.000001, 1000000.0);
    metal::float2 _e8 = place_in_picture(pixel_1, viewport_2);
    metal::float2 place_7 = (_e8 - metal::float2(anchor.x, -(anchor.y))) / metal::float2(size);
    StretchedPlace _e26 = mark_place_of(place_7, metal::float3(1.0 / size, 0.0, 0.0), metal::float3(0.0, 1.0 / size, 0.0), angle_2);
    return MarkPlace {_e26.place, {}, _e26.stretch};
}

float paper_octave(
    metal::float2 place_2,
    int zoom,
    float w_1,
    float fiber,
    uint seed_2
) {
    float scale_3 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom) + as_type<uint>(127))) << 23u);
    metal::float2 p_2 = metal::clamp(place_2 * scale_3, metal::float2(-4194304.0), metal::float2(4194304.0));
    uint own = seed_2 + (7u * as_type<uint>(zoom));
    float _e23 = perlin_noise(metal::float3(p_2, 0.5), own);
    float grain = _e23 - 0.5;
    metal::float2 q_1 = metal::clamp(2.7 * metal::float2((0.8 * p_2.x) - (0.6 * p_2.y), (0.6 * p_2.x) + (0.8 * p_2.y)), metal::float2(-4194304.0), metal::float2(4194304.0));
    float _e52 = perlin_noise(metal::float3(q_1, 0.5), own + 1u);
    float felt = _e52 - 0.5;
    float coarse_seen = 1.0 - metal::smoothstep(0.5, 1.0, w_1 * scale_3);
    float felt_seen = 1.0 - metal::smoothstep(0.5, 1.0, (2.7 * w_1) * scale_3);
    return metal::clamp(0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt))), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float paper_height(
    SpacedPlace at,
    float fiber_1,
    uint seed_3
) {
    float height = {};
    metal::float2 x_3 = metal::dfdx(at.place);
    metal::float2 y_1 = metal::dfdy(at.place);
    float w_3 = metal::sqrt(metal::max(metal::dot(x_3, x_3), metal::dot(y_1, y_1)));
    float _e12 = area_square(at.stretch);
    float _e16 = log2_stable(metal::max(metal::sqrt(_e12), 0.000000000000000000000000000001));
    float level = metal::clamp(-0.5 * _e16, -16.0, 16.0);
    float zoom_1 = metal::floor(level);
    float f_1 = level - zoom_1;
    float _e26 = paper_octave(at.place, naga_f2i32(zoom_1), w_3, fiber_1, seed_3);
    height = _e26;
    if (f_1 > 0.0) {
        float _e30 = height;
        float _e35 = paper_octave(at.place, as_type<int>(as_type<uint>(naga_f2i32(zoom_1)) + as_type<uint>(1)), w_3, fiber_1, seed_3);
        float both = metal::mix(_e30, _e35, f_1);
        height = metal::clamp(0.5 + ((both - 0.5) / metal::sqrt((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))), 0.0, 1.0);
    }
    float _e53 = height;
    return _e53;
}

PaperGrain paper_grain(
    float value,
    metal::float2 place_3,
    metal::float3 stretch_2,
    float count_1,
    float tooth,
    float fiber_2,
    int seed_4,
    metal::float2 viewport_3
) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    float _e10 = paper_height(_e8, fiber_2, 5u);
    float ink = 1.0 - value;
    return PaperGrain {1.0 - metal::clamp(ink + ((((8.0 * tooth) * (_e10 - 0.5)) * ink) * (1.0 - ink)), 0.0, 1.0), _e10};
}

PaperGrain paper_grain_2_(
    float value_1,
    metal::float2 place_4,
    metal::float3 stretch_3,
    float count_2,
    float tooth_1,
    float fiber_3,
    int seed_5,
    metal::float2 viewport_4
) {
    SpacedPlace _e8 = spaced(place_4, stretch_3, viewport_4, count_2);
    float _e10 = paper_height(_e8, fiber_3, 9u);
    float ink_1 = 1.0 - value_1;
    return PaperGrain {1.0 - metal::clamp(ink_1 + ((((8.0 * tooth_1) * (_e10 - 0.5)) * ink_1) * (1.0 - ink_1)), 0.0, 1.0), _e10};
}

PaperGrain paper_grain_3_(
    float value_2,
    metal::float2 place_5,
    metal::float3 stretch_4,
    float count_3,
    float tooth_2,
    float fiber_4,
    int seed_6,
    metal::float2 viewport_5
) {
    SpacedPlace _e8 = spaced(place_5, stretch_4, viewport_5, count_3);
    float _e10 = paper_height(_e8, fiber_4, 3u);
    float ink_2 = 1.0 - metal::max(value_2, 0.0);
    return PaperGrain {1.0 - metal::clamp(ink_2 + ((((8.0 * tooth_2) * (_e10 - 0.5)) * ink_2) * (1.0 - ink_2)), 0.0, 1.0), _e10};
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    float shade_2_ = metal::max((metal::dot(surface.normal, _e5) + 0.15) / 1.15, 0.0);
    float tone = metal::min((shade_2_ - 0.0) / 0.9, 1.0);
    float rubbed = metal::mix(0.05, 0.5, metal::min((tone - 0.0) / 0.6, 1.0));
    float r_bare = 1.0 - rubbed;
    metal::float2 _e35 = look.viewport;
    MarkPlace _e36 = mark_place_object(0.0, surface.anchor, surface.pixel, _e35);
    metal::float2 _e45 = look.viewport;
    PaperGrain _e46 = paper_grain(r_bare, _e36.place, _e36.stretch, 120.0, 0.6, 0.5, 5, _e45);
    float _e50 = bounded(1.0 - _e46.tone);
    metal::float4 blue_gray = metal::mix(metal::float4(0.1216, 0.1647, 0.1686, 1.0), metal::float4(0.4275, 0.5098, 0.5647, 1.0), _e50);
    metal::float3 _e66 = look.back.direction;
    metal::float3 _e75 = look.back.direction;
    Angle turn_2 = Angle {0.5 * metal::length(surface.normal - _e66), 0.5 * metal::length(surface.normal + _e75)};
    float _e83 = profile_balanced(turn_2, 0.0, orange_chalk_shape);
    float o_bare = 1.0 - _e83;
    metal::float2 _e94 = look.viewport;
    PaperGrain _e95 = paper_grain_2_(o_bare, _e36.place, _e36.stretch, 220.0, 0.8, 0.5, 9, _e94);
    float _e104 = bounded(1.0 - _e95.tone);
    metal::float4 orange = metal::mix(blue_gray, metal::float4(0.9412, 0.6353, 0.3608, 1.0), _e104);
    float curvature = surface.kappa;
    float hollow_to_bulge = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.16, -20.0, 20.0))))));
    float bare_in_hollows = metal::mix(0.1, 1.0, metal::clamp((hollow_to_bulge - 0.15) / 0.35, 0.0, 1.0));
    float white_chalk = tone * bare_in_hollows;
    float w_bare = 1.0 - white_chalk;
    metal::float2 _e146 = look.viewport;
    PaperGrain _e147 = paper_grain_3_(w_bare, _e36.place, _e36.stretch, 260.0, 0.62, 0.5, 3, _e146);
    float _e156 = bounded(1.0 - _e147.tone);
    metal::float4 white = metal::mix(orange, metal::float4(0.9686, 0.9529, 0.9098, 1.0), _e156);
    return white;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e14 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, _e14 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 normal [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.normal };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    metal::float4 _e11 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e17 = view.screen;
    metal::float4 _e22 = view.screen;
    metal::float4x4 _e27 = view.camera_from_world;
    metal::float4 _e31 = object.world_from_object[3];
    float _e40 = view.eye.w;
    float _e45 = view.clip_from_world[0].y;
    float _e50 = view.clip_from_world[1].y;
    float _e55 = view.clip_from_world[2].y;
    metal::float3 _e58 = anchor_on_screen((_e27 * metal::float4(_e31.xyz, 1.0)).xyz, _e40, metal::length(metal::float3(_e45, _e50, _e55)));
    Surface surface_1 = Surface {normal, _e11.x, (in.clip.xy * _e17.xy) + _e22.zw, {}, _e58};
    metal::float4 _e60 = shade(surface_1, look);
    return fs_mainOutput { _e60 };
}
