// Screen print: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// screen-print.json says what to put there and how to draw.
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
    Light side;
    metal::float2 viewport;
    char _pad2[8];
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
    float kappa;
    metal::float2 pixel;
    char _pad4[8];
};

typedef metal::float4 Color;
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
constant ProfileShape yellow_s_share_shape = ProfileShape {0.9887711, 0.14943813, 2.0858297,
    1.7378688, 0.3, 0.54759663, 0.22553022, 0u};

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
metal::float2 sin_cos_quarter(
    float x
) {
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    float h = 0.5 * x;
    float h2 = h * h;
    float s = h * (1.0 + h2 * (-0.16666667 + h2
        * (0.008333334 + h2 * (-0.0001984127 + h2 * (0.0000027557319 + h2 * -0.000000025052108)))));
    float one_minus_c = h2 * (0.5 + h2
        * (-0.041666668 + h2 * (0.0013888889 + h2
        * (-0.000024801588 + h2 * (0.0000002755732 + h2 * -0.0000000020876756)))));
    float c = 1.0 - one_minus_c;
    return metal::float2(2.0 * s * c, 1.0 - 2.0 * s * s);
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

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(
    float x,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return x >= high ? 1.0 : 0.0;
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(
    float x,
    float low,
    float high
) {
    float t = metal::clamp(place_between(x, low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return metal::sqrt(metal::dot(d, d));
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
metal::float2 footprint_of_vec2(
    metal::float2 v
) {
    metal::float2 dx = metal::dfdx(v);
    metal::float2 dy = metal::dfdy(v);
    return metal::sqrt(dx * dx + dy * dy);
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(
    float x,
    float edge,
    float w
) {
    float d = x - edge;
    return w < 0.000000000000000000000000000001 ? (d >= 0.0 ? 1.0 : 0.0) : metal::clamp(0.5 + d / w,
        0.0, 1.0);
}

Color mix_colors_multiply(
    Color a,
    Color b,
    float factor
) {
    return metal::float4(metal::mix(a.xyz, a.xyz * b.xyz, factor), 1.0);
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

/// p turned by an angle in radians, from x to y.
metal::float2 turned_by(
    metal::float2 p,
    float angle
) {
    metal::float2 turn = metal::float2(metal::sin(angle), metal::cos(angle));
    return metal::float2(turn.y * p.x - turn.x * p.y, turn.x * p.x + turn.y * p.y);
}

/// A place in pixels, in cells of a half-tone screen that has `lines` lines to the picture's height
/// and is turned by an angle in radians.
metal::float2 screen_cells(
    metal::float2 place,
    metal::float2 viewport,
    float lines,
    float angle
) {
    metal::float2 most = metal::float2(4194304.0);
    metal::float2 upright = place * (lines / metal::max(viewport.y, 1.0));
    return metal::clamp(turned_by(metal::clamp(upright, metal::float2(-4194304.0), most), angle),
        metal::float2(-4194304.0), most);
}

/// The integral of lines from 0 to x.
float lines_integral(
    float x,
    float share
) {
    float whole = metal::rint(x);
    return whole * share + metal::clamp(x - whole, -0.5 * share, 0.5 * share);
}

/// Lines that cover `share` of all, from 0 to 1: 1 within half a `share` of every whole number, 0
/// elsewhere, averaged over a footprint of `w`. Without a footprint the edges are inclusive.
float lines_filtered(
    float x,
    float share,
    float w
) {
    float t = x - metal::rint(x);
    if (w < 0.000000000000000000000000000001) {
        return ((metal::abs(t) <= 0.5 * share) & (share > 0.0)) ? 1.0 : 0.0;
    }
    // Beyond a thousand lines to the pixel the average does not change any more.
    float half_ = 0.5 * metal::min(w, 1000.0);
    return metal::clamp((lines_integral(t + half_, share) - lines_integral(t - half_, share))
        / (2.0 * half_), 0.0, 1.0);
}

/// The radius of disks around whole places that together cover `share` of the plane: beyond pi/4
/// they overlap, and at 1 they reach the middle between four.
float dot_radius(
    float share
) {
    float a = {};
    if (share <= 0.7853982) {
        return metal::sqrt(share * 0.31830987);
    }
    float s = (share - 0.7853982) / 0.21460183;
    a = metal::mix(0.5227232 * metal::sqrt(s), 0.7853982 - 0.3275682 * metal::sqrt(1.0 - s), s);
    for (int i = 0; i < 2; i++) {
        metal::float2 turn = sin_cos_quarter(metal::clamp(a, 0.0, 0.7853982));
        float tangent = turn.x / turn.y;
        float square = 1.0 / (turn.y * turn.y);
        float sector = 0.7853982 - a;
        float slope = 2.0 * sector * square * tangent;
        a = metal::clamp(a - (slope > 0.001 ? (sector * square + tangent - share) / slope : 0.0),
            0.0, 0.7853982);
    }
    return 0.5 / sin_cos_quarter(a).y;
}

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
float disk_filtered(
    float d,
    float r,
    float w
) {
    if (w < 0.000000000000000000000000000001) {
        return ((d <= r) & (r > 0.0)) ? 1.0 : 0.0;
    }
    // A ramp as wide as a pixel adds pi w^2/12 to a disk's area. A disk too small to give that back
    // is drawn fainter.
    float square = r * r;
    float least = w * w / 3.0;
    float inner = metal::sqrt(metal::max(square, least) - 0.25 * least);
    return metal::clamp(0.5 + (inner - d) / w, 0.0, 1.0) * metal::min(square / least, 1.0);
}

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
float disk_filtered_2(
    float d,
    float r,
    float w
) {
    if (w < 0.000000000000000000000000000001) {
        return d <= r ? 1.0 : 0.0;
    }
    float square = r * r;
    float least = w * w / 3.0;
    float inner = metal::sqrt(metal::max(square, least) - 0.25 * least);
    return metal::clamp(0.5 + (inner - d) / w, 0.0, 1.0) * metal::min(square / least, 1.0);
}

/// Ink of round dots that cover `share` of the plane.
float ink_of_dots(
    metal::float2 cell,
    float share,
    float w
) {
    float ink = {};
    float width = metal::min(w, 1.0);
    ink = disk_filtered(metal::length(cell - metal::rint(cell)), dot_radius(share), width);
    float hole = metal::sqrt((1.0 - share) * 0.31830987);
    float is_star = metal::smoothstep(0.3 * hole, 0.9 * hole, width)
        * metal::smoothstep(0.5, 0.7, share);
    if (is_star > 0.0) {
        float disk_filtered_2_value = disk_filtered_2(metal::length(cell - metal::floor(cell)
            - metal::float2(0.5)), hole, width);
        ink = metal::mix(ink, 1.0 - disk_filtered_2_value, is_star);
    }
    float mean = metal::mix(ink, share, metal::smoothstep(0.4, 1.0, w));
    return share <= 0.0 ? share : mean;
}

/// Ink of round dots that cover `share` of the plane.
float ink_of_dots_2(
    metal::float2 cell,
    float share,
    float w
) {
    float ink = {};
    float width = metal::min(w, 1.0);
    ink = disk_filtered(metal::length(cell - metal::rint(cell)), dot_radius(share), width);
    float hole = metal::sqrt((1.0 - share) * 0.31830987);
    float is_star = eased(width, 0.3 * hole, 0.9 * hole) * metal::smoothstep(0.5, 0.7, share);
    if (is_star > 0.0) {
        float disk_filtered_2_value = disk_filtered_2(metal::length(cell - metal::floor(cell)
            - metal::float2(0.5)), hole, width);
        ink = metal::mix(ink, 1.0 - disk_filtered_2_value, is_star);
    }
    float mean = metal::mix(ink, share, metal::smoothstep(0.4, 1.0, w));
    return share <= 0.0 ? share : mean;
}

/// Half-tone
///
/// Turns a tone into dark dots, lines or crosses, as print does, whose average is the tone. Screens
/// belong to the picture's height, so that every resolution has the same ones. For print in color
/// take one node for each channel of Separate color; printers turn the screens of cyan (red's) by
/// 15 degrees, of magenta (green's) by 75, of yellow (blue's) by 0 and of black by 45.
float halftone_dots(
    float value,
    metal::float2 place,
    float lines,
    float angle,
    metal::float2 viewport
) {
    metal::float2 cell = screen_cells(place, viewport, lines, angle);
    metal::float2 w = footprint_of_vec2(cell);
    return 1.0 - ink_of_dots(cell, 1.0 - metal::min(value, 1.0), metal::max(w.x, w.y));
}

/// Half-tone
///
/// Turns a tone into dark dots, lines or crosses, as print does, whose average is the tone. Screens
/// belong to the picture's height, so that every resolution has the same ones. For print in color
/// take one node for each channel of Separate color; printers turn the screens of cyan (red's) by
/// 15 degrees, of magenta (green's) by 75, of yellow (blue's) by 0 and of black by 45.
float halftone_dots_2(
    float value,
    metal::float2 place,
    float lines,
    float angle,
    metal::float2 viewport
) {
    metal::float2 cell = screen_cells(place, viewport, lines, angle);
    metal::float2 w = footprint_of_vec2(cell);
    return 1.0 - ink_of_dots_2(cell, 1.0 - metal::min(value, 1.0), metal::max(w.x, w.y));
}

float halftone_lines(
    float value,
    metal::float2 place,
    float lines,
    float angle,
    metal::float2 viewport
) {
    metal::float2 cell = screen_cells(place, viewport, lines, angle);
    return 1.0 - lines_filtered(cell.y, 1.0 - value, footprint_of(cell.y));
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Parametrization
    Angle side = Angle {0.5 * metal::length(surface.normal - look.side.direction), 0.5
        * metal::length(surface.normal + look.side.direction)};
    float yellow_s_share = profile_balanced(side, 0.0, yellow_s_share_shape);
    float pale = metal::mix(1.0, 0.25, yellow_s_share - 0.0);
    float yellow_screen = halftone_lines(pale, surface.pixel, 56.0, 0.0, look.viewport);
    metal::float4 p1_ink = metal::mix(metal::float4(0.9647, 0.8118, 0.2902, 1.0),
        metal::float4(1.0), yellow_screen);
    Color on_paper = mix_colors_multiply(metal::float4(0.9686, 0.9373, 0.8784, 1.0), p1_ink, 1.0);
    // Reflectance
    float shade_2 = metal::max((metal::dot(surface.normal, look.key.direction) + 0.3) / 1.3, 0.0);
    float tone = metal::min((shade_2 - 0.0) / 0.8, 1.0);
    float coral_s_share = metal::mix(0.12, 1.0, metal::clamp((tone - 0.25) / 0.7, 0.0, 1.0));
    float coral_screen = halftone_dots(coral_s_share, surface.pixel, 56.0, 0.2618, look.viewport);
    metal::float4 p2_ink = metal::mix(metal::float4(0.9333, 0.3529, 0.2902, 1.0),
        metal::float4(1.0), coral_screen);
    metal::float4 printed_over = metal::float4(metal::mix(on_paper.xyz, on_paper.xyz * p2_ink.xyz,
        1.0), 1.0);
    float teal_s_share = metal::mix(0.05, 1.0, metal::min((tone - 0.0) / 0.5, 1.0));
    float teal_screen = halftone_dots_2(teal_s_share, surface.pixel, 56.0, 1.309, look.viewport);
    metal::float4 p3_ink = metal::mix(metal::float4(0.1216, 0.5608, 0.5922, 1.0),
        metal::float4(1.0), teal_screen);
    metal::float4 printed_over_2 = metal::float4(metal::mix(printed_over.xyz, printed_over.xyz
        * p3_ink.xyz, 1.0), 1.0);
    float curvature = surface.kappa;
    // Curvature transition
    float hollow = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.25, -20.0, 20.0))));
    // Threshold
    float hollows = step_filtered(hollow, 0.22,
        metal::length(metal::float2(footprint_of(hollow), 0.0)));
    float facing = metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0);
    // Threshold
    float outline = step_filtered(facing, 0.28,
        metal::length(metal::float2(footprint_of(facing), 0.0)));
    float black_screen = hollows * outline;
    metal::float4 p4_ink = metal::mix(metal::float4(0.0902, 0.0745, 0.1216, 1.0),
        metal::float4(1.0), black_screen);
    metal::float4 printed_over_3 = metal::float4(metal::mix(printed_over_2.xyz, printed_over_2.xyz
        * p4_ink.xyz, 1.0), 1.0);
    return printed_over_3;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        texel.x, in.clip.xy * view.screen.xy + view.screen.zw};
    return fs_mainOutput { shade(surface, look) };
}
