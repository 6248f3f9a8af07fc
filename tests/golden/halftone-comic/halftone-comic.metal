// Half-tone comic: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// halftone-comic.json says what to put there and how to draw.
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
    Light key;
    metal::float2 viewport;
    char _pad2[8];
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float2 pixel;
    char _pad3[8];
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

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};

constant ProfileShape not_in_deep_shade_shape = ProfileShape {0.65243745, 0.75784254, 0.0, 1.0,
    1.72, 0.0, 0.0, 1u};
constant ProfileShape highlight_shape = ProfileShape {0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0,
    0.0, 1u};

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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(
    float x,
    float low,
    float high
) {
    float t = metal::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
metal::float2 footprint_of_vec2(
    metal::float2 v
) {
    metal::float2 dx = metal::dfdx(v);
    metal::float2 dy = metal::dfdy(v);
    return metal::sqrt(dx * dx + dy * dy);
}

Angle parametrization_specular_balanced(
    Light light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d = 2.0 * metal::dot(normal, view) * normal - view;
    return Angle {0.5 * metal::length(d - light.direction), 0.5
        * metal::length(d + light.direction)};
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(
    float s,
    float w,
    ProfileShape shape
) {
    float width = metal::sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = metal::clamp(0.5 + (0.0 - from_offset) / metal::max(width, 0.000001), 0.0, 1.0);
    return w <= 0.0 ? (s <= 0.0000004 ? 1.0 : 0.0) : ramp;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
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
    ink = disk_filtered(metal::length(cell - metal::rint(cell)), metal::sqrt(share * 0.31830987),
        width);
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
    return 1.0 - ink_of_dots_2(cell, 1.0 - value, metal::max(w.x, w.y));
}

/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Reflectance
    float light_and_shade = metal::max((metal::dot(surface.normal, look.key.direction) + 0.25)
        / 1.25, 0.0);
    float red_to_print = metal::mix(0.15, 1.0,
        metal::clamp((light_and_shade - 0.1) / 0.65, 0.0, 1.0));
    float red_dots = halftone_dots(red_to_print, surface.pixel, 78.0, 0.2617994, look.viewport);
    metal::float4 red_on_yellow = metal::mix(metal::float4(0.91, 0.3, 0.24, 1.0),
        metal::float4(1.0, 0.87, 0.58, 1.0), red_dots);
    // Parametrization
    Angle turned_from_the_light = Angle {0.5 * metal::length(surface.normal - look.key.direction),
        0.5 * metal::length(surface.normal + look.key.direction)};
    float not_in_deep_shade = profile_balanced(turned_from_the_light, 0.0, not_in_deep_shade_shape);
    float deep_shade = 1.0 - not_in_deep_shade;
    float how_much_blue = deep_shade * 0.62;
    float less = 1.0 - how_much_blue;
    float blue_dots = halftone_dots_2(less, surface.pixel, 78.0, 1.3089969, look.viewport);
    float inked = 1.0 - blue_dots;
    metal::float4 blue_over_it = metal::float4(metal::mix(red_on_yellow.xyz, red_on_yellow.xyz
        * metal::float3(0.24, 0.3, 0.58), inked), 1.0);
    Angle mirrored = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    float highlight = profile_balanced(mirrored, 0.0, highlight_shape);
    metal::float4 left_free = metal::mix(blue_over_it, metal::float4(1.0, 0.99, 0.95, 1.0),
        highlight);
    float contour = eased(metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0), 0.3,
        0.22);
    metal::float4 black_line = metal::mix(left_free, metal::float4(0.09, 0.07, 0.13, 1.0), contour);
    return black_line;
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
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
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
, constant View& view [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.clip.xy * view.screen.xy + view.screen.zw};
    return fs_mainOutput { shade(surface, look) };
}
