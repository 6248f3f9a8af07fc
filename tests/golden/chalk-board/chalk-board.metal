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
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    metal::float4 eye;
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    metal::float4 screen;
};

struct Object {
    metal::float4x4 world_from_object;
    /// The inverse transpose, for normals.
    metal::float3x3 world_from_normal;
    float id;
    char _pad3[12];
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    metal::float3 direction;
    /// Unit, toward the light, in the light's own frame.
    metal::float3 own_direction;
    /// Straight RGB.
    metal::packed_float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    Light back;
    metal::float2 viewport;
    char _pad2[8];
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::packed_float3 normal;
    float kappa;
    metal::float2 pixel;
    char _pad3[8];
    metal::float3 anchor;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    uint kind;
};

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    metal::float2 place;
    char _pad1[8];
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    metal::float3 stretch;
};

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};

struct MarkPlace {
    /// Along the strokes, and across them.
    metal::float2 place;
    char _pad1[8];
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    metal::float3 stretch;
};

struct PaperGrain {
    /// The tone as the paper shows it.
    float tone;
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
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

/// Greatest place and size on screen, in picture heights: beyond, it says no more.
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant ProfileShape orange_chalk_shape = ProfileShape {0.9689124, 0.24740396, 2.425296, 2.1444545,
    0.5, 0.43399706, 0.1847509, 0u};

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(
    float x
) {
    uint bits = as_type<uint>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return static_cast<float>(exponent) + z
        * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return square > 0.000000000000000000000000000001 ? v
        * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
metal::float3 normalize_seen(
    metal::float3 v
) {
    return normalize_moderate(v, metal::float3(0.0, 0.0, 1.0));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(
    Angle u,
    metal::float2 t
) {
    float s = u.half_sin - 0.0;
    metal::float2 upper = u.half_cos
        <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, u.half_cos);
    metal::float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(
    float x
) {
    uint bits = as_type<uint>(x);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : metal::pow(metal::max(1.0 - q * q, 0.0), shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(
    Angle u,
    float w,
    ProfileShape shape
) {
    metal::float2 place = metal::float2(u.half_sin * shape.half_cos_offset - u.half_cos
        * shape.half_sin_offset, u.half_cos * shape.half_cos_offset + u.half_sin
        * shape.half_sin_offset);
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v = {};
    v = seed * 1664525u + metal::uint3(1013904223u);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> metal::uint3(16u));
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(
    metal::float3 p,
    uint seed
) {
    float sum = 0.0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d = p - corner;
    metal::float3 f = d * d * d * (d * (d * 6.0 - metal::float3(15.0)) + metal::float3(10.0));
    metal::int3 cell = naga_f2i32(corner);
    for (int i = 0; i < 8; i++) {
        metal::int3 at = metal::int3(i & 1, (i >> 1u) & 1, i >> 2u);
        metal::float3 weight = metal::select(metal::float3(1.0) - f, f, at == metal::int3(1));
        metal::uint3 hash_pcg3d_value = hash_pcg3d(as_type<metal::uint3>(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at))) + seed * metal::uint3(2654435769u,
            2246822507u, 3266489909u));
        sum = sum + weight.x * weight.y * 0.5
            * gradient_dot(hash_pcg3d_value, d - static_cast<metal::float3>(at));
    }
    return metal::clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    // Clip space is 2 high.
    return metal::min(0.5 * scale / metal::mix(1.0, metal::max(depth, 0.000001), perspective),
        MOST_ON_SCREEN);
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
metal::float3 anchor_on_screen(
    metal::float3 origin,
    float perspective,
    float scale
) {
    float size = size_on_screen(-origin.z, perspective, scale);
    return metal::clamp(metal::float3(origin.x * size, -origin.y * size, size),
        metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 from_middle = pixel - 0.5 * viewport;
    return metal::float2(from_middle.x, -from_middle.y)
        / metal::float2(metal::max(viewport.y, 1.0));
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 turn = metal::float2(0.0, 1.0);
    metal::float3 x = turn.y * along + turn.x * across;
    metal::float3 y = turn.y * across - turn.x * along;
    metal::float2 turned = metal::float2(turn.y * place.x + turn.x * place.y, turn.y * place.y
        - turn.x * place.x);
    metal::float3 stretch = metal::float3(metal::dot(x, x), metal::dot(x, y), metal::dot(y, y));
    return StretchedPlace {turned, {}, stretch};
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced(
    metal::float2 place,
    metal::float3 stretch,
    metal::float2 viewport,
    float count
) {
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / metal::max(viewport.y, 1.0) : count;
    metal::float2 p = metal::clamp(place * scale, metal::float2(-4194304.0),
        metal::float2(4194304.0));
    return SpacedPlace {p, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : stretch};
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
float area_square(
    metal::float3 stretch
) {
    float sum = stretch.x + stretch.z;
    return metal::max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

MarkPlace mark_place_object(
    float angle,
    metal::float3 anchor,
    metal::float2 pixel,
    metal::float2 viewport
) {
    float size = metal::clamp(anchor.z, 0.000001, 1000000.0);
    metal::float2 place = (place_in_picture(pixel, viewport) - metal::float2(anchor.x, -anchor.y))
        / metal::float2(size);
    StretchedPlace m = mark_place_of(place, metal::float3(1.0 / size, 0.0, 0.0),
        metal::float3(0.0, 1.0 / size, 0.0), angle);
    return MarkPlace {m.place, {}, m.stretch};
}

/// The height of paper in one octave; paper finer than a pixel is flat.
float paper_octave(
    metal::float2 place,
    int zoom,
    float w,
    float fiber,
    uint seed
) {
    float scale = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom)
        + as_type<uint>(127))) << 23u);
    metal::float2 p = metal::clamp(place * scale, metal::float2(-4194304.0),
        metal::float2(4194304.0));
    uint own = seed + 7u * as_type<uint>(zoom);
    float grain = perlin_noise(metal::float3(p, 0.5), own) - 0.5;
    metal::float2 q = metal::clamp(2.7
        * metal::float2(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), metal::float2(-4194304.0),
        metal::float2(4194304.0));
    float felt = perlin_noise(metal::float3(q, 0.5), own + 1u) - 0.5;
    float coarse_seen = 1.0 - metal::smoothstep(0.5, 1.0, w * scale);
    float felt_seen = 1.0 - metal::smoothstep(0.5, 1.0, 2.7 * w * scale);
    return metal::clamp(0.5 + 1.4 * (coarse_seen * grain + fiber * felt_seen * felt), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// The height of paper, from 0 to 1 and 1/2 on average. Where an octave fades into the next, both
/// octaves are seen.
float paper_height(
    SpacedPlace at,
    float fiber,
    uint seed
) {
    float height = {};
    metal::float2 x = metal::dfdx(at.place);
    metal::float2 y = metal::dfdy(at.place);
    float w = metal::sqrt(metal::max(metal::dot(x, x), metal::dot(y, y)));
    float log2_stable_value = log2_stable(metal::max(metal::sqrt(area_square(at.stretch)),
        0.000000000000000000000000000001));
    float level = metal::clamp(-0.5 * log2_stable_value, -16.0, 16.0);
    float zoom = metal::floor(level);
    float f = level - zoom;
    height = paper_octave(at.place, naga_f2i32(zoom), w, fiber, seed);
    if (f > 0.0) {
        float paper_octave_value = paper_octave(at.place,
            as_type<int>(as_type<uint>(naga_f2i32(zoom)) + as_type<uint>(1)), w, fiber, seed);
        float both = metal::mix(height, paper_octave_value, f);
        height = metal::clamp(0.5 + (both - 0.5) / metal::sqrt(f * f + (1.0 - f) * (1.0 - f)), 0.0,
            1.0);
    }
    return height;
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain(
    float value,
    metal::float2 place,
    metal::float3 stretch,
    float count,
    float tooth,
    float fiber,
    int seed,
    metal::float2 viewport
) {
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 5u);
    float ink = 1.0 - value;
    return PaperGrain {1.0 - metal::clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink),
        0.0, 1.0), height};
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_2(
    float value,
    metal::float2 place,
    metal::float3 stretch,
    float count,
    float tooth,
    float fiber,
    int seed,
    metal::float2 viewport
) {
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 9u);
    float ink = 1.0 - value;
    return PaperGrain {1.0 - metal::clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink),
        0.0, 1.0), height};
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_3(
    float value,
    metal::float2 place,
    metal::float3 stretch,
    float count,
    float tooth,
    float fiber,
    int seed,
    metal::float2 viewport
) {
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 3u);
    float ink = 1.0 - metal::max(value, 0.0);
    return PaperGrain {1.0 - metal::clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink),
        0.0, 1.0), height};
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Reflectance
    float shade_2 = metal::max((metal::dot(surface.normal, look.key.direction) + 0.15) / 1.15, 0.0);
    float tone = metal::min((shade_2 - 0.0) / 0.9, 1.0);
    float rubbed = metal::mix(0.05, 0.5, metal::min((tone - 0.0) / 0.6, 1.0));
    float r_bare = 1.0 - rubbed;
    MarkPlace board = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    PaperGrain r_grain = paper_grain(r_bare, board.place, board.stretch, 120.0, 0.6, 0.5, 5,
        look.viewport);
    float r_on = bounded(1.0 - r_grain.tone);
    metal::float4 blue_gray = metal::mix(metal::float4(0.1216, 0.1647, 0.1686, 1.0),
        metal::float4(0.4275, 0.5098, 0.5647, 1.0), r_on);
    // Parametrization
    Angle turn = Angle {0.5 * metal::length(surface.normal - look.back.direction), 0.5
        * metal::length(surface.normal + look.back.direction)};
    float orange_chalk = profile_balanced(turn, 0.0, orange_chalk_shape);
    float o_bare = 1.0 - orange_chalk;
    PaperGrain o_grain = paper_grain_2(o_bare, board.place, board.stretch, 220.0, 0.8, 0.5, 9,
        look.viewport);
    metal::float4 orange = metal::mix(blue_gray, metal::float4(0.9412, 0.6353, 0.3608, 1.0),
        bounded(1.0 - o_grain.tone));
    float curvature = surface.kappa;
    // Curvature transition
    float hollow_to_bulge = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.16, -20.0, 20.0))));
    float bare_in_hollows = metal::mix(0.1, 1.0,
        metal::clamp((hollow_to_bulge - 0.15) / 0.35, 0.0, 1.0));
    float white_chalk = tone * bare_in_hollows;
    float w_bare = 1.0 - white_chalk;
    PaperGrain w_grain = paper_grain_3(w_bare, board.place, board.stretch, 260.0, 0.62, 0.5, 3,
        look.viewport);
    metal::float4 white = metal::mix(orange, metal::float4(0.9686, 0.9529, 0.9098, 1.0),
        bounded(1.0 - w_grain.tone));
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
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, object.world_from_normal
        * vertex_.normal};
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
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float3 anchor_on_screen_value = anchor_on_screen((view.camera_from_world
        * metal::float4(object.world_from_object[3].xyz, 1.0)).xyz, view.eye.w,
        metal::length(metal::float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = Surface {normal, texel.x, in.clip.xy * view.screen.xy + view.screen.zw, {},
        anchor_on_screen_value};
    return fs_mainOutput { shade(surface, look) };
}
